# SPDX-License-Identifier: LGPL-2.1-or-later
"""I-DEAS universal files: nodes, elements and permanent groups."""

import functools
import re

import numpy as np

from ...errors import IoError
from ..elements import kinds
from ..elements.parts import REMEDY, Parts, Section, content, count_within, equal_rows, numbers_in, unsupported, whole, words_of

_NODES, _ELEMENTS = (b"2411", b"781"), (b"2412", b"780")
# How many numbers each dataset of groups has for a member: its type, its number, and two unused ones.
_GROUPS = {b"2467": 4, b"2477": 4, b"2452": 4, b"2435": 4, b"2432": 2, b"2430": 2, b"2429": 2}
_ELEMENT = 8
_BEAMS = {11, 21, 22, 23, 24, 31, 32}
_WITH_RECORD = {11, 21, 22, 23, 24}  # a line of three numbers, of orientation and section
# Around the element: corners and the middles between them in turn, level by level.
AROUND = {
    ("line", 3): (0, (0, 1), 1),
    ("triangle", 6): (0, (0, 1), 1, (1, 2), 2, (2, 0)),
    ("quadrilateral", 8): (0, (0, 1), 1, (1, 2), 2, (2, 3), 3, (3, 0)),
    ("tetrahedron", 10): (0, (0, 1), 1, (1, 2), 2, (2, 0), (0, 3), (1, 3), (2, 3), 3),
    ("pyramid", 13): (0, (0, 1), 1, (1, 2), 2, (2, 3), 3, (3, 0), (0, 4), (1, 4), (2, 4), (3, 4), 4),
    ("prism", 15): (0, (0, 1), 1, (1, 2), 2, (2, 0), (0, 3), (1, 4), (2, 5), 3, (3, 4), 4, (4, 5), 5, (5, 3)),
    ("hexahedron", 20): (0, (0, 1), 1, (1, 2), 2, (2, 3), 3, (3, 0), (0, 4), (1, 5), (2, 6), (3, 7),
                         4, (4, 5), 5, (5, 6), 6, (6, 7), 7, (7, 4)),
}


@functools.lru_cache(maxsize=None)
def order_of(kind, count):
    """The indices that bring nodes into Gmsh's order."""
    if (kind, count) not in AROUND:
        return np.arange(count)
    places = kinds.places(kind, count)
    wanted = [places[part] if isinstance(part, int) else places[list(part)].mean(axis=0) for part in AROUND[kind, count]]
    return np.argsort(kinds.matching(kind, count, np.array(wanted)))


def read(path):
    """The Parts of a file."""
    data = content(path).replace(b"\r", b"")
    marks = [(found.start(), found.end()) for found in re.finditer(rb"^[ \t]*-1[ \t]*$\n?", data, re.M)]
    if not marks:
        raise IoError("it has no lines of -1, which universal files have around each dataset: it is none")
    points, parts, known = [], Parts(None, []), False
    at = 0
    while at + 1 < len(marks):
        number, _, body = data[marks[at][1]:marks[at + 1][0]].partition(b"\n")
        number, at = number.strip(), at + 2
        if number in _NODES:
            points.append(_nodes(body))
        elif number in _ELEMENTS:
            known = True
            parts.sections += _elements(body)
        elif number in _GROUPS:
            _groups(parts, body, _GROUPS[number])
    if at < len(marks):
        raise IoError(f"its last dataset has no end: it is cut off; {REMEDY}")
    if not points or not known:
        raise IoError("it has no datasets of nodes (2411) and elements (2412): write the mesh into it")
    points = np.concatenate(points)
    parts.point_numbers, parts.points = whole(points[:, 0]), points[:, 4:]
    return parts


def _nodes(body):
    values = numbers_in(body.replace(b"D", b"E"))
    if len(values) % 7:
        raise IoError(f"its nodes are not complete: {REMEDY}")
    return values.reshape(-1, 7)


def _elements(body):
    values, at, found = whole(numbers_in(body)), 0, []
    while at < len(values):
        if len(values) < at + 6:
            raise IoError(f"its elements end within one: it is cut off; {REMEDY}")
        descriptor, count = int(values[at + 1]), int(values[at + 5])
        kind = _kind(descriptor, count)
        head = 9 if descriptor in _WITH_RECORD else 6
        rows = equal_rows(values[at:], head + count, (len(values) - at) // (head + count), [1, 5])
        found.append(Section(kind, rows[:, head:][:, order_of(kind, count)], rows[:, 0]))
        at += rows.size
    return found


def _kind(descriptor, count):
    known = {2: "line", 3: "line"} if descriptor in _BEAMS else kinds.FLAT_OF if 40 <= descriptor < 100 else kinds.SOLID_OF
    if count not in known or descriptor < 0:
        raise unsupported(f"elements of type {descriptor} with {count} nodes")
    return known[count]


def _groups(parts, body, width):
    lines = body.split(b"\n")
    at = 0
    while at + 1 < len(lines) and lines[at].strip():
        head = whole(numbers_in(lines[at]))
        count = count_within(head[-1] if len(head) else -1, len(body), "members of a group")
        name = words_of(lines[at + 1]) or f"group {int(head[0])}"
        rows = -(-count * width // 8)
        values = whole(numbers_in(b" ".join(lines[at + 2:at + 2 + rows])))
        if len(values) < count * width:
            raise IoError(f"group {name!r} lacks members that it announces: it is cut off; {REMEDY}")
        members = values[:count * width].reshape(count, width)
        parts.add_to_group(name, members[members[:, 0] == _ELEMENT, 1])
        at += 2 + rows
