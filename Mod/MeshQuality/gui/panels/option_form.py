# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields for the options of a table, each with the unit, range and help that the table gives it."""

import re

import FreeCAD
from PySide import QtCore, QtGui

from ... import element_names, options
from ...core.sources import convert, frames
from ...errors import Error
from ...features import distance_bound
from ..quantities import QuantityBox, length_text, text_of, value_of
from ..selection import picked
from ..translation import translated
from .folding import fold_button
from .size_fields_box import SizeFieldsBox
from .task_form import keep_choices, narrow

translate = FreeCAD.Qt.translate

_MORE = FreeCAD.Qt.QT_TRANSLATE_NOOP("MeshQuality", "More options")
_LARGEST = 2**31 - 1
_WIDE = 150  # pixels that a list of sizes needs
_NUMBER = 90  # pixels that a number with its unit needs
_LENGTH = "0.1234 mm"
_ROOM = 8  # fields that are open at first
_ARROW = 42  # pixels of a box with choices beside its text
_KIND_OF_WORK = "check"  # the option that chooses among kinds of work: options of the others are no part of the form
_BETWEEN_SIZES = re.compile(r"[,;]\s*(?=[^\W\d])")  # a comma before a digit is in a number


class OptionForm(QtGui.QWidget):
    """One field for each option, in a box for each group of the table; groups that are rarely needed, and those for which
    there is no room, are folded away until the user opens them. Options that have no effect with the present values are
    disabled, and hidden where they belong to another kind of work than the chosen one.

    sources   the objects that the options are for; None: unknown
    defaults  {option: value} that the button Defaults shows; None: those of the table
    name      under which is kept what the user has opened
    """

    changed = QtCore.Signal()

    def __init__(self, table, sources=None, defaults=None, name=""):
        super().__init__()
        self._name = name
        self._sources = [source for source in sources or [] if source is not None]
        self._defaults = defaults or options.defaults(table)
        self._fields, self._labels = {}, {}
        self._groups = {}  # the fields of each group, by what shows it
        self.folds = {}  # the buttons that fold, by title, below that of the fold in which they are
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        frequent, rare = ([option for option in table if option.rare == is_rare] for is_rare in (False, True))
        self._add_groups(layout, frequent, _ROOM)
        self._rare = QtGui.QWidget()
        layout.addLayout(self._buttons(bool(rare)))
        inner = QtGui.QVBoxLayout(self._rare)
        inner.setContentsMargins(0, 0, 0, 0)
        self._add_groups(inner, rare, _ROOM if len(rare) <= _ROOM else 0, _MORE)
        layout.addWidget(self._rare)
        self.changed.connect(self._enable_effective)
        self._enable_effective()

    def _buttons(self, foldable):
        """The row with the button that folds the rare options, and Defaults."""
        self.more = self.folds[_MORE] = fold_button(translate("MeshQuality", _MORE), self._rare, f"{self._name} {_MORE}")
        self.more.setVisible(foldable)
        self.reset = QtGui.QToolButton()
        self.reset.setText(translate("MeshQuality", "Defaults"))
        self.reset.setToolTip(translate("MeshQuality", "Set all options to their defaults"))
        self.reset.setAutoRaise(True)
        self.reset.clicked.connect(lambda: self.set_values(self._defaults))
        row = QtGui.QHBoxLayout()
        row.setSpacing(0)
        narrow(self.reset, "padding: 0px; margin: 0px")
        row.addWidget(self.more)
        row.addStretch()
        row.addWidget(self.reset)
        return row

    def _add_groups(self, layout, table, room, above=""):
        """A box for each group; those for whose fields there is no room any more are folded away, below the fold `above`."""
        for title, group in _by_group(table).items():
            box, shown = QtGui.QGroupBox(), QtGui.QWidget()
            fields = self._fill(box, group, table)
            count = sum(field.option.only_with[:1] != (_KIND_OF_WORK,) for field in fields)  # one kind is shown at a time
            if count <= room:
                room -= count
                box.setTitle(translate("MeshQuality", title))
                layout.addWidget(box)
                self._groups[box] = fields
                continue
            rows = QtGui.QVBoxLayout(shown)
            rows.setContentsMargins(0, 0, 0, 0)
            rows.setSpacing(0)
            name = above + title
            self.folds[name] = fold_button(translate("MeshQuality", title), box, f"{self._name} {name}")
            rows.addWidget(self.folds[name])
            rows.addWidget(box)
            layout.addWidget(shown)
            self._groups[shown] = fields

    def _fill(self, box, group, table):
        """Fills a box with the fields of a group's options; returns the fields."""
        form, fields = QtGui.QFormLayout(box), []
        form.setContentsMargins(4, 9, 4, 4)
        # The panel may be 260 pixels wide.
        form.setRowWrapPolicy(QtGui.QFormLayout.WrapLongRows)
        form.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
        for option in group:
            if option.name in self._fields:
                continue  # the second of two with one field
            field = self._field(option, table)
            field.changed.connect(self.changed)
            fields.append(field)
            self._fields.update(dict.fromkeys(field.names, field))
            if option.kind is bool:
                form.addRow(field.widget)
                continue
            label = self._labels[option.name] = QtGui.QLabel(_title(option))
            label.setToolTip(_help(option))
            for row in ((label,), (field.widget,)) if field.below else ((label, field.widget),):
                form.addRow(*row)
        return fields

    def _field(self, option, table):
        if option.is_distance:
            return _Distance([pair for pair in table if pair.is_distance], self._size)
        if option.choices:
            return _Choice(option)
        if option.kind is bool:
            return _Switch(option)
        if option.is_sizes:
            return _Sizes(option, self._sources)
        if option.is_faces:
            return _Faces(option, self._sources)
        if option.is_fields:
            return _SizeFields(option, self._sources)
        return _Quantity(option) if option.unit else _Number(option)

    def _size(self):
        """Largest dimension of the first source in mm; 0: unknown."""
        return convert.size_of(self._sources[0]) if self._sources else 0.0

    def _enable_effective(self):
        values = self.values()
        for field in dict.fromkeys(self._fields.values()):
            other, needed = field.option.only_with or (None, ())
            has_effect = other is None or values[other] in needed
            for widget in (field.widget, self._labels.get(field.option.name)):
                if widget is not None:
                    widget.setEnabled(not field.bound and has_effect)
                    if other == _KIND_OF_WORK:
                        widget.setVisible(has_effect)
        for box, fields in self._groups.items():
            box.setVisible(any(not field.widget.isHidden() for field in fields))

    def values(self):
        """{option: value}; what the table allows is checked by options.check. A value that was shown and
        not edited is given back as it was.
        """
        found = {}
        for field in self._fields.values():
            found.update(field.values())
        return found

    def set_values(self, values):
        """Shows the values of those options that have a field and are not bound."""
        for field in dict.fromkeys(self._fields.values()):
            given = {name: values[name] for name in field.names if name in values}
            if given and not field.bound:
                field.show(given)
                if given.get(field.option.name, field.option.default) != field.option.default:
                    self._open(field.option)
        self._enable_effective()

    def _open(self, option):
        """Shows the field of an option where that is folded away."""
        for name in (_MORE, _MORE + option.group) if option.rare else (option.group,):
            if name in self.folds:
                self.folds[name].setChecked(True)

    def bind(self, expressions, values):
        """Shows these values of options that expressions set, {option: expression}, and has nobody edit them."""
        for field in dict.fromkeys(self._fields.values()):
            field.bind(next((expressions[name] for name in field.names if name in expressions), None))
            if field.bound:
                field.show(values)
        self._enable_effective()

    def field(self, name):
        """The widget of an option."""
        return self._fields[name].widget


