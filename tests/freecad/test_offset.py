# SPDX-License-Identifier: LGPL-2.1-or-later
"""offset and hollow: known volumes, soundness, distances by other means, openings, refusals."""

import math
import unittest

import Mesh
import numpy as np
import Part
from FreeCAD import Vector

import MeshQuality as mq
from MeshQuality.compat import extension


def distances_from(shape, mesh):
    """Distances of the vertices and centres of a mesh from the surface of a shape, by OpenCASCADE."""
    points = np.asarray(mesh.vertices) + mesh.origin
    points = np.concatenate((points, points[mesh.triangles].mean(axis=1)))
    surface = Part.Compound(shape.Faces)
    return np.array([surface.distToShape(Part.Vertex(*p))[0] for p in points[:: max(1, len(points) // 300)].tolist()])


def assert_on_faces(test, shape, mesh, distance_of, tolerance):
    """Centres of the triangles are as far from their faces as distance_of(indices) says, mm."""
    centres = (np.asarray(mesh.vertices) + mesh.origin)[mesh.triangles].mean(axis=1)
    chosen = np.arange(0, len(centres), max(1, len(centres) // 300))
    far = [shape.Faces[mesh.triangle_face[i]].distToShape(Part.Vertex(*centres[i].tolist()))[0] for i in chosen]
    test.assertLessEqual(abs(np.array(far) - distance_of(chosen)).max(), tolerance)


class Offsets(unittest.TestCase):
    def assert_sound(self, result, tolerance):
        report = result.report
        self.assertTrue(report.closed and report.oriented and report.manifold)
        self.assertEqual(report.self_intersections, 0)
        self.assertEqual(report.faults_left, 0)
        self.assertLessEqual(report.error_bound, tolerance)
        self.assertGreater(report.error_bound, 0.0)
        self.assertTrue(result.to_mesh().isSolid())
        self.assertFalse(any(extension().verify(result._surface).values()))  # exact

    def test_a_box_outward_has_rounded_edges(self):
        result = mq.offset(Part.makeBox(10, 10, 10), 2.0, tolerance=0.02)
        self.assert_sound(result, 0.02)
        exact = 1000 + 6 * 100 * 2 + 3 * 10 * math.pi * 4 + 4 / 3 * math.pi * 8
        self.assertAlmostEqual(result.report.volume / exact, 1.0, delta=1.5e-3)
        self.assertLess(len(result.triangles), 5000)

    def test_a_box_inward_is_a_box(self):
        result = mq.offset(Part.makeBox(10, 10, 10), -2.0, tolerance=0.01)
        self.assert_sound(result, 0.01)
        self.assertAlmostEqual(result.report.volume, 216.0, delta=0.05)
        sides = np.ptp(np.asarray(result.vertices), axis=0)
        np.testing.assert_allclose(sides, 6.0, atol=1e-3)

    def test_known_volumes(self):
        # With the signed distance of points from each, in closed form.
        ball = Part.makeSphere(5), lambda x, y, z: np.hypot(np.hypot(x, y), z) - 5
        torus = Part.makeTorus(10, 3), lambda x, y, z: np.hypot(np.hypot(x, y) - 10, z) - 3

        def from_cylinder(x, y, z):
            beside, above = np.hypot(x, y) - 5, abs(z - 10) - 10
            return np.hypot(np.maximum(beside, 0), np.maximum(above, 0)) + np.minimum(np.maximum(beside, above), 0)

        cylinder = Part.makeCylinder(5, 20), from_cylinder
        cases = [
            (ball, 1.0, 4 / 3 * math.pi * 216), (ball, -2.0, 4 / 3 * math.pi * 27),
            (cylinder, -1.0, math.pi * 16 * 18),
            # Its rim is rounded off by a quarter of a torus' tube.
            (cylinder, 1.0, math.pi * 36 * 20 + 2 * (math.pi * 25 + math.pi**2 * 5 / 2 + 2 / 3 * math.pi)),
            (torus, 1.0, 2 * math.pi**2 * 10 * 16), (torus, -1.0, 2 * math.pi**2 * 10 * 4),
        ]
        for (shape, signed_distance), distance, exact in cases:
            with self.subTest(shape=shape.Faces[0].Surface, distance=distance):
                result = mq.offset(shape, distance, tolerance=0.01)
                self.assert_sound(result, 0.01)
                self.assertAlmostEqual(result.report.volume / exact, 1.0, delta=4e-3)
                points = np.asarray(result.vertices) + result.origin
                points = np.concatenate((points, points[result.triangles].mean(axis=1)))
                self.assertLessEqual(abs(signed_distance(*points.T) - distance).max(), 0.01)

    def test_a_finer_tolerance_is_nearer_to_the_known_volume(self):
        exact = 2 * math.pi**2 * 10 * 16
        errors = [abs(mq.offset(Part.makeTorus(10, 3), 1.0, tolerance=t).report.volume - exact) for t in (0.04, 0.01)]
        self.assertLess(errors[1], 0.4 * errors[0])

    def test_gaps_close_and_walls_vanish(self):
        plate = Part.makeBox(20, 20, 4).cut(Part.makeCylinder(1, 4, Vector(10, 10, 0)))
        closed = mq.offset(plate, 1.2, tolerance=0.02)
        self.assert_sound(closed, 0.02)
        open_hole = mq.offset(plate, 0.5, tolerance=0.02)
        self.assert_sound(open_hole, 0.02)
        # A through hole makes a ring of it: Euler's characteristic is 0 as long as it is open.
        self.assertEqual(euler_characteristic(open_hole), 0)
        # Closed, it leaves dimples at both ends, and nothing in the middle of its axis.
        from_middle = np.linalg.norm(np.asarray(closed.vertices) - (10, 10, 2), axis=1)
        self.assertGreater(from_middle.min(), 1.9)
        empty = mq.offset(plate, -2.1, tolerance=0.02)
        self.assertEqual(len(empty.triangles), 0)
        self.assertIn("empty", " ".join(empty.report.notes))

    def test_a_gap_of_twice_the_distance_closes(self):
        slot = Part.makeBox(20, 10, 10).cut(Part.makeBox(2, 10, 8, Vector(9, 0, 2)))
        self.assert_sound(mq.offset(slot, 1.0, tolerance=0.02), 0.02)

    def test_a_rod_shrunk_by_more_than_its_radius_is_gone(self):
        # A ball about a point of the rod's axis leaves a ring of the outside: winding numbers alone would keep it.
        rod = Part.makeCylinder(1, 30).fuse(Part.makeBox(10, 10, 10, Vector(-5, -5, 30)))
        result = mq.offset(rod, -1.5, tolerance=0.02)
        self.assert_sound(result, 0.02)
        self.assertAlmostEqual(result.report.volume, 7.0**3, delta=2.0)

    def test_features_smaller_than_the_distance(self):
        # The raw offset of each pin crosses those of all pins near it.
        plate = Part.makeBox(6, 6, 2)
        pins = [Part.makeCylinder(0.2, 0.6, Vector(1.0 + x, 1.0 + y, 2)) for x in range(5) for y in range(5)]
        comb = plate.fuse(pins)
        result = mq.offset(comb, 1.0, tolerance=0.02)
        self.assert_sound(result, 0.02)
        self.assertLessEqual(abs(distances_from(comb, result) - 1.0).max(), 0.02)
        assert_on_faces(self, comb, result, lambda i: np.full(len(i), 1.0), 0.02)
        self.assertNotIn("dividing cells", result.report.seconds)

    def test_where_the_raw_offset_cannot_be_trimmed(self):
        # All triangles of the shaft's raw offset cross each other around its axis: the contour of the distance takes its
        # place.
        disc = Part.makeCylinder(3, 10)
        shaft = disc.fuse(Part.makeCylinder(1, 20, Vector(0, 0, 9)))
        result = mq.offset(shaft, -1.5, tolerance=0.02)
        self.assertIn("dividing cells", result.report.seconds)
        self.assert_sound(result, 0.02)
        self.assertLessEqual(abs(distances_from(shaft, result) - 1.5).max(), 0.02)
        assert_on_faces(self, shaft, result, lambda i: np.full(len(i), 1.5), 0.02)

    def test_faces_are_those_of_the_shape(self):
        result = mq.offset(Part.makeBox(10, 10, 10), 1.0, tolerance=0.05)
        self.assertEqual(set(result.triangle_face), set(range(6)))
        top = [i for i, face in enumerate(Part.makeBox(10, 10, 10).Faces) if face.CenterOfMass.z > 9][0]
        middle = (np.asarray(result.vertices)[result.triangles[result.triangle_face == top]]).mean(axis=(0, 1))
        self.assertGreater(middle[2], 9.0)

    def test_faces_where_bodies_were_united(self):
        two = Part.makeCompound([Part.makeBox(10, 10, 10), Part.makeBox(10, 10, 10, Vector(5, 5, 5))])
        result = mq.offset(two, 0.5, tolerance=0.05)
        assert_on_faces(self, two, result, lambda i: np.full(len(i), 0.5), 0.05)
        self.assertEqual(set(result.triangle_face), set(range(12)))

    def test_of_a_mesh_no_faces_are_known(self):
        for result in (mq.offset(Mesh.createSphere(5.0, 20), 1.0, tolerance=0.05),
                       mq.hollow(Mesh.createSphere(5.0, 20), 1.0, tolerance=0.05)):
            self.assertEqual(len(result.triangle_face), 0)

    def test_meshes_and_bodies_that_overlap(self):
        ball = Mesh.createSphere(5.0, 40)
        result = mq.offset(ball, 1.0, tolerance=0.05)
        self.assert_sound(result, 0.05)
        self.assertAlmostEqual(result.report.volume / (4 / 3 * math.pi * 216), 1.0, delta=1.5e-2)
        two = Part.makeCompound([Part.makeBox(10, 10, 10), Part.makeBox(10, 10, 10, Vector(5, 5, 5))])
        self.assert_sound(mq.offset(two, 0.5, tolerance=0.02), 0.02)

    def test_the_same_for_any_number_of_threads(self):
        part = Part.makeBox(10, 10, 10).cut(Part.makeCylinder(3, 10, Vector(5, 5, 0)))
        one, three = (mq.offset(part, -1.0, tolerance=0.02, threads=n) for n in (1, 3))
        np.testing.assert_array_equal(one.vertices, three.vertices)
        np.testing.assert_array_equal(one.triangles, three.triangles)

    def test_progress_and_cancelling(self):
        fractions = []
        mq.offset(Part.makeSphere(5), 1.0, tolerance=0.01, progress=lambda f, s: fractions.append(f))
        self.assertEqual(fractions, sorted(fractions))
        with self.assertRaises(mq.Cancelled):
            mq.offset(Part.makeTorus(10, 3), 1.0, tolerance=5e-4, progress=lambda f, s: False)
        # Caps of millions of triangles, which take minutes to make.
        with self.assertRaises(mq.Cancelled):
            mq.offset(Part.makeBox(1e-3, 1e-3, 1e-3), 0.1, tolerance=1e-7, progress=lambda f, s: s != "offsetting")

    def test_the_default_tolerance_follows_the_size_of_the_result(self):
        result = mq.offset(Part.makeBox(1, 1, 1), 10.0)
        self.assert_sound(result, 0.021)
        self.assertAlmostEqual(result.report.tolerance_asked, 0.021, delta=1e-12)
        self.assertLess(len(result.triangles), 50_000)  # 734,060 for a tolerance of 0.001


class Hollows(unittest.TestCase):
    assert_sound = Offsets.assert_sound

    def test_a_closed_box(self):
        result = mq.hollow(Part.makeBox(10, 10, 10), 1.0, tolerance=0.01)
        self.assert_sound(result, 0.01)
        self.assertAlmostEqual(result.report.volume, 1000 - 512, delta=0.1)
        self.assertEqual(euler_characteristic(result), 4)  # two shells

    def test_a_box_open_at_the_top(self):
        box = Part.makeBox(10, 10, 10)
        top = next(f"Face{i + 1}" for i, face in enumerate(box.Faces) if face.CenterOfMass.z > 9)
        result = mq.hollow(box, 1.0, openings=[top], tolerance=0.01)
        self.assert_sound(result, 0.01)
        self.assertAlmostEqual(result.report.volume, 1000 - 8 * 8 * 9, delta=0.2)
        self.assertEqual(euler_characteristic(result), 2)

    def test_a_pipe_that_is_open_at_both_ends(self):
        rod = Part.makeCylinder(5, 20)
        ends = [f"Face{i + 1}" for i, face in enumerate(rod.Faces) if face.Surface.TypeId == "Part::GeomPlane"]
        result = mq.hollow(rod, 0.8, openings=ends, tolerance=0.01)
        self.assert_sound(result, 0.01)
        self.assertAlmostEqual(result.report.volume / (math.pi * (25 - 4.2**2) * 20), 1.0, delta=4e-3)
        self.assertEqual(euler_characteristic(result), 0)

    def test_openings_that_meet_leave_no_wall_between_them(self):
        box = Part.makeBox(10, 10, 10)
        box.rotate(Vector(1, 2, 3), Vector(1, 1, 2), 30)
        for openings, hollow in ((("Face2", "Face6"), 8 * 9 * 9), (("Face2", "Face4", "Face6"), 9**3), (("Face1", "Face2"), 8 * 8 * 10)):
            result = mq.hollow(box, 1.0, openings=openings, tolerance=0.01)
            self.assert_sound(result, 0.01)
            self.assertAlmostEqual(result.report.volume, 1000 - hollow, delta=0.3)
            self.assertNotIn("dividing cells", result.report.seconds)
            self.assertLess(len(result.triangles), 150)

    def test_a_plane_opening_takes_little_more_than_a_closed_hollow(self):
        """The offset inward of the solid with a prism on the opening: no contour, and not more triangles than it needs."""
        box = Part.makeBox(20, 15, 10)
        rounded, inner = box.makeFillet(3, box.Edges), Part.makeBox(18, 13, 8, Vector(1, 1, 1))
        depth = (np.arange(1000) + 0.5) / 1000  # above the inner box, within a distance of 1 from the rim
        away = np.sqrt(1.0 - depth**2)
        hollow = inner.makeFillet(2, inner.Edges).Volume + np.mean((14 - 2 * away) * (9 - 2 * away))
        drilled = box.cut(Part.makeCylinder(3, 10, Vector(7, 7, 0)))
        left = 18 * 13 * 9 - math.pi * 4**2 * 9
        for shape, volume in ((rounded, rounded.Volume - hollow), (drilled, drilled.Volume - left)):
            top = next(f"Face{i + 1}" for i, face in enumerate(shape.Faces) if face.CenterOfMass.z > 9.9)
            result, closed = mq.hollow(shape, 1.0, openings=[top], tolerance=0.05), mq.hollow(shape, 1.0, tolerance=0.05)
            self.assert_sound(result, 0.05)
            self.assertAlmostEqual(result.report.volume / volume, 1.0, delta=3e-3)
            self.assertNotIn("dividing cells", result.report.seconds)
            self.assertLess(len(result.triangles), 1.3 * len(closed.triangles))

    def test_openings_that_are_not_plane_or_lie_in_pockets(self):
        """No prism fits there: both sides of the walls are offset."""
        rod = Part.makeCylinder(5, 20)
        side = next(f"Face{i + 1}" for i, face in enumerate(rod.Faces) if face.Surface.TypeId == "Part::GeomCylinder")
        result = mq.hollow(rod, 1.0, openings=[side], tolerance=0.05)
        self.assert_sound(result, 0.05)
        self.assertAlmostEqual(result.report.volume / (2 * math.pi * 25), 1.0, delta=1e-2)
        pocket = Part.makeBox(10, 10, 10).cut(Part.makeBox(3, 10, 5, Vector(3.5, 0, 5)))
        floor = next(f"Face{i + 1}" for i, face in enumerate(pocket.Faces) if abs(face.CenterOfMass.z - 5) < 1e-6
                     and face.normalAt(0, 0).z > 0.9)
        result = mq.hollow(pocket, 1.0, openings=[floor], tolerance=0.05)
        self.assert_sound(result, 0.05)
        self.assertLessEqual(distances_from(Part.Compound([f for i, f in enumerate(pocket.Faces) if f"Face{i + 1}" != floor]),
                                            result).max(), 1.56)  # amid the rim of the floor, 3 wide, at most 1.5

    def test_walls_that_rise_from_an_opening(self):
        # The hollow ends at a distance of 1 from the rim: half a disk, along a line and around an axis.
        plate, up = Part.makeBox(30, 20, 10), Vector(0, 0, 1)
        slab = 18 * (28 * 9 + 8 * 7 - math.pi / 2)
        boss = 28 * 18 * 9 - math.pi**2 * 4 + math.pi * 3**2 * 7
        for rising, hollow in ((Part.makeBox(10, 20, 18), slab), (Part.makeCylinder(4, 18, Vector(15, 10, 0)), boss)):
            part = plate.fuse(rising).removeSplitter()
            opening = next(f"Face{i + 1}" for i, face in enumerate(part.Faces)
                           if face.normalAt(0, 0).dot(up) > 0.99 and abs(face.CenterOfMass.z - 10) < 1e-6)
            part.rotate(Vector(1, 2, 3), Vector(1, 2, 1), 37)
            result = mq.hollow(part, 1.0, openings=[opening], tolerance=0.02)
            self.assertNotIn("dividing cells", result.report.seconds)  # no contour, which takes a hundred times as long
            self.assertLessEqual(result.report.error_bound, 0.02)
            self.assertAlmostEqual(result.report.volume, part.Volume - hollow, delta=0.002 * hollow)

    def test_round_edges_as_wide_as_the_wall(self):
        # The offset of such an edge is its axis. Where directions scattered around it, the offset was made as a contour of
        # cells, which took minutes.
        box = Part.makeBox(40, 30, 20)
        upright = [edge for edge in box.Edges if abs(edge.tangentAt(0).z) > 0.9]
        for radius in (1.96, 2.0, 2.1):
            solid = box.makeFillet(radius, upright)
            top = [f"Face{i}" for i, face in enumerate(solid.Faces, 1) if face.CenterOfMass.z > 19.9]
            result = mq.hollow(solid, 2.0, openings=top)
            self.assert_sound(result, 0.05)
            self.assertNotIn("dividing cells", result.report.seconds)
            inner = (36.0 * 26.0 - (4.0 - math.pi) * max(radius - 2.0, 0.0) ** 2) * 18.0
            self.assertAlmostEqual(result.report.volume, solid.Volume - inner, delta=0.05 * result.report.area)

    def test_walls_that_leave_an_opening_tangentially(self):
        # A plate between two round rails: from the rim of its lower face the rails go on upright at first.
        rail = Part.makeBox(9, 36, 13.5)
        rail = rail.makeFillet(1.35, [edge for edge in rail.Edges if abs(edge.tangentAt(0).y) > 0.9])
        solid = rail.fuse([rail.translated(Vector(51, 0, 0)), Part.makeBox(42, 36, 12.15, Vector(9, 0, 1.35))]).removeSplitter()
        plates = [f"Face{i}" for i, face in enumerate(solid.Faces, 1)
                  if abs(face.normalAt(0, 0).z) > 0.9 and abs(face.CenterOfMass.x - 30.0) < 1e-6 and face.Area > 1000]
        self.assertEqual(len(plates), 2)
        result = mq.hollow(solid, 0.675, openings=plates)
        self.assert_sound(result, 0.675 / 40.0)
        self.assertNotIn("dividing cells", result.report.seconds)

    def test_openings_whose_prisms_would_meet(self):
        """Two faces that meet in a concave edge: the prism on one would be in that on the other."""
        step = Part.makeBox(12, 8, 10).cut(Part.makeBox(6, 8, 5, Vector(6, 0, 5)))
        openings = [f"Face{i + 1}" for i, face in enumerate(step.Faces) if (face.CenterOfMass - Vector(7.5, 4, 6.5)).Length < 2.6]
        self.assertEqual(len(openings), 2)
        result = mq.hollow(step, 1.0, openings=openings, tolerance=0.1)
        self.assertAlmostEqual(result.report.volume, step.Volume - 6 * (10 * 4 + 5 * 4), delta=0.5)

    def test_what_is_closed_and_what_is_no_hollow_is_said(self):
        """An open shell is closed first: the result says so, as a Boolean does."""
        open_box = Part.Shell(Part.makeBox(10, 10, 10).Faces[:5])
        for result in (mq.offset(open_box, 1.0), mq.hollow(open_box, 1.0)):
            self.assertEqual(result.report.repaired[:1], ["1 hole closed (2 triangles)"])
            self.assertIn("repaired before: 1 hole closed (2 triangles)", result.report.notes)
        for result in (mq.offset(Part.makeBox(10, 10, 10), 1.0), mq.hollow(Part.makeBox(10, 10, 10), 1.0, openings=["Face6"])):
            self.assertEqual((result.report.repaired, result.report.notes), ([], []))
        self.assertIn("the hollow is closed", mq.hollow(Part.makeBox(10, 10, 10), 1.0).report.notes[0])
        self.assertIn("there is no hollow", mq.hollow(Part.makeBox(10, 10, 10), 6.0).report.notes[0])

    def test_a_hollow_is_rounded_where_the_outside_is_concave(self):
        step = Part.makeBox(20, 10, 20).cut(Part.makeBox(10, 10, 10, Vector(10, 0, 10)))
        result = mq.hollow(step, 2.0, tolerance=0.02)
        self.assert_sound(result, 0.02)
        inside = 6 * (16 * 6 + 6 * 10 + 2 * 2 - math.pi * 2**2 / 4)
        self.assertAlmostEqual(step.Volume - result.report.volume, inside, delta=0.01 * inside)

    def test_faces_are_those_of_the_shape(self):
        part = Part.makeBox(20, 20, 10).cut(Part.makeCylinder(4, 10, Vector(10, 10, 0)))
        top = next(i for i, face in enumerate(part.Faces) if face.CenterOfMass.z > 9)
        for openings in (None, [f"Face{top + 1}"]):
            result = mq.hollow(part, 2.0, openings=openings, tolerance=0.05)
            self.assert_sound(result, 0.05)
            self.assertEqual(set(result.triangle_face), set(range(7)))
            corners = np.asarray(result.vertices)[result.triangles]
            on_outside = (corners[:, :, 2] > 10 - 1e-5).all(axis=1)
            self.assertEqual(set(result.triangle_face[on_outside]), {top})
            # A triangle is on its face, or as far from it as the wall is thick.
            inside = result.triangle_source[:, 0] == 1
            if openings is None:
                assert_on_faces(self, part, result, lambda i, inside=inside: np.where(inside[i], 2.0, 0.0), 0.05)
                self.assertEqual(set(result.triangle_face[inside]), set(range(7)))
            else:
                self.assertNotIn(top, result.triangle_face[inside])  # the rims lie on it

    def test_openings_of_bodies_that_cross(self):
        two = Part.makeCompound([Part.makeBox(10, 10, 10), Part.makeBox(10, 10, 10, Vector(5, 5, 5))])
        top = next(f"Face{i + 1}" for i, face in enumerate(two.Faces) if face.CenterOfMass.z > 14)
        result = mq.hollow(two, 1.0, openings=[top], tolerance=0.05)
        self.assert_sound(result, 0.05)
        closed = mq.hollow(two, 1.0, tolerance=0.05)
        self.assertAlmostEqual(closed.report.volume - result.report.volume, 64.0, delta=1.0)

    def test_a_thin_plate_stays_whole(self):
        result = mq.hollow(Part.makeBox(20, 20, 1), 0.8, tolerance=0.01)
        self.assertAlmostEqual(result.report.volume, 400.0, delta=0.1)


class Refusals(unittest.TestCase):
    def test_values(self):
        box = Part.makeBox(10, 10, 10)
        for call, words in [
            (lambda: mq.offset(box, 0.0), "distance"), (lambda: mq.offset(box, None), "distance"),
            (lambda: mq.offset(box, float("nan")), "distance"), (lambda: mq.offset(box, 1.0, tolerance=2.0), "tolerance"),
            (lambda: mq.offset(box, 1.0, tolerance=1e-9), "tolerance"), (lambda: mq.hollow(box, -1.0), "thickness"),
            (lambda: mq.hollow(box, 1.0, openings=["Face9"]), "Face9"),
            (lambda: mq.hollow(box, 1.0, openings="Face1"), "openings"),
            (lambda: mq.hollow(box, 1.0, openings=[]), "openings"),
            (lambda: mq.hollow(box, 1.0, openings=[f"Face{i}" for i in range(1, 7)]), "all faces"),
            (lambda: mq.hollow(Mesh.createSphere(5.0, 20), 1.0, openings=["Face1"]), "mesh"),
            (lambda: mq.offset(Part.makePlane(10, 10), 1.0), "open"),
        ]:
            with self.subTest(words=words), self.assertRaises(mq.InvalidInput) as raised:
                call()
            self.assertIn(words, str(raised.exception))


def euler_characteristic(mesh):
    edges = np.sort(np.asarray(mesh.triangles)[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    return len(np.unique(mesh.triangles)) - len(np.unique(edges, axis=0)) + len(mesh.triangles)
