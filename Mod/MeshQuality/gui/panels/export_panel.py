# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that writes a curved mesh into a file, in the background."""

import os

import FreeCAD
import FreeCADGui
from PySide import QtGui

from ...core import export, frames
from ...core.curving import taken_from
from ...errors import Error
from .. import background, jobs, preferences
from ..panel_operation import is_there, name_of
from ..translation import translated
from ..view import badge
from .mesh_panel import title_of
from .task_form import ClosesWithDocument, Message, is_in_task_view

translate = FreeCAD.Qt.translate


class ExportPanel:
    """A panel for FreeCADGui.Control.showDialog: OK writes, then closes; what goes wrong is said in
    the panel.

    source  a document object of add_curved_mesh, or a link to one, see frames
    """

    def __init__(self, source):
        self.source, self.obj = source, frames.object_of(source)
        self._document, self._label = self.obj.Document.Name, frames.leaf_of(source).Label
        self.job, self.said = None, ""
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(title_of("MeshQuality_Export", "Export curved mesh"))
        self.form.setWindowIcon(QtGui.QIcon(badge.path_of("MeshQuality_Export")))
        self._document_watch = ClosesWithDocument(self._document, self.form, self._close)
        of = QtGui.QLabel(translate("MeshQuality", "Mesh: {}, curved elements of order {}").format(
            self._label, frames.linked_of(source)[0].ElementsOrder))
        self.formats = QtGui.QComboBox()
        for extension, title in export.CURVED_FORMATS.items():
            self.formats.addItem(f"{title} (*{extension})", extension)
        self.path = FreeCADGui.UiLoader().createWidget("Gui::FileChooser")
        self.path.setProperty("acceptMode", 1)  # a file to save
        self.path.setProperty("filter", ";;".join(
            f"{title} (*{extension})" for extension, title in export.CURVED_FORMATS.items()))
        self.path.setProperty("fileName", self._first_path())
        self.path.setToolTip(translate("MeshQuality", "Without an extension, that of the format is added"))
        self.message, self.bar = Message(), QtGui.QProgressBar()
        self.bar.setRange(0, 0)
        self.bar.hide()
        layout = QtGui.QVBoxLayout(self.form)
        layout.setContentsMargins(0, 0, 0, 0)
        of.setWordWrap(True)
        for widget in (of, self.message, self.bar, QtGui.QLabel(translate("MeshQuality", "Format")), self.formats,
                       QtGui.QLabel(translate("MeshQuality", "File")), self.path):
            layout.addWidget(widget)
        layout.addStretch()
        self._path_changed()
        self.path.fileNameChanged.connect(self._path_changed)
        self.formats.currentIndexChanged.connect(self._format_changed)

    def accept(self):
        """OK: begins to write."""
        if self.job is None:
            self._start()
        return False

    def reject(self):
        """Cancel: forgets the file that is being written, or closes the panel."""
        if self.job is not None:
            self.job.cancel()
            return False
        self._close()
        return True

    def _close(self):
        self._document_watch.end()
        FreeCADGui.Control.closeDialog()

    def _first_path(self):
        folder = preferences.stored().GetString("ExportFolder", "") or os.path.expanduser("~")
        return os.path.join(folder, f"{self._label}.msh")

    def _start(self):
        path = self._complete_path()
        if not path:
            self._say(translate("MeshQuality", "Choose a file, or type its name."), error=True)
            return
        try:
            path = export.checked(path)
            curved = taken_from(self.source)
        except (Error, ImportError) as error:
            self._say(translated(error), error=True)
            return
        self._enable(False)
        self._say("")
        self.job = jobs.Job(self.form.windowTitle(), lambda progress: export.write_ahead(curved(), path),
                            lambda forget: self._land(path, forget),
                            lambda: is_there(self._document, self.obj),
                            drop=lambda forget: forget())
        self.job.ended.connect(self._ended)
        jobs.queue().add(self.job)

    def _land(self, path, forget):
        try:
            FreeCADGui.doCommand("import MeshQuality as mq")
            FreeCADGui.doCommand(f"mq.export_curved_mesh({name_of(self.source)}, {path!r})")
        finally:
            forget()
        preferences.stored().SetString("ExportFolder", os.path.dirname(path))
        FreeCAD.Console.PrintMessage(f"Written: {path}\n")

    def _ended(self):
        job, self.job = self.job, None
        if not job.over:
            background.tell(job)
        if not is_in_task_view(self.form):
            return
        self._enable(True)
        if job.state == jobs.DONE:
            self._close()
        elif job.state == jobs.FAILED:
            self._say(translated(job.error), error=True)
        else:
            self._say(translate("MeshQuality", "Cancelled; no file was written."))

    def _enable(self, enabled):
        self.bar.setVisible(not enabled)
        for widget in (self.path, self.formats):
            widget.setEnabled(enabled)

    def _complete_path(self):
        """The path, with the ending of the format where it has none."""
        path = self.path.property("fileName").strip()
        if path and not os.path.splitext(path)[1] and not os.path.isdir(path):
            path += self.formats.currentData()
            self.path.setProperty("fileName", path)
        return path

    def _format_changed(self, *_):
        stem, extension = os.path.splitext(self.path.property("fileName"))
        if extension.lower() in export.CURVED_FORMATS:
            self.path.setProperty("fileName", stem + self.formats.currentData())

    def _path_changed(self, *_):
        path = self.path.property("fileName")
        index = self.formats.findData(os.path.splitext(path)[1].lower())
        if index >= 0:
            self.formats.setCurrentIndex(index)
        self._say(translate("MeshQuality", "The file exists and will be replaced.")
                  if os.path.isfile(path) else "")

    def _say(self, text, error=False):
        self.said = text
        self.message.say(text, error)
