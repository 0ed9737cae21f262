# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random parts, modelled by FreeCAD's Part module; the same seed gives the same part.

A part is a chain of steps, each with random numbers of its own, so that steps can be left out
without a change in the others. A step whose result is not one valid solid is left out by itself.
"""

import math
import random

import Part
from FreeCAD import Matrix, Placement, Rotation, Vector

Z = Vector(0, 0, 1)
TRIES = 5


class Dice(random.Random):
    """Random numbers of one step."""

    creased = False


def random_part(seed, skip=(), *, creased=False):
    """(solid, [(number, what)] of the steps in it); the steps in `skip` are not done.

    With `creased` every ring with corners is a single edge through them, whose faces have creases.
    """
    plan = random.Random(f"{seed}:plan")
    steps = [_solid] + [_boolean] * plan.choice((0, 1, 1, 2, 2, 3, 4))
    steps += [_dress] * plan.choice((0, 1, 1, 2)) + [_boolean] * plan.choice((0, 0, 1))
    steps += [plan.choice((_keep, _keep, _turn, _mirror, _scale, _scale, _scale, _far))]
    shape, done = None, []
    for number, step in enumerate(steps):
        if number in skip and number > 0:
            continue
        dice = Dice(f"{seed}:{number}")
        dice.creased = creased
        shape, what = _try(step, dice, shape)
        if what:
            done.append((number, what))
    return shape, done


def _try(step, dice, shape):
    """The largest solid of what the step makes, or `shape` itself where that is none."""
    try:
        made, what = step(dice, shape)
        solids = sorted(made.Solids, key=lambda solid: -solid.Volume)
        if solids and solids[0].Volume > 0 and solids[0].isValid():
            return solids[0], what
    except (Part.OCCError, ValueError, RuntimeError, NotImplementedError):
        pass
    return shape, ""


def _point(dice, size=10.0):
    return Vector(*(dice.uniform(-size, size) for _ in range(3)))


def _direction(dice):
    """Along an axis more often than not."""
    if dice.random() < 0.6:
        return dice.choice((Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)))
    return Vector(*(dice.gauss(0, 1) for _ in range(3))).normalize()


def _size(dice):
    """Round numbers often, so that faces coincide and touch."""
    return float(dice.randint(1, 12)) if dice.random() < 0.5 else 10 ** dice.uniform(-0.7, 1.1)


def _solid(dice, _shape):
    kinds = (_box, _cylinder, _sphere, _cone, _torus, _prism, _loft, _sweep, _revolution, _wedge)
    for _ in range(TRIES):
        kind = dice.choice(kinds)
        made, _ = _try(lambda d, _, k=kind: (k(d), ""), dice, None)
        if made is not None:
            return made, kind.__name__[1:]
    raise ValueError("no solid")


def _box(dice):
    return Part.makeBox(_size(dice), _size(dice), _size(dice))


def _angle(dice):
    return 360.0 if dice.random() < 0.6 else dice.uniform(10.0, 350.0)


def _cylinder(dice):
    return Part.makeCylinder(_size(dice), _size(dice), Vector(), Z, _angle(dice))


def _sphere(dice):
    low, high = sorted((dice.uniform(-90, 90), dice.uniform(-90, 90)))
    if dice.random() < 0.6:
        low, high = -90.0, 90.0
    return Part.makeSphere(_size(dice), Vector(), Z, low, high, _angle(dice))


def _cone(dice):
    top = 0.0 if dice.random() < 0.4 else _size(dice)
    return Part.makeCone(_size(dice), top, _size(dice), Vector(), Z, _angle(dice))


def _torus(dice):
    small = _size(dice)
    return Part.makeTorus(small * dice.uniform(1.02, 4.0), small, Vector(), Z, 0, 360, _angle(dice))


def _wedge(dice):
    a, b, c = (_size(dice) for _ in range(3))
    return Part.makeWedge(0, 0, 0, dice.uniform(0, c), dice.uniform(0, a), a, b, c, c, a)


def _ring(dice, radius, height=0.0):
    """A closed wire: polygon, circle, ellipse or spline around the z axis."""
    kind = dice.choice(("polygon", "circle", "ellipse", "spline"))
    if kind == "circle":
        return Part.Wire(Part.makeCircle(radius, Vector(0, 0, height)))
    if kind == "ellipse":
        curve = Part.Ellipse(Vector(0, 0, height), radius, radius * dice.uniform(0.1, 0.95))
        return Part.Wire(curve.toShape())
    count = dice.randint(3, 8)
    turns = sorted(2 * math.pi * (k + dice.uniform(0, 0.7)) / count for k in range(count))
    points = [Vector(math.cos(t), math.sin(t), 0) * radius * dice.uniform(0.5, 1.2) for t in turns]
    points = [p + Vector(0, 0, height) for p in points]
    if dice.creased:
        return Part.Wire(_with_corners([*points, points[0]], kind == "spline").toShape())
    if kind == "polygon":
        return Part.makePolygon([*points, points[0]])
    curve = Part.BSplineCurve()
    curve.interpolate(points, PeriodicFlag=True)
    return Part.Wire(curve.toShape())


def _with_corners(points, curved):
    """One spline: of straight lines, or of curves with a corner where two of them meet."""
    curve = Part.BSplineCurve()
    if not curved:
        curve.buildFromPolesMultsKnots(points, [2] + [1] * (len(points) - 2) + [2], degree=1)
        return curve
    corner = len(points) // 2
    curve.interpolate(points[:corner + 1])
    rest = Part.BSplineCurve()
    rest.interpolate(points[corner:])
    curve.join(rest)
    return curve


def _prism(dice):
    return Part.Face(_ring(dice, _size(dice))).extrude(
        Vector(dice.uniform(-2, 2), dice.uniform(-2, 2), _size(dice)))


def _loft(dice):
    height, rings = 0.0, []
    for _ in range(dice.randint(2, 4)):
        rings.append(_ring(dice, _size(dice), height))
        height += _size(dice)
    return Part.makeLoft(rings, True, dice.random() < 0.5)


def _sweep(dice):
    radius = _size(dice)
    kind = dice.choice(("helix", "spline", "arc"))
    if kind == "helix":
        path = Part.Wire(Part.makeHelix(2.6 * radius, 2.6 * radius * dice.uniform(0.5, 2.5),
                                        radius * dice.uniform(1.3, 5.0)))
    elif kind == "arc":
        path = Part.Wire(Part.makeCircle(radius * dice.uniform(1.2, 6.0), Vector(), Z, 0,
                                         dice.uniform(20, 300)))
    else:
        curve = Part.BSplineCurve()
        curve.interpolate([Vector(4 * radius * k, dice.uniform(-2, 2) * radius,
                                  dice.uniform(-2, 2) * radius) for k in range(4)])
        path = Part.Wire(curve.toShape())
    start = path.Edges[0]
    tangent = start.tangentAt(start.FirstParameter)
    ring = _ring(dice, radius)
    ring.Placement = Placement(start.valueAt(start.FirstParameter), Rotation(Z, tangent))
    return path.makePipeShell([ring], True, True)


def _revolution(dice):
    ring = _ring(dice, _size(dice))
    box = ring.BoundBox
    away = 0.0 if dice.random() < 0.3 else dice.uniform(0.01, 2.0) * box.XLength
    axis = Vector(box.XMin - away, 0, 0)
    return Part.Face(ring).revolve(axis, Vector(0, 1, 0), _angle(dice))


def _placed(dice, tool, shape):
    """The tool at some place in or on the shape."""
    if dice.random() < 0.3:
        at = dice.choice(shape.Vertexes).Point
    else:
        box = shape.BoundBox
        at = Vector(*(dice.uniform(low, high) for low, high in
                      ((box.XMin, box.XMax), (box.YMin, box.YMax), (box.ZMin, box.ZMax))))
    tool.Placement = Placement(at, Rotation(Z, _direction(dice))).multiply(
        Placement(-tool.CenterOfMass, Rotation()) if dice.random() < 0.7 else Placement())
    return tool


def _boolean(dice, shape):
    tool, name = _solid(dice, None)
    tool = _placed(dice, tool, shape)
    operation = dice.choice(("fuse", "fuse", "cut", "cut", "cut", "common"))
    made = getattr(shape, operation)(tool)
    if dice.random() < 0.5:
        made = made.removeSplitter()
    return made, f"{operation} {name}"


def _dress(dice, shape):
    return dice.choice((_fillet, _fillet, _chamfer, _shell))(dice, shape)


def _some_edges(dice, shape):
    edges = [edge for edge in shape.Edges if not edge.Degenerated and edge.Length > 1e-3]
    return dice.sample(edges, min(len(edges), dice.randint(1, 6)))


def _fillet(dice, shape):
    edges = _some_edges(dice, shape)
    radius = min(edge.Length for edge in edges) * 10 ** dice.uniform(-2, -0.3)
    return shape.makeFillet(radius, edges), "fillet"


def _chamfer(dice, shape):
    edges = _some_edges(dice, shape)
    width = min(edge.Length for edge in edges) * 10 ** dice.uniform(-2, -0.3)
    return shape.makeChamfer(width, edges), "chamfer"


def _shell(dice, shape):
    wall = shape.BoundBox.DiagonalLength * 10 ** dice.uniform(-2.5, -1) * dice.choice((-1, 1))
    return shape.makeThickness([dice.choice(shape.Faces)], wall, 1e-4), "shell"


def _keep(_dice, shape):
    return shape, ""


def _turn(dice, shape):
    turned = shape.copy()
    turned.Placement = Placement(_point(dice), Rotation(_direction(dice), dice.uniform(0, 360)))
    return turned, "turned"


def _mirror(dice, shape):
    return shape.mirror(_point(dice), _direction(dice)), "mirrored"


def _scale(dice, shape):
    """To 1e-3 mm or 1e6 mm, or otherwise in every direction."""
    kind = dice.choice(("tiny", "huge", "stretched"))
    matrix = Matrix()
    if kind == "stretched":
        matrix.scale(*(10 ** dice.uniform(-0.7, 0.7) for _ in range(3)))
        return shape.transformGeometry(matrix), kind
    factor = (1e-3 if kind == "tiny" else 1e6) / shape.BoundBox.DiagonalLength
    matrix.scale(factor, factor, factor)
    return shape.transformGeometry(matrix) if dice.random() < 0.3 else shape.copy().scale(factor), kind


def _far(dice, shape):
    moved = shape.copy()
    moved.translate(_direction(dice) * 1e6)
    return moved, "far"
