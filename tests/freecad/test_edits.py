# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random edits of parts with surfaces of every kind, meshed again with what was remembered."""

import math
import random
import unittest

import FreeCAD
import helpers
import Part
from FreeCAD import Placement, Rotation, Vector

import MeshQuality as mq

Z = Vector(0, 0, 1)
CHORD = 0.05
EDITS = 4


def spline(points, closed=False):
    curve = Part.BSplineCurve()
    curve.interpolate(points, PeriodicFlag=closed)
    return Part.Wire(curve.toShape())


def ring(radius, height, bumps):
    """A closed spline around the z axis."""
    turns = [2 * math.pi * k / 12 for k in range(12)]
    return spline([Vector(math.cos(t), math.sin(t), 0) * radius * (1 + bumps * math.cos(3 * t))
                   + Vector(0, 0, height) for t in turns], closed=True)


def filleted():
    box = Part.makeBox(16, 12, 8)
    return box.makeFillet(2.0, box.Edges)


def turned():
    profile = spline([Vector(2, 0, 0), Vector(5, 0, 3), Vector(3, 0, 7), Vector(4, 0, 10)])
    line = Part.makePolygon([Vector(4, 0, 10), Vector(0, 0, 10), Vector(0, 0, 0), Vector(2, 0, 0)])
    return Part.Face(Part.Wire(profile.Edges + line.Edges)).revolve(Vector(), Z, 360)


def lofted():
    return Part.makeLoft([ring(6, 0, 0.1), ring(4, 5, 0.0), ring(5, 10, -0.1)], True)


def swept():
    path = spline([Vector(0, 0, 0), Vector(0, 2, 6), Vector(0, -1, 12), Vector(0, 0, 18)])
    start = path.Edges[0]
    section = Part.Wire(Part.makeCircle(1.2, Vector(), start.tangentAt(start.FirstParameter)))
    return path.makePipeShell([section], True)


def fused():
    return Part.makeCone(5, 2, 8).fuse(Part.makeTorus(5, 1.5, Vector(0, 0, 3))).fuse(
        Part.makeSphere(3, Vector(0, 0, 8)))


def drilled(dice, shape):
    """With a hole along z near the middle."""
    box = shape.BoundBox
    at = Vector(box.Center.x + dice.uniform(-0.1, 0.1) * box.XLength,
                box.Center.y + dice.uniform(-0.1, 0.1) * box.YLength, box.ZMin - 1)
    return shape.cut(Part.makeCylinder(dice.uniform(0.3, 1.0), box.ZLength + 2, at))


def dimpled(dice, shape):
    """With a ball taken off somewhere on a face."""
    face = dice.choice(shape.Faces)
    low_u, high_u, low_v, high_v = face.ParameterRange
    at = face.valueAt(low_u + dice.random() * (high_u - low_u), low_v + dice.random() * (high_v - low_v))
    return shape.cut(Part.makeSphere(dice.uniform(0.3, 1.0), at))


def moved(dice, shape):
    """Somewhere else, and turned."""
    other = shape.copy()
    other.Placement = Placement(Vector(*(dice.uniform(-50, 50) for _ in range(3))),
                                Rotation(Vector(1, 2, 3), dice.uniform(0, 360))).multiply(shape.Placement)
    return other


def edited(dice, shape):
    """The shape after a random edit that leaves one valid solid."""
    for _ in range(20):
        other = dice.choice((drilled, dimpled, dimpled, moved))(dice, shape)
        if len(other.Solids) == 1 and other.isValid() and other.Volume > 0.7 * shape.Volume:
            return other.Solids[0]
    raise AssertionError("no edit succeeds")


class RandomEdits(unittest.TestCase):
    def test_guarantees_hold_and_faces_are_reused(self):
        for number, make in enumerate((filleted, turned, lofted, swept, fused)):
            for options in ({}, {"max_edge": 1.5}):
                with self.subTest(part=make.__name__, **options):
                    self.edit_at_random(random.Random(1000 + number), make(), options)

    def edit_at_random(self, dice, shape, options):
        """Meshes a part, and again after each of some edits."""
        cache, states, reused = mq.MeshCache(), [], 0
        for _ in range(EDITS + 1):
            mesh = mq.triangulate(shape, chord_height=CHORD, cache=cache, **options)
            self.check(mesh, shape, options)
            reused += mesh.report.reused_faces
            states.append((shape, mesh))
            shape = edited(dice, shape)
        self.assertGreater(reused, 0)
        for shape, mesh in states:
            again = mq.triangulate(shape, chord_height=CHORD, cache=cache, **options)
            self.assertEqual(again.triangles.tolist(), mesh.triangles.tolist())
            self.assertEqual(again.vertices.tolist(), mesh.vertices.tolist())
            self.assertEqual(again.report.reused_faces, len(shape.Faces))

    def check(self, mesh, shape, options):
        """What was asked for holds, but for corners of the part that no mesh can do better at."""
        report = mesh.report
        self.assertTrue(report.closed and report.oriented and report.manifold and report.complete)
        self.assertEqual(report.self_intersections, 0)
        self.assertLessEqual(report.max_chord_height, CHORD)
        self.assertGreaterEqual(report.min_angle_unexempted, 25.0)
        if report.exempt:
            nothing = mq.triangulate(shape, chord_height=CHORD, **options)
            self.assertGreater(len(nothing.report.exempt), 0, report.exempt)
        small = sum(helpers.smallest_angles(mesh) < 25.0 - 1e-6)
        self.assertEqual(small, len(report.exempt))
        self.assertLess(max(helpers.distances_to_faces(shape, mesh, 8)), CHORD)
        solid = mesh.to_mesh()
        self.assertTrue(solid.isSolid())
        self.assertAlmostEqual(solid.Volume / shape.Volume, 1.0, delta=0.05)


class PlacementOfTheSource(helpers.DocumentTest):
    def test_a_corner_below_the_bound_does_not_make_the_mesh_grow(self):
        source = self.document.addObject("Part::Feature", "Blade")
        corners = [Vector(*at) for at in ((0, 0, 0), (40, 0, 0), (40, 3, 0), (0, 0, 0))]
        source.Shape = Part.Face(Part.makePolygon(corners)).extrude(Vector(0, 0, 30))
        mesh = mq.add_quality_mesh(source, chord_height_relative=0.003)
        first = mesh.Mesh.CountFacets
        for turn in (0, 40, 77, 177):
            source.Placement = Placement(Vector(turn, -3, 1), Rotation(Vector(1, 2, 3), turn))
            self.document.recompute()
            self.assertEqual((mesh.Mesh.CountFacets, mesh.ReusedFaces), (first, 5))
            self.assertIn("the shape itself has a corner of 4.29°", mesh.Certificate)

    def test_faces_go_along(self):
        document = self.document
        source = document.addObject("Part::Feature", "Source")
        source.Shape = filleted()
        mesh = mq.add_quality_mesh(source, chord_height=CHORD)
        first = str(mesh.Mesh.Topology)
        source.Placement = Placement(Vector(30, -20, 10), Rotation(Vector(1, 1, 0), 40))
        document.recompute()
        self.assertGreater(mesh.ReusedFaces, 0.8 * len(source.Shape.Faces))
        self.assertEqual(mesh.Certificate, "met")
        self.assertAlmostEqual(mesh.Mesh.BoundBox.Center.distanceToPoint(source.Shape.BoundBox.Center),
                               0.0, delta=2 * CHORD)
        source.Placement = Placement()
        document.recompute()
        self.assertEqual(str(mesh.Mesh.Topology), first)
