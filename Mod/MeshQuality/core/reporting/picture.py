# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of coloured triangles without a window: parallel projection, a depth buffer, and PNG."""

import base64
import struct
import zlib

import numpy as np

AXONOMETRIC = np.array([1.0, -1.0, 0.9])  # from where a part is seen, as a direction
_FINER = 2  # pixels of the drawing along a side of a pixel of the picture
_MARGIN = 0.04
_LARGE = 32  # pixels: larger triangles are drawn one by one
_MOST_SAMPLES = 1_000_000  # pixels that are looked at at a time
_MOST_WITH_EDGES = 30_000  # triangles up to which edges are drawn
_EDGE = 0.7  # half the width of an edge, in pixels of the drawing
_FAR = np.iinfo(np.int64).max
_DEPTHS = 2**30
_DARK, _LIGHT = 0.45, 0.55  # share of the colour that any triangle has, and that those have more that face the eye


def png(corners, colours, size=(640, 480), direction=AXONOMETRIC, around=None, edges=True, lit=None):
    """The picture of triangles as the bytes of a PNG.

    corners    float (T, 3, 3), in one unit
    colours    float (T, 3), red, green, blue from 0 to 1
    size       (width, height), pixels
    direction  (3,): from where they are seen
    around     (point (3,), width): what the picture shows; None: everything
    edges      whether edges of triangles are drawn, where there are not too many
    lit        bool (T,): triangles that are magenta; None: none
    """
    pixels = drawn(np.asarray(corners, dtype=float), np.asarray(colours, dtype=float), size, direction, around, edges, lit)
    return _encoded(np.rint(255.0 * pixels).astype(np.uint8))


def as_source(data):
    """The bytes of a PNG as the source of an image in a page."""
    return "data:image/png;base64," + base64.b64encode(data).decode("ascii")


def drawn(corners, colours, size, direction, around, edges, lit):
    """float (height, width, 3) from 0 to 1; white where there is nothing."""
    width, height = _FINER * size[0], _FINER * size[1]
    right, up, back = _axes(direction)
    flat = np.stack([corners @ right, corners @ up], axis=2)
    scale, middle = _view(flat, around, (right, up), (width, height))
    places = (flat - middle) * (scale, -scale) + (0.5 * width, 0.5 * height)
    depth = corners @ -back
    nearest, wire = _buffers(places, depth, (width, height), edges and len(corners) <= _MOST_WITH_EDGES)
    found = np.ones((height * width, 3))
    seen = nearest != _FAR
    which = nearest[seen] & 0xffffffff
    shade = _DARK + _LIGHT * np.abs(_normals(corners) @ back)
    if lit is not None:
        colours = np.where(lit[:, None], (1.0, 0.13, 1.0), colours)
    found[seen] = colours[which] * shade[which, None]
    found[wire] *= 0.35
    return found.reshape(size[1], _FINER, size[0], _FINER, 3).mean(axis=(1, 3))


def _axes(direction):
    """Unit vectors to the right, up and towards the eye."""
    back = np.asarray(direction, dtype=float) / np.linalg.norm(direction)
    above = np.array([0.0, 0.0, 1.0]) if abs(back[2]) < 0.999 else np.array([0.0, 1.0, 0.0])
    right = np.cross(above, back)
    right /= np.linalg.norm(right)
    return right, np.cross(back, right), back


def _view(flat, around, axes, size):
    """(pixels by unit, the point in the middle): what is to be seen fits into the picture."""
    if around is not None:
        point, extent = around
        middle = np.array([np.dot(point, axis) for axis in axes])
        return min(size) / extent, middle
    low, high = flat.min(axis=(0, 1)), flat.max(axis=(0, 1))
    spans = np.maximum(high - low, 1e-12)
    return (1.0 - 2.0 * _MARGIN) * float(np.min(np.array(size) / spans)), 0.5 * (low + high)


def _normals(corners):
    found = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(found, axis=1, keepdims=True)
    return np.divide(found, lengths, out=np.zeros_like(found), where=lengths > 0.0)


