# SPDX-License-Identifier: LGPL-2.1-or-later
"""Smallest angles of triangles that were moved, and how points move within their faces and edges until these are large enough."""

import numpy as np

_PASSES = 12
_MOST_BELOW = 0.25  # fraction of the triangles beyond which no point is moved
_FALL = 0.9  # a pass that leaves more than this fraction of the triangles below the bound was the last one
_STEPS = 0.3, 0.1, 0.03, 0.01  # of a point, as a fraction of the mean length of its edges
_DIRECTIONS = np.array([(np.cos(a), np.sin(a)) for a in np.arange(8) * np.pi / 4])
_MARGIN = 1e-3  # degrees above the bound: rounding to single precision may cost a little


def smallest_angles(corners):
    """Degrees, of triangles (..., 3, 3)."""
    sides = [corners[..., k - 2, :] - corners[..., k, :] for k in range(3)]
    found = []
    for k in range(3):
        one, other = sides[k], -sides[k - 1]
        sine = np.linalg.norm(np.cross(one, other), axis=-1)
        found.append(np.degrees(np.arctan2(sine, np.einsum("...i,...i->...", one, other))))
    return np.min(found, axis=0)


def normals_of(entities, pairs, uv):
    """float64 (P, 3): outward normals of the faces at (u, v); zero where a surface has none."""
    found = np.zeros((len(pairs), 3))
    for i, (face, (u, v)) in enumerate(zip(pairs[:, 0].tolist(), uv.tolist())):
        try:
            found[i] = entities.surfaces[face].normal(u, v)
        except Exception:  # noqa: BLE001  FreeCAD raises errors of several kinds at a pole
            continue
        if entities.faces[face].Orientation == "Reversed":
            found[i] = -found[i]
    return found


class Angles:
    """The triangles of a moved mesh: their smallest angles, negative where one is turned over."""

    def __init__(self, places, after, points, uv, bounds):
        """bounds: degrees by triangle."""
        self._places, self._after, self.points, self._uv, self._bounds = places, after, points, uv, bounds
        self._normals = normals_of(after, places.pairs, uv)[places.corners].sum(axis=1)
        self.signs = _signs(places)

    def measured(self):
        """Degrees, by triangle."""
        return self._signed(self.points[self._places.triangles], self._normals, self.signs)

    @staticmethod
    def _signed(corners, normals, signs):
        across = np.cross(corners[..., 1, :] - corners[..., 0, :], corners[..., 2, :] - corners[..., 0, :])
        upright = np.einsum("...i,...i->...", across, normals) * signs
        return np.where(upright > 0.0, 1.0, -1.0) * smallest_angles(corners)

    def improve(self, poll):
        """Moves points of triangles below their bound to where the worst triangle around is best, while that helps."""
        stars = _stars(self._places.triangles, len(self.points))
        before = _MOST_BELOW * len(self._bounds) / _FALL
        for _ in range(_PASSES):
            below = np.flatnonzero(self.measured() < self._bounds + _MARGIN)
            if not len(below) or len(below) > _FALL * before:
                return
            before = len(below)
            poll()
            for v in np.unique(self._places.triangles[below]).tolist():
                self._improve_point(v, stars[v])

    def _improve_point(self, v, star):
        mover = self._mover(v, star)
        if mover is None:
            return
        triangles = self._places.triangles[star]
        corners = self.points[triangles]
        at = triangles == v
        length = np.linalg.norm(corners - self.points[v], axis=2).sum() / (2 * len(star))
        before = self._worst(corners[None], star)[0]
        for step in _STEPS:
            parameters, points = mover(step * length)
            trial = np.repeat(corners[None], len(points), axis=0)
            trial[:, at] = points[:, None]
            worst = self._worst(trial, star)
            best = int(np.argmax(worst))
            if worst[best] > before + 1e-6:
                self._put(v, parameters[best], points[best])
                corners[at], before = points[best], worst[best]

    def _worst(self, corners, star):
        """The least amount by which an angle of the star exceeds its bound, by candidate."""
        return (self._signed(corners, self._normals[star], self.signs[star]) - self._bounds[star]).min(axis=1)

    def _mover(self, v, star):
        """A function of a length that returns candidates: their parameters, and where these are; None: the point cannot move."""
        dimension, index = self._places.entity[v].tolist()
        if dimension == 1:
            return lambda step: self._along_edge(v, self._after.edges[index], step)
        if dimension == 2:
            pair = self._places.corners[star[0]][self._places.triangles[star[0]] == v][0]
            return lambda step: self._within_face(pair, self._after.surfaces[self._places.pairs[pair, 0]], step)
        return None

    def _along_edge(self, v, edge, step):
        share, change = self._places.share[v], step / edge.Length
        shares = np.clip([share - change, share + change], 0.0, 1.0)
        low, high = edge.ParameterRange
        return shares, np.array([edge.Curve.value(low + s * (high - low)) for s in shares.tolist()])

    def _within_face(self, pair, surface, step):
        u, v = self._uv[pair].tolist()
        along_u, along_v = (np.array(surface.getDN(u, v, k, 1 - k)) for k in (1, 0))
        metric = np.array([[along_u @ along_u, along_u @ along_v], [along_u @ along_v, along_v @ along_v]])
        if np.linalg.det(metric) <= 0.0:
            return self._uv[pair][None], np.array(surface.value(u, v))[None]
        # By the inverse root of the metric directions have the same length in space.
        parameters = self._uv[pair] + step * _DIRECTIONS @ np.linalg.inv(np.linalg.cholesky(metric))
        return parameters, np.array([surface.value(*at) for at in parameters.tolist()])

    def _put(self, v, parameters, point):
        self.points[v] = point
        if self._places.entity[v, 0] == 1:
            self._places.share[v] = parameters
        else:
            self._uv[self._places.pairs[:, 1] == v] = parameters


def _signs(places):
    """1 or -1 by triangle: on which side of the CAD face the mesh has its outside."""
    corners = places.points[places.triangles]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    upright = np.einsum("ij,ij->i", across, normals_of(places.entities, places.pairs, places.uv)[places.corners].sum(axis=1))
    by_face = np.bincount(places.face, upright)
    return np.where(by_face[places.face] < 0.0, -1.0, 1.0)


def _stars(triangles, count):
    """The triangles at each vertex."""
    order = np.argsort(triangles.ravel(), kind="stable")
    borders = np.cumsum(np.bincount(triangles.ravel(), minlength=count))[:-1]
    return np.split(order // 3, borders)
