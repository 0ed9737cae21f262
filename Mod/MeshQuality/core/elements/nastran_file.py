# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nastran bulk data: GRID and elements in fields of 8 or 16 characters, or with commas between."""

import re

import numpy as np

from ...errors import IoError
from . import kinds
from .parts import REMEDY, Parts, Section, content, unsupported, words_of

_SOLIDS = {b"CTETRA": (4, 10), b"CPYRAM": (5, 13), b"CPYRA": (5, 13), b"CPENTA": (6, 15), b"CHEXA": (8, 20)}
_KIND = {4: "tetrahedron", 10: "tetrahedron", 5: "pyramid", 13: "pyramid", 6: "prism", 15: "prism", 8: "hexahedron",
         20: "hexahedron"}
_OTHERS = {b"CTRIA3": ("triangle", 3), b"CTRIAR": ("triangle", 3), b"CTRIA6": ("triangle", 6), b"CQUAD4": ("quadrilateral", 4),
           b"CQUADR": ("quadrilateral", 4), b"CSHEAR": ("quadrilateral", 4), b"CQUAD8": ("quadrilateral", 8),
           b"CQUAD": ("quadrilateral", 9), b"CBAR": ("line", 2), b"CBEAM": ("line", 2), b"CROD": ("line", 2),
           b"CTUBE": ("line", 2)}
_UNKNOWN = re.compile(rb"C(?:TRI|QUAD|TETR|PENT|HEX|PYR)\w*")
_NAMES = (re.compile(rb"^\$ property +(\d+): (?:patch |solid )?(.+?) *$", re.M),
          re.compile(rb'^\$HMNAME (?:COMP|PROP) +(\d+) *"([^"\n]+)"', re.M))
_FLOAT = re.compile(rb"([\d.])([+-]\d+)$")  # an exponent without its letter


def read(path):
    """The Parts of a file."""
    data = content(path).replace(b"\r", b"")
    names = {int(found[1]): words_of(found[2]) for pattern in _NAMES for found in pattern.finditer(data)}
    start = re.search(rb"^[ \t]*BEGIN[ ,]+BULK.*$", data, re.M | re.I)
    ended = re.search(rb"^ENDDATA", data, re.M | re.I)
    if start and not ended:
        raise IoError(f"it has no ENDDATA: it is cut off; {REMEDY}")
    points, elements = [], {}
    for name, fields in _cards(data[start.end() if start else 0:ended.start() if ended else len(data)]):
        if name == b"GRID":
            if _blank_or_zero(fields, 1):
                points.append((fields[0], *(fields[2:5] + [b"0"] * 3)[:3]))
            else:
                raise unsupported("nodes in coordinate systems of their own (the third field of GRID)")
        elif name in _SOLIDS or name in _OTHERS:
            row = _element(name, fields)
            elements.setdefault(row[0], []).append(row[1])
        elif name == b"INCLUDE" or _UNKNOWN.fullmatch(name):
            raise unsupported(f"{words_of(name)} entries")
    if not points:
        raise IoError("it has no GRID entries: it is no mesh in Nastran bulk data")
    return _parts(points, elements, names)


def _cards(data):
    """(name, fields) of each entry, with those of its continuation lines."""
    name, fields = None, []
    for line in data.split(b"\n"):
        line = line.partition(b"$")[0].rstrip()
        if not line.strip():
            continue
        first, found = _fields(line)
        if first[:1] in (b"", b"+", b"*") and name is not None:
            fields += found
            continue
        if name is not None:
            yield name, fields
        name, fields = first.rstrip(b"*").upper(), found
    if name is not None:
        yield name, fields


def _fields(line):
    """(first field, the others but the last one of 10, of which a line has 8 or 4)."""
    if b"," in line:
        words = [word.strip() for word in line.split(b",")]
        wide = words[0].endswith(b"*")
        return words[0], (words[1:9] + [b""] * 8)[:4 if wide else 8]
    line = line.expandtabs(8)
    first = line[:8].strip()
    if first.endswith(b"*") or first[:1] == b"*":
        return first, [line[i:i + 16].strip() for i in (8, 24, 40, 56)]
    return first, [line[i:i + 8].strip() for i in range(8, 72, 8)]


def _blank_or_zero(fields, index):
    return len(fields) <= index or fields[index] in (b"", b"0")


def _element(name, fields):
    """((kind, nodes), [number, property, node, ...]) of an entry."""
    nodes = fields[2:]
    if name in _SOLIDS:
        full = [node for node in nodes if node]
        low, high = _SOLIDS[name]
        count = low if len(full) <= low else high
        kind = _KIND[count]
    else:
        kind, count = _OTHERS[name]
        full = nodes[:count]
        if kind == "quadrilateral" and count == 9 and not any(nodes[4:]):
            count, full = 4, nodes[:4]
    if len(full) != count or not all(full):
        there = sum(bool(node) for node in full)
        raise IoError(f"{words_of(name)} {words_of(fields[0])} has {there} nodes instead of {count}: elements with some "
                      "of their middle nodes cannot be read; give all or none")
    return (kind, count), [fields[0], fields[1] or fields[0], *full]


def _parts(points, elements, names):
    rows = np.array([_number(value) for point in points for value in point[1:]]).reshape(-1, 3)
    parts = Parts(rows, [], np.array([point[0] for point in points]).astype(np.int64))
    properties = {}
    for (kind, count), found in elements.items():
        table = np.array(found).astype(np.int64)
        nodes = table[:, 2:][:, kinds.from_convention(kind, count, kinds.LEVELS)]
        parts.sections.append(Section(kind, nodes, table[:, 0]))
        for number in np.unique(table[:, 1]).tolist():
            properties.setdefault(number, []).append(table[table[:, 1] == number, 0])
    for number, lists in sorted(properties.items()):
        parts.add_to_group(names.get(number, f"property {number}"), np.concatenate(lists))
    return parts


def _number(text):
    """A float as Nastran writes it: 1.5-3 is 0.0015, a blank 0."""
    if not text:
        return 0.0
    try:
        return float(text)
    except ValueError:
        return float(_FLOAT.sub(rb"\1e\2", text.upper().replace(b"D", b"E")))
