# SPDX-License-Identifier: LGPL-2.1-or-later
"""Size fields as the core takes them: sampled once into an octree, and meshes measured against them."""

from collections import namedtuple

import numpy as np

from ... import options
from ...compat import extension
from ...errors import Cancelled, InvalidInput
from ...listing import Public
from ..sources import convert
from . import RATIO, forms
from .interpolated import require_sizes

_ERROR = 0.05  # largest relative error of the octree
_LEAST_DEPTH = 5  # of the octree, everywhere in the box of the shape
_SURFACE_DEPTH, _ON_SURFACE = 6, 1 / 60  # of the cells at the surface, and their size as a fraction of the box
_MOST_SAMPLES = 1_500_000
_BATCH = 100_000  # points that a function gets at a time
_ROUNDS = 3  # further meshes where the octree has missed a small feature
_MOST_TRIANGLES = 5_000_000  # as max_triangles
# Area of a triangle, divided by the squared size: measured on meshes of constant fields, see docs/method/size-field.md.
_AREA = 0.36

# What was measured on a mesh: largest ratio, where, the fraction of edges below half of the field, number of edges, and the edges that
# are too long for the field, but not for the octree.
Measured = namedtuple("Measured", "ratio point short_share edges missed missed_sizes")


class SizeField(metaclass=Public):
    """Edge lengths by their places for the mesh of one shape, sampled, as mq.size_field makes it.

    points               float64 (n, 3), mm, on the shape's surface
    sizes                float64 (n,), mm, wanted there
    least                mm: the least of these
    expected_triangles   about how many triangles a mesh of these sizes has
    samples              how many values the field was asked for

    It is a form of size_field= itself: for the same shape it is not sampled again.
    """

    __slots__ = {"_core": None, "_sampling": None, "expected_triangles": "about how many triangles a mesh of these sizes has",
                 "points": "float64 (n, 3), mm: on the surface", "samples": "how many sizes were asked for", "sizes": "float64 (n,), mm"}

    def __init__(self, core, points, areas, samples):
        self._core = core
        self.points, self.samples = points, samples
        self.sizes = core.at(points)
        self.expected_triangles = expected_triangles(areas, self.sizes)

    least = property(lambda self: float(self.sizes.min()), doc="mm")

    def at(self, points):
        """float64 (n,), mm, at points (n, 3)."""
        return self._core.at(np.asarray(points, dtype=np.float64))

    def size_fields(self):
        """Itself as a list of one field."""
        return [forms.Octree(self._core)]

    def __repr__(self):
        return f"<SizeField: {self.least:.4g} to {self.sizes.max():.4g} mm, about {self.expected_triangles:,} triangles>"


def size_field(shape, size_field, progress=None):
    """The SizeField of a shape: what size_field= of triangulate makes of this argument, to be drawn or asked before meshing.

    shape       Part.Shape with faces, or a document object that has one
    size_field  as for triangulate
    progress    callable(fraction 0..1, stage); returning False cancels

    Raises what triangulate raises.
    """
    options.require_callable(progress)
    sampling = Sampling.of(shape, size_field, progress)
    if sampling is None:
        raise InvalidInput(f"size_field = None is no field: give {forms.ACCEPTED}")
    return SizeField(sampling.core(), sampling.points, sampling.areas, sampling.samples)


def expected_triangles(areas, sizes):
    """About how many triangles a surface has whose pieces have these areas (mm^2) and sizes (mm)."""
    return int(np.ceil(np.sum(areas / (_AREA * sizes**2))))


