# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether curved sides of elements meet elsewhere than in the vertices and edges that they share: an independent check of what
the core proves.

It shares no code with the core. All sides are triangles of one degree: quadrilaterals are two of twice their order, whose control
points follow by interpolation. All pairs whose boxes meet are cut into four by four pieces, level by level and many
pairs at once, until a plane is found by Gilbert's iteration (1966) between two pieces, or between their directions from a
vertex or an edge that they share. For pairs that are said to cross a common point is found.
"""

import functools
import itertools
import math

import numpy as np

from ...errors import Cancelled
from ..elements import kinds, lagrange

APART, CROSSING, UNKNOWN = 1, -1, 0
_LEVELS = 12  # how often a triangle is cut at most
_FEW_PIECES = 200  # pieces of a pair whose sides are said to cross: most pairs of halves of two quadrilaterals do not
_PIECES, _MANY_PIECES, _TRIED = 2000, 40_000, 50  # pieces of a pair; pieces of each of the first pairs left; how many these first pairs are
_ROUNDS = 60  # steps of the search for a plane
_ROUNDING = 1e-12  # share of the largest coordinate
_AT_A_TIME = 40_000  # pairs
_BOXES_AT_A_TIME = 8_000_000
_NUMBERS_AT_A_TIME = 1_000_000  # components of directions along vectors
_NEWTON = 14
_TOUCHING, _TOUCHING_LEVELS = 2e-9, 5
_AWAY = 1e-4  # barycentric coordinate by which a common point is off what is shared


@functools.lru_cache(maxsize=None)
def _exponents(order):
    """int (n, 3): the exponents of the control points, corners first."""
    rows = [(i, j, order - i - j) for i in range(order, -1, -1) for j in range(order - i, -1, -1)]
    return np.array(sorted(rows, key=lambda row: -max(row) if max(row) == order else 0))


def _bernstein(order, at):
    """float64 (len(at), n) at barycentric coordinates."""
    powers = _exponents(order)
    factor = np.array([math.factorial(order) // math.prod(map(math.factorial, row)) for row in powers.tolist()])
    return factor * np.prod(np.asarray(at)[:, None, :] ** powers[None], axis=2)


@functools.lru_cache(maxsize=None)
def _to_control(order):
    return np.linalg.inv(_bernstein(order, _exponents(order) / order))


# Corners of the four pieces, in halves.
_QUARTERS = np.array([[[2, 0, 0], [1, 1, 0], [1, 0, 1]], [[1, 1, 0], [0, 2, 0], [0, 1, 1]],
                      [[1, 0, 1], [0, 1, 1], [0, 0, 2]], [[0, 1, 1], [1, 0, 1], [1, 1, 0]]])


@functools.lru_cache(maxsize=None)
def _cuts(order):
    """float64 (4, n, n): the control points of each quarter by those of the whole."""
    nodes = _exponents(order) / order
    return np.array([_to_control(order) @ _bernstein(order, nodes @ (quarter / 2.0)) for quarter in _QUARTERS])


# The halves of a quadrilateral by the corners of triangles, and where its corners are.
_HALVES, _PLACES = ((0, 1, 2), (0, 2, 3)), {"triangle": ((0, 0), (1, 0), (0, 1)), "quadrilateral": ((0, 0), (1, 0), (1, 1), (0, 1))}


def _parts(kind):
    """Corners of the triangles that a side is divided into."""
    return _HALVES if kind == "quadrilateral" else _HALVES[:1]


class _Surface:
    """The triangles into which sides are divided: control points about the middle of the mesh, and their common corners.

    vertex  int (T, 3), side int (T,): the corners of each triangle, and its side, numbered from one kind to the next
    """

    def __init__(self, nodes, sides):
        self.order = max((order * len(_parts(kind)) for kind, order, _ in sides), default=1)
        at = _exponents(self.order) / self.order
        used = np.unique(np.concatenate([rows.ravel() for *_, rows in sides])) if sides else np.empty(0, dtype=int)
        places, same = np.unique(nodes[used], axis=0, return_inverse=True)
        same = same.reshape(-1)
        middle = (places.min(axis=0) + places.max(axis=0)) / 2 if len(places) else np.zeros(3)
        control, vertex, side, named, first = [], [], [], [], 0
        for kind, _, rows in sides:
            rows = same[np.searchsorted(used, rows)]
            for part in _parts(kind):
                where = np.column_stack([at @ np.array(_PLACES[kind], dtype=float)[list(part)], np.zeros(len(at))])
                weights = _to_control(self.order) @ lagrange.at_places(kind, rows.shape[1], where)
                control.append(np.einsum("ij,fjx->fix", weights, (places - middle)[rows]))
                vertex.append(rows[:, list(part)])
                side.append(first + np.arange(len(rows)))
            named += [tuple(row) for row in np.sort(rows, axis=1).tolist()]
            first += len(rows)
        count, numbers = len(at), {}
        self.control = np.concatenate(control) if control else np.empty((0, count, 3))
        self.vertex = np.concatenate(vertex) if vertex else np.empty((0, 3), dtype=int)
        self.side = np.concatenate(side) if side else np.empty(0, dtype=int)
        self._alike = np.array([numbers.setdefault(name, len(numbers)) for name in named], dtype=int)
        loss = max(1.0, np.abs(_to_control(self.order)).sum(axis=1).max() / 100.0)
        self.margin = _ROUNDING * loss * max(np.abs(places).max(initial=0.0), 1e-300)

    def shared(self, pairs):
        """(partner (P, 3), edges (P, 3)): by corner of the first the equal one of the second or -1, and by corner whether the
        edge opposite to it is an edge of the second.
        """
        a, b = pairs[:, 0], pairs[:, 1]
        equal = self.vertex[a][:, :, None] == self.vertex[b][:, None, :]
        partner = np.where(equal.any(axis=2), equal.argmax(axis=2), -1)
        edges = np.zeros((len(pairs), 3), dtype=bool)
        for k in range(3):
            for m in range(3):
                for one in (((k + 1) % 3, (k + 2) % 3), ((k + 2) % 3, (k + 1) % 3)):
                    other = (m + 1) % 3, (m + 2) % 3
                    chosen = np.flatnonzero(equal[:, one[0], other[0]] & equal[:, one[1], other[1]])
                    along = [self.control[part[chosen]][:, _edge(self.order, *ends)] for part, ends in ((a, one), (b, other))]
                    edges[chosen, k] |= np.abs(along[0] - along[1]).max(axis=(1, 2), initial=0.0) <= self.margin
        return partner, edges

    def on_each_other(self, pairs):
        """bool (P,): whether two triangles are of different sides with the same nodes."""
        sides = self.side[pairs]
        return (sides[:, 0] != sides[:, 1]) & (self._alike[sides[:, 0]] == self._alike[sides[:, 1]])


def near_pairs(surface):
    """int (P, 2): the pairs whose boxes meet and that do not lie on each other, (i, i) of each triangle among them."""
    low, high = surface.control.min(axis=1) - surface.margin, surface.control.max(axis=1) + surface.margin
    count = len(low)
    axis = int(np.argmax((high.max(axis=0) - low.min(axis=0)) / np.maximum((high - low).mean(axis=0), 1e-300)))
    order = np.argsort(low[:, axis], kind="stable")
    low, high = low[order], high[order]
    end = np.searchsorted(low[:, axis], high[:, axis], side="right")
    length = end - np.arange(count) - 1
    found, start, sums = [np.stack([np.arange(count)] * 2, axis=1)], 0, np.cumsum(length)
    while start < count:
        stop = max(start + 1, int(np.searchsorted(sums, (sums[start - 1] if start else 0) + _BOXES_AT_A_TIME)))
        part = length[start:stop]
        first = np.repeat(np.arange(start, min(stop, count)), part)
        second = first + 1 + np.arange(len(first)) - np.repeat(np.cumsum(part) - part, part)
        meet = ((low[first] <= high[second]) & (low[second] <= high[first])).all(axis=1)
        pairs = np.sort(order[np.stack([first[meet], second[meet]], axis=1)], axis=1)
        found.append(pairs[~surface.on_each_other(pairs)])
        start = stop
    return np.concatenate(found)


def _rounder(vectors):
    """(P, 3, 3): linear maps after which the vectors are about as long in all directions; planes stay planes."""
    square = np.einsum("pnx,pny->pxy", vectors, vectors)
    values, axes = np.linalg.eigh(square)
    values = np.maximum(values, 1e-12 * np.maximum(values[:, 2:], 1e-300))
    return axes / np.sqrt(values)[:, None, :]


def _in_half_space(vectors, margin):
    """bool (P,): whether a direction was found along which each of (P, n, 3) vectors has more than the margin."""
    length = np.linalg.norm(vectors, axis=2)
    found = np.zeros(len(vectors), dtype=bool)
    active = np.flatnonzero((length > margin).all(axis=1))
    units, least = vectors[active] / length[active][:, :, None], margin / length[active]
    turn = _rounder(units)
    round_ = units @ turn
    round_ /= np.linalg.norm(round_, axis=2, keepdims=True)
    direction = round_.mean(axis=1)
    for _ in range(_ROUNDS):
        flat = np.einsum("pxy,py->px", turn, direction)
        along = np.einsum("pnx,px->pn", units, flat)
        done = (along > least * np.linalg.norm(flat, axis=1)[:, None]).all(axis=1)
        found[active[done]] = True
        left = ~done
        active, units, least, direction, turn, round_ = (
            array[left] for array in (active, units, least, direction, turn, round_))
        if not len(active):
            break
        lowest = np.einsum("pnx,px->pn", round_, direction).argmin(axis=1)
        direction = _nearer(direction, round_[np.arange(len(active)), lowest])
    at_a_time = max(1, _NUMBERS_AT_A_TIME // units.shape[1] ** 3)
    for start in range(0, len(active), at_a_time):
        some = slice(start, start + at_a_time)
        found[active[some]] = _among_extreme(units[some], least[some])
    return found


def _among_extreme(units, least):
    """bool (P,): whether the sum of the extreme directions of the cone that is looked for is in it: these are at right angles to
    two of the vectors, or, where these are in a plane, in that plane to one of them.
    """
    first, second = np.triu_indices(units.shape[1], 1)
    normals = np.cross(units[:, first], units[:, second])
    longest = normals[np.arange(len(units)), np.einsum("pnx,pnx->pn", normals, normals).argmax(axis=1)]
    directions = np.concatenate([normals, np.cross(longest[:, None], units)], axis=1)
    length = np.linalg.norm(directions, axis=2)
    some = length > 1e-9
    directions /= np.where(some, length, 1.0)[:, :, None]
    along = directions @ units.transpose(0, 2, 1)
    sign = (some & (along >= -1e-12).all(axis=2)).astype(float) - (some & (along <= 1e-12).all(axis=2))
    total = np.einsum("pd,pdx->px", sign, directions)
    inside = np.einsum("pnx,px->pn", units, total) > least * np.linalg.norm(total, axis=1)[:, None]
    return inside.all(axis=1) & total.any(axis=1)


def _hulls_apart(a, b, margin):
    """bool (P,): whether a plane was found between the hulls of (P, n, 3) points each."""
    found, active = np.zeros(len(a), dtype=bool), np.arange(len(a))
    middles = [part.mean(axis=1, keepdims=True) for part in (a, b)]
    turn = _rounder(np.concatenate([a - middles[0], b - middles[1], middles[0] - middles[1]], axis=1))
    round_a, round_b = a @ turn, b @ turn
    direction = round_a.mean(axis=1) - round_b.mean(axis=1)
    for _ in range(_ROUNDS):
        index = np.arange(len(active))
        lowest = np.einsum("pnx,px->pn", round_a, direction).argmin(axis=1)
        highest = np.einsum("pnx,px->pn", round_b, direction).argmax(axis=1)
        flat = np.einsum("pxy,py->px", turn, direction)
        done = ((a[index, lowest] - b[index, highest]) * flat).sum(axis=1) > margin * np.linalg.norm(flat, axis=1)
        between = round_a[index, lowest] - round_b[index, highest]
        found[active[done]] = True
        left = ~done
        active, a, b, round_a, round_b, turn, direction, between = (
            array[left] for array in (active, a, b, round_a, round_b, turn, direction, between))
        if not len(active):
            break
        direction = _nearer(direction, between)
    return found


def _nearer(point, other):
    """The points between two that are nearest to the origin."""
    step = other - point
    share = -(point * step).sum(axis=1) / np.maximum((step * step).sum(axis=1), 1e-300)
    return point + np.clip(share, 0.0, 1.0)[:, None] * step


@functools.lru_cache(maxsize=None)
def _differences(order):
    """By corner (from, to): pairs of control points along which a triangle runs from the opposite edge to the corner."""
    index = {tuple(row): i for i, row in enumerate(_exponents(order).tolist())}
    found = []
    for corner in range(3):
        rows = []
        for lower in itertools.product(range(order), repeat=3):
            if sum(lower) == order - 1:
                up = [index[tuple(e + (k == d) for k, e in enumerate(lower))] for d in range(3)]
                rows += [(up[(corner + d) % 3], up[corner]) for d in (1, 2)]
        found.append(np.array(rows).T)
    return found


@functools.lru_cache(maxsize=None)
def _edge(order, first, second):
    """int (order + 1,): the control points of the edge from one corner to another."""
    index = {tuple(row): i for i, row in enumerate(_exponents(order).tolist())}
    chain = []
    for i in range(order + 1):
        row = [0, 0, 0]
        row[first], row[second] = order - i, i
        chain.append(index[tuple(row)])
    return np.array(chain)


def _settled(order, a, b, equal, on_edge, margin):
    """bool (P,): which pairs of pieces meet nowhere else; equal (P, 3, 3) which corners are one, on_edge (P,) whether two such
    corners are the ends of an edge of both.
    """
    found = np.zeros(len(a), dtype=bool)
    count = equal.sum(axis=(1, 2))
    corners = [int(np.flatnonzero(_exponents(order)[:, k] == order)[0]) for k in range(3)]
    chosen = np.flatnonzero(count == 0)
    found[chosen] = _hulls_apart(a[chosen], b[chosen], margin)
    for k, m in itertools.product(range(3), repeat=2):
        chosen = np.flatnonzero((count == 1) & equal[:, k, m])
        if len(chosen):
            ray = [np.delete(part[chosen] - part[chosen][:, corners[c]][:, None], corners[c], axis=1)
                   for part, c in ((a, k), (b, m))]
            found[chosen] = _in_half_space(np.concatenate([ray[0], -ray[1]], axis=1), margin)
        for l, n in itertools.product(range(k + 1, 3), range(3)):  # noqa: E741
            chosen = np.flatnonzero((count == 2) & on_edge & equal[:, k, m] & equal[:, l, n]) if n != m else ()
            if len(chosen):
                found[chosen] = _apart_beyond_edge(order, a[chosen], b[chosen], (k, l), (m, n), margin)
    return found


def _apart_beyond_edge(order, a, b, edge_a, edge_b, margin):
    out = _differences(order)[3 - sum(edge_a)]
    back = _differences(order)[3 - sum(edge_b)]
    across = [a[:, out[1]] - a[:, out[0]], b[:, back[0]] - b[:, back[1]]]
    along = np.diff(a[:, _edge(order, *edge_a)], axis=1)
    found = np.ones(len(a), dtype=bool)
    for sign in (1.0, -1.0):
        found[found] = _in_half_space(np.concatenate([*across, sign * along], axis=1)[found], margin)
    return found


def _monotone(order, control, margin):
    """bool (P,): whether each triangle is proven to have no point twice."""
    found = np.ones(len(control), dtype=bool)
    for low, high in _differences(order):
        found[found] = _in_half_space(control[found][:, high] - control[found][:, low], margin)
    return found


def examine(nodes, sides, listed=(), left_out=(), progress=None):
    """(pairs (P, 2), verdict (P,)) of the pairs that are not proven apart, and of those that are listed: APART, CROSSING or
    UNKNOWN. Other pairs are not examined. sides: [(kind, order, rows)]; progress as for verify.
    """
    surface = _Surface(nodes, sides)
    count = int(surface.side.max(initial=-1)) + 1
    pairs = near_pairs(surface)
    pairs = pairs[~_among(_of_sides(surface, pairs), left_out, count)]
    crossing = _among(_of_sides(surface, pairs), listed, count)
    left = [pairs[crossing]]
    pairs = pairs[~crossing]
    for start in range(0, len(pairs), _AT_A_TIME):
        if progress is not None and progress(start / len(pairs), "crossings") is False:
            raise Cancelled("the verification was cancelled")
        some = pairs[start:start + _AT_A_TIME]
        left.append(some[~_apart(surface, some, _PIECES)])
    left = np.concatenate(left)
    said = _among(_of_sides(surface, left), listed, count)
    verdict = np.full(len(left), UNKNOWN)
    verdict[said] = np.where(_apart(surface, left[said], _FEW_PIECES), APART, UNKNOWN)
    shown = set()  # pairs of sides: one pair of their triangles that cross is enough
    for i, pair in enumerate(map(tuple, _of_sides(surface, left).tolist())):
        if verdict[i] == UNKNOWN and pair not in shown and _meet(surface, *left[i].tolist()):
            verdict[i] = CROSSING
            shown.add(pair)
    for chosen, most in ((said, _PIECES), (~said, _MANY_PIECES)):
        tried = np.flatnonzero((verdict == UNKNOWN) & chosen & ~_among(_of_sides(surface, left), sorted(shown), count))[:_TRIED]
        verdict[tried[_apart(surface, left[tried], most)]] = APART
    found = {}
    for pair, what in zip(map(tuple, _of_sides(surface, left).tolist()), verdict.tolist()):
        found[pair] = min(found.get(pair, APART), what, key=(CROSSING, UNKNOWN, APART).index)
    listed = set(map(tuple, listed))
    found = {**dict.fromkeys(sorted(listed), APART), **found}
    kept = [pair for pair, what in found.items() if what != APART or pair in listed]
    return np.array(kept, dtype=int).reshape(-1, 2), np.array([found[pair] for pair in kept], dtype=int)


def _of_sides(surface, pairs):
    """int (P, 2): the sides of pairs of triangles, the lower one first."""
    return np.sort(surface.side[pairs], axis=1).reshape(-1, 2)


def _among(pairs, others, count):
    """bool (P,): which of the pairs are among others."""
    if not len(others):
        return np.zeros(len(pairs), dtype=bool)
    key = np.array([count + 1, 1])
    return np.isin(pairs @ key, np.asarray(others) @ key)


def _apart(surface, pairs, most):
    """bool (P,): which pairs are proven to meet in shared vertices and edges only."""
    found = np.zeros(len(pairs), dtype=bool)
    own = pairs[:, 0] == pairs[:, 1]
    found[own] = _monotone(surface.order, surface.control[pairs[own, 0]], surface.margin)
    for i in np.flatnonzero(own & ~found):
        found[i] = _apart_from_itself(surface, surface.control[pairs[i, 0]], 4)
    others = np.flatnonzero(~own)
    found[others] = _search(surface, surface.control[pairs[others, 0]], surface.control[pairs[others, 1]],
                            *surface.shared(pairs[others]), most)
    return found


def _apart_from_itself(surface, control, depth):
    if _monotone(surface.order, control[None], surface.margin)[0]:
        return True
    if depth == 0:
        return False
    parts = np.einsum("qij,jx->qix", _cuts(surface.order), control)
    first, second = np.array(list(itertools.combinations(range(4), 2))).T
    equal = (_QUARTERS[first][:, :, None] == _QUARTERS[second][:, None, :]).all(axis=3)
    partner = np.where(equal.any(axis=2), equal.argmax(axis=2), -1)
    edges = np.stack([(np.delete(partner, k, axis=1) >= 0).all(axis=1) for k in range(3)], axis=1)
    return bool(_search(surface, parts[first], parts[second], partner, edges, _PIECES).all()) \
        and all(_apart_from_itself(surface, part, depth - 1) for part in parts)


def _search(surface, a, b, partner, edges, most):
    """bool (P,): whether pairs are apart, shown on pieces; all pairs are cut together, so that pieces along a
    common edge have equal corners.
    """
    count, order = len(a), surface.order
    open_, owner = np.ones(count, dtype=bool), np.arange(count)
    whole = np.broadcast_to(np.eye(3, dtype=int), (count, 3, 3))
    at_a, at_b = whole, whole
    for level in range(_LEVELS):
        equal, on_edge = _equal_corners(at_a, at_b, partner[owner], edges[owner])
        left = ~_settled(order, a, b, equal, on_edge, surface.margin)
        counts = np.bincount(owner[left], minlength=count)
        open_ &= 16 * counts <= most
        if level == _LEVELS - 1:
            return open_ & (counts == 0)
        left &= open_[owner]
        a, b, at_a, at_b, owner = (array[left] for array in (a, b, at_a, at_b, owner))
        if not len(owner):
            return open_
        cut = [np.einsum("qij,pjx->pqix", _cuts(order), part) for part in (a, b)]
        at = [np.einsum("qcd,pdx->pqcx", _QUARTERS, part) for part in (at_a, at_b)]
        shape = a.shape[1:]
        a, at_a = np.repeat(cut[0], 4, axis=1).reshape(-1, *shape), np.repeat(at[0], 4, axis=1).reshape(-1, 3, 3)
        b, at_b = np.tile(cut[1], (1, 4, 1, 1)).reshape(-1, *shape), np.tile(at[1], (1, 4, 1, 1)).reshape(-1, 3, 3)
        owner = np.repeat(owner, 16)
    return open_


def _equal_corners(at_a, at_b, partner, edges):
    """(equal (P, 3, 3), on_edge (P,)) of pieces whose corners have these places in their triangles."""
    moved = np.zeros_like(at_a)
    for k in range(3):
        for m in range(3):
            moved[:, :, m] += np.where(partner[:, k] == m, 1, 0)[:, None] * at_a[:, :, k]
    total = at_a.sum(axis=2)
    nonzero = at_a != 0
    opposite = np.where(nonzero.sum(axis=2) == 2, np.argmin(nonzero, axis=2), -1)
    on_shared = np.where(opposite >= 0, np.take_along_axis(edges, np.maximum(opposite, 0), axis=1),
                         nonzero.sum(axis=2) == 1)
    valid = on_shared & (moved.sum(axis=2) == total)
    equal = valid[:, :, None] & (moved[:, :, None, :] == at_b[:, None, :, :]).all(axis=3)
    # Two equal corners are the ends of a common edge where both lie on one edge of the triangle that is common.
    common = np.zeros(len(at_a), dtype=bool)
    for k in range(3):
        on = (at_a[:, :, k] == 0) & equal.any(axis=2)
        common |= edges[:, k] & (on.sum(axis=1) == 2)
    return equal, common


def _meet(surface, a, b):
    """Whether two triangles have a point in common, away from what they share, where they cross at an angle."""
    if a == b:
        return False
    one, two = surface.control[a], surface.control[b]
    for arcs, disc, pair in ((one, two, (a, b)), (two, one, (b, a))):
        partner, _ = surface.shared(np.array([pair]))
        _, edges = surface.shared(np.array([pair[::-1]]))
        common = [k for k in partner[0].tolist() if k >= 0]
        if _pierces(surface.order, arcs, disc, (common, np.flatnonzero(edges[0])), surface.margin):
            return True
    return False


@functools.lru_cache(maxsize=None)
def _lines(steps=6):
    """(from, to): barycentric ends of the lines of a lattice, in three directions."""
    ends = []
    for k in range(3):
        for i in range(steps):
            first, second = np.zeros(3), np.zeros(3)
            first[k] = second[k] = i / steps
            first[(k + 1) % 3] = second[(k + 2) % 3] = 1 - i / steps
            ends.append((first, second))
    return np.array(ends)


def _slopes(order, control, at):
    """The derivatives along two sides at each place."""
    step = 1e-6
    along = [np.array([-step, step, 0.0]), np.array([-step, 0.0, step])]
    return np.stack([(_bernstein(order, at + d) - _bernstein(order, at - d)) @ control / (2 * step) for d in along], axis=2)


def _pierces(order, arcs, disc, shared, margin):
    """Newton's method from many places: a line of the first triangle and the second one, whose corners and edges (by the corner
    opposite) they share.
    """
    ends = _lines()
    starts = list(itertools.product(range(len(ends)), (0.15, 0.5, 0.85),
                                    ((0.6, 0.2), (0.2, 0.6), (0.2, 0.2), (1 / 3, 1 / 3))))
    line = np.array([start[0] for start in starts])
    t, uv = np.array([start[1] for start in starts]), np.array([start[2] for start in starts])
    size = np.ptp(np.concatenate([arcs, disc]), axis=0).max()
    run = ends[line, 1] - ends[line, 0]
    for _ in range(_NEWTON):
        on_line, on_disc = ends[line, 0] + t[:, None] * run, np.column_stack([1 - uv.sum(axis=1), uv])
        off = _bernstein(order, on_line) @ arcs - _bernstein(order, on_disc) @ disc
        tangent = np.einsum("pxd,pd->px", _slopes(order, arcs, on_line), run[:, 1:])
        across = _slopes(order, disc, on_disc)
        matrix = np.concatenate([tangent[:, :, None], -across], axis=2)
        regular = np.abs(np.linalg.det(matrix)) > 1e-9 * size**3
        if not regular.any():
            return False
        line, t, uv, run, off, matrix = (array[regular] for array in (line, t, uv, run, off, matrix))
        step = np.linalg.solve(matrix, off[:, :, None])[:, :, 0]
        t, uv = np.clip(t - step[:, 0], -0.2, 1.2), np.clip(uv - step[:, 1:], -0.2, 1.2)
    on_line, on_disc = ends[line, 0] + t[:, None] * run, np.column_stack([1 - uv.sum(axis=1), uv])
    point = _bernstein(order, on_line) @ arcs
    near = np.linalg.norm(point - _bernstein(order, on_disc) @ disc, axis=1) <= 100 * margin
    inside = (t >= 0) & (t <= 1) & (on_disc >= 0).all(axis=1)
    corners, edges = shared
    away = (1 - on_disc[:, corners] > _AWAY).all(axis=1) & (on_disc[:, edges] > _AWAY).all(axis=1)
    return bool((near & inside & away).any())


def touch_only(nodes, sides, pairs):
    """[bool]: which pairs of sides of different bodies have a plane with one on each side, but for _TOUCHING of the size; by
    pieces, where one plane does not do.
    """
    if not len(pairs):
        return []
    surface = _Surface(nodes, sides)
    body = _bodies(surface.vertex, surface.side)
    slack = _TOUCHING * float(np.ptp(surface.control.reshape(-1, 3), axis=0).max())
    found = []
    for pair in pairs:
        first, second = (np.flatnonzero(surface.side == number) for number in pair)
        found.append(bool(len(first) and len(second) and body[first[0]] != body[second[0]] and all(
            _on_both_sides(surface.order, surface.control[a], surface.control[b], slack, _TOUCHING_LEVELS)
            for a, b in itertools.product(first, second))))
    return found


def _bodies(corners, side):
    """By triangle the number of its body: edges with just two triangles connect these, and so does a common side."""
    edges = np.sort(np.concatenate([corners[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    owner = np.tile(np.arange(len(corners)), 3)
    _, index, counts = np.unique(edges, axis=0, return_inverse=True, return_counts=True)
    index = index.reshape(-1)
    order = np.argsort(index, kind="stable")
    pairs = owner[order][counts[index[order]] == 2].reshape(-1, 2)
    order = np.argsort(side, kind="stable")
    halves = np.flatnonzero(side[order][1:] == side[order][:-1])
    pairs = np.concatenate([pairs, np.stack([order[halves], order[halves + 1]], axis=1)])
    found = np.arange(len(corners))
    while True:
        before = found.copy()
        lowest = found[pairs].min(axis=1)
        for k in (0, 1):
            np.minimum.at(found, found[pairs[:, k]], lowest)
            np.minimum.at(found, pairs[:, k], lowest)
        found = found[found]
        if (found == before).all():
            return found


def _on_both_sides(order, a, b, slack, levels):
    corners = [part[[0, 1, 2]] for part in (a, b)]
    edges = [part[[1, 2, 0]] - part for part in corners]
    normals = [np.cross(*part[:2]) for part in edges]
    across = np.cross(edges[0][:, None], edges[1][None]).reshape(-1, 3)
    directions = np.concatenate([normals, across, np.cross(normals[0], edges[0]), np.cross(normals[1], edges[1])])
    length = np.linalg.norm(directions, axis=1)
    directions = directions[length > 0] / length[length > 0][:, None]
    along = [directions @ part.T for part in (a, b)]
    low, high = ([values(part, axis=1) for part in along] for values in (np.min, np.max))
    thick = np.maximum(*high) - np.minimum(*low) > 2 * slack
    if (thick & ((low[0] >= high[1] - slack) | (low[1] >= high[0] - slack))).any():
        return True
    if not thick[:2].any() and normals[0] @ normals[1] < 0:  # both lie in one plane and face away from each other
        return True
    if levels == 0:
        return False
    parts = [np.einsum("qij,jx->qix", _cuts(order), part) for part in (a, b)]
    return all(_on_both_sides(order, one, two, slack, levels - 1) for one, two in itertools.product(*parts))
