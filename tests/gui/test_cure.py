# SPDX-License-Identifier: LGPL-2.1-or-later
"""Certify and cure in the window: the command, what the panel tells, the analysis, and the quality of FEM meshes."""

import importlib.util
import os
import shutil
import sys
import unittest

import FreeCAD
import FreeCADGui
import given_meshes
import gui_helpers
import helpers
import numpy as np
import test_language
from PySide import QtGui

import MeshQuality as mq
from MeshQuality.gui import commands, fem_quality_data, quality_data
from MeshQuality.gui.panels import quality_panel

sys.path.append(os.path.join(helpers.ROOT, "benchmarks", "solvers"))
import cantilever  # noqa: E402

HAS_FEM = importlib.util.find_spec("Fem") is not None
if HAS_FEM:
    import FemGui
FOLDED = 2  # elements, all around without a face on the surface
MAGENTA = (255, 32, 255)  # of what lights up


@unittest.skipUnless(HAS_FEM, "this FreeCAD has no FEM workbench")
class CureTest(gui_helpers.PanelTest):
    def setUp(self):
        super().setUp()
        self.part = self.document.addObject("Part::Feature", "Shaft")
        self.part.Shape = cantilever.bracket()
        self.given = self.document.addObject("Fem::FemMeshObject", "Given")
        self.given.FemMesh = given_meshes.straight_mesh(self.part.Shape, 8.0,
                                                         given_meshes.inside(self.part.Shape, 8.0)[:FOLDED])
        self.document.recompute()


class Command(CureTest):
    def test_it_cures_and_tells(self):
        analysis = cantilever.add_analysis(self.part, "weight")
        analysis.addObject(self.given)
        group = analysis.Group
        objects = self.document.Objects
        panel = self.panel(commands.Cure, self.given, self.part)
        texts = [label.text() for label in panel.form.findChildren(QtGui.QLabel)]
        self.assertIn("Source: Shaft, Given", texts)
        self.apply(panel)
        self.assertEqual(panel.said, "")
        obj = next(obj for obj in self.document.Objects if obj not in objects)
        invalid, count = mq.certify(self.given).invalid, self.given.FemMesh.VolumeCount
        self.assertGreaterEqual(invalid, FOLDED)
        told = panel.certificate.text.text()
        self.assertIn(f"Given mesh: {invalid} of {count:,} elements are not proven valid, now 0 of ", told)
        self.assertIn("\nAll requested limits are met.", told)
        self.narrow(panel, "panel_cure")
        panel.reject()
        self.assertEqual((analysis.Group, self.document.UndoNames[0]),
                         ([*(member for member in group if member != self.given), obj], "Certify and cure"))
        self.assertEqual((self.given.ViewObject.Visibility, obj.ViewObject.Visibility), (False, True))
        views = [view.toPlainText() for view in FreeCADGui.getMainWindow().findChildren(QtGui.QTextEdit)]
        report = next(text for text in views if "Shaft cured mesh: " in text)
        self.assertIn("given mesh: ", report)
        self.assertIn("it takes the place of 'Given'", report)
        self.document.undo()
        self.assertEqual((self.document.Objects, analysis.Group), (objects, group))

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX (ccx) is not installed")
    def test_the_window_of_fem_solves_on_it(self):
        self.part.Shape = cantilever.beam()
        self.given.FemMesh = given_meshes.straight_mesh(self.part.Shape, 6.0,
                                                         given_meshes.inside(self.part.Shape, 6.0)[:FOLDED])
        analysis = cantilever.add_analysis(self.part, "force")
        analysis.addObject(self.given)
        self.apply(self.panel(commands.Cure, self.given, self.part))
        FreeCADGui.Control.closeDialog()
        cured = next(obj for obj in analysis.Group if obj.isDerivedFrom("Fem::FemMeshObject"))
        self.assertNotEqual(cured, self.given)
        FreeCADGui.activateWorkbench("FemWorkbench")
        self.addCleanup(FreeCADGui.activateWorkbench, "MeshQualityWorkbench")
        FemGui.setActiveAnalysis(analysis)
        self.select(next(obj for obj in analysis.Group if "Solver" in obj.Name))
        gui_helpers.wait(0.5)
        FreeCADGui.runCommand("FEM_SolverRun")
        results = [obj for obj in analysis.Group if obj.isDerivedFrom("Fem::FemResultObject")]
        self.assertEqual(len(results), 1)
        end = self.part.Shape.getElement(cantilever.face_at(self.part.Shape, "x", 1))
        found = cantilever.deflection(results[0], cured.FemMesh, end)
        self.assertAlmostEqual(found / cantilever.deflections()["force"], 1.0, delta=0.01)
        gui_helpers.screen().save(os.path.join(gui_helpers.PICTURES, "cure_solved.png"))

    def test_a_mesh_says_what_it_is_of(self):
        self.select(self.given)
        self.assertFalse(commands.Cure().IsActive())
        self.given.addProperty("App::PropertyLink", "Part")
        self.given.Part = self.part
        self.assertEqual(commands.Cure().selected(), [self.part, self.given])
        self.select(self.part)
        self.assertFalse(commands.Cure().IsActive())