def _buffers(places, depth, size, edges):
    """int64 (pixels,): depth and number of the nearest triangle, _FAR where there is none; and which pixels show its edge."""
    width, height = size
    nearest, wire = np.full(width * height, _FAR), np.zeros(width * height, dtype=bool)
    low = np.floor(places.min(axis=1)).astype(np.int64)
    high = np.ceil(places.max(axis=1)).astype(np.int64)
    visible = (high[:, 0] >= 0) & (high[:, 1] >= 0) & (low[:, 0] < width) & (low[:, 1] < height)
    extent = np.maximum((np.minimum(high, (width, height)) - np.maximum(low, 0)).max(axis=1), 1)
    span = float(np.ptp(depth)) or 1.0
    steps = (depth - depth.min()) / span * _DEPTHS
    start = np.maximum(low, 0)
    buffers = nearest, wire if edges else None
    side = 1
    while side < _LARGE:
        side *= 2
        chosen = np.flatnonzero(visible & (extent < side))
        visible[chosen] = False
        offset = np.stack(np.meshgrid(np.arange(side), np.arange(side)), axis=-1).reshape(-1, 2)
        block = max(1, _MOST_SAMPLES // (side * side))
        for first in range(0, len(chosen), block):
            part = chosen[first:first + block]
            _put(part, start[part][:, None] + offset, places, steps, size, buffers)
    for one in np.flatnonzero(visible):
        end = np.minimum(high[one] + 1, size)
        columns, rows = np.meshgrid(np.arange(start[one, 0], end[0]), np.arange(start[one, 1], end[1]))
        _put(np.array([one]), np.stack([columns, rows], axis=-1).reshape(1, -1, 2), places, steps, size, buffers)
    return nearest, wire


def _put(chosen, at, places, steps, size, buffers):
    """Draws triangles where they cover some of the pixels `at`, int (n, k, 2)."""
    nearest, wire = buffers
    a, b, c = (places[chosen, k][:, None] for k in range(3))
    points = at + 0.5
    areas = np.stack([_area(b, c, points), _area(c, a, points), _area(a, b, points)])
    whole = _area(a, b, c)
    inside = ((areas >= 0.0).all(axis=0) & (whole > 0.0) | (areas <= 0.0).all(axis=0) & (whole < 0.0)) & (at < size).all(axis=-1)
    row, column = np.nonzero(inside)
    if not len(row):
        return
    weights = areas[:, row, column].T / whole[row]
    deep = (weights * steps[chosen[row]]).sum(axis=1).astype(np.int64)
    keys = deep << 32 | chosen[row]
    pixel = at[row, column] @ np.array([1, size[0]])
    order = np.argsort(-keys, kind="stable")  # the nearest is written last
    order = order[keys[order] < nearest[pixel[order]]]
    nearest[pixel[order]] = keys[order]
    if wire is not None:
        sides = np.stack([np.linalg.norm(places[chosen, k - 1] - places[chosen, k - 2], axis=1) for k in range(3)], axis=1)
        heights = np.abs(whole[row]) / np.maximum(sides[row], 1e-9)
        is_edge = (weights * heights < _EDGE).any(axis=1)
        shown = order[nearest[pixel[order]] == keys[order]]
        wire[pixel[shown]] = is_edge[shown]


def _area(a, b, p):
    """Twice the signed area of a triangle in the plane."""
    return (b[..., 0] - a[..., 0]) * (p[..., 1] - a[..., 1]) - (b[..., 1] - a[..., 1]) * (p[..., 0] - a[..., 0])


def _encoded(pixels):
    """uint8 (height, width, 3) as PNG (RFC 2083)."""
    height, width, _ = pixels.shape
    rows = np.empty((height, 1 + 3 * width), dtype=np.uint8)
    rows[:, 0] = 0
    rows[:, 1:] = pixels.reshape(height, -1)
    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    chunks = ((b"IHDR", head), (b"IDAT", zlib.compress(rows.tobytes(), 9)), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data)) for kind, data in chunks)
