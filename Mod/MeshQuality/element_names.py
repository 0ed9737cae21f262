# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names of sub-elements of shapes, such as "Face3" or "Group.Box.Face6", and lengths by them. Imports nothing of FreeCAD."""

import re

_SUB_ELEMENT = re.compile(r"(Vertex|Edge|Face)([1-9]\d{0,8})")
# In containers and links behind the names of the objects on the way: "Group.Box.Face6".
_NAME = re.compile(rf"(?:\w+\.)*{_SUB_ELEMENT.pattern}")
_FACE = re.compile(r"(?:\w+\.)*Face[1-9]\d{0,8}")
_SIZE = re.compile(r"([\w.]+)\s*=\s*([^\s=]+)\s*(?:mm)?")


def is_name(text):
    """Whether it is the name of a face, an edge or a vertex."""
    return bool(_NAME.fullmatch(text))


def is_face(value):
    """Whether it is the name of a face."""
    return isinstance(value, str) and bool(_FACE.fullmatch(value))


def faces_of(names):
    """Those names that are of faces."""
    return [name for name in names if is_face(name)]


def names_of_text(text):
    """["Face3", "Face7"] of "Face3, Face7": what it says, not whether that makes sense."""
    return [name.strip() for name in re.split("[,;]", text) if name.strip()]


def sizes_of_text(text):
    """A list of pairs of "Face3=0.5 mm, Edge7=0.2": what it says, not whether that makes sense."""
    parts = [part for part in re.split("[,;]", text) if part.strip()]
    pairs = [_SIZE.fullmatch(part.strip()) for part in parts]
    return [pair.groups() if pair else (part, None) for pair, part in zip(pairs, parts)]


def text_of_sizes(sizes):
    """The text of {"Face3": 0.5}; `checked` makes the same of it."""
    return ", ".join(f"{name}={_shortest(length)}" for name, length in (sizes or {}).items())


def _shortest(number):
    return f"{number:g}" if float(f"{number:g}") == number else repr(number)


def entities_of(sizes):
    """[(dimension, index, mm), ...] of {"Face3": 0.5}, names without a path."""
    found = [(_SUB_ELEMENT.fullmatch(name), length) for name, length in (sizes or {}).items()]
    return [(("Vertex", "Edge", "Face").index(match[1]), int(match[2]) - 1, length)
            for match, length in found]
