#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long sequences of Boolean operations: as one expression, and one operation after the other.

    /usr/bin/python3 benchmarks/boolean/boolean_chain.py [--operations 200] [-n 3]

A block loses a ball by each operation (carve), and boxes at random places are joined (boxes). Processor seconds of
mq.Solid.evaluate for all of them, and of mq.boolean for each in turn; the median of n runs.
"""

import statistics
import sys
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad
import numpy as np
from made_meshes import box, sphere


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--operations", type=int, default=200)
    result.add_argument("-n", type=int, default=3, dest="runs", help="runs of each case")
    return result


def carve(count):
    random = np.random.default_rng(1)
    balls = [sphere(3, 1.0, random.uniform((0, 0, 3), (40, 40, 7))) for _ in range(count)]
    return "difference", [box((40, 40, 5), (0, 0, 0)), *balls]


def boxes(count):
    random = np.random.default_rng(2)
    side = 4.0 * count**(1 / 3)
    return "union", [box(random.uniform(1, 5, 3), random.uniform(0, side, 3)) for _ in range(count + 1)]


def at_once(operation, operands):
    import MeshQuality as mq

    solid = mq.Solid(operands[0])
    for operand in operands[1:]:
        solid = solid - operand if operation == "difference" else solid | operand
    return solid.evaluate().report


def one_by_one(operation, operands):
    import MeshQuality as mq

    result = operands[0]
    for operand in operands[1:]:
        result = mq.boolean(result, operand, operation)
    return result.report


def work(arguments):
    rows = []
    print(f"{'case':<8} {'operations':>10} {'way':<12} {'CPU s':>8} {'triangles':>10} {'volume':>12}")
    for name, make in (("carve", carve), ("boxes", boxes)):
        operation, operands = make(arguments.operations)
        for way in (at_once, one_by_one):
            seconds = []
            for _ in range(arguments.runs):
                start = time.process_time()
                report = way(operation, operands)
                seconds.append(time.process_time() - start)
            rows.append({"case": name, "way": way.__name__, "seconds": statistics.median(seconds),
                         "triangles": report.triangles, "volume": report.volume})
            sound = report.closed and report.manifold and report.faults_left == 0
            print(f"{name:<8} {arguments.operations:10} {way.__name__:<12} {statistics.median(seconds):8.3f} "
                  f"{report.triangles:10} {report.volume:12.4f}{'' if sound else '  not sound'}", flush=True)
    return {"runs": arguments.runs, "cases": rows}


inside_freecad.start(__file__, parser(), work)
