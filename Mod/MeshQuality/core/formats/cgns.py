# SPDX-License-Identifier: LGPL-2.1-or-later
"""CGNS files by the CGNS library: written with one unstructured zone, a section and a boundary condition a patch or group; read are the
unstructured zones of the first base, with their boundary conditions as groups.
"""

import ctypes
import ctypes.util
import functools
import itertools
import os
import tempfile

import numpy as np

from ... import files
from ...errors import IoError
from ..elements import kinds
from ..elements.parts import REMEDY, Parts, Section, count_within, equal_rows, unsupported, whole, words_of
from .arrays import element_blocks, points_of

# Values of the enumerations of cgnslib.h.
_MODE_READ, _MODE_WRITE = 0, 1
_UNSTRUCTURED, _REAL_DOUBLE, _POINT_RANGE, _FAMILY_SPECIFIED = 3, 4, 4, 25
_VERTEX, _CELL_CENTER, _FACE_CENTER, _EDGE_CENTER = 2, 3, 4, 8
_DIMENSIONAL, _UNKNOWN_DIMENSION = 2, 4
_LIST, _RANGE = (2, 7), (_POINT_RANGE, 6)  # of points, or of elements: values of PointSetType_t
_NODE, _MIXED = 2, 20
_TYPES = {3: ("line", 2), 4: ("line", 3), 5: ("triangle", 3), 6: ("triangle", 6), 7: ("quadrilateral", 4),
          8: ("quadrilateral", 8), 9: ("quadrilateral", 9), 10: ("tetrahedron", 4), 11: ("tetrahedron", 10),
          12: ("pyramid", 5), 13: ("pyramid", 14), 14: ("prism", 6), 15: ("prism", 15), 16: ("prism", 18),
          17: ("hexahedron", 8), 18: ("hexahedron", 20), 19: ("hexahedron", 27), 21: ("pyramid", 13), 24: ("line", 4),
          26: ("triangle", 10), 30: ("tetrahedron", 20), 40: ("line", 5), 42: ("triangle", 15), 47: ("tetrahedron", 35)}
TYPES = frozenset(_TYPES.values())
_NAMES = {22: "polygons (NGON_n)", 23: "polyhedra (NFACE_n)"}
_NUMBERS = {known: number for number, known in _TYPES.items()}
_DENSEST = 1000  # how many times a compressed file may grow
_LENGTHS = {1.0: 4, 0.001: 2}  # the value of LengthUnits_t by scale: millimetre, metre
_LEAST_BYTES = 2**19  # room for what a file holds beside its arrays


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
        raise IoError(f"the CGNS library says {cgns.cg_get_error().decode(errors='replace')}")


def _number(function, *arguments):
    found = ctypes.c_int()
    _call(function, *arguments, ctypes.byref(found))
    return found.value


def _text(name):
    return ctypes.c_char_p(name.encode())


class _File:
    """A file that is open."""

    def __init__(self, path, mode=_MODE_WRITE, arrays=0):
        """arrays  bytes of what will be written"""
        if mode == _MODE_WRITE:
            # On a full disk HDF5, which the library uses, aborts the process when it exits.
            files.require_room(path, _LEAST_BYTES + arrays)
        self.number = _number("cg_open", ctypes.c_char_p(os.fsencode(path)), mode)

    def __enter__(self):
        return self

    def __exit__(self, kind, *_):
        if kind is None:
            _call("cg_close", self.number)
        else:
            library().cg_close(self.number)

    def base(self, dimension):
        """A base with elements of this dimension in space."""
        return _number("cg_base_write", self.number, _text("Base"), dimension, 3)

    def zone(self, base, sizes, names=()):
        """A zone with a family, which cgnscheck 4.5 recommends; sizes as an array of whole numbers of the library's kind.

        names  of the families that follow
        """
        family = next(name for name in map("Mesh{}".format, itertools.count(1)) if name not in names)
        zone = _number("cg_zone_write", self.number, base, _text("Zone1"), address(sizes), _UNSTRUCTURED)
        _number("cg_family_write", self.number, base, _text(family))
        _call("cg_goto", self.number, base, _text("Zone_t"), zone, _text("end"))
        _call("cg_famname_write", _text(family))
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
        zone = file.zone(base, np.array([len(points), cells, 0], dtype=size), patches.names)
        for axis, column in zip("XYZ", points.T):
            _coordinate(file, (base, zone), f"Coordinate{axis}", np.ascontiguousarray(column))
        first = 1
        if len(tetrahedra):
            for name, members in element_blocks(solids, _ranks(mesh.tetrahedron_solid)):
                first = _section(file, (base, zone), name, ("tetrahedron", first), tetrahedra[members].astype(size))
        place = _FACE_CENTER if len(tetrahedra) else _CELL_CENTER
        for name, members in element_blocks(patches.names, patches.of_triangle):
            last = _section(file, (base, zone), name, ("triangle", first), triangles[members].astype(size))
            _condition(file, (base, zone), name, place, np.array([first, last - 1], dtype=size))
            first = last
        _units(file, base, scale)


