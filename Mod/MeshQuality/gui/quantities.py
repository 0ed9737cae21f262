# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths and angles as the user writes them, and a field for them that loses no digit.

A field has a text in the manner of FreeCAD, such as 3' 1/2", which it can be set to. What is only read is a
decimal number, so that lengths beside each other can be compared; angles then are in degrees in every unit
system. The decimal point is that of the user's locale in both.

Gui::QuantitySpinBox holds what its text says, rounded to the decimals of the preferences or to a
fraction of an inch: showing a value there would change it.
"""

import math
import re
from dataclasses import dataclass
from decimal import Decimal

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

_UNITS = {"mm": FreeCAD.Units.Length, "degrees": FreeCAD.Units.Angle}
_NAMES = {'"': "in", "'": "ft"}  # signs of FreeCAD that are hard to read after a number
_PLAIN = 10.0  # mm or degrees, which the user writes in the unit of numbers without one
_LARGEST = 1e12
_DECIMALS = 17  # decimals to which a QDoubleSpinBox rounds its value: all digits of a number
_DIGITS = 3  # that a length has at least
_ALL_DIGITS = 17  # that tell any two numbers apart
_TIE = 1.0 + 1e-9  # half a unit of the last digit, but for rounding


@dataclass(frozen=True)
class Unit:
    """A unit of lengths or angles: how many mm or degrees it has, and its name."""

    factor: float
    name: str

    @classmethod
    def of(cls, value, unit="mm"):
        """The unit in which FreeCAD shows a value given in mm or degrees, such as µm, mm or thou."""
        quantity = FreeCAD.Units.Quantity(value if value else _PLAIN, _UNITS[unit])
        _, factor, name = quantity.getUserPreferred()
        return cls(factor, _NAMES.get(name, name))

    def number(self, value, digits):
        """The value in this unit: the number with the fewest digits that says as many digits of it."""
        return _shortest(value, self.factor, digits)

    def rounded(self, value, digits):
        """The value in mm or degrees that has these many digits in this unit and is nearest to it."""
        number = float(f"{value / self.factor:.{digits}g}")
        return number if self.factor == 1.0 else float(f"{number * self.factor:.{_ALL_DIGITS - 2}g}")

    def written(self, number):
        """A number with the unit behind it, as the user writes it."""
        return f"{in_locale(_positional(number))} {self.name}"


def in_locale(text):
    """An English number such as "1,203.5" as the user writes it."""
    locale = QtCore.QLocale()
    return text.translate({ord("."): locale.decimalPoint(), ord(","): _group_separator(locale)})


def _group_separator(locale):
    """The separator of thousands. FreeCAD may write numbers in another manner than the user's language does: 9,084 would be
    nine there, and a narrow blank is none of a decimal point.
    """
    language = FreeCADGui.getLocale()
    fits = language in ("C", "English", QtCore.QLocale.languageToString(locale.language()))
    return locale.groupSeparator() if fits else "\u202f"


def count_text(count):
    """A whole number as the user writes it."""
    return in_locale(f"{count:,}")


def lengths_in_units(texts):
    """Texts such as ["0.0171 mm", "0.01 mm"] in the user's unit, the one that fits the longest of them.
    They keep their digits: three at least, and as many as tell them apart.
    """
    given = [text.split()[0] for text in texts]
    values = [float(number) for number in given]
    unit = Unit.of(max(filter(math.isfinite, map(abs, values)), default=0.0))
    for more in range(_ALL_DIGITS):
        numbers = [unit.number(value, _digits_of(text) + more) for value, text in zip(values, given)]
        if _same_order(numbers, values):
            break
    return [unit.written(number) for number in numbers]


def volume_in_unit(text):
    """A text such as "511.2 mm³" in the user's unit, to four digits."""
    value = float(text.split()[0])
    _, factor, name = FreeCAD.Units.Quantity(value, FreeCAD.Units.Volume).getUserPreferred()
    number = in_locale(_positional(float(f"{value / factor:.4g}")))
    return f"{number} {name.replace('^3', '³')}"


def length_text(value):
    """A length in mm, to three digits, in the user's unit."""
    unit = Unit.of(value)
    return unit.written(unit.number(value, _DIGITS))


def _digits_of(number):
    """How many digits a number such as "0.0171" or "1.5e-05" has that tell something, three at least."""
    return max(len(re.sub(r"e.*|\D", "", number).lstrip("0")), _DIGITS)


