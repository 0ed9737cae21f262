# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles that follow a metric: fewer of them, the distance and the largest angle held, entities kept, and what is refused."""

import unittest

import FreeCAD
import helpers
import numpy as np
import Part

import MeshQuality as mq


def largest_angles(mesh):
    """Degrees, by triangle, from the points alone."""
    corners = mesh.vertices[mesh.triangles]
    found = []
    for k in range(3):
        one, other = corners[:, k - 1] - corners[:, k], corners[:, k - 2] - corners[:, k]
        found.append(np.degrees(np.arctan2(np.linalg.norm(np.cross(one, other), axis=1), np.einsum("ij,ij->i", one, other))))
    return np.max(found, axis=0)


def along(x, y, z):
    """The metric of these three lengths along the axes, everywhere."""
    return lambda points: np.tile([x**-2.0, y**-2.0, z**-2.0, 0, 0, 0], (len(points), 1))


class ByCurvature(unittest.TestCase):
    def require_good(self, shape, share, **values):
        """The stretched mesh, with at most this fraction of the triangles of equal sides."""
        equal = mq.triangulate(shape, **values)
        found = mq.triangulate(shape, metric="curvature", **values)
        report = mq.quality(found, shape)
        self.assertTrue(report.closed and report.oriented and report.manifold)
        self.assertEqual(report.self_intersections, 0)
        self.assertLessEqual(report.max_chord_height, equal.report.chord_height_asked * (1 + 1e-6))
        self.assertLessEqual(max(helpers.distances_to_faces(shape, found)), equal.report.chord_height_asked * (1 + 1e-6))
        self.assertAlmostEqual(found.report.volume, shape.Volume, delta=0.01 * shape.Volume)
        self.assertLessEqual(largest_angles(found).max(), 150.01)
        self.assertAlmostEqual(found.largest_angle, largest_angles(found).max(), places=3)
        self.assertLessEqual(len(found.triangles), share * len(equal.triangles))
        self.assertLessEqual(np.mean(found.metric_quality < 0.3), 0.02)
        self.assertEqual(set(found.triangle_face.tolist()), set(range(len(shape.Faces))))
        return found

    def test_cylinder_needs_a_third(self):
        found = self.require_good(Part.makeCylinder(10, 40), 1 / 3, chord_height_relative=1e-3)
        points, entity = found.vertices + found.origin, found.vertex_entity
        on_edges = points[entity[:, 0] == 1]
        rims = (np.abs(np.hypot(on_edges[:, 0], on_edges[:, 1]) - 10) < 1e-5) & ((np.abs(on_edges[:, 2]) < 1e-5) | (np.abs(on_edges[:, 2] - 40) < 1e-5))
        seam = (np.abs(on_edges[:, 0] - 10) < 1e-5) & (np.abs(on_edges[:, 1]) < 1e-5)
        self.assertTrue((rims | seam).all())
        self.assertEqual((entity[:, 0] == 0).sum(), 2)

    def test_fillets_and_far_from_the_origin(self):
        shape = Part.makeBox(40, 30, 20, FreeCAD.Vector(1000, -500, 250))
        shape = shape.makeFillet(5, shape.Edges[:4])
        self.require_good(shape, 0.5, chord_height_relative=1e-3)

    def test_spline(self):
        circles = [Part.Wire(Part.makeCircle(r, FreeCAD.Vector(x, 0, z))) for r, x, z in ((5, 0, 0), (3, 1, 20), (4, 0, 60))]
        self.require_good(Part.makeLoft(circles, True), 0.45, chord_height_relative=1e-3)

    def test_cone_and_sphere_with_poles(self):
        self.require_good(Part.makeCone(10, 0, 30), 0.45, chord_height_relative=1e-3)
        self.require_good(Part.makeSphere(10), 1.0, chord_height_relative=3e-3)  # bends alike in all directions

    def test_open_sheet_keeps_its_border(self):
        sheet = Part.makeCylinder(10, 40).Faces[0]
        found = mq.triangulate(sheet, metric="curvature", chord_height_relative=1e-3)
        self.assertFalse(found.report.closed)
        sides = np.sort(np.stack([found.triangles, np.roll(found.triangles, -1, axis=1)], axis=-1).reshape(-1, 2), axis=1)
        ends, times = np.unique(sides, axis=0, return_counts=True)
        self.assertTrue((found.vertex_entity[ends[times == 1], 0] < 2).all())
        self.assertAlmostEqual(found.report.area, sheet.Area, delta=0.005 * sheet.Area)

    def test_quality_on_faces_narrower_than_the_lengths_wanted(self):
        """A washer of 10 mm with a wall of 1 mm: nothing stops edges of 9 mm along it but its width."""
        shape = Part.makeCylinder(10, 1.5).cut(Part.makeCylinder(9, 1.5))
        found = self.require_good(shape, 1.0, chord_height=0.05)
        self.assertGreaterEqual(found.metric_quality.min(), 0.3)

    def test_quality_beside_circles(self):
        found = self.require_good(Part.makeCylinder(10, 40), 1 / 3, chord_height_relative=1e-3)
        self.assertGreaterEqual(found.metric_quality.min(), 0.3)

    def test_bodies_that_touch(self):
        above, tube = Part.makeCylinder(10, 20, FreeCAD.Vector(0, 0, 20)), Part.makeCylinder(12, 20).cut(Part.makeCylinder(10, 20))
        for shape in (Part.makeCompound([Part.makeCylinder(10, 20), above]), Part.makeCompound([Part.makeCylinder(10, 20), tube])):
            equal = mq.triangulate(shape, chord_height_relative=1e-3)
            found = mq.triangulate(shape, metric="curvature", chord_height_relative=1e-3)
            self.assertLess(len(found.triangles), 0.4 * len(equal.triangles))
            self.assertTrue(found.report.closed)
            self.assertEqual(found.report.self_intersections, 0)
            self.assertGreater(mq.quality((found.vertices, found.triangles)).self_intersections, 0)  # this knows no bodies

    def test_where_stretched_ones_would_cross(self):
        """A wall of 0.1 mm at the side of a box, half the distance asked for: only there triangles keep equal sides."""
        box, at = Part.makeBox(30, 20, 20), FreeCAD.Vector(0, 10, 0)
        shape = box.fuse(Part.makeCylinder(6, 20, at)).cut(Part.makeCylinder(5.9, 20, at)).cut(Part.makeCylinder(4, 20, FreeCAD.Vector(18, 10, 0)))
        equal = mq.triangulate(shape, chord_height=0.2)
        found = mq.triangulate(shape, metric="curvature", chord_height=0.2)
        report = mq.quality(found, shape)
        self.assertEqual(report.self_intersections, 0)
        self.assertTrue(report.closed)
        self.assertLessEqual(report.max_chord_height, equal.report.chord_height_asked * (1 + 1e-6))
        self.assertIn("some triangles keep equal sides, as stretched ones would be too far from the shape, or cross", str(found.report.notes))
        bore = next(i for i, face in enumerate(shape.Faces) if isinstance(face.Surface, Part.Cylinder) and face.Surface.Radius == 4)
        self.assertNotIn(f"Face{bore + 1} ", str(found.report.notes).replace(",", " "))
        self.assertLess((found.triangle_face == bore).sum(), 0.7 * (equal.triangle_face == bore).sum())

    def test_same_bytes_and_names(self):
        shape = Part.makeCylinder(10, 40)
        one, other = (mq.triangulate(shape, metric="curvature", patches={"top": ["Face2"]}, patch_rest="rest") for _ in range(2))
        np.testing.assert_array_equal(one.vertices, other.vertices)
        np.testing.assert_array_equal(one.triangles, other.triangles)
        self.assertEqual(one.patches, ("top", "rest"))
        np.testing.assert_array_equal(one.triangle_patch == 0, one.triangle_face == 1)
        self.assertTrue((one.triangle_solid == 0).all())


