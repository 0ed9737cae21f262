# SPDX-License-Identifier: LGPL-2.1-or-later
"""A flow mesh of many cells: time, memory, and how soon a cancel would be answered.

    EDGE=0.38 freecadcmd -P <root>/Mod benchmarks/solvers/flow_cells.py </dev/null
A cylinder of radius 5 mm and length 40 mm, four layers of 0.02 mm and on its side, edges up to EDGE mm on it. The longest times between two calls of
progress, which a cancel waits for, are of the processor, with their stages. Those of the first call in a FreeCAD, which loads modules, are left out.
"""

import os
import resource
import time

import Part

import MeshQuality as mq

GIVEN = {"layers": 4, "first_height": 0.02, "growth_rate": 1.2, "walls": ["Face1"], "growth_inside": 0.1}


def main():
    edge, gaps = float(os.environ.get("EDGE", 0.38)), []
    mq.volume_mesh(Part.makeCylinder(5, 40), **GIVEN, max_edge=5.0)
    wall, start = time.time(), time.process_time()
    last = [start, "begin"]

    def progress(_, stage):
        now = time.process_time()
        gaps.append((now - last[0], last[1], stage))
        last[:] = now, stage
        return True

    mesh = mq.volume_mesh(Part.makeCylinder(5, 40), **GIVEN, max_edge=edge, progress=progress)
    end = time.process_time()
    cells = sum(mesh.report.elements.values())
    print(f"{edge:g} mm: {cells:,} cells, {time.time() - wall:.1f} s of the clock, {end - start:.1f} s of the processor, "
          f"{1e6 * (end - start) / cells:.0f} us a cell, {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024:.0f} MB")
    for seconds, before, after in sorted([*gaps, (end - last[0], last[1], "end")], reverse=True)[:5]:
        print(f"  {seconds:.3f} s from {before!r} to {after!r}")


main()
