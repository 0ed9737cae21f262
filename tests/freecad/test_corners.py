# SPDX-License-Identifier: LGPL-2.1-or-later
"""mq.triangulate(corners=...): narrow corners of faces that are kept or cut off."""

import math
import random
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


def lens(degrees, length=20.0):
    """A block under an arc that meets its chord at an angle."""
    half = math.radians(degrees)
    height = length / 2 * (1 - math.cos(half)) / math.sin(half)
    ends = FreeCAD.Vector(), FreeCAD.Vector(length, 0, 0)
    arc = Part.Arc(ends[0], FreeCAD.Vector(length / 2, height, 0), ends[1]).toShape()
    return Part.Face(Part.Wire([arc, Part.makeLine(*reversed(ends))])).extrude(FreeCAD.Vector(0, 0, 5))


def piece_of_torus(seed):
    """What a three-sided prism, a side of which meets another at 27 to 48 degrees, has in common with a torus."""
    dice = random.Random(seed)
    turn, radius = math.radians(dice.uniform(27, 48)), dice.uniform(2, 4)
    place, rotation = FreeCAD.Vector(dice.uniform(8, 13), dice.uniform(-3, 3), 0), dice.uniform(0, 360)
    length = dice.uniform(3, 9)
    ends = FreeCAD.Vector(length, 0, 0), FreeCAD.Vector(length * math.cos(turn), length * math.sin(turn), 0)
    prism = Part.Face(Part.makePolygon([FreeCAD.Vector(), *ends, FreeCAD.Vector()])).extrude(FreeCAD.Vector(0, 0, 30))
    prism.rotate(FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), rotation)
    prism.translate(place)
    return Part.makeTorus(10, radius).common(prism)


class WideCorners(unittest.TestCase):
    """Corners that are not below the bound force no triangle below it."""

    def test_pieces_are_halved_where_chords_need_more_triangles_than_fit(self):
        """Half a slender cone has 56 degrees at its tip, and its flat side 36."""
        half = Part.makeCone(10 * math.tan(math.radians(18)), 0, 10, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 180)
        report = mq.triangulate(half.removeSplitter(), chord_height=0.05, min_angle=25).report
        self.assertEqual(len(report.exempt), 0, report)
        self.assertGreaterEqual(report.min_angle, 25.0)


class KeptCorners(unittest.TestCase):
    """A corner has the angle of its edges, which the first chords of curved ones approach."""

    def test_chords_are_short_enough_wherever_the_part_is(self):
        for place in FreeCAD.Vector(), FreeCAD.Vector(300, 200, 400):  # the other one has a local frame
            part = lens(15.0)
            part.translate(place)
            with self.subTest(place):
                report = mq.triangulate(part, chord_height=0.5, corners="keep").report
                self.assertEqual(len(report.exempt), 4)
                self.assertGreater(report.min_angle, 15.0 / 1.08)
                self.assertLess(report.min_angle, 15.0)
                for _, why in report.exempt_reasons:
                    self.assertAlmostEqual(why.angle, 15.0, places=6)

    def test_no_vertex_divides_one_that_has_room_for_one_triangle(self):
        for seed in 43, 51, 79:  # across the corner, an edge was too far from the torus
            with self.subTest(seed):
                report = mq.triangulate(piece_of_torus(seed), chord_height=0.03, corners="keep").report
                self.assertEqual(report.exempt, [])
                self.assertGreaterEqual(report.min_angle, 25.0)
                self.assertLessEqual(report.max_chord_height, 0.03)
                self.assertTrue(report.closed and report.self_intersections == 0)

    def test_edges_that_touch_have_none(self):
        corner, ends = FreeCAD.Vector(), (FreeCAD.Vector(10, 0, 0), FreeCAD.Vector(10, 6, 0))
        arc = Part.Arc(corner, FreeCAD.Vector(*(10 / 1.7 * x for x in (math.sin(1.0), 1 - math.cos(1.0), 0))),
                       FreeCAD.Vector(*(10 / 1.7 * x for x in (math.sin(1.5), 1 - math.cos(1.5), 0))))
        end = arc.EndPoint
        sides = [Part.makeLine(corner, ends[0]), Part.makeLine(ends[0], FreeCAD.Vector(10, end.y, 0)),
                 Part.makeLine(FreeCAD.Vector(10, end.y, 0), end), arc.toShape()]
        part = Part.Face(Part.Wire(sides)).extrude(FreeCAD.Vector(0, 0, 5))
        report = mq.triangulate(part, corners="keep").report
        self.assertEqual({why.cause for _, why in report.exempt_reasons}, {"narrow_corner"})
        for triangle, why in report.exempt_reasons:
            self.assertAlmostEqual(why.angle, 0.0, places=5)


