# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes for machining: the side is a promise, held against OpenCASCADE; documents and the command line."""

import json
import os
import unittest

import FreeCAD
import helpers
import Mesh
import numpy as np
import Part
import test_cli

import MeshQuality as mq
from MeshQuality import options

TOLERANCE = 0.1


def parts():
    box = Part.makeBox(30, 20, 10)
    return {"box": box, "dome": box.fuse(Part.makeSphere(7, FreeCAD.Vector(15, 10, 10))),
            "pocket": box.cut(Part.makeCylinder(6, 20, FreeCAD.Vector(15, 10, 4))), "torus": Part.makeTorus(12, 4),
            "fillet": box.makeFillet(3, box.Edges)}


def signed(points, shape):
    """Distances from a solid by OpenCASCADE, below 0 inside."""
    surface = Part.makeCompound(shape.Faces)
    found = []
    for point in points:
        place = FreeCAD.Vector(*map(float, point))
        distance = Part.Vertex(place).distToShape(surface)[0]
        found.append(-distance if shape.isInside(place, 1e-9, False) else distance)
    return np.array(found)


def samples(mesh, count=150):
    """Points within triangles, and corners, float64 (n, 3)."""
    random = np.random.default_rng(3)
    chosen = random.integers(0, len(mesh.triangles), count)
    weights = random.dirichlet((0.6, 0.6, 0.6), count)
    return np.einsum("nk,nki->ni", weights, (mesh.vertices + mesh.origin)[mesh.triangles[chosen]])


class Sides(unittest.TestCase):
    def test_no_point_is_on_the_wrong_side(self):
        for name, shape in parts().items():
            for side in options.cam.SIDES:
                with self.subTest(f"{name} {side}"):
                    mesh = mq.cam(shape, TOLERANCE, side)
                    self.assertTrue(0.0 < mesh.nearest < mesh.farthest <= TOLERANCE)
                    report = mq.quality(mesh)
                    self.assertTrue(report.closed and report.manifold and report.oriented and report.self_intersections == 0)
                    values = signed(samples(mesh), shape) * (1 if side == "outside" else -1)
                    self.assertGreaterEqual(values.min(), mesh.nearest - 1e-5)
                    self.assertLessEqual(values.max(), mesh.farthest + 1e-5)

    def test_meshes_with_a_tolerance_as_coarse_as_others(self):
        """Fewer triangles than FreeCAD's tessellation at the same tolerance, which lies on both sides."""
        for name in ("dome", "torus", "fillet"):
            shape = parts()[name]
            self.assertLess(len(mq.cam(shape, TOLERANCE).triangles), len(shape.tessellate(TOLERANCE)[1]), name)

    def test_a_mesh_is_a_source_too(self):
        given = Mesh.createSphere(5.0, 30)
        found = mq.cam(given, 0.05)
        low = np.abs(np.linalg.norm(found.vertices, axis=1)).min()
        self.assertGreater(low, 5.0 * np.cos(np.pi / 30) - 0.1)
        self.assertLessEqual(mq.deviation(found, given).max_deviation, found.farthest + 1e-6)
        self.assertGreater(mq.deviation(found, given).lowest, 0.0)

    def test_what_cannot_be_is_refused(self):
        box = Part.makeBox(1, 1, 1)
        with self.assertRaisesRegex(mq.InvalidInput, "tolerance"):
            mq.cam(box, 0)
        with self.assertRaisesRegex(mq.InvalidInput, "side"):
            mq.cam(box, 0.1, side="above")
        with self.assertRaisesRegex(mq.InvalidInput, "nothing of the solid is as deep"):
            mq.cam(box, 1.2, side="inside")
        with self.assertRaises(mq.Error):
            mq.cam(box.Faces[0], 0.1)
        with self.assertRaises(mq.Cancelled):
            mq.cam(box, 0.1, progress=lambda *_: False)


class Objects(helpers.DocumentTest):
    def test_it_follows_its_part(self):
        box = self.box()
        obj = mq.add_cam_mesh(box, TOLERANCE)
        self.assertEqual((obj.Certificate, obj.Label, obj.Side), ("met", f"{box.Label} CAM mesh", "outside"))
        self.assertTrue(0 < obj.Nearest.Value < obj.MaxDeviation.Value <= TOLERANCE)
        self.assertGreater(obj.Mesh.Volume, box.Shape.Volume)
        mq.update(obj, side="inside")
        self.assertLess(obj.Mesh.Volume, box.Shape.Volume)
        self.assertIn("never outside the part", str(obj.Proxy.told(obj)))
        box.Length = 20
        self.document.recompute()
        self.assertAlmostEqual(obj.Mesh.BoundBox.XLength, 20 - TOLERANCE, delta=TOLERANCE)
        self.assertEqual(self.document.UndoNames[-1], "CAM mesh")

    def test_the_command_line(self):
        part, out = os.path.join(self.folder, "part.brep"), os.path.join(self.folder, "part.stl")
        Part.makeSphere(5).exportBrep(part)
        status, said, lines = test_cli.run("cam", part, "-o", out, "--tolerance", 0.05, "--json", "--strict")
        self.assertEqual(status, 0, lines)
        report = json.loads(said)
        self.assertTrue(0 < report["nearest"] < report["farthest"] <= 0.05)
        self.assertGreater(np.linalg.norm([tuple(point.Vector) for point in Mesh.Mesh(out).Points], axis=1).min(), 5.0)
        self.assertIn("outside of the part", lines[-1])
        self.assertEqual(test_cli.run("cam", part, "-o", out)[0], 2)
