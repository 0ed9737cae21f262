# SPDX-License-Identifier: LGPL-2.1-or-later
"""Input files of Abaqus and CalculiX: elements of the highest dimension; groups of faces as sets of nodes, sets of the
elements behind, and surfaces, as our curved meshes have them.
"""

import numpy as np

from ..elements import kinds
from ..elements.abaqus_file import SIDES
from .numbered import lines, wrapped
from .sides import sides_of

TYPES = {("line", 2): "B31", ("line", 3): "B32", ("triangle", 3): "S3", ("triangle", 6): "S6", ("quadrilateral", 4): "S4",
          ("quadrilateral", 8): "S8", ("tetrahedron", 4): "C3D4", ("tetrahedron", 10): "C3D10", ("pyramid", 5): "C3D5",
          ("prism", 6): "C3D6", ("prism", 15): "C3D15", ("hexahedron", 8): "C3D8", ("hexahedron", 20): "C3D20"}
_LINE = [0, 2, 1]  # the middle node comes between the others
_WIDTH = 8
_LONGEST, _DIGITS = 20, 13  # characters of a number; how many digits fit at any sign and exponent

BOUNDARIES = 0  # how many lower dimensions are elements, too


def write(mesh, path):
    """Writes a Numbered mesh."""
    with open(path, "w", encoding="utf-8") as file:
        file.write("*HEADING\nMeshQuality\n*NODE\n")
        file.writelines(f"{i},{_real(x)},{_real(y)},{_real(z)}\n" for i, (x, y, z) in enumerate(mesh.points.tolist(), 1))
        shown = [i for i, (kind, _) in enumerate(mesh.blocks) if kinds.DIMENSION[kind] == mesh.dimension]
        for i in shown:
            kind, nodes = mesh.blocks[i]
            order = _LINE if (kind, nodes.shape[1]) == ("line", 3) else np.argsort(
                kinds.from_convention(kind, nodes.shape[1], kinds.RINGS))
            file.write(f"*ELEMENT, TYPE={TYPES[kind, nodes.shape[1]]}\n")
            rows = np.column_stack([np.arange(len(nodes)) + mesh.first[i], nodes[:, order] + 1])
            file.write(_broken(lines(rows, ","), nodes.shape[1]))
        sides = sides_of(mesh, SIDES) if mesh.dimension == 3 else {}
        for name in mesh.groups:
            _write_group(file, mesh, name, sides.get(name))


def _real(value):
    """A number in as many characters as CalculiX reads."""
    text = repr(value)
    return text if len(text) <= _LONGEST else f"{value:.{_DIGITS}g}"


def _broken(text, count):
    """Lines of more than 16 numbers go on in the next one."""
    if count < 16:
        return text
    return "".join(f"{','.join(words[:11])},\n{','.join(words[11:])}\n" for words in
                   (line.split(",") for line in text.splitlines()))


def _write_group(file, mesh, name, sides):
    nodes = np.unique(np.concatenate([np.zeros(0, dtype=np.int64),
                                      *(mesh.blocks[i][1][rows].ravel() for i, rows in mesh.groups[name])]))
    if len(nodes):
        file.write(f"*NSET, NSET={name}\n{wrapped(nodes + 1, _WIDTH)}")
    whole = mesh.numbers_of(name, (mesh.dimension,))
    behind = whole if sides is None else np.union1d(whole, sides[0])
    if len(behind):
        file.write(f"*ELSET, ELSET={name}\n{wrapped(behind, _WIDTH)}")
    if sides is not None:
        file.write(f"*SURFACE, NAME={name}_surface, TYPE=ELEMENT\n")
        file.writelines(f"{number}, S{side}\n" for number, side in zip(*(part.tolist() for part in sides)))
