# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of preferences: what it shows, what it keeps."""

import os
import unittest.mock

import FreeCADGui
import gui_helpers
from PySide import QtCore, QtGui

from MeshQuality.gui import commands, preferences

WAIT = 300  # ms until the dialog has been drawn


class Preferences(gui_helpers.PanelTest):
    def in_dialog(self, act):
        """Opens FreeCAD's preferences at our page; act(dialog) works there, then OK is pressed."""
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
        FreeCADGui.showPreferences("Mesh Quality", 0)
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
