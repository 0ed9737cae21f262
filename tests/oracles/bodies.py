# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two solids that stand to each other in a known way: compounds for Booleans, clearances and assemblies."""

import math

import FreeCAD
import Part
import solids
from solids import V, Z, moved, one, polygon, spline_loop, turned


def together(*shapes):
    return Part.makeCompound([one(shape) for shape in shapes])


def small(dice):
    """A simple body."""
    kinds = [solids.box, solids.cylinder, solids.cone, solids.sphere, solids.prism, solids.torus]
    return one(dice.choice(kinds)(dice))


# What touches: the faces in common are parts of one plane, cylinder, cone, sphere, torus or spline


def boxes_on_a_plane(dice):
    a = Part.makeBox(10, 10, dice.uniform(2, 10))
    b = Part.makeBox(dice.uniform(2, 14), dice.uniform(2, 14), 5, V(dice.uniform(-2, 8), dice.uniform(-2, 8), a.BoundBox.ZMax))
    return together(a, b)


def prism_and_pyramid(dice):
    """They share a polygon; one may be turned by less than a tolerance."""
    count, radius, height = dice.randint(3, 20), dice.uniform(3, 10), dice.uniform(5, 20)
    turn = dice.choice([0.0, 10 ** dice.uniform(-5, -2)])
    a = Part.Face(Part.makePolygon(polygon(dice, count, radius))).extrude(V(0, 0, height))
    corners = polygon(dice, count, radius, turn, height)
    top = V(0, 0, height + dice.uniform(2, 10))
    sides = [Part.Face(Part.makePolygon([p, q, top, p])) for p, q in zip(corners, corners[1:])]
    b = Part.makeSolid(Part.makeShell([Part.Face(Part.makePolygon(corners)), *sides]))
    if b.Volume < 0:
        b.reverse()
    return together(a, b)


def cylinder_and_cone(dice):
    radius, height = dice.uniform(3, 10), dice.uniform(5, 20)
    top = dice.choice([0, radius * dice.uniform(0.2, 0.8)])
    return together(Part.makeCylinder(radius, height), Part.makeCone(radius, top, dice.uniform(2, 10), V(0, 0, height)))


def cylinders_in_line(dice):
    """Of one radius: the faces around are one cylinder; they meet in a disk, or overlap."""
    radius, height = dice.uniform(3, 10), dice.uniform(5, 20)
    return together(Part.makeCylinder(radius, height),
                    Part.makeCylinder(radius, height, V(0, 0, height * dice.choice([1.0, dice.uniform(0.2, 0.9)]))))


def peg_in_bore(dice):
    radius, depth = dice.uniform(1, 4), dice.uniform(3, 10)
    block = Part.makeBox(12, 12, 10).cut(Part.makeCylinder(radius, 20, V(6, 6, 10 - depth)))
    return together(block, Part.makeCylinder(radius, dice.choice([depth, depth + 5]), V(6, 6, 10 - depth)))


def ball_in_socket(dice):
    ball = Part.makeSphere(dice.uniform(2, 4), V(6, 6, 10))
    return together(Part.makeBox(12, 12, 10).cut(ball), ball)


def cone_in_seat(dice):
    plug = Part.makeCone(dice.uniform(1, 2), dice.uniform(3, 5), 10, V(6, 6, 0))
    return together(Part.makeBox(12, 12, dice.uniform(4, 9)).cut(plug), plug)


def ring_in_groove(dice):
    ring = Part.makeTorus(dice.uniform(3, 4), dice.uniform(0.5, 1.5), V(6, 6, 5))
    return together(Part.makeBox(12, 12, 5).cut(ring), ring)


def spline_stack(dice):
    """Two prisms on one closed spline."""
    low, high = dice.uniform(2, 8), dice.uniform(2, 8)
    face = Part.Face(Part.Wire(spline_loop(dice, 6)))
    upper = face.copy()
    upper.translate(V(0, 0, low))
    return together(face.extrude(V(0, 0, low)), upper.extrude(V(0, 0, high)))


def halves(dice):
    """A body cut by a plane."""
    body = small(dice)
    place = body.BoundBox.Center + V(0, 0, body.BoundBox.ZLength * dice.uniform(-0.3, 0.3))
    normal = V(dice.uniform(-1, 1), dice.uniform(-1, 1), 2)
    size = 4 * body.BoundBox.DiagonalLength
    knife = moved(Part.makeBox(size, size, size, V(-size / 2, -size / 2, 0)),
                  FreeCAD.Placement(place, FreeCAD.Rotation(Z, normal)))
    return together(body.cut(knife), body.common(knife))