def _title(option):
    # A spin box says itself what 0 stands for; a field with a unit cannot.
    title = translate("MeshQuality", option.title)
    if not option.unit or option.default is not None or option.is_distance or option.is_required:
        return title
    return f"{title} (0: {translate('MeshQuality', option.unset)})"


def _help(option):
    """What it says, in the words of the box with its choices where these are translated."""
    text = translate("MeshQuality", option.help)
    for choice, title in zip(option.choices, option.choice_titles):
        shown = translate("MeshQuality", title)
        if shown != title:
            text = re.sub(rf"(?<![\w-]){re.escape(choice)}(?![\w-])", f"„{shown}“", text)
    return text


def _by_group(table):
    """{group: options} in the order of the table."""
    return {group: [option for option in table if option.group == group] for group in dict.fromkeys(option.group for option in table)}


def _keep_wide(field, width):
    """Keeps room for a text of this width in pixels: style sheets give fields a least width, which counts instead of their own."""
    narrow(field, f"min-width: {width}px")


class _Field(QtCore.QObject):
    """A widget for an option. A subclass has write(value), which shows a value, and read(), which gives
    what is shown; None where the option is unset. What was shown may have less digits than the value.
    """

    changed = QtCore.Signal()
    below = False  # whether the widget needs the whole width, below its label

    def __init__(self, option, widget):
        super().__init__()
        self.option, self.widget = option, widget
        self.names = (option.name,)
        unset = f"\n0: {translate('MeshQuality', option.unset)}" \
            if option.default is None and not (option.is_distance or option.is_sizes or option.is_faces or option.is_fields
                                               or option.is_required) else ""
        widget.setToolTip(_help(option) + unset)
        widget.setObjectName(option.property_name)
        self._expression, self._hints = None, {}
        self.set_value(option.default)

    def bind(self, expression):
        """Says which expression sets the option; None: no expression does any more."""
        self._expression = expression
        for widget, hint in self._hints.items():
            widget.setToolTip(hint)
        self._hints.clear()
        if self.bound:
            words = translate("MeshQuality", "Set by the expression {}. To edit the value here, clear the expression in "
                                             "the property editor.").format(expression)
            for widget in (self.widget, *self.widget.findChildren(QtGui.QWidget)):
                self._hints[widget] = widget.toolTip()
                widget.setToolTip(words)

    @property
    def bound(self):
        """Whether an expression sets the option."""
        return self._expression is not None

    def value(self):
        """The value that was set, unless the user has edited it."""
        shown = self.read()
        return self._given if shown == self._shown else shown

    def set_value(self, value):
        """Shows a value."""
        # Writing tells of a change: what was set must be known by then.
        self._given, self._shown = value, None
        blocked = self.blockSignals(True)
        self.write(value)
        self.blockSignals(blocked)
        self._shown = self.read()
        self._changed()

    def values(self):
        """{option: value} of the options of the widget."""
        return {self.option.name: self.value()}

    def show(self, values):
        """Shows {option: value}."""
        self.set_value(values[self.option.name])

    def _changed(self, *_):
        self.changed.emit()

    def _of(self, number):
        return None if self.option.default is None and number == 0 else number


