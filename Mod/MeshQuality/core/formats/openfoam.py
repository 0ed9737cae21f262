# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes and fields of a case of OpenFOAM, text or binary, also compressed."""

import gzip
import os
import re
from dataclasses import dataclass

import numpy as np

from ...errors import InvalidInput, IoError

_HEADER = re.compile(rb"FoamFile\s*\{(.*?)\}", re.DOTALL)
_ENTRY = re.compile(r'(\w+)\s+(?:"([^"]*)"|([^;"\s]+))\s*;')
_BLANK = re.compile(rb"(?:\s|//[^\n]*|/\*.*?\*/)*", re.DOTALL)
_COUNT = re.compile(rb"(\d+)\s*([({])")
_FIELD = re.compile(rb"\binternalField\s+(uniform|nonuniform)\s+")
_LIST = re.compile(rb"List<\w+>\s*")
_NUMBER = re.compile(rb"[^\s();{}]+")
_COMPONENTS = {"volScalarField": 1, "volVectorField": 3, "volSymmTensorField": 6, "volTensorField": 9}


@dataclass(frozen=True)
class PolyMesh:
    """Cells of any shape by their faces, in the unit of the case.

    points     float64 (P, 3)
    corners    int (C,), the points of all faces one after another; starts: int (F + 1,), where each face begins
    owner      int (F,); neighbour: int (inner faces,)
    """

    points: np.ndarray
    corners: np.ndarray
    starts: np.ndarray
    owner: np.ndarray
    neighbour: np.ndarray

    @property
    def cells(self):
        """How many cells there are."""
        return int(max(self.owner.max(initial=-1), self.neighbour.max(initial=-1))) + 1

    def centres_and_volumes(self):
        """float64 (cells, 3), (cells,): as OpenFOAM has them, by pyramids from the mean of the centres of the faces."""
        centres, areas = self._faces()
        inner = len(self.neighbour)
        cell = np.concatenate([self.owner, self.neighbour])
        face = np.concatenate([np.arange(len(self.owner)), np.arange(inner)])
        outward = np.concatenate([areas, -areas[:inner]])
        middle = _sums(cell, centres[face], self.cells) / np.bincount(cell, minlength=self.cells)[:, None]
        pyramids = np.einsum("ij,ij->i", outward, centres[face] - middle[cell]) / 3.0
        volumes = np.bincount(cell, pyramids, self.cells)
        weighted = _sums(cell, pyramids[:, None] * (0.75 * centres[face] + 0.25 * middle[cell]), self.cells)
        good = volumes > 0.0
        middle[good] = weighted[good] / volumes[good, None]
        return middle, volumes

    def _faces(self):
        """Centres and area vectors of the faces, by triangles around the mean of the corners."""
        counts = np.diff(self.starts)
        face = np.repeat(np.arange(len(counts)), counts)
        following = np.arange(len(self.corners)) + 1
        following[self.starts[1:] - 1] = self.starts[:-1]
        one, two = self.points[self.corners], self.points[self.corners[following]]
        middle = _sums(face, one, len(counts)) / counts[:, None]
        areas = 0.5 * np.cross(one - middle[face], two - middle[face])
        whole = _sums(face, areas, len(counts))
        unit = whole / np.maximum(np.linalg.norm(whole, axis=1), 1e-300)[:, None]
        weights = np.einsum("ij,ij->i", areas, unit[face])
        total = np.bincount(face, weights, len(counts))
        centres = _sums(face, weights[:, None] * (one + two + middle[face]) / 3.0, len(counts))
        good = total > 0.0
        middle[good] = centres[good] / total[good, None]
        return middle, whole


def _sums(index, rows, count):
    return np.stack([np.bincount(index, column, count) for column in rows.T], axis=1)


def read_poly_mesh(case):
    """The PolyMesh of a case, its folder constant/polyMesh. Raises IoError naming the file."""
    folder = os.path.join(case, "constant", "polyMesh")
    files = {name: _File(os.path.join(folder, name)) for name in ("points", "faces", "owner", "neighbour")}
    points = files["points"].numbers(3)
    corners, starts = files["faces"].faces()
    owner, neighbour = (files[name].labels() for name in ("owner", "neighbour"))
    mesh = PolyMesh(points, corners, starts, owner, neighbour)
    if len(starts) - 1 != len(owner) or len(neighbour) > len(owner):
        raise IoError(f"cannot read '{folder}': it has {len(starts) - 1} faces, but owners of {len(owner)} and neighbours of {len(neighbour)}")
    if len(corners) and not 0 <= corners.min() <= corners.max() < len(points):
        raise IoError(f"cannot read '{folder}': faces name points that are not there")
    return mesh


def processor_patches(case):
    """{other processor: (first face, number of faces)} of a folder processor*: the patches to the others. Raises IoError."""
    return _File(os.path.join(case, "constant", "polyMesh", "boundary")).processor_patches()


def read_field(case, name, time=None):
    """(float64 (cells, k), of a uniform field (1, k); time) of a field of cells; time: None: the last one.

    Raises IoError naming the file; InvalidInput naming the times that there are.
    """
    time = _time_of(case, name, time)
    return _File(os.path.join(case, time, name)).internal_field(), time


def times_of(case, name):
    """The names of the folders of a case that have a field, by time."""
    try:
        folders = [entry for entry in os.listdir(case) if re.fullmatch(r"[0-9.]+(e[-+]?\d+)?", entry, re.IGNORECASE)]
    except OSError as error:
        raise IoError(f"cannot read the case '{case}': {error.strerror}") from error
    return sorted((entry for entry in folders if any(os.path.isfile(os.path.join(case, entry, name + end)) for end in ("", ".gz"))), key=float)


