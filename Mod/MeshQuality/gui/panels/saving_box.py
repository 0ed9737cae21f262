# SPDX-License-Identifier: LGPL-2.1-or-later
"""The buttons of the quality view that save what it shows."""

import FreeCAD
from PySide import QtCore, QtGui

from .. import saving
from .task_form import narrow

translate = FreeCAD.Qt.translate


class SavingBox(QtGui.QWidget):
    """A button that saves the values of all elements as a table, and one for the report. What became of it is told by `told`: a text,
    and whether it is an error.

    source  the document object, or a link to one
    name    the name of the files that is suggested, without a folder
    work    work(path), called on another thread: writes the table
    """

    told = QtCore.Signal(str, bool)

    def __init__(self, source, name, work):
        super().__init__()
        self._source, self._name, self._work, self.job = source, name, work, None
        self.values = QtGui.QPushButton(translate("MeshQuality", "Save values..."))
        self.values.setToolTip(translate("MeshQuality", "Write all measures of each element into a table, as CSV"))
        self.values.clicked.connect(self._save_values)
        self.report = QtGui.QPushButton(translate("MeshQuality", "Save report..."))
        self.report.setToolTip(translate("MeshQuality", "Write a page with pictures, figures, faces and places, as HTML or PDF"))
        self.report.clicked.connect(self._save_report)
        narrow(self, "QPushButton { padding: 4px; margin: 2px 0px; min-width: 0px }")
        layout = QtGui.QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.values)
        layout.addWidget(self.report)
        layout.addStretch()

    def _save_values(self):
        title = translate("MeshQuality", "Save values")
        path = saving.asked_path(title, self._name, (".csv",), "CSV (*.csv)")
        if path:
            self.job = saving.start(title, path, lambda progress: self._work(path), self.told.emit)

    def _save_report(self):
        self.job = saving.save_report(self._source, self.told.emit)

    def end(self):
        """The panel closes: what is being written is written."""
        self.blockSignals(True)
