# SPDX-License-Identifier: LGPL-2.1-or-later
"""What event_loop.py has FreeCAD execute."""

import os
import time
import traceback

import FreeCAD
import FreeCADGui
import Part
from PySide import QtCore, QtGui

START = 500  # ms until the window has been drawn
TICK = 5  # ms
QUIET = 3.0  # s of watching after the result has come


class Gaps:
    """Notes the gaps between the ticks of a timer."""

    def __init__(self):
        self.ticks = []  # (seconds, what went on)
        self.phase = "idle"
        self._timer = QtCore.QTimer()
        self._timer.setTimerType(QtCore.Qt.PreciseTimer)
        self._timer.timeout.connect(lambda: self.ticks.append((time.perf_counter(), self.phase)))
        self._timer.start(TICK)

    def end(self):
        """The gaps in ms, longest first, as (gap, phase)."""
        self._timer.stop()
        found = [(1000 * (after[0] - before[0]), before[1])
                 for before, after in zip(self.ticks, self.ticks[1:])]
        return sorted(found, reverse=True)


def cases(document, triangles):
    """(title, command, sources, values) of what is measured."""
    from MeshQuality.gui import commands

    torus = document.addObject("Part::Feature", "Torus")
    torus.Shape = Part.makeTorus(20, 8)
    box = document.addObject("Part::Feature", "Block")
    box.Shape = Part.makeBox(40, 40, 10).cut(Part.makeCylinder(12, 10, FreeCAD.Vector(20, 20, 0)))
    ball = document.addObject("Part::Feature", "Ball")
    ball.Shape = Part.makeSphere(15, FreeCAD.Vector(15, 15, 15))
    area = torus.Shape.Area
    edge = (area / triangles * 4 / 3**0.5) ** 0.5 * 1.45
    return [
        ("quality mesh, one face", commands.Triangulate, [torus], {"max_edge": edge}),
        ("quality mesh, 8 faces", commands.Triangulate, [box],
         {"max_edge": edge * (box.Shape.Area / area) ** 0.5}),
        ("curved mesh", commands.Curve, [torus], {"max_edge": 8 * edge}),
        ("Boolean", commands.Boolean, [box, ball], {"tolerance": 0.0004}),
    ]


def measure(command, sources, values):
    """(gaps, panel, object) of one operation from OK to the drawn result."""
    from MeshQuality.gui import mesh_panel

    FreeCADGui.Selection.clearSelection()
    for source in sources:
        FreeCADGui.Selection.addSelection(source)
    FreeCADGui.Selection.clearSelection()
    panel = mesh_panel.MeshPanel(command().operations(sources))
    FreeCADGui.Control.showDialog(panel)
    panel.options.set_values({"chord_height_relative": None, **values})
    wait(0.3)
    gaps = Gaps()
    wait(0.5)
    panel._end_trial()
    gaps.phase = "start"
    panel.accept()
    for made in panel.jobs:
        take = made.take
        made.take = lambda result, take=take: (setattr(gaps, "phase", "landing"), take(result))
    wait(0.1)
    gaps.phase = "working"
    while panel.jobs:
        wait(0.02)
    gaps.phase = "drawing"
    wait(QUIET)
    return gaps.end(), panel, panel.operations[0].obj


def wait(seconds):
    """Lets the event loop run."""
    loop = QtCore.QEventLoop()
    QtCore.QTimer.singleShot(int(1000 * seconds), loop.quit)
    loop.exec_() if hasattr(loop, "exec_") else loop.exec()


def main():
    triangles = int(os.environ["MESHQUALITY_LOOP_TRIANGLES"])
    with open(os.environ["MESHQUALITY_LOOP_RESULT"], "w", encoding="utf-8") as stream:
        try:
            FreeCADGui.activateWorkbench("MeshQualityWorkbench")
            document = FreeCAD.newDocument("Loop")
            document.UndoMode = 1
            wait(1.0)
            for title, command, sources, values in cases(document, triangles):
                gaps, panel, obj = measure(command, sources, values)
                if obj is None:
                    stream.write(f"{title}: failed: {panel.said}\n")
                    continue
                worst = {}
                for gap, phase in gaps:
                    worst.setdefault(phase, gap)
                text = ", ".join(f"{phase} {worst[phase]:.0f} ms" for phase in (
                    "idle", "start", "working", "landing", "drawing") if phase in worst)
                stream.write(f"{title}, {obj.Mesh.CountFacets} triangles shown: longest gap "
                             f"{text}\n")
                stream.flush()
                obj.ViewObject.Visibility = False
        except Exception:  # noqa: BLE001 - what goes wrong must reach the result, not a report view
            stream.write(traceback.format_exc())
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)
    FreeCADGui.getMainWindow().close()
    QtGui.QApplication.quit()


QtCore.QTimer.singleShot(START, main)
