# SPDX-License-Identifier: LGPL-2.1-or-later
"""What finite volumes ask of volume elements and their neighbours: OpenFOAM's non-orthogonality and skewness of faces, as
checkMesh has them (primitiveMeshTools of OpenFOAM), by the corners of the elements.
"""

import numpy as np

from . import kinds
from .alike import groups, shares, sorted_rows
from .vectors import cross, dot, lengths

_TINY = 1e-150  # ROOTVSMALL of OpenFOAM: lengths below it are none


def finite_volume_measures(nodes, blocks, check=lambda: None):
    """(non-orthogonality in degrees, skewness), float64 (E,): of each volume element the largest of its faces. Non-orthogonality
    is 0 of elements without a neighbour.

    nodes   float64 (N, 3)
    blocks  [(kind, int (E, corners)), ...] of volume elements
    check   called now and then; may raise Cancelled
    """
    rings, owner = rings_of(blocks, check)
    centres = _centres_of(nodes, blocks, check)
    angle, skewness = np.zeros(len(rings)), np.zeros(len(rings))  # by face
    alone = np.ones(len(rings), dtype=bool)
    for first, second in pairs_of(blocks, check):
        own, other = centres[owner[first]], centres[owner[second]]
        centre, area = _of_rings(nodes, rings[first])
        angle[first] = angle[second] = _angle(other - own, area)
        skewness[first] = skewness[second] = _skewness_between(nodes[rings[first]], rings[first], centre, area, own, other)
        alone[first] = alone[second] = False
    flat = rings[:, 3] < 0
    for chosen in (np.flatnonzero(alone & flat), np.flatnonzero(alone & ~flat)):
        for share in _checked(len(chosen), check):
            at = chosen[share]
            centre, area = _of_rings(nodes, rings[at])
            beside = centre - centres[owner[at]]
            normal = area / (lengths(area) + _TINY)[:, None]
            skewness[at] = _skewness(nodes[rings[at]], rings[at], centre, area, beside, normal * dot(normal, beside)[:, None], 0.4)
    return _largest(angle, blocks), _largest(skewness, blocks)


def skew_faces(nodes, blocks, most, check=lambda: None):
    """int (N,), the nodes of all faces between two elements whose skewness is above `most`. The rest as finite_volume_measures."""
    rings, owner = rings_of(blocks, check)
    centres = _centres_of(nodes, blocks, check)
    found = [np.empty(0, dtype=rings.dtype)]
    for first, second in pairs_of(blocks, check):
        faces = rings[first]
        measured = _skewness_between(nodes[faces], faces, *_of_rings(nodes, faces), centres[owner[first]], centres[owner[second]])
        found.append(faces[measured > most].ravel())
    chosen = np.unique(np.concatenate(found))
    return chosen[chosen >= 0]


def _centres_of(nodes, blocks, check):
    """float64 (E, 3), the centres of volume of all elements."""
    return np.concatenate([np.empty((0, 3)), *(_centres(nodes[corners[share]], kind)
                                              for kind, corners in blocks for share in _checked(len(corners), check))])


def _checked(count, check):
    """The shares of `count` rows, with a check before each."""
    for share in shares(count):
        check()
        yield share


def _largest(of_faces, blocks):
    """float64 (E,): the largest value of the faces of each element."""
    found, start = [], 0
    for kind, corners in blocks:
        end = start + len(kinds.FACES[kind]) * len(corners)
        found.append(of_faces[start:end].reshape(-1, len(corners)).max(axis=0))
        start = end
    return np.concatenate(found)


def rings_of(blocks, check=lambda: None):
    """int32 (F, 4), the nodes of all faces of elements, -1 after the third of triangles; and (F,), their elements."""
    total = sum(len(kinds.FACES[kind]) * len(corners) for kind, corners in blocks)
    rings, owners = np.full((total, 4), -1, dtype=np.int32), np.empty(total, dtype=np.int32)
    at = start = 0
    for kind, corners in blocks:
        for face in kinds.FACES[kind]:
            check()
            rings[at:at + len(corners), :len(face)] = corners[:, list(face)]
            owners[at:at + len(corners)] = np.arange(start, start + len(corners))
            at += len(corners)
        start += len(corners)
    return rings, owners


