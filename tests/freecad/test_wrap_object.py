# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Wrap": properties, recompute, undo, save and reload, containers, errors."""

import os
import tempfile
import unittest

import FreeCAD
import helpers
import Mesh
import numpy as np
import Part
import test_patches

import MeshQuality as mq
from MeshQuality import options
from MeshQuality.core.patches.patch_names import suggested_for
from MeshQuality.core.patches.source_faces import own_names
from MeshQuality.features.export import flat_maker_of

GAP, TOLERANCE = 2.0, 1.0
WIDTH = 0.4  # of the crack between both cubes


class WrapTest(helpers.DocumentTest):
    """Two cubes with a crack between them: one of shape, one of triangles."""

    def setUp(self):
        super().setUp()
        self.cube = self.box("Cube", Length=10, Width=10, Height=10)
        self.other = self.mesh("Other", Mesh.createBox(10, 10, 10), (15 + WIDTH, 5, 5))

    def mesh(self, name, mesh, base=(0, 0, 0)):
        obj = self.document.addObject("Mesh::Feature", name)
        obj.Mesh = mesh
        obj.Placement.Base = FreeCAD.Vector(*base)
        self.document.recompute()
        return obj

    def added(self, sources=None):
        return mq.add_wrap(sources or [self.cube, self.other], GAP, TOLERANCE)


