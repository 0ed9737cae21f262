# SPDX-License-Identifier: LGPL-2.1-or-later
"""The vertices of a mesh on their CAD faces: normals, curvatures, and how they move within a face."""

import FreeCAD
import numpy as np

_DERIVATIVES = (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)
_NOWHERE = FreeCAD.Vector()
_FLAT = 1e-7  # a normal of derivatives shorter than this share of their lengths has no direction
_CORRECTIONS = 2  # of a projection, after its first step


class CadPairs:
    """Each face with each vertex of a triangle on it.

    face, vertex  int64 (P,), ascending by face, then vertex
    uv            float64 (P, 2)
    normals       float64 (P, 3): unit, on the outer side of the mesh
    curvatures    float64 (P, 6): the second fundamental form in space, xx, yy, zz, xy, yz, zx, for each mm
    """

    def __init__(self, places, corners):
        self._surfaces = places.entities.surfaces
        self.face, self.vertex = places.pairs.T.astype(np.int64)
        self.uv = np.array(places.uv)
        self._bounds = np.array([places.entities.bounds(face) for face in range(len(self._surfaces))]).reshape(-1, 4)
        every = np.arange(len(self.face))
        points, derivatives = self._evaluated(every, self.uv)
        self.normals, self.curvatures, regular = _forms(derivatives)
        self.signs = np.ones(len(self._surfaces))
        across = _crosses(places.points[places.triangles])
        sums = np.zeros((len(every), 3))
        for k in range(3):
            np.add.at(sums, corners[:, k], across)
        upright = np.bincount(self.face, np.einsum("ij,ij->i", sums, self.normals), len(self.signs))
        self.signs[upright < 0.0] = -1.0
        self._outwards(every)
        sums /= np.maximum(np.linalg.norm(sums, axis=1), 1e-300)[:, None]
        self.normals[~regular] = sums[~regular]  # at a pole
        self.irregular = ~regular

    def _outwards(self, rows):
        signs = self.signs[self.face[rows], None]
        self.normals[rows] *= signs
        self.curvatures[rows] *= signs

    def _evaluated(self, rows, uv):
        """Points (n, 3) and derivatives (n, 5, 3): u, v, uu, uv, vv."""
        found = []
        for face, (u, v) in zip(self.face[rows].tolist(), uv.tolist()):
            surface = self._surfaces[face]
            at = surface.value(u, v)
            found += at.x, at.y, at.z
            try:
                here = [surface.getDN(u, v, along_u, along_v) for along_u, along_v in _DERIVATIVES]
            except Exception:  # noqa: BLE001  FreeCAD raises errors of several kinds at a pole
                here = [_NOWHERE] * len(_DERIVATIVES)
            found += [c for along in here for c in (along.x, along.y, along.z)]
        found = np.array(found).reshape(-1, 1 + len(_DERIVATIVES), 3)
        return found[:, 0], found[:, 1:]

    def projected(self, rows, points):
        """(uv, points, normals, curvatures, found): places of the faces of pairs near points (n, 3), starting from where the pairs are;
        found: where the surface has a normal.
        """
        uv, bounds = self.uv[rows].copy(), self._bounds[self.face[rows]]
        at, derivatives = self._evaluated(rows, uv)
        for _ in range(1 + _CORRECTIONS):
            uv += _step(derivatives, points - at)
            uv = np.clip(uv, bounds[:, [0, 2]], bounds[:, [1, 3]])
            at, derivatives = self._evaluated(rows, uv)
        normals, curvatures, found = _forms(derivatives)
        signs = self.signs[self.face[rows], None]
        return uv, at, normals * signs, curvatures * signs, found


def _step(derivatives, rest):
    along_u, along_v = derivatives[:, 0], derivatives[:, 1]
    a, b, c = (np.einsum("ij,ij->i", *pair) for pair in ((along_u, along_u), (along_u, along_v), (along_v, along_v)))
    e, f = np.einsum("ij,ij->i", rest, along_u), np.einsum("ij,ij->i", rest, along_v)
    determinant = a * c - b * b
    good = determinant > 1e-12 * a * c
    determinant[~good] = 1.0
    return np.where(good, np.stack([c * e - b * f, a * f - b * e]) / determinant, 0.0).T


def _forms(derivatives):
    """Unit normals, second fundamental forms in space (n, 6), and where there is a normal."""
    along_u, along_v = derivatives[:, 0], derivatives[:, 1]
    across = np.cross(along_u, along_v)
    lengths = np.linalg.norm(across, axis=1)
    scale = np.einsum("ij,ij->i", along_u, along_u) + np.einsum("ij,ij->i", along_v, along_v)
    found = lengths > _FLAT * np.maximum(scale, 1e-300)
    normals = across / np.where(found, lengths, 1.0)[:, None]
    second = np.einsum("nkj,nj->nk", derivatives[:, 2:], normals)
    # Dual vectors of the tangents: the form of a direction d is second(d . dual_u, d . dual_v).
    squared = np.where(found, lengths, 1.0)[:, None]
    dual_u, dual_v = np.cross(along_v, normals) / squared, np.cross(normals, along_u) / squared
    xx = dual_u[:, :, None] * dual_u[:, None, :] * second[:, 0, None, None]
    xy = (dual_u[:, :, None] * dual_v[:, None, :] + dual_v[:, :, None] * dual_u[:, None, :]) * second[:, 1, None, None]
    yy = dual_v[:, :, None] * dual_v[:, None, :] * second[:, 2, None, None]
    form = xx + xy + yy
    found &= np.isfinite(form).all(axis=(1, 2))
    normals[~found], form[~found] = 0.0, 0.0
    return normals, sixes(form), found


def _crosses(corners):
    return np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])


def sixes(matrices):
    """(n, 6): xx, yy, zz, xy, yz, zx of symmetric matrices (n, 3, 3)."""
    return matrices[:, [0, 1, 2, 0, 1, 2], [0, 1, 2, 1, 2, 0]]


def matrices(rows):
    """(n, 3, 3) of (n, 6)."""
    return rows[:, [[0, 3, 5], [3, 1, 4], [5, 4, 2]]]
