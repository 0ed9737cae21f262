#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether meshes keep size fields: ratios of edges to the field, angles, growth of the work.

    /usr/bin/python3 benchmarks/triangulate/size_fields.py [--parts 30] [--fuzz 200] [--seconds 120] [--only PART]

Parts are those of $MESHQUALITY_DATA/cad, spread by name over the smaller files. Each gets five kinds of field, by functions of the
place in fractions of its size L. With --fuzz random fields on small parts instead: steep, discontinuous, noisy, tiny, huge.
"""

import json
import sys
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad

LARGEST = 400_000  # bytes of a part's file
KINDS = ("constant", "graded", "step", "wave", "points")


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--parts", type=int, default=30)
    result.add_argument("--fuzz", type=int, default=0)
    result.add_argument("--seconds", type=float, default=120.0)
    result.add_argument("--only", default="")
    return result


def files(count, only):
    folder = inside_freecad.data_folder() / "cad"
    found = sorted(path for path in folder.rglob("*") if path.suffix.lower() in (".step", ".stp", ".brep", ".brp")
                   and path.stat().st_size <= LARGEST and only in path.name)
    return found[::max(1, len(found) // count)][:count]


def field_of(kind, low, high):
    import numpy as np

    size, corner, middle = float((high - low).max()), low, (low + high) / 2
    if kind == "constant":
        return lambda p: np.full(len(p), size / 40)
    if kind == "graded":
        return lambda p: size / 150 + 0.15 * np.linalg.norm(p - corner, axis=1)
    if kind == "step":
        return lambda p: np.where(np.linalg.norm(p - corner, axis=1) < size / 4, size / 80, size / 10)
    if kind == "wave":
        return lambda p: size / 40 * (1 + 0.7 * np.sin(12 * (p - middle) / size).prod(axis=1))
    random = np.random.RandomState(7)
    points = low + random.rand(300, 3) * (high - low)
    return points, size / 60 * (1 + 3 * np.abs(points[:, 0] - low[0]) / size)


class Late(Exception):
    """The time is up."""


def until(seconds):
    end = time.monotonic() + seconds

    def progress(_fraction, _stage):
        if time.monotonic() > end:
            raise Late

    return progress


def measured(shape, field, seconds, **options):
    import MeshQuality as mq

    start = time.perf_counter()
    try:
        mesh = mq.triangulate(shape, size_field=field, progress=until(seconds), **options)
    except Late:
        return {"late": True, "seconds": time.perf_counter() - start}
    except mq.Error as error:
        return {"error": str(error), "seconds": time.perf_counter() - start}
    report = mesh.report
    return {"triangles": len(mesh.triangles), "ratio": report.size_ratio, "short": report.short_share, "angle": report.min_angle,
            "unexempted": report.min_angle_unexempted, "exempt": len(report.exempt), "complete": report.complete,
            "crossings": report.self_intersections, "closed": report.closed,
            "reasons": [str(note) for note in report.notes if "size field" in str(note)], "seconds": time.perf_counter() - start}


def table(arguments, write):
    import numpy as np
    import Part

    import MeshQuality as mq

    for path in files(arguments.parts, arguments.only):
        try:
            shape = Part.read(str(path))
            plain = measured(shape, None, arguments.seconds)
            box = mq.triangulate(shape, chord_height_relative=0.02).report.box
        except Exception as error:  # of a file that FreeCAD cannot read
            write({"part": path.name, "error": str(error)})
            continue
        low, high = map(np.array, box)
        write({"part": path.name, "kind": "none", **plain})
        for kind in KINDS:
            write({"part": path.name, "kind": kind, **measured(shape, field_of(kind, low, high), arguments.seconds)})


def small_parts():
    import FreeCAD
    import Part

    box = Part.makeBox(10, 6, 4)
    return [box, Part.makeSphere(5), Part.makeTorus(6, 2), box.cut(Part.makeCylinder(2, 9, FreeCAD.Vector(4, 3, -1))),
            box.makeFillet(0.7, box.Edges), Part.makeCone(0, 4, 8)]


def random_field(random):
    """(what it is, a function) by a RandomState."""
    import numpy as np

    kind = ("steep", "discontinuous", "noisy", "tiny", "huge", "mixed")[random.randint(6)]
    at, scale = random.rand(3) * [10, 6, 4], 10.0 ** random.uniform(-1.5, 1.0)
    normal = random.randn(3)
    normal /= np.linalg.norm(normal)
    if kind == "steep":
        rate = 10.0 ** random.uniform(0, 4)
        return kind, lambda p: scale * (0.1 + rate * np.abs((p - at) @ normal) / (1 + rate * np.abs((p - at) @ normal)))
    if kind == "discontinuous":
        ratio = 10.0 ** random.uniform(0.3, 3)
        return kind, lambda p: np.where((p - at) @ normal > 0, scale, scale * ratio)
    if kind == "noisy":
        low = scale * random.uniform(0.05, 1)
        return kind, lambda p: low + (scale - low + 0.1 * scale) * np.abs(np.modf(np.sin(p @ [12.9898, 78.233, 37.719]) * 43758.5453)[0])
    if kind == "tiny":
        size = 10.0 ** random.uniform(-12, -1)
        radius = 10.0 ** random.uniform(-3, 1)
        return kind, lambda p: np.where(np.linalg.norm(p - at, axis=1) < radius, size, 5.0)
    if kind == "huge":
        size = 10.0 ** random.uniform(2, 300)
        return kind, lambda p: np.full(len(p), size)
    waves = 10.0 ** random.uniform(-1, 2)
    return kind, lambda p: scale * np.exp(2 * np.sin(waves * (p - at) @ normal))


def fuzz(arguments, write):
    import numpy as np

    shapes = small_parts()
    for seed in range(arguments.fuzz):
        random = np.random.RandomState(seed)
        kind, field = random_field(random)
        options = {"growth_rate": float(random.uniform(1.1, 2.0))} if random.rand() < 0.3 else {}
        write({"seed": seed, "kind": kind, "shape": seed % len(shapes), **options,
               **measured(shapes[seed % len(shapes)], field, arguments.seconds, max_triangles=300_000, **options)})


def work(arguments):
    results = []

    def write(row):
        results.append(row)
        print(json.dumps(row), flush=True)

    (fuzz if arguments.fuzz else table)(arguments, write)
    return {"rows": results}


inside_freecad.start(__file__, parser(), work)
