# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exodus II files, written by netCDF: a block a solid and a side set a patch, or a block a patch of a surface; read with side
sets as faces. Those that are HDF5 need h5py to be read.
"""

import re

import numpy as np

from ...errors import IoError
from ...version import __version__
from ..elements import kinds
from ..elements.parts import Parts, Section, content, hdf5, unsupported, words_of
from . import netcdf_classic
from .arrays import element_blocks, points_of, tetrahedra_in_common_order

_FIRST_BYTES = 2**16  # initial size of the file in memory, which grows
_LONGEST = 32  # characters of a name
_WANTED = ("connect", "coord", "eb_", "ss_", "elem_ss", "side_ss")

# Faces of kinds.FACES, in the order of Exodus' sides.
SIDES = {"tetrahedron": (1, 3, 2, 0), "hexahedron": (1, 3, 4, 2, 0, 5), "prism": (2, 4, 3, 0, 1), "pyramid": (0, 2, 3, 1, 4)}
_KINDS = {"TET": "tetrahedron", "PYR": "pyramid", "WED": "prism", "HEX": "hexahedron", "TRI": "triangle", "QUA": "quadrilateral",
          "SHE": "quadrilateral", "BAR": "line", "BEA": "line", "TRU": "line", "EDG": "line"}
# Side of a tetrahedron, by the corner that is opposite; triangles have sides of another kind.
_SIDE_OPPOSITE = np.array([2, 3, 1, 4])
_WRITTEN = {3: "TRI3", 6: "TRI6", 4: "TETRA", 10: "TETRA10"}


def _dataset():
    """A netCDF4.Dataset in memory, whose close() gives the content of its file: on a full disk netCDF leaves one behind that
    ends the process later.
    """
    try:
        import netCDF4
    except ImportError as error:
        raise IoError("Exodus files need netCDF for Python, which is not there: install it (Debian: python3-netcdf4)") \
            from error
    # The format of offsets of 64 bits, which all readers of Exodus know.
    return netCDF4.Dataset("mesh.exo", "w", format="NETCDF3_64BIT_OFFSET", memory=_FIRST_BYTES)


def write(mesh, path, patches, solids, scale):
    """Writes a SurfaceMesh or a CurvedMesh of order 1 or 2."""
    points, tetrahedra = points_of(mesh, scale), tetrahedra_in_common_order(mesh)
    if len(tetrahedra):
        rank = np.unique(mesh.tetrahedron_solid, return_inverse=True)[1]
        blocks = [(name, tetrahedra[members], members) for name, members in element_blocks(solids, rank)]
        number = _numbers([members for _, _, members in blocks], len(tetrahedra))
        sides = _side_sets(mesh, patches, number)
    else:
        blocks = [(name, mesh.triangles[members] + 1, members)
                  for name, members in element_blocks(patches.names, patches.of_triangle)]
        sides = []
    data = _dataset()
    data.set_auto_mask(False)
    _head(data, len(points), sum(len(nodes) for _, nodes, _ in blocks))
    data.createDimension("num_dim", 3)
    for axis, column in zip("xyz", points.T):
        data.createVariable(f"coord{axis}", "f8", ("num_nodes",))[:] = column
    _names(data, "coor_names", "num_dim", ["x", "y", "z"])
    _blocks(data, blocks)
    _sets(data, sides)
    with open(path, "wb") as stream:
        stream.write(data.close())


def _numbers(parts, count):
    """By element its number in the file, from 1: blocks come one after the other."""
    number = np.empty(count, dtype=np.int32)
    number[np.concatenate(parts)] = np.arange(1, count + 1)
    return number


def _side_sets(mesh, patches, number):
    behind = mesh._curved.tetrahedra_behind()
    sets = []
    for name, members in element_blocks(patches.names, patches.of_triangle):
        members = members[behind[members] >= 0]
        corners, triangle = mesh.tetrahedra[behind[members], :4], mesh.triangles[members, :3]
        opposite = np.argmin((corners[:, :, None] == triangle[:, None, :]).any(axis=2), axis=1)
        sets.append((name, number[behind[members]], _SIDE_OPPOSITE[opposite]))
    return sets


def _head(data, nodes, elements):
    data.setncatts({"title": f"MeshQuality {__version__}", "api_version": np.float32(8.03), "version": np.float32(8.03),
                    "floating_point_word_size": np.int32(8), "file_size": np.int32(1),
                    "maximum_name_length": np.int32(_LONGEST)})
    data.createDimension("len_name", _LONGEST + 1)
    data.createDimension("len_string", _LONGEST + 1)
    data.createDimension("time_step", None)
    data.createVariable("time_whole", "f8", ("time_step",))
    data.createDimension("num_nodes", nodes)
    data.createDimension("num_elem", elements)


def _names(data, variable, dimension, names):
    found = data.createVariable(variable, "S1", (dimension, "len_name"))
    for i, name in enumerate(names):
        encoded = name.encode()[:_LONGEST]
        found[i, :len(encoded)] = np.frombuffer(encoded, dtype="S1")


def _properties(data, prefix, dimension, count):
    """All of `count` groups are there, numbered from 1."""
    data.createVariable(f"{prefix}_status", "i4", (dimension,))[:] = 1
    numbers = data.createVariable(f"{prefix}_prop1", "i4", (dimension,))
    numbers.setncattr("name", "ID")
    numbers[:] = np.arange(1, count + 1)


def _blocks(data, blocks):
    data.createDimension("num_el_blk", len(blocks))
    _properties(data, "eb", "num_el_blk", len(blocks))
    _names(data, "eb_names", "num_el_blk", [name for name, _, _ in blocks])
    for i, (_, nodes, _) in enumerate(blocks, 1):
        data.createDimension(f"num_el_in_blk{i}", len(nodes))
        data.createDimension(f"num_nod_per_el{i}", nodes.shape[1])
        connected = data.createVariable(f"connect{i}", "i4", (f"num_el_in_blk{i}", f"num_nod_per_el{i}"))
        connected.setncattr("elem_type", _WRITTEN[nodes.shape[1]])
        connected[:] = nodes


def _sets(data, sides):
    if not sides:
        return
    data.createDimension("num_side_sets", len(sides))
    _properties(data, "ss", "num_side_sets", len(sides))
    _names(data, "ss_names", "num_side_sets", [name for name, _, _ in sides])
    for i, (_, elements, side) in enumerate(sides, 1):
        data.createDimension(f"num_side_ss{i}", len(side))
        data.createVariable(f"elem_ss{i}", "i4", (f"num_side_ss{i}",))[:] = elements
        data.createVariable(f"side_ss{i}", "i4", (f"num_side_ss{i}",))[:] = side


def read(path):
    """The Parts of a file."""
    data = content(path)
    return _parts(_variables_of_hdf5(path) if data.startswith(b"\x89HDF") else netcdf_classic.variables(data))


def _variables_of_hdf5(path):
    with hdf5(path, "Exodus files that are HDF5") as file:
        wanted = [name for name in file if name.startswith(_WANTED) and hasattr(file[name], "dtype")]
        return {name: (file[name][()], {"elem_type": _bytes(file[name].attrs.get("elem_type", b""))}) for name in wanted}


def _bytes(text):
    return text.encode() if isinstance(text, str) else bytes(text)


def _parts(data):
    blocks = _numbered(data, "connect")
    if not blocks:
        raise IoError("it is a netCDF file without a mesh: it has no connect1")
    parts, last = Parts(_points(data), [], side_order=SIDES), 0
    names = _names_of(data, "eb", blocks[-1], "block")
    for i in blocks:
        nodes, attributes = data[f"connect{i}"]
        nodes = nodes.astype(np.int64)
        kind = _kind(words_of(attributes.get("elem_type", b"")).upper(), nodes.shape[1])
        numbers = np.arange(last + 1, last + 1 + len(nodes))
        last += len(nodes)
        if kind is not None:
            order = kinds.from_convention(kind, nodes.shape[1], kinds.EXODUS)
            parts.sections.append(Section(kind, nodes[:, order] - 1, numbers))
            parts.add_to_group(names[i - 1], numbers)
    _add_sides(data, parts)
    return parts


def _numbered(data, prefix):
    """The numbers behind a prefix of variables, which go up to a few thousand."""
    return sorted(int(name[len(prefix):]) for name in data if re.fullmatch(prefix + r"[1-9]\d{0,5}", name))


def _points(data):
    if "coord" in data:
        return data["coord"][0].T
    return np.stack([data[axis][0] for axis in ("coordx", "coordy", "coordz") if axis in data], axis=1)


def _names_of(data, prefix, count, default):
    numbers = data[f"{prefix}_prop1"][0].tolist() if f"{prefix}_prop1" in data else []
    given = data[f"{prefix}_names"][0] if f"{prefix}_names" in data else []
    given = [words_of(row.tobytes().split(b"\0")[0]) for row in given]
    given += [""] * (count - len(given))
    numbers += list(range(len(numbers) + 1, count + 1))
    return [name or f"{default} {number}" for name, number in zip(given, numbers)]


def _kind(name, count):
    """The kind of a block's elements; None for points."""
    kind = _KINDS.get(name[:3])
    if name[:3] == "SHE" and count in (3, 6):
        kind = "triangle"
    if name[:3] in ("SPH", "CIR", "POI"):
        return None
    order = kinds.order_of(kind, count) if kind else None
    if order not in (1, 2):
        raise unsupported(f"elements of type {name} with {count} nodes")
    return kind


def _add_sides(data, parts):
    sets = _numbered(data, "elem_ss")
    names = _names_of(data, "ss", sets[-1] if sets else 0, "side set")
    flat = np.concatenate([np.zeros(0, dtype=np.int64), *(section.numbers for section in parts.sections
                                                          if kinds.DIMENSION[section.kind] < 3)])
    for i in sets:
        if f"side_ss{i}" not in data:
            continue
        name = names[i - 1]
        numbers, sides = (data[f"{what}_ss{i}"][0].astype(np.int64) for what in ("elem", "side"))
        of_flat = np.isin(numbers, flat)
        parts.add_to_group(name, numbers[of_flat & (sides <= 2)])  # shells, by either of their faces
        parts.sides.append((name, numbers[~of_flat], sides[~of_flat]))
