# SPDX-License-Identifier: LGPL-2.1-or-later
"""What bin/meshquality leaves behind when it, or its FreeCAD, is killed: nothing after the next command."""

import errno
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from unittest import mock

import FreeCAD
import helpers
import Part
from test_attacks_batch import ENDLESS, Started
from test_batch import processes_with, wait_until

from MeshQuality import scratch

TRIALS = 8
LONGEST = 2.5  # s: FreeCAD has started, read the part and works by then
FOREIGN = ("meshquality-notes", "meshquality-0123456789abcdef", "FreeCAD_Doc_mine")


@unittest.skipUnless(sys.platform.startswith("linux"), "files are locked, and processes found, as on Linux")
class Left(Started):
    def setUp(self):
        super().setUp()
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.temporary, self.results = os.path.join(holder.name, "tmp"), os.path.join(holder.name, "results")
        os.makedirs(self.results)
        for name in FOREIGN:
            os.makedirs(os.path.join(self.temporary, name))
            with open(os.path.join(self.temporary, name, "text"), "w", encoding="ascii") as stream:
                stream.write("mine")
        # Named as a record, but it is none of ours: a link to what must stay.
        os.symlink(os.path.join(self.temporary, FOREIGN[0], "text"),
                   os.path.join(self.temporary, FOREIGN[1] + ".owner"))
        before = os.environ.get("TMPDIR")
        os.environ["TMPDIR"] = self.temporary
        self.addCleanup(lambda: os.environ.pop("TMPDIR") if before is None else os.environ.update(TMPDIR=before))
        self.output = os.path.join(self.results, "mesh.stl")
        document = FreeCAD.newDocument("Ball")
        document.addObject("Part::Feature", "Ball").Shape = Part.makeSphere(5)
        self.part = os.path.join(self.parts, "ball.FCStd")
        document.saveAs(self.part)
        FreeCAD.closeDocument(document.Name)

    def left(self):
        """What is there beyond what others own."""
        others = {*FOREIGN, FOREIGN[1] + ".owner"}
        return sorted(set(os.listdir(self.temporary)) - others) + sorted(set(os.listdir(self.results)) - {"mesh.stl"})

    def assert_foreign_stays(self):
        for name in FOREIGN:
            with open(os.path.join(self.temporary, name, "text"), encoding="ascii") as stream:
                self.assertEqual(stream.read(), "mine")
        self.assertTrue(os.path.islink(os.path.join(self.temporary, FOREIGN[1] + ".owner")))

    def working(self):
        return self.start("triangulate", self.part, "-o", self.output, *ENDLESS)

    def next_command(self):
        process = self.start("triangulate", self.part, "-o", self.output, "--chord-height", "0.1")
        self.assertEqual(process.wait(60), 0)

    def test_killed_at_any_time_nothing_is_left_after_the_next_command(self):
        chance, were_left = random.Random(7), 0
        for _ in range(TRIALS):
            process = self.working()
            time.sleep(chance.uniform(0.05, LONGEST))
            process.kill()
            process.wait()
            self.assertTrue(wait_until(lambda: not processes_with(self.mark), 5))
            were_left += bool(self.left())
        self.assertGreater(were_left, 0)  # there is no process that could have removed it
        self.next_command()
        self.assertEqual(self.left(), [])
        self.assert_foreign_stays()

    def test_what_was_not_finished_beside_the_output_goes_too(self):
        code = ("import os, sys, time; from MeshQuality import files, scratch\n"
                "made = scratch.Folder(); path = files.unfinished(sys.argv[1], '.stl'); made.note_unfinished(path)\n"
                "open(path, 'w').close(); print(path, flush=True); time.sleep(60)")
        owner = subprocess.Popen(["/usr/bin/python3", "-c", code, self.output], stdout=subprocess.PIPE, text=True,
                                 env={**os.environ, "PYTHONPATH": os.path.join(helpers.ROOT, "Mod")})
        self.addCleanup(owner.stdout.close)
        path = owner.stdout.readline().strip()
        self.next_command()  # nothing of one that lives is taken away
        self.assertEqual(len(self.left()), 3)
        owner.kill()
        owner.wait()
        self.assertTrue(os.path.exists(path))
        self.next_command()
        self.assertEqual(self.left(), [])
        self.assert_foreign_stays()

    def test_a_command_at_work_keeps_its_folder(self):
        process = self.working()
        self.assertTrue(wait_until(lambda: self.freecads("cli/job.py")))
        self.next_command()
        self.assertIsNone(process.poll())
        self.assertGreater(len(self.left()), 1)
        os.kill(process.pid, signal.SIGTERM)
        self.assertEqual(process.wait(20), 1)
        self.assertEqual(self.left(), [])

    def test_freecad_killed_leaves_nothing(self):
        process = self.working()
        self.assertTrue(wait_until(lambda: self.freecads("cli/job.py")))
        for pid in self.freecads("cli/job.py"):
            os.kill(pid, signal.SIGKILL)
        self.assertEqual(process.wait(20), 1)
        self.assertEqual(self.left(), [])
        self.assert_foreign_stays()

    def test_where_files_cannot_be_locked_folders_are_left_alone(self):
        with mock.patch.object(scratch.fcntl, "flock", side_effect=OSError(errno.ENOLCK, "no locks")), \
                mock.patch.object(scratch.tempfile, "gettempdir", return_value=self.temporary):
            with scratch.Folder() as made:
                scratch.remove_left()
                self.assertTrue(os.path.isdir(made.path))
            self.assertEqual(self.left(), [])

    def test_without_a_place_for_temporary_files_it_says_so(self):
        with mock.patch.object(scratch.tempfile, "gettempdir", return_value=os.path.join(self.temporary, "nowhere")), \
                self.assertRaises(FileNotFoundError):
            scratch.Folder()
