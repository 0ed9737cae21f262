# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces picked in the 3D view get a size of their own in the panel."""

import FreeCADGui
import gui_helpers

from MeshQuality.gui import commands
from MeshQuality.gui.mesh_panel import MeshPanel


class LocalSizes(gui_helpers.GuiTest):
    def test_picked_faces_are_added_once(self):
        box = self.box()
        panel = MeshPanel(commands.Triangulate().operations([box]))
        FreeCADGui.Control.showDialog(panel)
        self.addCleanup(FreeCADGui.Control.closeDialog)
        gui_helpers.wait()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(box, "Face3")
        FreeCADGui.Selection.addSelection(box, "Edge2")
        field = panel.options._fields["local_sizes"]
        field.button.click()
        self.assertRegex(field.value(), r"^Face3=[\d.]+, Edge2=[\d.]+$")
        field.button.click()
        self.assertEqual(field.value().count("Face3"), 1)
        panel.accept()
        self.until(lambda: not panel.jobs)
        obj = self.document.Objects[-1]
        self.assertIn("Face3=", obj.LocalSizes)
        self.assertGreater(obj.Mesh.CountFacets, 500)

    def test_nonsense_is_said_in_the_panel(self):
        panel = MeshPanel(commands.Triangulate().operations([self.box()]))
        FreeCADGui.Control.showDialog(panel)
        self.addCleanup(FreeCADGui.Control.closeDialog)
        panel.options.set_values({"local_sizes": "Face3"})
        panel.accept()
        self.until(lambda: not panel.jobs)
        self.assertIn("Face3=0.5", panel.said)
