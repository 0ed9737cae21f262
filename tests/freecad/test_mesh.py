# SPDX-License-Identifier: LGPL-2.1-or-later
"""to_mesh, write and quality."""

import os
import unittest

import FreeCAD
import helpers
import Mesh
import numpy as np
import Part

import MeshQuality as mq
from MeshQuality.compat import extension
from MeshQuality.core.sources import convert


class ToMesh(unittest.TestCase):
    def test_same_points_and_triangles_in_the_same_order(self):
        for name, shape in helpers.simple_parts().items():
            with self.subTest(name):
                mesh = mq.triangulate(shape)
                points, facets = helpers.points_and_facets(mesh.to_mesh())
                self.assertTrue(np.array_equal(points, mesh.vertices + mesh.origin))
                self.assertTrue(np.array_equal(facets, mesh.triangles))

    def test_freecad_finds_the_mesh_sound(self):
        mesh = mq.triangulate(helpers.simple_parts()["cut"]).to_mesh()
        self.assertTrue(mesh.isSolid())
        for fault in ("hasNonManifolds", "hasInvalidNeighbourhood", "hasCorruptedFacets",
                      "hasNonUniformOrientedFacets", "hasPointsOutOfRange"):
            self.assertFalse(getattr(mesh, fault)(), fault)

    def test_one_segment_a_face(self):
        shape = helpers.simple_parts()["box"]
        surface = mq.triangulate(shape)
        mesh = surface.to_mesh()
        self.assertEqual(mesh.countSegments(), len(shape.Faces))
        for face in range(len(shape.Faces)):
            self.assertEqual(list(mesh.getSegment(face)),
                             np.flatnonzero(surface.triangle_face == face).tolist())

    def test_freecads_functions_make_the_same_mesh(self):
        surface = mq.triangulate(helpers.simple_parts()["cut"])._surface
        filled, wanted = Mesh.Mesh(), Mesh.Mesh()
        if not extension().fill_mesh(filled, surface):
            self.skipTest("this build of FreeCAD does not let us fill its meshes")
        convert.fill_by_python(wanted, surface)
        for what in (lambda mesh: mesh.Topology, lambda mesh: [
                mesh.getSegment(i) for i in range(mesh.countSegments())]):
            self.assertEqual(str(what(filled)), str(what(wanted)))
        self.assertFalse(filled.hasInvalidNeighbourhood())

    def test_only_meshes_are_filled(self):
        surface = mq.triangulate(helpers.simple_parts()["box"])._surface
        for other in (None, 3, "mesh", Part.makeBox(1, 1, 1), FreeCAD.Vector()):
            self.assertFalse(extension().fill_mesh(other, surface))
            self.assertIsNone(extension().bms_of_mesh(other))


class Copies(helpers.DocumentTest):
    def test_a_copy_does_not_follow_the_mesh(self):
        obj = self.document.addObject("Mesh::Feature", "Mesh")
        obj.Mesh = Mesh.createBox(1, 2, 3)
        obj.Placement.Base = FreeCAD.Vector(5, 0, 0)
        wanted = convert.arrays_of_mesh(obj)
        copy = convert.MeshCopy(obj)
        obj.Mesh = Mesh.createSphere(1)
        for mine, other in zip(copy.arrays, wanted):
            self.assertTrue(np.array_equal(mine, other))

    def test_both_ways_out_give_the_same_bytes(self):
        mesh = Mesh.createSphere(1, 20)
        found = extension().bms_of_mesh(mesh)
        if found is None:
            self.skipTest("this build of FreeCAD does not let us read its meshes")
        self.assertEqual(found.tobytes(), convert._bms_by_file(mesh))


class Write(helpers.DocumentTest):
    def test_every_format(self):
        mesh = mq.triangulate(Part.makeCylinder(5, 10))
        for suffix in ("stl", "ply", "obj", "off", "msh", "vtu"):
            path = os.path.join(self.folder, "part." + suffix)
            mesh.write(path)
            self.assertGreater(os.path.getsize(path), 100)
            if suffix in ("ply", "obj", "off"):
                points, facets = helpers.points_and_facets(Mesh.Mesh(path))
                self.assertTrue(np.array_equal(points, mesh.vertices), suffix)
                self.assertTrue(np.array_equal(facets, mesh.triangles), suffix)

    def test_failure_names_the_path(self):
        mesh = mq.triangulate(Part.makeBox(1, 1, 1))
        for path in ("/nowhere/at/all.ply", os.path.join(self.folder, "part.step")):
            with self.assertRaisesRegex(mq.IoError, os.path.basename(path)):
                mesh.write(path)


class Quality(helpers.DocumentTest):
    def test_all_kinds_of_meshes_give_the_same_numbers(self):
        surface = mq.triangulate(Part.makeCylinder(5, 10))
        feature = self.document.addObject("Mesh::Feature", "Mesh")
        feature.Mesh = surface.to_mesh()
        for mesh in (surface.to_mesh(), feature, (surface.vertices, surface.triangles),
                     (surface.vertices.tolist(), surface.triangles.tolist())):
            report = mq.quality(mesh)
            for name in ("triangles", "vertices", "closed", "oriented", "manifold", "min_angle",
                         "max_angle", "volume", "euler", "angle_histogram"):
                self.assertEqual(getattr(report, name), getattr(surface.report, name), name)

    def test_placement_counts(self):
        mesh = Mesh.createBox(1, 2, 3)
        mesh.Placement = FreeCAD.Placement(
            FreeCAD.Vector(10, 0, 0), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 90))
        low, high = mq.quality(mesh).box
        self.assertTrue(np.allclose(high - low, (2, 1, 3), atol=1e-6))
        self.assertTrue(np.allclose((high + low) / 2, (10, 0, 0), atol=1e-6))

    def test_distance_to_a_shape(self):
        shape = Part.makeSphere(5)
        surface = mq.triangulate(shape, chord_height=0.1)
        measured = mq.quality(surface.to_mesh(), shape).max_chord_height
        self.assertGreater(measured, 0.0)
        self.assertLessEqual(measured, 0.1)
        moved = surface.to_mesh()
        moved.translate(0, 0, 1)
        self.assertGreater(mq.quality(moved, shape).max_chord_height, 0.8)

    def test_what_is_no_mesh(self):
        for thing in (None, 5, "mesh", (1, 2, 3), Part.makeBox(1, 1, 1)):
            with self.assertRaises(mq.InvalidInput):
                mq.quality(thing)
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
        for triangles in ([(0, 1, 3)], [(0, 1, -1)], [(0, 1)], [(0.5, 1, 2)], [(0, 1, 2**40)]):
            with self.assertRaises(mq.InvalidInput):
                mq.quality((points, triangles))
        with self.assertRaises(mq.InvalidInput):
            mq.quality(([(0, 0, float("nan"))] * 3, [(0, 1, 2)]))
