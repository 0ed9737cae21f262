# SPDX-License-Identifier: LGPL-2.1-or-later
"""Polynomials of elements of any kind by their nodes, and their values elsewhere in the element."""

import functools
from math import comb

import numpy as np

from . import kinds, lagrange


def _line(order, t):
    """float64 (n, order + 1): the polynomials of equally spaced nodes, in their order along [0, 1]."""
    nodes = np.arange(order + 1) / order
    factors = [(t[:, None] - nodes[others]) / (nodes[i] - nodes[others])
               for i in range(order + 1) for others in [np.arange(order + 1) != i]]
    return np.stack([factor.prod(axis=1) for factor in factors], axis=1)


def _bernstein(i, n, t):
    return comb(n, i) * t**i * (1 - t) ** (n - i)


def _pyramid_basis(order, at):
    """Of Bergot, Cohen, Durufle 2010, as the core has it, with the corners of the base at 0 and 1."""
    side = 1 - at[:, 2]
    inside = side > 1e-12
    u, v = (np.where(inside, (at[:, axis] - 0.5 * at[:, 2]) / np.where(inside, side, 1), 0.0) for axis in (0, 1))
    return np.stack([_bernstein(k, order, at[:, 2]) * _bernstein(i, order - k, u) * _bernstein(j, order - k, v)
                     for k in range(order + 1) for i in range(order - k + 1) for j in range(order - k + 1)], axis=1)


def values(kind, order, at):
    """float64 (n, nodes): the polynomial of each node of the full element, in Gmsh's order, at places as kinds.places has
    them.
    """
    at, nodes = np.asarray(at, dtype=float), kinds.places(kind, kinds.count_of(kind, order))
    if kind in lagrange.SIMPLICES:
        return lagrange.values(kind, order, lagrange.shares(kind, at))
    if kind == "pyramid":
        return np.linalg.solve(_pyramid_basis(order, nodes).T, _pyramid_basis(order, at).T).T
    steps = np.rint(nodes * order).astype(int)
    if kind == "prism":
        flat = kinds.places("triangle", kinds.count_of("triangle", order))
        which = kinds.matching("triangle", len(flat), np.column_stack([nodes[:, :2], 0 * nodes[:, 2]]))
        of_triangle = lagrange.values("triangle", order, lagrange.shares("triangle", at))
        return of_triangle[:, which] * _line(order, at[:, 2])[:, steps[:, 2]]
    found = np.ones((len(at), len(nodes)))
    for axis in range(kinds.DIMENSION[kind]):
        found = found * _line(order, at[:, axis])[:, steps[:, axis]]
    return found


@functools.lru_cache(maxsize=None)
def between(kind, order, wanted):
    """float64 (nodes of `wanted`, nodes of `order`): the weights of nodes of `order` at the nodes of `wanted`."""
    return values(kind, order, kinds.places(kind, kinds.count_of(kind, wanted)))


@functools.lru_cache(maxsize=None)
def lowered(kind, order, lower):
    """float64 (nodes, nodes): maps nodes of an order to those of the polynomial of a lower order through
    points of theirs.
    """
    return between(kind, lower, order) @ between(kind, order, lower)


@functools.lru_cache(maxsize=None)
def corner_weights(kind, order):
    """float64 (nodes, corners): the weights of the corners at the nodes of the straight element."""
    at = kinds.places(kind, kinds.count_of(kind, order))
    if kind != "pyramid":
        return values(kind, 1, at)
    side = np.where(at[:, 2] < 1 - 1e-12, 1 - at[:, 2], 1)
    base = np.column_stack([(at[:, :2] - 0.5 * at[:, 2:]) / side[:, None], 0 * at[:, 2]])
    return np.column_stack([values("quadrilateral", 1, base) * (1 - at[:, 2:]), at[:, 2]])
