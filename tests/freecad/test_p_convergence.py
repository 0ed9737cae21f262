# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finite elements on curved meshes: the error falls with the order, less so with straight sides."""

import importlib.util
import os
import sys
import unittest

import helpers
import numpy as np

sys.path.append(os.path.join(helpers.ROOT, "benchmarks", "curve"))


@unittest.skipUnless(importlib.util.find_spec("scipy"), "SciPy is not installed")
class PConvergence(unittest.TestCase):
    def test_curved_elements_gain_with_each_order(self):
        import poisson

        rows = poisson.study((1, 2, 3))
        table = {name: [row[i] for row in rows] for i, name in enumerate(poisson.COLUMNS)}
        self.assertEqual(len(set(table["elements"])), 1, "one mesh for all orders")
        for name in ("curved_l2", "curved_h1"):
            self.assertLess(table[name][1], table[name][0] / 4, name)
            self.assertLess(table[name][2], table[name][1] / 8, name)
        self.assertGreater(table["straight_l2"][1], 2 * table["curved_l2"][1])
        self.assertGreater(table["straight_l2"][2], 20 * table["curved_l2"][2])

    def test_the_finite_elements_reproduce_polynomials(self):
        import poisson

        rng = np.random.default_rng(3)
        points, weights = poisson.quadrature(5)
        self.assertAlmostEqual(weights.sum(), 1 / 6, places=14)
        self.assertAlmostEqual((weights * points[:, 0] ** 3 * points[:, 2] ** 2).sum(),
                               6 * 2 / 40320, places=16)
        lattice = np.array([(i, j, k) for i in range(4) for j in range(4 - i)
                            for k in range(4 - i - j)]) / 3
        element = poisson.Element(3, lattice)
        x = rng.random((5, 3)) / 3
        np.testing.assert_allclose(element.values(x) @ lattice[:, 0] ** 3, x[:, 0] ** 3, atol=1e-13)
        slope = np.einsum("qnx,n->qx", element.gradients(x), lattice[:, 0] * lattice[:, 1] ** 2)
        np.testing.assert_allclose(slope[:, 1], 2 * x[:, 0] * x[:, 1], atol=1e-12)

    def test_the_solution_solves_the_equation(self):
        import poisson

        rng = np.random.default_rng(5)
        x = np.array([1.0, 0.2, 0.1]) + 0.2 * rng.random((20, 3))
        step = 1e-4
        value, slope, source = poisson.solution(x)
        laplace = np.zeros(len(x))
        for axis in np.eye(3):
            ahead, _, _ = poisson.solution(x + step * axis)
            behind, _, _ = poisson.solution(x - step * axis)
            np.testing.assert_allclose((ahead - behind) / (2 * step), slope @ axis, atol=1e-6)
            laplace += (ahead - 2 * value + behind) / step ** 2
        np.testing.assert_allclose(-laplace, source, atol=1e-5)
