# SPDX-License-Identifier: LGPL-2.1-or-later
"""CAM mesh: from a solid over the panel to the mesh on its side."""

import FreeCADGui
import gui_helpers
from PySide import QtGui

from MeshQuality.gui import commands


class CamCommand(gui_helpers.PanelTest):
    def test_from_selection_to_the_object(self):
        box = self.box()
        panel = self.panel(commands.CamMesh, box)
        self.assertGreater(panel.options.values()["tolerance"], 0.0)
        panel.options.set_values({"tolerance": 0.1})
        self.narrow(panel, "panel_cam")
        self.finish(panel)
        self.assertEqual(panel.said, "")
        obj = self.document.Objects[-1]
        self.assertGreater(obj.Mesh.Volume, box.Shape.Volume)
        report = FreeCADGui.getMainWindow().findChild(QtGui.QTextEdit, "Report view").toPlainText()
        self.assertIn("never inside the part", report)
        again = self.edit(obj)
        again.options.set_values({"side": "inside"})
        self.finish(again)
        self.assertLess(obj.Mesh.Volume, box.Shape.Volume)
