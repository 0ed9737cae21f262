# SPDX-License-Identifier: LGPL-2.1-or-later
"""The solids of the curving benchmark, made by FreeCAD's Part module: thin, bent, pointed, drilled."""

import math

import Part
from FreeCAD import Vector

ORIGIN, X, Y, Z = Vector(), Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)


def torus():
    return Part.makeTorus(1, 0.35)


def cone():
    return Part.makeCone(1, 0, 2)


def sphere():
    return Part.makeSphere(1)


def crosscyl():
    along_x = Part.makeCylinder(0.8, 4, Vector(-2, 0, 0), X)
    along_y = Part.makeCylinder(0.6, 4, Vector(0, -2, 0), Y)
    return along_x.fuse(along_y)


def drilled():
    return Part.makeSphere(1).cut(Part.makeCylinder(0.5, 4, Vector(-2, 0, 0.2), X))


def thinplate():
    """A quarter of a thin cylinder, 0.02 of the radius thick."""
    outer = Part.makeCylinder(1, 1.5, ORIGIN, Z, 90)
    return outer.cut(Part.makeCylinder(0.98, 4, Vector(0, 0, -1), Z))


def thinshell():
    """A hemisphere, 0.03 of the radius thick."""
    return Part.makeSphere(1, ORIGIN, Z, 0, 90).cut(Part.makeSphere(0.97))


def thintube():
    return Part.makeCylinder(1, 3).cut(Part.makeCylinder(0.95, 5, Vector(0, 0, -1), Z))


def elbow():
    """A pipe bent by 90 degrees."""
    ring = Part.makeFace([Part.Wire(Part.makeCircle(radius, Vector(3, 0, 0), Z))
                          for radius in (1.0, 0.93)], "Part::FaceMakerCheese")
    return ring.revolve(ORIGIN, Y, 90)


def tee():
    outer = Part.makeCylinder(1, 5, Vector(-2.5, 0, 0), X).fuse(Part.makeCylinder(0.8, 2.5))
    inner = Part.makeCylinder(0.9, 6, Vector(-3, 0, 0), X).fuse(Part.makeCylinder(0.7, 3))
    return outer.cut(inner)


def filletbox():
    """A box with all its straight edges rounded, but not those of the hole."""
    box = Part.makeBox(2, 1.4, 1)
    box = box.makeFillet(0.25, box.Edges)
    return box.cut(Part.makeCylinder(0.35, 3, Vector(0.7, 0.7, -1), Z))


def wavyplate():
    """A B-spline surface, 0.04 thick."""
    count = 9
    poles = [[Vector(x, y, 0.35 * math.sin(2.2 * x) * math.cos(1.7 * y))
              for y in (3.0 * j / (count - 1) for j in range(count))]
             for x in (3.0 * i / (count - 1) for i in range(count))]
    surface = Part.BSplineSurface()
    inner = [i / (count - 3) for i in range(count - 2)]
    ends = [4] + [1] * (count - 4) + [4]
    surface.buildFromPolesMultsKnots(poles, ends, ends, inner, inner, False, False, 3, 3)
    return surface.toShape().extrude(Vector(0, 0, 0.04))


def discgap():
    """A disc whose hole nearly touches its rim."""
    return Part.makeCylinder(1, 0.3).cut(Part.makeCylinder(0.6, 3, Vector(0.38, 0, -1), Z))


# By name: the shape, or the file in $MESHQUALITY_DATA/cad that it is read from.
MODELS = {
    made.__name__: made for made in (sphere, torus, cone, crosscyl, drilled, thinplate, thinshell,
                                     thintube, elbow, tee, filletbox, wavyplate, discgap)
}
MODELS.update({
    "t20": "gmsh_t20_data.step", "part": "part.step", "screw": "netgen_screw.step",
    "linkrods": "linkrods.step", "nut": "mal_ecrou.brep", "CrankArm": "CrankArm.brep",
})


def load(name, folder):
    """The shape; None where its file is missing."""
    source = MODELS[name]
    if callable(source):
        return source()
    path = folder / "cad" / source
    if not path.exists():
        return None
    shape = Part.Shape()
    shape.read(str(path))
    return shape
