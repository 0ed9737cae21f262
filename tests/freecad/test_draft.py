# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draft and undercuts: known angles and areas, the command line."""

import json
import os
import subprocess
import tempfile
import unittest

import FreeCAD
import helpers
import numpy as np
import Part

import MeshQuality as mq

COMMAND = os.path.join(helpers.ROOT, "bin", "meshquality")
V = FreeCAD.Vector


def by_face(found):
    return {face.face: face for face in found.faces}


class Draft(unittest.TestCase):
    def test_a_cone_has_the_angle_of_its_side_everywhere(self):
        shape = Part.makeCone(10, 8, 20)
        slope = np.degrees(np.arctan(2 / 20))
        found = mq.draft(shape, (0, 0, 5), min_draft=6)
        side = next(i for i, face in enumerate(shape.Faces) if "Cone" in str(face.Surface))
        there = found.mesh.triangle_face == side
        np.testing.assert_allclose(found.angles[there], slope, rtol=1e-5)
        self.assertEqual(found.exact_normals, 1.0)
        self.assertEqual(found.undercut_area, 0.0)
        self.assertAlmostEqual(found.low_area, shape.Faces[side].Area, delta=0.01 * shape.Faces[side].Area)
        self.assertTrue((found.release[there] == 1).all())
        self.assertEqual(mq.draft(shape, min_draft=5).low_area, 0.0)

    def test_walls_along_the_pull_have_none_and_are_no_undercuts(self):
        block = Part.makeBox(30, 20, 10).cut(Part.makeCylinder(4, 10, V(10, 10, 0)))
        found = mq.draft(block, "z")
        walls = np.abs(found.angles) < 1e-4
        self.assertTrue((found.release[walls] == 3).all())
        self.assertEqual(found.undercut_area, 0.0)
        self.assertAlmostEqual(found.low_area, 2 * (30 + 20) * 10 + 2 * np.pi * 4 * 10, delta=3)

    def test_a_cross_hole_is_an_undercut(self):
        block = Part.makeBox(30, 20, 10)
        bored = block.cut(Part.makeCylinder(2, 20, V(15, 0, 5), V(0, 1, 0)))
        hole = next(f"Face{i + 1}" for i, face in enumerate(bored.Faces) if "Cylinder" in str(face.Surface))
        found = mq.draft(bored, "z")
        faces = by_face(found)
        self.assertAlmostEqual(faces[hole].undercut_area, faces[hole].area, delta=0.01 * faces[hole].area)
        self.assertAlmostEqual(found.undercut_area, 2 * np.pi * 2 * 20, delta=3)
        # Along the hole there is none; its ends are in nobody's way.
        self.assertEqual(mq.draft(bored, (0, 1, 0)).undercut_area, 0.0)
        self.assertIn(hole, str(found))

    def test_a_groove_around_is_an_undercut(self):
        shaft = Part.makeCylinder(10, 40)
        ring = Part.makeCylinder(10, 5, V(0, 0, 18)).cut(Part.makeCylinder(7, 5, V(0, 0, 18)))
        found = mq.draft(shaft.cut(ring), "z")
        sides = 2 * np.pi * (10**2 - 7**2)
        floor = 2 * np.pi * 7 * 5
        self.assertAlmostEqual(found.undercut_area, sides + floor, delta=0.02 * (sides + floor))

    def test_against_the_pull_all_signs_change(self):
        shape = Part.makeCone(10, 8, 20)
        up, down = mq.draft(shape, "z"), mq.draft(shape, "-z")
        np.testing.assert_allclose(up.angles, -down.angles, atol=1e-12)
        self.assertEqual(up.low_area, down.low_area)

    def test_meshes_have_the_normals_of_their_triangles(self):
        mesh = mq.triangulate(Part.makeCone(10, 8, 20), chord_height=0.01)
        found = mq.draft((mesh.vertices, mesh.triangles))
        self.assertEqual((found.exact_normals, found.faces), (0.0, []))
        self.assertEqual(found.undercut_area, 0.0)
        side = np.abs(found.angles) < 45.0
        self.assertAlmostEqual(float(np.median(found.angles[side])), np.degrees(np.arctan(0.1)), delta=0.1)

    def test_refused(self):
        box = Part.makeBox(1, 1, 1)
        for direction in ("w", "1,2", (0, 0, 0), (1, 2), None, (np.nan, 0, 1)):
            with self.assertRaises(mq.InvalidInput):
                mq.draft(box, direction)
        with self.assertRaises(mq.InvalidInput):
            mq.draft(box, min_draft=91)
        with self.assertRaises(mq.Cancelled):
            mq.draft(box, progress=lambda fraction, stage: False)

    def test_command_line(self):
        with tempfile.TemporaryDirectory() as folder:
            path, table = os.path.join(folder, "block.brep"), os.path.join(folder, "draft.csv")
            Part.makeBox(30, 20, 10).cut(Part.makeCylinder(2, 20, V(15, 0, 5), V(0, 1, 0))).exportBrep(path)
            done = subprocess.run([COMMAND, "draft", path, "--pull-direction", "0,0,1", "--csv", table, "--json", "--strict"],
                                  capture_output=True, text=True, timeout=120, stdin=subprocess.DEVNULL)
            self.assertEqual(done.returncode, 3, done.stderr)
            said = json.loads(done.stdout)
            self.assertAlmostEqual(said["undercut_area"], 2 * np.pi * 2 * 20, delta=3)
            self.assertIn("1 face has undercuts", said["findings"][0]["text"])
            with open(table, encoding="ascii") as stream:
                self.assertEqual(stream.readline(), "triangle,face,draft,release,area\n")
                self.assertEqual(len(stream.readlines()), said["triangles"])


if __name__ == "__main__":
    unittest.main()
