# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plane that cuts the mesh in the quality view: its direction, where it is, and how the cut is drawn."""

import FreeCAD
import numpy as np
from PySide import QtCore, QtGui

from ...core.inspect.section import Plane
from ..quantities import QuantityBox
from .task_form import keep_choices, narrow

translate = FreeCAD.Qt.translate

_STEPS = 1000  # of the slider
_FACE = 3  # number of the direction that was picked; those before are x, y and z
_SHOWN_AFTER = 20  # ms after the last move of the slider, so that it does not wait for the drawing


class SectionBox(QtGui.QWidget):
    """The fields of a plane, shown once the box `on`, which stands elsewhere, is checked."""

    changed = QtCore.Signal()  # another plane, or another way to draw it

    def __init__(self, begin):
        """begin()  the SectionData, once the box is checked"""
        super().__init__()
        self.data, self._begin, self._scene, self._callback = None, begin, None, None
        self._picked = self._base = None  # the Plane that was picked; the point from which the offset counts
        self._flipped = False
        self.on, self.whole = QtGui.QCheckBox(translate("MeshQuality", "Section")), QtGui.QCheckBox(translate("MeshQuality", "Whole elements"))
        self.direction, self.offset = QtGui.QComboBox(), QuantityBox("mm", signed=True)
        self.slider, self.flip, self.pick = QtGui.QSlider(QtCore.Qt.Horizontal), QtGui.QToolButton(), QtGui.QToolButton()
        self._fill()
        self._timer = QtCore.QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(_SHOWN_AFTER)
        self._timer.timeout.connect(self.changed)
        self.hide()
        self.on.toggled.connect(self._switch)
        self.direction.currentIndexChanged.connect(self._turn)
        self.flip.clicked.connect(self._turn_over)
        self.pick.toggled.connect(self._picking)
        self.whole.toggled.connect(lambda _: self.changed.emit())
        self.slider.valueChanged.connect(self._slide)
        self.offset.valueChanged.connect(self._move)

    def _fill(self):
        self.on.setToolTip(translate("MeshQuality", "Cut the mesh open by a plane"))
        self.whole.setToolTip(translate("MeshQuality", "Leave elements whole: those whose middle is not cut off"))
        for text in ("X", "Y", "Z", translate("MeshQuality", "Picked")):
            self.direction.addItem(text)
        keep_choices(self.direction)
        self.direction.model().item(_FACE).setEnabled(False)
        self.direction.setToolTip(translate("MeshQuality", "Direction across which the mesh is cut"))
        self.flip.setText(translate("MeshQuality", "Flip"))
        self.flip.setToolTip(translate("MeshQuality", "Show the other half"))
        self.pick.setText(translate("MeshQuality", "Pick"))
        self.pick.setToolTip(translate("MeshQuality", "Then click on the mesh: the plane is parallel to its surface there"))
        self.pick.setCheckable(True)
        self.slider.setRange(0, _STEPS)
        self.offset.setToolTip(translate("MeshQuality", "Where the plane is: its coordinate, or its distance from the picked place"))
        self.offset.setMinimumWidth(self.offset.sizeHint().width())
        for button in (self.flip, self.pick):
            narrow(button, "padding: 2px 4px; margin: 0px")
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(3)
        for widgets in ((self.direction, self.pick), (self.slider, self.offset), (self.whole, self.flip)):
            row = QtGui.QHBoxLayout()
            row.setSpacing(3)
            for i, widget in enumerate(widgets):
                row.addWidget(widget, 1 - i)
            layout.addLayout(row)

    @property
    def plane(self):
        """The Plane; None where the mesh is not cut, as while a place on it is picked."""
        if not self.on.isChecked() or self.data is None or self.pick.isChecked():
            return None
        normal = self._normal()
        return Plane(self._base + self.offset.value() * normal, -normal if self._flipped else normal)

    def through(self, point):
        """Moves the plane through a point."""
        self.offset.setValue(float((point - self._base) @ self._normal()))

    def watch(self, scene):
        """Takes the direction of the camera, and clicks while a place is picked, of the view of a QualityScene."""
        self._scene = scene

    def end(self):
        """Takes no more clicks, and asks for no more drawing."""
        self.blockSignals(True)
        self.pick.setChecked(False)
        self._timer.stop()

    def _normal(self):
        number = self.direction.currentIndex()
        return self._picked.normal if number == _FACE else np.eye(3)[number]

    def _switch(self, on):
        self.setVisible(on)
        self.pick.setChecked(False)
        if on and self.data is None:
            self.data = self._begin()
            self._quietly(self.direction.setCurrentIndex, int(np.abs(self._scene.ahead()).argmax()))
            self._turn()
        else:
            self.changed.emit()

    def _turn(self, *_):
        """Another direction: the plane goes through the middle, or the place that was picked, and what is before it is cut off."""
        number = self.direction.currentIndex()
        self._base = self._picked.point if number == _FACE else np.zeros(3)
        self._flipped = bool(self._normal() @ self._scene.ahead() > 0.0)
        self._place(0.0 if number == _FACE else float(self.data.middle()[number]))
        self.changed.emit()

    def _turn_over(self):
        self._flipped = not self._flipped
        self.changed.emit()

    def _place(self, offset):
        """Sets the field and the slider, which goes from one side of the mesh to the other."""
        self._low, self._high = self.data.range(Plane(self._base, self._normal()))
        self._quietly(self.offset.setValue, offset)
        part = (offset - self._low) / max(self._high - self._low, np.finfo(float).tiny)
        self._quietly(self.slider.setValue, round(_STEPS * min(max(part, 0.0), 1.0)))

    def _slide(self, step):
        self._quietly(self.offset.setValue, self._low + (self._high - self._low) * step / _STEPS)
        self._timer.start()

    def _move(self, offset):
        self._place(offset)
        self.changed.emit()

    def _quietly(self, change, value):
        widget = change.__self__
        was = widget.blockSignals(True)
        change(value)
        widget.blockSignals(was)

    def _picking(self, on):
        if on and self._callback is None:
            self._callback = self._scene.view.addEventCallback("SoMouseButtonEvent", self._clicked)
        elif not on and self._callback is not None:
            self._scene.view.removeEventCallback("SoMouseButtonEvent", self._callback)
            self._callback = None
        self.changed.emit()

    def _clicked(self, event):
        if event["Button"] != "BUTTON1" or event["State"] != "DOWN":
            return
        found = self._scene.hit(*event["Position"])
        if found is None:
            return
        corners, point = found
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        self._picked = Plane(point, normal / np.linalg.norm(normal))
        self.pick.setChecked(False)
        self.direction.model().item(_FACE).setEnabled(True)
        self._quietly(self.direction.setCurrentIndex, _FACE)
        self._turn()