class _Choice(_Field):
    def __init__(self, option):
        box = QtGui.QComboBox()
        for choice, title in zip(option.choices, option.choice_titles):
            box.addItem(translate("MeshQuality", title), choice)
        keep_choices(box)
        super().__init__(option, box)
        box.currentIndexChanged.connect(self._changed)

    def read(self):
        return self.widget.itemData(self.widget.currentIndex())

    def write(self, value):
        self.widget.setCurrentIndex(self.option.choices.index(value))


class _Switch(_Field):
    def __init__(self, option):
        super().__init__(option, QtGui.QCheckBox(translate("MeshQuality", option.title)))
        self.widget.toggled.connect(self._changed)

    def read(self):
        return self.widget.isChecked()

    def write(self, value):
        self.widget.setChecked(value)


class _DecimalBox(QtGui.QDoubleSpinBox):
    """Without zeros at the end."""

    def textFromValue(self, value):
        """Called by Qt."""
        text = super().textFromValue(value)
        point = self.locale().decimalPoint()
        return text.rstrip("0").rstrip(point) if point in text else text


def _number_box(option):
    whole = option.kind is int
    box = QtGui.QSpinBox() if whole else _DecimalBox()
    if not whole:
        box.setDecimals(6)
        box.setSingleStep(0.001)
    low = 0 if option.default is None or option.is_distance else option.low or 0
    box.setRange(low, _LARGEST if option.high is None else option.high)
    return box


class _Number(_Field):
    def __init__(self, option):
        box = _number_box(option)
        if option.default is None:
            box.setSpecialValueText(translate("MeshQuality", option.unset))
            _keep_wide(box, box.fontMetrics().horizontalAdvance(box.specialValueText()))
        super().__init__(option, box)
        box.valueChanged.connect(self._changed)

    def read(self):
        return self._of(self.widget.value())

    def write(self, value):
        self.widget.setValue(0 if value is None else value)


class _Quantity(_Field):
    """A number with a unit."""

    def __init__(self, option):
        super().__init__(option, QuantityBox(option.unit, signed=option.low is None))
        self.widget.setMinimumWidth(_NUMBER)
        _keep_wide(self.widget, self.widget.fontMetrics().horizontalAdvance(_LENGTH))
        self.widget.valueChanged.connect(self._changed)

    def read(self):
        return self._of(self.widget.value())

    def write(self, value):
        self.widget.setValue(value or 0.0)


