# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench, from selection to result."""

import FreeCADGui
import gui_helpers

from MeshQuality.gui import commands


class Commands(gui_helpers.GuiTest):
    def setUp(self):
        super().setUp()
        FreeCADGui.activateWorkbench("MeshQualityWorkbench")
        FreeCADGui.Selection.clearSelection()

    def test_each_makes_an_object_and_undoes_it_in_one_step(self):
        box = self.box()
        for command in (commands.Triangulate, commands.Curve):
            with self.subTest(command.NAME):
                self.assertFalse(command().IsActive())
                FreeCADGui.Selection.addSelection(box)
                self.assertTrue(command().IsActive())
                FreeCADGui.runCommand(command.NAME)
                gui_helpers.wait()
                obj = self.document.Objects[-1]
                self.assertEqual(obj.Source, box)
                self.assertGreater(obj.Mesh.CountFacets, 0)
                self.assertEqual(self.document.UndoNames[0], command.TEXT)
                self.document.undo()
                self.assertEqual(self.document.Objects, [box])
                FreeCADGui.Selection.clearSelection()

    def test_a_failure_leaves_nothing_behind(self):
        source = self.document.addObject("Part::Feature", "Empty")
        FreeCADGui.Selection.addSelection(source)
        for command in (commands.Triangulate, commands.Curve):
            FreeCADGui.runCommand(command.NAME)
            gui_helpers.wait()
            self.assertEqual(self.document.Objects, [source])
            self.assertFalse(self.document.HasPendingTransaction)

    def test_every_command_has_its_icon(self):
        for command in (commands.Triangulate, commands.Curve):
            self.assertFalse(FreeCADGui.getIcon(command.NAME).isNull())
