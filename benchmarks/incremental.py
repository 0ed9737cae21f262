# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshing a part of 156 faces again after an edit of one hole: CPU seconds from nothing and with what
was remembered.

    freecadcmd -P <root>/Mod benchmarks/incremental.py </dev/null
"""

import sys
from pathlib import Path

sys.path[:0] = [str(Path(__file__).resolve().parent.parent / "tests" / "freecad")]


def measure(chord):
    """One line of figures for a chord height in mm."""
    from test_recall import plate  # noqa: PLC0415  on the path only now

    import MeshQuality as mq  # noqa: PLC0415

    memory = mq.Memory()
    mq.triangulate(plate(2.0), chord_height=chord, memory=memory)
    edited = plate(2.5)
    nothing = mq.triangulate(edited, chord_height=chord).report
    again = mq.triangulate(edited, chord_height=chord, memory=memory).report
    print(f"{chord:8g} {nothing.triangles:10d} {again.triangles:10d} {nothing.cpu_seconds:10.2f} "
          f"{again.cpu_seconds:10.2f} {again.reused_faces:6d} of {len(edited.Faces)}", flush=True)
    return nothing, again


def main():
    print("chord mm  triangles      again      CPU s      again  faces kept")
    for chord in (0.1, 0.05, 0.02):
        nothing, again = measure(chord)
    for name, report in (("from nothing", nothing), ("again", again)):
        stages = ", ".join(f"{stage} {seconds:.2f}" for stage, seconds in report.seconds.items())
        print(f"{name}: {report.queries} queries; {stages}")


main()
