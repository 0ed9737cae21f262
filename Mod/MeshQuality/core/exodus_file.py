# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exodus II files by netCDF: a block a solid and a side set a patch, or a block a patch of a surface."""

import numpy as np

from ..errors import IoError
from ..version import __version__
from .element_arrays import element_blocks, points_of, tetrahedra_in_common_order

_FIRST_BYTES = 2**16  # of the file in memory, which grows
_LONGEST = 32  # characters of a name
# Side of a tetrahedron, by the corner that is opposite; triangles have sides of another kind.
_SIDE_OPPOSITE = np.array([2, 3, 1, 4])
_TYPES = {3: "TRI3", 6: "TRI6", 4: "TETRA", 10: "TETRA10"}


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
        connected.setncattr("elem_type", _TYPES[nodes.shape[1]])
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
