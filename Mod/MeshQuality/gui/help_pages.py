# SPDX-License-Identifier: LGPL-2.1-or-later
"""The documentation in a window of its own, beginning with the first steps."""

import os

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from ..compat import HOME

translate = FreeCAD.Qt.translate

FIRST = os.path.join(HOME, "docs", "use", "first-part.md")
_SIZE = QtCore.QSize(760, 720)  # pixels

_pages = None


class Pages(QtGui.QDialog):
    """Shows pages of the documentation; links between them work, those to the web open in the browser."""

    def __init__(self):
        super().__init__(FreeCADGui.getMainWindow())
        self.setWindowTitle(translate("MeshQuality", "Mesh Quality: first steps"))
        self.text = QtGui.QTextBrowser()
        self.text.setOpenExternalLinks(True)
        back, home = (QtGui.QPushButton(text) for text in (translate("MeshQuality", "Back"), translate("MeshQuality", "First steps")))
        buttons = QtGui.QDialogButtonBox(QtGui.QDialogButtonBox.Close)
        buttons.addButton(back, QtGui.QDialogButtonBox.ActionRole)
        buttons.addButton(home, QtGui.QDialogButtonBox.ActionRole)
        layout = QtGui.QVBoxLayout(self)
        layout.addWidget(self.text)
        layout.addWidget(buttons)
        self.resize(_SIZE)
        back.setEnabled(False)
        back.clicked.connect(self.text.backward)
        home.clicked.connect(self.text.home)
        self.text.backwardAvailable.connect(back.setEnabled)
        buttons.rejected.connect(self.close)
        self.text.setSource(QtCore.QUrl.fromLocalFile(FIRST))


def show():
    """Opens the window, or brings it to the front."""
    global _pages
    if _pages is None:
        _pages = Pages()
    _pages.show()
    _pages.raise_()
    return _pages
