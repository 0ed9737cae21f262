# SPDX-License-Identifier: LGPL-2.1-or-later
"""Widths of panels: no word and no number is cut off in the task view as wide as it is at first, in English and German."""

import importlib.util
from pathlib import Path

import FreeCAD
import FreeCADGui
import gui_helpers
import numpy as np
from PySide import QtCore, QtGui

import MeshQuality as mq
from MeshQuality.gui import commands
from MeshQuality.gui.panels import case_panel, export_panel, patches_panel, quality_panel, solid_panel

_CURSOR = 2  # pixels that a field for text has for its cursor
_WINDOW = (1366, 768)
HAS_FEM = importlib.util.find_spec("Fem") is not None


def cut_texts(widget):
    """[(text, pixels needed, pixels there), ...] of all labels, fields and buttons in sight that are narrower than their text."""
    found = []
    for part in widget.findChildren(QtGui.QWidget):
        if not part.isVisible() or part.width() == 0:
            continue
        text, beside = "", 0
        if isinstance(part, QtGui.QLabel) and part.text():
            needed = part.minimumSizeHint().width() if part.wordWrap() else part.sizeHint().width()
            found.append((part.text(), needed, part.width()))
            continue
        if isinstance(part, QtGui.QTableWidget):
            found.append(("columns", part.horizontalHeader().length(), part.viewport().width()))
            for column in range(part.columnCount()):
                text = part.horizontalHeaderItem(column).text()
                found += [(line, part.fontMetrics().horizontalAdvance(line) + 4, part.columnWidth(column)) for line in text.splitlines()]
        if isinstance(part, QtGui.QTabBar):
            found.append((" ".join(part.tabText(i) for i in range(part.count())), part.sizeHint().width(), part.width()))
        if isinstance(part, QtGui.QAbstractButton) and part.text() and part.maximumWidth() > part.width():  # no field's own
            found.append((part.text(), part.minimumSizeHint().width(), part.width()))
            continue
        if isinstance(part, QtGui.QAbstractSpinBox):
            found.append((part.text(), part.fontMetrics().horizontalAdvance(part.text()), part.findChild(QtGui.QLineEdit).width() - _CURSOR))
            continue
        elif isinstance(part, QtGui.QComboBox):
            texts = [part.currentText()] if part.maximumWidth() == part.width() else \
                map(part.itemText, range(part.count()))  # else it becomes as wide as what is chosen
            found += [(text, part.fontMetrics().horizontalAdvance(text), room_of(part)) for text in texts]
            continue
        elif isinstance(part, QtGui.QLineEdit) and not isinstance(part.parentWidget(), QtGui.QAbstractSpinBox):
            text, beside = part.text() or part.placeholderText(), 8
        elif isinstance(part, QtGui.QGroupBox):
            text, beside = part.title(), 8
        if text:
            found.append((text, part.fontMetrics().horizontalAdvance(text) + beside, part.width()))
    return [row for row in found if row[1] > row[2]]


def room_of(box):
    """Pixels that a box with choices has for text, beside its frame and its arrow."""
    option = QtGui.QStyleOptionComboBox()
    box.initStyleOption(option)
    return box.style().subControlRect(QtGui.QStyle.CC_ComboBox, option, QtGui.QStyle.SC_ComboBoxEditField, box).width()


SHEETS = [Path(FreeCAD.getResourceDir(), "Gui", "Stylesheets", "Dark-blue.qss"),
          Path("/usr/share/freecad/Gui/Stylesheets/Dark-blue.qss")]


