# SPDX-License-Identifier: LGPL-2.1-or-later
"""wrap: known answers, gaps, leaks, dirty input, patches, errors."""

import os
import tempfile
import unittest

import FreeCAD
import numpy as np
import Part
from FreeCAD import Vector

import MeshQuality as mq


def shell_of(*solids, without=()):
    """(V, F) of the faces of solids, but for those named, with no vertex shared between solids."""
    vertices, triangles, count = [], [], 0
    for solid in solids:
        for i, face in enumerate(solid.Faces):
            if f"Face{i + 1}" in without:
                continue
            points, corners = face.tessellate(0.01)
            vertices += [tuple(p) for p in points]
            triangles += [tuple(c + count for c in corner) for corner in corners]
            count += len(points)
    return np.array(vertices), np.array(triangles)


class Sound(unittest.TestCase):
    def require_sound(self, mesh):
        report = mesh.report
        self.assertTrue(report.closed and report.manifold and report.oriented)
        self.assertEqual(report.self_intersections, 0)
        self.assertEqual(report.method, "wrap")
        self.assertLessEqual(report.error_bound, report.tolerance_asked)
        return mesh


class KnownAnswers(Sound):
    def test_box_keeps_its_edges(self):
        mesh = self.require_sound(mq.wrap(Part.makeBox(10, 7, 5), 1.0, 0.2))
        self.assertAlmostEqual(mesh.report.volume, 350.0, delta=0.35)
        self.assertEqual(mesh.gap_triangles, 0)
        self.assertLess(mesh.report.triangles, 4000)

    def test_turned_box(self):
        box = Part.makeBox(10, 7, 5)
        box.rotate(Vector(0, 0, 0), Vector(1, 2, 3), 37.0)
        mesh = self.require_sound(mq.wrap(box, 1.0, 0.2))
        self.assertAlmostEqual(mesh.report.volume, 350.0, delta=0.7)

    def test_sphere(self):
        mesh = self.require_sound(mq.wrap(Part.makeSphere(5), 1.0, 0.1))
        self.assertAlmostEqual(mesh.report.volume / (4.0 / 3.0 * np.pi * 125.0), 1.0, delta=3e-3)

    def test_concave_edges_stay_sharp(self):
        corner = Part.makeBox(10, 10, 4).fuse(Part.makeBox(4, 10, 10))
        mesh = self.require_sound(mq.wrap(corner, 2.0, 0.25))
        self.assertAlmostEqual(mesh.report.volume, corner.Volume, delta=2e-3 * corner.Volume)

    def test_overlapping_bodies_lose_what_is_inside(self):
        mesh = self.require_sound(mq.wrap([Part.makeBox(6, 6, 6), Part.makeBox(6, 6, 6, Vector(3, 3, 3)),
                                           Part.makeBox(1, 1, 1, Vector(2, 2, 2))], 0.8, 0.2))
        self.assertAlmostEqual(mesh.report.volume, 2 * 216 - 27, delta=1.0)

    def test_mesh_far_from_the_origin(self):
        mesh = self.require_sound(mq.wrap(Part.makeBox(10, 10, 10, Vector(2e5, -1e5, 0)), 1.0, 0.25))
        self.assertAlmostEqual(mesh.report.volume, 1000.0, delta=1.0)
        self.assertAlmostEqual((mesh.vertices + mesh.origin)[:, 0].min(), 2e5, delta=0.1)


