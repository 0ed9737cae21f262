# SPDX-License-Identifier: LGPL-2.1-or-later
"""repair, its document object, and the list of faults."""

import FreeCAD
import helpers
import Mesh
import numpy as np

import MeshQuality as mq
from MeshQuality.core.certify.faults import find_faults
from MeshQuality.core.meshes.surface_mesh import surface_of


def arrays(mesh):
    points, facets = mesh.Topology
    return np.array([tuple(point) for point in points]), np.array(facets)


def dirty():
    """A sphere with one fault of each kind that a repair removes, but for self-intersections; and its volume."""
    sphere = Mesh.createSphere(10, 30)
    points, facets = arrays(sphere)
    facets[10:12] = facets[10:12, ::-1]  # flipped
    return (points, np.vstack((facets[3:], facets[200:202]))), sphere.Volume


def crossing():
    """Two spheres in one mesh that cross each other."""
    points, facets = arrays(Mesh.createSphere(10, 20))
    return np.vstack((points, points + (8.0, 0.0, 0.0))), np.vstack((facets, facets + len(points)))


def counts(mesh):
    return {faults.kind: len(faults.triangles) for faults in find_faults(surface_of(mesh))}


class Faults(helpers.DocumentTest):
    def test_a_sound_mesh_has_none(self):
        self.assertEqual(counts(Mesh.createSphere(10, 20)), {})

    def test_the_numbers_are_those_of_quality(self):
        for mesh in (dirty()[0], crossing()):
            report, found = mq.quality(mesh), counts(mesh)
            self.assertEqual(found.get("open", 0), report.border_edges)
            self.assertEqual(found.get("nonmanifold", 0), report.nonmanifold_edges)
            self.assertEqual(found.get("duplicate", 0), report.duplicate_triangles)
            self.assertEqual(sum(found.get(kind, 0) for kind in ("crossing", "touching", "duplicate")),
                             report.self_intersections)

    def test_each_fault_names_triangles_that_have_it(self):
        (points, facets), _ = dirty()
        found = {faults.kind: faults for faults in find_faults(surface_of((points, facets)))}
        for one, other in found["duplicate"].triangles:
            self.assertEqual(sorted(facets[one]), sorted(facets[other]))
        uses = {}
        for facet in facets.tolist():
            for side in zip(facet, facet[1:] + facet[:1]):
                uses[tuple(sorted(side))] = uses.get(tuple(sorted(side)), 0) + 1
        for one, other in found["open"].triangles.tolist():
            facet = facets[one].tolist()
            self.assertEqual(other, -1)
            self.assertIn(1, [uses[tuple(sorted(side))] for side in zip(facet, facet[1:] + facet[:1])])
        self.assertEqual(str(found["duplicate"].words()), "2 duplicate triangles")
        self.assertIn("flipped", found)

    def test_triangles_without_area_and_empty_meshes(self):
        points = np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0]], dtype=float)
        self.assertEqual(counts((points, np.array([[0, 1, 2], [0, 2, 3], [0, 0, 1]])))["degenerate"], 2)
        self.assertEqual(counts((points, np.zeros((0, 3), dtype=int))), {})


class Repair(helpers.DocumentTest):
    def test_what_is_repaired_has_no_fault(self):
        mesh, volume = dirty()
        found = mq.repair(mesh)
        self.assertEqual(counts(found), {})
        self.assertTrue(found.report.closed)
        self.assertAlmostEqual(found.report.volume, volume, delta=1e-3 * volume)
        self.assertEqual(found.report.repaired, [
            "operand A: 2 duplicate triangles removed, 2 triangles turned around, 1 hole closed (3 triangles)"])

    def test_triangles_that_cross_are_divided(self):
        mesh = crossing()
        self.assertGreater(counts(mesh)["crossing"], 50)
        self.assertEqual(counts(mq.repair(mesh)), {})

    def test_an_open_sheet_is_refused(self):
        with self.assertRaisesRegex(mq.InvalidInput, "open surface"):
            mq.repair(Mesh.createPlane(5, 5))

    def test_the_object_follows_its_source(self):
        source = self.document.addObject("Mesh::Feature", "Scan")
        (points, facets), volume = dirty()
        source.Mesh = Mesh.Mesh((points[facets]).reshape(-1, 3).tolist())
        source.Placement.Base = FreeCAD.Vector(100, 0, 0)
        obj = mq.add_repaired_mesh(source)
        self.assertEqual(obj.Label, "Scan repaired")
        self.assertTrue(obj.Mesh.isSolid())
        self.assertAlmostEqual(obj.Volume.Value, volume, delta=1e-3 * volume)
        self.assertIn("hole closed", " ".join(obj.Repaired))
        self.assertEqual(obj.Certificate, "met")
        self.assertAlmostEqual(obj.Mesh.BoundBox.Center.x, 100, delta=0.1)
        source.Mesh = Mesh.createSphere(5, 20)
        self.document.recompute()
        self.assertEqual(obj.Repaired, [])
        self.assertAlmostEqual(obj.Mesh.Volume, source.Mesh.Volume, delta=1.0)
        with self.assertRaisesRegex(mq.InvalidInput, "with a mesh is needed"):
            mq.add_repaired_mesh(self.box())
