# SPDX-License-Identifier: LGPL-2.1-or-later
"""Odd numbers, and things that are nearly numbers, for every option of every function."""

import decimal
import fractions
import numbers

import numpy as np
import Part
from attack import Attack, Planted, survive

import FreeCAD
import MeshQuality as mq
from MeshQuality import options


class Raises:
    """Raises when it is taken for a number, looked at or compared."""

    def _raise(self, *_):
        raise Planted

    __float__ = __int__ = __index__ = __repr__ = __str__ = __lt__ = __le__ = __gt__ = __bool__ = _raise


class Unprintable:
    """Raises when it is named in a message."""

    def __repr__(self):
        raise Planted


class Fickle(float):
    """Another number each time that it is compared."""

    def __lt__(self, other):
        return True

    __le__ = __gt__ = __ge__ = __eq__ = __lt__
    __hash__ = float.__hash__


class NoReal:
    """Registered as a number, but none."""

    def __float__(self):
        raise ValueError("no number")


numbers.Real.register(NoReal)
numbers.Integral.register(NoReal)

ODD = {
    "a denormal": 5e-324, "-0.0": -0.0, "the smallest normal": 2.3e-308, "the largest": 1.79e308, "infinity": np.inf,
    "-infinity": -np.inf, "NaN": np.nan, "10**30": 10**30, "-(2**63)": -(2**63), "2**31": 2**31,
    "float16": np.float16(0.5), "float32": np.float32(0.1), "longdouble": np.longdouble("1e400"),
    "int8": np.int8(-3), "uint64": np.uint64(2**64 - 1), "numpy.bool_": np.bool_(True), "0-d array": np.array(0.5),
    "array of one": np.array([2]), "datetime64": np.datetime64("2026-01-01"), "complex64": np.complex64(1),
    "numpy.str_": np.str_("0.5"), "Decimal": decimal.Decimal("0.5"), "Decimal sNaN": decimal.Decimal("sNaN"),
    "Fraction": fractions.Fraction(1, 3), "tiny Fraction": fractions.Fraction(1, 10**400),
    "huge Fraction": fractions.Fraction(10**400), "raising": Raises(), "unprintable": Unprintable(),
    "fickle float": Fickle(0.5), "a number that is none": NoReal(), "a surrogate": "\ud800", "Arabic digits": "\u0663",
    "Quantity NaN": FreeCAD.Units.Quantity(float("nan"), "mm"), "Quantity kg": FreeCAD.Units.Quantity("1 kg"),
}
ODD_SIZES = {
    "none at all": {}, "NaN": {"Face1": np.nan}, "a denormal": {"Face1": 5e-324}, "True": {"Face1": True},
    "text": {"Face1": "0,5"}, "float32": {"Face1": np.float32(0.5)}, "raising": {"Face1": Raises()},
    "bytes": {b"Face1": 0.5}, "number": {1: 0.5}, "tuple": {("Face", 1): 0.5}, "Arabic digits": {"Face\u0661": 0.5},
    "fullwidth": {"\uff26ace1": 0.5}, "line": {"Face1\n": 0.5}, "NUL": {"Face1\0": 0.5}, "zero": {"Face01": 0.5},
    "twice": "Face1=1, Face1=0.5", "comma": "Face1=0,5", "huge text": "Face1=1," * 20000, "no name": "=1",
    "long name": {"A." * 50000 + "Face1": 1.0}, "itself": None, "a set": {"Face1"}, "pairs": [("Face1", 0.5)],
    "wedge": {"Edge1": 0.5, "Edge99": 0.5},
}
ODD_SIZES["itself"] = [ODD_SIZES]
FEW = {"max_triangles": 300}


def _calls():
    """{function: (call(option, value), its table)}."""
    box = Part.makeBox(1, 1, 1)
    mesh = mq.triangulate(box)
    curved = mq.curve(box)
    few = lambda name: {} if name == "max_triangles" else FEW  # noqa: E731
    sampled = lambda name: {} if name == "method" else {"method": "sprinkle"}  # noqa: E731
    operation = lambda name: {} if name == "operation" else {"operation": "union"}  # noqa: E731
    return {
        "triangulate": (lambda n, v: mq.triangulate(box, **{n: v}, **few(n)), options.TRIANGULATE),
        "sprinkle": (lambda n, v: mq.triangulate(box, **{n: v}, **sampled(n), **few(n)), options.TRIANGULATE[-4:]),
        "curve": (lambda n, v: mq.curve(box, **{n: v}), options.CURVE),
        "boolean": (lambda n, v: mq.boolean(mesh, mesh, **{n: v}, **operation(n)), options.BOOLEAN),
        "improve": (lambda n, v: mq.improve(mesh, **{n: v}), options.IMPROVE),
        "tessellate": (lambda n, v: curved.tessellate(**{n: v}), options.CURVED_DISPLAY),
    }


def rows():
    found = []
    for function, (call, table) in _calls().items():
        for option in table:
            for said, value in ODD.items():
                found.append(Attack(f"{function} {option.name}: {said}",
                                    lambda c=call, n=option.name, v=value: survive(lambda: c(n, v))))
    box = Part.makeBox(1, 1, 1)
    for said, sizes in ODD_SIZES.items():
        found.append(Attack(f"local_sizes: {said}",
                            lambda s=sizes: survive(lambda: mq.triangulate(box, local_sizes=s, **FEW))))
    return found


def combined(dice):
    """An attack of several odd options at a time."""
    call, table = dice.choice(list(_calls().values()))
    option = dice.choice(table)
    said, value = dice.choice(list(ODD.items()))
    return Attack(f"{option.name}: {said}", lambda: survive(lambda: call(option.name, value)))
