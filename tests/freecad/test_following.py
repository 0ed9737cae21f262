# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes that are moved along with edits of their part: same triangles, bounds held, reasons, derivatives."""

import unittest

import FreeCAD
import helpers
import numpy as np
import Part

import MeshQuality as mq
from MeshQuality.core.following import angles as angles_of
from MeshQuality.core.following.moving import _harmonic


def plate(radius=6.0, length=40.0, at=20.0):
    return Part.makeBox(length, 30, 5).cut(Part.makeCylinder(radius, 20, FreeCAD.Vector(at, 15, -5)))


def loft(height=20.0):
    circles = [Part.Wire(Part.makeCircle(r, FreeCAD.Vector(x, 0, z))) for r, x, z in ((5, 0, 0), (3, 1, 10), (4, 0, height))]
    return Part.makeLoft(circles, True)


class Following(unittest.TestCase):
    def require_followed(self, mesh, shape, **values):
        found = mq.follow(mesh, shape, otherwise="refuse", **values)
        self.assertTrue(found.kept)
        self.assertEqual(found.reasons, [])
        np.testing.assert_array_equal(found.triangles, mesh.triangles)
        np.testing.assert_array_equal(found.triangle_face, mesh.triangle_face)
        np.testing.assert_array_equal(found.vertex_entity, mesh.vertex_entity)
        report = mq.quality(found, shape)
        self.assertTrue(report.closed and report.oriented and report.manifold)
        self.assertEqual(report.self_intersections, 0)
        self.assertGreaterEqual(helpers.smallest_angles(found).min(), values.get("min_angle", 25.0) - 1e-6)
        self.assertAlmostEqual(found.report.volume, shape.Volume, delta=0.03 * shape.Volume)
        bound = values.get("chord_height", mesh.report.chord_height_asked)
        self.assertLessEqual(report.max_chord_height, bound * (1 + 1e-6))
        self.assertLessEqual(max(helpers.distances_to_faces(shape, found)), bound * (1 + 1e-6))
        for (dimension, index), point in list(zip(found.vertex_entity.tolist(), found.vertices.tolist()))[::7]:
            entity = (shape.Vertexes, shape.Edges, shape.Faces)[dimension][index]
            self.assertLess(Part.Vertex(FreeCAD.Vector(*point)).distToShape(entity)[0], 1e-4)
        return found

    def test_planes_cylinders_and_splines_are_followed(self):
        for before, after in ((plate(), plate(6.2)), (plate(), plate(at=20.6)), (loft(), loft(20.4)),
                              (Part.makeSphere(5), Part.makeSphere(4.5)), (Part.makeTorus(10, 3), Part.makeTorus(9.8, 3)),
                              (Part.makeCone(5, 0, 10), Part.makeCone(5, 0, 10.3))):
            mesh = mq.triangulate(before)
            self.require_followed(mesh, after, min_angle=22.0, chord_height=1.3 * mesh.report.chord_height_asked)

    def test_a_mesh_that_followed_is_followed_again(self):
        mesh = mq.triangulate(plate(), patches={"hole": ["Face7"]})
        for length in (40.5, 41.0, 40.0):
            mesh = self.require_followed(mesh, plate(length=length), min_angle=20.0, chord_height=0.15)
        self.assertIn("hole", mesh.patches)

    def test_an_unchanged_part_keeps_its_points(self):
        mesh = mq.triangulate(loft())
        np.testing.assert_allclose(self.require_followed(mesh, loft()).vertices, mesh.vertices, atol=1e-5)

    def test_what_cannot_be_kept_is_meshed_again_with_the_reason(self):
        mesh = mq.triangulate(plate())
        for shape, said in ((plate().cut(Part.makeCylinder(2, 20, FreeCAD.Vector(5, 5, -5))), "faces now, it had 7"),
                            (plate(14.0), "Face\\d would (have an angle below 25 degrees|be turned over)")):
            found = mq.follow(mesh, shape)
            self.assertFalse(found.kept)
            self.assertRegex("; ".join(found.reasons), said)
            self.assertTrue(found.report.closed)
            self.assertAlmostEqual(found.report.volume, shape.Volume, delta=0.02 * shape.Volume)
            with self.assertRaisesRegex((mq.TopologyError, mq.GeometryError), said):
                mq.follow(mesh, shape, otherwise="refuse")
        ball = mq.triangulate(Part.makeSphere(5))
        self.assertRegex(mq.follow(ball, Part.makeSphere(9)).reasons[0], "the distance from the shape would be .* mm at Face1")
        self.assertTrue(mq.follow(ball, Part.makeSphere(9), chord_height=1.0).kept)
        self.assertRegex(mq.follow(ball, Part.makeTorus(9, 2)).reasons[0], "has|is a toroid now, it was a sphere")

    def test_a_lower_bound_keeps_more(self):
        mesh = mq.triangulate(plate())
        self.assertFalse(mq.follow(mesh, plate(length=50)).kept)
        self.require_followed(mesh, plate(length=50), min_angle=15.0, chord_height=0.2)

    def test_moved_points_bring_angles_back(self):
        mesh = mq.triangulate(loft())
        held = angles_of.Angles.improve
        angles_of.Angles.improve = lambda *_: None
        try:
            self.assertFalse(mq.follow(mesh, loft(22), chord_height=0.12).kept)
        finally:
            angles_of.Angles.improve = held
        self.require_followed(mesh, loft(22), chord_height=0.12)

    def test_values_inside_are_linear_where_those_at_the_border_are(self):
        points = np.array([(0, 0), (3, 0), (3, 2), (0, 2), (1, 0.7), (2, 1.2)], dtype=float)
        triangles = np.array([(0, 1, 4), (1, 5, 4), (1, 2, 5), (2, 3, 5), (3, 4, 5), (3, 0, 4)])
        sides = []
        for k in range(3):
            one, other = points[triangles[:, k - 2]] - points[triangles[:, k]], points[triangles[:, k - 1]] - points[triangles[:, k]]
            weight = 0.5 * np.einsum("ij,ij->i", one, other) / np.abs(one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0])
            sides.append((triangles[:, k - 2], triangles[:, k - 1], weight))
        fixed = np.array([True] * 4 + [False] * 2)
        values = points @ [2.0, -1.0]
        np.testing.assert_allclose(_harmonic(*map(np.concatenate, zip(*sides)), np.where(fixed, values, 7), fixed), values, atol=1e-9)

    def test_wrong_arguments_are_named(self):
        mesh = mq.triangulate(plate())
        for call, said in ((lambda: mq.follow(mesh, plate(), otherwise="stop"), "otherwise = 'stop' is not allowed"),
                           (lambda: mq.follow(mesh.to_mesh(), plate()), "needs a SurfaceMesh that triangulate made"),
                           (lambda: mq.follow(mesh, plate(), min_angle=50), "min_angle = 50"),
                           (lambda: mq.follow(mesh, plate(), progress=3), "is not callable")):
            with self.assertRaisesRegex(mq.InvalidInput, said):
                call()
        with self.assertRaises(mq.Cancelled):
            mq.follow(mesh, plate(6.2), progress=lambda *_: False)
        cut = mq.triangulate(plate(), keep_edges="feature")
        if cut.report.spanning:
            self.assertIn("keep_edges", mq.follow(cut, plate(6.1)).reasons[0])


