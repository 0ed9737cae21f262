# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "FEM mesh": groups, what FreeCAD's constraints find on it, following, undo, files, CalculiX."""

import importlib.util
import os
import re
import shutil
import sys
import tempfile
import unittest
from unittest import mock

import FreeCAD
import helpers
import numpy as np
import Part

import MeshQuality as mq
from MeshQuality import compat, options
from MeshQuality.compat import fem_in_document
from MeshQuality.core.fem import fem, fem_size
from MeshQuality.core.meshes.element_mesh import ElementMesh
from MeshQuality.core.sources import convert, frames
from MeshQuality.features import fem_mesh

sys.path.append(os.path.join(helpers.ROOT, "benchmarks", "solvers"))
import cantilever  # noqa: E402

HAS_FEM = importlib.util.find_spec("Fem") is not None


def groups_of(mesh):
    """{name: (kind, set of element numbers)} of a Fem.FemMesh."""
    return {mesh.getGroupName(group): (mesh.getGroupElementType(group), set(mesh.getGroupElements(group)))
            for group in mesh.Groups}


def nodes_of(mesh, elements):
    return {node for element in elements for node in mesh.getElementNodes(element)}


@unittest.skipUnless(HAS_FEM, "this FreeCAD has no FEM workbench")
class FemObjectTest(helpers.DocumentTest):
    def part(self, shape, name="Part"):
        obj = self.document.addObject("Part::Feature", name)
        obj.Shape = shape
        self.document.recompute()
        return obj

    def analysis(self, *members):
        import ObjectsFem

        found = ObjectsFem.makeAnalysis(self.document)
        for member in members:
            found.addObject(member)
        return found

    def cylinder(self):
        obj = self.document.addObject("Part::Cylinder", "Cylinder")
        obj.Radius, obj.Height = 5, 10
        self.document.recompute()
        return obj


