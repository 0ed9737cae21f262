# SPDX-License-Identifier: LGPL-2.1-or-later
"""CGNS files by the CGNS library: one unstructured zone, a section and a boundary condition a patch."""

import ctypes
import ctypes.util
import functools
import os
import tempfile

import numpy as np

from .. import files
from ..errors import IoError
from .element_arrays import element_blocks, points_of
from .elements import kinds

# Of the enumerations of cgnslib.h.
_MODE_READ, _MODE_WRITE = 0, 1
_UNSTRUCTURED, _REAL_DOUBLE, _POINT_RANGE, _FAMILY_SPECIFIED = 3, 4, 4, 25
_CELL_CENTER, _FACE_CENTER = 3, 4
_DIMENSIONAL, _UNKNOWN_DIMENSION = 2, 4
_LENGTHS = {1.0: 4, 0.001: 2}  # by scale: millimetre, metre
_LEAST_BYTES = 2**19  # of a file beside its arrays
# By dimension and nodes of an element.
_TYPES = {(2, 3): 5, (2, 6): 6, (2, 10): 26, (2, 15): 42, (3, 4): 10, (3, 10): 11, (3, 20): 30, (3, 35): 47}


@functools.lru_cache(maxsize=None)
def library():
    """The CGNS library. Raises IoError where it is not there."""
    name = ctypes.util.find_library("cgns")
    if name is None:
        raise IoError("CGNS files need the CGNS library, which is not there: install it (Debian: libcgns-dev)")
    return ctypes.CDLL(name)


def _call(function, *arguments):
    cgns = library()
    if getattr(cgns, function)(*arguments):
        cgns.cg_get_error.restype = ctypes.c_char_p
        raise IoError(f"the CGNS library cannot write: {cgns.cg_get_error().decode(errors='replace')}")


def _text(name):
    return ctypes.c_char_p(name.encode())


class _File:
    """A file that is open."""

    def __init__(self, path, mode=_MODE_WRITE, arrays=0):
        """arrays  bytes of what will be written"""
        if mode == _MODE_WRITE:
            # Below the library HDF5 ends the process, at its end, where a disk was full.
            files.require_room(path, _LEAST_BYTES + arrays)
        self.number = ctypes.c_int()
        _call("cg_open", ctypes.c_char_p(os.fsencode(path)), mode, ctypes.byref(self.number))

    def __enter__(self):
        return self

    def __exit__(self, kind, *_):
        if kind is None:
            _call("cg_close", self.number)
        else:
            library().cg_close(self.number)

    def base(self, dimension):
        """A base with elements of this dimension in space."""
        base = ctypes.c_int()
        _call("cg_base_write", self.number, _text("Base"), dimension, 3, ctypes.byref(base))
        return base

    def zone(self, base, sizes):
        """A zone; sizes as an array of whole numbers of the library's kind."""
        zone = ctypes.c_int()
        _call("cg_zone_write", self.number, base, _text("Zone1"), address(sizes), _UNSTRUCTURED, ctypes.byref(zone))
        return zone


def address(array):
    """Where an array is, for the library."""
    return array.ctypes.data_as(ctypes.c_void_p)


