# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickness: known answers, what is measured, the report, the command line."""

import json
import math
import os
import re
import subprocess
import tempfile
import time
import unittest

import FreeCAD
import helpers
import Mesh
import MeshPart
import numpy as np
import Part

import MeshQuality as mq
from MeshQuality.core.certify import verdict

COMMAND = os.path.join(helpers.ROOT, "bin", "meshquality")
V = FreeCAD.Vector


def pipe(outer, wall, height):
    return Part.makeCylinder(outer, height).cut(Part.makeCylinder(outer - wall, height))


def wedge(low, high, length, width):
    """A plate that gets thicker along x, its lower side in the plane z = 0."""
    corners = [V(0, 0, 0), V(length, 0, 0), V(length, 0, high), V(0, 0, low)]
    return Part.Face(Part.makePolygon([*corners, corners[0]])).extrude(V(0, width, 0))


class KnownAnswers(unittest.TestCase):
    def check(self, shape, wall, faces):
        """Both measures give the wall within 2 % everywhere but near the ends."""
        found = mq.thickness(shape)
        for result in (found, found.by("rays")):
            self.assertAlmostEqual(result.minimum, wall, delta=0.02 * wall)
            self.assertEqual(set(result.minimum_faces), faces)
        inner, high = found.percentile([2, 90])
        self.assertAlmostEqual(inner, wall, delta=0.02 * wall)
        self.assertAlmostEqual(high, wall, delta=0.02 * wall)
        self.assertLessEqual(found.chord_height, 0.01 * wall)
        return found

    def test_plates(self):
        for wall in (0.8, 3.0):
            found = self.check(Part.makeBox(60, 40, wall), wall, {"Face5", "Face6"})
            self.assertAlmostEqual(found.minimum, wall, delta=1e-6)

    def test_pipes(self):
        for wall in (0.8, 3.0):
            shape = pipe(10, wall, 40)
            round_faces = {f"Face{i + 1}" for i, face in enumerate(shape.Faces) if "Cylinder" in str(face.Surface)}
            self.check(shape, wall, round_faces)

    def test_shells_of_spheres(self):
        for wall in (0.8, 3.0):
            self.check(Part.makeSphere(20).cut(Part.makeSphere(20 - wall)), wall, {"Face1", "Face2"})

    def test_tapered_wall_at_every_place(self):
        slope = 2.2 / 40.0
        found = mq.thickness(wedge(0.8, 3.0, 40, 30))
        flat = found.is_wall & (found.points[:, 2] == 0.0)
        self.assertGreater(flat.sum(), 500)
        x = found.points[flat, 0]
        np.testing.assert_allclose(found.by_rays[flat], 0.8 + slope * x, rtol=1e-6)
        np.testing.assert_allclose(found.by_spheres[flat], 2.0 * (x + 0.8 / slope) * np.tan(0.5 * np.arctan(slope)), rtol=1e-4)
        self.assertAlmostEqual(found.minimum, 0.8, delta=0.05)
        self.assertLess(found.minimum_point[0], 1.0)

    def test_errors_follow_the_distance_of_the_mesh(self):
        errors = []
        for tolerance in (0.2, 0.05, 0.0125):
            found = mq.thickness(pipe(20, 3, 30), tolerance=tolerance, spacing=10)
            middle = found.is_wall & (found.points[:, 2] > 5) & (found.points[:, 2] < 25)
            for values in (found.by_rays, found.by_spheres):
                errors.append(np.abs(values[middle] - 3.0).max())
                self.assertLessEqual(errors[-1], 2.1 * found.chord_height)
        self.assertLess(errors[-1], 0.2 * errors[0])

    def test_round_bars_and_balls_are_as_thick_as_wide(self):
        bar = mq.thickness(Part.makeCylinder(5, 60), tolerance=0.01)
        middle = (bar.points[:, 2] > 10) & (bar.points[:, 2] < 50)
        self.assertGreater(bar.is_wall[middle].mean(), 0.99)
        np.testing.assert_allclose(bar.values[middle], 10.0, rtol=0.02)
        ball = mq.thickness(Part.makeSphere(5), tolerance=0.01)
        np.testing.assert_allclose(ball.values, 10.0, rtol=0.01)

    def test_edges_of_75_degrees_are_no_walls(self):
        block = Part.makeCylinder(20, 80)
        tool = Part.makeBox(100, 100, 100, V(-50, -50, 0))
        tool.rotate(V(0, 0, 0), V(0, 1, 0), 15)
        tool.translate(V(0, 0, 50))
        found = mq.thickness(block.cut(tool))
        self.assertGreater(found.minimum, 38.0)
        self.assertLess(np.nanmin(found.by_spheres), 5.0)  # near the edges balls are small

    def test_rounded_edges_are_no_walls(self):
        box = Part.makeBox(60, 60, 10)
        found = mq.thickness(box.makeFillet(1.0, box.Edges))
        self.assertAlmostEqual(found.minimum, 10.0, delta=0.1)

    def test_gap_is_the_width_of_a_slot(self):
        block = Part.makeBox(40, 30, 20).cut(Part.makeBox(1.5, 30, 15, V(10, 0, 5)))
        block = block.cut(Part.makeCylinder(3, 20, V(30, 15, 0)))
        found = mq.thickness(block, gap=True)
        self.assertAlmostEqual(found.minimum, 1.5, delta=1e-6)
        across = [shape.CenterOfMass for shape in (block.Faces[int(name[4:]) - 1] for name in found.minimum_faces)]
        self.assertEqual(sorted(round(center.x, 6) for center in across), [10.0, 11.5])
        self.assertTrue(np.isinf(found.values[~found.is_wall]).any())
        self.assertIn("gap", str(found))


