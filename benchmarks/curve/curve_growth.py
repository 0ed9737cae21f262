#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What curving costs an element as meshes grow, and what it costs where elements are invalid; prints a table in Markdown.

    /usr/bin/python3 benchmarks/curve/curve_growth.py [--orders 2,3,4] [--copies 4,16,48] [--only TEXT]

Each row is a number of copies of one solid in one shape, at one order, filled: elements and invalid elements both grow with
the copies. Seconds are the processor's of this process, user and system; the tetrahedral mesher, which runs in a process
of its own, does not count. Stages are seconds on the clock.
"""

import math
import sys
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--orders", default="2,3,4")
    result.add_argument("--copies", default="4,16,48")
    result.add_argument("--only", default="", help="solids with this text in their names")
    return result


def solids():
    """{name: (shape, chord height in mm)}."""
    import Part
    from FreeCAD import Vector

    def wheel(spokes=5):
        rim = Part.makeCylinder(50, 12).cut(Part.makeCylinder(44, 12))
        parts = [Part.makeCylinder(12, 12)]
        for i in range(spokes):
            spoke = Part.makeBox(40, 6, 6, Vector(8, -3, 3))
            spoke.rotate(Vector(), Vector(0, 0, 1), 360.0 * i / spokes)
            parts.append(spoke)
        solid = rim.fuse(parts).removeSplitter().cut(Part.makeCylinder(6, 12)).Solids[0]
        upright = [edge for edge in solid.Edges if edge.Curve.TypeId == "Part::GeomLine"
                   and abs(edge.Vertexes[0].Z - edge.Vertexes[1].Z) > 5.9
                   and math.hypot(edge.Vertexes[0].X, edge.Vertexes[0].Y) < 48]
        return solid.makeFillet(2, upright)

    shell = Part.makeSphere(20).cut(Part.makeSphere(19))
    return {"shell of 1 mm": (shell, 0.4), "spoked wheel": (wheel(), 1.0)}


def row(name, shape, chord_height, order, copies):
    import Part
    from FreeCAD import Vector

    import MeshQuality as mq

    size = shape.BoundBox.XLength * 1.2
    many = []
    for i in range(copies):
        copy = shape.copy()
        copy.translate(Vector(size * i, 0, 0))
        many.append(copy)
    start = time.process_time()
    report = mq.curve(Part.makeCompound(many), order=order, volume=True, chord_height=chord_height).report
    used = time.process_time() - start
    print(f"| {name} | {order} | {report.elements} | {report.invalid_before} | {report.invalid} | {used:.1f} "
          f"| {1e6 * used / report.elements:.0f} | {1e3 * used / max(report.invalid_before, 1):.1f} |", flush=True)
    return {"solid": name, "order": order, "copies": copies, "elements": report.elements,
            "invalid_before": report.invalid_before, "invalid": report.invalid, "cpu": used,
            "stages": dict(report.seconds)}


def work(arguments):
    print("| solid | order | elements | invalid before | left | s | us an element | ms an invalid one |\n"
          "|---|---|---|---|---|---|---|---|")
    return {"rows": [row(name, shape, chord_height, int(order), int(copies))
                     for name, (shape, chord_height) in solids().items() if arguments.only in name
                     for order in arguments.orders.split(",") for copies in arguments.copies.split(",")]}


inside_freecad.start(__file__, parser(), work)
