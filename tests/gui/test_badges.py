# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the tree and the panels tell of certificates, and updates that the user asks for."""

import os
from unittest import mock

import FreeCAD
import FreeCADGui
import gui_helpers
import Part
from PySide import QtCore, QtGui

import MeshQuality as mq
from MeshQuality.features import mesh_object
from MeshQuality.gui import commands, jobs, preferences, update
from MeshQuality.gui.view import badge


def colours(icon):
    """How many pixels of an icon at the size of the tree are the badge's red or orange."""
    image = icon.pixmap(64, 64).toImage()
    found = {"red": 0, "orange": 0}
    for x in range(image.width()):
        for y in range(image.height()):
            colour = image.pixelColor(x, y)
            near = {"red": (239, 41, 41), "orange": (245, 121, 0)}
            for name, (r, g, b) in near.items():
                if abs(colour.red() - r) + abs(colour.green() - g) + abs(colour.blue() - b) < 30 \
                        and colour.alpha() > 200:
                    found[name] += 1
    return found


def tree_item(obj):
    """The object's item in FreeCAD's tree."""
    for tree in FreeCADGui.getMainWindow().findChildren(QtGui.QTreeWidget):
        found = tree.findItems(obj.Label, QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive, 0)
        if found:
            return found[0]
    return None