class Bounds(unittest.TestCase):
    def test_the_deviation_of_the_mesh_is_part_of_them(self):
        """A wall of exactly the limit between two curved surfaces: its mesh cannot tell."""
        found = mq.thickness(pipe(20, 4, 10), min_thickness=4.0)
        low, high = found.bounds
        self.assertGreater(found.chord_height, 0.0)
        self.assertAlmostEqual(high - low, 4 * found.chord_height)
        self.assertTrue(low <= 4.0 <= high, found.bounds)
        self.assertTrue(any("is not known; give a smaller tolerance" in note for note in found.notes), found.notes)

    def test_the_verdict_knows_it(self):
        """A wall as thick as the limit is neither called thinner nor thick enough."""
        found = mq.thickness(pipe(20, 4, 10), min_thickness=4.0)
        findings = verdict.of_thickness(found)
        self.assertEqual((found.decided, verdict.word(findings)), (False, "not decided"))
        said = re.fullmatch(r"Smallest thickness between ([\d.]+) mm and ([\d.]+) mm \(requested 4 mm\), as the measured mesh deviates by up "
                            r"to [\d.e-]+ mm; a max. deviation of [\d.e-]+ mm may decide it, unless the wall is just as thick.",
                            findings[0].text)
        self.assertTrue(said, findings[0].text)
        self.assertTrue(float(said[1]) < 4.0 < float(said[2]))
        self.assertFalse(verdict.is_missed(verdict.sentence(findings)))
        self.assertTrue(verdict.is_open(verdict.sentence(findings)))

    def test_a_finer_mesh_decides(self):
        """Where the first mesh cannot tell a wall a little thicker or thinner than its limit."""
        for thick, word in ((4.004, "met"), (3.997, "not met")):
            coarse = mq.thickness(pipe(20, thick, 10), min_thickness=4.0, tolerance=0.02)
            self.assertFalse(coarse.decided)
            found = mq.thickness(pipe(20, thick, 10), min_thickness=4.0)
            self.assertEqual((found.decided, verdict.word(verdict.of_thickness(found))), (True, word))

    def test_rounding_decides_nothing(self):
        """Walls between planes are as thick as their limit but for single precision."""
        for thick, at in ((4.0, 0.0), (0.3, 0.0), (0.3, 100.1), (1.1, 33.3)):
            found = mq.thickness(Part.makeBox(10, 10, thick, FreeCAD.Vector(0, 0, at)), min_thickness=thick)
            self.assertEqual((verdict.of_thickness(found), found.notes, found.thin_places()), ([], [], []), (thick, at))

    def test_without_a_limit_nothing_is_decided_by_one(self):
        found = mq.thickness(Part.makeBox(10, 10, 1))
        self.assertTrue(found.decided)
        self.assertEqual((found.least_allowed, found.deciding_deviation), (None, None))

    def test_what_is_thinner(self):
        thin = mq.thickness(pipe(20, 3.9, 10), min_thickness=4.0)
        self.assertLess(thin.bounds[1], 4.0)
        self.assertRegex(verdict.of_thickness(thin)[0].text, r"^Smallest thickness 3\.\d+ mm \(requested 4 mm\)\.$")


