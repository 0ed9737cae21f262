# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes elements of several kinds and orders into files."""

import numpy as np

from ..errors import InvalidInput
from .elements import gmsh_file, kinds, vtk_cells

_TYPE = {name: number for number, name in gmsh_file.TYPES.items()}
_NAMES = {name: number for number, name in vtk_cells.CELLS.items() if name[1] is not None}
_LAGRANGE = {"line": 68, "triangle": 69, "quadrilateral": 70, "tetrahedron": 71, "hexahedron": 72, "prism": 73}


def write_msh(mesh, path, scale):
    """Gmsh 4.1 as text: an entity for each set of elements that are in the same groups, and a physical group for each group."""
    sets = _sets_of(mesh)
    names = {name: number for number, name in enumerate(mesh.group_members, 1)}
    nodes = mesh.nodes * scale
    with open(path, "w", encoding="utf-8") as out:
        out.write("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n")
        _write_names(mesh, names, out)
        _write_entities(sets, names, nodes, out)
        dimension = mesh.dimension
        out.write(f"$Nodes\n1 {len(nodes)} 1 {len(nodes)}\n{dimension} 1 0 {len(nodes)}\n")
        out.write("".join(f"{i}\n" for i in range(1, len(nodes) + 1)))
        out.write("".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in nodes.tolist()))
        out.write("$EndNodes\n")
        count = sum(len(rows) for _, _, _, rows in sets)
        out.write(f"$Elements\n{len(sets)} {count} 1 {count}\n")
        number = 1
        for (of_dimension, tag), _, block, rows in sets:
            elements = block.nodes[rows] + 1
            out.write(f"{of_dimension} {tag} {_TYPE[block.kind, elements.shape[1]]} {len(rows)}\n")
            for element in elements.tolist():
                out.write(f"{number} {' '.join(map(str, element))}\n")
                number += 1
        out.write("$EndElements\n")


def _sets_of(mesh):
    """[((dimension, tag of the entity), names of groups, block, rows)]: elements of a block that are in the same groups."""
    sets, tags = [], {}
    for number, block in enumerate(mesh.blocks):
        within = {name: np.zeros(len(block.nodes), dtype=bool) for name, parts in mesh.group_members.items()
                  for other, _ in parts if other == number}
        for name, parts in mesh.group_members.items():
            for other, rows in parts:
                if other == number:
                    within[name][rows] = True
        table = np.column_stack([np.zeros(len(block.nodes), dtype=bool), *within.values()])
        found, index = np.unique(table, axis=0, return_inverse=True)
        for i, row in enumerate(found):
            names = tuple(name for name, there in zip(within, row[1:]) if there)
            dimension = kinds.DIMENSION[block.kind]
            tag = tags.setdefault((dimension, names), sum(key[0] == dimension for key in tags) + 1)
            sets.append(((dimension, tag), names, block, np.flatnonzero(index.ravel() == i)))
    return sets


def _write_names(mesh, names, out):
    out.write(f"$PhysicalNames\n{len(names)}\n")
    for name, number in names.items():
        dimension = kinds.DIMENSION[mesh.blocks[mesh.group_members[name][0][0]].kind]
        said = name.replace('"', "'")
        out.write(f'{dimension} {number} "{said}"\n')
    out.write("$EndPhysicalNames\n")


def _write_entities(sets, names, nodes, out):
    entities = {}
    for key, groups, block, rows in sets:
        places = nodes[np.unique(block.nodes[rows])]
        low, high = places.min(axis=0), places.max(axis=0)
        if key in entities:
            low, high = np.minimum(low, entities[key][1]), np.maximum(high, entities[key][2])
        entities[key] = groups, low, high
    if not any(key[0] == 3 for key in entities) and not any(key == (2, 1) for key in entities):
        raise InvalidInput("there are neither solids nor faces to write: give a mesh that has elements")
    counts = [sum(key[0] == dimension for key in entities) for dimension in range(4)]
    out.write("$Entities\n" + " ".join(map(str, counts)) + "\n")
    for (dimension, tag), (groups, low, high) in sorted(entities.items(), key=lambda item: item[0]):
        box = " ".join(repr(float(x)) for x in (*low, *high))
        physical = " ".join(str(names[name]) for name in groups)
        out.write(f"{tag} {box} {len(groups)} {physical} 0\n".replace("  ", " "))
    out.write("$EndEntities\n")


def write_vtu(mesh, path, scale):
    """VTK as text: the elements of the highest dimension; as Lagrange cells from order 3 on."""
    blocks = [block for block in mesh.blocks if kinds.DIMENSION[block.kind] == mesh.dimension]
    cells = []
    for block in blocks:
        count = block.nodes.shape[1]
        number = _NAMES.get((block.kind, count))
        if number is not None:
            order = np.argsort(kinds.from_convention(block.kind, count, kinds.RINGS))
        elif block.kind in _LAGRANGE:
            number, order = _LAGRANGE[block.kind], np.argsort(kinds.from_lagrange(block.kind, count))
        else:
            raise InvalidInput(f"{kinds.PLURALS[block.kind]} of order {block.order} have no cells in VTK: write .msh")
        cells.append((number, block.nodes[:, order], block.geometry))
    entity = {2: "cad_face", 3: "cad_solid"}[mesh.dimension]
    with open(path, "w", encoding="ascii") as out:
        count = sum(len(nodes) for _, nodes, _ in cells)
        out.write('<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="2.2" byte_order="LittleEndian">\n'
                  f'<UnstructuredGrid>\n<Piece NumberOfPoints="{len(mesh.nodes)}" NumberOfCells="{count}">\n<Points>\n')
        _write_array(out, "Float64", "Points", mesh.nodes * scale, 3)
        out.write("</Points>\n<Cells>\n")
        _write_array(out, "Int64", "connectivity", np.concatenate([nodes.ravel() for _, nodes, _ in cells]))
        sizes = np.concatenate([np.full(len(nodes), nodes.shape[1]) for _, nodes, _ in cells])
        _write_array(out, "Int64", "offsets", np.cumsum(sizes))
        _write_array(out, "UInt8", "types", np.concatenate([np.full(len(nodes), number) for number, nodes, _ in cells]))
        out.write("</Cells>\n<CellData>\n")
        _write_array(out, "Int32", entity, np.concatenate([geometry for _, _, geometry in cells]))
        out.write("</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n")


def _write_array(out, kind, name, values, width=1):
    text = " ".join(map(repr, values.ravel().tolist()))
    components = f' NumberOfComponents="{width}"' if width > 1 else ""
    out.write(f'<DataArray type="{kind}" Name="{name}"{components} format="ascii">\n{text}\n</DataArray>\n')


WRITERS = {".msh": write_msh, ".vtu": write_vtu}
