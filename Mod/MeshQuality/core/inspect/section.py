# SPDX-License-Identifier: LGPL-2.1-or-later
"""Planes that cut elements: polygons, segments, and what these enclose."""

from dataclasses import dataclass

import numpy as np

from ...errors import InvalidInput
from ..elements import kinds
from .draft import direction_of

_SPLIT = {"triangle": ((0, 1, 2),), "quadrilateral": ((0, 1, 2), (0, 2, 3))}


@dataclass(frozen=True)
class Plane:
    """point float64 (3,), mm; normal float64 (3,) of length 1: what it points to is cut off."""

    point: np.ndarray
    normal: np.ndarray

    @classmethod
    def of(cls, point, normal):
        """Of a point (x, y, z) and a direction as direction_of takes it. Raises InvalidInput."""
        direction = direction_of(normal, "normal")
        try:
            place = np.array([float(x) for x in point])
        except (TypeError, ValueError):
            place = np.zeros(0)
        if place.shape != (3,) or not np.isfinite(place).all():
            raise InvalidInput(f"point = {point!r} is not allowed: give three numbers such as (0, 0, 12.5)")
        return cls(place, direction / np.linalg.norm(direction))

    def heights(self, points):
        """Distances of points (..., 3) from the plane, mm; above 0 on the side that is cut off."""
        return (np.asarray(points, dtype=np.float64) - self.point) @ self.normal

    def axes(self):
        """float64 (2, 3): two directions in the plane, counter-clockwise seen from the side that is cut off."""
        first = np.cross(self.normal, np.eye(3)[np.abs(self.normal).argmin()])
        first /= np.linalg.norm(first)
        return np.stack([first, np.cross(self.normal, first)])


@dataclass(frozen=True)
class Cut:
    """Where a plane cuts elements.

    element  int (P,), the elements
    points   float64 (P, k, 3): rings of volume elements, segments of surfaces with what is inside on the left; the last point of
             a ring is repeated where it has fewer
    counts   int (P,), how many are there
    """

    element: np.ndarray
    points: np.ndarray
    counts: np.ndarray

    @property
    def areas(self):
        """float64 (P,), mm^2, of rings."""
        own = self.points - self.points[:, :1]
        return 0.5 * np.linalg.norm(np.cross(own[:, 1:-1], own[:, 2:]).sum(axis=1), axis=1)

    def fans(self):
        """(float64 (T, 3, 3), int (T,)): triangles that fill the rings, and the ring of each."""
        ring, k = np.nonzero(np.arange(2, self.points.shape[1]) < self.counts[:, None])
        points = self.points
        return np.stack([points[ring, 0], points[ring, k + 1], points[ring, k + 2]], axis=1), ring


def cut_volumes(nodes, blocks, plane):
    """The Cut of volume elements by their corners; blocks [(kind, int (E, corners)), ...]."""
    parts, first = [], 0
    heights, axes = plane.heights(nodes), plane.axes()
    most = max(len(kinds.EDGES[kind]) for kind, _ in blocks)
    for kind, corners in blocks:
        front = heights[corners] >= 0.0
        chosen = np.flatnonzero(front.any(axis=1) & ~front.all(axis=1))
        ends = corners[chosen][:, np.array(kinds.EDGES[kind])]
        points, crossed = _crossings(nodes, heights, ends)
        counts = crossed.sum(axis=1)
        centre = np.einsum("pk,pki->pi", crossed, points) / counts[:, None]
        flat = (points - centre[:, None]) @ axes.T
        order = np.argsort(np.where(crossed, np.arctan2(flat[..., 1], flat[..., 0]), np.inf), axis=1, kind="stable")
        order = np.take_along_axis(order, np.minimum(np.arange(most), counts[:, None] - 1), axis=1)
        parts.append((first + chosen, np.take_along_axis(points, order[..., None], axis=1), counts))
        first += len(corners)
    return Cut(*(np.concatenate(arrays) for arrays in zip(*parts)))


def cut_triangles(nodes, triangles, plane):
    """The Cut of triangles: segments. Triangles in the plane have none."""
    heights = plane.heights(nodes)
    front = heights[triangles] >= 0.0
    chosen = np.flatnonzero(front.any(axis=1) & ~front.all(axis=1))
    ends, front = triangles[chosen][:, [[0, 1], [1, 2], [2, 0]]], front[chosen]
    points, crossed = _crossings(nodes, heights, ends)
    # A segment begins at the side that leaves the half that is cut off, as triangles look outward.
    begins, rows = crossed & front, np.arange(len(chosen))
    segments = np.stack([points[rows, begins.argmax(axis=1)], points[rows, (crossed & ~begins).argmax(axis=1)]], axis=1)
    return Cut(chosen, segments, np.full(len(chosen), 2))


