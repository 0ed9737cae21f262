#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Uniform Booleans against the number of operands and of rays: time, memory, faults.

    /usr/bin/python3 benchmarks/boolean/layered_depth_scale.py [--operands 4 16] [--rays 129 257] [--scale 1025 2049 4097]
                                                       [--cores 513 1025]

Spheres along a spiral are united in one pass, and two at a time; then, each in a process of its own, a sphere less a box with
ever more rays, with the largest memory of the process. With --cores the time on two threads is compared with that on one, as
medians of five runs in turns, of meshes, of their shapes, and of a shape with spline faces; nothing else should run meanwhile.
"""

import argparse
import json
import os
import resource
import statistics
import sys
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
from child import Limits
from inside_freecad import ROOT

VARIABLE = "MESHQUALITY_LAYERED_DEPTH_SCALE"
RUNS = 5  # on each number of threads


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--operands", type=int, nargs="*", default=[4, 16])
    parser.add_argument("--rays", type=int, nargs="*", default=[129, 257])
    parser.add_argument("--scale", type=int, nargs="*", default=[1025, 2049, 4097])
    parser.add_argument("--cores", type=int, nargs="*", default=[], help="rays along a side")
    arguments = parser.parse_args()
    for count in arguments.operands:
        for rays in arguments.rays:
            print(count, "operands,", rays, "rays:", run({"work": "unite", "count": count, "rays": rays}), flush=True)
    for rays in arguments.scale:
        print(rays, "rays:", run({"work": "cut", "rays": rays}), flush=True)
    for rays in arguments.cores:
        for what in ("meshes", "shapes", "splines"):
            print(rays, "rays,", what, run({"work": "cores", "what": what, "rays": rays}), flush=True)


def run(job):
    command = ["freecadcmd", "-P", str(ROOT / "Mod"), str(Path(__file__).resolve())]
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
    if job["work"] == "cores":
        return cores(job["what"], resolution)
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


def cores(what, resolution):
    """Medians of the seconds on one and on two threads, of the whole Boolean and of its stages after the meshing."""
    import MeshQuality as mq
    import Part
    from FreeCAD import Vector

    operands = [Part.makeSphere(10.0), Part.makeBox(12, 12, 12)]
    if what == "meshes":
        operands = [mesh(shape, 0.02) for shape in operands]
    if what == "splines":
        section = Part.Wire([Part.makeCircle(1.7, Vector(8.0, 0.0, 0.0), Vector(0.0, 1.0, 0.12))])
        operands[0] = Part.Wire(Part.makeHelix(6.0, 21.0, 8.0)).makePipeShell([section], True, True)
    runs = {1: [], 2: []}
    for _ in range(RUNS):
        for threads, found in runs.items():
            began = time.perf_counter()
            report = mq.boolean(operands, operation="difference", method="uniform", resolution=resolution, threads=threads).report
            whole = time.perf_counter() - began
            found.append({**dict(report.seconds), "whole": whole,
                          "rays": whole - dict(report.seconds).get("meshing shapes", 0.0)})
    medians = {threads: {stage: statistics.median(run[stage] for run in found) for stage in found[0]}
               for threads, found in runs.items()}
    return {stage: [round(medians[1][stage], 3), round(medians[2][stage], 3), round(medians[2][stage] / medians[1][stage], 2)]
            for stage in medians[1] if medians[1][stage] > 0.02 * medians[1]["whole"]}


def mesh(shape, chord_height):
    import MeshQuality as mq

    return mq.triangulate(shape, chord_height=chord_height)


if VARIABLE in os.environ:
    print("\n" + json.dumps(inside()), flush=True)
    sys.exit(0)
if __name__ == "__main__":
    main()
