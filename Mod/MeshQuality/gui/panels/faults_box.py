# SPDX-License-Identifier: LGPL-2.1-or-later
"""The box of a panel on the faults of a mesh: how many of each kind, and where."""

import FreeCAD
import numpy as np
from PySide import QtCore, QtGui

from .. import jobs
from ..translation import translated
from .task_form import is_in_task_view

translate = FreeCAD.Qt.translate

_ROWS = 4  # rows in sight without scrolling
AROUND = 10.0  # width of the view around a fault, in sizes of its triangles


class FaultsBox(QtGui.QWidget):
    """Searches for faults in the background when `begin` is called.

    picked  signal (all, one): int arrays of the triangles with faults of the kind that was chosen, and of those at the
            fault that is to be looked at; two empty ones where none is chosen any more
    searched  signal (found), once they are known
    found   [core.faults.Faults, ...]; None before they are known
    """

    picked = QtCore.Signal(object, object)
    searched = QtCore.Signal(list)

    def __init__(self):
        super().__init__()
        self.found, self._job, self._place = None, None, 0
        self.text, self.list = QtGui.QLabel(), QtGui.QListWidget()
        self.text.setWordWrap(True)
        self.list.setWordWrap(True)
        self.list.setAlternatingRowColors(True)
        self.list.setMinimumHeight(_ROWS * self.list.fontMetrics().lineSpacing() + 8)
        self.next = QtGui.QPushButton(translate("MeshQuality", "Show next"))
        self.next.setToolTip(translate("MeshQuality", "Moves the camera to the next fault of the kind that is marked"))
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        for widget in (self.text, self.list, self.next):
            layout.addWidget(widget)
        self.list.hide()
        self.next.hide()
        self.list.currentRowChanged.connect(self._choose)
        self.list.itemClicked.connect(lambda _: self._choose(self.list.currentRow()))
        self.next.clicked.connect(self.show_next)

    def begin(self, find):
        """Calls find(progress) -> [Faults, ...] on another thread, and shows what it gives."""
        self.text.setText(translate("MeshQuality", "Searching for faults ..."))
        self._job = jobs.queue().add(jobs.Job(translate("MeshQuality", "Searching for faults"), find, self._take, quiet=True))
        job = self._job
        job.changed.connect(lambda: job.time and is_in_task_view(self) and self.text.setText(
            "\n".join((translate("MeshQuality", "Searching for faults ..."), job.time))))
        job.ended.connect(lambda: job.state == jobs.FAILED and is_in_task_view(self) and self.text.setText(translated(job.error)))

    def end(self):
        """The panel closes."""
        if self._job is not None and self._job.active:
            self._job.cancel()

    def _take(self, found):
        self.found = found
        self.text.setText(translate("MeshQuality", "Faults; click to show where:") if found
                          else translate("MeshQuality", "The mesh has no faults."))
        for faults in found:
            self.list.addItem(translated(faults.words()))
        self.list.setVisible(bool(found))
        self.searched.emit(found)

    def _choose(self, row):
        self._place = 0
        self.next.setVisible(row >= 0 and len(self.found[row].triangles) > 1)
        self._show(row)

    def show_next(self):
        """Shows the next fault of the same kind."""
        row = self.list.currentRow()
        self._place = (self._place + 1) % len(self.found[row].triangles)
        self._show(row)

    def _show(self, row):
        if row < 0:
            self.picked.emit(np.zeros(0, int), np.zeros(0, int))
            return
        triangles = self.found[row].triangles
        one = triangles[self._place]
        self.picked.emit(np.unique(triangles[triangles >= 0]), one[one >= 0])
