# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flow mesh: from a solid and picked walls over the panel to layers, the quality view and a case of OpenFOAM."""

import importlib.util
import os
import tempfile
import unittest
from unittest import mock

import FreeCAD
import FreeCADGui
import gui_helpers
import numpy as np
import Part
from PySide import QtGui

import MeshQuality as mq
from MeshQuality.gui import commands
from MeshQuality.gui.panels import quality_panel
from MeshQuality.gui.panels.case_panel import CasePanel
from MeshQuality.gui.panels.flow_panel import FlowPanel
from MeshQuality.gui.panels.task_form import is_in_task_view

HAS_FEM = importlib.util.find_spec("Fem") is not None


@unittest.skipUnless(HAS_FEM, "this FreeCAD has no FEM workbench")
class FlowMesh(gui_helpers.PanelTest):
    def setUp(self):
        super().setUp()
        self.pipe = self.document.addObject("Part::Cylinder", "Pipe")
        self.pipe.Radius, self.pipe.Height = 5, 20
        self.document.recompute()

    def opened(self, source, *faces):
        """The panel for an object, or for faces of it that are selected in the view."""
        self.select(*([] if faces else [source]))
        for face in faces:
            FreeCADGui.Selection.addSelection(source, face)
        self.assertTrue(commands.FlowMesh().IsActive())
        commands.FlowMesh().Activated()
        gui_helpers.wait()
        return self.shown

    @property
    def shown(self):
        """The FlowPanel that is open."""
        found = [panel for panel in self.made if panel.form is not None and is_in_task_view(panel.form)]
        self.assertEqual(len(found), 1)
        return found[0]

    def run(self, result=None):
        """Panels that commands open are noted."""
        self.made, begin = [], FlowPanel.__init__

        def noted(panel, *arguments, **values):
            begin(panel, *arguments, **values)
            self.made.append(panel)

        with mock.patch.object(FlowPanel, "__init__", noted):
            return super().run(result)

    def test_from_picked_walls_to_the_mesh(self):
        panel = self.opened(self.pipe, "Face1")
        values = panel.options.values()
        self.assertEqual((values["walls"], values["layers"]), (["Face1"], 5))
        panel.options.set_values({"max_edge": 2.5, "first_height": 0.1, "layers": 3})
        self.narrow(panel, "panel_flow_mesh")
        self.until(lambda: "cells" in panel.estimate.text() and "Counting" not in panel.estimate.text())
        self.finish(panel)
        self.assertEqual(panel.said, "")
        obj = self.document.Objects[-1]
        self.assertEqual((obj.Walls, obj.Covered, obj.Certificate, obj.Label), (["Face1"], 1.0, "met", "Pipe flow mesh"))
        self.assertEqual(self.document.UndoNames[0], "Flow mesh")
        self.assertFalse(self.pipe.ViewObject.Visibility)
        self.document.undo()
        self.assertEqual(self.document.Objects, [self.pipe])

    def test_the_estimate_of_a_large_mesh_is_about_right(self):
        panel = self.opened(self.pipe)
        panel.options.set_values({"max_edge": 0.7, "first_height": 0.02, "layers": 4})
        self.until(lambda: panel.estimate.text().startswith("About"))
        told = int(panel.estimate.text().split()[1].replace(",", ""))
        panel.reject()
        made = sum(mq.volume_mesh(self.pipe, 4, 0.02, max_edge=0.7).report.elements.values())
        self.assertLess(abs(told / made - 1.0), 0.2, (told, made))

    def test_the_height_for_a_y_plus(self):
        panel = self.opened(self.pipe, "Face1")
        box = panel.y_plus
        self.assertFalse(box.button.isVisible())
        box.setChecked(True)
        gui_helpers.wait()
        box.speed.setValue(20.0)
        box.length.setValue(10.0)
        box.y_plus.setValue(5.0)
        self.narrow(panel, "panel_flow_mesh_y_plus")
        box.button.click()
        expected = float(mq.first_height(20.0, 10.0, "air", 5.0))
        self.assertAlmostEqual(panel.options.values()["first_height"], expected, delta=0.005 * expected)
        self.assertIn("1.32e+04", box.said.text())
        box.speed.setValue(0.0)
        self.assertFalse(box.button.isEnabled())
        self.assertEqual(box.said.text(), "The first height for a y+ needs a speed and a length above 0")
        panel.reject()

    def test_walls_by_a_patch_of_another_mesh(self):
        surface = mq.add_quality_mesh(self.pipe, max_edge=5.0)
        mq.set_patches(surface, {"inlet": ["Face3"], "outlet": ["Face2"]}, patch_rest="pipe")
        panel = self.opened(self.pipe, "Face2")
        texts = [panel.by_patch.itemText(row) for row in range(panel.by_patch.count())]
        self.assertEqual(texts[1:], ["inlet", "outlet", "pipe"])
        panel.by_patch.activated.emit(3)
        self.assertEqual(panel.options.values()["walls"], ["Face2", "Face1"])
        panel.reject()
        self.document.removeObject(surface.Name)
        panel = self.opened(self.pipe)
        self.assertFalse(panel.by_patch.isVisible())
        panel.reject()

    def test_what_is_not_covered_is_named_and_shown(self):
        wedge = self.document.addObject("Part::Feature", "Wedge")
        corners = [FreeCAD.Vector(), FreeCAD.Vector(10, 0, 0), FreeCAD.Vector(9.4, 3.4, 0), FreeCAD.Vector()]
        wedge.Shape = Part.Face(Part.makePolygon(corners)).extrude(FreeCAD.Vector(0, 0, 5))
        self.document.recompute()
        panel = self.opened(wedge)
        panel.options.set_values({"max_edge": 1.5, "first_height": 0.05, "layers": 3})
        self.apply(panel)
        obj = self.document.Objects[-1]
        words = panel.certificate.text.text()
        self.assertIn("Layers cover ", words)
        self.assertIn("Target not met: layers do not cover all of ", words)
        bare = [line.split(":")[0] for line in obj.Coverage if not line.split(": ")[1].startswith("100 %")]
        self.assertEqual(obj.CertificateFaces, bare)
        panel.certificate.button.click()
        gui_helpers.wait()
        chosen = [name for part in FreeCADGui.Selection.getSelectionEx() for name in part.SubElementNames]
        self.assertEqual(sorted(chosen), sorted(bare))
        self.assertLess(np.abs(np.array(obj.CertificatePlace)[:, :2]).max(), 5.0)  # at the acute edge
        panel.reject()

    def test_the_layers_are_seen_in_a_cut_of_whole_elements(self):
        obj = mq.add_flow_mesh(self.pipe, 4, 0.2, max_edge=2.0, walls=["Face1"])
        panel = quality_panel.open_panel(obj)
        self.addCleanup(lambda: panel.ended or panel.reject())
        self.until(lambda: panel.values is not None)
        self.assertEqual(len(panel.values), obj.Elements)
        at = panel.data.face >= 0
        self.assertEqual(set(panel.data.face.tolist()), {-1, 0, 1, 2})
        distances = panel.data.distances()
        self.assertTrue(np.array_equal(at, ~np.isnan(distances)))
        self.assertLess(np.nanmax(distances), 0.2)
        drawn, height = panel.data.face[panel.data.element], panel.data.corners[:, :, 2]
        for face, z in ((1, self.pipe.Shape.Face2.CenterOfMass.z), (2, self.pipe.Shape.Face3.CenterOfMass.z)):  # each element there has a side in the plane of its end
            there = {int(i) for i in panel.data.element[(height == z).all(axis=1)]}
            self.assertLessEqual({int(i) for i in panel.data.element[drawn == face]}, there)
        panel.section.on.setChecked(True)
        panel.section.direction.setCurrentIndex(0)
        panel.section.whole.setChecked(True)
        gui_helpers.wait(0.2)
        self.assertGreater(len(set(map(tuple, self.picture("flow_mesh_cut").reshape(-1, 3).tolist()))), 20)

    def test_a_case_of_openfoam(self):
        obj = mq.add_flow_mesh(self.pipe, 2, 0.2, max_edge=4.0, walls=["Face1"], patches={"inlet": ["Face3"]}, patch_rest="pipe")
        self.select(obj)
        self.assertTrue(commands.FlowCase().IsActive())
        panel = CasePanel(commands.FlowCase().selected()[0])
        FreeCADGui.Control.showDialog(panel)
        gui_helpers.wait()
        self.assertFalse(panel.flow.isVisible() or panel.cell.isVisible())
        with tempfile.TemporaryDirectory() as folder:
            panel.path.setProperty("fileName", os.path.join(folder, "pipe"))
            panel.accept()
            self.until(lambda: panel.job is None)
            self.assertIn("&& checkMesh", panel.said)
            panel.reject()
            with open(os.path.join(folder, "pipe", "constant", "polyMesh", "boundary"), encoding="utf-8") as stream:
                text = stream.read()
        for name in ("inlet", "pipe"):
            self.assertIn(name, text)

    def test_editing_keeps_the_walls(self):
        obj = mq.add_flow_mesh(self.pipe, 2, 0.2, max_edge=4.0, walls=["Face1"])
        count = obj.Elements
        self.assertTrue(obj.ViewObject.Proxy.doubleClicked(obj.ViewObject))
        gui_helpers.wait()
        panel = self.shown
        self.assertEqual(panel.options.values()["walls"], ["Face1"])
        panel.options.set_values({"layers": 4})
        self.finish(panel)
        self.assertEqual((panel.said, obj.Layers), ("", 4))
        self.assertGreater(obj.Elements, count)
        self.assertFalse(QtGui.QApplication.activeModalWidget())
