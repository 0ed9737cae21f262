# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that tells how to get the binary, where it is missing."""

import os

import FreeCAD
from PySide import QtCore, QtGui

from ... import compat
from .mesh_panel import title_of

translate = FreeCAD.Qt.translate


class BinaryPanel:
    """A panel for FreeCADGui.Control.showDialog, with Close alone."""

    def __init__(self):
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(title_of("MeshQuality_GetBinary", "Missing binary"))
        self.text = QtGui.QLabel("\n\n".join(sentences()))
        self.text.setWordWrap(True)
        self.text.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        QtGui.QVBoxLayout(self.form).addWidget(self.text)

    def getStandardButtons(self):
        return compat.flags(QtGui.QDialogButtonBox.Close)


def sentences():
    """What is missing, and the ways to get it: paragraphs."""
    build = os.path.join(compat.HOME, "tools", "build")
    found = [
        translate("MeshQuality", "MeshQuality needs a binary file made for {0}. "
                                 "No usable one was found.").format(compat.versions()),
        translate("MeshQuality", "On Debian: install the package freecad-meshquality that was made for your "
                                 "release."),
        translate("MeshQuality", "Elsewhere: unpack the file {0} of MeshQuality's release, which is a zip, "
                                 "into the folder {1}.").format(compat.wheel(), compat.PACKAGES),
    ]
    if os.path.exists(build):
        found.append(translate("MeshQuality", "From these sources: run ‘bash {0}’ in a terminal.").format(build))
    else:
        found.append(translate(
            "MeshQuality", "From MeshQuality's sources: run ‘bash tools/build’ in their folder."))
    found.append(translate("MeshQuality", "Then restart FreeCAD. Until then, meshes of your documents are shown "
                                          "as they were saved."))
    return found
