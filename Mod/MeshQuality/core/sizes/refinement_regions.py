# SPDX-License-Identifier: LGPL-2.1-or-later
"""Boxes in which a mesher of hexahedra divides its cells, by a size field."""

import numpy as np

from .forms import fields_of

_MOST_BLOCKS = 32  # along each side of the background
_MOST_BOXES = 400
_SAMPLES = (np.arange(2) + 0.5) / 2.0  # of a block, along each side


def refinement_boxes(size_field, low, high, cell, most_level):
    """[(low (3,), high (3,), level), ...], mm: cells of the length `cell` / 2^level fill the box.

    size_field  as for triangulate
    low, high   corners of the background, mm; cell: length of its cells, mm
    Blocks of cells have the least size that the field has at eight points inside, and of a field by points at all of these.
    """
    cells = np.maximum(np.ceil((high - low) / cell), 1).astype(int)
    width = int(np.ceil(cells.max() / _MOST_BLOCKS))
    blocks = -(-cells // width)
    levels = _levels(size_field, low, blocks, width * cell, cell, most_level)
    while True:
        boxes = [box for level in range(levels.max(initial=0), 0, -1) for box in _boxes(levels >= level, level)]
        if len(boxes) <= _MOST_BOXES:
            break
        width, levels = 2 * width, _halved(levels)
    return [(low + first * width * cell, np.minimum(low + last * width * cell, low + cells * cell), level) for first, last, level in boxes]


def _levels(size_field, low, blocks, length, cell, most_level):
    """int (x, y, z): how often cells are to be halved, by block."""
    axes = [low[k] + length * (np.arange(blocks[k])[:, None] + _SAMPLES).ravel() for k in range(3)]
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    least = np.full(blocks, np.inf)
    for field in fields_of(size_field):
        sizes = field.sizes(points).reshape(blocks[0], 2, blocks[1], 2, blocks[2], 2).min(axis=(1, 3, 5))
        least = np.minimum(least, np.where(np.isnan(sizes), np.inf, sizes))
        marks, lengths = field.marks()
        if len(marks):
            at = np.floor((marks - low) / length).astype(int)
            inside = ((at >= 0) & (at < blocks)).all(axis=1)
            np.minimum.at(least, tuple(at[inside].T), lengths[inside])
    with np.errstate(divide="ignore"):
        return np.clip(np.ceil(np.log2(cell / least) - 1e-9), 0, most_level).astype(int)


def _halved(levels):
    """The levels of blocks of twice the length: the largest of the eight."""
    padded = np.pad(levels, [(0, n % 2) for n in levels.shape])
    x, y, z = (n // 2 for n in padded.shape)
    return padded.reshape(x, 2, y, 2, z, 2).max(axis=(1, 3, 5))


def _boxes(wanted, level):
    """[(first block, block behind the last, level), ...] that cover the wanted blocks and no others."""
    left, found = wanted.copy(), []
    while left.any():
        first = np.array(np.unravel_index(int(np.argmax(left)), left.shape))
        last = first + 1
        for axis in range(3):
            while last[axis] < wanted.shape[axis]:
                behind = [slice(a, b) for a, b in zip(first, last)]
                behind[axis] = slice(last[axis], last[axis] + 1)
                if not wanted[tuple(behind)].all():
                    break
                last[axis] += 1
        left[tuple(slice(a, b) for a, b in zip(first, last))] = False
        found.append((first, last, level))
    return found
