# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts like those of Aftosmis 1999, section 4, at 25 degrees by Algorithm M alone."""

import unittest

import helpers
import numpy as np
import parts

import MeshQuality as mq
from MeshQuality.compat import extension

MIN_ANGLE = 25.0
PARTS = ("die", "wing_main", "flap")
INSERTIONS = ("off-centre", "circumcentre")


def edge_counts(triangles):
    """How often each edge is run, in either direction, {(from, to): count}."""
    runs = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    edges, counts = np.unique(runs, axis=0, return_counts=True)
    return {tuple(edge): count for edge, count in zip(edges.tolist(), counts.tolist())}


class PaperParts(unittest.TestCase):
    """Everything is counted here once more, apart from what the report says."""

    @classmethod
    def setUpClass(cls):
        cls.shapes = {name: parts.ALL[name]() for name in PARTS}
        cls.meshes = {
            (name, insertion): mq.triangulate(shape, min_angle=MIN_ANGLE, chord_height="none",
                                              insertion=insertion)
            for name, shape in cls.shapes.items() for insertion in INSERTIONS}

    def check_each(self, check):
        """Calls check(shape, mesh) for every part and insertion, each as a test of its own."""
        for (name, insertion), mesh in self.meshes.items():
            with self.subTest(part=name, insertion=insertion):
                check(self.shapes[name], mesh)

    def test_closed_oriented_manifold(self):
        def check(_, mesh):
            report = mesh.report
            self.assertTrue(report.closed and report.oriented and report.manifold, str(report))
            self.assertTrue(report.complete)
            counts = edge_counts(mesh.triangles)
            self.assertEqual(set(counts.values()), {1}, "an edge is run twice the same way")
            self.assertTrue(all((b, a) in counts for a, b in counts), "an edge has no other side")

        self.check_each(check)

    def test_euler_number_of_a_ball(self):
        def check(shape, mesh):
            self.assertEqual(len(shape.Shells), 1)
            edges = len(edge_counts(mesh.triangles)) // 2
            self.assertEqual(len(mesh.vertices) - edges + len(mesh.triangles), 2)
            self.assertEqual(mesh.report.euler, 2)

        self.check_each(check)

    def test_angles(self):
        def check(_, mesh):
            angles = helpers.smallest_angles(mesh)
            exempt = [triangle for triangle, _ in mesh.report.exempt]
            self.assertLess(len(exempt), 0.002 * len(angles))
            self.assertTrue((angles[exempt] < MIN_ANGLE).all(), "exempted without need")
            self.assertGreaterEqual(np.delete(angles, exempt).min(), MIN_ANGLE - 1e-9)
            self.assertAlmostEqual(angles.min(), mesh.report.min_angle, places=6)

        self.check_each(check)

    def test_exemptions_name_their_entities(self):
        def check(shape, mesh):
            counts = {"Face": len(shape.Faces), "Edge": len(shape.Edges),
                      "Vertex": len(shape.Vertexes)}
            for triangle, why in mesh.report.exempt_reasons:
                self.assertEqual(why.entities[-1], f"Face{mesh.triangle_face[triangle] + 1}")
                self.assertGreater(len(why.entities), 1, str(why))
                for name in why.entities:
                    kind = name.rstrip("0123456789")
                    self.assertTrue(1 <= int(name[len(kind):]) <= counts[kind], str(why))

        self.check_each(check)

    def test_the_die_needs_no_exemption(self):
        for insertion in INSERTIONS:
            self.assertEqual(self.meshes["die", insertion].report.exempt, [])

    def test_every_face_is_there_and_the_volume_is_near(self):
        def check(shape, mesh):
            self.assertEqual(np.unique(mesh.triangle_face).tolist(), list(range(len(shape.Faces))))
            # No chord height is asked for: a coarse mesh of a thin flap may miss a few percent.
            self.assertLess(abs(mesh.report.volume / shape.Volume - 1.0), 0.05)

        self.check_each(check)

    def test_off_centres_need_fewer_triangles(self):
        for name in PARTS:
            self.assertLessEqual(len(self.meshes[name, "off-centre"].triangles),
                                 len(self.meshes[name, "circumcentre"].triangles), name)


def core_surface(shape, **values):
    """A mesh of the core by options that only comparisons with the paper need."""
    options = extension().TriangulateOptions()
    for name, value in values.items():
        setattr(options, name, value)
    return extension().triangulate(shape, options)


class History(unittest.TestCase):
    """The smallest angle while Algorithm M runs, as in figure 7."""

    @classmethod
    def setUpClass(cls):
        cls.surfaces = {record: core_surface(parts.ALL["die"](), insertion="paper", record_angles=record)
                        for record in (False, True)}
        cls.counts, cls.angles = cls.surfaces[True].angle_history

    def test_the_mesh_is_the_same(self):
        plain, recorded = self.surfaces[False], self.surfaces[True]
        self.assertEqual(recorded.vertices.tobytes(), plain.vertices.tobytes())
        self.assertEqual(recorded.triangles.tobytes(), plain.triangles.tobytes())
        self.assertEqual(len(plain.angle_history[0]), 0)

    def test_ends_at_the_mesh(self):
        report = self.surfaces[True].report
        self.assertEqual(self.counts[-1], report.triangles)
        self.assertAlmostEqual(self.angles[-1], report.min_angle, places=9)

    def test_rises_with_spikes_downward(self):
        self.assertLess(self.angles[0], 10.0)
        self.assertGreaterEqual(self.angles[-1], MIN_ANGLE)
        self.assertTrue((np.diff(self.angles) < 0.0).any())
        self.assertTrue((np.diff(self.counts) >= 0).all(), "a vertex that is inserted adds triangles")


class Comparisons(unittest.TestCase):
    """The paper's order and the modeler's own evaluation keep the same promises."""

    def check(self, shape, surface):
        report = surface.report
        self.assertTrue(report.closed and report.oriented and report.manifold and report.complete, str(report))
        self.assertGreaterEqual(report.min_angle_unexempted, MIN_ANGLE)
        self.assertEqual(report.euler, 2)
        self.assertLess(abs(report.volume / shape.Volume - 1.0), 0.05)

    def test_one_vertex_after_the_other(self):
        shape = parts.ALL["die"]()
        surface = core_surface(shape, insertion="paper", order="worst first", record_angles=True)
        self.check(shape, surface)
        angles = surface.angle_history[1]
        above = np.flatnonzero(angles >= MIN_ANGLE)
        self.assertGreaterEqual(above[0], len(angles) - 2, "it goes on although all angles are large enough")

    def test_native_evaluation(self):
        for name in ("flap", "die"):
            shape = parts.ALL[name]()
            ours, native = (mq.triangulate(shape, evaluation=evaluation, chord_height_relative=1e-3)
                            for evaluation in ("fast", "native"))
            self.check(shape, native)
            self.assertLessEqual(native.report.max_chord_height, native.report.chord_height_asked)
            self.assertEqual(len(native.report.exempt), len(ours.report.exempt))
            self.assertAlmostEqual(native.report.volume / ours.report.volume, 1.0, delta=5e-3)

    def test_the_cache_tells_evaluations_apart(self):
        shape, cache = parts.ALL["flap"](), mq.MeshCache()
        ours = mq.triangulate(shape, chord_height="none", cache=cache)
        native = mq.triangulate(shape, chord_height="none", cache=cache, evaluation="native")
        self.assertEqual((ours.report.reused_faces, native.report.reused_faces), (0, 0))
        self.assertEqual(native.vertices.tobytes(),
                         mq.triangulate(shape, chord_height="none", evaluation="native").vertices.tobytes())
