# SPDX-License-Identifier: LGPL-2.1-or-later
"""What first_mesh.py has FreeCAD execute."""

import os
import time
import traceback

import FreeCAD
import FreeCADGui
import Part
from PySide import QtCore, QtGui

START = 500  # ms until the window has been drawn
LIMIT = 60.0  # seconds


def until(condition):
    """Lets the event loop run until a condition holds; seconds that took, or TimeoutError."""
    begun = time.perf_counter()
    while not condition():
        if time.perf_counter() - begun > LIMIT:
            raise TimeoutError
        QtGui.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 5)
    return time.perf_counter() - begun


def progress_is_seen():
    """Whether a bar in the task panel shows how far the work is."""
    return any(bar.isVisible() and bar.text() for bar in
               FreeCADGui.getMainWindow().findChildren(QtGui.QProgressBar))


def colours_are_drawn():
    """Whether the quality view has drawn its triangles."""
    from MeshQuality.gui.panels import quality_panel

    panel = quality_panel.shown()
    return panel is not None and panel.values is not None \
        and panel.scene.scene.drawing_seconds > 0.0


def measure(path):
    """A line of the table."""
    FreeCADGui.activateWorkbench("MeshQualityWorkbench")
    document = FreeCAD.newDocument("Part")
    Part.insert(path, document.Name)
    source = document.Objects[0]
    document.recompute()
    FreeCADGui.getDocument(document.Name).activeView().fitAll()
    FreeCADGui.Selection.addSelection(source)
    until(lambda begun=time.perf_counter(): time.perf_counter() > begun + 1.0)
    begun = time.perf_counter()
    FreeCADGui.runCommand("MeshQuality_Quick")
    until(progress_is_seen)
    seen = time.perf_counter() - begun
    until(lambda: document.Objects[-1].isDerivedFrom("Mesh::Feature"))
    made = time.perf_counter() - begun
    until(colours_are_drawn)
    mesh, name = document.Objects[-1], os.path.basename(path)
    return (f"| {name} | {len(source.Shape.Faces)} | {seen:.2f} s | {made:.2f} s | "
            f"{mesh.Mesh.CountFacets:,} | {mesh.Certificate} | {time.perf_counter() - begun:.2f} s |\n")


def main():
    with open(os.environ["MESHQUALITY_RESULT"], "w", encoding="utf-8") as stream:
        try:
            stream.write(measure(os.environ["MESHQUALITY_PART"]))
        except Exception:  # noqa: BLE001 - what goes wrong must reach the result, not a report view
            stream.write(traceback.format_exc())
    FreeCADGui.Control.closeDialog()
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)
    FreeCADGui.getMainWindow().close()


QtCore.QTimer.singleShot(START, main)
