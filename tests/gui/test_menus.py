# SPDX-License-Identifier: LGPL-2.1-or-later
"""The menu of the workbench by task, its toolbar, icons and help."""

import os
import unittest

import FreeCAD
import FreeCADGui
import gui_helpers
import numpy as np
from PySide import QtGui

import MeshQuality as mq
from MeshQuality.features import cfd_surface
from MeshQuality.gui import commands, help_pages
from MeshQuality.gui.view import badge


def painted(icon):
    """The pixels of an icon at the size of toolbars."""
    picture = QtGui.QImage(24, 24, QtGui.QImage.Format_RGB888)
    picture.fill(0xFFFFFF)
    painter = QtGui.QPainter(picture)
    QtGui.QIcon(icon).paint(painter, 0, 0, 24, 24)
    painter.end()
    return gui_helpers.pixels_of(picture)


class Menus(gui_helpers.PanelTest):
    def test_the_menu_is_by_task(self):
        menu, = (menu for menu in FreeCADGui.getMainWindow().menuBar().findChildren(QtGui.QMenu) if menu.title() == "Mesh Quality")
        titles = [action.text() for action in menu.actions()]
        self.assertEqual(titles, ["Mesh", "Solve", "Print", "Inspect", "Repair", "Hand over", "Update mesh", "Help"])
        listed = [command for _, group in commands._MENUS for command in group]
        self.assertEqual(len(listed), len(set(listed)))
        below, = (below for below in menu.findChildren(QtGui.QMenu) if below.title() == "Mesh")
        self.assertEqual(below.actions()[0].text(), "Quality mesh...")
        menu.popup(FreeCADGui.getMainWindow().mapToGlobal(FreeCADGui.getMainWindow().rect().center()))
        gui_helpers.wait(0.3)
        gui_helpers.screen().save(os.path.join(gui_helpers.PICTURES, "menu.png"))
        menu.close()

    def test_three_toolbars_of_seven_buttons_at_most(self):
        self.assertEqual(len(commands._TOOLBARS), 3)
        for title, group in commands._TOOLBARS:
            toolbar = FreeCADGui.getMainWindow().findChild(QtGui.QToolBar, title)
            shown = [action.text() for action in toolbar.actions() if not action.isSeparator()]
            self.assertEqual(shown, [command.TEXT + ("..." if command.ASKS else "") for command in group])
            self.assertLessEqual(len(shown), 7)
        listed = {command for _, group in commands._MENUS for command in group}
        self.assertTrue({command for _, group in commands._TOOLBARS for command in group} <= listed)

    def test_commands_say_what_is_to_be_selected(self):
        for command in commands._COMMANDS:
            self.assertRegex(command.NEEDS, r"^Select .* first.*\.$", command.NAME)
            tip = FreeCADGui.Command.get(command.NAME).getInfo()["toolTip"]
            self.assertIn(command.NEEDS, tip)

    def test_icons_of_different_commands_differ(self):
        """Each is at least as far from every other as a tenth of its pixels, at the size of toolbars."""
        names = [command.NAME for _, group in commands._MENUS for command in group]
        found = {name: painted(badge.path_of(name)) for name in names}
        for name in ("MeshQuality_Wrap", "MeshQuality_FlowCase", "MeshQuality_CfdSurface"):
            for other in names:
                if other != name:
                    far = (abs(found[name] - found[other]).max(axis=2) > 60).mean()
                    self.assertGreater(far, 0.35, (name, other))

    def test_disabled_icons_are_told_from_enabled_ones_on_dark_and_light(self):
        def colourful(icon, mode):
            image = gui_helpers.pixels_of(icon.pixmap(24, 24, mode).toImage())
            return np.count_nonzero(image.max(axis=2) - image.min(axis=2) > 60)

        for command in (command.NAME for _, group in commands._MENUS for command in group):
            icon = QtGui.QIcon(badge.path_of(command))
            self.assertGreater(colourful(icon, QtGui.QIcon.Normal), 10, command)
            self.assertEqual(colourful(icon, QtGui.QIcon.Disabled), 0, command)

    @unittest.skipUnless(cfd_surface._can_be_undone(), "this core has a kernel of its own and shares no shape in place")
    def test_a_cfd_surface_has_its_icon_in_the_tree_also_when_opened_again(self):
        surface = mq.add_cfd_surface(mq.add_quality_mesh(self.box()))
        for _ in range(2):
            icon = self.document.getObject(surface.Name).ViewObject.Icon
            far = abs(painted(icon) - painted(badge.path_of("MeshQuality_CfdSurface"))).mean()
            self.assertLess(far, 20.0)  # FreeCAD draws it at another size first
            name, surface = surface.Name, None
            self.reopen()
            surface = self.document.getObject(name)
            gui_helpers.wait()


class Help(gui_helpers.PanelTest):
    def test_first_steps_open_with_pictures_and_links(self):
        FreeCADGui.runCommand("MeshQuality_FirstSteps")
        pages = help_pages._pages
        self.addCleanup(pages.close)
        gui_helpers.wait(0.3)
        self.assertTrue(pages.isVisible())
        self.assertIn("A first part in five minutes", pages.text.toPlainText())
        pages.grab().save(os.path.join(gui_helpers.PICTURES, "first_steps.png"))
        pages.text.setSource(pages.text.source().resolved(help_pages.QtCore.QUrl("mesh-objects.md")))
        self.assertIn("Mesh objects in the document", pages.text.toPlainText())

    def test_the_examples_can_be_meshed_measured_and_repaired_at_once(self):
        FreeCADGui.runCommand("MeshQuality_Examples")
        scanned, document = FreeCAD.getDocument("Scan"), FreeCAD.ActiveDocument
        for opened in (scanned, document):
            self.addCleanup(FreeCAD.closeDocument, opened.Name)
        part, = commands._selected()
        self.assertTrue(part.Shape.isValid() and len(part.Shape.Solids) == 1)
        mesh = mq.add_quality_mesh(part)
        self.assertEqual(mesh.Certificate, "met")
        self.assertTrue(mesh.Closed)
        found = mq.add_deviation(scanned.Scan, scanned.Tee, tolerance=0.2, align="any")
        self.assertTrue(0.4 < found.Highest.Value < 0.8)
        self.assertGreater(found.Within, 90)
        self.assertFalse(scanned.Scan.Mesh.isSolid())
        self.assertTrue(mq.add_repaired_mesh(scanned.Scan).Closed)
