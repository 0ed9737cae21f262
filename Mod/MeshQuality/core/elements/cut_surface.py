# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surface of a mesh as triangles of one order, on which distances from a shape are measured."""

import numpy as np

from . import kinds, lagrange

HIGHEST = 5  # order of triangles that are measured
_HALVES = ((0, 1, 2), (0, 2, 3))  # corners of the halves of a quadrilateral


def owners_of_triangles(sides, owners):
    """int (F,): the owner of each triangle that triangles_of_surface makes of the sides [int (n, nodes), ...] of a boundary, whose owners
    are [int (n,), ...].
    """
    kinds_of = [_kind_of(rows) for rows in sides]
    return np.concatenate([owner for kind, owner in sorted(zip(kinds_of, owners), key=lambda side: side[0], reverse=True)
                           for _ in (_HALVES if kind == "quadrilateral" else _HALVES[:1])])


def _kind_of(rows):
    return next(kind for kind in ("triangle", "quadrilateral") if kinds.order_of(kind, rows.shape[1]))


def triangles_of_surface(mesh):
    """(order, float64 (N, 3) nodes, int32 (F, n)) of the surface of an ElementMesh; (None, nodes, None) where it is not of sides of one order, or
    of too high a one.

    Halves of quadrilaterals follow the triangles, all of twice the order, which their diagonals have: no point of the surface changes.
    Surface meshes are of triangles alone.
    """
    sides = mesh.boundary()
    order = kinds.order_of("triangle", sides[0].shape[1])
    if len(sides) == 1 and order is not None and order <= HIGHEST:
        return order, mesh.nodes, sides[0]
    kinds_of = [_kind_of(rows) for rows in sides]
    orders = {kinds.order_of(kind, rows.shape[1]) for kind, rows in zip(kinds_of, sides)}
    order = 2 * max(orders)
    if len(orders) > 1 or order > HIGHEST or mesh.dimension < 3:
        return None, mesh.nodes, None
    count = kinds.count_of("triangle", order)
    at = kinds.places("triangle", count)
    points, found, first = [mesh.nodes], [], len(mesh.nodes)
    for kind, rows in sorted(zip(kinds_of, sides), key=lambda side: side[0], reverse=True):
        for corners in _HALVES if kind == "quadrilateral" else _HALVES[:1]:
            ends = kinds.places(kind, rows.shape[1])[list(corners)]
            places = ends[0] + at[:, :1] * (ends[1] - ends[0]) + at[:, 1:2] * (ends[2] - ends[0])
            values = lagrange.at_places(kind, rows.shape[1], places[3:])
            points.append(np.einsum("pn,fnx->fpx", values, mesh.nodes[rows]).reshape(-1, 3))
            own = first + np.arange(len(rows) * (count - 3)).reshape(len(rows), -1)
            found.append(np.concatenate([rows[:, list(corners)], own], axis=1))
            first += own.size
    return order, np.concatenate(points), np.concatenate(found).astype(np.int32)
