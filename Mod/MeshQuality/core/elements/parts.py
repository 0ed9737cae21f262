# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a file of elements holds, and how text and bytes of files become arrays."""

import warnings
from dataclasses import dataclass, field

import numpy as np

from ...errors import IoError

# The type of integers that readers return, and what error messages advise.
WHOLE = np.dtype(np.int64)
REMEDY = "write it anew, or in another format"


class Section:
    """Elements of one kind.

    kind      "tetrahedron" and so on
    nodes     int64 (E, nodes per element), numbers of the file's nodes in Gmsh's order
    numbers   int64 (E,), numbers of the elements in the file; None: they go on after those of the section before
    geometry  int64 (E,), 0-based CAD entity or -1; None: the file has none
    """

    def __init__(self, kind, nodes, numbers=None, geometry=None):
        self.kind, self.nodes, self.numbers, self.geometry = kind, nodes, numbers, geometry


@dataclass
class Parts:
    """What a file holds.

    points         float64 (N, 3) or (N, 2)
    point_numbers  int64 (N,), their numbers in the file; None: 0, 1, 2 ...
    sections       [Section, ...]
    groups         {name: [numbers of elements, ...]}
    sides          [(name, numbers of elements, which side of each, from 1), ...]: faces of volumes that make a group
    side_order     {kind: the face of kinds.FACES that each side is}
    notes          sentences about what was left out
    """

    points: np.ndarray
    sections: list
    point_numbers: np.ndarray = None
    groups: dict = field(default_factory=dict)
    sides: list = field(default_factory=list)
    side_order: dict = field(default_factory=dict)
    notes: list = field(default_factory=list)

    def add(self, kind, nodes, geometry=None):
        """Adds a Section of elements that go on after those before; returns their numbers."""
        last = int(self.sections[-1].numbers[-1]) if self.sections else 0
        self.sections.append(Section(kind, nodes, np.arange(last + 1, last + 1 + len(nodes)), geometry))
        return self.sections[-1].numbers

    def add_to_group(self, name, numbers):
        """Puts elements into a group."""
        if len(numbers):
            self.groups.setdefault(name, []).append(np.asarray(numbers))


def hdf5(path, what, mode="r", **options):
    """An h5py.File; raises IoError where h5py is missing, or where a file to read is no HDF5 file. `what` are the files."""
    try:
        import h5py
    except ImportError as error:
        raise IoError(f"{what} need h5py, which is not there: install it (Debian: python3-h5py)") from error
    if mode == "r" and not h5py.is_hdf5(path):
        raise IoError("it is no HDF5 file, which such files are: write it anew")
    return h5py.File(path, mode, **options)


def content(path):
    """The bytes of a file; raises IoError where there are none."""
    with open(path, "rb") as file:
        data = file.read()
    if not (data[:4096].strip() or data.strip()):
        raise IoError("it is empty: write it anew")
    return data


def numbers_in(text):
    """float64 array of the numbers in bytes of text; raises ValueError where there is something else."""
    if not text.strip():
        return np.zeros(0)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            return np.fromstring(text, sep=" ")
        except DeprecationWarning as error:
            raise ValueError("there is a word where numbers were expected") from error


def whole(values):
    """int64 array of the numbers in bytes of text; raises ValueError for fractions and for what is too large to
    be a number of a node.
    """
    values = np.asarray(values)
    if values.dtype.kind != "f":
        return values.astype(WHOLE)
    if not (np.abs(values) < 2.0**53).all():
        raise ValueError("there is a number of a node or an element that is too large")
    found = values.astype(WHOLE)
    if (found != values).any():
        raise ValueError("there is a fraction where the number of a node or an element was expected")
    return found


def count_within(count, most, what):
    """A count as an int; raises IoError where the file is too short to hold as many."""
    count = int(count)
    if not 0 <= count <= most:
        raise IoError(f"it announces {count:,} {what}, which it is too short for: it is cut off or damaged; {REMEDY}")
    return count


def unsupported(what):
    """The IoError of elements that are not known here."""
    return IoError(f"it holds {what}, which cannot be read: write the mesh without such elements, or in another format "
                   "such as Gmsh's .msh")


def words_of(name):
    """A name in bytes as text."""
    return name.decode("utf-8", errors="replace").strip().strip("\0").strip()


def equal_rows(values, width, most, key):
    """The rows at the start whose columns `key` are those of the first one: at most `most`, at least one."""
    if most < 1:
        raise IoError(f"it ends within an element: it is cut off; {REMEDY}")
    step, found = 256, 0
    while found < most:
        rows = values[found * width:min(found + step, most) * width].reshape(-1, width)
        other = np.flatnonzero((rows[:, key] != values[key]).any(axis=1))
        if len(other):
            found += int(other[0])
            break
        found, step = found + len(rows), step * 4
    return values[:found * width].reshape(found, width)


def runs(values):
    """[(first, last + 1), ...] of equal neighbours."""
    if not len(values):
        return []
    ends = np.flatnonzero(values[1:] != values[:-1]) + 1
    return list(zip(np.concatenate([[0], ends]).tolist(), np.concatenate([ends, [len(values)]]).tolist()))
