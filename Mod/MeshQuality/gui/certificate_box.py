# SPDX-License-Identifier: LGPL-2.1-or-later
"""The box of a panel on the certificate of the object that it edits."""

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtGui

from .. import phrases
from ..core.certify import verdict
from ..core.sources import convert, frames
from ..features import mesh_object
from .sub_elements import Mark, select_face
from .translation import translated, translated_certificate
from .view.quality_scene import flight_to

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

RELATIONS = (QT_TRANSLATE_NOOP("MeshQuality", "touching"), QT_TRANSLATE_NOOP("MeshQuality", "overlapping"),
             QT_TRANSLATE_NOOP("MeshQuality", "inside"), QT_TRANSLATE_NOOP("MeshQuality", "equal"))

_NEAR = 0.1  # share of a part's size that is seen around a place
_SOLID = 0.5 * np.array([[[-1, -1, -1], [1, 1, 1], [-1, 1, -1]], [[-1, -1, -1], [-1, 1, -1], [1, 1, 1]]])  # looks nowhere


def _words(obj):
    """What was found and changed, and what the certificate and the status of an object say."""
    told = obj.Proxy.told(obj)
    lines = [phrases.upper_first(phrases.sentence(told))] if told is not None else []
    return "\n".join([*map(translated, lines), _verdict(obj)])


def _verdict(obj):
    if verdict.is_missed(obj.Certificate):
        words = translate("MeshQuality", "Target not met: {}").format(
            translated_certificate(verdict.said(phrases.stored(obj.Certificate, obj.CertificateData))))
    elif verdict.is_open(obj.Certificate):
        words = translate("MeshQuality", "Target not decided: {}").format(
            translated_certificate(verdict.said(phrases.stored(obj.Certificate, obj.CertificateData))))
    elif verdict.is_met(obj.Certificate):
        words = translate("MeshQuality", "All requested limits are met.")
    else:
        words = translate("MeshQuality", "Update the mesh to check whether all requested limits are met.")
    if obj.Status == mesh_object.OUT_OF_DATE:
        words += " " + translate("MeshQuality", "The mesh is out of date: a source or an option has "
                                                "changed.")
    elif obj.Status.startswith(mesh_object.FAILED):
        words += " " + translate("MeshQuality", "The last update failed: {}").format(
            translated(phrases.stored(obj.Status[len(mesh_object.FAILED):], obj.StatusData)))
    return words