class Recompute(WrapTest):
    def test_it_holds_the_result_of_its_options(self):
        obj = self.added()
        expected = mq.wrap([self.cube, self.other], GAP, TOLERANCE)
        points, facets = helpers.points_and_facets(obj.Mesh)
        self.assertTrue(np.array_equal(points, expected.vertices.astype(np.float32)))
        self.assertTrue(np.array_equal(facets, expected.triangles))
        self.assertEqual((obj.Sources, obj.Gap.Value, obj.Tolerance.Value), ([self.cube, self.other], GAP, TOLERANCE))
        self.assertEqual((obj.Triangles, obj.GapTriangles), (len(expected.triangles), expected.gap_triangles))
        self.assertAlmostEqual(obj.GapArea.Value, expected.gap_area, places=6)
        self.assertAlmostEqual(obj.DistanceToInput.Value, expected.distance_to_input, places=9)
        self.assertAlmostEqual(obj.DistanceFromInput.Value, expected.distance_from_input, places=9)
        self.assertEqual((obj.AskedTolerance.Value, obj.FaultsLeft, list(obj.Notes)), (TOLERANCE, 0, []))
        self.assertTrue(obj.Closed and obj.Oriented and obj.Manifold and obj.Mesh.isSolid())
        self.assertEqual((obj.Certificate, obj.Status, obj.Label), ("met", "up to date", "Cube wrap"))
        self.assertNotIn("Touched", obj.State)

    def test_what_it_measures_is_what_it_is(self):
        obj = self.added()
        self.assertAlmostEqual(obj.Volume.Value, 2000 + 100 * WIDTH, delta=10.0)
        # Four strips as wide as the crack, and the slopes beside them.
        self.assertTrue(4 * 10 * WIDTH < obj.GapArea.Value < 4 * 10 * (WIDTH + 0.5))
        self.assertGreater(obj.GapTriangles, 0)
        self.assertGreater(obj.DistanceToInput.Value, 0.0)
        self.assertGreater(obj.DistanceFromInput.Value, 0.0)
        self.assertAlmostEqual(obj.ErrorBound.Value, max(obj.DistanceToInput.Value, obj.DistanceFromInput.Value), delta=1e-4)
        self.assertLessEqual(obj.ErrorBound.Value, obj.AskedTolerance.Value)
        points, _ = helpers.points_and_facets(obj.Mesh)
        outside = np.maximum(points - (20 + WIDTH, 10, 10), -points).max(axis=1)
        self.assertLessEqual(outside.max(), obj.DistanceToInput.Value + 1e-4)

    def test_every_option_is_a_property_and_the_others_are_those_of_a_wrap(self):
        obj = self.added(self.cube)
        for option in options.wrap.WRAP_OBJECT:
            self.assertEqual(obj.getTypeIdOfProperty(option.property_name), option.property_type)
            self.assertTrue(obj.getDocumentationOfProperty(option.property_name))
        self.assertEqual({obj.getGroupOfProperty(name) for name in ("Sources", "Gap", "Tolerance")}, {"Wrap"})
        for name in ("Sources", "GapTriangles", "GapArea", "DistanceToInput", "DistanceFromInput", "AskedTolerance",
                     "ErrorBound"):
            self.assertNotRegex(obj.getDocumentationOfProperty(name), "operand|Boolean")
        self.assertEqual(obj.getEditorMode("GapArea"), ["ReadOnly"])
        for name in ("Retained", "Reconstructed", "Repaired", "Operation"):
            self.assertNotIn(name, obj.PropertiesList)

    def test_it_follows_every_source_and_option(self):
        obj = self.added()
        self.cube.Height = 5
        self.document.recompute()
        self.assertAlmostEqual(obj.Volume.Value, 1500 + 50 * WIDTH, delta=20.0)
        self.other.Placement.Base.x = 20  # the crack is 5 mm wide now
        self.document.recompute()
        self.assertEqual((obj.GapTriangles, obj.GapArea.Value), (0, 0.0))
        self.assertAlmostEqual(obj.Volume.Value, 1500, delta=10.0)
        mq.update(obj, tolerance=0.5)
        self.assertEqual((self.document.UndoNames[0], obj.AskedTolerance.Value), ("Update Cube wrap", 0.5))
        obj.Gap, self.cube.Height = 8, 10
        self.document.recompute()
        self.assertGreater(obj.GapTriangles, 0)
        self.assertGreater(obj.Volume.Value, 2100)
        obj.Sources = [self.other]
        self.document.recompute()
        self.assertAlmostEqual(obj.Volume.Value, 1000, delta=10.0)

    def test_one_source_and_wraps_of_wraps(self):
        obj = self.added(self.cube)
        self.assertEqual((obj.Sources, obj.GapTriangles), ([self.cube], 0))
        self.assertAlmostEqual(obj.Volume.Value, 1000, delta=2.0)
        both = self.added([obj, self.other])
        self.assertAlmostEqual(both.Volume.Value, 2000 + 100 * WIDTH, delta=15.0)
        self.cube.Width = 5
        self.document.recompute()
        self.assertAlmostEqual(both.Volume.Value, 1500 + 50 * WIDTH, delta=15.0)

    def test_nothing_is_done_when_nothing_changed(self):
        obj = self.added()
        obj.Notes = ["kept while the mesh is"]
        self.cube.touch()
        self.document.recompute()
        self.assertEqual(obj.Notes, ["kept while the mesh is"])
        self.assertTrue(obj.isValid())

    def test_what_is_open_and_turned_over_is_wrapped(self):
        open_box = Mesh.createBox(10, 10, 10)
        open_box.removeFacets([facet.Index for facet in open_box.Facets if facet.Normal.z > 0.9])
        lid = Mesh.createBox(10, 10, 2)
        lid.translate(0, 0, 6.2)
        lid.flipNormals()
        obj = self.added([self.mesh("Open", open_box), self.mesh("Lid", lid)])
        self.assertTrue(obj.Closed and obj.Manifold)
        self.assertAlmostEqual(obj.Volume.Value, 10 * 10 * 12.2, delta=20.0)
        self.assertGreater(obj.GapArea.Value, 4 * 10 * 0.2)
        self.assertEqual(obj.Certificate, "met")

    def test_an_error_keeps_the_last_good_mesh_and_says_why(self):
        obj = self.added()
        facets = obj.Mesh.CountFacets
        for name, value, words in (("Gap", 0, "gap is 0: give a length"),
                                   ("Tolerance", 1.5, "tolerance is 1.5 mm: at most half of the gap of 2 mm is possible"),
                                   ("Sources", [], "Sources is empty: choose objects with a mesh or a shape")):
            held = getattr(obj, name)
            setattr(obj, name, value)
            self.document.recompute()
            self.assertFalse(obj.isValid(), name)
            self.assertRegex(obj.getStatusString(), words)
            self.assertEqual(obj.Mesh.CountFacets, facets)
            setattr(obj, name, held)
            self.document.recompute()
            self.assertTrue(obj.isValid())

    def test_a_source_that_is_deleted(self):
        obj = self.added()
        self.document.removeObject(self.other.Name)
        self.document.recompute()  # FreeCAD takes it out of the list
        self.assertTrue(obj.isValid())
        self.assertAlmostEqual(obj.Volume.Value, 1000, delta=2.0)
        facets = obj.Mesh.CountFacets
        self.document.removeObject(self.cube.Name)
        self.document.recompute()
        self.assertEqual(obj.Status, "out of date: the source was deleted")
        self.assertEqual(obj.Mesh.CountFacets, facets)


