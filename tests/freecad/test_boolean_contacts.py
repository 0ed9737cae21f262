# SPDX-License-Identifier: LGPL-2.1-or-later
"""Booleans of solids that touch, beside what OpenCASCADE makes of them."""

import math
import unittest

import FreeCAD
import MeshQuality as mq
import numpy as np
import Part
from parts.contact_pairs import KINDS, OPERATIONS, components, contact_pair, disagreement

V = FreeCAD.Vector


def shortest_edge(mesh):
    corners = mesh.vertices[mesh.triangles]
    return float(np.linalg.norm(corners - np.roll(corners, -1, axis=1), axis=2).min())


class RandomContacts(unittest.TestCase):
    """The first pairs of each kind; benchmarks/boolean/boolean_contacts.py runs thousands."""

    def check(self, kind):
        for seed in range(2):
            pair = contact_pair(kind, seed)
            operands = (pair.first, pair.displaced)
            if seed % 2:
                operands = tuple(mq.triangulate(shape, chord_height=0.5 * pair.tolerance).to_mesh() for shape in operands)
            for operation in OPERATIONS:
                with self.subTest(kind=kind, seed=seed, operation=operation):
                    result = mq.boolean(*operands, operation, tolerance=pair.tolerance, method="exact")
                    self.assertEqual(disagreement(pair, operation, result), "")


def _test_of(kind):
    return lambda self: self.check(kind)


for _kind in KINDS:
    setattr(RandomContacts, f"test_{_kind}", _test_of(_kind))


class Contacts(unittest.TestCase):
    def test_a_cone_on_a_cylinder(self):
        right = math.pi * 64 + 2 * math.pi * 8 * 20 + math.pi * 8 * math.hypot(8, 5)
        for tolerance in (0.5, 0.1, 0.02):
            with self.subTest(tolerance=tolerance):
                result = mq.boolean(Part.makeCylinder(8, 20), Part.makeCone(8, 0, 5, V(0, 0, 20)), "union",
                                    tolerance=tolerance)
                self.assertAlmostEqual(result.report.area, right, delta=50 * tolerance)
                self.assertEqual(components(result.triangles), 1)

    def test_equal_cylinders_upon_each_other_make_no_needles(self):
        result = mq.boolean(Part.makeCylinder(10, 20), Part.makeCylinder(10, 15, V(0, 0, 20)), "union")
        self.assertGreater(shortest_edge(result), 35 * 2.0**-24)
        self.assertFalse(result.to_mesh().hasSelfIntersections())

    def test_many_operands(self):
        """A shaft of three pieces in a bore through three plates, all in contact."""
        bore = Part.makeCylinder(4, 30)
        plates = [Part.makeBox(20, 20, 10, V(-10, -10, z)).cut(bore) for z in (0, 10, 20)]
        pieces = [Part.makeCylinder(4, 10, V(0, 0, z)) for z in (0, 10, 20)]
        result = mq.boolean([*plates, *pieces], operation="union", tolerance=0.05)
        self.assertEqual(components(result.triangles), 1)
        self.assertAlmostEqual(result.report.area, 2 * 400 + 4 * 20 * 30, delta=5.0)
        self.assertAlmostEqual(result.report.volume, 12000.0, delta=10.0)

    def test_curved_faces_in_contact_keep_the_tolerance(self):
        """What moves is not in the result of a union, so that it does not count."""
        for kind in ("cylinder", "cone", "sphere", "torus", "spline"):
            with self.subTest(kind=kind):
                pair = contact_pair(kind, 9000)
                report = mq.boolean(pair.first, pair.displaced, "union", tolerance=pair.tolerance).report
                self.assertLessEqual(report.error_bound, pair.tolerance)
                self.assertGreater(report.closed_gaps, 0.0)
                self.assertLessEqual(report.closed_gaps, 2.0 * pair.tolerance)

    def test_an_expression(self):
        """A boss on a plate, less a shaft that fills its bore."""
        plate, boss = Part.makeBox(30, 30, 5, V(-15, -15, -5)), Part.makeCylinder(8, 12)
        shaft = Part.makeCylinder(8, 20)
        result = ((mq.Solid(plate) | mq.Solid(boss)) - mq.Solid(shaft)).evaluate(tolerance=0.05)
        self.assertAlmostEqual(result.report.volume, 4500.0, delta=15.0)
        self.assertEqual(components(result.triangles), 1)
