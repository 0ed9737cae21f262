# SPDX-License-Identifier: LGPL-2.1-or-later
"""Times how long a mesh of about a million triangles takes to be made and to be written in each format, with two patches.

    freecadcmd -P Mod benchmarks/solvers/write_formats.py </dev/null

MESHQUALITY_EDGE is the longest edge in mm of the ball with a diameter of 100 mm. Prints a table: median of three runs,
seconds of the processor, and the size of the file.
"""

import os
import statistics
import tempfile
import time

import Part

import MeshQuality as mq
from MeshQuality import formats

RUNS = 3


def seconds(call):
    start = time.process_time()
    result = call()
    return time.process_time() - start, result


def main():
    ball = Part.makeSphere(50)
    ball = ball.cut(Part.makeBox(100, 100, 100))
    edge = float(os.environ.get("MESHQUALITY_EDGE", "0.4"))
    meshing, mesh = seconds(lambda: mq.triangulate(ball, max_edge=edge, patches={"inlet": ["Face1"]}, patch_rest="walls"))
    print(f"{len(mesh.triangles)} triangles, made in {meshing:.1f} CPU s")
    print("\n| format | CPU s | MB |\n|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for suffix, ascii_form in [*((suffix, False) for suffix in formats.SUFFIXES), (".stl", True)]:
            path = os.path.join(folder, "mesh" + suffix)
            try:
                taken = statistics.median(seconds(lambda: mesh.write(path, ascii=ascii_form))[0] for _ in range(RUNS))
            except mq.IoError as error:
                print(f"| `{suffix}` | {error} | |")
                continue
            print(f"| `{suffix}`{' as text' if ascii_form else ''} | {taken:.2f} | {os.path.getsize(path) / 1e6:.0f} |",
                  flush=True)
            os.remove(path)


main()
