#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Table III of Wang 2010: the whole surface reconstructed from the samples (full=True) against the partial reconstruction.

    /usr/bin/python3 benchmarks/papers wang-table3 [--rows chair] [--rays 257 513] [--points 200000]

Mean and largest distance from the exact result as in wang-table2; ours are seconds of the processor, the paper's are on the clock.
Models stand for the paper's (benchmarks/boolean/wang_models.py), in $MESHQUALITY_DATA.
"""

import argparse
import tempfile

import wang_models
import wang_runs


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rows", nargs="+", default=[example.name for example in wang_models.EXAMPLES if example.full],
                        help="only examples whose names contain one of these words")
    parser.add_argument("--rays", type=int, nargs="+", default=[513])
    parser.add_argument("--points", type=int, default=200_000, help="on each surface")
    arguments = parser.parse_args()
    print("| example | rays | reconstruction | triangles | kept | mean, % | largest, % | CPU s | crossings | the paper's mean, % "
          "| clock s |\n|" + "---|" * 11)
    with tempfile.TemporaryDirectory() as folder:
        for example in wang_models.named(arguments.rows):
            wang_runs.operands(example.name, folder, with_exact=True)
            for rays in arguments.rays:
                for full in (False, True):
                    run = wang_runs.boolean(example.name, folder, rays, full=full, points=arguments.points)
                    show(example, rays, full, run)


def show(example, rays, full, run):
    mean, largest = (max(values) for values in zip(run["errors"]["to"], run["errors"]["back"]))
    partial = (example.errors[rays][0], example.paper[rays][0]) if rays in example.errors else ()
    paper = example.full if full and rays == 513 else () if full else partial
    theirs = f"{paper[0]:.2g} | {paper[1]:g}" if paper else "- | -"
    print(f"| {example.name} | {rays} | {'full' if full else 'partial'} | {run['triangles']:,} | {run['retained']:,} | {mean:.2g} | "
          f"{largest:.2g} | {run['cpu_seconds']:.2f} | {run['crossings']} | {theirs} |", flush=True)


if __name__ == "__main__":
    main()
