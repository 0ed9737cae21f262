# SPDX-License-Identifier: LGPL-2.1-or-later
"""offset and hollow: solids grown, shrunk, and made walls of."""

from .. import options
from ..compat import extension
from ..errors import InvalidInput
from ..listing import Public
from .booleans import BooleanMesh
from .operands.operands import Operands
from .patches.patches import division_for


class OffsetMesh(BooleanMesh, metaclass=Public):
    """A BooleanMesh that offset or hollow made: closed, manifold, without self-intersections.

    triangle_face    int32 (T,), of a shape: the face on which each triangle lies, or from which it is offset, -1 where that
                     is not known; of a mesh empty
    triangle_source  of a hollowed solid: (0, triangle of its united mesh) of those on its outside that are whole, (1, ...) of
                     those of the hollow, (-1, -1) of those cut at openings; of an offset (-1, -1)
    report           BooleanReport. error_bound, mm, is proven: the distance of no point of the result from the source differs by
                     more from the one asked for, and points that differ by more are on their side of the result, the deviation
                     of the mesh from the shape included. The exact corner of a box can be 1.73 times as far from the result.
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
    values = options.check(options.offset.OFFSET, {"distance": distance, "tolerance": tolerance, "threads": threads})
    if not values["distance"]:
        raise InvalidInput(f"distance = {distance!r}: give a length in mm other than 0")
    options.require_callable(progress)
    return run_offset(Operands([source]), values, progress)


def tolerance_of_offset(operands):
    """A function of options: the tolerance in mm that an offset of these Operands keeps."""
    size = operands.size()

    def kept(values):
        distance = values["distance"] or 0.0
        return values["tolerance"] or min(1e-3 * (size + 2.0 * max(distance, 0.0)), 0.1 * abs(distance))

    return kept


def tolerance_of_hollow(values):
    """The tolerance in mm that hollowing keeps by its options."""
    return values["tolerance"] or (values["thickness"] or 0.0) / 40.0


def run_offset(operands, values, progress=None):
    """The OffsetMesh of a single operand that was read (Operands), with checked options."""
    return OffsetMesh(operands.given_to(lambda core: extension().offset_shape(
        core, values["distance"], values["tolerance"] or 0.0, values.get("threads", 0), progress)),
                      construction=operands.construction(values["distance"]))


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
    values = options.check(options.offset.HOLLOW, {"thickness": thickness, "tolerance": tolerance, "threads": threads})
    if not values["thickness"]:
        raise InvalidInput(f"thickness = {thickness!r}: give a length in mm")
    options.require_callable(progress)
    operands = Operands([source])
    return run_hollow(operands, None if openings is None else _faces_named(operands, source, openings), values, progress)


def run_hollow(operands, faces, values, progress=None):
    """The OffsetMesh of hollowing a single operand that was read (Operands), with checked options.

    faces  indices of the faces of its shape that are open; None: the hollow is closed
    """
    return OffsetMesh(operands.given_to(lambda core: extension().hollow_shape(
        core, values["thickness"], faces, values["tolerance"] or 0.0, values.get("threads", 0), progress)),
                      construction=operands.construction(-values["thickness"], tuple(faces or ())))


def _faces_named(operands, source, names):
    """Indices of the faces of the shape that are named."""
    if isinstance(names, str) or not hasattr(names, "__iter__"):
        raise InvalidInput(f"openings = {names!r}: give a list of faces such as ['Face1', 'Face4']")
    names = list(names)
    # Openings of a mesh are refused by the core.
    found = sorted(division_for(source, {"openings": names}).patch_of) if operands.is_shape(0) else list(range(len(names)))
    if not found:
        raise InvalidInput("openings is an empty list: name the faces, or leave it out for a closed hollow")
    return found
