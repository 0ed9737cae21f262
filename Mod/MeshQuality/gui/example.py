# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part to try the commands on: a pipe tee."""

import FreeCAD
import Part

_OUTER, _INNER, _LENGTH, _BRANCH = 15.0, 12.0, 120.0, 60.0  # mm; radii and lengths


def tee():
    """The shape of the tee: a pipe along x with a branch upwards, centred on the origin."""
    across, up = FreeCAD.Vector(1, 0, 0), FreeCAD.Vector(0, 0, 1)
    start, middle = FreeCAD.Vector(-_LENGTH / 2, 0, 0), FreeCAD.Vector()
    full, bore = (Part.makeCylinder(radius, _LENGTH, start, across).fuse(Part.makeCylinder(radius, _BRANCH, middle, up))
                  for radius in (_OUTER, _INNER))
    return full.cut(bore).removeSplitter()


def open_document():
    """Opens a new document with the tee, in the window selected and in full view; returns the object."""
    document = FreeCAD.newDocument("Tee")
    part = document.addObject("Part::Feature", "Tee")
    part.Shape = tee()
    document.recompute()
    if FreeCAD.GuiUp:
        import FreeCADGui

        view = FreeCADGui.getDocument(document.Name).activeView()
        view.viewAxonometric()
        view.fitAll()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(part)
    return part
