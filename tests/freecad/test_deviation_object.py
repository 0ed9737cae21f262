# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object of a deviation: it follows scan and part, is undone, saved and loaded."""

import os
import tempfile
import unittest

import FreeCAD
import numpy as np
import Part
from parts.bracket import bracket
from test_deviation import moved, scan_of

import MeshQuality as mq

V = FreeCAD.Vector


class Object(unittest.TestCase):
    def setUp(self):
        self.doc = FreeCAD.newDocument()
        self.doc.UndoMode = 1
        self.addCleanup(lambda: FreeCAD.closeDocument(self.doc.Name))
        self.part = self.doc.addObject("Part::Box", "Box")
        self.part.Length, self.part.Width, self.part.Height = 30, 20, 10
        self.scan = self.doc.addObject("Mesh::Feature", "Scan")
        mesh = mq.triangulate(Part.makeBox(30, 20, 10.2), max_edge=3.0)
        self.scan.Mesh = mesh.to_mesh()
        self.doc.recompute()

    def test_it_has_what_the_function_says_and_follows_edits(self):
        obj = mq.add_deviation(self.scan, self.part, tolerance=0.1)
        found = mq.deviation(self.scan, self.part, tolerance=0.1)
        self.assertAlmostEqual(obj.MaxDeviation.Value, found.max_deviation)
        self.assertAlmostEqual(obj.MaxDeviation.Value, 0.2, places=5)
        self.assertAlmostEqual(obj.Within, 100.0 * found.within())
        self.assertEqual(obj.Points, self.scan.Mesh.CountPoints)
        self.assertEqual(obj.Mesh.CountFacets, self.scan.Mesh.CountFacets)
        self.assertEqual(len(obj.Deviations), obj.Mesh.CountFacets)
        self.assertTrue(obj.Certificate.startswith("not met: max. deviation 0.2 mm (allowed 0.1 mm)"), obj.Certificate)
        self.assertEqual(obj.CertificateFaces, [face.face for face in found.by_face if face.within < 1.0])
        self.assertIn("+0.2 mm (Face", obj.PlaceTexts[0])
        self.part.Height = 10.2
        self.doc.recompute()
        self.assertLess(obj.MaxDeviation.Value, 1e-6)
        self.assertEqual(obj.Certificate, "met")
        mq.update(obj, tolerance=None)
        self.assertEqual((obj.Tolerance.Value, obj.Within), (0.0, 100.0))

    def test_it_is_one_undo_step_and_is_saved(self):
        obj = mq.add_deviation(self.scan, self.part, tolerance=0.5)
        name = obj.Name
        self.doc.undo()
        self.assertIsNone(self.doc.getObject(name))
        self.doc.redo()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "deviation.FCStd")
            self.doc.saveAs(path)
            again = FreeCAD.openDocument(path)
            loaded = again.getObject(name)
            again.recompute()
            self.assertEqual(loaded.Status, "up to date")
            self.assertAlmostEqual(loaded.MaxDeviation.Value, 0.2, places=5)
            self.assertEqual(len(loaded.Deviations), loaded.Mesh.CountFacets)

    def test_points_are_aligned_and_drawn(self):
        import Points

        part = self.doc.addObject("Part::Feature", "Bracket")
        part.Shape = bracket()
        away = FreeCAD.Placement(V(20, 3, -4), FreeCAD.Rotation(V(1, 2, 0), 30))
        cloud = self.doc.addObject("Points::Feature", "Cloud")
        cloud.Points = Points.Points([V(*point) for point in moved(scan_of(part.Shape, 3000, 0.01), away).tolist()])
        obj = mq.add_deviation(cloud, part, align="any")
        self.assertEqual((obj.Mesh.CountFacets, obj.Points), (3000, 3000))
        self.assertAlmostEqual(obj.Residual.Value, 0.01, delta=0.001)
        self.assertAlmostEqual(obj.Rms.Value, 0.01, delta=0.001)
        both = obj.Alignment.multiply(away)
        self.assertLess(both.Base.Length, 0.01)
        # The largest value of the points is that of a triangle.
        self.assertAlmostEqual(np.abs(obj.Deviations).max(), obj.MaxDeviation.Value)

    def test_what_is_no_scan_is_refused_by_name(self):
        other = self.doc.addObject("Part::Box", "Other")
        self.doc.recompute()
        with self.assertRaisesRegex(mq.InvalidInput, "'Other' is no mesh and no point cloud"):
            mq.add_deviation(other, self.part)
        count = len(self.doc.Objects)
        with self.assertRaisesRegex(mq.InvalidInput, "cannot be aligned with 'Box'"):
            torus = self.doc.addObject("Mesh::Feature", "Torus")
            torus.Mesh = mq.triangulate(Part.makeTorus(10, 3)).to_mesh()
            mq.add_deviation(torus, self.part, align="any")
        self.assertEqual(len(self.doc.Objects), count + 1)
