# SPDX-License-Identifier: LGPL-2.1-or-later
"""The faces that bound the elements of a mesh."""

import numpy as np

from . import kinds


def boundary_of(blocks):
    """A tuple of int32 (F, nodes per face); see ElementMesh.boundary."""
    return tuple(nodes for nodes, _, _ in with_elements(blocks))


def with_elements(blocks):
    """The same with the elements behind the faces: [(int32 (F, nodes per face), int (F,) the index of the block, and int
    (F,) that of the element in it), ...].
    """
    faces = {}
    for i, block in enumerate(blocks):
        if kinds.DIMENSION[block.kind] == 3:
            for kind, local in kinds.faces_of(block.kind, block.nodes.shape[1]):
                faces.setdefault((kinds.CORNERS[kind], len(local)), []).append((i, block.nodes, local))
    if not faces:
        return [(block.nodes, np.full(len(block.nodes), i), np.arange(len(block.nodes)))
                for i, block in enumerate(blocks) if kinds.DIMENSION[block.kind] == 2]
    return _outer(faces)


def _outer(faces):
    """The faces that are there once; as with_elements has them.

    faces  {(corners, nodes): [(index of the block, its elements, nodes of the face in an element), ...]}
    """
    once = []
    for corners in (3, 4):
        alike = [(key[1], part) for key, parts in sorted(faces.items()) if key[0] == corners for part in parts]
        if not alike:
            continue
        single = _single(_keys([elements[:, local[:corners]] for _, (_, elements, local) in alike]))
        found, first = {}, 0
        for count, (block, elements, local) in alike:
            chosen = np.flatnonzero(single[first:first + len(elements)])
            found.setdefault(count, []).append((elements[chosen][:, local], np.full(len(chosen), block), chosen))
            first += len(elements)
        once += [tuple(map(np.concatenate, zip(*parts))) for _, parts in sorted(found.items(), key=lambda item: item[0])]
    return [part for part in once if len(part[0])]


def _keys(corners):
    """uint64 (F,) or (F, 2): faces of the same corners have the same."""
    rows = [_sorted(part).astype(np.uint64) for part in corners]
    # The three lowest numbers tell faces apart: two elements that share three corners share the face.
    low = np.concatenate([part[:, 0] << np.uint64(32) | part[:, 1] for part in rows])
    return low, np.concatenate([part[:, 2] for part in rows])


def _sorted(corners):
    """Each row in order; by exchanges, which are faster than sorting for rows as short as these."""
    columns = [corners[:, i] for i in range(corners.shape[1])]
    pairs = ((0, 1), (1, 2), (0, 1)) if len(columns) == 3 else ((0, 1), (2, 3), (0, 2), (1, 3), (1, 2))
    for a, b in pairs:
        columns[a], columns[b] = np.minimum(columns[a], columns[b]), np.maximum(columns[a], columns[b])
    return np.stack(columns, axis=1)


def _single(keys):
    """bool (F,): which of the keys is there once."""
    low, high = keys
    order = np.lexsort((high, low))
    low, high = low[order], high[order]
    same = (low[1:] == low[:-1]) & (high[1:] == high[:-1])
    again = np.concatenate([[False], same]) | np.concatenate([same, [False]])
    single = np.empty(len(order), dtype=bool)
    single[order] = ~again
    return single
