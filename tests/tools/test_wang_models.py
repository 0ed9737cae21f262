# SPDX-License-Identifier: LGPL-2.1-or-later
"""benchmarks/boolean/wang_models.py: meshes have the numbers of triangles that are asked for, and stay what they are."""

import sys
import unittest
from unittest import mock

import documents
import numpy as np

sys.path.insert(0, str(documents.ROOT / "benchmarks" / "boolean"))

import wang_models  # noqa: E402


def octahedron():
    vertices = np.array([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)], float)
    triangles = np.array([(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)])
    return vertices, triangles


def volume(vertices, triangles):
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c))) / 6


class Halving(unittest.TestCase):
    def test_as_many_triangles_as_asked_for(self):
        for count in (8, 10, 64, 1000, 4096):
            vertices, triangles = wang_models.halve_longest(*octahedron(), count)
            self.assertEqual(len(triangles), count)
            self.assertEqual(len(vertices), count // 2 + 2)
            edges = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)
            directed = set(map(tuple, edges.tolist()))
            self.assertEqual(len(directed), 3 * count)
            self.assertEqual(directed, {(b, a) for a, b in directed})
            self.assertAlmostEqual(volume(vertices, triangles), 4 / 3, places=6)

    def test_longest_edges_first(self):
        vertices, triangles = octahedron()
        vertices[4] *= 20.0
        vertices, _ = wang_models.halve_longest(vertices, triangles, 12)
        self.assertTrue((vertices[6:, 2] == 10.0).all())


class Examples(unittest.TestCase):
    def test_every_example_has_its_models(self):
        self.assertEqual(set(wang_models.BY_NAME), set(wang_models._MADE))
        self.assertEqual([example.name for example in wang_models.named(["bunny"])], ["dragon - bunny"])

    def test_says_where_scans_are_looked_for(self):
        with mock.patch.dict("os.environ", {"MESHQUALITY_DATA": "/nowhere"}):
            with self.assertRaisesRegex(FileNotFoundError, "/nowhere/boolean/dragon277k.ply.gz .*MESHQUALITY_DATA"):
                wang_models.operands("dragon - bunny")

    def test_made_models_are_closed_and_turned_outward(self):
        for name in ("helix - slices", "ring U bars", "ring U ring"):
            for vertices, triangles in wang_models.operands(name):
                edges = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)
                directed = set(map(tuple, edges.tolist()))
                self.assertEqual(directed, {(b, a) for a, b in directed}, name)
                self.assertGreater(volume(vertices, triangles), 0.0, name)


if __name__ == "__main__":
    unittest.main()
