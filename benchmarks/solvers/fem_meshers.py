# SPDX-License-Identifier: LGPL-2.1-or-later
"""FEM mesh objects of several meshers for the same part: ours, and those of FreeCAD. Runs inside FreeCAD."""

import os
import shutil
import stat
from functools import partial

LAUNCHER = """#!/usr/bin/python3
import sys
import gmsh
gmsh.initialize()
gmsh.open(sys.argv[-1])
gmsh.finalize()
"""


def ours(part, analysis, size):
    """Our mesh object with edges of at most `size` mm."""
    import MeshQuality as mq

    return mq.add_fem_mesh(part, analysis=analysis, max_edge=size)


def gmsh(part, analysis, size, **options):
    """FreeCAD's Gmsh object with its own options but these."""
    import ObjectsFem
    from femmesh.gmshtools import GmshTools

    from MeshQuality import compat

    made = ObjectsFem.makeMeshGmsh(part.Document)
    setattr(made, compat.fem_source_property(), part)
    made.CharacteristicLengthMax, made.ElementOrder = size, "2nd"
    for name, value in options.items():
        setattr(made, name, value)
    analysis.addObject(made)
    error = GmshTools(made).create_mesh()
    if not made.FemMesh.VolumeCount:
        raise RuntimeError(error or "no tetrahedra")
    return made


def netgen(part, analysis, size):
    """FreeCAD's Netgen object; RuntimeError where FreeCAD is built without it."""
    made = part.Document.addObject("Fem::FemMeshShapeNetgenObject", "Netgen")
    made.Shape, made.MaxSize, made.SecondOrder = part, size, True
    analysis.addObject(made)
    part.Document.recompute()
    if not made.FemMesh.VolumeCount:
        raise RuntimeError("this FreeCAD is built without Netgen")
    return made


MESHERS = {"MeshQuality": ours, "Gmsh": gmsh,
           "Gmsh, curved elements optimised": partial(gmsh, HighOrderOptimize="Elastic+Optimization"),
           "Gmsh, sizes not from curvature": partial(gmsh, MeshSizeFromCurvature=0), "Netgen": netgen}


def use_gmsh_module(folder):
    """Puts a program gmsh that is Python's module on the path, where there is no other."""
    if shutil.which("gmsh"):
        return
    path = os.path.join(folder, "gmsh")
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(LAUNCHER)
    os.chmod(path, os.stat(path).st_mode | stat.S_IXUSR)
    os.environ["PATH"] = f"{folder}{os.pathsep}{os.environ['PATH']}"
