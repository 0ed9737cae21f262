# SPDX-License-Identifier: LGPL-2.1-or-later
"""Groups of elements by the CAD entity that they lie on."""

import numpy as np

from . import kinds

_ENTITY = {1: "Edge", 2: "Face", 3: "Solid"}


def entity_groups(blocks):
    """{"Face1": ((block, rows), ...)} by what the blocks say as geometry."""
    members = {}
    for number, block in enumerate(blocks):
        for entity in np.unique(block.geometry[block.geometry >= 0]).tolist():
            name = f"{_ENTITY[kinds.DIMENSION[block.kind]]}{entity + 1}"
            rows = np.flatnonzero(block.geometry == entity).astype(np.int32)
            members[name] = (*members.get(name, ()), (number, rows))
    return dict(sorted(members.items(), key=lambda item: (-_dimension(item[1], blocks), item[0])))


def _dimension(parts, blocks):
    return kinds.DIMENSION[blocks[parts[0][0]].kind]
