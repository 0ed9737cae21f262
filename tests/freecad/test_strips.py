# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long narrow faces: how many triangles they take, and when they count as edges."""

import math
import unittest

import FreeCAD
import numpy as np
import Part

import MeshQuality as mq


def stairs(step, length=400.0):
    """A bar with six steps of a height along its whole length, mm."""
    corners = [(0, 0), (20, 0), (20, 10)]
    for i in range(6):
        corners += [(18 - 2 * i, 10 + step * i), (18 - 2 * i, 10 + step * (i + 1))]
    corners.append((0, 10 + 6 * step))
    points = [FreeCAD.Vector(x, y, 0) for x, y in [*corners, corners[0]]]
    return Part.Face(Part.makePolygon(points)).extrude(FreeCAD.Vector(0, 0, length))


class Strips(unittest.TestCase):
    def test_pieces_are_as_long_as_the_bound_allows(self):
        # Isosceles triangles on a rail have bases of at most 2 g / tan(bound), of which halving leaves more than half on each rail; with
        # vertices side by side, it left two to four times the least number.
        for width in 0.7, 1.0, 1.3:
            with self.subTest(width):
                part = Part.makeBox(100, width, 20)
                mesh = mq.triangulate(part, min_angle=25)
                self.assertGreaterEqual(mesh.report.min_angle, 25.0)
                self.assertTrue(mesh.report.closed)
                least = 2 * 100 * math.tan(math.radians(25)) / (2 * width)
                strips = [f for f, face in enumerate(part.Faces) if abs(face.Area - 100 * width) < 1e-9]
                self.assertEqual(len(strips), 2)
                for face in strips:
                    count = np.count_nonzero(mesh.triangle_face == face)
                    self.assertGreater(count, least)
                    self.assertLess(count, 2.05 * least)

    def test_they_count_as_edges_where_keeping_them_costs_too_much(self):
        part = stairs(0.2)
        mesh = mq.triangulate(part, chord_height=0.8)
        report = mesh.report
        self.assertAlmostEqual(report.detail, 0.4)
        self.assertRegex(str(report.notes[0]), r"below 0\.4 mm are not told apart: with all of them the mesh had [\d,]+ triangles")
        self.assertLess(len(mesh.triangles), 20 * report.chord_triangles)
        self.assertTrue(report.closed and report.manifold and report.self_intersections == 0)
        self.assertEqual(report.exempt, [])
        self.assertLessEqual(report.max_chord_height, 0.8)
        for vertex in mesh.vertices + mesh.origin:
            self.assertLess(part.distToShape(Part.Vertex(*vertex))[0], 0.4)
        for vertex in part.Vertexes:
            self.assertLess(np.linalg.norm(mesh.vertices + mesh.origin - vertex.Point, axis=1).min(), 0.8)

    def test_not_where_they_show(self):
        report = mq.triangulate(stairs(0.5), chord_height=0.8).report
        self.assertLess(report.detail, 0.1)
        self.assertLess(report.max_chord_height, 1e-3)

    def test_not_where_sizes_ask_for_the_triangles(self):
        report = mq.triangulate(stairs(0.2, 40.0), chord_height=0.8, max_edge=1.0).report
        self.assertLess(report.detail, 0.1)


if __name__ == "__main__":
    unittest.main()
