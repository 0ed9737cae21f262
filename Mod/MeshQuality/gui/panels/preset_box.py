# SPDX-License-Identifier: LGPL-2.1-or-later
"""The box at the top of a panel that offers how fine a mesh shall be."""

import FreeCAD
from PySide import QtCore, QtGui

from ... import options
from ..quantities import length_text

translate = FreeCAD.Qt.translate


class PresetBox(QtGui.QWidget):
    """A choice among presets, and what the present values promise in words; hidden without presets."""

    chosen = QtCore.Signal(dict)  # values

    def __init__(self, presets):
        super().__init__()
        self._presets = presets
        self.box = QtGui.QComboBox()
        for preset in presets:
            self.box.addItem(translate("MeshQuality", preset.title))
        self.box.addItem(translate("MeshQuality", "Custom"))
        self.promise = QtGui.QLabel()
        self.promise.setWordWrap(True)
        layout = QtGui.QFormLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addRow(translate("MeshQuality", "Fineness"), self.box)
        layout.addRow(self.promise)
        # Not at every change of the index: `show` changes it too.
        self.box.activated[int].connect(self._choose)
        self.setVisible(bool(presets))

    def show(self, values, size):
        """Shows which preset the values are, and what they promise of a part of this size in mm."""
        names = [i for i, preset in enumerate(self._presets)
                 if all(values[name] == value for name, value in preset.values.items())]
        self.box.setCurrentIndex(names[0] if names else len(self._presets))
        if self._presets:
            self.promise.setText(_promise(values, size))

    def _choose(self, index):
        if index < len(self._presets):
            self.chosen.emit(self._presets[index].values)


def _promise(values, size):
    """What the bound on the distance means, as a sentence."""
    bound = options.bound_of(values)
    if bound == options.UNBOUNDED:
        return translate("MeshQuality", "The distance from the shape is not bounded.")
    if bound == options.RELATIVE and not size:
        return ""
    height, relative = (values[name] for name in options.DISTANCE)
    length = length_text(height if bound == options.ABSOLUTE else relative * size)
    words = translate("MeshQuality", "Before it is curved, the mesh keeps within {} of the shape.") \
        if "volume" in values else translate("MeshQuality", "Keeps within {} of the shape.")
    return words.format(length)
