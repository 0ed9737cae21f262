# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshing a part of many faces again after an edit."""

import tempfile
import unittest

import FreeCAD
import Part
from FreeCAD import Vector

import MeshQuality as mq
from MeshQuality import options
from MeshQuality.features import mesh_cache_limit
from MeshQuality.features.mesh_object import with_precomputed
from MeshQuality.features.quality_mesh import QualityMesh

PITCH = 10.0


def plate(first_radius, along=10):
    """A plate with a hundred holes, or others along its sides; the radius of the first one is free."""
    holes = []
    for i in range(along):
        for j in range(along):
            radius = first_radius if i == j == 0 else 2.0 + 0.1 * ((i + 3 * j) % 7)
            place = Vector(PITCH * (i + 0.5), PITCH * (j + 0.5), -1.0)
            holes.append(Part.makeCylinder(radius, 12.0 if (i + j) % 2 else 6.0, place))
    return Part.makeBox(PITCH * along, PITCH * along, 10.0).cut(Part.makeCompound(holes))


class AfterAnEdit(unittest.TestCase):
    def test_faces_that_did_not_change_keep_their_triangles(self):
        cache = mq.MeshCache()
        first = mq.triangulate(plate(2.0, 7), chord_height=0.05, cache=cache)
        self.assertEqual(first.report.reused_faces, 0)
        edited = plate(2.5, 7)
        self.assertEqual(len(cache), 1)
        again = mq.triangulate(edited, chord_height=0.05, cache=cache)
        self.assertGreater(again.report.reused_faces, 0.8 * len(edited.Faces))
        report = again.report
        self.assertTrue(report.closed and report.oriented and report.manifold)
        self.assertEqual(report.self_intersections, 0)
        self.assertGreaterEqual(report.min_angle_unexempted, 25.0)
        self.assertEqual(len(report.exempt), 0)
        self.assertLessEqual(report.max_chord_height, 0.05)
        judged = mq.quality(again, edited)
        self.assertLessEqual(judged.max_chord_height, 0.05 + 1e-5)

    def test_only_a_cache_is_one(self):
        with self.assertRaisesRegex(mq.InvalidInput, "cache"):
            mq.triangulate(plate(2.0), cache={})
        for wrong in (-1, 2.5, "8"):
            with self.assertRaisesRegex(mq.InvalidInput, "most_runs"):
                mq.MeshCache(most_runs=wrong)

    def test_the_older_names_go_on_working(self):
        with self.assertWarnsRegex(DeprecationWarning, "MeshQuality.Memory is called MeshQuality.MeshCache"):
            older = mq.Memory
        self.assertIs(older, mq.MeshCache)
        self.assertNotIn("Memory", dir(mq))
        cache, box = older(), Part.makeBox(1, 2, 3)
        mq.triangulate(box, memory=cache)
        self.assertEqual(len(cache), 1)
        with self.assertRaisesRegex(mq.InvalidInput, "memory is the older name of cache"):
            mq.triangulate(box, memory=cache, cache=cache)

    def test_a_cache_keeps_within_its_bounds(self):
        box = Part.makeBox(1, 1, 1)
        cache = mq.MeshCache(most_runs=2)
        for size in (0.5, 0.4, 0.3):
            mq.triangulate(box, max_edge=size, cache=cache)
        self.assertEqual(len(cache), 2)
        self.assertGreater(cache.bytes, 0)
        nothing = mq.MeshCache(most_bytes=10)
        mq.triangulate(box, cache=nothing)
        self.assertEqual((len(nothing), nothing.bytes), (0, 0))


def triangles_of(obj):
    return str(obj.Mesh.Topology), list(obj.FaceRuns)


