# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patches of document objects: properties, undo, following edits, names that the document knows, export."""

import os
import tempfile
import unittest

import FreeCAD
import Part

import MeshQuality as mq
from MeshQuality.features.patches import lines_of_patches, patches_of_lines, patches_of_object

PATCHES = {"inlet": ["Face1"], "outlet": {"faces": ["Face2"], "colour": "#ff0000"}}


class OfObjects(unittest.TestCase):
    """Of a quality mesh of a box."""

    def setUp(self):
        self.document = FreeCAD.newDocument("Patches")
        self.document.UndoMode = 1
        self.box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        self.obj = mq.add_quality_mesh(self.box, chord_height=0.1)
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.addCleanup(lambda: [FreeCAD.closeDocument(name) for name in FreeCAD.listDocuments() if name in ("Patches", "saved")])

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def solids_in(self, name):
        """{name of a solid of an ASCII STL: number of its triangles}."""
        found, current = {}, None
        with open(self.path(name), encoding="utf-8") as stream:
            for line in stream:
                words = line.split()
                if words[:1] == ["solid"]:
                    current = words[1]
                    found[current] = 0
                elif words[:1] == ["facet"]:
                    found[current] += 1
        return found

    def test_they_are_set_as_one_step_without_computing_the_mesh(self):
        mesh, steps = self.obj.Mesh.copy(), self.document.UndoCount
        mq.set_patches(self.obj, PATCHES, patch_rest="walls")
        self.assertEqual(list(self.obj.Patches), ["inlet: Face1", "outlet #ff0000: Face2"])
        self.assertEqual(self.obj.PatchRest, "walls")
        self.assertEqual(self.document.UndoCount, steps + 1)
        self.assertEqual(self.obj.Mesh.Topology, mesh.Topology)
        self.assertEqual(self.obj.Status, "up to date")
        self.document.undo()
        self.assertEqual(list(self.obj.Patches), [])
        self.assertEqual(self.obj.PatchRest, "")

    def test_files_have_them(self):
        mq.set_patches(self.obj, PATCHES, patch_rest="walls")
        mq.export_mesh(self.obj, self.path("a.stl"), ascii=True)
        self.assertEqual(self.solids_in("a.stl"), {"inlet": 2, "outlet": 2, "walls": 8})
        mq.export_mesh(self.obj, self.path("b.stl"), patches={"all": [f"Face{i}" for i in range(1, 7)]}, ascii=True)
        self.assertEqual(self.solids_in("b.stl"), {"all": 12})
        mq.set_patches(self.obj, None)
        mq.export_mesh(self.obj, self.path("c.stl"), ascii=True)
        self.assertEqual(self.solids_in("c.stl"), {f"Face{i}": 2 for i in range(1, 7)})
        self.assertEqual(patches_of_object(self.obj), (None, None))

    def test_saved_and_opened_a_mesh_is_up_to_date(self):
        """FreeCAD's text keeps a fixed number of decimals: small numbers and directions come back as others."""
        self.document.addObject("Part::Cylinder", "Cylinder")
        made = self.document.addObject("Part::Feature", "Made")
        box = Part.makeBox(10, 7, 5).cut(Part.makeCylinder(2, 30, FreeCAD.Vector(3, 3, -5), FreeCAD.Vector(0.1, 0.2, 1)))
        made.Shape = box.makeFillet(0.7, box.Edges[:2])
        self.document.recompute()
        for shape in (self.document.Cylinder, made):
            mq.set_patches(mq.add_quality_mesh(shape), {"wall": ["Face1"]}, patch_rest="rest")
        names = [obj.Name for obj in self.document.Objects if hasattr(obj, "Fingerprint")][-2:]
        path = self.path("saved.FCStd")
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        for name in names:
            mq.export_mesh(self.document.getObject(name), self.path("a.stl"), ascii=True)
            self.assertEqual(set(self.solids_in("a.stl")), {"wall", "rest"})

    def test_undone_and_redone_a_mesh_is_up_to_date(self):
        """FreeCAD keeps a copy of a shape for redoing, in which faces have no curve in common."""
        part = self.document.addObject("Part::Cylinder", "Part")
        part.Radius = 20
        self.document.recompute()
        mesh = mq.add_quality_mesh(part, chord_height=0.5)
        mq.set_patches(mesh, {"lid": ["Face2"]}, patch_rest="walls")
        self.document.openTransaction("edit")
        part.Radius = 25
        self.document.recompute()
        self.document.commitTransaction()
        for step in (self.document.undo, self.document.redo, self.document.undo, self.document.redo):
            step()
            mq.export_mesh(mesh, self.path("walls.stl"))  # of an older mesh it is refused

    def test_a_mesh_that_is_out_of_date_is_not_written_by_patches(self):
        mq.set_patches(self.obj, PATCHES, patch_rest="walls")
        self.obj.Recompute = "Manual"
        self.box.Length = 25
        for recompute in (False, True):
            if recompute:
                self.document.recompute()
            with self.assertRaisesRegex(mq.InvalidInput, "out of date.*recompute"):
                mq.export_mesh(self.obj, self.path("a.stl"), ascii=True)
            self.assertEqual(os.listdir(self.path("")), [])
        self.obj.Recompute = "Automatic"
        self.document.recompute()
        mq.export_mesh(self.obj, self.path("a.stl"), ascii=True)
        self.assertEqual(self.solids_in("a.stl"), {"inlet": 2, "outlet": 2, "walls": self.obj.Mesh.CountFacets - 4})
        mq.set_patches(self.obj, None)
        self.box.Length = 35
        mq.export_mesh(self.obj, self.path("b.stl"))  # with a warning
        self.assertEqual(os.path.getsize(self.path("b.stl")), 84 + 50 * self.obj.Mesh.CountFacets)

    def test_they_are_saved_and_loaded(self):
        mq.set_patches(self.obj, PATCHES, patch_rest="walls")
        self.document.saveAs(self.path("patches.FCStd"))
        FreeCAD.closeDocument("Patches")
        self.document = FreeCAD.openDocument(self.path("patches.FCStd"))
        self.addCleanup(FreeCAD.newDocument, "Patches")
        obj = self.document.getObject("QualityMesh")
        mq.export_mesh(obj, self.path("a.stl"), ascii=True)
        self.assertEqual(self.solids_in("a.stl"), {"inlet": 2, "outlet": 2, "walls": 8})
        FreeCAD.closeDocument(self.document.Name)

    def test_what_is_not_possible_is_refused_and_changes_nothing(self):
        mq.set_patches(self.obj, PATCHES)
        for patches, words in (({"a": ["Face9"]}, "Face9"), ({"a": ["Face1"], "b": ["Face1"]}, "Face1"),
                               ({"a:b": ["Face1"]}, "a:b"), ({"": ["Face1"]}, "name of a patch"),
                               ({"a": ["Edge1"]}, "Edge1"), ({"a #ff0000": ["Face1"]}, "as a colour does")):
            with self.assertRaisesRegex(mq.InvalidInput, words):
                mq.set_patches(self.obj, patches)
            self.assertEqual(list(self.obj.Patches), ["inlet: Face1", "outlet #ff0000: Face2"])
        with self.assertRaisesRegex(mq.InvalidInput, "has no patches"):
            mq.set_patches(self.box, PATCHES)
        with self.assertRaisesRegex(mq.InvalidInput, "holds no mesh"):
            mq.export_mesh(self.box, self.path("a.stl"))
        with self.assertRaisesRegex(mq.IoError, "one of .stl"):
            mq.export_mesh(self.obj, self.path("a.docx"))

    def test_lines(self):
        self.assertEqual(lines_of_patches(patches_of_lines(["a b #00ff00: Face1,Face2", "c:Face3"])),
                         ["a b #00ff00: Face1, Face2", "c: Face3"])
        for line, words in (("inlet Face1", "a colon"), (": Face1", "a colon"), ("a: b: c", "a colon")):
            with self.assertRaisesRegex(mq.InvalidInput, words):
                patches_of_lines([line])
        with self.assertRaisesRegex(mq.InvalidInput, "two patches"):
            patches_of_lines(["a: Face1", "a: Face2"])

    def test_faces_are_found_again_where_their_numbers_change(self):
        """The top of a block gets another number when a bore is cut into its side."""
        top = self.top_of(self.box)
        mq.set_patches(self.obj, {"top": [top]})
        cut = self.document.addObject("Part::Cut", "Cut")
        tool = self.document.addObject("Part::Cylinder", "Tool")
        tool.Radius, tool.Height = 1, 30
        tool.Placement = FreeCAD.Placement(FreeCAD.Vector(-5, 5, 5), FreeCAD.Rotation(FreeCAD.Vector(0, 1, 0), 90))
        cut.Base, cut.Tool = self.box, tool
        self.obj.Source = cut
        self.document.recompute()
        self.assertEqual(list(self.obj.Patches), [f"top: {self.top_of(cut)}"])
        self.assertEqual(list(self.obj.PatchesChanged), [])

    def test_an_edit_of_dimensions_keeps_them(self):
        top = self.top_of(self.box)
        mq.set_patches(self.obj, {"top": [top]})
        self.box.Height = 17
        self.document.recompute()
        self.assertEqual(list(self.obj.Patches), [f"top: {top}"])
        self.assertEqual(list(self.obj.PatchesChanged), [])

    def test_a_move_keeps_them(self):
        """Also where a face comes to lie where another one was."""
        mq.set_patches(self.obj, {"left": ["Face1"], "right": ["Face2"]})
        for x in (10, 0):
            self.box.Placement.Base = FreeCAD.Vector(x, 0, 0)
            self.document.recompute()
            self.assertEqual(list(self.obj.Patches), ["left: Face1", "right: Face2"])
            self.assertEqual(list(self.obj.PatchesChanged), [])

    def test_what_was_lost_is_said_until_it_is_chosen_anew(self):
        mq.set_patches(self.obj, {"top": ["Face6"]})
        self.obj.Source = self.document.addObject("Part::Sphere", "Ball")
        self.document.recompute()
        mq.update(self.obj, min_angle=20)
        self.assertEqual(len(self.obj.PatchesChanged), 1)
        mq.set_patches(self.obj, {"all": ["Face1"]})
        self.assertEqual(list(self.obj.PatchesChanged), [])

    def test_a_line_that_makes_no_sense_does_not_fail_the_mesh(self):
        self.obj.Patches = ["nonsense"]
        self.box.Height = 12
        self.document.recompute()
        self.assertEqual(self.obj.Status, "up to date")
        self.assertIn("nonsense", self.obj.PatchesChanged[0])

    def test_what_is_not_found_again_is_said(self):
        mq.set_patches(self.obj, {"top": [self.top_of(self.box)]})
        ball = self.document.addObject("Part::Sphere", "Ball")
        self.obj.Source = ball
        self.document.recompute()
        self.assertEqual(len(self.obj.PatchesChanged), 1)
        self.assertIn("of patch 'top' may be another face", self.obj.PatchesChanged[0])

    @staticmethod
    def top_of(obj):
        return next(f"Face{i}" for i, face in enumerate(obj.Shape.Faces, 1)
                    if abs(face.CenterOfMass.z - obj.Shape.BoundBox.ZMax) < 1e-9)

    def test_names_by_labels(self):
        part = self.document.addObject("App::Part", "Part")
        pin = self.document.addObject("Part::Cylinder", "Pin")
        pin.Label, pin.Placement.Base = "the pin", FreeCAD.Vector(30, 0, 0)
        part.addObjects([self.box, pin])
        self.document.recompute()
        found = mq.suggested_patches(part, "labels")
        self.assertEqual({name: len(said["faces"]) for name, said in found.items()}, {"Box": 6, "the_pin": 3})
        obj = mq.add_quality_mesh(part, chord_height=0.1)
        mq.set_patches(obj, found)
        mq.export_mesh(obj, self.path("a.stl"), ascii=True)
        self.assertEqual(set(self.solids_in("a.stl")), {"Box", "the_pin"})
        mq.set_patches(obj, {"cap": ["Pin.Face2"]}, patch_rest="rest")
        mq.export_mesh(obj, self.path("b.stl"), ascii=True)
        self.assertEqual(set(self.solids_in("b.stl")), {"cap", "rest"})

    def test_labels_that_look_alike(self):
        part = self.document.addObject("App::Part", "Part")
        boxes = []
        for number, label in enumerate(("Bolt-1", "Bolt 1", "\u87ba\u6813", "\u87ba\u6bcd")):
            box = self.document.addObject("Part::Box", "B")
            box.Label, box.Placement.Base = label, FreeCAD.Vector(20 * number, 0, 0)
            boxes.append(box)
        part.addObjects(boxes)
        self.document.recompute()
        self.assertEqual({name: len(said["faces"]) for name, said in mq.suggested_patches(part, "labels").items()},
                         {"Bolt_1": 6, "Bolt_1_2": 6, "patch": 6, "patch_2": 6})

    def test_names_by_an_analysis(self):
        import ObjectsFem

        analysis = ObjectsFem.makeAnalysis(self.document)
        force = ObjectsFem.makeConstraintForce(self.document, "Push here")
        force.References = [(self.box, ("Face2", "Face3"))]
        analysis.addObject(force)
        self.assertEqual(mq.suggested_patches(self.box, "analysis"),
                         {plain(force.Label): {"faces": ["Face2", "Face3"]}})
        with self.assertRaisesRegex(mq.InvalidInput, "holds no parts"):
            mq.suggested_patches(self.box, "labels")
        with self.assertRaisesRegex(mq.InvalidInput, "by = 'magic'"):
            mq.suggested_patches(self.box, "magic")

    def test_a_curved_mesh_has_them_too(self):
        obj = mq.add_curved_mesh(self.box, order=1, volume=True)
        mq.set_patches(obj, {"fixed": ["Face1"]}, patch_rest="free")
        mq.export_mesh(obj, self.path("part.inp"))
        with open(self.path("part.inp"), encoding="utf-8") as stream:
            text = stream.read()
        self.assertIn("NSET=fixed", text.replace(" ", ""))
        mq.export_mesh(obj, self.path("part.stl"), ascii=True)
        self.assertEqual(set(self.solids_in("part.stl")), {"fixed", "free"})


def plain(label):
    return label.replace(" ", "_")
