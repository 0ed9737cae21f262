# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the elements of a mesh fit together.

They do not where a side has too many elements, where elements are there twice, or where a corner of one lies amid an
edge or a side of another, as refinement leaves it.
"""

import numpy as np

from . import kinds
from .hanging import hangs


def of_blocks(blocks, nodes, check=lambda: None):
    """(conforming, oriented): whether no side has more than two elements and no corner hangs, and whether all pairs see a
    side from two sides.

    A corner hangs that is an inner node of another element, or lies on an edge or a side of one (hanging.py). Sides are the faces of volume elements; of a mesh without these, the
    edges of triangles and quadrilaterals, where more than two may meet.

    check  called now and then; may raise Cancelled
    """
    highest = max(kinds.DIMENSION[block.kind] for block in blocks)
    whole = [block for block in blocks if kinds.DIMENSION[block.kind] == highest]
    if highest == 2:
        directed = np.concatenate([block.nodes[:, list(edge)] for block in whole for edge in kinds.EDGES[block.kind]])
        _, counts = np.unique(directed, axis=0, return_counts=True)
        _, pairs = np.unique(np.sort(directed, axis=1), axis=0, return_counts=True)
        return not hangs(whole, nodes) and not doubled(whole), bool(counts.max(initial=0) <= 1 or pairs.max(initial=0) > 2)
    conforming, oriented = not hangs(whole, nodes), True
    check()
    conforming = conforming and not doubled(whole)
    for corners in (3, 4):
        check()
        sides = [block.nodes[:, list(face)] for block in whole for face in kinds.FACES[block.kind] if len(face) == corners]
        if sides:
            counts, turns = _counted(np.concatenate(sides))
            conforming = conforming and bool(counts.max(initial=0) <= 2)
            oriented = oriented and not (turns[counts == 2] != 0).any()
    return conforming, oriented


def doubled(whole):
    """[(kind, index of an element, index of another one)]: elements with the same corners; indices count on from one block
    of the kind to the next. The corners of surface elements must also go round in the same direction: where two bodies
    touch, each may have the same triangle, seen from its own side.
    """
    found = []
    for kind in sorted({block.kind for block in whole}):
        corners = np.concatenate([block.nodes[:, :kinds.CORNERS[kind]] for block in whole if block.kind == kind])
        if kinds.DIMENSION[kind] == 3:
            corners = np.sort(corners, axis=1)
        else:
            turn = np.argmin(corners, axis=1)[:, None] + np.arange(corners.shape[1])
            corners = np.take_along_axis(corners, turn % corners.shape[1], axis=1)
        order = np.lexsort(corners.T[::-1])
        same = np.flatnonzero((corners[order][1:] == corners[order][:-1]).all(axis=1))
        found += [(kind, *sorted((int(order[i]), int(order[i + 1])))) for i in same]
    return found


def _counted(sides):
    """By side: how many elements have it, and the sum of their directions round it, 1 or -1."""
    first = np.argmin(sides, axis=1)
    rows = np.arange(len(sides))
    count = sides.shape[1]
    after, before = sides[rows, (first + 1) % count], sides[rows, (first - 1) % count]
    way = np.where(after < before, 1, -1)
    keys = np.sort(sides, axis=1)
    order = np.lexsort(keys.T)
    begins = np.append(True, (keys[order[1:]] != keys[order[:-1]]).any(axis=1))[:len(keys)]
    index = np.cumsum(begins) - 1
    return np.bincount(index), np.bincount(index, weights=way[order])
