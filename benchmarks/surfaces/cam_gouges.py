# SPDX-License-Identifier: LGPL-2.1-or-later
"""How deep a ball cutter gouges the part where it is driven over meshes of it, by the drop cutter of OpenCAMLib, which FreeCAD's
3D surface operation uses.

    freecadcmd -P <root>/Mod benchmarks/surfaces/cam_gouges.py </dev/null
    MESHQUALITY_OPERATION=1 freecadcmd -P <root>/Mod benchmarks/surfaces/cam_gouges.py </dev/null
Needs OpenCAMLib for FreeCAD's Python (pip install opencamlib); MESHQUALITY_OPENCAMLIB names its folder where it is elsewhere.

Five parts, each meshed by FreeCAD's tessellation, by triangulate and by cam with the same tolerance. The cutter drops onto each at the
points of a grid. The gouge is the radius less the distance of the cutter's centre from the CAD, by OpenCASCADE: above 0 metal of the part is cut.

With MESHQUALITY_OPERATION the 3D surface operation itself drives the cutter over the part, which it tessellates, and over the solid that To solid
makes of the CAM mesh; the centres are those of the moves of its path, but for those on the floor beside the part. Its bounding box is that of
the stock: with that of the model it computes envelopes of all facets, which takes minutes.
"""

import os
import sys
import time

import FreeCAD
import numpy as np
import Part

import MeshQuality as mq

sys.path.append(os.environ.get("MESHQUALITY_OPENCAMLIB", ""))
import opencamlib as ocl  # noqa: E402

sys.modules["ocl"] = ocl  # the name under which FreeCAD's operation asks for it first

RADIUS, STEP, TOLERANCE, FLOOR = 3.0, 1.5, 0.1, 1e-3  # mm


def parts():
    """{name: solid}; tops that a cutter reaches from above."""
    box = Part.makeBox(60, 40, 20)
    return {"rounded box": box.makeFillet(5, box.Edges), "pocket": box.cut(Part.makeCylinder(12, 30, FreeCAD.Vector(30, 20, 8))),
            "cone": Part.makeCone(25, 5, 30), "dome": Part.makeBox(60, 60, 10).fuse(Part.makeSphere(20, FreeCAD.Vector(30, 30, 10))),
            "torus": Part.makeTorus(25, 8)}


def dropped(corners, box):
    """float64 (n, 3): the cutter's centres where it rests on the triangles (T, 3, 3), at a grid over a box."""
    surface = ocl.STLSurf()
    for triangle in corners.tolist():
        surface.addTriangle(ocl.Triangle(*(ocl.Point(*point) for point in triangle)))
    drop, cutter = ocl.BatchDropCutter(), ocl.BallCutter(2 * RADIUS, 100.0)  # which the library does not keep
    drop.setSTL(surface)
    drop.setCutter(cutter)
    for x in np.arange(box.XMin, box.XMax, STEP):
        for y in np.arange(box.YMin, box.YMax, STEP):
            drop.appendPoint(ocl.CLPoint(float(x), float(y), box.ZMin))
    drop.run()
    points = np.array([(point.x, point.y, point.z) for point in drop.getCLPoints()])
    return points[points[:, 2] > box.ZMin] + (0, 0, RADIUS)


def operated(model):
    """The same of the moves of a 3D surface operation over a document object, in the same steps. The part has moved with its stock's corner."""
    import PathScripts.PathJob as PathJob
    import PathScripts.PathSurface as PathSurface
    import PathScripts.PathToolBit as PathToolBit

    job = PathJob.Create("Job", [model], None)
    job.Tools.Group[0].Tool = PathToolBit.Factory.Create("Ball", os.path.join(FreeCAD.getHomePath(), "Mod", "Path", "Tools", "Shape", "ballend.fcstd"))
    job.Tools.Group[0].Tool.Diameter = 2 * RADIUS
    made = PathSurface.Create("Surface", parentJob=job)
    made.ToolController, made.BoundBox, made.CutPattern, made.LayerMode = job.Tools.Group[0], "Stock", "ZigZag", "Single-pass"
    made.StepOver, made.SampleInterval, made.LinearDeflection = 100.0 * STEP / (2 * RADIUS), STEP, TOLERANCE
    model.Document.recompute()
    found, at = [], {"X": None, "Y": None, "Z": None}
    for command in made.Path.Commands:
        at.update({axis: command.Parameters[axis] for axis in at if axis in command.Parameters})
        if command.Name == "G1" and None not in at.values():
            found.append(tuple(at.values()))
    return np.array(found) + (0, 0, RADIUS)


def gouges(centres, shape):
    """float64 (n,), mm: above 0 the cutter is in the part."""
    surface = Part.makeCompound(shape.Faces)
    found = []
    for centre in centres:
        place = FreeCAD.Vector(*map(float, centre))
        distance = Part.Vertex(place).distToShape(surface)[0]
        found.append(RADIUS + distance if shape.isInside(place, 1e-9, False) else RADIUS - distance)
    return np.array(found)


def tessellated(shape):
    """The corners of FreeCAD's tessellation, as its 3D surface operation takes it."""
    points, triangles = shape.copy().tessellate(TOLERANCE)
    return np.array([tuple(point) for point in points])[np.array(triangles)]


def corners_of(mesh):
    return (mesh.vertices + mesh.origin)[mesh.triangles]


def drop_cutter():
    """(part, mesh, triangles, seconds to mesh, seconds to drop, gouges) of each, by the library."""
    makers = {"FreeCAD": tessellated, "triangulate": lambda shape: corners_of(mq.triangulate(shape, chord_height=TOLERANCE, min_angle=1)),
              "cam": lambda shape: corners_of(mq.cam(shape, TOLERANCE))}
    for name, shape in parts().items():
        for maker, make in makers.items():
            begun = time.process_time()
            corners = make(shape)
            meshed = time.process_time()
            centres = dropped(corners, shape.BoundBox)
            yield name, maker, len(corners), meshed - begun, time.process_time() - meshed, gouges(centres, shape)


def operation():
    """The same by FreeCAD's operation."""
    for name, shape in parts().items():
        document = FreeCAD.newDocument(name.replace(" ", ""))
        part = document.addObject("Part::Feature", "Part")
        part.Shape = shape
        document.recompute()
        begun = time.process_time()
        made = mq.add_cam_mesh(part, tolerance=TOLERANCE)
        solid = mq.add_solid(made)
        for maker, model, count, meshed in (("FreeCAD", part, len(tessellated(shape)), 0.0),
                                            ("cam, to solid", solid, made.Mesh.CountFacets, time.process_time() - begun)):
            started = time.process_time()
            centres = operated(model)
            driven = time.process_time() - started
            yield name, maker, count, meshed, driven, gouges(centres[centres[:, 2] > shape.BoundBox.ZMin + RADIUS + FLOOR], shape)
        FreeCAD.closeDocument(document.Name)


def main():
    print(f"{'part':<12} {'mesh':<14} {'triangles':>9} {'mesh s':>7} {'drop s':>7} {'points':>7} {'deepest gouge, mm':>18} {'left standing, mm':>18}")
    for name, maker, count, meshed, driven, found in operation() if "MESHQUALITY_OPERATION" in os.environ else drop_cutter():
        print(f"{name:<12} {maker:<14} {count:>9,} {meshed:>7.2f} {driven:>7.2f} {len(found):>7,} {max(found.max(), 0.0):>18.4f} {-found.min():>18.4f}", flush=True)


main()
