# SPDX-License-Identifier: LGPL-2.1-or-later
"""Heights of panels: OK and what tells of the work are seen on a low screen, however many options are open and wherever these
are scrolled to, in English and German, mm and inches, light and dark.
"""

import FreeCADGui
import gui_helpers
from PySide import QtCore, QtGui
from test_widths import SHEETS

import MeshQuality as mq
from MeshQuality.gui import commands
from MeshQuality.gui.panels.flow_panel import FlowPanel
from MeshQuality.gui.panels.mesh_panel import MeshPanel

_WINDOW = (1366, 768)


def is_seen(widget, area):
    """Whether all of a widget is within what a scroll area shows."""
    top = widget.mapTo(area.viewport(), QtCore.QPoint())
    return widget.isVisible() and area.viewport().rect().contains(QtCore.QRect(top, widget.size()))


class Heights(gui_helpers.PanelTest):
    def setUp(self):
        super().setUp()
        window = FreeCADGui.getMainWindow()
        self.addCleanup(window.resize, window.size())
        window.resize(*_WINDOW)
        self.as_at_first()
        self.addCleanup(gui_helpers.use_units, gui_helpers.MM)
        self.addCleanup(FreeCADGui.setLocale, "English")

    def opened(self, command, sources):
        """Its panel, and the scroll area of FreeCAD in which that is."""
        self.select(*sources)
        kind = FlowPanel if command is commands.FlowMesh else MeshPanel
        panel = kind(command().operations(command().selected()))
        FreeCADGui.Control.showDialog(panel)
        self.until(lambda: "..." not in panel.estimate.text())
        area, = (area for area in FreeCADGui.getMainWindow().findChildren(QtGui.QScrollArea) if area.isAncestorOf(panel.form))
        return panel, area

    def check(self, panel, area):
        """What tells of the work is seen where the options are scrolled to their end, which their own scroll bar reaches."""
        bar = panel.lowest.verticalScrollBar()
        shown = [panel.button, panel.lowest, *([panel.estimate] if panel.estimate.text() else [])]

        def is_right():
            bar.setValue(bar.maximum())
            hidden = panel.fields.height() - panel.lowest.viewport().height()
            return area.verticalScrollBar().maximum() == 0 and bar.maximum() == hidden \
                and panel.fields.width() == panel.lowest.viewport().width() and all(is_seen(widget, area) for widget in shown)

        self.until(is_right)

    def everywhere(self):
        sources = self.two_boxes()
        meshes = [mq.add_quality_mesh(source) for source in sources]
        for command, chosen in (
                (commands.Triangulate, sources[:1]), (commands.Curve, sources[:1]), (commands.FemMesh, sources[:1]),
                (commands.FlowMesh, sources[:1]), (commands.Inspect, sources[:1]), (commands.Offset, sources[:1]),
                (commands.Boolean, meshes), (commands.Improve, meshes[:1]), (commands.Wrap, sources[:1])):
            with self.subTest(command.__name__):
                panel, area = self.opened(command, chosen)
                try:
                    self.check(panel, area)
                    gui_helpers.unfold(panel)
                    self.check(panel, area)
                finally:
                    panel.reject()

    def test_in_english(self):
        self.everywhere()

    def test_in_german_and_inches(self):
        FreeCADGui.setLocale("German")
        gui_helpers.use_units(gui_helpers.INCHES)
        self.everywhere()

    def test_in_a_dark_theme(self):
        sheet = next((path for path in SHEETS if path.exists()), None)
        if sheet is None:
            self.skipTest("this FreeCAD has no Dark-blue.qss")
        app = QtGui.QApplication.instance()
        self.addCleanup(app.setStyleSheet, app.styleSheet())
        app.setStyleSheet(sheet.read_text(encoding="utf-8"))
        FreeCADGui.setLocale("German")
        self.everywhere()

    def test_options_that_have_room_do_not_scroll(self):
        """A panel with few options is as high as these, and grows with what is opened as long as there is room."""
        panel, area = self.opened(commands.Triangulate, [self.box()])
        self.check(panel, area)
        panel.reject()
        panel, area = self.opened(commands.Offset, [self.box()])
        self.check(panel, area)
        self.assertEqual(panel.lowest.verticalScrollBar().maximum(), 0)

    def test_a_window_that_gets_lower_and_higher(self):
        panel, area = self.opened(commands.FlowMesh, [self.box()])
        heights = []
        for pixels in (_WINDOW[1], 660, 880):
            FreeCADGui.getMainWindow().resize(_WINDOW[0], pixels)
            gui_helpers.wait(0.2)
            self.check(panel, area)
            heights.append(panel.lowest.height())
        self.assertLess(heights[1], heights[0])
        self.assertLess(heights[0], heights[2])
