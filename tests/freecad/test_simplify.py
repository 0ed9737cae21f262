# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fewer triangles within a tolerance: proven both ways, without new faults, features kept."""

import unittest

import helpers
import numpy as np
import Part

import MeshQuality as mq


def fine(shape):
    return mq.triangulate(shape, chord_height_relative=5e-4, max_edge=shape.BoundBox.DiagonalLength / 20)


def samples(mesh):
    """float64 (n, 3): corners, middles of edges and more points of each triangle."""
    weights = np.array([(i, j, 4 - i - j) for i in range(5) for j in range(5 - i)]) / 4.0
    return np.einsum("ki,tij->tkj", weights, (mesh.vertices + mesh.origin)[mesh.triangles]).reshape(-1, 3)


class Simplify(unittest.TestCase):
    def test_distances_are_within_the_tolerance_both_ways(self):
        for name in ("cylinder", "cone", "fused", "torus"):
            shape = helpers.simple_parts()[name]
            with self.subTest(part=name):
                given = fine(shape)
                tolerance = 1e-3 * shape.BoundBox.DiagonalLength
                found = mq.simplify(given, tolerance=tolerance)
                report = found.report
                self.assertLess(report.triangles, 0.7 * given.report.triangles)
                self.assertTrue(report.closed and report.oriented and report.manifold)
                self.assertEqual(report.self_intersections, 0)
                self.assertEqual(report.vertices - report.triangles // 2, given.report.vertices - given.report.triangles // 2)
                self.assertLessEqual(found.deviation, tolerance)
                for one, other in ((found, given), (given, found)):
                    self.assertLessEqual(mq.deviation(samples(one), other).max_deviation, found.deviation * (1 + 1e-6) + 1e-6)

    def test_faces_with_planes_take_as_few_triangles_as_they_need(self):
        found = mq.simplify(fine(Part.makeBox(10, 20, 30)), tolerance=0.0375)
        self.assertEqual(found.report.triangles, 12)
        self.assertEqual(sorted(set(found.triangle_face.tolist())), [0, 1, 2, 3, 4, 5])
        self.assertAlmostEqual(found.report.volume, 6000.0, places=3)

    def test_sharp_edges_stay(self):
        shape = helpers.simple_parts()["fused"]
        given = fine(shape)
        found = mq.simplify(given, tolerance=0.04)
        edges = [edge.valueAt(t) for edge in shape.Edges if not edge.Degenerated
                 for t in np.linspace(edge.FirstParameter, edge.LastParameter, 20)]
        off = mq.deviation([tuple(point) for point in edges], found)
        self.assertLessEqual(off.max_deviation, found.deviation + given.report.max_chord_height + 1e-6)
        self.assertLess(found.report.triangles, 0.3 * given.report.triangles)

    def test_an_open_border_stays(self):
        closed = fine(Part.makeSphere(10))
        above = (closed.vertices[closed.triangles][:, :, 2] > 2.0).all(axis=1)
        given = (np.array(closed.vertices), closed.triangles[above])
        found = mq.simplify(given, tolerance=0.05)
        before = mq.quality(given)
        self.assertEqual(found.report.border_edges, before.border_edges)
        self.assertLess(found.report.triangles, 0.5 * before.triangles)
        self.assertTrue(found.report.manifold)

    def test_it_is_the_same_every_time(self):
        given = fine(Part.makeTorus(10, 3))
        first, second = (mq.simplify(given, tolerance=0.03) for _ in range(2))
        np.testing.assert_array_equal(first.triangles, second.triangles)
        np.testing.assert_array_equal(first.vertices, second.vertices)

    def test_what_cannot_be_is_refused(self):
        book = (np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (0, -1, 0)], dtype=float),
                np.array([(0, 1, 2), (0, 1, 3), (0, 1, 4)]))
        with self.assertRaisesRegex(mq.InvalidInput, "not manifold and oriented at 1 edges or triangles: repair it first"):
            mq.simplify(book, tolerance=0.1)
        with self.assertRaisesRegex(mq.InvalidInput, "tolerance"):
            mq.simplify(Part.makeBox(1, 1, 1).tessellate(0.1), tolerance=-1)
        with self.assertRaises(mq.Cancelled):
            mq.simplify(fine(Part.makeSphere(5)), tolerance=0.1, progress=lambda *_: False)
