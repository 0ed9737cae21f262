# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes that benchmarks make themselves: points and triangles as arrays."""

import numpy as np


def sphere(level, radius=1.0, centre=(0.0, 0.0, 0.0)):
    """(V, F) of an octahedron refined `level` times on the sphere."""
    vertices = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], float)
    triangles = np.array([[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4],
                          [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]])
    for _ in range(level):
        sides = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        edges, index = np.unique(sides, axis=0, return_inverse=True)
        middle = index.reshape(-1, 3) + len(vertices)
        new = vertices[edges].sum(axis=1)
        vertices = np.vstack([vertices, new / np.linalg.norm(new, axis=1)[:, None]])
        a, b, c = triangles.T
        ab, bc, ca = middle.T
        triangles = np.vstack([np.stack(t, axis=1) for t in
                               ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))])
    return (radius * vertices + np.asarray(centre)).astype(np.float32), triangles.astype(np.int32)


def shaken_sphere(level):
    """Of 8 * 4**level triangles."""
    vertices, triangles = sphere(level)
    shake = np.random.default_rng(1).uniform(-0.4, 0.4, vertices.shape) / 2 ** level
    vertices = vertices + shake
    return vertices / np.linalg.norm(vertices, axis=1)[:, None], triangles


def needle_cylinder(sides, height=2.0):
    """Closed, of 4 * sides - 4 triangles: two to a side, and a fan at either end."""
    angle = 2 * np.pi * np.arange(sides) / sides
    ring = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    vertices = np.vstack([np.c_[ring, np.zeros(sides)], np.c_[ring, np.full(sides, height)]])
    i = np.arange(sides)
    j = (i + 1) % sides
    ends = np.stack([np.zeros(sides - 2, int), j[1:-1], i[1:-1]], axis=1)
    triangles = np.vstack([np.stack([i, j, j + sides], axis=1),
                           np.stack([i, j + sides, i + sides], axis=1),
                           ends, ends[:, [0, 2, 1]] + sides])
    return vertices, triangles


def row_of_cylinders(level):
    """4**level / 32 cylinders of 256 triangles each, side by side."""
    vertices, triangles = needle_cylinder(65)
    count = 4 ** level // 32
    shifts = np.c_[3.0 * np.arange(count), np.zeros((count, 2))]
    return ((vertices + shifts[:, None]).reshape(-1, 3),
            (triangles + len(vertices) * np.arange(count)[:, None, None]).reshape(-1, 3))


def crumpled_sheet(level):
    """Of 8 * 4**level triangles, three times as long as wide, whose points are lifted at random."""
    cells = 2 ** (level + 1)
    x, y = np.meshgrid(np.arange(cells + 1), np.arange(cells + 1))
    lift = np.random.default_rng(2).uniform(0.0, 1.5, x.size)
    vertices = np.stack([x.ravel(), 3.0 * y.ravel(), lift], axis=1)
    a = (x[:-1, :-1] + y[:-1, :-1] * (cells + 1)).ravel()
    c = a + cells + 2
    return vertices, np.vstack([np.stack([a, a + 1, c], axis=1), np.stack([a, c, c - 1], axis=1)])


def box(size, place):
    """(V, F) of a box with a corner at `place`."""
    corners = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
    triangles = [[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4],
                 [2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5]]
    return (corners * size + place).astype(np.float32), np.array(triangles, np.int32)