class Badges(gui_helpers.PanelTest):
    def wedge(self):
        source = self.document.addObject("Part::Feature", "Wedge")
        corners = [FreeCAD.Vector(*p) for p in ((0, 0, 0), (10, 0, 0), (10, 0.8, 0), (0, 0, 0))]
        source.Shape = Part.Face(Part.makePolygon(corners)).extrude(FreeCAD.Vector(0, 0, 3))
        self.document.recompute()
        return source

    def edit(self, obj):
        panel = commands.panel_of(obj)
        FreeCADGui.Control.showDialog(panel)
        gui_helpers.wait()
        return panel

    def test_a_missed_certificate_is_marked_red_in_the_tree(self):
        good, bad = mq.add_quality_mesh(self.box()), mq.add_quality_mesh(self.wedge())
        gui_helpers.wait(0.2)
        self.assertEqual(colours(good.ViewObject.Icon)["red"], 0)
        self.assertGreater(colours(bad.ViewObject.Icon)["red"], 100)
        self.assertGreater(colours(tree_item(bad).icon(0))["red"], 0)
        self.assertEqual(colours(tree_item(good).icon(0))["red"], 0)

    def test_the_mark_goes_when_the_promise_is_kept_again(self):
        obj = mq.add_quality_mesh(self.wedge())
        mq.update(obj, min_angle=4.0)
        gui_helpers.wait(0.2)
        self.assertEqual(obj.Certificate, "met")
        self.assertEqual(colours(obj.ViewObject.Icon)["red"], 0)
        self.assertEqual(colours(tree_item(obj).icon(0))["red"], 0)

    def test_an_object_that_is_out_of_date_is_marked_orange(self):
        box = self.box()
        obj = mq.add_quality_mesh(box)
        obj.Recompute = "Manual"
        box.Height = 20
        self.document.recompute()
        gui_helpers.wait(0.2)
        self.assertGreater(colours(obj.ViewObject.Icon)["orange"], 100)
        mq.update(obj)
        self.assertEqual(colours(obj.ViewObject.Icon)["orange"], 0)

    def test_both_badges_are_drawn_from_files_of_ours(self):
        for name in (badge.MISSED, badge.OUTDATED):
            self.assertTrue(os.path.isfile(badge.path_of(name)))
            self.assertIn("XPM", badge.with_badge("MeshQuality_Triangulate", name))

    def test_what_could_not_be_computed_is_marked(self):
        obj = mq.add_quality_mesh(self.box())
        obj.MaxEdge, obj.MinEdge = 1, 2
        self.document.recompute()
        gui_helpers.wait(0.2)
        self.assertEqual(badge.badge_of(obj), badge.FAILED)
        self.assertGreater(colours(obj.ViewObject.Icon)["red"], 100)
        panel = self.edit(obj)
        self.assertIn("The last update failed: The shortest edge of 2 mm", panel.certificate.text.text())
        panel.reject()
        obj.MinEdge = 0.1
        self.document.recompute()
        self.assertIsNone(badge.badge_of(obj))
        self.assertEqual(colours(obj.ViewObject.Icon)["red"], 0)

    def test_each_verdict_has_its_badge_those_of_older_versions_too(self):
        obj = mq.add_quality_mesh(self.box())
        for text, expected, said in (
                ("kept", None, "All requested limits are met."),
                ("missed: smallest angle 4.57 of 25 degrees at triangle 7", badge.MISSED,
                 "Target not met: smallest angle 4.57 of 25 degrees at triangle 7"),
                ("not decided: smallest thickness between 1.9 mm and 2.1 mm", badge.UNDECIDED,
                 "Target not decided: smallest thickness between 1.9 mm and 2.1 mm")):
            obj.Certificate = text
            self.assertEqual(badge.badge_of(obj), expected)
            panel = self.edit(obj)
            self.assertEqual(panel.certificate.text.text(), said)
            self.assertEqual("color" in panel.certificate.text.styleSheet(), expected == badge.MISSED)
            panel.reject()

    def test_a_source_that_was_deleted_is_said(self):
        box = self.box()
        obj = mq.add_quality_mesh(box)
        panel = self.edit(obj)
        self.document.removeObject(box.Name)
        gui_helpers.wait(0.2)
        self.assertEqual(badge.badge_of(obj), badge.FAILED)
        self.assertEqual(obj.Status, mesh_object.SOURCE_DELETED)
        panel.apply()
        self.assertEqual(panel.said, "The source was deleted. Close this panel.")
        panel.reject()
        panel = self.edit(obj)
        self.assertEqual(panel.said, "The source was deleted. Close this panel.")
        texts = [label.text() for label in panel.form.findChildren(QtGui.QLabel) if label.isVisible()]
        self.assertEqual(sum("deleted" in text for text in texts), 1, texts)
        self.assertFalse(any(text.startswith("Source:") for text in texts), texts)
        gui_helpers.wait(0.6)  # the estimate is begun
        self.assertEqual(panel.said, "The source was deleted. Close this panel.")
        panel.reject()

    def test_the_report_view_has_one_line_for_each_mesh(self):
        view = FreeCADGui.getMainWindow().findChild(QtGui.QTextEdit, "Report view")
        view.clear()
        box, wedge = self.box(), self.wedge()
        self.apply(self.panel(commands.Triangulate, box))
        FreeCADGui.Control.closeDialog()
        self.apply(self.panel(commands.Triangulate, wedge))
        FreeCADGui.Control.closeDialog()
        self.document.recompute()
        gui_helpers.wait(0.2)
        lines = [line for line in view.toPlainText().splitlines() if "triangles, " in line]
        self.assertEqual(len(lines), 2, lines)
        self.assertRegex(lines[0], r"Box quality mesh: \d+ triangles, smallest angle 45°, max\. deviation 0 mm; "
                                   r"all requested limits are met\.$")
        self.assertRegex(lines[1], r"Wedge quality mesh: \d+ triangles, .*; target not met: smallest angle 4\.57° ")

    def test_the_panel_shows_the_sentence_and_the_place(self):
        source = self.wedge()
        obj = mq.add_quality_mesh(source)
        source.ViewObject.Visibility = False
        panel = self.edit(obj)
        self.assertIn("Target not met: smallest angle 4.57° (requested 25°)", panel.certificate.text.text())
        self.assertIn("#cc0000", panel.certificate.text.styleSheet())
        self.assertTrue(panel.certificate.button.isVisible())
        self.narrow(panel, "panel_missed")
        mode = obj.ViewObject.DisplayMode
        panel.certificate.button.click()
        chosen = FreeCADGui.Selection.getSelectionEx()
        self.assertEqual([part.Object for part in chosen], [source])
        self.assertEqual(set(chosen[0].SubElementNames), set(obj.CertificateFaces))
        self.assertTrue(source.ViewObject.Visibility)
        self.assertEqual(obj.ViewObject.DisplayMode, "Wireframe")
        panel.reject()
        self.assertEqual(obj.ViewObject.DisplayMode, mode)

    def test_the_panel_says_that_all_is_kept(self):
        panel = self.edit(mq.add_quality_mesh(self.box()))
        self.assertIn("All requested limits are met", panel.certificate.text.text())
        self.assertFalse(panel.certificate.button.isVisible())

    def test_a_panel_that_adds_shows_it_after_apply(self):
        panel = self.panel(commands.Triangulate, self.wedge())
        self.assertTrue(panel.certificate.isHidden())
        self.apply(panel)
        self.assertIn("not met", panel.certificate.text.text())
        panel.options.set_values({"min_angle": 4.0})
        self.apply(panel)
        self.assertIn("All requested limits are met", panel.certificate.text.text())


