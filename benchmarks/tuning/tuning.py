#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What each constant of a folder of src that is MESHQUALITY_TUNED does at half and at double its value.

    cmake -B build/tunable -DMESHQUALITY_TUNABLE=ON ... (docs/measurements/tuning.md has the whole line)
    benchmarks/tuning/tuning.py --parts FOLDER --stage triangulate/refine --out out/refine.json
    benchmarks/tuning/tuning.py --stage boolean/rounding --first 12 --out out/rounding.json

A build with MESHQUALITY_TUNABLE scales constants by what the environment says; it takes the place
of the module in Mod/. The cases of tuning_cases.py for that folder are run with the defaults, then
with each constant halved and doubled; cases whose mesh has more than --most-triangles are left out.
Parts to triangulate are those of FOLDER (benchmarks/corpus_runs/parts_sources.py brings them) of the share to
develop on. A line is printed for each setting: cases that differ, and the sums of each figure, as
the difference from the defaults.
"""

import json
import os
import re
import sys
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
from child import in_child, outcome_in_child
from inside_freecad import ROOT, command_line, start

DECLARED = re.compile(r"MESHQUALITY_TUNED\(\s*([\w:]+),\s*(\w+),\s*([^;]+)\);")
FACTORS = (0.5, 2.0)
VARIABLE = "MESHQUALITY_TUNING"
MODULES = ROOT / "Mod" / "MeshQuality"
SECONDS_OF_CASE, SECONDS_OF_SETTING = 15, 3600
SUMMED = ("missed", "unforced", "far", "crossings", "errors", "faults", "invalid", "below", "triangles")


def constants(stage):
    """Names and values of the tuned constants in a folder of src, as they are declared."""
    found = {}
    for path in sorted((ROOT / "src" / stage).glob("*.h")):
        for _, name, value in DECLARED.findall(path.read_text(encoding="utf-8")):
            found[name] = value
    return found


def run_all(cases, setting):
    """Figures of all cases under one setting, by name, and the seconds of the processor; made by a child, whose
    module reads the setting when it is loaded.
    """
    def work():
        if setting:
            os.environ[VARIABLE] = setting
        import MeshQuality  # noqa: F401, PLC0415

        found, seconds = {}, 0.0
        for name, case in cases.items():
            def timed(case=case):
                begin = time.process_time()
                return [case(), time.process_time() - begin]

            answer, why = outcome_in_child(timed, SECONDS_OF_CASE)
            found[name] = answer[0] if answer else {"failed": why}
            seconds += answer[1] if answer else 0.0
        return {"cases": found, "seconds": seconds}

    return in_child(work, SECONDS_OF_SETTING)


def sums(run):
    """The figures of one setting over all cases."""
    cases = run["cases"].values()
    done = [c for c in cases if "failed" not in c]
    found = {name: sum(c[name] for c in done) for name in SUMMED if done and name in done[0]}
    return {"failed": len(cases) - len(done), **found, "seconds": run["seconds"]}


def compared(run, base):
    """Differences of the sums from the defaults, over the cases that both ended."""
    both = [n for n in base["cases"] if "failed" not in base["cases"][n] and "failed" not in run["cases"][n]]
    one = sums({"cases": {n: run["cases"][n] for n in both}, "seconds": run["seconds"]})
    other = sums({"cases": {n: base["cases"][n] for n in both}, "seconds": base["seconds"]})
    result = {name: one[name] - other[name] for name in one}
    result["failed"] = sums(run)["failed"] - sums(base)["failed"]
    result["differing"] = sum(run["cases"][n] != base["cases"][n] for n in both)
    result["triangles_percent"] = 100.0 * result.get("triangles", 0) / max(1, other.get("triangles", 0))
    result["seconds_percent"] = 100.0 * result["seconds"] / max(1e-9, other["seconds"])
    return result


def in_words(row):
    """A row in one line."""
    counts = " ".join(f"{name} {row[name]:+}" for name in ("failed", *SUMMED[:-1]) if name in row)
    return f"differ {row['differing']:4} {counts} triangles {row['triangles_percent']:+6.2f}% " \
           f"cpu {row['seconds_percent']:+5.0f}%"


def work(arguments):
    """Measures the stage and returns everything that is kept."""
    import tuning_cases  # noqa: PLC0415

    if not any(VARIABLE.encode() in module.read_bytes() for module in MODULES.glob("_core.*.so")):
        raise RuntimeError(f"the module in {MODULES} was built without MESHQUALITY_TUNABLE")
    cases = {name: case for name, case in tuning_cases.cases(arguments.stage, arguments).items()
             if not arguments.cases or name in arguments.cases}
    base = run_all(cases, "")
    if base is None:
        raise RuntimeError(f"the defaults took more than {SECONDS_OF_SETTING} s: take fewer cases (--first)")
    small = [n for n, c in base["cases"].items() if "failed" not in c and c["triangles"] <= arguments.most_triangles]
    if len(small) < len(base["cases"]):
        cases = {n: cases[n] for n in small}
        base = run_all(cases, "")
    print(f"{len(cases)} cases: {sums(base)}", flush=True)
    rows = {}
    for name, value in constants(arguments.stage).items():
        if arguments.only and name not in arguments.only:
            continue
        for factor in FACTORS:
            run = run_all(cases, f"{arguments.stage}/{name}={factor}")
            if run is None:
                print(f"{name:28} {value:>10} x{factor}: did not end", flush=True)
                continue
            rows[f"{name}*{factor}"] = compared(run, base)
            print(f"{name:28} {value:>10} x{factor}: {in_words(rows[f'{name}*{factor}'])}", flush=True)
    return {"arguments": vars(arguments) | {"out": str(arguments.out)}, "cases": base["cases"],
            "defaults": sums(base), "rows": rows}


def parser():
    """The command line."""
    result = command_line(__doc__)
    result.add_argument("--stage", required=True, help="folder of src, such as triangulate/refine")
    result.add_argument("--parts", help="folder of parts named by their digests, to triangulate")
    result.add_argument("--only", action="append", help="a constant")
    result.add_argument("--cases", nargs="*", help="names of cases; default: all")
    result.add_argument("--names", help="file with the digests of the parts to take")
    result.add_argument("--method", default="refine", help="refine, star or sprinkle")
    result.add_argument("--keep-edges", help="all or feature")
    result.add_argument("--first", type=int, default=200, help="parts to read, or pairs of operands")
    result.add_argument("--most-bytes", type=int, default=300_000, help="largest file")
    result.add_argument("--most-triangles", type=int, default=8_000, help="largest mesh")
    return result


start(__file__, parser(), work)
