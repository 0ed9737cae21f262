#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seconds of two calls that nothing but their input bounds: meshes that end at max_triangles, and the distance of a mesh
from its shape.

    /usr/bin/python3 benchmarks/corpus_runs/limit_times.py [--seconds 120]

Each first case asks for far more triangles than the limit allows. `silence` is the longest time between two calls of
the progress callback, after which a cancellation would be seen. The distance is that of quality(mesh, shape), of meshes at
default options. What takes longer than --seconds is cancelled, and said to be.
"""

import sys
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad

LIMIT_HEAD = f"{'max_triangles':<26} {'limit':>8} {'triangles':>9} {'seconds':>8} {'silence':>8}"
QUALITY_HEAD = f"{'quality(mesh, shape)':<26} {'faces':>8} {'triangles':>9} {'seconds':>8} {'silence':>8} {'ms each':>8}"
FILES = ("fuselage.brep", "M6-1x12-countersunk-screw.step", "CrankArm.brep", "wing_fuselage.step")


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--seconds", type=float, default=120.0, help="the most for one call")
    return result


class Watch:
    """A progress callback that ends the work after some seconds, and notes its longest silence."""

    def __init__(self, most):
        self.start = self.last = time.perf_counter()
        self.end, self.silence = self.start + most, 0.0

    def __call__(self, fraction, stage):
        now = time.perf_counter()
        self.silence, self.last = max(self.silence, now - self.last), now
        return now < self.end


def timed(call, most):
    """(result or None where it was cancelled, seconds, longest silence)."""
    import MeshQuality as mq

    watch = Watch(most)
    try:
        result = call(watch)
    except mq.Cancelled:
        result = None
    return result, time.perf_counter() - watch.start, watch.silence


def limited_cases():
    """(name, shape, options) of calls that end at max_triangles."""
    import Part

    sphere, box = Part.makeSphere(1), Part.makeBox(1, 1, 1)
    return (("sphere, edges_per_circle", sphere, {"edges_per_circle": 10000, "max_triangles": 100_000}),
            ("box, local size of an edge", box, {"local_sizes": {"Edge1": 3e-5}, "max_triangles": 30_000}),
            ("box, max_edge", box, {"max_edge": 1e-4, "max_triangles": 100_000}))


def limited(most):
    import MeshQuality as mq

    print(LIMIT_HEAD)
    for name, shape, options in limited_cases():
        mesh, seconds, silence = timed(
            lambda watch, shape=shape, options=options: mq.triangulate(shape, progress=watch, **options), most)
        count = "cancelled" if mesh is None else len(mesh.triangles)
        print(f"{name:<26} {options['max_triangles']:8} {count:>9} {seconds:8.2f} {silence:8.3f}", flush=True)
        yield {"name": name, "options": options, "triangles": count, "seconds": seconds, "silence": silence}


def measured(most):
    import MeshQuality as mq
    import Part

    print(QUALITY_HEAD)
    for name in FILES:
        shape = Part.read(str(inside_freecad.data_folder() / "cad" / name))
        mesh, _, _ = timed(lambda watch, shape=shape: mq.triangulate(shape, progress=watch), most)
        if mesh is None:
            continue
        report, seconds, silence = timed(
            lambda watch, mesh=mesh, shape=shape: mq.quality(mesh, shape, progress=watch), most)
        each = "cancelled" if report is None else f"{1e3 * seconds / len(mesh.triangles):.2f}"
        print(f"{name:<26.26} {len(shape.Faces):8} {len(mesh.triangles):9} {seconds:8.2f} {silence:8.3f} {each:>8}",
              flush=True)
        yield {"name": name, "faces": len(shape.Faces), "triangles": len(mesh.triangles), "seconds": seconds,
               "silence": silence, "ended": report is not None}


def work(arguments):
    return {"limited": list(limited(arguments.seconds)), "measured": list(measured(arguments.seconds))}


inside_freecad.start(__file__, parser(), work)
