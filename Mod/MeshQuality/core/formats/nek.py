# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nek5000's .re2, version 2: hexahedra, their bent edges by middle nodes, and sides of groups with the number of the group."""

import numpy as np

from ...errors import InvalidInput
from ..elements import kinds
from .sides import sides_of

# The middle nodes of edges as Nek5000 numbers these: below, above, between; and its sides.
_EDGES = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))
_SIDES = {**kinds.FACES, "hexahedron": (1, 3, 4, 2, 0, 5)}
_MIDDLE, _CONDITION = b"m", b"MSH"  # the latter is for the case to replace by what the number means
_BENT = 1e-9  # share of an edge's length: a node farther from the middle bends the edge

TYPES = {("hexahedron", count) for count in (8, 20, 27)}


def write(mesh, path, scale):
    """Writes an ElementMesh whose volumes are hexahedra."""
    volumes, points = [block.nodes for block in mesh.blocks if kinds.DIMENSION[block.kind] == 3], mesh.nodes * scale
    if not volumes:
        raise InvalidInput(".re2 files hold hexahedra, of which the mesh has none")
    count = sum(map(len, volumes))
    with open(path, "wb") as file:
        file.write(f"#v002{count:9d}{3:3d}{count:9d} this is the hdr".ljust(80).encode())
        file.write(np.array([6.54321], dtype="<f4").tobytes())
        for nodes in volumes:
            corners = points[nodes[:, :8]].transpose(0, 2, 1).reshape(-1, 24)
            file.write(np.column_stack([np.zeros(len(nodes)), corners]).astype("<f8").tobytes())
        first = np.cumsum([1, *map(len, volumes)])
        _write_records(file, np.concatenate([_bent(points, nodes, number) for nodes, number in zip(volumes, first)]), _MIDDLE)
        _write_records(file, _conditions(mesh), _CONDITION)


def _bent(points, nodes, first):
    """float64 (n, 7): element, edge, place of its middle node and two zeros, of edges that are bent."""
    if nodes.shape[1] == 8:
        return np.zeros((0, 7))
    pairs = [tuple(sorted(edge)) for edge in kinds.EDGES["hexahedron"]]
    places = [8 + pairs.index(tuple(sorted(edge))) for edge in _EDGES]
    middles, ends = points[nodes[:, places]], points[nodes[:, _EDGES]]
    off = np.linalg.norm(middles - ends.mean(axis=2), axis=2)
    element, edge = np.nonzero(off > _BENT * np.linalg.norm(ends[:, :, 1] - ends[:, :, 0], axis=2))
    return np.column_stack([element + first, edge + 1, middles[element, edge], np.zeros((len(element), 2))])


def _conditions(mesh):
    """float64 (n, 7): element, side, four zeros and the number of the group of faces."""
    found = [np.zeros((0, 7))]
    for group, (elements, sides) in enumerate(sides_of(mesh, _SIDES).values(), 1):
        found.append(np.column_stack([elements, sides, np.zeros((len(sides), 4)), np.full(len(sides), group)]))
    rows = np.concatenate(found)
    _, first = np.unique(rows[:, :2], axis=0, return_index=True)  # a side has one condition
    return rows[first]


def _write_records(file, rows, letters):
    record = np.zeros(len(rows), dtype=[("values", "<f8", 7), ("letters", "S8")])
    record["values"], record["letters"] = rows, letters.ljust(8)
    file.write(np.array([len(rows)], dtype="<f8").tobytes() + record.tobytes())
