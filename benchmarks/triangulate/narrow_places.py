#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many solids with one narrow place each are meshed well: six classes of narrow_shapes.py, by seeds.

    /usr/bin/python3 benchmarks/triangulate/narrow_places.py [--parts 100] [--first 0] [--only corner] [--judge PROGRAM]

Each solid is meshed by a process of its own at 25 degrees and 2e-3 of its size, in at most 60 CPU seconds. Of each class the
rates are shown of those that are meshed, closed and oriented, keep the angle but where the part itself forbids it, keep the
distance, have no crossings, and have at most twenty times the triangles of BRepMesh; `good` are those with all of it. With
--judge, a program that reads MESH SHAPE --json, the judge says all of that but the number of triangles; without it our own
report does. Seeds of those that are not good are listed.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad

ANGLE, DISTANCE = 25.0, 2e-3  # degrees; of the size
SECONDS, GIBIBYTES = 60.0, 6.0  # a part
MANY_TIMES = 20
SLACK = 1.05  # of the distance: the judge takes the largest side of another box
LISTED = 12  # seeds a class
ASPECTS = ("meshed", "closed", "angle", "distance", "crossings", "triangles")


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--parts", type=int, default=100, help="of each class")
    result.add_argument("--first", type=int, default=0, help="the first seed")
    result.add_argument("--only", action="append", help="a class; may be given more than once")
    result.add_argument("--judge", help="program that judges a mesh: MESH SHAPE --json")
    return result


def meshed(kind, seed, judge):
    """What came of one solid: {aspect: whether it is good}, and numbers."""
    import MeshQuality as mq
    from narrow_shapes import narrow_solid

    shape, numbers = narrow_solid(kind, seed)
    box = shape.BoundBox
    size = max(box.XLength, box.YLength, box.ZLength)
    peer = len(shape.copy().tessellate(DISTANCE * size)[1])
    mesh = mq.triangulate(shape, min_angle=ANGLE, chord_height_relative=DISTANCE)
    report = mesh.report
    forced = sum(reason.forced for _, reason in report.exempt_reasons)
    found = {"meshed": True, "closed": report.closed and report.oriented, "angle": forced == len(report.exempt),
             "distance": report.max_chord_height <= report.chord_height_asked * SLACK, "crossings": not report.self_intersections,
             "triangles": report.triangles <= MANY_TIMES * peer}
    if judge:
        with tempfile.TemporaryDirectory() as folder:
            mesh.write(f"{folder}/mesh.ply")
            shape.exportBrep(f"{folder}/part.brep")
            told = json.loads(subprocess.run([judge, f"{folder}/mesh.ply", f"{folder}/part.brep", "--json", "--samples", "2000"],
                                             capture_output=True, check=True, text=True).stdout)
        found.update(closed=told["closed"] and told["oriented"], angle=told["min_angle_unexcused"] >= ANGLE - 1e-6,
                     distance=told["hausdorff_L"] <= DISTANCE * SLACK, crossings=not told["self_intersections"])
    return {**found, "good": all(found.values()), "count": report.triangles, "peer": peer, "exempt": len(report.exempt),
            "forced": forced, "cpu_seconds": report.cpu_seconds, "numbers": numbers}


def outcome(kind, seed, judge):
    from child import outcome_in_child

    def work():
        try:
            return meshed(kind, seed, judge)
        except Exception as error:  # an answer, too: the table counts it
            return {"why": f"{type(error).__name__}: {error}"}

    found, why = outcome_in_child(work, SECONDS, GIBIBYTES)
    return {"class": kind, "seed": seed, **dict.fromkeys((*ASPECTS, "good"), False), **(found or {"why": why})}


def work(arguments):
    from narrow_shapes import CLASSES

    results = []
    print(f"{'class':<9}{'parts':>6}" + "".join(f"{aspect:>11}" for aspect in (*ASPECTS, "good")), flush=True)
    for kind in arguments.only or CLASSES:
        found = [outcome(kind, seed, arguments.judge) for seed in range(arguments.first, arguments.first + arguments.parts)]
        found = [one for one in found if "no valid solid" not in one.get("why", "")]
        shares = (sum(one[aspect] for one in found) / max(1, len(found)) for aspect in (*ASPECTS, "good"))
        print(f"{kind:<9}{len(found):>6}" + "".join(f"{100.0 * share:>9.1f} %" for share in shares), flush=True)
        bad = [one for one in found if not one["good"]]
        print("  " + "; ".join(f"{one['seed']}: {one.get('why') or ', '.join(a for a in ASPECTS if not one[a])}" for one in bad[:LISTED]),
              flush=True)
        results += found
    return {"results": results}


inside_freecad.start(__file__, parser(), work)
