# SPDX-License-Identifier: LGPL-2.1-or-later
"""BooleanMesh: a Boolean of closed meshes, and how it is made."""

from .. import options
from ..compat import extension
from ..errors import InvalidInput
from .meshes.surface_mesh import SurfaceMesh
from .operands.operands import Operands


class BooleanMesh(SurfaceMesh):
    """A SurfaceMesh that tells where its triangles come from.

    triangle_source  int32 (T, 2): operand (0, 1, ...) and triangle there of each triangle that is
                     an operand's own, bit for bit, turned around where an operand was subtracted;
                     (-1, -1) of those made or changed
    report           BooleanReport: a MeshReport with method ("exact" or "uniform"), error_bound, retained,
                     reconstructed, repaired, guessed_share, operand_components, operand_euler

    vertices, origin, triangles, to_mesh and write are those of a SurfaceMesh; triangle_face and
    vertex_entity are empty.
    """

    __slots__ = ()

    triangle_source = property(lambda self: self._surface.triangle_source, doc="int32 (T, 2)")


def boolean(a, b=None, operation=None, resolution=512, tolerance=None, progress=None,
            method="default", threads=0, full=False):
    """Joins, intersects or subtracts closed meshes and shapes.

    a, b        operands: Mesh.Mesh, SurfaceMesh, arrays (V, F), Part.Shape, or document objects
                with a mesh or a shape, taken where the document has them. Or `a` is a list of any
                number of operands and b is left out: the operation is applied from the first on
    operation   "union", "intersection", "difference" or "symmetric_difference"
    resolution  cells along the longest side of all operands, or along 8 times the mean thickness (2 V / A) of the
                thinnest one where that is less, though not below a sixteenth of that side; the tolerance is then
                sqrt(3) times such a cell (method "uniform": a cell of its grid along the longest side, which has free
                cells around them)
    tolerance   mm; largest distance of the result from the exact one
    progress    callable(fraction 0..1, stage); returning False cancels
    method      "exact": triangles are divided along the exact intersection; "uniform": operands are sampled
                along rays (Wang 2010), open ones by their winding number; "default": exact, and uniform where
                the operands have no exact result, which report.method and a note tell
    threads     that work at a time; 0: one for each core. The result is the same for any number
    full        True: method "uniform" makes the whole surface anew from the samples, so that no triangle of an
                operand stays (Wang 2010, Table III). Other methods refuse it

    Shapes are meshed first, within a quarter of the tolerance; a sixteenth for method "uniform", whose rays
    meet the CAD faces themselves. Where no tolerance is given, they are meshed as fine as keeps the volume of each to
    0.2 %, too. Operands with small faults (holes,
    duplicate, flipped or degenerate triangles, self-intersections) are repaired, which the report
    tells. Where no repair closes an operand, method "uniform" takes for its inside where its generalised
    winding number is at least 0.5; report.guessed_share is the share of the surface that this made.

    report.error_bound of method "uniform" is the largest distance found between the result and the exact one of
    these meshes, both ways; where something is lost between rays it is above the tolerance.

    Returns a BooleanMesh; an empty one where nothing is left.
    Raises InvalidInput naming the operand, the defect and the remedy; Cancelled; with method "exact" also
    TopologyError, where the operands have no exact result.
    """
    if isinstance(b, str):
        raise InvalidInput(f"b = {b!r} is no operand: with a list of operands give operation={b!r}")
    if b is None and not isinstance(a, (list, tuple)):
        raise InvalidInput("a second operand is needed: give a and b, or a list of operands")
    values = options.check(options.BOOLEAN, {
        "operation": operation, "resolution": resolution, "tolerance": tolerance,
        "method": method, "full": full,
    })
    values["threads"] = options.THREADS.checked(threads)
    options.require_callable(progress)
    sources = list(a) if b is None else [a, b]
    if not sources:
        raise InvalidInput("the list of operands is empty")
    return run(Operands(sources), values, progress)


def tolerance_for(operands):
    """A function of checked options: the tolerance in mm that a Boolean of these Operands keeps."""
    size, length = operands.size(), operands.divided_length()
    return lambda values: _core_options(values).tolerance_for(size if values["method"] == "uniform" else length)


def _core_options(values):
    core_options = extension().BooleanOptions()
    core_options.resolution = values["resolution"]
    core_options.tolerance = values["tolerance"] or 0.0
    core_options.threads = values.get("threads", 0)
    core_options.full = values["full"]
    return core_options


def run(operands, values, progress=None):
    """The BooleanMesh of operands that were read, with checked options."""
    return BooleanMesh(operands.given_to(lambda core: extension().boolean(
        core, values["operation"], _core_options(values), values["method"], progress)), construction=operands.construction())