def _shortest(value, factor, digits):
    """The number of factors with the fewest digits that gives the value to the requested digits."""
    if value == 0.0 or not math.isfinite(value):
        return value
    half = 0.5 * _TIE * 10.0 ** (math.floor(math.log10(abs(value))) - digits + 1)
    numbers = (float(f"{value / factor:.{fewest}g}") for fewest in range(1, _ALL_DIGITS + 1))
    return next((number for number in numbers if abs(number * factor - value) <= half), value / factor)


def _same_order(numbers, values):
    """Whether one number is greater than another where its value is."""
    first, second = ([[one > other for other in each] for one in each] for each in (numbers, values))
    return first == second


def _positional(number):
    """The fewest digits that tell a number from all others, without an exponent. NumPy, which does this, too, would be
    loaded with every start of FreeCAD.
    """
    text = f"{Decimal(repr(float(number))):f}" if math.isfinite(number) else str(number)
    return text.rstrip("0").rstrip(".") if "." in text else text


def text_of(value, unit="mm", digits=6):
    """A length in mm or an angle in degrees as FreeCAD writes it; where that says less than `digits`
    significant digits of it, as a decimal number.
    """
    text = FreeCAD.Units.Quantity(value, _UNITS[unit]).UserString
    found = value_of(text, unit)
    if found is not None and math.isclose(found, value, rel_tol=0.5 * 10 ** -(digits - 1)):
        return text
    plain = _plain(unit)
    return plain.written(float(f"{value / plain.factor:.{digits}g}"))


def value_of(text, unit="mm"):
    """The mm or degrees of a text such as "1/8 in", "=2*0.1 mm" or "0.5", which is in the user's unit;
    None where it says none.
    """
    text = text.strip().lstrip("=")
    locale = QtCore.QLocale()
    if locale.decimalPoint() in text and locale.decimalPoint() != ".":
        text = text.replace(locale.groupSeparator(), "").replace(locale.decimalPoint(), ".")
    try:
        quantity = FreeCAD.Units.Quantity(text) if text else None
    except (ValueError, OverflowError, RuntimeError):
        return None
    if quantity is None or not math.isfinite(quantity.Value):
        return None
    if quantity.Unit == FreeCAD.Units.Unit():
        return quantity.Value * _plain(unit).factor
    return quantity.Value if quantity.Unit == _UNITS[unit] else None


def number_of(text):
    """The finite number of a text as the user writes it, or as "0.5"; None where it is none."""
    locale = QtCore.QLocale()
    if locale.decimalPoint() in text:
        text = text.replace(locale.groupSeparator(), "").replace(locale.decimalPoint(), ".")
    try:
        found = float(text)
    except ValueError:
        return None
    return found if math.isfinite(found) else None


def _plain(unit):
    """The Unit in which the user writes a number without one."""
    return Unit.of(_PLAIN, unit)


class QuantityBox(QtGui.QDoubleSpinBox):
    """A spin box for a value in mm or degrees. What was set is kept in full, however it is shown."""

    def __init__(self, unit, signed=False):
        """`signed`: whether it takes values below 0, too."""
        self._unit = unit
        self._exact = ("", 0.0)  # a text that was shown, and what it stands for
        super().__init__()
        # Parts of what is being typed are values, too ("1 m" of "1 mm"): only what is finished counts, and what
        # says no length leaves the value as it was.
        self.setKeyboardTracking(False)
        self.setDecimals(_DECIMALS)
        self.setRange(-_LARGEST if signed else 0.0, _LARGEST)
        self.setMinimumWidth(60)
        self.setSizePolicy(QtGui.QSizePolicy.Expanding, QtGui.QSizePolicy.Fixed)

    def setValue(self, value):
        """Shows a value in mm or degrees, and keeps all of its digits."""
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
        factor = _plain(self._unit).factor
        now = self.value() / factor
        step = 10.0 ** math.floor(math.log10(abs(now))) if now else 1.0
        if steps * now < 0.0 and math.isclose(abs(now), step):
            step /= 10.0
        self.setValue(max(round(now / step + steps) * step * factor, self.minimum()))
        self.selectAll()

    def minimumSizeHint(self):
        """Not as wide as the largest value needs."""
        return QtCore.QSize(self.minimumWidth(), super().minimumSizeHint().height())

    def sizeHint(self):
        """Likewise."""
        width = self.fontMetrics().boundingRect("0.0019685 in").width()
        return QtCore.QSize(width + 30, super().sizeHint().height())
