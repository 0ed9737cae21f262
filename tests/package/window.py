# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inside FreeCAD's window: the installed workbench is there, its commands work. Writes 'good' to window.txt."""

import os
import traceback

import FreeCAD
import FreeCADGui
from PySide import QtCore

START = 1000  # ms until the window has been drawn


def look():
    FreeCADGui.activateWorkbench("MeshQualityWorkbench")
    import MeshQuality
    from MeshQuality.gui import commands

    workbench = FreeCADGui.activeWorkbench()
    assert workbench.MenuText == "Mesh Quality", workbench.MenuText
    document = FreeCAD.newDocument("Window")
    document.addObject("Part::Box", "Box")
    document.recompute()
    FreeCADGui.Selection.addSelection(document.Box)
    assert "MeshQuality_Triangulate" in commands.fitting()
    feature = MeshQuality.add_quality_mesh(document.Box)
    assert feature.Mesh.CountFacets > 0
    FreeCADGui.activeDocument().activeView().saveImage("window.png", 400, 300, "White")
    assert os.path.getsize("window.png") > 0


def main():
    try:
        look()
        said = "good\n"
    except Exception:  # noqa: BLE001 - what goes wrong must reach the file, not a report view
        said = traceback.format_exc()
    with open("window.txt", "w", encoding="utf-8") as stream:
        stream.write(said)
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)
    FreeCADGui.getMainWindow().close()


QtCore.QTimer.singleShot(START, main)
