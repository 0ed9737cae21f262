# SPDX-License-Identifier: LGPL-2.1-or-later
"""Elements from elsewhere are checked by the core, of any kind."""

import unittest

import numpy as np

from MeshQuality import _core, errors

CUBE = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
                 (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)], float)
VALID, FOLDED, INVERTED = 0, 1, 2


class Elements(unittest.TestCase):
    def test_verdicts(self):
        pushed = CUBE.copy()
        pushed[6] = 0.6, 0.6, 0.6
        nodes = np.vstack([CUBE, pushed])
        first = np.arange(8, dtype=np.int32)
        rows = np.array([first, first + 8, np.roll(first, 4)])
        low, high, verdict = _core.check_elements("hexahedron", 1, nodes, rows)
        self.assertEqual(verdict.tolist(), [VALID, FOLDED, INVERTED])
        self.assertEqual(verdict.dtype, np.uint8)
        self.assertGreater(low[0], 1.0 - 1e-9)
        self.assertLessEqual(low[1], -0.2)
        self.assertGreaterEqual(high[1], -0.2)
        self.assertEqual(low[2], -1.0)

    def test_progress_and_cancelling(self):
        rows = np.arange(8, dtype=np.int32).reshape(1, 8)
        seen = []
        _core.check_elements("hexahedron", 1, CUBE, rows,
                             lambda fraction, stage: seen.append(fraction))
        self.assertEqual(seen[-1], 1.0)
        with self.assertRaises(errors.Cancelled):
            _core.check_elements("hexahedron", 1, CUBE, rows, lambda fraction, stage: False)

    def test_faults_are_named(self):
        rows = np.arange(8, dtype=np.int32).reshape(1, 8)
        for kind, order, nodes, elements, text in [
                ("wedge", 1, CUBE, rows, "no elements of kind"),
                ("hexahedron", 2, CUBE, rows, "has 27 nodes, or 20"),
                ("hexahedron", 6, CUBE, rows, "order of 1 to 5"),
                ("hexahedron", 1, CUBE[:, :2], rows, "nodes must have 3 numbers in each row"),
                ("hexahedron", 1, CUBE, rows.ravel(), "in each row"),
                ("hexahedron", 1, CUBE, rows + 1, "names node 8")]:
            with self.subTest(text), self.assertRaisesRegex(errors.InvalidInput, text):
                _core.check_elements(kind, order, nodes, elements)