class Widths(gui_helpers.PanelTest):
    def setUp(self):
        super().setUp()
        window = FreeCADGui.getMainWindow()
        self.addCleanup(window.resize, window.size())
        window.resize(*_WINDOW)

    def in_dark_theme(self):
        sheet = next((path for path in SHEETS if path.exists()), None)
        if sheet is None:
            self.skipTest("this FreeCAD has no Dark-blue.qss")
        app = QtGui.QApplication.instance()
        self.addCleanup(app.setStyleSheet, app.styleSheet())
        app.setStyleSheet(sheet.read_text(encoding="utf-8"))

    def in_language(self, language):
        FreeCADGui.setLocale(language)
        self.addCleanup(FreeCADGui.setLocale, "English")
        gui_helpers.wait(0.2)

    def check(self, panel, name):
        if hasattr(panel, "options"):
            gui_helpers.unfold(panel)
            gui_helpers.wait()
        self.narrow(panel, name)
        self.assertEqual(cut_texts(panel.form), [], name)

    def everywhere(self, language):
        sources = self.two_boxes()
        net = mq.add_quality_mesh(sources[0])
        other = mq.add_quality_mesh(sources[1])
        for command, chosen in (
                (commands.Triangulate, sources[:1]), (commands.Curve, sources[:1]), (commands.FemMesh, sources[:1]),
                (commands.Boolean, [net, other]), (commands.Improve, [net]), (commands.Simplify, [net]), (commands.Repair, [net]),
                (commands.Offset, sources[:1]), (commands.Hollow, sources[:1]), (commands.Wrap, sources[:1]),
                (commands.Inspect, sources[:1]), (commands.FlowMesh, sources[:1])):
            with self.subTest(command.__name__):
                panel = self.panel(command, *chosen)
                try:
                    self.until(lambda made=panel: "..." not in made.estimate.text())
                    self.check(panel, f"width_{language}_{command.__name__}")
                finally:
                    panel.reject()
        for kind in (patches_panel.PatchesPanel, export_panel.ExportPanel, case_panel.CasePanel, solid_panel.SolidPanel):
            panel = kind(net)
            FreeCADGui.Control.showDialog(panel)
            gui_helpers.wait()
            self.until(lambda made=panel: made.job is None if hasattr(made, "job") else True)
            with self.subTest(kind.__name__):
                try:
                    self.check(panel, f"width_{language}_{kind.__name__}")
                finally:
                    panel.reject()
        meshes = [net, mq.add_curved_mesh(sources[0])] + ([mq.add_fem_mesh(sources[0])] if HAS_FEM else [])
        for mesh in meshes:
            self.all_measures(mesh, language)

    def all_measures(self, mesh, language):
        panel = quality_panel.open_panel(mesh)
        self.until(lambda: panel.values is not None)
        panel.section.on.setChecked(True)
        for i in range(panel.measures.count()):
            panel.measures.setCurrentIndex(i)
            self.until(lambda k=i: panel.measure is panel.data.measures[k])
            for tab in range(panel.tabs.count()):
                panel.tabs.setCurrentIndex(tab)
                gui_helpers.wait()
                with self.subTest(mesh.Label, measure=panel.measure.title, tab=tab):
                    self.check(panel, f"width_{language}_quality")
        panel.reject()

    def test_nothing_is_cut_off_in_english(self):
        self.everywhere("English")

    def test_nothing_is_cut_off_in_german(self):
        self.in_language("German")
        self.everywhere("German")

    def test_choices_are_as_wide_as_their_boxes_in_a_dark_theme_need(self):
        self.in_dark_theme()
        self.in_language("German")
        panel = self.panel(commands.Triangulate, self.box())
        choice, = (box for box in panel.form.findChildren(QtGui.QComboBox) if box.findText("Relativ") >= 0)
        panel.form.grab().save(f"{gui_helpers.PICTURES}/width_German_dark.png")
        for i in range(choice.count()):
            choice.setCurrentIndex(i)
            gui_helpers.wait()
            self.assertGreaterEqual(room_of(choice), choice.fontMetrics().horizontalAdvance(choice.currentText()))
        panel.reject()

    def test_lists_of_choices_are_as_dark_as_their_boxes_in_a_dark_theme(self):
        self.in_dark_theme()
        panel = self.panel(commands.Triangulate, self.box())
        gui_helpers.unfold(panel)
        boxes = [box for box in panel.form.findChildren(QtGui.QComboBox) if box.isVisible() and box.count() > 1]
        self.assertGreater(len(boxes), 2)
        for box in boxes:
            box.showPopup()
            gui_helpers.wait(0.2)
            place = QtCore.QRect(box.view().mapToGlobal(QtCore.QPoint(0, 0)), box.view().size())
            pixels = gui_helpers.pixels_of(gui_helpers.screen().copy(place))  # a widget alone has nothing behind it
            box.hidePopup()
            self.assertLess(np.median(pixels), 128, box.currentText())
        panel.reject()

    def test_nothing_is_cut_off_in_a_dark_theme(self):
        self.in_dark_theme()
        self.in_language("German")
        self.everywhere("German_dark")

    def test_buttons_have_room_beside_long_labels_in_a_dark_theme(self):
        self.in_dark_theme()
        panel = self.panel(commands.FemMesh, self.box())
        self.check(panel, "width_English_dark_FemMesh")
        panel.reject()

    def test_nothing_is_cut_off_in_inches(self):
        self.in_language("German")
        gui_helpers.use_units(gui_helpers.INCHES)
        self.addCleanup(gui_helpers.use_units, gui_helpers.MM)
        self.everywhere("German")
