# SPDX-License-Identifier: LGPL-2.1-or-later
"""The measures of elements that users know by name: those of Verdict (Stimpson, Ernst, Knupp, Pebay and Thompson: The Verdict
Geometric Quality Library, Sandia report SAND2007-1751), by the corners of the elements; middle nodes do not count.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from . import kinds
from .vectors import cross, dot, lengths

# Of each corner of a volume element the three corners at the ends of its edges, right-handed.
_AT_CORNERS = {
    "hexahedron": ((0, 1, 3, 4), (1, 2, 0, 5), (2, 3, 1, 6), (3, 0, 2, 7), (4, 7, 5, 0), (5, 4, 6, 1), (6, 5, 7, 2), (7, 6, 4, 3)),
    "prism": ((0, 1, 2, 3), (1, 2, 0, 4), (2, 0, 1, 5), (3, 5, 4, 0), (4, 3, 5, 1), (5, 4, 3, 2)),
}
_TETRAHEDRA_OF_PYRAMID = ((0, 1, 2, 4), (0, 2, 3, 4), (1, 3, 0, 4), (1, 2, 3, 4))
# Which corners of a hexahedron count with +1, the others with -1: its principal axes, and how these change along others.
_AXES = ((1, 2, 5, 6), (2, 3, 6, 7), (4, 5, 6, 7))
_CROSS_AXES = ((0, 2, 4, 6), (0, 3, 5, 6), (0, 1, 6, 7))
_PAIRS = ((0, 1), (0, 2), (1, 2))


@dataclass(frozen=True)
class ElementMeasure:
    """One measure.

    name   of it in Python and in tables
    ideal  its value of the regular element
    poor   a value from which on elements are usually called poor, on the side of the ideal value where bad ones are
    unit   "°", or none
    of     {kind of element: float64 (E,) of corners, float64 (E, corners, 3)}
    """

    name: str
    ideal: float
    poor: float
    unit: str
    of: dict[str, Callable]

    def values(self, kind, corners):
        """float64 (E,): of elements of a kind; not a number where the measure is not defined for the kind."""
        if kind not in self.of:
            return np.full(len(corners), np.nan)
        with np.errstate(divide="ignore", invalid="ignore"):
            return self.of[kind](np.asarray(corners, dtype=float))


def _ratio(above, below):
    """above / below, infinite where there is nothing below."""
    return np.where(below > 0.0, above / np.where(below > 0.0, below, 1.0), np.inf)


def _sides(kind, corners):
    """float64 (E, edges): lengths."""
    return np.stack([lengths(corners[:, b] - corners[:, a]) for a, b in kinds.EDGES[kind]], axis=1)


def _edge_ratio(kind):
    def of(corners):
        sides = _sides(kind, corners)
        return _ratio(sides.max(axis=1), sides.min(axis=1))
    return of


def _ring(corners):
    """float64 (E, n, 3): the edges of a face, each from its corner to the next."""
    return np.roll(corners, -1, axis=1) - corners


def _signed_areas(corners):
    """float64 (E, 4): the areas of the parallelograms at the corners of quadrilaterals, below 0 where they are folded."""
    edges = _ring(corners)
    at_corners = cross(np.roll(edges, 1, axis=1), edges)
    centre = cross(*_axes_of_quadrilateral(corners))
    return dot(at_corners, (centre / lengths(centre)[:, None])[:, None])


def _axes_of_quadrilateral(corners):
    """Its two principal axes, (E, 3) each."""
    a, b, c, d = corners.transpose(1, 0, 2)
    return b + c - a - d, c + d - a - b


def _angles(corners):
    """float64 (E, 4), degrees, of quadrilaterals, 180 at most."""
    edges = _ring(corners)
    back = -np.roll(edges, 1, axis=1)
    return np.degrees(np.arctan2(lengths(cross(edges, back)), dot(edges, back)))


def _twice_area(corners):
    return lengths(cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))


def _angle_of_triangle(corners, pick):
    """The smallest angle by np.maximum, the largest by np.minimum: the height is the same at all corners, so the scalar product
    of the sides tells which angle is larger.
    """
    a, b, c = (corners[:, k] - corners[:, k - 1] for k in range(3))
    product = pick(pick(-dot(a, b), -dot(b, c)), -dot(c, a))
    return np.degrees(np.arctan2(lengths(cross(a, b)), product))


def _smallest_angle(corners):
    return _angle_of_triangle(corners, np.maximum) if corners.shape[1] == 3 else _angles(corners).min(axis=1)


def _largest_angle(corners):
    """Of a quadrilateral that is folded in at a corner the angle beyond 180 degrees."""
    if corners.shape[1] == 3:
        return _angle_of_triangle(corners, np.minimum)
    found = _angles(corners).max(axis=1)
    return np.where((_signed_areas(corners) < 0.0).any(axis=1), 360.0 - found, found)


def _aspect_of_triangle(corners):
    sides = _sides("triangle", corners)
    return _ratio(sides.max(axis=1) * sides.sum(axis=1), 2.0 * np.sqrt(3.0) * _twice_area(corners))


def _aspect_of_quadrilateral(corners):
    sides = _sides("quadrilateral", corners)
    return _ratio(sides.max(axis=1) * sides.sum(axis=1), _signed_areas(corners).sum(axis=1))


def _determinant(corners):
    """float64 (E,): six times the volume of tetrahedra."""
    a, b, c = (corners[:, k] - corners[:, 0] for k in (1, 2, 3))
    return dot(a, cross(b, c))


def _aspect_of_tetrahedron(corners):
    faces = [corners[:, list(face)] for face in kinds.FACES["tetrahedron"]]
    area = 0.5 * sum(_twice_area(face) for face in faces)
    longest = _sides("tetrahedron", corners).max(axis=1)
    return _ratio(longest * area, np.sqrt(6.0) * np.abs(_determinant(corners)))


def _axes_of_hexahedron(corners, which=_AXES):
    """float64 (3, E, 3)."""
    signs = np.full((3, 8), -1.0)
    for axis, plus in enumerate(which):
        signs[axis, list(plus)] = 1.0
    return np.einsum("ak,eki->aei", signs, corners)


def _aspect_of_hexahedron(corners):
    of_axes = lengths(_axes_of_hexahedron(corners))
    return _ratio(of_axes.max(axis=0), of_axes.min(axis=0))


def _frobenius_of_tetrahedron(corners):
    """The condition number of tetrahedra in the Frobenius norm, 1 of the regular one."""
    edges = corners[:, 1:] - corners[:, :1]
    mixed = sum(dot(edges[:, i], edges[:, j]) for i, j in _PAIRS)
    determinant = _determinant(corners)
    below = 3.0 * np.cbrt(2.0 * np.square(determinant))
    return _ratio(1.5 * np.square(edges).sum(axis=(1, 2)) - mixed, below)


def _aspect_of_prism(corners):
    """The largest Frobenius aspect of the tetrahedra at the corners, by Verdict's constant for the regular prism."""
    found = np.max([_frobenius_of_tetrahedron(corners[:, list(four)]) for four in _AT_CORNERS["prism"]], axis=0)
    return np.maximum(found / 1.16477, 1.0)


