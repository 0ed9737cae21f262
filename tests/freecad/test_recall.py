# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshing a part of many faces again after an edit."""

import unittest

import Part
from FreeCAD import Vector

import MeshQuality as mq

ALONG, ACROSS, PITCH = 10, 10, 10.0


def plate(first_radius):
    """A plate with a hundred holes; a dimension of the first one is free."""
    holes = []
    for i in range(ALONG):
        for j in range(ACROSS):
            radius = first_radius if i == j == 0 else 2.0 + 0.1 * ((i + 3 * j) % 7)
            place = Vector(PITCH * (i + 0.5), PITCH * (j + 0.5), -1.0)
            holes.append(Part.makeCylinder(radius, 12.0 if (i + j) % 2 else 6.0, place))
    return Part.makeBox(PITCH * ALONG, PITCH * ACROSS, 10.0).cut(Part.makeCompound(holes))


class AfterAnEdit(unittest.TestCase):
    def test_faces_that_did_not_change_keep_their_triangles(self):
        memory = mq.Memory()
        first = mq.triangulate(plate(2.0), chord_height=0.05, memory=memory)
        self.assertEqual(first.report.reused_faces, 0)
        edited = plate(2.5)
        self.assertEqual(len(memory), len(edited.Faces))
        again = mq.triangulate(edited, chord_height=0.05, memory=memory)
        self.assertGreater(again.report.reused_faces, 0.9 * len(edited.Faces))
        report = again.report
        self.assertTrue(report.closed and report.oriented and report.manifold)
        self.assertEqual(report.self_intersections, 0)
        self.assertGreaterEqual(report.min_angle_unexempted, 25.0)
        self.assertEqual(len(report.exempt), 0)
        self.assertLessEqual(report.max_chord_height, 0.05)
        judged = mq.quality(again, edited)
        self.assertLessEqual(judged.max_chord_height, 0.05 + 1e-5)

    def test_only_a_memory_is_one(self):
        with self.assertRaisesRegex(mq.InvalidInput, "memory"):
            mq.triangulate(plate(2.0), memory={})
