#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Share and cost of exact predicates: Aftosmis 1999, sections 3.1 and 3.4.

    /usr/bin/python3 benchmarks/papers aftosmis-predicates

First how many predicates the parts of section 4 take, and how many of them floating point does not decide; then what one
costs, by build/benchmarks/predicates_bench, on random quadrilaterals, on a lattice and on turned squares, whose angles
are equal or nearly so.
"""

import json

import inside_freecad
from papers import _programs

NAMES = ("die", "wing_main", "flap")
RULES = ("circumcentre", "off-centre")
ANGLE = 25.0
KINDS = ("random", "lattice", "turned squares")  # as in predicates_bench.cpp


def parser():
    result = inside_freecad.command_line(__doc__)
    _programs.add_option(result, "predicates_bench")
    return result


def counts():
    import parts

    import MeshQuality as mq

    print(f"{'part':<10} {'rule':<13} {'triangles':>9} {'predicates':>11} {'a triangle':>11} {'exact':>8} {'share':>7}")
    rows = []
    for name in NAMES:
        shape = parts.ALL[name]()
        for rule in RULES:
            report = mq.triangulate(shape, min_angle=ANGLE, chord_height="none", insertion=rule).report
            rows.append({"part": name, "rule": rule, "triangles": report.triangles, "predicates": report.predicates,
                         "exact": report.exact_predicates, "cpu_seconds": report.cpu_seconds})
            print(f"{name:<10} {rule:<13} {report.triangles:9,} {report.predicates:11,} "
                  f"{report.predicates / report.triangles:11.1f} {report.exact_predicates:8,} "
                  f"{report.exact_predicates / report.predicates:7.2%}", flush=True)
    return rows


def costs(program):
    """{predicate: [(ns, exact share) by kind]}, medians of five runs."""
    printed = _programs.output(program, "--benchmark_format=json", "--benchmark_repetitions=5", "--benchmark_min_time=0.1",
                               "--benchmark_report_aggregates_only=true")
    found = {}
    for run in json.loads(printed)["benchmarks"]:
        if run["aggregate_name"] == "median":
            name, _, kind = run["run_name"].partition("/kind:")
            found.setdefault(name.removesuffix("_bench"), {})[KINDS[int(kind)]] = {
                "ns": run["cpu_time"], "exact_share": run.get("exact_share", 0.0)}
    print(f"\n{'ns of the processor each':<18}" + "".join(f"{kind + ' (exact)':>26}" for kind in KINDS))
    for name, by_kind in found.items():
        print(f"{name:<18}" + "".join(f"{by_kind[kind]['ns']:16,.1f} ({by_kind[kind]['exact_share']:7.2%})"
                                      for kind in KINDS))
    return found


def work(arguments):
    rows = counts()
    return {"rows": rows, "costs": costs(arguments.program)}


inside_freecad.start(__file__, parser(), work)