def _crossings(nodes, heights, ends):
    """(float64 (E, k, 3), bool (E, k)) of sides (E, k, 2): where they cross the plane, bit for bit the same for all elements that
    share them, and whether they do.
    """
    a, b = ends[..., 0], ends[..., 1]
    crossed = (heights[a] >= 0.0) != (heights[b] >= 0.0)
    a, b = np.where(heights[a] >= 0.0, a, b), np.where(heights[a] >= 0.0, b, a)
    part = heights[a] / np.where(crossed, heights[a] - heights[b], 1.0)
    return np.where(crossed[..., None], nodes[a] + part[..., None] * (nodes[b] - nodes[a]), 0.0), crossed


def enclosed_area(segments, plane):
    """mm^2: what closed lines of segments (S, 2, 3) enclose, each time that they go around it."""
    flat = (segments - plane.point) @ plane.axes().T
    return 0.5 * float((flat[:, 0, 0] * flat[:, 1, 1] - flat[:, 0, 1] * flat[:, 1, 0]).sum())


def lines_of(segments):
    """tuple of float64 (n, 3): segments (S, 2, 3), joined where one ends in the point where another begins."""
    segments = segments[(segments[:, 0] != segments[:, 1]).any(axis=1)]
    if not len(segments):
        return ()
    points, number = np.unique(segments.reshape(-1, 3), axis=0, return_inverse=True)
    pairs, after = number.reshape(-1, 2).tolist(), {}
    for i, (start, _) in enumerate(pairs):
        after.setdefault(start, []).append(i)
    ends = {end for _, end in pairs}
    left, lines = set(range(len(pairs))), []
    for first in sorted(left, key=lambda i: pairs[i][0] in ends):  # open lines from their beginning
        line = [pairs[first][0]] if first in left else []
        step = first if first in left else None
        while step is not None:
            left.discard(step)
            line.append(pairs[step][1])
            step = next((i for i in after.get(line[-1], ()) if i in left), None) if line[-1] != line[0] else None
        if line:
            lines.append(points[line])
    return tuple(lines)


def is_closed(line):
    """Whether the first point of a line, float64 (n, 3), is also its last one."""
    return np.array_equal(line[0], line[-1])


def filled(segments, plane):
    """float64 (T, 3, 3): triangles that fill what closed lines of segments (S, 2, 3) go around, trapezoid by trapezoid between the
    heights of their ends.
    """
    closed = [line for line in lines_of(segments) if is_closed(line)]
    segments = np.concatenate([np.zeros((0, 2, 3)), *(np.stack([line[:-1], line[1:]], axis=1) for line in closed)])
    axes = plane.axes()
    flat = (segments - plane.point) @ axes.T
    levels, level = np.unique(flat[..., 1], return_inverse=True)
    low, high = np.sort(level.reshape(-1, 2), axis=1).T
    row = np.repeat(np.arange(len(flat)), high - low)
    slab = np.arange(len(row)) - np.repeat(np.cumsum(high - low) - (high - low), high - low) + low[row]

    def at(height, rows):
        (x0, y0), (x1, y1) = flat[rows, 0].T, flat[rows, 1].T
        return x0 + (height - y0) / (y1 - y0) * (x1 - x0)

    order = np.lexsort((at(0.5 * (levels[slab] + levels[slab + 1]), row), slab))
    row, slab = row[order], slab[order]
    enters = np.where(flat[row, 1, 1] < flat[row, 0, 1], 1, -1)
    inside = np.cumsum(enters)
    starts = np.flatnonzero(np.r_[True, slab[1:] != slab[:-1]]) if len(slab) else np.zeros(0, dtype=int)
    lengths = np.diff(np.r_[starts, len(slab)])
    inside = inside - np.repeat(inside[starts] - enters[starts], lengths)
    left = np.flatnonzero((inside[:-1] != 0) & (slab[1:] == slab[:-1]))
    below, above = levels[slab[left]], levels[slab[left] + 1]
    quads = [(at(height, row[side]), height) for side, height in ((left, below), (left + 1, below), (left + 1, above), (left, above))]
    points = plane.point + np.stack([np.stack(pair, axis=1) for pair in quads], axis=1) @ axes
    return np.concatenate([points[:, [0, 1, 2]], points[:, [0, 2, 3]]])


def corners_of(mesh):
    """[(kind, int (E, corners)), ...] of the elements of the highest dimension of an ElementMesh, as mq.measures counts them."""
    return [(block.kind, block.nodes[:, :kinds.CORNERS[block.kind]]) for block in mesh.blocks
            if kinds.DIMENSION[block.kind] == mesh.dimension]


def triangles_of(blocks):
    """(int (T, 3), int (T,)): triangles and quadrilaterals as triangles, and the element of each."""
    triangles, owners, first = [], [], 0
    for kind, corners in blocks:
        split = corners[:, np.array(_SPLIT[kind])]
        triangles.append(split.reshape(-1, 3))
        owners.append(np.repeat(first + np.arange(len(corners)), split.shape[1]))
        first += len(corners)
    return np.concatenate(triangles), np.concatenate(owners)
