#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What each constant of src/triangulate/*/*.h that is MESHQUALITY_TUNED does at half and at double its value.

    cmake -B build/tunable -DMESHQUALITY_TUNABLE=ON ... (docs/measurements/tuning.md has the whole line)
    benchmarks/tuning.py --parts FOLDER --stage refine --out out/refine.json

A build with MESHQUALITY_TUNABLE scales constants by what the environment says; it takes the place
of the module in Mod/. Parts of FOLDER (benchmarks/parts_sources.py brings them) of the share to
develop on are meshed with the defaults, then with each constant of the stage halved and doubled.
Documents and invalid shapes are left out. Of the parts, in the order of their digests, the first
--first are taken whose mesh has at most --most-triangles. A line is printed for each setting: the
parts whose mesh differs, the parts that miss the bound, crossings and exempt triangles that no
input angle forces, triangles and processor time, each as the difference from the defaults.
"""

import json
import os
import re
import time
from pathlib import Path

from child import in_child, outcome_in_child
from inside_freecad import ROOT, command_line, start
from parts_report import FORCED, angle, far_distances

DECLARED = re.compile(r"MESHQUALITY_TUNED\(\s*([\w:]+),\s*(\w+),\s*([^;]+)\);")
FACTORS = (0.5, 2.0)
VARIABLE = "MESHQUALITY_TUNING"
MODULES = ROOT / "Mod" / "MeshQuality"
BOUND = 25.0  # degrees
DISTANCE = 0.002  # fraction of the largest side
SECONDS_OF_PART, SECONDS_OF_SETTING = 15, 3600


def constants(stage):
    """Names and values of the tuned constants in a folder of src/triangulate, as they are declared."""
    found = {}
    for path in sorted((ROOT / "src" / "triangulate" / stage).glob("*.h")):
        for _, name, value in DECLARED.findall(path.read_text(encoding="utf-8")):
            found[name] = value
    return found


def figures(mesh):
    """What is compared of one mesh."""
    report = mesh.report
    forced = sum(reason.cause in FORCED for _, reason in report.exempt_reasons)
    found = {
        "triangles": report.triangles, "vertices": report.vertices,
        "exempt": len(report.exempt), "exempt_forced": forced, "unforced": len(report.exempt) - forced,
        "min_angle": report.min_angle, "min_angle_unexempted": report.min_angle_unexempted,
        "max_chord_height": report.max_chord_height, "chord_height_asked": report.chord_height_asked,
        "crossings": max(report.self_intersections, 0),
    }
    found["missed"] = angle(found, BOUND) == "missed"
    found["far"] = bool(far_distances(found, {"chord_height_relative": DISTANCE}))
    return found


def mesh_all(shapes, setting, options):
    """Figures of all parts under one setting, by name, and the seconds of the processor; made by a child, whose
    module reads the setting when it is loaded.
    """
    def work():
        if setting:
            os.environ[VARIABLE] = setting
        import MeshQuality as mq  # noqa: PLC0415

        found, seconds = {}, 0.0
        for name, shape in shapes.items():
            def mesh_one(shape=shape):
                begin = time.process_time()
                return [figures(mq.triangulate(shape, **options)), time.process_time() - begin]

            answer, why = outcome_in_child(mesh_one, SECONDS_OF_PART)
            found[name] = answer[0] if answer else {"failed": why}
            seconds += answer[1] if answer else 0.0
        return {"parts": found, "seconds": seconds}

    return in_child(work, SECONDS_OF_SETTING)


def sums(run):
    """The figures of one setting over all parts."""
    parts = run["parts"].values()
    done = [p for p in parts if "failed" not in p]
    return {
        "failed": len(parts) - len(done),
        "missed": sum(p["missed"] for p in done),
        "unforced": sum(p["unforced"] for p in done),
        "far": sum(p["far"] for p in done),
        "crossings": sum(p["crossings"] > 0 for p in done),
        "triangles": sum(p["triangles"] for p in done),
        "seconds": run["seconds"],
    }


def compared(run, base):
    """Differences of the sums from the defaults, over the parts that both meshed."""
    both = [n for n in base["parts"] if "failed" not in base["parts"][n] and "failed" not in run["parts"][n]]
    one = sums({"parts": {n: run["parts"][n] for n in both}, "seconds": run["seconds"]})
    other = sums({"parts": {n: base["parts"][n] for n in both}, "seconds": base["seconds"]})
    result = {name: one[name] - other[name] for name in one}
    result["failed"] = sums(run)["failed"] - sums(base)["failed"]
    result["differing"] = sum(run["parts"][n] != base["parts"][n] for n in both)
    result["triangles_percent"] = 100.0 * result["triangles"] / max(1, other["triangles"])
    result["seconds_percent"] = 100.0 * result["seconds"] / max(1e-9, other["seconds"])
    return result


def read_parts(arguments):
    """Shapes by name, in the order of the digests, whose mesh with the defaults is small enough."""
    import Part  # noqa: PLC0415
    import parts_sources  # noqa: PLC0415

    shapes, names = {}, set()
    if arguments.names:
        names = set(Path(arguments.names).read_text(encoding="utf-8").split())
    files = sorted(p for p in Path(arguments.parts).iterdir()
                   if parts_sources.share_of(p.stem) == "develop" and p.suffix != ".fcstd")
    for path in files:
        if len(shapes) == arguments.first:
            break
        if path.stat().st_size > arguments.most_bytes or (names and path.stem not in names):
            continue
        shape = Part.Shape()
        try:
            shape.read(str(path))
        except Exception as error:
            print(f"{path.name} is left out: {error}", flush=True)
            continue
        if shape.Faces and shape.isValid():
            shapes[path.stem] = shape
    return shapes


def work(arguments):
    """Measures the stage and returns everything that is kept."""
    options = {"min_angle": BOUND, "chord_height_relative": DISTANCE, "method": arguments.method}
    if arguments.keep_edges:
        options["keep_edges"] = arguments.keep_edges
    if not any(VARIABLE.encode() in module.read_bytes() for module in MODULES.glob("_core.*.so")):
        raise RuntimeError(f"the module in {MODULES} was built without MESHQUALITY_TUNABLE")
    shapes = read_parts(arguments)
    base = mesh_all(shapes, "", options)
    if base is None:
        raise RuntimeError(f"the defaults took more than {SECONDS_OF_SETTING} s: take fewer parts (--first)")
    small = [n for n, p in base["parts"].items()
             if "failed" not in p and p["triangles"] <= arguments.most_triangles]
    shapes = {n: shapes[n] for n in small}
    if len(small) < len(base["parts"]):
        base = mesh_all(shapes, "", options)
    print(f"{len(shapes)} parts: {sums(base)}", flush=True)
    rows = {}
    for name, value in constants(arguments.stage).items():
        if arguments.only and name not in arguments.only:
            continue
        for factor in FACTORS:
            run = mesh_all(shapes, f"{name}={factor}", options)
            if run is None:
                print(f"{name:28} {value:>10} x{factor}: did not end", flush=True)
                continue
            row = compared(run, base)
            rows[f"{name}*{factor}"] = row
            print(f"{name:28} {value:>10} x{factor}: differ {row['differing']:4} missed {row['missed']:+3} "
                  f"unforced {row['unforced']:+6} crossings {row['crossings']:+2} far {row['far']:+2} "
                  f"failed {row['failed']:+2} "
                  f"triangles {row['triangles_percent']:+6.2f}% cpu {row['seconds_percent']:+5.0f}%", flush=True)
    return {"options": options, "parts": base["parts"], "defaults": sums(base), "rows": rows}


def parser():
    """The command line."""
    result = command_line(__doc__)
    result.add_argument("--parts", required=True, help="folder of parts named by their digests")
    result.add_argument("--stage", required=True, help="folder of src/triangulate")
    result.add_argument("--only", action="append", help="a constant")
    result.add_argument("--names", help="file with the digests of the parts to take")
    result.add_argument("--method", default="refine", help="refine, star or sprinkle")
    result.add_argument("--keep-edges", help="all or feature")
    result.add_argument("--first", type=int, default=200, help="parts to read")
    result.add_argument("--most-bytes", type=int, default=300_000, help="largest file")
    result.add_argument("--most-triangles", type=int, default=8_000, help="largest mesh")
    return result


start(__file__, parser(), work)