class AgainstOpenCascade(unittest.TestCase):
    """The same by OpenCASCADE, on the surfaces themselves."""

    @classmethod
    def setUpClass(cls):
        case = Part.makeBox(60, 40, 25).cut(Part.makeBox(55, 36, 22, V(2.5, 2, 3)))
        case = case.fuse(Part.makeCylinder(5, 22, V(20, 20, 3))).cut(Part.makeCylinder(3.4, 30, V(20, 20, 0)))
        cls.shape = case.fuse(Part.makeCone(7, 4, 18, V(42, 18, 3))).removeSplitter()
        cls.found = mq.thickness(cls.shape)
        cls.chosen = np.random.default_rng(5).choice(np.flatnonzero(cls.found.is_wall), 60, replace=False)

    def foot_and_normal(self, triangle):
        """The point of the CAD face at the middle of the measure, and the outward normal there."""
        face = self.shape.Faces[self.found.mesh.triangle_face[triangle]]
        u, v = face.Surface.parameter(V(*self.found.points[triangle]))
        return face.valueAt(u, v), face.normalAt(u, v)

    def test_rays_are_as_long_as_lines_in_the_solid(self):
        compared = 0
        for triangle in self.chosen:
            foot, normal = self.foot_and_normal(triangle)
            line = Part.makeLine(foot - normal * 1e-3, foot - normal * 200)
            inside = [edge for edge in self.shape.common(line).Edges if edge.distToShape(Part.Vertex(foot))[0] < 0.01]
            if inside and np.isclose(self.found.by_rays[triangle], inside[0].Length, rtol=0.02):
                compared += 1
        self.assertGreaterEqual(compared, 58)

    def test_balls_lie_in_the_solid_and_touch_two_sides(self):
        for triangle in self.chosen:
            foot, normal = self.foot_and_normal(triangle)
            radius = 0.5 * self.found.by_spheres[triangle]
            center = Part.Vertex(foot - normal * radius)
            nearest = min(face.distToShape(center)[0] for face in self.shape.Faces)
            self.assertGreater(nearest, 0.97 * radius)
            across = self.shape.getElement(self.found.faces_at(int(triangle))[-1])
            self.assertLess(across.distToShape(center)[0], 1.03 * radius)


