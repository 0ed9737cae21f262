# SPDX-License-Identifier: LGPL-2.1-or-later
"""The before/after picture: two shaded meshes a part, and under each its histogram of angles."""

from dataclasses import dataclass

import numpy as np
import render
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

TITLES = ("FreeCAD's standard tessellation", "MeshQuality")


@dataclass
class Mesh:
    """What is drawn and said of one mesh."""

    vertices: np.ndarray
    triangles: np.ndarray
    faces: np.ndarray  # CAD face of each triangle
    distance: float  # largest, to the part, in mm


@dataclass
class Row:
    """One part."""

    name: str
    before: Mesh
    after: Mesh


def save(rows, path, min_angle):
    """Writes the picture of the rows as PNG."""
    figure = Figure(figsize=(12.0, 6.5 * len(rows)), dpi=110)
    FigureCanvasAgg(figure)
    bands = figure.add_gridspec(
        len(rows), 1, left=0.05, right=0.985, top=1.0 - 0.045 / len(rows) - 0.01,
        bottom=0.08 / len(rows), hspace=0.20,
    )
    for i, row in enumerate(rows):
        grid = bands[i].subgridspec(2, 2, height_ratios=[4.4, 1.0], hspace=0.02, wspace=0.10)
        histogram = None  # both of a row share their scale
        for j, mesh in enumerate((row.before, row.after)):
            _mesh_axes(figure.add_subplot(grid[0, j]), f"{row.name}: {TITLES[j]}", mesh)
            histogram = figure.add_subplot(grid[1, j], sharey=histogram)
            _histogram_axes(histogram, mesh, min_angle)
    figure.savefig(str(path), facecolor="white")


def _mesh_axes(axes, title, mesh):
    axes.imshow(np.clip(render.render(mesh.vertices, mesh.triangles, mesh.faces), 0.0, 1.0))
    axes.set_axis_off()
    worst = render.smallest_angles(mesh.vertices, mesh.triangles).min()
    figures = (f"{len(mesh.triangles):,} triangles, smallest angle {worst:.2f}°, "
               f"{mesh.distance:.2g} mm from the part at most")
    axes.set_title(f"{title}\n{figures}", fontsize=11)


def _histogram_axes(axes, mesh, min_angle):
    angles = render.smallest_angles(mesh.vertices, mesh.triangles)
    counts, edges = np.histogram(angles, bins=np.arange(0.0, 61.0, 1.0))
    shares = 100.0 * counts / max(len(angles), 1)
    axes.bar(
        edges[:-1], shares, width=1.0, align="edge", edgecolor="white", linewidth=0.4,
        color=np.clip(render.colours(edges[:-1] + 0.5), 0.0, 1.0),
    )
    axes.axvline(min_angle, color="0.25", linewidth=1.0, linestyle="--")
    axes.set_xlim(0.0, 60.0)
    axes.set_xlabel("smallest angle of a triangle (degrees)", fontsize=9)
    axes.set_ylabel("% of triangles", fontsize=9)
    axes.tick_params(labelsize=8)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
