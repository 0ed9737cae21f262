# SPDX-License-Identifier: LGPL-2.1-or-later
"""How good the shapes of elements are, by their corners; middle nodes count elsewhere, by the Jacobian."""

from dataclasses import dataclass

import numpy as np

from . import kinds

_UP = np.sqrt(0.75)  # height of the triangle with sides 1
_TETRAHEDRON_UP = np.sqrt(2.0 / 3.0)
# Corners of the regular element of each kind, all sides 1.
_REGULAR = {
    "triangle": ((0, 0, 0), (1, 0, 0), (0.5, _UP, 0)),
    "quadrilateral": ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)),
    "tetrahedron": ((0, 0, 0), (1, 0, 0), (0.5, _UP, 0), (0.5, _UP / 3, _TETRAHEDRON_UP)),
    "pyramid": ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0.5, np.sqrt(0.5))),
    "prism": ((0, 0, 0), (1, 0, 0), (0.5, _UP, 0), (0, 0, 1), (1, 0, 1), (0.5, _UP, 1)),
    "hexahedron": ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)),
}


@dataclass(frozen=True)
class Shapes:
    """float64 (E,) each.

    angle       of volumes the smallest angle between two faces, of surfaces that between two sides, degrees
    aspect      longest / shortest side
    distortion  eta of curve/output/shape_distortion.h (Knupp 2001), the largest of the corners, each by its sides: 1 is the
                regular element, infinite a corner that is folded
    content     volume in mm³, below 0 where the element is inside out; of surfaces the area in mm²
    """

    angle: np.ndarray
    aspect: np.ndarray
    distortion: np.ndarray
    content: np.ndarray


def shapes_of(kind, corners):
    """The Shapes of elements of a kind by their corners, float64 (E, corners, 3)."""
    sides = np.stack([np.linalg.norm(corners[:, b] - corners[:, a], axis=1) for a, b in kinds.EDGES[kind]])
    with np.errstate(divide="ignore", invalid="ignore"):
        aspect = np.where(sides.min(axis=0) > 0.0, sides.max(axis=0) / sides.min(axis=0), np.inf)
    solid = kinds.DIMENSION[kind] == 3
    angle = _angles_of_faces(kind, corners) if solid else _angles_of_sides(kind, corners)
    content = _volume(kind, corners) if solid else np.linalg.norm(_normal(corners), axis=1)
    return Shapes(angle, aspect, _distortion(kind, corners), content)


def _normal(ring):
    """Half the sum of cross products around a ring (E, n, 3): its area as a vector, exact also of one that is not flat."""
    return 0.5 * np.cross(ring, np.roll(ring, -1, axis=1)).sum(axis=1)


def _volume(kind, corners):
    own = corners - corners[:, :1]
    faces = [own[:, list(face)] for face in kinds.FACES[kind]]
    return sum(np.einsum("ij,ij->i", face.mean(axis=1), _normal(face)) for face in faces) / 3.0


def _angle_between(a, b):
    """Degrees, also of vectors without a length, which stand at none."""
    return np.degrees(np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), np.einsum("ij,ij->i", a, b)))


def _angles_of_faces(kind, corners):
    own = corners - corners[:, :1]
    normals = [_normal(own[:, list(face)]) for face in kinds.FACES[kind]]
    pairs = [[k for k, face in enumerate(kinds.FACES[kind]) if a in face and b in face] for a, b in kinds.EDGES[kind]]
    return np.min([180.0 - _angle_between(normals[i], normals[j]) for i, j in pairs], axis=0)


def _angles_of_sides(kind, corners):
    n = kinds.CORNERS[kind]
    return np.min([_angle_between(corners[:, (k + 1) % n] - corners[:, k], corners[:, k - 1] - corners[:, k])
                   for k in range(n)], axis=0)


def _distortion(kind, corners):
    """The largest of the corners at which as many sides meet as the element has dimensions: all but the tip of a pyramid."""
    dimension = kinds.DIMENSION[kind]
    regular = np.array(_REGULAR[kind], dtype=float)
    found = []
    for corner in range(kinds.CORNERS[kind]):
        ends = [b if a == corner else a for a, b in kinds.EDGES[kind] if corner in (a, b)]
        if len(ends) != dimension:
            continue
        ideal = _in_own_plane((regular[ends] - regular[corner])[None])[0]
        found.append(_eta(_in_own_plane(corners[:, ends] - corners[:, corner, None]), ideal, dimension))
    return np.max(found, axis=0)


def _in_own_plane(sides):
    """The sides at a corner, (E, d, 3), as columns of matrices (E, d, d); two sides in coordinates of the plane that
    they span.
    """
    if sides.shape[1] == 3:
        return np.swapaxes(sides, 1, 2)
    first, second = sides[:, 0], sides[:, 1]
    length = np.maximum(np.linalg.norm(first, axis=1), np.finfo(float).tiny)
    along = np.einsum("ij,ij->i", first, second) / length
    across = np.linalg.norm(np.cross(first, second), axis=1) / length
    return np.stack([np.stack([length, along], axis=1), np.stack([np.zeros_like(length), across], axis=1)], axis=1)


def _eta(matrices, ideal, dimension):
    mapped = matrices @ np.linalg.inv(ideal)
    determinant = np.linalg.det(mapped)
    valid = determinant > 0.0
    norm = np.einsum("ijk,ijk->i", mapped, mapped)
    return np.where(valid, norm / (dimension * np.where(valid, determinant, 1.0) ** (2.0 / dimension)), np.inf)
