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


def mean_error(result, exact):
    """The larger mean distance of both ways, mm."""
    surfaces = result._surface, exact._surface
    there, back = (extension().surface_distance(*pair)[0] for pair in (surfaces, surfaces[::-1]))
    return max(there, back)


def uniform(a, b, operation, **options):
    return mq.boolean(a, b, operation, method="uniform", **options)


class NativeRays(unittest.TestCase):
    def setUp(self):
        self.ball = Part.makeSphere(10.0)
        self.block = Part.makeBox(12.3, 14.1, 9.7, Vector(1.3, -6.2, 2.1))

    def test_reconstructed_vertices_lie_on_the_faces(self):
        exact = self.ball.cut(self.block)
        result = uniform(self.ball, self.block, "difference", resolution=193)
        report = result.report
        self.assertTrue(report.closed and report.oriented and report.manifold)
        self.assertEqual(report.face_samples, report.samples)
        self.assertGreater(report.fitted_vertices, 1000)
        self.assertLess(report.unfitted_vertices, 0.05 * report.fitted_vertices)
        self.assertAlmostEqual(report.volume / exact.Volume, 1.0, delta=4e-3)
        distances = extension().distances_to_faces(exact, reconstructed(result), None)
        self.assertLess(np.quantile(distances, 0.97), 1e-5)  # the others lie at edges, and are the fewer the finer the rays
        meshes = [mq.triangulate(shape, chord_height=report.tolerance_asked / 16) for shape in (self.ball, self.block)]
        by_mesh = uniform(*meshes, "difference", resolution=193)
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
        here = uniform(self.ball, self.block, "union", resolution=65, tolerance=0.2)
        place = Placement(Vector(3e5, -2e5, 1e5), Rotation(Vector(1, 2, 3), 40))
        moved = [shape.copy() for shape in (self.ball, self.block)]
        for shape in moved:
            shape.Placement = place.multiply(shape.Placement)
        far = uniform(*moved, "union", resolution=65, tolerance=0.2)
        self.assertTrue(far.report.closed)
        self.assertEqual(far.report.face_samples, far.report.samples)
        self.assertAlmostEqual(far.report.volume / here.report.volume, 1.0, delta=3e-3)
        exact = moved[0].fuse(moved[1])
        distances = extension().distances_to_faces(exact, reconstructed(far), None)
        self.assertLess(np.quantile(distances, 0.9), 1e-3)

    def test_vertices_lie_on_the_faces_of_all_operands(self):
        ring = Part.makeTorus(11.0, 2.6)
        bars = [Part.makeBox(31.0, 2.1, 1.9, Vector(-15.3, y, -0.9)) for y in (-6.1, -0.8, 4.7)]
        exact = ring
        for bar in bars:
            exact = exact.fuse(bar)
        result = mq.boolean([ring, *bars], operation="union", method="uniform", resolution=129)
        self.assertTrue(result.report.closed)
        self.assertLess(result.report.unfitted_vertices, 0.1 * result.report.fitted_vertices)
        distances = extension().distances_to_faces(exact, reconstructed(result), None)
        self.assertLess(np.quantile(distances, 0.9), 1e-5)

    def test_errors_are_below_those_of_meshes(self):
        ring, bar = Part.makeTorus(11.0, 2.6), Part.makeBox(31.0, 2.1, 1.9, Vector(-15.3, -0.8, -0.9))
        cube = Part.makeBox(17.1, 16.3, 15.9, Vector(-8.4, -8.1, -7.9))
        pairs = ((cube, Part.makeSphere(10.3), "intersection"), (ring, bar, "difference"))
        for a, b, operation in pairs:
            exact = {"intersection": a.common, "difference": a.cut}[operation](b)
            fine = mq.triangulate(exact, chord_height=1e-5 * exact.BoundBox.DiagonalLength)
            for rays in (65, 129):
                by_faces = uniform(a, b, operation, resolution=rays)
                cell = by_faces.report.tolerance_asked / 3**0.5
                default = uniform(mq.triangulate(a), mq.triangulate(b), operation, resolution=rays)
                coarse = [mq.triangulate(shape, chord_height=cell / 2) for shape in (a, b)]
                by_meshes = uniform(*coarse, operation, resolution=rays)
                with self.subTest(operation=operation, rays=rays):
                    self.assertLess(mean_error(by_faces, fine), 0.06 * cell)
                    self.assertLess(mean_error(by_faces, fine), mean_error(default, fine))
                    self.assertLess(3 * mean_error(by_faces, fine), mean_error(by_meshes, fine))

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
        section = Part.Wire([Part.makeCircle(1.7, Vector(8.0, 0.0, 0.0), Vector(0.0, 1.0, 0.12))])
        tube = Part.Wire(Part.makeHelix(6.0, 12.0, 8.0)).makePipeShell([section], True, True)  # of spline faces
        for shape in (self.ball, tube):
            one, *others = (uniform(shape, self.block, "union", resolution=129, threads=n) for n in (1, 2, 3))
            self.assertGreater(one.report.fitted_vertices, 100)
            for other in others:
                self.assertEqual(one.vertices.tobytes(), other.vertices.tobytes())
                self.assertEqual(one.triangles.tobytes(), other.triangles.tobytes())

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
