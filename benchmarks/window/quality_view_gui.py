# SPDX-License-Identifier: LGPL-2.1-or-later
"""What quality_view.py has FreeCAD execute."""

import os
import statistics
import time
import traceback
from unittest import mock

import FreeCAD
import FreeCADGui
import numpy as np
from pivy import coin
from PySide import QtCore, QtGui

START = 500  # ms until the window has been drawn
FRAMES, TURN = 9, 0.05  # radians between two


def wait(seconds=0.02):
    """Lets the event loop run."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtGui.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 5)


def torus(triangles):
    """(vertices, triangles) of an even torus."""
    across = round((triangles / 5) ** 0.5)
    along = round(triangles / 2 / across)
    u, v = np.meshgrid(2 * np.pi * np.arange(along) / along, 2 * np.pi * np.arange(across) / across,
                       indexing="ij")
    radius = 20 + 8 * np.cos(v)
    points = np.stack((radius * np.cos(u), radius * np.sin(u), 8 * np.sin(v)), axis=-1)
    i, k = np.meshgrid(np.arange(along), np.arange(across), indexing="ij")
    a, b, c, d = (((i + m) % along * across + (k + n) % across).ravel()
                  for m, n in ((0, 0), (1, 0), (1, 1), (0, 1)))
    return points.reshape(-1, 3), np.concatenate((np.stack((a, b, c), 1), np.stack((a, c, d), 1)))


class Frames:
    """Turns the camera of a view and takes the time until the window shows it."""

    def __init__(self, view):
        self._camera, self._drawn = view.getCameraNode(), 0
        view.graphicsView().viewport().frameSwapped.connect(self._swapped)

    def _swapped(self):
        self._drawn += 1

    def median(self):
        """Seconds; two frames before are not counted, in which what is kept is made."""
        turn = coin.SbRotation(coin.SbVec3f(0, 0, 1), TURN)
        times = []
        for _ in range(FRAMES + 2):
            wait()
            before, begun = self._drawn, time.perf_counter()
            self._camera.orientation.setValue(self._camera.orientation.getValue() * turn)
            while self._drawn == before:
                QtGui.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 5)
            times.append(time.perf_counter() - begun)
        return statistics.median(times[2:])


def measure(triangles):
    """(triangles, seconds to open, FreeCAD's frame, all triangles, moving)."""
    from MeshQuality.compat import extension
    from MeshQuality.core.sources import convert
    from MeshQuality.gui.panels import quality_panel
    from MeshQuality.gui.view import quality_scene

    document = FreeCAD.newDocument("View")
    wait(0.5)
    obj = document.addObject("Mesh::Feature", "Torus")
    obj.Mesh = convert.mesh_of_surface(
        convert.surface_of_arrays(extension(), *torus(triangles), measured=False))
    document.recompute()
    view = FreeCADGui.getDocument(document.Name).activeView()
    view.viewAxonometric()
    view.fitAll()
    wait(1.0)
    frames = Frames(view)
    own = frames.median()
    begun = time.perf_counter()
    panel = quality_panel.open_panel(obj)
    while panel.values is None:
        wait()
    opened = time.perf_counter() - begun
    panel.edges.setChecked(False)
    with mock.patch.object(quality_scene, "_SLOW", np.inf):
        full = frames.median()
    moving = frames.median()
    panel.reject()
    found = obj.Mesh.CountFacets, opened, own, full, moving
    FreeCAD.closeDocument(document.Name)
    return found


def report(stream):
    """Writes the table."""
    FreeCADGui.activateWorkbench("MeshQualityWorkbench")
    stream.write("| triangles | opened in | FreeCAD's view, a frame | quality view, all triangles | "
                 "moving | all : FreeCAD's |\n|---|---|---|---|---|---|\n")
    for triangles in os.environ["MESHQUALITY_VIEW_TRIANGLES"].split():
        count, opened, own, full, moving = measure(int(triangles))
        stream.write(f"| {count:,} | {opened:.1f} s | {own:.3f} s | {full:.3f} s | {moving:.3f} s | "
                     f"{full / own:.2f} |\n")


def main():
    with open(os.environ["MESHQUALITY_RESULT"], "w", encoding="utf-8") as stream:
        try:
            report(stream)
        except Exception:  # noqa: BLE001 - what goes wrong must reach the result, not a report view
            stream.write(traceback.format_exc())
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)
    FreeCADGui.getMainWindow().close()


QtCore.QTimer.singleShot(START, main)
