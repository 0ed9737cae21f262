# SPDX-License-Identifier: LGPL-2.1-or-later
"""FEM meshes that other programs made: cured as a document object, its groups and analysis, following, files, CalculiX."""

import importlib.util
import os
import shutil
import sys
import unittest

import FreeCAD
import given_meshes
import helpers
import numpy as np
import Part

import MeshQuality as mq
from MeshQuality.compat import fem_in_document
from MeshQuality.core.meshes.element_mesh import ElementMesh
from MeshQuality.core.sources import convert

sys.path.append(os.path.join(helpers.ROOT, "benchmarks", "solvers"))
import cantilever  # noqa: E402
import fem_meshers  # noqa: E402

HAS_FEM = importlib.util.find_spec("Fem") is not None
HAS_GMSH = bool(shutil.which("gmsh") or os.path.isfile("/usr/lib/python3/dist-packages/gmsh.py"))


def groups_of(mesh):
    """{name: (kind, element numbers)} of a Fem.FemMesh."""
    return {mesh.getGroupName(group): (mesh.getGroupElementType(group), sorted(mesh.getGroupElements(group)))
            for group in mesh.Groups}


@unittest.skipUnless(HAS_FEM, "this FreeCAD has no FEM workbench")
class CureTest(helpers.DocumentTest):
    def part(self, shape):
        obj = self.document.addObject("Part::Feature", "Part")
        obj.Shape = shape
        self.document.recompute()
        return obj

    def given(self, part, folded=(), size=8.0):
        """A FEM mesh object of the part with a group of every tenth tetrahedron and one of all triangles."""
        obj = self.document.addObject("Fem::FemMeshObject", "Given")
        mesh = given_meshes.straight_mesh(part.Shape, size, folded)
        mesh.addGroupElements(mesh.addGroup("some", "Volume"), list(mesh.Volumes)[::10])
        mesh.addGroupElements(mesh.addGroup("skin", "Face"), list(mesh.Faces))
        obj.FemMesh = mesh
        return obj


class Cured(CureTest):
    def test_a_folded_mesh_is_valid_afterwards(self):
        part = self.part(cantilever.bracket())
        given = self.given(part, folded=(3, 40))
        before = mq.certify(given)
        self.assertGreaterEqual(before.invalid, 2)
        obj = mq.add_cured_mesh(given, part)
        self.assertEqual((obj.TypeId, obj.Label), ("Fem::FemMeshObjectPython", "Part cured mesh"))
        after = mq.certify(obj, part)
        self.assertEqual((after.invalid, after.folded_on_cad, obj.Certificate), (0, 0, "met"))
        self.assertLess(after.max_deviation, mq.certify(given, part).max_deviation)
        self.assertEqual((obj.GivenElements, obj.GivenInvalid, obj.Invalid), (given.FemMesh.VolumeCount, before.invalid, 0))
        self.assertEqual(obj.GivenInvalidElements, before.invalid_elements)
        self.assertEqual((obj.Given, obj.Source, obj.Order), (given, part, 2))
        self.assertNotIn("Touched", obj.State)

    def test_what_is_sound_stays(self):
        part = self.part(cantilever.beam())
        given = self.given(part)
        obj = mq.add_cured_mesh(given, part)
        corners = {tuple(sorted(given.FemMesh.getElementNodes(n)[:4])) for n in given.FemMesh.Volumes}
        places = {tuple(np.round(tuple(given.FemMesh.Nodes[n]), 9)) for row in corners for n in row}
        self.assertEqual((obj.GivenReplaced, obj.GivenMoved, obj.Elements), (0, 0, len(corners)))
        found = {tuple(np.round(tuple(obj.FemMesh.Nodes[n]), 9)) for e in obj.FemMesh.Volumes
                 for n in obj.FemMesh.getElementNodes(e)[:4]}
        self.assertEqual(found, places)

    def test_groups(self):
        part = self.part(cantilever.beam())
        given = self.given(part)
        obj = mq.add_cured_mesh(given, part)
        found, before = groups_of(obj.FemMesh), groups_of(given.FemMesh)
        self.assertEqual(found["Solid1"], ("Volume", sorted(obj.FemMesh.Volumes)))
        for i, face in enumerate(part.Shape.Faces):
            self.assertEqual(set(obj.FemMesh.getFacesByFace(face)), set(found[f"Face{i + 1}"][1]))
        self.assertEqual(found["skin"], ("Face", sorted(obj.FemMesh.Faces)))
        self.assertEqual((found["some"][0], len(found["some"][1])), ("Volume", len(before["some"][1])))

        def middles(mesh, numbers):
            return sorted(tuple(np.round(np.mean([tuple(mesh.Nodes[n]) for n in mesh.getElementNodes(e)[:4]], axis=0), 6))
                          for e in numbers)

        self.assertEqual(middles(obj.FemMesh, found["some"][1]), middles(given.FemMesh, before["some"][1]))
        mq.set_patches(obj, {"clamped": ["Face1"]})
        self.assertLessEqual({"some", "skin", "clamped"}, set(groups_of(obj.FemMesh)))

    def test_order_1(self):
        part = self.part(cantilever.bracket())
        obj = mq.add_cured_mesh(self.given(part, folded=(3,)), part, order=1)
        self.assertEqual((len(obj.FemMesh.getElementNodes(1)), mq.certify(obj).invalid), (4, 0))


