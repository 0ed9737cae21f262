# SPDX-License-Identifier: LGPL-2.1-or-later
"""mq.boolean(method="uniform") of shapes: the rays meet the CAD faces, and reconstructed vertices lie on them."""

import os
import unittest

import helpers
import numpy as np
import Part
from FreeCAD import Placement, Rotation, Vector

import MeshQuality as mq
from MeshQuality.compat import extension

CAD = os.path.join(os.environ.get("MESHQUALITY_DATA", os.path.join(helpers.ROOT, "..", "shared", "data")), "cad")
DATA_PARTS = ("ANC101.stp", "BSplHelix.brep", "Cone_1.brep", "CrankArm.brep", "Pump_TopCover.brep", "Torus_1.brep",
              "axle.step", "codo2.stp", "component8.step", "dobleCodo.stp", "eight_cyl.stp")


def reconstructed(result):
    """Vertices of triangles that were made or changed, without those of an operand's own triangles."""
    made = result.triangle_source[:, 0] < 0
    vertices = np.setdiff1d(result.triangles[made], result.triangles[~made])
    return result.vertices[vertices] + result.origin


def uniform(a, b, operation, **options):
    return mq.boolean(a, b, operation, method="uniform", **options)


class NativeRays(unittest.TestCase):
    def setUp(self):
        self.ball = Part.makeSphere(10.0)
        self.block = Part.makeBox(12.3, 14.1, 9.7, Vector(1.3, -6.2, 2.1))

    def test_reconstructed_vertices_lie_on_the_faces(self):
        exact = self.ball.cut(self.block)
        result = uniform(self.ball, self.block, "difference", resolution=129)
        report = result.report
        self.assertTrue(report.closed and report.oriented and report.manifold)
        self.assertEqual(report.face_samples, report.samples)
        self.assertGreater(report.fitted_vertices, 500)
        self.assertLess(report.unfitted_vertices, 0.05 * report.fitted_vertices)
        self.assertAlmostEqual(report.volume / exact.Volume, 1.0, delta=4e-3)
        distances = extension().distances_to_faces(exact, reconstructed(result), None)
        self.assertLess(np.quantile(distances, 0.95), 1e-5)
        meshes = [mq.triangulate(shape, chord_height=report.tolerance_asked / 16) for shape in (self.ball, self.block)]
        by_mesh = uniform(*meshes, "difference", resolution=129)
        self.assertEqual(by_mesh.report.face_samples, 0)
        self.assertLess(10 * distances.mean(),
                        extension().distances_to_faces(exact, reconstructed(by_mesh), None).mean())

    def test_of_all_operations(self):
        volumes = {"union": self.ball.fuse(self.block).Volume, "difference": self.ball.cut(self.block).Volume,
                   "intersection": self.ball.common(self.block).Volume}
        volumes["symmetric_difference"] = volumes["union"] - volumes["intersection"]
        for operation, volume in volumes.items():
            report = uniform(self.ball, self.block, operation, resolution=129).report
            self.assertTrue(report.closed and report.oriented, operation)
            self.assertAlmostEqual(report.volume / volume, 1.0, delta=5e-3, msg=operation)

    def test_shapes_far_away_and_turned(self):
        here = uniform(self.ball, self.block, "union", resolution=65)
        place = Placement(Vector(3e5, -2e5, 1e5), Rotation(Vector(1, 2, 3), 40))
        moved = [shape.copy() for shape in (self.ball, self.block)]
        for shape in moved:
            shape.Placement = place.multiply(shape.Placement)
        far = uniform(*moved, "union", resolution=65)
        self.assertTrue(far.report.closed)
        self.assertEqual(far.report.face_samples, far.report.samples)
        self.assertAlmostEqual(far.report.volume / here.report.volume, 1.0, delta=3e-3)
        exact = moved[0].fuse(moved[1])
        distances = extension().distances_to_faces(exact, reconstructed(far), None)
        self.assertLess(np.quantile(distances, 0.9), 1e-3)

    def test_a_shape_and_a_mesh(self):
        block = mq.triangulate(self.block, chord_height=0.01)
        report = uniform(self.ball, block, "difference", resolution=65).report
        self.assertTrue(report.closed)
        self.assertTrue(0 < report.face_samples < report.samples)

    def test_faces_in_contact(self):
        below, above = Part.makeBox(4, 4, 2), Part.makeBox(2, 2, 3, Vector(1, 1, 2))
        report = uniform(below, above, "union", resolution=65).report
        self.assertTrue(report.closed and report.manifold)
        self.assertAlmostEqual(report.volume, 32 + 12, delta=0.3)
        pipe = Part.makeCylinder(2, 10).cut(Part.makeCylinder(1, 10))
        report = uniform(pipe, Part.makeCylinder(1, 10), "union", resolution=65).report
        self.assertTrue(report.closed)
        self.assertAlmostEqual(report.volume / (40 * np.pi), 1.0, delta=0.01)

    def test_the_same_for_any_number_of_threads(self):
        one, three = (uniform(self.ball, self.block, "union", resolution=65, threads=n) for n in (1, 3))
        self.assertEqual(one.vertices.tobytes(), three.vertices.tobytes())
        self.assertEqual(one.triangles.tobytes(), three.triangles.tobytes())

    def test_tolerance_and_stages(self):
        stages = []
        result = uniform(self.ball, self.block, "union", tolerance=0.3,
                         progress=lambda fraction, stage: stages.append(stage) is None)
        self.assertLessEqual(result.report.error_bound, 0.3)
        self.assertIn("sampling CAD faces", dict(result.report.seconds))
        with self.assertRaises(mq.Cancelled):
            uniform(self.ball, self.block, "union", resolution=257,
                    progress=lambda fraction, stage: "CAD" not in stage)

    def test_every_ray_of_real_parts_leaves_as_often_as_it_enters(self):
        """Rays that do not balance are an error."""
        names = [name for name in DATA_PARTS if os.path.exists(os.path.join(CAD, name))]
        if len(names) < 10:
            self.skipTest("parts are not in $MESHQUALITY_DATA/cad")
        for name in names:
            with self.subTest(part=name):
                shape = Part.Shape()
                shape.read(os.path.join(CAD, name))
                box = shape.BoundBox
                sides = (box.XLength, box.YLength, box.ZLength)
                corner = Vector(*(low + 0.31 * side for low, side in zip((box.XMin, box.YMin, box.ZMin), sides)))
                tool = Part.makeBox(*(0.55 * side for side in sides), corner)
                report = uniform(shape, tool, "difference", resolution=65).report
                self.assertTrue(report.closed and report.oriented)
                self.assertGreater(report.face_samples, 0.97 * report.samples)
