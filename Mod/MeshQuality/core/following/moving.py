# SPDX-License-Identifier: LGPL-2.1-or-later
"""The points of a mesh on another shape with the same faces, edges and vertices."""

import FreeCAD
import numpy as np

from .entities import scale_and_shift

_POLE = 1e-9  # a derivative below this fraction of the size: the surface is a point there
_RESIDUAL = 1e-11  # of the equations of inner points, relative


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
            return tuple(entities.surfaces[face].parameter(_place(entities, dimension, index, share)))
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
        found.append('corners of faces were cut off (corners="cut")')
    if report.spanning:
        found.append('triangles lie on several faces (keep_edges="feature")')
    if len(mesh.triangle_opposite):
        found.append("solids share faces (imprint=True)")
    if report.missing_faces:
        found.append("faces have no triangles (allow_missing_faces=True)")
    return found


def _place(entities, dimension, index, share):
    if dimension == 0:
        return entities.vertices[index].Point
    edge = entities.edges[index]
    return edge.Curve.value(edge.FirstParameter + share * (edge.LastParameter - edge.FirstParameter))


def moved(places, after):
    """(points (V, 3), (u, v) of the pairs) on the entities of another shape: points on vertices and edges go to these, and inner
    points by that by which (u, v) of the borders change, harmonically continued inwards.
    """
    uv, change, fixed = _change_at_borders(places, after)
    first, second, weights = _weights(places)
    for k in (0, 1):
        change[:, k] = _harmonic(first, second, weights, change[:, k], fixed[:, k])
    uv += change
    points = np.zeros_like(places.points)
    for v, (dimension, index) in enumerate(places.entity.tolist()):
        if dimension < 2:
            points[v] = _place(after, dimension, index, places.share[v])
    for pair in np.flatnonzero(places.inner).tolist():
        face, vertex = places.pairs[pair].tolist()
        points[vertex] = after.surfaces[face].value(*uv[pair].tolist())
    return points, uv


def _change_at_borders(places, after):
    """(u, v) in the new ranges, the change of that at borders, and where it is known."""
    before = places.entities
    uv, change = np.zeros_like(places.uv), np.zeros_like(places.uv)
    fixed = np.repeat(~places.inner[:, None], 2, axis=1)
    for face in np.unique(places.pairs[:, 0]).tolist():
        of_face = np.flatnonzero(places.pairs[:, 0] == face)
        factors = scale_and_shift(before, after, face)
        uv[of_face] = places.uv[of_face] * factors[:, 0] + factors[:, 1]
        border = of_face[~places.inner[of_face]]
        if not len(border):
            continue
        found = np.array([places.on_border(after, face, v) for v in places.pairs[border, 1].tolist()]) - uv[border]
        for k, period in enumerate(after.periods(face)):
            if period:
                found[:, k] -= period * np.round((found[:, k] - found[0, k]) / period)
        change[border] = found
        _free_poles(places, face, border, fixed)
    return uv, change, fixed


def _free_poles(places, face, border, fixed):
    """Where a surface is a point along u or v, that parameter is none of the point's."""
    surface = places.entities.surfaces[face]
    for pair in border[places.entity[places.pairs[border, 1], 0] == 0].tolist():
        u, v = places.uv[pair].tolist()
        for k in (0, 1):
            if surface.getDN(u, v, 1 - k, k).Length < _POLE * places.entities.size:
                fixed[pair, k] = False


def _weights(places):
    """(first pair, second pair, weight) of the sides of all triangles: half the cotangent of the angle opposite."""
    at = places.points[places.triangles]
    found = []
    for k in range(3):
        a, b, c = at[:, k], at[:, k - 2], at[:, k - 1]
        one, other = b - a, c - a
        area = np.linalg.norm(np.cross(one, other), axis=1)
        weights = 0.5 * np.einsum("ij,ij->i", one, other) / np.maximum(area, 1e-300)
        found.append((places.corners[:, k - 2], places.corners[:, k - 1], np.where(area > 0.0, weights, 0.0)))
    return (np.concatenate(parts) for parts in zip(*found))


def _harmonic(first, second, weights, values, fixed):
    """Values that minimise the sum of weights times squared differences, where those that are not fixed are free: by conjugate
    gradients.
    """
    count, free = len(values), ~fixed
    degree = np.bincount(first, weights, count) + np.bincount(second, weights, count)
    diagonal = np.where(degree > 0.0, degree, 1.0)

    def applied(x):
        return np.where(free, degree * x - np.bincount(first, weights * x[second], count)
                        - np.bincount(second, weights * x[first], count), 0.0)

    x = np.where(fixed, values, 0.0)
    rest = -applied(x)
    wanted = _RESIDUAL * float(np.linalg.norm(rest))
    direction = shifted = rest / diagonal
    product = float(rest @ shifted)
    for _ in range(count):
        if np.linalg.norm(rest) <= wanted:
            break
        image = applied(direction)
        step = product / float(direction @ image)
        x = x + step * direction
        rest = rest - step * image
        shifted = rest / diagonal
        product, before = float(rest @ shifted), product
        direction = shifted + (product / before) * direction
    return x
