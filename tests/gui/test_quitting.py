# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD is closed while work runs in the background: it ends soon and cleanly."""

import os
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import run

HELPERS = str(Path(__file__).resolve().parent.parent / "freecad")

LIMIT = 60  # seconds
GRACE = 5  # seconds that work gets to end in
SCRIPT = """
import sys
import FreeCAD
import FreeCADGui
sys.path.append({helpers!r})
import helpers
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
    from MeshQuality.gui import commands, jobs
    from MeshQuality.gui.panels import mesh_panel
    document = FreeCAD.newDocument("Quit")
    box = document.addObject("Part::Box", "Box")
    {before_starting}
    document.recompute()
    panel = mesh_panel.MeshPanel(commands.Triangulate().operations([source]))
    FreeCADGui.Control.showDialog(panel)
    panel.options.set_values({{"chord_height": "none", "max_edge": 0.004}})
    panel.accept()
    def close():
        with open({seen!r}, "w") as stream:
            stream.write(panel.jobs[0].doing if panel.jobs else panel.said)
        {before_quitting}
        QtCore.QTimer.singleShot(500, discard)
        FreeCADGui.getMainWindow().close()
    def close_once_it_works():
        if any(word in panel.doing.text() for word in {words!r}):
            close()
        else:
            QtCore.QTimer.singleShot(100, close_once_it_works)
    close_once_it_works()

QtCore.QTimer.singleShot(500, start)
"""


class Quitting(unittest.TestCase):
    def quit_while_it_works(self, folder, before_quitting, words, before_starting):
        """(exit status, seconds since it was told to quit, what the job did then, output) of a FreeCAD of its own."""
        home, seen = Path(folder, "home"), str(Path(folder, "seen.txt"))
        home.mkdir()
        run.make_home(home)
        script = Path(folder, "quit.py")
        script.write_text(SCRIPT.format(seen=seen, before_quitting=before_quitting, words=words,
                                        before_starting=before_starting, helpers=HELPERS),
                          encoding="utf-8")
        done = subprocess.run(["freecad", str(script)], timeout=LIMIT, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, check=False,
                              env={**os.environ, "FREECAD_USER_HOME": str(home)})
        return (done.returncode, time.time() - os.stat(seen).st_mtime,
                Path(seen).read_text(encoding="utf-8"), done.stdout + done.stderr)

    def assert_ends(self, before_quitting, words, seconds, before_starting="source = box"):
        with tempfile.TemporaryDirectory() as folder:
            status, taken, doing, output = self.quit_while_it_works(folder, before_quitting, words, before_starting)
        self.assertTrue(any(word in doing for word in words), doing)
        self.assertEqual(status, 0, output[-2000:])
        self.assertLess(taken, seconds)
        return taken

    def test_it_ends_while_a_job_runs(self):
        for before in ("FreeCAD.closeDocument('Quit')",
                       "box.Height = 20",
                       "panel.continue_in_background(); box.Height = 20",
                       "import threading, Part, MeshQuality as mq; threading.Thread(target=lambda: mq.triangulate("
                       "Part.makeSphere(10), chord_height=0.0005), daemon=True).start()"):
            with self.subTest(before):
                self.assert_ends(before, ("triangulation", "refining", "running"), GRACE)

    def test_it_ends_soon_though_opencascade_works_on(self):
        """The check of the face takes longer than the test may take."""
        teeth = "source = document.addObject('Part::Feature', 'Teeth'); source.Shape = helpers.zigzag_face(250)"
        for before in ("pass", "panel.reject()", "panel.continue_in_background()"):
            with self.subTest(before):
                taken = self.assert_ends(before, ("OpenCASCADE: checking Face1",), 2 * GRACE, teeth)
                self.assertGreater(taken, GRACE - 1)  # it waited for the work