class OfAnObject(unittest.TestCase):
    def setUp(self):
        self.document = FreeCAD.newDocument()
        self.addCleanup(lambda: FreeCAD.closeDocument(self.document.Name))
        self.source = self.document.addObject("Part::Feature", "Plate")
        self.source.Shape = plate(2.0, 5)
        self.mesh = mq.add_quality_mesh(self.source, chord_height=0.05)
        self.first = triangles_of(self.mesh)

    def edit(self, radius):
        self.source.Shape = plate(radius, 5)
        self.document.recompute()
        return triangles_of(self.mesh)

    def from_nothing(self):
        mesh = mq.triangulate(self.source, chord_height=0.05).to_mesh()
        return str(mesh.Topology)

    def test_faces_that_an_edit_leaves_alone_keep_their_triangles(self):
        self.assertEqual(self.mesh.ReusedFaces, 0)
        for radius in (2.5, 2.2):
            self.edit(radius)
            self.assertGreater(self.mesh.ReusedFaces, 0.8 * len(self.source.Shape.Faces))
            self.assertEqual(self.mesh.Certificate, "met")
            self.assertTrue(self.mesh.Mesh.isSolid())
            self.assertGreaterEqual(self.mesh.MeasuredMinAngle.Value, 25.0)
            self.assertLessEqual(self.mesh.MaxChordHeight.Value, 0.05)

    def test_what_was_computed_before_it_was_added_counts(self):
        values = options.check(options.TRIANGULATE, {"chord_height": 0.05})
        work = QualityMesh.work_on([self.source], values)
        with with_precomputed(QualityMesh, work, work.result(None)):
            self.mesh = mq.add_quality_mesh(self.source, chord_height=0.05)
        self.assertEqual(triangles_of(self.mesh), self.first)
        self.edit(2.5)
        self.assertGreater(self.mesh.ReusedFaces, 0.8 * len(self.source.Shape.Faces))
        self.assertEqual(self.edit(2.0), self.first)

    def test_what_was_there_comes_back(self):
        second = self.edit(2.5)
        third = self.edit(2.2)
        for radius, before in ((2.5, second), (2.0, self.first), (2.2, third), (2.0, self.first)):
            self.assertEqual(self.edit(radius), before)
            self.assertEqual(self.mesh.ReusedFaces, len(self.source.Shape.Faces))
        self.assertNotEqual(third[0], self.from_nothing())

    def test_undo_and_redo(self):
        self.document.UndoMode = 1
        self.edit(2.5)
        self.document.openTransaction("Edit")
        second = self.edit(2.2)
        self.document.commitTransaction()
        self.document.openTransaction("Edit")
        third = self.edit(2.1)
        self.document.commitTransaction()
        self.document.undo()
        self.document.recompute()
        self.assertEqual(triangles_of(self.mesh), second)
        self.document.redo()
        self.document.recompute()
        self.assertEqual(triangles_of(self.mesh), third)

    def test_without_reuse_the_shape_alone_decides(self):
        self.edit(2.5)
        self.edit(2.2)
        self.assertNotEqual(triangles_of(self.mesh)[0], self.from_nothing())
        self.mesh.Reuse = False
        self.document.recompute()
        self.assertEqual(triangles_of(self.mesh)[0], self.from_nothing())
        self.assertEqual((self.mesh.ReusedFaces, self.mesh.Proxy.cache), (0, None))
        self.edit(2.1)
        self.assertEqual(triangles_of(self.mesh)[0], self.from_nothing())
        self.assertEqual(self.edit(2.0), self.first)

    def test_neither_a_copy_nor_a_file_remembers(self):
        self.edit(2.5)
        before = triangles_of(self.mesh)
        copy = self.document.copyObject(self.mesh)
        self.document.recompute()
        self.assertEqual(triangles_of(copy)[0], before[0])
        self.assertIsNone(copy.Proxy.cache)
        with tempfile.TemporaryDirectory() as folder:
            path = f"{folder}/plate.FCStd"
            name = self.mesh.Name
            self.document.saveAs(path)
            FreeCAD.closeDocument(self.document.Name)
            self.document = FreeCAD.openDocument(path)
        self.mesh, self.source = self.document.getObject(name), self.document.getObject("Plate")
        self.assertIsNone(self.mesh.Proxy.cache)
        self.assertTrue(self.mesh.Reuse)
        self.document.recompute()
        self.assertEqual(triangles_of(self.mesh), before)  # nothing is computed
        self.edit(2.2)
        self.assertEqual(triangles_of(self.mesh)[0], self.from_nothing())
        self.assertEqual(self.mesh.Certificate, "met")
        self.edit(2.3)
        self.assertGreater(self.mesh.ReusedFaces, 0.8 * len(self.source.Shape.Faces))

    def test_an_object_may_be_collected_while_the_caches_are_counted(self):
        class Collected:
            """A weak reference to an object that is collected behind the first question."""

            def __init__(self, thing):
                self.left = [thing]

            def __call__(self):
                return self.left.pop() if self.left else None

        class Other:
            cache = None

        self.addCleanup(mesh_cache_limit._proxies.__setitem__, slice(None), list(mesh_cache_limit._proxies))
        mesh_cache_limit._proxies.append(Collected(Other()))
        mesh_cache_limit.use(self.mesh.Proxy)
        self.assertIs(mesh_cache_limit._proxies[-1](), self.mesh.Proxy)

    def test_all_objects_together_keep_within_a_bound(self):
        most = mesh_cache_limit._MOST
        self.addCleanup(setattr, mesh_cache_limit, "_MOST", most)
        mesh_cache_limit._MOST = int(1.5 * self.mesh.Proxy.cache.bytes)
        other = mq.add_quality_mesh(self.source, chord_height=0.05)
        self.assertIsNone(self.mesh.Proxy.cache)
        self.assertIsNotNone(other.Proxy.cache)