def pairs_of(blocks, check=lambda: None):
    """Yields faces that two elements share, as the indices of either side in rings_of, int (P,), the lower one first; a share of them at a time."""
    starts, total = [], 0
    for kind, corners in blocks:
        for face in kinds.FACES[kind]:
            starts.append((corners, face, total))
            total += len(corners)
    for count in (3, 4):
        sides = [(corners, face) for corners, face, _ in starts if len(face) == count]
        if not sides:
            continue
        index = np.concatenate([np.arange(start, start + len(corners), dtype=np.int32) for corners, face, start in starts if len(face) == count])
        for chosen, begins in groups(sorted_rows(sides, check), check):
            ends = np.append(begins[1:], True)
            # Of a face that more than two have, no pair is a pair of neighbours.
            at = np.flatnonzero(begins[:-1] & ~begins[1:] & ends[1:])
            yield index[chosen[at]], index[chosen[at + 1]]


def _of_rings(nodes, rings):
    """Centres and area vectors of faces, float64 (F, 3), -1 after the third corner of triangles, which come alone."""
    return _of_faces(nodes[rings[:, :3 if len(rings) and rings[0, 3] < 0 else 4]])


def _of_faces(corners):
    """Centres and area vectors, float64 (F, 3), of faces by float64 (F, 3 | 4, 3): of quadrilaterals by the four triangles at the mean of their corners."""
    if corners.shape[1] == 3:
        a, b, c = corners.transpose(1, 0, 2)
        return (a + b + c) / 3.0, 0.5 * cross(b - a, c - a)
    middle = corners.mean(axis=1, keepdims=True)
    following = np.roll(corners, -1, axis=1)
    normals = cross(following - corners, middle - corners)
    sizes = lengths(normals)
    whole = sizes.sum(axis=1)
    weighted = (sizes[..., None] * (corners + following + middle)).sum(axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        centre = np.where(whole[:, None] > 0.0, weighted / (3.0 * whole[:, None]), middle[:, 0])
    return centre, 0.5 * normals.sum(axis=1)


def _centres(corners, kind):
    """The centres of volume of elements, by the pyramids of the faces over the mean of their centres."""
    faces = [_of_faces(corners[:, list(face)]) for face in kinds.FACES[kind]]
    guess = sum(centre for centre, _ in faces) / len(faces)
    volumes = [dot(area, centre - guess) for centre, area in faces]
    whole = sum(volumes)
    weighted = sum(volume[:, None] * (0.75 * centre + 0.25 * guess) for volume, (centre, _) in zip(volumes, faces))
    with np.errstate(divide="ignore", invalid="ignore"):
        found = weighted / whole[:, None]
    return np.where(np.isfinite(found).all(axis=1)[:, None], found, guess)


def _angle(between, area):
    return np.degrees(np.arctan2(lengths(cross(between, area)), dot(between, area)))


def _skewness_between(corners, rings, centre, area, own, other):
    """_skewness of faces between elements with the centres `own` and `other`."""
    return _skewness(corners, rings, centre, area, centre - own, other - own, 0.2)


def _skewness(corners, rings, centre, area, beside, between, least):
    """|s| over the extent of the face along s, where s leads from the face's centre to where the line between the centres meets
    it; `beside` leads from the centre of the owner to that of the face.
    """
    along = dot(area, beside) / (dot(area, between) + _TINY)
    off = beside - along[:, None] * between
    size = lengths(off)
    direction = off / (size + _TINY)[:, None]
    extents = np.abs(dot(corners - centre[:, None], direction[:, None]))
    extents[rings < 0] = 0.0
    return size / np.maximum(extents.max(axis=1), least * lengths(between) + _TINY)