class Nested(CureTest):
    """A part in containers that are turned and moved, in German and in inches."""

    def setUp(self):
        super().setUp()
        inner, outer = (self.document.addObject("App::Part", name) for name in ("Innen", "Aussen"))
        inner.addObject(self.part)
        outer.addObject(inner)
        inner.Placement = FreeCAD.Placement(FreeCAD.Vector(3, 0, 0), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 30))
        outer.Placement = FreeCAD.Placement(FreeCAD.Vector(0, 70, 0), FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), 50))
        self.part.Label, self.given.Label = "Welle", "Vorgabe"
        self.addCleanup(gui_helpers.use_units, gui_helpers.MM)
        gui_helpers.use_units(gui_helpers.INCHES)
        FreeCADGui.setLocale("German")
        self.addCleanup(FreeCADGui.setLocale, "English")
        gui_helpers.wait(0.2)

    def test_it_cures_and_tells(self):
        panel = self.panel(commands.Cure, self.given, self.part)
        gui_helpers.unfold(panel)
        self.apply(panel)
        self.assertEqual(panel.said, "")
        told = panel.certificate.text.text()
        self.assertIn(" von ", told)
        self.assertNotIn("veraltet", told)
        self.assertNotRegex(told, r"\bmm\b|µm")
        for text in test_language.shown_texts(panel.form):
            self.assertIsNone(test_language.ENGLISH.search(text), text)
        self.narrow(panel, "panel_cure_nested_de_inches")
        gui_helpers.wait(0.3)
        gui_helpers.screen().save(os.path.join(gui_helpers.PICTURES, "window_cure_nested_de_inches.png"))
        panel.reject()
        obj = next(obj for obj in self.document.Objects if "GivenInvalid" in obj.PropertiesList)
        self.assertEqual(obj.Status, "up to date")
        self.assertEqual(mq.certify(obj, self.part).invalid, 0)
        self.assertLess(mq.certify(obj, self.part).max_deviation, 0.1)

    def test_its_quality(self):
        self.given.addProperty("App::PropertyLink", "Part")
        self.given.Part = self.part
        panel = quality_panel.open_panel(self.given)
        self.addCleanup(lambda: panel.ended or panel.reject())
        self.until(lambda: panel.values is not None)
        for text in test_language.shown_texts(panel.form):
            self.assertIsNone(test_language.ENGLISH.search(text), text)
        self.assertNotRegex(panel.summary.text(), r"\bmm\b|µm")
        self.narrow(panel, "quality_given_nested_de_inches")


