# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids with exact surfaces from meshes that know their CAD: valid, closed, of the right volume by formula, read back from STEP."""

import math
import os
import tempfile
import unittest

import FreeCAD
import Part

import MeshQuality as mq

BOX = Part.makeBox(10, 20, 30)
CYLINDER = Part.makeCylinder(5, 20)


class ToSolid(unittest.TestCase):
    def check(self, solid, volume, faces, kinds):
        """A MeshSolid that is valid and has this volume, mm^3, this number of faces, and these kinds of surfaces."""
        self.assertTrue(solid.shape.isValid())
        self.assertTrue(all(shell.isClosed() for shell in solid.shape.Shells))
        self.assertAlmostEqual(solid.shape.Volume / volume, 1.0, places=6)
        self.assertEqual((solid.faces, solid.facets), (faces, 0))
        self.assertEqual({type(face.Surface).__name__ for face in solid.shape.Faces}, kinds)
        self.assertLessEqual(solid.deviation, solid.tolerance)
        self.assertLessEqual(solid.deviation_back, solid.tolerance)

    def test_a_triangulated_shape_comes_back(self):
        self.check(mq.to_solid(mq.triangulate(CYLINDER)), CYLINDER.Volume, 3, {"Plane", "Cylinder"})
        self.check(mq.to_solid(mq.triangulate(Part.makeSphere(5))), Part.makeSphere(5).Volume, 1, {"Sphere"})

    def test_a_grown_box_has_cylinders_and_spheres(self):
        solid = mq.to_solid(mq.offset(BOX, 2.0, tolerance=0.05))
        volume = 6000 + 2 * 2200 + math.pi * 4 * 60 + math.pi * 32 / 3  # Steiner's formula
        self.check(solid, volume, 26, {"Plane", "Cylinder", "Sphere"})

    def test_a_grown_cylinder_has_tori(self):
        solid = mq.to_solid(mq.offset(CYLINDER, 2.0, tolerance=0.05))
        area, mean_curvature = CYLINDER.Area, math.pi * 20 + math.pi ** 2 * 5
        self.check(solid, CYLINDER.Volume + 2 * area + 4 * mean_curvature + math.pi * 32 / 3, 5, {"Plane", "Cylinder", "Toroid"})

    def test_shrunk_and_hollowed_solids(self):
        self.check(mq.to_solid(mq.offset(BOX, -2.0)), 6 * 16 * 26, 6, {"Plane"})
        self.check(mq.to_solid(mq.hollow(BOX, 2.0)), 6000 - 6 * 16 * 26, 12, {"Plane"})
        self.check(mq.to_solid(mq.hollow(BOX, 2.0, ["Face6"])), 6000 - 6 * 16 * 28, 11, {"Plane"})

    def test_an_opening_that_goes_on_smoothly_in_roundings(self):
        """The wall is round about the edges between: within 2 of (3, 0) and (17, 0)."""
        box = Part.makeBox(20, 20, 10)
        part = box.makeFillet(3, [edge for edge in box.Edges if abs(edge.tangentAt(0).z) > 0.5])
        front = next(f"Face{i + 1}" for i, face in enumerate(part.Faces) if face.BoundBox.YMax < 1e-6)
        solid = mq.to_solid(mq.hollow(part, 2.0, [front]))
        self.check(solid, 3640 + 90 * math.pi - 6 * (280 - math.pi), solid.faces, {"Plane", "Cylinder"})

    def test_booleans_of_shapes_and_of_meshes_made_of_shapes(self):
        solid = mq.to_solid(mq.boolean(BOX, CYLINDER, "difference"))
        self.check(solid, BOX.cut(CYLINDER).Volume, 8, {"Plane", "Cylinder"})
        hole = Part.makeCylinder(1.5, 40, FreeCAD.Vector(5, 10, -5))
        solid = mq.to_solid(mq.boolean(mq.hollow(BOX, 2.0), hole, "difference"))
        self.check(solid, 6000 - 6 * 16 * 26 - math.pi * 2.25 * 4, 14, {"Plane", "Cylinder"})

        ball = Part.makeSphere(8)
        solid = mq.to_solid(mq.boolean(BOX, ball, "union"))
        self.check(solid, BOX.fuse(ball).Volume, 7, {"Plane", "Sphere"})

    def test_step_is_read_back(self):
        solid = mq.to_solid(mq.triangulate(BOX))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "box.step")
            solid.write(path)
            back = Part.Shape()
            back.read(path)
            self.assertAlmostEqual(back.Volume, 6000.0, places=6)
            with self.assertRaisesRegex(mq.IoError, "missing"):
                solid.write(os.path.join(folder, "missing", "box.step"))

    def test_a_mesh_without_cad_gets_merged_facets(self):
        solid = mq.to_solid(mq.triangulate(BOX).to_mesh())
        self.assertEqual((solid.faces, solid.facets), (0, 6))
        self.assertAlmostEqual(solid.shape.Volume, 6000.0, places=3)
        self.assertIn("does not know the CAD", solid.notes[0])

    def test_facets_of_slivers(self):
        """Of the mesh some triangles are narrower than a thousandth of a millimetre; the solid has them all the same."""
        dome = Part.makeBox(60, 60, 10).fuse(Part.makeSphere(20, FreeCAD.Vector(30, 30, 10)))
        mesh = mq.cam(dome, 0.1)
        made = mq.to_solid(mesh)
        self.assertTrue(made.shape.isValid() and made.shape.isClosed())
        self.assertEqual(made.faces, 0)
        self.assertGreater(made.facets, 3000)
        self.assertAlmostEqual(made.shape.Volume, mesh.report.volume, places=3)
        corners = [tuple(vertex.Point) for vertex in made.shape.Vertexes]
        self.assertLess(mq.deviation(corners, mesh).max_deviation, 1e-4)

    def test_what_cannot_be_is_refused(self):
        points, triangles = BOX.tessellate(1.0)
        with self.assertRaisesRegex(mq.InvalidInput, "not closed"):
            mq.to_solid(([tuple(point) for point in points], triangles[:-1]))
        with self.assertRaisesRegex(mq.GeometryError, "does not know the CAD"):
            mq.to_solid(mq.triangulate(BOX).to_mesh(), facets=False)
        with self.assertRaisesRegex(mq.InvalidInput, "too many facets: simplify"):
            mq.to_solid(mq.triangulate(Part.makeSphere(5), max_edge=0.15).to_mesh())
        with self.assertRaises(mq.Cancelled):
            mq.to_solid(mq.triangulate(BOX), progress=lambda *_: False)
