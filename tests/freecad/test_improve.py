# SPDX-License-Identifier: LGPL-2.1-or-later
"""Improve: the function, the document object, the command line."""

import json
import os
import subprocess
import tempfile
import unittest

import FreeCAD
import helpers
import Mesh
import MeshPart
import numpy as np
import Part

import MeshQuality as mq
from MeshQuality import options

COMMAND = os.path.join(helpers.ROOT, "bin", "meshquality")


def standard_mesh():
    """A part as FreeCAD's standard mesher gives it, with slivers."""
    shape = Part.makeBox(30, 20, 10).cut(Part.makeCylinder(4, 20, FreeCAD.Vector(10, 10, -1)))
    shape = shape.fuse(Part.makeSphere(6, FreeCAD.Vector(25, 10, 10)))
    return shape, MeshPart.meshFromShape(Shape=shape, LinearDeflection=0.1, AngularDeflection=0.5)


class Improve(unittest.TestCase):
    def test_a_standard_mesh_of_a_part_reaches_the_angle(self):
        shape, mesh = standard_mesh()
        self.assertLess(mq.quality(mesh).min_angle, 3)
        better = mq.improve(mesh, min_angle=25, tolerance=0.02)
        self.assertGreaterEqual(better.report.min_angle, 25)
        self.assertEqual(better.report.exempt, [])
        self.assertTrue(better.report.closed and better.report.manifold and better.report.oriented)
        self.assertAlmostEqual(better.report.volume, mq.quality(mesh).volume, delta=1.0)
        # No farther from the part than the given mesh and the tolerance together.
        given = mq.quality(mesh, shape).max_chord_height
        self.assertLessEqual(mq.quality(better, shape).max_chord_height, given + 0.021)
        self.assertIn("edges swapped", better.report.notes[0])

    def test_what_stays_below_is_listed_and_the_rest_is_not(self):
        corners = [FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(20, 0, 0), FreeCAD.Vector(20, 1.5, 0)]
        wedge = Part.Face(Part.makePolygon([*corners, corners[0]])).extrude(FreeCAD.Vector(0, 0, 5))
        points, facets = wedge.tessellate(0.1)
        report = mq.improve(Mesh.Mesh([points[i] for facet in facets for i in facet])).report
        self.assertLess(report.min_angle, 5.0)
        self.assertTrue(report.exempt)
        self.assertGreaterEqual(report.min_angle_unexempted, 25.0)

    def test_sheets_near_each_other_never_cross(self):
        """Two shells closer than the tolerance: each may move by that, but not through the other."""
        points, facets = Part.makeSphere(10).tessellate(0.3)
        points, facets = np.array([tuple(p) for p in points]), np.array(facets)
        mesh = np.concatenate([points, 1.0005 * points]), np.concatenate([facets, facets[:, ::-1] + len(points)])
        before = mq.quality(mesh)
        self.assertEqual(before.self_intersections, 0)
        better = mq.improve(mesh, tolerance=0.1)
        after = mq.quality((better.vertices, better.triangles))
        self.assertEqual((after.self_intersections, better.report.self_intersections), (0, 0))
        self.assertGreaterEqual(after.min_angle, before.min_angle - 1e-4)
        self.assertTrue(any("kept as it was" in note for note in better.report.notes), better.report.notes)

    def test_quality_finds_triangles_that_cross_and_fold(self):
        nodes = np.array([[0, 0, 0], [2, 0, 0], [0, 2, 0], [0.5, 0.5, -1], [0.5, 0.5, 1], [3, 3, 0], [0.4, 0.4, 0]], dtype=float)
        for rows, kind in (([[0, 1, 2], [3, 4, 5]], "self_intersections"), ([[0, 1, 2], [1, 0, 6]], "self_intersections"),
                           ([[0, 1, 2], [0, 1, 2]], "duplicate_triangles"), ([[0, 1, 2]], "border_edges")):
            report = mq.quality((nodes, np.array(rows)))
            self.assertGreater(getattr(report, kind), 0, rows)
            self.assertNotIn("faults       none", str(report))

    def test_every_value_is_in_single_precision(self):
        better = mq.improve(standard_mesh()[1])
        self.assertTrue(np.array_equal(better.vertices, better.vertices.astype(np.float32)))

    def test_arrays_and_meshes_give_the_same(self):
        mesh = Mesh.createSphere(5.0, 30)
        first = mq.improve(mesh)
        second = mq.improve((first.vertices, first.triangles))
        self.assertTrue(np.array_equal(first.triangles, second.triangles))
        self.assertGreaterEqual(first.report.min_angle, 25)

    def test_bad_input_is_named(self):
        mesh = Mesh.createSphere(5.0, 20)
        for values, words in (({"min_angle": 50}, "min_angle = 50"), ({"tolerance": -1}, "tolerance"),
                              ({"feature_angle": 0}, "feature_angle")):
            with self.assertRaisesRegex(mq.InvalidInput, words):
                mq.improve(mesh, **values)
        with self.assertRaisesRegex(mq.InvalidInput, "Mesh.Mesh"):
            mq.improve(Part.makeBox(1, 1, 1))
        with self.assertRaisesRegex(mq.InvalidInput, "triangle 0 names a vertex twice"):
            mq.improve((np.eye(3), [[0, 0, 1]]))
        with self.assertRaisesRegex(mq.InvalidInput, "no triangles"):
            mq.improve(Mesh.Mesh())

    def test_progress_follows_the_bad_triangles(self):
        seen = []
        # Large enough to be looked at while it works.
        mesh = MeshPart.meshFromShape(Shape=Part.makeTorus(10, 4), LinearDeflection=0.02,
                                      AngularDeflection=0.1)
        mq.improve(mesh, progress=lambda fraction, stage: seen.append((fraction, stage)) or True)
        fractions = [fraction for fraction, _ in seen]
        self.assertEqual(fractions, sorted(fractions))
        self.assertIn("improving", {stage for _, stage in seen})
        self.assertEqual(fractions[-1], 1.0)

    def test_it_can_be_cancelled(self):
        with self.assertRaises(mq.Cancelled):
            mq.improve(standard_mesh()[1], progress=lambda fraction, stage: False)


