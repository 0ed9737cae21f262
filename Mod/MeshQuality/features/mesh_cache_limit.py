# SPDX-License-Identifier: LGPL-2.1-or-later
"""Limits the mesh caches of all document objects together."""

import weakref

_MOST = 2**30  # bytes

_proxies = []  # weak references; the one used last at the end


def use(proxy):
    """Notes that the cache of a proxy was used. The least recently used caches are dropped where all of them
    together are too large.
    """
    # Each reference is asked once: a proxy may be collected at any time.
    others = [one for one in (ref() for ref in _proxies) if one is not None and one is not proxy]
    alive = [*others, proxy]
    _proxies[:] = [weakref.ref(one) for one in alive]
    total = 0
    for one in reversed(alive):
        total += one.cache.bytes if one.cache is not None else 0
        if total > _MOST:
            one.cache = None
