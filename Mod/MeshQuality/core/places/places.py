# SPDX-License-Identifier: LGPL-2.1-or-later
"""The points of a mesh by the entities of its shape that they lie on."""

import FreeCAD
import numpy as np


class Places:
    """Where the points of a mesh lie on its shape: shares of the ranges of edges, and (u, v) on faces.

    points   float64 (V, 3), mm
    pairs    int (P, 2): each face with each vertex of a triangle on it
    corners  int (T, 3): the rows of these by the corners of the triangles
    uv       float64 (P, 2)
    share    float64 (V,): of vertices on edges
    """

    def __init__(self, mesh, entities):
        self.entities, self.triangles = entities, np.asarray(mesh.triangles)
        self.face, self.entity = np.asarray(mesh.triangle_face), np.asarray(mesh.vertex_entity)
        self.points = mesh.vertices + mesh.origin
        count = len(self.points)
        keys, corners = np.unique(self.face[:, None].astype(np.int64) * count + self.triangles, return_inverse=True)
        self.corners, self.pairs = corners.reshape(-1, 3), np.column_stack((keys // count, keys % count))
        self.inner = self.entity[self.pairs[:, 1], 0] == 2
        self._vectors = [FreeCAD.Vector(*point) for point in self.points]
        self.share = np.zeros(count)
        for v in np.flatnonzero(self.entity[:, 0] == 1):
            self.share[v] = entities.parameter_on_edge(self.entity[v, 1], self._vectors[v])
        self._edge_at = self._edges_at_vertices()
        self.uv = np.array([(0.0, 0.0) if inner else self.on_border(entities, face, v)
                            for (face, v), inner in zip(self.pairs.tolist(), self.inner)]).reshape(-1, 2)
        self._project_inner()

    def _edges_at_vertices(self):
        """{(face, vertex of the shape): (edge of the face that ends there, share)}."""
        found = {}
        for face, edges in enumerate(self.entities.edges_of_face):
            for edge in edges:
                ends = self.entities.ends_of_edge[edge]
                for k, vertex in enumerate(ends):
                    found.setdefault((face, vertex), (edge, float(k)))
        return found

    def on_border(self, entities, face, vertex):
        """(u, v) on a face of the entities of a vertex of the mesh that lies on an edge or a vertex of the shape."""
        dimension, index = self.entity[vertex].tolist()
        edge, share = (index, self.share[vertex]) if dimension == 1 else self._edge_at.get((face, index), (None, 0.0))
        curve = None if edge is None else entities.curve_on(face, edge)
        if curve is None:  # a vertex inside a face, or an edge that is none of the face
            return tuple(entities.surfaces[face].parameter(place_on(entities, dimension, index, share)))
        curve, low, high = curve
        at = curve.value(low + share * (high - low))
        return at.x, at.y

    def _project_inner(self):
        """(u, v) of the inner points, from those at the border inwards."""
        neighbours = [[] for _ in self.pairs]
        for corners in self.corners.tolist():
            for k in range(3):
                neighbours[corners[k]].append(corners[k - 1])
                neighbours[corners[k - 1]].append(corners[k])
        known = ~self.inner
        front = np.flatnonzero(known).tolist()
        while not known.all():
            if not front:
                front = [int(np.argmin(known))]
                self.uv[front[0]] = self._uv_of(front[0], None)
                known[front[0]] = True
            reached = []
            for at in front:
                for pair in neighbours[at]:
                    if not known[pair]:
                        self.uv[pair] = self._uv_of(pair, tuple(self.uv[at].tolist()))
                        known[pair] = True
                        reached.append(pair)
            front = reached

    def _uv_of(self, pair, guess):
        face, vertex = self.pairs[pair].tolist()
        return self.entities.parameters_on_face(face, self._vectors[vertex], guess)


def unfit(mesh):
    """Sentences: why the points of a mesh do not all lie on the entities that they belong to."""
    report, found = mesh.report, []
    if report.cut_corners:
        found.append('corners of faces were cut off (corners="keep" keeps them)')
    if report.spanning:
        found.append('triangles lie on several faces (keep_edges="feature")')
    if len(mesh.triangle_opposite):
        found.append("solids share faces (imprint=True)")
    if report.missing_faces:
        found.append("faces have no triangles (allow_missing_faces=True)")
    return found


def place_on(entities, dimension, index, share):
    """The FreeCAD.Vector of a vertex (dimension 0) of a shape, or of a share of the range of an edge."""
    if dimension == 0:
        return entities.vertices[index].Point
    edge = entities.edges[index]
    return edge.Curve.value(edge.FirstParameter + share * (edge.LastParameter - edge.FirstParameter))
