# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws triangle meshes as shaded wireframes with nothing but NumPy: no display, no OpenGL.

Every triangle is coloured by its smallest angle. A pixel inside a triangle knows its distance to
the three edges from its barycentric coordinates, which gives smooth lines of any width; edges
between two CAD faces are drawn heavier.
"""

import numpy as np

BACKGROUND = np.array([1.0, 1.0, 1.0])
LINE = np.array([0.13, 0.16, 0.20])
# Smallest angle in degrees -> colour: red is a sliver, blue is good.
SCALE_ANGLES = np.array([0.0, 8.0, 16.0, 25.0, 40.0, 60.0])
SCALE_COLOURS = np.array([
    [0.78, 0.11, 0.13], [0.93, 0.42, 0.20], [0.98, 0.80, 0.43],
    [0.62, 0.80, 0.89], [0.40, 0.66, 0.83], [0.33, 0.58, 0.80],
])
LIGHTS = ((np.array([-0.35, 0.55, 0.76]), 0.62), (np.array([0.80, 0.10, 0.59]), 0.25))
AMBIENT = 0.30


def smallest_angles(vertices, triangles):
    """The smallest angle of each triangle, in degrees; 0 for a degenerate one."""
    corners = np.asarray(vertices, dtype=float)[np.asarray(triangles)]
    angles = np.empty((len(corners), 3))
    for i in range(3):
        a = corners[:, (i + 1) % 3] - corners[:, i]
        b = corners[:, (i + 2) % 3] - corners[:, i]
        angles[:, i] = np.degrees(
            np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), np.einsum("ij,ij->i", a, b))
        )
    return angles.min(axis=1)


def colours(angles):
    """Colours of the scale, one row for each angle."""
    return np.stack(
        [np.interp(angles, SCALE_ANGLES, SCALE_COLOURS[:, i]) for i in range(3)], axis=-1
    )


def camera(azimuth=-55.0, elevation=28.0):
    """A rotation whose rows are right, up and towards the eye; z is up."""
    a, e = np.radians([azimuth, elevation])
    eye = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
    right = np.array([-np.sin(a), np.cos(a), 0.0])
    return np.stack([right, np.cross(eye, right), eye])


def render(vertices, triangles, faces, size=(900, 700), view=None, smooth=3):
    """The picture as an array (height, width, 3) of values in [0, 1].

    faces: the CAD face of each triangle; size: width and height in pixels; smooth: samples a pixel
    along each axis.
    """
    triangles = np.asarray(triangles)
    width, height = size[0] * smooth, size[1] * smooth
    points = np.asarray(vertices, dtype=float) @ (camera() if view is None else view).T
    screen = _fit(points, width, height)
    shade = _shade(points, triangles) * colours(smallest_angles(vertices, triangles)).T
    widths = np.where(_between_faces(triangles, faces), 2.6, 0.9) * smooth / 2.0
    image = np.broadcast_to(BACKGROUND, (height, width, 3)).copy()
    depth = np.full((height, width), -np.inf)
    for corners, colour, half_widths in zip(screen[triangles], shade.T, widths):
        _draw(image, depth, corners, colour, half_widths)
    return image.reshape(size[1], smooth, size[0], smooth, 3).mean(axis=(1, 3))


def _fit(points, width, height):
    """Points in pixels, centred, with a margin; the third coordinate is the depth in pixels."""
    low, high = points.min(axis=0), points.max(axis=0)
    scale = 0.94 * min(width / (high[0] - low[0]), height / (high[1] - low[1]))
    centred = (points - (low + high) / 2.0) * scale
    return centred * [1.0, -1.0, 1.0] + [width / 2.0, height / 2.0, 0.0]


def _shade(points, triangles):
    corners = points[triangles]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
    light = AMBIENT + sum(power * np.maximum(normal @ to, 0.0) for to, power in LIGHTS)
    return np.minimum(light, 1.0)


def _between_faces(triangles, faces):
    """Whether the edge opposite to each corner of each triangle borders on another CAD face."""
    edges = np.sort(np.stack([triangles[:, [1, 2]], triangles[:, [2, 0]], triangles[:, :2]], 1))
    flat = edges.reshape(-1, 2)
    _, index = np.unique(flat, axis=0, return_inverse=True)
    index = index.reshape(-1)
    owner = np.repeat(np.asarray(faces), 3)
    low = np.full(index.max() + 1, np.iinfo(np.int64).max)
    high = np.full(index.max() + 1, -1)
    np.minimum.at(low, index, owner)
    np.maximum.at(high, index, owner)
    alone = np.bincount(index) == 1
    return ((low != high) | alone)[index].reshape(-1, 3)


def _draw(image, depth, corners, colour, half_widths):
    """Paints one triangle with its edges where it is nearer than what is there."""
    (ax, ay), (bx, by), (cx, cy) = corners[:, :2]
    area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    if area >= -1e-9:  # y points down: a triangle that faces the eye runs clockwise
        return
    height, width = depth.shape
    x0, x1 = max(int(min(ax, bx, cx)), 0), min(int(max(ax, bx, cx)) + 2, width)
    y0, y1 = max(int(min(ay, by, cy)), 0), min(int(max(ay, by, cy)) + 2, height)
    x, y = np.arange(x0, x1) + 0.5, (np.arange(y0, y1) + 0.5)[:, None]
    u = ((bx - x) * (cy - y) - (by - y) * (cx - x)) / area
    v = ((cx - x) * (ay - y) - (cy - y) * (ax - x)) / area
    w = 1.0 - u - v
    z = u * corners[0, 2] + v * corners[1, 2] + w * corners[2, 2]
    window = depth[y0:y1, x0:x1]
    seen = (u >= -1e-9) & (v >= -1e-9) & (w >= -1e-9) & (z > window)
    if not seen.any():
        return
    line = np.zeros_like(z)
    for i, share in enumerate((u, v, w)):
        opposite = corners[(i + 2) % 3, :2] - corners[(i + 1) % 3, :2]
        distance = share * -area / max(np.hypot(*opposite), 1e-12)
        line = np.maximum(line, np.clip(half_widths[i] - distance + 0.5, 0.0, 1.0))
    mixed = colour + (0.75 * line)[..., None] * (LINE - colour)
    window[seen] = z[seen]
    image[y0:y1, x0:x1][seen] = mixed[seen]
