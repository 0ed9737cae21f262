# SPDX-License-Identifier: LGPL-2.1-or-later
"""The edges and faces of lines, triangles and tetrahedra of any order, each once: what elements share."""

import itertools
from typing import NamedTuple

import numpy as np

from . import kinds, lagrange

# Edges and faces by their corners: as MFEM and Nektar++ go through them, too.
EDGES = {"line": ((0, 1),), "triangle": ((0, 1), (1, 2), (0, 2)),
         "tetrahedron": ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3))}
FACES = {"line": (), "triangle": ((0, 1, 2),), "tetrahedron": ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1))}


class Sides(NamedTuple):
    """Edges or faces, each once, in the order in which elements first have them.

    corners  int (n, 2 or 3), ascending
    nodes    int (n, nodes), with the corners in this order, as Gmsh orders a line or a triangle
    of       {kind: int (elements, sides)}: which each element has
    turns    {kind: int (elements, sides)}: the corners of an element's side are corners[TURNS[...][turn]]
    first    int (n, 3): the corners as the first element with it has them
    """

    corners: np.ndarray
    nodes: np.ndarray
    of: dict
    turns: dict
    first: np.ndarray


TURNS = {2: tuple(itertools.permutations(range(2))), 3: tuple(itertools.permutations(range(3)))}


def edges_of(elements, order):
    """The Sides of {kind: int (E, nodes)} in Gmsh's order; the first kinds are numbered first."""
    return _sides(elements, order, EDGES, "line")


def faces_of(elements, order):
    """Likewise, of the faces."""
    return _sides(elements, order, FACES, "triangle")


def _sides(elements, order, table, flat):
    width, places = kinds.CORNERS[flat], kinds.places(flat, kinds.count_of(flat, order))
    held = [(kind, nodes) for kind, nodes in elements.items() if table[kind]]
    given = [nodes[:, table[kind]].reshape(-1, width) for kind, nodes in held]
    given = np.concatenate([np.zeros((0, width), dtype=np.int64), *given])
    ascending = np.argsort(given, axis=1, kind="stable")
    found, first, number = np.unique(np.take_along_axis(given, ascending, axis=1), axis=0, return_index=True,
                                     return_inverse=True)
    by_appearance = np.argsort(first, kind="stable")
    rank = np.empty(len(found), dtype=np.int64)
    rank[by_appearance] = np.arange(len(found))
    number, turn = rank[number.ravel()], _turns_of(np.argsort(ascending, axis=1, kind="stable"))
    all_nodes = np.zeros((len(found), len(places)), dtype=np.int64)
    of, turns, at = {}, {}, 0
    for kind, nodes in held:
        shape = (len(nodes), len(table[kind]))
        of[kind] = number[at:at + shape[0] * shape[1]].reshape(shape)
        turns[kind] = turn[at:at + shape[0] * shape[1]].reshape(shape)
        at += shape[0] * shape[1]
        for side, which, t in _groups(turns[kind], flat):
            all_nodes[of[kind][which, side]] = nodes[which][:, places_on(kind, order, flat, side, t)]
    return Sides(found[by_appearance], all_nodes, of, turns, given[first[by_appearance]])


def _turns_of(order):
    """The number in TURNS of each row of `order`."""
    turns = np.array(TURNS[order.shape[1]])
    return (order[:, None, :] == turns[None]).all(axis=2).argmax(axis=1)


def _groups(turns, flat):
    """(side, indices of elements, turn) of all elements with a side that is turned in one way."""
    for side in range(turns.shape[1]):
        for turn in range(len(TURNS[kinds.CORNERS[flat]])):
            which = np.flatnonzero(turns[:, side] == turn)
            if len(which):
                yield side, which, turn


def places_on(kind, order, flat, side, turn):
    """int (nodes of the side,): which nodes of an element are those of a side, with its corners ascending."""
    table = EDGES if flat == "line" else FACES
    weights = lagrange.shares(flat, kinds.places(flat, kinds.count_of(flat, order)))
    corners = kinds.places(kind, kinds.count_of(kind, order))[list(table[kind][side])]
    # Corner i of the element's side is corner TURNS[turn][i] of the ascending ones.
    return kinds.matching(kind, kinds.count_of(kind, order), weights[:, TURNS[len(corners)][turn]] @ corners)


def fill(sides, kind, order, flat, made, numbers):
    """Puts the nodes inside of sides, numbers (n, inner nodes), into the elements `made` (E, nodes) of an order."""
    inner = kinds.CORNERS[flat] + (3 * (order - 1) if flat == "triangle" else 0)
    if numbers.shape[1]:
        for side, which, turn in _groups(sides.turns[kind], flat):
            places = places_on(kind, order, flat, side, turn)[inner:]
            made[which[:, None], places[None]] = numbers[sides.of[kind][which, side]]