def write_elements(mesh, path, scale):
    """Writes an ElementMesh: a section for each group of elements of the highest dimension, mixed where that has several kinds, and
    for those in none; of groups of their boundaries a condition each, on a section for each kind: cgnscheck 3.4 takes
    quadrilaterals in mixed ones for none of the boundary.
    """
    size, points = size_type(), mesh.nodes * scale
    numbers, place = np.array([len(points), 0, 0], dtype=size), {3: _FACE_CENTER, 2: _EDGE_CENTER}.get(mesh.dimension, _VERTEX)
    sections = []
    for dimension in (mesh.dimension, mesh.dimension - 1):
        sections += [(name, rows, dimension < mesh.dimension) for name, rows in _rows_of_groups(mesh, dimension)]
    numbers[1] = sum(len(nodes) for _, rows, at_boundary in sections if not at_boundary for _, nodes in rows)
    with _File(path, arrays=points.nbytes + sum(2 * size().nbytes * nodes.size for _, rows, _ in sections for _, nodes in rows)) as file:
        base = file.base(mesh.dimension)
        zone = file.zone(base, numbers, [name for name, *_ in sections])
        for axis, column in zip("XYZ", points.T):
            _coordinate(file, (base, zone), f"Coordinate{axis}", np.ascontiguousarray(column))
        first = 1
        for name, rows, at_boundary in sections:
            last, rows = first, [(kind, nodes.astype(size)) for kind, nodes in rows]
            if len(rows) > 1 and not at_boundary:
                last = _mixed_section(file, (base, zone), name, first, rows)
            else:
                for kind, nodes in rows:
                    last = _section(file, (base, zone), name if last == first else f"{kind}_{last}", (kind, last), nodes)
            if at_boundary:
                _condition(file, (base, zone), name, place, np.array([first, last - 1], dtype=size))
            first = last
        _units(file, base, scale)


def _rows_of_groups(mesh, dimension):
    """[(name, [(kind, its nodes in the order of CGNS, from 1), ...]), ...]: each element once, those in no group of the highest
    dimension as "Elements".
    """
    blocks = {i: block for i, block in enumerate(mesh.blocks) if kinds.DIMENSION[block.kind] == dimension}
    left = {i: np.ones(len(block.nodes), dtype=bool) for i, block in blocks.items()}
    rest = [("Elements", tuple((i, None) for i in blocks))] if dimension == mesh.dimension else []
    found = []
    for name, parts in [*mesh.group_members.items(), *rest]:
        rows = []
        for i, members in parts:
            if i in blocks:
                chosen = left[i] if members is None else left[i] & np.isin(np.arange(len(left[i])), members)
                if chosen.any():
                    rows.append((blocks[i].kind, _in_order(blocks[i].kind, blocks[i].nodes[chosen])))
                left[i] &= ~chosen
        if rows:
            found.append((name, rows))
    return found


def _mixed_section(file, place, name, first, rows):
    """Writes elements of several kinds, numbered from `first` on; returns the number after the last one."""
    integer = ctypes.c_int64 if rows[0][1].dtype == np.int64 else ctypes.c_int32
    values = np.concatenate([np.insert(nodes, 0, _NUMBERS[kind, nodes.shape[1]], axis=1).ravel() for kind, nodes in rows])
    lengths = np.concatenate([np.full(len(nodes), nodes.shape[1] + 1) for _, nodes in rows])
    offsets = np.concatenate([[0], np.cumsum(lengths)]).astype(values.dtype)
    last = first + len(lengths) - 1
    _call("cg_poly_section_write", file.number, *place, _text(name), _MIXED, integer(first), integer(last), 0, address(values),
          address(offsets), ctypes.byref(ctypes.c_int()))
    return last + 1


