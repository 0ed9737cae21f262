# SPDX-License-Identifier: LGPL-2.1-or-later
"""Odd shapes that FreeCAD lets scripts make: moved, mirrored, sheared, nested, without curves, infinite."""

import math
import random

import FreeCAD
import numpy as np
import Part
from attack import Attack, with_patience

import MeshQuality as mq

V = FreeCAD.Vector
DEEP = 1000
FEW = 3000  # triangles
MANY = 10**4


def box():
    return Part.makeBox(1, 1, 1)


def bored():
    return Part.makeBox(10, 10, 10).cut(Part.makeCylinder(2, 30, V(5, 5, -5)))


def _transformed(shape, *numbers):
    """By a matrix that may shear."""
    return shape.transformGeometry(FreeCAD.Matrix(*numbers))


def _mirrored(shape):
    return shape.mirror(V(0, 0, 0), V(1, 0.3, 0.2))


def _nested(depth):
    shape = box()
    for _ in range(depth):
        shape = Part.makeCompound([shape])
    return shape


def _doubled(depth):
    """2^depth times the same box by sub-shapes that are shared."""
    shape = box()
    for _ in range(depth):
        shape = Part.makeCompound([shape, shape])
    return shape


def _scaled(factor):
    shape = bored()
    shape.scale(factor)
    return shape


def _far(distance):
    shape = bored()
    shape.translate(V(distance, -distance, distance))
    return shape


def _wavy(poles=8, height=5.0):
    dice = random.Random(3)
    surface = Part.BSplineSurface()
    surface.interpolate([[V(i, j, dice.uniform(-height, height)) for j in range(poles)] for i in range(poles)])
    return surface.toShape()


def _open_shell():
    return Part.makeShell(box().Faces[:5])


def _faces_turned():
    faces = box().Faces
    return Part.makeShell([face.reversed() if i % 2 else face for i, face in enumerate(faces)])


def _double_faces():
    return Part.makeCompound(box().Faces + box().Faces)


def _solid_of_open_shell():
    return Part.Solid(_open_shell())


def _void(turned):
    inner = Part.makeBox(0.5, 0.5, 0.5, V(0.25, 0.25, 0.25)).Shells[0]
    return Part.makeCompound([box(), inner.reversed() if turned else inner])


def _bow_tie():
    """A face whose wire crosses itself."""
    return Part.Face(Part.makePolygon([V(0, 0, 0), V(1, 1, 0), V(1, 0, 0), V(0, 1, 0), V(0, 0, 0)]))


def _needle_face():
    return Part.Face(Part.makePolygon([V(0, 0, 0), V(1000, 0, 0), V(1000, 1e-5, 0), V(0, 0, 0)])).extrude(V(0, 0, 1))


def _hole_outside():
    outer = Part.makePolygon([V(0, 0, 0), V(1, 0, 0), V(1, 1, 0), V(0, 1, 0), V(0, 0, 0)])
    inner = Part.makePolygon([V(2, 2, 0), V(3, 2, 0), V(3, 3, 0), V(2, 3, 0), V(2, 2, 0)])
    return Part.Face([outer, inner])


def _holes_crossing():
    outer = Part.makePolygon([V(0, 0, 0), V(9, 0, 0), V(9, 9, 0), V(0, 9, 0), V(0, 0, 0)])
    circles = [Part.Wire(Part.makeCircle(2, V(x, 4, 0))) for x in (3, 5)]
    return Part.Face([outer, *circles])


def _pipe_through_itself():
    points = [V(0, 0, 0), V(10, 0, 0), V(10, 10, 0), V(5, -5, 0)]
    return Part.Wire(Part.makePolygon(points)).makePipeShell([Part.Wire(Part.makeCircle(1, V(0, 0, 0), V(1, 0, 0)))],
                                                             True, False)


def _tolerant(tolerance):
    shape = bored()
    shape.fixTolerance(tolerance)
    return shape


def _without_pcurves():
    """A bored box from text whose curves on the cylinder are left out: read back, edges have them in space only."""
    face = Part.Cylinder().toShape(0, 2, 0, 1)
    return Part.Face(face.Surface, Part.Wire(Part.__sortEdges__(
        [Part.makeCircle(1, V(0, 0, 0), V(0, 0, 1), 0, 90), Part.makeLine(V(0, 1, 0), V(0, 1, 1)),
         Part.makeCircle(1, V(0, 0, 1), V(0, 0, 1), 0, 90), Part.makeLine(V(1, 0, 1), V(1, 0, 0))])))


def _star():
    """A face of 300 corners."""
    angles = np.linspace(0, 2 * math.pi, 301)
    return Part.Face(Part.makePolygon([V(math.cos(a) * (1 + i % 2), math.sin(a) * (1 + i % 2), 0)
                                       for i, a in enumerate(angles)]))


