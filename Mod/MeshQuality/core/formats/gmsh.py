# SPDX-License-Identifier: LGPL-2.1-or-later
"""Gmsh's .msh of versions 2 and 4.1, as text and binary: https://gmsh.info/doc/texinfo/gmsh.html#Gmsh-file-formats"""

import re

import numpy as np

from ...errors import IoError
from ..elements.kinds import DIMENSION, count_of
from ..elements.parts import REMEDY, Parts, Section, content, count_within, equal_rows, numbers_in, unsupported, whole, words_of

_BY_ORDER = {"line": (1, 8, 26, 27, 28), "triangle": (2, 9, 21, 23, 25), "quadrilateral": (3, 10, 36, 37, 38),
             "tetrahedron": (4, 11, 29, 30, 31), "hexahedron": (5, 12, 92, 93, 94), "prism": (6, 13, 90, 91, 106),
             "pyramid": (7, 14, 118, 119, 120)}
_POINT = 15
TYPES = {number: (kind, count_of(kind, order)) for kind, numbers in _BY_ORDER.items()
         for order, number in enumerate(numbers, 1)}
TYPES.update({16: ("quadrilateral", 8), 17: ("hexahedron", 20), 18: ("prism", 15), 19: ("pyramid", 13)})
_SERENDIPITY = {20: "triangles of order 3 without inner nodes", 22: "triangles of order 4 without inner nodes",
                24: "triangles of order 5 without inner nodes"}
_ENTITY = {0: "Point", 1: "Curve", 2: "Surface", 3: "Volume"}


class _Text:
    """Takes numbers one after the other out of a section that is text."""

    def __init__(self, data, start, name):
        end = data.find(b"$End" + name, start)
        if end < 0:
            raise IoError(f"${name.decode()} has no end: the file is cut off; {REMEDY}")
        self._numbers, self._at, self.end = numbers_in(data[start:end]), 0, end

    def take(self, kind, count):
        """An array of the next numbers."""
        count = count_within(count, len(self._numbers) - self._at, "numbers")
        found = self._numbers[self._at:self._at + count]
        self._at += count
        return found if kind == "f8" else whole(found)

    def left(self):
        """How many numbers there still are, at most."""
        return len(self._numbers) - self._at

    def at_end(self):
        """Whether nothing of the section is left."""
        return not self.left()