class MeshesOfShapes(Sound):
    """What a wrap starts from: meshes within a distance, of any angles."""

    def test_faces_that_we_refuse_are_opencascades_and_measured(self):
        path = os.path.join(os.environ.get("MESHQUALITY_DATA", ""), "cad", "SlenderSurface.brep")
        if not os.path.exists(path):
            self.skipTest("SlenderSurface.brep is not in $MESHQUALITY_DATA/cad")
        slender = Part.read(path)
        with self.assertRaises(mq.TopologyError):
            mq.triangulate(slender)
        mesh = mq.wrap(Part.makeCompound([Part.makeCylinder(4, 3), slender]), 1.0, 0.3)
        self.assertIn("operand A, Face4: not meshed; OpenCASCADE's triangulation", mesh.report.notes[0])
        self.assertGreater(mesh.report.error_bound, max(mesh.distance_to_input, mesh.distance_from_input))

    def test_error_bound_has_the_distance_of_the_meshes(self):
        mesh = self.require_sound(mq.wrap(Part.makeSphere(5), 1.0, 0.2))
        self.assertGreater(mesh.report.error_bound, max(mesh.distance_to_input, mesh.distance_from_input))


class Gaps(Sound):
    def test_narrow_crack_between_bodies_closes_and_a_wide_one_does_not(self):
        for width, closed in ((0.5, True), (3.0, False)):
            with self.subTest(width):
                bodies = [Part.makeBox(10, 10, 10), Part.makeBox(10, 10, 10, Vector(10 + width, 0, 0))]
                mesh = self.require_sound(mq.wrap(bodies, 1.0, 0.25))
                self.assertEqual(mesh.gap_triangles > 0, closed)
                self.assertAlmostEqual(mesh.report.volume, 2000.0 + (100.0 * width if closed else 0.0), delta=25.0)

    def test_open_box_fills_through_a_hole_that_is_narrower_than_the_gap(self):
        lid = shell_of(Part.makeBox(20, 18.8, 2, Vector(0, 0, 20)))
        mesh = self.require_sound(mq.wrap([shell_of(Part.makeBox(20, 20, 20), without=("Face6",)), lid], 2.0, 0.4))
        self.assertAlmostEqual(mesh.report.volume, 8000.0 + 20 * 18.8 * 2, delta=20.0)
        self.assertGreater(mesh.gap_area, 0.5 * 20 * 1.2)

    def test_open_box_stays_a_shell(self):
        mesh = self.require_sound(mq.wrap(shell_of(Part.makeBox(20, 20, 20), without=("Face6",)), 2.0, 0.5))
        self.assertAlmostEqual(mesh.report.volume, 5 * 400 * 0.5, delta=0.2 * 5 * 400 * 0.5)

    def test_leak_is_shown_and_closed_by_a_larger_gap(self):
        room = Part.makeBox(20, 20, 20).cut(Part.makeBox(16, 16, 16, Vector(2, 2, 2)))
        room = room.cut(Part.makeCylinder(1.5, 10, Vector(10, 10, 15)))
        inside = (10, 10, 10)
        mesh = mq.wrap(room, 2.0, 0.3, dry=[inside])
        self.assertEqual(len(mesh.leaks), 1)
        leak = mesh.leaks[0]
        self.assertAlmostEqual(leak.width, 3.0, delta=0.6)
        self.assertLess(np.hypot(leak.narrowest[0] - 10, leak.narrowest[1] - 10), 1.0)
        self.assertTrue(17.0 < leak.narrowest[2] < 21.0)
        self.assertTrue(np.allclose(leak.path[0], inside))
        self.assertGreater(leak.path[-1][2], 20.0)
        self.assertIn("not dry", str(leak))
        self.assertEqual(mq.wrap(room, 4.0, 0.3, dry=[inside]).leaks, [])