class Elements(FemObjectTest):
    def test_it_holds_the_elements_of_its_options(self):
        source = self.cylinder()
        for order in (1, 2):
            obj = mq.add_fem_mesh(source, order=order, max_edge=4.0)
            expected = mq.curve(source, order=order, volume=True, max_edge=4.0)
            mesh = obj.FemMesh
            self.assertEqual(obj.TypeId, "Fem::FemMeshObjectPython")
            self.assertEqual((mesh.NodeCount, mesh.VolumeCount, mesh.FaceCount, mesh.EdgeCount),
                             (len(expected.nodes), len(expected.tetrahedra), len(expected.triangles), len(expected.edges)))
            points = np.array([tuple(mesh.Nodes[i + 1]) for i in range(mesh.NodeCount)])
            np.testing.assert_array_equal(points, expected.nodes)
            self.assertEqual(set(mesh.getElementNodes(1)), set((expected.tetrahedra[0] + 1).tolist()))
            self.assertEqual((obj.Elements, obj.Invalid), (len(expected.tetrahedra), 0))
            self.assertEqual(obj.MinScaledJacobian, expected.report.min_scaled_jacobian)
            self.assertEqual((obj.Certificate, obj.Label.rstrip("0123456789")), ("met", "Cylinder FEM mesh"))
            self.assertEqual(getattr(obj, fem_mesh.PART[0]), source)
            self.assertNotIn("Touched", obj.State)

    def test_every_option_is_a_property(self):
        obj = mq.add_fem_mesh(self.cylinder())
        for option in options.fem.FEM:
            self.assertEqual(obj.getTypeIdOfProperty(option.property_name), option.property_type)
            self.assertTrue(obj.getDocumentationOfProperty(option.property_name))
        self.assertEqual((obj.Order, obj.Volume), (2, True))
        self.assertEqual(obj.getEditorMode(fem_mesh.PART[0]), ["Hidden"])

    def test_groups_have_the_names_of_the_part(self):
        source = self.part(cantilever.bracket())
        mesh = mq.add_fem_mesh(source).FemMesh
        found = groups_of(mesh)
        shape = source.Shape
        self.assertEqual(found["Solid1"], ("Volume", set(mesh.Volumes)))
        self.assertEqual({name for name in found if name.startswith("Face")},
                         {f"Face{i + 1}" for i in range(len(shape.Faces))})
        for kind, faces in (("Face", shape.Faces), ("Edge", shape.Edges)):
            for i, entity in enumerate(faces):
                with self.subTest(f"{kind}{i + 1}"):
                    self.assertEqual(found[f"{kind}{i + 1}"][0], kind)
                    nodes = nodes_of(mesh, found[f"{kind}{i + 1}"][1])
                    self.assertEqual(nodes, set(getattr(mesh, f"getNodesBy{kind}")(entity)))

    def test_faces_of_constraints_are_found(self):
        source = self.part(cantilever.beam())
        for order in (1, 2):
            mesh = mq.add_fem_mesh(source, order=order, max_edge=20.0).FemMesh
            found = groups_of(mesh)
            for i, face in enumerate(source.Shape.Faces):
                elements = found[f"Face{i + 1}"][1]
                self.assertEqual(set(mesh.getFacesByFace(face)), elements)
                self.assertGreaterEqual({volume for volume, _ in mesh.getccxVolumesByFace(face)},
                                        {volume for element in elements for volume in mesh.Volumes
                                         if set(mesh.getElementNodes(element)) <= set(mesh.getElementNodes(volume))})

    def test_shells(self):
        for source, values in ((self.part(Part.makeCylinder(5, 10).Shells[0]), {}), (self.cylinder(), {"volume": False})):
            mesh = mq.add_fem_mesh(source, max_edge=4.0, **values).FemMesh
            self.assertEqual(mesh.VolumeCount, 0)
            self.assertEqual(mesh.FaceCount, len(mq.curve(source, max_edge=4.0).triangles))
            self.assertEqual(nodes_of(mesh, groups_of(mesh)["Face1"][1]), set(mesh.getNodesByFace(source.Shape.Face1)))

    def test_bodies_that_touch_share_nodes(self):
        """By default; of a mesh of separate bodies a solver would find two parts that hang on nothing."""
        source = self.part(Part.makeCompound([Part.makeBox(10, 10, 10), Part.makeBox(4, 4, 4, FreeCAD.Vector(3, 3, 10))]))
        joined, apart = (mq.add_fem_mesh(source, imprint=imprint) for imprint in (True, False))
        self.assertEqual(joined.Certificate, "met")
        self.assertTrue(options.defaults(options.fem.FEM)["imprint"])
        for obj, shared in ((joined, True), (apart, False)):
            groups = groups_of(obj.FemMesh)
            solids = [nodes_of(obj.FemMesh, groups[name][1]) for name in ("Solid1", "Solid2")]
            self.assertEqual(bool(solids[0] & solids[1]), shared)
        groups = groups_of(joined.FemMesh)
        self.assertTrue(groups["Face11"][1] < groups["Face6"][1])  # the bottom of the upper box, in the top of the lower one

    def test_without_groups_there_are_elements_of_one_kind(self):
        curved = mq.curve(self.cylinder(), volume=True)
        mesh = curved.to_fem_mesh()
        self.assertEqual((mesh.GroupCount, mesh.FaceCount, mesh.EdgeCount), (0, 0, 0))
        again = curved.to_fem_mesh(groups=True)
        for i in range(1, len(curved.tetrahedra) + 1):
            self.assertEqual(mesh.getElementNodes(i), again.getElementNodes(i))
        first = len(curved.tetrahedra) + 1
        np.testing.assert_array_equal(again.getElementNodes(first), curved.triangles[0] + 1)
        self.assertEqual(len(curved.edges), len(curved.edge_entity))


