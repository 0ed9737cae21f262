# SPDX-License-Identifier: LGPL-2.1-or-later
"""mq.boolean of shapes without a tolerance: how fine they are meshed, and what is told of it."""

import unittest

import FreeCAD
import Part

import MeshQuality as mq


class Volumes(unittest.TestCase):
    """By default; a tolerance that divides the length of this rod by 512 is a tenth of its radius."""

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
        self.assertLess(report.triangles, 80000)

    def test_slivers_of_slender_parts_stay(self):
        """A rod that a slab cuts to a sixth of its radius, and a plate to a tenth, hang together as the shapes do."""
        rod, slab = Part.makeCylinder(2.42, 125), Part.makeBox(5, 30, 30, FreeCAD.Vector(-2, -15, 40))
        plate, pocket = Part.makeBox(60, 60, 1), Part.makeBox(30, 80, 5, FreeCAD.Vector(15, -10, 0.1))
        for part, tool in ((rod, slab), (plate, pocket)):
            exact, report = part.cut(tool), mq.boolean(part, tool, "difference").report
            self.assertEqual(report.components, 1)
            self.assertLess(abs(report.volume / exact.Volume - 1.0), 0.002)

    def test_a_resolution_divides_eight_thicknesses(self):
        rod = Part.makeCylinder(2, 100)
        asked = [mq.boolean(rod, rod, "union", resolution=resolution).report.tolerance_asked for resolution in (512, 256)]
        thickness = 2.0 * rod.Volume / rod.Area
        self.assertAlmostEqual(asked[0], 3.0**0.5 * 8.0 * thickness / 512.0)
        self.assertAlmostEqual(asked[1], 2.0 * asked[0])
        shells = mq.boolean(rod.Shells[0], rod.Shells[0], "union").report
        self.assertAlmostEqual(shells.tolerance_asked, asked[0])
        bar = Part.makeBox(100, 0.5, 0.5)
        self.assertAlmostEqual(mq.boolean(bar, bar, "union").report.tolerance_asked, 3.0**0.5 * 100.0 / 16.0 / 512.0)

    def test_many_shapes_are_told_in_one_note(self):
        shapes = [Part.makeCylinder(1, 2, FreeCAD.Vector(5 * i, 0, 0)) for i in range(12)]
        notes = mq.boolean(shapes, operation="union").report.notes
        self.assertEqual(len(notes), 1, notes)
        self.assertRegex(notes[0], r"^12 operands are shapes: their meshes deviate by at most \S+ mm from them; ")

    def test_the_tolerance_does_not_change_once_a_shape_was_shown(self):
        torus = Part.makeTorus(10, 3)
        shown = torus.copy()
        shown.tessellate(1.0)
        plain, after = (mq.boolean(shape, Part.makeBox(5, 5, 5), "union", resolution=64, method="uniform").report.tolerance_asked
                        for shape in (torus, shown))
        self.assertEqual(plain, after)
