# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of SU2: straight elements; groups of what bounds them as markers."""

import numpy as np

from ..elements import kinds
from ..elements.vtk_cells import CELLS
from .numbered import lines

TYPES = {(kind, count): number for number, (kind, count) in CELLS.items() if count == kinds.CORNERS[kind]}

BOUNDARIES = 1  # how many lower dimensions are elements, too


def write(mesh, path):
    """Writes a Numbered mesh; one of faces or lines alone is one in space, with markers only."""
    inside = [(kind, nodes) for kind, nodes in mesh.blocks if kinds.DIMENSION[kind] == 3]
    markers = mesh.division(2 if mesh.dimension == 3 else mesh.dimension)
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"NDIME= 3\nNELEM= {sum(len(nodes) for _, nodes in inside)}\n")
        for kind, nodes in inside:
            _write_rows(file, kind, nodes)
        file.write(f"NPOIN= {len(mesh.points)}\n")
        file.writelines(f"{x!r} {y!r} {z!r}\n" for x, y, z in mesh.points.tolist())
        file.write(f"NMARK= {len(markers)}\n")
        for name, parts in markers:
            file.write(f"MARKER_TAG= {name or 'others'}\nMARKER_ELEMS= {sum(len(rows) for _, rows in parts)}\n")
            for block, rows in parts:
                kind, nodes = mesh.blocks[block]
                _write_rows(file, kind, nodes[rows])


def _write_rows(file, kind, nodes):
    file.write(lines(np.column_stack([np.full(len(nodes), TYPES[kind, nodes.shape[1]]), nodes])))
