# SPDX-License-Identifier: LGPL-2.1-or-later
"""Python or FreeCAD ends in the middle of a call: soon, with its status, and nothing stays."""

import os
import subprocess
import tempfile
import time
import unittest
import uuid

import FreeCAD
import helpers
from test_batch import processes_with, wait_until

GRACE = 5  # seconds that work gets to end in
# Seconds for which OpenCASCADE's check goes on at least when the script leaves, on a fast machine: it is not cut off.
GOES_ON = 1
STATUS = 3
MODULES = os.path.join(FreeCAD.getHomePath(), "lib")
# What a call works at: its code, and the stage in which the script leaves.
OWN = ("mq.triangulate(Part.makeSphere(10), chord_height=5e-6, max_triangles=2000000000, progress=tell)", "refining")
FOREIGN = ("mq.triangulate(helpers.zigzag_face(250), progress=tell)", "waits for OpenCASCADE: checking Face1")
FILLING = ("mq.curve(Part.makeSphere(10), order=1, volume=True, chord_height=0.0005, progress=tell)", "filling")
SCRIPT = """
import sys
sys.path[:0] = {paths!r}
import FreeCAD, Part
import os, threading, time
import helpers
import MeshQuality as mq

reached = threading.Event()

def tell(fraction, stage):
    if stage.startswith({stage!r}):
        reached.set()

threading.Thread(target=lambda: {call}, daemon={daemon}).start()
assert reached.wait(60)
time.sleep(0.2)
print("leaves at", time.time(), "after", time.process_time(), flush=True)
sys.exit({status})
"""


class Leaving(unittest.TestCase):
    def leave(self, program, work, daemon, longest, least=0.0):
        """Has a script leave while the work goes on; checks how it ended, and after how many seconds: `least` on the
        clock, and `longest` of CPU time, which other work of the machine does not make longer.
        """
        mark = uuid.uuid4().hex
        paths = [os.path.join(helpers.ROOT, "Mod"), os.path.dirname(os.path.abspath(__file__))]
        if program != "freecadcmd":
            paths.append(MODULES)
        with tempfile.TemporaryDirectory() as folder:
            script = os.path.join(folder, "leave.py")
            with open(script, "w", encoding="utf-8") as stream:
                stream.write(SCRIPT.format(paths=paths, stage=work[1], call=work[0], daemon=daemon, status=STATUS))
            before = helpers.cpu_seconds_of_children()
            done = subprocess.run([program, script], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                                  timeout=120, check=False, env={**os.environ, "MESHQUALITY_TEST": mark})
            end = time.time()
        self.assertEqual(done.returncode, STATUS, done.stdout + done.stderr)
        self.assertNotIn("terminate called", done.stderr)
        left_at, _, used = done.stdout.partition("leaves at ")[2].split()[:3]
        self.assertLess(helpers.cpu_seconds_of_children() - before - float(used), longest)
        self.assertGreater(end - float(left_at), least)
        self.assertTrue(wait_until(lambda: not processes_with(mark)))

    def test_freecad_gives_opencascade_some_seconds(self):
        for daemon in (True, False):
            with self.subTest(daemon=daemon):
                self.leave("freecadcmd", FOREIGN, daemon, 2 * GRACE, GOES_ON)

    def test_freecad_ends_at_once_where_the_work_does(self):
        for daemon in (True, False):
            with self.subTest(daemon=daemon):
                self.leave("freecadcmd", OWN, daemon, GRACE - 1)

    def test_the_program_that_fills_goes_too(self):
        self.leave("freecadcmd", FILLING, True, GRACE - 1)

    @unittest.skipUnless(os.path.exists(os.path.join(MODULES, "FreeCAD.so")), "FreeCAD as a module of Python")
    def test_python_with_a_daemon_thread(self):
        """Any other thread Python itself waits for."""
        self.leave("/usr/bin/python3", FOREIGN, True, 2 * GRACE, GOES_ON)
        self.leave("/usr/bin/python3", OWN, True, GRACE - 1)