class Updates(gui_helpers.PanelTest):
    def outdated(self):
        box = self.box()
        obj = mq.add_quality_mesh(box)
        obj.Recompute = "Manual"
        box.Height = 20
        self.document.recompute()
        self.assertEqual(obj.Status, mesh_object.OUT_OF_DATE)
        return obj

    def test_the_context_menu_updates_in_the_background(self):
        obj = self.outdated()
        FreeCADGui.activateWorkbench("PartWorkbench")
        self.addCleanup(FreeCADGui.activateWorkbench, "MeshQualityWorkbench")
        menu = QtGui.QMenu()
        obj.ViewObject.Proxy.setupContextMenu(obj.ViewObject, menu)
        actions = {action.text(): action for action in menu.actions()}
        steps = self.document.UndoCount
        actions["Update mesh"].trigger()
        self.assertEqual(obj.Status, mesh_object.OUT_OF_DATE)
        self.until(lambda: not len(jobs.queue()))
        self.assertEqual(obj.Status, mesh_object.UP_TO_DATE)
        self.assertAlmostEqual(obj.Mesh.BoundBox.ZLength, 20)
        self.assertEqual(self.document.UndoCount, steps + 1)
        self.assertIn("done", FreeCADGui.getMainWindow().statusBar().currentMessage())
        self.document.undo()
        self.assertAlmostEqual(obj.Mesh.BoundBox.ZLength, 10)

    def test_the_macro_line_is_the_api(self):
        obj, lines = self.outdated(), []
        real = FreeCADGui.doCommand
        with mock.patch.object(FreeCADGui, "doCommand",
                               lambda line: (lines.append(line), real(line))):
            update.update_in_background(obj)
            self.until(lambda: not len(jobs.queue()))
        self.assertEqual(lines[1:], [f"mq.update(App.getDocument({self.document.Name!r})"
                                     f".getObject({obj.Name!r}))"])

    def test_what_cannot_be_updated_leaves_it_as_it_is(self):
        obj = self.outdated()
        obj.Source = None
        self.assertIsNone(update.update_in_background(obj))
        self.assertAlmostEqual(obj.Mesh.BoundBox.ZLength, 10)

    def test_heavy_meshes_are_left_to_the_user(self):
        light = mq.add_quality_mesh(self.box())
        preferences.stored().SetInt("ManualAbove", light.Triangles - 1)
        heavy = mq.add_quality_mesh(self.box("Another"))
        self.assertEqual((light.Recompute, heavy.Recompute), ("Automatic", "Manual"))

    def test_editing_an_outdated_object_updates_it(self):
        obj = self.outdated()
        panel = commands.panel_of(obj)
        FreeCADGui.Control.showDialog(panel)
        self.assertIn("out of date", panel.certificate.text.text())
        self.finish(panel)
        self.assertEqual(obj.Status, mesh_object.UP_TO_DATE)
        self.assertAlmostEqual(obj.Mesh.BoundBox.ZLength, 20)
