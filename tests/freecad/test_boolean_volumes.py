# SPDX-License-Identifier: LGPL-2.1-or-later
"""mq.boolean of shapes without a tolerance: how fine they are meshed, and what is told of it."""

import unittest
from unittest import mock

import FreeCAD
import Part

import MeshQuality as mq
from MeshQuality.core import operands


class Volumes(unittest.TestCase):
    """By default; the tolerance of the resolution is a tenth of the radius of this rod."""

    def test_round_operands_keep_their_volume(self):
        rod, away = Part.makeCylinder(5, 200), Part.makeBox(60, 40, 6, FreeCAD.Vector(-30, -20, 300))
        report = mq.boolean(rod, away, "difference").report
        self.assertLess(abs(report.volume / rod.Volume - 1.0), 0.002)
        self.assertNotIn("volume", "".join(report.notes))
        given = mq.boolean(rod, away, "difference", tolerance=0.68).report
        self.assertGreater(abs(given.volume / rod.Volume - 1.0), 0.02)
        self.assertLess(given.triangles, report.triangles)

    def test_walls_that_lose_inside_what_they_gain_outside_stay_coarse(self):
        tube = Part.makeCylinder(100, 200).cut(Part.makeCylinder(99, 200))
        report = mq.boolean(tube, Part.makeBox(1, 1, 1, FreeCAD.Vector(200, 0, 0)), "union").report
        self.assertLess(abs((report.volume - 1.0) / tube.Volume - 1.0), 0.002)
        self.assertLess(report.triangles, 60000)

    def test_many_shapes_are_told_in_one_note(self):
        shapes = [Part.makeCylinder(1, 2, FreeCAD.Vector(5 * i, 0, 0)) for i in range(12)]
        notes = mq.boolean(shapes, operation="union").report.notes
        self.assertEqual(len(notes), 1, notes)
        self.assertRegex(notes[0], r"^12 operands are shapes: their meshes deviate by at most \S+ mm from them; ")

    def test_what_would_take_too_many_triangles_is_told(self):
        with mock.patch.object(operands, "_MOST", 1000):
            report = mq.boolean(Part.makeCylinder(5, 200), Part.makeBox(1, 1, 1, FreeCAD.Vector(50, 0, 0)), "union").report
        self.assertRegex(report.notes[0], r"operand A .* and its volume by about \d.*%;")
