# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object: properties, recompute, undo, save and reload, sources of all kinds."""

import FreeCAD
import helpers
import numpy as np

import MeshQuality as mq
from MeshQuality import options
from MeshQuality.features import properties, quality_mesh


class Recompute(helpers.DocumentTest):
    def test_it_holds_the_mesh_of_its_options(self):
        box = self.box(Height=30)
        obj = mq.add_quality_mesh(box, min_angle=20, chord_height=0.1)
        expected = mq.triangulate(box, min_angle=20, chord_height=0.1)
        points, facets = helpers.points_and_facets(obj.Mesh)
        self.assertTrue(np.array_equal(points, expected.vertices))
        self.assertTrue(np.array_equal(facets, expected.triangles))
        self.assertEqual(obj.MinAngle.Value, 20.0)
        self.assertEqual(obj.ChordHeight.Value, 0.1)
        self.assertEqual(obj.Triangles, len(expected.triangles))
        self.assertAlmostEqual(obj.MeasuredMinAngle.Value, expected.report.min_angle)
        self.assertTrue(obj.Closed and obj.Oriented and obj.Manifold)
        self.assertEqual(obj.Mesh.countSegments(), 6)
        self.assertNotIn("Touched", obj.State)

    def test_every_option_is_a_property_with_its_unit(self):
        obj = mq.add_quality_mesh(self.box())
        for option in options.TRIANGULATE:
            kind = obj.getTypeIdOfProperty(option.property_name)
            self.assertEqual(kind, option.property_type)
            self.assertTrue(obj.getDocumentationOfProperty(option.property_name))
        self.assertEqual(obj.getGroupOfProperty("Triangles"), "Quality")
        self.assertEqual(obj.getEditorMode("Triangles"), ["ReadOnly"])

    def test_it_follows_the_source(self):
        box = self.box()
        obj = mq.add_quality_mesh(box)
        box.Height = 50
        self.document.recompute()
        self.assertAlmostEqual(obj.Mesh.BoundBox.ZLength, 50.0)

    def test_it_follows_an_option(self):
        obj = mq.add_quality_mesh(self.box())
        few = obj.Triangles
        obj.MaxEdge = 1.0
        self.document.recompute()
        self.assertGreater(obj.Triangles, few)

    def test_insertion_is_a_choice(self):
        cylinder = self.document.addObject("Part::Cylinder", "Cylinder")
        with self.assertRaisesRegex(mq.InvalidInput, "recompute"):
            mq.add_quality_mesh(cylinder)
        self.document.recompute()
        obj = mq.add_quality_mesh(cylinder, insertion="circumcentre")
        self.assertEqual(obj.Insertion, "circumcentre")
        self.assertEqual(obj.getEnumerationsOfProperty("Insertion"), ["off-centre", "circumcentre", "paper"])
        expected = mq.triangulate(cylinder, insertion="circumcentre")
        self.assertEqual(obj.Triangles, len(expected.triangles))
        fingerprint = obj.Fingerprint
        obj.Insertion = "off-centre"
        self.document.recompute()
        self.assertNotEqual(obj.Fingerprint, fingerprint)

    def test_nothing_is_done_when_nothing_changed(self):
        box = self.box()
        obj = mq.add_quality_mesh(box)
        mesh_before = obj.Mesh.copy()
        fingerprint = obj.Fingerprint
        obj.Notes = ["kept while the mesh is"]
        box.touch()
        self.document.recompute()
        self.assertEqual(obj.Notes, ["kept while the mesh is"])
        self.assertEqual(obj.Fingerprint, fingerprint)
        self.assertEqual(obj.Mesh.Topology[1], mesh_before.Topology[1])
        self.assertTrue(obj.isValid())

    def test_showing_the_source_changes_nothing(self):
        box = self.box()
        obj = mq.add_quality_mesh(box)
        before = obj.Fingerprint
        box.Shape.tessellate(0.1)
        self.assertEqual(quality_mesh.QualityMesh.work_on(
            [box], properties.options_of(obj, options.TRIANGULATE)).fingerprint, before)

    def test_errors_are_sentences_and_mark_the_object(self):
        obj = mq.add_quality_mesh(self.box())
        obj.MinAngle = 40
        self.document.recompute()
        self.assertFalse(obj.isValid())
        self.assertIn("min_angle = 40", obj.getStatusString())
        obj.MinAngle = 25
        self.document.recompute()
        self.assertTrue(obj.isValid())
        obj.Source = None
        self.document.recompute()
        self.assertIn("Source is empty", obj.getStatusString())