class Sizes(FemObjectTest):
    def test_a_plate_has_two_elements_through_its_thickness(self):
        source = self.part(Part.makeBox(20, 20, 4))
        obj = mq.add_fem_mesh(source)
        mesh = obj.FemMesh
        nodes = mesh.Nodes
        heights = {round(nodes[node].z, 6) for number in mesh.Volumes for node in mesh.getElementNodes(number)[:4]}
        self.assertTrue(any(1.0 < height < 3.0 for height in heights), heights)
        self.assertLess(mq.add_fem_mesh(source, elements_through=1).Elements, obj.Elements / 3)
        self.assertEqual(obj.Certificate, "met")
        # Twice the volume over the area of the surface, over two.
        self.assertAlmostEqual(fem_size.longest_edge(source.Shape, options.check(options.fem.FEM, {}))[0], 1600 / 1120)

    def test_the_number_of_elements_has_a_limit_that_is_told(self):
        values = options.check(options.fem.FEM, {})
        length, note = fem_size.longest_edge(Part.makeBox(300, 300, 1), values)
        self.assertGreater(length, 0.5)
        self.assertIn("100,000 elements", note)
        self.assertLessEqual(fem_size.expected_elements(Part.makeBox(300, 300, 1), values), 100000)
        with mock.patch.object(fem_size, "_MOST", 100):
            obj = mq.add_fem_mesh(self.part(Part.makeBox(10, 10, 2)))
        self.assertIn("100 elements: give max_edge", "".join(obj.Notes))
        self.assertEqual(fem_size.longest_edge(Part.makeBox(300, 300, 1), {**values, "max_edge": 7.0}), (7.0, ""))

    def test_shells_go_by_their_size(self):
        source = self.part(Part.makePlane(30, 40))
        obj = mq.add_fem_mesh(source)
        expected = fem_size.expected_elements(source.Shape, options.check(options.fem.FEM, {}))
        self.assertAlmostEqual(expected / obj.Elements, 1.0, delta=0.3)


