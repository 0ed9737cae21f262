#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes random parts and checks every promise of the mesher; not part of the test suite.

    benchmarks/corpus_runs/fuzz_parts.py [--first 0] [--parts 300] [--jobs 1] [--creased] [--reduce]
    benchmarks/corpus_runs/fuzz_parts.py --first 17 --parts 1 --brep part.brep

Parts are modelled from a seed by FreeCAD (fuzz_shapes.py), each meshed in a process of its own with
random options. Every failure is one line with the seed that repeats it. With --reduce, steps of a
failing part and options are left out as long as a failure of the same kind is left.
"""

import argparse
import json
import os
import re
import sys
import tempfile
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
from child import Limits, crash_cause

HERE = Path(__file__).resolve().parent
OPTIONS = ("max_edge", "min_edge", "chord_height", "method", "min_angle")


def parse_arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--first", type=int, default=0, help="the first seed")
    parser.add_argument("--parts", type=int, default=300, help="how many seeds")
    parser.add_argument("--skip", default="", help="steps of the part to leave out: 1,3")
    parser.add_argument("--plain", default="", help="options to leave out: max_edge,method")
    parser.add_argument("--creased", action="store_true",
                        help="faces of parts have creases: see fuzz_shapes.random_part")
    parser.add_argument("--reduce", action="store_true", help="make failing parts smaller")
    parser.add_argument("--brep", help="file for the part (of the last seed)")
    parser.add_argument("--jobs", type=int, default=1, help="parts meshed at the same time")
    parser.add_argument("--time-limit", type=float, default=120.0,
                        help="seconds of the processor a part")
    parser.add_argument("--memory-limit", type=float, default=4.0, help="GiB a part")
    parser.add_argument("--mod", type=Path, default=HERE.parents[1] / "Mod",
                        help="where MeshQuality lies")
    parser.add_argument("--out", type=Path, default=HERE.parents[1] / "out" / "fuzz_parts.jsonl")
    return parser.parse_args()


def mesh_one(seed, skip, plain, arguments):
    """The result of one seed; state: ok, no part, crash or timeout."""
    limits = Limits(arguments.time_limit, arguments.memory_limit)
    with tempfile.TemporaryDirectory() as scratch:
        file = Path(scratch) / "result.json"
        job = {"seed": seed, "skip": skip, "plain": plain, "result": str(file),
               "creased": arguments.creased,
               "brep": arguments.brep and str(Path(arguments.brep).resolve())}
        status, output = limits.run(
            ["freecadcmd", "-P", str(arguments.mod), str(HERE / "fuzz_worker.py")],
            {**os.environ, "MESHQUALITY_JOB": json.dumps(job)})
        found = json.loads(file.read_text(encoding="utf-8")) if file.exists() else {}
    result = {"seed": seed, "skip": skip, "plain": plain, "state": "crash", **found}
    if status is None:
        # Without a part it is FreeCAD's modelling that takes so long.
        result["state"] = "timeout" if found else "no part"
        result["faults"] = ["timeout"] if found else []
    elif result["state"] == "crash":
        result["state"] = "crash" if found else "no part"
        result["faults"] = [f"crash: {crash_cause(status, output)}"] if found else []
    return {**result, "creased": arguments.creased}


def kinds(result):
    """The faults without their numbers, to tell whether two results fail alike."""
    return {re.sub(r"\d+(\.\d+)?(e[+-]?\d+)?", "#", fault) for fault in result["faults"]}


def reduced(result, arguments):
    """The smallest failing result that leaving out steps and options one by one leads to."""
    wanted = kinds(result)
    for number, _ in reversed(result.get("steps", [])[1:]):
        smaller = mesh_one(result["seed"], [*result["skip"], number], result["plain"], arguments)
        if kinds(smaller) & wanted:
            result = smaller
    for name in OPTIONS:
        if name in result.get("options", {}):
            smaller = mesh_one(result["seed"], result["skip"], [*result["plain"], name], arguments)
            if kinds(smaller) & wanted:
                result = smaller
    return result


def line(result):
    steps = ", ".join(what for _, what in result.get("steps", []))
    options = " ".join(f"{name}={value:.6g}" if isinstance(value, float) else f"{name}={value}"
                       for name, value in result.get("options", {}).items())
    repeat = f"--first {result['seed']} --parts 1"
    for name in ("skip", "plain"):
        if result[name]:
            repeat += f" --{name} {','.join(map(str, result[name]))}"
    repeat += " --creased" if result["creased"] else ""
    crossing = " (the part crosses itself)" if result.get("crossing") else ""
    return f"{repeat}: {'; '.join(result['faults'])}{crossing} | {steps} | {options}"


def main():
    arguments = parse_arguments()
    arguments.out.parent.mkdir(parents=True, exist_ok=True)
    skip = [int(number) for number in arguments.skip.split(",") if number]
    plain = [name for name in arguments.plain.split(",") if name]

    def work(seed):
        result = mesh_one(seed, skip, plain, arguments)
        if result["faults"]:
            print(line(result), flush=True)
            if arguments.reduce:
                result = reduced(result, arguments)
                print("  reduced: " + line(result), flush=True)
        with open(arguments.out, "a", encoding="utf-8") as stream:
            stream.write(json.dumps(result) + "\n")
        return result

    with ThreadPoolExecutor(arguments.jobs) as pool:
        results = list(pool.map(work, range(arguments.first, arguments.first + arguments.parts)))
    failing = [result for result in results if result["faults"]]
    print(f"states: {dict(Counter(result['state'] for result in results))}; "
          f"{sum(result.get('triangles', 0) for result in results)} triangles")
    print(f"{len(failing)} parts failing, "
          f"{sum(bool(result.get('crossing')) for result in failing)} of them cross themselves")
    return 1 if failing else 0


if __name__ == "__main__":
    sys.exit(main())
