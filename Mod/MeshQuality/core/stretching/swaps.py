# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges between two triangles of a face that are turned, where that makes the worse triangle better in the metric."""

import numpy as np

from .limits import LONGEST
from .triangles import Edges, Measures, among, edge_keys, score

_ROUNDS = 20
_GAIN = 0.05  # least gain of the score
_FEW = 1e-3  # a round that swaps less than this fraction of the triangles was the last one


class Swaps:
    """Swaps edges, many that share no triangle at a time."""

    def __init__(self, triangles, limits):
        self._triangles, self._limits = triangles, limits

    def run(self, poll):
        """Until the triangles get no better."""
        self._failed = np.zeros(0, dtype=np.int64)
        for _ in range(_ROUNDS):
            poll()
            if self._round() <= _FEW * len(self._triangles.corners):
                return

    def _round(self):
        mesh, limits = self._triangles, self._limits
        edges = Edges(mesh.vertices, len(mesh.points))
        rows = edges.side_rows
        starts = np.concatenate([[0], np.cumsum(edges.count)])
        inner = np.flatnonzero((edges.count == 2) & ~among(edges.keys, mesh.segment_keys()) & ~among(edges.keys, self._failed))
        one, other = rows[starts[inner]], rows[starts[inner] + 1]
        same = mesh.face[one // 3] == mesh.face[other // 3]
        inner, one, other = inner[same], one[same], other[same]
        pair = np.stack([one // 3, other // 3])
        a, b, c = (mesh.corners[pair[0], (one % 3 + k) % 3] for k in range(3))
        d = mesh.corners[pair[1], (other % 3 + 2) % 3]
        ends = mesh.pairs.vertex[np.stack([a, b, c, d])]
        good = (ends[2] != ends[3]) & ~edges.has(ends[2], ends[3])
        held = mesh.held[ends]
        good &= ~(held[0] & held[1] & (held[2] | held[3]))
        new = [np.stack(corners, axis=1) for corners in ((a, d, c), (d, b, c))]
        found = [mesh.measured(corners) for corners in new]
        old = [Measures(*(values[side] for values in mesh.measures)) for side in pair]
        worst = Measures(*(np.minimum(*both) for both in zip(*old)))._replace(distance=0.0)
        gain = np.minimum(score(found[0]), score(found[1])) - np.minimum(score(old[0]), score(old[1]))
        longest = np.maximum(LONGEST, mesh.measures.lengths[pair[0], one % 3])
        good &= (gain > _GAIN) & (found[0].lengths[:, 1] <= longest)
        for measures in found:
            good &= ~limits.broken(measures, worst)
        chosen = self._chosen(np.flatnonzero(good), gain, pair, edge_keys(ends[2], ends[3], len(mesh.points)))
        if limits.verify is not None and len(chosen):
            bad = limits.verify(mesh, np.concatenate([corners[chosen] for corners in new]), np.tile(np.arange(len(chosen)), 2), len(chosen))
            self._failed = np.unique(np.concatenate([self._failed, edges.keys[inner[chosen[bad]]]]))
            chosen = chosen[~bad]
        for side, corners, measures in zip(pair, new, found):
            mesh.put(side[chosen], corners[chosen], Measures(*(values[chosen] for values in measures)))
        return len(chosen)

    def _chosen(self, rows, gain, pair, keys):
        """Those that gain most of all that share a triangle, and make no edge twice."""
        most = np.zeros(len(self._triangles.corners))
        for side in pair:
            np.maximum.at(most, side[rows], gain[rows])
        rows = rows[(most[pair[0][rows]] == gain[rows]) & (most[pair[1][rows]] == gain[rows])]
        rows = rows[np.unique(keys[rows], return_index=True)[1]]
        uses = np.bincount(pair[:, rows].ravel(), minlength=len(most))
        return rows[(uses[pair[0][rows]] == 1) & (uses[pair[1][rows]] == 1)]