# What overlaps, lies in the other, is the same, or is apart


def overlapping(dice):
    a = turned(dice, small(dice))
    b = turned(dice, small(dice))
    inside = a.CenterOfMass - b.CenterOfMass
    b = moved(b, FreeCAD.Placement(inside + V(*(dice.uniform(-2, 2) for _ in range(3))), FreeCAD.Rotation()))
    if a.common(b).Volume < 1e-2 * min(a.Volume, b.Volume):
        raise ValueError("hardly in common")
    return together(a, b)


def overlapping_flush(dice):
    """Boxes that have a plane in common on the same side, or one slid half into the other."""
    a = Part.makeBox(10, 10, 10)
    return together(a, Part.makeBox(dice.choice([10, dice.uniform(3, 12)]), dice.choice([10, dice.uniform(3, 12)]), 10,
                                    V(dice.uniform(1, 8), 0, 0)))


def equal(dice):
    body = small(dice)
    return together(body, body.copy())


def nested(dice):
    body = small(dice)
    if min(body.BoundBox.XLength, body.BoundBox.YLength, body.BoundBox.ZLength) < 1:
        raise ValueError("too thin")
    inner = Part.makeSphere(dice.uniform(0.1, 0.5), body.CenterOfMass)
    if not body.isInside(body.CenterOfMass, 1e-6, False) or abs(body.common(inner).Volume - inner.Volume) > 1e-6:
        raise ValueError("not inside")
    return together(body, inner)


def nested_flush(dice):
    """One in the other, with a plane in common."""
    return together(Part.makeBox(10, 10, 10), Part.makeBox(dice.uniform(2, 6), 4, dice.choice([10, 5]), V(2, 3, 0)))


def ball_in_cavity(dice):
    """A ball in a hollow one, with a gap."""
    radius, gap = dice.uniform(3, 8), 10 ** dice.uniform(-2, 0)
    shell = Part.makeSphere(radius + 2).cut(Part.makeSphere(radius))
    return together(shell, Part.makeSphere(radius - gap))


def shaft_in_bore(dice):
    """With a clearance."""
    radius, gap = dice.uniform(2, 4), 10 ** dice.uniform(-2, -0.3)
    return together(Part.makeBox(14, 14, 8).cut(Part.makeCylinder(radius + gap, 20, V(7, 7, -5))),
                    Part.makeCylinder(radius, 20, V(7, 7, -5)))


def apart(dice):
    a, b = turned(dice, small(dice)), turned(dice, small(dice))
    away = V(dice.uniform(-1, 1), dice.uniform(-1, 1), 1).normalize()
    b = moved(b, FreeCAD.Placement(away * (a.BoundBox.DiagonalLength + b.BoundBox.DiagonalLength) * dice.uniform(0.6, 1.5),
                                   FreeCAD.Rotation()))
    if a.distToShape(b)[0] < 1e-2:
        raise ValueError("not apart")
    return together(a, b)


def boxes_with_a_gap(dice):
    """Face to face, a gap apart."""
    a = Part.makeBox(10, 10, 10)
    return together(a, Part.makeBox(10, 10, 10, V(10 + 10 ** dice.uniform(-6, 0), dice.uniform(-5, 5), dice.uniform(-5, 5))))


def crossed_bars(dice):
    """Equal bars through one axis."""
    bar = Part.makeBox(20, 2, 2, V(-10, -1, -1))
    return together(bar, moved(bar, FreeCAD.Placement(V(), FreeCAD.Rotation(Z, math.degrees(dice.uniform(0.3, 2.8))))))


TOUCHING = {
    "boxes on a plane": boxes_on_a_plane, "prism and pyramid": prism_and_pyramid, "cylinder and cone": cylinder_and_cone,
    "peg in bore": peg_in_bore, "ball in socket": ball_in_socket, "cone in seat": cone_in_seat,
    "ring in groove": ring_in_groove, "spline stack": spline_stack, "halves": halves}
OVERLAPPING = {
    "overlapping": overlapping, "overlapping flush": overlapping_flush, "equal": equal, "nested": nested,
    "nested flush": nested_flush, "crossed bars": crossed_bars}
APART = {"ball in cavity": ball_in_cavity, "shaft in bore": shaft_in_bore, "apart": apart,
         "boxes with a gap": boxes_with_a_gap}
BODIES = {**TOUCHING, **OVERLAPPING, **APART, "cylinders in line": cylinders_in_line}
