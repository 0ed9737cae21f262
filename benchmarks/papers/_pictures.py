# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of the pages about papers, as small PNG files."""

from io import BytesIO


def figure_of(mosaic, size):
    """A figure of inches by inches, and its panels by their names in a mosaic of matplotlib."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=size, dpi=80, layout="tight")
    FigureCanvasAgg(figure)
    return figure, figure.subplot_mosaic(mosaic)


def show(axes, mesh, title, size, view, triangles=None):
    """The mesh as tools/render.py draws it, or these triangles of it."""
    import numpy as np
    import render

    kept = np.arange(len(mesh.triangles)) if triangles is None else triangles
    used, corners = np.unique(mesh.triangles[kept], return_inverse=True)
    axes.imshow(render.render(mesh.vertices[used], corners.reshape(-1, 3), mesh.triangle_face[kept], size=size,
                              view=render.camera(*view), smooth=2))
    axes.set_title(title, fontsize=9)
    axes.set_axis_off()


def save(figure, path):
    """With 64 colours, which takes a third of the bytes."""
    from PIL import Image

    stream = BytesIO()
    figure.savefig(stream, format="png")
    Image.open(stream).convert("RGB").quantize(64).save(path, optimize=True)
    print(f"written: {path}", flush=True)
