# SPDX-License-Identifier: LGPL-2.1-or-later
"""VTK's legacy files of unstructured grids, as text and binary, of versions up to 5.1."""

import re

import numpy as np

from ...errors import IoError
from ..elements.parts import REMEDY, Parts, content, count_within, numbers_in, unsupported, whole
from . import vtk_cells

_TYPES = {b"float": "f4", b"double": "f8", b"int": "i4", b"unsigned_int": "u4", b"long": "i8", b"unsigned_long": "u8",
          b"vtktypeint64": "i8", b"vtkidtype": "i8", b"vtktypeint32": "i4", b"short": "i2", b"unsigned_char": "u1",
          b"char": "i1"}
_WORD = re.compile(rb"\s*([^\s]+)")


class _Reader:
    def __init__(self, data):
        self._data, self._at = data, 0
        if not data.startswith(b"# vtk DataFile"):
            raise IoError("it does not begin with '# vtk DataFile': it is no legacy file of VTK")
        for _ in range(2):
            self._at = data.index(b"\n", self._at) + 1
        self._binary = self._word().upper() == b"BINARY"
        if self._word().upper() != b"DATASET":
            raise IoError(f"it has no DATASET in its fourth line: {REMEDY}")
        if (kind := self._word().upper()) != b"UNSTRUCTURED_GRID":
            raise unsupported(f"a dataset of type {kind.decode(errors='replace') or 'none'}")

    def _word(self):
        found = _WORD.match(self._data, self._at)
        if found is None:
            return b""
        self._at = found.end()
        return found[1]

    def _count(self, what):
        return count_within(int(self._word()), len(self._data), what)

    def _array(self, kind, count):
        if self._binary:
            self._at = self._data.index(b"\n", self._at) + 1
            kind = np.dtype(kind).newbyteorder(">")
            count_within(count, (len(self._data) - self._at) // kind.itemsize, "numbers")
            found = np.frombuffer(self._data, kind, count, self._at)
            self._at += count * kind.itemsize
            return found.astype(np.float64 if kind.kind == "f" else np.int64)
        letter = re.compile(rb"(?:^|\n)[ \t]*[A-Za-z]").search(self._data, self._at)
        end = letter.start() if letter else len(self._data)
        found = numbers_in(self._data[self._at:end])
        if len(found) < count:
            raise IoError(f"it has {len(found):,} numbers where it announces {count:,}: it is cut off; {REMEDY}")
        self._at = end
        return found[:count] if np.dtype(kind).kind == "f" else whole(found[:count])

    def _type(self):
        name = self._word().lower()
        if name not in _TYPES:
            raise unsupported(f"numbers of type {name.decode(errors='replace') or 'none'}")
        return _TYPES[name]

    def parts(self):
        """The Parts of the file."""
        points = cells = types = None
        tables = {}
        while word := self._word().upper():
            if word == b"POINTS":
                count = self._count("points")
                points = self._array(self._type(), 3 * count).reshape(count, 3)
            elif word == b"CELLS":
                cells = self._cells()
            elif word == b"CELL_TYPES":
                types = self._array("i4", self._count("cells"))
            elif word == b"CELL_DATA" and types is not None:
                tables = self._entities(len(types))
                break
            elif word == b"POINT_DATA":
                break
        if points is None or cells is None or types is None:
            raise IoError(f"it has no POINTS, CELLS or CELL_TYPES: it is cut off; {REMEDY}")
        parts = Parts(points, [])
        vtk_cells.add(parts, *cells, types, (tables, 0))
        return parts

    def _cells(self):
        """(nodes of the cells, where each one ends)."""
        count, size = self._count("cells"), self._count("numbers of cells")
        before = self._at
        if self._word().upper() == b"OFFSETS":  # version 5: count is of the ends and the 0 before them
            offsets = self._array(self._type(), count)
            if self._word().upper() != b"CONNECTIVITY":
                raise IoError(f"OFFSETS without CONNECTIVITY: {REMEDY}")
            return self._array(self._type(), size), offsets[1:]
        self._at = before
        values, starts, at = self._array("i4", size), [], 0
        sizes = values.tolist()
        for _ in range(count):
            if not 0 <= at < size or sizes[at] < 0:
                raise IoError(f"its cells have other numbers of nodes than it announces: {REMEDY}")
            starts.append(at)
            at += sizes[at] + 1
        starts = np.array(starts, dtype=np.int64)
        keep = np.ones(size, dtype=bool)
        keep[starts] = False
        if at != size:
            raise IoError(f"its cells have other numbers of nodes than it announces: {REMEDY}")
        return values[keep], np.cumsum(values[starts])

    def _entities(self, count):
        """{CellEntityIds: an array} where Gmsh wrote them."""
        self._word()
        head = re.compile(rb"\s*SCALARS +(CellEntityIds) +int +1\s+LOOKUP_TABLE +\w+").match(self._data, self._at)
        if head is None:
            return {}
        self._at = head.end()
        return {"CellEntityIds": self._array("i4", count)}


def read(path):
    """The Parts of a file."""
    return _Reader(content(path)).parts()