class Sources(unittest.TestCase):
    def test_solids_of_an_assembly_each_by_itself(self):
        lower, upper = Part.makeBox(40, 40, 2), Part.makeBox(40, 40, 5, V(0, 0, 2))
        found = mq.thickness(Part.makeCompound([lower, upper]))
        self.assertAlmostEqual(found.minimum, 2.0, delta=1e-6)
        # A ball of the whole thickness fits there: nearer to the sides it touches these first.
        aside = np.minimum(found.points[:, :2], 40.0 - found.points[:, :2]).min(axis=1)
        on_upper = found.is_wall & (found.points[:, 2] == 7.0) & (aside > 2.5)
        np.testing.assert_allclose(found.values[on_upper], 5.0, rtol=1e-6)

    def test_a_dirty_mesh_is_repaired(self):
        mesh = MeshPart.meshFromShape(Shape=pipe(10, 2, 30), LinearDeflection=0.01, AngularDeflection=0.2)
        mesh.removeFacets([5, 700])
        found = mq.thickness(mesh)
        self.assertTrue(found.mesh.report.closed)
        self.assertIn("2 holes closed", "".join(found.notes))
        self.assertAlmostEqual(found.percentile(10), 2.0, delta=0.04)
        self.assertEqual(found.minimum_faces, ())
        self.assertIsNone(found.chord_height)

    def test_arrays_surface_meshes_and_objects(self):
        made = mq.triangulate(Part.makeBox(20, 20, 3))
        document = FreeCAD.newDocument()
        try:
            box = document.addObject("Part::Box")
            box.Height = 3
            box.Placement.Base = V(1000, 0, 0)
            mesh = document.addObject("Mesh::Feature")
            mesh.Mesh = made.to_mesh()
            document.recompute()
            for source in (made, (made.vertices, made.triangles), box, mesh):
                self.assertAlmostEqual(mq.thickness(source).minimum, 3.0, delta=1e-6)
            self.assertGreater(mq.thickness(box).minimum_point[0], 1000.0)
        finally:
            FreeCAD.closeDocument(document.Name)
        self.assertEqual(set(mq.thickness(made).minimum_faces), {"Face5", "Face6"})

    def test_what_bounds_no_volume_is_refused(self):
        for source in (Part.makePlane(10, 10), Mesh.createPlane(5), (np.zeros((0, 3)), np.zeros((0, 3)))):
            with self.assertRaises(mq.InvalidInput):
                mq.thickness(source)
        for values in ({"measure": "guess"}, {"corner_angle": 90}, {"spacing": -1}, {"tolerance": 0}, {"min_thickness": 0},
                       {"progress": 3}):
            with self.assertRaises(mq.InvalidInput):
                mq.thickness(Part.makeBox(1, 1, 1), **values)
        with self.assertRaises(mq.InvalidInput):
            mq.thickness("Box")
        far = np.array([[0, 0, 0], [1, 0, 0], [0, 1, np.nan]]), np.array([[0, 1, 2]])
        with self.assertRaisesRegex(mq.InvalidInput, "not a finite number"):
            mq.thickness(far)

    def test_it_is_the_same_at_every_size_and_place(self):
        for factor, offset in ((1e-3, 0), (1e3, 0), (1, 1e6)):
            shape = pipe(10 * factor, factor, 40 * factor)
            shape.translate(V(offset, 0, 0))
            self.assertAlmostEqual(mq.thickness(shape).minimum / factor, 1.0, delta=0.01)

    def test_cancelling_takes_less_than_a_fifth_of_a_second(self):
        mesh = mq.triangulate(Part.makeSphere(20), chord_height=0.002)
        asked = []

        def progress(fraction, stage):
            if stage == "measuring the thickness" and fraction > 0.7 and not asked:
                asked.append(time.monotonic())
            return not asked

        with self.assertRaises(mq.Cancelled):
            mq.thickness(mesh, spacing=0.05, progress=progress)
        self.assertLess(time.monotonic() - asked[0], 0.2)

    def test_progress_runs_forward_and_the_shape_stays(self):
        shape, seen = pipe(10, 0.8, 20), []
        before = shape.exportBrepToString()
        mq.thickness(shape, progress=lambda fraction, stage: seen.append(fraction))
        self.assertEqual(seen, sorted(seen))
        self.assertEqual(seen[-1], 1.0)
        self.assertEqual(shape.exportBrepToString(), before)


