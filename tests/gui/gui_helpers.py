# SPDX-License-Identifier: LGPL-2.1-or-later
"""What GUI tests share: waiting for the event loop, and pictures of views."""

import os
import time
from unittest import mock

import FreeCAD
import FreeCADGui
import helpers
import numpy as np
from PySide import QtCore, QtGui

from MeshQuality.gui import commands, preferences
from MeshQuality.gui.panels import mesh_panel

PICTURES = os.environ.get("MESHQUALITY_GUI_PICTURES", ".")
WIDTH, HEIGHT = 700, 500
DARK = """QWidget { background-color: #2b2b2b; color: #dddddd }
QLineEdit, QAbstractSpinBox, QComboBox, QListWidget, QTableWidget { background-color: #3c3c3c }"""
LIMIT = 300  # seconds for what a test waits for, on a machine that does much else


MM, INCHES = 0, 3  # schemas of units
_UNITS = "User parameter:BaseApp/Preferences/Units"


def use_units(schema):
    """As the preferences set them."""
    FreeCAD.ParamGet(_UNITS).SetInt("UserSchema", schema)
    for document in FreeCAD.listDocuments().values():
        if hasattr(document, "UnitSystem"):  # since FreeCAD 1.0
            document.UnitSystem = schema
    FreeCAD.Units.setSchema(schema)


def typed(box, text):
    """Types into a field as a user does, and leaves it."""
    box.setFocus()
    box.selectAll()
    for key, letter in [(QtCore.Qt.Key_A, letter) for letter in text] + [(QtCore.Qt.Key_Tab, "")]:
        QtGui.QApplication.sendEvent(box, QtGui.QKeyEvent(QtCore.QEvent.KeyPress, key, QtCore.Qt.NoModifier, letter))
    wait()


def unfold(panel):
    """Opens all groups of options, as a user may."""
    for button in panel.options.folds.values():
        button.setChecked(True)
    wait()


def wait(seconds=0.05):
    """Lets the event loop run."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtGui.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 20)


def screen():
    """What the screen shows, as a picture; that of a widget has no 3D view."""
    return QtGui.QGuiApplication.primaryScreen().grabWindow(0).toImage()


def wait_until_still():
    """Lets the event loop run until the screen shows the same for half a second."""
    before, end = None, time.monotonic() + LIMIT
    while time.monotonic() < end:
        wait(0.5)
        now = screen()
        if now == before:
            return
        before = now
    raise AssertionError(f"the screen still changes after {LIMIT} s")


def pixels_of(image):
    """A picture as (height, width, 3) numbers."""
    image = image.convertToFormat(QtGui.QImage.Format_RGB888)
    rows = np.frombuffer(image.constBits(), dtype=np.uint8).reshape(image.height(), -1)
    return rows[:, :3 * image.width()].reshape(image.height(), image.width(), 3).astype(int)


class GuiTest(helpers.DocumentTest):
    """A test with a document that has a 3D view."""

    def setUp(self):
        super().setUp()
        wait()
        self.view = FreeCADGui.getDocument(self.document.Name).activeView()

    def as_at_first(self):
        """Hides what a new FreeCAD does not show below the tasks."""
        for name in ("Report view", "Python console"):
            dock = FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, name)
            if dock is not None:
                self.addCleanup(dock.setVisible, dock.isVisible())
                dock.hide()
        wait(0.2)

    def until(self, condition):
        """Lets the event loop run until a condition holds."""
        end = time.monotonic() + LIMIT
        while not condition() and time.monotonic() < end:
            wait(0.02)
        self.assertTrue(condition())

    def picture(self, name, folder=PICTURES):
        """Saves what the 3D view shows as <name>.png; returns it as (height, width, 3) numbers."""
        self.view.viewAxonometric()
        self.view.fitAll()
        wait()
        return self.saved(name, folder)

    def saved(self, name, folder=PICTURES, background="White"):
        """The same, from where the camera is."""
        path = os.path.join(folder, f"{name}.png")
        self.view.saveImage(path, WIDTH, HEIGHT, background)
        image = QtGui.QImage(path)
        self.assertEqual((image.width(), image.height()), (WIDTH, HEIGHT))
        return pixels_of(image)


class PanelTest(GuiTest):
    """A test that opens task panels."""

    def setUp(self):
        super().setUp()
        preferences.stored().Clear()
        FreeCADGui.activateWorkbench("MeshQualityWorkbench")
        FreeCADGui.Selection.clearSelection()

    def tearDown(self):
        FreeCADGui.Control.closeDialog()
        super().tearDown()

    def select(self, *objects):
        FreeCADGui.Selection.clearSelection()
        for obj in objects:
            FreeCADGui.Selection.addSelection(obj)

    def panel(self, command, *objects):
        """The panel that the command opens for these objects."""
        self.select(*objects)
        self.assertTrue(command().IsActive())
        panel = mesh_panel.MeshPanel(command().operations(command().selected()))
        FreeCADGui.Control.showDialog(panel)
        wait()
        return panel

    def edit(self, obj):
        """The panel that a double click opens."""
        made, real = [], mesh_panel.MeshPanel

        def noted(*arguments, **values):
            made.append(real(*arguments, **values))
            return made[-1]

        with mock.patch.object(commands, "MeshPanel", noted):
            self.assertTrue(obj.ViewObject.Proxy.doubleClicked(obj.ViewObject))
        wait()
        self.assertTrue(FreeCADGui.Control.activeDialog())
        return made[0]

    def finish(self, panel):
        """OK, and waits until the work has ended."""
        panel.accept()
        self.until(lambda: not panel.jobs)

    def apply(self, panel):
        """Apply, and waits until the work has ended."""
        panel.button.click()
        self.until(lambda: not panel.jobs)

    def narrow(self, panel, name):
        """Checks that the panel fits into FreeCAD's task view as wide as that is at first, and takes a
        picture of it.
        """
        dock, outer = panel.form, panel.form.parentWidget()
        while not isinstance(outer, QtGui.QMainWindow):
            dock, outer = outer, outer.parentWidget()
        if isinstance(dock, QtGui.QDockWidget):
            FreeCADGui.getMainWindow().resizeDocks([dock], [264], QtCore.Qt.Horizontal)
        else:  # FreeCAD 1.1 lays it over the view, and sizes it again and again
            self.addCleanup(dock.setMaximumWidth, dock.maximumWidth())
            dock.setMaximumWidth(264)
        wait()
        if not hasattr(panel, "lowest"):  # which has a scroll bar of its own
            panel.form.setMinimumHeight(panel.form.sizeHint().height())
        wait()
        area = panel.form.parentWidget()
        while not isinstance(area, QtGui.QScrollArea):
            area = area.parentWidget()
        right = panel.form.mapTo(area.viewport(), QtCore.QPoint(panel.form.width(), 0)).x()
        self.assertLess(dock.width(), 290)
        self.assertLessEqual(right, area.viewport().width())
        if hasattr(panel, "lowest"):
            self.until(lambda: panel.fields.width() <= panel.lowest.viewport().width())
        panel.form.grab().save(os.path.join(PICTURES, f"{name}.png"))
        panel.form.setMinimumHeight(0)

    def two_boxes(self):
        first, second = self.box(), self.document.addObject("Part::Box", "Second")
        second.Placement.Base = FreeCAD.Vector(4, 4, 4)
        self.document.recompute()
        return first, second
