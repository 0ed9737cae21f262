# SPDX-License-Identifier: LGPL-2.1-or-later
"""Vertices inside faces that move to where the triangles around are better in the metric."""

import numpy as np

from .limits import LONGEST
from .metrics import longest_direction, main_lengths
from .triangles import SCORE, Edges, Measures, least_of, score

_SHARES = 1.0, 0.5  # of the way that are tried
_ALONG = 0.4, -0.4, 0.15, -0.15  # lengths in the metric that are tried in its long direction
_AROUND = 8  # directions that are tried about a vertex of a low triangle
_LENGTHS = 0.5, 0.2, 0.08  # in the metric, that are tried there
_GAIN = 0.03  # least gain of the score


class Moves:
    """Moves vertices within their faces, many that are no neighbours at a time."""

    def __init__(self, triangles, limits, metric_at):
        """metric_at: function(points, normals, curvatures) -> (n, 6)."""
        self._triangles, self._limits, self._metric_at = triangles, limits, metric_at

    def run(self, sweeps, poll, low=False):
        """Each vertex once a sweep; low: those of triangles that are low, in all directions."""
        mesh = self._triangles
        self._low = low
        edges = Edges(mesh.vertices, len(mesh.points))
        self._pair = np.full(len(mesh.points), -1)
        free = (mesh.entity[:, 0] == 2) & ~mesh.held
        inner = free[mesh.vertices]
        if low:
            inner &= (score(mesh.measures) < SCORE)[:, None]
        self._pair[mesh.pairs.vertex[mesh.corners[inner]]] = mesh.corners[inner]
        random = np.random.RandomState(2)
        for _ in range(sweeps):
            left = np.flatnonzero(self._pair >= 0)
            while len(left):
                poll()
                now = edges.independent(left, random.rand(len(left)), 6)
                self._move(edges, left[now])
                left = left[~now]

    def _move(self, edges, vertices):
        mesh = self._triangles
        which, corner = edges.corners_of(vertices)
        group, other, edge = edges.neighbours_of(vertices)
        lengths = np.maximum(edges.lengths(mesh.measures.lengths)[edge], 1e-9)
        wanted = mesh.points[other] + (mesh.points[vertices[group]] - mesh.points[other]) / lengths[:, None]
        target = np.stack([np.bincount(group, wanted[:, k], len(vertices)) for k in range(3)], axis=1)
        target /= np.bincount(group, minlength=len(vertices))[:, None]
        todo = np.arange(len(vertices))
        for share in _SHARES:
            todo = self._tried(vertices, todo, mesh.points[vertices] + share * (target - mesh.points[vertices]), which, corner)
        if self._low:
            self._around(vertices, todo, which, corner)
            return
        along = longest_direction(mesh.metric[self._pair[vertices]], mesh.pairs.normals[self._pair[vertices]])
        for length in _ALONG:
            todo = self._tried(vertices, todo, mesh.points[vertices] + length * along, which, corner)

    def _around(self, vertices, todo, which, corner):
        """Tries places about vertices, at lengths in the mean metric of the triangles there."""
        mesh = self._triangles
        pairs = self._pair[vertices]
        mean = np.zeros((len(vertices), 6))
        np.add.at(mean, which, mesh.metric[mesh.corners[corner // 3]].mean(axis=1))
        mean /= np.bincount(which, minlength=len(vertices))[:, None]
        one, other = main_lengths(mean, mesh.pairs.normals[pairs])
        for length in _LENGTHS:
            for k in range(_AROUND):
                angle = 2.0 * np.pi * k / _AROUND
                todo = self._tried(vertices, todo, mesh.points[vertices] + length * (np.cos(angle) * one + np.sin(angle) * other), which, corner)

    def _tried(self, vertices, todo, target, which, corner):
        """The vertices that are not better there."""
        mesh = self._triangles
        pairs = self._pair[vertices[todo]]
        uv, points, normals, curvatures, found = mesh.pairs.projected(pairs, target[todo])
        metric = self._metric_at(points, normals, curvatures)
        number = np.full(len(vertices), -1)
        number[todo] = np.arange(len(todo))
        mine = number[which] >= 0
        group, rows, place = number[which[mine]], corner[mine] // 3, corner[mine] % 3
        new = mesh.measured(mesh.corners[rows], (place, points[group], normals[group], metric[group]))
        old = Measures(*(values[rows] for values in mesh.measures))
        before, after = (least_of(group, score(values), len(todo)) for values in (old, new))
        worst = old._replace(cosine=least_of(group, old.cosine, len(todo))[group], quality=least_of(group, old.quality, len(todo))[group])
        longer = (new.lengths > np.maximum(LONGEST, old.lengths)).any(axis=1)
        good = found & (after > before + _GAIN) & (np.bincount(group, self._limits.broken(new, worst) | longer, len(todo)) == 0)
        good &= self._close(good, group, mesh.corners[rows], place, points, len(todo))
        at = vertices[todo[good]]
        mesh.points[at], mesh.pairs.uv[pairs[good]], mesh.pairs.normals[pairs[good]] = points[good], uv[good], normals[good]
        mesh.pairs.curvatures[pairs[good]], mesh.metric[pairs[good]] = curvatures[good], metric[good]
        applied = good[group]
        mesh.put(rows[applied], mesh.corners[rows[applied]], Measures(*(values[applied] for values in new)))
        return todo[~good]

    def _close(self, good, group, corners, place, points, count):
        found = np.ones(count, dtype=bool)
        if self._limits.verify is not None and good.any():
            number = np.cumsum(good) - 1
            mine = good[group]
            bad = self._limits.verify(self._triangles, corners[mine], number[group[mine]], int(good.sum()), (place[mine], points[group[mine]]))
            found[np.flatnonzero(good)[bad]] = False
        return found

