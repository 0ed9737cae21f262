# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simplify: from a mesh over the panel to the lighter one in its place."""

import FreeCADGui
import gui_helpers
import Part
from PySide import QtGui

import MeshQuality as mq
from MeshQuality.gui import commands
from MeshQuality.gui.fem_quality_data import QualityData


class SimplifyCommand(gui_helpers.PanelTest):
    def test_from_selection_to_the_object(self):
        source = self.document.addObject("Part::Feature", "Part")
        source.Shape = Part.makeCylinder(5, 20).cut(Part.makeBox(3, 3, 30))
        given = mq.add_quality_mesh(source, max_edge=1.0)
        panel = self.panel(commands.Simplify, given)
        panel.options.set_values({"tolerance": 0.05})
        self.narrow(panel, "panel_simplify")
        self.finish(panel)
        self.assertEqual(panel.said, "")
        obj = self.document.Objects[-1]
        self.assertLess(obj.Triangles, 0.4 * given.Triangles)
        self.assertEqual(self.document.UndoNames[0], commands.Simplify.TEXT)
        self.assertTrue(obj.ViewObject.Visibility)
        self.assertFalse(given.ViewObject.Visibility)
        report = FreeCADGui.getMainWindow().findChild(QtGui.QTextEdit, "Report view").toPlainText()
        self.assertIn(f"{obj.Triangles:,} of {given.Triangles:,} triangles are left; no point of either surface is farther than", report)
        again = self.edit(obj)
        again.options.set_values({"tolerance": 0.5})
        before = obj.Triangles
        self.finish(again)
        self.assertLess(obj.Triangles, before)
        data = QualityData(obj)
        data.prepare()
        self.assertEqual({row.name for row in data.faces(data.shapes()[0], data.measures[0])},
                         {f"Face{i + 1}" for i in range(len(source.Shape.Faces))})
        self.picture("simplified")

    def test_it_is_for_meshes(self):
        box = self.box()
        self.select(box)
        self.assertFalse(commands.Simplify().IsActive())