class Follows(FemObjectTest):
    def test_source_and_options(self):
        source = self.cylinder()
        obj = mq.add_fem_mesh(source)
        source.Height = 20
        self.document.recompute()
        self.assertAlmostEqual(obj.FemMesh.BoundBox.ZMax, 20.0)
        self.assertEqual(obj.Status, "up to date")
        obj.Order = 1
        self.document.recompute()
        self.assertEqual(len(obj.FemMesh.getElementNodes(1)), 4)
        mq.update(obj, order=2, max_edge=3.0)
        self.assertEqual(len(obj.FemMesh.getElementNodes(1)), 10)
        obj.Recompute = "Manual"
        source.Height = 10
        self.document.recompute()
        self.assertIn("out of date", obj.Status)
        self.assertAlmostEqual(obj.FemMesh.BoundBox.ZMax, 20.0)

    def test_constraints_find_nodes_of_a_nested_and_moved_part(self):
        source = self.box()
        source.Placement = FreeCAD.Placement(FreeCAD.Vector(1, 2, 3), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 30))
        outer, inner = (self.document.addObject("App::Part", name) for name in ("Outer", "Inner"))
        outer.addObject(inner)
        inner.addObject(source)
        outer.Placement.Base, inner.Placement.Base = FreeCAD.Vector(100, 0, 0), FreeCAD.Vector(0, 50, 0)
        self.document.recompute()
        obj = mq.add_fem_mesh(source)
        self.assert_on(obj, source)
        outer.Placement.Base = FreeCAD.Vector(0, 0, 7)
        self.document.recompute()
        self.assert_on(obj, source)
        inner.addObject(obj)
        self.document.recompute()
        self.assert_on(obj, source)
        source.Placement.Base = FreeCAD.Vector(-5, 0, 0)
        self.document.recompute()
        self.assert_on(obj, source)

    def nested(self):
        source = self.box()
        source.Placement.Base = FreeCAD.Vector(1, 2, 3)
        outer, inner = (self.document.addObject("App::Part", name) for name in ("Outer", "Inner"))
        outer.addObject(inner)
        inner.addObject(source)
        outer.Placement.Base, inner.Placement.Base = FreeCAD.Vector(100, 0, 0), FreeCAD.Vector(0, 50, 0)
        self.document.recompute()
        return source, inner

    def test_it_stands_where_a_nested_part_is(self):
        source, inner = self.nested()
        obj = mq.add_fem_mesh(source)
        if fem_in_document():
            self.assertIsNone(obj.getParentGeoFeatureGroup())
        else:
            self.assertEqual(obj.getParentGeoFeatureGroup(), inner)
            self.assertEqual(frames.frame_of(obj).Base, FreeCAD.Vector(100, 50, 0))
        self.assert_seen_on(obj, source)
        self.assert_on(obj, source)
        self.assertIsNone(obj.Proxy.told(obj))
        # What the container holds is counted as before.
        self.assertEqual(mq.add_quality_mesh(inner).Mesh.CountFacets, mq.add_quality_mesh(source).Mesh.CountFacets)
        self.document.undo()
        self.document.undo()
        self.document.undo()
        self.assertEqual(inner.Group, [source])

    def test_in_an_analysis_elsewhere_it_says_that_it_stands_beside_and_the_remedy_helps(self):
        source, inner = self.nested()
        analysis = self.analysis()
        obj = mq.add_fem_mesh(source, analysis=analysis)
        beside = "put the analysis, or the mesh without one, into 'Inner'"
        if fem_in_document():
            self.assertIsNone(obj.Proxy.told(obj))
            self.assert_seen_on(obj, source)
        else:
            self.assertIn(beside, obj.Proxy.told(obj))
        inner.addObject(analysis)
        self.document.recompute()
        self.assertEqual((analysis.Group, frames.frame_of(obj).Base), ([obj], FreeCAD.Vector(100, 50, 0)))
        if fem_in_document():
            self.assertIn("take the mesh and its analysis out of 'Inner', 'Outer'", obj.Proxy.told(obj))
        else:
            self.assertIsNone(obj.Proxy.told(obj))
            self.assert_seen_on(obj, source)
        self.assert_on(obj, source)

    def assert_on(self, obj, source):
        """FreeCAD's constraints find the nodes of faces."""
        found = groups_of(obj.FemMesh)
        for i, face in enumerate(helpers.faces_as_fem_finds_them(source)):
            nodes = nodes_of(obj.FemMesh, found[f"Face{i + 1}"][1])
            self.assertEqual(nodes, set(obj.FemMesh.getNodesByFace(face)))
            self.assertGreater(len(nodes), 3)

    def assert_seen_on(self, obj, source):
        """The view has the mesh where it has the part."""
        points, box = ElementMesh.of(obj).nodes, convert.shape_of(source).BoundBox
        self.assertTrue(np.allclose(points.min(axis=0), (box.XMin, box.YMin, box.ZMin), atol=1e-5))
        self.assertTrue(np.allclose(points.max(axis=0), (box.XMax, box.YMax, box.ZMax), atol=1e-5))

    def test_loads_of_a_nested_part_are_written_for_calculix(self):
        from femtools.ccxtools import FemToolsCcx

        written = []
        for moved in (False, True):
            source, inner = self.nested() if moved else (self.box(), None)
            analysis = cantilever.add_analysis(source, "force")
            obj, folder = mq.add_fem_mesh(source, analysis=analysis), self.enterContext(tempfile.TemporaryDirectory())
            if moved:
                inner.Placement.Base = FreeCAD.Vector(0, -70, 3)  # after it was meshed
                self.document.recompute()
            tools = FemToolsCcx(analysis, next(found for found in analysis.Group if found.isDerivedFrom("Fem::FemSolverObjectPython")))
            tools.update_objects()
            tools.setup_working_dir(folder)
            tools.write_inp_file()
            with open(tools.inp_file_name, encoding="utf-8") as stream:
                text = stream.read()
            written.append(sorted(line for line in text.splitlines() if re.match(r"\d+,\d,-?\d", line)))
            self.assertIn("*CLOAD", text)
            self.assert_on(obj, source)
        self.assertGreater(len(written[0]), 3)
        self.assertEqual(len(written[0]), len(written[1]))

    def test_an_error_keeps_the_last_good_mesh_and_says_why(self):
        obj = mq.add_fem_mesh(self.cylinder())
        count = obj.FemMesh.VolumeCount
        obj.Order = 3
        self.document.recompute()
        self.assertFalse(obj.isValid())
        self.assertIn("order = 3", obj.getStatusString())
        obj.Order = 2
        self.document.recompute()
        self.assertTrue(obj.isValid())
        self.document.removeObject("Cylinder")
        self.document.recompute()
        self.assertIsNone(getattr(obj, fem_mesh.PART[0]))
        self.assertIn("source was deleted", obj.Status)
        self.assertEqual(obj.FemMesh.VolumeCount, count)


