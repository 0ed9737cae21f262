# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lagrange polynomials of lines, triangles and tetrahedra: their values anywhere in the element, of nodes in Gmsh's order
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
def between(kind, order, wanted):
    """float64 (nodes of `wanted`, nodes of `order`): by which nodes of one order make those of another one."""
    found = values(kind, order, shares(kind, kinds.places(kind, kinds.count_of(kind, wanted))))
    found.flags.writeable = False
    return found


@functools.lru_cache(maxsize=None)
def _powers(kind, order):
    """int (nodes, corners): how many steps each node is away from the sides opposite to the corners."""
    at = shares(kind, kinds.places(kind, kinds.count_of(kind, order)))
    return np.rint(order * at).astype(int)
