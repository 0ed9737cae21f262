# SPDX-License-Identifier: LGPL-2.1-or-later
"""I-DEAS universal files: nodes, elements, and groups of elements and of their nodes."""

import numpy as np

from ..elements.universal_file import AROUND, order_of
from .numbered import lines

# By kind and nodes the descriptor of an element.
TYPES = {("line", 2): 21, ("line", 3): 24, ("triangle", 3): 91, ("triangle", 6): 92, ("quadrilateral", 4): 94,
          ("quadrilateral", 8): 95, ("tetrahedron", 4): 111, ("tetrahedron", 10): 118, ("prism", 6): 112, ("prism", 15): 113,
          ("hexahedron", 8): 115, ("hexahedron", 20): 116}
_OF_NODES, _OF_ELEMENTS = 7, 8
_WIDTH = 8  # numbers in a line

BOUNDARIES = 2  # how many lower dimensions are elements, too


def write(mesh, path):
    """Writes a Numbered mesh."""
    with open(path, "w", encoding="utf-8") as file:
        file.write("    -1\n  2411\n")
        file.writelines(f"{i:10d}         1         1        11\n{x:25.16E}{y:25.16E}{z:25.16E}\n"
                        for i, (x, y, z) in enumerate(mesh.points.tolist(), 1))
        file.write("    -1\n    -1\n  2412\n")
        for (kind, nodes), first in zip(mesh.blocks, mesh.first):
            count = nodes.shape[1]
            head = f"{TYPES[kind, count]:10d}         1         1         7{count:10d}\n"
            if kind == "line":
                head += "         0         1         1\n"
            rows = (nodes[:, np.argsort(order_of(kind, count))] + 1).tolist()
            file.writelines(f"{number:10d}{head}{_record(row)}" for number, row in enumerate(rows, first))
        file.write("    -1\n")
        if mesh.groups:
            _write_groups(file, mesh)


def _record(row):
    return "".join("".join([*(f"{node:10d}" for node in row[i:i + _WIDTH]), "\n"]) for i in range(0, len(row), _WIDTH))


def _write_groups(file, mesh):
    file.write("    -1\n  2467\n")
    for i, name in enumerate(mesh.groups, 1):
        elements = mesh.numbers_of(name)
        nodes = np.unique(np.concatenate([np.zeros(0, dtype=np.int64),
                                          *(mesh.blocks[k][1][rows].ravel() for k, rows in mesh.groups[name])])) + 1
        members = [(_OF_ELEMENTS, number) for number in elements.tolist()] + [(_OF_NODES, number) for number in nodes.tolist()]
        file.write(f"{i:10d}{'         0' * 6}{len(members):10d}\n{name}\n")
        for k in range(0, len(members), 2):
            file.write("".join(f"{kind:10d}{number:10d}         0         0" for kind, number in members[k:k + 2]) + "\n")
    file.write("    -1\n")