class ImprovedMesh(helpers.DocumentTest):
    def source(self):
        obj = self.document.addObject("Mesh::Feature", "Imported")
        obj.Mesh = standard_mesh()[1]
        obj.Placement.Base = FreeCAD.Vector(100, 0, 0)
        self.document.recompute()
        return obj

    def test_it_holds_the_result_where_its_source_lies(self):
        source = self.source()
        obj = mq.add_improved_mesh(source, tolerance=0.02)
        self.assertEqual((obj.Source, obj.Label), (source, "Imported improved"))
        self.assertGreater(obj.Mesh.BoundBox.XMin, 99)
        self.assertGreaterEqual(obj.MeasuredMinAngle.Value, 25)
        self.assertEqual(obj.Certificate, "met")
        self.assertTrue(obj.Closed and obj.Manifold)
        for option in options.IMPROVE:
            self.assertEqual(obj.getTypeIdOfProperty(option.property_name), option.property_type)

    def test_it_follows_its_source_and_options(self):
        source = self.source()
        obj = mq.add_improved_mesh(source)
        before = obj.Mesh.CountFacets
        obj.MinAngle = 30
        self.document.recompute()
        self.assertGreaterEqual(obj.MeasuredMinAngle.Value, 30)
        self.assertNotEqual(obj.Mesh.CountFacets, before)
        source.Mesh = Mesh.createSphere(3.0, 20)
        self.document.recompute()
        self.assertAlmostEqual(obj.Mesh.Volume, source.Mesh.Volume, delta=1.0)

    def test_one_undo_step(self):
        source = self.source()
        mq.add_improved_mesh(source)
        self.assertEqual(len(self.document.Objects), 2)
        self.assertEqual(self.document.UndoNames[0], "Improve mesh")
        self.document.undo()
        self.assertEqual(self.document.Objects, [source])

    def test_something_else_is_refused_and_nothing_added(self):
        box = self.box()
        for wrong in (box, None, Mesh.Mesh()):
            with self.assertRaisesRegex(mq.InvalidInput, "a document object with a mesh"):
                mq.add_improved_mesh(wrong)
        self.assertEqual(self.document.Objects, [box])


class CommandLine(unittest.TestCase):
    def test_a_file_becomes_a_better_file(self):
        with tempfile.TemporaryDirectory() as folder:
            path, out = os.path.join(folder, "a.stl"), os.path.join(folder, "b.ply")
            standard_mesh()[1].write(path)
            done = subprocess.run([COMMAND, "improve", path, "-o", out, "--min-angle", "28",
                                   "--json"], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            report = json.loads(done.stdout)
            self.assertGreaterEqual(report["min_angle"], 28)
            self.assertEqual(Mesh.Mesh(out).CountFacets, report["triangles"])
            self.assertIn(f"{report['triangles']} triangles in {out}", done.stderr)
