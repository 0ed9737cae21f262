# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a panel tells of the certificate of the object that it edits."""

import FreeCAD
import FreeCADGui
from PySide import QtGui

from ..features import certificate, mesh_object

translate = FreeCAD.Qt.translate


class CertificateBox(QtGui.QWidget):
    """The sentence, red where a promise is missed, and a button that shows where that is."""

    def __init__(self):
        super().__init__()
        self._obj = None
        self._modes = {}  # display modes by view, before the place was shown
        self.text = QtGui.QLabel()
        self.text.setWordWrap(True)
        self.button = QtGui.QPushButton(translate("MeshQuality", "Show where"))
        self.button.setToolTip(translate(
            "MeshQuality", "Selects the faces of the part on which the mesh misses what was asked for"))
        self.button.clicked.connect(self.show_place)
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.text)
        layout.addWidget(self.button)
        self.show(None)

    def show(self, obj):
        """Shows what the object's certificate says; hides without an object."""
        self._obj = obj
        self.setVisible(obj is not None)
        if obj is None:
            return
        missed = obj.Certificate.startswith(certificate.MISSED)
        outdated = obj.Status == mesh_object.OUT_OF_DATE
        words = translate("MeshQuality", "The mesh keeps all that was asked for.")
        if missed:
            words = translate("MeshQuality", "What was asked for is missed: {}").format(
                obj.Certificate[len(certificate.MISSED):])
        elif obj.Certificate != certificate.KEPT:
            words = translate("MeshQuality", "Update the mesh to learn whether it keeps what was "
                                             "asked for.")
        if outdated:
            words += " " + translate("MeshQuality", "The mesh is out of date: a source or an option "
                                                    "has changed.")
        self.text.setText(words)
        self.text.setStyleSheet("color: #cc0000" if missed else "")
        self.button.setVisible(missed and bool(obj.CertificateFaces))

    def show_place(self):
        """Selects those faces of the source and moves the view there; triangles become wires."""
        source = self._obj.Source
        view = self._obj.ViewObject
        self._modes.setdefault(view, view.DisplayMode)
        view.DisplayMode = "Wireframe"
        source.ViewObject.Visibility = True
        FreeCADGui.Selection.clearSelection()
        # The faces of a container are numbered through all that it holds: select it as a whole.
        names = self._obj.CertificateFaces if hasattr(source, "Shape") else [""]
        for name in names:
            FreeCADGui.Selection.addSelection(source, name)
        FreeCADGui.SendMsgToActiveView("ViewSelection")

    def end(self):
        """The panel closes: the mesh looks as before."""
        for view, mode in self._modes.items():
            view.DisplayMode = mode
        self._modes.clear()
