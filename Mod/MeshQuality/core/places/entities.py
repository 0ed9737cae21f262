# SPDX-License-Identifier: LGPL-2.1-or-later
"""The faces, edges and vertices of a shape and how they hang together, and the points of a mesh on them."""

from functools import cached_property

import numpy as np

_CLOSED_FORM = ("Part::GeomPlane", "Part::GeomCylinder", "Part::GeomCone", "Part::GeomSphere", "Part::GeomToroid")
_INFINITE = 1e50  # parameters of OpenCASCADE's unbounded surfaces are beyond
_STEPS = 20  # of a projection
_NEAR = 1e-6  # distance of a projected point from its surface, as a fraction of the size


class Entities:
    """The faces, edges and vertices of a Part.Shape, by their numbers."""

    def __init__(self, shape):
        self.faces, self.edges, self.vertices = shape.Faces, shape.Edges, shape.Vertexes
        self._solids_and_shells = [*shape.Solids, *shape.Shells]
        self.size = shape.BoundBox.DiagonalLength
        self._curves = {}

    @cached_property
    def surfaces(self):
        """The surface of each face."""
        return [face.Surface for face in self.faces]

    @cached_property
    def bodies(self):
        """The numbers of the faces of each solid and each shell."""
        numbers = _numbers(self.faces)
        return [[_number(numbers, face) for face in body.Faces] for body in self._solids_and_shells]

    @cached_property
    def edges_of_face(self):
        """The numbers of the edges of each face, ascending."""
        numbers = _numbers(self.edges)
        return [sorted(_number(numbers, edge) for edge in face.Edges) for face in self.faces]

    @cached_property
    def ends_of_edge(self):
        """The numbers of the vertices of each edge, in the direction of its curve."""
        numbers = _numbers(self.vertices)
        return [tuple(_number(numbers, vertex) for vertex in self._in_order(edge)) for edge in self.edges]

    @staticmethod
    def _in_order(edge):
        ends = edge.Vertexes
        if len(ends) == 2 and not edge.Degenerated:
            first = edge.Curve.value(edge.FirstParameter)
            ends = sorted(ends, key=lambda vertex: vertex.Point.distanceToPoint(first))
        return ends

    def curve_on(self, face, edge):
        """(curve in (u, v), first and last parameter) of an edge of a face."""
        if (face, edge) not in self._curves:
            self._curves[face, edge] = self.faces[face].curveOnSurface(self.edges[edge])
        return self._curves[face, edge]

    def bounds(self, face):
        """(u, u, v, v) between which the surface of a face is defined."""
        return self.surfaces[face].bounds()

    def periods(self, face):
        """After which u and v are the same place again; 0: never."""
        surface = self.surfaces[face]
        u0, u1, v0, v1 = surface.bounds()
        return [high - low if high - low < _INFINITE and (periodic or closed) else 0.0 for low, high, periodic, closed in (
            (u0, u1, surface.isUPeriodic(), surface.isUClosed()), (v0, v1, surface.isVPeriodic(), surface.isVClosed()))]

    def parameter_on_edge(self, edge, point):
        """The parameter of a point on an edge, as a share of its range."""
        edge = self.edges[edge]
        curve, (low, high) = edge.Curve, edge.ParameterRange
        t = curve.parameter(point)
        if curve.isPeriodic():
            period = curve.LastParameter - curve.FirstParameter
            middle = (low + high) / 2
            t += period * round((middle - t) / period)
        return min(max((t - low) / (high - low), 0.0), 1.0)

    def parameters_on_face(self, face, point, guess):
        """(u, v) of a point on a face; guess: (u, v) nearby, or None."""
        surface = self.surfaces[face]
        if surface.TypeId in _CLOSED_FORM:
            return surface.parameter(point)
        found = guess and _projected(surface, point, *guess, _NEAR * self.size)
        return found or surface.parameter(point)


def scale_and_shift(before, after, face):
    """By u and v the factor and the summand that take the range of the surface of a face before to that after."""
    found = []
    old, new = before.bounds(face), after.bounds(face)
    for low, high, new_low, new_high in ((old[0], old[1], new[0], new[1]), (old[2], old[3], new[2], new[3])):
        bounded = max(abs(low), abs(high), abs(new_low), abs(new_high)) < _INFINITE
        factor = (new_high - new_low) / (high - low) if bounded else 1.0
        found.append((factor, new_low - factor * low if bounded else 0.0))
    return np.array(found)


def differences(before, after):
    """Sentences: where two shapes do not have the same faces, edges and vertices in the same numbering; none where they have."""
    for name, old, new in (("faces", before.faces, after.faces), ("edges", before.edges, after.edges),
                           ("vertices", before.vertices, after.vertices)):
        if len(old) != len(new):
            return [f"the shape has {len(new)} {name} now, it had {len(old)}"]
    found = []
    for i, (old, new) in enumerate(zip(before.surfaces, after.surfaces)):
        if old.TypeId != new.TypeId:
            found.append(f"Face{i + 1} is a {_kind(new)} now, it was a {_kind(old)}")
        elif before.edges_of_face[i] != after.edges_of_face[i]:
            found.append(f"Face{i + 1} has other edges now")
    for i, (old, new) in enumerate(zip(before.ends_of_edge, after.ends_of_edge)):
        if old != new:
            found.append(f"Edge{i + 1} has other ends now")
        elif before.edges[i].Degenerated != after.edges[i].Degenerated:
            found.append(f"Edge{i + 1} is a point in one of the shapes only")
    return found


def _kind(surface):
    return surface.TypeId.replace("Part::Geom", "").lower()


def _numbers(shapes):
    numbers = {}
    for i, shape in enumerate(shapes):
        numbers.setdefault(shape.hashCode(), []).append((shape, i))
    return numbers


def _number(numbers, wanted):
    return next(i for shape, i in numbers[wanted.hashCode()] if shape.isSame(wanted))


def _projected(surface, point, u, v, near):
    """(u, v) of a point on a surface by Newton's method; None where that does not lead to it."""
    u0, u1, v0, v1 = surface.bounds()
    for _ in range(_STEPS):
        rest = point - surface.value(u, v)
        if rest.Length <= 1e-3 * near:
            return u, v
        along_u, along_v = surface.getDN(u, v, 1, 0), surface.getDN(u, v, 0, 1)
        a, b, c = along_u * along_u, along_u * along_v, along_v * along_v
        determinant = a * c - b * b
        if determinant <= 1e-12 * a * c:
            return None
        e, f = rest * along_u, rest * along_v
        u_next = min(max(u + (c * e - b * f) / determinant, u0), u1)
        v_next = min(max(v + (a * f - b * e) / determinant, v0), v1)
        if abs(u_next - u) <= 1e-14 * (u1 - u0) and abs(v_next - v) <= 1e-14 * (v1 - v0):
            break
        u, v = u_next, v_next
    return (u, v) if (point - surface.value(u, v)).Length <= near else None
