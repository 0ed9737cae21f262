# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes that are no surfaces of solids, or are so in a way that is hard to see."""

import os
import tempfile

import Mesh
import numpy as np
import Part
from attack import Attack, check, with_patience

import MeshQuality as mq

CUBE = ((0, 2, 1), (0, 3, 2), (4, 5, 6), (4, 6, 7), (0, 1, 5), (0, 5, 4), (1, 2, 6), (1, 6, 5), (2, 3, 7), (2, 7, 6),
        (3, 0, 4), (3, 4, 7))
CORNERS = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], float)
MANY = 10**5


def cube(scale=1.0, at=0.0, inside_out=False):
    triangles = np.array(CUBE)
    return (CORNERS - 0.5) * scale + at, triangles[:, ::-1] if inside_out else triangles


def joined(meshes):
    """Several meshes in one pair of arrays."""
    starts = np.cumsum([0] + [len(vertices) for vertices, _ in meshes])
    return (np.concatenate([vertices for vertices, _ in meshes]),
            np.concatenate([triangles + start for (_, triangles), start in zip(meshes, starts)]))


def strip(around, along, surface, twisted):
    """A grid of quadrilaterals closed in the first direction, and in the second where `along` says so."""
    count, closed = along
    rows = count if closed else count + 1
    index = np.arange(around * rows).reshape(around, rows)
    following = np.roll(index, -1, axis=0)
    if twisted:
        following[-1] = np.roll(following[-1][::-1], 1) if closed else following[-1][::-1]
    right = np.roll(index, -1, axis=1)[:, :count], np.roll(following, -1, axis=1)[:, :count]
    left = index[:, :count], following[:, :count]
    triangles = np.concatenate([np.stack([left[0], right[0], right[1]], -1).reshape(-1, 3),
                                np.stack([left[0], right[1], left[1]], -1).reshape(-1, 3)])
    u, v = np.meshgrid(2 * np.pi * np.arange(around) / around, np.arange(rows) / count, indexing="ij")
    return np.stack(surface(u, v), -1).reshape(-1, 3), triangles


def moebius():
    def surface(u, v):
        r = 3 + (v - 0.5) * np.cos(u / 2)
        return r * np.cos(u), r * np.sin(u), (v - 0.5) * np.sin(u / 2)

    return strip(40, (6, False), surface, True)


def klein():
    def surface(u, v):
        v = 2 * np.pi * v
        r = 4 + np.cos(u / 2) * np.sin(v) - np.sin(u / 2) * np.sin(2 * v)
        return r * np.cos(u), r * np.sin(u), np.sin(u / 2) * np.sin(v) + np.cos(u / 2) * np.sin(2 * v)

    return strip(40, (20, True), surface, True)


def fan(count, closed=False):
    """Triangles around one vertex; closed: two fans back to back, a wheel."""
    angles = 2 * np.pi * np.arange(count) / count
    rim = np.stack([np.cos(angles), np.sin(angles), 0 * angles], -1)
    tips = [[0, 0, 1], [0, 0, -1]] if closed else [[0, 0, 1]]
    around = np.stack([np.arange(count), np.roll(np.arange(count), -1), np.full(count, count)], -1)
    triangles = np.concatenate([around, around[:, [1, 0, 2]] + [0, 0, 1]]) if closed else around
    return np.concatenate([rim, tips]), triangles


def t_junctions():
    """A cube one face of which is divided, its neighbours not."""
    vertices, triangles = cube()
    middle = len(vertices)
    vertices = np.concatenate([vertices, [(vertices[4] + vertices[6]) / 2, (vertices[4] + vertices[5]) / 2]])
    return vertices, np.concatenate([np.delete(triangles, [2, 3], 0),
                                     [[4, middle + 1, middle], [middle + 1, 5, middle], [5, 6, middle], [6, 7, middle],
                                      [7, 4, middle]]])


def projective_plane():
    """Six vertices, ten triangles, one side."""
    triangles = [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5), (0, 5, 1), (1, 2, 4), (2, 3, 5), (3, 4, 1), (4, 5, 2),
                 (5, 1, 3)]
    return np.random.default_rng(1).normal(size=(6, 3)), np.array(triangles)


def soup(count=300):
    vertices = np.random.default_rng(2).normal(size=(3 * count, 3))
    return vertices, np.arange(3 * count).reshape(-1, 3)


def pages(count=200):
    """A book: all triangles share an edge."""
    angles = 2 * np.pi * np.arange(count) / count
    vertices = np.concatenate([[[0, 0, 0], [0, 0, 1]],
                               np.stack([np.cos(angles), np.sin(angles), 0 * angles + 0.5], -1)])
    return vertices, np.stack([np.zeros(count, int), np.ones(count, int), np.arange(count) + 2], -1)


def spike(height):
    vertices, triangles = cube()
    vertices[6] = (0.5, 0.5, height)
    return vertices, triangles


