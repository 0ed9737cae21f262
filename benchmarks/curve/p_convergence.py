#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What curved elements are good for: errors of finite elements against their order on one coarse mesh.

    /usr/bin/python3 benchmarks/curve/p_convergence.py [--picture docs/pictures/p_convergence.svg]

prints a table; see poisson.py for the problem.
"""

import os
import sys
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad

ORDERS = (1, 2, 3, 4)


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
        poisson.draw(rows, arguments.picture)
    return {"columns": poisson.COLUMNS, "rows": rows}


inside_freecad.start(__file__, parser(), work)
