#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What it saves that equal bodies of an assembly are refined once: processor seconds, queries, predicates.

    /usr/bin/python3 benchmarks/triangulate/equal_bodies.py [--threads 1] [--rounds 5] [--bolts 20]

as1-oc-214 of $MESHQUALITY_DATA/cad, and bolts that are turned by odd angles, are meshed as they are and
with local sizes that change nothing, but differ from body to body, so that none is equal to another one.
Both take turns; of each the round with the least processor time counts.
"""

import sys
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad

LEVELS = (1e-3, 1e-4)
NEVER = 1e6  # mm: no edge is as long


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--threads", type=int, default=1)
    result.add_argument("--rounds", type=int, default=5)
    result.add_argument("--bolts", type=int, default=20)
    return result


def bolts(count):
    import FreeCAD
    import Part

    head, shank = Part.makeCylinder(8, 5), Part.makeCylinder(4, 20, FreeCAD.Vector(0, 0, -20))
    solid = head.fuse(shank).removeSplitter()
    rims = [edge for edge in solid.Edges if len(edge.Vertexes) == 1 and abs(edge.Vertexes[0].Z - 5) < 1e-6]
    bolt = solid.makeFillet(1.0, rims).Solids[0]
    placed = []
    for i in range(count):
        placed.append(Part.Shape(bolt))
        turn = FreeCAD.Rotation(FreeCAD.Vector(1, 2, 3), 37.123 * i)
        placed[-1].Placement = FreeCAD.Placement(FreeCAD.Vector(30 * (i % 5), 40 * (i // 5), 0), turn)
    return Part.makeCompound(placed)


def sizes_that_differ(shape):
    sizes, face = {}, 1
    for number, solid in enumerate(shape.Solids):
        sizes[f"Face{face}"] = NEVER + number
        face += len(solid.Faces)
    return sizes


def measured(shape, options):
    import MeshQuality as mq

    cpu = time.process_time()
    mesh = mq.triangulate(shape, **options)
    cpu = time.process_time() - cpu
    report = mesh.report
    return {"cpu": cpu, "triangles": len(mesh.triangles), "queries": report.queries, "predicates": report.predicates,
            "smallest angle": report.min_angle_unexempted, "crossings": report.self_intersections}


def case(name, shape, relative, arguments):
    options = {"chord_height_relative": relative, "threads": arguments.threads}
    ways = {"apart": {**options, "local_sizes": sizes_that_differ(shape)}, "equal": options}
    runs = {way: [] for way in ways}
    for _ in range(arguments.rounds):
        for way, how in ways.items():
            runs[way].append(measured(shape, how))
    best = {way: min(rounds, key=lambda one: one["cpu"]) for way, rounds in runs.items()}
    print(f"{name} at {relative:g} L, {len(shape.Solids)} solids: " + "; ".join(
        f"{what} {best['apart'][what]:.6g} -> {best['equal'][what]:.6g}" for what in best["apart"]), flush=True)
    return {"part": name, "relative": relative, **best}


def work(arguments):
    import Part

    name = "as1-oc-214.stp"
    assembly = Part.Shape()
    assembly.read(str(inside_freecad.data_folder() / "cad" / name))
    made = bolts(arguments.bolts)
    return {"cases": [case(title, shape, relative, arguments)
                      for title, shape in ((name, assembly), (f"{arguments.bolts} bolts", made)) for relative in LEVELS]}


inside_freecad.start(__file__, parser(), work)
