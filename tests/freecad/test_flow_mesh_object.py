# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Flow mesh": layers, walls that follow the part, patches, files, pyramids in saved documents."""

import importlib.util
import os
import tempfile
import unittest
from unittest import mock

import FreeCAD
import helpers
import numpy as np
import Part
from FreeCAD import Vector
from test_volume_mesh import wedge

import MeshQuality as mq
from MeshQuality import options
from MeshQuality.core.volumes.volume_mesh import expected_cells
from MeshQuality.features import flow_mesh

HAS_FEM = importlib.util.find_spec("Fem") is not None


def groups_of(mesh):
    """{name: (kind, number of elements)} of a Fem.FemMesh."""
    return {mesh.getGroupName(group): (mesh.getGroupElementType(group), len(mesh.getGroupElements(group))) for group in mesh.Groups}


@unittest.skipUnless(HAS_FEM, "this FreeCAD has no FEM workbench")
class FlowMeshObject(helpers.DocumentTest):
    def part(self, shape):
        obj = self.document.addObject("Part::Feature", "Part")
        obj.Shape = shape
        self.document.recompute()
        return obj

    def pipe(self):
        obj = self.document.addObject("Part::Cylinder", "Pipe")
        obj.Radius, obj.Height = 5, 20
        self.document.recompute()
        return obj

    def added(self, source, **values):
        return mq.add_flow_mesh(source, 2, 0.1, **{"max_edge": 4.0, **values})

    def test_it_holds_the_mesh_of_its_options(self):
        source = self.pipe()
        obj = self.added(source, walls=["Face1"], patches={"inlet": ["Face3"], "outlet": ["Face2"]}, patch_rest="pipe")
        expected = mq.volume_mesh(source.Shape, 2, 0.1, max_edge=4.0, walls=["Face1"])
        self.assertEqual((obj.FemMesh.VolumeCount, obj.FemMesh.NodeCount), (sum(expected.report.elements.values()), len(expected.nodes)))
        self.assertEqual((obj.Elements, obj.NodeCount, obj.Covered), (obj.FemMesh.VolumeCount, len(expected.nodes), 1.0))
        self.assertEqual((obj.Certificate, obj.Label, obj.Coverage[0][:12]), ("met", "Pipe flow mesh", "Face1: 100 %"))
        found = groups_of(obj.FemMesh)
        self.assertEqual(found["fluid"], ("Volume", obj.Elements))
        for patch, face in (("inlet", "Face3"), ("outlet", "Face2"), ("pipe", "Face1")):
            self.assertEqual(found[patch], found[face])
        for option in options.volume.FLOW:
            self.assertEqual(obj.getTypeIdOfProperty(option.property_name), option.property_type)
        self.assertNotIn("Touched", obj.State)

    def test_it_follows_the_part_and_its_walls(self):
        box = self.document.addObject("Part::Box", "Box")
        cut, tool = self.document.addObject("Part::Cut", "Cut"), self.document.addObject("Part::Box", "Tool")
        tool.Length = tool.Width = tool.Height = 3
        tool.Placement.Base = Vector(-5, -5, -5)
        cut.Base, cut.Tool = box, tool
        self.document.recompute()
        top = next(f"Face{i}" for i, face in enumerate(cut.Shape.Faces, 1) if face.CenterOfMass.z > 9.99)
        obj = self.added(cut, walls=[top])
        self.assertEqual(obj.Walls, [top])
        tool.Placement.Base = Vector(-1, -1, -1)  # the faces get other numbers
        self.document.recompute()
        now = next(f"Face{i}" for i, face in enumerate(cut.Shape.Faces, 1) if face.CenterOfMass.z > 9.99)
        self.assertNotEqual(now, top)
        self.assertEqual((obj.Walls, obj.Status), ([now], "up to date"))
        self.assertEqual([line.split(":")[0] for line in obj.Coverage], [now])
        self.assertAlmostEqual(obj.MeshVolume.Value, cut.Shape.Volume, delta=0.01)
        with mock.patch.object(flow_mesh.FlowMeshObject, "compute", side_effect=AssertionError):
            obj.touch()
            self.document.recompute()

    def test_the_flow_around_a_part(self):
        obj = self.added(self.pipe(), far_field="box", far_distance=2.0, symmetry="y>", symmetry_at=0.0, patch_rest="pin")
        found = groups_of(obj.FemMesh)
        self.assertLessEqual({"xMin", "xMax", "yMax", "zMin", "zMax", "symmetry", "pin", "fluid"}, set(found))
        mesh = flow_mesh.volume_mesh_of(obj)
        self.assertEqual((mesh.patch_types["symmetry"], mesh.patch_types["pin"], mesh.patch_types["xMin"]), ("symmetry", "wall", "patch"))
        expected = mq.volume_mesh(obj.Source, 2, 0.1, max_edge=4.0, far_field="box:2", symmetry="y>0")
        self.assertEqual(sum(expected.report.elements.values()), obj.Elements)

    def test_what_layers_do_not_cover_is_in_the_certificate(self):
        obj = mq.add_flow_mesh(self.part(wedge(20)), 3, 0.05, max_edge=1.5)
        self.assertTrue(obj.Certificate.startswith("not met: layers do not cover all of "))
        report = mq.volume_mesh(obj.Source, 3, 0.05, max_edge=1.5).report
        self.assertEqual(obj.CertificateFaces, [wall.face for wall in report.walls if wall.covered < 1.0])
        self.assertIn("layers cover ", obj.Proxy.told(obj))
        corners = np.array(obj.CertificatePlace)
        self.assertEqual(corners.shape, (3, 3))

    def test_a_saved_document_has_its_pyramids(self):
        obj = mq.add_flow_mesh(self.part(wedge(20)), 3, 0.05, max_edge=1.5)
        count, name, kinds = obj.Elements, obj.Name, list(obj.Kinds)
        self.assertTrue(any(line.startswith("pyramid") for line in kinds))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "flow.FCStd")
            self.document.saveCopy(path)
            opened = FreeCAD.openDocument(path, True)
        self.addCleanup(FreeCAD.closeDocument, opened.Name)
        obj = opened.getObject(name)
        self.assertEqual((obj.FemMesh.VolumeCount, groups_of(obj.FemMesh)["fluid"]), (count, ("Volume", count)))
        mesh = flow_mesh.volume_mesh_of(obj)
        certificate = mq.certify(mesh)
        self.assertEqual((certificate.invalid, certificate.conforming, certificate.oriented), (0, True, True))
        self.assertEqual([f"{kind}: {len(rows)}" for kind, rows in mesh.solid_blocks], kinds)

    def test_files_have_patches_and_no_faces_twice(self):
        obj = self.added(self.pipe(), walls=["Face1"], patches={"inlet": ["Face3"]}, patch_rest="pipe")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "pipe.su2")
            mq.export_mesh(obj, path)
            with open(path, encoding="utf-8") as stream:
                text = stream.read()
        self.assertEqual(text.count("MARKER_TAG="), 2)

    def test_a_case_is_the_same_as_that_of_the_mesh(self):
        source = self.pipe()
        patches = {"inlet": ["Face3"], "outlet": ["Face2"]}
        obj = self.added(source, walls=["Face1"], patches=patches, patch_rest="pipe")
        expected = mq.volume_mesh(source.Shape, 2, 0.1, max_edge=4.0, walls=["Face1"], patches=patches, patch_rest="pipe")
        texts = []
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(mq.write_openfoam_case(obj, os.path.join(folder, "object")), {})
            expected.write(os.path.join(folder, "mesh"))
            for name in ("object", "mesh"):
                with open(os.path.join(folder, name, "constant", "polyMesh", "boundary"), encoding="utf-8") as stream:
                    texts.append(sorted(stream.read().replace(";", " ").split()))
        self.assertEqual([word for word in texts[0] if not word.isdigit()], [word for word in texts[1] if not word.isdigit()])

    def test_walls_in_a_container(self):
        box, group = self.document.addObject("Part::Box", "Box"), self.document.addObject("App::Part", "Group")
        group.addObject(box)
        group.Placement.Base = Vector(0, 0, 50)
        self.document.recompute()
        obj = self.added(group, walls=["Box.Face1"], patches={"wall": ["Box.Face1"]})
        self.assertEqual((obj.Walls, obj.Coverage[0][:12]), (["Box.Face1"], "Face1: 100 %"))
        self.assertEqual(flow_mesh.volume_mesh_of(obj).patch_types, {"wall": "wall", **{f"Face{i}": "patch" for i in range(2, 7)}})
        box.Length = 12
        self.document.recompute()
        self.assertAlmostEqual(obj.MeshVolume.Value, box.Shape.Volume, delta=0.01)

    def test_copies_links_and_undo(self):
        obj = mq.add_flow_mesh(self.part(wedge(20)), 3, 0.05, max_edge=1.5)
        count = obj.Elements
        copy = self.document.copyObject(obj, False)
        self.document.recompute()
        self.assertEqual((copy.FemMesh.VolumeCount, copy.Source), (count, obj.Source))
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject, link.LinkPlacement = obj, FreeCAD.Placement(Vector(0, 0, 7), FreeCAD.Rotation())
        self.document.recompute()
        self.assertAlmostEqual(flow_mesh.volume_mesh_of(link).nodes[:, 2].min(), 7.0)
        self.document.UndoMode = 1
        mq.update(obj, layers=2)
        self.assertNotEqual(obj.Elements, count)
        self.document.undo()
        with self.assertRaisesRegex(mq.InvalidInput, "out of date"):  # FreeCAD does not bring back the mesh
            flow_mesh.volume_mesh_of(obj)
        obj.touch()
        self.document.recompute()
        self.assertEqual((obj.Layers, obj.Elements, flow_mesh.volume_mesh_of(obj).prisms.shape[0] % 3), (3, count, 0))

    def test_what_is_refused(self):
        source = self.pipe()
        for values, words in (({"walls": ["Face9"]}, "a wall names Face9, but 'Pipe' has faces Face1 to Face3"),
                              ({"walls": "Face1"}, "give a list of faces"), ({"far_field": "cone"}, "far_field"),
                              ({"walls": ["Face2"]}, "Face1 is not plane"), ({"patches": {"inlet": ["Face7"]}}, "Face7"),
                              ({"patches": {"fluid": ["Face2"]}}, "patch 'fluid' has the name of a group"), ({"patch_rest": "xMin"}, "patch 'xMin'")):
            with self.subTest(values), self.assertRaisesRegex(mq.InvalidInput, words):
                self.added(source, **values)
            self.assertEqual(self.document.Objects, [source])

    def test_cells_are_expected_by_the_surface(self):
        shape = Part.makeCylinder(5, 20)
        for values in ({"layers": 1, "first_height": 0.05, "max_edge": 1.5}, {"layers": 1, "first_height": 0.1, "max_edge": 3.0, "growth_inside": 0.8},
                       {"layers": 3, "first_height": 0.1, "max_edge": 3.0, "far_field": "box:2", "growth_inside": 0.8}):
            made = sum(mq.volume_mesh(shape, **values).report.elements.values())
            told, whole = expected_cells(shape, 50_000, **values)
            self.assertTrue(whole)
            self.assertLess(abs(told / made - 1.0), 0.2, (told, made))
        self.assertFalse(expected_cells(shape, 100, layers=2, first_height=0.1, max_edge=1.0)[1])
