#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The local operations of Dey, O'Bara, Shephard, figures 8 to 15: each on the smallest mesh that needs it, before and after.

    /usr/bin/python3 benchmarks/papers dey-operations [--out-dir docs/pictures] [--program build/benchmarks/curve_operations]

The program is a benchmark in C++ that calls the operations one by one, as the repairs do:

    cmake -B build -DMESHQUALITY_BENCHMARKS=ON && ninja -C build curve_operations

Qualities are lower bounds of min J / max J, equation (3). The status is 1 where an operation does not make all elements valid.
"""

import argparse
import json
import sys
from pathlib import Path

import inside_freecad
import numpy as np
import small_pictures
from papers import _programs

INVALID, VALID, BORDER, INSIDE = "#d8403a", "#bcd7ee", "#222222", "#1c6fb5"
VIEW = (-62.0, 24.0)  # azimuth and elevation, degrees


def parser():
    result = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    result.add_argument("--out-dir", type=Path, default=inside_freecad.ROOT / "docs" / "pictures", help="folder for the pictures")
    _programs.add_option(result, "curve_operations")
    return result


def state_of(snapshot):
    return snapshot.get("state", snapshot)


def worst(snapshot):
    return min(element["quality"] for element in state_of(snapshot)["elements"])


def invalid(snapshot):
    return sum(not element["quality"] > 0.0 for element in state_of(snapshot)["elements"])


def edges_of(state):
    return {tuple(edge["vertices"]): np.array(edge["points"]) for edge in state["edges"]}


def draw_triangles(axis, state):
    """From above."""
    edges = edges_of(state)
    for element in state["elements"]:
        a, b, c = element["corners"]
        outline = [edges[(p, q)] if p < q else edges[(q, p)][::-1] for p, q in ((a, b), (b, c), (c, a))]
        colour = VALID if element["quality"] > 0.0 else INVALID
        axis.fill(*np.concatenate(outline)[:, :2].T, facecolor=colour, alpha=0.6)
    for edge in state["edges"]:
        axis.plot(*np.array(edge["points"])[:, :2].T, color=BORDER if edge["fixed"] else INSIDE, linewidth=1.6 if edge["fixed"] else 1.0)


def draw_tetrahedra(axis, snapshot, camera):
    """Edges on the surface dark, those inside blue, or red in elements that are not valid."""
    state = state_of(snapshot)
    bad = [set(element["corners"]) for element in state["elements"] if not element["quality"] > 0.0]
    for edge in sorted(state["edges"], key=lambda edge: not edge["fixed"]):
        points = np.array(edge["points"])
        bent = np.linalg.norm(points[len(points) // 2] - (points[0] + points[-1]) / 2) > 1e-3
        colour = BORDER if edge["fixed"] else INVALID if any(set(edge["vertices"]) <= one for one in bad) else INSIDE
        axis.plot(*(points @ camera.T)[:, :2].T, color=colour, linewidth=(2.4 if bent else 0.7) if edge["fixed"] else 1.4)
    for line in snapshot.get("lines", ()):
        axis.plot(*(np.array(line) @ camera.T)[:, :2].T, color="#888888", linewidth=0.5)
    if "node" in snapshot:
        axis.plot(*(np.array(snapshot["node"]) @ camera.T)[:2], "o", color=INVALID if bad else INSIDE, markersize=4)


def draw(found, path):
    """Before above, after below, a column for each operation."""
    import render

    figure, axes = small_pictures.panels(2, len(found), 2.1, 2.1)
    camera = render.camera(*VIEW)
    for column, row in enumerate(found):
        for axis, when in ((axes[column], "before"), (axes[len(found) + column], "after")):
            if len(state_of(row[when])["elements"][0]["corners"]) == 3:
                draw_triangles(axis, row[when])
            else:
                draw_tetrahedra(axis, row[when], render.camera(0.0, 89.0) if "node" in row[when] else camera)
            axis.set_aspect("equal")
            name = f"{row['operation']}\n" if when == "before" else ""
            axis.set_title(f"{name}{when}: {worst(row[when]):.2f}", fontsize=7)
    small_pictures.save(figure, path)


def main():
    arguments = parser().parse_args()
    sys.path.append(str(inside_freecad.ROOT / "tools"))
    found = [json.loads(line) for line in _programs.output(arguments.program).splitlines()]
    print(f"{'operation':<32} {'before: elements':>16} {'invalid':>7} {'min J / max J':>13} {'after: elements':>15} {'invalid':>7} "
          f"{'min J / max J':>13}")
    for row in found:
        before, after = row["before"], row["after"]
        print(f"{row['operation']:<32} {len(state_of(before)['elements']):16} {invalid(before):7} {worst(before):13.2f} "
              f"{len(state_of(after)['elements']):15} {invalid(after):7} {worst(after):13.2f}{'' if row['done'] else ' REFUSED'}")
    flat = [row for row in found if len(state_of(row["before"])["elements"][0]["corners"]) == 3]
    draw(flat, arguments.out_dir / "dey_operations_face.png")
    draw([row for row in found if row not in flat], arguments.out_dir / "dey_operations_region.png")
    return 0 if all(row["done"] and not invalid(row["after"]) for row in found) else 1


if __name__ == "__main__":
    sys.exit(main())
