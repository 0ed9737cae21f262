# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of other programs as the core takes them to be curved."""

import numpy as np

from ..errors import InvalidInput
from .elements import kinds


def corners_of(mesh):
    """(nodes, triangles, tetrahedra, regions) of an ElementMesh: float64 (N, 3), int32 (T, 3), (E, 4) and (E,).

    Raises InvalidInput where it has other elements, which are not curved.
    """
    others = [block for block in mesh.blocks if block.kind not in ("line", "triangle", "tetrahedron")]
    if others:
        kind, count = others[0].kind, len(others[0].nodes)
        raise InvalidInput(f"the mesh has {count:,} {kinds.PLURALS[kind] if count != 1 else kind}: only triangles and "
                           "tetrahedra are curved; certify takes all kinds")
    tetrahedra = [block for block in mesh.blocks if block.kind == "tetrahedron"]
    triangles = [block.nodes[:, :3] for block in mesh.blocks if block.kind == "triangle"]
    return (mesh.nodes, _joined(triangles, 3), _joined([block.nodes[:, :4] for block in tetrahedra], 4),
            _joined([_regions_of(block) for block in tetrahedra], None))


def _regions_of(block):
    """A number a body: its CAD solid where the file says one, else its group."""
    return block.geometry if (block.geometry >= 0).any() else block.group


def _joined(parts, width):
    empty = np.empty(0 if width is None else (0, width), dtype=np.int32)
    return np.ascontiguousarray(np.concatenate([empty, *parts]), dtype=np.int32)
