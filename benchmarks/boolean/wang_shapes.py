#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Uniform Booleans of shapes like the models of Wang's table: CAD faces sampled, beside meshes sampled.

    /usr/bin/python3 benchmarks/boolean/wang_shapes.py [--resolutions 65 129 257 513] [--pairs helix ring] [--most 4000]

Rows "faces" have shapes for operands. Rows "default" have the meshes that `triangulate` makes of them without options, rows
"cell" meshes that deviate from them by half the distance r between rays at most. The reference is OpenCASCADE's own Boolean of
the shapes. Distances are taken both ways by VTK, as Metro does, over points that lie evenly on the area: from points of the result
to triangles of the reference that deviate by 0.001 % of the diagonal at most, and from points on the faces of the reference
(vertices of these triangles, any points where the face is plane) to the result. The mean is the larger of the two
means, in per cent of the diagonal of the reference's box, as in the table; so are the 99 % quantile and the largest. The time is
that of the clock, with the meshing, the memory what the process needs beyond what it had. The status is 1 where the mean of
rows "faces" is not below the others; further errors that are not are listed.
"""

import ctypes
import sys
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad
import numpy as np
from metro import even_points

HEAD = (f"{'pair':<24} {'rays':>5} {'from':<8} {'triangles':>9} {'mean %':>9} {'99 % in':>9} {'largest %':>9} {'r %':>7} {'s':>6} "
        f"{'CPU s':>6} {'MB':>5} {'faults':>6}")
# Deviation of the triangles that stand for the reference, in fractions of the diagonal: 0.001 %.
FINE = 1e-5
ERRORS = ("mean", "quantile", "largest")
# Parts of the data folder: where beside the middle of their box the tool lies, in fractions of the box.
PARTS = (("axle.step", (0.2, 0.1, 0.1)), ("CrankArm.brep", (0.25, 0.1, 0.2)), ("bottle.brep", (0.2, 0.1, 0.1)),
         ("0049_control_arm.step", (0.1, 0.2, 0.1)))


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--resolutions", type=int, nargs="+", default=[65, 129, 257, 513])
    result.add_argument("--pairs", nargs="+", help="only those whose names contain one of these words")
    result.add_argument("--most", type=int, default=4000, help="points measured each way")
    return result


def helix():
    """A tube along a helix."""
    import Part
    from FreeCAD import Vector

    spine = Part.makeHelix(6.0, 21.0, 8.0)
    section = Part.Wire([Part.makeCircle(1.7, Vector(8.0, 0.0, 0.0), Vector(0.0, 1.0, 0.12))])
    return Part.Wire(spine).makePipeShell([section], True, True)


def gear():
    """A wheel with 18 teeth whose flanks are splines, with a bore."""
    import math

    import Part
    from FreeCAD import Vector

    teeth, edges = 18, []
    for k in range(teeth):
        def at(radius, share, k=k):
            angle = 2.0 * math.pi * (k + share) / teeth
            return Vector(radius * math.cos(angle), radius * math.sin(angle), 0.0)

        edges += [Part.Arc(at(12.0, 0.30), at(12.02, 0.40), at(12.0, 0.50)).toShape()]
        for points in ([at(9.5, 0.2), at(10.4, 0.24), at(11.3, 0.27), at(12.0, 0.3)],
                       [at(12.0, 0.5), at(11.3, 0.53), at(10.4, 0.56), at(9.5, 0.6)]):
            flank = Part.BSplineCurve()
            flank.interpolate(points)
            edges.append(flank.toShape())
        edges.append(Part.Arc(at(9.5, 0.6), at(9.45, 0.9), at(9.5, 1.2)).toShape())
    wire = Part.Wire(Part.__sortEdges__(edges))
    return Part.Face(wire).extrude(Vector(0.0, 0.0, 5.0)).cut(Part.makeCylinder(3.1, 9.0, Vector(0.2, 0.1, -2.0)))


def bracket():
    """An angle with rounded edges and holes."""
    import Part
    from FreeCAD import Vector

    solid = Part.makeBox(30.0, 18.0, 4.0).fuse(Part.makeBox(4.0, 18.0, 22.0)).removeSplitter()
    inner = [edge for edge in solid.Edges
             if all(abs(v.X - 4.0) < 1e-6 and abs(v.Z - 4.0) < 1e-6 for v in edge.Vertexes)]
    solid = solid.makeFillet(3.0, inner)
    for x in (12.0, 23.0):
        solid = solid.cut(Part.makeCylinder(2.3, 10.0, Vector(x, 9.1, -2.0)))
    return solid.cut(Part.makeCone(2.0, 4.2, 8.0, Vector(-2.0, 9.1, 14.0), Vector(1.0, 0.0, 0.0)))


def made():
    """(name, operands, operation), after the table: cube n sphere, chair - flower, helix - slices, that n cylinder, ring and
    bars, two rings, and parts that CAD has."""
    import Part
    from FreeCAD import Vector

    yield ("cube n sphere", [Part.makeBox(17.1, 16.3, 15.9, Vector(-8.4, -8.1, -7.9)), Part.makeSphere(10.3)],
           "intersection")
    slabs = [Part.makeBox(24.0, 24.0, 0.9, Vector(-12.1, -12.2, 0.7 + 3.31 * k)) for k in range(6)]
    yield ("helix - slices", [helix(), *slabs], "difference")
    yield ("helix n cylinder", [helix(), Part.makeCylinder(7.7, 30.0, Vector(0.4, 0.3, -4.0))], "intersection")
    ring = Part.makeTorus(11.0, 2.6)
    bars = [Part.makeBox(31.0, 2.1, 1.9, Vector(-15.3, y, -0.9)) for y in (-6.1, -0.8, 4.7)]
    yield ("ring U bars", [ring, *bars], "union")
    yield ("ring - bars", [ring, *bars], "difference")
    yield ("ring U ring", [ring, Part.makeTorus(9.0, 2.2, Vector(12.3, 0.4, 0.7), Vector(0.0, 1.0, 0.2))], "union")
    yield ("gear - ring", [gear(), Part.makeTorus(8.0, 1.3, Vector(0.1, 0.2, 5.0))], "difference")
    yield ("bracket U pipe", [bracket(), Part.makeCylinder(3.2, 40.0, Vector(-5.0, 8.7, 12.5), Vector(1.0, 0.05, -0.1))],
           "union")


def from_files():
    import Part
    from FreeCAD import Vector

    folder = inside_freecad.data_folder() / "cad"
    for name, beside in PARTS:
        path = folder / name
        if not path.exists():
            print(f"missing: {path}")
            continue
        shape = Part.Shape()
        shape.read(str(path))
        box = shape.BoundBox
        sides = (box.XLength, box.YLength, box.ZLength)
        centre = Vector(*(middle + share * side for middle, share, side in zip(box.Center, beside, sides)))
        yield f"{path.stem} - sphere", [shape, Part.makeSphere(0.33 * max(sides), centre)], "difference"


def exact(operands, operation):
    first, *others = operands
    for other in others:
        first = {"difference": first.cut, "union": first.fuse, "intersection": first.common}[operation](other)
    return first


def corners_of(mesh):
    return (mesh.vertices + mesh.origin)[mesh.triangles]


class Reference:
    """OpenCASCADE's Boolean of the shapes, and points evenly on its faces."""

    def __init__(self, operands, operation, most):
        import MeshQuality as mq
        import Part
        from offset_parts import locator

        self.shape, self.most = exact(operands, operation), most
        self.diagonal = self.shape.BoundBox.DiagonalLength
        fine = mq.triangulate(self.shape, chord_height=FINE * self.diagonal)
        self.distances, _, _ = locator(fine.vertices + fine.origin, fine.triangles)
        # Points of triangles on planes, corners of the others: all of them lie on the faces.
        rng, corners = np.random.default_rng(3), corners_of(fine)
        plane = np.array([isinstance(face.Surface, Part.Plane) for face in self.shape.Faces])[fine.triangle_face]
        self.points = even_points(corners, most, rng, corners_only=~plane)

    def errors(self, result):
        """Mean, 99 % quantile and largest of the distances from the result to the faces, and the other way, in per cent
        of the diagonal."""
        from offset_parts import locator

        points = even_points(corners_of(result), self.most, np.random.default_rng(7))
        to = self.distances(points)
        nearest, _, _ = locator(result.vertices + result.origin, result.triangles)
        return [[float(100.0 * value / self.diagonal) for value in (d.mean(), np.quantile(d, 0.99), d.max())]
                for d in (to, nearest(self.points))]


