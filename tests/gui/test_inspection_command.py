# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inspection: from the selection over the panel to what was found, its limit, and its panel and texts in German."""

import FreeCAD
import FreeCADGui
import gui_helpers
import numpy as np
import Part
from PySide import QtGui

import MeshQuality as mq
from MeshQuality.gui import commands, quality_data
from MeshQuality.gui.panels import quality_panel


class Inspect(gui_helpers.PanelTest):
    def stepped(self, thin=1.0):
        return Part.makeBox(30, 20, 3).cut(Part.makeBox(10, 20, 3 - thin, FreeCAD.Vector(20, 0, thin)))

    def setUp(self):
        super().setUp()
        self.source = self.document.addObject("Part::Feature", "Plate")
        self.source.Shape = self.stepped()
        self.document.recompute()

    def test_a_thin_wall_is_told_and_gone_after_the_edit(self):
        panel = self.panel(commands.Inspect, self.source)
        self.assertTrue(panel.options.field("min_thickness").isEnabled())
        self.assertFalse(panel.options.field("min_draft").isEnabled())
        panel.options.set_values({"min_thickness": 2.0})
        self.narrow(panel, "panel_inspection")
        self.finish(panel)
        self.assertEqual(panel.said, "")
        obj = self.document.Objects[-1]
        self.assertTrue(obj.Certificate.startswith("not met: smallest thickness"))
        self.assertEqual(self.document.UndoNames[0], commands.Inspect.TEXT)
        panel = self.edit(obj)
        texts = " ".join(label.text() for label in panel.form.findChildren(QtGui.QLabel))
        self.assertIn("mallest thickness", texts)
        self.narrow(panel, "panel_inspection_missed")
        panel.reject()
        self.source.Shape = self.stepped(thin=2.5)
        self.document.recompute()
        self.until(lambda: obj.Status == "up to date" and obj.Certificate == "met")
        self.assertAlmostEqual(obj.Minimum.Value, 2.5, delta=0.05)

    def test_what_is_made_of_one_part_in_several_ways_is_seen_alone(self):
        """Each object is made of the part or of a mesh of it, and would be drawn through what is made of the other."""
        net, hollow = mq.add_quality_mesh(self.source), mq.add_hollow(self.source, 0.4)
        for source in (net, self.source, hollow):
            earlier = (self.source, net, hollow)
            for obj in earlier:
                obj.ViewObject.Visibility = True
            with self.subTest(source=source.Name):
                found = mq.add_inspection(source)
                self.assertEqual([obj.ViewObject.Visibility for obj in (*earlier, found)], [False, False, False, True])
                self.document.undo()
                self.assertEqual([obj.ViewObject.Visibility for obj in earlier], [True, True, True])

    def test_its_mesh_is_coloured(self):
        panel = self.panel(commands.Inspect, self.source)
        self.finish(panel)
        obj = self.document.Objects[-1]
        self.select(obj)
        self.assertTrue(commands.Thickness().IsActive())
        commands.Thickness().Activated()
        view = quality_panel.shown()
        self.addCleanup(lambda: view.ended or view.reject())
        self.until(lambda: view.values is not None)
        self.assertIs(view.measure, quality_data.THICKNESS)
        self.assertAlmostEqual(float(view.values[view._worst[0]]), obj.Minimum.Value, delta=0.05)
        self.picture("inspection_thickness")

    def test_its_mesh_shows_the_thickness_without_edges(self):
        self.finish(self.panel(commands.Inspect, self.source))
        obj = self.document.Objects[-1]
        self.assertEqual((obj.ViewObject.DisplayMode, len(obj.FaceColors)), ("Shaded", obj.Mesh.CountFacets))
        FreeCADGui.Selection.clearSelection()
        image = self.picture("inspection_coloured")
        strong = image[(image.max(axis=2) - image.min(axis=2)) > 60]
        self.assertGreater(len(strong), 5000)
        self.assertLess(np.count_nonzero(image.max(axis=2) < 60), 500)  # no black edges
        self.assertGreaterEqual(len(np.unique(strong // 32, axis=0)), 2)  # of two thicknesses
        obj.Check = "draft"
        self.document.recompute()
        self.until(lambda: obj.Status == "up to date" and not obj.ViewObject.Coloring)

    def test_fields_of_other_checks_are_not_there(self):
        panel = self.panel(commands.Inspect, self.source)
        for check, there, gone in (("thickness", ("measure", "spacing"), ("min_clearance", "min_draft", "pull_direction")),
                                   ("clearance", ("min_clearance",), ("measure", "min_thickness", "min_draft")),
                                   ("draft", ("min_draft", "pull_direction"), ("measure", "gap", "min_clearance"))):
            panel.options.set_values({"check": check})
            gui_helpers.wait()
            for name in there:
                self.assertTrue(panel.options.field(name).isVisible(), (check, name))
            for name in gone:
                self.assertFalse(panel.options.field(name).isVisible(), (check, name))
        self.assertEqual([box.title() for box in panel.form.findChildren(QtGui.QGroupBox) if box.isVisible()],
                         ["Inspection", "Draft", "Accuracy"])
        self.narrow(panel, "panel_inspection_draft")
        panel.reject()

    def test_pairs_of_bodies_are_listed_and_shown(self):
        # Two touch by design; the third is 0.5 mm away from the second.
        self.source.Shape = Part.makeCompound([Part.makeBox(10, 10, 10, FreeCAD.Vector(x, 0, 0)) for x in (0, 10, 20.5)])
        self.document.recompute()
        panel = self.panel(commands.Inspect, self.source)
        panel.options.set_values({"check": "clearance", "min_clearance": 1.0})
        self.finish(panel)
        obj = self.document.Objects[-1]
        self.assertEqual(len(obj.Places), 2 * len(obj.Pairs))
        self.assertTrue(obj.Pairs[0].startswith("0.5 mm: "), obj.Pairs)
        self.assertTrue(obj.Pairs[1].startswith("touching: "), obj.Pairs)
        self.view.viewAxonometric()
        self.view.fitAll()
        panel = self.edit(obj)
        box = panel.certificate
        self.assertEqual([box.pairs.item(row).text() for row in range(box.pairs.count())], list(obj.Pairs))
        before = self.view.getCameraNode().height.getValue()
        box.pairs.setCurrentRow(0)
        self.until(lambda: not box.flight.active)
        camera = self.view.getCameraNode()
        self.assertLess(camera.height.getValue(), before)
        self.narrow(panel, "panel_clearance_pairs")
        self.saved("clearance_pair")
        place = np.array(camera.position.getValue().getValue()) + camera.focalDistance.getValue() * np.array(
            self.view.getViewDirection())
        self.assertAlmostEqual(place[0], 20.25, delta=0.1)
        panel.reject()

    def test_another_check(self):
        panel = self.panel(commands.Inspect, self.source)
        panel.options.set_values({"check": "draft", "min_draft": 2.0})
        self.assertTrue(panel.options.field("pull_direction").isEnabled())
        self.assertFalse(panel.options.field("min_thickness").isEnabled())
        self.finish(panel)
        obj = self.document.Objects[-1]
        self.assertEqual((obj.Check, obj.PullDirection, obj.MinDraft.Value), ("draft", "z", 2.0))
        self.assertTrue(obj.Certificate.startswith("not met: less draft than 2°"))

    def test_an_assembly_stays_in_sight(self):
        part = self.document.addObject("App::Part", "Assembly")
        other = self.box("Other", Length=30, Width=20, Height=2)
        other.Placement.Base.z = 4.0
        part.addObjects([self.source, other])
        self.document.recompute()
        panel = self.panel(commands.Inspect, part)
        panel.options.set_values({"check": "clearance", "min_clearance": 1.5})
        self.finish(panel)
        obj = self.document.Objects[-1]
        self.assertAlmostEqual(obj.Minimum.Value, 1.0, places=6)
        self.assertTrue(obj.Certificate.startswith("not met: smallest gap 1 mm"))
        self.assertTrue(part.ViewObject.Visibility)

    def test_in_german(self):
        FreeCADGui.setLocale("German")
        self.addCleanup(FreeCADGui.setLocale, "English")
        gui_helpers.wait(0.2)
        panel = self.panel(commands.Inspect, self.source)
        texts = [label.text() for label in panel.form.findChildren(QtGui.QLabel)]
        for text in ("Prüfung", "Kleinste Dicke (0: keine Grenze)", "Öffnungsrichtung"):
            self.assertIn(text, texts)
        panel.options.set_values({"min_thickness": 2.0})
        self.narrow(panel, "panel_inspection_german")
        self.finish(panel)
        panel = self.edit(self.document.Objects[-1])
        shown = " ".join(label.text() for label in panel.form.findChildren(QtGui.QLabel))
        self.assertIn("leinste Dicke", shown)
        panel.reject()
