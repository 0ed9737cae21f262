# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random solids, and bodies side by side, of FreeCAD's Part only: the inputs of the oracles.

    solids.make("bored block", 17)

The same kind and seed make the same shape, which is valid by Shape.isValid(). Lengths are in mm.
"""

import math
import random

import FreeCAD
import Part

V = FreeCAD.Vector
X, Y, Z = V(1, 0, 0), V(0, 1, 0), V(0, 0, 1)
MOST_TRIES = 40  # until a fillet or a cut of chance is possible


class NoSolidError(Exception):
    """No valid solid came of a kind and a seed."""


def make(kind, seed):
    """The shape of this kind and seed: a solid of SOLIDS, or a compound of solids of BODIES."""
    dice = random.Random(f"{kind} {seed}")
    for _ in range(MOST_TRIES):
        try:
            shape = _kinds()[kind](dice)
        except (Part.OCCError, FreeCAD.Base.FreeCADError, ValueError):
            continue  # a fillet that is too large: the dice have another one
        if shape.Solids and shape.isValid() and all(_is_whole(solid) for solid in shape.Solids):
            return shape
    raise NoSolidError(f"no valid solid of kind {kind!r} and seed {seed}")


def _kinds():
    import bodies  # noqa: PLC0415  is made of this module

    return {**SOLIDS, **bodies.BODIES}


def _is_whole(solid):
    """Whether it is closed and encloses something of the size of its faces."""
    return solid.isClosed() and solid.Volume > 1e-7 * solid.Area ** 1.5


def one(shape):
    """The only solid of a shape, without the compound around it."""
    if len(shape.Solids) != 1:
        raise ValueError("several solids")
    return shape.Solids[0]


# Bodies of one surface or few


def box(dice):
    return Part.makeBox(dice.uniform(1, 20), dice.uniform(1, 20), dice.uniform(1, 20))


def cylinder(dice):
    return Part.makeCylinder(dice.uniform(1, 10), dice.uniform(1, 20), V(), Z, dice.choice([360, 360, dice.uniform(40, 320)]))


def cone(dice):
    base = dice.uniform(2, 10)
    return Part.makeCone(base, dice.choice([0, base * dice.uniform(0.2, 0.8)]), dice.uniform(2, 20))


def sphere(dice):
    return Part.makeSphere(dice.uniform(1, 10))


def cut_sphere(dice):
    radius = dice.uniform(3, 10)
    return one(Part.makeSphere(radius).cut(Part.makeBox(30, 30, 30, V(-15, -15, radius * dice.uniform(-0.7, 0.7)))))


def torus(dice):
    radius = dice.uniform(4, 12)
    return Part.makeTorus(radius, radius * dice.uniform(0.15, 0.7))


def polygon(dice, count, radius, turn=0.0, height=0.0):
    """The corners of a regular polygon, the first one again at the end."""
    angles = [turn + 2 * math.pi * k / count for k in range(count)]
    corners = [V(radius * math.cos(a), radius * math.sin(a), height) for a in angles]
    return [*corners, corners[0]]


def prism(dice):
    face = Part.Face(Part.makePolygon(polygon(dice, dice.randint(3, 12), dice.uniform(2, 10), dice.uniform(0, 6))))
    return face.extrude(V(dice.uniform(-2, 2), dice.uniform(-2, 2), dice.uniform(2, 20)))


def spline_loop(dice, radius, height=0.0):
    """A closed curve around the z-axis."""
    count = dice.randint(5, 9)
    spline = Part.BSplineCurve()
    spline.interpolate([V(math.cos(a) * r, math.sin(a) * r, height) for a, r in (
        (2 * math.pi * k / count, radius * dice.uniform(0.7, 1.3)) for k in range(count))], PeriodicFlag=True)
    return spline.toShape()


def spline_prism(dice):
    return Part.Face(Part.Wire(spline_loop(dice, dice.uniform(3, 10)))).extrude(V(0, 0, dice.uniform(2, 15)))


# Bodies that were worked on


def filleted_box(dice):
    body = Part.makeBox(dice.uniform(6, 20), dice.uniform(6, 20), dice.uniform(6, 20))
    edges = dice.sample(body.Edges, dice.choice([1, 2, 4, 12]))
    return one(body.makeFillet(dice.uniform(0.3, 2.5), edges))


def chamfered_box(dice):
    body = Part.makeBox(dice.uniform(6, 20), dice.uniform(6, 20), dice.uniform(6, 20))
    return one(body.makeChamfer(dice.uniform(0.3, 2.5), dice.sample(body.Edges, dice.choice([1, 3, 12]))))


def filleted_cylinder(dice):
    radius = dice.uniform(3, 10)
    body = Part.makeCylinder(radius, dice.uniform(5, 20))
    rims = [edge for edge in body.Edges if isinstance(edge.Curve, Part.Circle)]
    return one(body.makeFillet(radius * dice.uniform(0.1, 0.45), dice.sample(rims, dice.randint(1, 2))))


def filleted_boss(dice):
    body = Part.makeBox(20, 20, 5).fuse(Part.makeCylinder(dice.uniform(2, 6), 15, V(10, 10, 0))).removeSplitter()
    foot = [e for e in body.Edges if isinstance(e.Curve, Part.Circle) and abs(e.Curve.Center.z - 5) < 1e-6]
    return one(body.makeFillet(dice.uniform(0.3, 2), foot))


def bored_block(dice):
    body = Part.makeBox(20, 20, dice.uniform(3, 15))
    for _ in range(dice.randint(1, 3)):
        body = body.cut(Part.makeCylinder(dice.uniform(0.8, 3), 40, V(dice.uniform(4, 16), dice.uniform(4, 16), -10)))
    return one(body)


def near_tangent_cut(dice):
    """A bore that nearly touches a side of a box, from inside or outside."""
    radius, gap = dice.uniform(2, 5), dice.choice([-1, 1]) * 10 ** dice.uniform(-3, -0.7)
    return one(Part.makeBox(20, 20, 8).cut(Part.makeCylinder(radius, 20, V(radius + gap, 10, -5))))


def thin_tube(dice):
    radius = dice.uniform(3, 10)
    height = dice.uniform(3, 15)
    return one(Part.makeCylinder(radius, height).cut(Part.makeCylinder(radius - 10 ** dice.uniform(-2, -0.3), height)))


def thin_plate(dice):
    return Part.makeBox(dice.uniform(5, 20), dice.uniform(5, 20), 10 ** dice.uniform(-2, -0.3))


def loft(dice):
    low = Part.makePolygon(polygon(dice, dice.choice([4, 6]), dice.uniform(3, 8)))
    high = Part.Wire(Part.makeCircle(dice.uniform(2, 8), V(dice.uniform(-2, 2), 0, dice.uniform(4, 15))))
    sections = [high, low] if dice.random() < 0.5 else [
        Part.Wire(spline_loop(dice, 5)), Part.Wire(spline_loop(dice, dice.uniform(3, 7), 8))]
    body = Part.makeLoft(sections, True)
    body.fix(1e-6, 1e-6, 1e-4)
    if body.Volume < 0:
        body.reverse()
    return one(body)


def sweep(dice):
    path = Part.BSplineCurve()
    path.interpolate([V(), V(0, dice.uniform(-2, 2), 6), V(dice.uniform(2, 6), 0, 12), V(dice.uniform(8, 14), 4, 15)])
    start = path.tangent(path.FirstParameter)[0]
    profile = Part.Wire(Part.makeCircle(dice.uniform(0.5, 2), V(), start))
    return one(Part.Wire(path.toShape()).makePipeShell([profile], True, False))


def thread(dice):
    """A helix of a triangle or a circle."""
    radius, pitch = dice.uniform(4, 8), dice.uniform(2, 4)
    path = Part.makeHelix(pitch, pitch * dice.uniform(1, 2), radius)
    if dice.random() < 0.5:
        profile = Part.Wire(Part.makeCircle(pitch * 0.2, V(radius, 0, 0), Y))
    else:
        profile = Part.makePolygon([V(radius, 0, -0.3 * pitch), V(radius + 0.5 * pitch, 0, 0),
                                    V(radius, 0, 0.3 * pitch), V(radius, 0, -0.3 * pitch)])
    return one(Part.Wire(path.Edges).makePipeShell([profile], True, True))


def pattern(dice):
    """A plate with a row or a ring of bores."""
    body, count = Part.makeBox(24, 24, dice.uniform(1, 4)), dice.randint(3, 6)
    ring, radius = dice.random() < 0.5, dice.uniform(0.5, 1.5)
    for k in range(count):
        at = V(12 + 8 * math.cos(2 * math.pi * k / count), 12 + 8 * math.sin(2 * math.pi * k / count), -1) if ring \
            else V(3 + 18 * k / (count - 1), 12, -1)
        body = body.cut(Part.makeCylinder(radius, 10, at))
    return one(body)


def revolved(dice):
    inner = dice.choice([0, dice.uniform(1, 4)])
    points = [V(inner, 0, 0), V(dice.uniform(5, 9), 0, 0), V(dice.uniform(5, 9), 0, dice.uniform(2, 4)),
              V(dice.uniform(4.5, 8), 0, dice.uniform(5, 9)), V(inner, 0, 10)]
    return one(Part.Face(Part.makePolygon([*points, points[0]])).revolve(V(), Z, dice.choice([360, dice.uniform(60, 300)])))


def hollow_body(dice):
    """A body with one or two closed cavities."""
    body = Part.makeBox(20, 12, 12) if dice.random() < 0.5 else Part.makeCylinder(12, 12)
    center = body.BoundBox.Center
    for k in range(dice.randint(1, 2)):
        at = center + V(-5 + 10 * k, 0, 0)
        body = body.cut(dice.choice([Part.makeSphere(dice.uniform(1, 4), at), Part.makeBox(3, 3, 3, at)]))
    return one(body)


# The same bodies elsewhere, and of other sizes


def mirrored(dice):
    return one(some(dice).mirror(V(), V(dice.uniform(-1, 1), dice.uniform(-1, 1), 1)))


def turned(dice, shape, spread=0.0):
    """The shape turned at random, and moved by at most the spread along each axis."""
    axis = V(dice.uniform(-1, 1), dice.uniform(-1, 1), dice.uniform(-1, 1))
    place = FreeCAD.Placement(V(*(dice.uniform(-spread, spread) for _ in range(3))),
                              FreeCAD.Rotation(axis, dice.uniform(0, 360)))
    return one(shape.transformGeometry(place.toMatrix()) if dice.random() < 0.1 else moved(shape, place))


def moved(shape, place):
    copy = shape.copy()
    copy.Placement = place.multiply(copy.Placement)
    return copy


def turned_body(dice):
    return turned(dice, some(dice), 30)


def far(dice):
    return moved(some(dice), FreeCAD.Placement(V(*(dice.choice([-1, 1]) * 10 ** dice.uniform(3, 6) for _ in range(3))),
                                               FreeCAD.Rotation()))


def scaled(shape, factor):
    copy = shape.copy()
    copy.scale(factor)
    return copy


def micro(dice):
    return scaled(some(dice), 1e-3)


def huge(dice):
    return scaled(some(dice), 1e4)


PLAIN = {
    "box": box, "cylinder": cylinder, "cone": cone, "sphere": sphere, "cut sphere": cut_sphere, "torus": torus,
    "prism": prism, "spline prism": spline_prism, "filleted box": filleted_box, "chamfered box": chamfered_box,
    "filleted cylinder": filleted_cylinder, "filleted boss": filleted_boss, "bored block": bored_block,
    "near-tangent cut": near_tangent_cut, "thin tube": thin_tube, "thin plate": thin_plate, "loft": loft,
    "sweep": sweep, "thread": thread, "pattern": pattern, "revolved": revolved, "hollow body": hollow_body}


def some(dice):
    """Any of the plain ones."""
    return dice.choice([*PLAIN.values()])(dice)


SOLIDS = {**PLAIN, "mirrored": mirrored, "turned": turned_body, "far": far, "micro": micro, "huge": huge}