class Pinches(unittest.TestCase):
    """A face that is pinched between two parts of its border, or beside a seam, is opened there by itself."""

    def _holds(self, part):
        kept = mq.triangulate(part, chord_height_relative=2e-3, corners="keep").report
        self.assertGreaterEqual(len(kept.exempt), 2)
        mesh = mq.triangulate(part, chord_height_relative=2e-3)
        report = mesh.report
        self.assertEqual((len(report.exempt), report.self_intersections), (0, 0), str(report))
        self.assertTrue(report.closed and report.oriented and report.manifold)
        self.assertEqual(report.cut_corners, 2)
        self.assertLessEqual(report.max_chord_height, report.chord_height_asked)
        self.assertAlmostEqual(report.volume / kept.volume, 1.0, delta=2e-3)
        return mesh

    def test_a_hole_that_touches_an_edge_or_nearly_does(self):
        for gap in 0.0, 1e-5, 1e-4, 8e-4:  # mm; the detail is 0.002
            with self.subTest(gap):
                tool = Part.makeCone(3, 1.5, 8, FreeCAD.Vector(9, 3 + gap, 8), FreeCAD.Vector(0, 0, -1))
                mesh = self._holds(Part.makeBox(20, 12, 8).cut(tool))
                self.assertLess(len(mesh.triangles), 3000)

    def test_two_holes_that_touch_each_other(self):
        part = Part.makeBox(20, 12, 8)
        for x, r in (6, 3), (11, 2):
            part = part.cut(Part.makeCone(r, 0.4 * r, 6, FreeCAD.Vector(x, 6, 8), FreeCAD.Vector(0, 0, -1)))
        self._holds(part)

    def test_a_hole_that_touches_a_seam(self):
        tool = Part.makeCylinder(0.75, 3, FreeCAD.Vector(0, 0.75, 5), FreeCAD.Vector(1, 0, 0))
        part = Part.makeCylinder(2, 15).cut(tool)
        mesh = self._holds(part)
        self.assertEqual(mq.curve(mesh, shape=part).report.invalid, 0)


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
                # Half a degree takes more than twenty times the triangles of the distance, and so a larger detail.
                self.assertAlmostEqual(volume / part.Volume, 1.0, delta=5e-4 * report.detail)

    def test_by_itself_a_corner_that_keeps_one_triangle_stays(self):
        for degrees in (0.5, 10):
            with self.subTest(degrees=degrees):
                part = roof(degrees)
                mesh = mq.triangulate(part, chord_height_relative=2e-3)
                kept = mq.triangulate(part, chord_height_relative=2e-3, corners="keep")
                self.assertEqual([why.cause for _, why in mesh.report.exempt_reasons], ["narrow_corner"])
                np.testing.assert_array_equal(mesh.vertices, kept.vertices)

    def test_by_itself_a_corner_is_cut_off_where_its_triangle_is_narrower_than_the_detail(self):
        corner = FreeCAD.Vector(0, 0, 8)
        step = [corner, FreeCAD.Vector(40, 0.4, 8), FreeCAD.Vector(40, 20, 8), FreeCAD.Vector(0, 20, 8), corner]
        part = Part.makeBox(40, 20, 8).fuse(Part.Face(Part.makePolygon(step)).extrude(FreeCAD.Vector(0, 0, 4)))
        edge = next(f"Edge{i}" for i, edge in enumerate(part.Edges, 1)
                    if edge.Length > 40.0001 and edge.BoundBox.ZMax < 8.001)
        for size, cut in ((0.3, 1), (0.6, 0)):  # mm; the corner is 0.004 mm wide, as the detail is, at 0.4 mm
            with self.subTest(size):
                report = mq.triangulate(part, min_angle=25, chord_height_relative=2e-3, local_sizes={edge: size}).report
                self.assertEqual((report.cut_corners, len(report.exempt)), (cut, 1 - cut), str(report))
                self.assertEqual(report.self_intersections, 0)

    def test_corners_too_sharp_for_any_fan_are_cut_off_before_the_first_triangle(self):
        """The top of a nut, whose round border touches the six sides: innermost pieces get longer beside the width as the distance gets finer."""
        across = 10.0 / math.cos(math.pi / 6)
        corners = [FreeCAD.Vector(across * math.cos(math.pi / 3 * i), across * math.sin(math.pi / 3 * i), 0) for i in range(7)]
        low = 10.0 * math.tan(math.pi / 6)
        nut = Part.Face(Part.makePolygon(corners)).extrude(FreeCAD.Vector(0, 0, 5)).common(Part.makeCone(20, 10, low, FreeCAD.Vector(0, 0, 5 - low)))
        coarse = mq.triangulate(nut, chord_height=2e-3).report
        self.assertEqual((coarse.cut_corners, len(coarse.exempt)), (0, 12), str(coarse))
        fine = mq.triangulate(nut, chord_height=2e-4).report
        self.assertEqual((fine.cut_corners, len(fine.exempt), fine.self_intersections), (12, 0, 0), str(fine))
        self.assertNotIn("attempts before", dict(fine.seconds))

    def test_by_itself_corners_are_cut_off_where_more_triangles_stay_below_the_bound(self):
        part = roof(0.2)
        kept = mq.triangulate(part, chord_height_relative=2e-3, corners="keep")
        self.assertIn("narrow_cluster", [why.cause for _, why in kept.report.exempt_reasons])
        mesh = mq.triangulate(part, chord_height_relative=2e-3)
        self.assertEqual(mesh.report.exempt, [])
        self.assertTrue(any("is cut off where it is" in str(note) for note in mesh.report.notes), str(mesh.report))
        self.assertTrue(mesh.report.closed and mesh.report.self_intersections == 0)
        self.assertEqual(mq.curve(mesh, shape=part).report.invalid, 0)

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
