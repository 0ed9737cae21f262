# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles that are changed, with what is measured on each of them."""

from collections import namedtuple

import numpy as np

SCORE = 1.0  # triangles with a lower one have too large an angle or too low a quality
_STEEP = 1e-3  # squared cosine below which a slope counts as vertical

# By triangle: the least cosine between its normal and those of the CAD face at its corners, the cosine of its largest angle, its
# distance from the CAD face in mm by the normals at its corners, the lengths of its sides in the metric, and its quality there, 1 at most.
Measures = namedtuple("Measures", "alignment cosine distance lengths quality")


class Triangles:
    """Triangles of CAD faces.

    points        float64 (V, 3), mm
    entity        int (V, 2): dimension and index of what each vertex lies on
    pairs         the CadPairs of the faces with the vertices of triangles on them
    metric        float64 (P, 6), by pair
    corners       int64 (T, 3): pairs
    segments      int64 (S, 3): two vertices that follow each other on an edge of the shape, and this edge
    tangents      float64 (S, 2, 3): its unit tangents there
    held          bool (V,): vertices that stay where they are; triangles of three of them stay, too
    measures      the Measures of the triangles
    """

    def __init__(self, points, entity, pairs, metric, corners, segments, tangents, held):
        self.points, self.entity, self.pairs, self.metric, self.corners = points, entity, pairs, metric, corners
        self.segments, self.tangents, self.held = segments, tangents, held
        self._keys = pairs.face * len(points) + pairs.vertex
        self.measures = self.measured(corners)

    @property
    def vertices(self):
        """int64 (T, 3): the vertices of the triangles."""
        return self.pairs.vertex[self.corners]

    @property
    def face(self):
        """int64 (T,): the CAD faces of the triangles."""
        return self.pairs.face[self.corners[:, 0]]

    def pair(self, face, vertex):
        """The pairs of faces with vertices; -1: there is none."""
        keys = face * len(self.points) + vertex
        found = np.minimum(np.searchsorted(self._keys, keys), len(self._keys) - 1)
        return np.where(self._keys[found] == keys, found, -1)

    def put(self, rows, corners, measures):
        """Replaces triangles."""
        self.corners[rows] = corners
        for mine, new in zip(self.measures, measures):
            mine[rows] = new

    def keep(self, which):
        """Leaves the triangles out that are not among these."""
        self.corners = self.corners[which]
        self.measures = Measures(*(values[which] for values in self.measures))

    def measured(self, corners, moved=None):
        """The Measures of triangles of pairs (n, 3); moved: (corner of each that lies elsewhere, points, normals, metrics there)."""
        points = self.points[self.pairs.vertex[corners]]
        normals, metric = self.pairs.normals[corners], self.metric[corners]
        if moved is not None:
            rows, (corner, at, normal, own) = np.arange(len(corners)), moved
            points[rows, corner], normals[rows, corner], metric[rows, corner] = at, normal, own
        return measures(points, normals, metric)

    def segment_keys(self):
        """Keys of the segments, ascending."""
        return np.sort(edge_keys(self.segments[:, 0], self.segments[:, 1], len(self.points)))


def score(found):
    """How good triangles of these Measures are: 1 where the quality is 0.3 or the largest angle 150 degrees, 3 or more where both are good."""
    return np.minimum(found.quality / 0.3, (180.0 - np.degrees(np.arccos(np.clip(found.cosine, -1.0, 1.0)))) / 30.0)


def measures(points, normals, metric):
    """The Measures of triangles: points (n, 3, 3), normals (n, 3, 3) and metrics (n, 3, 6) at their corners."""
    points, normals, metric = (np.ascontiguousarray(np.moveaxis(a, 0, -1)) for a in (points, normals, metric))
    sides = [points[(i + 1) % 3] - points[i] for i in range(3)]
    lengths = [np.sqrt(np.maximum(_dot(side, side), 1e-300)) for side in sides]
    across = _cross(sides[0], sides[1])
    across /= np.sqrt(np.maximum(_dot(across, across), 1e-300))
    alignment = np.minimum.reduce([_dot(across, normals[i]) for i in range(3)])
    cosine = np.minimum.reduce([-_dot(sides[i], sides[i - 1]) / (lengths[i] * lengths[i - 1]) for i in range(3)])
    in_metric = [np.sqrt(np.maximum(_form((metric[i] + metric[(i + 1) % 3]) / 2.0, sides[i], sides[i]), 0.0)) for i in range(3)]
    return Measures(alignment, cosine, _distance(sides, lengths, normals), np.stack(in_metric, axis=1), _quality(sides, metric.sum(axis=0)))


