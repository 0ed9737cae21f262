# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corners of a mesh that the shape does not have, as the mesher counts edges as one."""

import unittest

import FreeCAD
import MeshQuality as mq
import Part
from MeshQuality.core import verdict


def pad(gap, radius):
    """A pad on a box, this far from the front edge of the box, with one rounded corner: the strip beside it ends there."""
    box = Part.makeBox(100, 60, 5)
    foot = Part.makeBox(70, 40, 5, FreeCAD.Vector(30, gap, 5))
    edge, = (edge for edge in foot.Edges
             if all(abs(v.X - 30) < 1e-9 and abs(v.Y - gap) < 1e-9 for v in edge.Vertexes))
    return box.fuse(foot.makeFillet(radius, [edge]))


def corners(shape):
    """The angles between edges of each face, degrees; edges that go on smoothly make none."""
    for face in shape.Faces:
        for vertex in face.Vertexes:
            ways = []
            for edge in face.Edges:
                for t, sign in zip(edge.ParameterRange, (1, -1)):
                    if (edge.valueAt(t) - vertex.Point).Length < 1e-6:
                        ways.append(edge.tangentAt(t) * sign)
            for i, way in enumerate(ways):
                yield from (way.getAngle(other) * 57.29578 for other in ways[:i])


class IdentifiedCorners(unittest.TestCase):
    def test_they_are_not_the_shapes(self):
        shape = pad(0.002, 0.05)
        self.assertGreater(min(corners(shape)), 45)
        mesh = mq.triangulate(shape, chord_height=0.5, min_angle=25)
        self.assertTrue(mesh.report.exempt_reasons)
        for _, reason in mesh.report.exempt_reasons:
            self.assertEqual((reason.cause, reason.forced), ("identified_corner", False))
            self.assertEqual([name[:4] for name in reason.joined], ["Edge", "Edge"])
            self.assertAlmostEqual(reason.apart, 0.002, places=6)
            self.assertLess(reason.angle, 25)
        finding, = verdict.of_triangulation(mesh, True)
        self.assertFalse(finding.forced)
        self.assertRegex(str(finding.text),
                         r"triangle \d+ on Face\d\. Edge\d+ and Edge\d+ count as one, as they are no farther apart than "
                         r"0\.002 mm: that makes a corner of \d+\.\d+°, which the shape does not have and a smaller max\. "
                         r"deviation avoids, between Edge\d+ and Edge\d+ at Vertex\d+\.$")

    def test_a_smaller_deviation_avoids_them(self):
        report = mq.triangulate(pad(0.008, 0.05), chord_height=0.05, min_angle=25).report
        self.assertLess(report.detail, 0.008)
        self.assertEqual(report.exempt_reasons, [])
