# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a script in FreeCAD's window on a virtual screen, drawn by the processor alone."""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tests" / "gui"))

LIMIT = 600  # seconds


def text_of(script, **variables):
    """What a script of this folder writes into the file MESHQUALITY_RESULT; variables are of its
    environment.
    """
    import run

    with tempfile.TemporaryDirectory(prefix="meshquality-window-") as home:
        run.make_home(Path(home))
        result = Path(home, "result.txt")
        environment = {**os.environ, "FREECAD_USER_HOME": home, "LIBGL_ALWAYS_SOFTWARE": "1",
                       "MESHQUALITY_RESULT": str(result), **variables}
        subprocess.run(["xvfb-run", "-a", "-s", run.SCREEN, "freecad",
                        str(ROOT / "benchmarks" / "window" / script)], env=environment,
                       stdin=subprocess.DEVNULL, timeout=LIMIT, check=False, capture_output=True)
        return result.read_text(encoding="utf-8") if result.exists() else "FreeCAD ended early"
