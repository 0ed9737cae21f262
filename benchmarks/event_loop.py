# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long FreeCAD's window is blocked while a mesh of half a million triangles is made and shown.

    /usr/bin/python3 benchmarks/event_loop.py [triangles]
A timer of 5 ms runs in the window's event loop, on a virtual screen; printed are the longest gaps
between two of its ticks while the work runs and when its result comes into the document, for a quality mesh, a
curved mesh and a Boolean. Asked are 50 ms.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.append(str(ROOT / "tests" / "gui"))

LIMIT = 900  # seconds


def main():
    import run

    with tempfile.TemporaryDirectory(prefix="meshquality-loop-") as home:
        run.make_home(Path(home))
        result = Path(home, "result.txt")
        environment = {
            **os.environ, "FREECAD_USER_HOME": home, "LIBGL_ALWAYS_SOFTWARE": "1",
            "MESHQUALITY_LOOP_RESULT": str(result),
            "MESHQUALITY_LOOP_TRIANGLES": sys.argv[1] if len(sys.argv) > 1 else "500000",
        }
        subprocess.run(["xvfb-run", "-a", "-s", run.SCREEN, "freecad",
                        str(ROOT / "benchmarks" / "event_loop_gui.py")], env=environment,
                       stdin=subprocess.DEVNULL, timeout=LIMIT, check=False, capture_output=True)
        print(result.read_text(encoding="utf-8") if result.exists() else "FreeCAD ended early")


if __name__ == "__main__":
    main()
