# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document objects "Offset" and "Hollow": properties, recompute, openings, undo, save and reload, placement, errors."""

import math
import os
import shutil
import tempfile

import FreeCAD
import helpers
import Mesh
import numpy as np
import Part

import MeshQuality as mq
from MeshQuality import options

TOLERANCE = 0.05


class SolidTest(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        self.cube = self.box("Cube", Length=10, Width=10, Height=10)

    def mesh(self, name, mesh):
        obj = self.document.addObject("Mesh::Feature", name)
        obj.Mesh = mesh
        self.document.recompute()
        return obj

    def top(self, obj):
        """The name of the topmost face."""
        faces = obj.Shape.Faces
        return f"Face{max(range(len(faces)), key=lambda i: faces[i].CenterOfMass.z) + 1}"


class Offset(SolidTest):
    def test_it_holds_the_result_of_its_options(self):
        obj = mq.add_offset(self.cube, 2.0, tolerance=TOLERANCE)
        expected = mq.offset(self.cube, 2.0, tolerance=TOLERANCE)
        points, facets = helpers.points_and_facets(obj.Mesh)
        self.assertTrue(np.array_equal(points, expected.vertices))
        self.assertTrue(np.array_equal(facets, expected.triangles))
        self.assertEqual((obj.Source, obj.Distance.Value, obj.Tolerance.Value), (self.cube, 2.0, TOLERANCE))
        self.assertEqual(obj.Triangles, len(expected.triangles))
        exact = 1000 + 6 * 100 * 2 + 3 * 10 * math.pi * 4 + 4 / 3 * math.pi * 8
        self.assertAlmostEqual(obj.Volume.Value / exact, 1.0, delta=4e-3)
        self.assertEqual((obj.AskedTolerance.Value, obj.FaultsLeft), (TOLERANCE, 0))
        self.assertGreater(obj.ErrorBound.Value, 0.0)
        self.assertLessEqual(obj.ErrorBound.Value, TOLERANCE)
        self.assertTrue(obj.Closed and obj.Oriented and obj.Manifold and obj.Mesh.isSolid())
        self.assertEqual((obj.Certificate, obj.Status, obj.Label), ("met", "up to date", "Cube offset"))
        self.assertNotIn("Touched", obj.State)

    def test_every_option_is_a_property(self):
        for obj, table in ((mq.add_offset(self.cube, 1.0, tolerance=TOLERANCE), options.offset.OFFSET_OBJECT),
                           (mq.add_hollow(self.cube, 1.0, tolerance=TOLERANCE), options.offset.HOLLOW_OBJECT)):
            for option in table:
                self.assertEqual(obj.getTypeIdOfProperty(option.property_name), option.property_type)
                self.assertTrue(obj.getDocumentationOfProperty(option.property_name))
            self.assertEqual(obj.getEditorMode("Volume"), ["ReadOnly"])

    def test_it_follows_its_source_and_options_inward_too(self):
        obj = mq.add_offset(self.cube, -2.0, tolerance=TOLERANCE)
        self.assertEqual(obj.Distance.Value, -2.0)
        self.assertAlmostEqual(obj.Volume.Value, 216.0, delta=1.0)
        self.cube.Height = 20
        self.document.recompute()
        self.assertAlmostEqual(obj.Volume.Value, 36.0 * 16.0, delta=2.0)
        obj.Distance = -3
        self.document.recompute()
        self.assertAlmostEqual(obj.Volume.Value, 16.0 * 14.0, delta=2.0)
        mq.update(obj, distance=-1.0)
        self.assertAlmostEqual(obj.Volume.Value, 64.0 * 18.0, delta=2.0)
        self.assertEqual(self.document.UndoNames[0], "Update Cube offset")

    def test_nothing_is_done_when_nothing_changed(self):
        for obj in (mq.add_offset(self.cube, 1.0, tolerance=TOLERANCE),
                    mq.add_hollow(self.cube, 1.0, [self.top(self.cube)], tolerance=TOLERANCE)):
            obj.Notes = ["kept while the mesh is"]
            self.cube.touch()
            self.document.recompute()
            self.assertEqual(obj.Notes, ["kept while the mesh is"])
            self.assertTrue(obj.isValid())

    def test_meshes_and_objects_of_objects(self):
        ball = self.mesh("Ball", Mesh.createSphere(5.0, 40))
        ball.Placement = FreeCAD.Placement(FreeCAD.Vector(3, 0, 0), FreeCAD.Rotation(FreeCAD.Vector(1, 2, 3), 40))
        grown = mq.add_offset(ball, 1.0, tolerance=TOLERANCE)
        self.assertAlmostEqual(grown.Volume.Value / (4 / 3 * math.pi * 216), 1.0, delta=1.5e-2)
        shell = mq.add_hollow(grown, 1.0, tolerance=TOLERANCE)
        self.assertAlmostEqual(shell.Volume.Value / (4 / 3 * math.pi * (216 - 125)), 1.0, delta=3e-2)
        ball.Mesh = Mesh.createSphere(3.0, 40)
        self.document.recompute()
        self.assertAlmostEqual(shell.Volume.Value / (4 / 3 * math.pi * (64 - 27)), 1.0, delta=3e-2)

    def test_nothing_left_is_said_and_legal(self):
        obj = mq.add_offset(self.cube, -6.0, tolerance=TOLERANCE)
        self.assertEqual((obj.Triangles, obj.Mesh.CountFacets), (0, 0))
        self.assertIn("nothing is left", obj.Proxy.told(obj))
        self.assertTrue(obj.isValid())
        obj.Distance = -4
        self.document.recompute()
        self.assertIsNone(obj.Proxy.told(obj))
        self.assertAlmostEqual(obj.Volume.Value, 8.0, delta=0.5)

    def test_an_error_keeps_the_last_good_mesh_and_says_why(self):
        obj = mq.add_offset(self.cube, 1.0, tolerance=TOLERANCE)
        facets = obj.Mesh.CountFacets
        for name, value, words in (("Distance", 0, "distance is 0: give a length"),
                                   ("Tolerance", 5, "tolerance.*at most the distance")):
            held = getattr(obj, name)
            setattr(obj, name, value)
            self.document.recompute()
            self.assertFalse(obj.isValid())
            self.assertRegex(obj.getStatusString(), words)
            self.assertEqual(obj.Mesh.CountFacets, facets)
            setattr(obj, name, held)
            self.document.recompute()
            self.assertTrue(obj.isValid())
        self.document.removeObject(self.cube.Name)
        self.document.recompute()
        self.assertEqual(obj.Status, "out of date: the source was deleted")
        self.assertEqual(obj.Mesh.CountFacets, facets)


class Hollow(SolidTest):
    def test_it_holds_the_result_of_its_options(self):
        top = self.top(self.cube)
        obj = mq.add_hollow(self.cube, 1.0, openings=[top], tolerance=TOLERANCE)
        expected = mq.hollow(self.cube, 1.0, openings=[top], tolerance=TOLERANCE)
        points, facets = helpers.points_and_facets(obj.Mesh)
        self.assertTrue(np.array_equal(points, expected.vertices))
        self.assertTrue(np.array_equal(facets, expected.triangles))
        self.assertEqual((obj.Openings, obj.Thickness.Value), ([top], 1.0))
        self.assertAlmostEqual(obj.Volume.Value, 1000 - 8 * 8 * 9, delta=1.0)
        self.assertGreater(obj.HollowTriangles, 0)
        self.assertEqual((obj.Certificate, obj.Label), ("met", "Cube hollow"))

    def test_a_closed_hollow_says_what_is_sealed_and_saved(self):
        obj = mq.add_hollow(self.cube, 1.0, tolerance=TOLERANCE)
        self.assertAlmostEqual(obj.HollowVolume.Value, 512, delta=1.0)
        self.assertRegex(obj.Proxy.told(obj), r"^a closed void is sealed inside, .*; it saves 511\.\d mm³, 51\.2 % of the volume$")
        obj.Openings = [self.top(self.cube)]
        self.document.recompute()
        self.assertEqual((obj.HollowVolume.Value, obj.Proxy.told(obj)), (0.0, None))

    def test_openings_are_chosen_anew(self):
        obj = mq.add_hollow(self.cube, 1.0, tolerance=TOLERANCE)
        self.assertAlmostEqual(obj.Volume.Value, 1000 - 512, delta=1.0)
        obj.Openings = [self.top(self.cube)]
        self.document.recompute()
        self.assertAlmostEqual(obj.Volume.Value, 1000 - 576, delta=1.0)
        mq.update(obj, openings=["Face5", "Face6"])
        self.assertAlmostEqual(obj.Volume.Value, 1000 - 640, delta=1.0)
        mq.update(obj, openings=None)
        self.assertEqual(obj.Openings, [])
        self.assertAlmostEqual(obj.Volume.Value, 1000 - 512, delta=1.0)

    def test_openings_follow_an_edit_that_gives_faces_other_numbers(self):
        body = self.document.addObject("Part::Feature", "Solid")
        body.Shape = Part.makeBox(10, 10, 10)
        obj = mq.add_hollow(body, 1.0, [self.top(body)], tolerance=TOLERANCE)
        pocket = Part.makeBox(10, 10, 10).cut(Part.makeBox(2, 2, 2, FreeCAD.Vector(4, 4, 0)))
        other = next(i for i in range(len(pocket.Faces)) if pocket.Faces[i].CenterOfMass.z > 9.9)
        faces = [*pocket.Faces[other:], *pocket.Faces[:other]]
        body.Shape = Part.Solid(Part.Shell(faces[1:] + faces[:1]))  # the top is another one than before
        name = self.top(body)
        self.assertNotEqual(obj.Openings, [name])
        self.document.recompute()
        self.assertEqual(obj.Openings, [name])
        self.assertTrue(obj.isValid())
        self.assertNotIn("openings", " ".join(obj.Notes))
        held = obj.Fingerprint
        obj.touch()
        self.document.recompute()
        self.assertEqual(obj.Fingerprint, held)

    def test_an_opening_that_is_not_found_again_is_said(self):
        body = self.document.addObject("Part::Feature", "Solid")
        body.Shape = Part.makeBox(10, 10, 10)
        top = self.top(body)
        obj = mq.add_hollow(body, 1.0, [top], tolerance=TOLERANCE)
        body.Shape = Part.makeBox(10, 10, 12).cut(Part.makeBox(2, 10, 2, FreeCAD.Vector(8, 0, 10)))
        self.document.recompute()
        self.assertIn(f"{top} of the openings may be another face after the edit", " ".join(obj.Notes))
        mq.update(obj, openings=[self.top(body)])
        self.assertNotIn("another face", " ".join(obj.Notes))

    def test_properties_that_were_edited_by_hand(self):
        top = self.top(self.cube)
        obj = mq.add_hollow(self.cube, 1.0, [top], tolerance=TOLERANCE)
        for text in ("no JSON", "[]", "{}", f'{{"names": ["{top}"]}}', f'{{"names": ["{top}"], "faces": [1]}}'):
            obj.OpeningFaces = text
            self.cube.Height = self.cube.Height.Value + 1
            self.document.recompute()
            self.assertTrue(obj.isValid(), text)
            self.assertEqual((obj.Openings, obj.Status), ([top], "up to date"))
        facets = obj.Mesh.CountFacets
        for names, words in ((["Edge1"], "names of faces"), (["Face99"], "has faces Face1 to Face6")):
            obj.Openings = names
            self.document.recompute()
            self.assertFalse(obj.isValid())
            self.assertRegex(obj.getStatusString(), words)
            self.assertEqual(obj.Mesh.CountFacets, facets)
        obj.Openings = [top, top]
        self.document.recompute()
        self.assertTrue(obj.isValid())

    def test_a_plate_that_stays_whole_is_said(self):
        plate = self.box("Plate", Length=20, Width=20, Height=1)
        obj = mq.add_hollow(plate, 0.8, tolerance=TOLERANCE)
        self.assertAlmostEqual(obj.Volume.Value, 400.0, delta=0.1)
        self.assertEqual(obj.HollowTriangles, 0)
        self.assertIn("stays whole", obj.Proxy.told(obj))

    def test_containers_and_links(self):
        part = self.document.addObject("App::Part", "Part")
        part.addObject(self.cube)
        part.Placement = FreeCAD.Placement(FreeCAD.Vector(50, 0, 0), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 90))
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = part
        link.Placement.Base = FreeCAD.Vector(0, 0, 100)
        self.document.recompute()
        top = self.top(self.cube)
        for source, name in ((self.cube, top), (part, f"Cube.{top}"), (link, f"Cube.{top}")):
            with self.subTest(source=source.Name):
                obj = mq.add_hollow(source, 1.0, [name], tolerance=TOLERANCE)
                self.assertAlmostEqual(obj.Volume.Value, 1000 - 576, delta=1.0)
                self.assertEqual(obj.Openings, [name])
                centre = obj.Mesh.BoundBox.Center
                self.assertAlmostEqual(centre.x, 5.0 if source is link else 45.0, places=3)  # a link has its own placement
                self.assertAlmostEqual(centre.z, 105.0 if source is link else 5.0, places=3)

    def test_a_container_of_shapes_and_meshes(self):
        plate = Mesh.createBox(10.0, 10.0, 2.0)
        plate.translate(10.0, 5.0, 5.0)
        group = self.document.addObject("App::Part", "Mixed")
        group.addObjects([self.cube, self.mesh("Plate", plate)])
        self.document.recompute()
        obj = mq.add_offset(group, -0.5, tolerance=TOLERANCE)
        # The cube, and what of the plate sticks out of it.
        self.assertAlmostEqual(obj.Volume.Value, 729.0 + 5.0 * 9.0 * 1.0, delta=1.5)
        self.assertEqual(obj.Certificate, "met")
        with self.assertRaisesRegex(mq.InvalidInput, "has no patches"):
            mq.set_patches(obj, {"lid": ["Face1"]})
        with self.assertRaisesRegex(mq.InvalidInput, "'Mixed' holds shapes and meshes"):
            mq.add_inspection(group)

    def test_a_moved_container_takes_it_along_without_new_work(self):
        part = self.document.addObject("App::Part", "Part")
        part.addObject(self.cube)
        obj = mq.add_hollow(self.cube, 1.0, [self.top(self.cube)], tolerance=TOLERANCE)
        held, obj.Notes = obj.Fingerprint, ["kept while the mesh is"]
        part.Placement.Base = FreeCAD.Vector(0, 30, 0)
        self.document.recompute()
        self.assertEqual((obj.Fingerprint, obj.Notes), (held, ["kept while the mesh is"]))
        self.assertAlmostEqual(obj.Mesh.BoundBox.Center.y, 35.0, places=4)


