# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Curved Mesh": properties, recompute, undo, save and reload, its elements."""

import os

import helpers
import numpy as np

import MeshQuality as mq
from MeshQuality import options
from MeshQuality.core.curving import ARRAYS


class CurvedObjectTest(helpers.DocumentTest):
    def cylinder(self, radius=5, height=10):
        obj = self.document.addObject("Part::Cylinder", "Cylinder")
        obj.Radius, obj.Height = radius, height
        self.document.recompute()
        return obj

    def assert_same_elements(self, one, other):
        self.assertEqual(one.order, other.order)
        for array in ARRAYS.values():
            np.testing.assert_array_equal(getattr(one._curved, array),
                                          getattr(other._curved, array), array)


class Recompute(CurvedObjectTest):
    def test_it_holds_the_elements_of_its_options(self):
        source = self.cylinder()
        obj = mq.add_curved_mesh(source, order=3, volume=True, deviation=0.01)
        expected = mq.curve(source, order=3, volume=True)
        self.assert_same_elements(mq.CurvedMesh.of(obj), expected)
        points, facets = helpers.points_and_facets(obj.Mesh)
        surface = expected.tessellate(0.01).surface()
        np.testing.assert_array_equal(points, surface.vertices)
        np.testing.assert_array_equal(facets, surface.triangles)
        report = expected.report
        self.assertEqual((obj.Elements, obj.Invalid), (len(expected.tetrahedra), 0))
        self.assertEqual(obj.MinScaledJacobian, report.min_scaled_jacobian)
        self.assertEqual(obj.MinDistortion, report.min_distortion)
        self.assertEqual(obj.MaxShapeDistortion, report.max_shape_distortion)
        self.assertEqual(obj.MaxDeviation.Value, report.max_deviation)
        self.assertEqual(obj.MovedVertices, 0)
        self.assertTrue(obj.Mesh.isSolid())
        self.assertEqual(obj.Mesh.countSegments(), 3)
        self.assertEqual(obj.Label, "Cylinder curved mesh")
        self.assertNotIn("Touched", obj.State)

    def test_every_option_is_a_property(self):
        obj = mq.add_curved_mesh(self.cylinder())
        for option in options.CURVE + options.CURVED_DISPLAY:
            kind = obj.getTypeIdOfProperty(option.property_name)
            self.assertEqual(kind, option.property_type)
            self.assertTrue(obj.getDocumentationOfProperty(option.property_name))
        self.assertEqual(obj.getGroupOfProperty("MinScaledJacobian"), "Quality")
        self.assertEqual(obj.getEditorMode("Invalid"), ["ReadOnly"])
        self.assertEqual(obj.getEditorMode("TriangleNodes"), ["Hidden"])

    def test_it_follows_source_and_options(self):
        source = self.cylinder()
        obj = mq.add_curved_mesh(source)
        self.assertAlmostEqual(obj.Mesh.BoundBox.ZLength, 10.0)
        source.Height = 20
        self.document.recompute()
        self.assertAlmostEqual(obj.Mesh.BoundBox.ZLength, 20.0)
        obj.Order = 4
        self.document.recompute()
        self.assertEqual(mq.CurvedMesh.of(obj).order, 4)
        self.assertLess(obj.MaxDeviation.Value, 1e-2)
        obj.Volume = True
        self.document.recompute()
        self.assertGreater(len(mq.CurvedMesh.of(obj).tetrahedra), 0)

    def test_another_deviation_cuts_the_same_elements(self):
        obj = mq.add_curved_mesh(self.cylinder(), deviation=0.1)
        coarse, elements = obj.Mesh.CountFacets, mq.CurvedMesh.of(obj)
        obj.Notes = ["kept while the elements are"]
        obj.Deviation = 0.001
        self.document.recompute()
        self.assertGreater(obj.Mesh.CountFacets, 3 * coarse)
        self.assertEqual(obj.Notes, ["kept while the elements are"])
        self.assert_same_elements(mq.CurvedMesh.of(obj), elements)
        self.assertAlmostEqual(obj.ShownDeviation.Value, 0.001)

    def test_an_error_keeps_the_last_good_mesh_and_says_why(self):
        obj = mq.add_curved_mesh(self.cylinder())
        facets = obj.Mesh.CountFacets
        obj.Order = 6
        self.document.recompute()
        self.assertFalse(obj.isValid())
        self.assertIn("order = 6", obj.getStatusString())
        obj.Order, obj.Volume = 5, True
        self.document.recompute()
        self.assertIn("order is 5", obj.getStatusString())
        obj.Order, obj.Volume = 2, False
        obj.Source = None
        self.document.recompute()
        self.assertIn("Source is empty", obj.getStatusString())
        self.assertEqual(obj.Mesh.CountFacets, facets)


