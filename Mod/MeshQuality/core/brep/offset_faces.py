# SPDX-License-Identifier: LGPL-2.1-or-later
"""The faces of the offset surface of a shape, untrimmed against each other: those of faces, of edges and of vertices."""

import math

import FreeCAD
import Part

_SMOOTH = 1e-4  # sine of the angle of normals below which an edge is smooth
_STEP = 1e-4  # of the length of an edge, by which its sides are told
_FIT = 1e-5  # of the distance: a face that OpenCASCADE offset is where it should be within this
_SPHERE_U, _SPHERE_V = math.radians(100), math.radians(80)  # half angles of the patch of a sphere about a vertex


def offset_faces(shape, distance, left_out=()):
    """[Part.Face, ...] that together contain the boundary of the offset by a signed distance, mm, away from the faces left out.

    Each point of that boundary is nearest to a face, an edge or a vertex of the shape: it lies on the face moved along its normals, on
    a cylinder or torus about the edge, or on a sphere about the vertex. Edges are straight or circular; those of other kinds, tips of
    cones, and faces that OpenCASCADE cannot offset have none.
    """
    offset = [face for i, face in enumerate(shape.Faces) if i not in left_out]
    found = [moved for moved in (_moved(face, distance) for face in offset) if moved is not None]
    tubes = {}  # by the hash of a vertex, the normals at the rounded edges that end there
    for edge, sides in _edges_between(offset):
        normals = _rounded(edge, sides, distance)
        if normals is None:
            continue
        tube = _tube(edge, normals, abs(distance))
        if tube is not None:
            found.append(tube)
        for vertex in edge.Vertexes:
            tubes.setdefault(vertex.hashCode(), (vertex, []))[1].append(normals)
    for edge, side, opening in _edges_of_openings(offset, [shape.Faces[i] for i in left_out]):
        directions = _rim(edge, side, opening, distance)
        tube = None if directions is None else _tube(edge, directions, abs(distance))
        if tube is not None:
            found.append(tube)
    for vertex, ends in tubes.values():
        if len(ends) > 2:
            found.append(_sphere(vertex.Point, sum((normal for pair in ends for normal in pair), FreeCAD.Vector()), abs(distance)))
    return found


def _moved(face, distance):
    """A face moved along its normals; None where nothing of it is left."""
    u, v = _middle(face)
    normal = face.normalAt(u, v)
    if isinstance(face.Surface, Part.Plane):
        return face.translated(distance * normal)
    goal = Part.Vertex(face.valueAt(u, v) + distance * normal)
    for signed in (distance, -distance):
        try:
            made = face.makeOffsetShape(signed, 1e-7)
        except Part.OCCError:
            continue
        if made.Faces and made.distToShape(goal)[0] < _FIT * abs(distance):
            return made.Faces[0]
    return None


def _middle(face):
    """Parameters (u, v) of a point within a face."""
    u1, u2, v1, v2 = face.ParameterRange
    steps = [(i + 0.5) / 8 for i in (4, 3, 5, 2, 6, 1, 7, 0)]
    inside = ((u1 + a * (u2 - u1), v1 + b * (v2 - v1)) for a in steps for b in steps)
    return next(((u, v) for u, v in inside if face.isPartOfDomain(u, v)), (0.5 * (u1 + u2), 0.5 * (v1 + v2)))


def _edges_between(faces):
    """(edge, [face, face]) of the edges between two of the faces."""
    sides = {}
    for face in faces:
        for edge in face.Edges:
            if not edge.Degenerated:
                same = sides.setdefault(edge.hashCode(), (edge, []))[1]
                if not any(face.isSame(other) for other in same):
                    same.append(face)
    return [entry for entry in sides.values() if len(entry[1]) == 2]


def _edges_of_openings(faces, openings):
    """(edge, face, opening) of the edges between one of the faces and an opening."""
    around = {edge.hashCode(): opening for opening in openings for edge in opening.Edges}
    return [(edge, face, around[edge.hashCode()]) for face in faces for edge in face.Edges
            if not edge.Degenerated and edge.hashCode() in around]


def _rim(edge, side, opening, distance):
    """The two directions, of length 1, between which the offset of a face is round about its edge at an opening, at the beginning of
    the edge; None where they meet at a right angle or less, so that nothing of the solid lies beyond the edge.
    """
    if -_into(edge, side, 0.5).dot(_into(edge, opening, 0.5)) < _SMOOTH:
        return None
    normal, = _normals(edge, [side], 0.0)
    return [math.copysign(1.0, distance) * normal, _into(edge, opening, 0.0)]


def _into(edge, face, fraction):
    """The direction, of length 1, from a point of an edge, at a fraction of its parameters, into a face beside it."""
    (middle,), (normal,) = _normals(edge, [face], 0.5), _normals(edge, [face], fraction)
    at = [edge.FirstParameter + part * (edge.LastParameter - edge.FirstParameter) for part in (0.5, fraction)]
    across = middle.cross(edge.tangentAt(at[0]))
    is_inward = face.isPartOfDomain(*face.Surface.parameter(edge.valueAt(at[0]) + _STEP * edge.Length * across))
    return normal.cross(edge.tangentAt(at[1])) * (1.0 if is_inward else -1.0)


def _rounded(edge, sides, distance):
    """The two directions, of length 1, between which the offset is round about an edge at its beginning; None where it is not."""
    normals = _normals(edge, sides, 0.5)
    across = normals[0].cross(normals[1])
    if across.Length < _SMOOTH and normals[0].dot(normals[1]) > 0.0:
        return None
    if _into(edge, sides[0], 0.5).dot(normals[1]) * distance >= 0.0:
        return None
    sign = math.copysign(1.0, distance)
    return [sign * normal for normal in _normals(edge, sides, 0.0)]


def _normals(edge, sides, fraction):
    point = edge.valueAt(edge.FirstParameter + fraction * (edge.LastParameter - edge.FirstParameter))
    return [side.normalAt(*side.Surface.parameter(point)) for side in sides]


def _tube(edge, normals, radius):
    """The part of a cylinder or torus about an edge between two normals; None where the edge is neither straight nor circular."""
    start = edge.valueAt(edge.FirstParameter)
    between = (normals[0] + normals[1]).normalize()
    arc = Part.Arc(*(start + radius * direction for direction in (normals[0], between, normals[1]))).toShape()
    curve = edge.Curve
    if isinstance(curve, (Part.Line, Part.LineSegment)):
        return arc.extrude(edge.valueAt(edge.LastParameter) - start)
    if isinstance(curve, Part.Circle):
        return arc.revolve(curve.Center, curve.Axis, math.degrees(edge.LastParameter - edge.FirstParameter))
    return None


def _sphere(centre, direction, radius):
    """The part of a sphere on one side, without its seam and its poles."""
    ball = Part.Sphere()
    ball.Radius = radius
    face = ball.toShape(-_SPHERE_U, _SPHERE_U, -_SPHERE_V, _SPHERE_V)
    face.Placement = FreeCAD.Placement(centre, FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), direction))
    return face