class Patches(SolidTest):
    def test_triangles_are_in_the_patches_of_their_faces(self):
        top = self.top(self.cube)
        for obj in (mq.add_offset(self.cube, 1.0, tolerance=TOLERANCE),
                    mq.add_hollow(self.cube, 1.0, [top], tolerance=TOLERANCE)):
            with self.subTest(obj.Label):
                mq.set_patches(obj, {"lid": [top]}, patch_rest="walls")
                names, triangles = self.exported(obj)
                self.assertEqual(names, ["lid", "walls"])
                self.assertEqual(sum(triangles), obj.Triangles)
                self.assertEqual(obj.Mesh.countSegments(), 6)

    def test_patches_follow_an_edit(self):
        obj = mq.add_offset(self.cube, -1.0, tolerance=TOLERANCE)
        mq.set_patches(obj, {"lid": [self.top(self.cube)]})
        before = self.exported(obj)
        self.cube.Height = 12
        self.document.recompute()
        self.assertEqual(obj.Patches, [f"lid: {self.top(self.cube)}"])
        self.assertEqual(obj.PatchesChanged, [])
        self.assertEqual(self.exported(obj)[0], before[0])
        self.cube.Height = 14  # not computed yet
        obj.Recompute = "Manual"
        self.document.recompute()
        with self.assertRaisesRegex(mq.InvalidInput, "out of date"):
            self.exported(obj)

    def test_segments_and_patches_come_back(self):
        obj = mq.add_hollow(self.cube, 1.0, tolerance=TOLERANCE)
        mq.set_patches(obj, {"lid": [self.top(self.cube)]}, patch_rest="walls")
        before, name = self.exported(obj), obj.Name
        self.reopen()
        obj = self.document.getObject(name)
        self.assertEqual(obj.Mesh.countSegments(), 6)
        self.assertEqual(self.exported(obj), before)

    def test_of_a_mesh_there_are_none(self):
        ball = self.mesh("Ball", Mesh.createSphere(5.0, 20))
        obj = mq.add_offset(ball, 1.0, tolerance=TOLERANCE)
        self.assertEqual((list(obj.FaceRuns), obj.Mesh.countSegments()), ([], 0))
        with self.assertRaisesRegex(mq.InvalidInput, "has no patches.*source is a shape"):
            mq.set_patches(obj, {"lid": ["Face1"]})

    def test_a_surface_for_cfd_has_its_patches(self):
        obj = mq.add_offset(self.cube, 1.0, tolerance=TOLERANCE)
        mq.set_patches(obj, {"lid": [self.top(self.cube)]}, patch_rest="walls")
        surface = mq.add_cfd_surface(obj)
        self.assertEqual(surface.Patches, ["Face1: lid", "Face2: walls"])

    def exported(self, obj):
        """(names, numbers of triangles) of the solids in the STL file of the object."""
        path = os.path.join(tempfile.mkdtemp(), "out.stl")
        self.addCleanup(shutil.rmtree, os.path.dirname(path))
        mq.export_mesh(obj, path, ascii=True)
        with open(path, encoding="ascii") as file:
            solids = file.read().split("endsolid")[:-1]
        names = [solid.partition("solid ")[2].split("\n")[0].strip() for solid in solids]
        return names, [solid.count("facet normal") for solid in solids]


