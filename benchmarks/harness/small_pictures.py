# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures by Matplotlib that stay small in the repository: PNG files of a few dozen colours."""

import io
from pathlib import Path

COLOURS = 64  # a third of the bytes that all colours take


def _figure(size):
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=size, dpi=80, layout="tight")
    FigureCanvasAgg(figure)
    return figure


def panels(rows, columns, width, height):
    """A figure and its axes as a list, without frames; width and height of a panel in inches."""
    figure = _figure((width * columns, height * rows))
    axes = list(figure.subplots(rows, columns, squeeze=False).flat)
    for axis in axes:
        axis.set_axis_off()
    return figure, axes


def mosaic(names, size):
    """A figure of inches by inches, and its axes by their names in a mosaic of matplotlib."""
    figure = _figure(size)
    return figure, figure.subplot_mosaic(names)


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
    """Writes a PNG file, with its folder."""
    from PIL import Image

    stream = io.BytesIO()
    figure.savefig(stream, format="png")
    picture = Image.open(stream).convert("RGB").quantize(COLOURS, dither=Image.Dither.NONE)
    Path(path).parent.mkdir(parents=True, exist_ok=True)
    picture.save(path, optimize=True)
    print(f"written: {path}", flush=True)
