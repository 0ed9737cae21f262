# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arrays in fields of Coin's nodes, by pivy: it comes with every FreeCAD and fits its Coin, whereas C++ of ours would have to
be built for the Coin of each FreeCAD.
"""

import ctypes

import numpy as np
from pivy import coin


# By kind of field: the numbers of its memory, and how many an entry has.
_KINDS = {"MFVec3f": (np.float32, (3,)), "MFColor": (np.float32, (3,)), "MFInt32": (np.int32, ()), "MFUInt32": (np.uint32, ())}


def fill(field, rows):
    """Puts an array into a Coin field of as many points, colours or whole numbers, byte by byte: by way of lists that takes a
    hundred times as long.
    """
    number, shape = _KINDS[field.getTypeId().getName().getString()]
    rows = np.ascontiguousarray(rows, dtype=number).reshape(-1, *shape)
    field.setNum(len(rows))
    if len(rows):
        memory = field.startEditing()
        ctypes.memmove(int(getattr(memory, "this", memory)), rows.ctypes.data, rows.nbytes)
        field.finishEditing()


def unlit():
    """A node after which colours are drawn as they are."""
    light = coin.SoLightModel()
    light.model = coin.SoLightModel.BASE_COLOR
    return light


def separator(*children):
    """A separator that holds these nodes, whose drawing Coin caches."""
    node = coin.SoSeparator()
    node.renderCaching = coin.SoSeparator.ON
    for child in children:
        node.addChild(child)
    return node