class _Binary:
    """Takes numbers one after the other out of a binary section."""

    def __init__(self, data, start, order):
        self._data, self.end, self._order = data, start, order

    def take(self, kind, count):
        """An array of the next numbers."""
        kind = np.dtype(kind).newbyteorder(self._order)
        count = count_within(count, (len(self._data) - self.end) // kind.itemsize, "numbers")
        found = np.frombuffer(self._data, kind, count, self.end)
        self.end += count * kind.itemsize
        return found if kind.kind == "f" else found.astype(np.int64)

    def left(self):
        """How many numbers there still are, at most."""
        return (len(self._data) - self.end) // 4

    def at_end(self):
        """Whether nothing of the section is left."""
        return self._data[self.end:self.end + 8].lstrip().startswith(b"$End")


class _Reader:
    def __init__(self, data):
        self.data, self.names = data, {}
        found = re.match(rb"\s*\$MeshFormat\s+([\d.]+)\s+([01])\s+(\d+)[ \t]*\r?\n", data)
        if found is None:
            raise IoError("it does not begin as a file of Gmsh does, with $MeshFormat: give the extension of its format")
        self.version, self.binary, self.at = float(found[1]), found[2] == b"1", found.end()
        if not (2.0 <= self.version < 3.0 or self.version == 4.1):
            raise IoError(f"it is of version {self.version:g} of Gmsh's format: write version 4.1 or 2.2")
        self.size = f"u{int(found[3])}" if int(found[3]) in (4, 8) else "u8"
        self.order = "<"
        if self.binary:
            self.order = "<" if data[self.at:self.at + 4] == b"\1\0\0\0" else ">"
            self.at += 4
        self.physical = {}
        self.parents = {}
        self.parts = Parts(None, [])

    def sections(self):
        """Reads all sections."""
        known = {b"PhysicalNames": self._physical_names, b"Entities": self._entities, b"Nodes": self._nodes,
                 b"PartitionedEntities": self._partitioned, b"Elements": self._elements}
        seen = set()
        while True:
            start = re.compile(rb"\s*\$(\w+)[ \t]*\r?\n").search(self.data, self.at)
            if start is None:
                break
            name, self.at = start[1], start.end()
            if name in known:
                self.at = known[name](name)
                seen.add(name)
            if not name.startswith(b"End"):
                self.at = self._after(name)
        for name in (b"Nodes", b"Elements"):
            if name not in seen:
                raise IoError(f"it has no ${name.decode()}: it is cut off, or holds geometry alone; mesh it first")
        return self.parts

    def _after(self, name):
        end = self.data.find(b"$End" + name, self.at)
        if end < 0:
            raise IoError(f"${name.decode()} has no end: the file is cut off; {REMEDY}")
        return end + len(name) + 4

    def _cursor(self, name):
        return _Binary(self.data, self.at, self.order) if self.binary else _Text(self.data, self.at, name)

    def _physical_names(self, _name):
        end = self.data.find(b"$EndPhysicalNames", self.at)
        for found in re.finditer(rb'^\s*(\d+)\s+(-?\d+)\s+"([^"\n]*)"', self.data[self.at:max(end, self.at)], re.M):
            self.names[int(found[1]), int(found[2])] = words_of(found[3])
        return self.at

    def _name_of(self, dimension, tag):
        return self.names.get((dimension, abs(tag))) or f"Physical {_ENTITY[dimension]} {abs(tag)}"

    def _entities(self, name, partitioned=False):
        cursor = self._cursor(name)
        if partitioned:
            _, ghosts = cursor.take(self.size, 2).tolist()
            for _ in range(count_within(ghosts, cursor.left(), "ghost entities")):
                cursor.take("i4", 2)
        for dimension, count in enumerate(cursor.take(self.size, 4).tolist()):
            for _ in range(count_within(count, cursor.left(), "entities")):
                tag = int(cursor.take("i4", 1)[0])
                if partitioned:
                    parent = cursor.take("i4", 2).tolist()
                    if parent[0] == dimension:
                        self.parents[dimension, tag] = parent[1]
                    cursor.take("i4", cursor.take(self.size, 1)[0])
                cursor.take("f8", 3 if dimension == 0 else 6)
                self.physical[dimension, tag] = cursor.take("i4", cursor.take(self.size, 1)[0]).tolist()
                if dimension:
                    cursor.take("i4", cursor.take(self.size, 1)[0])
        return cursor.end

    def _partitioned(self, name):
        return self._entities(name, partitioned=True)

    def _nodes(self, name):
        if self.version < 4:
            return self._nodes_2(name)
        cursor, numbers, points = self._cursor(name), [np.zeros(0, dtype=np.int64)], [np.zeros((0, 3))]
        for _ in range(count_within(cursor.take(self.size, 4)[0], cursor.left(), "blocks of nodes")):
            dimension, _, parametric = cursor.take("i4", 3).tolist()
            count = count_within(cursor.take(self.size, 1)[0], cursor.left(), "nodes")
            numbers.append(cursor.take(self.size, count))
            width = 3 + (dimension if parametric and 0 <= dimension <= 3 else 0)
            points.append(cursor.take("f8", count * width).reshape(count, width)[:, :3])
        self.parts.point_numbers, self.parts.points = np.concatenate(numbers), np.concatenate(points)
        return _end_of(cursor, name)

    def _elements(self, name):
        if self.version < 4:
            return self._elements_2(name)
        cursor = self._cursor(name)
        for _ in range(count_within(cursor.take(self.size, 4)[0], cursor.left(), "blocks of elements")):
            _, tag, number = cursor.take("i4", 3).tolist()
            count = cursor.take(self.size, 1)[0]
            width = 2 if number == _POINT else _type(number)[1] + 1
            rows = cursor.take(self.size, count_within(count, cursor.left(), "elements") * width).reshape(-1, width)
            if number == _POINT or not len(rows):
                continue
            dimension = DIMENSION[TYPES[number][0]]
            self._add(number, rows[:, 1:], rows[:, 0], np.full(len(rows), self.parents.get((dimension, tag), tag)))
            for physical in dict.fromkeys(self.physical.get((dimension, tag), ())):
                self.parts.add_to_group(self._name_of(dimension, physical), rows[:, 0])
        return _end_of(cursor, name)

    def _add(self, number, nodes, numbers, entities):
        self.parts.sections.append(Section(TYPES[number][0], nodes, numbers, np.maximum(entities - 1, -1)))

    def _count_line(self, what):
        line = re.compile(rb"\s*(\d+)[ \t]*\r?\n").match(self.data, self.at)
        if line is None:
            raise IoError(f"the number of its {what} is missing: {REMEDY}")
        return count_within(int(line[1]), len(self.data), what), line.end()

    def _nodes_2(self, name):
        count, self.at = self._count_line("nodes")
        if self.binary:
            kind = np.dtype([("number", "i4"), ("place", "f8", 3)]).newbyteorder(self.order)
            count_within(count, (len(self.data) - self.at) // kind.itemsize, "nodes")
            rows = np.frombuffer(self.data, kind, count, self.at)
            self.parts.point_numbers = rows["number"].astype(np.int64)
            self.parts.points = rows["place"].astype(np.float64)
            return self.at + count * kind.itemsize
        cursor = _Text(self.data, self.at, name)
        rows = cursor.take("f8", 4 * count).reshape(count, 4)
        self.parts.point_numbers, self.parts.points = whole(rows[:, 0]), rows[:, 1:]
        return _end_of(cursor, name)

    def _elements_2(self, name):
        count, self.at = self._count_line("elements")
        if not self.binary:
            cursor = _Text(self.data, self.at, name)
            values = cursor.take("i8", cursor.left())
            at = 0
            while at < len(values) and count > 0:
                if len(values) < at + 3:
                    raise IoError(f"$Elements ends within an element: {REMEDY}")
                number, tags = values[at + 1:at + 3].tolist()
                width = 3 + count_within(tags, len(values), "tags") + (1 if number == _POINT else _type(number)[1])
                rows = equal_rows(values[at:], width, min(count, (len(values) - at) // width), slice(1, 3))
                at, count = at + rows.size, count - len(rows)
                self._add_2(number, rows[:, 0], rows[:, 3:3 + tags], rows[:, 3 + tags:])
            if count:
                raise IoError(f"$Elements lacks {count:,} elements that it announces: the file is cut off; {REMEDY}")
            if at < len(values):
                raise _more_than_announced(name)
            return cursor.end
        cursor = _Binary(self.data, self.at, self.order)
        while count > 0:
            number, following, tags = cursor.take("i4", 3).tolist()
            width = 1 + count_within(tags, cursor.left(), "tags") + (1 if number == _POINT else _type(number)[1])
            if following < 1:
                raise IoError(f"$Elements has a block without elements: the file is damaged; {REMEDY}")
            rows = cursor.take("i4", count_within(following, count, "elements") * width).reshape(following, width)
            count -= following
            self._add_2(number, rows[:, 0], rows[:, 1:1 + tags], rows[:, 1 + tags:])
        return _end_of(cursor, name)

    def _add_2(self, number, numbers, tags, nodes):
        if number == _POINT:
            return
        none = np.zeros(len(numbers), dtype=np.int64)
        self._add(number, nodes, numbers, tags[:, 1] if tags.shape[1] > 1 else none)
        physical = tags[:, 0] if tags.shape[1] else none
        for tag in np.unique(physical[physical != 0]).tolist():
            self.parts.add_to_group(self._name_of(DIMENSION[TYPES[number][0]], tag), numbers[physical == tag])


def _end_of(cursor, name):
    if not cursor.at_end():
        raise _more_than_announced(name)
    return cursor.end


def _more_than_announced(name):
    return IoError(f"${name.decode()} has more than it announces: it is damaged; {REMEDY}")


def _type(number):
    if number not in TYPES:
        raise unsupported(_SERENDIPITY.get(number, f"elements of Gmsh's type {number}"))
    return TYPES[number]


def read(path):
    """The Parts of a file."""
    return _Reader(content(path)).sections()
