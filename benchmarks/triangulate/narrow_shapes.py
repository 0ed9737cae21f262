# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random solids with one narrow place each, of six classes; the same class and seed give the same solid.

corner   two edges of a face, straight or curved, leave a vertex at 0.05 to 10 degrees
contact  two edges of a face come as near as the tolerance, touch or cross: -3 to 3 tolerances between them
rim      the rim of a hole comes as near to an edge or to another rim as 1e-9 to 1e-3 of the size, or touches it; the walls open below
sliver   a face between a chain of n edges and one of m edges, 0.001 to 30 tolerances wide
cusp     two edges of a face leave a vertex tangentially: their distance grows as the square of the way, or more slowly yet
crest    a strip along the crest of a thread or of rings, 0.1 to 300 tolerances wide
"""

import math
import random

import Part
from FreeCAD import Rotation, Vector

CLASSES = ("corner", "contact", "rim", "sliver", "cusp", "crest")
TOLERANCES = (1e-7, 1e-5, 1e-4, 1e-3)  # mm, of vertices and edges: OpenCASCADE's own, and those of exchanged files
TRIES = 40  # solids that OpenCASCADE does not make valid are made again with other numbers
Z = Vector(0, 0, 1)


def narrow_solid(kind, seed):
    """(Part.Shape, {name: number} of what is narrow in it). Raises ValueError where no try gives a valid solid."""
    for attempt in range(TRIES):
        dice = random.Random(f"{kind}:{seed}:{attempt}")
        try:
            shape, numbers = MAKERS[kind](dice)
        except (Part.OCCError, RuntimeError, ValueError, ZeroDivisionError):
            continue
        if shape.Solids and shape.Volume > 0.0 and shape.isValid():
            shape.rotate(Vector(), Vector(*(dice.gauss(0, 1) for _ in range(3))), dice.uniform(0, 360))
            return shape, {**numbers, "attempt": attempt}
    raise ValueError(f"no valid solid of class {kind} and seed {seed}")


def _between(dice, low, high):
    """Evenly by the logarithm."""
    return math.exp(dice.uniform(math.log(low), math.log(high)))


def _direction(angle):
    return Vector(math.cos(math.radians(angle)), math.sin(math.radians(angle)), 0)


def _bent(dice, start, angle, length, bend):
    """(edge, its end): from `start` at an angle in degrees to the x axis; it turns by `bend` degrees on its way: a line, an arc
    or a spline.
    """
    along, turned = _direction(angle), _direction(angle + bend)
    if abs(bend) < 0.01:
        end = start + along * length
        return Part.makeLine(start, end), end
    radius = length / math.radians(bend)
    centre = start + _direction(angle + 90) * radius
    end = centre - _direction(angle + bend + 90) * radius
    if dice.random() < 0.5:
        middle = centre - _direction(angle + bend / 2 + 90) * radius
        return Part.Arc(start, middle, end).toShape(), end
    curve = Part.BSplineCurve()
    curve.interpolate([start, centre - _direction(angle + bend / 3 + 90) * radius, end], InitialTangent=along, FinalTangent=turned)
    return curve.toShape(), end


def _prism(dice, edges, size):
    """The face that the edges bound, extruded, and now and then on a curved face: cut out of a cylinder."""
    solid = Part.Face(Part.Wire(Part.__sortEdges__(edges))).extrude(Vector(0, 0, size * _between(dice, 0.05, 1.0)))
    if dice.random() < 0.3:
        box = solid.BoundBox
        radius = box.DiagonalLength * _between(dice, 0.6, 5.0)
        middle = box.Center - Z * (radius - 0.4 * box.ZLength)
        solid = solid.common(Part.makeCylinder(radius, 3 * box.DiagonalLength, middle - Vector(1.5 * box.DiagonalLength, 0, 0),
                                               Vector(1, 0, 0)))
    return solid


def _corner(dice):
    angle, length = _between(dice, 0.05, 10.0), _between(dice, 1.0, 100.0)
    bends = [dice.choice((0.0, 0.0, dice.uniform(-20, 20), dice.uniform(-60, 60))) for _ in range(2)]
    # The upper side turns away from the lower one, or both turn alike, so that they do not meet again.
    bends[1] = max(bends[1], bends[0])
    low, low_end = _bent(dice, Vector(), 0.0, length, bends[0])
    high, high_end = _bent(dice, Vector(), angle, length * dice.uniform(0.5, 1.5), bends[1])
    solid = _prism(dice, [low, high, Part.makeLine(low_end, high_end)], length)
    return solid, {"degrees": angle, "bends": bends}


def _contact(dice):
    tolerance, size = dice.choice(TOLERANCES), _between(dice, 5.0, 100.0)
    gap = dice.uniform(-3.0, 3.0) * tolerance
    radius = size * dice.uniform(0.1, 0.4)
    height = size * _between(dice, 0.05, 0.5)
    if dice.random() < 0.5:  # a hole beside the border of a plate
        outline = Part.makePolygon([Vector(0, 0, 0), Vector(size, 0, 0), Vector(size, size, 0), Vector(0, size, 0), Vector(0, 0, 0)])
        hole = Part.Wire(Part.makeCircle(radius, Vector(size / 2, radius + gap, 0)))
    else:  # a hole beside the border of a disc
        outline = Part.Wire(Part.makeCircle(size / 2))
        hole = Part.Wire(Part.makeCircle(radius, Vector(size / 2 - radius - gap, 0, 0)))
    hole.reverse()
    face = Part.Face([outline, hole])
    solid = face.extrude(Vector(0, 0, height))
    solid.fixTolerance(tolerance)
    return solid, {"tolerance": tolerance, "gap": gap / tolerance}


def _rim(dice):
    length, width, height = (_between(dice, 5.0, 50.0) for _ in range(3))
    gap = max(length, width, height) * dice.choice((0.0, _between(dice, 1e-9, 1e-3)))
    radius, shrunk = dice.uniform(0.08, 0.22) * min(length, width), dice.choice((0.4, 0.7, 0.9))
    solid = Part.makeBox(length, width, height)
    kind = dice.choice(("cone beside edge", "ball beside edge", "two cones"))
    if kind == "two cones":
        middle, other, way = Vector(0.5 * length, 0.5 * width, height), radius * dice.uniform(0.3, 1.0), dice.uniform(0, 360)
        solid = solid.cut(Part.makeCone(radius, shrunk * radius, height, middle, -Z))
        middle += _direction(way) * (radius + other + gap)
        solid = solid.cut(Part.makeCone(other, shrunk * other, 0.7 * height, middle, -Z))
    else:
        place = Vector(length * dice.uniform(0.3, 0.7), radius + gap, height)
        if kind == "cone beside edge":
            solid = solid.cut(Part.makeCone(radius, shrunk * radius, height * dice.choice((0.6, 1.0)), place, -Z))
        else:
            ball = radius * dice.uniform(1.05, 3.0)
            solid = solid.cut(Part.makeSphere(ball, place + Z * math.sqrt(ball**2 - radius**2)))
    return solid, {"gap": gap, "kind": kind, "shrunk": shrunk}


def _sliver(dice):
    tolerance, length = dice.choice(TOLERANCES), _between(dice, 5.0, 100.0)
    width, counts = tolerance * _between(dice, 1e-3, 30.0), (dice.randint(0, 4), dice.randint(0, 4))
    depth, height = length * dice.uniform(0.2, 0.6), length * dice.uniform(0.1, 0.3)
    # A step of that width, on which and under which blocks stand flush with the riser, which divide its edges.
    solid = Part.makeBox(length, depth, height).fuse(Part.makeBox(length, 0.5 * depth, width, Vector(0, 0, height)))
    for count, side in zip(counts, (-1, 1)):
        for i in range(count):
            at = length * (i + dice.uniform(0.1, 0.5)) / count
            block = Part.makeBox(length / count * dice.uniform(0.1, 0.4), 0.2 * depth, 0.3 * height,
                                 Vector(at, (0.3 if side < 0 else 0.5) * depth, height + (width if side < 0 else 0.0)))
            solid = solid.fuse(block)
    solid.fixTolerance(tolerance)
    return solid, {"tolerance": tolerance, "width": width / tolerance, "blocks": counts}


def _cusp(dice):
    radius, way = _between(dice, 1.0, 100.0), dice.uniform(10.0, 80.0)
    other = dice.choice((0.0, 0.0, dice.uniform(0.1, 0.9), dice.uniform(0.9, 0.99), -dice.uniform(0.1, 1.0)))
    length = radius * math.radians(way)
    upper, upper_end = _bent(random.Random(0), Vector(), 0.0, length, way)
    # The lower side bends, too, by this share of the upper one; negative: away from it.
    lower, lower_end = _bent(dice, Vector(), 0.0, length, other * way)
    solid = _prism(dice, [upper, lower, Part.makeLine(lower_end, upper_end)], radius)
    return solid, {"radius": radius, "share": other}


def _crest(dice):
    tolerance, radius = dice.choice(TOLERANCES), _between(dice, 2.0, 50.0)
    width, pitch = tolerance * _between(dice, 0.1, 300.0), radius * dice.uniform(0.1, 0.6)
    depth = pitch * dice.uniform(0.3, 0.9)
    turns = dice.randint(1, 4)
    if dice.random() < 0.5:  # rings
        points = [Vector(0, 0, 0), Vector(radius - depth, 0, 0)]
        for i in range(turns):
            low = i * pitch
            points += [Vector(radius, 0, low + 0.5 * (pitch - width)), Vector(radius, 0, low + 0.5 * (pitch + width)),
                       Vector(radius - depth, 0, low + pitch)]
        points += [Vector(0, 0, turns * pitch), Vector(0, 0, 0)]
        solid = Part.Face(Part.makePolygon(points)).revolve(Vector(), Z, 360)
    else:  # a thread: its profile is swept along a helix and united with the core
        helix = Part.makeHelix(pitch, turns * pitch, radius - depth)
        inner = radius - depth - 0.05 * pitch
        profile = Part.makePolygon([Vector(inner, 0, -0.45 * pitch), Vector(radius, 0, -0.5 * width), Vector(radius, 0, 0.5 * width),
                                    Vector(inner, 0, 0.45 * pitch), Vector(inner, 0, -0.45 * pitch)])
        solid = Part.Wire(helix).makePipeShell([profile], True, True)
    solid.fixTolerance(tolerance)
    return solid, {"tolerance": tolerance, "width": width / tolerance}


MAKERS = {"corner": _corner, "contact": _contact, "rim": _rim, "sliver": _sliver, "cusp": _cusp, "crest": _crest}
