#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seconds that reading and checking the corpus' shapes takes, before any triangle is made.

    /usr/bin/python3 benchmarks/reading.py [--only PATTERN] [--rounds 3]
Each part of $MESHQUALITY_DATA/cad is meshed as coarsely as it can be, and the least time of its
stage "read the shape" in all rounds is taken: on the clock, so the machine should have nothing else
to do. Parts that cannot be meshed are left out. Reading their files is FreeCAD's work, and not in it.
"""

import fnmatch

import inside_freecad

SUFFIXES = {".step", ".stp", ".iges", ".igs", ".brep", ".brp"}


def work(arguments):
    import Part

    import MeshQuality as mq

    seconds = {}
    for path in sorted((inside_freecad.data_folder() / "cad").iterdir()):
        if path.suffix.lower() not in SUFFIXES or not fnmatch.fnmatch(path.name, arguments.only):
            continue
        shape = Part.Shape()
        shape.read(str(path))
        try:
            rounds = [mq.triangulate(shape, min_angle=1).report.seconds["read the shape"] for _ in range(arguments.rounds)]
        except mq.Error as error:
            print(f"| {path.name} | {error.__class__.__name__} |")
            continue
        seconds[path.name] = min(rounds)
        print(f"| {path.name} | {seconds[path.name]:.4f} |", flush=True)
    print(f"{len(seconds)} parts: {sum(seconds.values()):.2f} s")
    return {"seconds": seconds}


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--only", default="*", metavar="PATTERN", help="names of parts")
    result.add_argument("--rounds", type=int, default=3, help="least time of this many")
    return result


inside_freecad.start(__file__, parser(), work)
