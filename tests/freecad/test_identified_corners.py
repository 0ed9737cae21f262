# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corners of a mesh that the shape does not have, as edges or vertices closer than the detail count as one."""

import math
import unittest

import FreeCAD
import MeshQuality as mq
import Part
from MeshQuality.core.certify import verdict


def notched(step, radius, turn):
    """A sheet of 100 x 60 mm: a line, a step this high, and an arc that begins in the direction of the line."""
    turned = [FreeCAD.Vector(radius * math.sin(angle), step + radius * (1 - math.cos(angle)), 0)
              for angle in (0, turn / 2, turn)]
    way = FreeCAD.Vector(math.cos(turn), math.sin(turn), 0)
    points = [turned[-1], turned[-1] + way * ((60 - turned[-1].y) / way.y), *(
        FreeCAD.Vector(*xy, 0) for xy in ((100, 60), (100, 0), (0, 0), (0, step)))]
    lines = [Part.makeLine(*ends) for ends in zip(points, points[1:])]
    return Part.Face(Part.Wire([Part.Arc(*turned).toShape(), *lines]))


def pad(gap, radius):
    """A pad on a box, this far from the front edge of the box, with one rounded corner: the strip beside it ends there."""
    box = Part.makeBox(100, 60, 5)
    foot = Part.makeBox(70, 40, 5, FreeCAD.Vector(30, gap, 5))
    edge, = (edge for edge in foot.Edges
             if all(abs(v.X - 30) < 1e-9 and abs(v.Y - gap) < 1e-9 for v in edge.Vertexes))
    return box.fuse(foot.makeFillet(radius, [edge]))


def smallest_corner(shape):
    """The smallest angle between edges of a face, degrees."""
    angles = []
    for face in shape.Faces:
        for vertex in face.Vertexes:
            ways = [edge.tangentAt(t) * sign for edge in face.Edges for t, sign in zip(edge.ParameterRange, (1, -1))
                    if (edge.valueAt(t) - vertex.Point).Length < 1e-6]
            angles += [way.getAngle(other) for i, way in enumerate(ways) for other in ways[:i]]
    return math.degrees(min(angles))


class IdentifiedCorners(unittest.TestCase):
    def test_they_are_not_the_shapes(self):
        shape = notched(0.0005, 0.075, math.radians(62))
        self.assertGreater(smallest_corner(shape), 60)
        mesh = mq.triangulate(shape, chord_height=0.5, min_angle=34)
        (_, reason), = mesh.report.exempt_reasons
        self.assertEqual((reason.cause, reason.forced), ("identified_corner", False))
        self.assertEqual([name[:6] for name in reason.joined], ["Vertex", "Vertex"])
        self.assertAlmostEqual(reason.apart, 0.0005, places=9)
        self.assertTrue(30 < reason.angle < 34, reason.angle)
        finding, = verdict.of_triangulation(mesh, False)
        self.assertFalse(finding.forced)
        self.assertNotIn("shape itself", str(finding.text))
        self.assertRegex(str(finding.text),
                         r"triangle \d+ on Face1\. Vertex\d+ and Vertex\d+ count as one, as they are no farther apart than "
                         r"0\.0005 mm: that makes a corner of 3\d\.\d+°, which the shape does not have and a smaller max\. "
                         r"deviation avoids, between Edge\d+ and Edge\d+ at Vertex\d+\.$")

    def test_a_smaller_deviation_avoids_them(self):
        report = mq.triangulate(notched(0.0005, 0.075, math.radians(62)), chord_height=0.004, min_angle=34).report
        self.assertLess(report.detail, 0.0005)
        self.assertEqual(report.exempt_reasons, [])

    def test_fillets_open_before_the_next_vertex(self):
        """Where a step is contracted, or a strip taken off, an arc would leave the line at its first chord's angle."""
        for shape in (notched(0.0005, 0.05, math.pi / 2), notched(0.005, 0.07, math.pi / 2), pad(0.002, 0.05),
                      pad(0.0005, 0.07)):
            self.assertGreater(smallest_corner(shape), 60)
            report = mq.triangulate(shape, chord_height=0.5, min_angle=25).report
            self.assertGreater(report.detail, 0.009)
            self.assertTrue(any("shorter than 0.01 mm" in note or "spike" in note for note in report.notes), report.notes)
            self.assertEqual(report.exempt_reasons, [])
            self.assertGreaterEqual(report.min_angle, 25)
            self.assertLessEqual(report.max_chord_height, 0.5)
            self.assertLess(report.triangles, 5000)
