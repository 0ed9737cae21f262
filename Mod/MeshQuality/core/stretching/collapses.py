# SPDX-License-Identifier: LGPL-2.1-or-later
"""Vertices that go: each is drawn into a neighbour, many that are no neighbours at a time."""

import numpy as np

from .limits import LONGEST
from .triangles import SCORE, Edges, Measures, among, edge_keys, least_of, score

_ROUNDS = 200
_SPREAD = 0.3  # by which the order of edges of like lengths is shuffled, so that rounds find many that are no neighbours


class Collapses:
    """Takes vertices out whose edges are short in the metric, until none can go."""

    def __init__(self, triangles, limits):
        self._triangles, self._limits = triangles, limits
        count = len(triangles.points)
        self._shuffle = 1.0 + _SPREAD * np.random.RandomState(1).rand(count)

    def run(self, shorter, poll, low=False):
        """Of edges shorter than this in the metric; low: at triangles that are low, where the lowest around gets better."""
        self._low, self._longest = low, shorter if low else LONGEST
        self._fails = np.zeros(len(self._triangles.points), dtype=np.int64)
        for _ in range(_ROUNDS):
            poll()
            if not self._round(shorter):
                return

    def _round(self, shorter):
        """Whether there was a candidate."""
        mesh = self._triangles
        edges = self._edges = Edges(mesh.vertices, len(mesh.points))
        gone, target, sides = self._candidates(shorter)
        if not len(gone):
            return False
        which, corner = edges.corners_of(gone)
        triangle, place = corner // 3, corner % 3
        dies = (mesh.vertices[triangle] == target[which][:, None]).any(axis=1)
        good = np.bincount(which, dies, len(gone)) == sides
        group, rows, place = which[~dies], triangle[~dies], place[~dies]
        corners = mesh.corners[rows]
        pairs = mesh.pair(mesh.face[rows], target[group])
        corners[np.arange(len(rows)), place] = np.maximum(pairs, 0)
        good &= self._linked(gone, target, sides) & (np.bincount(group, minlength=len(gone)) > 0) & (np.bincount(group, pairs < 0, len(gone)) == 0)
        good &= self._straight(gone, good)
        # Measured only where nothing else forbids it.
        open_ = good[group]
        group, rows, corners, place = group[open_], rows[open_], corners[open_], place[open_]
        new = mesh.measured(corners)
        of_each = np.arange(len(rows))
        longest = np.maximum(new.lengths[of_each, place], new.lengths[of_each, (place + 2) % 3])
        before = self._before(which, triangle, len(gone), group)
        broken = self._limits.broken(new, before) | (longest > self._longest)
        if self._low:
            broken |= score(new) <= np.minimum(score(before), SCORE)
        good &= np.bincount(group, broken, len(gone)) == 0
        self._fails[gone[~good]] += 1
        chosen = self._chosen(gone, target, good, edges)
        chosen = self._verified(gone, chosen, group, corners)
        applied = chosen[group]
        mesh.put(rows[applied], corners[applied], Measures(*(values[applied] for values in new)))
        self._fails[np.unique(mesh.vertices[rows[applied]])] = 0
        live = np.ones(len(mesh.corners), dtype=bool)
        live[triangle[dies & chosen[which]]] = False
        mesh.keep(live)
        on_edge = chosen & (mesh.entity[gone, 0] == 1)
        self._join_segments(gone[on_edge], target[on_edge])
        return True

    def _candidates(self, shorter):
        """(vertex, neighbour, triangles at the edge): of each vertex the shortest edge that has not failed since something around changed."""
        mesh, edges = self._triangles, self._edges
        on_shape = among(edges.keys, mesh.segment_keys())
        dimension, count = mesh.entity[:, 0], len(mesh.points)
        segments = np.bincount(mesh.segments[:, :2].ravel(), minlength=count)
        free = ((dimension == 2) & (segments == 0)) | ((dimension == 1) & (segments == 2))
        odd = (edges.count > 2) | ((edges.count == 1) & ~on_shape)
        free[edges.a[odd]] = free[edges.b[odd]] = False
        free &= ~mesh.held
        if self._low:
            of_low = np.zeros(count, dtype=bool)
            of_low[mesh.vertices[score(mesh.measures) < SCORE]] = True
            free &= of_low
        lengths = np.tile(edges.lengths(mesh.measures.lengths), 2)
        allowed = np.flatnonzero(free[edges.ends] & (lengths < shorter) & ((dimension[edges.ends] == 2) | np.tile(on_shape, 2)))
        allowed = allowed[np.lexsort((lengths[allowed], edges.ends[allowed]))]
        first = np.searchsorted(edges.ends[allowed], np.arange(count + 1))
        gone = np.flatnonzero(self._fails < np.diff(first))
        chosen = allowed[first[gone] + self._fails[gone]]
        self._lengths = lengths[chosen]
        return gone, edges.others[chosen], edges.count[chosen % len(edges.keys)]

    def _linked(self, gone, target, sides):
        """Whether the two vertices have no neighbour in common but those of the triangles that go."""
        which, other, _ = self._edges.neighbours_of(gone)
        common = (other != target[which]) & self._edges.has(target[which], other)
        return np.bincount(which, common, len(gone)) == sides

    def _straight(self, gone, asked):
        """Whether the segments of vertices on edges of the shape, joined, stay within the distance of it."""
        mesh, found = self._triangles, np.ones(len(gone), dtype=bool)
        rows = np.flatnonzero(asked & (mesh.entity[gone, 0] == 1))
        if len(rows):
            one, other = self._segments_at(gone[rows])
            ends = [mesh.segments[half // 2, 1 - half % 2] for half in (one, other)]
            chord = mesh.points[ends[1]] - mesh.points[ends[0]]
            off = np.maximum(*(np.linalg.norm(np.cross(chord, mesh.tangents[half // 2, 1 - half % 2]), axis=1) for half in (one, other))) / 4.0
            same = mesh.segments[one // 2, 2] == mesh.segments[other // 2, 2]
            found[rows] = (off <= self._limits.distance) & same & (ends[0] != ends[1])
        return found

    def _segments_at(self, vertices):
        """The two ends of segments at each, as 2 times the segment plus 0 or 1."""
        ends = self._triangles.segments[:, :2].ravel()
        order = np.argsort(ends, kind="stable")
        first = np.searchsorted(ends[order], vertices)
        return order[first], order[first + 1]

    def _before(self, which, triangle, count, group):
        """The worst measures of the triangles that each candidate changes, by new triangle."""
        old = self._triangles.measures
        alignment, cosine, quality = (least_of(which, values[triangle], count)[group] for values in (old.alignment, old.cosine, old.quality))
        return Measures(alignment, cosine, 0.0, 0.0, quality)

    def _chosen(self, gone, target, good, edges):
        """Of the good candidates some that are no neighbours and make no edge twice."""
        chosen = np.zeros(len(gone), dtype=bool)
        rows = np.flatnonzero(good)
        chosen[rows] = edges.independent(gone[rows], (self._lengths * self._shuffle[gone])[rows])
        which, other, _ = edges.neighbours_of(gone)
        new = chosen[which] & (other != target[which]) & ~edges.has(target[which], other)
        which, keys = which[new], edge_keys(target[which[new]], other[new], len(self._triangles.points))
        order = np.argsort(keys, kind="stable")
        twice = order[1:][keys[order[1:]] == keys[order[:-1]]]
        chosen[which[twice]] = False
        return chosen

    def _verified(self, gone, chosen, group, corners):
        if self._limits.verify is None or not chosen.any():
            return chosen
        number = np.cumsum(chosen) - 1
        applied = chosen[group]
        bad = self._limits.verify(self._triangles, corners[applied], number[group[applied]], int(chosen.sum()))
        rows = np.flatnonzero(chosen)[bad]
        self._fails[gone[rows]] += 1
        chosen[rows] = False
        return chosen

    def _join_segments(self, gone, target):
        mesh = self._triangles
        if not len(gone):
            return
        one, other = self._segments_at(gone)
        swapped = mesh.segments[one // 2, 1 - one % 2] != target
        near, far = np.where(swapped, other, one), np.where(swapped, one, other)
        mesh.segments[far // 2, far % 2] = target
        mesh.tangents[far // 2, far % 2] = mesh.tangents[near // 2, 1 - near % 2]
        left = np.ones(len(mesh.segments), dtype=bool)
        left[near // 2] = False
        mesh.segments, mesh.tangents = mesh.segments[left], mesh.tangents[left]
