# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colours of a mesh by what was measured on it: thicknesses, or deviations."""

import numpy as np

from ..core import colour_scale
from ..features.properties import add_hidden
from .quality_data import deviation_scale, thickness_scale

_COLOURS = ("FaceColors", "App::PropertyColorList", "The colour of each triangle")  # FreeCAD finds it by this name


def show(obj, values, limit=None):
    """Colours the triangles of a document object by thicknesses in mm, infinite without a wall, or by deviations between
    -limit and limit, and draws no edges, which would cover the colours; values None: it has one colour.
    """
    add_hidden(obj, "Mesh", (_COLOURS,))
    view, coloured = obj.ViewObject, values is not None and len(values) == obj.Mesh.CountFacets > 0
    rgb = np.zeros((0, 3))
    if coloured:
        scale = thickness_scale(values) if limit is None else deviation_scale(limit)
        rgb = colour_scale.colours_of(scale.goodness(values))
    obj.FaceColors = list(map(tuple, rgb.tolist()))
    if coloured:
        view.DisplayMode = "Shaded"
    view.Coloring = coloured
