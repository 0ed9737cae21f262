# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of Gmsh with other elements than triangles and tetrahedra.   python3 gmsh_layers.py FOLDER

In a process of its own: Gmsh's OpenCASCADE must not meet FreeCAD's. It writes holed.msh, around.msh and torus.msh.
"""

import math
import os
import sys

import gmsh

LENGTH = 3.0


def _new():
    gmsh.clear()
    gmsh.option.setNumber("Mesh.RecombineAll", 0)
    gmsh.option.setNumber("Mesh.MeshSizeMax", 1e22)


def holed(path):
    """A plate with a hole, extruded: prisms."""
    _new()
    occ = gmsh.model.occ
    face = occ.cut([(2, occ.addRectangle(-4, -4, 0, 8, 8))], [(2, occ.addDisk(0, 0, 0, 2, 2))])[0]
    occ.extrude(face, 0, 0, LENGTH, [2], recombine=True)
    occ.synchronize()
    gmsh.option.setNumber("Mesh.MeshSizeMax", 1.6)
    gmsh.model.mesh.generate(3)
    gmsh.write(path)


def around(path, thickness=0.25):
    """The flow around a cylinder: layers of hexahedra on its wall, prisms beyond."""
    _new()
    occ = gmsh.model.occ
    face = occ.cut([(2, occ.addRectangle(-8, -8, 0, 16, 16))], [(2, occ.addDisk(0, 0, 0, 2, 2))])[0]
    occ.synchronize()
    circle = [tag for dim, tag in gmsh.model.getEntities(1) if gmsh.model.getType(1, tag) in ("Circle", "Ellipse")]
    field = gmsh.model.mesh.field
    layers = field.add("BoundaryLayer")
    field.setNumbers(layers, "CurvesList" if gmsh.__version__ >= "4.9" else "EdgesList", circle)
    for name, value in (("hwall_n" if gmsh.__version__ < "4.9" else "Size", thickness / 10), ("ratio", 1.6),
                        ("thickness", thickness), ("Quads", 1)):
        field.setNumber(layers, name, value)
    field.setAsBoundaryLayer(layers)
    occ.extrude(face, 0, 0, LENGTH, [2], recombine=True)
    occ.synchronize()
    gmsh.option.setNumber("Mesh.MeshSizeMax", 2.0)
    gmsh.model.mesh.generate(3)
    gmsh.write(path)


def torus(path):
    """A surface of quadrilaterals, and triangles where these do not fit."""
    _new()
    gmsh.model.occ.addTorus(0, 0, 0, 10, 3)
    gmsh.model.occ.synchronize()
    gmsh.option.setNumber("Mesh.RecombineAll", 1)
    gmsh.option.setNumber("Mesh.MeshSizeMax", 2 * math.pi * 3 / 8)
    gmsh.model.mesh.generate(2)
    gmsh.write(path)


if __name__ == "__main__":
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    for make in (holed, around, torus):
        make(os.path.join(sys.argv[1], f"{make.__name__}.msh"))
    gmsh.finalize()
