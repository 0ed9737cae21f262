# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of patches, and the export of a mesh by them."""

import importlib.util
import os
import unittest
from unittest import mock

import FreeCAD
import FreeCADGui
import gui_helpers
import Mesh
import numpy as np
import test_units
from PySide import QtGui

import MeshQuality as mq
from MeshQuality.gui import commands
from MeshQuality.gui.panels import case_panel, export_panel, patches_panel, quality_panel


class Patches(gui_helpers.PanelTest):
    def quality(self):
        self.part = self.box()
        obj = mq.add_quality_mesh(self.part, chord_height=0.5)
        self.select(obj)
        return obj

    def panel_for(self, obj):
        panel = patches_panel.PatchesPanel(obj)
        FreeCADGui.Control.showDialog(panel)
        gui_helpers.wait()
        return panel

    def pick(self, *faces):
        FreeCADGui.Selection.clearSelection()
        for face in faces:
            FreeCADGui.Selection.addSelection(self.part, face)

    def test_it_is_for_one_mesh_of_a_source(self):
        obj, command = self.quality(), commands.Patches()
        improved = mq.add_improved_mesh(obj)
        for chosen, active in (((obj,), True), ((self.part,), False), ((improved,), False), ((), False)):
            self.select(*chosen)
            self.assertEqual(command.IsActive(), active)

    def test_no_part_is_selected_as_a_whole_while_faces_are_picked(self):
        obj = self.quality()
        self.select(self.part)
        panel = self.panel_for(obj)
        self.assertEqual(FreeCADGui.Selection.getSelectionEx(), [])
        panel.reject()
        self.pick("Face2")
        panel = self.panel_for(obj)
        panel.new.click()
        self.assertEqual(list(panel.patches()), ["patch_1"])
        panel.reject()

    def test_a_name_is_edited_within_its_column_in_a_theme_with_wide_fields(self):
        app = QtGui.QApplication.instance()
        self.addCleanup(app.setStyleSheet, app.styleSheet())
        app.setStyleSheet(gui_helpers.DARK + "QLineEdit { min-width: 100px; margin: 2px; padding: 4px }")
        panel = self.panel_for(self.quality())
        self.pick("Face1")
        panel.new.click()
        gui_helpers.wait(0.2)
        gui_helpers.screen().save(os.path.join(gui_helpers.PICTURES, "patches_dark.png"))
        editor, = panel.table.findChildren(QtGui.QLineEdit)
        self.assertLess(panel.table.columnWidth(0), 110)
        self.assertLessEqual(editor.geometry().right(), panel.table.visualItemRect(panel.table.item(0, 0)).right())
        panel.reject()

    @unittest.skipUnless(importlib.util.find_spec("Fem"), "this FreeCAD has no FEM workbench")
    def test_of_a_fem_mesh_they_are_groups(self):
        self.part = self.box()
        obj = mq.add_fem_mesh(self.part)
        self.select(obj)
        self.assertTrue(commands.Patches().IsActive())
        panel = self.panel_for(obj)
        self.pick("Face1", "Face2")
        panel.new.click()
        panel.rest.setText("others")
        gui_helpers.wait()
        gui_helpers.screen().save(os.path.join(gui_helpers.PICTURES, "patches_fem.png"))
        self.assertTrue(panel.accept())
        names = {obj.FemMesh.getGroupName(group) for group in obj.FemMesh.Groups}
        self.assertLessEqual({"patch_1", "others", "Face1"}, names)
        self.assertTrue(obj.ViewObject.Visibility)
        panel = self.panel_for(obj)
        self.assertEqual(panel.rest.text(), "others")
        panel.rest.setText("Face9")
        self.assertFalse(panel.accept())
        self.assertIn("Face9", panel.said)
        panel.reject()

    def test_selected_faces_become_patches(self):
        obj = self.quality()
        panel = self.panel_for(obj)
        self.assertTrue(self.part.ViewObject.Visibility)
        self.pick("Face1", "Face2")
        panel.new.click()
        panel.table.item(0, 0).setText("inlet")
        self.pick("Face2", "Face3")
        panel.new.click()
        panel.table.item(1, 0).setText("outlet")
        self.pick("Face4")
        panel.more.click()
        panel.rest.setText("walls")
        self.assertEqual(panel.patches(), {"inlet": {"faces": ["Face1"]}, "outlet": {"faces": ["Face2", "Face3", "Face4"]}})
        gui_helpers.wait()
        self.narrow(panel, "panel_patches")
        self.assertTrue(panel.accept())
        self.assertEqual(list(obj.Patches), ["inlet: Face1", "outlet: Face2, Face3, Face4"])
        self.assertEqual(obj.PatchRest, "walls")
        self.assertFalse(self.part.ViewObject.Visibility)
        self.assertTrue(obj.ViewObject.Visibility)

    def test_marked_patches_show_their_faces(self):
        obj = self.quality()
        mq.set_patches(obj, {"inlet": {"faces": ["Face1", "Face5"], "colour": "#00ff00"}})
        panel = self.panel_for(obj)
        panel.table.selectRow(0)
        chosen = FreeCADGui.Selection.getSelectionEx()
        self.assertEqual([list(one.SubElementNames) for one in chosen], [["Face1", "Face5"]])
        panel.remove.click()
        self.assertEqual(panel.patches(), {})
        panel.reject()
        self.assertEqual(list(obj.Patches), ["inlet #00ff00: Face1, Face5"])

    def test_what_is_wrong_is_said_in_the_panel(self):
        panel = self.panel_for(self.quality())
        FreeCADGui.Selection.clearSelection()
        panel.new.click()
        self.assertIn("Select faces", panel.said)
        panel.more.click()
        self.assertIn("Mark one patch", panel.said)
        self.pick("Face1")
        panel.new.click()
        panel.table.item(0, 0).setText("a:b")
        self.assertFalse(panel.accept())
        self.assertIn("a:b", panel.said)
        panel.names.setCurrentIndex(panel.names.findData("labels"))
        panel.names.activated.emit(panel.names.currentIndex())
        self.assertIn("holds no parts", panel.said)
        panel.reject()

    def test_colours_of_faces_are_patches(self):
        obj = self.quality()
        red, grey = (1.0, 0.0, 0.0, 0.0), (0.8, 0.8, 0.8, 0.0)
        self.part.ViewObject.DiffuseColor = [red, grey, grey, grey, grey, red]
        panel = self.panel_for(obj)
        panel.names.activated.emit(panel.names.findData("colours"))
        self.assertEqual(panel.patches()["colour_ff0000"], {"faces": ["Face1", "Face6"], "colour": "#ff0000"})
        panel.reject()

    def colours_of(self, image):
        """The hues of a picture that cover some of it, in degrees."""
        high, low = image.max(axis=2), image.min(axis=2)
        strong = image[(high - low) > 60]
        hues = np.array([QtGui.QColor(*map(int, pixel)).hue() for pixel in strong[::97]])
        return {int(hue) for hue in np.unique(hues // 10 * 10) if np.count_nonzero(hues // 10 * 10 == hue) > 20}

    def test_the_mesh_has_the_colours_of_its_patches(self):
        obj = self.quality()
        FreeCADGui.Selection.clearSelection()
        plain = self.colours_of(self.picture("patches_none"))
        panel = self.panel_for(obj)
        self.pick("Face2")
        panel.new.click()
        with mock.patch.object(patches_panel.FreeCAD.Console, "PrintMessage") as told:
            self.assertTrue(panel.accept())
        self.assertEqual(told.call_args_list[-1].args[0], f"{obj.Label}: patches patch_1 (1 face)\n")
        self.assertEqual(plain, set())
        self.assertEqual(self.colours_of(self.picture("patches_one")), {0})  # distinct_colour(0) is red
        mq.set_patches(obj, {"top": {"faces": ["Face6"], "colour": "#0000ff"}})
        self.assertEqual(self.colours_of(self.picture("patches_blue")), {240})
        self.part.Length = 20
        self.document.recompute()
        self.assertEqual(self.colours_of(self.picture("patches_recomputed")), {240})
        mq.set_patches(obj, None)
        self.assertEqual(self.colours_of(self.picture("patches_no_more")), set())
        self.document.undo()
        self.assertEqual(self.colours_of(self.picture("patches_undone")), {240})

    def test_patches_are_coloured_after_reading_the_document(self):
        obj = self.quality()
        mq.set_patches(obj, {"top": {"faces": ["Face6"], "colour": "#0000ff"}})
        path = os.path.join(self.folder, "patches.FCStd")
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path)
        gui_helpers.wait()
        self.view = FreeCADGui.getDocument(self.document.Name).activeView()
        self.assertEqual(self.colours_of(self.picture("patches_read")), {240})

    def test_faces_of_patches_are_coloured_while_others_are_picked(self):
        obj = self.quality()
        mq.set_patches(obj, {"top": {"faces": ["Face6"], "colour": "#0000ff"}})
        before = self.part.ViewObject.DiffuseColor
        panel = self.panel_for(obj)
        self.assertEqual(self.colours_of(self.picture("patches_picking")), {240})
        self.pick("Face2")
        panel.new.click()
        FreeCADGui.Selection.clearSelection()
        gui_helpers.wait()
        self.assertEqual(len(self.colours_of(self.picture("patches_picked"))), 2)
        panel.table.selectRow(0)
        panel.remove.click()
        FreeCADGui.Selection.clearSelection()
        self.assertEqual(len(self.colours_of(self.picture("patches_removed"))), 1)
        panel.reject()
        self.assertEqual(self.part.ViewObject.DiffuseColor, before)

    def test_export_writes_them(self):
        obj = self.quality()
        mq.set_patches(obj, {"inlet": ["Face1"]}, patch_rest="walls")
        panel = export_panel.ExportPanel(obj)
        FreeCADGui.Control.showDialog(panel)
        panel.path.setProperty("fileName", os.path.join(self.folder, "part.stl"))
        gui_helpers.wait()
        panel.text.setChecked(True)
        panel.unit.setCurrentIndex(panel.unit.findData(0.001))
        gui_helpers.wait()
        self.narrow(panel, "panel_export_patches")
        panel.accept()
        self.until(lambda: panel.job is None)
        self.assertEqual(panel.said, "")
        with open(os.path.join(self.folder, "part.stl"), encoding="utf-8") as stream:
            text = stream.read()
        self.assertEqual([line.split()[1] for line in text.splitlines() if line.startswith("solid")], ["inlet", "walls"])
        largest = max(abs(float(word)) for line in text.splitlines() if "vertex" in line for word in line.split()[1:])
        self.assertLess(largest, 0.1)

    def test_the_quality_view_lists_patches(self):
        obj = self.quality()
        mq.set_patches(obj, {"inlet": ["Face1"]}, patch_rest="walls")
        panel = quality_panel.QualityPanel(obj)
        FreeCADGui.Control.showDialog(panel)
        self.until(lambda: panel.values is not None)
        names = [panel.faces.item(row, 0).text() for row in range(panel.faces.rowCount())]
        self.assertEqual(sorted(names), ["inlet", "walls"])
        panel.faces.selectRow(names.index("inlet"))
        self.assertEqual(int(panel.lit.sum()), sum(1 for face in panel.data.face if face == 0))
        self.assertIn("Patches", panel.tabs.tabText(1))

    def test_a_part_in_a_moved_container(self):
        """Its faces are named below the container."""
        part = self.document.addObject("App::Part", "Outer")
        self.part = self.box()
        part.addObject(self.part)
        part.Placement = FreeCAD.Placement(FreeCAD.Vector(100, 20, 3), FreeCAD.Rotation(10, 20, 30))
        self.document.recompute()
        obj = mq.add_quality_mesh(part, chord_height=0.5)
        panel = self.panel_for(obj)
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(part, f"{self.part.Name}.Face3")
        panel.new.click()
        panel.table.item(0, 0).setText("inlet")
        panel.rest.setText("walls")
        self.assertEqual(panel.patches(), {"inlet": {"faces": [f"{self.part.Name}.Face3"]}})
        self.narrow(panel, "panel_patches_nested")
        self.assertTrue(panel.accept())
        path = os.path.join(self.folder, "nested.stl")
        mq.export_mesh(obj, path, ascii=True)
        with open(path, encoding="utf-8") as stream:
            lines = stream.read().splitlines()
        self.assertEqual([line.split()[1] for line in lines if line.startswith("solid")], ["inlet", "walls"])

    def test_a_case_of_several_solids_is_refused_inside(self):
        part = self.document.addObject("App::Part", "Two")
        for x in (0, 100):
            box = self.box()
            box.Placement.Base.x = x
            part.addObject(box)
        self.document.recompute()
        panel = case_panel.CasePanel(mq.add_quality_mesh(part, chord_height=0.5))
        FreeCADGui.Control.showDialog(panel)
        panel.path.setProperty("fileName", os.path.join(self.folder, "case"))
        panel.accept()
        self.assertIn("2 solids", panel.said)
        panel.reject()

    def test_undo(self):
        obj = self.quality()
        panel = self.panel_for(obj)
        self.pick("Face1")
        panel.new.click()
        panel.accept()
        self.assertEqual(list(obj.Patches), ["patch_1: Face1"])
        FreeCAD.ActiveDocument.undo()
        self.assertEqual(list(obj.Patches), [])

    def test_a_case_for_openfoam(self):
        obj = self.quality()
        mq.set_patches(obj, {"inlet": ["Face1"]}, patch_rest="walls")
        self.assertTrue(commands.FlowCase().IsActive())
        panel = case_panel.CasePanel(obj)
        FreeCADGui.Control.showDialog(panel)
        folder = os.path.join(self.folder, "case")
        panel.path.setProperty("fileName", folder)
        panel.flow.setCurrentIndex(1)
        panel.cell.setValue(5)
        self.narrow(panel, "panel_case")
        panel.accept()
        self.until(lambda: panel.job is None)
        self.assertTrue(FreeCADGui.Control.activeDialog())  # says what to do next until it is closed
        self.assertIn(f"type: cd {folder} && blockMesh", panel.said)
        self.narrow(panel, "panel_case_written")
        panel.reject()
        self.assertFalse(FreeCADGui.Control.activeDialog())
        self.assertEqual(sorted(os.listdir(folder)), ["constant", "system"])
        self.assertEqual(cfd_ready(), {})

    def test_the_folder_of_a_case_has_the_name_of_the_part_without_blanks(self):
        obj = self.quality()
        obj.Source.Label = "Pipe tee (2)"
        panel = case_panel.CasePanel(obj)
        self.assertEqual(os.path.basename(panel.path.property("fileName")), "Pipe_tee_2_case")
        panel.path.setProperty("fileName", os.path.join(self.folder, "my case"))
        FreeCADGui.Control.showDialog(panel)
        with mock.patch.object(FreeCAD.Console, "PrintMessage") as said, mock.patch.object(FreeCAD.Console, "PrintWarning") as warned:
            panel.accept()
            self.until(lambda: panel.job is None)
        lines = "".join(call.args[0] for call in said.call_args_list)
        self.assertIn(f"type: cd '{self.folder}/my case' && blockMesh && snappyHexMesh -overwrite && checkMesh", lines)
        self.assertIn("no blanks in paths", warned.call_args.args[0])
        self.assertIn("no blanks in paths", panel.said)
        panel.reject()

    def test_a_case_needs_a_folder_that_can_be_made(self):
        obj = self.quality()
        panel = case_panel.CasePanel(obj)
        FreeCADGui.Control.showDialog(panel)
        path = os.path.join(self.folder, "file")
        with open(path, "w", encoding="utf-8"):
            pass
        for folder, words in (("", "Choose a folder"), (os.path.join(path, "case"), "cannot be made")):
            panel.path.setProperty("fileName", folder)
            panel.accept()
            self.until(lambda: panel.job is None)
            self.assertIn(words, panel.said)
        panel.reject()


class Inches(test_units.UnitsTest):
    def test_a_case_takes_and_shows_the_users_unit(self):
        panel = case_panel.CasePanel(mq.add_quality_mesh(self.box(), chord_height=0.5))
        FreeCADGui.Control.showDialog(panel)
        panel.cell.setValue(2.54)
        self.assertIn("0.1", panel.cell.text())
        self.assertAlmostEqual(panel.cell.value(), 2.54)
        self.narrow(panel, "panel_case_inches")
        panel.path.setProperty("fileName", os.path.join(self.folder, "case"))
        panel.accept()
        self.until(lambda: panel.job is None)
        with open(os.path.join(self.folder, "case", "system", "meshDict"), encoding="utf-8") as stream:
            self.assertIn("maxCellSize 0.00254;", stream.read())


def cfd_ready():
    from MeshQuality.features import cfd

    return cfd._ready


class OfAWrap(gui_helpers.PanelTest):
    """Of several sources, a mesh among them."""

    def setUp(self):
        super().setUp()
        self.part = self.document.addObject("Part::Box", "Part")
        self.scan = self.document.addObject("Mesh::Feature", "Scan")
        self.scan.Mesh = Mesh.createBox(10.0, 10.0, 10.0)
        self.scan.Placement.Base = FreeCAD.Vector(15.4, 5, 5)
        self.document.recompute()
        self.wrapped = mq.add_wrap([self.part, self.scan], 2.0, 1.0)

    def panel_for(self):
        self.select(self.wrapped)
        self.assertTrue(commands.Patches().IsActive())
        panel = patches_panel.PatchesPanel(self.wrapped)
        FreeCADGui.Control.showDialog(panel)
        gui_helpers.wait()
        return panel

    def test_faces_of_any_source_become_patches(self):
        self.part.ViewObject.Visibility = self.scan.ViewObject.Visibility = False
        panel = self.panel_for()
        self.assertTrue(self.part.ViewObject.Visibility and self.scan.ViewObject.Visibility)
        FreeCADGui.Selection.clearSelection()
        panel.new.click()
        self.assertIn("Select faces of Part, Scan", panel.said)
        FreeCADGui.Selection.addSelection(self.part, "Face1")
        panel.new.click()
        panel.table.item(0, 0).setText("inlet")
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(self.scan)
        panel.new.click()
        panel.table.item(1, 0).setText("scanned")
        panel.table.selectRow(1)
        self.assertEqual([one.Object for one in FreeCADGui.Selection.getSelectionEx()], [self.scan])
        panel.table.selectRow(0)
        chosen = FreeCADGui.Selection.getSelectionEx()
        self.assertEqual([(one.Object, list(one.SubElementNames)) for one in chosen], [(self.part, ["Face1"])])
        panel.rest.setText("walls")
        self.assertEqual(panel.patches(), {"inlet": {"faces": ["Part.Face1"]}, "scanned": {"faces": ["Scan"]}})
        self.view.viewIsometric()
        self.view.fitAll()
        self.narrow(panel, "panel_patches_wrap")
        self.assertTrue(panel.accept())
        self.assertEqual(list(self.wrapped.Patches), ["inlet: Part.Face1", "scanned: Scan"])
        self.assertFalse(self.part.ViewObject.Visibility or self.scan.ViewObject.Visibility)
        path = os.path.join(self.folder, "wrap.stl")
        mq.export_mesh(self.wrapped, path, ascii=True)
        with open(path, encoding="utf-8") as stream:
            names = [line.split()[1] for line in stream if line.startswith("solid")]
        self.assertEqual(names, ["inlet", "scanned", "walls"])

    def test_labels_of_the_sources(self):
        panel = self.panel_for()
        panel.names.activated.emit(panel.names.findData("labels"))
        self.assertEqual(panel.patches(), {"Part": {"faces": [f"Part.Face{k}" for k in range(1, 7)]},
                                           "Scan": {"faces": ["Scan"]}})
        panel.names.activated.emit(panel.names.findData("analysis"))
        self.assertNotEqual(panel.said, "")
        panel.reject()

    def test_the_quality_view_lists_faces_and_gaps(self):
        panel = quality_panel.QualityPanel(self.wrapped)
        FreeCADGui.Control.showDialog(panel)
        self.until(lambda: panel.values is not None)
        names = {panel.faces.item(row, 0).text() for row in range(panel.faces.rowCount())}
        self.assertLessEqual({"gaps", "Scan", "Part_Face1"}, names)
        panel.tabs.setCurrentIndex(1)
        self.picture("quality_wrap_patches")
        panel.reject()
