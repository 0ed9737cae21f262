# SPDX-License-Identifier: LGPL-2.1-or-later
"""CFD surfaces in the window: command, picture, and CfdOF with OpenFOAM, where these are installed."""

import importlib.util
import os
import shutil
import subprocess
import sys
import unittest

import FreeCAD
import FreeCADGui
import gui_helpers
import numpy as np
import Part

import MeshQuality as mq
from MeshQuality.features import cfd_surface
from MeshQuality.gui import commands, quantities

if os.environ.get("MESHQUALITY_CFDOF"):  # a clone of it that is no addon
    sys.path.append(os.environ["MESHQUALITY_CFDOF"])

# Where it is not so, test_a_binary_that_cannot_take_shapes_in_place_refuses_it alone says what becomes of it.
needs_live = unittest.skipUnless(cfd_surface._can_be_undone(), "this core has a kernel of its own and shares no shape in place")


class CfdSurfaces(gui_helpers.PanelTest):
    def tee(self):
        """A quality mesh of a pipe with a branch, with patches."""
        obj = self.document.addObject("Part::Feature", "Tee")
        obj.Shape = Part.makeCylinder(5, 40).fuse(Part.makeCylinder(3, 30, FreeCAD.Vector(0, 0, 20), FreeCAD.Vector(1, 0, 0)))
        self.document.recompute()
        patches = {}
        for i, face in enumerate(obj.Shape.Faces):
            centre = face.CenterOfMass
            name = "inlet" if abs(centre.z) < 1e-6 else "outlet" if abs(centre.z - 40) < 1e-6 else \
                "branch" if abs(centre.x - 30) < 1e-6 else "walls"
            patches.setdefault(name, []).append(f"Face{i + 1}")
        self.assertEqual(len(patches), 4)
        mesh = mq.add_quality_mesh(obj, chord_height=0.02)
        mq.set_patches(mesh, patches)
        return mesh

    @needs_live
    def test_the_command_makes_a_coloured_shape_in_place_of_the_mesh(self):
        mesh = self.tee()
        mq.set_patches(mesh, {"inlet": {"faces": ["Face1"], "colour": "#ff0000"}}, patch_rest="walls")
        box, command = self.box(), commands.CfdSurface()
        for chosen, active in (((box,), False), ((), False), ((mesh,), True)):
            self.select(*chosen)
            self.assertEqual(command.IsActive(), active)
        with gui_helpers.mock.patch.object(FreeCAD.Console, "PrintMessage") as told:
            command.Activated()
        obj = self.document.ActiveObject
        self.assertEqual(FreeCADGui.Selection.getSelection(), [obj])
        self.assertEqual(told.call_args[0][0], f"{obj.Label}: Face1: inlet, Face2: walls; a point inside, for snappyHexMesh: "
                                               f"{', '.join(map(quantities.text_of, obj.PointInside))}\n")
        self.assertEqual(obj.TypeId, "Part::FeaturePython")
        self.assertFalse(mesh.ViewObject.Visibility)
        self.assertEqual(obj.ViewObject.DiffuseColor[obj.Patches.index("Face1: inlet")][:3], (1.0, 0.0, 0.0))
        box.ViewObject.Visibility = False
        image = self.picture("cfd_surface")
        self.assertGreater(np.count_nonzero(image.max(axis=2) - image.min(axis=2) > 60), 5000)

    @needs_live
    def test_undo_of_what_it_follows(self):
        """FreeCAD keeps shapes without their triangles for undoing, and ended where faces had no surface either."""
        part = self.document.addObject("Part::Cylinder", "Main")
        part.Radius, part.Height = 20, 160
        self.document.recompute()
        mesh = mq.add_quality_mesh(part)
        mq.set_patches(mesh, {"inlet": ["Face2"], "outlet": ["Face3"]}, patch_rest="walls")
        surface = mq.add_cfd_surface(mesh)
        FreeCADGui.updateGui()

        def set_placement():
            surface.Placement.Base = FreeCAD.Vector(50, 0, 0)

        edits = {
            "part": lambda: setattr(part, "Radius", 25), "option": lambda: setattr(mesh, "MinAngle", 20),
            "patches": lambda: mq.set_patches(mesh, {"inlet": ["Face3"], "outlet": ["Face2"]}, patch_rest="walls"),
            "placement": set_placement}
        for name, edit in edits.items():
            with self.subTest(edit=name):
                before = [len(face.tessellate(1.0)[1]) for face in surface.Shape.Faces]
                self.assertEqual(sum(before), mesh.Mesh.CountFacets)
                self.document.openTransaction(name)
                edit()
                self.document.recompute()
                self.document.commitTransaction()
                FreeCADGui.updateGui()
                after = [len(face.tessellate(1.0)[1]) for face in surface.Shape.Faces]
                for step, expected in ((self.document.undo, before), (self.document.redo, after),
                                       (self.document.undo, before)):
                    step()
                    FreeCADGui.updateGui()
                    self.assertEqual([len(face.tessellate(1.0)[1]) for face in surface.Shape.Faces], expected)

    @needs_live
    def test_a_new_mesh_is_seen_in_place_of_all_that_is_made_of_its_source(self):
        box, other = self.two_boxes()
        net = mq.add_quality_mesh(box)
        surface, improved, apart = mq.add_cfd_surface(net), mq.add_improved_mesh(net), mq.add_quality_mesh(other)
        for obj in (net, surface, improved, apart):
            obj.ViewObject.Visibility = True
        again = mq.add_quality_mesh(box)
        self.assertEqual([obj.ViewObject.Visibility for obj in (again, net, surface, improved, apart)], [True, False, False, False, True])

    def test_an_open_mesh_is_told(self):
        face = self.document.addObject("Part::Feature", "Face")
        face.Shape = Part.makePlane(10, 10)
        self.document.recompute()
        mesh = mq.add_quality_mesh(face)
        self.select(mesh)
        objects = list(self.document.Objects)
        with gui_helpers.mock.patch.object(FreeCAD.Console, "PrintError") as told:
            commands.CfdSurface().Activated()
        self.assertIn("closed surface", told.call_args[0][0])
        self.assertEqual(self.document.Objects, objects)

    def test_a_binary_that_cannot_take_shapes_in_place_refuses_it(self):
        part = self.document.addObject("Part::Box", "Part")
        self.document.recompute()
        mesh = mq.add_quality_mesh(part)
        objects = list(self.document.Objects)
        with gui_helpers.mock.patch.object(cfd_surface, "_can_be_undone", lambda: False), \
                self.assertRaisesRegex(mq.InvalidInput, "'Part quality mesh'.*built for this FreeCAD.*STL"):
            mq.add_cfd_surface(mesh)
        self.assertEqual(self.document.Objects, objects)

    @needs_live
    def test_cfdof_meshes_it_with_our_triangles(self):
        if importlib.util.find_spec("CfdOF") is None:
            self.skipTest("CfdOF is missing: install the addon, or name a clone of it in MESHQUALITY_CFDOF")
        self.import_cfdof()
        mesh = self.tee()
        surface = mq.add_cfd_surface(mesh)
        for utility in ("snappyHexMesh", "cfMesh"):
            case = self.case_of(surface, utility)
            with open(os.path.join(case, "constant", "triSurface", f"{surface.Name}_Geometry.stl"), encoding="utf-8") as stream:
                text = stream.read()
            self.assertEqual(text.count("endfacet"), mesh.Mesh.CountFacets)
            self.assertEqual(text.count("endsolid"), 4)
        programs = ("surfaceFeatureExtract", "blockMesh", "snappyHexMesh")
        if not all(map(shutil.which, programs)):
            self.skipTest("snappyHexMesh is missing: Debian's package openfoam has it")
        case = os.path.join(self.folder, "snappyHexMesh", "meshCase")
        for program in programs:
            done = subprocess.run([program, *(["-overwrite"] if program == "snappyHexMesh" else [])], cwd=case,
                                  capture_output=True, text=True, check=False, stdin=subprocess.DEVNULL,
                                  env={**os.environ, "WM_PROJECT_DIR": "/usr/share/openfoam"})
            self.assertEqual(done.returncode, 0, done.stdout[-2000:])
        self.assertIn("Finished meshing without any errors", done.stdout)
        with open(os.path.join(case, "constant", "polyMesh", "boundary"), encoding="utf-8") as stream:
            boundary = stream.read()
        for number in range(1, 5):
            self.assertIn(f"patch_{number}_0", boundary)

    def import_cfdof(self):
        """CfdOF asks for PySide.QtWidgets, which FreeCAD has from 0.21 on."""
        if importlib.util.find_spec("PySide.QtWidgets") is None:
            import PySide
            from PySide2 import QtWidgets

            PySide.QtWidgets = sys.modules["PySide.QtWidgets"] = QtWidgets

    def case_of(self, surface, utility):
        """The folder of the mesh case that CfdOF writes, with a boundary for each patch."""
        from CfdOF import CfdAnalysis, CfdTools
        from CfdOF.Mesh import CfdMesh, CfdMeshTools
        from CfdOF.Solve import CfdFluidBoundary

        CfdTools.setFoamDir("/usr/share/openfoam")
        analysis = CfdAnalysis.makeCfdAnalysis(f"Analysis_{utility}")
        CfdTools.setActiveAnalysis(analysis)
        analysis.OutputPath = os.path.join(self.folder, utility)
        os.mkdir(analysis.OutputPath)
        for line in surface.Patches:
            face, name = line.split(": ")
            boundary = CfdFluidBoundary.makeCfdFluidBoundary(name)
            boundary.ShapeRefs = [(surface, (face,))]
            analysis.addObject(boundary)
        mesh = CfdMesh.makeCfdMesh("CfdMesh")
        analysis.addObject(mesh)
        mesh.Part, mesh.MeshUtility, mesh.CharacteristicLengthMax = surface, utility, "2 mm"
        mesh.PointInMesh = {axis: f"{value} mm" for axis, value in zip("xyz", surface.PointInside)}
        CfdMeshTools.CfdMeshTools(mesh).writeMesh()
        FreeCADGui.updateGui()
        return os.path.join(analysis.OutputPath, "meshCase")