class Dirty(Sound):
    def test_reversed_doubled_and_missing_triangles(self):
        solids = Part.makeSphere(5), Part.makeBox(8, 3, 3, Vector(0, -1.5, -1.5))
        parts = [mq.triangulate(solid, chord_height=0.02, max_edge=0.6) for solid in solids]
        vertices = np.concatenate([part.vertices for part in parts])
        triangles = np.concatenate((parts[0].triangles, parts[1].triangles + len(parts[0].vertices)))
        rng = np.random.default_rng(3)
        flipped = rng.random(len(triangles)) < 0.5
        triangles[flipped] = triangles[flipped][:, ::-1]
        kept = rng.random(len(triangles)) < 0.97
        mesh = self.require_sound(mq.wrap((vertices, np.concatenate((triangles[kept], triangles[:20]))), 2.0, 0.25))
        clean = mq.boolean(*solids, "union", tolerance=0.02)
        self.assertAlmostEqual(mesh.report.volume / clean.report.volume, 1.0, delta=0.02)

    def test_faces_that_cannot_be_meshed_are_wrapped_as_opencascade_has_them(self):
        corners = [Vector(*p) for p in ((0, 0, 0), (9, 9, 0), (9, 0, 0), (0, 9, 0))]  # its border crosses itself
        shape = Part.makeCompound([Part.makeBox(6, 6, 6, Vector(20, 0, 0)),
                                   Part.Face(Part.makePolygon([*corners, corners[0]]))])
        with self.assertRaises(mq.TopologyError):
            mq.triangulate(shape)
        mesh = mq.wrap(shape, 1.0, 0.4)
        self.assertTrue(mesh.report.closed and mesh.report.manifold)
        self.assertEqual(mesh.report.self_intersections, 0)
        self.assertTrue(any("Face7: meshed neither" in note for note in mesh.report.notes), mesh.report.notes)
        box = mesh.vertices[mesh.vertices[:, 0] + mesh.origin[0] > 15] + mesh.origin
        self.assertTrue(np.allclose(box.max(axis=0), (26, 6, 6), atol=0.2))
        self.assertIn("Face1", mesh.patches)

    def test_random_soups_give_sound_wraps(self):
        for seed in range(6):
            with self.subTest(seed):
                rng = np.random.default_rng(seed)
                corners = (rng.random((40, 1, 3)) * 10 + rng.random((40, 3, 3)) * 4).reshape(-1, 3)
                mesh = mq.wrap((corners, np.arange(120).reshape(-1, 3)), 1.5, 0.4)
                report = mesh.report
                self.assertTrue(report.closed and report.manifold and report.oriented)
                self.assertEqual(report.self_intersections, 0)
                self.assertGreater(report.volume, 0.0)


class Named(Sound):
    def test_patches_are_faces_of_the_objects(self):
        document = FreeCAD.newDocument("Wrap")
        self.addCleanup(FreeCAD.closeDocument, document.Name)
        first, second = document.addObject("Part::Box", "First"), document.addObject("Part::Box", "Second")
        second.Placement.Base = Vector(10.3, 0, 0)
        document.recompute()
        mesh = self.require_sound(mq.wrap([first, second], 1.0, 0.25))
        faces = [f"{name}_Face{i}" for name in ("First", "Second") for i in range(1, 7)]
        self.assertLessEqual(set(mesh.patches), {*faces, "gaps"})
        for face in {*faces, "gaps"} - {"First_Face2", "Second_Face1"}:
            self.assertIn(face, mesh.patches)
        corners = mesh.vertices[mesh.triangles]
        areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
        for face in {"First_Face2", "Second_Face1"} & set(mesh.patches):  # at the mouth of the gap between them
            self.assertLess(areas[mesh.triangle_patch == mesh.patches.index(face)].sum(), 5.0)
        top = mesh.triangle_patch == mesh.patches.index("First_Face6")
        height = mesh.vertices[mesh.triangles[top]][:, :, 2] + mesh.origin[2]
        self.assertTrue(np.allclose(height, 10.0, atol=0.13))
        self.assertEqual(set(mesh.triangle_source[top][:, 0]), {0})

    def test_files_with_patches_of_ones_own(self):
        bodies = [Part.makeBox(5, 5, 5), Part.makeBox(5, 5, 5, Vector(5.3, 0, 0))]
        mesh = mq.wrap(bodies, 1.0, 0.25)
        with tempfile.TemporaryDirectory() as folder:
            for patches, rest, wanted in (
                    ({"inlet": ["Face1"], "outlet": ["Object2_Face2"]}, None, {"inlet", "outlet", "gaps", "Object1_Face3"}),
                    ({"inlet": ["Face1"], "leaks": ["gaps"]}, "walls", {"inlet", "leaks", "walls"})):
                path = os.path.join(folder, "out.stl")
                mesh.write(path, ascii=True, patches=patches, patch_rest=rest)
                with open(path, encoding="ascii") as file:
                    names = {line.split()[1] for line in file if line.startswith("solid")}
                self.assertLessEqual(wanted, names)
                self.assertNotIn("Surface", names)
            with self.assertRaisesRegex(mq.InvalidInput, "Object3_Face1"):
                mesh.write(path, patches={"inlet": ["Object3_Face1"]})

    def test_faces_without_triangles_count(self):
        hidden, box = Part.makeBox(2, 2, 2, Vector(1, 1, 1)), Part.makeBox(5, 5, 5)
        mesh = mq.wrap([hidden, box, mq.triangulate(Part.makeBox(5, 5, 5, Vector(20, 0, 0)))], 1.0, 0.25)
        self.assertEqual(set(mesh.triangle_face.tolist()), set(range(6, 18)))
        self.assertTrue((np.diff(mesh.triangle_face) >= 0).all())
        self.assertEqual(set(mesh.triangle_source[:, 0].tolist()), {1, 2})
        self.assertIn("Object3_Face6", mesh.patches)

    def test_one_object_keeps_the_names_of_its_faces(self):
        mesh = mq.wrap(Part.makeBox(5, 5, 5), 1.0)
        self.assertEqual(set(mesh.patches), {f"Face{i}" for i in range(1, 7)})


