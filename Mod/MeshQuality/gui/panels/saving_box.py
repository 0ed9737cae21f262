# SPDX-License-Identifier: LGPL-2.1-or-later
"""The buttons of the quality view that save what it shows."""

import os

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from .. import jobs
from ..translation import translated

translate = FreeCAD.Qt.translate


class SavingBox(QtGui.QWidget):
    """A button that saves the values of all elements as a table. What became of it is told by `told`: a text, and whether it is an
    error.

    work  work(path, progress), called on another thread: writes the table
    name  called for the name of the file that is suggested, without a folder
    """

    told = QtCore.Signal(str, bool)

    def __init__(self, work, name):
        super().__init__()
        self._work, self._name, self.job = work, name, None
        self.values = QtGui.QPushButton(translate("MeshQuality", "Save values..."))
        self.values.setToolTip(translate("MeshQuality", "Write all measures of each element into a table, as CSV"))
        self.values.clicked.connect(self._save_values)
        layout = QtGui.QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.values)
        layout.addStretch()

    def _save_values(self):
        path = self._asked_for(translate("MeshQuality", "Save values"), ".csv", "CSV (*.csv)")
        if path:
            self._start(translate("MeshQuality", "Save values"), path, lambda progress: self._work(path, progress))

    def _asked_for(self, title, suffix, kinds):
        """The path that the user gives, with the extension; empty: none."""
        path = QtGui.QFileDialog.getSaveFileName(FreeCADGui.getMainWindow(), title, self._name() + suffix, kinds)[0]
        return path if not path or path.lower().endswith(suffix) else path + suffix

    def _start(self, title, path, work):
        self.job = jobs.queue().add(jobs.Job(title, work, lambda _: self._say(
            translate("MeshQuality", "Saved: {0}").format(os.path.basename(path)))))
        job = self.job
        job.ended.connect(lambda: job.error and self._say(translated(job.error), True))

    def _say(self, text, error=False):
        self.told.emit(text, error)

    def end(self):
        """The panel closes: what is being written is written."""
        self.blockSignals(True)