class Results(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        # Two pockets that leave 1 and 2 mm below.
        block = Part.makeBox(60, 30, 10).cut(Part.makeBox(15, 20, 9, V(5, 5, 1)))
        cls.shape = block.cut(Part.makeBox(15, 20, 8, V(40, 5, 2)))
        cls.found = mq.thickness(cls.shape, min_thickness=2.5)

    def test_thin_places_are_regions(self):
        places = self.found.thin_places()
        # Each floor is seen from above and from below. From below, a ball that touches the rim of the pocket at a
        # distance d outside of it has the diameter (d^2 + t^2) / t: below 2.5 up to d.
        self.assertEqual([round(place.thickness, 4) for place in places], [1.0, 1.0, 2.0, 2.0])
        for place in places:
            d = 0.0 if place.faces[0] in ("Face15", "Face16") else math.sqrt(2.5 * place.thickness - place.thickness ** 2)
            self.assertGreaterEqual(place.area, 15 * 20 - 1e-6)
            self.assertLessEqual(place.area, 15 * 20 + 70 * d + math.pi * d * d + 1e-6)
            self.assertEqual(len(place.faces), 1)
            self.assertTrue((self.found.values[place.triangles] < 2.5).all())
        self.assertEqual(len(self.found.thin_places(1.5)), 2)
        self.assertEqual(self.found.thin_places(0.5), [])
        with self.assertRaises(mq.InvalidInput):
            mq.thickness(Part.makeBox(9, 9, 1)).thin_places()

    def test_percentiles_and_histogram_are_by_area(self):
        found = self.found
        areas, edges = found.histogram(bins=[0.0, 1.5, 2.5, 100.0])
        self.assertAlmostEqual(areas[0], 600, delta=100)
        self.assertAlmostEqual(areas.sum(), found.areas[found.is_wall].sum(), places=6)
        self.assertEqual(len(edges), 4)
        self.assertAlmostEqual(found.areas.sum(), self.shape.Area, delta=1e-3)
        self.assertAlmostEqual(found.percentile(0), found.minimum)
        self.assertLessEqual(found.percentile(10), found.percentile(20))
        with self.assertRaises(mq.InvalidInput):
            found.percentile(101)

    def test_the_arrays_fit_the_mesh(self):
        found, count = self.found, len(self.found.mesh.triangles)
        for array in (found.values, found.by_rays, found.by_spheres, found.is_wall, found.opposite, found.areas):
            self.assertEqual(array.shape, (count,))
        self.assertEqual(found.points.shape, (count, 3))
        corners = found.mesh.vertices[found.mesh.triangles]
        self.assertTrue((found.points >= corners.min(axis=1) - 1e-9).all())
        self.assertTrue((found.points <= corners.max(axis=1) + 1e-9).all())
        self.assertFalse(found.values.flags.writeable)
        self.assertIs(found.by("spheres").mesh, found.mesh)

    def test_the_text_names_what_matters(self):
        text = str(self.found)
        for words in ("by spheres", "minimum      1 mm at (", "of Face", "4 places", "by rays"):
            self.assertIn(words, text)
        self.assertIn("1 mm at least", repr(self.found))
        json.dumps(self.found.to_dict(), allow_nan=False)
        block = mq.thickness(Part.makeBox(9, 9, 9), gap=True)
        self.assertIn("none: no two sides of a gap face each other", str(block))
        self.assertEqual((block.minimum, block.minimum_point, block.minimum_faces), (float("inf"), None, ()))
        json.dumps(block.to_dict(), allow_nan=False)

    def test_a_second_run_gives_the_same_bytes(self):
        again = mq.thickness(self.shape, min_thickness=2.5)
        for name in ("by_rays", "by_spheres", "points", "opposite", "is_wall"):
            self.assertEqual(getattr(again, name).tobytes(), getattr(self.found, name).tobytes(), name)


class CommandLine(unittest.TestCase):
    def run_command(self, *arguments):
        done = subprocess.run([COMMAND, "thickness", *arguments], capture_output=True, text=True, timeout=120,
                              stdin=subprocess.DEVNULL)
        return done.returncode, done.stdout, done.stderr

    def test_report_csv_and_status(self):
        with tempfile.TemporaryDirectory() as folder:
            path, table = os.path.join(folder, "plate.brep"), os.path.join(folder, "walls.csv")
            Part.makeBox(30, 20, 1.5).exportBrep(path)
            status, out, err = self.run_command(path, "--csv", table)
            self.assertEqual(status, 0, err)
            self.assertIn("minimum      1.5 mm at (", out)
            with open(table, encoding="ascii") as stream:
                lines = stream.read().splitlines()
            self.assertTrue(lines[0].startswith("triangle,face,by_spheres,by_rays,x,y,z,opposite_face,is_wall,area"))
            self.assertIn(",1.5,", lines[-1])
            self.assertIn(f"measured {len(lines) - 1} triangles", err)
            status, out, err = self.run_command(path, "--min-thickness", "2", "--strict", "--json")
            self.assertEqual(status, 3, err)
            said = json.loads(out)
            self.assertAlmostEqual(said["minimum"], 1.5, places=5)
            self.assertEqual(said["verdict"], "not met")
            self.assertIn("smallest thickness 1.5 mm (requested 2 mm)", said["findings"][0]["text"].lower())
            self.assertEqual(set(said["findings"][0]["faces"]), {"Face5", "Face6"})
            self.assertEqual(len(said["thin_places"]), 2)

    def test_meshes_and_bad_usage(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "plate.stl")
            mq.triangulate(Part.makeBox(30, 20, 1.5)).write(path)
            status, out, err = self.run_command(path, "--measure", "rays")
            self.assertEqual(status, 0, err)
            self.assertIn("by rays", out)
            for arguments in ((path, "--csv", os.path.join(folder, "no", "a.csv")), (path, "--corner-angle", "95")):
                status, _, err = self.run_command(*arguments)
                self.assertEqual(status, 2, err)


if __name__ == "__main__":
    unittest.main()
