#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What curved elements are good for: errors of finite elements against their order on one coarse mesh.

    /usr/bin/python3 benchmarks/p_convergence.py [--picture docs/pictures/p_convergence.svg]

prints a table; see poisson.py for the problem.
"""

import os

import inside_freecad

ORDERS = (1, 2, 3, 4)


def draw(rows, path):
    """Both errors against the order, curved and straight."""
    import matplotlib

    matplotlib.use("Agg")
    matplotlib.rcParams["svg.hashsalt"] = "p-convergence"
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(1, 2, figsize=(9, 3.8), sharey=True)
    columns = list(zip(*rows))
    for axis, name, curved, straight in ((axes[0], "L2 error", 3, 5), (axes[1], "H1 error", 4, 6)):
        axis.semilogy(columns[0], columns[straight], "s--", color="#b33", label="straight sides")
        axis.semilogy(columns[0], columns[curved], "o-", color="#24a", label="curved")
        axis.set_xticks(columns[0])
        axis.set_xlabel("order of the elements")
        axis.set_title(f"relative {name}")
        axis.grid(True, which="both", alpha=0.3)
    axes[0].legend()
    figure.suptitle(f"Poisson's equation in a torus, {rows[0][1]} tetrahedra")
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--picture", type=os.path.abspath, help="file to draw the errors into")
    return result


def work(arguments):
    import poisson

    rows = poisson.study(ORDERS)
    print("order elements unknowns  curved: L2, H1        straight: L2, H1")
    for row in rows:
        print("{:5d} {:8d} {:8d}  {:9.2e} {:9.2e}   {:9.2e} {:9.2e}".format(*row))
    if arguments.picture:
        draw(rows, arguments.picture)
    return {"columns": poisson.COLUMNS, "rows": rows}


inside_freecad.start(__file__, parser(), work)