class Nested(CureTest):
    """A part in a moved App::Part in another one, and meshes of it wherever these stand."""

    def setUp(self):
        super().setUp()
        self.inner, self.outer = (self.document.addObject("App::Part", name) for name in ("Inner", "Outer"))
        self.outer.addObject(self.inner)
        self.nested = self.part(cantilever.bracket())
        self.inner.addObject(self.nested)
        turned = FreeCAD.Rotation(FreeCAD.Vector(1, 1, 0), 40)
        self.nested.Placement = FreeCAD.Placement(FreeCAD.Vector(5, 6, 7), turned)
        self.inner.Placement = FreeCAD.Placement(FreeCAD.Vector(100, 0, 0), turned)
        self.outer.Placement = FreeCAD.Placement(FreeCAD.Vector(0, 200, 0), turned.inverted())
        self.document.recompute()

    def meshes(self):
        """{where it stands: the object}"""
        found = {name: self.given(self.nested, folded=(3,)) for name in ("own", "inner", "outer", "document", "placed")}
        self.inner.addObject(found["inner"])
        self.outer.addObject(found["outer"])
        shape = self.nested.Shape.copy()
        shape.Placement = self.nested.getGlobalPlacement()
        found["document"].FemMesh = given_meshes.straight_mesh(shape, 8.0, (3,))
        shape.Placement = FreeCAD.Placement()
        found["placed"].FemMesh = given_meshes.straight_mesh(shape, 8.0, (3,))
        found["placed"].Placement = self.nested.Placement
        return found

    def test_turned_by_a_quarter_about_the_middle_of_its_box(self):
        """Both places have the same box: the nodes lie on the faces in one of them only."""
        block = Part.makeBox(40, 40, 40).cut(Part.makeCylinder(5, 40, FreeCAD.Vector(10, 10, 0)))
        part, container = self.part(block), self.document.addObject("App::Part", "Turned")
        container.addObject(part)
        container.Placement = FreeCAD.Placement(FreeCAD.Vector(), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 90), FreeCAD.Vector(20, 20, 20))
        self.document.recompute()
        there = block.copy()
        there.Placement = container.Placement
        for shape in (block, there):
            given = self.given(part)
            given.FemMesh = given_meshes.straight_mesh(shape, 12.0, ())
            certificate = mq.certify(given, part)
            self.assertIsNone(certificate.not_on_shape, str(certificate))
            self.assertLess(certificate.max_deviation, 1.0)
            self.assertLess(certificate.cad_deviation, 1.0)

    def test_the_cured_mesh_is_where_the_fem_workbench_looks(self):
        for name, given in self.meshes().items():
            with self.subTest(name):
                obj = mq.add_cured_mesh(given, self.nested)
                self.assertEqual((obj.Invalid, obj.GivenReplaced, obj.GivenMoved), (0, 0, 0))
                self.assertGreater(obj.GivenInvalid, 0)
                end = cantilever.face_at(self.nested.Shape, "x", 1)
                self.assertTrue(obj.FemMesh.getNodesByFace(helpers.faces_as_fem_finds_them(self.nested)[int(end[len("Face"):]) - 1]))
                self.assertLess(mq.certify(obj, self.nested).max_deviation, 0.06)

    def test_where_it_is_when_the_containers_move(self):
        obj = mq.add_cured_mesh(self.meshes()["own"], self.nested)
        before, stood = ElementMesh.of(obj.FemMesh).nodes, self.nested.getGlobalPlacement()
        self.outer.Placement = FreeCAD.Placement(FreeCAD.Vector(1, 2, 3), FreeCAD.Rotation())
        self.document.recompute()
        if fem_in_document():
            moved = convert.moved(before, self.nested.getGlobalPlacement().multiply(stood.inverse()))
            np.testing.assert_allclose(ElementMesh.of(obj.FemMesh).nodes, moved, atol=1e-9)
        else:
            self.assertEqual(obj.getParentGeoFeatureGroup(), self.inner)
            np.testing.assert_array_equal(ElementMesh.of(obj.FemMesh).nodes, before)
        self.assertTrue(all(obj.FemMesh.getNodesByFace(face) for face in helpers.faces_as_fem_finds_them(self.nested)))
        self.assertEqual((obj.Status, mq.certify(obj, self.nested).not_on_shape), ("up to date", None))

    def test_certify_and_curve_take_the_objects(self):
        centre = self.nested.Shape.transformed(self.inner.Placement.toMatrix()).transformed(self.outer.Placement.toMatrix()).BoundBox.Center
        for name, given in self.meshes().items():
            with self.subTest(name):
                self.assertEqual(mq.certify(given, self.nested).not_on_shape, None)
                cured = mq.curve(self.nested, mesh=given)
                low, high = cured.nodes.min(axis=0), cured.nodes.max(axis=0)
                self.assertLess(np.abs((low + high) / 2 - tuple(centre)).max(), 0.2)


