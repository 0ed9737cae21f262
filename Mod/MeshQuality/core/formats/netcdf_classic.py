# SPDX-License-Identifier: LGPL-2.1-or-later
"""Variables of netCDF's classic formats (CDF-1, -2 and -5), read here: the netCDF library divides by zero, or runs on for a
minute, where a header is damaged.
"""

import math

import numpy as np

from ...errors import IoError
from ..elements.parts import REMEDY, count_within

_TYPES = {1: "i1", 2: "S1", 3: ">i2", 4: ">i4", 5: ">f4", 6: ">f8", 7: "u1", 8: ">u2", 9: ">u4", 10: ">i8", 11: ">u8"}
_LISTS = {"dimensions": 10, "variables": 11, "attributes": 12}


class _Header:
    def __init__(self, data):
        self._data, self._at = data, 4
        version = data[3] if len(data) > 3 else 0
        if data[:3] != b"CDF" or version not in (1, 2, 5):
            raise IoError(f"it is no netCDF file, which Exodus files are: {REMEDY}")
        self._count = ">i8" if version == 5 else ">i4"
        self._offset = ">i4" if version == 1 else ">i8"
        self._take(self._count)  # records
        self._dimensions = [(self._name(), self._take(self._count)) for _ in range(self._list("dimensions"))]
        self._attributes()

    def _array(self, kind, count):
        kind = np.dtype(kind)
        count_within(count, (len(self._data) - self._at) // kind.itemsize, "numbers")
        found = np.frombuffer(self._data, kind, count, self._at)
        self._at += count * kind.itemsize
        return found

    def _take(self, kind):
        return int(self._array(kind, 1)[0])

    def _list(self, what):
        tag, count = self._take(">i4"), self._take(self._count)
        if tag not in (0, _LISTS[what]):
            raise IoError(f"its list of {what} is damaged: {REMEDY}")
        return count_within(count, len(self._data) - self._at, what)

    def _padded(self, kind, count):
        found = self._array(kind, count)
        self._at += -found.nbytes % 4
        return found

    def _name(self):
        return self._padded("S1", self._take(self._count)).tobytes().decode("utf-8", errors="replace")

    def _attributes(self):
        found = {}
        for _ in range(self._list("attributes")):
            name, kind = self._name(), self._take(">i4")
            found[name] = self._padded(_TYPES[kind], self._take(self._count)).tobytes()
        return found

    def variables(self):
        """{name: (array, {attribute: bytes})} of the variables that do not change with time."""
        found = {}
        for _ in range(self._list("variables")):
            name = self._name()
            which = self._array(self._count, count_within(self._take(self._count), len(self._dimensions), "dimensions"))
            shape = tuple(self._dimensions[i][1] for i in which.tolist())
            attributes, kind = self._attributes(), np.dtype(_TYPES[self._take(">i4")])
            self._take(self._count)  # bytes
            begin = self._take(self._offset)
            if 0 in shape[:1]:
                continue
            if not 0 <= begin <= len(self._data) or min(shape, default=1) < 0:
                raise IoError(f"variable {name} lies beyond its end: it is cut off; {REMEDY}")
            count = count_within(math.prod(shape), (len(self._data) - begin) // kind.itemsize, f"numbers of {name}")
            found[name] = np.frombuffer(self._data, kind, count, begin).reshape(shape), attributes
        return found


def variables(data):
    """See _Header.variables."""
    return _Header(data).variables()