class Undo(SolidTest):
    def test_one_step(self):
        before = list(self.document.UndoNames)
        for add, title in ((mq.add_offset, "Offset"), (mq.add_hollow, "Hollow")):
            obj = add(self.cube, 1.0, tolerance=TOLERANCE)
            name, facets = obj.Name, obj.Mesh.CountFacets
            self.assertEqual(self.document.UndoNames, [title, *before])
            self.document.undo()
            self.assertIsNone(self.document.getObject(name))
            self.document.redo()
            self.assertEqual(self.document.getObject(name).Mesh.CountFacets, facets)
            self.document.undo()

    def test_a_failure_leaves_nothing_behind(self):
        sheet, ball = self.mesh("Sheet", Mesh.createPlane(5, 5)), self.mesh("Ball", Mesh.createSphere(5.0, 20))
        undo, objects = list(self.document.UndoNames), len(self.document.Objects)
        for call, words in (
                (lambda: mq.add_offset(self.cube, 0.0), "distance is 0"),
                (lambda: mq.add_offset(self.cube, None), "distance is 0"),
                (lambda: mq.add_offset(self.cube, float("nan")), "distance = nan"),
                (lambda: mq.add_offset(self.cube, 1.0, tolerance=-1), "tolerance"),
                (lambda: mq.add_offset(self.cube.Shape, 1.0), "document object"),
                (lambda: mq.add_offset(sheet, 1.0), "open"),
                (lambda: mq.add_hollow(self.cube, -1.0), "thickness"),
                (lambda: mq.add_hollow(self.cube, 1.0, ["Face9"]), "names Face9, but 'Cube' has faces Face1 to Face6"),
                (lambda: mq.add_hollow(self.cube, 1.0, ["Other.Face1"]), "names Other.Face1, but 'Cube' does not hold that"),
                (lambda: mq.add_hollow(self.cube, 1.0, ["Edge1"]), "openings.*names of faces"),
                (lambda: mq.add_hollow(self.cube, 1.0, "Face1"), "openings.*names of faces"),
                (lambda: mq.add_hollow(self.cube, 1.0, []), "openings.*names of faces"),
                (lambda: mq.add_hollow(ball, 1.0, ["Face1"]), "openings are faces of a shape, and 'Ball' has a mesh")):
            with self.subTest(words), self.assertRaisesRegex(mq.InvalidInput, words):
                call()
        self.assertEqual(len(self.document.Objects), objects)
        self.assertEqual(self.document.UndoNames, undo)
        self.assertFalse(self.document.HasPendingTransaction)