class Documents(FemObjectTest):
    def test_one_undo_step_with_its_place_in_the_analysis(self):
        source = self.cylinder()
        analysis = self.analysis(source)
        before = list(self.document.UndoNames)
        obj = mq.add_fem_mesh(source)
        name, count = obj.Name, obj.FemMesh.VolumeCount
        self.assertEqual(self.document.UndoNames, ["FEM mesh", *before])
        self.assertEqual(analysis.Group, [source, obj])
        self.document.undo()
        self.assertIsNone(self.document.getObject(name))
        self.assertEqual(analysis.Group, [source])
        self.document.redo()
        self.assertEqual(self.document.getObject(name).FemMesh.VolumeCount, count)
        self.assertEqual(analysis.Group, [source, self.document.getObject(name)])

    def test_a_failure_leaves_nothing_behind(self):
        source = self.cylinder()
        analysis = self.analysis(source)
        objects = list(self.document.Objects)
        for values, words in (({"order": 3}, "order"), ({"ordre": 2}, "ordre"), ({"analysis": source}, "Fem::FemAnalysis")):
            with self.subTest(words), self.assertRaisesRegex(mq.InvalidInput, words):
                mq.add_fem_mesh(source, **values)
        with self.assertRaisesRegex(mq.InvalidInput, "document object"):
            mq.add_fem_mesh(source.Shape)
        with self.assertRaisesRegex(mq.InvalidInput, "no faces"):
            mq.add_fem_mesh(self.part(Part.makeLine((0, 0, 0), (1, 0, 0))))
        self.document.removeObject("Part")
        self.assertEqual(self.document.Objects, objects)
        self.assertEqual(analysis.Group, [source])
        self.assertFalse(self.document.HasPendingTransaction)

    def test_a_freecad_without_fem_is_named(self):
        with mock.patch.dict(sys.modules, {"Fem": None}), self.assertRaisesRegex(mq.Error, "no FEM workbench"):
            mq.add_fem_mesh(self.cylinder())
        self.assertIs(fem.module(), sys.modules["Fem"])

    def test_a_given_analysis_takes_it_and_a_second_mesh_is_told(self):
        first, second = self.analysis(), self.analysis()
        source = self.cylinder()
        self.assertEqual(mq.add_fem_mesh(source).InList, [])
        obj = mq.add_fem_mesh(source, analysis=second)
        self.assertEqual((first.Group, second.Group), ([], [obj]))
        with mock.patch.object(FreeCAD.Console, "PrintWarning") as warned:
            other = mq.add_fem_mesh(source, analysis=second)
        self.assertEqual(second.Group, [obj, other])
        said = "".join(call.args[0] for call in warned.call_args_list)
        self.assertIn(f"'{second.Label}' has another mesh, '{obj.Label}'", said)

    def test_it_comes_back_from_a_file(self):
        obj = mq.add_fem_mesh(self.cylinder(), max_edge=4.0)
        name, found, quality = obj.Name, groups_of(obj.FemMesh), obj.MinDistortion
        points, first = obj.FemMesh.Nodes, obj.FemMesh.getElementNodes(1)
        self.reopen()
        again = self.document.getObject(name)
        self.assertEqual(type(again.Proxy).__module__, "MeshQuality.features.fem_mesh")
        self.assertEqual(groups_of(again.FemMesh), found)
        self.assertEqual(again.FemMesh.getElementNodes(1), first)
        for number, point in again.FemMesh.Nodes.items():
            self.assertLess((point - points[number]).Length, 1e-12)
        part = getattr(again, compat.fem_source_property())
        self.assertEqual((again.MaxEdge.Value, again.MinDistortion, part.Name), (4.0, quality, "Cylinder"))
        again.Notes = ["kept while the mesh is"]
        self.document.getObject("Cylinder").touch()
        self.document.recompute()
        self.assertEqual(again.Notes, ["kept while the mesh is"])
        self.document.getObject("Cylinder").Height = 12
        self.document.recompute()
        self.assertAlmostEqual(again.FemMesh.BoundBox.ZMax, 12.0)


