# SPDX-License-Identifier: LGPL-2.1-or-later
"""offset and hollow: solids grown, shrunk, and made walls of."""

import time

import numpy as np

from .. import offset_options, options, phrases
from ..compat import extension
from ..errors import Error, InvalidInput
from ..listing import Public
from .booleans import BooleanMesh
from .operands.operands import Operands, part_of
from .patches.patches import division_for

# Shares of the tolerance: of the mesh of a shape, of the union of what is given, of cutting the hollow out; what is left is
# for the offset.
_CHORD, _UNION, _CUTTING = 0.15, 0.05, 0.05
# Fractions of the progress at which the steps end: meshing, union, offset.
_MESHED, _UNITED, _OFFSET = 0.3, 0.4, 0.9
_SHARE_OF_WALL = 40.0  # the thickness over the tolerance of a wall, where none is given
# Degrees, of the mesh of a shape: needles have short edges, where the raw offset gets many strips; larger bounds take more
# triangles (docs/measurements/offset.md).
_SMALLEST_ANGLE = 1.0
_CLOSED = "the hollow is closed: powder, resin or air cannot leave it; name openings, or cut holes by boolean"
_WHOLE = "there is no hollow: the solid is nowhere thicker than two walls"
_FINEST = 4.0 * 2.0**-23  # tolerance of a Boolean, as a fraction of the size, at least


class OffsetMesh(BooleanMesh, metaclass=Public):
    """A BooleanMesh that offset or hollow made: closed, manifold, without self-intersections.

    triangle_face    int32 (T,), of a shape: the face on which each triangle lies, or from which it is offset, -1 where that
                     is not known; of a mesh empty
    triangle_source  of a hollowed solid: (0, triangle of its united mesh) of those on its outside that are whole, (1, ...) of
                     those of the hollow, (-1, -1) of those cut at openings; of an offset (-1, -1)
    report           BooleanReport. error_bound, mm, is proven: no point of the result is farther than this from the exact
                     one, and none of the exact one farther from the result, the distance of the mesh from the shape included.
                     Where features are smaller than the distance, the second is known at the nodes of a lattice only
    """

    __slots__ = ()


def offset(source, distance, tolerance=None, progress=None, threads=0):
    """All points within a distance of a solid; of a negative distance, those deeper in it than that.

    source     what boolean takes as an operand: a mesh, arrays (V, F), a shape, or a document object
    distance   mm; outward, or inward where it is below 0
    tolerance  mm, the largest distance between the result and the exact offset, in both directions; None: a thousandth of
               the size of the result, at most a tenth of the distance
    progress   callable(fraction 0..1, stage); returning False cancels
    threads    that work at a time; 0: one for each core. The result is the same for any number

    Edges are rounded outward where they are convex and stay sharp where they are concave, as in the exact offset; gaps
    narrower than twice the distance close. Several bodies are united first, small faults of meshes repaired.

    Returns an OffsetMesh, an empty one where nothing is as deep. report says whether the tolerance is met.
    Raises InvalidInput, TopologyError, Cancelled.
    """
    values = options.check(offset_options.OFFSET, {"distance": distance, "tolerance": tolerance, "threads": threads})
    if not values["distance"]:
        raise InvalidInput(f"distance = {distance!r}: give a length in mm other than 0")
    options.require_callable(progress)
    return run_offset(Operands([source]), values, progress)


def run_offset(operands, values, progress=None):
    """The OffsetMesh of Operands, of which there is one, that were read, with checked options."""
    work = _Work(operands, values["distance"], values["tolerance"], values.get("threads", 0), progress, _SMALLEST_ANGLE)
    return work.run(lambda: OffsetMesh(extension().offset_surface(
        work.solid, work.distance, work.share_of_offset(), work.threads, work.before(last=True),
        work.progress(_UNITED, 1.0))))


