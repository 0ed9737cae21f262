# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nastran bulk data: a property for each group, named in comments."""

import numpy as np

from ..elements import kinds

TYPES = {("line", 2): "CBAR", ("triangle", 3): "CTRIA3", ("triangle", 6): "CTRIA6", ("quadrilateral", 4): "CQUAD4",
          ("quadrilateral", 8): "CQUAD8", ("tetrahedron", 4): "CTETRA", ("tetrahedron", 10): "CTETRA", ("pyramid", 5): "CPYRAM",
          ("pyramid", 13): "CPYRAM", ("prism", 6): "CPENTA", ("prism", 15): "CPENTA", ("hexahedron", 8): "CHEXA",
          ("hexahedron", 20): "CHEXA"}
_WIDTH, _WIDE, _FIELDS = 8, 16, 8
_DIGITS = (15, 14, 13, 12, 11, 10, 9, 8)  # the last one fits always

BOUNDARIES = 1  # how many lower dimensions are elements, too


def write(mesh, path):
    """Writes a Numbered mesh; an element in several groups has the first one's property, one in none that of its kind."""
    parts = [part for dimension in (mesh.dimension - 1, mesh.dimension) for part in mesh.division(dimension)]
    names = [name if name is not None else f"other {kinds.PLURALS[mesh.blocks[members[0][0]][0]]}" for name, members in parts]
    with open(path, "w", encoding="utf-8") as file:
        file.write("$ MeshQuality\n")
        file.writelines(f"$ property {i}: patch {name}\n" for i, name in enumerate(names, 1))
        file.write("BEGIN BULK\n")
        file.writelines(f"GRID*   {i:16d}{'':16}{_field(x)}{_field(y)}\n*       {_field(z)}\n"
                        for i, (x, y, z) in enumerate(mesh.points.tolist(), 1))
        for number, (_, members) in enumerate(parts, 1):
            for block, rows in members:
                _write_elements(file, mesh, (block, rows), number)
        file.write("ENDDATA\n")


def _write_elements(file, mesh, members, number):
    block, rows = members
    kind, nodes = mesh.blocks[block]
    name = TYPES[kind, nodes.shape[1]]
    order = np.argsort(kinds.from_convention(kind, nodes.shape[1], kinds.LEVELS))
    listed = (nodes[rows][:, order] + 1).tolist()
    tail = "0.      0.      1.\n" if name == "CBAR" else ""
    for element, row in zip((rows + mesh.first[block]).tolist(), listed):
        fields = [f"{value:{_WIDTH}d}" for value in (element, number, *row)]
        parts = ["".join(fields[i:i + _FIELDS]) for i in range(0, len(fields), _FIELDS)]
        file.write(f"{name:{_WIDTH}}" + "+\n+       ".join(parts) + (tail or "\n"))


def _field(value):
    """A number in 16 characters, with a point, as Nastran wants it."""
    for digits in _DIGITS:
        text = f"{value:.{digits}G}"
        if "." not in text:
            whole, letter, exponent = text.partition("E")
            text = f"{whole}.{letter}{exponent}"
        if len(text) <= _WIDE:
            return f"{text:>{_WIDE}}"
    raise ValueError(f"{value!r} does not fit into a field")
