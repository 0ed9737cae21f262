# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all document objects together remember of their last meshes: not more than there is room for."""

import weakref

_MOST = 2**30  # bytes

_proxies = []  # weak references; the one used last at the end


def use(proxy):
    """Notes that the memory of a proxy was used; those go that were used least lately, where all of
    them are too large.
    """
    others = [ref for ref in _proxies if ref() is not None and ref() is not proxy]
    _proxies[:] = [*others, weakref.ref(proxy)]
    total = 0
    for one in [ref() for ref in reversed(_proxies)]:
        total += one.memory.bytes if one.memory is not None else 0
        if total > _MOST:
            one.memory = None
