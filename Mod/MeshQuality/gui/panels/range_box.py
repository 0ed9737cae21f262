# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two numbers between which colours and histogram of the quality view go."""

import FreeCAD
from PySide import QtCore, QtGui

from .task_form import narrow

translate = FreeCAD.Qt.translate

_NUMBER = 58  # least width of a number, pixels

_DIGITS = 3


class RangeBox(QtGui.QWidget):
    """The ends of a scale as fields, and a button that sets them by the measure."""

    chosen = QtCore.Signal(object)  # (low, high); None: the measure sets both

    def __init__(self):
        super().__init__()
        self._scale = None
        self.low, self.high, self.unit, self.reset = QtGui.QLineEdit(), QtGui.QLineEdit(), QtGui.QLabel(), QtGui.QToolButton()
        self.reset.setIcon(self.style().standardIcon(QtGui.QStyle.SP_BrowserReload))
        self.reset.setAutoRaise(True)
        self.reset.setToolTip(translate("MeshQuality", "Colours over the usual range of this measure"))
        narrow(self.reset, "padding: 0px; margin: 0px")
        self.reset.clicked.connect(lambda: self.chosen.emit(None))
        row = QtGui.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(2)
        for widget in (QtGui.QLabel(translate("MeshQuality", "Range")), self.low, QtGui.QLabel("–"), self.high, self.unit, self.reset):
            row.addWidget(widget)
        for field, words in ((self.low, translate("MeshQuality", "Colours begin at this value")),
                             (self.high, translate("MeshQuality", "Colours end at this value"))):
            field.setMinimumWidth(_NUMBER)
            narrow(field, f"min-width: {_NUMBER - 10}px")
            field.setToolTip(words)
            field.editingFinished.connect(self._edited)

    def show_scale(self, scale, is_own):
        """The ends of a quality_data.Scale; is_own: whether the user has chosen them."""
        self._scale = scale
        self.unit.setText(scale.unit.strip())
        self.unit.setVisible(bool(scale.unit.strip()))
        self.reset.setEnabled(is_own)
        for field, value in ((self.low, scale.low), (self.high, scale.high)):
            field.setText(scale.number(value, _DIGITS))

    def _edited(self):
        """Another range, where there is one in the fields; else they get back what they had."""
        if self._scale is None:  # nothing is measured yet
            return
        texts, scale = (self.low.text(), self.high.text()), self._scale
        if texts == (scale.number(scale.low, _DIGITS), scale.number(scale.high, _DIGITS)):
            return
        low, high = (old if text == scale.number(old, _DIGITS) else scale.value_of(text) for text, old in zip(texts, (scale.low, scale.high)))
        if low is not None and high is not None and low < high:
            self.chosen.emit((low, high))
        else:
            self.show_scale(scale, self.reset.isEnabled())