def hollow(source, thickness, openings=None, tolerance=None, progress=None, threads=0):
    """A solid of which only a wall is left: all of its points that are at most a thickness away from its surface.

    source     what boolean takes as an operand; with openings a shape, or a document object with one
    thickness  mm; the wall grows inward, the outside stays
    openings   names of faces of the shape that get no wall, as in ["Face3", "Face7"]: the hollow reaches them; None: the
               hollow is closed
    tolerance  mm, the largest distance between the result and the exact one; None: a fortieth of the thickness
    progress, threads   as offset has them

    The hollow keeps sharp edges where the outside has convex ones, and is rounded at concave ones. Without openings
    powder or resin stays in the hollow: boolean cuts holes.

    Returns an OffsetMesh: the whole solid where it is nowhere thicker than twice the thickness.
    Raises InvalidInput naming the face and the remedy, TopologyError, Cancelled.
    """
    values = options.check(offset_options.HOLLOW, {"thickness": thickness, "tolerance": tolerance, "threads": threads})
    if not values["thickness"]:
        raise InvalidInput(f"thickness = {thickness!r}: give a length in mm")
    options.require_callable(progress)
    operands = Operands([source])
    return run_hollow(operands, None if openings is None else _faces_named(operands, source, openings), values, progress)


def run_hollow(operands, faces, values, progress=None):
    """The same of Operands, of which there is one, that were read, with checked options.

    faces  indices of the faces of its shape that are open; None: the hollow is closed
    """
    if faces is not None and not operands.is_shape(0):
        raise InvalidInput("openings are faces of a shape, and a mesh is given: hollow it without openings, and cut "
                           "them by boolean")
    tolerance = values["tolerance"] or values["thickness"] / _SHARE_OF_WALL
    work = _Work(operands, values["thickness"], tolerance, values.get("threads", 0), progress, min_angle=None)
    return work.run(lambda: _hollowed(work, faces))


def _faces_named(operands, source, names):
    """Indices of the faces of the shape that are named."""
    if isinstance(names, str) or not hasattr(names, "__iter__"):
        raise InvalidInput(f"openings = {names!r}: give a list of faces such as ['Face1', 'Face4']")
    found = sorted(division_for(source, {"openings": list(names)}).patch_of) if operands.is_shape(0) else names
    if not found:
        raise InvalidInput("openings is an empty list: name the faces, or leave it out for a closed hollow")
    return found


def _hollowed(work, faces):
    module = extension()
    operation, inside = _inside(work, faces)
    work.add(inside.report)
    if not len(inside.triangles):
        work.note(_WHOLE)
    elif faces is None:
        work.note(_CLOSED)
    operands = [(work.solid, False, None)]
    if len(inside.triangles):
        operands.append((inside, False, None))
    result = module.boolean(operands, operation, work.boolean_options(_CUTTING), "exact", work.before(last=True),
                            work.progress(_OFFSET, 1.0))
    module.name_faces(result, [surface for surface, *_ in operands])
    return OffsetMesh(result)


def _inside(work, faces):
    """(the operation that hollows the solid, the core.BooleanSurface that it does so with)."""
    module, watched = extension(), work.progress(_UNITED, _OFFSET)
    how = (work.distance, work.share_of_offset(), work.threads, work.before(), watched)
    if faces is None:
        return "difference", module.offset_surface(work.solid, -work.distance, *how[1:])
    is_open = work.triangles_of(faces)
    if is_open.all():
        raise InvalidInput("all faces are left out: at least one is needed")
    # Plane openings are extended by prisms, so that the hollow is an offset inward. Elsewhere both sides of all walls
    # are offset, which takes many times as long.
    inside = module.hollow_beyond_openings(work.solid, is_open, *how)
    if inside is not None:
        return "difference", inside
    return "intersection", module.thicken_walls(work.solid, is_open, *how)