def _distance(sides, lengths, normals):
    """Of cubic curves that have the ends and the slopes of the CAD face there, and of the middle of the quadratic surface through them."""
    largest, sum_of_middles = 0.0, 0.0
    for i, (side, length) in enumerate(zip(sides, lengths)):
        rise, fall = (-_dot(normals[k], side) / length for k in (i, (i + 1) % 3))
        rise, fall = (slope / np.sqrt(np.maximum(1.0 - slope * slope, _STEEP)) for slope in (rise, fall))
        middle = length * (rise - fall) / 8.0
        first, last = length * (4.0 * rise - 2.0 * fall) / 27.0, length * (2.0 * rise - 4.0 * fall) / 27.0
        largest = np.maximum.reduce([largest + 0.0 * middle, np.abs(middle), np.abs(first), np.abs(last)])
        sum_of_middles = sum_of_middles + middle
    return np.maximum(largest, np.abs(sum_of_middles) * 4.0 / 9.0)


def _quality(sides, metric):
    one, other, last = (_form(metric, side, side) for side in sides)
    mixed = _form(metric, sides[0], sides[1])
    return 2.0 * np.sqrt(3.0) * np.sqrt(np.maximum(one * other - mixed * mixed, 0.0)) / np.maximum(one + other + last, 1e-300)


def _dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a, b):
    return np.stack([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def _form(m, a, b):
    return (m[0] * a[0] * b[0] + m[1] * a[1] * b[1] + m[2] * a[2] * b[2] + m[3] * (a[0] * b[1] + a[1] * b[0])
            + m[4] * (a[1] * b[2] + a[2] * b[1]) + m[5] * (a[2] * b[0] + a[0] * b[2]))


def edge_keys(a, b, count):
    """A number for each pair of vertices, either way round."""
    return np.minimum(a, b) * count + np.maximum(a, b)


def among(keys, table):
    """Whether each key is in an ascending table."""
    if not len(table):
        return np.zeros(len(keys), dtype=bool)
    return table[np.minimum(np.searchsorted(table, keys), len(table) - 1)] == keys


def least_of(which, values, count):
    """The least value of each group; which: int (n,), ascending. Infinity: the group is empty."""
    found = np.full(count, np.inf)
    if len(which):
        first = np.flatnonzero(np.concatenate([[True], which[1:] != which[:-1]]))
        found[which[first]] = np.minimum.reduceat(values, first)
    return found


class Edges:
    """The edges of triangles (T, 3) of vertices and the triangles at each vertex.

    keys    int64 (E,), ascending
    a, b    int64 (E,): the vertices, a < b
    count   int64 (E,): triangles at each
    of_side int64 (3 T,): the edge of each side; side i of a triangle goes from corner i to the next
    side_rows  the sides in the order of their edges
    """

    def __init__(self, vertices, count):
        self._of = count
        self.keys, self.of_side, self.count = np.unique(
            edge_keys(vertices.ravel(), np.roll(vertices, -1, axis=1).ravel(), count), return_inverse=True, return_counts=True)
        self.of_side = self.of_side.reshape(-1)
        self.side_rows = np.argsort(self.of_side, kind="stable")
        self.a, self.b = self.keys // count, self.keys % count
        self.corner_rows, self._corner_starts = _grouped(vertices.ravel(), count)
        self.ends, self.others = np.concatenate([self.a, self.b]), np.concatenate([self.b, self.a])
        self._end_rows, self._end_starts = _grouped(self.ends, count)
        self._alone = np.diff(self._end_starts) == 0

    def corners_of(self, vertices):
        """(which of the vertices, corner): 3 times the triangle plus the number of the corner, of all that have them."""
        which, places = _expanded(self._corner_starts, vertices)
        return which, self.corner_rows[places]

    def neighbours_of(self, vertices):
        """(which of the vertices, neighbour, edge)."""
        which, places = _expanded(self._end_starts, vertices)
        rows = self._end_rows[places]
        return which, self.others[rows], rows % len(self.keys)

    def has(self, a, b):
        """Whether pairs of vertices are edges."""
        return among(edge_keys(a, b, self._of), self.keys)

    def lengths(self, of_sides):
        """The largest of what the sides (T, 3) have, by edge."""
        return np.maximum.reduceat(of_sides.ravel()[self.side_rows], np.concatenate([[0], np.cumsum(self.count)[:-1]]))

    def independent(self, vertices, priority, rounds=4):
        """Some of the vertices, no two of which are neighbours, those with the lowest priority first."""
        open_, chosen = np.full(self._of, np.inf), np.zeros(self._of, dtype=bool)
        open_[vertices] = priority
        for _ in range(rounds):
            around = np.append(open_[self.others[self._end_rows]], np.inf)
            least = np.where(self._alone, np.inf, np.minimum.reduceat(around, self._end_starts[:-1]))
            new = (open_ < least) & np.isfinite(open_)
            chosen |= new
            open_[new] = np.inf
            open_[self.ends[new[self.others]]] = np.inf
        return chosen[vertices]


def _grouped(values, count):
    return np.argsort(values, kind="stable"), np.concatenate([[0], np.cumsum(np.bincount(values, minlength=count))])


def _expanded(starts, at):
    counts = starts[at + 1] - starts[at]
    first = np.concatenate([[0], np.cumsum(counts)[:-1]])
    return np.repeat(np.arange(len(at)), counts), np.repeat(starts[at] - first, counts) + np.arange(counts.sum())
