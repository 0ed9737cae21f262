# SPDX-License-Identifier: LGPL-2.1-or-later
"""Elements of order 2 without middle nodes of faces, with these where the polynomials of the elements are."""

import numpy as np

from ..elements import kinds


def completed(points, volumes):
    """(points, volumes) in which all elements have all nodes of their order, each face one for both its elements.

    volumes  [(kind, int (E, nodes) in Gmsh's order), ...]
    """
    faces, parts, found = [], [points], []
    for kind, nodes in volumes:
        count, order = nodes.shape[1], kinds.order_of(kind, nodes.shape[1])
        full = kinds.count_of(kind, order)
        found.append(np.concatenate([nodes, np.zeros((len(nodes), full - count), dtype=np.int64)], axis=1))
        for face in (face for face in kinds.FACES[kind] if len(face) == 4 and full > count):
            faces.append((len(found) - 1, _middle_of(kind, face, full), np.sort(nodes[:, list(face)], axis=1), _amid(points, kind, nodes, face)))
    last = len(points)
    if faces:
        _, first, number = np.unique(np.concatenate([part[2] for part in faces]), axis=0, return_index=True, return_inverse=True)
        parts.append(np.concatenate([part[3] for part in faces])[first])
        number, at = number.ravel() + last, 0
        for volume, middle, corners, _ in faces:
            found[volume][:, middle] = number[at:at + len(corners)]
            at += len(corners)
        last += len(first)
    for (kind, nodes), whole in zip(volumes, found):
        if kind == "hexahedron" and whole.shape[1] > nodes.shape[1]:
            parts.append(points[nodes[:, 8:]].sum(axis=1) / 4 - points[nodes[:, :8]].sum(axis=1) / 4)
            whole[:, -1] = last + np.arange(len(nodes))
            last += len(nodes)
    return np.concatenate(parts), [(kind, whole) for (kind, _), whole in zip(volumes, found)]


def blended(points, volumes):
    """float64 (N, 3): points of whole elements of order 2, of which those amid quadrilaterals, which nodes on the edges leave free, are where
    elements without such nodes have them.
    """
    found = points.copy()
    for kind, nodes in volumes:
        for face in (face for face in kinds.FACES[kind] if len(face) == 4):
            found[nodes[:, _middle_of(kind, face, nodes.shape[1])]] = _amid(points, kind, nodes, face)
    return found


def _amid(points, kind, nodes, face):
    """float64 (E, 3): where the edges of a quadrilateral put its middle."""
    count = kinds.serendipity_count(kind, nodes.shape[1])
    edges = kinds.matching(kind, count, kinds.places(kind, count)[[*zip(face, (*face[1:], face[0]))]].mean(axis=1))
    return points[nodes[:, edges]].sum(axis=1) / 2 - points[nodes[:, list(face)]].sum(axis=1) / 4


def _middle_of(kind, face, full):
    """Which node of an element of order 2 is the middle one of a face."""
    return int(kinds.matching(kind, full, kinds.places(kind, full)[list(face)].mean(axis=0)[None])[0])
