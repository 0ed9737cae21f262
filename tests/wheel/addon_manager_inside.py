# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clicks of addon_manager.py inside FreeCAD: the Addon Manager installs, FreeCAD restarts, a part is meshed.

A step waits until what is to be clicked is in sight. Clicks are events of the mouse as Qt has them from the screen, each half a second after that.
"""

import json
import os
import subprocess
import sys
import time
import traceback

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

FOLDER = os.environ["ADDON_MANAGER"]
STATE, DONE = os.path.join(FOLDER, "state.json"), os.path.join(FOLDER, "done.json")
LIMIT = 120  # seconds for one step
LOOK = 0.5  # seconds for which a user at least sees what to click; until then it may still be drawn
COLOURS = 3  # seconds, which do not count, until a mesh is seen in its colours
APPLICATION = QtGui.QApplication


def mouse(widget, place, kind):
    event = QtGui.QMouseEvent(kind, QtCore.QPointF(place), QtCore.QPointF(widget.mapToGlobal(place)), QtCore.Qt.LeftButton,
                              QtCore.Qt.LeftButton if kind == QtCore.QEvent.MouseButtonPress else QtCore.Qt.NoButton,
                              QtCore.Qt.NoModifier)
    APPLICATION.sendEvent(widget, event)


def click(widget, place=None):
    place = place or widget.rect().center()
    mouse(widget, place, QtCore.QEvent.MouseButtonPress)
    mouse(widget, place, QtCore.QEvent.MouseButtonRelease)


def in_sight(kind, fits):
    """The first widget of a kind that can be clicked and fits."""
    for widget in APPLICATION.allWidgets():
        if isinstance(widget, kind) and widget.isVisible() and widget.isEnabled() and fits(widget):
            return widget
    return None


def plain(text):
    return text.replace("&", "")


def button(*texts, within=None):
    """Clicks a button with one of these texts, in whatever case, in a window with one of these titles."""
    def find():
        return in_sight(QtGui.QAbstractButton,
                        lambda one: plain(one.text()).lower() in map(str.lower, texts) and one.window().windowTitle() in (within or [one.window().windowTitle()]))

    return find, click


def tool(text):
    """Clicks the button of a command in a toolbar."""
    def find():
        return in_sight(QtGui.QToolButton, lambda one: one.defaultAction() and plain(one.defaultAction().text()) == text)

    return find, click


def menu(text):
    def find():
        bar = FreeCADGui.getMainWindow().menuBar()
        return next(((bar, action) for action in bar.actions() if plain(action.text()) == text and action.isVisible()), None)

    return find, lambda found: click(found[0], found[0].actionGeometry(found[1]).center())


def entry(text):
    """Clicks an entry of the menu that is open."""
    def find():
        for shown in (widget for widget in APPLICATION.allWidgets() if isinstance(widget, QtGui.QMenu) and widget.isVisible()):
            for action in shown.actions():
                if plain(action.text()).lower() == text.lower():
                    return shown, action
        return None

    return find, lambda found: click(found[0], found[0].actionGeometry(found[1]).center())


def chosen(text):
    """Clicks an entry of the workbench box that is open."""
    def find():
        view = in_sight(QtGui.QAbstractItemView, lambda one: one.window().inherits("QComboBoxPrivateContainer"))
        found = view and view.model().match(view.model().index(0, 0), QtCore.Qt.DisplayRole, text, 1, QtCore.Qt.MatchExactly)
        return (view, found[0]) if found else None

    def act(found):
        view, index = found
        view.scrollTo(index)
        view.setCurrentIndex(index)  # as the mouse over it does
        click(view.viewport(), view.visualRect(index).center())

    return find, act


def workbench_box():
    return lambda: in_sight(QtGui.QComboBox, lambda one: one.findText("Mesh Quality") >= 0), click


def addon(name):
    """Clicks the row of an addon in the manager's list."""
    def find():
        view = in_sight(QtGui.QAbstractItemView, lambda one: one.objectName() == "listPackages")
        model = view and view.model()
        for i in range(model.rowCount() if model else 0):
            known = model.data(model.index(i, 0), QtCore.Qt.UserRole)
            if getattr(known, "name", "") == name and known.metadata:  # which comes later than the name
                return view, model.index(i, 0)
        return None

    return find, lambda found: click(found[0].viewport(), found[0].visualRect(found[1]).center())


def mesh():
    """The mesh that has been made, once its panel is there."""
    document = FreeCAD.ActiveDocument
    found = [obj for obj in document.Objects if getattr(obj, "Certificate", "")] if document else []
    return found[0] if found and FreeCADGui.Control.activeDialog() else None


def unpack_wheel():
    """Types a line in a terminal, in the folder of the wheels: the binary goes into the addon's folder."""
    def type_line(_):
        wheel, = (os.path.join(FOLDER, "wheels", name) for name in os.listdir(os.path.join(FOLDER, "wheels"))
                  if "cp%d%d-" % sys.version_info[:2] in name)
        subprocess.run(["python3", "-m", "zipfile", "-e", wheel, os.path.join(FreeCAD.getUserAppDataDir(), "Mod", "MeshQuality")], check=True)

    return lambda: True, type_line


