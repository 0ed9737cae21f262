# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mouse wheel over a panel scrolls it, and turns no value."""

import FreeCADGui
import gui_helpers
from PySide import QtCore, QtGui

import MeshQuality as mq
from MeshQuality.gui import commands
from MeshQuality.gui.panels import case_panel, export_panel, patches_panel, quality_panel

FIELDS = (QtGui.QAbstractSpinBox, QtGui.QComboBox, QtGui.QSlider)


def turn(widget, down=1):
    """Turns the wheel over the middle of a widget; what it ignores goes on to what is around it, as Qt does with events of
    the X server alone.
    """
    place = widget.rect().center()
    while widget is not None:
        event = QtGui.QWheelEvent(QtCore.QPointF(place), QtCore.QPointF(widget.mapToGlobal(place)), QtCore.QPoint(),
                                  QtCore.QPoint(0, -120 * down), QtCore.Qt.NoButton, QtCore.Qt.NoModifier,
                                  QtCore.Qt.NoScrollPhase, False)
        event.accept()
        taken = QtGui.QApplication.sendEvent(widget, event)
        if taken and event.isAccepted():
            break
        place, widget = widget.mapToParent(place), widget.parentWidget()
    gui_helpers.wait()


def shown(field):
    """What a field shows, and which choice that is."""
    return field.currentIndex() if isinstance(field, QtGui.QComboBox) else (field.value(), field.text())


class Wheel(gui_helpers.PanelTest):
    def fields(self, panel):
        """The fields that are in sight and may be edited."""
        found = [field for kind in FIELDS for field in panel.form.findChildren(kind) if field.isVisible() and field.isEnabled()]
        self.assertTrue(found)
        return found

    def assert_nothing_turns(self, panel):
        if QtGui.QApplication.focusWidget():
            QtGui.QApplication.focusWidget().clearFocus()
        for field in self.fields(panel):
            for down in (1, -1):
                before = shown(field)
                turn(field, down)
                self.assertEqual(shown(field), before, field.objectName())
                self.assertFalse(field.hasFocus())

    def test_no_field_of_any_panel_turns_without_the_focus(self):
        box, second = self.two_boxes()
        for command, sources in ((commands.Triangulate, [box]), (commands.Curve, [box]), (commands.FemMesh, [box]),
                                 (commands.Boolean, [box, second]), (commands.Hollow, [box]), (commands.Wrap, [box, second]),
                                 (commands.Inspect, [box])):
            panel = self.panel(command, *sources)
            gui_helpers.unfold(panel)
            gui_helpers.wait()
            self.assert_nothing_turns(panel)
            panel.reject()
            gui_helpers.wait()
        mesh = mq.add_quality_mesh(box)
        for made in (quality_panel.QualityPanel, export_panel.ExportPanel, case_panel.CasePanel, patches_panel.PatchesPanel):
            panel = made(mesh)
            FreeCADGui.Control.showDialog(panel)
            gui_helpers.wait()
            self.assert_nothing_turns(panel)
            panel.reject()
            gui_helpers.wait()

    def test_the_panel_scrolls_instead(self):
        panel = self.panel(commands.Triangulate, self.box())
        gui_helpers.unfold(panel)
        panel.fields.setMinimumHeight(3000)  # longer than any screen
        gui_helpers.wait()
        bar, angle = panel.lowest.verticalScrollBar(), panel.options.field("min_angle")
        self.until(lambda: bar.maximum() > 0)
        bar.setValue(0)
        turn(angle)
        self.until(lambda: bar.value() > 0)
        self.assertEqual(panel.options.values()["min_angle"], 25)

    def test_a_field_with_the_focus_turns(self):
        panel = self.panel(commands.Triangulate, self.box())
        angle = panel.options.field("min_angle")
        FreeCADGui.getMainWindow().activateWindow()
        angle.setFocus()
        self.until(angle.hasFocus)
        turn(angle, -1)
        self.assertGreater(panel.options.values()["min_angle"], 25)