class Containers(WrapTest):
    def setUp(self):
        super().setUp()
        self.outer, self.inner = (self.document.addObject("App::Part", name) for name in ("Assembly", "Inner"))
        self.inner.addObject(self.other)
        self.outer.addObjects([self.cube, self.inner])
        self.outer.Placement = FreeCAD.Placement(FreeCAD.Vector(0, 0, 50), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 90))
        self.document.recompute()

    def require_in_place(self, obj):
        self.assertAlmostEqual(obj.Volume.Value, 2000 + 100 * WIDTH, delta=10.0)
        centre = obj.Mesh.BoundBox.Center
        for value, expected in zip(centre, (-5.0, 10.2, 55.0)):
            self.assertAlmostEqual(value, expected, delta=0.2)

    def test_an_assembly_is_one_source(self):
        obj = self.added(self.outer)
        self.assertEqual((obj.Sources, obj.Label), ([self.outer], "Assembly wrap"))
        self.require_in_place(obj)
        self.cube.Height = 5
        self.document.recompute()
        self.assertAlmostEqual(obj.Volume.Value, 1500 + 50 * WIDTH, delta=20.0)

    def test_sources_in_containers_are_where_the_document_has_them(self):
        obj = self.added()
        self.require_in_place(obj)
        self.inner.Placement.Base.x = 10  # one of them moves against the other
        self.document.recompute()
        self.assertEqual(obj.GapTriangles, 0)
        self.assertAlmostEqual(obj.Volume.Value, 2000, delta=10.0)

    def test_a_moved_assembly_takes_it_along_without_new_work(self):
        obj = self.added()
        held, obj.Notes, before = obj.Fingerprint, ["kept while the mesh is"], obj.Mesh.BoundBox.Center
        self.outer.Placement.Base.y += 30
        self.document.recompute()
        self.assertEqual((obj.Fingerprint, obj.Notes), (held, ["kept while the mesh is"]))
        self.assertAlmostEqual((obj.Mesh.BoundBox.Center - before).y, 30.0, places=4)

    def test_links_and_what_is_hidden(self):
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = self.cube
        link.Placement.Base = FreeCAD.Vector(0, 0, 10 + WIDTH)
        self.document.recompute()
        obj = self.added([self.cube, link])
        self.assertEqual(obj.Sources, [self.cube, link])
        self.other.Visibility = False
        hidden = self.added(self.outer)
        self.assertAlmostEqual(hidden.Volume.Value, 1000, delta=2.0)
        self.assertRegex(" ".join(hidden.Notes), "Other.*hidden|hidden.*Other")


class Undo(WrapTest):
    def test_one_step(self):
        before = list(self.document.UndoNames)
        obj = self.added()
        name, facets = obj.Name, obj.Mesh.CountFacets
        self.assertEqual(self.document.UndoNames, ["Wrap", *before])
        self.document.undo()
        self.assertIsNone(self.document.getObject(name))
        self.document.redo()
        self.assertEqual(self.document.getObject(name).Mesh.CountFacets, facets)

    def test_a_failure_leaves_nothing_behind(self):
        other = FreeCAD.newDocument("Other")
        self.names.append(other.Name)
        foreign = other.addObject("Part::Box", "Box")
        empty = self.document.addObject("Mesh::Feature", "Empty")
        undo, objects = list(self.document.UndoNames), len(self.document.Objects)
        both = [self.cube, self.other]
        for arguments, words in (((both, None), "gap is 0: give a length"), ((both, 0.0), "gap"), ((both, -1.0), "gap"),
                                 ((both, float("nan")), "gap = nan"), ((both, 1.0, -1), "tolerance"),
                                 ((both, 1.0, 0.8), "at most half of the gap of 1 mm"), (([], 1.0), "list of objects is empty"),
                                 (([self.cube, foreign], 1.0), "different documents"),
                                 ((self.cube.Shape, 1.0), "document objects"), (([self.cube, 5], 1.0), "document objects"),
                                 ((empty, 1.0), "nothing to wrap")):
            with self.subTest(words), self.assertRaisesRegex(mq.InvalidInput, words):
                mq.add_wrap(*arguments)
        self.assertEqual(len(self.document.Objects), objects)
        self.assertEqual(self.document.UndoNames, undo)
        self.assertFalse(self.document.HasPendingTransaction)


