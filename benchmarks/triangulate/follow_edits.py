#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether meshes follow edits of parametrized parts: kept, meshed again with the reason, or wrong.

    /usr/bin/python3 benchmarks/triangulate/follow_edits.py [--judge PATH] [--only PART] [--min-angle DEGREES] [--distance FACTOR]

20 parts of FreeCAD, each with one dimension that is 1 %, 10 % and 50 % larger. A kept mesh is wrong where the judge, another program that
shares no code with the package, finds it open, crossing itself, with flipped triangles, an angle below the bound or a distance above
it, or where OpenCASCADE finds a centroid farther from its own face than the bound.
"""

import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad

EDITS = 1.01, 1.1, 1.5
SAMPLES = 60  # centroids of a mesh that OpenCASCADE measures


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--judge", default="surface_judge")
    result.add_argument("--only", default="")
    result.add_argument("--min-angle", type=float, default=25.0, help="bound of the moved mesh; the mesh is made with 25 degrees")
    result.add_argument("--distance", type=float, default=1.0, help="bound of the moved mesh, as a multiple of that of the mesh")
    return result


def blocks():
    """{name: function of the factor of one dimension}."""
    import FreeCAD
    import Part

    at, box, cylinder = FreeCAD.Vector, Part.makeBox, Part.makeCylinder

    def plate(length, width, height, *holes):
        result = box(length, width, height)
        for x, y, radius in holes:
            result = result.cut(cylinder(radius, 3 * height, at(x, y, -height)))
        return result

    def rounded(shape, radius, wanted=lambda edge: True):
        return shape.makeFillet(radius, [edge for edge in shape.Edges if wanted(edge)])

    def chamfered(shape, size):
        return shape.makeChamfer(size, shape.Edges[:4])

    def upright(edge):
        return edge.BoundBox.ZLength > 1e-6 and edge.BoundBox.XLength < 1e-6 and edge.BoundBox.YLength < 1e-6

    def angle_piece(radius):
        shape = box(40, 30, 5).fuse(box(5, 30, 40)).removeSplitter()
        return rounded(shape, radius, lambda e: abs(e.CenterOfMass.x - 5) < 1e-6 and abs(e.CenterOfMass.z - 5) < 1e-6)

    return {
        "plate, radius of the hole": lambda w: plate(40, 30, 5, (20, 15, 6 * w)),
        "plate, length": lambda w: plate(40 * w, 30, 5, (20, 15, 6)),
        "plate of two holes, place of one": lambda w: plate(60, 30, 8, (15, 15, 5), (30 * w, 15, 5)),
        "plate, height": lambda w: plate(40, 30, 5 * w, (12, 15, 4), (28, 15, 4)),
        "block with a blind hole, depth": lambda w: box(20, 20, 20).cut(cylinder(5, 20, at(10, 10, 20 - 8 * w))),
        "block with crossing bores, radius": lambda w: box(20, 20, 20).cut(cylinder(4 * w, 40, at(10, 10, -5))).cut(
            cylinder(3, 40, at(-5, 10, 10), at(1, 0, 0))),
        "angle piece, radius of the fillet": lambda w: angle_piece(4 * w),
        "block, all edges rounded, radius": lambda w: rounded(box(30, 20, 10), 2 * w),
        "block, upright edges rounded, length": lambda w: rounded(box(30 * w, 20, 10), 3, upright),
        "cylinder with rounded rims, height": lambda w: rounded(cylinder(8, 20 * w), 2, lambda e: e.BoundBox.ZLength < 1e-6),
        "block with chamfers, size": lambda w: chamfered(box(20, 20, 20), 2 * w),
    }


def lofts_and_turned_parts():
    """Likewise."""
    import FreeCAD
    import Part

    at, circle = FreeCAD.Vector, lambda r, x, y, z: Part.Wire(Part.makeCircle(r, at(x, y, z)))

    def turned(*points):
        corners = [at(x, 0, z) for x, z in points]
        return Part.Face(Part.makePolygon([*corners, corners[0]])).revolve(at(0, 0, 0), at(0, 0, 1), 360)

    def spline_turned(radius):
        curve = Part.BSplineCurve()
        curve.interpolate([at(8, 0, 0), at(radius, 0, 10), at(5, 0, 20), at(7, 0, 30)])
        side = curve.toShape()
        low, top = at(8, 0, 0), at(7, 0, 30)
        rest = Part.makePolygon([top, at(3, 0, 30), at(3, 0, 0), low])
        return Part.Face(Part.Wire([side, *rest.Edges])).revolve(at(0, 0, 0), at(0, 0, 1), 360)

    return {
        "loft of two circles, radius": lambda w: Part.makeLoft([circle(5 * w, 0, 0, 0), circle(3, 0, 0, 15)], True),
        "loft of three circles, height": lambda w: Part.makeLoft([circle(5, 0, 0, 0), circle(3, 1, 0, 10), circle(4, 0, 0, 20 * w)], True),
        "loft of squares, size of one": lambda w: Part.makeLoft(
            [Part.makePolygon([at(x * s, y * s, z) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1))])
             for s, z in ((6, 0), (4 * w, 10), (5, 20))], True),
        "loft of squares, ruled, height": lambda w: Part.makeLoft(
            [Part.makePolygon([at(x * s, y * s, z) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1))])
             for s, z in ((6, 0), (4, 10 * w))], True, True),
        "ring, outer radius": lambda w: turned((6, 0), (10 * w, 0), (10 * w, 5), (6, 5)),
        "stepped shaft, length of a step": lambda w: turned((0, 0), (8, 0), (8, 10 * w), (5, 10 * w), (5, 25 * w), (0, 25 * w)),
        "turned spline, radius": lambda w: spline_turned(9 * w),
        "torus, small radius": lambda w: Part.makeTorus(10, 3 * w),
        "cone with a bore, radius": lambda w: Part.makeCone(10 * w, 6, 20).cut(Part.makeCylinder(3, 60, at(0, 0, -20))),
    }


def faults(mesh, shape, min_angle, chord, judge):
    """Sentences: what is wrong with a mesh that was kept."""
    import FreeCAD
    import numpy as np
    import Part

    found = []
    with tempfile.TemporaryDirectory() as folder:
        mesh.write(f"{folder}/mesh.ply")
        shape.exportBrep(f"{folder}/shape.brep")
        said = subprocess.run([judge, f"{folder}/mesh.ply", f"{folder}/shape.brep", "--json"], capture_output=True, text=True, check=True)
    figures = json.loads(said.stdout)
    size = figures["brep_L"]
    found += [name for name in ("closed", "manifold", "oriented") if not figures[name]]
    found += [f"{name} {figures[name]}" for name in ("self_intersections", "flipped_normals") if figures[name]]
    if figures["min_angle"] < min_angle - 1e-6:
        found.append(f"angle {figures['min_angle']:.3f}")
    for name in ("chord_max_L", "reverse_max_L"):
        # The reverse distance of a mesh within the bound may be a little larger, at places between its samples.
        if figures[name] * size > chord * (1.001 if name == "chord_max_L" else 1.2):
            found.append(f"{name} {figures[name] * size:.4g} mm")
    chosen = np.unique(np.linspace(0, len(mesh.triangles) - 1, SAMPLES).astype(int))
    for k, p in zip(chosen.tolist(), mesh.vertices[mesh.triangles[chosen]].mean(axis=1) + mesh.origin):
        away = Part.Vertex(FreeCAD.Vector(*p)).distToShape(shape.Faces[mesh.triangle_face[k]])[0]
        if away > 1.001 * chord:
            found.append(f"triangle {k} is {away:.4g} mm from its face")
    return found


def work(asked):
    import MeshQuality as mq

    rows = {}
    for name, make in {**blocks(), **lofts_and_turned_parts()}.items():
        if asked.only not in name:
            continue
        mesh = mq.triangulate(make(1.0))
        bound = asked.distance * mesh.report.chord_height_asked
        for edit in EDITS:
            shape = make(edit)
            start = time.perf_counter()
            result = mq.follow(mesh, shape, min_angle=asked.min_angle, chord_height=bound)
            middle = time.perf_counter()
            mq.triangulate(shape, min_angle=asked.min_angle, chord_height=bound)
            again = time.perf_counter() - middle
            wrong = faults(result, shape, asked.min_angle, bound, asked.judge) if result.kept else []
            row = rows.setdefault(edit, {"kept": 0, "remeshed": 0, "wrong": 0, "seconds": 0.0, "again": 0.0})
            row["wrong" if wrong else "kept" if result.kept else "remeshed"] += 1
            row["seconds"] += middle - start if result.kept else 0.0
            row["again"] += again if result.kept else 0.0
            print(f"{name} | {edit - 1:.0%} | {len(mesh.triangles)} | {'WRONG' if wrong else 'kept' if result.kept else 'meshed again'} | "
                  f"{'; '.join(wrong or result.reasons)} | {result.report.min_angle:.2f} | {middle - start:.2f} | {again:.2f}", flush=True)
    for edit, row in rows.items():
        print(f"{edit - 1:.0%}: {json.dumps(row)}", flush=True)
    return {"rows": rows}


inside_freecad.start(__file__, parser(), work)
