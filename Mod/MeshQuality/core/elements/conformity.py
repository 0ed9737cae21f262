# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the elements of a mesh fit together.

They do not where a side has too many elements, where elements are there twice, or where a corner of one lies amid an
edge or a side of another, as refinement leaves it.
"""

import numpy as np

from . import kinds
from .alike import groups, shares, sorted_rows
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
    conforming, oriented = not hangs(whole, nodes, check), True
    conforming = conforming and not doubled(whole, check)
    for corners in (3, 4):
        sides = [(block.nodes, face) for block in whole for face in kinds.FACES[block.kind] if len(face) == corners]
        for counts, turns in _counted(sides, check) if sides else ():
            conforming = conforming and bool(counts.max(initial=0) <= 2)
            oriented = oriented and not (turns[counts == 2] != 0).any()
    return conforming, oriented


def doubled(whole, check=lambda: None):
    """[(kind, index of an element, index of another one)]: elements with the same corners; indices count on from one block
    of the kind to the next. The corners of surface elements must also go round in the same direction: where two bodies
    touch, each may have the same triangle, seen from its own side.
    """
    found = []
    for kind in sorted({block.kind for block in whole}):
        alike = [block.nodes for block in whole if block.kind == kind]
        if kinds.DIMENSION[kind] == 3:
            corners = sorted_rows([(nodes, range(kinds.CORNERS[kind])) for nodes in alike], check)
        else:
            corners = np.concatenate([nodes[:, :kinds.CORNERS[kind]] for nodes in alike])
            turn = np.argmin(corners, axis=1)[:, None] + np.arange(corners.shape[1])
            corners = np.take_along_axis(corners, turn % corners.shape[1], axis=1)
        for chosen, begins in groups(corners, check):
            found += [(kind, *sorted((int(chosen[i]), int(chosen[i + 1])))) for i in np.flatnonzero(~begins[1:])]
    return found


def _counted(sides, check):
    """Yields by side, a share of them at a time: how many elements have it, and the sum of their directions round it, 1 or -1.

    sides  [(elements, nodes of the side in an element), ...]
    """
    way = np.empty(sum(len(nodes) for nodes, _ in sides), dtype=np.int8)
    start = 0
    for nodes, face in sides:
        for share in shares(len(nodes)):
            check()
            way[start + share.start:start + share.stop] = _way(nodes[share], face)
        start += len(nodes)
    for chosen, begins in groups(sorted_rows(sides, check), check):
        index = np.cumsum(begins) - 1
        yield np.bincount(index), np.bincount(index, weights=way[chosen])


def _way(nodes, face):
    """int (F,): in which direction the corners of sides go round."""
    sides = nodes[:, list(face)]
    first = np.argmin(sides, axis=1)
    rows = np.arange(len(sides))
    count = sides.shape[1]
    after, before = sides[rows, (first + 1) % count], sides[rows, (first - 1) % count]
    return np.where(after < before, 1, -1)