class Undo(CurvedObjectTest):
    def test_one_step(self):
        source = self.cylinder()
        before = list(self.document.UndoNames)
        obj = mq.add_curved_mesh(source)
        name, elements = obj.Name, mq.CurvedMesh.of(obj)
        self.assertEqual(self.document.UndoNames, ["Curved mesh", *before])
        self.document.undo()
        self.assertIsNone(self.document.getObject(name))
        self.document.redo()
        self.assert_same_elements(mq.CurvedMesh.of(self.document.getObject(name)), elements)

    def test_a_failure_leaves_nothing_behind(self):
        source = self.cylinder()
        objects = len(self.document.Objects)
        for values, words in (({"order": 0}, "order"), ({"deviation": -1}, "deviation"),
                              ({"ordre": 2}, "ordre"), ({"order": 5, "volume": True}, "order")):
            with self.subTest(words), self.assertRaisesRegex(mq.InvalidInput, words):
                mq.add_curved_mesh(source, **values)
        with self.assertRaisesRegex(mq.InvalidInput, "document object"):
            mq.add_curved_mesh(source.Shape)
        self.assertEqual(len(self.document.Objects), objects)
        self.assertFalse(self.document.HasPendingTransaction)


class SaveAndReload(CurvedObjectTest):
    def test_elements_mesh_and_options_come_back(self):
        obj = mq.add_curved_mesh(self.cylinder(), order=3, volume=True, deviation=0.02)
        elements, quality = mq.CurvedMesh.of(obj), obj.MinDistortion
        points, facets = helpers.points_and_facets(obj.Mesh)
        name = obj.Name
        self.reopen()
        document = self.document
        again = document.getObject(name)
        self.assertEqual(type(again.Proxy).__module__, "MeshQuality.features.curved_mesh")
        self.assert_same_elements(mq.CurvedMesh.of(again), elements)
        points_again, facets_again = helpers.points_and_facets(again.Mesh)
        np.testing.assert_array_equal(points_again, points)
        np.testing.assert_array_equal(facets_again, facets)
        self.assertEqual(again.Mesh.countSegments(), 3)
        self.assertEqual((again.Order, again.Volume, again.Deviation.Value), (3, True, 0.02))
        self.assertEqual(again.MinDistortion, quality)
        written = os.path.join(self.folder, "again.msh")
        mq.CurvedMesh.of(again).write(written)
        self.assertGreater(os.path.getsize(written), 10000)
        again.Notes = ["kept while the mesh is"]
        document.getObject("Cylinder").touch()
        document.recompute()
        self.assertEqual(again.Notes, ["kept while the mesh is"])

    def test_documents_of_older_versions_get_the_newer_properties(self):
        obj = mq.add_curved_mesh(self.cylinder())
        obj.removeProperty("Deviation")
        obj.Proxy.onDocumentRestored(obj)
        self.assertEqual(obj.Deviation.Value, 0.0)


class Elements(CurvedObjectTest):
    def test_only_curved_mesh_objects_have_some(self):
        with self.assertRaisesRegex(mq.InvalidInput, "Cylinder.*add_curved_mesh"):
            mq.CurvedMesh.of(self.cylinder())

    def test_a_damaged_document_is_refused(self):
        obj = mq.add_curved_mesh(self.cylinder())
        obj.TriangleNodes = obj.TriangleNodes[:-1]
        with self.assertRaisesRegex(mq.InvalidInput, "triangles"):
            mq.CurvedMesh.of(obj)
        obj.TriangleNodes = [*obj.TriangleNodes, 1e6]
        with self.assertRaisesRegex(mq.InvalidInput, "node 1000000"):
            mq.CurvedMesh.of(obj)

    def test_report_and_quality(self):
        source = self.cylinder()
        mesh = mq.curve(source, volume=True)
        self.assertIsNone(mq.CurvedMesh.of(mq.add_curved_mesh(source)).report)
        self.assertEqual(mesh.tetrahedron_quality.min(), mesh.report.min_scaled_jacobian)
        self.assertEqual(len(mesh.shown_quality), len(mesh.triangles))
        self.assertTrue(set(mesh.shown_quality) <= set(mesh.tetrahedron_quality))
        surface = mq.curve(source)
        np.testing.assert_array_equal(surface.shown_quality, surface.triangle_quality)
