# SPDX-License-Identifier: LGPL-2.1-or-later
"""mq.to_solid on 26 meshes of parts: faces, validity, volume, distances both ways, STEP read back.

    freecadcmd -P Mod benchmarks/surfaces/solids_of_meshes.py </dev/null

Writes a table in Markdown to standard error.
"""

import os
import sys
import tempfile
import time

import Part
from FreeCAD import Vector

import MeshQuality as mq

BOX, CYLINDER, SPHERE = Part.makeBox(10, 20, 30), Part.makeCylinder(5, 20), Part.makeSphere(8)
ANGLE = Part.makeBox(30, 10, 10).fuse(Part.makeBox(10, 10, 30)).removeSplitter()
BRACKET = ANGLE.cut(Part.makeCylinder(2, 40, Vector(22, 5, -5))).cut(Part.makeCylinder(2, 40, Vector(-5, 5, 22), Vector(1, 0, 0)))
TUBE = Part.makeCylinder(8, 20).cut(CYLINDER)
CROSSING = Part.makeCylinder(3, 20, Vector(-10, 0, 10), Vector(1, 0, 0))
HOLE = Part.makeCylinder(1.5, 40, Vector(5, 10, -5))
MESHES = {
    "box": lambda: mq.triangulate(BOX),
    "bracket with holes": lambda: mq.triangulate(BRACKET),
    "box, edges rounded": lambda: mq.triangulate(BOX.makeFillet(2, BOX.Edges)),
    "torus": lambda: mq.triangulate(Part.makeTorus(12, 4)),
    "cone": lambda: mq.triangulate(Part.makeCone(8, 3, 15)),
    "box, offset 2": lambda: mq.offset(BOX, 2.0),
    "box, offset -2": lambda: mq.offset(BOX, -2.0),
    "cylinder, offset 2": lambda: mq.offset(CYLINDER, 2.0, tolerance=0.05),
    "cylinder, offset -2": lambda: mq.offset(CYLINDER, -2.0, tolerance=0.05),
    "angle, offset 1": lambda: mq.offset(ANGLE, 1.0),
    "angle, offset -1": lambda: mq.offset(ANGLE, -1.0),
    "bracket, offset -0.5": lambda: mq.offset(BRACKET, -0.5, tolerance=0.02),
    "bracket, offset 0.5": lambda: mq.offset(BRACKET, 0.5, tolerance=0.02),
    "cone, offset 1": lambda: mq.offset(Part.makeCone(8, 3, 15), 1.0, tolerance=0.05),
    "pointed cone, offset 1": lambda: mq.offset(Part.makeCone(8, 0, 15), 1.0, tolerance=0.05),
    "tube, offset 0.5": lambda: mq.offset(TUBE, 0.5, tolerance=0.03),
    "box, hollow, open": lambda: mq.hollow(BOX, 2.0, ["Face6"]),
    "box, hollow": lambda: mq.hollow(BOX, 2.0),
    "cylinder, hollow, open": lambda: mq.hollow(CYLINDER, 1.0, ["Face2"]),
    "angle, hollow, open": lambda: mq.hollow(ANGLE, 1.5, ["Face1"]),
    "bracket, hollow": lambda: mq.hollow(BRACKET, 1.0),
    "box - cylinder": lambda: mq.boolean(BOX, CYLINDER, "difference"),
    "box + sphere": lambda: mq.boolean(BOX, SPHERE, "union"),
    "two cylinders": lambda: mq.boolean(CYLINDER, CROSSING, "union"),
    "hollow box - cylinder": lambda: mq.boolean(mq.hollow(BOX, 2.0), HOLE, "difference"),
    "offset cylinders - box": lambda: mq.boolean(mq.offset(mq.boolean(CYLINDER, CROSSING, "union"), 0.5), BOX, "difference"),
}


def row(name, mesh, folder):
    """A line of the table."""
    start = time.perf_counter()
    try:
        solid = mq.to_solid(mesh)
    except mq.Error as error:
        return f"| {name} | {len(mesh.triangles):,} | {error} |"
    seconds = time.perf_counter() - start
    try:
        solid.write(os.path.join(folder, "solid.step"))
        step = "yes"
    except mq.IoError:
        step = "no"
    return (f"| {name} | {len(mesh.triangles):,} | {solid.faces} | {solid.facets:,} | {'yes' if solid.shape.isValid() else 'no'} | "
            f"{100.0 * (solid.volume / solid.mesh_volume - 1.0):+.3f} % | {solid.deviation:.4f} | {solid.deviation_back:.4f} | "
            f"{solid.tolerance:.4f} | {step} | {seconds:.1f} |{' '.join(solid.notes)}")


def main():
    print("| mesh | triangles | faces | facets | valid | volume | mesh to solid, mm | solid to mesh, mm | tolerance, mm | STEP read back | s |",
          file=sys.stderr)
    with tempfile.TemporaryDirectory() as folder:
        for name, make in MESHES.items():
            print(row(name, make(), folder), file=sys.stderr, flush=True)


main()