class Quality(CureTest):
    def setUp(self):
        super().setUp()
        self.given.addProperty("App::PropertyLink", "Part")
        self.given.Part = self.part

    def open(self, obj):
        panel = quality_panel.open_panel(obj)
        self.addCleanup(lambda: panel.ended or panel.reject())
        self.until(lambda: panel.values is not None)
        return panel

    def test_invalid_elements_are_marked_and_listed_first(self):
        self.select(self.given)
        self.assertTrue(commands.Analyse().IsActive())
        found = mq.certify(self.given)
        panel = self.open(self.given)
        own = [fem_quality_data.JACOBIAN_RATIO, quality_data.DISTORTION, fem_quality_data.DIHEDRAL, quality_data.ASPECT,
               fem_quality_data.VOLUME, quality_data.DISTANCE]
        self.assertEqual(panel.data.measures[:len(own)], own)
        self.assertIn("Aspect ratio", [measure.title for measure in panel.data.measures[len(own):]])
        self.assertFalse(self.part.ViewObject.Visibility)
        np.testing.assert_array_equal(panel.values, found.distortion[0])
        self.assertEqual(np.flatnonzero(panel.lit).tolist(), np.flatnonzero(found.distortion[0] <= 0.0).tolist())
        self.assertIn(f"{found.invalid} of {self.given.FemMesh.VolumeCount:,} are not proven valid.", panel.summary.text())
        worst = int(found.distortion[0].argmin())
        self.assertTrue(panel.worst.item(0).text().startswith("-"))
        self.assertIn(f"element {worst + 1}", panel.worst.item(0).text())
        pixels = self.picture("quality_given_fem_mesh")
        self.assertGreater((pixels < 250).any(axis=2).mean(), 0.05)
        gui_helpers.screen().save(os.path.join(gui_helpers.PICTURES, "quality_given_fem_mesh_window.png"))
        panel.worst.setCurrentRow(0)
        self.until(lambda: not panel.scene.flight.active)
        self.assertEqual(np.flatnonzero(panel.lit).tolist(), [worst])
        self.assertTrue(panel.data.is_inside(worst))
        shown = panel.scene.scene.triangles
        self.assertLess(shown, len(panel.data.corners))
        gui_helpers.wait(0.3)
        pixels = self.saved("quality_inside")
        self.assertGreater((np.abs(pixels - np.array(MAGENTA)) < 40).all(axis=2).mean(), 0.0005)
        panel.histogram.picked.emit(-1, -1)
        self.assertEqual(panel.scene.scene.triangles, len(panel.data.corners))
        panel.reject()
        self.assertTrue(self.part.ViewObject.Visibility)

    def test_every_measure_of_elements_has_values(self):
        obj = mq.add_cured_mesh(self.given, self.part)
        panel = self.open(obj)
        self.assertIn(f"All {obj.FemMesh.VolumeCount:,} proven valid.", panel.summary.text())
        for measure in panel.data.measures:
            panel.measures.setCurrentIndex(panel.data.measures.index(measure))
            self.until(lambda measure=measure: panel.measure is measure)
            self.assertEqual(len(panel.values), obj.FemMesh.VolumeCount)
            self.assertGreater(panel.worst.count(), 0)
        volume = panel.data.contents.sum()
        self.assertAlmostEqual(volume, obj.FemMesh.Volume.Value, delta=0.02 * volume)  # of straight sides
        panel.measures.setCurrentIndex(panel.data.measures.index(fem_quality_data.DIHEDRAL))
        gui_helpers.wait(0.3)
        gui_helpers.screen().save(os.path.join(gui_helpers.PICTURES, "quality_dihedral.png"))
        panel.reject()

    def test_a_cured_mesh_has_its_distance(self):
        obj = mq.add_cured_mesh(self.given, self.part)
        panel = self.open(obj)
        self.assertGreater(panel.values.min(), 0.0)
        self.assertFalse(panel.lit.any())
        panel.measures.setCurrentIndex(panel.data.measures.index(quality_data.DISTANCE))
        self.until(lambda: panel.measure is quality_data.DISTANCE)
        found = mq.certify(obj, self.part)
        self.assertAlmostEqual(np.nanmax(panel.values), found.max_deviation, places=9)
        self.assertEqual(panel.faces.rowCount(), len(self.part.Shape.Faces))
        inside = int(np.flatnonzero(np.isnan(panel.values))[0])
        chosen = np.arange(panel.data.elements) == inside
        self.assertEqual(panel.data.triangles_of(chosen).shape, (16, 3, 3))
        self.picture("quality_cured_fem_mesh")
