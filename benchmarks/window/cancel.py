#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How soon a triangulation ends once its progress callback has returned False.

    /usr/bin/python3 benchmarks/window/cancel.py

Cancels at random moments, evenly spread over the time that the whole work takes, and measures from
the callback's answer until MeshQuality.Cancelled is raised. The part gets as many triangles as it
takes for the work to last.
"""

import random
import sys
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad

BOUND = 0.2  # seconds: what the callers were promised


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--part", default="wing_main", help="one of tests/parts")
    result.add_argument("--triangles", type=int, default=300_000, help="at least so many")
    result.add_argument("--cancels", type=int, default=50)
    result.add_argument("--seed", type=int, default=1)
    return result


class At:
    """A progress callback that cancels at a moment and remembers what was going on."""

    def __init__(self, delay=None):
        self.moment = None if delay is None else time.perf_counter() + delay
        self.answered = self.stage = None
        self.last, self.silence = time.perf_counter(), 0.0

    def __call__(self, fraction, stage):
        now = time.perf_counter()
        self.silence, self.last = max(self.silence, now - self.last), now
        if self.moment is None or now < self.moment:
            return True
        self.stage = stage
        self.answered = time.perf_counter()
        return False


def options_for(shape, wanted):
    """A chord height that gives at least `wanted` triangles, and how long that takes."""
    import MeshQuality as mq

    relative = 1e-3
    while True:
        start, watcher = time.perf_counter(), At()
        mesh = mq.triangulate(shape, chord_height_relative=relative, progress=watcher)
        seconds = time.perf_counter() - start
        if len(mesh.triangles) >= wanted:
            stages = ", ".join(f"{name} {s:.2f}" for name, s in mesh.report.seconds.items())
            print(f"\n{len(mesh.triangles):,} triangles in {seconds:.2f} s ({stages}); "
                  f"longest silence between two callbacks {watcher.silence:.3f} s")
            return {"chord_height_relative": relative}, len(mesh.triangles), seconds
        relative /= 2.0


def cancel_after(shape, options, delay):
    """Seconds from the answer False to the end, and the stage; None when the work was faster."""
    import MeshQuality as mq

    watcher = At(delay)
    try:
        mq.triangulate(shape, progress=watcher, **options)
    except mq.Cancelled:
        return {"at": delay, "stage": watcher.stage,
                "seconds": time.perf_counter() - watcher.answered}
    return None


def work(arguments):
    """Cancels, and prints the worst of each stage."""
    import parts

    shape = parts.ALL[arguments.part]()
    options, triangles, whole = options_for(shape, arguments.triangles)
    moments = random.Random(arguments.seed)
    found = []
    while len(found) < arguments.cancels:
        result = cancel_after(shape, options, moments.uniform(0.0, whole))
        if result:
            found.append(result)
    for stage in sorted({f["stage"] for f in found}):
        seconds = [f["seconds"] for f in found if f["stage"] == stage]
        print(f"{stage:<30} {len(seconds):3} cancels, {max(seconds):.3f} s at worst")
    worst = max(f["seconds"] for f in found)
    print(f"worst of {len(found)}: {worst:.3f} s, "
          f"{'within' if worst <= BOUND else 'MORE THAN'} {BOUND} s")
    return {"part": arguments.part, "options": options, "triangles": triangles,
            "whole_seconds": whole, "worst_seconds": worst, "bound": BOUND, "cancels": found}


inside_freecad.start(__file__, parser(), work)
