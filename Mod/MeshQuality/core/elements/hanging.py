# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corners that lie amid an edge or a face of another element, anywhere on it, straight or curved.

Sides that two elements have are closed: such a corner is on sides that one element has. Where an edge is divided on one
side only, a piece of it begins at each of its ends: that piece's other end lies on the edge. Where a face is divided and
its edges are not, each of its corners has an edge to a corner inside. So the neighbours of one end, or of one corner, are
all that is looked at, and bodies that only touch are not.
"""

import numpy as np

from . import boundary, kinds, lagrange
from .alike import unique_pairs

_NEAR = 1e-6  # share of an edge's length within which places are the same
_ROUNDS = 12  # steps of Newton's method
_STEP = 1e-5  # step of the parameters for derivatives
_AT_A_TIME = 50_000


def hangs(whole, nodes, check=lambda: None):
    """Whether a corner of an element lies amid another one. `check` is called now and then; it may raise Cancelled."""
    inner = [block.nodes[:, kinds.CORNERS[block.kind]:].ravel() for block in whole if block.nodes.shape[1] > kinds.CORNERS[block.kind]]
    if inner:
        is_corner = np.zeros(len(nodes), dtype=bool)
        for block in whole:
            is_corner[block.nodes[:, :kinds.CORNERS[block.kind]]] = True
        if is_corner[np.concatenate(inner)].any():
            return True
    parts = list(_parts(whole, check))
    neighbours = _Neighbours([rows[:, :2] for kind, _, rows, _ in parts if kind == "line"], len(nodes))
    return any(_any_on(kind, order, rows, elements, neighbours, nodes, check) for kind, order, rows, elements in parts)


class _Neighbours:
    """The corners that edges connect with each corner."""

    def __init__(self, ends, count):
        ends = np.concatenate([np.empty((0, 2), dtype=np.int32), *ends])
        both, _ = unique_pairs(np.concatenate([ends, ends[:, ::-1]]))
        self._first = np.searchsorted(both[:, 0], np.arange(count + 1))
        self._other = both[:, 1]

    def of(self, corners):
        """(row, neighbour): each neighbour of each of the corners."""
        counts = self._first[corners + 1] - self._first[corners]
        row = np.repeat(np.arange(len(corners)), counts)
        offset = np.arange(len(row)) - np.repeat(np.cumsum(counts) - counts, counts)
        return row, self._other[self._first[corners][row] + offset]


def _parts(whole, check):
    """(kind, order, rows of nodes, corners of the element behind) of edges and faces that are on sides of one element."""
    volumes = any(kinds.DIMENSION[block.kind] == 3 for block in whole)
    for rows, block, element in boundary.with_elements(whole, check):
        count = rows.shape[1]
        kind = "triangle" if kinds.order_of("triangle", count) else "quadrilateral"
        order, corners = kinds.order_of(kind, count), _corners_of(whole, block, element)
        if volumes:
            yield kind, order, rows, corners
        once = None if volumes else _used_once(rows, kind, whole)
        at = kinds.places(kind, count)
        for number, edge in enumerate(kinds.EDGES[kind]):
            a, b = at[list(edge)]
            inner = a + (b - a) * np.arange(1, order)[:, None] / order
            local = [*edge, *(kinds.matching(kind, count, inner) if order > 1 else ())]
            chosen = slice(None) if volumes else once[number]
            yield "line", order, rows[chosen][:, local], corners[chosen]


def _corners_of(whole, block, element):
    """int (F, 8): the corners of elements, and -1."""
    found = np.full((len(element), 8), -1)
    for i, one in enumerate(whole):
        chosen = block == i
        count = kinds.CORNERS[one.kind]
        found[chosen, :count] = one.nodes[element[chosen], :count]
    return found


def _used_once(rows, kind, whole):
    """bool (F,) for each edge of the kind: whether just one triangle or quadrilateral of all has that edge."""
    ends = [np.sort(block.nodes[:, list(edge)], axis=1) for block in whole for edge in kinds.EDGES[block.kind]]
    edges, counts = np.unique(np.concatenate(ends).astype(np.int64) @ [2**32, 1], return_counts=True)
    single = edges[counts == 1]
    return [np.isin(np.sort(rows[:, list(edge)], axis=1).astype(np.int64) @ [2**32, 1], single)
            for edge in kinds.EDGES[kind]]


def _any_on(kind, order, rows, elements, neighbours, nodes, check):
    corners = kinds.CORNERS[kind]
    for start in range(0, len(rows), _AT_A_TIME):
        check()
        part = rows[start:start + _AT_A_TIME]
        row, point = neighbours.of(part[:, 0])
        outside = (part[row] != point[:, None]).all(axis=1)
        row, point = row[outside], point[outside]
        shape = nodes[part]
        near = _close_to_corners(shape[:, :corners], _bend(kind, order, shape), row, nodes[point])
        row, point = row[near], point[near]
        # A degenerate element has a corner on a side of its own: that is a fault of another sort.
        other = (elements[start + row] != point[:, None]).all(axis=1)
        row, point = row[other], point[other]
        if len(row) and _inside(kind, order, shape[row], nodes[point]).any():
            return True
    return False


def _bend(kind, order, shape):
    """By row a bound of its distance from what its corners span, for orders up to 5."""
    corners = kinds.CORNERS[kind]
    if shape.shape[1] == corners:
        return np.zeros(len(shape)) if corners < 4 else np.abs(shape[:, 0] - shape[:, 1] + shape[:, 2] - shape[:, 3]).max(axis=1)
    flat = np.einsum("nc,rcd->rnd", lagrange.at_places(kind, corners, kinds.places(kind, shape.shape[1])), shape[:, :corners])
    return 8.0 * np.abs(shape - flat).sum(axis=2).max(axis=1)  # more than the Lebesgue constant of a triangle of order 5


def _close_to_corners(corners, bend, row, points):
    """Whether points are no farther from the line or plane of the corners than the edge or face can be."""
    a, along = corners[:, 0], corners[:, 1] - corners[:, 0]
    length = np.linalg.norm(along, axis=1)
    low, high = corners.min(axis=1), corners.max(axis=1)
    size = (high - low).max(axis=1)
    slack = bend + _NEAR * size
    near = ((points > (low - slack[:, None])[row]) & (points < (high + slack[:, None])[row])).all(axis=1)
    to = points - a[row]
    with np.errstate(invalid="ignore", divide="ignore"):
        if corners.shape[1] == 2:
            direction = along / length[:, None]
            off = np.linalg.norm(to - (to * direction[row]).sum(axis=1)[:, None] * direction[row], axis=1)
        else:
            normal = np.cross(along, corners[:, -1] - a)
            normal /= np.linalg.norm(normal, axis=1)[:, None]
            off = np.abs((to * normal[row]).sum(axis=1))
    return near & (off <= slack[row])


def _inside(kind, order, shape, points):
    """Whether each point is on its part, at none of its corners."""
    corners, free = kinds.CORNERS[kind], kinds.DIMENSION[kind]
    size = (shape.max(axis=1) - shape.min(axis=1)).max(axis=1)
    at = _start(kind, shape[:, :corners], points)

    def place(at):
        return np.einsum("rn,rnd->rd", lagrange.at_places(kind, shape.shape[1], at), shape)

    for _ in range(_ROUNDS):
        off = place(at) - points
        slopes = []
        for d in range(free):
            step = np.zeros(3)
            step[d] = _STEP
            slopes.append((place(at + step) - place(at - step)) / (2 * _STEP))
        slopes = np.stack(slopes, axis=2)
        square = np.einsum("rdi,rdj->rij", slopes, slopes) + 1e-30 * np.eye(free)
        with np.errstate(all="ignore"):
            move = np.linalg.solve(square, np.einsum("rdi,rd->ri", slopes, off)[:, :, None])[:, :, 0]
        at[:, :free] = np.clip(at[:, :free] - np.nan_to_num(move), 0.0, 1.0)
    on = np.linalg.norm(place(at) - points, axis=1) <= _NEAR * size
    inner = (at[:, :free] > -_NEAR).all(axis=1) & (at[:, :free] < 1 + _NEAR).all(axis=1)
    if kind == "triangle":
        inner &= at[:, 0] + at[:, 1] < 1 + _NEAR
    apart = (np.linalg.norm(shape[:, :corners] - points[:, None], axis=2) > _NEAR * size[:, None]).all(axis=1)
    return on & inner & apart


def _start(kind, corners, points):
    """Places (n, 3) of the parts that are nearest where these are straight."""
    at = np.zeros((len(points), 3))
    u, to = corners[:, 1] - corners[:, 0], points - corners[:, 0]
    if kind == "line":
        at[:, 0] = (to * u).sum(axis=1) / np.maximum((u * u).sum(axis=1), 1e-300)
    else:
        v = corners[:, -1] - corners[:, 0]
        normal = np.cross(u, v)
        square = np.maximum((normal * normal).sum(axis=1), 1e-300)
        at[:, 0] = (np.cross(to, v) * normal).sum(axis=1) / square
        at[:, 1] = (np.cross(u, to) * normal).sum(axis=1) / square
    return np.clip(at, 0.0, 1.0)
