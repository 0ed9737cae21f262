#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many triangles FreeCAD's constraints find on the surface of FEM meshes of given parts, ours and of Gmsh.

    /usr/bin/python3 benchmarks/solvers/fem_faces.py PART.step ...

FreeCAD takes a triangle as one on a face where all its nodes are within the tolerance of the face.
"""

import sys
import tempfile
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad


def found_on(mesh, shape):
    """Number of triangles of a Fem.FemMesh that the search by the faces of a shape finds."""
    found = set()
    for face in shape.Faces:
        found.update(mesh.getFacesByFace(face))
    return len(found)


def rows_of(path):
    """[(mesher, triangles, found), ...] of a part."""
    import fem_meshers
    import FreeCAD
    import ObjectsFem
    import Part

    document = FreeCAD.newDocument()
    try:
        part = document.addObject("Part::Feature", "Part")
        part.Shape = Part.read(path)
        document.recompute()
        size = part.Shape.BoundBox.DiagonalLength / 20.0
        rows = []
        for name in ("MeshQuality", "Gmsh, sizes not from curvature"):
            try:
                mesh = fem_meshers.MESHERS[name](part, ObjectsFem.makeAnalysis(document), size).FemMesh
                rows.append((name, mesh.FaceCount, found_on(mesh, part.Shape)))
            except RuntimeError as error:
                rows.append((name, 0, str(error)))
        return rows
    finally:
        FreeCAD.closeDocument(document.Name)


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("parts", nargs="+", help="files with one solid each")
    return result


def work(arguments):
    import fem_meshers

    table = {}
    with tempfile.TemporaryDirectory() as folder:
        fem_meshers.use_gmsh_module(folder)
        for path in arguments.parts:
            table[Path(path).name] = rows_of(path)
            for mesher, triangles, found in table[Path(path).name]:
                print(f"| {Path(path).name} | {mesher} | {triangles:,} triangles | found: {found} |", flush=True)
    return {"parts": table}


inside_freecad.start(__file__, parser(), work)
