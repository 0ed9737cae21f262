# SPDX-License-Identifier: LGPL-2.1-or-later
"""The numbers behind the quality view: what is measured, element by element. No windows here."""

from dataclasses import dataclass, replace
from functools import cached_property, partial

import FreeCAD
import numpy as np

from .. import fault_phrases, phrases
from ..compat import extension, property_of
from ..core.certify.faults import find_faults
from ..core.colour_scale import GREEN
from ..core.curving import holds_elements, taken_from
from ..core.inspect.thickness import thickness
from ..core.measures import MeasureTable
from ..core.measures import measures as measured_table
from ..core.meshes.surface_mesh import SurfaceMesh
from ..core.patches.patches import patches_of
from ..core.sources import convert, frames
from ..errors import InvalidInput
from ..features import mesh_object
from ..features.deviation import colour_limit, is_of_points
from ..features.properties import exempt_reasons
from .element_measures import measures_of
from .patch_colours import division_of
from .quality_measure import Measure
from .quantities import Unit, in_locale, number_of, value_of

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

BARS = 40
_MANY, COARSE = 200_000, 50_000  # triangles from which on others stand for them; about how many


class Scale:
    """How the values of a measure are coloured and written.

    measure
    low, high  ends of what is shown
    unbounded  how many values are infinite and not bad, such as where there is no wall: they have a colour of their own
    bound      what the values were to keep within: red is beyond it, green is at it; None: the largest
               value is red, where the measure has no number for that
    Made on any thread; its texts are for the window's.
    """

    def __init__(self, measure, values, bound=None):
        self.measure, self.bound = measure, bound
        finite = values[np.isfinite(values)]
        self.unbounded = int(np.count_nonzero(values == np.inf)) if measure.low_is_bad else 0
        worst = max(float(finite.max(initial=measure.good)), bound or 0.0, measure.good + 1e-12)
        self._bad = worst if measure.bad is None else measure.bad
        self.low, self.high = sorted((self._bad, measure.good))

    @cached_property
    def _length_unit(self):
        return Unit.of(self.high) if self.measure.unit is None else None

    @property
    def unit(self):
        """The unit that follows a number."""
        return self.measure.unit if self._length_unit is None else f" {self._length_unit.name}"

    def number(self, value, digits=4):
        """A value without its unit."""
        factor = 1.0 if self._length_unit is None else self._length_unit.factor
        return "∞" if np.isinf(value) else in_locale(f"{value / factor:.{digits}g}")

    def text(self, value):
        """A value with its unit."""
        return self.number(value) + ("" if np.isinf(value) else self.unit)

    def value_of(self, text):
        """The value of a number that is written without a unit or with one; None where it is none."""
        if self._length_unit is not None:
            plain = number_of(text)
            return value_of(text) if plain is None else plain * self._length_unit.factor
        return number_of(text.strip().removesuffix(self.unit.strip()))

    def within(self, low, high):
        """The Scale of the same values with other ends."""
        ends = (low, high) if self.measure.low_is_bad else (high, low)
        found = Scale(replace(self.measure, bad=ends[0], good=ends[1]), np.zeros(0))
        found.unbounded = self.unbounded
        return found

    def goodness(self, values):
        """float64: 0 where bad, 1 where good; not a number where a value is infinite and not bad."""
        if self.measure.low_is_bad:
            values = np.where(np.isposinf(values), np.nan, values)
        if self.measure.is_signed:
            return np.interp(values, (self.low, 0.0, self.high), (1.0, GREEN, 0.0))
        if self.bound is not None:
            inside = 1.0 - (1.0 - GREEN) * np.asarray(values) / self.bound
            return np.where(inside >= GREEN * (1.0 - 1e-9), inside, 0.0)
        return np.clip((values - self._bad) / (self.measure.good - self._bad), 0.0, 1.0)


MIN_ANGLE = Measure(
    QT_TRANSLATE_NOOP("MeshQuality", "Smallest angle"),
    QT_TRANSLATE_NOOP("MeshQuality", "60° is ideal; angles of a few degrees harm simulations."),
    "°", 0.0, 60.0, lambda data, _: data.shapes()[0])
ASPECT = Measure(
    QT_TRANSLATE_NOOP("MeshQuality", "Longest edge / shortest edge"),
    QT_TRANSLATE_NOOP("MeshQuality", "1 is ideal: all edges of an element have the same length."),
    "", 10.0, 1.0, lambda data, _: data.shapes()[1])
DISTANCE = Measure(
    QT_TRANSLATE_NOOP("MeshQuality", "Max. deviation"),
    QT_TRANSLATE_NOOP("MeshQuality", "Largest distance between each triangle and the source."),
    None, None, 0.0, lambda data, progress: data.distances(progress))
