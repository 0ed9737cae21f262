# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colours of a mesh by the thickness that was measured on it."""

import numpy as np

from ..features.properties import add_hidden
from .quality_data import thickness_scale
from .view import colour_scale

_COLOURS = ("FaceColors", "App::PropertyColorList", "The colour of each triangle")  # FreeCAD finds it by this name


def show(obj, values):
    """Colours the triangles of a document object by thicknesses in mm, infinite without a wall, and draws no edges, which
    would cover the colours; None: it has one colour.
    """
    add_hidden(obj, "Mesh", (_COLOURS,))
    view, coloured = obj.ViewObject, values is not None and len(values) == obj.Mesh.CountFacets > 0
    rgb = colour_scale.colours_of(thickness_scale(values).goodness(values)) if coloured else np.zeros((0, 3))
    obj.FaceColors = list(map(tuple, rgb.tolist()))
    if coloured:
        view.DisplayMode = "Shaded"
    view.Coloring = coloured
