# SPDX-License-Identifier: LGPL-2.1-or-later
"""The measures of core/elements/measures.py as the quality view shows them: titles, meanings and colours."""

import FreeCAD

from ..core.measures import ALL
from .quality_measure import Measure

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

# Edge ratios and smallest angles have measures of their own in the view.
_TEXTS = {
    "aspect_ratio": (
        QT_TRANSLATE_NOOP("MeshQuality", "Aspect ratio"),
        QT_TRANSLATE_NOOP("MeshQuality", "Longest edge over the size of the inscribed circle or ball, by Verdict: 1 = regular.")),
    "scaled_jacobian": (
        QT_TRANSLATE_NOOP("MeshQuality", "Scaled Jacobian of the corners"),
        QT_TRANSLATE_NOOP("MeshQuality", "By Verdict: 1 = regular, ≤ 0 = folded.")),
    "equiangle_skew": (
        QT_TRANSLATE_NOOP("MeshQuality", "Equiangle skew"),
        QT_TRANSLATE_NOOP("MeshQuality", "How far angles are from those of the regular element: 0 = none, 1 = flat.")),
    "max_angle": (
        QT_TRANSLATE_NOOP("MeshQuality", "Largest angle"),
        QT_TRANSLATE_NOOP("MeshQuality", "Between two sides of an element; near 180° it is flat.")),
    "skew": (
        QT_TRANSLATE_NOOP("MeshQuality", "Skew"),
        QT_TRANSLATE_NOOP("MeshQuality", "Cosine of the angle between the axes of quadrilaterals and hexahedra: 0 = square.")),
    "taper": (
        QT_TRANSLATE_NOOP("MeshQuality", "Taper"),
        QT_TRANSLATE_NOOP("MeshQuality", "Difference of opposite sides of quadrilaterals and hexahedra: 0 = none.")),
    "warpage": (
        QT_TRANSLATE_NOOP("MeshQuality", "Warpage"),
        QT_TRANSLATE_NOOP("MeshQuality", "Of quadrilaterals, also as faces of volumes: 0 = flat.")),
    "non_orthogonality": (
        QT_TRANSLATE_NOOP("MeshQuality", "Non-orthogonality"),
        QT_TRANSLATE_NOOP("MeshQuality", "OpenFOAM's: angle between a face and the line between the centres of its elements; 70° is much.")),
    "skewness": (
        QT_TRANSLATE_NOOP("MeshQuality", "Skewness"),
        QT_TRANSLATE_NOOP("MeshQuality", "OpenFOAM's: how far that line misses the middle of the face; 4 is much.")),
}


def _of(name):
    return lambda data, _: data.table[name]


MEASURES = {measure.name: Measure(*_TEXTS[measure.name], measure.unit, measure.poor, measure.ideal, _of(measure.name))
            for measure in ALL if measure.name in _TEXTS}


def measures_of(names):
    """The measures of the view among those that a MeasureTable has."""
    return [MEASURES[name] for name in names if name in MEASURES]