class _Distance(_Field):
    """The bound on the distance: a choice, and the field of what is chosen."""

    def __init__(self, pair, size):
        """`size` gives the largest dimension of the shape in mm, 0 where that is unknown."""
        self._pair, self._size = pair, size
        widget = QtGui.QWidget()
        row = QtGui.QHBoxLayout(widget)
        row.setContentsMargins(0, 0, 0, 0)
        self.choice = QtGui.QComboBox()
        for bound, title in ((options.RELATIVE, translate("MeshQuality", "Relative")),
                             (options.ABSOLUTE, translate("MeshQuality", "Absolute")),
                             (options.UNBOUNDED, translate("MeshQuality", "No limit"))):
            self.choice.addItem(title, bound)
        self.choice.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToContents)
        self.length, self.fraction = QuantityBox("mm"), _number_box(pair[1])
        for box in (self.choice, self.length, self.fraction):
            row.addWidget(box)
        for box, widest in ((self.length, _LENGTH), (self.fraction, "0.0003")):
            box.setMinimumWidth(box.fontMetrics().boundingRect(widest).width() + _ARROW)
        self._bound = None
        super().__init__(pair[0], widget)
        self.names = tuple(option.name for option in pair)
        self.length.setToolTip(translate("MeshQuality", pair[0].help))
        self.fraction.setToolTip(translate("MeshQuality", pair[1].help))
        self.choice.currentIndexChanged.connect(self._chosen)
        self.length.valueChanged.connect(self._changed)
        self.fraction.valueChanged.connect(self._changed)

    def read(self):
        bound = self.choice.itemData(self.choice.currentIndex())
        return tuple(options.bound_from_properties(bound, {
            options.DISTANCE[0]: self.length.value(),
            options.DISTANCE[1]: self.fraction.value()}).values())

    def write(self, value):
        length, fraction = value or (None, None)
        if length is None and fraction is None:
            fraction = self._pair[1].default
        bound = options.bound_of(dict(zip(options.DISTANCE, (length, fraction))))
        if bound == options.ABSOLUTE:
            self.length.setValue(length)
        elif bound == options.RELATIVE:
            self.fraction.setValue(fraction)
        self._show_box(bound)  # before the choice, which would convert the value of the one before
        self.choice.setCurrentIndex(self.choice.findData(bound))

    def values(self):
        return dict(zip(options.DISTANCE, self.value() or self.read()))

    def show(self, values):
        self.set_value(tuple(values.get(name) for name in options.DISTANCE))

    def _chosen(self):
        """Called when the user has chosen how to give the bound: the other field begins with the same bound."""
        before, bound = self._bound, self.choice.itemData(self.choice.currentIndex())
        same = distance_bound.same_bound(
            bound, self.length.value() if before == options.ABSOLUTE else 0.0,
            self.fraction.value() if before == options.RELATIVE else 0.0, self._size())
        if same is not None:
            (self.length if bound == options.ABSOLUTE else self.fraction).setValue(same)
        self._show_box(bound)
        self._changed()

    def _show_box(self, bound):
        self._bound = bound
        # The panel may be 260 pixels wide: no more than this choice needs.
        text = self.choice.itemText(self.choice.findData(bound))
        metrics = self.choice.fontMetrics()
        widest = max(metrics.horizontalAdvance(self.choice.itemText(i)) for i in range(self.choice.count()))
        beside = max(self.choice.sizeHint().width() - widest, _ARROW)  # style sheets have wider boxes
        self.choice.setFixedWidth(metrics.horizontalAdvance(text) + beside)
        self.length.setVisible(bound == options.ABSOLUTE)
        self.fraction.setVisible(bound == options.RELATIVE)


