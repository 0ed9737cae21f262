#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cost of improving a mesh against its size: processor seconds, and their exponent from line to line.

    /usr/bin/python3 benchmarks/surfaces/improve_growth.py [--largest 250000] [-n 3]

Made here, each finer by four from line to line: a sphere whose vertices are shaken (as of a scan),
a row of closed cylinders of needles (as of CAD), a crumpled sheet with so many sharp edges that many
triangles stay bad (what every round could try again), and one cylinder of ever more sides, at whose
ends all triangles meet in a vertex, and whose needles stay bad, too. 25 degrees. Seconds are of
mq.improve, the median of n runs. The exponent is 1 where the cost grows as the triangles do.
"""

import math
import statistics
import sys
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad
from made_meshes import crumpled_sheet, needle_cylinder, row_of_cylinders, shaken_sphere

HEAD = f"{'':<10} {'triangles':>9} {'below':>7} -> {'triangles':>9} {'below':>7} {'CPU s':>8} " \
       f"{'us/triangle':>12} {'exponent':>9}"
ANGLE = 25.0
MOST_IN_A_FAN = 10000  # triangles: beyond, it takes minutes
# Name, mesh of a level, tolerance in mm.
KINDS = (("sphere", shaken_sphere, 2e-3), ("cylinders", row_of_cylinders, 5e-3),
         ("crumpled", crumpled_sheet, 2e-2),
         ("fans", lambda level: needle_cylinder(2 * 4 ** level + 1), 2e-3))


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--largest", type=int, default=250000, metavar="TRIANGLES")
    result.add_argument("-n", type=int, default=3, dest="runs", help="runs of each mesh")
    return result


def below(surface):
    from MeshQuality.compat import extension

    return int((extension().triangle_shapes(surface)[0] < ANGLE).sum())


def measure(kind, mesh, tolerance, runs):
    import MeshQuality as mq
    import numpy as np
    from MeshQuality.compat import extension
    from MeshQuality.core.sources import convert

    vertices, triangles = mesh
    given = mq.SurfaceMesh(convert.surface_of_arrays(
        extension(), vertices.astype(np.float32).astype(float), triangles.astype(np.int32), measured=False))
    seconds = []
    for _ in range(runs):
        start = time.process_time()
        better = mq.improve(given, min_angle=ANGLE, tolerance=tolerance)
        seconds.append(time.process_time() - start)
    return {"kind": kind, "triangles": len(triangles), "below": below(given._surface),
            "after": len(better.triangles), "below_after": below(better._surface),
            "seconds": statistics.median(seconds)}


def line(row, before):
    exponent = ""
    if before:
        dearer, larger = (row[key] / before[key] for key in ("seconds", "triangles"))
        exponent = f"{math.log(dearer) / math.log(larger):.2f}"
    return f"{row['kind']:<10} {row['triangles']:9} {row['below']:7} -> {row['after']:9} " \
           f"{row['below_after']:7} {row['seconds']:8.3f} " \
           f"{1e6 * row['seconds'] / row['triangles']:12.2f} {exponent:>9}"


def work(arguments):
    rows = []
    print(HEAD)
    for kind, make, tolerance in KINDS:
        before, level = None, 4
        most = min(arguments.largest, MOST_IN_A_FAN if kind == "fans" else arguments.largest)
        while 8 * 4 ** level <= most:
            row = measure(kind, make(level), tolerance, arguments.runs)
            rows.append(row)
            print(line(row, before), flush=True)
            before, level = row, level + 1
    return {"angle": ANGLE, "meshes": rows}


inside_freecad.start(__file__, parser(), work)