class Undo(helpers.DocumentTest):
    def test_one_step(self):
        box = self.box()
        before = list(self.document.UndoNames)
        obj = mq.add_quality_mesh(box)
        name, facets = obj.Name, obj.Mesh.CountFacets
        self.assertEqual(len(self.document.UndoNames), len(before) + 1)
        self.document.undo()
        self.assertIsNone(self.document.getObject(name))
        self.document.redo()
        self.assertEqual(self.document.getObject(name).Mesh.CountFacets, facets)

    def test_mesh_segments_and_placement_come_back(self):
        source = self.box()
        source.Placement.Base = FreeCAD.Vector(5000, 0, 0)
        self.document.recompute()
        obj = mq.add_quality_mesh(source)

        def state():
            return (str(obj.Mesh.Topology), obj.Placement.Base, obj.Fingerprint,
                    [obj.Mesh.getSegment(i) for i in range(obj.Mesh.countSegments())])

        before = state()
        mq.update(obj, max_edge=3.0)
        after = state()
        self.assertNotEqual(before, after)
        self.assertEqual(len(after[-1]), 6)
        for _ in range(2):
            self.document.undo()
            self.assertEqual(state(), before)
            self.document.redo()
            self.assertEqual(state(), after)
        self.document.openTransaction("given up")
        mq.update(obj, max_edge=2.0)
        self.document.abortTransaction()
        self.assertEqual(state(), after)

    def test_it_joins_an_open_transaction(self):
        box = self.box()
        self.document.openTransaction("Mine")
        mq.add_quality_mesh(box)
        self.assertTrue(self.document.HasPendingTransaction)
        self.document.commitTransaction()
        self.assertEqual(self.document.UndoNames[0], "Mine")

    def test_a_failure_leaves_nothing_behind(self):
        line = self.document.addObject("Part::Line", "Line")
        self.document.recompute()
        undo, objects = list(self.document.UndoNames), len(self.document.Objects)
        for source, values in ((line, {}), (self.box(), {"min_angle": 99}), (line.Shape, {}),
                               (line, {"min_angel": 3})):
            with self.assertRaises(mq.InvalidInput):
                mq.add_quality_mesh(source, **values)
        self.assertEqual(len(self.document.Objects), objects + 1)
        self.assertNotIn("Quality mesh", self.document.UndoNames[:-len(undo) or None])
        self.assertFalse(self.document.HasPendingTransaction)


class SaveAndReload(helpers.DocumentTest):
    def test_mesh_options_and_proxy_come_back(self):
        obj = mq.add_quality_mesh(self.box(), min_angle=28, max_edge=3.0)
        points, facets = helpers.points_and_facets(obj.Mesh)
        name = obj.Name
        self.reopen()
        document = self.document
        again = document.getObject(name)
        self.assertEqual(type(again.Proxy).__module__, "MeshQuality.features.quality_mesh")
        points_again, facets_again = helpers.points_and_facets(again.Mesh)
        self.assertTrue(np.array_equal(points, points_again))
        self.assertTrue(np.array_equal(facets, facets_again))
        self.assertEqual(again.MinAngle.Value, 28.0)
        self.assertEqual(again.Mesh.countSegments(), 6)
        self.assertEqual(again.getEditorMode("Fingerprint"), ["Hidden"])
        document.recompute()
        self.assertTrue(again.isValid())
        document.getObject("Box").Height = 77
        document.recompute()
        self.assertAlmostEqual(again.Mesh.BoundBox.ZLength, 77.0)

    def test_documents_of_older_versions_get_the_newer_properties(self):
        obj = mq.add_quality_mesh(self.box())
        obj.removeProperty("AllowMissingFaces")
        obj.Proxy.onDocumentRestored(obj)
        self.assertIs(obj.AllowMissingFaces, False)


class Sources(helpers.DocumentTest):
    def box_of(self, source):
        obj = mq.add_quality_mesh(source)
        box = obj.Mesh.BoundBox
        return [round(value, 5) for value in
                (box.XMin, box.YMin, box.ZMin, box.XMax, box.YMax, box.ZMax)]

    def test_placement(self):
        box = self.box(Length=1, Width=2, Height=3)
        box.Placement = FreeCAD.Placement(
            FreeCAD.Vector(10, 0, 0), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 90))
        self.document.recompute()
        self.assertEqual(self.box_of(box), [8, 0, 0, 10, 1, 3])

    def test_link(self):
        box = self.box(Length=1, Width=2, Height=3)
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = box
        link.Placement.Base = FreeCAD.Vector(0, 0, 50)
        self.document.recompute()
        self.assertEqual(self.box_of(link), [0, 0, 50, 1, 2, 53])

    def test_container_with_placements(self):
        first, second = self.box("First", Length=1, Width=1, Height=1), self.box(
            "Second", Length=1, Width=1, Height=1)
        second.Placement.Base = FreeCAD.Vector(5, 0, 0)
        part = self.document.addObject("App::Part", "Part")
        part.addObject(first)
        part.addObject(second)
        part.Placement.Base = FreeCAD.Vector(0, 100, 0)
        self.document.recompute()
        self.assertEqual(self.box_of(part), [0, 100, 0, 6, 101, 1])
        obj = self.document.Objects[-1]
        self.assertEqual(mq.quality(obj).components, 2)
        second.Height = 9
        self.document.recompute()
        self.assertAlmostEqual(obj.Mesh.BoundBox.ZMax, 9.0)

    def test_body(self):
        body = self.document.addObject("PartDesign::Body", "Body")
        pad = body.newObject("PartDesign::AdditiveBox", "Pad")
        pad.Length, pad.Width, pad.Height = 1, 2, 3
        self.document.recompute()
        self.assertEqual(self.box_of(body), [0, 0, 0, 1, 2, 3])

    def test_source_of_a_script(self):
        box = self.box(Length=1, Width=2, Height=3)
        mesh = mq.triangulate((box, "Face1"))
        self.assertFalse(mesh.report.closed)
        self.assertAlmostEqual(mesh.report.area, 6.0)
        mesh = mq.triangulate(box)
        self.assertAlmostEqual(mesh.report.volume, 6.0)
