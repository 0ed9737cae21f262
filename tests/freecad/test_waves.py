# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves and surfaces whose waves lie between the places where pieces of a mesh are measured."""

import math
import unittest

import FreeCAD
import numpy as np
import Part

import MeshQuality as mq

SIZE = 50.0
HEIGHT = 0.3
CHORD = 0.1
METHODS = ("refine", "star", "sprinkle")


def sine(x):
    return math.sin(2 * math.pi * x)


def dimple(x):
    return 1 - math.cos(2 * math.pi * x)


def wavy_height(wave, in_x, in_y):
    """z at x and y from 0 to SIZE, mm, of so many waves."""
    def height(x, y):
        return HEIGHT * wave(in_x * x / SIZE) * (wave(in_y * y / SIZE) if in_y else 1.0)
    return height


def wavy_face(height, steps=36):
    points = [[FreeCAD.Vector(SIZE * i / steps, SIZE * k / steps,
                              height(SIZE * i / steps, SIZE * k / steps))
               for k in range(steps + 1)] for i in range(steps + 1)]
    surface = Part.BSplineSurface()
    surface.interpolate(points)
    return surface.toShape()


def dense_points(mesh, parts=12):
    """Points of all triangles of a mesh, by rows."""
    weights = np.array([(i / parts, k / parts, (parts - i - k) / parts)
                        for i in range(parts + 1) for k in range(parts + 1 - i)])
    corners = np.asarray(mesh.vertices, dtype=float)[np.asarray(mesh.triangles)]
    return np.einsum("wk,tkc->twc", weights, corners).reshape(-1, 3)


def wavy_curve():
    """Flat waves of a spline about the straight line between its ends, which cross it in the middle."""
    points = [FreeCAD.Vector(60 * i / 12, 0.5 * math.sin(math.pi * i / 2), 0) for i in range(13)]
    curve = Part.BSplineCurve()
    curve.interpolate(points)
    return curve


def distance_from_segments(points, starts, ends):
    """The largest distance of the points from the nearest segment."""
    along = ends - starts
    largest = 0.0
    for p in points:
        at = np.clip(((p - starts) * along).sum(1) / (along * along).sum(1), 0, 1)
        nearest = starts + at[:, None] * along
        largest = max(largest, np.linalg.norm(nearest - p, axis=1).min())
    return largest


class Surfaces(unittest.TestCase):
    def check(self, face, height, **options):
        mesh = mq.triangulate(face, chord_height=CHORD, **options)
        far = max(abs(height(x, y) - z) for x, y, z in dense_points(mesh))
        self.assertLessEqual(far, 1.01 * CHORD)
        self.assertGreaterEqual(mesh.report.min_angle_unexempted, 25.0)
        return mesh

    def test_waves_are_followed(self):
        for wave in (sine, dimple):
            for in_x, in_y in ((1, 0), (1, 1), (2, 1), (2, 2), (3, 0)):
                for method in METHODS:
                    with self.subTest(wave=wave.__name__, x=in_x, y=in_y, method=method):
                        height = wavy_height(wave, in_x, in_y)
                        self.check(wavy_face(height), height, method=method)

    def test_a_corrugated_sheet(self):
        curve = wavy_curve()
        sheet = curve.toShape().extrude(FreeCAD.Vector(0, 0, 40))
        mesh = mq.triangulate(sheet, chord_height=CHORD)
        far = max(curve.value(curve.parameter(FreeCAD.Vector(x, y, 0))).distanceToPoint(
            FreeCAD.Vector(x, y, 0)) for x, y, _ in dense_points(mesh, 4))
        self.assertLessEqual(far, 1.01 * CHORD)
        self.assertGreater(mesh.report.triangles, 50)

    def test_quality_sees_what_two_triangles_miss(self):
        face = wavy_face(wavy_height(dimple, 2, 2))
        corners = np.array([(0, 0, 0), (SIZE, 0, 0), (SIZE, SIZE, 0), (0, SIZE, 0)], dtype=float)
        report = mq.quality((corners, np.array([(0, 1, 2), (0, 2, 3)])), face)
        self.assertAlmostEqual(report.max_chord_height, 4 * HEIGHT, delta=0.2 * HEIGHT)


class Curves(unittest.TestCase):
    def test_waves_are_followed(self):
        curve = wavy_curve()
        parameters = np.linspace(curve.FirstParameter, curve.LastParameter, 500)
        ends = [curve.value(parameters[0]), curve.value(parameters[-1])]
        corners = [FreeCAD.Vector(60, 40, 0), FreeCAD.Vector(0, 40, 0)]
        wire = Part.Wire([curve.toShape(), Part.makeLine(ends[1], corners[0]),
                          Part.makeLine(*corners), Part.makeLine(corners[1], ends[0])])
        for chord in (0.3, 0.1, 0.02):
            with self.subTest(chord=chord):
                mesh = mq.triangulate(Part.Face(wire), chord_height=chord)
                vertices = np.asarray(mesh.vertices, dtype=float)
                edges = np.vstack([mesh.triangles[:, [0, 1]], mesh.triangles[:, [1, 2]],
                                   mesh.triangles[:, [2, 0]]])
                points = [np.array(curve.value(t)) for t in parameters]
                far = distance_from_segments(points, vertices[edges[:, 0]], vertices[edges[:, 1]])
                self.assertLessEqual(far, 1.01 * chord)
                self.assertLessEqual(mesh.report.max_chord_height, chord)


if __name__ == "__main__":
    unittest.main()
