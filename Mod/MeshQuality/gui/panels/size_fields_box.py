# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of size regions in a panel, and the field that they make, drawn before meshing."""

from contextlib import suppress

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from ...core.sizes.size_field import size_field
from ...core.sources import convert, frames
from ...errors import Error
from ...features import size_fields, size_region
from ...features.transactions import undo_step
from ..quantities import length_text
from ..translation import translated
from .task_form import Message, Table

translate = FreeCAD.Qt.translate

_PART = 20  # a new region gets this part of the size of the shape as its size
_FAR = 10  # a new region near faces ends at this part
_ROWS = 4  # of the table that are seen
_POINT = 5  # pixels


class SizeFieldsBox(QtGui.QWidget):
    """A row for each size field of the document, with a check mark and its size; buttons that add a region of what is selected,
    and draw the field.
    """

    changed = QtCore.Signal()

    def __init__(self, sources):
        super().__init__()
        self._sources, self._drawn = sources, _Drawn()
        self.table = Table(0, 2)
        self.table.setHorizontalHeaderLabels([translate("MeshQuality", "Region"), translate("MeshQuality", "Size")])
        self.table.horizontalHeader().setSectionResizeMode(0, QtGui.QHeaderView.Stretch)
        self.table.horizontalHeader().setSectionResizeMode(1, QtGui.QHeaderView.ResizeToContents)
        self.table.verticalHeader().hide()
        self.table.setMaximumHeight((_ROWS + 1) * self.table.verticalHeader().defaultSectionSize())
        self.add, self.draw = QtGui.QToolButton(), QtGui.QToolButton()
        self.add.setText("+")
        self.add.setToolTip(translate("MeshQuality", "Add a region: inside of the selected solids, or near the selected faces, edges "
                                                     "and points"))
        self.draw.setText(translate("MeshQuality", "Draw"))
        self.draw.setCheckable(True)
        self.draw.setToolTip(translate("MeshQuality", "Draw the sizes as coloured points, and count the triangles to expect"))
        self.words = Message()
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.table)
        row = QtGui.QHBoxLayout()
        row.setSpacing(2)  # a long label of another option leaves little room
        for widget in (self.add, self.draw):
            row.addWidget(widget)
        row.addStretch()
        column.addLayout(row)
        column.addWidget(self.words)
        self.add.clicked.connect(self._add_region)
        self.draw.toggled.connect(self._show)
        self.table.itemChanged.connect(self._edited)
        self.destroyed.connect(self._drawn.clear)
        self.fill(())

    def showEvent(self, event):
        """Called by Qt: only now the button has the style sheet of the window, and the width that it needs."""
        self.draw.setMinimumWidth(self.draw.sizeHint().width())
        super().showEvent(event)

    def names(self):
        """The names of the fields that are checked."""
        rows = (self.table.item(i, 0) for i in range(self.table.rowCount()))
        return [item.data(QtCore.Qt.UserRole) for item in rows if item.checkState() == QtCore.Qt.Checked]

    def fill(self, checked):
        """Shows the fields of the document, these with a check mark."""
        document = frames.object_of(self._sources[0]).Document if self._sources else None
        fields = [obj for obj in document.Objects if size_fields.is_field(obj)] if document is not None else []
        blocked = self.table.blockSignals(True)
        self.table.setRowCount(len(fields))
        for i, obj in enumerate(fields):
            name = QtGui.QTableWidgetItem(obj.Label)
            name.setFlags(QtCore.Qt.ItemIsEnabled | QtCore.Qt.ItemIsUserCheckable)
            name.setCheckState(QtCore.Qt.Checked if obj.Name in checked else QtCore.Qt.Unchecked)
            name.setData(QtCore.Qt.UserRole, obj.Name)
            size = QtGui.QTableWidgetItem(length_text(obj.Size.Value) if hasattr(obj, "Size") else "")
            if not hasattr(obj, "Size"):
                size.setFlags(QtCore.Qt.ItemIsEnabled)
            self.table.setItem(i, 0, name)
            self.table.setItem(i, 1, size)
        self.table.blockSignals(blocked)
        self.table.setVisible(bool(fields))
        self._draw_again()

    def _edited(self, item):
        if item.column() == 1:
            self._set_size(item)
        self._draw_again()
        self.changed.emit()

    def _set_size(self, item):
        obj = self._document().getObject(self.table.item(item.row(), 0).data(QtCore.Qt.UserRole))
        try:
            length = FreeCAD.Units.Quantity(item.text())
            if not length.Value > 0.0 or length.Unit not in (FreeCAD.Units.Length, FreeCAD.Units.Unit()):
                raise ValueError
        except (ValueError, ArithmeticError, OSError):
            self.words.say(translate("MeshQuality", "A size is a length above 0."))
        else:
            self.words.say("")
            with undo_step(obj.Document, f"Size of {obj.Label}"):
                obj.Size = length.Value
        blocked = self.table.blockSignals(True)
        item.setText(length_text(obj.Size.Value))
        self.table.blockSignals(blocked)

    def _document(self):
        return frames.object_of(self._sources[0]).Document

    def _add_region(self):
        chosen, size = _selected(), convert.size_of(self._sources[0]) if self._sources else 0.0
        if not chosen or not size:
            self.words.say(translate("MeshQuality", "Select solids, or faces, edges or points, in the 3D view first."))
            return
        parts = any(names for _, names in chosen)
        try:
            added = size_region.add_size_region(chosen, size / _PART, kind="near" if parts else "inside",
                                                distance=size / _FAR if parts else None)
        except Error as error:
            self.words.say(translated(error))
            return
        self.words.say("")
        self.fill([*self.names(), added.Name])
        self.changed.emit()

    def _draw_again(self):
        if self.draw.isChecked():
            self._show(True)

    def _show(self, shown):
        self._drawn.clear()
        self.words.say("")
        if not shown or not self._sources:
            return
        names = self.names()
        if not names:
            self.words.say(translate("MeshQuality", "Check a region first."))
            return
        try:
            found = size_field(convert.shape_of(self._sources[0]), size_fields.fields_for(self._sources[0], names)[0])
        except Error as error:
            self.words.say(translated(error))
            return
        self._drawn.show(FreeCADGui.getDocument(self._document().Name).activeView(), found)
        self.words.say(translate("MeshQuality", "Sizes from {0} (red) to {1} (blue); about {2} triangles by these regions").format(
            length_text(found.least), length_text(float(found.sizes.max())), f"{found.expected_triangles:,}"))