def _skew_of_quadrilateral(corners):
    first, second = _axes_of_quadrilateral(corners)
    return np.abs(dot(first, second)) / (lengths(first) * lengths(second))


def _skew_of_hexahedron(corners):
    axes = _axes_of_hexahedron(corners)
    axes = axes / lengths(axes)[..., None]
    return np.max([np.abs(dot(axes[i], axes[j])) for i, j in _PAIRS], axis=0)


def _taper_of_quadrilateral(corners):
    a, b, c, d = corners.transpose(1, 0, 2)
    shorter = np.min([lengths(axis) for axis in _axes_of_quadrilateral(corners)], axis=0)
    return _ratio(lengths(a - b + c - d), shorter)


def _taper_of_hexahedron(corners):
    of_axes, across = (lengths(_axes_of_hexahedron(corners, which)) for which in (_AXES, _CROSS_AXES))
    return np.max([_ratio(across[k], np.minimum(of_axes[i], of_axes[j])) for k, (i, j) in enumerate(_PAIRS)], axis=0)


def _warpage_of_quadrilateral(corners):
    edges = _ring(corners)
    normals = cross(np.roll(edges, 1, axis=1), edges)
    normals = normals / lengths(normals)[..., None]
    return 1.0 - np.minimum(dot(normals[:, 0], normals[:, 2]), dot(normals[:, 1], normals[:, 3])) ** 3


def _jacobian_of_triangle(corners):
    sides = _sides("triangle", corners)
    products = np.max([sides[:, i] * sides[:, j] for i, j in _PAIRS], axis=0)
    return np.where(products > 0.0, 2.0 / np.sqrt(3.0) * _twice_area(corners) / products, 0.0)


def _jacobian_of_quadrilateral(corners):
    sides = lengths(_ring(corners))
    products = sides * np.roll(sides, 1, axis=1)
    return np.where(products > 0.0, _signed_areas(corners) / products, 0.0).min(axis=1)


_EDGES_AT = tuple([k for k, edge in enumerate(kinds.EDGES["tetrahedron"]) if corner in edge] for corner in range(4))


def _jacobian_of_tetrahedron(corners):
    sides = _sides("tetrahedron", corners)
    products = np.max([sides[:, at].prod(axis=1) for at in _EDGES_AT], axis=0)
    return np.where(products > 0.0, np.sqrt(2.0) * _determinant(corners) / products, 0.0)


