# SPDX-License-Identifier: LGPL-2.1-or-later
"""cam: a mesh of a solid that lies on one side of it, for machining."""

from .. import options
from ..errors import GeometryError, InvalidInput
from ..listing import Public
from .meshes.surface_mesh import SurfaceMesh
from .offsetting import run_offset
from .operands.operands import Operands, part_of
from .triangulation import triangulate

_SHARES = (0.42, 0.3, 0.2, 0.1)  # distance of the mesh of the shape, as a fraction of the tolerance: coarsest first
_SLACK = 0.98  # of the distance that is left for the offset, which roundings may use up
_MESHING = 0.3  # share of the progress


class CamMesh(SurfaceMesh, metaclass=Public):
    """A SurfaceMesh of a solid on one side of it: closed, manifold, without self-intersections.

    side       "outside": no point of the mesh is in the solid; "inside": none is out of it
    nearest, farthest
               mm: every point of the mesh is at least, and at most, this far from the surface of the solid, on that side; proven
    tolerance  mm, that was given: farthest is at most this
    """

    __slots__ = {"side": '"outside" or "inside"', "nearest": "mm, proven", "farthest": "mm, proven", "tolerance": "mm"}

    def __init__(self, surface, side, distances, tolerance):
        super().__init__(surface)
        self.side, self.tolerance = side, tolerance
        self.nearest, self.farthest = distances


def cam(source, tolerance, side="outside", progress=None):
    """A mesh for machining that never lies on the wrong side of a solid -> CamMesh.

    source     what boolean takes as an operand: a shape, a mesh, arrays (V, F), or a document object
    tolerance  mm: the largest distance of the mesh from the surface of the solid
    side       "outside": no point of the mesh is in the solid, so that a tool that touches the mesh never cuts into it;
               "inside": no point is out of it, so that a mesh for stock or for a core takes no more room than the part
    progress   as for triangulate

    The solid is meshed within c of its surface, and this mesh is offset by half of the tolerance within e: its points are at a distance
    from tolerance / 2 - c - e, which is above 0, to tolerance / 2 + c + e, at most the tolerance. Both c and e are proven, so the side is.
    Gaps narrower than the tolerance may close, inside also walls thinner than it.

    Raises InvalidInput for what is no solid, or where nothing is left of it inside; GeometryError where the side cannot be proven, naming
    the remedy; Cancelled.
    """
    values = options.check(options.cam.CAM, {"tolerance": tolerance, "side": side})
    if not values["tolerance"]:
        raise InvalidInput(f"tolerance = {tolerance!r}: give a length in mm")
    options.require_callable(progress)
    return run_cam(Operands([source]), values, progress)


def run_cam(operands, values, progress=None):
    """The CamMesh of a single operand that was read (Operands), with checked options."""
    if not operands.is_shape(0):
        found = _offset(operands, 0.0, values, progress)
        return found if found is not None else _refuse(values)
    shape = operands.plain(0)
    for share in _SHARES:
        # Angles do not matter to a tool: the fewest triangles.
        mesh = triangulate(shape, chord_height=share * values["tolerance"], min_angle=1.0, overlap="allow",
                           progress=part_of(progress, 0.0, _MESHING))
        found = _offset(Operands([mesh]), mesh.report.max_chord_height, values, part_of(progress, _MESHING, 1.0))
        if found is not None:
            return found
    return _refuse(values)


def _offset(operands, deviation, values, progress):
    """The CamMesh of a mesh that is within `deviation` of the solid; None where that is too coarse."""
    half = 0.5 * values["tolerance"]
    left = _SLACK * (half - deviation)
    if left <= 0.0:
        return None
    distance = half if values["side"] == "outside" else -half
    mesh = run_offset(operands, {"distance": distance, "tolerance": left}, progress)
    if not len(mesh.triangles):
        raise InvalidInput("nothing of the solid is as deep as the tolerance: give a smaller one")
    wrong = mesh.report.error_bound + deviation
    if wrong >= half or mesh.report.faults_left:
        return None
    return CamMesh(mesh._surface, values["side"], (half - wrong, half + wrong), values["tolerance"])


def _refuse(values):
    raise GeometryError(f"it could not be proven that the mesh stays {values['side']} of the solid within {values['tolerance']:g} mm: give a "
                        "larger tolerance, or repair the solid")
