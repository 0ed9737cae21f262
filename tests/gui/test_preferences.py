# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of preferences: what it shows, what it keeps."""

import os
import unittest.mock

import FreeCADGui
import gui_helpers
from PySide import QtCore, QtGui

from MeshQuality.features import file_settings
from MeshQuality.gui import commands, preferences

WAIT = 300  # ms until the dialog has been drawn


class Preferences(gui_helpers.PanelTest):
    def in_dialog(self, act, page=0):
        """Opens FreeCAD's preferences at one of our pages; act(dialog) works there, then OK is pressed."""
        failed = []

        def work():
            dialog = QtGui.QApplication.activeModalWidget()
            if dialog is None:
                QtCore.QTimer.singleShot(WAIT, work)
                return
            try:
                act(dialog)
            except Exception as error:  # noqa: BLE001 - Qt would swallow it; the test raises it
                failed.append(error)
            finally:
                buttons = dialog.findChild(QtGui.QDialogButtonBox)
                buttons.button(QtGui.QDialogButtonBox.Ok).click()

        QtCore.QTimer.singleShot(WAIT, work)
        FreeCADGui.showPreferences("Mesh Quality", page)
        if failed:
            raise failed[0]

    def test_it_shows_the_defaults_that_the_code_has(self):
        def act(dialog):
            self.assertEqual(dialog.findChild(QtGui.QDoubleSpinBox, "minAngle").value(), 25.0)
            self.assertTrue(dialog.findChild(QtGui.QCheckBox, "rememberValues").isChecked())
            self.assertTrue(dialog.findChild(QtGui.QCheckBox, "background").isChecked())
            self.assertEqual(dialog.findChild(QtGui.QSpinBox, "manualAbove").value(),
                             preferences.manual_above())
            self.assertEqual(dialog.findChild(QtGui.QSpinBox, "threads").text(), "One for each core")
            dialog.grab().save(f"{gui_helpers.PICTURES}/preferences.png")

        self.in_dialog(act)

    def test_what_is_set_there_is_what_the_panels_use(self):
        def act(dialog):
            dialog.findChild(QtGui.QDoubleSpinBox, "minAngle").setValue(28.5)
            dialog.findChild(QtGui.QCheckBox, "rememberValues").setChecked(False)
            dialog.findChild(QtGui.QSpinBox, "manualAbove").setValue(12)
            dialog.findChild(QtGui.QCheckBox, "background").setChecked(False)
            dialog.findChild(QtGui.QSpinBox, "threads").setValue(3)

        self.in_dialog(act)
        self.assertEqual(preferences.manual_above(), 12)
        self.assertFalse(preferences.in_background())
        self.assertFalse(preferences.stored().GetBool("RememberValues", True))
        panel = self.panel(commands.Triangulate, self.box())
        self.assertEqual(panel.options.values()["min_angle"], 28.5)

        self.assertEqual(preferences.stored().GetInt("Threads"), 3)

    def test_the_page_of_files_has_the_defaults_and_what_is_set_there_holds(self):
        usual = file_settings.surface_values()

        def look(dialog):
            self.assertEqual(dialog.findChild(QtGui.QComboBox, "fineness").currentText(), "Medium")
            self.assertEqual(dialog.findChild(QtGui.QComboBox, "elements").currentIndex(), 0)
            self.assertEqual(dialog.findChild(QtGui.QSpinBox, "order").value(), 2)
            self.assertEqual(dialog.findChild(QtGui.QComboBox, "unit").currentText(), "mm")
            dialog.grab().save(f"{gui_helpers.PICTURES}/preferences_files.png")

        def change(dialog):
            dialog.findChild(QtGui.QComboBox, "fineness").setCurrentIndex(2)
            dialog.findChild(QtGui.QComboBox, "elements").setCurrentIndex(1)
            dialog.findChild(QtGui.QSpinBox, "order").setValue(3)
            dialog.findChild(QtGui.QComboBox, "unit").setCurrentIndex(1)

        self.in_dialog(look, 1)
        self.assertEqual(file_settings.surface_values(), usual)
        self.in_dialog(change, 1)
        self.assertEqual(file_settings.surface_values()["chord_height_relative"], 0.001)
        self.assertEqual((file_settings.scale(), file_settings.fills_solids()), (0.001, False))
        self.assertEqual([file_settings.element_values(suffix, True)["order"] for suffix in (".msh", ".inp", ".su2")], [3, 2, 1])
        self.in_dialog(lambda dialog: dialog.findChild(QtGui.QWidget, "chordHeight").setProperty("rawValue", 0.5), 1)
        values = file_settings.surface_values()
        self.assertEqual((values["chord_height"], values["chord_height_relative"]), (0.5, None))

    def test_the_environment_decides_on_threads_before_the_user_does(self):
        for environment, preferred, expected in (({}, 0, None), ({}, 3, "3"), ({"MESHQUALITY_THREADS": "2"}, 3, "2")):
            preferences.stored().SetInt("Threads", preferred)
            with self.subTest(environment=environment, preferred=preferred), \
                    unittest.mock.patch.dict(os.environ, environment):
                if not environment:
                    os.environ.pop("MESHQUALITY_THREADS", None)
                preferences.limit_threads()
                self.assertEqual(os.environ.get("MESHQUALITY_THREADS"), expected)

    def test_the_page_has_its_icon(self):
        self.assertFalse(FreeCADGui.getIcon("preferences-mesh_quality").isNull())
