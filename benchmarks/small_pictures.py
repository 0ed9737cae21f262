# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures by Matplotlib that stay small in the repository: PNG files of a few dozen colours."""

import io
from pathlib import Path

COLOURS = 64


def panels(rows, columns, width, height, dpi=80):
    """A figure and its axes as a list, without frames; width and height of a panel in inches."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width * columns, height * rows), dpi=dpi, layout="tight")
    FigureCanvasAgg(figure)
    axes = list(figure.subplots(rows, columns, squeeze=False).flat)
    for axis in axes:
        axis.set_axis_off()
    return figure, axes


def save(figure, path):
    """Writes a PNG file, with its folder."""
    from PIL import Image

    stream = io.BytesIO()
    figure.savefig(stream, format="png")
    picture = Image.open(stream).convert("RGB").quantize(COLOURS, dither=Image.Dither.NONE)
    Path(path).parent.mkdir(parents=True, exist_ok=True)
    picture.save(path, optimize=True)
    print(f"written: {path}", flush=True)