class _SubElements(_Field):
    """Names of sub-elements as text, with a button that adds what is selected in the 3D view. A subclass has add(names),
    which adds those that fit; and these texts:

    hint     what stands in the empty field
    tip      what the button says
    for_one  why it adds nothing where the panel is for several objects
    nothing  what to select first, with a place for the label of the object
    """

    def __init__(self, option, sources):
        self._sources = sources
        box = QtGui.QWidget()
        rows = QtGui.QVBoxLayout(box)
        rows.setContentsMargins(0, 0, 0, 0)
        row = QtGui.QHBoxLayout()
        rows.addLayout(row)
        self.text, self.button, self.refusal = QtGui.QLineEdit(), QtGui.QToolButton(), QtGui.QLabel()
        self.text.setPlaceholderText(self.hint)
        self.text.setMinimumWidth(_WIDE)
        _keep_wide(self.text, _WIDE)
        self.button.setText("+")
        self.button.setToolTip(self.tip)
        row.addWidget(self.text)
        row.addWidget(self.button)
        self.refusal.setWordWrap(True)
        rows.addWidget(self.refusal)
        self._refuse("")
        super().__init__(option, box)
        self.text.editingFinished.connect(self._changed)
        self.button.clicked.connect(self._add_selected)

    def _add_selected(self):
        if len(self._sources) != 1:
            self._refuse(self.for_one)
            return
        source = self._sources[0]
        label = frames.leaf_of(source).Label
        try:
            names, others = picked(source)
            names = self.add(names)
        except Error as error:
            self._refuse(translated(error))
            return
        self._changed()
        if others:
            self._refuse(translate("MeshQuality", "Not added: {0} is not part of {1}.").format(
                ", ".join(others), label))
        elif not names:
            self._refuse(self.nothing.format(label))

    def _changed(self, *_):
        self._refuse("")
        super()._changed()

    def _refuse(self, text):
        self.refusal.setText(text)
        self.refusal.setVisible(bool(text))


class _SizeFields(_Field):
    """The table of size regions."""

    below = True

    def __init__(self, option, sources):
        super().__init__(option, SizeFieldsBox(sources))
        self.widget.changed.connect(self._changed)

    def read(self):
        return self.widget.names() or None

    def write(self, value):
        self.widget.fill(value or ())


class _Faces(_SubElements):
    """Names of faces."""

    def __init__(self, option, sources):
        self.hint = "Face3, Face7"
        self.tip = translate("MeshQuality", "Add the faces that are selected in the 3D view")
        self.for_one = translate("MeshQuality", "Faces are chosen of one object: open the panel for that object alone.")
        self.nothing = translate("MeshQuality", "Select faces of {} in the 3D view first.")
        super().__init__(option, sources)

    def read(self):
        return element_names.names_of_text(self.text.text()) or None

    def write(self, value):
        self.text.setText(", ".join(value or []))

    def add(self, names):
        """Adds the names that the field does not have yet."""
        names = element_names.faces_of(names)
        self.write(list(dict.fromkeys([*(self.read() or []), *names])))
        return names


class _Sizes(_SubElements):
    """Lengths by sub-elements. The text shows the user's units, and takes any; a number without one is in the user's.
    """

    def __init__(self, option, sources):
        self._exact = {}  # lengths as they were shown, and the numbers of mm that they stand for
        self.hint = f"Face3={length_text(0.5)}"
        self.tip = translate("MeshQuality", "Add the faces, edges and vertices that are selected in the 3D view")
        self.for_one = translate("MeshQuality", "Local sizes are for one object: open the panel for that object alone.")
        self.nothing = translate("MeshQuality", "Select faces, edges or vertices of {} in the 3D view first.")
        super().__init__(option, sources)

    def read(self):
        # In mm; whether it makes sense is said when it is used.
        return ", ".join(map(self._in_millimetres, self._parts())) or None

    def write(self, value):
        pairs = element_names.sizes_of_text(value if isinstance(value, str) else element_names.text_of_sizes(value))
        self.text.setText(", ".join(self._in_units(name.strip(), length) for name, length in pairs))

    def _parts(self):
        """The text for each sub-element."""
        return [part for part in (part.strip(" ,;") for part in _BETWEEN_SIZES.split(self.text.text())) if part]

    def _in_units(self, name, length):
        """A pair of element_names.sizes_of_text in the user's unit; as it is where that is no length."""
        try:
            text = text_of(float(length))
        except (TypeError, ValueError):
            return name if length is None else f"{name}={length}"
        self._exact[text] = length
        return f"{name}={text}"

    def _in_millimetres(self, part):
        """The inverse of _in_units."""
        name, equals, text = (piece.strip() for piece in part.partition("="))
        if text in self._exact:
            return f"{name}={self._exact[text]}"
        length = value_of(text)
        return f"{name}{equals}{text}" if length is None else element_names.text_of_sizes({name: length})

    def add(self, names):
        """Sub-elements that have no size get a hundredth of the part's diagonal."""
        size = convert.shape_of(self._sources[0]).BoundBox.DiagonalLength / 100
        written = self._parts()
        for name in names:
            if not any(part.split("=")[0].strip() == name for part in written):
                written.append(f"{name}={length_text(size)}")
        if names:
            self.text.setText(", ".join(written))
        return names
