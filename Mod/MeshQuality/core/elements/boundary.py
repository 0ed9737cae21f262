# SPDX-License-Identifier: LGPL-2.1-or-later
"""The faces that bound the elements of a mesh."""

import numpy as np

from . import kinds
from .alike import groups, sorted_rows


def boundary_of(blocks, check=lambda: None):
    """A tuple of int32 (F, nodes per face); see ElementMesh.boundary. `check` is called now and then; it may raise Cancelled."""
    return tuple(nodes for nodes, _, _ in with_elements(blocks, check))


def with_elements(blocks, check=lambda: None):
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
    return _outer(faces, check)


def _outer(faces, check):
    """The faces that are there once; as with_elements has them.

    faces  {(corners, nodes): [(index of the block, its elements, nodes of the face in an element), ...]}
    """
    once = []
    for corners in (3, 4):
        alike = [(key[1], part) for key, parts in sorted(faces.items()) if key[0] == corners for part in parts]
        if not alike:
            continue
        single = _single(sorted_rows([(elements, local[:corners]) for _, (_, elements, local) in alike], check), check)
        found, first = {}, 0
        for count, (block, elements, local) in alike:
            chosen = np.flatnonzero(single[first:first + len(elements)])
            found.setdefault(count, []).append((elements[chosen][:, local], np.full(len(chosen), block), chosen))
            first += len(elements)
        once += [tuple(map(np.concatenate, zip(*parts))) for _, parts in sorted(found.items(), key=lambda item: item[0])]
    return [part for part in once if len(part[0])]


def _single(rows, check):
    """bool (F,): which of the faces is there once."""
    single = np.empty(len(rows), dtype=bool)
    # The three lowest numbers tell faces apart: two elements that share three corners share the face.
    for chosen, begins in groups(rows, check, 3):
        single[chosen] = begins & np.append(begins[1:], True)
    return single
