#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Table I of Wang 2010 at the paper's sizes: time, memory, triangles kept, beside exact Booleans of ours and of others.

    /usr/bin/python3 benchmarks/papers wang-table1 [--rows dragon ring] [--rays 257 513] [--peer PROGRAM]

The paper's models are not public: scans of $MESHQUALITY_DATA with the same numbers of triangles stand for them
(benchmarks/boolean/wang_models.py). Each Boolean has a FreeCAD of its own. Seconds are of the processor, from arrays to the measured and
checked result; MB are the most that were resident, in brackets those before the Boolean. A peer is a program that reads and
writes files, as benchmarks/boolean/boolean_peers.py asks for: it is not in the repository.
"""

import argparse
import json
import tempfile
from pathlib import Path

import boolean_peers
import wang_models
import wang_runs

STAGES = ("sampling", "clustering", "membership", "octree", "stitching", "contouring", "two-manifold", "assembly", "measuring")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rows", nargs="+", default=[], help="only examples whose names contain one of these words")
    parser.add_argument("--rays", type=int, nargs="+", default=[129, 257, 513, 1025])
    parser.add_argument("--peer", action="append", metavar="PROGRAM", default=[])
    parser.add_argument("--out", metavar="FILE", help="figures of all rows as JSON")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        rows = [measure(example, arguments, folder) for example in wang_models.named(arguments.rows)]
    if arguments.out:
        figures = {row["example"].name: {name: row[name] for name in ("counts", "runs", "exact")} for row in rows}
        Path(arguments.out).write_text(json.dumps(figures), encoding="utf-8")
    peers = [boolean_peers.Peer(path, ".").name for path in arguments.peer]
    times(rows, arguments.rays, peers)
    sizes(rows, arguments.rays)
    stages(rows, arguments.rays)


def measure(example, arguments, folder):
    """All figures of an example; says how far it is."""
    counts = wang_runs.operands(example.name, folder)["triangles"]
    print(f"{example.name}: {counts[0]:,} and {counts[1]:,} triangles", flush=True)
    runs = {rays: wang_runs.boolean(example.name, folder, rays) for rays in arguments.rays}
    exact = wang_runs.boolean(example.name, folder, 513, method="exact")
    return {"example": example, "counts": counts, "runs": runs, "exact": exact,
            "peers": [ask(path, example, folder) for path in arguments.peer]}


def ask(path, example, folder):
    """A peer's seconds of the processor, or why there are none."""
    peer = boolean_peers.Peer(path, folder)
    meshes = wang_runs.load(Path(folder) / f"{example.name}.npz")
    word = example.name.replace(" ", "_")
    files = [peer.operand(f"{word}{k}", mesh) for k, mesh in enumerate(meshes)]
    seconds, found = peer.run(example.operation, files)
    return found.removeprefix("FAIL:").replace("_", " ") if seconds is None else f"{seconds:.2f}"


def table(title, head, lines):
    print(f"\n{title}\n\n| {' | '.join(head)} |\n|{'---|' * len(head)}")
    for line in lines:
        print(f"| {' | '.join(line)} |", flush=True)


def times(rows, rays, peers):
    """Seconds of the processor, in brackets the paper's on the clock."""
    lines = []
    for row in rows:
        example = row["example"]
        cells = []
        for count in rays:
            run, paper = row["runs"][count], example.paper.get(count)
            cells.append(f"{run['cpu_seconds']:.2f}" + (f" ({paper[0]:g})" if paper else ""))
        others = ", ".join("fails" if seconds is None else f"{seconds:g}" for seconds in example.others.values())
        lines.append([example.name, *cells, f"{row['exact']['cpu_seconds']:.2f}", *row["peers"], others])
    table("Our seconds of the processor (in brackets the paper's seconds on the clock, with a graphics card)",
          ["example", *map(str, rays), "exact", *peers, "the paper's " + ", ".join(rows[0]["example"].others)], lines)


def sizes(rows, rays):
    lines = []
    for row in rows:
        runs = [row["runs"][count] for count in rays]
        kept = [f"{100 * run['retained'] / max(run['triangles'], 1):.0f}" for run in runs]
        lines.append([
            row["example"].name, " and ".join(map(number, row["counts"], row["example"].faces)),
            ", ".join(f"{run['megabytes']:.0f}" for run in runs) + f" ({runs[0]['megabytes_before']:.0f})",
            f"{row['exact']['megabytes']:.0f}", f"{runs[-1]['triangles']:,}", f"{row['exact']['triangles']:,}",
            ", ".join(kept), ", ".join(str(run["crossings"]) for run in runs),
            *(", ".join(str(run[name]) for run in runs) + f" ({row['exact'][name]})" for name in ("components", "euler")),
            ", ".join(str(run["degenerate"]) for run in runs), str(sum(run["open"] for run in runs))])
    table(f"Triangles of the operands (of the paper's where they are others); of MB, per cent kept, crossings, components and triangles without area "
          f"one number each for {', '.join(map(str, rays))} rays (MB before the Boolean)", [
              "example", "operands", "MB", "exact", f"triangles at {rays[-1]}", "exact", "kept, %", "crossings", "components (exact)",
              "Euler number (exact)", "without area",
              "not manifold"], lines)


def number(count, paper):
    return f"{count:,}" + (f" ({paper:,})" if paper not in (None, count) else "")


def stages(rows, rays):
    """Shares of the clock; the rest is inspecting the operands, and the check of the result. At last the paper's sampling."""
    lines = []
    for row in rows:
        run = row["runs"][rays[-1]]
        shares = {name: run["stages"].get(name, 0.0) / run["seconds"] for name in STAGES}
        shares["rest"] = 1.0 - sum(shares.values())
        paper = row["example"].paper.get(rays[-1])
        lines.append([row["example"].name, *(f"{100 * share:.0f}" for share in shares.values()),
                      f"{100 * paper[1] / paper[0]:.0f}" if paper else "-"])
    table(f"Per cent of the time on the clock at {rays[-1]} rays, by stage",
          ["example", *STAGES, "rest", "the paper's sampling"], lines)


if __name__ == "__main__":
    main()