def memory():
    """MB that the process has at most since forget_memory()."""
    with open("/proc/self/status", encoding="ascii") as status:
        return next(int(line.split()[1]) for line in status if line.startswith("VmHWM")) / 1024


def forget_memory():
    """Gives free memory back, so that what is needed next counts; returns the MB that the process has."""
    ctypes.CDLL("libc.so.6").malloc_trim(0)
    with open("/proc/self/clear_refs", "w", encoding="ascii") as peak:
        peak.write("5")
    return memory()


def meshes_of(operands, source, spacing):
    import MeshQuality as mq

    if source == "faces":
        return operands
    return [mq.triangulate(shape, **({} if source == "default" else {"chord_height": spacing / 2})) for shape in operands]


def row(name, rays, source, operands, operation, reference, spacing):
    import MeshQuality as mq

    had, wall, cpu = forget_memory(), time.perf_counter(), time.process_time()
    result = mq.boolean(meshes_of(operands, source, spacing), operation=operation, method="uniform", resolution=rays)
    wall, cpu, megabytes = time.perf_counter() - wall, time.process_time() - cpu, memory() - had
    to, back = reference.errors(result)
    mean, most, largest = map(max, zip(to, back))
    print(f"{name:<24} {rays:>5} {source:<8} {len(result.triangles):>9} {mean:>9.2e} {most:>9.2e} {largest:>9.2e} "
          f"{100 * spacing / reference.diagonal:>7.3f} {wall:>6.2f} {cpu:>6.2f} {megabytes:>5.0f} {result.report.faults_left:>6}",
          flush=True)
    return {"pair": name, "rays": rays, "from": source, "triangles": len(result.triangles), "mean": mean, "quantile": most,
            "largest": largest, "to": to, "back": back, "spacing": spacing, "diagonal": reference.diagonal,
            "seconds": wall, "cpu_seconds": cpu, "megabytes": megabytes, "faults": result.report.faults_left,
            "closed": result.report.closed, "stages": dict(result.report.seconds), "notes": list(result.report.notes)}


