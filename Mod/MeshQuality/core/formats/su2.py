# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of SU2: https://su2code.github.io/docs_v7/Mesh-File/"""

import re

import numpy as np

from ...errors import IoError
from ..elements import kinds
from ..elements.parts import REMEDY, Parts, content, count_within, equal_rows, numbers_in, unsupported, whole, words_of
from .vtk_cells import CELLS

# VTK's numbers, with how many nodes.
_TYPES = {number: (kind, count) for number, (kind, count) in CELLS.items() if count}


def read(path):
    """The Parts of a file."""
    data = re.sub(rb"%.*", b"", content(path).replace(b"\r", b""))
    entries = list(re.finditer(rb"^[ \t]*([A-Z_]+)[ \t]*=[ \t]*(.*)$", data, re.M))
    parts, dimension, marker = Parts(None, []), None, None
    markers, announced = 0, None
    for entry, end in zip(entries, [*(entry.start() for entry in entries[1:]), len(data)]):
        name, value, body = entry[1], entry[2].strip(), data[entry.end():end]
        if name == b"NDIME":
            dimension = int(value)
        elif name == b"NZONE" and int(value) != 1:
            raise unsupported("several zones")
        elif name == b"NPOIN":
            parts.points = _points(int(value.split()[0]), body, dimension)
        elif name == b"MARKER_TAG":
            marker = words_of(value)
            markers += 1
        elif name == b"NMARK":
            announced = int(value.split()[0])
        elif name in (b"NELEM", b"MARKER_ELEMS"):
            for kind, nodes in _elements(int(value.split()[0]), body):
                numbers = parts.add(kind, nodes)
                if name == b"MARKER_ELEMS":
                    parts.add_to_group(marker or "marker", numbers)
    if dimension not in (2, 3) or parts.points is None:
        raise IoError("it has no NDIME= or no NPOIN=: it is cut off, or no mesh of SU2")
    if announced not in (None, markers):
        raise IoError(f"it announces {announced:,} markers and has {markers:,}: it is cut off or damaged; {REMEDY}")
    return parts


def _points(count, body, dimension):
    values = numbers_in(body)
    count_within(count, len(values), "nodes")
    width = len(values) // count if count else 0
    if not count or width * count != len(values) or dimension is None or not dimension <= width <= dimension + 3:
        raise IoError(f"NPOIN= {count} does not fit the {len(values):,} numbers below it: {REMEDY}")
    return values.reshape(count, width)[:, :dimension]


def _elements(count, body):
    """(kind, nodes) of each run of elements of one type; a number of the element may stand behind its nodes."""
    values = whole(numbers_in(body))
    count_within(count, len(values), "elements")
    numbered = bool(count) and len(body.strip().partition(b"\n")[0].split()) - 1 > _nodes(int(values[0]))
    at = 0
    while count > 0:
        if at >= len(values):
            raise IoError(f"{count:,} elements are missing that it announces: it is cut off; {REMEDY}")
        nodes = _nodes(int(values[at]))
        width, kind = 1 + nodes + numbered, _TYPES[int(values[at])][0]
        rows = equal_rows(values[at:], width, min(count, (len(values) - at) // width), slice(0, 1))
        yield kind, rows[:, 1:1 + nodes][:, kinds.from_convention(kind, nodes, kinds.RINGS)]
        at, count = at + rows.size, count - len(rows)


def _nodes(number):
    if number not in _TYPES:
        raise unsupported(f"elements of type {number}")
    return _TYPES[number][1]
