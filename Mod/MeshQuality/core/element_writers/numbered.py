# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh as files have it: elements numbered from 1, block by block, and groups by these numbers."""

import numpy as np

from ..elements import kinds


class Numbered:
    """What writers take of an ElementMesh.

    points  float64 (N, 3), in the file's coordinates
    blocks  [(kind, int64 (E, nodes) from 0 in Gmsh's order), ...]
    first   the number of the first element of each
    groups  {name: ((index of a block, indices of elements in it), ...)}
    """

    def __init__(self, mesh, scale):
        self.points = mesh.nodes * scale
        self.blocks = [(block.kind, block.nodes.astype(np.int64)) for block in mesh.blocks]
        self.geometry = [block.geometry for block in mesh.blocks]
        self.first = (np.cumsum([0, *(len(block.nodes) for block in mesh.blocks)]) + 1).tolist()
        self.groups, self.dimension = mesh.group_members, mesh.dimension

    def numbers_of(self, name, dimensions=(1, 2, 3)):
        """int64: the elements of a group."""
        return np.concatenate([np.zeros(0, dtype=np.int64), *(rows + self.first[i] for i, rows in self.groups[name]
                                                              if kinds.DIMENSION[self.blocks[i][0]] in dimensions)])

    def groups_of(self, dimension):
        """{name: ((block, rows), ...)} of the elements of a dimension, without empty ones."""
        found = {name: tuple((i, rows) for i, rows in parts if kinds.DIMENSION[self.blocks[i][0]] == dimension and len(rows))
                 for name, parts in self.groups.items()}
        return {name: parts for name, parts in found.items() if parts}

    def division(self, dimension):
        """[(name, ((block, rows), ...)), ...] of all elements of a dimension, each once: in the first of its groups, those
        of none as None at the end.
        """
        left = {i: np.ones(len(nodes), dtype=bool) for i, (kind, nodes) in enumerate(self.blocks)
                if kinds.DIMENSION[kind] == dimension}
        found = []
        for name, parts in self.groups_of(dimension).items():
            mine = tuple((i, rows[left[i][rows]]) for i, rows in parts)
            for i, rows in mine:
                left[i][rows] = False
            found.append((name, tuple(part for part in mine if len(part[1]))))
        found.append((None, tuple((i, np.flatnonzero(rest)) for i, rest in left.items() if rest.any())))
        return [(name, parts) for name, parts in found if parts]


def lines(rows, separator=" "):
    """The rows of an array of whole numbers as text, one a line."""
    return "".join(f"{separator.join(map(str, row))}\n" for row in rows.tolist())


def wrapped(numbers, width, separator=", "):
    """Numbers as text, `width` of them a line."""
    words = list(map(str, numbers.tolist()))
    return "".join(f"{separator.join(words[i:i + width])}\n" for i in range(0, len(words), width))