class CertificateBox(QtGui.QWidget):
    """The sentence, red where a promise is missed, and a button that shows where that is."""

    def __init__(self):
        super().__init__()
        self._obj = None
        self._modes = {}  # display modes by view, before the place was shown
        self._visible = {}  # visibility of the sources before the place was shown
        self._selected = None  # the selection before the place was shown
        self._mark = self.flight = None
        self.text = QtGui.QLabel()
        self.text.setWordWrap(True)
        self.button = QtGui.QPushButton(translate("MeshQuality", "Show where"))
        self.button.setToolTip(translate(
            "MeshQuality", "Moves the camera there, and selects the faces of the shape on which a requested "
                           "limit is not met"))
        self.button.clicked.connect(self.show_place)
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        self.pairs = QtGui.QListWidget()
        self.pairs.setWordWrap(True)
        self.pairs.setAlternatingRowColors(True)
        self.pairs.setToolTip(translate("MeshQuality", "Click to show where the two bodies are nearest"))
        self.pairs.currentRowChanged.connect(self.show_pair)
        self.pairs.itemClicked.connect(lambda _: self.show_pair(self.pairs.currentRow()))
        for widget in (self.text, self.button, self.pairs):
            layout.addWidget(widget)
        self.show(None)

    def show(self, obj):
        """Shows what the object's certificate says; hides without an object."""
        self._end_mark()
        self._obj = obj
        # That a mesh is without its source the panel says, and nothing else.
        shown = obj is not None and not obj.Proxy.lacks_source(obj)
        self.setVisible(shown)
        self._list_pairs(getattr(obj, "Pairs", []))
        if not shown:
            return
        missed = verdict.is_missed(obj.Certificate)
        self.text.setText(_words(obj))
        self.text.setStyleSheet("color: #cc0000" if missed else "")
        self.button.setVisible((missed or verdict.is_open(obj.Certificate)) and bool(obj.CertificateFaces or obj.CertificatePlace))

    def show_place(self):
        """Selects those faces of the source, marks where it is worst and flies there; triangles become
        wires.
        """
        view = self._obj.ViewObject
        self._remember(view)
        view.DisplayMode = "Wireframe"
        if self._obj.CertificateFaces:
            self._select(self._obj.Proxy.sources(self._obj)[0], self._obj.CertificateFaces)
        corners = convert.moved(np.array([tuple(corner) for corner in self._obj.CertificatePlace]),
                                frames.motion_of(self._obj))
        if len(corners):
            self._show_places(FreeCADGui.getDocument(self._obj.Document.Name).activeView(), corners)
        else:
            FreeCADGui.SendMsgToActiveView("ViewSelection")

    def _list_pairs(self, pairs):
        blocked = self.pairs.blockSignals(True)
        self.pairs.clear()
        for pair in pairs:
            how, _, bodies = pair.partition(": ")
            self.pairs.addItem(f"{translated(translate('MeshQuality', how))}: {bodies}")
        self.pairs.setVisible(bool(pairs))
        self.pairs.blockSignals(blocked)

    def show_pair(self, row):
        """Marks where two bodies are nearest to each other, and flies there."""
        if row < 0:
            return
        self._remember(self._obj.ViewObject)
        for source in self._obj.Proxy.sources(self._obj):
            frames.object_of(source).ViewObject.Visibility = True
        places = np.array([tuple(point) for point in self._obj.Places[2 * row:2 * row + 2]])
        places = convert.moved(places, frames.motion_of(self._obj))
        self._show_places(FreeCADGui.getDocument(self._obj.Document.Name).activeView(), places[[0, 1, 1]],
                      convert.size_of(self._obj.Proxy.sources(self._obj)[0]))

    def _remember(self, view):
        """Stores the state of the view that is restored once the panel closes."""
        self._modes.setdefault(view, view.DisplayMode)
        source = getattr(self._obj, "Source", None)
        if source is not None:
            self._visible.setdefault(source.ViewObject, source.ViewObject.Visibility)
        if self._selected is None:
            self._selected = [(part.Object, name) for part in FreeCADGui.Selection.getSelectionEx("", 0)
                              for name in part.SubElementNames or ("",)]

    def _select(self, source, faces):
        frames.object_of(source).ViewObject.Visibility = True
        FreeCADGui.Selection.clearSelection()
        for face in faces:
            select_face(source, face)

    def _show_places(self, view, corners, around=None):
        if not hasattr(view, "getCameraNode"):
            return  # it is no 3D view
        self._end_mark()
        self._mark = Mark(view, corners.tolist())
        corners = corners.reshape(1, 3, 3)
        if around is None:
            self.flight = flight_to(view, corners)
            return
        # Two places may be one: as much of the part is seen as tells where that is.
        size = max(float(np.linalg.norm(corners[0, 1] - corners[0, 0])), _NEAR * around)
        self.flight = flight_to(view, corners[0].mean(axis=0) + size * _SOLID, 1.5)

    def _end_mark(self):
        if self._mark is not None:
            self._mark.end()
            self._mark = None

    def end(self):
        """The panel closes: mesh, sources and selection are as before."""
        self._end_mark()
        for view, mode in self._modes.items():
            view.DisplayMode = mode
        for view, visible in self._visible.items():
            view.Visibility = visible
        if self._selected is not None:
            FreeCADGui.Selection.clearSelection()
            for obj, name in self._selected:
                FreeCADGui.Selection.addSelection(obj, name)
        self._modes, self._visible, self._selected = {}, {}, None
