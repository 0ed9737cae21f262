# SPDX-License-Identifier: LGPL-2.1-or-later
"""What finite volumes ask of volume elements and their neighbours: OpenFOAM's non-orthogonality and skewness of faces, as
checkMesh has them (primitiveMeshTools of OpenFOAM), by the corners of the elements.
"""

from dataclasses import dataclass

import numpy as np

from . import kinds

_TINY = 1e-150  # ROOTVSMALL of OpenFOAM: lengths below it are none


@dataclass(frozen=True)
class _Faces:
    """The faces of all elements, (F,) each: rings (F, 4) of corners, -1 after the third one of triangles; the elements that they
    are of, centres and area vectors, which point out of that element.
    """

    rings: np.ndarray
    owner: np.ndarray
    centre: np.ndarray
    area: np.ndarray


def finite_volume_measures(nodes, blocks, check=lambda: None):
    """(non-orthogonality in degrees, skewness), float64 (E,): of each volume element the largest of its faces. Non-orthogonality
    is 0 of elements without a neighbour.

    nodes   float64 (N, 3)
    blocks  [(kind, int (E, corners)), ...] of volume elements
    check   called now and then; may raise Cancelled
    """
    faces = _faces_of(nodes, blocks)
    check()
    count = sum(len(corners) for _, corners in blocks)
    centres = _centres_of_elements(nodes, blocks, faces, count)
    check()
    first, second = _pairs_of(faces.rings)
    check()
    angle, skewness = np.zeros(count), np.zeros(count)
    inner = _angle(centres[faces.owner[second]] - centres[faces.owner[first]], faces.area[first])
    check()
    across = _skewness_inside(nodes, faces, first, centres[faces.owner[first]], centres[faces.owner[second]])
    for side in (first, second):
        check()
        np.maximum.at(angle, faces.owner[side], inner)
        np.maximum.at(skewness, faces.owner[side], across)
    alone = np.setdiff1d(np.arange(len(faces.owner)), np.concatenate([first, second]))
    np.maximum.at(skewness, faces.owner[alone], _skewness_at_border(nodes, faces, alone, centres[faces.owner[alone]]))
    return angle, skewness


def rings_of(blocks):
    """int64 (F, 4), the nodes of all faces of elements, -1 after the third of triangles; and (F,), their elements."""
    rings, owners, start = [], [], 0
    for kind, corners in blocks:
        for face in kinds.FACES[kind]:
            ring = np.full((len(corners), 4), -1, dtype=np.int64)
            ring[:, :len(face)] = corners[:, list(face)]
            rings.append(ring)
            owners.append(start + np.arange(len(corners)))
        start += len(corners)
    return np.concatenate(rings), np.concatenate(owners)


def _faces_of(nodes, blocks):
    rings, owners = rings_of(blocks)
    centre, area = _centres_of_faces(nodes, rings)
    return _Faces(rings, owners, centre, area)


def _length(vectors):
    return np.sqrt(np.einsum("...i,...i->...", vectors, vectors))


def _dot(a, b):
    return np.einsum("...i,...i->...", a, b)


def _centres_of_faces(nodes, rings):
    """Centres and area vectors: of quadrilaterals by the four triangles at the mean of their corners."""
    centre, area = np.empty((len(rings), 3)), np.empty((len(rings), 3))
    flat = rings[:, 3] < 0
    a, b, c = nodes[rings[flat, :3]].transpose(1, 0, 2)
    centre[flat], area[flat] = (a + b + c) / 3.0, 0.5 * np.cross(b - a, c - a)
    corners = nodes[rings[~flat]]
    middle = corners.mean(axis=1, keepdims=True)
    following = np.roll(corners, -1, axis=1)
    normals = np.cross(following - corners, middle - corners)
    sizes = _length(normals)
    whole = sizes.sum(axis=1)
    weighted = (sizes[..., None] * (corners + following + middle)).sum(axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        centre[~flat] = np.where(whole[:, None] > 0.0, weighted / (3.0 * whole[:, None]), middle[:, 0])
    area[~flat] = 0.5 * normals.sum(axis=1)
    return centre, area


def _centres_of_elements(nodes, blocks, faces, count):
    """The centres of volume, by the pyramids of the faces over the mean of their centres."""
    number = np.bincount(faces.owner, minlength=count)
    guess = _summed(faces.owner, faces.centre, count) / number[:, None]
    volumes = _dot(faces.area, faces.centre - guess[faces.owner])
    whole = np.bincount(faces.owner, weights=volumes, minlength=count)
    weighted = _summed(faces.owner, volumes[:, None] * (0.75 * faces.centre + 0.25 * guess[faces.owner]), count)
    with np.errstate(divide="ignore", invalid="ignore"):
        found = weighted / whole[:, None]
    return np.where(np.isfinite(found).all(axis=1)[:, None], found, guess)


def _summed(owner, vectors, count):
    return np.stack([np.bincount(owner, weights=vectors[:, k], minlength=count) for k in range(3)], axis=1)


def _pairs_of(rings):
    """Faces that two elements share: the indices of either side."""
    keys = np.sort(rings, axis=1)
    order = np.lexsort(keys.T)
    same = (keys[order[1:]] == keys[order[:-1]]).all(axis=1)
    # Of a face that more than two have, no pair is a pair of neighbours.
    once = same & ~np.append(same[1:], False) & ~np.append(False, same[:-1])
    at = np.flatnonzero(once)
    return order[at], order[at + 1]


def _angle(between, area):
    return np.degrees(np.arctan2(_length(np.cross(between, area)), _dot(between, area)))


def _skewness(nodes, faces, which, beside, between, least):
    """|s| over the extent of the face along s, where s leads from the face's centre to where the line between the centres meets
    it; `beside` leads from the centre of the owner to that of the face.
    """
    area = faces.area[which]
    along = _dot(area, beside) / (_dot(area, between) + _TINY)
    off = beside - along[:, None] * between
    size = _length(off)
    direction = off / (size + _TINY)[:, None]
    rings = faces.rings[which]
    extents = np.abs(_dot(nodes[rings] - faces.centre[which][:, None], direction[:, None]))
    extents[rings < 0] = 0.0
    return size / np.maximum(extents.max(axis=1), least * _length(between) + _TINY)


def _skewness_inside(nodes, faces, which, own, other):
    return _skewness(nodes, faces, which, faces.centre[which] - own, other - own, 0.2)


def _skewness_at_border(nodes, faces, which, own):
    beside = faces.centre[which] - own
    normal = faces.area[which] / (_length(faces.area[which]) + _TINY)[:, None]
    return _skewness(nodes, faces, which, beside, normal * _dot(normal, beside)[:, None], 0.4)
