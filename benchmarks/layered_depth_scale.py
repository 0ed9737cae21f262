#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Uniform Booleans against the number of operands and of rays: time, memory, faults.

    /usr/bin/python3 benchmarks/layered_depth_scale.py [--operands 4 16] [--rays 129 257] [--scale 1025 2049 4097]

Spheres along a spiral are united in one pass, and two at a time; then, each in a process of its own, a sphere less a box with
ever more rays, with the largest memory of the process.
"""

import argparse
import json
import os
import resource
import sys
import time
from pathlib import Path

from child import Limits
from inside_freecad import ROOT

VARIABLE = "MESHQUALITY_LAYERED_DEPTH_SCALE"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--operands", type=int, nargs="*", default=[4, 16])
    parser.add_argument("--rays", type=int, nargs="*", default=[129, 257])
    parser.add_argument("--scale", type=int, nargs="*", default=[1025, 2049, 4097])
    arguments = parser.parse_args()
    for count in arguments.operands:
        for rays in arguments.rays:
            print(count, "operands,", rays, "rays:", run({"work": "unite", "count": count, "rays": rays}), flush=True)
    for rays in arguments.scale:
        print(rays, "rays:", run({"work": "cut", "rays": rays}), flush=True)


def run(job):
    command = ["freecadcmd", "-P", str(ROOT / "Mod"), "-P", str(ROOT / "benchmarks"), str(Path(__file__).resolve())]
    _, text = Limits(300.0, 16.0).run(command, {**os.environ, VARIABLE: json.dumps(job)})
    lines = [line for line in text.splitlines() if line.startswith("{")]
    return json.loads(lines[-1]) if lines else {"outcome": text[-200:]}


def inside():
    import FreeCAD
    import MeshQuality as mq
    import Part

    job = json.loads(os.environ[VARIABLE])
    resolution = job["rays"] - 1
    if job["work"] == "cut":
        operands = [mesh(Part.makeSphere(10.0), 0.02), mesh(Part.makeBox(12, 12, 12), 0.02)]
        began = time.perf_counter()
        try:
            result = mq.boolean(operands, operation="difference", method="uniform", resolution=resolution)
            row = {"seconds": time.perf_counter() - began, "samples": result.report.samples}
        except mq.Error as error:
            row = {"refused": str(error)}
        return {**row, "gigabytes": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20}
    spheres = [mesh(Part.makeSphere(1.0, FreeCAD.Vector(0.9 * i, 0.4 * (i % 4), 0.3 * (i % 3))), 1e-3)
               for i in range(job["count"])]
    began = time.perf_counter()
    result = mq.boolean(spheres, operation="union", method="uniform", resolution=resolution)
    once = time.perf_counter() - began
    began, folded = time.perf_counter(), spheres[0]
    for sphere in spheres[1:]:
        folded = mq.boolean(folded, sphere, "union", method="uniform", resolution=resolution)
    return {"one pass": once, "two at a time": time.perf_counter() - began, "volume": result.report.volume,
            "volume two at a time": folded.report.volume, "faults": result.report.faults_left}


def mesh(shape, chord_height):
    import MeshQuality as mq

    return mq.triangulate(shape, chord_height=chord_height)


if VARIABLE in os.environ:
    print("\n" + json.dumps(inside()), flush=True)
    sys.exit(0)
if __name__ == "__main__":
    main()
