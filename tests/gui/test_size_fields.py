# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of size regions in the panel of a mesh, and the field drawn before meshing."""

import FreeCADGui
import gui_helpers
from PySide import QtCore

import MeshQuality as mq
from MeshQuality.gui import commands


class SizeFields(gui_helpers.PanelTest):
    def setUp(self):
        super().setUp()
        self.part = self.document.addObject("Part::Box", "Block")
        self.ball = self.document.addObject("Part::Sphere", "Ball")
        self.ball.Radius = 3
        self.document.recompute()

    def field(self, panel):
        return panel.options._fields["size_field"].widget

    def test_a_region_of_what_is_selected_is_drawn_and_meshed(self):
        panel = self.panel(commands.Triangulate, self.part)
        box = self.field(panel)
        self.assertTrue(box.table.isHidden())
        FreeCADGui.Selection.clearSelection()
        box.add.click()
        self.assertIn("Select solids", box.words.text())
        FreeCADGui.Selection.addSelection(self.ball)
        box.add.click()
        region = self.document.getObject("SizeRegion")
        self.assertEqual((box.names(), region.Kind), (["SizeRegion"], "Inside"))
        self.narrow(panel, "panel_size_fields")
        table = box.table
        self.assertLessEqual(table.columnViewportPosition(1) + table.columnWidth(1), table.viewport().width())
        self.assertGreaterEqual(table.columnWidth(0), table.fontMetrics().horizontalAdvance(region.Label))
        box.draw.click()
        self.assertRegex(box.words.text(), r"about [\d,]+ triangles")
        graph = FreeCADGui.getDocument(self.document.Name).activeView().getSceneGraph()
        node = box._drawn.node
        self.assertGreaterEqual(graph.findChild(node), 0)
        before = box.words.text()
        box.table.item(0, 1).setText("0.3 mm")
        self.assertAlmostEqual(region.Size.Value, 0.3)
        self.assertNotEqual(box.words.text(), before)
        box.table.item(0, 1).setText("-1 mm")
        self.assertAlmostEqual(region.Size.Value, 0.3)
        box.draw.click()
        self.assertIsNone(box._drawn.node)
        self.finish(panel)
        self.assertEqual(panel.said, "")
        obj = self.document.Objects[-1]
        self.assertEqual(obj.SizeField, [region])
        self.assertGreater(obj.Mesh.CountFacets, 100)

    def test_faces_make_a_region_near_them(self):
        panel = self.panel(commands.Triangulate, self.part)
        box = self.field(panel)
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.part, "Face1")
        box.add.click()
        region = self.document.getObject("SizeRegion")
        self.assertEqual((region.Kind, region.Of[0][1]), ("Near", ("Face1",)))
        box.table.item(0, 0).setCheckState(QtCore.Qt.Unchecked)
        self.assertEqual(box.names(), [])

    def test_the_panel_of_an_object_shows_its_regions(self):
        region = mq.add_size_region(self.ball, 0.5)
        other = mq.add_size_region(self.ball, 0.7)
        obj = mq.add_quality_mesh(self.part, size_field=[other])
        panel = commands.panel_of(obj)
        FreeCADGui.Control.showDialog(panel)
        self.addCleanup(FreeCADGui.Control.closeDialog)
        self.assertEqual(self.field(panel).names(), [other.Name])
        self.assertEqual(self.field(panel).table.rowCount(), 2)
        self.assertTrue(region.ViewObject.Proxy.getIcon().endswith("SizeRegion.svg"))