class Given(unittest.TestCase):
    def test_bad_input_is_named(self):
        box = Part.makeBox(10, 10, 10)
        for arguments, text in (((box, 0.0), "gap"), ((box, -1.0), "gap"), ((box, None), "gap"),
                                ((box, 1.0, 0.6), "half of the gap"), (([], 1.0), "empty"),
                                ((box, 1.0, 1e-4), "tolerance of 0.0001 mm would take more than 2 GB"), ((5, 1.0), "operand A")):
            with self.subTest(arguments), self.assertRaisesRegex(mq.InvalidInput, text):
                mq.wrap(*arguments)
        for dry in ("here", [(1, 2)], [(1, 2, float("nan"))]):
            with self.subTest(dry), self.assertRaisesRegex(mq.InvalidInput, "dry"):
                mq.wrap(box, 1.0, dry=dry)

    def test_any_number_of_threads_gives_the_same(self):
        solids = [Part.makeSphere(5), Part.makeBox(8, 3, 3)]
        one, three = (mq.wrap(solids, 1.0, 0.3, threads=threads) for threads in (1, 3))
        self.assertEqual(one.vertices.tobytes(), three.vertices.tobytes())
        self.assertEqual(one.triangles.tobytes(), three.triangles.tobytes())

    def test_progress_and_cancelling(self):
        seen = []
        mq.wrap(Part.makeBox(10, 10, 10), 1.0, progress=lambda fraction, stage: seen.append((fraction, stage)))
        self.assertEqual(sorted(fraction for fraction, _ in seen), [fraction for fraction, _ in seen])
        seen.clear()
        mq.wrap(Part.makeSphere(6), 1.0, 0.12, progress=lambda fraction, stage: seen.append((fraction, stage)))
        for stage in ("classifying nodes", "rolling the ball", "contouring", "simplifying", "measuring distances"):
            # Long ones are not told by their beginning alone.
            self.assertGreater(len({fraction for fraction, name in seen if name == stage}), 2, stage)
        with self.assertRaises(mq.Cancelled):
            mq.wrap(Part.makeBox(10, 10, 10), 0.5, 0.1, progress=lambda fraction, stage: False)


if __name__ == "__main__":
    unittest.main()