class Given(unittest.TestCase):
    def test_lengths_follow_the_metric(self):
        found = mq.triangulate(Part.makeBox(32, 12, 16), metric=along(8.0, 2.0, 4.0))
        corners = found.vertices[found.triangles]
        sides = (np.roll(corners, -1, axis=1) - corners).reshape(-1, 3)
        lengths = np.linalg.norm(sides / [8.0, 2.0, 4.0], axis=1)
        self.assertLess(lengths.max(), 1.5)
        self.assertGreater(np.median(lengths), 0.6)
        self.assertLess(len(found.triangles), found.given_triangles / 2)
        self.assertLessEqual(largest_angles(found).max(), 150.01)
        self.assertAlmostEqual(found.report.volume, 6144.0, delta=1e-6 * 6144)

    def test_points_are_as_good_as_a_function(self):
        box = Part.makeBox(10, 4, 4)
        points = np.random.RandomState(1).rand(50, 3) * [10, 4, 4]
        found = mq.triangulate(box, metric=(points, along(4.0, 1.0, 1.0)(points)))
        np.testing.assert_array_equal(found.triangles, mq.triangulate(box, metric=along(4.0, 1.0, 1.0)).triangles)

    def test_stretching_is_bounded(self):
        box = Part.makeBox(10, 4, 4)
        few, many = (len(mq.triangulate(box, metric=along(8.0, 1.0, 1.0), max_stretching=limit).triangles) for limit in (8.0, 1.0))
        self.assertLess(few, many / 2)

    def test_refused_with_the_reason(self):
        box = Part.makeBox(20, 10, 10)
        for values, words in (
                ({"metric": "wind"}, "one of none, curvature"), ({"metric": 3}, "metric = int is not allowed"),
                ({"metric": lambda p: p}, "six numbers for each"), ({"metric": lambda p: np.full((len(p), 6), np.nan)}, "has no numbers"),
                ({"metric": along(1, 1, 1), "growth_rate": 1.2}, "growth_rate does not go with metric"),
                ({"metric": along(1, 1, 1), "size_field": 2.0}, "size_field does not go with metric"),
                ({"metric": "curvature", "chord_height": "none"}, "needs a bound on the distance"),
                ({"metric": (np.zeros((2, 3)), np.zeros((2, 5)))}, "(n, 6)"),
                ({"metric": lambda p: np.tile([-1.0, 1, 1, 0, 0, 0], (len(p), 1))}, "without negative eigenvalues"),
                ({"metric": along(1, 1, 1), "max_stretching": 0.5}, "max_stretching")):
            with self.subTest(words=words), self.assertRaises(mq.InvalidInput) as caught:
                mq.triangulate(box, **values)
            self.assertIn(words, str(caught.exception))

    def test_cancelled(self):
        def progress(_, stage):
            return stage != "stretching triangles"
        with self.assertRaises(mq.Cancelled):
            mq.triangulate(Part.makeCylinder(10, 40), metric="curvature", progress=progress)


class OfADocument(unittest.TestCase):
    def test_object_follows_its_source(self):
        document = FreeCAD.newDocument()
        self.addCleanup(FreeCAD.closeDocument, document.Name)
        source = document.addObject("Part::Cylinder", "Cylinder")
        document.recompute()
        mesh = mq.add_quality_mesh(source, metric="curvature", chord_height_relative=1e-3)
        before = mesh.Mesh.CountFacets
        equal = mq.triangulate(source, chord_height_relative=1e-3)
        self.assertLess(before, 0.6 * len(equal.triangles))
        source.Height = 40
        document.recompute()
        self.assertTrue(mesh.Mesh.isSolid())
        self.assertEqual(mesh.Metric, "curvature")
        self.assertAlmostEqual(mesh.Mesh.Volume, source.Shape.Volume, delta=0.03 * source.Shape.Volume)
