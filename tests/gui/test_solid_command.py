# SPDX-License-Identifier: LGPL-2.1-or-later
"""To solid: the panel says what becomes exact before it is added, and what is refused."""

import os

import FreeCADGui
import gui_helpers
import Mesh
import Part
from PySide import QtGui

import MeshQuality as mq
from MeshQuality.features import mesh_solid
from MeshQuality.gui import commands
from MeshQuality.gui.panels.solid_panel import SolidPanel
from MeshQuality.gui.view import badge


class ToSolid(gui_helpers.PanelTest):
    def open(self, obj):
        self.select(obj)
        self.assertTrue(commands.ToSolid().IsActive())
        panel = SolidPanel(commands.ToSolid().selected()[0])
        FreeCADGui.Control.showDialog(panel)
        self.until(lambda: panel.found is not None or panel.said)
        self.until(lambda: panel.job is None)
        return panel

    def test_exact_faces(self):
        hollow = mq.add_hollow(self.box(), 1.0)
        panel = self.open(hollow)
        self.assertRegex(panel.made.text(), r"^The solid has 12 faces on exact surfaces\.\nMesh and solid are within .* mm")
        self.narrow(panel, "panel_to_solid")
        panel.accept()
        self.assertFalse(FreeCADGui.Control.activeDialog())
        solid = self.document.ActiveObject
        self.assertIsInstance(solid.Proxy, mesh_solid.SolidOfMesh)
        self.assertEqual((solid.ExactFaces, mesh_solid._ready), (12, {}))
        self.assertFalse(hollow.ViewObject.Visibility)
        self.assertTrue(solid.ViewObject.Visibility)
        self.assertEqual(solid.ViewObject.Proxy.getIcon(), badge.path_of("MeshQuality_ToSolid"))
        self.picture("to_solid")
        self.document.undo()
        self.assertIsNone(self.document.getObject("Solid"))

    def test_facets_and_refusal(self):
        mesh = self.document.addObject("Mesh::Feature", "Given")
        mesh.Mesh = Mesh.createBox(10, 20, 30)
        panel = self.open(mesh)
        self.assertIn("The solid has 6 planar facets: the mesh does not know the CAD it was made of.", panel.made.text())
        panel.facets.setChecked(False)
        self.until(lambda: panel.said)
        self.assertEqual((panel.found, panel.made.text()), (None, ""))
        self.assertEqual(panel.message.text(), "No solid with exact surfaces: the mesh does not know the CAD it was made of")
        self.narrow(panel, "panel_to_solid_refused")
        panel.accept()
        self.until(lambda: panel.job is None)
        self.assertTrue(FreeCADGui.Control.activeDialog())
        self.assertEqual(len(self.document.Objects), 1)
        panel.reject()

    def test_the_command_of_the_menu(self):
        self.select(mq.add_quality_mesh(self.box()))
        FreeCADGui.runCommand("MeshQuality_ToSolid")
        self.assertTrue(FreeCADGui.Control.activeDialog())
        gui_helpers.wait(0.5)