class Sampling:
    """The octree of the fields that a form stands for, around one shape."""

    @classmethod
    def of(cls, shape, form, progress, inside=True):
        """The Sampling; None where the form is None. Calls functions on this thread. inside: not near the surface alone."""
        fields = forms.fields_of(form)
        return cls(convert.shape_of(shape), fields, progress, inside) if fields else None

    def __init__(self, live_shape, fields, progress, inside):
        self._fields, self._progress = fields, progress
        module = extension()
        coarse = module.TriangulateOptions()
        options.hand_over({"min_angle": 0.0, "chord_height_relative": 0.005, "allow_missing_faces": True}, coarse)
        surface = module.triangulate(live_shape, coarse, progress, None)
        corners = (np.asarray(surface.vertices) + np.asarray(surface.origin))[np.asarray(surface.triangles)]
        self._box = low, high = corners.min(axis=(0, 1)), corners.max(axis=(0, 1))
        self._size = float(max(high - low))
        self.points, self.areas = _pieces(corners, self._size * _ON_SURFACE)
        self._sampler = module.SizeFieldSampler(tuple(low), tuple(high), _ERROR, _LEAST_DEPTH, _MOST_SAMPLES)
        self._sampler.mark(self.points, np.full(len(self.points), self._size * _ON_SURFACE))
        if not inside:
            self._sampler.restrict_to(self.points, _SURFACE_DEPTH)
        for field in fields:
            points, lengths = field.marks()
            self._sampler.mark(points, np.ascontiguousarray(lengths))
        self._sample()

    samples = property(lambda self: self._sampler.samples)

    def core(self):
        """The octree, as the core has it."""
        return self._field

    def sizes_at(self, points):
        """The least of the fields at points (n, 3), checked: float64 (n,), mm. Beyond the box of the shape, where functions may
        have no meaning, that of the nearest point of the box.
        """
        points = np.clip(points, *self._box)
        found = np.empty(len(points))
        for first in range(0, len(points), _BATCH):
            part = points[first:first + _BATCH]
            self._check_progress()
            sizes = np.full(len(part), np.inf)
            for field in self._fields:
                own = field.sizes(part)
                require_sizes(part, own, f"size_field ({field.name})" if field.name != "size_field" else field.name)
                sizes = np.minimum(sizes, own)
            found[first:first + _BATCH] = sizes
        return found

    def require_affordable(self, most):
        """Raises InvalidInput where the field needs many more triangles than the limit allows."""
        most = most or _MOST_TRIANGLES
        sizes = self._field.at(self.points)
        expected = expected_triangles(self.areas, sizes)
        if expected > 2 * most:
            place = ", ".join(f"{c:.6g}" for c in self.points[int(np.argmin(sizes))])
            raise InvalidInput(f"size_field asks for about {expected:,} triangles, and max_triangles is {most:,}: its least size on the "
                               f"surface is {sizes.min():.4g} mm at ({place}) mm; give larger sizes or a larger max_triangles")

    def measured(self, points, edges):
        """The Measured of edges, rows of two indices of points; by the fields themselves."""
        ends = points[edges]
        middles, lengths = ends.mean(axis=1), np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
        sizes = self.sizes_at(middles)
        ratios = lengths / sizes
        worst = int(np.argmax(ratios)) if len(ratios) else -1
        missed = (ratios > RATIO) & (self._field.at(middles) > 1.1 * sizes)
        return Measured(float(ratios[worst]) if len(ratios) else 0.0, middles[worst] if len(ratios) else np.zeros(3),
                        float((ratios < 0.5).mean()) if len(ratios) else 0.0, len(ratios), middles[missed], sizes[missed])

    def learn(self, measured):
        """Divides the octree where a mesh has shown that it misses features; whether it does."""
        if not len(measured.missed):
            return False
        self._sampler.mark(measured.missed, 0.5 * measured.missed_sizes)
        self._sampler.restart()
        self._sample()
        return True

    def _sample(self):
        while len(points := self._sampler.wanted()):
            self._sampler.give(np.minimum(self.sizes_at(points), 1e300))
        self._field = self._sampler.field()

    def _check_progress(self):
        if self._progress is not None and self._progress(0.0, "sampling the size field") is False:
            raise Cancelled("cancelled")


def meshed(sampling, make, points_and_edges):
    """The mesh of the core that make(octree) returns, measured against the fields; made again with a finer octree where that
    has missed small features. And sentences: why edges are too long, where they are.

    points_and_edges(mesh)  points (n, 3), and edges as rows of two indices
    """
    for times in range(_ROUNDS + 1):
        mesh = make(sampling.core())
        found = sampling.measured(*points_and_edges(mesh))
        if found.ratio <= RATIO or times == _ROUNDS or not sampling.learn(found):
            break
    extension().set_size_ratio(mesh, found.ratio, tuple(found.point), found.short_share)
    return mesh, [] if found.ratio <= RATIO else [_reason(found, getattr(mesh.report, "complete", True))]


def _reason(found, complete):
    place = ", ".join(f"{c:.6g}" for c in found.point)
    if not complete:
        why = "the limit on triangles ended the work: give a larger max_triangles"
    elif len(found.missed):
        why = "there it changes within less than the sampled distances: give a smoother field, or points with sizes"
    else:
        why = "these edges cannot be divided: min_edge, details of the shape or single precision forbid it"
    return f"an edge at ({place}) mm has {found.ratio:.3f} times the length of the size field, as {why}"


def surface_edges(surface):
    """Points and edges of a Surface of the core."""
    return np.asarray(surface.vertices) + np.asarray(surface.origin), _edges(np.asarray(surface.triangles))


def curved_edges(curved):
    """Points and edges between corners of the tetrahedra of a Curved of the core, or of its triangles."""
    elements, corners = (curved.tetrahedra, 4) if len(curved.tetrahedra) else (curved.triangles, 3)
    return np.asarray(curved.nodes), _edges(np.asarray(elements)[:, :corners])


def _edges(elements):
    corners = elements.shape[1]
    pairs = np.concatenate([elements[:, [i, j]] for i in range(corners) for j in range(i + 1, corners)])
    return np.unique(np.sort(pairs, axis=1), axis=0)


def _pieces(corners, length):
    """Triangles (n, 3, 3) divided until their edges are at most that long: centres (m, 3) and areas (m,)."""
    done = []
    for _ in range(12):
        sides = np.linalg.norm(corners - np.roll(corners, -1, axis=1), axis=2)
        longest, i = sides.max(axis=1), sides.argmax(axis=1)
        done.append(corners[longest <= length])
        corners, i = corners[longest > length], i[longest > length]
        if not len(corners):
            break
        rows = np.arange(len(corners))
        a, b, c = (corners[rows, (i + k) % 3] for k in range(3))
        middle = (a + b) / 2
        corners = np.concatenate((np.stack((a, middle, c), axis=1), np.stack((middle, b, c), axis=1)))
    done = np.concatenate((*done, corners))
    areas = np.linalg.norm(np.cross(done[:, 1] - done[:, 0], done[:, 2] - done[:, 0]), axis=1) / 2
    return done.mean(axis=1), areas
