# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that writes a mesh into a file, in the background."""

import os

import FreeCAD
import FreeCADGui
from PySide import QtGui

from ... import formats
from ...core import frames
from ...core.curving import holds_elements
from ...errors import Error
from ...features import export
from ...features.patches import patches_of_object
from .. import background, jobs, preferences
from ..panel_operation import is_there, name_of
from ..translation import translated
from ..view import badge
from .mesh_panel import title_of
from .task_form import ClosesWithDocument, Message, is_in_task_view

translate = FreeCAD.Qt.translate

_UNITS = (("mm", 1.0), ("m", 0.001), ("in", 1 / 25.4))
_FIRST_FORMAT = {True: ".msh", False: ".stl"}  # of curved elements, of flat triangles


class ExportPanel:
    """A panel for FreeCADGui.Control.showDialog: OK writes, then closes; what goes wrong is said in
    the panel.

    source  a document object with a mesh, or a link to one, see frames
    """

    def __init__(self, source):
        self.source, self.obj = source, frames.object_of(source)
        self._document, self._label = self.obj.Document.Name, frames.leaf_of(source).Label
        self.job, self.said = None, ""
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(title_of("MeshQuality_Export", "Export mesh"))
        self.form.setWindowIcon(QtGui.QIcon(badge.path_of("MeshQuality_Export")))
        self._document_watch = ClosesWithDocument(self._document, self.form, self._close)
        self._suffixes = export.suffixes_for(source)
        of = QtGui.QLabel(self._described())
        self.formats = QtGui.QComboBox()
        for extension in self._suffixes:
            self.formats.addItem(f"{formats.FORMATS[extension].title} (*{extension})", extension)
        self.unit = QtGui.QComboBox()
        for title, scale in _UNITS:
            self.unit.addItem(title, scale)
        self.unit.setToolTip(translate("MeshQuality", "The unit of the numbers in the file: solvers mostly take metres"))
        self.text = QtGui.QCheckBox(translate("MeshQuality", "As text, one solid a patch"))
        self.text.setToolTip(translate("MeshQuality", "STL as text, which OpenFOAM takes the names of patches from"))
        self.path = FreeCADGui.UiLoader().createWidget("Gui::FileChooser")
        self.path.setProperty("acceptMode", 1)  # a file to save
        self.path.setProperty("filter", ";;".join(
            f"{formats.FORMATS[extension].title} (*{extension})" for extension in self._suffixes))
        self.path.setProperty("fileName", self._first_path())
        self.path.setToolTip(translate("MeshQuality", "Without an extension, that of the format is added"))
        self.message, self.bar = Message(), QtGui.QProgressBar()
        self.bar.setRange(0, 0)
        self.bar.hide()
        layout = QtGui.QVBoxLayout(self.form)
        layout.setContentsMargins(0, 0, 0, 0)
        of.setWordWrap(True)
        for widget in (of, self.message, self.bar, QtGui.QLabel(translate("MeshQuality", "Format")), self.formats,
                       QtGui.QLabel(translate("MeshQuality", "File")), self.path,
                       QtGui.QLabel(translate("MeshQuality", "Unit")), self.unit, self.text):
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
        return os.path.join(folder, f"{self._label}{_FIRST_FORMAT[holds_elements(self.source)]}")

    def _described(self):
        """Says what is written, and by which patches."""
        if holds_elements(self.source):
            text = translate("MeshQuality", "Mesh: {}, curved elements of order {}").format(
                self._label, frames.linked_of(self.source)[0].ElementsOrder)
        else:
            text = translate("MeshQuality", "Mesh: {}").format(self._label)
        try:
            patches, rest = patches_of_object(self.source)
        except Error as error:
            return f"{text}\n{translated(error)}"
        names = [*(patches or {}), *([rest] if rest else [])]
        return f"{text}\n" + (translate("MeshQuality", "Patches: {}").format(", ".join(names)) if names else translate(
            "MeshQuality", "Each face is a patch by its own name; the command Patches names them."))

    def _start(self):
        path = self._complete_path()
        if not path:
            self._say(translate("MeshQuality", "Choose a file, or type its name."), error=True)
            return
        try:
            path = export.checked(self.source, path)
            make = export.maker_of(self.source, path)
        except (Error, ImportError) as error:
            self._say(translated(error), error=True)
            return
        self._enable(False)
        self._say("")
        options = self._options(path)
        self.job = jobs.Job(self.form.windowTitle(), lambda progress: export.write_ahead(make, path, **options),
                            lambda forget: self._land(path, options, forget),
                            lambda: is_there(self._document, self.obj),
                            drop=lambda forget: forget())
        self.job.ended.connect(self._ended)
        jobs.queue().add(self.job)

    def _options(self, path):
        """What export_mesh takes beside object and path, where it is not the default."""
        options = {}
        if self.unit.currentData() != 1.0:
            options["scale"] = self.unit.currentData()
        if self.text.isChecked() and self._has_text(os.path.splitext(path)[1]):
            options["ascii"] = True
        return options

    @staticmethod
    def _has_text(suffix):
        known = formats.known_suffix(suffix)
        return known is not None and formats.FORMATS[known].text

    def _land(self, path, options, forget):
        try:
            FreeCADGui.doCommand("import MeshQuality as mq")
            given = "".join(f", {name}={value!r}" for name, value in options.items())
            FreeCADGui.doCommand(f"mq.export_mesh({name_of(self.source)}, {path!r}{given})")
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
        for widget in (self.path, self.formats, self.unit, self.text):
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
        if formats.known_suffix(extension):
            self.path.setProperty("fileName", stem + self.formats.currentData())

    def _path_changed(self, *_):
        path = self.path.property("fileName")
        suffix = os.path.splitext(path)[1]
        index = self.formats.findData(formats.known_suffix(suffix))
        self.text.setVisible(self._has_text(suffix))
        if index >= 0:
            self.formats.setCurrentIndex(index)
        self._say(translate("MeshQuality", "The file exists and will be replaced.")
                  if os.path.isfile(path) else "")

    def _say(self, text, error=False):
        self.said = text
        self.message.say(text, error)
