# SPDX-License-Identifier: LGPL-2.1-or-later
"""Voids: closed cavities, their volumes and faces."""

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


def hollow():
    """A block with a box and a ball in it that are closed, and a bore that is not."""
    block = Part.makeBox(40, 30, 20).cut(Part.makeBox(6, 5, 4, V(5, 5, 5)))
    return block.cut(Part.makeSphere(4, V(25, 15, 10))).cut(Part.makeCylinder(2, 20, V(35, 25, 0)))


class Voids(unittest.TestCase):
    def test_their_volumes_places_and_faces(self):
        shape = hollow()
        found = mq.voids(shape)
        self.assertEqual(len(found.voids), 2)
        ball, box = found.voids
        self.assertAlmostEqual(ball.volume, 4 / 3 * np.pi * 64, delta=6)
        self.assertAlmostEqual(box.volume, 120, places=3)
        self.assertAlmostEqual(box.area, 2 * (30 + 24 + 20), places=3)
        np.testing.assert_allclose(ball.center, (25, 15, 10), atol=1e-2)
        np.testing.assert_allclose(box.low, (5, 5, 5), atol=1e-5)
        np.testing.assert_allclose(box.high, (11, 10, 9), atol=1e-5)
        self.assertEqual((len(ball.faces), len(box.faces)), (1, 6))
        self.assertIn("Sphere", str(shape.getElement(ball.faces[0]).Surface))
        self.assertAlmostEqual(found.solid_volume, shape.Volume, delta=0.01 * shape.Volume)
        self.assertIn("voids        2", str(found))

    def test_a_finer_mesh_comes_nearer_to_the_volume(self):
        exact = 4 / 3 * np.pi * 64
        errors = [abs(mq.voids(hollow(), tolerance=tolerance).voids[0].volume - exact) for tolerance in (0.1, 0.01)]
        self.assertLess(errors[1], 0.2 * errors[0])

    def test_none_in_solids_without_and_in_several_solids(self):
        self.assertEqual(mq.voids(Part.makeBox(3, 4, 5)).voids, [])
        both = Part.makeCompound([hollow(), Part.makeSphere(2, V(25, 15, 10))])
        self.assertEqual([round(void.volume) for void in mq.voids(both).voids],
                         [round(void.volume) for void in mq.voids(hollow()).voids])

    def test_meshes_that_are_inside_out(self):
        mesh = mq.triangulate(hollow())
        found = mq.voids((mesh.vertices, mesh.triangles[:, ::-1]))
        self.assertEqual(len(found.voids), 2)
        self.assertEqual(found.voids[0].faces, ())
        with self.assertRaises(mq.InvalidInput):
            mq.voids(Part.makePlane(3, 3))

    def test_command_line(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "hollow.brep")
            hollow().exportBrep(path)
            done = subprocess.run([COMMAND, "voids", path, "--json", "--strict"], capture_output=True, text=True, timeout=120,
                                  stdin=subprocess.DEVNULL)
            self.assertEqual(done.returncode, 3, done.stderr)
            said = json.loads(done.stdout)
            self.assertEqual(len(said["voids"]), 2)
            self.assertIn("2 closed voids", said["findings"][0]["text"])


if __name__ == "__main__":
    unittest.main()
