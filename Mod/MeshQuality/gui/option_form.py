# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields for the options of a table, each with the unit, range and help that the table gives it."""

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from ..options import text_of_sizes

translate = FreeCAD.Qt.translate

_UNITS = {"mm": FreeCAD.Units.Length, "degrees": FreeCAD.Units.Angle}
_SUFFIX = {"mm": "mm", "degrees": "deg"}
_LARGEST = 2**31 - 1
_WIDE = 150  # pixels that a list of sizes needs


class OptionForm(QtGui.QWidget):
    """One field for each option, in a group box for each group of the table; those that are rarely
    needed can be folded away.
    """

    changed = QtCore.Signal()

    def __init__(self, table):
        super().__init__()
        self._fields = {}
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        self._add_groups(layout, [option for option in table if not option.rare])
        self.more = QtGui.QToolButton()
        self.more.setText(translate("MeshQuality", "More options"))
        self.more.setCheckable(True)
        self.more.setAutoRaise(True)
        self.more.setToolButtonStyle(QtCore.Qt.ToolButtonTextBesideIcon)
        self.more.toggled.connect(self._fold)
        self._rare = QtGui.QWidget()
        inner = QtGui.QVBoxLayout(self._rare)
        inner.setContentsMargins(0, 0, 0, 0)
        rare = [option for option in table if option.rare]
        self._add_groups(inner, rare)
        layout.addWidget(self.more)
        layout.addWidget(self._rare)
        self.more.setVisible(bool(rare))
        self._fold(False)

    def _add_groups(self, layout, table):
        boxes = {}
        for option in table:
            if option.group not in boxes:
                boxes[option.group] = _group(translate("MeshQuality", option.group))
                layout.addWidget(boxes[option.group])
            field = _field(option)
            field.changed.connect(self.changed)
            self._fields[option.name] = field
            if option.kind is bool:
                boxes[option.group].layout().addRow(field.widget)
                continue
            label = QtGui.QLabel(_title(option))
            label.setToolTip(translate("MeshQuality", option.help))
            boxes[option.group].layout().addRow(label, field.widget)

    def _fold(self, shown):
        self.more.setArrowType(QtCore.Qt.DownArrow if shown else QtCore.Qt.RightArrow)
        self._rare.setVisible(shown)

    def values(self):
        """{option: value}; what the table allows is checked by options.check."""
        return {name: field.value() for name, field in self._fields.items()}

    def set_values(self, values):
        """Shows the values of those options that have a field."""
        for name, field in self._fields.items():
            if name in values:
                field.set_value(values[name])
                if field.option.rare and values[name] != field.option.default:
                    self.more.setChecked(True)

    def field(self, name):
        """The widget of an option."""
        return self._fields[name].widget


def _title(option):
    # A spin box says itself what 0 stands for; a field with a unit cannot.
    title = translate("MeshQuality", option.title)
    if not option.unit or option.default is not None:
        return title
    return f"{title} (0: {translate('MeshQuality', option.unset)})"


def _group(title):
    box = QtGui.QGroupBox(title)
    form = QtGui.QFormLayout(box)
    form.setContentsMargins(4, 9, 4, 4)
    # The panel may be 260 pixels wide.
    form.setRowWrapPolicy(QtGui.QFormLayout.WrapLongRows)
    form.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
    return box


def _field(option):
    if option.choices:
        return _Choice(option)
    if option.kind is bool:
        return _Switch(option)
    if option.is_sizes:
        return _Sizes(option)
    return _Quantity(option) if option.unit else _Number(option)


class _Field(QtCore.QObject):
    """A widget for an option; value() gives None where the option is unset."""

    changed = QtCore.Signal()

    def __init__(self, option, widget):
        super().__init__()
        self.option, self.widget = option, widget
        unset = f"\n0: {translate('MeshQuality', option.unset)}" if option.default is None else ""
        widget.setToolTip(translate("MeshQuality", option.help) + unset)
        widget.setObjectName(option.property_name)
        self.set_value(option.default)

    def _changed(self, *_):
        self.changed.emit()

    def _of(self, number):
        return None if self.option.default is None and number == 0 else number


class _Choice(_Field):
    def __init__(self, option):
        box = QtGui.QComboBox()
        for choice, title in zip(option.choices, option.choice_titles):
            box.addItem(translate("MeshQuality", title), choice)
        super().__init__(option, box)
        box.currentIndexChanged.connect(self._changed)

    def value(self):
        return self.widget.itemData(self.widget.currentIndex())

    def set_value(self, value):
        self.widget.setCurrentIndex(self.option.choices.index(value))


class _Switch(_Field):
    def __init__(self, option):
        super().__init__(option, QtGui.QCheckBox(translate("MeshQuality", option.title)))
        self.widget.toggled.connect(self._changed)

    def value(self):
        return self.widget.isChecked()

    def set_value(self, value):
        self.widget.setChecked(value)


class _Number(_Field):
    def __init__(self, option):
        whole = option.kind is int
        box = QtGui.QSpinBox() if whole else QtGui.QDoubleSpinBox()
        if not whole:
            box.setDecimals(6)
            box.setSingleStep(0.001)
        low = 0 if option.default is None else option.low or 0
        box.setRange(low, _LARGEST if option.high is None else option.high)
        if option.default is None:
            box.setSpecialValueText(translate("MeshQuality", option.unset))
        super().__init__(option, box)
        box.valueChanged.connect(self._changed)

    def value(self):
        return self._of(self.widget.value())

    def set_value(self, value):
        self.widget.setValue(0 if value is None else value)


class _Sizes(_Field):
    """Lengths by sub-elements as text, with a button that adds what is selected in the 3D view."""

    def __init__(self, option):
        box = QtGui.QWidget()
        row = QtGui.QHBoxLayout(box)
        row.setContentsMargins(0, 0, 0, 0)
        self.text, self.button = QtGui.QLineEdit(), QtGui.QToolButton()
        self.text.setPlaceholderText("Face3=0.5, Edge7=0.2")
        self.text.setMinimumWidth(_WIDE)
        self.button.setText("+")
        self.button.setToolTip(translate(
            "MeshQuality", "Add the faces, edges and vertices that are selected in the 3D view"))
        row.addWidget(self.text)
        row.addWidget(self.button)
        super().__init__(option, box)
        self.text.editingFinished.connect(self._changed)
        self.button.clicked.connect(self._add_selected)

    def value(self):
        # As it was written: whether that makes sense is said when it is used.
        return self.text.text().strip() or None

    def set_value(self, value):
        self.text.setText(value if isinstance(value, str) else text_of_sizes(value))

    def _add_selected(self):
        """Sub-elements that have no size get a hundredth of the part's diagonal."""
        written = [part.strip() for part in self.text.text().split(",") if part.strip()]
        for selected in FreeCADGui.Selection.getSelectionEx():
            size = selected.Object.Shape.BoundBox.DiagonalLength / 100
            for name in selected.SubElementNames:
                if not any(part.split("=")[0].strip() == name for part in written):
                    written.append(f"{name}={size:.3g}")
        self.text.setText(", ".join(written))
        self._changed()


class _Quantity(_Field):
    """FreeCAD's field for numbers with units and expressions."""

    def __init__(self, option):
        box = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
        box.setProperty("unit", _SUFFIX[option.unit])
        box.setProperty("minimum", 0.0)
        super().__init__(option, box)
        box.valueChanged.connect(self._changed)

    def value(self):
        return self._of(float(self.widget.property("rawValue")))

    def set_value(self, value):
        self.widget.setProperty("value", FreeCAD.Units.Quantity(value or 0.0, _UNITS[self.option.unit]))