@unittest.skipUnless(shutil.which("ccx"), "CalculiX (ccx) is not installed")
class CalculiX(FemObjectTest):
    def test_a_cantilever_bends_as_beam_theory_says(self):
        source = self.part(cantilever.beam(), "Beam")
        end = source.Shape.getElement(cantilever.face_at(source.Shape, "x", 1))
        for load, expected in cantilever.deflections().items():
            with self.subTest(load):
                analysis = cantilever.add_analysis(source, load)
                mesh = mq.add_fem_mesh(source, analysis=analysis, max_edge=8.0).FemMesh
                result = cantilever.solve(analysis, self.folder)
                self.assertAlmostEqual(cantilever.deflection(result, mesh, end) / expected, 1.0, delta=0.003)

    def test_the_largest_stress_by_default_is_that_of_beam_theory(self):
        found = cantilever.largest_stress("cantilever", self.folder)
        self.assertAlmostEqual(found["stress"] / cantilever.BORED_STRESS, 1.0, delta=0.1)
        self.assertAlmostEqual(found["expected"] / found["tetrahedra"], 1.0, delta=0.25)

    def test_each_solid_has_its_own_material(self):
        import ObjectsFem

        halves = [Part.makeBox(10, 10, 10, FreeCAD.Vector(x, 0, 0)) for x in (0, 10)]
        source = self.part(halves[0].generalFuse(halves[1:])[0])
        self.assertEqual(len(source.Shape.Solids), 2)
        analysis = cantilever.add_analysis(source, "pressure")
        for obj in list(analysis.Group):
            if "Material" in obj.Name or "Pressure" in obj.Name:
                self.document.removeObject(obj.Name)
        pressure = ObjectsFem.makeConstraintPressure(self.document)
        pressure.References = [(source, cantilever.face_at(source.Shape, "x", 1))]
        cantilever.set_load(pressure, "Pressure", 10.0, "MPa")
        analysis.addObject(pressure)
        young = {"Solid1": 200000.0, "Solid2": 50000.0}
        for name, value in young.items():
            material = ObjectsFem.makeMaterialSolid(self.document)
            material.Material = {"Name": name, "YoungsModulus": f"{value} MPa", "PoissonRatio": "0.0"}
            material.References = [(source, name)]
            analysis.addObject(material)
        mesh = mq.add_fem_mesh(source, analysis=analysis, max_edge=5.0).FemMesh
        self.assertEqual({name for name in groups_of(mesh) if name.startswith("Solid")}, set(young))
        result = cantilever.solve(analysis, self.folder)
        moved = min(vector.x for vector in result.DisplacementVectors)
        self.assertAlmostEqual(moved, -sum(10.0 * 10.0 / value for value in young.values()), delta=1e-6)
