# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD is closed while work runs in the background: it ends soon and cleanly."""

import os
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import run

LIMIT = 60  # seconds
SCRIPT = """
import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

def discard():
    # What a user answers when the window asks whether to save.
    box = QtGui.QApplication.activeModalWidget()
    if box is None:
        QtCore.QTimer.singleShot(200, discard)
        return
    for button in box.findChildren(QtGui.QAbstractButton):
        if box.buttonRole(button) == QtGui.QMessageBox.DestructiveRole:
            button.click()

def start():
    FreeCADGui.activateWorkbench("MeshQualityWorkbench")
    from MeshQuality.gui import commands, jobs, mesh_panel
    document = FreeCAD.newDocument("Quit")
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    panel = mesh_panel.MeshPanel(commands.Triangulate().operations([box]))
    FreeCADGui.Control.showDialog(panel)
    panel.options.set_values({{"chord_height": "none", "max_edge": 0.004}})
    panel.accept()
    def close():
        with open({seen!r}, "w") as stream:
            stream.write(panel.jobs[0].state if panel.jobs else panel.said)
        {before_quitting}
        QtCore.QTimer.singleShot(500, discard)
        FreeCADGui.getMainWindow().close()
    QtCore.QTimer.singleShot(1500, close)

QtCore.QTimer.singleShot(500, start)
"""


class Quitting(unittest.TestCase):
    def quit_while_it_works(self, folder, before_quitting):
        """(exit status, seconds, state of the job before, output) of a FreeCAD of its own."""
        home, seen = Path(folder, "home"), str(Path(folder, "seen.txt"))
        home.mkdir()
        run.make_home(home)
        script = Path(folder, "quit.py")
        script.write_text(SCRIPT.format(seen=seen, before_quitting=before_quitting),
                          encoding="utf-8")
        start = time.monotonic()
        done = subprocess.run(["freecad", str(script)], timeout=LIMIT, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, check=False,
                              env={**os.environ, "FREECAD_USER_HOME": str(home)})
        return (done.returncode, time.monotonic() - start,
                Path(seen).read_text(encoding="utf-8"), done.stdout + done.stderr)

    def test_it_ends_while_a_job_runs(self):
        for before in ("FreeCAD.closeDocument('Quit')",
                       "box.Height = 20",
                       "panel.continue_in_background(); box.Height = 20",
                       "import threading, Part, MeshQuality as mq; threading.Thread(target=lambda: mq.triangulate("
                       "Part.makeSphere(10), chord_height=0.0005), daemon=True).start()"):
            with self.subTest(before), tempfile.TemporaryDirectory() as folder:
                status, seconds, state, output = self.quit_while_it_works(folder, before)
                self.assertEqual(state, "running")
                self.assertEqual(status, 0, output[-2000:])
                self.assertLess(seconds, LIMIT / 2)