class _Drawn:
    """Coloured points in a 3D view."""

    def __init__(self):
        self._graph = self._node = None

    @property
    def node(self):
        """What is drawn; None: nothing."""
        return self._node

    def show(self, view, field):
        """Draws a SizeField: small sizes red, large ones blue."""
        import numpy as np
        from pivy import coin

        from ...core import colour_scale

        logs = np.log(field.sizes)
        goodness = (logs - logs.min()) / max(float(np.ptp(logs)), 1e-9)
        node, material, binding = coin.SoSeparator(), coin.SoMaterial(), coin.SoMaterialBinding()
        material.diffuseColor.setValues(0, len(logs), colour_scale.colours_of(goodness).tolist())
        binding.value = coin.SoMaterialBinding.PER_VERTEX
        light, style, points = coin.SoLightModel(), coin.SoDrawStyle(), coin.SoCoordinate3()
        light.model = coin.SoLightModel.BASE_COLOR
        style.pointSize = _POINT
        points.point.setValues(0, len(logs), field.points.tolist())
        for part in (light, style, material, binding, points, coin.SoPointSet()):
            node.addChild(part)
        self._graph, self._node = view.getSceneGraph(), node
        self._graph.addChild(node)

    def clear(self, *_):
        """Takes the points away."""
        if self._node is not None:
            with suppress(Exception):  # the view may be gone
                self._graph.removeChild(self._node)
            self._graph = self._node = None


def _selected():
    """[(object, names of its sub-elements), ...] of what is selected in the 3D view."""
    found = []
    for selected in FreeCADGui.Selection.getSelectionEx():
        names = [name for name in selected.SubElementNames if name]
        if convert.has_faces(selected.Object) or names:
            found.append((selected.Object, names))
    return found
