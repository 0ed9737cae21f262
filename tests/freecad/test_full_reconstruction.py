# SPDX-License-Identifier: LGPL-2.1-or-later
"""Booleans whose whole surface is reconstructed from the samples (Wang 2010, Table III)."""

import unittest

import FreeCAD
import Mesh
import Part

import MeshQuality as mq


def spheres():
    """Two meshes that overlap."""
    a, b = Mesh.createSphere(1.0, 30), Mesh.createSphere(1.0, 30)
    b.Placement.Base = FreeCAD.Vector(0.8, 0.1, 0.2)
    return a, b


class FullReconstruction(unittest.TestCase):
    def test_no_triangle_of_an_operand_stays(self):
        a, b = spheres()
        for operation in ("union", "difference"):
            values = {"operation": operation, "method": "uniform", "resolution": 65}
            partial, full = mq.boolean(a, b, **values), mq.boolean(a, b, full=True, **values)
            report = full.report
            self.assertTrue(report.closed and report.oriented and report.manifold)
            self.assertGreater(partial.report.retained, 0)
            self.assertEqual(report.retained, 0)
            self.assertTrue((full.triangle_source == -1).all())
            self.assertEqual(report.samples, partial.report.samples)
            exact = mq.boolean(a, b, operation, method="exact").report.volume
            self.assertAlmostEqual(report.volume / exact, 1.0, delta=0.01)

    def test_without_it_nothing_changes(self):
        a, b = spheres()
        values = {"operation": "union", "method": "uniform", "resolution": 65}
        one, other = mq.boolean(a, b, **values), mq.boolean(a, b, full=False, **values)
        self.assertEqual(one.triangles.tobytes(), other.triangles.tobytes())
        self.assertEqual(one.vertices.tobytes(), other.vertices.tobytes())

    def test_of_shapes_it_lies_on_their_faces(self):
        full = mq.boolean([Part.makeSphere(10.0)], operation="union", method="uniform", resolution=65, full=True)
        self.assertEqual(full.report.retained, 0)
        radii = [sum(c * c for c in point) ** 0.5 for point in full.vertices + full.origin]
        self.assertLess(max(abs(radius - 10.0) for radius in radii), 1e-5)

    def test_other_methods_refuse_it(self):
        for method in ("default", "exact"):
            with self.assertRaisesRegex(mq.InvalidInput, "full is for method 'uniform' only"):
                mq.boolean(*spheres(), "union", method=method, full=True)
        with self.assertRaisesRegex(mq.InvalidInput, "full = 1.*True or False"):
            mq.boolean(*spheres(), "union", method="uniform", full=1)

    def test_the_document_object_has_it(self):
        document = FreeCAD.newDocument("full")
        self.addCleanup(FreeCAD.closeDocument, document.Name)
        sources = []
        for name, mesh in zip("AB", spheres()):
            sources.append(document.addObject("Mesh::Feature", name))
            sources[-1].Mesh = mesh
        obj = mq.add_boolean(*sources, "union", method="uniform", resolution=33, full=True)
        self.assertEqual(obj.Retained, 0)
        obj.Full = False
        document.recompute()
        self.assertGreater(obj.Retained, 0)
        obj.Full, obj.Method = True, "exact"
        document.recompute()
        self.assertIn("method 'uniform' only", obj.getStatusString())


if __name__ == "__main__":
    unittest.main()
