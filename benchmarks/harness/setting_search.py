# SPDX-License-Identifier: LGPL-2.1-or-later
"""The setting with which a rival that is not asked for a distance keeps one."""

import math

CRASHES = 2  # in turn, and no finer setting is tried


def coarsest(grid, distance, target):
    """The first of the grid, coarse to fine, whose distance is within the target.

    Distances fall by about 2 from one to the next, which tells where to look.
    """
    low, high, k, crashes = 0, len(grid), 2, 0
    while low < high and crashes < CRASHES:
        found = distance(grid[k])
        crashes = crashes + 1 if found is None else 0
        if found is not None and found <= target:
            high = k
        else:
            low = k + 1
        step = math.ceil(math.log2(found / target)) if found else 1
        k = min(max(low, k + step), high - 1)
    return grid[high] if high < len(grid) else None
