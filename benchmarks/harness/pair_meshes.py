# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pairs of meshes for Booleans, made from the files of $MESHQUALITY_DATA/mesh by random numbers: pair "near-12" is the
same mesh for the same seed, wherever it is made. All coordinates are single-precision numbers.

random   two files, each turned at random, whose surfaces meet; B is half to twice the size of A
near     a file, and a copy whose vertices are moved at random by up to 1e-6 to 1e-3 of the size
offset   a file, and a copy whose vertices are moved along their normals by 1e-4 to 1e-2 of the size
files    the pairs of files of $MESHQUALITY_DATA/boolean that are known to be hard

Even numbers are the share for developing; odd ones are for measuring only, and nobody looks at a single one of them.
`files` has even numbers only, as its pairs are known.
"""

import sys
from itertools import count
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import boolean_models
import mesh_files
import numpy as np

CLASSES = ("random", "near", "offset", "files")
SHARES = ("develop", "measure")
OPERATIONS = ("union", "intersection", "difference", "symmetric_difference")
FILES = ("needles582", "needles84", "twin")
SIZE = 100.0  # mm, diagonal of the box of A


def names(classes, share):
    """The names of the pairs of a share without end, class by class in turn."""
    for half in count():
        number = 2 * half + SHARES.index(share)
        for kind in classes:
            if kind != "files" or share == "develop" and half < len(FILES):
                yield f"{kind}-{number}"
        if list(classes) == ["files"] and half >= len(FILES):
            return


class Pairs:
    """Makes pairs by name; keeps the files that were read."""

    def __init__(self, data, seed):
        self.data, self.seed, self.known = Path(data), seed, {}
        self.files = sorted(path for path in (self.data / "mesh").iterdir() if path.is_file())

    def make(self, name):
        """((V, F), (V, F), what they are)."""
        kind, _, number = name.partition("-")
        number = int(number)
        dice = np.random.default_rng([self.seed, CLASSES.index(kind), number])
        if kind == "files":
            names = [f"{FILES[number // 2]}_{side}" for side in "ab"]
            paths = [self.data / "boolean" / f"{name}.ply.gz" for name in names]
            return *map(boolean_models.read, paths), " ".join(names)
        if kind == "random":
            return self._random(dice)
        path = self.files[number // 2 % len(self.files)]
        vertices, triangles = self._placed(path, dice, SIZE)
        if kind == "near":
            step = SIZE * 10 ** dice.uniform(-6, -3)
            moved = vertices + dice.uniform(-step, step, vertices.shape)
        else:
            step = SIZE * 10 ** dice.uniform(-4, -2) * dice.choice((-1, 1))
            moved = vertices + step * vertex_normals(vertices, triangles)
        return single(vertices, triangles), single(moved, triangles), f"{path.name} {step:.2g} mm"

    def _random(self, dice):
        one, other = (self.files[i] for i in dice.choice(len(self.files), 2))
        a = self._placed(one, dice, SIZE)
        b = self._placed(other, dice, SIZE * 2 ** dice.uniform(-1, 1))
        # A corner of B lies close to one of A, so that the surfaces are sure to be near each other.
        meet = dice.choice(a[0][np.unique(a[1])]) - dice.choice(b[0][np.unique(b[1])])
        shift = meet + dice.normal(size=3) * 0.01 * SIZE
        return single(*a), single(b[0] + shift, b[1]), f"{one.name} {other.name}"

    def _placed(self, path, dice, size):
        """A file's mesh, turned at random about the middle of its box, which has this diagonal."""
        if path not in self.known:
            self.known[path] = mesh_files.read(path)
        vertices, triangles = self.known[path]
        used = vertices[np.unique(triangles)]
        low, high = used.min(axis=0), used.max(axis=0)
        turn, _ = np.linalg.qr(dice.normal(size=(3, 3)))
        turn *= np.sign(np.linalg.det(turn))
        scaled = (vertices - (low + high) / 2) * (size / np.linalg.norm(high - low))
        return scaled @ turn.T, triangles


def single(vertices, triangles):
    return vertices.astype(np.float32).astype(float), triangles


def vertex_normals(vertices, triangles):
    """Unit normals, weighted by area; zero where there is none."""
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    normals = np.zeros_like(vertices)
    for corner in range(3):
        np.add.at(normals, triangles[:, corner], np.cross(b - a, c - a))
    lengths = np.linalg.norm(normals, axis=1)
    return normals / np.where(lengths > 0, lengths, 1.0)[:, None]


def volume(vertices, triangles):
    """Signed, about the middle of the vertices."""
    if not len(triangles):
        return 0.0
    a, b, c = (vertices[triangles[:, k]] - vertices.mean(axis=0) for k in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)
