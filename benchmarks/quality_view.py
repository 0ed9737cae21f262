# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a frame of the quality view takes, against FreeCAD's own view of the same mesh.

    /usr/bin/python3 benchmarks/quality_view.py [triangles ...]
FreeCAD draws a torus of so many triangles on a virtual screen by the processor alone, turned a little from frame to
frame; printed are medians of 9 frames: FreeCAD's own view, the quality view with all triangles, as it stands still,
and as it moves, with the coarse triangles that stand for them where drawing takes long. Without numbers: 100000,
1000000 and 2000000.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.append(str(ROOT / "tests" / "gui"))

LIMIT = 600  # seconds


def main():
    import run

    with tempfile.TemporaryDirectory(prefix="meshquality-view-") as home:
        run.make_home(Path(home))
        result = Path(home, "result.txt")
        environment = {
            **os.environ, "FREECAD_USER_HOME": home, "LIBGL_ALWAYS_SOFTWARE": "1",
            "MESHQUALITY_VIEW_RESULT": str(result),
            "MESHQUALITY_VIEW_TRIANGLES": " ".join(sys.argv[1:] or ["100000", "1000000", "2000000"]),
        }
        subprocess.run(["xvfb-run", "-a", "-s", run.SCREEN, "freecad",
                        str(ROOT / "benchmarks" / "quality_view_gui.py")], env=environment,
                       stdin=subprocess.DEVNULL, timeout=LIMIT, check=False, capture_output=True)
        print(result.read_text(encoding="utf-8") if result.exists() else "FreeCAD ended early")


if __name__ == "__main__":
    main()
