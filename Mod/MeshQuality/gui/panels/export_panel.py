# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that writes a mesh into a file, in the background."""

import os
from functools import partial

import FreeCAD
import FreeCADGui
from PySide import QtGui

from ... import formats
from ...core.curving import holds_elements
from ...core.sources import frames
from ...errors import Error, IoError
from ...features import export, mesh_object
from ...features.file_settings import UNITS
from ...features.patches import patches_of_object
from .. import preferences
from ..panel_operation import name_of
from ..translation import translated
from .writing_panel import WritingPanel

translate = FreeCAD.Qt.translate

class ExportPanel(WritingPanel):
    """OK writes the file, then closes.

    source  a document object with a mesh, or a link to one, see frames
    """

    COMMAND, TITLE = "MeshQuality_Export", "Export mesh"
    DROP = staticmethod(lambda forget: forget())

    def add_fields(self, layout):
        suffixes = self._known = export.suffixes_for(self.source)
        titles = {suffix: f"{formats.title_of(suffix)} (*{suffix})" for suffix in suffixes}
        self.formats = QtGui.QComboBox()
        for suffix, title in titles.items():
            self.formats.addItem(title, suffix)
        self.unit = QtGui.QComboBox()
        for title, scale in UNITS:
            self.unit.addItem(title, scale)
        self.unit.setToolTip(translate("MeshQuality", "The unit of the numbers in the file: solvers mostly take metres"))
        self.text = QtGui.QCheckBox(translate("MeshQuality", "As text, one solid a patch"))
        self.text.setToolTip(translate("MeshQuality", "STL as text, which OpenFOAM takes the names of patches from"))
        self.path = FreeCADGui.UiLoader().createWidget("Gui::FileChooser")
        self.path.setProperty("acceptMode", 1)  # a file to save
        self.path.setProperty("filter", ";;".join(titles.values()))
        self.path.setProperty("fileName", os.path.join(
            self.first_folder(), f"{self.label}{_first_format(self.source)}"))
        self.path.setToolTip(translate("MeshQuality", "Without an extension, that of the format is added"))
        of = QtGui.QLabel(self._described())
        of.setWordWrap(True)
        layout.addWidget(of)
        self.add_work(layout)
        for widget in (QtGui.QLabel(translate("MeshQuality", "Format")), self.formats,
                       QtGui.QLabel(translate("MeshQuality", "File")), self.path,
                       QtGui.QLabel(translate("MeshQuality", "Unit")), self.unit, self.text):
            layout.addWidget(widget)
        self.fields = (self.path, self.formats, self.unit, self.text)
        self._path_changed()
        self.path.fileNameChanged.connect(self._path_changed)
        self.formats.currentIndexChanged.connect(self._format_changed)

    def _described(self):
        """Says what is written, and by which patches."""
        if export.holds_fem_mesh(self.source):
            return translate("MeshQuality", "FEM mesh: {}, with its groups").format(self.label)
        if holds_elements(self.source):
            text = translate("MeshQuality", "Mesh: {}, curved elements of order {}").format(
                self.label, frames.linked_of(self.source)[0].ElementsOrder)
        else:
            text = translate("MeshQuality", "Mesh: {}").format(self.label)
        return described(self.source, text)

    def prepare(self):
        path = self._complete_path()
        if not path:
            raise IoError(translate("MeshQuality", "Choose a file, or type its name."))
        path = export.checked(self.source, path)
        make, how = export.maker_of(self.source, path), self._options(path)
        return lambda _progress: export.write_ahead(make, self.source, path, **how), partial(self._land, path, how)

    def _options(self, path):
        """The arguments of export_mesh beside object and path that are not the default."""
        how = {}
        if self.unit.currentData() != 1.0:
            how["scale"] = self.unit.currentData()
        if self.text.isChecked() and _has_text(os.path.splitext(path)[1]):
            how["ascii"] = True
        return how

    def _land(self, path, how, forget):
        try:
            FreeCADGui.doCommand("import MeshQuality as mq")
            given = "".join(f", {name}={value!r}" for name, value in how.items())
            FreeCADGui.doCommand(f"mq.export_mesh({name_of(self.source)}, {path!r}{given})")
        finally:
            forget()
        self.remember_folder(os.path.dirname(path))
        preferences.stored().SetString(_setting_of(self.source)[0], formats.known_suffix(os.path.splitext(path)[1], self._known))
        FreeCAD.Console.PrintMessage("{}\n".format(translate("MeshQuality", "Written: {}").format(path)))

    def _complete_path(self):
        """The path, with the ending of the format where it has none."""
        path = self.path.property("fileName").strip()
        if path and not os.path.splitext(path)[1] and not os.path.isdir(path):
            path += self.formats.currentData()
            self.path.setProperty("fileName", path)
        return path

    def _format_changed(self, *_):
        stem, suffix = os.path.splitext(self.path.property("fileName"))
        if formats.known_suffix(suffix, self._known):
            self.path.setProperty("fileName", stem + self.formats.currentData())

    def _path_changed(self, *_):
        path = self.path.property("fileName")
        suffix = os.path.splitext(path)[1]
        index = self.formats.findData(formats.known_suffix(suffix, self._known))
        self.text.setVisible(_has_text(suffix))
        if index >= 0:
            self.formats.setCurrentIndex(index)
        self.say(translate("MeshQuality", "The file exists and will be replaced.")
                 if os.path.isfile(path) else "")


def _first_format(source):
    """The format of the last file that was written of such a mesh: users who print write for printing again."""
    setting, usual = _setting_of(source)
    last = preferences.stored().GetString(setting, usual)
    return last if last in export.suffixes_for(source) else usual


def _setting_of(source):
    """(name of the setting with the last format, the usual format)."""
    has_elements = holds_elements(source) or export.holds_fem_mesh(source)
    return ("ExportFormatElements", ".msh") if has_elements else ("ExportFormat", ".stl")


def _has_text(suffix):
    known = formats.known_suffix(suffix)
    return known is not None and formats.FORMATS[known].text


def described(source, text):
    """The text that names a mesh and, where it has any, its patches for people."""
    holder = frames.linked_of(source)[0]
    proxy = getattr(holder, "Proxy", None)
    if not isinstance(proxy, mesh_object.PatchedMesh) or proxy.lacks_source(holder) or not proxy.has_faces(holder):
        return text
    try:
        patches, rest = patches_of_object(source)
    except Error as error:
        return f"{text}\n{translated(error)}"
    names = [*(patches or {}), *([rest] if rest else [])]
    said = translate("MeshQuality", "Patches: {}").format(", ".join(names)) if names else \
        translate("MeshQuality", "Each face is a patch by its own name; the command Patches names them.")
    return f"{text}\n{said}"
