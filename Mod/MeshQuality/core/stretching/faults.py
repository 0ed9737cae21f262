# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where stretched triangles may not stay: they cross others that those of equal sides do not cross there, or are too far from the shape."""

import numpy as np

from ...compat import extension
from ..meshes.surface_mesh import surface_of
from .triangles import edge_keys

_CROSSINGS = "crossing pair of triangles", "touching pair of triangles"
_MOST = 200_000  # pairs that are looked at; where there are more, all count
_WIDER = 1.0, 2.0, 4.0  # radii about a triangle at fault, in its own, one round after the other; then its whole face


class Faults:
    """Judges stretched triangles beside those of equal sides that they were made of."""

    def __init__(self, mesh, places, asked):
        """asked: mm, the largest distance; None: any."""
        self._mesh, self._asked = mesh, asked
        self._body = _bodies(places.entities)
        self._points, self._triangles, self._face = places.points.copy(), places.triangles, places.face
        pairs = self._pairs((mesh.vertices, mesh.triangles))
        faces = np.sort(self._face[pairs], axis=1)
        self._before = dict(zip(*(values.tolist() for values in np.unique(self._keys(faces), return_counts=True)))) if len(pairs) else {}
        self.said = set()  # faces with triangles at fault

    def crossing(self, points, triangles, face):
        """int (n, 2) of triangles (T, 3) on faces (T,): pairs that count as crossings, and int (m, 2): those that are at fault.

        Bodies that touch have faces that lie on each other, whose triangles meet in any mesh. So pairs of different bodies count only
        where triangles of equal sides of the same two faces do not meet, and those of one body all, but are at fault only if there are more.
        """
        pairs = self._pairs((points, triangles))
        if not 0 < len(pairs) < _MOST:
            return pairs, pairs
        faces = np.sort(face[pairs], axis=1)
        one_body = np.array([bool(self._body[a] & self._body[b]) for a, b in faces.tolist()])
        keys = self._keys(faces)
        _, which, counts = np.unique(keys, return_inverse=True, return_counts=True)
        before = np.array([self._before.get(key, 0) for key in keys.tolist()])
        more = counts[which.reshape(-1)] > before
        return pairs[one_body | (before == 0)], pairs[np.where(one_body, more, before == 0)]

    def held(self, points, triangles, face, rows, wide):
        """bool (V,): vertices of the mesh of equal sides around triangles at fault, wider from round to round."""
        self.said |= set(face[rows].tolist())
        found = np.zeros(len(self._points), dtype=bool)
        for row in np.unique(rows).tolist():
            mine = self._face == face[row]
            corners = points[triangles[row]]
            centre = corners.mean(axis=0)
            vertices = np.unique(self._triangles[mine])
            if wide < len(_WIDER):
                radius = _WIDER[wide] * np.linalg.norm(corners - centre, axis=1).max()
                vertices = vertices[np.linalg.norm(self._points[vertices] - centre, axis=1) <= radius]
            found[vertices] = True
        around = found[self._triangles].any(axis=1)  # so that whole triangles of equal sides stay
        found[self._triangles[around]] = True
        return found

    def too_far(self, surface, shape, progress):
        """The triangles of a Surface that are farther from the shape than allowed."""
        if not self._asked:
            return np.zeros(0, dtype=np.int64)
        most = max(self._asked, self._mesh.report.max_chord_height)
        if surface.report.max_chord_height <= most:
            return np.zeros(0, dtype=np.int64)
        return np.flatnonzero(extension().triangle_deviations(surface, shape, progress) > most)

    def _pairs(self, mesh):
        found = extension().faults(surface_of(mesh), _MOST)
        return np.concatenate([found[kind] for kind in _CROSSINGS if kind in found])

    def _keys(self, faces):
        return edge_keys(faces[:, 0].astype(np.int64), faces[:, 1].astype(np.int64), len(self._body))


def _bodies(entities):
    """The bodies that each face belongs to: solids and shells; faces in none that edges join are one."""
    found = [set() for _ in entities.faces]
    for number, body in enumerate(entities.bodies):
        for face in body:
            found[face].add(number)
    loose = [face for face, bodies in enumerate(found) if not bodies]
    faces_of_edge = {}
    for face in loose:
        for edge in entities.edges_of_face[face]:
            faces_of_edge.setdefault(edge, []).append(face)
    for number, first in enumerate(loose, len(entities.bodies)):
        waiting = [] if found[first] else [first]
        while waiting:
            face = waiting.pop()
            if not found[face]:
                found[face].add(number)
                waiting += [other for edge in entities.edges_of_face[face] for other in faces_of_edge[edge]]
    return found
