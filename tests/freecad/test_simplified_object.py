# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simplify in documents and on the command line: what is proven, CAD faces, edits, and files."""

import json
import os

import FreeCAD
import helpers
import Mesh
import numpy as np
import Part
import test_cli

import MeshQuality as mq
from MeshQuality import options
from MeshQuality.features import mesh_object


class Objects(helpers.DocumentTest):
    def meshed(self):
        source = self.document.addObject("Part::Feature", "Part")
        source.Shape = Part.makeCylinder(5, 20)
        source.Placement.Base = FreeCAD.Vector(100, 0, 0)
        self.document.recompute()
        return mq.add_quality_mesh(source, max_edge=1.0)

    def test_fewer_triangles_where_the_source_lies_with_its_faces(self):
        given = self.meshed()
        obj = mq.add_simplified_mesh(given, tolerance=0.05)
        self.assertEqual((obj.Source, obj.Label), (given, f"{given.Label} simplified"))
        self.assertGreater(obj.Mesh.BoundBox.XMin, 94)
        self.assertEqual(obj.GivenTriangles, given.Mesh.CountFacets)
        self.assertLess(obj.Triangles, 0.3 * obj.GivenTriangles)
        self.assertTrue(0 < obj.MaxDeviation.Value <= 0.05)
        self.assertEqual(obj.DeviationInFull, f"{obj.MaxDeviation.Value:.4g} mm")
        self.assertEqual((obj.Certificate, obj.AskedClosed, obj.Closed, obj.Manifold), ("met", True, True, True))
        for one, other in ((obj, given), (given, obj)):
            self.assertLessEqual(mq.deviation(one, other).max_deviation, obj.MaxDeviation.Value + 1e-6)
        faces = mesh_object.faces_of_runs(obj.FaceRuns, obj.Mesh.CountFacets)
        self.assertEqual(sorted(set(faces.tolist())), [0, 1, 2])
        self.assertEqual(obj.Mesh.countSegments(), 3)
        for option in options.simplify.SIMPLIFY:
            self.assertEqual(obj.getTypeIdOfProperty(option.property_name), option.property_type)

    def test_it_follows_its_source_and_options(self):
        given = self.meshed()
        obj = mq.add_simplified_mesh(given)
        before = obj.Triangles
        mq.update(obj, tolerance=0.5)
        self.assertLess(obj.Triangles, before)
        given.Source.Shape = Part.makeBox(5, 6, 7)
        self.document.recompute()
        self.assertEqual(obj.Triangles, 12)
        self.assertAlmostEqual(obj.Mesh.Volume, 210.0, places=3)
        self.reopen()
        again = self.document.getObject("SimplifiedMesh")
        self.assertEqual((again.Triangles, again.Status), (12, mesh_object.UP_TO_DATE))

    def test_a_mesh_of_freecad_and_one_undo_step(self):
        source = self.document.addObject("Mesh::Feature", "Imported")
        source.Mesh = Mesh.createSphere(5.0, 40)
        self.document.recompute()
        obj = mq.add_simplified_mesh(source, tolerance=0.05)
        self.assertLess(obj.Triangles, obj.GivenTriangles)
        self.assertEqual((obj.Certificate, self.document.UndoNames[0]), ("met", "Simplify"))
        self.document.undo()
        self.assertEqual(self.document.Objects, [source])

    def test_what_cannot_be_is_refused_and_nothing_added(self):
        box = self.box()
        for wrong in (box, None):
            with self.assertRaisesRegex(mq.InvalidInput, "a document object with a mesh"):
                mq.add_simplified_mesh(wrong)
        book = self.document.addObject("Mesh::Feature", "Book")
        book.Mesh = Mesh.Mesh([[(0, 0, 0), (1, 0, 0), end] for end in ((0, 1, 0), (0, 0, 1), (0, -1, 0))])
        with self.assertRaisesRegex(mq.InvalidInput, "not manifold and oriented"):
            mq.add_simplified_mesh(book)
        self.assertEqual(self.document.Objects, [box, book])


class CommandLine(helpers.DocumentTest):
    def test_a_file_becomes_a_lighter_file(self):
        path, out = os.path.join(self.folder, "a.stl"), os.path.join(self.folder, "b.ply")
        Mesh.createSphere(5.0, 60).write(path)
        status, said, lines = test_cli.run("simplify", path, "-o", out, "--tolerance", 0.05, "--json", "--strict")
        self.assertEqual(status, 0, lines)
        report = json.loads(said)
        self.assertTrue(0 < report["deviation"] <= 0.05)
        self.assertEqual(Mesh.Mesh(out).CountFacets, report["triangles"])
        self.assertLess(report["triangles"], Mesh.Mesh(path).CountFacets)
        self.assertIn("proven to deviate by", lines[-1])
        np.testing.assert_allclose(Mesh.Mesh(out).Volume, Mesh.Mesh(path).Volume, rtol=0.02)

    def test_an_open_mesh_is_no_finding_but_one_that_is_not_manifold_is_refused(self):
        path = os.path.join(self.folder, "book.stl")
        Mesh.Mesh([[(0, 0, 0), (1, 0, 0), end] for end in ((0, 1, 0), (0, 0, 1), (0, -1, 0))]).write(path)
        status, _, lines = test_cli.run("simplify", path, "-o", os.path.join(self.folder, "out.stl"))
        self.assertEqual(status, 2)
        self.assertIn("repair it first", lines[-1])
