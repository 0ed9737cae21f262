# SPDX-License-Identifier: LGPL-2.1-or-later
"""Longest edges on single faces, edges and around vertices."""

import unittest

import helpers
import numpy as np
import Part

import MeshQuality as mq
from MeshQuality import options


def longest_edges(mesh, chosen):
    """float (n,): the longest edge of each chosen triangle."""
    corners = np.asarray(mesh.vertices)[mesh.triangles[chosen]]
    return np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)


class LocalSizes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.shape = Part.makeBox(10, 10, 10)

    def test_a_face(self):
        for method in ("refine", "star"):
            mesh = mq.triangulate(self.shape, local_sizes={"Face3": 0.5}, method=method)
            on_face = mesh.triangle_face == 2
            self.assertLessEqual(longest_edges(mesh, on_face).max(), 0.5 + 1e-6)
            self.assertGreater(longest_edges(mesh, ~on_face).max(), 1.0)
            self.assertGreaterEqual(mesh.report.min_angle, 25 - 1e-6)
            self.assertTrue(mesh.report.closed)

    def test_an_edge_and_a_vertex(self):
        mesh = mq.triangulate(self.shape, local_sizes={"Edge2": 0.3, "Vertex8": 0.1})
        entity, points = mesh.vertex_entity, np.asarray(mesh.vertices)
        edge = self.shape.Edges[1]
        ends = [v.Point for v in edge.Vertexes]
        along = np.array(sorted((np.asarray(p) - ends[0]) @ (ends[1] - ends[0]) / edge.Length
                                for p in points[(entity == (1, 1)).all(axis=1)]))
        self.assertLessEqual(np.diff(np.concatenate(([0.0], along, [10.0]))).max(), 0.3 + 1e-6)
        corner = int(np.flatnonzero((entity == (0, 7)).all(axis=1))[0])
        around = mesh.triangles[(mesh.triangles == corner).any(axis=1)]
        lengths = np.linalg.norm(points[np.unique(around)] - points[corner], axis=1)
        self.assertLessEqual(lengths.max(), 0.1 + 1e-6)

    def test_text_says_the_same_as_a_dict(self):
        first = mq.triangulate(self.shape, local_sizes={"Face3": 0.5, "Edge1": 0.2})
        second = mq.triangulate(self.shape, local_sizes="Face3=0.5 mm, Edge1 = 0.2")
        self.assertTrue(np.array_equal(first.triangles, second.triangles))
        table = next(o for o in options.TRIANGULATE if o.name == "local_sizes")
        self.assertEqual(table.checked("Face3=0.5"), {"Face3": 0.5})
        self.assertIsNone(table.checked(""))

    def test_what_makes_no_sense_is_named(self):
        for sizes in ({"Face1": -1}, {"Face1": 0}, {"Solid1": 1}, "Face1", "Face1=x", {"Face0": 1}, 3):
            with self.assertRaisesRegex(mq.InvalidInput, "local_sizes = .*sub-elements"):
                mq.triangulate(self.shape, local_sizes=sizes)
        with self.assertRaisesRegex(mq.InvalidInput, "Face9, but the shape has 6 faces"):
            mq.triangulate(self.shape, local_sizes={"Face9": 1})
        with self.assertRaisesRegex(mq.InvalidInput, "Face2, but the shape has 1 face$"):
            mq.triangulate(Part.makeSphere(1), local_sizes={"Face2": 0.1})


class OfObjects(helpers.DocumentTest):
    def test_property_is_text_and_is_saved(self):
        obj = mq.add_quality_mesh(self.box(Length=10, Width=10, Height=10),
                                  local_sizes={"Face3": 0.5})
        self.assertEqual(obj.LocalSizes, "Face3=0.5")
        count = obj.Mesh.CountFacets
        name = obj.Name
        self.reopen()
        obj = self.document.getObject(name)
        self.assertEqual(obj.LocalSizes, "Face3=0.5")
        obj.LocalSizes = "Face3=0.5, Face1=0.5"
        obj.Document.recompute()
        self.assertGreater(obj.Mesh.CountFacets, count)
        obj.LocalSizes = "Face77=1"
        obj.Document.recompute()
        self.assertIn("Face77", obj.getStatusString())
