# SPDX-License-Identifier: LGPL-2.1-or-later
"""mq.triangulate(corners=...): narrow corners of faces that are taken off."""

import math
import unittest

import FreeCAD
import numpy as np
import Part

import MeshQuality as mq


def roof(degrees):
    """A block under two slopes of 45 degrees, between which its top is a narrow triangle."""
    turn = math.radians(degrees)
    part = Part.makeBox(18, 20, 5, FreeCAD.Vector(-8, -10, -5))
    for outward in (FreeCAD.Vector(0, -1, 1), FreeCAD.Vector(-math.sin(turn), math.cos(turn), 1)):
        above = Part.makeBox(200, 200, 200, FreeCAD.Vector(-100, -100, 0))
        above.Placement = FreeCAD.Placement(FreeCAD.Vector(), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), outward))
        part = part.cut(above)
    return part.removeSplitter()


class CutCorners(unittest.TestCase):
    """corners="cut": narrow corners of faces end where they are a detail wide."""

    def test_no_triangle_is_below_the_bound(self):
        for degrees in (0.5, 2, 10, 20):
            with self.subTest(degrees=degrees):
                part = roof(degrees)
                kept = mq.triangulate(part, chord_height_relative=2e-3, corners="keep").report
                self.assertEqual(len(kept.exempt), 1)
                mesh = mq.triangulate(part, chord_height_relative=2e-3, corners="cut")
                report = mesh.report
                self.assertEqual((len(report.exempt), report.self_intersections), (0, 0), str(report))
                self.assertGreaterEqual(report.min_angle, 25.0)
                self.assertTrue(report.closed and report.oriented and report.manifold)
                self.assertLessEqual(report.max_chord_height, 0.5 * report.detail)
                self.assertTrue(any("is cut off where it is" in str(note) for note in report.notes), str(report))
                a, b, c = (mesh.vertices[column] for column in mesh.triangles.T)
                volume = np.einsum("ij,ij->", a, np.cross(b, c)) / 6.0
                self.assertAlmostEqual(volume / part.Volume, 1.0, delta=1e-6)

    def test_by_itself_only_those_below_two_degrees_are_cut_off(self):
        for degrees, others in ((0.5, "cut"), (1.9, "cut"), (2.1, "keep"), (20, "keep")):
            with self.subTest(degrees=degrees):
                part = roof(degrees)
                mesh = mq.triangulate(part, chord_height_relative=2e-3)
                same = mq.triangulate(part, chord_height_relative=2e-3, corners=others)
                self.assertEqual(len(mesh.report.exempt), 0 if others == "cut" else 1)
                np.testing.assert_array_equal(mesh.vertices, same.vertices)

    def test_where_angles_have_no_bound_nothing_is_cut_off(self):
        mesh = mq.triangulate(roof(2), chord_height_relative=2e-3, method="star", polish=False)
        self.assertFalse(any("is cut off" in str(note) for note in mesh.report.notes))

    def test_a_corner_between_faces_that_would_fold_on_each_other_stays(self):
        corners = [FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(20, 0, 0), FreeCAD.Vector(20, 1, 0)]
        wedge = Part.Face(Part.makePolygon([*corners, corners[0]])).extrude(FreeCAD.Vector(0, 0, 10))
        kept = mq.triangulate(wedge)
        cut = mq.triangulate(wedge, corners="cut")
        self.assertEqual(len(cut.report.exempt), 2)
        np.testing.assert_array_equal(cut.vertices, kept.vertices)

    def test_other_words_are_refused(self):
        with self.assertRaisesRegex(mq.InvalidInput, "corners"):
            mq.triangulate(Part.makeBox(1, 1, 1), corners="round")
