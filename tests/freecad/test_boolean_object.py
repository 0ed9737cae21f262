# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Boolean": properties, recompute, undo, save and reload, sources, errors."""

import os

import FreeCAD
import helpers
import Mesh
import numpy as np

import MeshQuality as mq
from MeshQuality import options
from MeshQuality.cli import input_files


class BooleanObjectTest(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        self.cube = self.box("Cube", Length=2, Width=2, Height=2)
        self.tool = self.mesh("Tool", Mesh.createBox(1, 1, 1), (2, 2, 2))

    def mesh(self, name, mesh, base=(0, 0, 0)):
        obj = self.document.addObject("Mesh::Feature", name)
        obj.Mesh = mesh
        obj.Placement.Base = FreeCAD.Vector(*base)
        self.document.recompute()
        return obj


class Recompute(BooleanObjectTest):
    def test_it_holds_the_result_of_its_options(self):
        obj = mq.add_boolean(self.cube, self.tool, "difference", tolerance=0.01)
        expected = mq.boolean(self.cube, self.tool, "difference", tolerance=0.01)
        points, facets = helpers.points_and_facets(obj.Mesh)
        self.assertTrue(np.array_equal(points, expected.vertices))
        self.assertTrue(np.array_equal(facets, expected.triangles))
        self.assertEqual(obj.Sources, [self.cube, self.tool])
        self.assertEqual((obj.Operation, obj.Tolerance.Value), ("difference", 0.01))
        self.assertEqual(obj.Triangles, len(expected.triangles))
        self.assertEqual(obj.Retained, expected.report.retained)
        self.assertEqual(obj.Reconstructed, expected.report.reconstructed)
        self.assertAlmostEqual(obj.Volume.Value, 8 - 0.125, places=4)
        self.assertTrue(obj.Closed and obj.Oriented and obj.Manifold)
        self.assertEqual(obj.FaultsLeft, 0)
        self.assertEqual(list(obj.Notes), expected.report.notes)
        self.assertNotIn("Touched", obj.State)
        self.assertEqual(obj.Label, "Cube difference")

    def test_every_option_is_a_property(self):
        obj = mq.add_boolean(self.cube, self.tool, "union")
        for option in options.BOOLEAN:
            kind = obj.getTypeIdOfProperty(option.property_name)
            self.assertEqual(kind, option.property_type)
            self.assertTrue(obj.getDocumentationOfProperty(option.property_name))
        self.assertEqual(obj.getEnumerationsOfProperty("Operation"), list(options.OPERATIONS))
        self.assertEqual(obj.getEditorMode("Triangles"), ["ReadOnly"])

    def test_it_follows_every_source_and_option(self):
        obj = mq.add_boolean(self.cube, self.tool, "union")
        self.assertAlmostEqual(obj.Volume.Value, 8.875, places=4)
        self.cube.Height = 4
        self.document.recompute()
        self.assertAlmostEqual(obj.Volume.Value, 16.75, places=4)
        self.tool.Placement.Base.z = 4
        self.document.recompute()
        self.assertAlmostEqual(obj.Volume.Value, 16.875, places=4)
        obj.Operation = "intersection"
        self.document.recompute()
        self.assertAlmostEqual(obj.Volume.Value, 0.125, places=4)
        self.tool.Mesh = Mesh.createBox(0.5, 1, 1)
        self.tool.Placement.Base = FreeCAD.Vector(2, 2, 4)
        self.document.recompute()
        self.assertAlmostEqual(obj.Volume.Value, 0.0625, places=4)
        obj.Method, obj.Resolution = "uniform", 33
        self.document.recompute()
        self.assertGreater(obj.ErrorBound.Value, 0.0)

    def test_nothing_is_done_when_nothing_changed(self):
        obj = mq.add_boolean(self.cube, self.tool, "union")
        obj.Notes = ["kept while the mesh is"]
        self.cube.touch()
        self.document.recompute()
        self.assertEqual(obj.Notes, ["kept while the mesh is"])
        self.assertTrue(obj.isValid())

    def test_any_number_of_sources_and_booleans_of_booleans(self):
        far = self.mesh("Far", Mesh.createBox(1, 1, 1), (9, 9, 9))
        obj = mq.add_boolean([self.cube, self.tool, far], operation="union")
        self.assertAlmostEqual(obj.Volume.Value, 9.875, places=4)
        less = mq.add_boolean(obj, far, "difference")
        self.assertAlmostEqual(less.Volume.Value, 8.875, places=4)
        obj.Sources = [self.cube, far]
        self.document.recompute()
        self.assertAlmostEqual(less.Volume.Value, 8.0, places=4)

    def test_an_empty_result_is_legal(self):
        far = self.mesh("Far", Mesh.createBox(1, 1, 1), (9, 9, 9))
        obj = mq.add_boolean(self.cube, far, "intersection")
        self.assertEqual((obj.Triangles, obj.Mesh.CountFacets), (0, 0))
        self.assertTrue(any("empty" in note for note in obj.Notes))
        self.assertTrue(obj.isValid())
        far.Placement.Base = FreeCAD.Vector(2, 2, 2)
        self.document.recompute()
        self.assertAlmostEqual(obj.Volume.Value, 0.125, places=4)

    def test_an_error_keeps_the_last_good_mesh_and_says_why(self):
        obj = mq.add_boolean(self.cube, self.tool, "union")
        facets = obj.Mesh.CountFacets
        self.tool.Mesh = Mesh.createPlane(5, 5)
        self.document.recompute()
        self.assertFalse(obj.isValid())
        self.assertRegex(obj.getStatusString(), "'Tool' is an open surface")
        self.assertEqual(obj.Mesh.CountFacets, facets)
        self.tool.Mesh = Mesh.createBox(1, 1, 1)
        obj.Resolution = 3
        self.document.recompute()
        self.assertIn("resolution = 3", obj.getStatusString())
        obj.Resolution = 512
        obj.Sources = [self.cube]
        self.document.recompute()
        self.assertIn("Sources has 1", obj.getStatusString())
        obj.Sources = [self.cube, self.tool]
        self.document.recompute()
        self.assertTrue(obj.isValid())

    def test_a_uniform_boolean_keeps_the_tolerance_of_its_resolution(self):
        """The free cells around the operands are counted; what crosses is said."""
        for values in ({"resolution": 64}, {"resolution": 65}, {"tolerance": 0.05}):
            obj = mq.add_boolean(self.cube, self.tool, "union", method="uniform", **values)
            self.assertGreater(obj.ErrorBound.Value, 0.0)
            self.assertLessEqual(obj.ErrorBound.Value, obj.AskedTolerance.Value)
            self.assertNotIn("max. deviation", obj.Certificate)
            self.assertEqual("the surface intersects itself" in obj.Certificate, obj.FaultsLeft > 0)

    def test_the_label_follows_the_operation_unless_the_user_gave_one(self):
        obj, other = (mq.add_boolean(self.cube, self.tool, "intersection") for _ in range(2))
        other.Label = "Mine"
        for mesh in (obj, other):
            mq.update(mesh, operation="symmetric_difference")
        self.assertEqual((obj.Label, other.Label), (f"{self.cube.Label} symmetric difference", "Mine"))

    def test_repairs_are_shown(self):
        holed = Mesh.createSphere(1.0, 20)
        holed.removeFacets([50])
        obj = mq.add_boolean(self.cube, self.mesh("Holed", holed), "union")
        self.assertEqual(len(obj.Repaired), 1)
        self.assertIn("operand B", obj.Repaired[0])


class Undo(BooleanObjectTest):
    def test_one_step(self):
        before = list(self.document.UndoNames)
        obj = mq.add_boolean(self.cube, self.tool, "union")
        name, facets = obj.Name, obj.Mesh.CountFacets
        self.assertEqual(self.document.UndoNames, ["Boolean", *before])
        self.document.undo()
        self.assertIsNone(self.document.getObject(name))
        self.document.redo()
        self.assertEqual(self.document.getObject(name).Mesh.CountFacets, facets)

    def test_a_failure_leaves_nothing_behind(self):
        sheet = self.mesh("Sheet", Mesh.createPlane(5, 5))
        other = FreeCAD.newDocument("Other")
        self.names.append(other.Name)
        foreign = other.addObject("Part::Box", "Box")
        undo, objects = list(self.document.UndoNames), len(self.document.Objects)
        for sources, values, words in (
                ((self.cube, sheet), {}, "'Sheet' is an open surface"),
                ((self.cube, self.tool), {"tolerance": -1}, "tolerance"),
                ((self.cube, self.tool), {"tolerence": 1}, "tolerence"),
                ((self.cube, self.tool), {"operation": "cut"}, "difference"),
                ((self.cube, self.tool.Mesh), {}, "document objects"),
                ((self.cube, foreign), {}, "different documents"),
                (([self.cube],), {}, "two operands"),
                (([self.cube, self.tool], "union"), {}, "operation='union'")):
            with self.subTest(words), self.assertRaisesRegex(mq.InvalidInput, words):
                mq.add_boolean(*sources, **values)
        self.assertEqual(len(self.document.Objects), objects)
        self.assertEqual(self.document.UndoNames, undo)
        self.assertFalse(self.document.HasPendingTransaction)


class SaveAndReload(BooleanObjectTest):
    def test_mesh_options_and_proxy_come_back(self):
        obj = mq.add_boolean(self.cube, self.tool, "difference", resolution=100)
        points, facets = helpers.points_and_facets(obj.Mesh)
        name = obj.Name
        self.reopen()
        document = self.document
        again = document.getObject(name)
        self.assertEqual(type(again.Proxy).__module__, "MeshQuality.features.boolean")
        points_again, facets_again = helpers.points_and_facets(again.Mesh)
        self.assertTrue(np.array_equal(points, points_again))
        self.assertTrue(np.array_equal(facets, facets_again))
        self.assertEqual((again.Operation, again.Resolution), ("difference", 100))
        again.Notes = ["kept while the mesh is"]
        document.getObject("Cube").touch()
        document.recompute()
        self.assertEqual(again.Notes, ["kept while the mesh is"])
        document.getObject("Cube").Height = 9
        document.recompute()
        self.assertAlmostEqual(again.Mesh.BoundBox.ZLength, 9.0)

    def test_documents_of_older_versions_get_the_newer_properties(self):
        obj = mq.add_boolean(self.cube, self.tool, "union")
        obj.removeProperty("Method")
        obj.Proxy.onDocumentRestored(obj)
        self.assertEqual(obj.Method, "default")


class Sources(BooleanObjectTest):
    def test_links_and_objects_in_containers(self):
        part = self.document.addObject("App::Part", "Part")
        part.addObject(self.cube)
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = self.tool
        link.Placement.Base = FreeCAD.Vector(2, 2, 1)
        self.document.recompute()
        obj = mq.add_boolean(part, link, "union")
        self.assertAlmostEqual(obj.Volume.Value, 8.75, places=4)
        link.Placement.Base = FreeCAD.Vector(2, 2, 2)
        self.document.recompute()
        self.assertAlmostEqual(obj.Volume.Value, 8.875, places=4)


class OfContainers(BooleanObjectTest):
    """What a container shows is one operand: its shapes and its meshes."""

    def setUp(self):
        super().setUp()
        self.part = self.document.addObject("App::Part", "Part")
        inner = self.document.addObject("App::Part", "Inner")
        group = self.document.addObject("App::DocumentObjectGroup", "Group")
        self.tool.Placement.Base = FreeCAD.Vector(2, 2, 2)  # an eighth of it lies in the cube
        inner.Placement.Base = FreeCAD.Vector(0, 0, 0)
        group.addObject(self.tool)
        inner.addObject(group)
        self.part.addObject(self.cube)
        self.part.addObject(inner)
        self.part.Placement.Base = FreeCAD.Vector(100, 0, 0)
        self.other = self.box("Other", Length=1, Width=1, Height=1)
        self.other.Placement.Base = FreeCAD.Vector(110, 0, 0)
        self.document.recompute()
        self.whole = 8.0 + 1.0 - 0.125

    def union(self, operand, other=None):
        result = mq.boolean(operand, self.other if other is None else other, "union", tolerance=0.01)
        self.assertEqual(result.report.faults_left, 0)
        return result.report.volume - 1.0

    def test_shapes_and_meshes_are_joined(self):
        self.assertAlmostEqual(self.union(self.part), self.whole, places=4)
        self.assertAlmostEqual(self.union(self.other, self.part), self.whole, places=4)
        result = mq.boolean(self.part, self.other, "union", tolerance=0.01)
        self.assertAlmostEqual(result.vertices[:, 0].min() + result.origin[0], 100.0)
        self.assertIn("holds shapes and meshes: the mesh of the shapes deviates by", " ".join(result.report.notes))

    def test_meshes_alone_and_through_links(self):
        self.part.removeObject(self.cube)
        self.document.recompute()
        self.assertAlmostEqual(self.union(self.part), 1.0, places=5)
        self.part.addObject(self.cube)
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = self.part
        link.Placement.Base = FreeCAD.Vector(0, 50, 0)
        self.document.recompute()
        self.assertAlmostEqual(self.union(link), self.whole, places=4)
        result = mq.boolean(link, self.other, "union", tolerance=0.01)
        self.assertAlmostEqual(result.vertices[:, 1].max() + result.origin[1], 52.5)

    def test_what_is_hidden_does_not_count(self):
        self.tool.Visibility = False
        self.assertAlmostEqual(self.union(self.part), 8.0, places=4)
        self.tool.Visibility, self.cube.Visibility = True, False
        self.assertAlmostEqual(self.union(self.part), 1.0, places=4)

    def test_an_object_of_it_follows_both(self):
        obj = mq.add_boolean(self.part, self.other, "union", tolerance=0.01)
        self.assertAlmostEqual(obj.Volume.Value, self.whole + 1.0, places=4)
        self.tool.Mesh = Mesh.createBox(0.2, 0.2, 0.2)
        self.tool.Placement.Base = FreeCAD.Vector(1, 1, 1)
        self.document.recompute()
        self.assertAlmostEqual(obj.Volume.Value, 9.0, places=4)
        self.cube.Height = 4
        self.document.recompute()
        self.assertAlmostEqual(obj.Volume.Value, 17.0, places=4)
        held = obj.Fingerprint
        self.part.Placement.Base.y = 0.0
        obj.touch()
        self.document.recompute()
        self.assertEqual(obj.Fingerprint, held)

    def test_on_the_command_line(self):
        """With the object of a file, too."""
        path, other = os.path.join(self.folder, "parts.FCStd"), os.path.join(self.folder, "other.stl")
        self.other.Visibility = True
        Mesh.createBox(1, 1, 1).write(other)
        self.document.saveAs(path)
        sources = [input_files.read_operand(path, "Part"), input_files.read_operand(other)]
        result = mq.boolean(sources, operation="union", tolerance=0.01)
        self.assertAlmostEqual(result.report.volume, self.whole + 1.0, places=4)
        with self.assertRaisesRegex(mq.InvalidInput, "2 objects with shapes, and 'Part' holds meshes, too: choose one"):
            input_files.read_operand(path)