def _time_of(case, name, time):
    times = times_of(case, name)
    if not times:
        raise IoError(f"cannot read the case '{case}': no time has a field {name}")
    if time is None:
        return times[-1]
    found = next((entry for entry in times if entry == str(time) or float(entry) == float(time)), None)
    if found is None:
        raise InvalidInput(f"time = {time!r} is not possible: {name} is there at {', '.join(times)}")
    return found


class _File:
    """A file of OpenFOAM: its header, and what follows."""

    def __init__(self, path):
        self._path = path
        try:
            with (gzip.open(f"{path}.gz") if not os.path.isfile(path) and os.path.isfile(f"{path}.gz") else open(path, "rb")) as stream:
                self._data = stream.read()
        except (OSError, EOFError) as error:
            raise IoError(f"cannot read '{path}': {getattr(error, 'strerror', None) or error}") from error
        header = _HEADER.search(self._data)
        if header is None:
            raise self._fault("it has no header FoamFile")
        words = {key: quoted or plain for key, quoted, plain in _ENTRY.findall(header[1].decode("latin-1"))}
        self.kind, self._binary = words.get("class", ""), words.get("format", "ascii") == "binary"
        arch = words.get("arch", "")
        order = ">" if "MSB" in arch else "<"
        self._label = np.dtype(f"{order}i{8 if 'label=64' in arch else 4}")
        self._scalar = np.dtype(f"{order}f{4 if 'scalar=32' in arch else 8}")
        self._at = header.end()

    def _fault(self, why):
        return IoError(f"cannot read '{self._path}': {why}")

    def numbers(self, columns):
        """The next list of numbers: float64 (n, columns)."""
        return self._rows(self._scalar, columns)

    def labels(self):
        """The next list of labels: int64 (n,)."""
        return self._rows(self._label, 1).ravel()

    def faces(self):
        """(corners, starts) of a list of faces."""
        if self._binary:
            starts = self.labels()
            return self.labels(), starts
        count = self._begin()
        end = self._data.rindex(b")")
        tokens = np.array(re.sub(rb"[()]", b" ", self._data[self._at:end]).split(), dtype=np.int64)
        sizes, at = np.zeros(count, dtype=np.int64), 0
        for i in range(count):
            if at >= len(tokens):
                raise self._fault(f"it ends before face {i}")
            sizes[i] = tokens[at]
            at += sizes[i] + 1
        starts = np.concatenate([[0], np.cumsum(sizes)])
        lead = starts[:-1] + np.arange(count)
        return np.delete(tokens[:at], lead), starts

    def processor_patches(self):
        """{other processor: (first face, number of faces)} of a file boundary."""
        found = {}
        for body in re.findall(r"\{([^{}]*)\}", self._data[self._at:].decode("latin-1")):
            words = {key: quoted or plain for key, quoted, plain in _ENTRY.findall(body)}
            if "neighbProcNo" in words and words.get("type") == "processor":
                found[int(words["neighbProcNo"])] = int(words["startFace"]), int(words["nFaces"])
        return found

    def internal_field(self):
        """float64 (cells, k), or the row that holds for all cells."""
        if self.kind not in _COMPONENTS:
            raise self._fault(f"it is a {self.kind or 'file without a class'}: give a field of cells, one of {', '.join(_COMPONENTS)}")
        found = _FIELD.search(self._data, self._at)
        if found is None:
            raise self._fault("it has no internalField")
        self._at = found.end()
        columns = _COMPONENTS[self.kind]
        if found[1] == b"uniform":
            end = self._data.index(b";", self._at)
            return self._floats(_NUMBER.findall(self._data[self._at:end]), columns).reshape(-1, columns)
        mark = _LIST.match(self._data, self._at)
        self._at = self._at if mark is None else mark.end()
        return self._rows(self._scalar, columns)

    def _floats(self, words, columns):
        try:
            found = np.array(words, dtype=np.float64)
        except ValueError as error:
            raise self._fault(f"{' '.join(str(error).split())[:100]}") from error
        if len(found) % columns:
            raise self._fault(f"it has {len(found)} numbers, which are no rows of {columns}")
        return found

    def _begin(self):
        """Goes behind the bracket that opens a list; how many entries that has."""
        self._at = _BLANK.match(self._data, self._at).end()
        found = _COUNT.match(self._data, self._at)
        if found is None:
            raise self._fault(f"no list where one is expected: {self._data[self._at:self._at + 40]!r}")
        self._at = found.end()
        self._opened = found[2]
        return int(found[1])

    def _rows(self, dtype, columns):
        count = self._begin()
        if self._opened == b"{":
            end = self._data.index(b"}", self._at)
            row = self._floats(_NUMBER.findall(self._data[self._at:end]), columns)
            self._at = end + 1
            return np.tile(row, (count, 1))
        kind = np.int64 if dtype.kind == "i" else np.float64
        if self._binary:
            size = count * columns * dtype.itemsize
            if self._at + size > len(self._data):
                raise self._fault(f"it ends within a list of {count}")
            found = np.frombuffer(self._data, dtype, count * columns, self._at).astype(kind)
            self._at = self._data.index(b")", self._at + size) + 1
            return found.reshape(-1, columns)
        return self._text_rows(count, columns, kind)

    def _text_rows(self, count, columns, kind):
        """Rows of a list as text: up to the bracket that closes it."""
        words = []
        depth = 0
        for mark in re.finditer(rb"[()]", self._data[self._at:]):
            depth += 1 if mark[0] == b"(" else -1
            if depth < 0:
                words = re.sub(rb"[()]", b" ", self._data[self._at:self._at + mark.start()]).split()
                self._at += mark.end()
                break
        found = self._floats(words, columns).astype(kind).reshape(-1, columns)
        if len(found) != count:
            raise self._fault(f"it says {count} entries, and has {len(found)}")
        return found
