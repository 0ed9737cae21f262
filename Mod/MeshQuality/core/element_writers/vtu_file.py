# SPDX-License-Identifier: LGPL-2.1-or-later
"""VTK's unstructured grids in XML, in base64; groups as a number of each element, named in a field of the file."""

import base64

import numpy as np

from ..elements import kinds
from ..elements.vtk_cells import GROUP, NEWER_CELLS

TYPES = {known: number for number, known in NEWER_CELLS.items()}
_KINDS = {"f": "Float", "i": "Int", "u": "UInt"}

BOUNDARIES = 2  # how many lower dimensions are elements, too


def write(mesh, path):
    """Writes a Numbered mesh."""
    connected, sizes, types = [], [], []
    for kind, nodes in mesh.blocks:
        count = nodes.shape[1]
        number = TYPES.get((kind, count))
        order = kinds.from_lagrange(kind, count) if number is None else kinds.from_convention(kind, count, kinds.RINGS)
        connected.append(nodes[:, np.argsort(order)].ravel())
        sizes.append(np.full(len(nodes), count))
        types.append(np.full(len(nodes), TYPES[kind, None] if number is None else number, dtype=np.uint8))
    group = np.full(mesh.first[-1] - 1, -1, dtype=np.int32)
    for i, name in reversed(list(enumerate(mesh.groups))):
        group[mesh.numbers_of(name) - 1] = i
    with open(path, "w", encoding="utf-8") as file:
        file.write('<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="2.2" byte_order="LittleEndian" '
                   'header_type="UInt64">\n<UnstructuredGrid>\n')
        file.writelines(f"<!-- {GROUP} {i}: {name.replace('--', '- -')} -->\n" for i, name in enumerate(mesh.groups))
        file.write(f'<Piece NumberOfPoints="{len(mesh.points)}" NumberOfCells="{len(group)}">\n<CellData>\n')
        file.write(_array(GROUP, group))
        file.write("</CellData>\n<Points>\n")
        file.write(_array("Points", mesh.points, ' NumberOfComponents="3"'))
        file.write("</Points>\n<Cells>\n")
        file.write(_array("connectivity", np.concatenate(connected)))
        file.write(_array("offsets", np.cumsum(np.concatenate(sizes))))
        file.write(_array("types", np.concatenate(types)))
        file.write("</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n")


def _array(name, values, more=""):
    values = np.ascontiguousarray(values, dtype=values.dtype.newbyteorder("<"))
    title = f"{_KINDS[values.dtype.kind]}{8 * values.dtype.itemsize}"
    data = base64.b64encode(np.array([values.nbytes], dtype="<u8").tobytes() + values.tobytes()).decode()
    return f'<DataArray type="{title}" Name="{name}"{more} format="binary">\n{data}\n</DataArray>\n'
