#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How soon each long call ends once its progress callback has returned False; prints a table in Markdown.

    MESHQUALITY_DATA=... /usr/bin/python3 benchmarks/window/cancel_latency.py [--parts N] [--moments N] [--only TEXT]

Each call on each part is cancelled at several moments, spread over the first seconds of the work. The latency runs from
the callback's first False until the call is back: on the clock, or what the process used of the processors meanwhile
where that is less, as others may use the machine, too. Reading and writing files take no callback: their whole time is
given.
"""

import os
import random
import sys
import tempfile
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad

BOUND = 0.2  # seconds: what callers were promised
CORPUS = ("mal_vis.brep", "bottle.brep", "CrankArm.brep", "Motor-c.brep", "wing.brep", "SampleCrankshaft4A.stp",
          "linkrods.step", "terrain.brep", "hammer.brep", "shell1.brep", "MODERN_Sink_1_opened.brep", "component8.step")
HEAVY = ("a torus as thin as a hair", "a wild face", "stretched", "a needle", "10^4 vertices and a box",
         "nested 1000 deep", "a sliver of a sphere", "one box 1024 times")
HEAVY_MESHES = ("a fan of 10^5", "a cube 1000 times", "nested 1000 deep", "triangle soup", "one triangle 10^5 times")


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--parts", type=int, default=len(CORPUS), help="so many of the corpus")
    result.add_argument("--moments", type=int, default=4, help="cancels of each call on each part")
    result.add_argument("--longest", type=float, default=2.0, help="seconds, up to which calls are cancelled")
    result.add_argument("--seed", type=int, default=1)
    result.add_argument("--only", default="", help="calls with this text in their names")
    result.add_argument("--large", action="store_true", help="of 10,000 boxes and two balls of 420,000 triangles instead")
    return result


class At:
    """Cancels at a moment; `answered` is when it first did, `stage` what went on then."""

    def __init__(self, delay):
        self.moment, self.answered, self.used, self.stage = time.perf_counter() + delay, None, 0.0, ""

    def __call__(self, _fraction, stage):
        now = time.perf_counter()
        if now < self.moment:
            return True
        if self.answered is None:
            self.answered, self.used, self.stage = now, time.process_time(), stage
        return False


def latency(call, delay):
    """(seconds from the cancel to the end or None, the same on the clock, the stage then)."""
    import MeshQuality as mq

    progress = At(delay)
    try:
        call(progress)
    except mq.Error:
        pass
    if progress.answered is None:
        return None, 0.0, ""
    clock = time.perf_counter() - progress.answered
    return min(clock, time.process_time() - progress.used), clock, progress.stage


def shape_calls():
    """{name: call(shape, progress)}."""
    import FreeCAD
    import Part

    import MeshQuality as mq

    def tool(shape):
        box = shape.BoundBox
        return Part.makeSphere(0.3 * box.DiagonalLength, FreeCAD.Vector(box.Center))

    fine = {"chord_height_relative": 2e-4}
    return {
        "triangulate": lambda shape, progress: mq.triangulate(shape, progress=progress, **fine),
        "star": lambda shape, progress: mq.triangulate(shape, method="star", progress=progress, **fine),
        "sprinkle": lambda shape, progress: mq.triangulate(shape, method="sprinkle", progress=progress, **fine),
        "sharp edges only": lambda shape, progress: mq.triangulate(shape, keep_edges="feature", progress=progress,
                                                                   **fine),
        "curve": lambda shape, progress: mq.curve(shape, order=3, chord_height_relative=2e-3, progress=progress),
        "curve volume": lambda shape, progress: mq.curve(shape, volume=True, chord_height_relative=2e-3,
                                                         progress=progress),
        "boolean of shapes": lambda shape, progress: mq.boolean(shape, tool(shape), "difference", resolution=1024,
                                                                progress=progress),
    }


def mesh_calls():
    """{name: call(mesh, shape or None, progress)}."""
    import MeshQuality as mq

    moved = _moved
    return {
        "boolean": lambda mesh, _, progress: mq.boolean(mesh, moved(mesh), "union", progress=progress),
        "boolean uniform": lambda mesh, _, progress: mq.boolean(mesh, moved(mesh), "union", method="uniform",
                                                                resolution=512, progress=progress),
        "improve": lambda mesh, _, progress: mq.improve(mesh, min_angle=30.0, progress=progress),
        "quality with a shape": lambda mesh, shape, progress: shape and mq.quality(mesh, shape, progress),
    }


def _moved(mesh):
    """The same a little aside, as arrays: two copies that cross everywhere."""
    import numpy as np

    vertices, triangles = (mesh.vertices, mesh.triangles) if hasattr(mesh, "vertices") else mesh
    size = float(np.ptp(np.asarray(vertices), axis=0).max())
    return np.asarray(vertices) + 0.01 * size, triangles


def large_jobs():
    """(call's name, part's name, call(progress)) of inputs whose preparation alone takes seconds."""
    import FreeCAD
    import Mesh
    import Part

    import MeshQuality as mq

    boxes = Part.makeCompound([Part.makeBox(1, 1, 1, FreeCAD.Vector(2 * i, 0, 0)) for i in range(10_000)])
    yield "triangulate", "10,000 boxes", lambda progress: mq.triangulate(boxes, progress=progress)
    ball = Mesh.createSphere(10.0, 459)
    other = ball.copy()
    other.translate(1.0, 2.0, 3.0)
    yield ("boolean", f"two balls of {ball.CountFacets:,} triangles",
           lambda progress: mq.boolean(ball, other, "union", progress=progress))


def jobs(arguments):
    """(call's name, part's name, call(progress))."""
    import Part
    import meshes_given
    import shapes_given

    import MeshQuality as mq

    folder = inside_freecad.data_folder() / "cad"
    shapes = {name: Part.read(str(folder / name)) for name in CORPUS[:arguments.parts] if (folder / name).exists()}
    shapes.update({name: shapes_given.SHAPES[name]() for name in HEAVY})
    for name, shape in shapes.items():
        for call_name, call in shape_calls().items():
            yield call_name, name, lambda progress, c=call, s=shape: c(s, progress)
    meshes = {name: (meshes_given.MESHES[name](), None) for name in HEAVY_MESHES}
    for name in list(shapes)[:4]:
        meshes[name] = mq.triangulate(shapes[name], chord_height_relative=1e-3, max_triangles=200_000), shapes[name]
    for name, (mesh, shape) in meshes.items():
        for call_name, call in mesh_calls().items():
            if shape is not None or call_name != "quality with a shape":
                yield call_name, name, lambda progress, c=call, m=mesh, s=shape: c(m, s, progress)
    for name in list(shapes)[:4]:
        curved = mq.curve(shapes[name], order=3)
        fine = curved.report.max_deviation * 1e-3 + 1e-4
        yield "tessellate", name, lambda progress, c=curved, f=fine: c.tessellate(f, progress)


def files(arguments):
    """[(what, part, seconds, triangles)] of reading and writing, which cannot be cancelled."""
    import Part

    import MeshQuality as mq

    found = []
    folder = inside_freecad.data_folder() / "cad"
    for name in CORPUS[:arguments.parts]:
        if (folder / name).exists():
            start = time.perf_counter()
            Part.read(str(folder / name))
            found.append(("read", name, time.perf_counter() - start, "Part.read: FreeCAD's reader"))
    mesh = mq.triangulate(Part.makeSphere(10), chord_height=0.00005, max_triangles=500_000)
    with tempfile.TemporaryDirectory() as scratch:
        for suffix in ("stl", "ply", "obj", "off", "msh", "vtu"):
            start = time.perf_counter()
            mesh.write(os.path.join(scratch, "mesh." + suffix))
            found.append(("write", f".{suffix}, {len(mesh.triangles):,} triangles", time.perf_counter() - start, ""))
    return found


def work(arguments):
    import sys

    sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests" / "attacks"))
    found, dice = [], random.Random(arguments.seed)
    for call_name, part, call in large_jobs() if arguments.large else jobs(arguments):
        if arguments.only not in f"{call_name}: {part}":
            continue
        for k in range(arguments.moments):
            # More of them early: that is where stages change.
            delay = arguments.longest * ((k + dice.random()) / arguments.moments) ** 2
            seconds, clock, stage = latency(call, delay)
            if seconds is None:
                break  # it ends before
            found.append({"call": call_name, "part": part, "at": delay, "seconds": seconds, "clock": clock,
                          "stage": stage})
            if seconds > BOUND:
                print(f"{call_name}: {part}: {seconds:.2f} s after a cancel at {delay:.2f} s, {stage}", flush=True)
    table(found)
    others = [] if arguments.large else files(arguments)
    for what, name, seconds, reason in others:
        print(f"| {what} | {name} | {seconds:.2f} | {reason} |")
    return {"bound": BOUND, "cancels": found, "files": others}


def table(found):
    """Prints the worst of each call in Markdown, and each part beyond the bound."""
    print("\n| call | cancels | median s | worst s | part | stage |\n|---|---|---|---|---|---|")
    for name in dict.fromkeys(row["call"] for row in found):
        rows = sorted((row for row in found if row["call"] == name), key=lambda row: row["seconds"])
        worst = rows[-1]
        median = rows[len(rows) // 2]
        print(f"| {name} | {len(rows)} | {median['seconds']:.3f} | {worst['seconds']:.3f} | {worst['part']} "
              f"| {worst['stage']} |")
    print(f"\nBeyond {BOUND} s:\n")
    slow = {}
    for row in found:
        key = row["call"], row["part"], row["stage"]
        if row["seconds"] > BOUND and row["seconds"] > slow.get(key, 0.0):
            slow[key] = row["seconds"]
    for (name, part, stage), seconds in sorted(slow.items(), key=lambda item: -item[1]):
        print(f"| {name} | {part} | {stage} | {seconds:.2f} |")
    within = sum(row["seconds"] <= BOUND for row in found)
    print(f"\n{within} of {len(found)} cancels within {BOUND} s")


inside_freecad.start(__file__, parser(), work)