class SaveAndReload(WrapTest):
    def test_mesh_options_and_proxy_come_back(self):
        obj = self.added()
        points, facets = helpers.points_and_facets(obj.Mesh)
        name, distance, measured = obj.Name, obj.DistanceToInput.Value, (obj.GapTriangles, obj.Triangles, obj.Certificate)
        self.reopen()
        again = self.document.getObject(name)
        self.assertEqual(type(again.Proxy).__module__, "MeshQuality.features.wrap")
        points_again, facets_again = helpers.points_and_facets(again.Mesh)
        self.assertTrue(np.array_equal(points, points_again))
        self.assertTrue(np.array_equal(facets, facets_again))
        self.assertEqual((again.Gap.Value, again.Tolerance.Value), (GAP, TOLERANCE))
        self.assertEqual((again.GapTriangles, again.Triangles, again.Certificate), measured)
        self.assertAlmostEqual(again.DistanceToInput.Value, distance, places=9)
        again.Notes = ["kept while the mesh is"]
        self.document.getObject("Cube").touch()
        self.document.recompute()
        self.assertEqual(again.Notes, ["kept while the mesh is"])
        self.document.getObject("Cube").Height = 5
        self.document.recompute()
        self.assertAlmostEqual(again.Volume.Value, 1500 + 50 * WIDTH, delta=20.0)


class OwnNames(unittest.TestCase):
    def test_labels_that_look_alike(self):
        for labels, counts in ((("Box", "Box", "Box_1"), (2, 1, 1)), (("Box", "Box_Face1"), (1, None)),
                               (("Bö", "B_", "B²"), (1, 1, None))):
            names = own_names(labels, counts)
            self.assertEqual(len(names), sum(1 if count is None else count for count in counts))
            self.assertEqual(len(set(names)), len(names), names)
            self.assertRegex(" ".join(names), r"^[A-Za-z0-9_ ]+$")


