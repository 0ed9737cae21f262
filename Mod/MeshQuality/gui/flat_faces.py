# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces of elements of any order as flat triangles between their nodes, for drawing."""

from functools import lru_cache

import numpy as np

from ..core.elements import kinds

# By number of nodes, middle nodes come after the corners; triangles of higher orders are divided by rule.
_TRIANGLES = {3: ((0, 1, 2),), 4: ((0, 1, 2), (0, 2, 3)), 6: ((0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5)),
              8: ((0, 4, 7), (4, 1, 5), (5, 2, 6), (6, 3, 7), (4, 5, 6), (4, 6, 7)),
              9: ((0, 4, 8), (4, 1, 8), (1, 5, 8), (5, 2, 8), (2, 6, 8), (6, 3, 8), (3, 7, 8), (7, 0, 8))}
_RING = {3: (0, 1, 2), 4: (0, 1, 2, 3), 6: (0, 3, 1, 4, 2, 5), 8: (0, 4, 1, 5, 2, 6, 3, 7), 9: (0, 4, 1, 5, 2, 6, 3, 7)}


def triangles_of_faces(faces):
    """int (F, k, 3): the flat triangles of each face, int (F, nodes per face) in Gmsh's order."""
    return faces[:, np.array(_division(faces.shape[1])[0])]


def sides_of(faces):
    """int (n, 2): the sides of faces, from node to node."""
    ring = faces[:, list(_division(faces.shape[1])[1])]
    return np.stack([ring, np.roll(ring, -1, axis=1)], axis=2).reshape(-1, 2)


@lru_cache(maxsize=None)
def _division(count):
    """(the triangles, the ring around them) of a face with this number of nodes."""
    if count in _TRIANGLES:
        return _TRIANGLES[count], _RING[count]
    kind = "triangle" if kinds.order_of("triangle", count) else "quadrilateral"
    order = kinds.order_of(kind, count)
    node = {tuple(place): i for i, place in enumerate(np.rint(order * kinds.places(kind, count)[:, :2]).astype(int).tolist())}
    squares = [[node.get(at) for at in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))] for i in range(order) for j in range(order)]
    halves = [half for a, b, c, d in squares for half in ((a, b, d), (b, c, d))]
    edges = np.arange(kinds.CORNERS[kind], kinds.CORNERS[kind] * order).reshape(-1, order - 1).tolist()
    return tuple(half for half in halves if None not in half), tuple(i for corner, edge in enumerate(edges) for i in (corner, *edge))
