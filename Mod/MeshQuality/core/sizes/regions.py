# SPDX-License-Identifier: LGPL-2.1-or-later
"""Size fields of shapes: inside of solids, near faces, edges and points, and in wakes."""

import hashlib

import numpy as np

from ... import options
from ...compat import extension
from ...errors import InvalidInput
from ..sources import convert

_CHORD = 0.002  # of the triangles that stand for a shape, as a fraction of its size
_EDGE_PIECES = 200  # of a curve
_MOST_STEPS = 200  # of a body along its wake
_MARKS = 1 / 200  # least size of a feature that is marked, as a fraction of the size of the region


class _Region:
    """A region with its name and a digest of what it depends on."""

    def __init__(self, name, digest):
        self.name, self._digest = name, hashlib.sha256(repr(digest).encode())

    def digest(self):
        """Text that changes whenever the region does."""
        return self._digest.hexdigest()


class Inside(_Region):
    """One size inside of solids, no bound outside."""

    def __init__(self, shape, size, name):
        if not shape.Solids:
            raise InvalidInput(f"{name} has no solid: a region inside needs one; for faces, edges and points use near")
        super().__init__(name, ("inside", size, convert.shape_text(shape)))
        self._size = size
        self._surface, self._points, self._extent, self._box = _surface_of(shape)

    def sizes(self, points):
        """float64 (n,), mm."""
        return np.where(self._contains(points), self._size, np.inf)

    def marks(self):
        """The region ends at its surface."""
        return self._points, np.full(len(self._points), max(self._size, _MARKS * self._extent))

    def _contains(self, points):
        found = np.zeros(len(points), dtype=bool)
        there = ((points >= self._box[0]) & (points <= self._box[1])).all(axis=1)
        if there.any():
            module = extension()
            measured = module.measure_deviation(np.ascontiguousarray(points[there]), self._surface, None)
            found[there] = measured.values <= 1e-9 * self._extent
        return found


class Wake(Inside):
    """One size in the volume that solids sweep along a direction."""

    def __init__(self, shape, size, direction, length, name):
        super().__init__(shape, size, name)
        direction = np.asarray(direction, dtype=np.float64)
        norm = np.linalg.norm(direction)
        if direction.shape != (3,) or not np.isfinite(norm) or norm == 0.0:
            raise InvalidInput(f"{name}: the direction of a wake is {direction.tolist()}: give three numbers, not all 0")
        self._digest.update(repr((direction.tolist(), length)).encode())
        self._sweep, self._length = direction / norm * length, length
        self._body = self._box
        self._box = np.minimum(self._box[0], self._box[0] + self._sweep), np.maximum(self._box[1], self._box[1] + self._sweep)

    def marks(self):
        """The places of the body along the wake."""
        steps = np.linspace(0.0, 1.0, self._steps())
        points = (self._points[None] + steps[:, None, None] * self._sweep).reshape(-1, 3)
        points = points[::max(1, len(points) // 200_000)]
        return points, np.full(len(points), max(self._size, _MARKS * (self._extent + self._length)))

    def _steps(self):
        return int(min(_MOST_STEPS, max(2, np.ceil(2.0 * self._length / min(self._size, self._extent)) + 1)))

    def _contains(self, points):
        found, box = np.zeros(len(points), dtype=bool), self._box
        self._box = self._body
        try:
            for step in np.linspace(0.0, 1.0, self._steps()):
                left = np.flatnonzero(~found & ((points >= box[0]) & (points <= box[1])).all(axis=1))
                if len(left):
                    found[left] = super()._contains(points[left] - step * self._sweep)
        finally:
            self._box = box
        return found


class Near(_Region):
    """A size at shapes, which grows linearly to another one at a distance, and no bound beyond."""

    def __init__(self, shapes, size, far_size, distance, name):
        super().__init__(name, ("near", size, far_size, distance, [convert.shape_text(shape) for shape in shapes]))
        self._size, self._far, self._distance = size, far_size, distance
        nodes, simplices = _simplices_of(shapes)
        if not len(nodes):
            raise InvalidInput(f"{name} has neither faces, edges nor points: choose some")
        self._nodes = nodes
        self._field = extension().SimplexField(nodes, simplices, np.zeros(len(nodes)))
        self._extent = float(np.ptp(nodes, axis=0).max()) if len(nodes) else 0.0

    def sizes(self, points):
        """float64 (n,), mm."""
        share = self._field.distances(points) / self._distance
        return np.where(share <= 1.0, self._size + (self._far - self._size) * share, np.inf)

    def marks(self):
        """The shapes."""
        return self._nodes, np.full(len(self._nodes), max(self._size, _MARKS * self._extent))


class Moved:
    """A field for points of another frame."""

    def __init__(self, field, placement):
        self.name, self._field, self._placement = field.name, field, placement

    def sizes(self, points):
        """float64 (n,), mm."""
        return self._field.sizes(convert.moved(points, self._placement))

    def marks(self):
        """Those of the field, in that frame."""
        points, lengths = self._field.marks()
        return convert.moved(points, self._placement.inverse()), lengths


def _triangulated(shape):
    module = extension()
    given = module.TriangulateOptions()
    options.hand_over({"min_angle": 20.0, "chord_height_relative": _CHORD, "allow_missing_faces": True}, given)
    return module.triangulate(shape, given, None, None)


def _surface_of(shape):
    """A Surface of the core, its vertices, their extent and their box."""
    module, surface = extension(), _triangulated(shape)
    points = np.asarray(surface.vertices) + np.asarray(surface.origin)
    surface = module.surface_from_arrays(points, np.asarray(surface.triangles, dtype=np.int64))
    box = points.min(axis=0), points.max(axis=0)
    return surface, points, float((box[1] - box[0]).max()), box


def _simplices_of(shapes):
    """Nodes and simplices of faces, else edges, else points of each shape."""
    nodes, simplices, first = [np.zeros((0, 3))], [np.zeros((0, 4), dtype=np.int32)], 0
    for shape in shapes:
        if shape.Faces:
            surface = _triangulated(shape)
            points, rows = np.asarray(surface.vertices) + np.asarray(surface.origin), np.asarray(surface.triangles)
        else:
            curves = [np.array([tuple(p) for p in edge.discretize(_EDGE_PIECES)]) for edge in shape.Edges]
            if not curves:
                curves = [np.array([tuple(vertex.Point)]) for vertex in shape.Vertexes]
            starts = np.cumsum([0, *map(len, curves)])
            points = np.concatenate(curves) if curves else np.zeros((0, 3))
            rows = [np.column_stack((np.arange(a, b - 1), np.arange(a + 1, b))) if b - a > 1 else np.array([[a]])
                    for a, b in zip(starts, starts[1:])]
            rows = np.concatenate(rows) if rows else np.zeros((0, 1), dtype=int)
        simplices.append(np.pad(rows + first, ((0, 0), (0, 4 - rows.shape[1])), constant_values=-1).astype(np.int32))
        nodes.append(points)
        first += len(points)
    return np.concatenate(nodes), np.concatenate(simplices)
