#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure 11 of Wang 2010 and its claim on time: holes that stitching leaves, and time by stage, against the resolution.

    /usr/bin/python3 benchmarks/papers wang-holes [--rows dragon] [--rays 65 129] [--runs 5]
        [--picture docs/pictures/wang_holes.png]

Holes are those that were filled; beside them how many there are for 1,000 triangles that were made. Seconds are those of the run
that is the quickest on the clock: of the processor and on the clock for the whole Boolean with its check, on the clock for the
stages. Sampling runs on all cores. The rest is what no stage has: inspecting the operands and checking the result. Models stand
for the paper's (benchmarks/boolean/wang_models.py), in $MESHQUALITY_DATA.
"""

import argparse
import tempfile

import wang_models
import wang_runs

STAGES = ("sampling", "octree", "contouring", "two-manifold")
ROWS = ("vase-lion U dragon", "chair - flower", "helix - slices", "dragon - bunny", "armadillo U nefertiti")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rows", nargs="+", default=list(ROWS), help="only examples whose names contain one of these words")
    parser.add_argument("--rays", type=int, nargs="+", default=[65, 129, 257, 513, 1025])
    parser.add_argument("--runs", type=int, default=1, help="of which the quickest counts")
    parser.add_argument("--picture", metavar="FILE")
    arguments = parser.parse_args()
    found = {}
    print(f"| example | rays | holes | per 1,000 made | CPU s | times those before | clock s | {' | '.join(STAGES)} | rest |\n|"
          + "---|" * 12)
    with tempfile.TemporaryDirectory() as folder:
        for example in wang_models.named(arguments.rows):
            wang_runs.operands(example.name, folder)
            runs = found[example.name] = []
            for rays in arguments.rays:
                again = (wang_runs.boolean(example.name, folder, rays) for _ in range(arguments.runs))
                runs.append(min(again, key=lambda run: run["seconds"]))
                show(example.name, rays, runs)
    if arguments.picture:
        draw(found, arguments.rays, arguments.picture)


def show(name, rays, runs):
    run = runs[-1]
    made = run["triangles"] - run["retained"]
    grown = f"{run['cpu_seconds'] / runs[-2]['cpu_seconds']:.1f}" if len(runs) > 1 else "-"
    seconds = [run["stages"].get(stage, 0.0) for stage in STAGES]
    seconds.append(run["seconds"] - sum(run["stages"].values()))
    print(f"| {name} | {rays} | {run['holes']} | {1000 * run['holes'] / max(made, 1):.2g} | {run['cpu_seconds']:.2f} | {grown} | "
          f"{run['seconds']:.2f} | {' | '.join(f'{value:.2f}' for value in seconds)} |", flush=True)


def draw(found, rays, path):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, (holes, time) = pyplot.subplots(1, 2, figsize=(9.0, 3.6), constrained_layout=True)
    for name, runs in found.items():
        holes.plot(rays, [1000 * run["holes"] / max(run["triangles"] - run["retained"], 1) for run in runs], "o-", label=name)
        time.plot(rays, [run["cpu_seconds"] / runs[0]["cpu_seconds"] for run in runs], "o-")
    time.plot(rays, [count / rays[0] for count in rays], "k:", label="rays along a side")
    time.plot(rays, [(count / rays[0]) ** 2 for count in rays], "k--", label="rays")
    for axes, title in ((holes, "holes per 1,000 triangles made"), (time, f"processor time, that at {rays[0]} rays = 1")):
        axes.set(xscale="log", yscale="log", xlabel="rays along a side", title=title)
        axes.set_xticks(rays, map(str, rays))
        axes.minorticks_off()
        axes.legend(fontsize="small")
    figure.savefig(path, dpi=110)


if __name__ == "__main__":
    main()
