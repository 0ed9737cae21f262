# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pairs of solids that share a face, made at random, and what OpenCASCADE makes of them."""

import math
import random
from dataclasses import dataclass

import FreeCAD
import Part

V = FreeCAD.Vector
OPERATIONS = ("union", "intersection", "difference", "symmetric_difference")
_LARGE = 1000.0  # mm, beyond all solids made here


@dataclass
class ContactPair:
    """Two solids that share a face, or parts of faces.

    second      as it lies exactly on the first
    displaced   the same, turned and moved by less than the tolerance in two pairs of three
    tolerance   mm
    """

    kind: str
    seed: int
    first: object
    second: object
    displaced: object
    tolerance: float


def _polygon(sides, radius, turn, z=0.0):
    corners = [V(radius * math.cos(turn + 2.0 * math.pi * i / sides),
                 radius * math.sin(turn + 2.0 * math.pi * i / sides), z) for i in range(sides)]
    return Part.makePolygon([*corners, corners[0]])


def _pyramid(low, apex):
    corners = [vertex.Point for vertex in low.OrderedVertexes]
    sides = [Part.Face(Part.makePolygon([p, q, apex, p])) for p, q in zip(corners, corners[1:] + corners[:1])]
    return Part.Solid(Part.Shell([*sides, Part.Face(low)]))


def _standing(rng, radius):
    """A solid that stands on the plane z = 0."""
    sides, height = rng.randint(3, 32), rng.uniform(0.4, 2.0) * radius
    low = _polygon(sides, radius, rng.choice([0.0, 10.0 ** rng.uniform(-5.0, -1.5), rng.uniform(0.0, 1.0)]))
    return {
        "prism": lambda: Part.Face(low).extrude(V(0, 0, height)),
        "pyramid": lambda: _pyramid(low, V(0, 0, height)),
        "frustum": lambda: Part.makeLoft([low, _polygon(sides, 0.6 * radius, 0.0, height)], True, True),
        "cylinder": lambda: Part.makeCylinder(radius, height),
        "cone": lambda: Part.makeCone(radius, 0, height),
        "truncated": lambda: Part.makeCone(radius, rng.uniform(0.3, 1.4) * radius, height),
        "box": lambda: Part.makeBox(2.0 * radius, 1.4 * radius, height, V(-radius, -0.7 * radius, 0)),
        "half_ball": lambda: Part.makeSphere(radius, V(), V(0, 0, 1), 0, 90, 360),
    }[rng.choice(["prism", "pyramid", "frustum", "cylinder", "cone", "truncated", "box", "half_ball"])]()


def _planar(rng):
    """One solid upon another: with equal, contained or overlapping bases."""
    radius = rng.uniform(3.0, 12.0)
    scale, aside = rng.choice([(1.0, 0.0), (rng.uniform(0.3, 0.9), 0.0),
                               (rng.uniform(0.5, 1.2), radius * rng.uniform(0.3, 0.9))])
    above = _standing(rng, radius * scale)
    above.translate(V(aside, 0, 0))
    return _standing(rng, radius).mirror(V(), V(0, 0, 1)), above


def _slab(low, high):
    return Part.makeBox(2.0 * _LARGE, 2.0 * _LARGE, high - low, V(-_LARGE, -_LARGE, low))


def _in_its_hole(rng, tool, length):
    """A block that a tool has gone through, and a piece of the tool: as long, shorter, or sticking out."""
    wall, box = rng.uniform(2.0, 6.0), tool.BoundBox
    block = Part.makeBox(box.XLength + 2.0 * wall, box.YLength + 2.0 * wall, length,
                         V(box.XMin - wall, box.YMin - wall, 0)).cut(tool)
    low, high = rng.choice([(0.0, 1.0), (rng.uniform(0.05, 0.4), rng.uniform(0.6, 0.95)),
                            (rng.uniform(0.2, 0.7), 1.6)])
    return block, tool.common(_slab(low * length, high * length))


def _cylinder(rng):
    length = rng.uniform(6.0, 20.0)
    return _in_its_hole(rng, Part.makeCylinder(rng.uniform(3.0, 10.0), 3.0 * length, V(0, 0, -length)), length)


def _cone(rng):
    length, radius = rng.uniform(6.0, 20.0), rng.uniform(4.0, 10.0)
    return _in_its_hole(rng, Part.makeCone(radius, radius * rng.uniform(1.2, 2.5), 3.0 * length, V(0, 0, -length)),
                        length)


def _spline(rng):
    count, length = rng.randint(5, 9), rng.uniform(6.0, 15.0)
    radii = [rng.uniform(4.0, 8.0) for _ in range(count)]
    curve = Part.BSplineCurve()
    curve.interpolate(Points=[V(r * math.cos(2.0 * math.pi * i / count), r * math.sin(2.0 * math.pi * i / count),
                                -length) for i, r in enumerate(radii)], PeriodicFlag=True)
    return _in_its_hole(rng, Part.Face(Part.Wire(curve.toShape())).extrude(V(0, 0, 3.0 * length)), length)