def _units(file, base, scale):
    """Says the unit of lengths, where it is one that the format knows."""
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
    exponents = np.array([0, 1, 0, 0, 0], dtype=np.float64)
    coordinate = _number("cg_coord_write", file.number, base, zone, _REAL_DOUBLE, _text(name), address(values))
    _call("cg_goto", file.number, base, _text("Zone_t"), zone, _text("GridCoordinates_t"), 1, _text("DataArray_t"),
          coordinate, _text("end"))
    _call("cg_exponents_write", _REAL_DOUBLE, address(exponents))


def _ranks(numbers):
    return np.unique(numbers, return_inverse=True)[1]


def _section(file, place, name, kind_and_first, elements):
    """Writes elements numbered from `first` on; returns the number after the last one."""
    kind, first = kind_and_first
    integer = ctypes.c_int64 if elements.dtype == np.int64 else ctypes.c_int32
    last = first + len(elements) - 1
    _call("cg_section_write", file.number, *place, _text(name), _NUMBERS[kind, elements.shape[1]], integer(first),
          integer(last), 0, address(np.ascontiguousarray(elements)), ctypes.byref(ctypes.c_int()))
    return last + 1


def _condition(file, place, name, location, ends):
    """The boundary condition of a patch, left to a family of its name."""
    base, zone = place
    integer = ctypes.c_int64 if ends.dtype == np.int64 else ctypes.c_int32
    _number("cg_family_write", file.number, base, _text(name))
    condition = _number("cg_boco_write", file.number, base, zone, _text(name), _FAMILY_SPECIFIED, _POINT_RANGE, integer(2),
                        address(ends))
    _call("cg_boco_gridlocation_write", file.number, base, zone, condition, location)
    _call("cg_goto", file.number, base, _text("Zone_t"), zone, _text("ZoneBC_t"), 1, _text("BC_t"), condition,
          _text("end"))
    _call("cg_famname_write", _text(name))


def read(path):
    """The Parts of a file."""
    most = os.path.getsize(path) * _DENSEST
    with _File(path, _MODE_READ) as opened:
        file = opened.number
        if _number("cg_nbases", file) < 1:
            raise IoError("it has no base: write the mesh into it")
        parts = Parts([np.zeros((0, 3))], [])
        for zone in range(1, _number("cg_nzones", file, 1) + 1):
            _Zone(file, zone, most).read(parts)
    parts.points = np.concatenate(parts.points)
    return parts


