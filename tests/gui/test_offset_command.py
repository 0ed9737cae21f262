# SPDX-License-Identifier: LGPL-2.1-or-later
"""Offset and Hollow: from the selection, with faces as openings, over the panel to the mesh."""

from unittest import mock

import FreeCAD
import FreeCADGui
import gui_helpers
import Mesh
import numpy as np
import Part
from PySide import QtCore, QtGui

import MeshQuality as mq
from MeshQuality.features import mesh_object
from MeshQuality.gui import background_recompute, commands, jobs, quantities
from MeshQuality.gui.panels.mesh_panel import MeshPanel

TOLERANCE = 0.05


class SolidCommands(gui_helpers.PanelTest):
    def setUp(self):
        super().setUp()
        self.addCleanup(gui_helpers.use_units, gui_helpers.MM)
        self.cube = self.box(Length=10, Width=10, Height=10)
        faces = self.cube.Shape.Faces
        self.top = f"Face{max(range(6), key=lambda i: faces[i].CenterOfMass.z) + 1}"

    def opened(self, command):
        """The panel for what is selected."""
        self.assertTrue(command().IsActive())
        panel = MeshPanel(command().operations(command().selected()))
        FreeCADGui.Control.showDialog(panel)
        gui_helpers.wait()
        return panel


class Offset(SolidCommands):
    def test_the_panel_says_what_the_result_is_asked_to_keep(self):
        for command, name, lengths in ((commands.Offset, "distance", (-2.0, 0.05, 3.0)), (commands.Hollow, "thickness", (0.5, 2.0))):
            for length in lengths:
                panel = self.panel(command, self.cube)
                panel.options.set_values({name: length})
                gui_helpers.wait()
                told = panel.estimate.text()
                self.finish(panel)
                asked = self.document.ActiveObject.AskedTolerance.Value
                self.assertEqual(told, f"Keeps within {quantities.length_text(asked)} of the exact result.")

    def test_from_the_selection_to_the_mesh_inward(self):
        panel = self.panel(commands.Offset, self.cube)
        gui_helpers.typed(panel.options.field("distance"), "-2 mm")
        panel.options.set_values({"tolerance": TOLERANCE})
        self.narrow(panel, "panel_offset")
        self.finish(panel)
        self.assertEqual(panel.said, "")
        obj = self.document.Objects[-1]
        self.assertEqual((obj.Source, obj.Distance.Value, obj.Certificate), (self.cube, -2.0, "met"))
        self.assertAlmostEqual(obj.Volume.Value, 216.0, delta=1.0)
        self.assertEqual(self.document.UndoNames[0], commands.Offset.TEXT)
        self.assertFalse(self.cube.ViewObject.Visibility)
        self.document.undo()
        self.assertEqual(self.document.Objects, [self.cube])
        self.assertTrue(self.cube.ViewObject.Visibility)

    def test_the_distance_is_asked_for(self):
        panel = self.panel(commands.Offset, self.cube)
        panel.options.set_values({"distance": None})
        self.finish(panel)
        self.assertEqual(panel.said, "Distance: give a length that is not 0")
        self.assertEqual(self.document.Objects, [self.cube])
        texts = [label.text() for label in panel.form.findChildren(QtGui.QLabel)]
        self.assertIn("Distance", texts)
        panel.reject()

    def test_in_inches(self):
        gui_helpers.use_units(gui_helpers.INCHES)
        panel = self.panel(commands.Offset, self.cube)
        box = panel.options.field("distance")
        gui_helpers.typed(box, "-1/16 in")
        self.assertAlmostEqual(box.value(), -1.5875)
        self.assertIn("in", box.text())
        gui_helpers.typed(panel.options.field("tolerance"), "0.1")  # inches
        self.finish(panel)
        self.assertIn("at most the distance of", panel.said)
        self.assertNotIn("mm", panel.said)
        gui_helpers.typed(panel.options.field("tolerance"), "0.002")
        self.finish(panel)
        obj = self.document.Objects[-1]
        self.assertAlmostEqual(obj.Distance.Value, -1.5875)
        self.assertAlmostEqual(obj.Tolerance.Value, 0.0508)
        self.assertAlmostEqual(obj.Mesh.BoundBox.XLength, 10 - 2 * 1.5875, delta=0.11)
        panel = self.edit(obj)
        self.assertAlmostEqual(panel.options.values()["distance"], -1.5875)
        self.finish(panel)
        self.assertAlmostEqual(obj.Distance.Value, -1.5875)

    def test_the_arrows_of_the_field_go_below_zero(self):
        panel = self.panel(commands.Offset, self.cube)
        box, shown = panel.options.field("distance"), []
        box.setValue(0.0)
        for steps in (1, -1, -1):
            box.stepBy(steps)
            shown.append(round(box.value(), 6))
        box.setValue(-1.0)
        for steps in (-1, 1, 1):
            box.stepBy(steps)
            shown.append(round(box.value(), 6))
        self.assertEqual(shown, [1.0, 0.9, 0.8, -2.0, -1.0, -0.9])
        panel.reject()

    def test_meshes_and_what_is_none(self):
        source = self.document.addObject("Mesh::Feature", "Imported")
        source.Mesh = Mesh.createSphere(5.0, 30)
        sheet = self.document.addObject("Spreadsheet::Sheet", "Sheet")
        for command in (commands.Offset, commands.Hollow):
            self.select(sheet)
            self.assertFalse(command().IsActive())
        panel = self.panel(commands.Offset, source)
        panel.options.set_values({"distance": 1.0, "tolerance": TOLERANCE})
        self.finish(panel)
        self.assertAlmostEqual(self.document.Objects[-1].Mesh.BoundBox.XLength, 12.0, delta=0.2)

    def test_nothing_left_is_said_in_the_panel(self):
        panel = self.panel(commands.Offset, self.cube)
        panel.options.set_values({"distance": -6.0, "tolerance": TOLERANCE})
        self.apply(panel)
        self.assertIn("Nothing is left: the solid is nowhere that deep.", panel.certificate.text.text())
        panel.reject()