# Red outside, green on the surface, blue inside; ends at the tolerance, see deviation_scale.
DEVIATION = Measure(
    QT_TRANSLATE_NOOP("MeshQuality", "Deviation from the part"),
    QT_TRANSLATE_NOOP("MeshQuality", "Signed distance from the part: red outside, blue inside."),
    None, 1.0, -1.0, lambda data, _: data.deviations)
# Ends at twice the median, as what is thick depends on the part: see thickness_scale.
THICKNESS = Measure(
    QT_TRANSLATE_NOOP("MeshQuality", "Wall thickness"),
    QT_TRANSLATE_NOOP("MeshQuality", "Diameter of the largest ball in the solid that touches the surface there; "
                                     "∞ = no wall."),
    None, 0.0, 1.0, lambda data, progress: data.thicknesses(progress))
# The inverse is what is called a quality: a fifth is what a corner of 7 degrees has.
DISTORTION = Measure(
    QT_TRANSLATE_NOOP("MeshQuality", "Shape distortion"),
    QT_TRANSLATE_NOOP("MeshQuality", "Deviation from equal sides and angles: 1 = ideal, 5 = poor, ∞ = folded."),
    "", 5.0, 1.0, lambda data, progress: data.distortions(progress),
    lambda data, progress: data.distortions_of_all(progress))
JACOBIAN = Measure(
    QT_TRANSLATE_NOOP("MeshQuality", "Scaled Jacobian"),
    QT_TRANSLATE_NOOP("MeshQuality", "1 = undistorted by its curvature, ≤ 0 = invalid."),
    "", 0.0, 1.0, lambda data, _: data.jacobians, lambda data, _: data.jacobians_of_all())


def thickness_scale(values):
    """The Scale of thicknesses: up to twice the median, as what is thick depends on the part."""
    finite = values[np.isfinite(values)]
    return Scale(replace(THICKNESS, good=2.0 * float(np.median(finite)) if len(finite) else 1.0), values)


def deviation_scale(limit):
    """The Scale of deviations between -limit and limit, mm."""
    return Scale(replace(DEVIATION, bad=limit, good=-limit), np.zeros(0))


@dataclass(frozen=True)
class Histogram:
    """How many elements lie in each of BARS equal parts from `low` to `high`; those beyond are in
    the first and the last bar, those with a colour of their own in none, see Scale.
    """

    low: float
    high: float
    bar: np.ndarray  # by element; -1: in no bar
    counts: np.ndarray

    @classmethod
    def of(cls, values, scale):
        low, high = scale.low, scale.high
        part = (np.nan_to_num(values, nan=low, posinf=high, neginf=low) - low) / (high - low)
        bar = np.clip((part * BARS).astype(int), 0, BARS - 1)
        known = ~np.isnan(values) if not scale.unbounded else np.isfinite(values)
        return cls(low, high, np.where(known, bar, -1), np.bincount(bar[known], minlength=BARS))

    def edges(self):
        """The BARS + 1 numbers between which the bars lie."""
        return np.linspace(self.low, self.high, BARS + 1)


@dataclass(frozen=True)
class FaceRow:
    """One CAD face, or one patch where the mesh has such: its index and name, how many elements lie on it, their worst
    value, and the mean of those that have a finite one.
    """

    face: int
    name: str
    elements: int
    worst: float
    mean: float


