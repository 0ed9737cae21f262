# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options of document objects by the names of older versions.

An option with an alias has a second, hidden property of that name with the same value: documents of older
versions have it, and scripts may go on using it.
"""

from .. import options
from ..compat import property_of

_HIDDEN = 2  # hidden in the property editor


def first_value(obj, option):
    """What the property of an option begins with: the value that an object of an older version has by the
    older name, else the default.
    """
    if option.alias and option.alias_property_name in obj.PropertiesList:
        return property_of(obj, option.alias_property_name)
    return options.to_property(option, option.default)


def add(obj, table):
    """Adds the hidden properties, and gives choices of older versions their present names."""
    for option in table:
        name, alias = option.property_name, option.alias_property_name
        if option.alias:
            if alias not in obj.PropertiesList:
                obj.addProperty(option.property_type, alias, option.group, f"The older name of {name}")
            obj.setEditorMode(alias, _HIDDEN)
            _copy(obj, name, alias)
        if option.choice_aliases and obj.getEnumerationsOfProperty(name) != option.property_choices:
            chosen = property_of(obj, name)
            setattr(obj, name, option.property_choices)
            known = chosen if chosen in option.property_choices else option.default  # scripts may give other choices
            setattr(obj, name, option.choice_aliases.get(known, known))


def follow_change(table, obj, name):
    """Gives a property the value of its other name, and a choice its present name."""
    document = obj.Document
    # What is read from a file, undone or redone is consistent.
    if document.Restoring or document.Transacting:
        return
    for option in table:
        if option.alias and name == option.property_name:
            _copy(obj, name, option.alias_property_name)
        elif option.alias and name == option.alias_property_name:
            _copy(obj, name, option.property_name)
        elif option.choice_aliases and name == option.property_name \
                and property_of(obj, name) in option.choice_aliases:
            setattr(obj, name, option.choice_aliases[property_of(obj, name)])


def _copy(obj, name, other):
    """Gives the property `other` the value of the property `name`, where it is there."""
    if other not in obj.PropertiesList or name not in obj.PropertiesList:
        return
    value, there = property_of(obj, name), property_of(obj, other)
    both_nan = value != value and there != there
    if value != there and not both_nan:
        setattr(obj, other, value)
