# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids of meshes of the document: exact surfaces of what these were made of, edits, undo, saving, the command line."""

import json
import math
import os

import FreeCAD
import helpers
import Mesh
import Part
import test_cli

import MeshQuality as mq


class Objects(helpers.DocumentTest):
    def part(self, shape, name="Part"):
        source = self.document.addObject("Part::Feature", name)
        source.Shape = shape
        self.document.recompute()
        return source

    def check(self, solid, volume, faces):
        self.assertTrue(solid.Shape.isValid() and solid.Shape.Solids)
        self.assertEqual((solid.ExactFaces, solid.FacetCount, solid.Notes), (faces, 0, []))
        self.assertAlmostEqual(solid.Shape.Volume / volume, 1.0, places=6)
        self.assertLessEqual(max(solid.Deviation.Value, solid.DeviationBack.Value), solid.AllowedDeviation.Value)
        self.assertEqual(len(solid.Shape.Faces), faces)

    def test_meshes_of_each_kind_that_know_their_cad(self):
        cylinder, box = self.part(Part.makeCylinder(5, 20)), self.part(Part.makeBox(10, 20, 30), "Box")
        self.check(mq.add_solid(mq.add_quality_mesh(cylinder)), math.pi * 500, 3)
        self.check(mq.add_solid(mq.add_offset(box, -2.0)), 6 * 16 * 26, 6)
        hollow = mq.add_hollow(box, 2.0, ["Face6"])
        self.check(mq.add_solid(hollow), 6000 - 6 * 16 * 28, 11)
        drill = self.part(Part.makeCylinder(1.5, 40, FreeCAD.Vector(5, 10, -5)), "Drill")
        made = mq.add_solid(mq.add_boolean(hollow, drill, "difference"))
        self.check(made, 6000 - 6 * 16 * 28 - math.pi * 2.25 * 2, 12)
        self.assertEqual({type(face.Surface).__name__ for face in made.Shape.Faces}, {"Plane", "Cylinder"})

    def test_in_a_moved_container(self):
        box = self.part(Part.makeBox(10, 20, 30))
        around = self.document.addObject("App::Part", "Around")
        around.addObject(box)
        around.Placement = FreeCAD.Placement(FreeCAD.Vector(100, 0, 0), FreeCAD.Rotation(FreeCAD.Vector(1, 1, 0), 30))
        self.document.recompute()
        made = mq.add_solid(mq.add_hollow(box, 2.0))
        self.check(made, 6000 - 6 * 16 * 26, 12)
        self.assertLess((made.Shape.CenterOfMass - around.Placement.multVec(FreeCAD.Vector(5, 10, 15))).Length, 1e-6)

    def test_it_follows_edits_undo_and_saving(self):
        source = self.document.addObject("Part::Cylinder", "Cylinder")
        source.Radius, source.Height = 5, 20
        self.document.recompute()
        made = mq.add_solid(mq.add_quality_mesh(source))
        source.Height = 30
        self.document.recompute()
        self.check(made, math.pi * 750, 3)
        name = made.Name
        self.document.UndoMode = 1
        other = mq.add_solid(made.Source)
        other_name = other.Name
        self.document.undo()
        self.assertIsNone(self.document.getObject(other_name))
        self.document.redo()
        self.check(self.document.getObject(other_name), math.pi * 750, 3)
        self.reopen()
        self.check(self.document.getObject(name), math.pi * 750, 3)

    def test_meshes_of_no_cad_have_facets(self):
        mesh = self.document.addObject("Mesh::Feature", "Given")
        mesh.Mesh = Mesh.createBox(10, 20, 30)
        made = mq.add_solid(mesh)
        self.assertEqual((made.ExactFaces, made.FacetCount), (0, 6))
        self.assertAlmostEqual(made.Shape.Volume, 6000.0, places=3)
        self.assertEqual(made.Notes, ["the mesh does not know the CAD it was made of"])

    def test_what_is_refused_adds_nothing(self):
        count = len(self.document.Objects)
        mesh = self.document.addObject("Mesh::Feature", "Given")
        mesh.Mesh = Mesh.createBox(10, 20, 30)
        with self.assertRaisesRegex(mq.GeometryError, "does not know the CAD"):
            mq.add_solid(mesh, facets=False)
        mesh.Mesh = Mesh.Mesh(mesh.Mesh.Topology[0][0:0] or [tuple(point) for facet in mesh.Mesh.Facets[:4] for point in facet.Points])
        with self.assertRaisesRegex(mq.InvalidInput, "not closed, manifold and oriented: repair it first"):
            mq.add_solid(mesh)
        box = self.part(Part.makeBox(1, 2, 3))
        with self.assertRaisesRegex(mq.InvalidInput, "'Part' holds no mesh|Part holds no mesh"):
            mq.add_solid(box)
        self.assertEqual(len(self.document.Objects), count + 2)


class CommandLine(helpers.DocumentTest):
    def test_solids_in_step(self):
        part, shell, given, facets = (os.path.join(self.folder, name) for name in ("part.step", "shell.step", "part.stl", "facets.stp"))
        box = Part.makeBox(10, 20, 30)
        box.exportStep(part)
        status, out, err = test_cli.run("hollow", part, "--thickness", "2", "-o", shell)
        self.assertEqual(status, 0, err)
        self.assertIn("a solid of 12 exact faces", "".join(err))
        back = Part.Shape()
        back.read(shell)
        self.assertAlmostEqual(back.Volume, 6000 - 6 * 16 * 26, places=3)
        mq.triangulate(box).write(given)
        status, out, err = test_cli.run("to-solid", given, "-o", facets, "--json")
        self.assertEqual(status, 0, err)
        report = json.loads("".join(out))
        self.assertEqual((report["faces"], report["facets"]), (0, 6))
        self.assertIn("does not know the CAD", report["notes"][0])
        back.read(facets)
        self.assertAlmostEqual(back.Volume, 6000.0, places=3)
        status, _, err = test_cli.run("to-solid", given, "-o", os.path.join(self.folder, "part.ply"))
        self.assertEqual(status, 2)
