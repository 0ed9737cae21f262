# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of the kinds on which Ruiz et al. show their algorithms: bearing, helical part, crank, support.

Between them: several shells, faces with several holes, faces whose sizes differ by 1e4, and
curvature that varies much within one face.
"""

import math

import Part
from FreeCAD import Vector

BALLS = 8
PITCH = 24.0


def bearing():
    """Two grooved rings and eight balls: ten solids, ten shells."""
    groove = Part.makeTorus(30.0, 5.2)
    inner = Part.makeCylinder(27.0, 14.0, Vector(0, 0, -7))
    inner = inner.cut(Part.makeCylinder(20.0, 14.0, Vector(0, 0, -7))).cut(groove)
    outer = Part.makeCylinder(40.0, 14.0, Vector(0, 0, -7))
    outer = outer.cut(Part.makeCylinder(33.0, 14.0, Vector(0, 0, -7))).cut(groove)
    balls = []
    for k in range(BALLS):
        angle = 2.0 * math.pi * k / BALLS
        balls.append(Part.makeSphere(5.0, Vector(30 * math.cos(angle), 30 * math.sin(angle), 0)))
    return Part.makeCompound([inner, outer, *balls])


def helix():
    """A round wire swept along a helix of two turns."""
    path = Part.makeHelix(PITCH, 2.0 * PITCH, 20.0)
    start = path.Vertexes[0].Point
    circle = Part.makeCircle(3.0, start, path.Edges[0].tangentAt(path.Edges[0].FirstParameter))
    return Part.Wire(path).makePipeShell([Part.Wire(circle)], True, True).Solids[0]


def crank():
    """A crank with two eyes, filleted all around its arm."""
    eye = Part.makeCylinder(18.0, 24.0)
    pin = Part.makeCylinder(10.0, 40.0, Vector(80, 0, -16))
    arm = Part.makeBox(80.0, 14.0, 12.0, Vector(0, -7, 6))
    shape = eye.fuse(arm).fuse(pin).removeSplitter()
    inner = [e for e in shape.Edges if _joins(e)]
    shape = shape.makeFillet(2.0, inner)
    return shape.cut(Part.makeCylinder(9.0, 24.0)).Solids[0]


def _joins(edge):
    """An edge of the arm at the eye or the pin."""
    box = edge.BoundBox
    return box.ZMin > 5.9 and box.ZMax < 18.1 and box.YMin > -7.1 and box.YMax < 7.1 \
        and (box.XMax < 18.0 or 69.0 < box.XMin) and box.ZLength > 1.0


def support():
    """A plate with many holes, two ribs, and a chamfer a ten-thousandth of the plate's area."""
    plate = Part.makeBox(120.0, 80.0, 8.0)
    for i in range(5):
        for j in range(3):
            hole = Part.makeCylinder(2.0 + i, 8.0, Vector(15 + 22 * i, 18 + 22 * j, 0))
            plate = plate.cut(hole)
    rib = Part.makeBox(120.0, 4.0, 20.0, Vector(0, 0, 8))
    shape = plate.fuse(rib).fuse(rib.translated(Vector(0, 76, 0))).removeSplitter()
    corner = [e for e in shape.Edges
              if len({round(v.Z, 6) for v in e.Vertexes}) == 2
              and all(v.X < 1e-6 and v.Y < 1e-6 for v in e.Vertexes)]
    return shape.makeChamfer(0.02, corner[:1]).Solids[0]


def warped_face(in_u, in_v):
    """A rational Bezier face; weights in geometric progression only change its parameters.

    Along u they run in_u times as fast at one end as in the middle, in_u**2 times as at the other.
    """
    surface = Part.BezierSurface()
    surface.increase(3, 3)
    for i in range(4):
        for j in range(4):
            height = 4.0 if (i in (1, 2)) != (j in (1, 2)) else 0.0
            surface.setPole(i + 1, j + 1, Vector(10 * i / 3, 10 * j / 3, height))
            surface.setWeight(i + 1, j + 1, in_u**i * in_v**j)
    return surface.toShape()
