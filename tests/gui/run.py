# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the tests of this folder in a real FreeCAD on a virtual screen; ends with 'N passed, N failed'.

    python3 tests/gui/run.py [test_module[.Class[.method]] ...]
FreeCAD gets a home of its own, in which the repository is an installed addon. Pictures that tests
take are kept in build/test-logs/gui.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
PICTURES = ROOT / "build" / "test-logs" / "gui"
SCREEN = "-screen 0 1400x900x24"
LIMIT = 3600  # seconds for all tests, on a machine that does much else

# No start page, which needs a browser; the workbench under test first; cameras that do not turn slowly (FreeCAD 1.0), or
# a picture shows some place on the way.
SETTINGS = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FCParameters>
  <FCParamGroup Name="Root">
    <FCParamGroup Name="BaseApp">
      <FCParamGroup Name="Preferences">
        <FCParamGroup Name="General">
          <FCText Name="AutoloadModule">MeshQualityWorkbench</FCText>
          <FCBool Name="ShowSplasher" Value="0"/>
        </FCParamGroup>
        <FCParamGroup Name="View"><FCBool Name="UseNavigationAnimations" Value="0"/></FCParamGroup>
        <FCParamGroup Name="Mod">
          <FCParamGroup Name="Start"><FCBool Name="ShowOnStartup" Value="0"/></FCParamGroup>
        </FCParamGroup>
      </FCParamGroup>
    </FCParamGroup>
  </FCParamGroup>
</FCParameters>
"""


def make_home(folder, addon=ROOT):
    """A user's folder of FreeCAD with the addon and the settings."""
    (folder / "Mod").mkdir()
    (folder / "Mod" / "MeshQuality").symlink_to(addon)
    (folder / "user.cfg").write_text(SETTINGS, encoding="utf-8")


def run(names):
    """The text that the tests printed, and FreeCAD's exit status."""
    PICTURES.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="meshquality-gui-") as home:
        make_home(Path(home))
        result = Path(home, "result.txt")
        environment = {
            **os.environ, "FREECAD_USER_HOME": home, "LIBGL_ALWAYS_SOFTWARE": "1",
            "MESHQUALITY_GUI_RESULT": str(result), "MESHQUALITY_GUI_TESTS": " ".join(names),
            "MESHQUALITY_GUI_PICTURES": str(PICTURES),
        }
        command = ["xvfb-run", "-a", "-s", SCREEN, "freecad", str(HERE / "inside.py")]
        try:
            done = subprocess.run(command, env=environment, stdin=subprocess.DEVNULL, timeout=LIMIT,
                                  capture_output=True, text=True, check=False)
            status, output = done.returncode, done.stdout + done.stderr
        except subprocess.TimeoutExpired:
            status, output = 124, f"FreeCAD did not end within {LIMIT} s\n"
        text = result.read_text(encoding="utf-8") if result.exists() else ""
    return text + (output if status or not text else ""), status


def main():
    missing = [name for name in ("freecad", "xvfb-run") if not shutil.which(name)]
    if missing:
        print(f"not installed: {', '.join(missing)}\n0 passed, 1 failed")
        return 1
    text, status = run(sys.argv[1:])
    print(text)
    counts = re.findall(r"^(\d+) passed, (\d+) failed$", text, re.MULTILINE)
    passed, failed = map(int, counts[-1]) if counts else (0, 1)
    if status and not failed:
        print(f"FreeCAD ended with status {status}")
        failed = 1
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