class Analyses(CureTest):
    def test_it_takes_the_place_of_the_given_mesh(self):
        from femtools import membertools

        part = self.part(cantilever.beam())
        analysis, given = cantilever.add_analysis(part, "force"), self.given(part)
        analysis.addObject(given)
        others = [member for member in analysis.Group if member != given]
        obj = mq.add_cured_mesh(given, part)
        self.assertEqual((analysis.Group, given.Document), ([*others, obj], self.document))
        self.assertEqual(membertools.get_mesh_to_solve(analysis), (obj, ""))
        again = mq.add_cured_mesh(given, part, order=1)
        self.assertEqual(membertools.get_mesh_to_solve(analysis), (again, ""))

    def test_undo_is_one_step(self):
        part = self.part(cantilever.beam())
        analysis, given = cantilever.add_analysis(part, "force"), self.given(part)
        analysis.addObject(given)
        self.document.UndoMode = 1
        group = analysis.Group
        obj = mq.add_cured_mesh(given, part)
        name = obj.Name
        self.assertEqual(self.document.UndoNames, ["Certify and cure"])
        self.document.undo()
        self.assertEqual((analysis.Group, self.document.getObject(name)), (group, None))
        self.document.redo()
        obj = self.document.getObject(name)
        self.assertEqual((obj in analysis.Group, given in analysis.Group), (True, False))

    def test_nothing_changes_on_an_error(self):
        part, other = self.part(cantilever.beam()), self.part(Part.makeSphere(30))
        analysis, given = cantilever.add_analysis(part, "force"), self.given(part)
        analysis.addObject(given)
        objects, group = self.document.Objects, analysis.Group
        with self.assertRaises(mq.Error) as caught:
            mq.add_cured_mesh(given, other)
        self.assertRegex(str(caught.exception), "Face1|mesh")
        self.assertEqual((self.document.Objects, analysis.Group), (objects, group))
        for wrong, words in ((part, "has no FEM mesh"), (given, "does not say of which part")):
            with self.subTest(words), self.assertRaisesRegex(mq.InvalidInput, words):
                mq.add_cured_mesh(wrong)

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX (ccx) is not installed")
    def test_calculix(self):
        part = self.part(cantilever.beam())
        end = part.Shape.getElement(cantilever.face_at(part.Shape, "x", 1))
        for load in ("force", "pressure"):
            with self.subTest(load):
                analysis, given = cantilever.add_analysis(part, load), self.given(part, size=6.0)
                analysis.addObject(given)
                obj = mq.add_cured_mesh(given, part)
                self.assertEqual(mq.certify(obj).invalid, 0)
                found = cantilever.deflection(cantilever.solve(analysis, self.folder), obj.FemMesh, end)
                self.assertAlmostEqual(found / cantilever.deflections()[load], 1.0, delta=0.01)


