# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distances of points from the curved triangles of a mesh: the verifier's own, without the core's trees and projections.

Points of the triangles, a lattice on each, are sorted into cells; from the nearest ones on Gauss-Newton's method goes to the
nearest point inside of each triangle and on each of its sides. All triangles of about one size have cells of their own, so that
large ones beside small ones cost no more than these.
"""

import numpy as np

from ..elements import lagrange

_PARTS = 6  # parts of a triangle's edge, at least: searches start from points between them
_ROUNDS = 12  # steps of Gauss-Newton's method
_FIRST, _MORE = 1, 16  # triangles that are searched for a point: at first, and where none of these is near enough
_AT_A_TIME = 200_000
_STEP = 1e-5  # step of finite differences, in the parameters
_SIDES = (((0.0, 0.0), (1.0, 0.0)), ((1.0, 0.0), (-1.0, 1.0)), ((0.0, 1.0), (0.0, -1.0)))  # where each side begins, and its direction


def beyond(points, nodes, rows, allowed):
    """float64 (N,): the distance of each point from the mesh if it exceeds `allowed` mm, else the first distance found below
    that; infinite where no triangle is near enough to be searched.
    """
    found = np.full(len(points), np.inf)
    candidates = _candidates(points, nodes, rows, allowed)
    for most in (_FIRST, _MORE):
        open_ = np.flatnonzero(found > allowed)
        number, owner, start = candidates(open_, most)
        for part in np.array_split(np.arange(len(number)), max(1, -(-len(number) // _AT_A_TIME))):
            best = _nearest(points[number[part]], nodes[rows[owner[part]]], start[part], allowed)
            np.minimum.at(found, number[part], best)
    return found


def _lattice(parts):
    return np.array([(i / parts, j / parts, 0.0) for i in range(parts + 1) for j in range(parts + 1 - i)])


def _levels(nodes, rows, parts, allowed):
    """[(cell, owners, places, points)]: for triangles of about one size, the points from which searches start."""
    corners = nodes[rows[:, [0, 1, 2, 0]]]
    size = np.linalg.norm(np.diff(corners, axis=1), axis=2).max(axis=1)
    level = np.floor(np.log2(np.maximum(size, 1e-300))).astype(int)
    at = _lattice(parts)
    weights = lagrange.at_places("triangle", rows.shape[1], at)
    for number in np.unique(level):
        own = np.flatnonzero(level == number)
        places = np.einsum("pn,fnx->fpx", weights, nodes[rows[own]]).reshape(-1, 3)
        yield (2.0 * size[own].max() / parts + allowed, np.repeat(own, len(at)), np.tile(at[:, :2], (len(own), 1)), places)


def _candidates(points, nodes, rows, allowed):
    """A function that gives, of some of the points, (number of the point, triangle, parameters to start at) of the nearest."""
    parts = max(_PARTS, 2 * (int(np.sqrt(2 * rows.shape[1])) - 1))
    levels = []
    for cell, owners, at, places in _levels(nodes, rows, parts, allowed):
        key = _keys(np.floor(places / cell).astype(np.int64))
        order = np.argsort(key, kind="stable")
        levels.append((cell, key[order], owners[order], at[order], places[order]))

    def of(some, most):
        found = []
        for cell, key, owners, at, places in levels:
            for part in np.array_split(some, max(1, -(-len(some) // 2000))):
                found.append(_near(points, part, cell, key, owners, at, places, most))
        return _best(found, most)

    return of


def _keys(cells):
    """One number a cell; two cells may share one, which costs time only."""
    return cells[..., 0] * 73856093 ^ cells[..., 1] * 19349663 ^ cells[..., 2] * 83492791


def _near(points, some, cell, key, owners, at, places, most):
    """(points, triangles, parameters, distances) of the nearest places of each triangle around some points, `most` each."""
    shift = np.array([(x, y, z) for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)])
    keys = _keys(np.floor(points[some] / cell).astype(np.int64)[:, None] + shift)
    first, last = np.searchsorted(key, keys, "left").ravel(), np.searchsorted(key, keys, "right").ravel()
    count = last - first
    number = np.repeat(np.repeat(some, len(shift)), count)
    index = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count) + np.repeat(first, count)
    distance = np.linalg.norm(places[index] - points[number], axis=1)
    return _fewest(number, owners[index], at[index], distance, most)


def _fewest(number, owner, at, distance, most):
    order = np.lexsort((distance, owner, number))
    number, owner, at, distance = number[order], owner[order], at[order], distance[order]
    first = np.ones(len(number), dtype=bool)
    first[1:] = (number[1:] != number[:-1]) | (owner[1:] != owner[:-1])
    number, owner, at, distance = number[first], owner[first], at[first], distance[first]
    order = np.lexsort((distance, number))
    number, owner, at, distance = number[order], owner[order], at[order], distance[order]
    begins = np.searchsorted(number, number, "left")
    kept = np.arange(len(number)) - begins < most
    return number[kept], owner[kept], at[kept], distance[kept]


def _best(found, most):
    number, owner, at, _ = _fewest(*(np.concatenate([part[i] for part in found]) for i in range(4)), most)
    return number, owner, at


def _at(corners, at):
    weights = lagrange.at_places("triangle", corners.shape[1], np.column_stack([at, np.zeros(len(at))]))
    return np.einsum("fn,fnx->fx", weights, corners)


def _nearest(points, corners, start, allowed):
    """float64 (N,): a distance of each point from its triangle that is at most `allowed`, else the smallest that searches
    find, from a place inside and along each side.
    """
    best = np.linalg.norm(_at(corners, start) - points, axis=1)
    _search(points, corners, start, np.broadcast_to(np.eye(2), (len(points), 2, 2)), _in_triangle, best, allowed)
    for begin, along in _SIDES:
        open_ = np.flatnonzero(best > allowed)
        begin, along = np.array(begin), np.array(along)
        s = np.linspace(0.0, 1.0, 2 * _PARTS + 1)
        own = np.stack([np.linalg.norm(_at(corners[open_], np.tile(begin + t * along, (len(open_), 1))) - points[open_], axis=1) for t in s])
        at = begin + s[own.argmin(axis=0)][:, None] * along
        found = best[open_]
        _search(points[open_], corners[open_], at, np.broadcast_to([along, [0.0, 0.0]], (len(open_), 2, 2)),
                lambda at, begin=begin, along=along: begin + np.clip((at - begin) @ along / (along @ along), 0.0, 1.0)[:, None] * along,
                found, allowed)
        best[open_] = found
    return best


def _search(points, corners, at, along, inside, best, allowed):
    """Gauss-Newton's method along one or two directions in the parameters; makes `best` smaller."""
    number = np.flatnonzero(best > allowed)
    at = at[number]
    for _ in range(_ROUNDS):
        own, ways = corners[number], along[number]
        u, v = ((_at(own, at + _STEP * ways[:, k]) - _at(own, at - _STEP * ways[:, k])) / (2 * _STEP) for k in (0, 1))
        off = points[number] - _at(own, at)
        uu, uv, vv, gu, gv = ((a * b).sum(axis=1) for a, b in ((u, u), (u, v), (v, v), (u, off), (v, off)))
        flat = vv == 0.0
        area = np.where(flat, uu, uu * vv - uv * uv)
        area[area <= 0.0] = np.inf
        by_u, by_v = np.where(flat, gu, vv * gu - uv * gv) / area, np.where(flat, 0.0, uu * gv - uv * gu) / area
        at = inside(at + by_u[:, None] * ways[:, 0] + by_v[:, None] * ways[:, 1])
        best[number] = np.minimum(best[number], np.linalg.norm(_at(own, at) - points[number], axis=1))
        left = best[number] > allowed
        number, at = number[left], at[left]


def _in_triangle(at):
    at = np.clip(at, 0.0, 1.0)
    at = np.clip(at - np.maximum(at.sum(axis=1, keepdims=True) - 1.0, 0.0) / 2.0, 0.0, 1.0)
    at[:, 1] = np.minimum(at[:, 1], 1.0 - at[:, 0])
    return at
