# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench in German: menus, panels, and that numbers and values do not depend on it."""

import FreeCADGui
import gui_helpers
from PySide import QtGui

import MeshQuality as mq
from MeshQuality.gui import commands


def menu_texts():
    """All texts of the main window's menus."""
    found, pending = [], list(FreeCADGui.getMainWindow().menuBar().actions())
    while pending:
        action = pending.pop()
        found.append(action.text().replace("&", ""))
        if action.menu():
            pending += action.menu().actions()
    return found


class German(gui_helpers.PanelTest):
    def setUp(self):
        super().setUp()
        FreeCADGui.setLocale("German")
        self.addCleanup(FreeCADGui.setLocale, "English")
        gui_helpers.wait(0.2)

    def test_menus_are_german_and_english_again(self):
        texts = menu_texts()
        for text in ("Netzqualität", "Qualitätsnetz...", "Gekrümmtes Netz...",
                     "Gekrümmtes Netz exportieren...", "Netz aktualisieren..."):
            self.assertIn(text, texts)
        FreeCADGui.setLocale("English")
        gui_helpers.wait(0.2)
        self.assertIn("Quality mesh...", menu_texts())
        self.assertNotIn("Qualitätsnetz...", menu_texts())

    def test_panels_are_german_and_fit(self):
        sources = self.two_boxes()
        expected = {commands.Triangulate: ("Qualitätsnetz", "Kleinster Winkel", "Sehr fein"),
                    commands.Curve: ("Gekrümmtes Netz", "Ordnung der Elemente", "Sehr fein"),
                    commands.Boolean: ("Boolesche Netzoperation", "Auflösung", "vereinigen")}
        for command, words in expected.items():
            panel = self.panel(command, *sources)
            shown = [panel.form.windowTitle()]
            shown += [label.text() for label in panel.form.findChildren(QtGui.QLabel)]
            for box in panel.form.findChildren(QtGui.QComboBox):
                shown += [box.itemText(i) for i in range(box.count())]
            for word in words:
                self.assertIn(word, shown)
            panel.options.more.setChecked(True)
            self.narrow(panel, f"panel_{command.__name__}_de")
            panel.reject()

    def test_values_and_properties_do_not_depend_on_it(self):
        panel = self.panel(commands.Triangulate, self.box())
        panel.options.set_values({"min_angle": 27.5, "max_edge": 2.25, "method": "star"})
        values = panel.options.values()
        self.assertEqual((values["min_angle"], values["max_edge"], values["method"]),
                         (27.5, 2.25, "star"))
        self.finish(panel)
        obj = self.document.Objects[-1]
        self.assertEqual((obj.MaxEdge.Value, obj.Certificate), (2.25, "kept"))
        FreeCADGui.setLocale("English")
        mq.update(obj, max_edge=3.5)
        self.assertEqual(obj.MaxEdge.Value, 3.5)
