# SPDX-License-Identifier: LGPL-2.1-or-later
"""docs/debugging.md: the mesh after each stage (MESHQUALITY_STAGES, and tools/stages, which draws it), and what replays
a mesh of a document.
"""

import contextlib
import importlib.util
import io
import os
import subprocess
import tempfile
import unittest
from unittest import mock

import FreeCAD
import helpers
import Mesh
import Part
from test_recipes import recipes

import MeshQuality as mq


def pin():
    return Part.makeCylinder(5, 10).cut(Part.makeSphere(4))


class Stages(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = scratch.name

    def drawn(self, **values):
        with mock.patch.dict(os.environ, MESHQUALITY_STAGES=self.folder):
            return mq.triangulate(pin(), **values), sorted(os.listdir(self.folder))

    def test_the_mesh_after_each_stage_in_its_order(self):
        mesh, names = self.drawn(chord_height=0.05)
        self.assertEqual(names[:3], ["01-initial-triangulation.ply", "02-angles.ply", "03-chord-height.ply"])
        counts = [Mesh.Mesh(os.path.join(self.folder, name)).CountFacets for name in names]
        self.assertEqual(counts[-1], mesh.report.triangles)
        self.assertLess(counts[0], counts[1])
        self.assertLess(counts[1], counts[2])

    def test_the_result_is_the_same(self):
        self.assertEqual(self.drawn()[0].vertices.tobytes(), mq.triangulate(pin()).vertices.tobytes())

    def test_nothing_is_written_unless_asked_for(self):
        self.drawn()
        before = {name: os.stat(os.path.join(self.folder, name)).st_mtime_ns for name in os.listdir(self.folder)}
        mq.triangulate(pin())
        after = {name: os.stat(os.path.join(self.folder, name)).st_mtime_ns for name in os.listdir(self.folder)}
        self.assertEqual(after, before)

    def test_a_folder_that_is_not_there_is_named(self):
        self.folder = os.path.join(self.folder, "none")
        with mock.patch.dict(os.environ, MESHQUALITY_STAGES=self.folder), self.assertRaisesRegex(mq.IoError, "none"):
            mq.triangulate(pin())

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "matplotlib is not installed")
    def test_each_is_drawn(self):
        names = self.drawn()[1]
        picture = os.path.join(self.folder, names[-1].replace(".ply", ".png"))
        done = subprocess.run(["/usr/bin/python3", os.path.join(helpers.ROOT, "tools", "stage_pictures.py"), self.folder],
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=300, check=False)
        self.assertEqual((done.returncode, len(done.stdout.splitlines())), (0, len(names)), done.stderr)
        self.assertRegex(done.stdout, r"01-initial-triangulation.png: \d+ triangles, smallest angle [\d.]+ degrees")
        with open(picture, "rb") as stream:
            self.assertEqual(stream.read(4), b"\x89PNG")


class Replay(helpers.DocumentTest):
    def test_the_shape_and_the_options_of_an_object(self):
        source = self.document.addObject("Part::Feature", "Pin")
        source.Shape = pin()
        obj = mq.add_quality_mesh(source, min_angle=28.0)
        FreeCAD.setActiveDocument(self.document.Name)
        before, said = os.getcwd(), io.StringIO()
        self.addCleanup(os.chdir, before)
        os.chdir(self.folder)
        with contextlib.redirect_stdout(said):
            for text in recipes("docs/debugging.md"):
                exec(text, {"App": FreeCAD})  # noqa: S102 - what the page tells to do
        self.assertIn("'min_angle': 28.0", said.getvalue())
        shape = Part.Shape()
        shape.importBinary("part.bin")
        again = mq.triangulate(shape, min_angle=28.0)
        self.assertEqual(again.report.triangles, obj.Triangles)


if __name__ == "__main__":
    unittest.main()
