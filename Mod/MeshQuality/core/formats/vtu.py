# SPDX-License-Identifier: LGPL-2.1-or-later
"""VTK's unstructured grids in XML: text, base64 or raw bytes, compressed by zlib or LZMA, or not."""

import base64
import lzma
import re
import xml.etree.ElementTree as ElementTree
import zlib

import numpy as np

from ...errors import IoError
from ..elements.parts import REMEDY, Parts, content, count_within, numbers_in, unsupported, whole
from . import vtk_cells

_TYPES = {"Float32": "f4", "Float64": "f8", "Int8": "i1", "Int16": "i2", "Int32": "i4", "Int64": "i8", "UInt8": "u1",
          "UInt16": "u2", "UInt32": "u4", "UInt64": "u8"}
_NEWER = ("2.2", "2.3")  # versions
# Bytes that all compressed arrays of a file may unpack to: a multiple of the size of the file, and a constant. A mesh
# of 1.7 million equal hexahedra unpacks to 8 times its size.
_RATIO, _MORE = 64, 1 << 26


def _zlib(data, most):
    return zlib.decompressobj().decompress(data, most)


def _lzma(data, most):
    return lzma.LZMADecompressor().decompress(data, most)


_COMPRESSORS = {"vtkZLibDataCompressor": _zlib, "vtkLZMADataCompressor": _lzma}


class _Arrays:
    """Reads the DataArrays of a file."""

    def __init__(self, root, appended, size):
        self._left = _RATIO * size + _MORE
        self._order = ">" if root.get("byte_order") == "BigEndian" else "<"
        self._head = np.dtype(_TYPES[root.get("header_type", "UInt32")]).newbyteorder(self._order)
        name = root.get("compressor")
        if name and name not in _COMPRESSORS:
            raise unsupported(f"arrays compressed by {name}")
        self._decompress = _COMPRESSORS.get(name)
        self._appended, self._encoded = appended

    def array(self, element):
        """The numbers of a DataArray."""
        kind = np.dtype(_TYPES[element.get("type")]).newbyteorder(self._order)
        form = element.get("format", "ascii")
        if form == "ascii":
            values = numbers_in((element.text or "").encode())
            return values if kind.kind == "f" else whole(values)
        if form == "appended":
            found = self._bytes(self._appended[int(element.get("offset")):], self._encoded)
        else:
            found = self._bytes("".join((element.text or "").split()).encode(), True)
        values = np.frombuffer(found, kind, len(found) // kind.itemsize)
        return values.astype(np.float64 if kind.kind == "f" else np.int64)

    def _bytes(self, data, encoded):
        size = self._head.itemsize
        if self._decompress is None:
            raw = _decoded(data, size) if encoded else data
            count = count_within(np.frombuffer(raw, self._head, 1)[0], len(data), "bytes")
            raw = _decoded(data, size + count) if encoded else data
            return _cut(raw, size, count)
        blocks = count_within(np.frombuffer(_decoded(data, size) if encoded else data, self._head, 1)[0], len(data), "blocks")
        length = size * (3 + blocks)
        head = np.frombuffer(_decoded(data, length) if encoded else data, self._head, 3 + blocks).tolist()
        if encoded:
            data, length = _decoded(data[-(-length // 3) * 4:], sum(head[3:])), 0
        found, most = [], head[1]
        for stored in head[3:]:
            found.append(self._decompress(_cut(data, length, stored), max(1, min(most, self._left + 1))))
            length += stored
            self._left -= len(found[-1])
            if self._left < 0:
                raise IoError(f"its arrays unpack to more than {_RATIO} times its size, which no mesh does: it is damaged; write it "
                              "without compression")
        return b"".join(found)


def _decoded(text, count):
    """At least the first `count` bytes that base64 text stands for."""
    return base64.b64decode(text[:-(-count // 3) * 4])


def _cut(data, first, count):
    if first + count > len(data):
        raise IoError(f"an array is shorter than it announces: the file is cut off; {REMEDY}")
    return data[first:first + count]


def read(path):
    """The Parts of a file."""
    data, raw, encoded = content(path), b"", True
    mark = re.search(rb"<AppendedData[^>]*>\s*_", data)
    if mark:
        end = data.rfind(b"</AppendedData>")
        if end < mark.end():
            raise IoError(f"it has no </AppendedData>: it is cut off; {REMEDY}")
        raw, encoded = data[mark.end():end], b"base64" in mark[0]
        data = data[:mark.end() - 1] + data[end:]
    root = ElementTree.fromstring(data)
    if root.tag != "VTKFile" or root.get("type") != "UnstructuredGrid":
        raise IoError(f"it holds {root.get('type') or root.tag}, not UnstructuredGrid: write the mesh as one")
    arrays = _Arrays(root, (raw, encoded), len(data) + len(raw))
    known = vtk_cells.NEWER_CELLS if root.get("version") in _NEWER else vtk_cells.CELLS
    parts, points, first = Parts(None, []), [], 0
    for piece in root.iter("Piece"):
        cells = {array.get("Name"): arrays.array(array) for array in piece.find("Cells")}
        place = arrays.array(piece.find("Points").find("DataArray"))
        if len(place) != 3 * int(piece.get("NumberOfPoints")) or len(cells["types"]) != int(piece.get("NumberOfCells")):
            raise IoError(f"it has other numbers of points or cells than it announces: {REMEDY}")
        points.append(place.reshape(-1, 3))
        groups = {array.get("Name"): arrays.array(array) for array in _tables(piece)}
        vtk_cells.add(parts, cells["connectivity"], cells["offsets"], cells["types"], (groups, first), known)
        first += len(points[-1])
    parts.points = np.concatenate(points) if points else np.zeros((0, 3))
    return parts


def _tables(piece):
    """The arrays of cells that say groups or CAD entities."""
    found = piece.find("CellData")
    return [array for array in found if array.get("Name") in vtk_cells.TABLES] if found is not None else []