@functools.lru_cache(maxsize=None)
def size_type():
    """The NumPy type of the library's sizes, which is a choice of those who built it: read back from a small file."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "sizes.cgns")
        with _File(path) as file:
            base = file.base(3)
            zone = file.zone(base, np.array([1, 0, 0], dtype=np.int64))  # the same for both
        found = np.full(9, -1, dtype=np.int32)
        with _File(path, _MODE_READ) as file:
            _call("cg_zone_read", file.number, base, zone, ctypes.create_string_buffer(33), address(found))
    return np.int32 if found[3] == -1 else np.int64


def write(mesh, path, patches, solids, scale):
    """Writes a SurfaceMesh or a CurvedMesh of orders 1 to 4."""
    size, points = size_type(), points_of(mesh, scale)
    tetrahedra = _in_order("tetrahedron", getattr(mesh, "tetrahedra", np.zeros((0, 4), dtype=np.int32)))
    triangles = _in_order("triangle", mesh.triangles)
    cells = len(tetrahedra) or len(triangles)
    with _File(path, arrays=points.nbytes + tetrahedra.nbytes + triangles.nbytes) as file:
        base = file.base(3 if len(tetrahedra) else 2)
        zone = file.zone(base, np.array([len(points), cells, 0], dtype=size))
        for axis, column in zip("XYZ", points.T):
            _coordinate(file, (base, zone), f"Coordinate{axis}", np.ascontiguousarray(column))
        first = 1
        if len(tetrahedra):
            for name, members in element_blocks(solids, _ranks(mesh.tetrahedron_solid)):
                first = _section(file, (base, zone), name, (3, first), tetrahedra[members].astype(size))
        place = _FACE_CENTER if len(tetrahedra) else _CELL_CENTER
        for name, members in element_blocks(patches.names, patches.of_triangle):
            last = _section(file, (base, zone), name, (2, first), triangles[members].astype(size))
            _condition(file, (base, zone), name, place, np.array([first, last - 1], dtype=size))
            first = last
        _call("cg_goto", file.number, base, _text("end"))
        _call("cg_dataclass_write", _DIMENSIONAL if scale in _LENGTHS else _UNKNOWN_DIMENSION)
        if scale in _LENGTHS:
            _call("cg_units_write", 0, _LENGTHS[scale], 0, 0, 0)


def _in_order(kind, nodes):
    """The nodes of elements from 1 as CGNS orders them."""
    return nodes[:, np.argsort(kinds.from_cgns(kind, nodes.shape[1]))] + 1


def _coordinate(file, place, name, values):
    """Writes one coordinate of all points, which is a length."""
    base, zone = place
    coordinate, exponents = ctypes.c_int(), np.array([0, 1, 0, 0, 0], dtype=np.float64)
    _call("cg_coord_write", file.number, base, zone, _REAL_DOUBLE, _text(name), address(values),
          ctypes.byref(coordinate))
    _call("cg_goto", file.number, base, _text("Zone_t"), zone, _text("GridCoordinates_t"), 1, _text("DataArray_t"),
          coordinate, _text("end"))
    _call("cg_exponents_write", _REAL_DOUBLE, address(exponents))


def _ranks(numbers):
    return np.unique(numbers, return_inverse=True)[1]


def _section(file, place, name, kind_and_first, elements):
    """Writes elements numbered from `first` on; returns the number after the last one."""
    dimension, first = kind_and_first
    integer = ctypes.c_int64 if elements.dtype == np.int64 else ctypes.c_int32
    last = first + len(elements) - 1
    _call("cg_section_write", file.number, *place, _text(name), _TYPES[dimension, elements.shape[1]], integer(first),
          integer(last), 0, address(np.ascontiguousarray(elements)), ctypes.byref(ctypes.c_int()))
    return last + 1


def _condition(file, place, name, location, ends):
    """The boundary condition of a patch, left to a family of its name."""
    base, zone = place
    integer = ctypes.c_int64 if ends.dtype == np.int64 else ctypes.c_int32
    condition, family = ctypes.c_int(), ctypes.c_int()
    _call("cg_family_write", file.number, base, _text(name), ctypes.byref(family))
    _call("cg_boco_write", file.number, base, zone, _text(name), _FAMILY_SPECIFIED, _POINT_RANGE, integer(2),
          address(ends), ctypes.byref(condition))
    _call("cg_boco_gridlocation_write", file.number, base, zone, condition, location)
    _call("cg_goto", file.number, base, _text("Zone_t"), zone, _text("ZoneBC_t"), 1, _text("BC_t"), condition,
          _text("end"))
    _call("cg_famname_write", _text(name))
