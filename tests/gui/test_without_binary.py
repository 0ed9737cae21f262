# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench of an addon without its extension module: all is shown, nothing can be used but the help."""

import json
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

import helpers
import run

LIMIT = 120  # seconds
SCRIPT = """
import json
import traceback
import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

def look():
    FreeCADGui.activateWorkbench("MeshQualityWorkbench")
    from MeshQuality.gui import commands
    document = FreeCAD.newDocument("Bare")
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    FreeCADGui.Selection.addSelection(box)
    workbench = FreeCADGui.activeWorkbench()
    toolbar = FreeCADGui.getMainWindow().findChild(QtGui.QToolBar, "Mesh Quality")
    buttons = [action for action in toolbar.actions() if not action.isSeparator()]
    # Buttons follow IsActive a moment later.
    for _ in range(40):
        QtGui.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 50)
        FreeCADGui.updateGui()
    shown = dict(registered=[name for name in FreeCADGui.listCommands() if name.startswith("MeshQuality_")],
                 names=[command.NAME for command in commands._COMMANDS],
                 in_toolbar=len(commands._TOOLBARS[0][1]),
                 enabled=[action.isEnabled() for action in buttons],
                 fitting=commands.fitting())
    FreeCADGui.runCommand("MeshQuality_GetBinary")
    panel = FreeCADGui.Control.activeDialog()
    labels = FreeCADGui.getMainWindow().findChildren(QtGui.QLabel)
    shown["told"] = [label.text() for label in labels if "tools/build" in label.text()]
    shown["dialog"] = bool(panel)
    FreeCADGui.Control.closeDialog()
    return shown

def main():
    try:
        shown = look()
    except Exception:
        shown = dict(fault=traceback.format_exc())
    with open({result!r}, "w") as stream:
        json.dump(shown, stream)
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)
    FreeCADGui.getMainWindow().close()

QtCore.QTimer.singleShot(500, main)
"""

HELP = ("MeshQuality_FirstSteps", "MeshQuality_Examples")


class WithoutBinary(unittest.TestCase):
    def shown(self):
        """What a FreeCAD with such an addon has shown."""
        with tempfile.TemporaryDirectory() as folder:
            addon, home, result = (os.path.join(folder, name) for name in ("addon", "home", "result"))
            helpers.copy_without_binary(addon)
            os.mkdir(home)
            run.make_home(Path(home), addon)
            script = Path(folder, "bare.py")
            script.write_text(SCRIPT.format(result=result), encoding="utf-8")
            subprocess.run(["freecad", str(script)], timeout=LIMIT, stdin=subprocess.DEVNULL,
                           capture_output=True, check=True, env={**os.environ, "FREECAD_USER_HOME": home})
            with open(result, encoding="utf-8") as stream:
                return json.load(stream)

    def test_commands_are_shown_disabled_and_one_tells_why(self):
        shown = self.shown()
        self.assertNotIn("fault", shown, shown.get("fault"))
        self.assertEqual(sorted(shown["registered"]),
                         sorted([*shown["names"], "MeshQuality_GetBinary", *HELP]))
        self.assertGreater(len(shown["names"]), 5)
        self.assertEqual(shown["enabled"], [True] + [False] * shown["in_toolbar"])
        self.assertEqual(shown["fitting"], [])
        self.assertTrue(shown["dialog"])
        self.assertEqual(len(shown["told"]), 1)
        self.assertIn("OpenCASCADE", shown["told"][0])
