# SPDX-License-Identifier: LGPL-2.1-or-later
"""Equal bodies of an assembly, inside FreeCAD: they have the same mesh at their places, which costs little."""

import unittest

import helpers

import FreeCAD
import numpy as np
import Part

import MeshQuality as mq

# No edge is within rounding of this distance: where one is, rounding of a copy may exceed it, and is repaired.
CHORD = 0.012
# Single precision at the assembly's size of 200 mm: rounding of both meshes.
RESOLUTION = 2e-5


def bolt():
    """A bolt with a rounded head, about the z axis, and a flat on its shank."""
    solid = Part.makeCylinder(8, 5).fuse(Part.makeCylinder(4, 20, FreeCAD.Vector(0, 0, -20))).removeSplitter()
    rims = [edge for edge in solid.Edges if len(edge.Vertexes) == 1 and abs(edge.Vertexes[0].Z - 5) < 1e-6]
    solid = solid.makeFillet(1.0, rims)
    return solid.cut(Part.makeBox(8, 2, 20, FreeCAD.Vector(-4, 3, -20))).Solids[0]


def at(shape, x, y=0.0, rotation=None):
    """The same geometry at another place."""
    result = Part.Shape(shape)
    result.Placement = FreeCAD.Placement(FreeCAD.Vector(x, y, 0), rotation or FreeCAD.Rotation())
    return result


def scaled(shape, factor):
    matrix = FreeCAD.Matrix()
    matrix.scale(factor, factor, factor)
    return shape.transformGeometry(matrix)


class Assembly(unittest.TestCase):
    """Five placed bolts, one of them turned by an odd angle; a mirrored one, and one that is slightly larger."""

    @classmethod
    def setUpClass(cls):
        odd = FreeCAD.Rotation(FreeCAD.Vector(1, 2, 3), 37.123)
        one = bolt()
        cls.copies = [at(one, 0), at(one, 30, 3.3), at(one, 60, 1.7, odd), at(one, 90), at(one, 120)]
        mirrored = one.mirror(FreeCAD.Vector(0, 0, 0), FreeCAD.Vector(0, 1, 0))
        mirrored.translate(FreeCAD.Vector(150, 0, 0))
        larger = scaled(one, 1.01)
        larger.translate(FreeCAD.Vector(180, 0, 0))
        cls.others = [mirrored, larger]
        cls.shape = Part.makeCompound(cls.copies + cls.others)
        cls.faces = len(one.Faces)
        cls.mesh = mq.triangulate(cls.shape, chord_height=CHORD)

    def corners(self, body):
        """The corners of a body's triangles, by triangle."""
        faces = np.asarray(self.mesh.triangle_face)
        chosen = (faces >= body * self.faces) & (faces < (body + 1) * self.faces)
        return np.asarray(self.mesh.vertices, float)[np.asarray(self.mesh.triangles)[chosen]]

    def test_every_bound_holds(self):
        report = self.mesh.report
        self.assertTrue(report.closed and report.oriented and report.manifold and report.complete, str(report))
        self.assertGreaterEqual(report.min_angle_unexempted, 25.0)
        self.assertLessEqual(report.max_chord_height, CHORD)
        self.assertEqual((report.self_intersections, report.overlaps), (0, 0))
        self.assertEqual(len(self.shape.Faces), 7 * self.faces)
        distances = helpers.distances_to_faces(self.shape, self.mesh, samples=200)
        self.assertLessEqual(max(distances), CHORD)

    def test_copies_have_the_mesh_of_the_first(self):
        first = self.corners(0)
        self.assertGreater(len(first), 1000)
        for body, copy in enumerate(self.copies):
            matrix = np.array(copy.Placement.toMatrix().A).reshape(4, 4)
            moved = first @ matrix[:3, :3].T + matrix[:3, 3]
            here = self.corners(body)
            self.assertEqual(here.shape, first.shape, f"copy {body}")
            # Output may turn the corners of a triangle: the nearest of its turns counts.
            turns = [np.abs(np.roll(moved, turn, axis=1) - here).max(axis=(1, 2)) for turn in range(3)]
            self.assertLess(np.min(turns, axis=0).max(), RESOLUTION, f"copy {body}")

    def test_others_have_their_own(self):
        first = self.corners(0)
        mirrored = self.corners(5) * (1, -1, 1) + (-150, 0, 0)
        larger = (self.corners(6) + (-180, 0, 0)) / 1.01
        for other in (mirrored, larger):
            self.assertTrue(other.shape != first.shape or np.abs(np.sort(other.mean(axis=1), axis=0) -
                                                                 np.sort(first.mean(axis=1), axis=0)).max() > 1e-3)

    def test_copies_cost_little(self):
        """Local sizes that change nothing, but differ from body to body, keep them from being equal."""
        sizes = {f"Face{body * self.faces + 1}": 1e6 + body for body in range(7)}
        apart = mq.triangulate(self.shape, chord_height=CHORD, local_sizes=sizes)
        self.assertEqual((apart.report.closed, apart.report.self_intersections), (True, 0))
        self.assertLess(self.mesh.report.queries, 0.65 * apart.report.queries)

    def test_the_number_of_threads_changes_nothing(self):
        for threads in (1, 3):
            mesh = mq.triangulate(self.shape, chord_height=CHORD, threads=threads)
            self.assertEqual(mesh.vertices.tobytes(), self.mesh.vertices.tobytes())
            self.assertEqual(mesh.triangles.tobytes(), self.mesh.triangles.tobytes())
            self.assertEqual(mesh.report.queries, self.mesh.report.queries)

    def test_smooth_edges_are_removed_from_all(self):
        mesh = mq.triangulate(self.shape, chord_height=CHORD, keep_edges="feature")
        self.assertTrue(mesh.report.closed and mesh.report.manifold, str(mesh.report))
        self.assertEqual(mesh.report.self_intersections, 0)
        self.assertGreaterEqual(mesh.report.min_angle_unexempted, 25.0)

    def test_a_local_size_concerns_one_copy(self):
        local = mq.triangulate(self.shape, chord_height=CHORD, local_sizes={f"Face{2 * self.faces + 1}": 0.5})
        faces = np.asarray(local.triangle_face) // self.faces
        counts = np.bincount(faces, minlength=7)
        before = np.bincount(np.asarray(self.mesh.triangle_face) // self.faces, minlength=7)
        self.assertGreater(counts[2], before[2])
        for body in (0, 1, 3, 4):
            self.assertEqual(counts[body], before[body])

    def test_an_edit_keeps_the_meshes_of_the_others(self):
        cache = mq.MeshCache()
        mq.triangulate(self.shape, chord_height=CHORD, cache=cache)
        edited = Part.makeCompound([*self.copies, self.others[0], at(Part.makeTorus(5, 2), 180)])
        again = mq.triangulate(edited, chord_height=CHORD, cache=cache)
        self.assertTrue(again.report.closed and again.report.manifold, str(again.report))
        self.assertGreaterEqual(again.report.reused_faces, 5 * self.faces)


if __name__ == "__main__":
    unittest.main()