MESHES = {
    "all vertices equal": lambda: (np.ones((8, 3)), np.array(CUBE)),
    "all on a line": lambda: (CORNERS * [1, 0, 0], np.array(CUBE)),
    "all in a plane": lambda: (CORNERS * [1, 1, 0], np.array(CUBE)),
    "one triangle 10^5 times": lambda: (CORNERS[:3], np.tile([[0, 1, 2]], (MANY, 1))),
    "one triangle and its back 10^5 times": lambda: (CORNERS[:3], np.tile([[0, 1, 2], [2, 1, 0]], (MANY // 2, 1))),
    "a cube 1000 times": lambda: joined([cube()] * 1000),
    "a fan of 10^5": lambda: fan(MANY),
    "a wheel of 10^4": lambda: fan(MANY // 10, closed=True),
    "a book of 200 pages": pages,
    "vertices at 1e300": lambda: cube(1e300),
    "vertices at 1e-300": lambda: cube(1e-300),
    "vertices at 1e38": lambda: cube(1e38),
    "vertices at 1e-38": lambda: cube(1e-38),
    "far away": lambda: cube(1.0, 1e9),
    "farther than single precision": lambda: cube(1e-3, 1e6),
    "two sizes, 1e-9 and 1e9": lambda: joined([cube(1e-9), cube(1e9)]),
    "nested 1000 deep": lambda: joined([cube(1 - i / 1001.0, 0.0, i % 2 == 1) for i in range(1000)]),
    "nested 1000 deep, none turned": lambda: joined([cube(1 - i / 1001.0) for i in range(1000)]),
    "inside out": lambda: cube(inside_out=True),
    "half turned": lambda: (CORNERS, np.array([t if i % 2 else t[::-1] for i, t in enumerate(CUBE)])),
    "a Moebius strip": moebius,
    "a Klein bottle": klein,
    "a projective plane": projective_plane,
    "triangle soup": soup,
    "cubes at a corner": lambda: joined([cube(), cube(1.0, 1.0)]),
    "cubes at an edge": lambda: joined([cube(), cube(1.0, np.array([1.0, 1.0, 0.0]))]),
    "cubes at a face": lambda: joined([cube(), cube(1.0, np.array([1.0, 0.0, 0.0]))]),
    "cubes one float apart": lambda: joined([cube(), cube(1.0, np.array([np.nextafter(1.0, 2.0), 0.0, 0.0]))]),
    "T-junctions": t_junctions,
    "a hole": lambda: (CORNERS, np.array(CUBE[1:])),
    "a single triangle": lambda: (CORNERS[:3], np.array([[0, 1, 2]])),
    "degenerate: a vertex twice": lambda: (CORNERS, np.concatenate([CUBE, [[0, 0, 1]]])),
    "degenerate: a vertex thrice": lambda: (CORNERS, np.array([[3, 3, 3]])),
    "vertices that nothing uses": lambda: (np.concatenate([CORNERS,
                                                           np.random.default_rng(1).normal(size=(MANY, 3)) * 1e6]),
                                           np.array(CUBE)),
    "a spike to 1e6": lambda: spike(1e6),
    "a spike through itself": lambda: spike(-7.0),
    "needles": lambda: fan(2000, closed=True),
    "no triangles": lambda: (CORNERS, np.zeros((0, 3), int)),
    "nothing": lambda: (np.zeros((0, 3)), np.zeros((0, 3), int)),
}
OTHER = (CORNERS * 0.7 + 0.1, np.array(CUBE))


def _written(mesh, progress):
    """Each format, written and removed; meshes of FreeCAD, too."""
    surface = mq.improve(mesh, progress=progress)
    with tempfile.TemporaryDirectory() as folder:
        for suffix in ("stl", "ply", "obj", "off", "msh", "vtu"):
            surface.write(os.path.join(folder, f"mesh.{suffix}"))
    check(surface.to_mesh().CountFacets == len(surface.triangles), "FreeCAD has other triangles")
    return surface


FACES = {
    "quality": lambda mesh, _: mq.quality(mesh),
    "quality against a box": lambda mesh, progress: mq.quality(mesh, Part.makeBox(1, 1, 1), progress),
    "improve": lambda mesh, progress: mq.improve(mesh, progress=progress),
    "improve to 34 degrees within 1e-6":
        lambda mesh, progress: mq.improve(mesh, min_angle=34.0, tolerance=1e-6, progress=progress),
    "write": _written,
    "union": lambda mesh, progress: mq.boolean(mesh, OTHER, "union", progress=progress),
    "difference from a box": lambda mesh, progress: mq.boolean(OTHER, mesh, "difference", progress=progress),
    "symmetric difference with itself":
        lambda mesh, progress: mq.boolean(mesh, mesh, "symmetric_difference", progress=progress),
    "union of one": lambda mesh, progress: mq.boolean([mesh], operation="union", progress=progress),
    "uniform": lambda mesh, progress: mq.boolean(mesh, OTHER, "intersection", method="uniform", resolution=64,
                                                 progress=progress),
    "Mesh.Mesh": lambda mesh, _: mq.quality(Mesh.Mesh([tuple(p) for t in mesh[1][:1000] for p in mesh[0][t]])),
}


def rows():
    return [Attack(f"{function}: {name}", lambda c=call, m=make: with_patience(lambda progress: c(m(), progress)))
            for name, make in MESHES.items() for function, call in FACES.items()]


def combined(dice):
    """Two of the meshes, moved, in one, or one with the other."""
    chosen = [dice.choice([name for name in MESHES if "10^" not in name and "1000" not in name]) for _ in range(2)]
    function, call = dice.choice(list(FACES.items()))
    scale, move = 10 ** dice.uniform(-3, 3), np.array([dice.uniform(-1, 1) for _ in range(3)])

    def attack():
        one, other = (MESHES[name]() for name in chosen)
        other = np.asarray(other[0]) * scale + move, other[1]
        if dice.random() < 0.5:
            with_patience(lambda progress: call(joined([one, other]), progress))
        else:
            with_patience(lambda progress: mq.boolean(one, other, dice.choice(("union", "difference")),
                                                      progress=progress))

    return Attack(f"{function}: {chosen[0]} and {chosen[1]} scaled by {scale:.3g}", attack)
