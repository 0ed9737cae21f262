#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cost of parts at which costs have fallen off: many solids through one axis, slivers, foils, bodies far apart.

    /usr/bin/python3 benchmarks/corpus_runs/time_cliffs.py [--only PATTERN]

Unions of bars through one axis; wraps of a box and of six plates; a strip between two fillets, by keep_edges "all" and
"feature"; the thickness of a foil and of a cut torus; triangulations of cylinders far apart, and of a frame of thin arms
with bores. Processor seconds of one call, of all threads, beside what is asked for, triangles, Euler number and notes.
"""

import fnmatch
import sys
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad

HEAD = f"{'case':<40} {'CPU s':>8} {'asked':>6} {'triangles':>10} {'Euler':>6}"


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--only", action="append", metavar="PATTERN", help="names of cases")
    return result


def plates():
    """The sides of a box of 60, each 2 thick; they overlap along its edges."""
    import Part
    from FreeCAD import Vector

    return [Part.makeBox(*(2 if k == axis else 60 for k in range(3)),
                         Vector(*(58 * side if k == axis else 0 for k in range(3))))
            for axis in range(3) for side in range(2)]


def frame():
    """A plate with four arms, slots and 36 bores, 3 thick."""
    import Part
    from FreeCAD import Vector

    def turned(shape, quarter):
        shape.rotate(Vector(0, 0, 0), Vector(0, 0, 1), 45 + 90 * quarter)
        return shape

    part = Part.makeBox(60, 60, 3, Vector(-30, -30, 0))
    for quarter in range(4):
        part = part.fuse(turned(Part.makeBox(120, 16, 3, Vector(20, -8, 0)), quarter))
        part = part.fuse(turned(Part.makeCylinder(16, 3, Vector(140, 0, 0)), quarter))
    bores = ((140, 0, 3.2), (132, 0, 1.6), (148, 0, 1.6), (140, 8, 1.6), (140, -8, 1.6), (60, 0, 5), (80, 0, 5),
             (100, 0, 5), (28, 0, 1.6))
    for quarter in range(4):
        for x, y, radius in bores:
            part = part.cut(turned(Part.makeCylinder(radius, 10, Vector(x, y, -3)), quarter))
    for x in range(-20, 21, 10):
        part = part.cut(Part.makeBox(4, 30, 10, Vector(x, -15, -2)))
    return part.removeSplitter()


def cases():
    """(name, CPU s asked for, call that returns a report)."""
    import Part
    from FreeCAD import Vector
    from parts.cliff_parts import bars, strip

    import MeshQuality as mq

    for n, asked in ((10, 0.3), (20, 0.8), (35, 2.0)):
        yield f"union of {2 * n} bars through one axis", asked, lambda n=n: mq.boolean(bars(2 * n), operation="union").report
    yield "wrap of a box of 60, gap 2", 2.0, lambda: mq.wrap(Part.makeBox(60, 60, 60), 2.0).report
    yield "wrap of six plates, gap 2", 4.0, lambda: mq.wrap(plates(), 2.0).report
    for width in (0.01, 0.002):
        for keep in ("all", "feature"):
            for chord in (None, 0.001):
                yield (f"strip {width} wide, {keep}, {chord or 'default'}", 1.0,
                       lambda width=width, keep=keep, chord=chord: mq.triangulate(
                           strip(width, 100), keep_edges=keep, chord_height=chord).report)
    yield "thickness of a foil 1000 x 1000 x 0.001", 5.0, lambda: mq.thickness(Part.makeBox(1000, 1000, 0.001)).mesh.report
    yield "thickness of a cut torus", 3.0, lambda: mq.thickness(Part.makeTorus(20, 5).cut(Part.makeBox(50, 50, 50))).mesh.report
    for far in (1e3, 1e5):
        yield f"cylinders of 10, {far:g} apart", 5.0, lambda far=far: mq.triangulate(Part.makeCompound(
            [Part.makeCylinder(5, 10), Part.makeCylinder(5, 10, Vector(far, 0, 0))])).report
    yield "frame of 74 faces", 5.0, lambda: mq.triangulate(frame()).report


def work(arguments):
    print(HEAD)
    rows = []
    for name, asked, call in cases():
        if arguments.only and not any(fnmatch.fnmatch(name, pattern) for pattern in arguments.only):
            continue
        start = time.process_time()
        report = call()
        rows.append({"case": name, "asked": asked, "seconds": time.process_time() - start, "triangles": report.triangles,
                     "euler": report.euler, "notes": [*report.notes]})
        print(f"{name:<40} {rows[-1]['seconds']:8.2f} {asked:6.1f} {report.triangles:10} {report.euler:6}", flush=True)
    return {"cases": rows}


inside_freecad.start(__file__, parser(), work)
