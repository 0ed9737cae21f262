# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that writes a curved mesh into a file, in the background."""

import os

import FreeCAD
import FreeCADGui
from PySide import QtGui

from .. import export
from ..curved_mesh import CurvedMesh
from ..errors import Error
from . import jobs, preferences
from .mesh_panel import title_of
from .operation import is_there, name_of
from .words import translated

translate = FreeCAD.Qt.translate


class ExportPanel:
    """A panel for FreeCADGui.Control.showDialog: OK writes, then closes; what goes wrong is said in
    the panel.

    obj  a document object of add_curved_mesh
    """

    def __init__(self, obj):
        self.obj, self._document = obj, obj.Document.Name
        self.job, self.said = None, ""
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(title_of("MeshQuality_Export", "Export curved mesh"))
        of = QtGui.QLabel(translate("MeshQuality", "Of {}, as curved elements of order {}").format(
            obj.Label, obj.ElementsOrder))
        self.path = FreeCADGui.UiLoader().createWidget("Gui::FileChooser")
        self.path.setProperty("acceptMode", 1)  # a file to save
        self.path.setProperty("filter", ";;".join(
            f"{title} (*{extension})" for extension, title in export.CURVED_FORMATS.items()))
        self.path.setProperty("fileName", self._first_path())
        formats = ", ".join(f"{end} {title}" for end, title in export.CURVED_FORMATS.items())
        self.path.setToolTip(
            translate("MeshQuality", "The ending chooses the format: {}").format(formats))
        self.message, self.bar = QtGui.QLabel(), QtGui.QProgressBar()
        self.bar.setRange(0, 0)
        self.bar.hide()
        layout = QtGui.QVBoxLayout(self.form)
        for label in (of, self.message):
            label.setWordWrap(True)
        for widget in (of, QtGui.QLabel(translate("MeshQuality", "File")), self.path, self.bar, self.message):
            layout.addWidget(widget)
        layout.addStretch()
        self.path.fileNameChanged.connect(self._path_changed)
        self._path_changed()

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
        FreeCADGui.Control.closeDialog()
        return True

    def _first_path(self):
        folder = preferences.stored().GetString("ExportFolder", "") or os.path.expanduser("~")
        return os.path.join(folder, f"{self.obj.Label}.msh")

    def _start(self):
        try:
            path = export.checked(self.path.property("fileName"))
            curved = CurvedMesh.taken_from(self.obj)
        except (Error, ImportError) as error:
            self._say(translated(error))
            return
        self.path.setEnabled(False)
        self.bar.show()
        self._say("")
        self.job = jobs.Job("Export curved mesh", lambda progress: export.write_ahead(curved(), path),
                            lambda forget: self._land(path, forget),
                            lambda: is_there(self._document, self.obj),
                            drop=lambda forget: forget())
        self.job.ended.connect(self._ended)
        jobs.queue().add(self.job)

    def _land(self, path, forget):
        try:
            FreeCADGui.doCommand("import MeshQuality as mq")
            FreeCADGui.doCommand(f"mq.export_curved_mesh({name_of(self.obj)}, {path!r})")
        finally:
            forget()
        preferences.stored().SetString("ExportFolder", os.path.dirname(path))
        FreeCAD.Console.PrintMessage(f"{path} was written\n")

    def _ended(self):
        job, self.job = self.job, None
        self.bar.hide()
        self.path.setEnabled(True)
        if job.state == jobs.DONE:
            FreeCADGui.Control.closeDialog()
        else:
            self._say(translated(job.error) if job.state == jobs.FAILED
                      else translate("MeshQuality", "Cancelled; no file was written."))

    def _path_changed(self, *_):
        exists = os.path.isfile(self.path.property("fileName"))
        self._say(translate("MeshQuality", "The file exists and will be replaced.")
                  if exists else "")

    def _say(self, text):
        self.said = text
        self.message.setText(text)
        self.message.setVisible(bool(text))
