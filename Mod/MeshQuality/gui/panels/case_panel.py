# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that writes a case for OpenFOAM, in the background."""

import os
import re
import shlex
from functools import partial

import FreeCAD
import FreeCADGui
from PySide import QtGui

from ...core.sources import frames
from ...errors import InvalidInput
from ...features import cfd
from ..panel_operation import name_of
from ..quantities import QuantityBox
from .export_panel import described
from .writing_panel import WritingPanel

translate = FreeCAD.Qt.translate

_NEXT, _NEXT_OF_CELLS = "blockMesh && snappyHexMesh -overwrite && checkMesh", "checkMesh"


class CasePanel(WritingPanel):
    """OK writes the folder, then says what to type next.

    source  a document object with a closed mesh, or a flow mesh, or a link to one, see frames
    """

    COMMAND, TITLE = "MeshQuality_FlowCase", "OpenFOAM case"
    STAYS = True
    DROP = staticmethod(lambda forget: forget())

    def add_fields(self, layout):
        self._has_cells = cfd.holds_cells(self.source)
        self.flow = QtGui.QComboBox()
        for title, flow in ((translate("MeshQuality", "inside of the part"), "internal"),
                            (translate("MeshQuality", "around the part"), "external")):
            self.flow.addItem(title, flow)
        self.cell = QuantityBox("mm")
        self.cell.setToolTip(translate("MeshQuality", "Length of the cells far from the surface; 0: 1/20 of the part inside, "
                                                      "1/4 around it. Cells at the surface are as large as its triangles."))
        self.path = FreeCADGui.UiLoader().createWidget("Gui::FileChooser")
        self.path.setProperty("mode", 1)  # a folder
        self.path.setProperty("fileName", os.path.join(self.first_folder(), self._folder_name()))
        of = QtGui.QLabel(described(self.source, translate("MeshQuality", "Mesh: {}").format(self.label)))
        of.setWordWrap(True)
        layout.addWidget(of)
        self.add_work(layout)
        for title, widget in ((translate("MeshQuality", "Flow"), self.flow),
                              (translate("MeshQuality", "Background cells (0: by the size)"), self.cell),
                              (translate("MeshQuality", "Folder"), self.path)):
            label = QtGui.QLabel(title)
            label.setWordWrap(True)
            layout.addWidget(label)
            layout.addWidget(widget)
            if widget is not self.path and self._has_cells:
                label.hide()
                widget.hide()
        self.fields = (self.flow, self.cell, self.path)

    def _folder_name(self):
        """Named after the part, not after its mesh, and without blanks, which OpenFOAM does not take in paths."""
        part = getattr(frames.linked_of(self.source)[0], "Source", None)
        return re.sub(r"[^\w.-]+", "_", part.Label if part is not None else self.label).strip("_") + "_case"

    @staticmethod
    def said_of_cancelling():
        return translate("MeshQuality", "Cancelled; files of the case that were written already stay.")

    def prepare(self):
        folder = self.path.property("fileName").strip()
        if not folder:
            raise InvalidInput(translate("MeshQuality", "Choose a folder, or type its name."))
        flow, cell = self.flow.currentData(), self.cell.value() or None
        make = cfd.maker_of(self.source, flow)
        how = "" if self._has_cells else f", flow={flow!r}" + (f", cell={cell!r}" if cell else "")
        line = f"mq.write_openfoam_case({name_of(self.source)}, {folder!r}{how})"
        return lambda _progress: cfd.write_ahead(make, self.source, folder, flow, cell), partial(self._land, folder, line)

    def _land(self, folder, line, forget):
        try:
            FreeCADGui.doCommand("import MeshQuality as mq")
            FreeCADGui.doCommand(line)
        finally:
            forget()
        self.remember_folder(os.path.dirname(os.path.abspath(folder)))
        folder, then = os.path.abspath(folder), _NEXT_OF_CELLS if self._has_cells else _NEXT
        words = translate("MeshQuality", "Written: {0}. In a terminal with OpenFOAM type: {1}").format(
            folder, f"cd {shlex.quote(folder)} && {then}")
        FreeCAD.Console.PrintMessage(f"{words}\n")
        if " " in folder:
            blanks = translate("MeshQuality", "OpenFOAM takes no blanks in paths: move the folder to where there are none.")
            FreeCAD.Console.PrintWarning(f"{blanks}\n")
            words += f"\n{blanks}"
        self.say(words)
