# SPDX-License-Identifier: LGPL-2.1-or-later
"""follow: the triangles of a mesh, moved along with an edit of its part."""

import numpy as np

from ... import options
from ...compat import extension
from ...errors import Cancelled, GeometryError, InvalidInput, TopologyError
from ..brep.construction import Construction
from ..meshes.surface_mesh import SurfaceMesh
from ..patches.patches import kept
from ..places.entities import Entities, differences
from ..places.places import Places, unfit
from ..sources import convert
from ..triangulation import triangulate
from .angles import Angles
from .moving import moved

_OTHERWISE = "remesh", "refuse"
_NAMED = 8  # faces that a reason names
_OF_EXEMPT = 0.9  # fraction of its angle that a triangle keeps that was exempt from the bound


class FollowedMesh(SurfaceMesh):
    """A SurfaceMesh of a part that was edited.

    kept     whether it has the triangles of the mesh before, in the same order and with the same numbers of vertices
    reasons  list of sentences: why the shape was meshed again; empty where the triangles were kept
    """

    __slots__ = {"kept": "whether the triangles are those of the mesh before", "reasons": "why they are not"}

    def __init__(self, surface, patches, overlap, construction, reasons):
        super().__init__(surface, patches, overlap, construction)
        self.kept, self.reasons = not reasons, reasons


def follow(mesh, shape, min_angle=None, chord_height=None, otherwise="remesh", progress=None, **values):
    """The triangles of a mesh, moved along with an edit of its part: a FollowedMesh.

    mesh          SurfaceMesh of triangulate, or of follow
    shape         Part.Shape, or a document object that has one: the part after the edit
    min_angle     degrees; None: the bound of the mesh
    chord_height  mm, the largest distance from the shape; "none": no bound; None: that of the mesh
    otherwise     where the triangles cannot be kept: "remesh" the shape, or "refuse"
    progress      as for triangulate
    values        other options of triangulate, where the shape is meshed again

    Where the shape has the same faces, edges and vertices as before, points on edges keep their share of the parameter, and inner
    points of faces their (u, v) but for the change at the edges, which is continued inwards. Points of triangles below the bound are
    moved within their faces and edges. Then everything is measured anew: angles, distance, whether it is closed and crosses itself.
    Raises InvalidInput for meshes of other functions; with "refuse" TopologyError or GeometryError naming the faces; Cancelled.
    """
    if otherwise not in _OTHERWISE:
        raise InvalidInput(f"otherwise = {otherwise!r} is not allowed: it must be one of {', '.join(map(repr, _OTHERWISE))}")
    options.require_callable(progress)
    asked = mesh_bounds(mesh, min_angle, chord_height)
    live_shape = convert.shape_of(shape)
    surface, reasons, error = _followed(mesh, live_shape, asked, progress)
    division = None if mesh._patches is None else mesh._patches.division
    if not reasons:
        return FollowedMesh(surface, kept(division, surface), mesh._overlap, Construction((live_shape,)), reasons)
    if otherwise == "refuse":
        raise error(f"the triangles cannot be kept: {'; '.join(reasons)}: leave otherwise= out and the shape is meshed again")
    made = triangulate(shape, min_angle=asked["min_angle"], chord_height=asked["chord_height"] or "none", progress=progress, **values)
    return FollowedMesh(made._surface, kept(division, made._surface), made._overlap, made._construction, reasons)


def mesh_bounds(mesh, min_angle=None, chord_height=None):
    """The bounds on angles and distance as {option: plain value}; 0: none. Raises InvalidInput unless triangulate made the mesh."""
    shape_of_mesh(mesh)
    table = [option for option in options.TRIANGULATE if option.name in ("min_angle", "chord_height")]
    given = {option.name: option.checked(value) for option, value in zip(table, (min_angle, chord_height)) if value is not None}
    if given.get("chord_height") == options.NO_BOUND:
        given["chord_height"] = 0.0
    return {"min_angle": mesh.report.min_angle_asked, "chord_height": mesh.report.chord_height_asked, **given}


def shape_of_mesh(mesh):
    """The Part.Shape that a mesh was made of. Raises InvalidInput unless triangulate or follow made it."""
    construction = getattr(mesh, "_construction", None)
    source = construction.sources[0] if construction is not None and len(construction.sources) == 1 else None
    if not hasattr(source, "Faces") or construction.distance or not len(getattr(mesh, "vertex_entity", ())):
        raise InvalidInput(f"follow needs a SurfaceMesh that triangulate made of a shape, not {type(mesh).__name__}")
    return source


def _followed(mesh, shape, asked, progress):
    """(Surface, reasons, error that they are): the triangles on the shape; reasons why they do not serve."""
    before, after = Entities(shape_of_mesh(mesh)), Entities(shape)
    reasons = unfit(mesh) + differences(before, after)
    if reasons:
        return None, _shortened(reasons), TopologyError
    places = Places(mesh, before)
    points, uv = moved(places, after)
    limits = _limits(mesh, asked["min_angle"])
    angles = Angles(places, after, points, uv, limits)
    angles.improve(lambda: _tell(progress))
    points = np.float32(angles.points - mesh.origin).astype(np.float64)
    angles.points = points + mesh.origin
    measured = angles.measured()
    found = _by_face(mesh, measured <= 0.0, "{} of {} would be turned over")
    found += _by_face(mesh, (measured > 0.0) & (measured < limits), f"{{}} of {{}} would have an angle below {asked['min_angle']:.4g} degrees")
    if found:
        return None, found, GeometryError
    surface = extension().with_vertices(mesh._surface, points, shape, asked["min_angle"], asked["chord_height"], progress)
    return surface, _findings(mesh, surface, asked), GeometryError


def _tell(progress):
    if progress is not None and progress(0.3, "following the shape") is False:
        raise Cancelled()


def _limits(mesh, min_angle):
    """Degrees, by triangle: the bound, and of triangles that were exempt from it a share of what they have."""
    limits = np.full(len(mesh.triangles), float(min_angle))
    exempt = np.array([triangle for triangle, _ in mesh.report.exempt], dtype=int)
    if len(exempt):
        own = extension().triangle_shapes(mesh._surface)[0][exempt]
        limits[exempt] = np.minimum(min_angle, _OF_EXEMPT * own)
    return limits


def _by_face(mesh, bad, sentence):
    faces, counts = np.unique(mesh.triangle_face[bad], return_counts=True)
    return _shortened([sentence.format(f"{count} triangle{'s' if count > 1 else ''}", f"Face{face + 1}")
                       for face, count in zip(faces.tolist(), counts.tolist())])


def _findings(mesh, surface, asked):
    """Sentences: which promises of the mesh the moved one does not keep."""
    old, new, found = mesh.report, surface.report, []
    if asked["chord_height"] and new.max_chord_height > asked["chord_height"]:
        face = mesh.triangle_face[new.max_chord_triangle] + 1
        found.append(f"the distance from the shape would be {new.max_chord_height:.4g} mm at Face{face}, more than {asked['chord_height']:.4g} mm")
    if old.closed and not new.closed or new.degenerate_triangles > old.degenerate_triangles:
        found.append("the mesh would not be closed and without degenerate triangles")
    if new.self_intersections > max(old.self_intersections, 0):
        found.append(f"{new.self_intersections} pairs of triangles would cross")
    if old.closed and old.volume * new.volume < 0.0:
        found.append("the mesh would be inside out")
    return found


def _shortened(sentences):
    rest = len(sentences) - _NAMED
    return sentences if rest <= 0 else [*sentences[:_NAMED], f"and {rest} more"]