class _Work:
    """What the steps of an offset share.

    solid  core.BooleanSurface: the union of the operand's bodies, on the faces of the shape

    min_angle  degrees, the bound on the angles of the mesh of a shape; None: that of triangulate
    """

    def __init__(self, operands, distance, tolerance, threads, progress, min_angle):
        self._progress, self._operands, self._min_angle = progress, operands, min_angle
        self.threads, self.distance = threads, distance
        size = self._operands.size()
        # An offset outward is larger than the part: by its own size its triangles are counted.
        self.tolerance = tolerance or min(1e-3 * (size + 2.0 * max(distance, 0.0)), 0.1 * abs(distance))
        self._finest = _FINEST * size
        if self.tolerance > abs(distance):
            raise InvalidInput(phrases.Text(phrases.ABOVE_DISTANCE, length=f"{self.tolerance:g} mm", length2=f"{abs(distance):g} mm"))
        self._error_bound, self._seconds, self._notes, self._cpu_seconds = 0.0, [], [], 0.0
        self._repaired = []

    def run(self, last_steps):
        try:
            self._unite()
            return last_steps()
        except Error as error:
            raise self._operands.explain(error) from error

    def progress(self, low, high):
        return part_of(self._progress, low, high)

    def boolean_options(self, share):
        chosen = extension().BooleanOptions()
        chosen.tolerance = max(share * self.tolerance, self._finest)
        chosen.threads = self.threads
        return chosen

    def _unite(self):
        meshing = extension().BooleanOptions()
        meshing.threads = self.threads
        meshing.tolerance = 2.0 * _CHORD * self.tolerance  # shapes are meshed within half of it
        meshed = self._operands.mesh_shapes(meshing, self.progress(0.0, _MESHED), min_angle=self._min_angle)
        operand, rounded, shape = self._operands.surfaces[0]
        self._error_bound = self._operands.deviation
        self._seconds, self._notes = list(self._operands.seconds), []
        self._cpu_seconds = self._operands.cpu_seconds
        self.solid = extension().boolean([(operand, rounded, None)], "union", self.boolean_options(_UNION), "exact",
                                         self.before(), self.progress(_MESHED if meshed else 0.0, _UNITED))
        extension().name_faces(self.solid, [operand])
        self._seconds, self._notes = [], []
        self.add(self.solid.report)
        if shape is not None:
            self._name_normals(shape)
        self._repaired = [sentence.removeprefix("operand A: ") for sentence in self.solid.report.repaired]
        for sentence in self._repaired:
            self.note(f"repaired before: {sentence}")

    def _name_normals(self, shape):
        """Offsets follow the normals of CAD faces."""
        wall, cpu = time.perf_counter(), time.process_time()
        extension().name_corner_normals(self.solid, shape, self.progress(_UNITED, _UNITED))
        self._seconds.append(("reading the shape", time.perf_counter() - wall))
        self._cpu_seconds += time.process_time() - cpu

    def note(self, sentence):
        """Adds a sentence to the notes of the result."""
        self._notes = [*self._notes, sentence]

    def add(self, report):
        """Takes over what the report of a step says."""
        self._error_bound = report.error_bound
        self._seconds = list(report.seconds.items())
        if report.triangles:  # of a step without a result it is the last one that tells what is left
            self._notes = report.notes
        self._cpu_seconds = report.cpu_seconds

    def before(self, last=False):
        """core.WorkBefore for the next step."""
        before = extension().WorkBefore()
        before.seconds, before.notes, before.cpu_seconds = self._seconds, self._notes, self._cpu_seconds
        before.error_bound = self._error_bound
        before.repaired = self._repaired if last else []
        before.tolerance = self.tolerance if last else 0.0
        return before

    def share_of_offset(self):
        """mm, the tolerance that meshing, union and cutting have left."""
        left = (1.0 - _UNION - _CUTTING) * self.tolerance - self._error_bound
        if left <= 0.0:
            raise InvalidInput(f"the mesh that was made of the operand deviates by up to {self._error_bound:.4g} mm, and the "
                               f"tolerance is {self.tolerance:.4g} mm: give a larger tolerance")
        return left

    def triangles_of(self, faces):
        """bool (T,): the triangles of the solid that lie on some faces."""
        return np.isin(np.asarray(self.solid.triangle_face), faces)
