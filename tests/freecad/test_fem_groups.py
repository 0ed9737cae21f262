# SPDX-License-Identifier: LGPL-2.1-or-later
"""Groups of FEM meshes: of patches, and of nodes for constraints on edges that are looser than their faces."""

import importlib.util
import os
import unittest

import FreeCAD
import helpers
import Part

import MeshQuality as mq

HAS_FEM = importlib.util.find_spec("Fem") is not None
LOOSE = 0.05  # mm


def loosened(solid):
    """The solid with edges and vertices that are off by a part of their tolerance, as those of imported parts."""
    text = solid.exportBrepToString()
    lines, edge, vertex = text.splitlines(), False, False
    for i, line in enumerate(lines):
        if vertex or edge:
            words = line.split()
            words[0] = str(LOOSE)
            lines[i] = (" " if edge else "") + " ".join(words)
        edge, vertex = line == "Ed", line == "Ve"
    shape = Part.Shape()
    shape.importBrepFromString("\n".join(lines) + "\n")
    return shape


@unittest.skipUnless(HAS_FEM, "this FreeCAD has no FEM workbench")
class Groups(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        import ObjectsFem

        self.document.UndoMode = 1
        self.part = self.document.addObject("Part::Feature", "Part")
        self.part.Shape = self.shape()
        self.document.recompute()
        self.analysis = ObjectsFem.makeAnalysis(self.document)
        self.fixed = self.constraint("Fixed", "Face3")
        self.fem = mq.add_fem_mesh(self.part, analysis=self.analysis, max_edge=6.0)

    def shape(self):
        return loosened(Part.makeCylinder(5, 20))

    def constraint(self, kind, *names):
        import ObjectsFem

        found = getattr(ObjectsFem, f"makeConstraint{kind}")(self.document)
        found.References = [(self.part, name) for name in names]
        self.analysis.addObject(found)
        return found

    def found(self, constraint):
        """The nodes that FreeCAD's solvers take for a constraint."""
        from femmesh import meshtools

        return set(meshtools.get_femnodes_by_femobj_with_references(self.fem.FemMesh, {"Object": constraint}))

    def nodes_of(self, *names):
        """Those of the elements on faces and edges."""
        mesh, found = self.fem.FemMesh, set()
        for group in mesh.Groups:
            if mesh.getGroupName(group) in names:
                found.update(node for element in mesh.getGroupElements(group) for node in mesh.getElementNodes(element))
        self.assertTrue(found)
        return found

    def groups(self):
        mesh = self.fem.FemMesh
        return {mesh.getGroupName(group) for group in mesh.Groups if mesh.getGroupElementType(group) == "Node"}

    def test_constraints_find_all_nodes(self):
        self.assertEqual(self.groups(), {f"{self.fixed.Name}_AllNodes"})
        self.assertEqual(self.found(self.fixed), self.nodes_of("Face3"))
        pressure = self.constraint("Pressure", "Face1", "Face2")
        self.assertEqual(self.found(pressure), self.nodes_of("Face1", "Face2"))
        self.assertNotIn("Touched", self.fem.State)

    def test_they_follow_the_constraints(self):
        self.fixed.References = [(self.part, "Face2")]
        self.assertEqual(self.found(self.fixed), self.nodes_of("Face2"))
        self.document.openTransaction("other face")
        self.fixed.References = [(self.part, "Face1")]
        self.document.commitTransaction()
        self.assertEqual(self.found(self.fixed), self.nodes_of("Face1"))
        self.document.undo()
        self.assertEqual(self.found(self.fixed), self.nodes_of("Face2"))
        self.document.redo()
        self.assertEqual(self.found(self.fixed), self.nodes_of("Face1"))
        self.analysis.removeObject(self.fixed)
        self.assertEqual(self.groups(), set())

    def test_they_follow_the_mesh_and_are_saved(self):
        mq.update(self.fem, max_edge=3.0)
        self.assertEqual(self.found(self.fixed), self.nodes_of("Face3"))
        expected, fem, fixed = self.nodes_of("Face3"), self.fem.Name, self.fixed.Name
        self.reopen()
        self.fem, self.fixed = self.document.getObject(fem), self.document.getObject(fixed)
        self.assertEqual(self.found(self.fixed), expected)

    def test_what_needs_none_gets_none(self):
        other = self.document.addObject("Part::Feature", "Other")
        other.Shape = Part.makeBox(1, 1, 1)
        self.fixed.References = [(self.part, "Face3"), (other, "Face1")]  # FreeCAD looks for both by place
        self.assertEqual(self.groups(), set())
        self.fixed.References = [(self.part, "Vertex1")]
        self.assertEqual(self.groups(), set())
        self.part.Shape = Part.makeCylinder(5, 20)
        self.fixed.References = [(self.part, "Face3")]
        self.document.recompute()
        self.assertEqual(self.groups(), set())
        self.assertEqual(self.found(self.fixed), self.nodes_of("Face3"))


@unittest.skipUnless(HAS_FEM, "this FreeCAD has no FEM workbench")
class Patches(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        self.document.UndoMode = 1
        self.part = self.box()
        self.fem = mq.add_fem_mesh(self.part)

    def groups(self, mesh=None):
        """{name: elements} of those of faces and patches."""
        mesh = mesh or self.fem.FemMesh
        return {mesh.getGroupName(group): set(mesh.getGroupElements(group)) for group in mesh.Groups
                if mesh.getGroupElementType(group) == "Face"}

    def of_patches(self):
        return {name: elements for name, elements in self.groups().items() if not name.startswith("Face")}

    def test_they_are_groups_of_triangles(self):
        steps, faces = self.document.UndoCount, self.groups()
        mq.set_patches(self.fem, {"clamped": ["Face1", "Face2"], "loaded": ["Face6"]}, patch_rest="free")
        self.assertEqual(self.document.UndoCount, steps + 1)
        expected = {"clamped": faces["Face1"] | faces["Face2"], "loaded": faces["Face6"],
                    "free": faces["Face3"] | faces["Face4"] | faces["Face5"]}
        self.assertEqual(self.of_patches(), expected)
        self.assertEqual((self.fem.Status, "Touched" in self.fem.State), ("up to date", False))
        self.document.undo()
        self.assertEqual((self.of_patches(), list(self.fem.Patches)), ({}, []))
        self.document.redo()
        self.assertEqual(self.of_patches(), expected)
        self.fem.Patches, self.fem.PatchRest = ["other: Face3"], ""  # in the property editor
        self.document.recompute()
        self.assertEqual(self.of_patches(), {"other": faces["Face3"]})
        mq.set_patches(self.fem, None)
        self.assertEqual(self.groups(), faces)

    def test_files_of_freecad_name_them(self):
        import Fem

        mq.set_patches(self.fem, {"clamped": ["Face1"], "loaded": ["Face6"]})
        for suffix in ("unv", "med"):
            path = os.path.join(self.folder, f"part.{suffix}")
            self.fem.FemMesh.write(path)
            found = self.groups(Fem.read(path))
            self.assertEqual({name: len(found[name]) for name in ("clamped", "loaded")},
                             {name: len(elements) for name, elements in self.of_patches().items()})

    def test_they_follow_the_part_and_are_saved(self):
        mq.set_patches(self.fem, {"top": ["Face6"]})
        self.part.Height = 50
        self.document.recompute()
        self.assertEqual(self.of_patches(), {"top": self.groups()["Face6"]})
        mq.update(self.fem, max_edge=5.0)
        self.assertEqual(self.of_patches(), {"top": self.groups()["Face6"]})
        name = self.fem.Name
        self.reopen()
        self.fem = self.document.getObject(name)
        self.assertEqual(self.of_patches(), {"top": self.groups()["Face6"]})

    def test_what_is_refused(self):
        for patches, rest, words in (({"Face3": ["Face1"]}, None, "name of a group"), ({"a": ["Face1"]}, "Solid1", "name of a group"),
                                     ({"a": ["Face7"]}, None, "Face7"), ("a", None, "dict")):
            with self.subTest(patches), self.assertRaisesRegex(mq.InvalidInput, words):
                mq.set_patches(self.fem, patches, patch_rest=rest)
            self.assertEqual((list(self.fem.Patches), self.of_patches()), ([], {}))


class ImportedPart(Groups):
    """A part of which FreeCAD's search misses nodes."""

    def setUp(self):
        self.path = os.path.join(os.environ.get("MESHQUALITY_DATA", ""), "cad", "tie_rod.step")
        if not os.path.exists(self.path):
            self.skipTest("tie_rod.step is not in $MESHQUALITY_DATA/cad")
        super().setUp()

    def shape(self):
        return Part.read(self.path)

    def test_constraints_find_all_nodes(self):
        missed = 0
        for i in range(len(self.part.Shape.Faces)):
            name = f"Face{i + 1}"
            self.fixed.References = [(self.part, name)]
            nodes = self.nodes_of(name) if self.has(name) else set()
            missed += bool(nodes - set(self.fem.FemMesh.getNodesByFace(self.part.Shape.Faces[i])))
            if nodes:
                self.assertLessEqual(nodes, self.found(self.fixed), name)
        self.assertGreater(missed, 0)

    def has(self, name):
        return name in {self.fem.FemMesh.getGroupName(group) for group in self.fem.FemMesh.Groups}

    test_they_follow_the_constraints = test_they_follow_the_mesh_and_are_saved = test_what_needs_none_gets_none = None
