# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lagrange polynomials of lines, triangles, quadrilaterals and tetrahedra: their values anywhere in the element, of nodes in Gmsh's order
that are equally spaced.
"""

import functools

import numpy as np

from . import kinds

SIMPLICES = ("line", "triangle", "tetrahedron")


def shares(kind, at):
    """float64 (n, corners): barycentric coordinates of places of the reference element."""
    at = np.asarray(at, dtype=float)[:, :kinds.DIMENSION[kind]]
    return np.column_stack([1.0 - at.sum(axis=1), at])


def values(kind, order, at):
    """float64 (n, nodes): the polynomial of each node at barycentric coordinates, as products of factors along each of
    them (Silvester 1969), which are exact at the nodes.
    """
    at = np.asarray(at, dtype=float)
    powers = _powers(kind, order)
    factors = np.ones((*at.shape, order + 1))
    for m in range(1, order + 1):
        factors[..., m] = factors[..., m - 1] * (order * at - (m - 1)) / m
    found = np.ones((len(at), len(powers)))
    for corner, power in enumerate(powers.T):
        found *= factors[:, corner, power]
    return found


@functools.lru_cache(maxsize=None)
def _powers(kind, order):
    """int (nodes, corners): how many steps each node is away from the sides opposite to the corners."""
    at = shares(kind, kinds.places(kind, kinds.count_of(kind, order)))
    return np.rint(order * at).astype(int)


def at_places(kind, count, at):
    """float64 (n, count): the polynomial of each node at places (n, 3) of the reference element; of quadrilaterals, too, with
    or without inner nodes.
    """
    order = kinds.order_of(kind, count)
    if kind != "quadrilateral":
        return values(kind, order, shares(kind, at))
    full = kinds.count_of(kind, order)
    line = kinds.places("line", order + 1)[:, 0]
    index = np.abs(kinds.places(kind, full)[:, :2, None] - line).argmin(axis=2)
    u, v = (values("line", order, shares("line", at[:, d:d + 1])) for d in (0, 1))
    found = u[:, index[:, 0]] * v[:, index[:, 1]]
    if full != count:  # 8 nodes: the ninth follows from them
        found[:, :4] -= 0.25 * found[:, 8:]
        found[:, 4:8] += 0.5 * found[:, 8:]
    return found[:, :count]
