# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths and angles as text in the user's units, and a field for them that loses no digit.

Gui::QuantitySpinBox holds what its text says, rounded to the decimals of the preferences or to a
fraction of an inch: showing a value there would change it.
"""

import math

import FreeCAD
from PySide import QtCore, QtGui

_UNITS = {"mm": FreeCAD.Units.Length, "degrees": FreeCAD.Units.Angle}
_LARGEST = 1e12
_DECIMALS = 17  # of what a QDoubleSpinBox rounds its value to


def text_of(value, unit="mm", digits=6):
    """A length in mm or an angle in degrees as FreeCAD writes it; where that says less than `digits`
    significant digits of it, as a decimal number.
    """
    quantity = FreeCAD.Units.Quantity(value, _UNITS[unit])
    text = quantity.UserString
    found = value_of(text, unit)
    if found is not None and math.isclose(found, value, rel_tol=0.5 * 10 ** -(digits - 1)):
        return text
    factor, name = _plain_unit(unit)
    locale = _locale()
    return f"{f'{value / factor:.{digits}g}'.replace('.', locale.decimalPoint())} {name}"


def value_of(text, unit="mm"):
    """The mm or degrees of a text such as "1/8 in", "=2*0.1 mm" or "0.5", which is in the user's unit;
    None where it says none.
    """
    text = text.strip().lstrip("=")
    locale = _locale()
    if locale.decimalPoint() in text and locale.decimalPoint() != ".":
        text = text.replace(locale.groupSeparator(), "").replace(locale.decimalPoint(), ".")
    try:
        quantity = FreeCAD.Units.Quantity(text) if text else None
    except (ValueError, OverflowError, RuntimeError):
        return None
    if quantity is None or not math.isfinite(quantity.Value):
        return None
    if quantity.Unit == FreeCAD.Units.Unit():
        return quantity.Value * _plain_unit(unit)[0]
    return quantity.Value if quantity.Unit == _UNITS[unit] else None


def _plain_unit(unit):
    """(mm or degrees in it, name) of the unit in which the user writes a number without one."""
    _, factor, name = FreeCAD.Units.Quantity(10.0, _UNITS[unit]).getUserPreferred()
    return factor, name


def _locale():
    return QtCore.QLocale()


class QuantityBox(QtGui.QDoubleSpinBox):
    """A spin box for a value in mm or degrees. What was set is kept in full, however it is shown."""

    def __init__(self, unit):
        self._unit = unit
        self._exact = ("", 0.0)  # a text that was shown, and what it stands for
        super().__init__()
        # Parts of what is being typed are values, too ("1 m" of "1 mm"): only what is finished counts, and what
        # says no length leaves the value as it was.
        self.setKeyboardTracking(False)
        self.setDecimals(_DECIMALS)
        self.setRange(0.0, _LARGEST)
        self.setMinimumWidth(60)
        self.setSizePolicy(QtGui.QSizePolicy.Expanding, QtGui.QSizePolicy.Fixed)

    def setValue(self, value):
        """Of QDoubleSpinBox."""
        self._exact = (text_of(value, self._unit), value)
        super().setValue(value)

    def textFromValue(self, value):
        """Called by Qt."""
        return text_of(value, self._unit)

    def valueFromText(self, text):
        """Called by Qt."""
        if text != self._exact[0]:
            found = value_of(text, self._unit)
            if found is None:
                return self._exact[1]
            self._exact = (text_of(found, self._unit), found)
        return self._exact[1]

    def validate(self, text, position):
        """Called by Qt."""
        found = self._exact[1] if text == self._exact[0] else value_of(text, self._unit)
        good = found is not None and self.minimum() <= found <= self.maximum()
        return (QtGui.QValidator.Acceptable if good else QtGui.QValidator.Intermediate), text, position

    def stepBy(self, steps):
        """Called by Qt: a tenth of the next smaller power of ten, in the user's unit."""
        factor, _ = _plain_unit(self._unit)
        now = self.value() / factor
        step = 10.0 ** math.floor(math.log10(now)) if now > 0.0 else 1.0
        if steps < 0 and math.isclose(now, step):
            step /= 10.0
        self.setValue(max(round(now / step + steps) * step, 0.0) * factor)
        self.selectAll()

    def minimumSizeHint(self):
        """Not as wide as the largest value needs."""
        return QtCore.QSize(self.minimumWidth(), super().minimumSizeHint().height())

    def sizeHint(self):
        """Likewise."""
        width = self.fontMetrics().boundingRect("0.0019685 in").width()
        return QtCore.QSize(width + 30, super().sizeHint().height())