class FirstLengths(SolidCommands):
    def test_panels_open_with_a_useful_length_and_ok_works(self):
        """2 % of the size and at most 2 mm; of walls a tenth of it; the gap of a wrap has no largest value."""
        large = self.document.addObject("Part::Box", "Large")
        large.Length = 500
        self.document.recompute()
        for command, name, lengths in ((commands.Offset, "distance", (0.2, 2.0)), (commands.Hollow, "thickness", (1.0, 2.0)),
                                       (commands.Wrap, "gap", (0.2, 10.0))):
            for source, length in zip((self.cube, large), lengths):
                panel = self.panel(command, source)
                self.assertEqual(panel.options.values()[name], length)
                panel.options.reset.click()
                self.assertEqual(panel.options.values()[name], length)
                panel.reject()
        panel = self.panel(commands.Hollow, self.cube)
        self.finish(panel)
        self.assertEqual((panel.said, self.document.Objects[-1].Thickness.Value), ("", 1.0))


class Hollow(SolidCommands):
    def test_selected_faces_become_openings(self):
        FreeCADGui.Selection.addSelection(self.cube, self.top)
        panel = self.opened(commands.Hollow)
        self.assertEqual(panel.options.values()["openings"], [self.top])
        panel.options.set_values({"thickness": 1.0, "tolerance": TOLERANCE})
        self.narrow(panel, "panel_hollow")
        self.finish(panel)
        self.assertEqual(panel.said, "")
        obj = self.document.Objects[-1]
        self.assertEqual((obj.Source, obj.Openings), (self.cube, [self.top]))
        self.assertAlmostEqual(obj.Volume.Value, 1000 - 576, delta=1.0)
        self.assertEqual(FreeCADGui.Selection.getSelection(), [obj])
        FreeCADGui.Selection.clearSelection()  # the result is selected, and so drawn in the colour of selections
        image = self.picture("hollow")
        self.assertGreater(np.count_nonzero(image.max(axis=2) < 200), 50_000)

    def test_the_button_adds_faces_and_refuses_others(self):
        other = self.document.addObject("Part::Box", "Other")
        self.document.recompute()
        panel = self.panel(commands.Hollow, self.cube)
        field = panel.options._fields["openings"]
        self.assertIsNone(field.value())
        for chosen, expected, refusal in (
                (((self.cube, "Edge1"),), None, f"Select faces of {self.cube.Label}"),
                (((other, "Face1"),), None, f"{other.Label} is not part of {self.cube.Label}"),
                (((self.cube, "Face5"), (self.cube, "Edge1")), ["Face5"], ""),
                (((self.cube, "Face5"), (self.cube, "Face6")), ["Face5", "Face6"], "")):
            FreeCADGui.Selection.clearSelection()
            for obj, name in chosen:
                FreeCADGui.Selection.addSelection(obj, name)
            field.button.click()
            self.assertEqual(field.value(), expected)
            self.assertIn(refusal, field.refusal.text())
            self.assertEqual(bool(refusal), bool(field.refusal.text()))
        panel.options.set_values({"thickness": 1.0, "tolerance": TOLERANCE})
        self.finish(panel)
        self.assertAlmostEqual(self.document.Objects[-1].Volume.Value, 1000 - 640, delta=1.0)

    def test_a_part_nested_in_parts(self):
        inner, outer = (self.document.addObject("App::Part", name) for name in ("Inner", "Outer"))
        inner.addObject(self.cube)
        inner.Placement = FreeCAD.Placement(FreeCAD.Vector(20, 0, 0), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 90))
        outer.addObject(inner)
        self.document.recompute()
        FreeCADGui.Selection.addSelection(self.document.Name, outer.Name, f"Inner.{self.cube.Name}.{self.top}")
        panel = self.opened(commands.Hollow)
        self.assertEqual(panel.options.values()["openings"], [self.top])
        panel.options.set_values({"thickness": 1.0, "tolerance": TOLERANCE})
        self.finish(panel)
        obj = self.document.Objects[-1]
        self.assertEqual((obj.Source, obj.Openings), (self.cube, [self.top]))
        self.assertAlmostEqual(obj.Volume.Value, 1000 - 576, delta=1.0)
        self.assertAlmostEqual(obj.Mesh.BoundBox.Center.x, 15.0, places=4)
        outer.Placement.Base.z = 7.0
        self.document.recompute()
        self.assertAlmostEqual(obj.Mesh.BoundBox.ZMin, 7.0, places=4)
        self.select(outer)  # the whole assembly: faces are named by their paths
        panel = self.opened(commands.Hollow)
        field = panel.options._fields["openings"]
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.document.Name, outer.Name, f"Inner.{self.cube.Name}.{self.top}")
        field.button.click()
        self.assertEqual(field.value(), [f"Inner.{self.cube.Name}.{self.top}"])
        panel.reject()

    def test_an_edit_changes_the_openings_and_the_macro_says_so(self):
        obj = mq.add_hollow(self.cube, 1.0, [self.top], tolerance=TOLERANCE)
        panel = self.edit(obj)
        self.assertEqual(panel.options.values()["openings"], [self.top])
        self.finish(panel)
        steps = self.document.UndoCount
        self.assertEqual(obj.Openings, [self.top])
        panel = self.edit(obj)
        panel.options.set_values({"openings": None})
        self.assertEqual(panel.operations[0].line(panel.options.values()),
                         f"mq.update(App.getDocument('{self.document.Name}').getObject('{obj.Name}'), openings=None)")
        self.finish(panel)
        self.assertEqual((obj.Openings, self.document.UndoCount), ([], steps + 1))
        self.assertAlmostEqual(obj.Volume.Value, 1000 - 512, delta=1.0)

    def test_errors_are_said_in_the_words_of_the_panel(self):
        for values, words in (({"thickness": None}, "Thickness: give a length that is not 0"),
                              ({"thickness": 1.0, "openings": ["Face9"]}, "names Face9, but 'Box' has faces Face1 to Face6"),
                              ({"thickness": 1.0, "openings": ["Edge9"]}, "Openings: ['Edge9'] is not possible, it must be names")):
            panel = self.panel(commands.Hollow, self.cube)
            panel.options.set_values(values)
            self.finish(panel)
            self.assertIn(words, panel.said)
            self.assertEqual(self.document.Objects, [self.cube])
            panel.reject()

    def test_in_german(self):
        FreeCADGui.setLocale("German")
        self.addCleanup(FreeCADGui.setLocale, "English")
        gui_helpers.wait(0.2)
        panel = self.panel(commands.Hollow, self.cube)
        texts = [label.text() for label in panel.form.findChildren(QtGui.QLabel)]
        for word in ("Dicke", "Öffnungen"):
            self.assertIn(word, texts)
        panel.options.set_values({"thickness": None})
        self.finish(panel)
        self.assertEqual(panel.said, "Dicke: eine Länge angeben, die nicht 0 ist")
        self.narrow(panel, "panel_hollow_german")
        panel.reject()

    def test_it_follows_its_source_in_the_background(self):
        obj = mq.add_hollow(self.cube, 1.0, [self.top], tolerance=TOLERANCE)
        refresh = next(action for action in FreeCADGui.getMainWindow().findChildren(QtGui.QAction)
                       if action.objectName() == "Std_Refresh")
        refresh.setEnabled(True)  # FreeCAD 1.1 does so only a moment after a change
        with mock.patch.object(background_recompute, "_python_waits", lambda: False):
            self.cube.Height = 20
            QtCore.QTimer.singleShot(0, refresh.trigger)
            self.until(lambda: "Touched" not in self.cube.State)
            self.assertEqual(obj.Status, mesh_object.COMPUTING)
            gui_helpers.wait(0.1)
            self.until(lambda: len(jobs.queue()) == 0)
        self.assertEqual(obj.Status, mesh_object.UP_TO_DATE)
        self.assertAlmostEqual(obj.Volume.Value, 2000 - 8 * 8 * 19, delta=2.0)

    def test_several_solids_at_once(self):
        other = self.document.addObject("Part::Feature", "Other")
        other.Shape = Part.makeCylinder(5, 10)
        panel = self.panel(commands.Hollow, self.cube, other)
        panel.options.set_values({"thickness": 1.0, "tolerance": TOLERANCE})
        field = panel.options._fields["openings"]
        field.button.click()
        self.assertIn("Faces are chosen of one object", field.refusal.text())
        self.finish(panel)
        self.assertEqual([obj.Source for obj in self.document.Objects[2:]], [self.cube, other])
