#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The largest von Mises stress on FEM meshes with default options, by CalculiX.

    /usr/bin/python3 benchmarks/solvers/fem_stress.py [--parts cantilever bracket shaft]

prints a row for each part and each number of elements through its walls, against a mesh with edges of 1.5 mm, that of the
cantilever against beam theory.
"""

import sys
import tempfile
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad

REFERENCE_EDGE = 1.5  # mm
HEAD = "| part | elements through | longest edge | tetrahedra | expected | solver s | largest stress | error |"


def parser():
    result = inside_freecad.command_line(__doc__)
    names = ["cantilever", "bracket", "shaft"]
    result.add_argument("--parts", nargs="+", choices=names, default=names)
    return result


def work(arguments):
    import cantilever

    print(HEAD)
    results = {}
    for name in arguments.parts:
        with tempfile.TemporaryDirectory() as folder:
            right = cantilever.BORED_STRESS if name == "cantilever" \
                else cantilever.largest_stress(name, folder, max_edge=REFERENCE_EDGE)["stress"]
            for through in (1, 2, 3):
                row = cantilever.largest_stress(name, folder, elements_through=through)
                print(f"| {name} | {through} | {row['edge']:.2f} mm | {row['tetrahedra']:,} | {row['expected']:,} | "
                      f"{row['solver']:.0f} | {row['stress']:.1f} MPa | {100 * (row['stress'] / right - 1):+.1f} % |", flush=True)
                results.setdefault(name, []).append(row)
    return results


inside_freecad.start(__file__, parser(), work)
