# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long FreeCAD's window is blocked while a mesh of half a million triangles is made and shown.

    /usr/bin/python3 benchmarks/window/event_loop.py [triangles [rounds]]
A timer of 5 ms runs in the window's event loop, on a virtual screen; printed are the longest gaps in ms
between two of its ticks while the work runs and when its result comes into the document, for a quality
mesh, a curved mesh and a Boolean, then for the same mesh given to a plain Mesh::Feature of FreeCAD. Of
several rounds, each in a FreeCAD of its own, the least is printed and the largest in brackets: other
programs can only make gaps longer. Asked are 50 ms.
"""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tests" / "gui"))

LIMIT = 900  # seconds


def main():
    triangles, rounds = (sys.argv[1:] + ["500000", "3"][len(sys.argv) - 1:])[:2]
    found = {}
    for _ in range(int(rounds)):
        for case in one_round(triangles):
            found.setdefault(case["title"], {})
            for phase, gap in case["gaps"].items():
                found[case["title"]].setdefault(phase, []).append(gap)
    for title, phases in found.items():
        print(title)
        for phase, gaps in phases.items():
            print(f"    {phase:<32} {min(gaps):5.0f} ({max(gaps):.0f})")


def one_round(triangles):
    """What event_loop_gui.py has measured in a FreeCAD of its own."""
    import run

    with tempfile.TemporaryDirectory(prefix="meshquality-loop-") as home:
        run.make_home(Path(home))
        result = Path(home, "result.txt")
        environment = {
            **os.environ, "FREECAD_USER_HOME": home, "LIBGL_ALWAYS_SOFTWARE": "1",
            "MESHQUALITY_LOOP_RESULT": str(result), "MESHQUALITY_LOOP_TRIANGLES": triangles,
        }
        done = subprocess.run(["xvfb-run", "-a", "-s", run.SCREEN, "freecad",
                               str(Path(__file__).with_name("event_loop_gui.py"))], env=environment,
                              stdin=subprocess.DEVNULL, timeout=LIMIT, check=False,
                              capture_output=True, text=True)
        if not result.exists():
            sys.exit(f"FreeCAD ended early: {done.stdout}{done.stderr}")
        return [json.loads(line) for line in result.read_text(encoding="utf-8").splitlines()]


if __name__ == "__main__":
    main()
