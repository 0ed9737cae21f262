# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents to try the commands on: a pipe tee, and a scan of it."""

import FreeCAD
import Mesh
import numpy as np
import Part

_OUTER, _INNER, _LENGTH, _BRANCH = 15.0, 12.0, 120.0, 60.0  # mm; radii and lengths
_EDGE, _BUMP, _WIDE = 3.0, 0.6, 12.0  # mm: of the scan's triangles, height and width of its bump
_HOLES = 5


def tee():
    """The shape of the tee: a pipe along x with a branch upwards, centred on the origin."""
    across, up = FreeCAD.Vector(1, 0, 0), FreeCAD.Vector(0, 0, 1)
    start, middle = FreeCAD.Vector(-_LENGTH / 2, 0, 0), FreeCAD.Vector()
    full, bore = (Part.makeCylinder(radius, _LENGTH, start, across).fuse(Part.makeCylinder(radius, _BRANCH, middle, up))
                  for radius in (_OUTER, _INNER))
    return full.cut(bore).removeSplitter()


def scan_of(shape):
    """A Mesh.Mesh as a scanner makes it of a shape: turned and shifted, with a bump, and with triangles missing."""
    from ..core.triangulation import triangulate  # needs the binary, which may be missing

    mesh = triangulate(shape, max_edge=_EDGE, chord_height=0.05)
    points = np.array(mesh.vertices + mesh.origin)
    top = np.array([_LENGTH / 4, 0.0, _OUTER])
    away = points - top
    lift = _BUMP * np.exp(-np.square(away).sum(axis=1) / (0.25 * _WIDE**2))
    points[:, 2] += lift * (points[:, 2] > 0.9 * _OUTER)
    holes = np.linspace(0, len(mesh.triangles) - 1, _HOLES + 2).astype(int)[1:-1]
    left = np.delete(np.array(mesh.triangles), holes, axis=0)
    found = Mesh.Mesh(points[left].tolist())
    found.rotate(0.02, 0.01, 0.03)
    found.translate(1.5, -1.0, 0.8)
    return found


def _shown(document, selected):
    """Selects an object and shows all of its document, where there is a window."""
    document.recompute()
    if FreeCAD.GuiUp:
        import FreeCADGui

        view = FreeCADGui.getDocument(document.Name).activeView()
        view.viewAxonometric()
        view.fitAll()
        FreeCADGui.Selection.clearSelection()
        for obj in selected:
            FreeCADGui.Selection.addSelection(obj)


def open_documents():
    """Opens a new document with the tee and its scan, both selected as *Deviation* takes them, where the binary is there that makes it; then
    one with the tee alone, selected. Returns the tee of the latter.
    """
    from ..compat import why_no_extension

    if not why_no_extension():
        document = FreeCAD.newDocument("Scan")
        scan, part = document.addObject("Mesh::Feature", "Scan"), document.addObject("Part::Feature", "Tee")
        part.Shape = tee()
        scan.Mesh = scan_of(part.Shape)
        _shown(document, (scan, part))
    document = FreeCAD.newDocument("Tee")
    part = document.addObject("Part::Feature", "Tee")
    part.Shape = tee()
    _shown(document, (part,))
    return part
