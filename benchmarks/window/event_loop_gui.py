# SPDX-License-Identifier: LGPL-2.1-or-later
"""What event_loop.py has FreeCAD execute."""

import json
import os
import time
import traceback
from functools import partial

import FreeCAD
import FreeCADGui
import Part
from PySide import QtCore

START = 500  # ms until the window has been drawn
TICK = 5  # ms
LANDING, DRAWING = "landing", "landing and first drawing"
QUIET = 3.0  # s of watching after the result has come


class Gaps:
    """Notes the gaps between the ticks of a timer, and what went on in them."""

    def __init__(self):
        self._ticks, self._marks = [], []
        self.mark("idle")
        self._timer = QtCore.QTimer()
        self._timer.setTimerType(QtCore.Qt.PreciseTimer)
        self._timer.timeout.connect(lambda: self._ticks.append(time.perf_counter()))
        self._timer.start(TICK)

    def mark(self, phase):
        """A phase begins."""
        self._marks.append((time.perf_counter(), phase))

    def end(self):
        """{phase: the longest gap in ms}; a gap belongs to the phase that it has most of. The phase of
        LANDING is that itself, without what the window does next.
        """
        self._timer.stop()
        ends = [time for time, _ in self._marks[1:]] + [self._ticks[-1]]
        longest = {phase: 0.0 for _, phase in self._marks}
        for before, after in zip(self._ticks, self._ticks[1:]):
            parts = [(min(after, end) - max(before, start), phase)
                     for (start, phase), end in zip(self._marks, ends)]
            phase = max(part for part in parts if not part[1].endswith(LANDING))[1]
            longest[phase] = max(longest[phase], 1000 * (after - before))
        for (start, phase), end in zip(self._marks, ends):
            if phase.endswith(LANDING):
                longest[phase] = 1000 * (end - start)
        return longest


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
        ("curved mesh", commands.Curve, [torus], {"max_edge": 2.2 * edge}),
        ("Boolean", commands.Boolean, [box, ball], {"tolerance": 0.0004}),
    ]


def measure(command, sources, values):
    """(gaps, panel, object) of one operation from OK to the drawn result."""
    from MeshQuality.gui.panels import mesh_panel

    panel = mesh_panel.MeshPanel(command().operations(sources))
    FreeCADGui.Control.showDialog(panel)
    panel.options.set_values({"chord_height": "none", **values})
    wait(0.3)
    panel._end_trial()
    wait(0.2)
    gaps = Gaps()
    wait(1.0)
    gaps.mark("start")
    panel.accept()
    for made in panel.jobs:
        made.take = partial(landing, gaps, made.take)
    wait(0.1)
    gaps.mark("work")
    while panel.jobs:
        wait(0.02)
    wait(QUIET)
    return gaps.end(), panel, panel.operations[0].obj


def landing(gaps, take, result):
    """Takes the result, and notes when."""
    gaps.mark(LANDING)
    take(result)
    gaps.mark(DRAWING)


def measure_freecad(document, mesh):
    """Gaps of FreeCAD alone: a copy of the mesh is given to an object, and drawn."""
    gaps = Gaps()
    wait(0.5)
    obj = document.addObject("Mesh::Feature", "Alone")
    copy = mesh.copy()
    wait(0.5)

    def assign():
        gaps.mark(f"FreeCAD alone: {LANDING}")
        obj.Mesh = copy
        gaps.mark(f"FreeCAD alone: {DRAWING}")

    QtCore.QTimer.singleShot(0, assign)
    wait(QUIET)
    found = gaps.end()
    obj.ViewObject.Visibility = False
    wait(1.0)
    del found["idle"]
    return found


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
                found, panel, obj = measure(command, sources, values)
                if obj is None:
                    raise RuntimeError(f"{title}: {panel.said}")
                obj.ViewObject.Visibility = False
                wait(1.0)
                found.update(measure_freecad(document, obj.Mesh))
                stream.write(json.dumps({
                    "title": f"{title}, {obj.Mesh.CountFacets} triangles shown", "gaps": found}))
                stream.write("\n")
                stream.flush()
        except Exception:  # noqa: BLE001 - what goes wrong must reach the result, not a report view
            stream.write(json.dumps({"title": traceback.format_exc(), "gaps": {}}) + "\n")
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)
    FreeCADGui.getMainWindow().close()


QtCore.QTimer.singleShot(START, main)
