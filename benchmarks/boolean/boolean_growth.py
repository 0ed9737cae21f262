#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cost of a Boolean against the size of its operands, the length of their intersection, and the tolerance.

    /usr/bin/python3 benchmarks/boolean/boolean_growth.py [--levels 8] [-n 3]

Unions of two spheres, made here: both refined alike (triangles grow by four, the pairs of triangles
that cross by two, from line to line); one small sphere against a fine one (the pairs stay few); and
one pair at several tolerances. Processor seconds of mq.boolean, the median of n runs.
"""

import statistics
import sys
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad
from made_meshes import sphere

HEAD = f"{'':<22} {'triangles':>10} {'pairs':>8} {'CPU s':>8} {'us/triangle':>12} {'us/pair beyond':>15}"


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--levels", type=int, default=8, help="finest refinement: 8 * 4**n triangles")
    result.add_argument("-n", type=int, default=3, dest="runs", help="runs of each case")
    return result


def measure(name, a, b, runs, **options):
    import MeshQuality as mq

    seconds = []
    for _ in range(runs):
        start = time.process_time()
        report = mq.boolean(a, b, "union", **options).report
        seconds.append(time.process_time() - start)
    if report.faults_left or not report.closed:
        raise SystemExit(f"{name}: the result has faults")
    return {"case": name, "triangles": len(a[1]) + len(b[1]), "pairs": report.crossing_pairs,
            "seconds": statistics.median(seconds), "error_bound": report.error_bound}


def show(row, base=None):
    """`base`: seconds a triangle without any crossings."""
    each = row["seconds"] / row["triangles"]
    beyond = ""
    if base is not None and row["pairs"]:
        beyond = f"{1e6 * (row['seconds'] - base * row['triangles']) / row['pairs']:15.1f}"
    print(f"{row['case']:<22} {row['triangles']:10} {row['pairs']:8} {row['seconds']:8.3f} "
          f"{1e6 * each:12.2f} {beyond}", flush=True)
    return row


def work(arguments):
    levels, n = range(3, arguments.levels + 1), arguments.runs
    rows = []
    print(HEAD)
    for level in levels:
        far = measure(f"apart, level {level}", sphere(level), sphere(level, 1.0, (3, 0.1, 0.2)), n)
        base = far["seconds"] / far["triangles"]
        rows.append(show(far))
        rows.append(show(measure(f"crossing, level {level}", sphere(level),
                                 sphere(level, 0.9, (0.7, 0.1, 0.2)), n), base))
    for level in levels:
        rows.append(show(measure(f"small on fine {level}", sphere(level),
                                 sphere(3, 0.05, (1.0, 0.03, 0.02)), n)))
    fine = arguments.levels - 1
    for tolerance in (1e-5, 1e-4, 1e-3, 1e-2):
        rows.append(show(measure(f"tolerance {tolerance:g}", sphere(fine),
                                 sphere(fine, 0.9, (0.7, 0.1, 0.2)), n, tolerance=tolerance)))
    return {"runs": n, "cases": rows}


inside_freecad.start(__file__, parser(), work)