class Patches(WrapTest):
    """By the faces of several sources; a mesh is one, and what closes gaps another."""

    CUBE = [f"Cube_Face{k}" for k in range(1, 7)]

    def exported(self, obj, **given):
        """The names of the solids of an STL file."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "wrap.stl")
            mq.export_mesh(obj, path, ascii=True, **given)
            with open(path, encoding="ascii") as file:
                return [line.split(None, 1)[1].strip() for line in file if line.startswith("solid")]

    def triangles_in(self, obj, patches):
        """By patch the corners of its triangles in the mesh that is exported."""
        mesh = flat_maker_of(obj)()
        corners = (mesh.vertices + mesh.origin)[mesh.triangles]
        return {name: corners[mesh.triangle_patch == mesh.patches.index(name)] for name in patches}

    def test_without_names_they_are_those_of_wrap(self):
        obj = self.added()
        wrapped = mq.wrap([self.cube, self.other], GAP, TOLERANCE)
        self.assertIn("gaps", wrapped.patches)
        self.assertIn("Other", wrapped.patches)
        self.assertLess(set(self.CUBE), {*wrapped.patches, "Cube_Face2"})
        mesh = flat_maker_of(obj)()
        self.assertEqual(mesh.patches, wrapped.patches)
        self.assertTrue(np.array_equal(mesh.triangle_patch, wrapped.triangle_patch))
        self.assertEqual(self.exported(obj), list(wrapped.patches))

    def test_names_are_kept_and_written(self):
        obj = self.added()
        mq.set_patches(obj, {"inlet": {"faces": ["Cube.Face1"], "colour": "#ff0000"}, "scan": ["Other"],
                             "leaks": ["gaps"]}, patch_rest="walls")
        self.assertEqual(self.document.UndoNames[0], "Patches of Cube wrap")
        self.assertEqual(list(obj.Patches), ["inlet #ff0000: Cube.Face1", "scan: Other", "leaks: gaps"])
        found = self.triangles_in(obj, ("inlet", "scan", "leaks", "walls"))
        self.assertLess(np.abs(found["inlet"][..., 0]).max(), 0.01)  # Face1 of a box is at x = 0
        self.assertGreater(found["scan"][..., 0].min(), 10)  # the crack ends at 10 + WIDTH
        self.assertEqual(len(found["leaks"]), obj.GapTriangles)
        self.assertEqual(set(self.exported(obj)), {"inlet", "scan", "leaks", "walls"})
        self.document.undo()
        self.assertEqual((list(obj.Patches), obj.PatchRest), ([], ""))

    def test_faces_by_any_of_their_names(self):
        obj = self.added()
        mq.set_patches(obj, {"a": ["Face1", "Cube_Face3", "Cube.Face4"], "b": ["Face7"]})
        self.assertEqual(list(obj.Patches), ["a: Cube.Face1, Cube.Face3, Cube.Face4", "b: Other"])
        self.assertEqual(self.exported(obj)[:2], ["a", "b"])

    def test_errors_name_patch_face_and_remedy(self):
        obj = self.added()
        for patches, words in (({"a": ["Cube.Face9"]}, "Cube.Face9"), ({"a": ["Face8"]}, "Face8"),
                               ({"a": ["Sphere.Face1"]}, "Sphere.Face1.*does not hold"),
                               ({"a": ["nothing"]}, "'nothing', which is no face"),
                               ({"a": ["Cube.Face1", "Face1"]}, "Face1 is twice"),
                               ({"Cube_Face2": ["Cube.Face1"]}, "name of a face that is in no patch"),
                               ({"a": ["Other.Face1"]}, "Other.Face1")):
            with self.subTest(words), self.assertRaisesRegex(mq.InvalidInput, words):
                mq.set_patches(obj, patches)
                flat_maker_of(obj)()
                self.fail("no error")
        self.assertEqual(obj.PatchesChanged, [])

    def test_they_follow_recompute_and_other_sources(self):
        obj = self.added()
        mq.set_patches(obj, {"inlet": ["Cube.Face1"], "scan": ["Other"]}, patch_rest="walls")
        self.cube.Height = 6
        self.document.recompute()
        self.assertEqual((obj.Status, list(obj.PatchesChanged)), ("up to date", []))
        self.assertLess(np.abs(self.triangles_in(obj, ["inlet"])["inlet"][..., 0]).max(), obj.ErrorBound.Value)
        third = self.box("Third", Length=4, Width=4, Height=4)
        third.Placement.Base = FreeCAD.Vector(30, 0, 0)
        obj.Sources = [third, self.other, self.cube]
        self.document.recompute()
        self.assertEqual(list(obj.Patches), ["inlet: Cube.Face1", "scan: Other"])
        found = self.triangles_in(obj, ("inlet", "scan"))
        self.assertLess(np.abs(found["inlet"][..., 0]).max(), obj.ErrorBound.Value)
        self.assertTrue((found["scan"][..., 0] > 10).all() and (found["scan"][..., 0] < 21).all())

    def test_faces_that_an_edit_exchanges_are_found_again_or_named(self):
        feature = self.document.addObject("Part::Feature", "Solid")
        feature.Shape = Part.makeBox(10, 10, 10)
        obj = self.added([feature, self.other])
        mq.set_patches(obj, {"side": ["Solid.Face1"], "top": ["Solid.Face6"]}, patch_rest="walls")
        feature.Shape = Part.makeBox(10, 10, 10).cut(Part.makeCylinder(2, 20, FreeCAD.Vector(5, 5, 5)))  # through the top
        self.document.recompute()
        side = self.triangles_in(obj, ["side"])["side"]
        self.assertLess(np.abs(side[..., 0]).max(), 0.01)
        self.assertEqual([text for text in obj.PatchesChanged if "top" in text], list(obj.PatchesChanged))
        self.assertEqual(len(obj.PatchesChanged), 1)

    def test_a_source_that_is_gone_is_named(self):
        obj = self.added()
        mq.set_patches(obj, {"scan": ["Other"]}, patch_rest="walls")
        obj.Sources = [self.cube]
        self.document.recompute()
        with self.assertRaisesRegex(mq.InvalidInput, "Other"):
            self.exported(obj)
        obj.Sources = [self.cube, self.other]
        mq.set_patches(obj, {"inlet": ["Cube.Face1"]}, patch_rest="walls")
        obj.Sources = [self.other]
        self.document.recompute()
        lost, = obj.PatchesChanged
        self.assertIn("Cube.Face1 of patch 'inlet'", lost)
        with self.assertRaisesRegex(mq.InvalidInput, "Cube.Face1.*does not hold"):
            self.exported(obj)

    def test_one_that_is_out_of_date_is_written_by_numbers(self):
        obj = self.added()
        obj.Recompute = "Manual"
        self.cube.Height = 5
        self.document.recompute()
        self.assertEqual(self.exported(obj)[0], "Surface")
        mq.set_patches(obj, {"inlet": ["Cube.Face1"]})
        with self.assertRaisesRegex(mq.InvalidInput, "out of date"):
            self.exported(obj)

    def test_one_source_and_containers(self):
        one = self.added(self.cube)
        self.assertEqual(self.exported(one), [f"Face{k}" for k in range(1, 7)])
        mq.set_patches(one, {"inlet": ["Face1"]}, patch_rest="walls")
        self.assertEqual(list(one.Patches), ["inlet: Cube.Face1"])
        part = self.document.addObject("App::Part", "Assembly")
        part.addObject(self.box("Inside", Length=5, Width=5, Height=5))
        self.document.recompute()
        obj = self.added([part, self.other])
        mq.set_patches(obj, {"inlet": ["Assembly.Inside.Face1"]}, patch_rest="walls")
        self.assertEqual(set(self.exported(obj)), {"inlet", "walls"})
        self.assertLess(np.abs(self.triangles_in(obj, ["inlet"])["inlet"][..., 0]).max(), 0.01)

    def test_save_and_restore(self):
        obj = self.added()
        mq.set_patches(obj, {"inlet": ["Cube.Face1"], "scan": ["Other"]}, patch_rest="walls")
        name, before = obj.Name, self.triangles_in(obj, ("inlet", "scan", "walls"))
        segments = obj.Mesh.countSegments()
        self.assertGreater(segments, 6)
        self.reopen()
        again = self.document.getObject(name)
        self.assertEqual(again.Mesh.countSegments(), segments)
        for patch, corners in self.triangles_in(again, before).items():
            self.assertTrue(np.array_equal(corners, before[patch]), patch)

    def test_other_writers_have_them(self):
        obj = self.added()
        mq.set_patches(obj, {"inlet": ["Cube.Face1"], "scan": ["Other"]}, patch_rest="walls")
        with tempfile.TemporaryDirectory() as folder:
            levels = mq.write_openfoam_case(obj, os.path.join(folder, "case"), flow="external")
            self.assertLessEqual({"inlet", "scan", "walls"}, set(levels))
            path = os.path.join(folder, "wrap.cgns" if test_patches.has_cgns() else "wrap.msh")
            mq.export_mesh(obj, path)
            with open(path, "rb") as file:
                content = file.read()
            self.assertTrue(all(word in content for word in (b"inlet", b"scan", b"walls")))
        shape = mq.add_cfd_surface(obj)
        self.assertEqual([line.split(": ")[1] for line in shape.Patches], ["inlet", "scan", "walls"])

    def test_those_of_older_documents_are_made_again(self):
        obj = self.added()
        runs = list(obj.FaceRuns)
        obj.FaceRuns = []
        self.document.recompute()
        self.assertEqual(list(obj.FaceRuns), runs)

    def test_suggested_by_labels(self):
        obj = self.added()
        self.assertEqual(suggested_for(obj.Proxy.faces(obj).members, "labels"),
                         {"Cube": {"faces": [f"Cube.Face{k}" for k in range(1, 7)]}, "Other": {"faces": ["Other"]}})
        with self.assertRaises(mq.InvalidInput):
            suggested_for(obj.Proxy.faces(obj).members, "analysis")