SHAPES = {
    "null": Part.Shape, "an empty compound": lambda: Part.makeCompound([]),
    "an empty compound in one": lambda: Part.makeCompound([Part.makeCompound([])]),
    "a vertex": lambda: Part.Vertex(0, 0, 0), "an edge": lambda: Part.makeLine(V(), V(1, 0, 0)),
    "a wire": lambda: Part.makePolygon([V(), V(1, 0, 0), V(0, 1, 0)]),
    "10^4 vertices": lambda: Part.makeCompound([Part.Vertex(i, 0, 0) for i in range(MANY)]),
    "10^4 vertices and a box": lambda: Part.makeCompound([*(Part.Vertex(i, 0, 0) for i in range(MANY)), box()]),
    "a solid with an edge beside it": lambda: Part.makeCompound([box(), Part.makeLine(V(5, 0, 0), V(9, 9, 9))]),
    "nested 1000 deep": lambda: _nested(DEEP), "one box 1024 times": lambda: _doubled(10),
    "the same solid twice": lambda: Part.makeCompound([box(), box()]),
    "an infinite plane": lambda: Part.Plane().toShape(), "an infinite cylinder": lambda: Part.Cylinder().toShape(),
    "an infinite cone": lambda: Part.Cone().toShape(),
    "a half-space": lambda: box().Faces[0].makeHalfSpace(V(0, 0, 5)),
    "an infinite extrusion": lambda: Part.SurfaceOfExtrusion(Part.Line(), V(0, 0, 1)).toShape(),
    "reversed": lambda: bored().reversed(), "mirrored": lambda: _mirrored(bored()),
    "mirrored twice": lambda: _mirrored(_mirrored(bored())),
    "scaled by -1": lambda: _scaled(-1.0),
    "sheared": lambda: _transformed(bored(), 1, 0.9, 0, 0, 0, 1, 0.5, 0, 0, 0, 1, 0),
    "flattened": lambda: _transformed(bored(), 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1e-6, 0),
    "stretched": lambda: _transformed(bored(), 1e4, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0),
    "turned inside out": lambda: _transformed(bored(), -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0),
    **{f"scaled by {factor:g}": (lambda f=factor: _scaled(f)) for factor in (1e-6, 1e-4, 1e-2, 1e2, 1e4, 1e6)},
    **{f"{distance:g} mm away": (lambda d=distance: _far(d)) for distance in (1e4, 1e6, 1e8, 1e10)},
    "a wavy face": _wavy, "a wild face": lambda: _wavy(14, 40.0), "an open shell": _open_shell,
    "faces turned": _faces_turned, "double faces": _double_faces,
    "a solid of an open shell": _solid_of_open_shell, "a void": lambda: _void(True),
    "a void not turned": lambda: _void(False),
    "a bow tie": _bow_tie, "a needle": _needle_face, "a hole outside": _hole_outside,
    "holes that cross": _holes_crossing,
    "a pipe through itself": _pipe_through_itself, "tolerances of 1": lambda: _tolerant(1.0),
    "tolerances of 100": lambda: _tolerant(100.0),
    "a face with edges in space only": _without_pcurves, "a sphere's face": lambda: Part.Sphere().toShape(),
    "a self-touching ring": lambda: Part.makeTorus(5, 5), "a spindle": lambda: Part.makeTorus(3, 5),
    "a torus as thin as a hair": lambda: Part.makeTorus(100, 1e-3),
    "a cone to a point": lambda: Part.makeCone(0, 1e-3, 1000),
    "a wedge": lambda: Part.makeWedge(0, 0, 0, 0, 0, 10, 10, 10, 5, 5),
    "a sliver of a sphere": lambda: Part.makeSphere(5, V(), V(0, 0, 1), -90, 90, 0.01),
    "a cap of a sphere": lambda: Part.makeSphere(5, V(), V(0, 0, 1), 89.9, 90, 360),
    "boxes that touch at an edge": lambda: box().fuse(Part.makeBox(1, 1, 1, V(1, 1, 0))),
    "boxes that touch at a corner": lambda: box().fuse(Part.makeBox(1, 1, 1, V(1, 1, 1))),
    "boxes that share a face": lambda: box().generalFuse([Part.makeBox(1, 1, 1, V(1, 0, 0))])[0],
    "a face of 300 corners": _star,
}
COARSE = {"max_triangles": FEW, "chord_height_relative": 0.02}
FACES = {
    "triangulate": lambda shape, progress: mq.triangulate(shape, progress=progress, **COARSE),
    "star": lambda shape, progress: mq.triangulate(shape, method="star", progress=progress, **COARSE),
    "sprinkle": lambda shape, progress: mq.triangulate(shape, method="sprinkle", connectivity="parametric",
                                                       progress=progress, **COARSE),
    "sharp edges only": lambda shape, progress: mq.triangulate(shape, keep_edges="feature", allow_missing_faces=True,
                                                               progress=progress, **COARSE),
    "curve": lambda shape, progress: mq.curve(shape, chord_height_relative=0.05, progress=progress),
    "curve volume": lambda shape, progress: mq.curve(shape, volume=True, chord_height_relative=0.05, progress=progress),
    "union": lambda shape, progress: mq.boolean(shape, Part.makeBox(0.7, 0.7, 0.7, V(0.3, 0.3, 0.3)), "union",
                                                resolution=64, progress=progress),
    "quality": lambda shape, progress: mq.quality(mq.triangulate(box()), shape, progress),
}


def rows():
    return [Attack(f"{function}: {name}", lambda c=call, m=make: with_patience(lambda progress: c(m(), progress)))
            for name, make in SHAPES.items() for function, call in FACES.items()]


def combined(dice):
    """A shape that is moved, scaled and mirrored by chance."""
    name = dice.choice([name for name in SHAPES if "10^4" not in name])
    function, call = dice.choice(list(FACES.items()))
    matrix = [dice.choice((0.0, 1.0, -1.0, dice.uniform(-2, 2))) for _ in range(12)]

    def attack():
        shape = SHAPES[name]()
        try:
            shape = shape.transformGeometry(FreeCAD.Matrix(*matrix)) if dice.random() < 0.5 else _mirrored(shape)
        except Part.OCCError:
            return  # OpenCASCADE itself refuses to make it
        with_patience(lambda progress: call(shape, progress))

    return Attack(f"{function}: {name} moved", attack)
