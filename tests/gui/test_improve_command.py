# SPDX-License-Identifier: LGPL-2.1-or-later
"""Improve mesh: from an imported mesh over the panel to the better one."""

import FreeCADGui
import gui_helpers
import Mesh

from MeshQuality.gui import commands
from MeshQuality.gui.panels.mesh_panel import MeshPanel


class ImproveCommand(gui_helpers.GuiTest):
    def tearDown(self):
        FreeCADGui.Control.closeDialog()
        super().tearDown()

    def panel(self, obj):
        FreeCADGui.activateWorkbench("MeshQualityWorkbench")
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(obj)
        command = commands.Improve()
        self.assertTrue(command.IsActive())
        panel = MeshPanel(command.operations(command.selected()))
        FreeCADGui.Control.showDialog(panel)
        gui_helpers.wait()
        return panel

    def test_from_selection_to_result(self):
        source = self.document.addObject("Mesh::Feature", "Imported")
        source.Mesh = Mesh.createCylinder(2.0, 10.0, True, 5.0, 30)
        panel = self.panel(source)
        panel.options.set_values({"min_angle": 28.0})
        panel.accept()
        self.until(lambda: not panel.jobs)
        obj = self.document.Objects[-1]
        self.assertEqual((obj.Source, obj.MinAngle.Value), (source, 28.0))
        self.assertGreaterEqual(obj.MeasuredMinAngle.Value, 28.0)
        self.assertEqual(self.document.UndoNames[0], commands.Improve.TEXT)

    def test_an_empty_mesh_is_named_and_nothing_added(self):
        source = self.document.addObject("Mesh::Feature", "Empty")
        panel = self.panel(source)
        panel.accept()
        self.until(lambda: not panel.jobs)
        self.assertIn("no triangles", panel.said)
        self.assertEqual(self.document.Objects, [source])

    def test_it_is_for_meshes_only(self):
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.box())
        self.assertFalse(commands.Improve().IsActive())
