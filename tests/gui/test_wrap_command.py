# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wrap: from the selection over the panel to the mesh, in which a crack between two boxes is closed."""

import FreeCAD
import FreeCADGui
import gui_helpers
import Mesh
import numpy as np
from PySide import QtGui

import MeshQuality as mq
from MeshQuality.gui import commands
from MeshQuality.gui.panels import quality_panel

GAP, TOLERANCE = 2.0, 1.0
WIDTH = 0.4  # of the crack


class WrapCommand(gui_helpers.PanelTest):
    def setUp(self):
        super().setUp()
        self.addCleanup(gui_helpers.use_units, gui_helpers.MM)
        self.first, self.second = (self.cube(name, x) for name, x in (("First", 0.0), ("Second", 10.0 + WIDTH)))

    def cube(self, name, x):
        obj = self.document.addObject("Part::Box", name)
        obj.Placement.Base.x = x
        self.document.recompute()
        return obj

    def texts(self, panel):
        return [label.text() for label in panel.form.findChildren(QtGui.QLabel)]

    def seen_through(self, name):
        """Number of pixels in the middle row of a picture from the front that show the background between the cubes."""
        self.view.viewFront()
        self.view.fitAll()
        gui_helpers.wait(0.3)
        image = self.saved(name, background="Blue")  # FreeCAD 1.0 draws faces towards the camera white
        empty = (image[image.shape[0] // 2] == image[0, 0]).all(axis=1)
        filled = np.flatnonzero(~empty)
        self.assertGreater(len(filled), 100)
        return int(np.count_nonzero(empty[filled[0]:filled[-1]]))

    def test_from_the_selection_to_the_mesh(self):
        self.assertGreater(self.seen_through("wrap_before"), 3)
        panel = self.panel(commands.Wrap, self.first, self.second)
        self.assertIn("Operands: A = First, B = Second", self.texts(panel))
        gui_helpers.typed(panel.options.field("gap"), "2 mm")
        panel.options.set_values({"tolerance": TOLERANCE})
        self.narrow(panel, "panel_wrap")
        self.finish(panel)
        self.assertEqual(panel.said, "")
        obj = self.document.Objects[-1]
        self.assertEqual((obj.Sources, obj.Gap.Value, obj.Certificate), ([self.first, self.second], GAP, "met"))
        self.assertEqual(obj.Mesh.countComponents(), 1)
        self.assertGreater(obj.GapTriangles, 0)
        self.assertEqual(self.document.UndoNames[0], commands.Wrap.TEXT)
        self.assertFalse(self.first.ViewObject.Visibility or self.second.ViewObject.Visibility)
        self.assertEqual(self.seen_through("wrap_after"), 0)
        self.picture("wrap")
        self.document.undo()
        self.assertEqual(self.document.Objects, [self.first, self.second])
        self.assertTrue(self.first.ViewObject.Visibility and self.second.ViewObject.Visibility)

    def test_one_object(self):
        panel = self.panel(commands.Wrap, self.first)
        self.assertIn("Source: First", self.texts(panel))
        panel.options.set_values({"gap": GAP, "tolerance": TOLERANCE})
        self.apply(panel)
        obj = self.document.Objects[-1]
        self.assertEqual((obj.Sources, obj.Label, obj.GapTriangles), ([self.first], "First wrap", 0))
        panel.reject()

    def test_an_assembly_and_a_mesh(self):
        assembly = self.document.addObject("App::Part", "Assembly")
        assembly.addObjects([self.first, self.second])
        lid = self.document.addObject("Mesh::Feature", "Lid")
        lid.Mesh = Mesh.createBox(10.0, 10.0, 2.0)
        lid.Placement.Base = FreeCAD.Vector(5, 5, 11 + WIDTH)
        self.document.recompute()
        panel = self.panel(commands.Wrap, assembly, lid)
        self.assertIn("Operands: A = Assembly, B = Lid", self.texts(panel))
        panel.options.set_values({"gap": GAP, "tolerance": TOLERANCE})
        self.finish(panel)
        self.assertEqual(panel.said, "")
        obj = self.document.Objects[-1]
        self.assertEqual((obj.Sources, obj.Mesh.countComponents()), ([assembly, lid], 1))
        self.assertAlmostEqual(obj.Volume.Value, 2000 + 100 * WIDTH + 200 + 100 * WIDTH, delta=30.0)

    def test_when_it_can_be_used(self):
        sheet = self.document.addObject("Spreadsheet::Sheet", "Sheet")
        self.select(sheet)
        self.assertFalse(commands.Wrap().IsActive())
        self.select(self.first, sheet)
        self.assertEqual(commands.Wrap().selected(), [self.first])

    def test_an_edit_and_errors_in_the_words_of_the_panel(self):
        panel = self.panel(commands.Wrap, self.first, self.second)
        panel.options.set_values({"gap": None})
        self.finish(panel)
        self.assertEqual(panel.said, "Gap: give a length that is not 0")
        self.assertEqual(self.document.Objects, [self.first, self.second])
        panel.options.set_values({"gap": 1.0, "tolerance": 0.8})
        self.finish(panel)
        self.assertIn("at most half of the gap of 1 mm is possible", panel.said)
        panel.reject()
        obj = mq.add_wrap([self.first, self.second], GAP, TOLERANCE)
        panel = self.edit(obj)
        self.assertEqual(panel.options.values(), {"gap": GAP, "tolerance": TOLERANCE})
        panel.options.set_values({"gap": 3.0})
        self.assertEqual(panel.operations[0].line(panel.options.values()),
                         f"mq.update(App.getDocument('{self.document.Name}').getObject('{obj.Name}'), gap=3.0)")
        self.finish(panel)
        self.assertEqual((obj.Gap.Value, self.document.UndoNames[0]), (3.0, "Edit First wrap"))

    def test_in_inches(self):
        gui_helpers.use_units(gui_helpers.INCHES)
        panel = self.panel(commands.Wrap, self.first, self.second)
        box = panel.options.field("gap")
        gui_helpers.typed(box, "1/8 in")
        self.assertAlmostEqual(box.value(), 3.175)
        self.assertIn("in", box.text())
        gui_helpers.typed(panel.options.field("tolerance"), "0.1")  # inches
        self.finish(panel)
        self.assertIn("at most half of the gap of", panel.said)
        self.assertNotIn("mm", panel.said)
        panel.options.set_values({"tolerance": 1e-4})
        self.finish(panel)
        self.assertIn("would take more than 2 GB of memory", panel.said)
        self.assertNotIn("mm", panel.said)
        gui_helpers.typed(panel.options.field("tolerance"), "0.04")
        self.narrow(panel, "panel_wrap_inches")
        self.finish(panel)
        obj = self.document.Objects[-1]
        self.assertAlmostEqual(obj.Gap.Value, 3.175)
        self.assertAlmostEqual(obj.Tolerance.Value, 1.016)

    def test_in_german(self):
        FreeCADGui.setLocale("German")
        self.addCleanup(FreeCADGui.setLocale, "English")
        gui_helpers.wait(0.2)
        panel = self.panel(commands.Wrap, self.first, self.second)
        self.assertEqual(panel.form.windowTitle(), "Umhüllen")
        for word in ("Lücke", "Max. Abweichung (0: nach Größe)", "Operanden: A = First, B = Second"):
            self.assertIn(word, self.texts(panel))
        panel.options.set_values({"gap": None})
        self.finish(panel)
        self.assertEqual(panel.said, "Lücke: eine Länge angeben, die nicht 0 ist")
        panel.options.set_values({"gap": 1.0, "tolerance": 0.8})
        self.finish(panel)
        self.assertIn("möglich ist höchstens die Hälfte der Lücke von 1 mm", panel.said)
        panel.options.set_values({"gap": 1.0, "tolerance": 1e-4})
        self.finish(panel)
        self.assertIn("Eine Hülle mit einer max. Abweichung von 100 nm würde mehr als 2 GB Speicher brauchen", panel.said)
        self.narrow(panel, "panel_wrap_german")
        panel.reject()

    def test_the_quality_of_a_wrap_is_shown(self):
        obj = mq.add_wrap([self.first, self.second], GAP, TOLERANCE)
        panel = quality_panel.open_panel(obj)
        self.until(lambda: panel.values is not None)
        self.assertEqual(len(panel.values), obj.Triangles)
        panel.reject()