def _jacobian_of_pyramid(corners):
    least = np.min([_jacobian_of_tetrahedron(corners[:, list(four)]) for four in _TETRAHEDRA_OF_PYRAMID], axis=0)
    scaled = np.maximum(least, 0.0) * np.sqrt(2.0)
    return np.where(scaled < 1.0, scaled, 2.0 - scaled)


def _jacobians_at_corners(kind, corners):
    found = []
    for at, *ends in _AT_CORNERS[kind]:
        a, b, c = (corners[:, end] - corners[:, at] for end in ends)
        found.append(dot(a, cross(b, c)) / (lengths(a) * lengths(b) * lengths(c)))
    return np.min(found, axis=0)


def _jacobian_of_prism(corners):
    return 2.0 / np.sqrt(3.0) * _jacobians_at_corners("prism", corners)


def _jacobian_of_hexahedron(corners):
    a, b, c = _axes_of_hexahedron(corners)
    centre = dot(a, cross(b, c)) / (lengths(a) * lengths(b) * lengths(c))
    return np.minimum(centre, _jacobians_at_corners("hexahedron", corners))


def _skew_of_angles(least, most, even):
    return np.maximum((most - even) / (180.0 - even), (even - least) / even)


def _equiangle_skew(corners):
    return _skew_of_angles(_smallest_angle(corners), _largest_angle(corners), 60.0 if corners.shape[1] == 3 else 90.0)


def _equiangle_skew_of_tetrahedron(corners):
    """The larger of that of the faces and that of the angles between them."""
    normals = [cross(corners[:, b] - corners[:, a], corners[:, c] - corners[:, a]) for a, b, c in kinds.FACES["tetrahedron"]]
    between = [180.0 - np.degrees(np.arctan2(lengths(cross(normals[i], normals[j])), dot(normals[i], normals[j])))
               for i in range(4) for j in range(i)]
    dihedral = _skew_of_angles(np.min(between, axis=0), np.max(between, axis=0), np.degrees(np.arccos(1.0 / 3.0)))
    return np.maximum(dihedral, _worst_of_faces("tetrahedron", _equiangle_skew, (3,))(corners))


def _worst_of_faces(kind, of, sizes):
    """The largest value of the faces that have one of these numbers of corners."""
    faces = [list(face) for face in kinds.FACES[kind] if len(face) in sizes]
    return lambda corners: np.max([of(corners[:, face]) for face in faces], axis=0)


_SOLIDS = ("tetrahedron", "pyramid", "prism", "hexahedron")
_FLATS = ("triangle", "quadrilateral")

MEASURES = (
    ElementMeasure("edge_ratio", 1.0, 10.0, "", {kind: _edge_ratio(kind) for kind in _FLATS + _SOLIDS}),
    ElementMeasure("aspect_ratio", 1.0, 10.0, "", {
        "triangle": _aspect_of_triangle, "quadrilateral": _aspect_of_quadrilateral, "tetrahedron": _aspect_of_tetrahedron,
        "prism": _aspect_of_prism, "hexahedron": _aspect_of_hexahedron}),
    ElementMeasure("scaled_jacobian", 1.0, 0.0, "", {
        "triangle": _jacobian_of_triangle, "quadrilateral": _jacobian_of_quadrilateral, "tetrahedron": _jacobian_of_tetrahedron,
        "pyramid": _jacobian_of_pyramid, "prism": _jacobian_of_prism, "hexahedron": _jacobian_of_hexahedron}),
    ElementMeasure("equiangle_skew", 0.0, 1.0, "", {
        **dict.fromkeys(_FLATS, _equiangle_skew), "tetrahedron": _equiangle_skew_of_tetrahedron,
        **{kind: _worst_of_faces(kind, _equiangle_skew, (3, 4)) for kind in _SOLIDS[1:]}}),
    ElementMeasure("min_angle", 60.0, 0.0, "°", dict.fromkeys(_FLATS, _smallest_angle)),
    ElementMeasure("max_angle", 60.0, 180.0, "°", dict.fromkeys(_FLATS, _largest_angle)),
    ElementMeasure("skew", 0.0, 1.0, "", {"quadrilateral": _skew_of_quadrilateral, "hexahedron": _skew_of_hexahedron}),
    ElementMeasure("taper", 0.0, 1.0, "", {"quadrilateral": _taper_of_quadrilateral, "hexahedron": _taper_of_hexahedron}),
    ElementMeasure("warpage", 0.0, 1.0, "", {
        "quadrilateral": _warpage_of_quadrilateral,
        **{kind: _worst_of_faces(kind, _warpage_of_quadrilateral, (4,)) for kind in ("pyramid", "prism", "hexahedron")}}),
)
