# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where costs fell off a cliff: what is counted are triangles, not seconds."""

import math
import unittest

import FreeCAD
import Part
from parts.cliff_parts import bars, strip

import MeshQuality as mq

V = FreeCAD.Vector


class Cliffs(unittest.TestCase):
    def test_bars_through_one_axis(self):
        result = mq.boolean(bars(12), operation="union", tolerance=0.01)
        report = result.report
        self.assertTrue(report.closed and report.manifold and report.oriented)
        self.assertEqual((report.components, report.euler, report.self_intersections), (1, 2, 0))
        half = math.pi / 24  # of the angle between neighbours, whose sides meet at 1 / sin from the axis
        core = 24 / math.tan(half)  # of the star's outline: 24 kites, each of a bar's half width up to the next bar
        area = core + 24 * (20 / 2 - 1 / math.tan(half)) * 2
        self.assertAlmostEqual(report.volume, 2 * area, delta=0.002 * area)

    def test_wrap_of_a_box_and_of_plates_has_no_handles(self):
        plates = [Part.makeBox(*size, V(*at)) for size, at in (
            ((30, 30, 2), (0, 0, 0)), ((30, 30, 2), (0, 0, 28)), ((2, 30, 30), (0, 0, 0)),
            ((2, 30, 30), (28, 0, 0)), ((30, 2, 30), (0, 0, 0)), ((30, 2, 30), (0, 28, 0)))]
        for objects in (Part.makeBox(30, 30, 30), plates):
            report = mq.wrap(objects, 4.0).report
            self.assertEqual((report.components, report.euler, report.self_intersections), (1, 2, 0))
            self.assertAlmostEqual(report.volume, 30.0 ** 3, delta=30.0)

    def test_thickness_of_a_foil_takes_no_triangles_for_the_angles_of_its_rim(self):
        found = mq.thickness(Part.makeBox(1000, 1000, 0.001))
        self.assertAlmostEqual(found.minimum, 0.001, delta=1e-6)
        self.assertEqual(set(found.minimum_faces), {"Face5", "Face6"})
        self.assertLess(len(found.values), 100_000)

    def test_a_sliver_that_costs_most_triangles_is_named(self):
        for keep_edges in ("all", "feature"):
            report = mq.triangulate(strip(0.002, 20), chord_height=0.005, keep_edges=keep_edges).report
            notes = [note for note in report.notes if "take such faces out of the shape" in note]
            self.assertEqual(len(notes), 1, report.notes)
            self.assertTrue(notes[0].startswith("Face5: "), notes)

    def test_the_remedy_for_a_sliver_holds(self):
        shape = strip(0.002, 30)
        costly = mq.triangulate(shape, chord_height=0.005).report
        note = next(note for note in costly.notes if "max. deviation" in note)
        wanted = float(note.split("max. deviation of ")[1].split(" mm")[0])
        cheap = mq.triangulate(shape, chord_height=wanted).report
        self.assertLess(20 * cheap.triangles, costly.triangles)
        self.assertFalse([note for note in cheap.notes if "take such faces" in note])

    def test_no_sliver_is_named_where_the_mesh_is_fine_for_other_reasons(self):
        report = mq.triangulate(Part.makeBox(100, 100, 1), max_edge=1.0).report
        self.assertGreater(report.triangles, 20_000)
        self.assertEqual(report.notes, [])