class SaveAndReload(SolidTest):
    def test_mesh_options_and_proxy_come_back(self):
        top = self.top(self.cube)
        objects = mq.add_offset(self.cube, -1.0, tolerance=TOLERANCE), mq.add_hollow(self.cube, 1.0, [top], tolerance=TOLERANCE)
        held = [(obj.Name, helpers.points_and_facets(obj.Mesh)) for obj in objects]
        self.reopen()
        for (name, (points, facets)), module in zip(held, ("offset", "hollow")):
            again = self.document.getObject(name)
            self.assertEqual(type(again.Proxy).__module__, f"MeshQuality.features.{module}")
            points_again, facets_again = helpers.points_and_facets(again.Mesh)
            self.assertTrue(np.array_equal(points, points_again))
            self.assertTrue(np.array_equal(facets, facets_again))
            again.Notes = ["kept while the mesh is"]
        self.assertEqual(self.document.getObject(held[0][0]).Distance.Value, -1.0)
        self.assertEqual(self.document.getObject(held[1][0]).Openings, [top])
        self.document.getObject("Cube").touch()
        self.document.recompute()
        for name, _ in held:
            self.assertEqual(self.document.getObject(name).Notes, ["kept while the mesh is"])
        self.document.getObject("Cube").Height = 30
        self.document.recompute()
        self.assertAlmostEqual(self.document.getObject(held[0][0]).Mesh.BoundBox.ZLength, 28.0, delta=2 * TOLERANCE)
        self.assertAlmostEqual(self.document.getObject(held[1][0]).Mesh.BoundBox.ZLength, 30.0, delta=1e-4)