class Sensitivities(helpers.DocumentTest):
    def test_of_a_function(self):
        mesh = mq.triangulate(plate())
        found = mq.sensitivity(mesh, lambda radius: plate(radius), 6.0)
        self.assertEqual(found.shape, mesh.vertices.shape)
        wall = np.asarray(mesh.vertex_entity)[:, 0] < 2
        offset = mesh.vertices[:, :2] - [20, 15]
        radius = np.linalg.norm(offset, axis=1)
        on_hole = wall & (abs(radius - 6) < 1e-4)
        self.assertGreater(on_hole.sum(), 20)
        np.testing.assert_allclose(found[on_hole][:, :2], offset[on_hole] / 6, atol=1e-5)
        np.testing.assert_allclose(found[wall & (radius > 7)], 0, atol=1e-6)

    def test_of_properties_of_the_document(self):
        box = self.document.addObject("Part::Box", "Box")
        sheet = self.document.addObject("Spreadsheet::Sheet", "Sheet")
        sheet.set("A1", "=20mm")
        sheet.setAlias("A1", "wide")
        self.document.recompute()
        box.setExpression("Width", "Sheet.wide")
        self.document.recompute()
        mesh = mq.triangulate(box)
        wanted = np.zeros_like(mesh.vertices)
        wanted[:, 0] = mesh.vertices[:, 0] / box.Length.Value
        np.testing.assert_allclose(mq.sensitivity(mesh, (box, "Length")), wanted, atol=1e-6)
        self.assertEqual(box.Length.Value, 10)
        found = mq.sensitivity(mesh, (sheet, "wide"), shape=box)
        np.testing.assert_allclose(found[:, 1], mesh.vertices[:, 1] / 20, atol=1e-6)
        self.assertEqual((sheet.getContents("A1").replace(" ", ""), box.Width.Value), ("=20mm", 20))
        for parameter, said in (((box, "Width"), "follows an expression"), ((box, "Depth"), "has no property Depth"),
                                ((box, "Label"), "is no number"), (3, "parameter = 3 is not allowed")):
            with self.assertRaisesRegex(mq.InvalidInput, said):
                mq.sensitivity(mesh, parameter)
        with self.assertRaisesRegex(mq.InvalidInput, "value= is needed"):
            mq.sensitivity(mesh, lambda value: None)
        with self.assertRaisesRegex(mq.TopologyError, "faces now, it had 6"):
            mq.sensitivity(mesh, lambda w: Part.makeBox(w, 20, 10).cut(Part.makeSphere(2)), 10.0)
