#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Table II of Wang 2010: mean and largest distance between the uniform and the exact Boolean, in per cent of the diagonal.

    /usr/bin/python3 benchmarks/papers wang-table2 [--rows chair] [--rays 257 513] [--points 200000]

As Metro measures: from points that lie evenly on one surface, and its vertices, to triangles of the other, by VTK. The paper's
figures are from its result to CGAL's. `back` is the other way, which the paper does not give. Models stand for the paper's
(benchmarks/boolean/wang_models.py), in $MESHQUALITY_DATA. --rows "" has all the examples of table I.
"""

import argparse
import tempfile

import wang_models
import wang_runs


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rows", nargs="+", default=[example.name for example in wang_models.EXAMPLES if example.errors],
                        help="only examples whose names contain one of these words")
    parser.add_argument("--rays", type=int, nargs="+", default=[257, 513, 1025])
    parser.add_argument("--points", type=int, default=200_000, help="on each surface")
    arguments = parser.parse_args()
    print("| example | rays | mean | largest | back: mean | largest | bound | the paper's mean | largest |\n|" + "---|" * 9)
    with tempfile.TemporaryDirectory() as folder:
        for example in wang_models.named(arguments.rows):
            wang_runs.operands(example.name, folder, with_exact=True)
            for rays in arguments.rays:
                show(example, rays, wang_runs.boolean(example.name, folder, rays, points=arguments.points))


def show(example, rays, run):
    paper = " | ".join(f"{value:.2g}" for value in example.errors.get(rays, ())) or "- | -"
    ours = " | ".join(f"{value:.2g}" for way in ("to", "back") for value in run["errors"][way])
    print(f"| {example.name} | {rays} | {ours} | {run['errors']['bound']:.2g} | {paper} |", flush=True)


if __name__ == "__main__":
    main()
