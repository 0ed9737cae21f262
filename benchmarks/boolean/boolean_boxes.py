#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Unions of many boxes in one call, whose faces lie in common planes: how the cost grows with their number.

    /usr/bin/python3 benchmarks/boolean/boolean_boxes.py [--most 1500] [-n 3]

Boxes of 1 mm: in a row that overlap by half, in a grid that overlap by 0.3 and 0.4, at random places that overlap about
two others, and in a stack, each turned by 21.2 degrees against the one before. Processor seconds, the median of n runs.
"""

import statistics
import sys
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad
import numpy as np
from made_meshes import box

TURN = 0.37  # radians


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--most", type=int, default=1500, help="boxes")
    result.add_argument("-n", type=int, default=3, dest="runs", help="runs of each case")
    return result


def row(count):
    return [box((1, 1, 1), (0.5 * k, 0, 0)) for k in range(count)]


def grid(count):
    side = round(count**0.5)
    return [box((1, 1, 1), (0.7 * i, 0.6 * j, 0)) for i in range(side) for j in range(side)]


def cloud(count):
    random = np.random.default_rng(1)
    side = 0.8 * count**(1 / 3)
    return [box((1, 1, 1), random.uniform(0, side, 3)) for _ in range(count)]


def stack(count):
    operands = []
    for k in range(count):
        vertices, triangles = box((1, 1, 1), (-0.5, -0.5, 0))
        cosine, sine = np.cos(TURN * k), np.sin(TURN * k)
        turned = vertices @ np.array([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]]).T
        operands.append(((turned + (0.05 * k, 0, 0)).astype(np.float32), triangles))
    return operands


# A stack crosses itself in as many places as the square of its number.
CASES = {"row": (row, 1), "grid": (grid, 1), "cloud": (cloud, 1), "stack": (stack, 15)}


def work(arguments):
    import MeshQuality as mq

    rows = []
    print(f"{'case':<8} {'boxes':>6} {'CPU s':>8} {'triangles':>10} {'volume':>12}")
    for name, (make, fewer) in CASES.items():
        for part in (4, 1):
            operands = make(arguments.most // fewer // part)
            seconds = []
            for _ in range(arguments.runs):
                start = time.process_time()
                report = mq.boolean(operands, operation="union").report
                seconds.append(time.process_time() - start)
            sound = report.closed and report.manifold and report.faults_left == 0
            rows.append({"case": name, "boxes": len(operands), "seconds": statistics.median(seconds),
                         "triangles": report.triangles, "volume": report.volume, "sound": sound})
            print(f"{name:<8} {len(operands):6} {statistics.median(seconds):8.3f} {report.triangles:10} "
                  f"{report.volume:12.4f}{'' if sound else '  not sound'}", flush=True)
    return {"runs": arguments.runs, "cases": rows}


inside_freecad.start(__file__, parser(), work)