class _Zone:
    def __init__(self, file, zone, most):
        self._place, self._most, self._kind = (file, 1, zone), most, size_type()

    def _sizes(self, count):
        return np.zeros(count, dtype=self._kind)

    def read(self, parts):
        if _number("cg_zone_type", *self._place) != _UNSTRUCTURED:
            raise unsupported("structured zones")
        sizes = self._sizes(9)
        _call("cg_zone_read", *self._place, ctypes.create_string_buffer(33), address(sizes))
        first_node = sum(len(part) for part in parts.points)
        first_element = max((int(section.numbers.max()) for section in parts.sections if len(section.numbers)), default=0)
        parts.points.append(self._points(count_within(sizes[0], self._most, "nodes")))
        sections = {}
        for number in range(1, _number("cg_nsections", *self._place) + 1):
            name, found = self._section(number, first_node - 1, first_element)
            sections.setdefault(name, []).extend(found)
            parts.sections += found
        grouped = [np.zeros(0, dtype=np.int64)]
        for number in range(1, _number("cg_nbocos", *self._place) + 1):
            name, members = self._condition(number)
            if members is not None:
                parts.add_to_group(name, members + first_element)
                grouped.append(members + first_element)
        grouped = np.concatenate(grouped)
        for name, found in sections.items():
            numbers = np.concatenate([np.zeros(0, dtype=np.int64), *(section.numbers for section in found)])
            if not np.isin(numbers, grouped).any():
                parts.add_to_group(name, numbers)

    def _points(self, count):
        found = np.zeros((count, 3))
        first, last = np.ones(3, dtype=self._kind), np.full(3, count, dtype=self._kind)
        axes = _number("cg_ncoords", *self._place)
        for axis in range(min(axes, 3)):
            name, kind, column = ctypes.create_string_buffer(33), ctypes.c_int(), np.zeros(count)
            _call("cg_coord_info", *self._place, axis + 1, ctypes.byref(kind), name)
            if name.value not in (b"CoordinateX", b"CoordinateY", b"CoordinateZ"):
                raise unsupported(f"the coordinate {words_of(name.value)}")
            _call("cg_coord_read", *self._place, name, _REAL_DOUBLE, address(first), address(last), address(column))
            found[:, "XYZ".index(words_of(name.value)[-1])] = column
        return found

    def _section(self, number, node_offset, element_offset):
        """(name, [Section, ...])."""
        name, kind, ends = ctypes.create_string_buffer(33), ctypes.c_int(), self._sizes(2)
        boundary, parents, size = ctypes.c_int(), ctypes.c_int(), self._sizes(1)
        _call("cg_section_read", *self._place, number, name, ctypes.byref(kind), address(ends[:1]), address(ends[1:]),
             ctypes.byref(boundary), ctypes.byref(parents))
        _call("cg_ElementDataSize", *self._place, number, address(size))
        values = self._sizes(count_within(size[0], self._most, "numbers of an element section"))
        count = count_within(ends[1] - ends[0] + 1, len(values), "elements")
        owners = self._sizes(4 * count if parents.value else 1)
        if kind.value == _MIXED:
            _call("cg_poly_elements_read", *self._place, number, address(values), address(self._sizes(count + 1)), address(owners))
        elif kind.value in _TYPES or kind.value == _NODE:
            _call("cg_elements_read", *self._place, number, address(values), address(owners))
        else:
            raise unsupported(_NAMES.get(kind.value, f"elements of CGNS' type {kind.value}"))
        numbers = np.arange(count) + int(ends[0]) + element_offset
        rows = _mixed(whole(values), count) if kind.value == _MIXED else [(kind.value, whole(values))]
        return words_of(name.value), _sections(rows, numbers, node_offset)

    def _condition(self, number):
        """(name, numbers of elements), None of conditions on nodes."""
        name, integers, sizes = ctypes.create_string_buffer(33), [ctypes.c_int() for _ in range(7)], self._sizes(2)
        kind, points, normal_type, sets = integers[:4]
        _call("cg_boco_info", *self._place, number, name, ctypes.byref(kind), ctypes.byref(points), address(sizes[:1]),
             (ctypes.c_int * 3)(), address(sizes[1:]), ctypes.byref(normal_type), ctypes.byref(sets))
        location = _number("cg_boco_gridlocation_read", *self._place, number)
        by_elements = points.value in (_LIST[1], _RANGE[1])
        if not by_elements and (location == _VERTEX or points.value not in (_LIST[0], _RANGE[0])):
            return None, None
        members = self._sizes(count_within(sizes[0], self._most, "members of a boundary condition"))
        normals = np.zeros(3 * count_within(sizes[1], self._most, "normals") + 3)
        _call("cg_boco_read", *self._place, number, address(members), address(normals))
        members = whole(members)
        if points.value in _RANGE:
            if len(members) != 2 or not 0 <= members[1] - members[0] < self._most:
                raise IoError(f"boundary condition {words_of(name.value)!r} has no range of elements: {REMEDY}")
            members = np.arange(members[0], members[1] + 1)
        return self._family(number) or words_of(name.value), members

    def _family(self, number):
        """The name of a condition's family; None without one."""
        file, base, zone = self._place
        name = ctypes.create_string_buffer(700)
        end = ctypes.c_char_p(b"end")
        if library().cg_goto(file, base, ctypes.c_char_p(b"Zone_t"), zone, ctypes.c_char_p(b"ZoneBC_t"), 1,
                             ctypes.c_char_p(b"BC_t"), number, end) or library().cg_famname_read(name):
            return None
        return words_of(name.value)


def _sections(rows, numbers, node_offset):
    found, at = [], 0
    for kind, values in rows:
        if kind == _NODE:
            at += len(values)
            continue
        name, count = _TYPES[kind]
        if len(values) % count:
            raise IoError(f"a section has {len(values):,} numbers, which are no {kinds.PLURALS[name]}: {REMEDY}")
        nodes = values.reshape(-1, count)[:, kinds.from_cgns(name, count)]
        found.append(Section(name, nodes + node_offset, numbers[at:at + len(nodes)]))
        at += len(nodes)
    if at != len(numbers):
        raise IoError(f"a section has {at:,} elements instead of {len(numbers):,}: {REMEDY}")
    return found


def _mixed(values, count):
    """(type, its numbers) of each run of elements of one type."""
    at = 0
    while at < len(values) and count > 0:
        kind = int(values[at])
        if kind != _NODE and kind not in _TYPES:
            raise unsupported(_NAMES.get(kind, f"elements of CGNS' type {kind}"))
        width = 1 + (1 if kind == _NODE else _TYPES[kind][1])
        rows = equal_rows(values[at:], width, min(count, (len(values) - at) // width), slice(0, 1))
        yield kind, rows[:, 1:].ravel()
        at, count = at + rows.size, count - len(rows)
