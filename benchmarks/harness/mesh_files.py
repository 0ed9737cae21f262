# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads triangle meshes of files as they stand: OBJ, OFF, PLY and STL, also packed with gzip. Polygons become fans,
strips of PLY triangles; corners of STL at equal coordinates become one vertex. Nothing is repaired.
"""

import gzip
import re
from pathlib import Path

import numpy as np

# Files of $MESHQUALITY_DATA/mesh that benchmarks improve.
IMPROVED = ("ballA.off", "casting.off", "nut-big.obj", "screw-big.obj", "3DBenchy.obj")

_PLY_TYPES = {"char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1", "short": "i2", "int16": "i2",
              "ushort": "u2", "uint16": "u2", "int": "i4", "int32": "i4", "uint": "u4",
              "uint32": "u4", "float": "f4", "float32": "f4", "double": "f8", "float64": "f8"}


def read(path):
    """(V, F) of a file; raises ValueError where it holds no triangles."""
    path = Path(path)
    packed = path.suffix == ".gz"
    data = gzip.decompress(path.read_bytes()) if packed else path.read_bytes()
    kind = Path(path.stem).suffix if packed else path.suffix
    vertices, triangles = _READERS[kind](data)
    if not len(triangles):
        raise ValueError(f"{path.name} holds no triangles")
    return np.asarray(vertices, float), np.asarray(triangles, np.int32)


def _fans(polygons):
    return np.array([(p[0], p[k - 1], p[k]) for p in polygons for k in range(2, len(p))],
                    np.int32).reshape(-1, 3)


def _obj(data):
    lines = data.decode("latin-1").splitlines()
    vertices = [line.split()[1:4] for line in lines if line.startswith("v ")]
    corners = [[int(word.split("/")[0]) for word in line.split()[1:]]
               for line in lines if line.startswith("f ")]
    return vertices, _fans([[i - 1 if i > 0 else i + len(vertices) for i in p] for p in corners])


def _off(data):
    if data.startswith(b"OFF BINARY"):
        return _off_binary(data)
    words = data.split()
    points, faces = int(words[1]), int(words[2])
    vertices = np.array(words[4:4 + 3 * points], float).reshape(-1, 3)
    numbers = np.array(words[4 + 3 * points:], float).astype(np.int32)
    return vertices, _fans(_lists(numbers, faces))


def _off_binary(data):
    start = data.index(b"\n") + 1
    points, faces, _ = np.frombuffer(data, "<u4", 3, start)
    vertices = np.frombuffer(data, "<f4", 3 * points, start + 12).reshape(-1, 3)
    numbers = np.frombuffer(data, "<i4", -1, start + 12 + vertices.nbytes)
    return vertices, _fans(_lists(numbers, faces))


def _lists(numbers, count):
    """Numbers in `count` lists, each after its length."""
    found, at = [], 0
    for _ in range(count):
        size = int(numbers[at])
        found.append(numbers[at + 1:at + 1 + size])
        at += 1 + size
    return found


def _ply(data):
    end = re.search(rb"end_header\r?\n", data).end()
    text = "ascii" in data[:end].decode("latin-1").split("format", 1)[1].splitlines()[0]
    words, at, vertices, triangles = iter(data[end:].split()) if text else None, end, None, []
    for name, count, properties in _ply_elements(data[:end].decode("latin-1")):
        rows = []
        for _ in range(count):
            row = []
            for size_type, value_type in properties:
                if text:
                    number = int(next(words)) if size_type else 1
                    row.append([float(next(words)) for _ in range(number)])
                    continue
                number = 1
                if size_type:
                    number = int(np.frombuffer(data, size_type, 1, at)[0])
                    at += np.dtype(size_type).itemsize
                row.append(np.frombuffer(data, value_type, number, at))
                at += row[-1].nbytes
            rows.append(row)
        if name == "vertex":
            vertices = np.array([[float(value[0]) for value in row[:3]] for row in rows])
        elif name == "face":
            triangles = _fans([np.asarray(row[0], np.int32) for row in rows])
        elif name == "tristrips":
            triangles = _strips(np.asarray(rows[0][0], np.int32))
    return vertices, triangles


def _ply_elements(header):
    """(name, count, properties) of each element; a property has the type of its length, or None, and its type."""
    elements = []
    for line in header.splitlines():
        words = line.split()
        if words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), []))
        elif words[:2] == ["property", "list"]:
            elements[-1][2].append(tuple("<" + _PLY_TYPES[word] for word in words[2:4]))
        elif words[:1] == ["property"]:
            elements[-1][2].append((None, "<" + _PLY_TYPES[words[1]]))
    return elements


def _strips(indices):
    """Triangles of strips, each ended by -1."""
    found, start = [], 0
    for i, index in enumerate(indices):
        if index < 0:
            start = i + 1
        elif i - start >= 2:
            a, b = (i - 2, i - 1) if (i - start) % 2 == 0 else (i - 1, i - 2)
            triangle = (indices[a], indices[b], index)
            if len(set(triangle)) == 3:
                found.append(triangle)
    return found


def _stl(data):
    count = int.from_bytes(data[80:84], "little")
    if len(data) == 84 + 50 * count:
        facet = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
        corners = np.frombuffer(data, facet, count, 84)["corners"].reshape(-1, 3)
    else:
        corners = np.array([line.split()[1:4] for line in re.findall(rb"vertex[^\n]*", data)],
                           np.float32)
    vertices, index = np.unique(corners, axis=0, return_inverse=True)
    return vertices, index.reshape(-1, 3)


_READERS = {".obj": _obj, ".off": _off, ".ply": _ply, ".stl": _stl}