def rows_of(name, operands, operation, arguments):
    reference = Reference(operands, operation, arguments.most)
    boxes = [shape.BoundBox for shape in operands]
    side = max(max(getattr(box, f"{axis}Max") for box in boxes) - min(getattr(box, f"{axis}Min") for box in boxes)
               for axis in "XYZ")
    return [row(name, rays, source, operands, operation, reference, side / rays)
            for rays in arguments.resolutions for source in ("default", "cell", "faces")]


def work(arguments):
    print(HEAD)
    rows = []
    for name, operands, operation in [*made(), *from_files()]:
        if not arguments.pairs or any(word in name for word in arguments.pairs):
            rows += rows_of(name, operands, operation, arguments)
    faces = {(row["pair"], row["rays"]): row for row in rows if row["from"] == "faces"}
    worse = [f"{row['pair']} {row['rays']} {error} ({row['from']})" for row in rows if row["from"] != "faces"
             for error in ERRORS if faces[row["pair"], row["rays"]][error] >= row[error]]
    print(f"faces not below: {', '.join(worse) or 'none'}")
    for error in ERRORS:
        for source in ("default", "cell"):
            times = [row[error] / faces[row["pair"], row["rays"]][error] for row in rows if row["from"] == source]
            print(f"{error} from {source}, times that from faces: {np.min(times):.2f} to {np.max(times):.1f}, {np.median(times):.1f} "
                  "in the median")
    return {"rows": rows, "worse": worse, "status": 1 if any(" mean " in text for text in worse) else 0}


inside_freecad.start(__file__, parser(), work)
