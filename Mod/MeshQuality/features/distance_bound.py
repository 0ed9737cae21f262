# SPDX-License-Identifier: LGPL-2.1-or-later
"""The bound on the distance in the property editor: the choice DistanceBound and one value of it.

Of ChordHeight and ChordHeightRelative the one that is not chosen is 0, hidden and without effect, so
that the two cannot contradict each other. A script, or a document of an older version, that sets one of
them chooses it by that.
"""

from contextlib import contextmanager

from .. import options
from ..compat import property_of
from ..core.sources import convert

PROPERTY = "DistanceBound"
_VALUES = {options.ABSOLUTE: "ChordHeight", options.RELATIVE: "ChordHeightRelative"}
_DIGITS = 3  # digits of a bound that is converted from the other option

_choosing = set()  # (document, object) whose bound is being chosen


def add(obj, table):
    """Adds the choice to an object that has the two values. An object of an older version gets the
    choice that its values imply.
    """
    if PROPERTY not in obj.PropertiesList:
        option = next(option for option in table if option.name == options.DISTANCE[0])
        given = [bound for bound, name in _VALUES.items() if _number(obj, name)]
        with _while_choosing(obj):
            obj.addProperty("App::PropertyEnumeration", PROPERTY, option.group,
                            "How the max. deviation from the shape is given: relative to its size, as a "
                            "length, or not at all")
            obj.DistanceBound = list(options.BOUNDS)
            _choose(obj, given[0] if given else obj.Proxy.BOUND_BEFORE)
    _show_chosen(obj)


def follow_change(proxy, obj, name):
    """Makes the choice and its values consistent once one of them has changed."""
    if PROPERTY not in obj.PropertiesList or name not in (PROPERTY, *_VALUES.values()):
        return
    document = obj.Document
    # What is read from a file, undone or redone is consistent.
    if (document.Name, obj.Name) in _choosing:
        return
    if not (document.Restoring or document.Transacting):
        with _while_choosing(obj):
            _choose(obj, _bound_after(obj, name), lambda: convert.size_of(proxy.sources(obj)[0]))
    _show_chosen(obj)


@contextmanager
def _while_choosing(obj):
    key = obj.Document.Name, obj.Name
    _choosing.add(key)
    try:
        yield
    finally:
        _choosing.discard(key)


def _bound_after(obj, name):
    """The choice once this property has changed: the value 0 stands for no bound, as in older versions."""
    if name == PROPERTY:
        return obj.DistanceBound
    bound = next(bound for bound, value in _VALUES.items() if value == name)
    if _number(obj, name):
        return bound
    return options.UNBOUNDED if obj.DistanceBound == bound else obj.DistanceBound


def _choose(obj, bound, size=lambda: 0.0):
    """Makes the choice, gives its value, and takes the other one away."""
    chosen = _VALUES.get(bound)
    if chosen and not _number(obj, chosen):
        setattr(obj, chosen, _same_as_before(obj, bound, size()))
    for name in _VALUES.values():
        if name != chosen and _number(obj, name):
            setattr(obj, name, 0)
    if obj.DistanceBound != bound:
        obj.DistanceBound = bound


def same_bound(bound, length, relative, size):
    """A value of the chosen kind, as near to the bound that there was as three digits allow: a length in
    mm for ABSOLUTE, a fraction of the size for RELATIVE. None where no value of the other kind was given, or
    the size is not known.

    length    mm, 0: not given
    relative  fraction of the size, 0: not given
    size      largest dimension of the shape in mm, 0: unknown
    """
    if bound == options.ABSOLUTE and relative and size:
        return _rounded(relative * size)
    if bound == options.RELATIVE and length and size:
        return min(_rounded(length / size), 1.0)
    return None


def _same_as_before(obj, bound, size):
    """same_bound() for the properties of an object, with the default where no value was given."""
    default = next(option.default for option in obj.Proxy.OPTIONS
                   if option.name == options.DISTANCE[1])
    relative = max(_number(obj, "ChordHeightRelative"), 0.0) or default
    same = same_bound(bound, _number(obj, "ChordHeight"), relative, size)
    if same is None:
        return default if bound == options.RELATIVE else 0.0
    return same


def _rounded(number):
    return float(f"{number:.{_DIGITS}g}")


def _show_chosen(obj):
    """Hides the value that is not chosen."""
    for bound, name in _VALUES.items():
        mode = [] if obj.DistanceBound == bound else ["Hidden"]
        if obj.getEditorMode(name) != mode:
            obj.setEditorMode(name, mode)


def _number(obj, name):
    value = property_of(obj, name)
    return getattr(value, "Value", value)
