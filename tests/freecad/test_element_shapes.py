# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shapes of elements by their corners, against values known in closed form."""

import unittest

import numpy as np

from MeshQuality.core.elements import shapes

SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.0]])


def of(kind, corners):
    return shapes.shapes_of(kind, np.asarray(corners, dtype=float)[None])


class Shapes(unittest.TestCase):
    def check(self, found, angle, aspect, distortion, content):
        for name, wanted in (("angle", angle), ("aspect", aspect), ("distortion", distortion), ("content", content)):
            np.testing.assert_allclose(getattr(found, name)[0], wanted, rtol=1e-12, atol=1e-9, err_msg=name)

    def test_regular_elements(self):
        """All sides 1: distortion 1, and the angles and volumes of the books."""
        known = {"tetrahedron": (np.degrees(np.arccos(1 / 3)), np.sqrt(2) / 12), "hexahedron": (90.0, 1.0),
                 "pyramid": (np.degrees(np.arctan(np.sqrt(2))), np.sqrt(2) / 6), "prism": (60.0, np.sqrt(3) / 4),
                 "triangle": (60.0, np.sqrt(3) / 4), "quadrilateral": (90.0, 1.0)}
        for kind, (angle, content) in known.items():
            with self.subTest(kind):
                self.check(of(kind, shapes._REGULAR[kind]), angle, 1.0, 1.0, content)

    def test_the_corner_of_a_cube(self):
        """eta = |S|^2 / (3 det^(2/3)), here (3/2 + 3/2) ... = 2^(1/3) * 1.19 by hand: |S|^2 = 9/2, det = sqrt(2)."""
        found = of("tetrahedron", [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)])
        self.check(found, np.degrees(np.arccos(1 / np.sqrt(3))), np.sqrt(2), 4.5 / (3 * 2 ** (1 / 3)), 1 / 6)

    def test_a_box_and_one_inside_out(self):
        box = np.concatenate([SQUARE, SQUARE + (0, 0, 1)]) * (4, 1, 1)
        self.check(of("hexahedron", box), 90.0, 4.0, 18 / (3 * 4 ** (2 / 3)), 4.0)
        turned = of("hexahedron", box * (1, 1, -1))
        self.check(turned, 90.0, 4.0, np.inf, -4.0)

    def test_a_flat_one(self):
        flat = of("tetrahedron", [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)])
        self.check(flat, 0.0, np.sqrt(2), np.inf, 0.0)

    def test_a_triangle_agrees_with_its_closed_form(self):
        """Sum of the squared edges / (4 sqrt(3) area), see curve/output/shape_distortion.h."""
        self.check(of("triangle", [(0, 0, 0), (3, 0, 0), (0, 0, 4)]), np.degrees(np.arctan(0.75)), 5 / 3, 50 / (4 * np.sqrt(3) * 6), 6.0)