# What is said, how it is found and clicked, and the name of the picture before the click, if any.
REFUSED = os.environ.get("ADDON_MANAGER_REFUSED")
INSTALLING = [
    ("menu Tools", menu("Tools"), ""),
    ("Addon manager", entry("addon manager"), ""),
    ("first use of the Addon Manager: OK or Continue", button("OK", "Continue"), "first-use"),
    ("MeshQuality in the list", addon("MeshQuality"), "list"),
    ("Install", button("Install"), "addon"),
    ("the Python package: OK" if REFUSED else "the Python package: Yes", button("OK" if REFUSED else "Yes"), "package"),
    ("what tells of success: Close or OK", button("Close", "OK", within=["Installation succeeded", "Success"]), "installed"),
    ("the Addon Manager: Close", button("Close"), "pending"),
    *([("line typed: python3 -m zipfile -e meshquality_core-*.whl .../Mod/MeshQuality", unpack_wheel(), "")] if REFUSED else []),
    ("Restart now", button("Restart now"), "restart"),
]
MESHING = [
    ("list of workbenches", workbench_box(), "started"),
    ("Mesh Quality", chosen("Mesh Quality"), ""),
    ("menu Mesh Quality", menu("Mesh Quality"), ""),
    ("Help", entry("Help"), ""),
    ("Examples", entry("Examples"), ""),
    ("Quick mesh", tool("Quick mesh"), "part"),
]


class Session:
    """Clicks one step after another; what it knows is in a file, as FreeCAD is started again in between."""

    def __init__(self):
        self.state = {"session": 0, "begin": time.time(), "steps": []}
        if os.path.exists(STATE):
            with open(STATE, encoding="utf-8") as stream:
                self.state = json.load(stream)
        self.state["session"] += 1
        self.steps = INSTALLING if self.state["session"] == 1 else MESHING
        self.at, self.since, self.seen = 0, time.time(), None
        self.save()

    def save(self):
        with open(STATE, "w", encoding="utf-8") as stream:
            json.dump(self.state, stream)

    def picture(self, name):
        """Of the largest dialog, with what is before it, or else of all."""
        shown = [one.geometry() for one in APPLICATION.topLevelWidgets() if isinstance(one, QtGui.QDialog) and one.isVisible()]
        shown.sort(key=lambda place: place.width() * place.height())
        seen = QtGui.QGuiApplication.primaryScreen().grabWindow(0)
        (seen.copy(shown[-1]) if shown else seen).save(os.path.join(FOLDER, f"{len(self.state['steps']):02d}-{name}.png"))

    def tick(self):
        QtCore.QTimer.singleShot(100, self.tick)  # before all else: a click may open a dialog and end with it
        try:
            if self.at == len(self.steps):
                self.end()
            else:
                self.step()
        except Exception:  # noqa: BLE001 - what goes wrong must reach the result
            self.done(traceback.format_exc(), False)

    def step(self):
        what, (find, act), name = self.steps[self.at]
        found = find()
        if not found:
            self.seen = None
            if time.time() - self.since > LIMIT:
                self.picture("missing")
                self.done(f"no {what} within {LIMIT} s", False)
            return
        self.seen = self.seen or time.time()
        if time.time() - self.seen < LOOK:
            return
        waited = self.seen - self.since
        if name:
            self.picture(name)
        self.state["steps"].append({"session": self.state["session"], "what": what, "waited": waited})
        self.save()
        self.at, self.since, self.seen = self.at + 1, time.time(), None
        act(found)

    def end(self):
        if self.state["session"] == 1:
            return  # FreeCAD ends now
        obj = mesh()
        if obj is None:
            if time.time() - self.since > LIMIT:
                self.picture("missing")
                self.done(f"no mesh within {LIMIT} s", False)
            return
        self.seen = self.seen or time.time()
        if time.time() - self.seen > COLOURS:
            self.picture("mesh")
            binary = sys.modules["MeshQuality._core"].__file__
            self.done(f"{obj.Mesh.CountFacets} triangles, certificate: {obj.Certificate}, by {binary}",
                      obj.Certificate.startswith("met") and binary.startswith(FreeCAD.getUserAppDataDir()))

    def done(self, result, met):
        with open(DONE, "w", encoding="utf-8") as stream:
            json.dump({"steps": self.state["steps"], "seconds": (self.seen or time.time()) - self.state["begin"], "result": result, "met": met,
                       "freecad": ".".join(FreeCAD.Version()[:3]), "folder": FreeCAD.getUserAppDataDir()}, stream)
        sys.stdout.flush()
        os._exit(0)


session = Session()
QtCore.QTimer.singleShot(500, session.tick)
