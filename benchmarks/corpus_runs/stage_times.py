#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What triangulating the corpus costs: processor seconds, triangles a second, and the clock by stage.

    /usr/bin/python3 benchmarks/corpus_runs/stage_times.py [--only PATTERN] [--folder FOLDER] [--relative 1e-3] [--rounds 3]
                                               [--min-angle 25] [--threads 1] [--against FILE]

All parts of $MESHQUALITY_DATA/cad, or of a folder, are meshed in one FreeCAD; of the rounds of a part the one
with the least processor time counts. Reading the files is FreeCAD's work, and not in it; reading and
checking their shapes is. --against shows a JSON file of another build beside it, with all parts whose
triangles below the bound, for which no corner of the part is the reason, or crossings differ. On an
idle machine threads that wait for each other cost more than on a busy one: compare runs of one hour.
"""

import fnmatch
import json
import sys
import time
from collections import Counter
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--only", default="*", metavar="PATTERN", help="names of parts")
    result.add_argument("--folder", help="of CAD files")
    result.add_argument("--relative", type=float, default=1e-3, help="chord height, of the largest dimension")
    result.add_argument("--min-angle", type=float, default=25.0)
    result.add_argument("--rounds", type=int, default=1)
    result.add_argument("--threads", type=int, default=0)
    result.add_argument("--against", help="what this wrote for another build")
    return result


def measured(shape, options):
    """What one call cost, and what it gave."""
    import MeshQuality as mq

    cpu, clock = time.process_time(), time.perf_counter()
    try:
        mesh = mq.triangulate(shape, **options)
    except mq.Error as error:
        return {"error": str(error), "cpu": time.process_time() - cpu}
    report = mesh.report
    return {"cpu": time.process_time() - cpu, "clock": time.perf_counter() - clock, "stages": dict(report.seconds),
            "triangles": len(mesh.triangles), "queries": report.queries, "crossings": report.self_intersections,
            "unforced": sum(1 for _, reason in report.exempt_reasons if not reason.forced)}


def show(parts):
    """The sums of all parts that could be meshed."""
    meshed = [part for part in parts.values() if "error" not in part]
    cpu = sum(part["cpu"] for part in meshed)
    triangles = sum(part["triangles"] for part in meshed)
    stages = Counter()
    for part in meshed:
        stages.update(part["stages"])
    print(f"{len(meshed)} of {len(parts)} parts, {triangles} triangles: {cpu:.2f} CPU s, "
          f"{sum(part['clock'] for part in meshed):.2f} s on the clock, {triangles / max(cpu, 1e-9):.0f} triangles a CPU s; "
          f"below the bound {sum(part['unforced'] for part in meshed)}")
    print("on the clock: " + ", ".join(f"{name} {seconds:.2f}" for name, seconds in stages.most_common()))


def compare(parts, others):
    for name in sorted(parts.keys() & others.keys()):
        now, then = parts[name], others[name]
        if ("error" in now) != ("error" in then):
            print(f"{name}: {then.get('error', 'meshed')} -> {now.get('error', 'meshed')}")
        elif "error" not in now and any(now[what] != then[what] for what in ("unforced", "crossings")):
            print(f"{name}: below the bound {then['unforced']} -> {now['unforced']}, crossings {then['crossings']} -> "
                  f"{now['crossings']}, CPU {then['cpu']:.2f} -> {now['cpu']:.2f} s")
    both = [name for name in parts if name in others and "error" not in parts[name] and "error" not in others[name]]
    print(f"of {len(both)} parts that both mesh: {sum(others[name]['cpu'] for name in both):.2f} -> "
          f"{sum(parts[name]['cpu'] for name in both):.2f} CPU s")


def work(arguments):
    import Part

    folder = Path(arguments.folder) if arguments.folder else inside_freecad.data_folder() / "cad"
    options = {"chord_height_relative": arguments.relative, "min_angle": arguments.min_angle}
    options.update({"threads": arguments.threads} if arguments.threads else {})
    parts = {}
    for path in sorted(folder.iterdir()):
        if path.suffix.lower() in inside_freecad.CAD_SUFFIXES and fnmatch.fnmatch(path.name, arguments.only):
            shape = Part.Shape()
            shape.read(str(path))
            rounds = [measured(shape, options) for _ in range(arguments.rounds)]
            parts[path.name] = min(rounds, key=lambda one: one["cpu"])
    show(parts)
    if arguments.against:
        others = json.loads(Path(arguments.against).read_text(encoding="utf-8"))["parts"]
        show(others)
        compare(parts, others)
    return {"parts": parts}


inside_freecad.start(__file__, parser(), work)
