#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a geometry engine on a thread of its own costs, and batches of queries save: Aftosmis 1999, section 1.2.

    /usr/bin/python3 benchmarks/papers aftosmis-engine

First the time of one query for the nearest point of a surface, by build/benchmarks/engine_bench: answered in the thread of
the caller, through the engine's main thread, and with the next batch submitted before the answers of this one are taken. Then
parts with new vertices in rounds and one after the other, by the paper's rule and by off-centres, each the quickest of five runs.
"""

import json

import inside_freecad
from papers import _programs

SIZES = (1, 16, 128, 1024)
WAYS = (("direct", "face_nearest/{}_direct"), ("thread", "face_nearest/{}_thread"),
        ("ahead", "face_nearest_ahead/{}_thread"))
SURFACES = ("cylinder", "spline")
NAMES = ("die", "wing_main", "flap", "crank", "bearing")
RULES = {"circumcentre": "paper", "off-centre": "off-centre"}
RUNS = 5


def parser():
    result = inside_freecad.command_line(__doc__)
    _programs.add_option(result, "engine_bench")
    return result


def microseconds(program):
    """{"surface, way": wall-clock microseconds a query by batch}, medians of five runs."""
    printed = _programs.output(program, "--benchmark_format=json", "--benchmark_repetitions=5", "--benchmark_min_time=0.05",
                               "--benchmark_report_aggregates_only=true")
    at = {run["run_name"]: run["real_time"] / 1000.0 for run in json.loads(printed)["benchmarks"]
          if run["aggregate_name"] == "median"}
    return {f"{surface}, {way}": [at[f"{pattern.format(surface)}/{size}/real_time"] / size for size in SIZES]
            for surface in SURFACES for way, pattern in WAYS}


def quickest(shape, rule, sites_in_round):
    """The report of the quickest run of Algorithm M, and its wall-clock seconds."""
    from MeshQuality.compat import extension

    best = None
    for _ in range(RUNS):
        options = extension().TriangulateOptions()
        options.insertion = RULES[rule]
        options.sites_in_round = sites_in_round
        report = extension().triangulate(shape, options).report
        if best is None or report.seconds["angles"] < best.seconds["angles"]:
            best = report
    return best


def work(arguments):
    import parts

    found = microseconds(arguments.program)
    print(f"{'microseconds a query':<22}" + "".join(f"{'batch of ' + format(size, ','):>16}" for size in SIZES))
    for name, values in found.items():
        print(f"{name:<22}" + "".join(f"{value:16.3f}" for value in values))
    print(f"\n{'part':<10} {'rule':<13} {'in rounds: triangles':>21} {'queries':>8} {'s':>7} {'one by one: triangles':>22} "
          f"{'queries':>8} {'s':>7}")
    rows = []
    for name in NAMES:
        shape = parts.ALL[name]()
        for rule in RULES:
            row = {"part": name, "rule": rule}
            for key, sites in (("rounds", 0), ("one", 1)):
                report = quickest(shape, rule, sites)
                row[key] = {"triangles": report.triangles, "queries": report.queries, "seconds": report.seconds["angles"]}
            rows.append(row)
            rounds, one = row["rounds"], row["one"]
            print(f"{name:<10} {rule:<13} {rounds['triangles']:21,} {rounds['queries']:8,} {rounds['seconds']:7.4f} "
                  f"{one['triangles']:22,} {one['queries']:8,} {one['seconds']:7.4f}", flush=True)
    return {"microseconds": found, "rows": rows}


inside_freecad.start(__file__, parser(), work)
