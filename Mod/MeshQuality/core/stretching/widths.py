# SPDX-License-Identifier: LGPL-2.1-or-later
"""How wide faces are at their borders: edges across a face cannot be longer, whatever a metric wants."""

import numpy as np

from .triangles import edge_keys

_MOST = 1_000_000  # rays times segments at a time


def at_borders(triangles, edges_of_face):
    """(rows of pairs, unit directions (n, 3) into the face across its border, widths there in mm; infinite: nothing is opposite).

    edges_of_face  the numbers of the edges of each face
    """
    found = [_of_face(triangles, face, edges) for face, edges in enumerate(edges_of_face)]
    return tuple(np.concatenate(parts) for parts in zip(*found))


def _of_face(mesh, face, edges):
    segments = np.flatnonzero(np.isin(mesh.segments[:, 2], edges))
    inside = _inner_corners(mesh, face, segments)
    known = inside >= 0
    segments, inside = segments[known], inside[known]
    ends = mesh.segments[segments, :2]
    rows = mesh.pair(np.full(ends.shape, face), ends)
    known = (rows >= 0).all(axis=1)
    ends, rows, inside, tangents = ends[known], rows[known].ravel(), inside[known], mesh.tangents[segments[known]].reshape(-1, 3)
    normals = mesh.pairs.normals[rows]
    across = np.cross(normals, tangents)
    length = np.linalg.norm(across, axis=1)
    good = length > 0.5
    into = np.repeat(mesh.points[inside] - mesh.points[ends[:, 0]], 2, axis=0)
    across *= (np.where(np.einsum("ij,ij->i", across, into) < 0.0, -1.0, 1.0) / np.maximum(length, 1e-300))[:, None]
    rows, across, normals, start = rows[good], across[good], normals[good], ends.ravel()[good]
    widths = np.full(len(rows), np.inf)
    step = max(1, _MOST // max(1, len(ends)))
    for low in range(0, len(rows), step):
        part = slice(low, low + step)
        widths[part] = _opposite(mesh.points, start[part], across[part], np.cross(across[part], normals[part]), ends)
    return rows, across, widths


def _inner_corners(mesh, face, segments):
    """The vertex of the face's triangle at each segment that is opposite to it; -1: there is none."""
    corners, count = mesh.vertices[mesh.face == face], len(mesh.points)
    keys = edge_keys(corners, np.roll(corners, -1, axis=1), count).ravel()
    third = np.roll(corners, -2, axis=1).ravel()
    order = np.argsort(keys, kind="stable")
    if not len(order):
        return np.full(len(segments), -1)
    wanted = edge_keys(*mesh.segments[segments, :2].T, count)
    at = order[np.minimum(np.searchsorted(keys[order], wanted), len(order) - 1)]
    return np.where(keys[at] == wanted, third[at], -1)


def _opposite(points, start, across, along, ends):
    """mm: how far the nearest segment is in directions (n, 3), seen along the normal."""
    rest = points[ends][None] - points[start][:, None, None]
    side, depth = (np.einsum("nsek,nk->nse", rest, axis) for axis in (along, across))
    gap = side[..., 0] - side[..., 1]
    hit = (side[..., 0] * side[..., 1] <= 0.0) & (gap != 0.0) & (ends[None] != start[:, None, None]).all(axis=2)
    share = side[..., 0] / np.where(hit, gap, 1.0)
    hit &= depth[..., 0] + share * (depth[..., 1] - depth[..., 0]) > 0.0
    far = np.linalg.norm(rest[:, :, 0] + share[..., None] * (rest[:, :, 1] - rest[:, :, 0]), axis=2)
    return np.where(hit, far, np.inf).min(axis=1, initial=np.inf)