class QualityData:
    """The elements of a mesh object or a link to one, see frames, taken from it once; later changes do not show.

    After prepare(), which any thread may call, there are
    corners   float32 (T, 3, 3): the triangles that are drawn, in the document's frame
    element   int (T,): the element that each of them is a part of
    face      int (E,): the CAD face of each element, -1 where there is none
    group     int (E,): the patch of each element; of a mesh without patches the same as `face`
    patches   the names of the patches; empty where the mesh has none
    jacobians float64 (E,), of curved elements only
    coarse    float32 (n, 3, 3): triangles that look like those of `corners` from afar; None where
              there are few of these
    lines     (float32 (P, 3), int32 runs ended by -1): the elements' edges, made when they are first
              asked for, which takes a second for a million triangles
    tetrahedra  how many a volume mesh has, else 0; `shown` of them are at the surface, which is
              what the elements are then
    and before it already
    measures  those that make sense here
    bound     distance in mm that the mesh was to keep within, or None
    """

    def __init__(self, source):
        obj = frames.linked_of(source)[0]
        self._shape = _shape_behind(source, obj)
        self.corners = self._curved = None
        if obj.Mesh.CountFacets == 0:
            raise InvalidInput(phrases.Text(phrases.NO_TRIANGLES, name=obj.Label))
        self._why = exempt_reasons(obj)
        self._division = division_of(obj)
        asked = "AskedChordHeight" in obj.PropertiesList and property_of(obj, "AskedChordHeight").Value
        self.bound = asked or None
        self.tetrahedra = self.shown = 0
        if holds_elements(source):
            self.measures = [JACOBIAN, DISTORTION]
            self._prepare = partial(self._take_curved, taken_from(source),
                                    property_of(obj, "ShownDeviation").Value)
        elif is_of_points(obj):
            self.measures, self.deviations, self._limit = [DEVIATION], np.array(obj.Deviations), colour_limit(obj)
            self._prepare = partial(self._take_flat, convert.MeshCopy(source), list(obj.FaceRuns))
        else:
            self.measures = [MIN_ANGLE, ASPECT, DISTORTION, *([DISTANCE] if self._shape is not None else []), THICKNESS,
                             *measures_of(MeasureTable.names_of(("triangle",)))]
            self._prepare = partial(self._take_flat, convert.MeshCopy(source),
                                    list(getattr(obj, "FaceRuns", [])))

    def prepare(self):
        """Makes what is drawn; once."""
        if self.corners is None:
            self._prepare()
            self.group, self.patches = self.face, ()
            if self._division is not None and len(self.face):
                found = patches_of(self._division, self.face, len(self.face))
                self.group, self.patches = found.of_triangle, found.names
            self.coarse = None
            if len(self.corners) > _MANY:
                self.coarse, self._joined = extension().clustered(self.corners, COARSE)

    def _take_flat(self, mesh, runs):
        vertices, triangles = mesh.arrays
        self._surface = convert.surface_of_arrays(extension(), vertices, triangles, measured=False)
        self._made_table = lambda: MeasureTable(vertices, [("triangle", triangles)], self.face)
        self._measured = lambda: convert.surface_of_arrays(extension(), vertices, triangles)
        self.corners = vertices[triangles].astype(np.float32)
        self.element = np.arange(len(triangles))
        face = mesh_object.faces_of_runs(runs, len(triangles))
        self.face = face if len(face) else np.full(len(triangles), -1)
        self._lines = lambda: (vertices.astype(np.float32), runs_of_edges(triangles))
        self._shapes = None

    def _take_curved(self, taken, deviation):
        curved = taken()
        shown = curved.tessellate(deviation)
        surface = shown.surface()
        points = (np.asarray(surface.vertices) + surface.origin).astype(np.float32)
        self.corners = points[surface.triangles]
        self.element = np.array(shown.element)
        self.face = np.array(curved.triangle_face)
        self._lines = lambda: (points, np.array(shown.edge_lines, dtype=np.int32))
        self.jacobians = np.array(curved.shown_quality)
        self._curved, self._made_table = curved, lambda: measured_table(curved)
        self.tetrahedra = len(curved.tetrahedra)
        self.shown = curved.tetrahedra_at_surface() if self.tetrahedra else 0

    @cached_property
    def lines(self):
        """(points, runs), see above."""
        return self._lines()

    @cached_property
    def table(self):
        """The MeasureTable of all elements, of a volume mesh also of those inside."""
        return self._made_table()

    @property
    def has_lines(self):
        """Whether the lines are made."""
        return "lines" in vars(self)

    def coarse_colours(self, colours):
        """uint8 (n, 4): the mean of the colours, uint8 (T, 4), of the triangles that each of `coarse`
        stands for.
        """
        stands = self._joined >= 0
        joined, count = self._joined[stands], len(self.coarse)
        sums = [np.bincount(joined, weights=colours[stands, k], minlength=count) for k in range(4)]
        members = np.bincount(joined, minlength=count)
        return np.rint(np.column_stack(sums) / members[:, None]).astype(np.uint8)

    @property
    def curved(self):
        """Whether the elements are curved ones."""
        return self._curved is not None

    @property
    def solid(self):
        """What ElementMesh.of makes the volume elements of; None of a surface."""
        return self._curved if self.tetrahedra else None

    @property
    def elements(self):
        """The number of elements."""
        return len(self.face)

    def shapes(self):
        """(smallest angles, aspects, distortions) of the triangles."""
        if self._shapes is None:
            self._shapes = extension().triangle_shapes(self._surface)
        return self._shapes

    def distortions(self, progress=None):
        """How far each element's shape is from the regular one, 1 is best; infinite: it folds."""
        if self._curved is not None:
            return self._curved.shown_distortion(progress)
        return self.shapes()[2]

    def distortions_of_all(self, progress=None):
        """The distortion of each tetrahedron; empty without tetrahedra."""
        return self._curved.tetrahedron_distortion if self.tetrahedra else np.zeros(0)

    def jacobians_of_all(self):
        """float64: the scaled Jacobian of each tetrahedron; none without them."""
        return self._curved.tetrahedron_quality

    def scale(self, measure, values):
        """The Scale of these values of a measure."""
        if measure is THICKNESS:
            return thickness_scale(values)
        if measure is DEVIATION:
            return deviation_scale(self._limit)
        return Scale(measure, values, self.bound if measure is DISTANCE else None)

    def distances(self, progress=None):
        """The largest distance of each triangle from the shape that was meshed, mm."""
        return extension().triangle_deviations(self._surface, self._shape, progress)

    def faults(self, progress=None):
        """[core.faults.Faults, ...] of flat triangles, see core.faults."""
        return find_faults(self._surface, progress)

    def thicknesses(self, progress=None):
        """How thick the wall behind each triangle is, mm, by spheres; infinite where there is no wall."""
        mesh = SurfaceMesh(self._measured())
        if not mesh.report.closed:
            raise InvalidInput(phrases.Text(fault_phrases.NO_THICKNESS_OPEN, count=f"{mesh.report.border_edges:,}"))
        found = thickness(mesh, progress=progress)
        if not np.array_equal(found.mesh.triangles, mesh.triangles):
            faults = [kind.words() for kind in self.faults(progress)]
            raise InvalidInput(phrases.Text(fault_phrases.NO_THICKNESS_FAULTS, list=faults))
        return np.where(found.is_wall, found.values, np.inf)

    def faces(self, values, measure):
        """A FaceRow for each CAD face or patch, the worst first."""
        order = np.argsort(self.group, kind="stable")
        faces, starts, counts = np.unique(self.group[order], return_index=True, return_counts=True)
        finite = np.where(np.isfinite(values), values, 0.0)[order]
        sums = np.add.reduceat(finite, starts)
        known = np.maximum(np.add.reduceat(np.isfinite(values[order]).astype(int), starts), 1)
        # The first element of each face in the order of faces, and in each the worst first.
        by_face = np.lexsort((-measure.badness(values), self.group))
        worst = values[by_face][starts]
        rows = [FaceRow(int(f), self.patches[f] if self.patches else f"Face{f + 1}", int(n), float(w), float(s / k))
                for f, n, w, s, k in zip(faces, counts, worst, sums, known) if f >= 0]
        return [rows[i] for i in measure.order(np.array([row.worst for row in rows]))]

    def marked(self, measure, values):
        """bool (E,): which elements light up by themselves."""
        return np.zeros(self.elements, dtype=bool)

    def is_inside(self, element):
        """Whether the surface that is drawn hides the element from all sides."""
        return False

    def remark(self):
        """A text on all elements beside the numbers."""
        return ""

    def place(self, element):
        """Words for where an element lies."""
        face = self.face[element]
        if face < 0:
            return translate("MeshQuality", "element {0}").format(element)
        return translate("MeshQuality", "element {0} on {1}").format(element, f"Face{face + 1}")

    def reason(self, element):
        """Why the mesher could not do better there, or an empty text."""
        return self._why.get(int(element), "")

    def triangles_of(self, chosen):
        """Those drawn triangles, float32 (n, 3, 3), that belong to elements chosen by a mask."""
        return self.corners[chosen[self.element]]


def _shape_behind(source, obj):
    """The shape that the mesh object was made of, where the source has it; None where there is none, or more than one."""
    proxy = getattr(obj, "Proxy", None)
    made_of = proxy.sources(obj)[0] if isinstance(proxy, mesh_object.SourceMesh) else None
    if made_of is None or getattr(frames.leaf_of(source), "ElementCount", 0):
        return None
    shape = convert.shape_of(made_of)
    if obj != source:
        shape.transformShape(frames.relative_motion(frames.placement_of(obj), frames.placement_of(source)).toMatrix(), False)
    return convert.taken(shape)


def runs_of_edges(triangles):
    """int32: each edge of the triangles once, as two indices and -1."""
    return runs_of_sides(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2))


def runs_of_sides(sides):
    """int32: each of the sides, (n, 2), once, as two indices and -1."""
    sides = np.sort(sides.astype(np.int64), axis=1)
    keys = np.unique(sides[:, 0] << 32 | sides[:, 1])
    runs = np.column_stack((keys >> 32, keys & 0xffffffff, np.full(len(keys), -1)))
    return runs.ravel().astype(np.int32)
