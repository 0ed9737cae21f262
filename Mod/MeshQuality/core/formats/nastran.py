# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nastran bulk data: GRID and elements in fields of 8 or 16 characters, or with commas between."""

import re

import numpy as np

from ...errors import IoError
from ..elements import kinds
from ..elements.parts import REMEDY, Parts, Section, content, unsupported, words_of
from . import nastran_table

_SOLIDS = {b"CTETRA": (4, 10), b"CPYRAM": (5, 13), b"CPYRA": (5, 13), b"CPENTA": (6, 15), b"CHEXA": (8, 20)}
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
    body = data[start.end() if start else 0:ended.start() if ended else len(data)]
    try:
        points, elements = _of_tables(nastran_table.tables_of(body))
    except (nastran_table.Unusual, ValueError):  # line by line, which names what is wrong
        points, elements = _of_lines(body)
    return _parts(points, elements, names)


def _of_tables(tables):
    """((numbers, places) of nodes, {(kind, nodes): rows of number, property and nodes}); raises Unusual."""
    points, elements = [], {}
    for name, fields in tables:
        if name == b"GRID":
            if fields.shape[1] < 5 or not np.isin(fields[:, 1], list(b" 0")).all():
                raise nastran_table.Unusual
            points.append((nastran_table.whole_of(fields[:, 0]), nastran_table.floats_of(fields[:, 2:5], _number)))
        elif name in _SOLIDS or name in _OTHERS:
            for key, rows in _rows_of(name, fields):
                elements.setdefault(key, []).append(rows)
        elif name == b"INCLUDE" or _UNKNOWN.fullmatch(name):
            raise nastran_table.Unusual
    if not points:
        raise nastran_table.Unusual
    points = tuple(np.concatenate(part) for part in zip(*points))
    return points, {key: np.concatenate(parts) for key, parts in elements.items()}


def _rows_of(name, fields):
    """[((kind, nodes), rows), ...] of the elements of a table."""
    empty = nastran_table.blank(fields)
    if name == b"CQUAD" or empty[:, 0].any():
        raise nastran_table.Unusual
    there = (~empty[:, 2:]).sum(axis=1)
    counts = [(low, there <= low) if k == 0 else (high, there > low) for low, high in [_SOLIDS[name]] for k in (0, 1)] \
        if name in _SOLIDS else [(_OTHERS[name][1], np.ones(len(fields), dtype=bool))]
    found = []
    for count, which in counts:
        if not which.any():
            continue
        if fields.shape[1] < 2 + count or empty[which, 2:2 + count].any() or name in _SOLIDS and (there[which] != count).any():
            raise nastran_table.Unusual
        mine = fields[which, :2 + count]
        mine[empty[which, 1], 1] = mine[empty[which, 1], 0]
        kind = kinds.SOLID_OF[count] if name in _SOLIDS else _OTHERS[name][0]
        found.append(((kind, count), nastran_table.whole_of(mine)))
    return found


def _of_lines(body):
    """The same of entries in any form; raises IoError naming what cannot be read."""
    points, elements = [], {}
    for name, fields in _cards(body):
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
    places = np.array([_number(value) for point in points for value in point[1:]]).reshape(-1, 3)
    return (np.array([point[0] for point in points]).astype(np.int64), places), \
        {key: np.array(found).astype(np.int64) for key, found in elements.items()}


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
        kind = kinds.SOLID_OF[count]
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
    parts = Parts(points[1], [], points[0])
    properties = {}
    for (kind, count), table in elements.items():
        nodes = table[:, 2:][:, kinds.from_convention(kind, count, kinds.LEVELS)]
        parts.sections.append(Section(kind, nodes, table[:, 0]))
        order = np.argsort(table[:, 1], kind="stable")
        for rows in np.split(order, np.flatnonzero(np.diff(table[order, 1])) + 1):
            properties.setdefault(int(table[rows[0], 1]), []).append(table[rows, 0])
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