def _sphere(rng):
    radius = rng.uniform(4.0, 10.0)
    depth = radius * rng.uniform(0.3, 1.2)
    block = Part.makeBox(3.0 * radius, 3.0 * radius, depth + 4.0, V(-1.5 * radius, -1.5 * radius, -depth - 4.0))
    ball = Part.makeSphere(radius, V(0, 0, radius - depth))
    return block.cut(ball), ball


def _torus(rng):
    large, small = rng.uniform(6.0, 12.0), rng.uniform(1.0, 4.0)
    side = 2.0 * (large + small) + 6.0
    ring = Part.makeTorus(large, small)
    return Part.makeBox(side, side, small + 3.0, V(-0.5 * side, -0.5 * side, -small - 3.0)).cut(ring), ring


KINDS = {"plane": _planar, "cylinder": _cylinder, "cone": _cone, "sphere": _sphere, "torus": _torus,
         "spline": _spline}


def _direction(rng):
    return V(rng.gauss(0.0, 1.0), rng.gauss(0.0, 1.0), rng.gauss(0.0, 1.0)).normalize()


def _placed(shape, placement):
    result = shape.copy()
    result.Placement = placement.multiply(result.Placement)
    return result


def contact_pair(kind, seed):
    """The pair of this kind and seed. In two of three the second one is displaced, in any direction, by at most 0.45
    of the tolerance; in two of three the whole pair is turned.
    """
    rng = random.Random(f"{kind} {seed}")
    first, second = KINDS[kind](rng)
    size = first.fuse(second).BoundBox.DiagonalLength
    tolerance = size * 10.0 ** rng.uniform(-3.3, -2.5)
    turned = FreeCAD.Rotation(_direction(rng), rng.uniform(0.0, 360.0)) if rng.random() < 0.67 else FreeCAD.Rotation()
    whole = FreeCAD.Placement(_direction(rng) * rng.choice([0.0, 50.0]), turned)
    first, second = _placed(first, whole), _placed(second, whole)
    share = rng.choice([0.0, rng.uniform(0.0, 0.45), 10.0 ** rng.uniform(-4.0, -1.0)]) * tolerance
    turn = FreeCAD.Rotation(_direction(rng), math.degrees(rng.choice([0.0, share / size])))
    moved = FreeCAD.Placement(_direction(rng) * (0.5 * share), turn, second.BoundBox.Center)
    return ContactPair(kind, seed, first, second, _placed(second, moved), tolerance)


def by_opencascade(pair, operation):
    """(shells, area, volume) of what OpenCASCADE makes of the undisplaced pair. The symmetric difference of solids that
    only touch is their union.
    """
    join = {"union": pair.first.fuse, "intersection": pair.first.common, "difference": pair.first.cut,
            "symmetric_difference": pair.first.fuse}[operation]
    solids = join(pair.second).Solids
    return sum(len(s.Shells) for s in solids), sum(s.Area for s in solids), sum(s.Volume for s in solids)


def components(triangles):
    """How many connected components a mesh has."""
    parent = list(range(int(triangles.max()) + 1)) if len(triangles) else []

    def root(v):
        while parent[v] != v:
            parent[v] = parent[parent[v]]
            v = parent[v]
        return v

    for a, b, c in triangles.tolist():
        parent[root(a)] = parent[root(b)] = root(c)
    return len({root(v) for v in set(triangles.ravel().tolist())})


def disagreement(pair, operation, result):
    """In what a BooleanMesh of the pair differs from OpenCASCADE's solid by more than the tolerance explains; "" where
    it does not.

    Surfaces within the tolerance of each other enclose volumes that differ by the tolerance times their area at most.
    Their areas differ by that of ledges along edges as wide as the tolerance, and as facets do from what they
    approximate, by about the tolerance times the size.
    """
    shells, area, volume = by_opencascade(pair, operation)
    within, report = pair.tolerance, result.report
    edges = sum(edge.Length for shape in (pair.first, pair.second) for edge in shape.Edges)
    size = pair.first.fuse(pair.second).BoundBox.DiagonalLength
    found = []
    count = components(result.triangles)
    if count != shells:
        found.append(f"{count} components of {shells}")
    if abs(report.area - area) > within * (edges + 6.0 * size):
        found.append(f"area {report.area:.6g} of {area:.6g}")
    if abs(report.volume - volume) > within * (pair.first.Area + pair.second.Area):
        found.append(f"volume {report.volume:.6g} of {volume:.6g}")
    return ", ".join(found)
