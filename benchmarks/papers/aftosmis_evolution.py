#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The smallest angle while Algorithm M runs, over the number of triangles: figures 2, 7, 9 and 10 of Aftosmis 1999.

    /usr/bin/python3 benchmarks/papers aftosmis-evolution [--angle 30]

The core records the smallest angle of all triangles that are not exempt after each vertex that it inserts. "one by one" is
the paper's order: the triangle with the smallest angle first, one after the other. "rounds" is what users get: as many
triangles from the head of the queue as make a batch of queries. A bound of 25 degrees, read from a curve, is where it
passes 25 degrees for the first time.
"""

from pathlib import Path

import inside_freecad

PAPER = {"die": 2606, "wing_main": 20846, "flap": 15334}
PAPER_ANGLE = 25.0
RULES = {"circumcentre": "paper", "off-centre": "off-centre"}  # by their names in the core
ORDERS = {"one by one": 1, "rounds": 0}  # sites in a round
COLOURS = {"circumcentre": "#c2452d", "off-centre": "#3667a6"}
TINY = 0.01  # degrees; smaller falls are not counted


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--angle", type=float, default=30.0, metavar="DEGREES", help="the bound, 25 to 34")
    result.add_argument("--out-dir", default=str(inside_freecad.ROOT / "docs" / "pictures"), help="folder for the picture")
    return result


def history(shape, angle, rule, order):
    """(numbers of triangles, smallest angles) and the mesh in the core's memory."""
    from MeshQuality.compat import extension

    core = extension()
    options = core.TriangulateOptions()
    options.min_angle = angle
    options.insertion = RULES[rule]
    options.sites_in_round = ORDERS[order]
    options.record_angles = True
    surface = core.triangulate(shape, options)
    return (*surface.angle_history, surface)


def row(triangles, angles):
    """What the curve shows, as a dict."""
    import numpy as np

    steps = np.diff(angles)
    above = np.flatnonzero(angles >= PAPER_ANGLE)
    return {"first": int(triangles[0]), "insertions": len(steps),
            "at_25": int(triangles[above[0]]) if len(above) else None, "last": int(triangles[-1]),
            "smallest_at_first": float(angles[0]), "smallest_at_last": float(angles[-1]),
            "highest": float(angles.max()), "falls": int((steps < -TINY).sum()),
            "rises": int((steps > TINY).sum()), "largest_fall": float(-steps.min())}


def draw(curves, angle, path):
    """A row of panels for each rule, in the paper's order."""
    import small_pictures

    figure, panels = small_pictures.mosaic([[f"{name}, {rule}" for name in PAPER] for rule in RULES], (12.0, 6.0))
    for title, axes in panels.items():
        name, _, rule = title.partition(", ")
        triangles, angles, found = curves[name, rule, "one by one"]
        axes.plot(triangles, angles, color=COLOURS[rule], linewidth=0.5)
        axes.axhline(PAPER_ANGLE, color="0.4", linewidth=0.8, linestyle="--")
        axes.set_ylim(0.0, angle + 1.0)
        axes.set_xlim(left=0.0)
        axes.set_title(f"{title}: 25 degrees first at {found['at_25']:,}", fontsize=9)
        axes.set_xlabel("triangles", fontsize=8)
        axes.set_ylabel("smallest angle, degrees", fontsize=8)
        axes.tick_params(labelsize=7)
    small_pictures.save(figure, path)


def work(arguments):
    import parts

    print(f"{'part':<10} {'rule':<13} {'order':<11} {'bound':>6} {'initial':>8} {'at 25':>8} {'at end':>8} {'smallest':>9} "
          f"{'insertions':>11} {'rises':>6} {'falls':>6} {'largest fall':>13}")
    curves, rows = {}, []
    for name in PAPER:
        shape = parts.ALL[name]()
        for rule in RULES:
            for order in ORDERS:
                for bound in (PAPER_ANGLE, arguments.angle):
                    triangles, angles, surface = history(shape, bound, rule, order)
                    found = {"part": name, "rule": rule, "order": order, "bound": bound,
                             "exempt": len(surface.report.exempt), **row(triangles, angles)}
                    curves[name, rule, order] = (triangles, angles, found)  # of the larger bound, at last
                    rows.append(found)
                    print(f"{name:<10} {rule:<13} {order:<11} {bound:6.0f} {found['first']:8,} {found['at_25'] or 0:8,} "
                          f"{found['last']:8,} {found['smallest_at_last']:9.3f} {found['insertions']:11,} "
                          f"{found['rises']:6,} {found['falls']:6,} {found['largest_fall']:13.2f}", flush=True)
    draw(curves, arguments.angle, Path(arguments.out_dir) / "aftosmis_evolution.png")
    return {"rows": rows}


inside_freecad.start(__file__, parser(), work)
