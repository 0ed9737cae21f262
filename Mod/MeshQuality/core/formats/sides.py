# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sides of elements that are the same, and which sides of volume elements are the faces of groups."""

import numpy as np

from ..elements import kinds


def keys_of(corners):
    """What sides with the same corners have in common: the three lowest, which tell sides apart, with how many there are."""
    corners = np.asarray(corners, dtype=np.int64)
    flat = corners.shape[1] == 3 or (corners[:, 3] < 0)
    rows = np.where(corners < 0, np.iinfo(np.int64).max, corners)
    rows = np.sort(rows, axis=1)[:, :3]
    return np.column_stack([rows[:, :2], 2 * rows[:, 2] + flat])


def alike(keys):
    """(int (n,) the first row of each key, int (rows,) the key of each row, int (n,) how many rows have it)."""
    order = np.lexsort(keys.T[::-1])
    begins = np.concatenate([[True], (keys[order[1:]] != keys[order[:-1]]).any(axis=1)])
    same = np.empty(len(keys), dtype=np.int64)
    same[order] = np.cumsum(begins) - 1
    return order[begins], same, np.bincount(same)


def faces_of_groups(mesh):
    """[(name, int (F, corners)), ...]: the corners of the faces in the groups of an ElementMesh, by kind."""
    return [(name, mesh.blocks[i].nodes[rows][:, :kinds.CORNERS[mesh.blocks[i].kind]])
            for name, parts in mesh.group_members.items() for i, rows in parts
            if kinds.DIMENSION[mesh.blocks[i].kind] == 2 and len(rows)]


def sides_of(mesh, order):
    """{name: (numbers of volume elements from 1, their sides from 1)} of the groups of an ElementMesh that have faces of such; of
    one between two elements the side of the first.

    order  {kind: the face of kinds.FACES that each side is}
    """
    keys, elements, sides, number = [], [], [], 1
    for block in (block for block in mesh.blocks if kinds.DIMENSION[block.kind] == 3):
        for face, corners in enumerate(kinds.FACES[block.kind]):
            keys.append(keys_of(block.nodes[:, corners]))
            elements.append(np.arange(len(block.nodes)) + number)
            sides.append(np.full(len(block.nodes), order[block.kind].index(face) + 1))
        number += len(block.nodes)
    wanted = {}
    for name, corners in faces_of_groups(mesh):
        wanted[name] = np.concatenate([wanted[name], keys_of(corners)]) if name in wanted else keys_of(corners)
    if not keys or not wanted:
        return {}
    at = sum(map(len, keys))
    first, same, _ = alike(np.concatenate([*keys, *wanted.values()]))
    elements, sides, found = np.concatenate(elements), np.concatenate(sides), {}
    for name, rows in wanted.items():
        mine = np.unique(first[same[at:at + len(rows)]])
        mine, at = mine[mine < len(elements)], at + len(rows)
        if len(mine):
            found[name] = elements[mine], sides[mine]
    return found