class Follows(CureTest):
    def test_the_part_and_the_mesh(self):
        part = self.document.addObject("Part::Cylinder", "Cylinder")
        part.Radius, part.Height = 5, 10
        self.document.recompute()
        given = self.given(part, size=4.0)
        obj = mq.add_cured_mesh(given, part)
        count = obj.Elements
        given.FemMesh = given_meshes.straight_mesh(part.Shape, 2.0)
        self.document.recompute()
        self.assertEqual((obj.Elements, obj.Status), (given.FemMesh.VolumeCount, "up to date"))
        self.assertGreater(obj.Elements, count)
        part.Radius = 50
        self.document.recompute()
        self.assertTrue(obj.Status.startswith("failed: "), obj.Status)
        given.FemMesh = given_meshes.straight_mesh(part.Shape, 20.0)
        self.document.recompute()
        self.assertEqual((obj.Elements, obj.Status), (given.FemMesh.VolumeCount, "up to date"))
        self.document.removeObject(given.Name)
        self.document.recompute()
        self.assertEqual(obj.Status, "out of date: the source was deleted")
        self.assertEqual(mq.certify(obj).invalid, 0)

    def test_save_and_open(self):
        part = self.part(cantilever.beam())
        obj = mq.add_cured_mesh(self.given(part), part)
        name, counts, groups = obj.Name, (obj.Elements, obj.GivenElements), set(groups_of(obj.FemMesh))
        path = os.path.join(self.folder, "cured.FCStd")
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        obj = self.document.getObject(name)
        self.assertEqual(((obj.Elements, obj.GivenElements), set(groups_of(obj.FemMesh))), (counts, groups))
        self.assertEqual((mq.certify(obj).invalid, obj.Certificate, obj.Given.Name), (0, "met", "Given"))
        mq.update(obj, order=1)
        self.assertEqual(len(obj.FemMesh.getElementNodes(1)), 4)


@unittest.skipUnless(HAS_GMSH, "Gmsh is not installed (gmsh or python3-gmsh)")
class Gmsh(CureTest):
    def test_freecads_mesh_object(self):
        """Its part is named by itself; some of its elements are folded, as it is asked not to mend them."""
        fem_meshers.use_gmsh_module(self.folder)
        part = self.part(cantilever.bracket())
        analysis = cantilever.add_analysis(part, "weight")
        given = fem_meshers.gmsh(part, analysis, 12.0, HighOrderOptimize="None", MeshSizeFromCurvature=0)
        self.assertGreater(mq.certify(given).folded, 0)
        obj = mq.add_cured_mesh(given)
        self.assertEqual((obj.Source, obj.Invalid, mq.certify(obj).invalid), (part, 0, 0))
        self.assertEqual([member for member in analysis.Group if member.isDerivedFrom("Fem::FemMeshObject")], [obj])
