# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rows of corners that are the same: faces that two elements have, elements that are there twice. They are found by a share of all rows at a time:
that is faster, as a share stays in the processor's cache, and a check, which may raise Cancelled, is called every few hundredths of a second.
"""

import numpy as np

AT_A_TIME = 25_000  # rows


def shares(count, size=None):
    """Slices of `count` rows, a share of at most `size` or AT_A_TIME each."""
    size = size or AT_A_TIME
    return [slice(start, min(start + size, count)) for start in range(0, count, size)]


def sorted_rows(parts, check=lambda: None):
    """int32 (R, k): the rows of all parts, the numbers of each in order.

    parts  [(int (E, corners), which k of these), ...]
    """
    found = np.empty((sum(len(rows) for rows, _ in parts), len(parts[0][1])), dtype=np.int32)
    start = 0
    for rows, local in parts:
        for share in shares(len(rows)):
            check()
            found[start + share.start:start + share.stop] = _in_order([rows[share, column] for column in local])
        start += len(rows)
    return found


def _in_order(columns):
    """Each row in order; faces by exchanges, which are faster than sorting for rows as short as these."""
    if len(columns) > 4:
        return np.sort(np.stack(columns, axis=1), axis=1)
    pairs = ((0, 1), (1, 2), (0, 1)) if len(columns) == 3 else ((0, 1), (2, 3), (0, 2), (1, 3), (1, 2))
    for a, b in pairs:
        columns[a], columns[b] = np.minimum(columns[a], columns[b]), np.maximum(columns[a], columns[b])
    return np.stack(columns, axis=1)


def groups(rows, check=lambda: None, columns=None):
    """Yields (int (n,), bool (n,)): rows in ascending order, the same ones in that of their numbers, and where another row than the one before
    begins. All of the same rows come at once.

    rows     int (R, k), from 0 on
    columns  how many numbers tell rows apart, the first ones; None: all
    """
    if not len(rows):
        return
    count = int(rows.max()) + 1
    share_of = (np.cumsum(np.bincount(rows[:, 0], minlength=count)) // AT_A_TIME).astype(np.uint16)
    check()
    share = share_of[rows[:, 0]]
    check()
    order, ends = np.argsort(share, kind="stable"), np.cumsum(np.bincount(share))
    for start, end in zip([0, *ends[:-1]], ends):
        check()
        if start == end:
            continue
        chosen = order[start:end]
        keys = _packed(rows[chosen, :columns], count)
        at = np.lexsort(keys[::-1])
        begins = np.zeros(len(at), dtype=bool)
        begins[0] = True
        for key in keys:
            key = key[at]
            begins[1:] |= key[1:] != key[:-1]
        yield chosen[at], begins


def _packed(rows, count):
    """[int64 (n,), ...]: as few numbers as hold the rows of numbers below count, in the same order."""
    bits = max(count.bit_length(), 1)
    together, found = max(63 // bits, 1), []
    for first in range(0, rows.shape[1], together):
        key = rows[:, first].astype(np.int64)
        for column in range(first + 1, min(first + together, rows.shape[1])):
            key = key << bits | rows[:, column]
        found.append(key)
    return found


def unique_pairs(pairs):
    """(int (E, 2), int (E,)): each pair once, ascending, and how often it is there; faster than np.unique by rows."""
    keys, counts = np.unique(pairs[:, 0].astype(np.int64) << 32 | pairs[:, 1], return_counts=True)
    return np.column_stack([keys >> 32, keys & 0xFFFFFFFF]).astype(pairs.dtype), counts
