# SPDX-License-Identifier: LGPL-2.1-or-later
"""method="star" and method="sprinkle" of triangulate, on live shapes."""

import unittest

import Part
from FreeCAD import Vector

import MeshQuality as mq
from MeshQuality.cli import parser as cli_parser

METHODS = ("star", "sprinkle")


def plate():
    """A plate with two round holes, one edge filleted."""
    shape = Part.makeBox(40, 30, 5)
    for x, radius in ((12, 5), (28, 3)):
        shape = shape.cut(Part.makeCylinder(radius, 5, Vector(x, 15, 0)))
    return shape.makeFillet(1.0, [shape.Edges[0]])


class Sampling(unittest.TestCase):
    def test_polished_meshes_keep_the_bounds(self):
        for method in METHODS:
            for connectivity in ("pseudo-delaunay", "parametric"):
                with self.subTest(method=method, connectivity=connectivity):
                    report = mq.triangulate(plate(), method=method, connectivity=connectivity,
                                            chord_height=0.05).report
                    self.assertTrue(report.closed and report.oriented and report.manifold)
                    self.assertEqual(report.euler, -2)
                    self.assertGreaterEqual(report.min_angle_unexempted, 25.0)
                    self.assertLessEqual(report.max_chord_height, 0.05)

    def test_raw_meshes_are_sound(self):
        for method in METHODS:
            with self.subTest(method=method):
                report = mq.triangulate(plate(), method=method, refine_samples=False).report
                self.assertTrue(report.closed and report.oriented and report.manifold)
                self.assertEqual(report.min_angle_asked, 0.0)
                self.assertEqual(report.fallback, [])
                self.assertGreater(report.min_angle, 15.0)

    def test_the_seed_decides_and_nothing_else(self):
        def arrays(seed):
            mesh = mq.triangulate(plate(), method="sprinkle", seed=seed)
            return mesh.vertices.tobytes(), mesh.triangles.tobytes()

        self.assertEqual(arrays(1), arrays(1))
        self.assertNotEqual(arrays(1), arrays(2))

    def test_segments_follow_the_faces(self):
        shape = plate()
        mesh = mq.triangulate(shape, method="star")
        self.assertEqual(set(mesh.triangle_face.tolist()), set(range(len(shape.Faces))))
        self.assertEqual(mesh.to_mesh().countSegments(), len(shape.Faces))

    def test_refining_samples_is_on_unless_switched_off_on_the_command_line(self):
        parser = cli_parser.parser()
        for flags, expected in (([], True), (["--refine-samples"], True), (["--no-refine-samples"], False)):
            arguments = parser.parse_args(["triangulate", "part.step", *flags])
            self.assertIs(arguments.refine_samples, expected)
            self.assertIs(arguments.allow_missing_faces, False)

    def test_cancel(self):
        def refuse(fraction, stage):
            return stage != "sampling"

        with self.assertRaises(mq.Cancelled):
            mq.triangulate(plate(), method="sprinkle", max_edge=0.2, progress=refuse)
