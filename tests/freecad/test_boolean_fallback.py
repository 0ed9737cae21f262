# SPDX-License-Identifier: LGPL-2.1-or-later
"""Booleans whose operands have no exact result: sampled along rays, and saying so."""

import json
import math
import os
import unittest

import helpers
import Mesh
import numpy as np
import Part
from FreeCAD import Vector
from test_cli import run

import MeshQuality as mq
from MeshQuality.compat import extension
from MeshQuality.core.certify import verdict


def points_of(points):
    return np.array([(p.x, p.y, p.z) for p in points], np.float32)


def bowl(height=0.1, radius=1.0, sampling=60):
    """A sphere without what is above a height: more than a third of its surface is missing, which no repair fills."""
    points, facets = Mesh.createSphere(radius, sampling).Topology
    points, facets = points_of(points), np.array(facets, np.int32)
    return points, facets[points[facets].mean(axis=1)[:, 2] < height]


def verify(result):
    """{kind of fault: number}, found by an exact search."""
    return extension().verify(result._surface)


BALL = 4.0 / 3.0 * math.pi


class Fallback(unittest.TestCase):
    def sampled(self, result):
        """Checks a result by method uniform."""
        report = result.report
        self.assertEqual(report.method, "uniform")
        self.assertTrue(report.closed and report.oriented and report.manifold, str(report))
        self.assertGreater(report.error_bound, 0.0)
        # The surface of a guess begins at the steps of a border, some of which are thinner than the distance between rays.
        self.assertLessEqual(report.error_bound, report.tolerance_asked * (2.0 if report.guessed_share else 1.0))
        if report.guessed_share:
            self.assertTrue(verdict.of_boolean(result))  # a guess is never called met, however large its bound is
        self.assertFalse(any(verify(result).values()), verify(result))
        return report

    def test_an_open_operand_is_sampled_and_the_report_says_why(self):
        tool = Mesh.createBox(1.0, 3.0, 3.0)
        report = self.sampled(mq.boolean(bowl(), tool, "difference", resolution=128))
        self.assertIn("method       uniform", str(report))
        self.assertIn("sampled along rays (method uniform), as there is no exact result: operand A is an open surface",
                      report.notes[0])
        self.assertTrue(any("open, as no repair closes it: operand A" in note for note in report.notes), report.notes)
        self.assertGreater(report.guessed_share, 0.05)
        self.assertLess(report.guessed_share, 0.5)
        self.assertGreater(report.retained, 100)

    def test_exact_raises_and_default_is_exact_where_it_can_be(self):
        tool = Mesh.createBox(1.0, 3.0, 3.0)
        with self.assertRaisesRegex(mq.InvalidInput, "operand A is an open surface: a border of .* close it"):
            mq.boolean(bowl(), tool, "difference", method="exact")
        ball = Mesh.createSphere(1.0, 40)
        results = [mq.boolean(ball, tool, "difference", method=method) for method in ("default", "exact")]
        for result in results:
            self.assertEqual(result.report.method, "exact")
            self.assertEqual(result.report.guessed_share, 0.0)
            self.assertFalse(any("uniform" in note for note in result.report.notes))
        self.assertTrue(np.array_equal(results[0].vertices, results[1].vertices))
        self.assertTrue(np.array_equal(results[0].triangles, results[1].triangles))

    def test_small_holes_stay_exact(self):
        points, facets = Mesh.createSphere(1.0, 40).Topology
        report = mq.boolean((points_of(points), np.array(facets, np.int32)[:-3]), Mesh.createBox(1.0, 3.0, 3.0),
                            "difference").report
        self.assertEqual(report.method, "exact")
        self.assertIn("hole", report.repaired[0])

    def test_the_volume_of_a_bowl_is_that_of_its_winding_number(self):
        # Missing is a cap of height 0.3: the guess spans it between the plane of its rim and the sphere.
        volume = self.sampled(mq.boolean([bowl(0.2)], operation="union", resolution=256, method="uniform")).volume
        below = math.pi * 1.2**2 * (1.0 - 1.2 / 3.0)
        self.assertGreater(volume, 0.85 * below)
        self.assertLess(volume, BALL)

    def test_errors_of_arguments_and_cancelling_do_not_fall_back(self):
        tool = Mesh.createBox(1.0, 3.0, 3.0)
        with self.assertRaisesRegex(mq.InvalidInput, "not a finite number"):
            points, facets = bowl()
            points[0] = math.nan
            mq.boolean((points, facets), tool, "union")
        with self.assertRaisesRegex(mq.InvalidInput, "tolerance"):
            mq.boolean(bowl(), tool, "union", tolerance=-1.0)
        with self.assertRaisesRegex(mq.InvalidInput, "method"):
            mq.boolean(bowl(), tool, "union", method="sampled")
        with self.assertRaises(mq.Cancelled):
            mq.boolean(bowl(), tool, "union", progress=lambda fraction, stage: stage != "winding numbers")

    def test_where_rays_do_not_suffice_both_reasons_are_told(self):
        with self.assertRaisesRegex(mq.InvalidInput, "open surface.*sampling it along rays fails, too: tolerance is"):
            mq.boolean(bowl(), Mesh.createBox(1.0, 3.0, 3.0), "union", tolerance=1e-4)

    def test_an_open_shell_of_cad_faces(self):
        box = Part.makeBox(10.0, 10.0, 10.0)
        shell = Part.Shell([face for face in box.Faces if face.CenterOfMass.z < 9.0 and face.CenterOfMass.x < 9.0])
        report = self.sampled(mq.boolean(shell, Part.makeSphere(3.0, Vector(0, 0, 0)), "difference", resolution=64))
        self.assertGreater(report.guessed_share, 0.1)
        self.assertGreater(report.volume, 300.0)
        self.assertLess(report.volume, 1000.0)

    def test_triangles_of_a_dirty_operand_that_cross_are_divided(self):
        points, facets = Mesh.createSphere(1.0, 60).Topology
        points, facets = points_of(points), np.array(facets, np.int32)
        middle = len(points) // 2
        near = np.argsort(np.linalg.norm(points - points[middle], axis=1))
        points[middle] += np.float32(1.6) * (points[near[12]] - points[middle])  # across its neighbours, less than a ray wide
        dirty = mq.boolean([(points, facets)], operation="union", method="uniform", resolution=32)
        far = Mesh.createSphere(1.0, 30)
        far.translate(5.0, 0.0, 0.0)
        result = mq.boolean((points, facets[5:]), far, "union", method="uniform", resolution=64)
        for made in (dirty, result):
            self.assertGreater(made.report.crossing_pairs, 0)
            self.assertFalse(any(verify(made).values()), verify(made))
            self.assertGreater(made.report.retained, len(facets) // 2)
        self.assertEqual(result.report.components, 2)
        self.assertEqual(result.report.operand_components, [1, 1])
        self.assertEqual(result.report.operand_euler[1], 2)
        self.assertNotEqual(result.report.operand_euler[0], 2)  # holes
        self.assertIn("operands     1 component, Euler number", str(result.report))

    def test_the_error_bound_of_what_rays_miss_is_measured(self):
        # A rod between the rays is lost, which a bound by the distance between rays does not tell.
        rod = Mesh.createBox(10.0, 0.01, 0.01)
        rod.translate(0.0, 0.1371, 0.0873)
        block = Mesh.createBox(2.0, 2.0, 2.0)
        block.translate(20.0, 0.0, 0.0)
        lost = mq.boolean(rod, block, "union", method="uniform", resolution=32)
        self.assertGreater(lost.report.error_bound, lost.report.tolerance_asked)
        self.assertGreater(lost.report.error_bound, 1.0)
        self.assertIn("Max. deviation", " ".join(str(finding.text) for finding in verdict.of_boolean(lost)))
        kept = mq.boolean(Mesh.createSphere(1.0, 40), block, "union", method="uniform", resolution=64)
        self.assertLessEqual(kept.report.error_bound, kept.report.tolerance_asked)
        self.assertEqual(verdict.of_boolean(kept), [])

    def test_solids_and_many_operands(self):
        balls = [Mesh.createSphere(1.0, 30) for _ in range(4)]
        for k, ball in enumerate(balls):
            ball.translate(0.9 * k, 0.2 * k, 0.1)
        at_once = self.sampled(mq.boolean(balls, operation="union", method="uniform", resolution=256))
        exact = mq.boolean(balls, operation="union").report
        self.assertAlmostEqual(at_once.volume / exact.volume, 1.0, delta=1e-3)
        solid = mq.Solid(bowl()) - Mesh.createBox(1.0, 3.0, 3.0) | balls[3]
        self.sampled(solid.evaluate(resolution=128))


class FallbackInTheDocument(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        points, facets = bowl()
        self.bowl = Mesh.Mesh([[tuple(map(float, points[i])) for i in facet] for facet in facets])
        self.tool = Mesh.createBox(1.0, 3.0, 3.0)

    def test_the_certificate_of_an_object_says_how_much_is_a_guess(self):
        a, b = (self.document.addObject("Mesh::Feature", name) for name in ("Bowl", "Tool"))
        a.Mesh, b.Mesh = self.bowl, self.tool
        obj = mq.add_boolean(a, b, "difference", resolution=64)
        self.assertTrue(any("no exact result: operand A" in note for note in obj.Notes), obj.Notes)
        self.assertIn("% of the surface is a guess", obj.Certificate)
        obj.Method = "exact"
        self.document.recompute()
        self.assertIn("open surface", obj.getStatusString())

    def test_command_line(self):
        first, second, out = (os.path.join(self.folder, name) for name in ("bowl.stl", "tool.stl", "out.stl"))
        self.bowl.write(first)
        self.tool.write(second)
        command = ("boolean", first, second, "-o", out, "--operation", "difference", "--resolution", 64, "--json")
        _, text, _ = run(*command)
        report = json.loads(text)
        self.assertEqual(report["method"], "uniform")
        self.assertGreater(report["guessed_share"], 0.05)
        self.assertEqual(Mesh.Mesh(out).CountFacets, report["triangles"])
        status, _, err = run(*command, "--method", "exact")
        self.assertEqual(status, 2)
        self.assertIn("open surface", " ".join(err))
