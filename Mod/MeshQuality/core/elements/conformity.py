# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the elements of a mesh fit together.

They do not where a side has too many elements, or where a corner of one lies amid an edge or a side of another, as
refinement leaves it.
"""

import numpy as np

from . import kinds

_NEAR = 1e-6  # of the length of an edge: places that are the same


def of_blocks(blocks, nodes):
    """(conforming, oriented): whether no side has more than two elements and no corner hangs, and whether all pairs see a
    side from two sides.

    A corner hangs that is an inner node of another element, or lies at the middle of an edge or a side of a straight one
    to two of whose corners an edge leads from it. Sides are the faces of volume elements; of a mesh without these, the
    edges of triangles and quadrilaterals, where more than two may meet.
    """
    highest = max(kinds.DIMENSION[block.kind] for block in blocks)
    whole = [block for block in blocks if kinds.DIMENSION[block.kind] == highest]
    if highest == 2:
        directed = np.concatenate([block.nodes[:, list(edge)] for block in whole for edge in kinds.EDGES[block.kind]])
        _, counts = np.unique(directed, axis=0, return_counts=True)
        _, pairs = np.unique(np.sort(directed, axis=1), axis=0, return_counts=True)
        return not hangs(whole, nodes), bool(counts.max(initial=0) <= 1 or pairs.max(initial=0) > 2)
    conforming, oriented = not hangs(whole, nodes), True
    for corners in (3, 4):
        sides = [block.nodes[:, list(face)] for block in whole for face in kinds.FACES[block.kind] if len(face) == corners]
        if sides:
            counts, turns = _counted(np.concatenate(sides))
            conforming = conforming and bool(counts.max() <= 2)
            oriented = oriented and not (turns[counts == 2] != 0).any()
    return conforming, oriented


def _counted(sides):
    """By side: how many elements have it, and the sum of the ways in which they go round it, 1 or -1."""
    first = np.argmin(sides, axis=1)
    rows = np.arange(len(sides))
    count = sides.shape[1]
    after, before = sides[rows, (first + 1) % count], sides[rows, (first - 1) % count]
    way = np.where(after < before, 1, -1)
    _, index, counts = np.unique(np.sort(sides, axis=1), axis=0, return_inverse=True, return_counts=True)
    return counts, np.bincount(index, weights=way)


def hangs(whole, nodes):
    """Whether a corner of an element lies amid another one."""
    corners = np.unique(np.concatenate([block.nodes[:, : kinds.CORNERS[block.kind]].ravel() for block in whole]))
    inner = [block.nodes[:, kinds.CORNERS[block.kind] :].ravel() for block in whole]
    if np.isin(corners, np.concatenate(inner)).any():
        return True
    edges = np.concatenate([block.nodes[:, list(edge)] for block in whole for edge in kinds.EDGES[block.kind]]).astype(np.int64)
    known = set((edges.min(axis=1) * len(nodes) + edges.max(axis=1)).tolist())

    def joined(point, part):  # of two solids that only touch, nodes may lie anywhere
        return sum(min(point, q) * len(nodes) + max(point, q) in known for q in part) >= 2

    for block in whole:
        sides = kinds.FACES[block.kind] if kinds.DIMENSION[block.kind] == 3 else ()
        for part in (*kinds.EDGES[block.kind], *sides) if block.order == 1 else ():
            rows = block.nodes[:, list(part)]
            if any(joined(int(corners[i]), rows[j].tolist()) for i, j in _meeting(nodes[corners], nodes[rows])):
                return True
    return False


def _meeting(points, others):
    """Pairs (i, j) where points[i] is at the middle of the corners others[j]."""
    middles = others.mean(axis=1)
    tolerance = _NEAR * np.abs(others - middles[:, None]).max(axis=(1, 2))
    order = np.argsort(points[:, 0], kind="stable")
    index = np.arange(len(middles))
    first, last = (np.searchsorted(points[order, 0], middles[:, 0] + shift) for shift in (-tolerance, tolerance))
    while len(index):
        index, first, last = (array[first < last] for array in (index, first, last))
        found = order[first]
        near = np.abs(points[found] - middles[index]).max(axis=1) <= tolerance[index]
        yield from zip(found[near].tolist(), index[near].tolist())
        first = first + 1
