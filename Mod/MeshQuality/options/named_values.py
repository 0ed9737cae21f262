# SPDX-License-Identifier: LGPL-2.1-or-later
"""Values of options that name things: sub-elements with sizes, faces, and what gives size fields. Imports nothing of FreeCAD."""

import math

from .. import element_names, phrases
from ..errors import InvalidInput
from ..phrases import Text


def checked_sizes(value, option):
    """{sub-element: mm} of such a dict, or of its text."""
    sizes = element_names.sizes_of_text(value) if isinstance(value, str) else value
    try:
        found = {str(name): float(getattr(length, "Value", length))
                 for name, length in dict(sizes).items()}
    except (TypeError, ValueError, OverflowError):
        found = None
    if found is None or not all(element_names.is_name(name) and math.isfinite(length) and length > 0
                                for name, length in found.items()):
        raise InvalidInput(Text(phrases.NOT_ALLOWED, option=option.name, value=repr(value), range=option.range_text))
    return found or None


def checked_faces(value, option):
    """The names in such a list, each once."""
    if not isinstance(value, (list, tuple)) or not value or not all(map(element_names.is_face, value)):
        raise InvalidInput(Text(phrases.NOT_ALLOWED, option=option.name, value=repr(value), range=option.range_text))
    return list(dict.fromkeys(value))


def checked_fields(value, option):
    """The names in such a list, each once; one name may be given by itself."""
    names = [value] if isinstance(value, str) else value
    if not isinstance(names, (list, tuple)) or not all(isinstance(name, str) and name for name in names):
        raise InvalidInput(Text(phrases.NOT_ALLOWED, option=option.name, value=repr(value), range=option.range_text))
    return list(dict.fromkeys(names)) or None
