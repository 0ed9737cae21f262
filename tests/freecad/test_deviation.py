# SPDX-License-Identifier: LGPL-2.1-or-later
"""Signed distances of points from CAD and meshes: OpenCASCADE's, known motions, tables, the command line."""

import json
import os
import subprocess
import tempfile
import unittest

import FreeCAD
import helpers
import numpy as np
import Part
from parts.bracket import bracket

import MeshQuality as mq

COMMAND = os.path.join(helpers.ROOT, "bin", "meshquality")
V = FreeCAD.Vector


def spline_block():
    """A block with a wavy B-spline top: no surface with a formula."""
    points = [[V(x, y, 4 + np.sin(0.7 * x) * np.cos(0.5 * y)) for x in np.linspace(-2, 12, 9)] for y in np.linspace(-2, 10, 8)]
    top = Part.BSplineSurface()
    top.interpolate(points)
    column = Part.makeBox(10, 8, 10).generalFuse([top.toShape()])[0]
    return min(column.Solids, key=lambda solid: solid.CenterOfMass.z)


def scan_of(shape, count, noise, seed=1):
    """float64 (N, 3): points of the surface, moved along its normals by a normal deviate."""
    random = np.random.default_rng(seed)
    mesh = mq.triangulate(shape, chord_height_relative=1e-3)
    corners = mesh.vertices[mesh.triangles]
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    chosen = random.choice(len(areas), count, p=areas / areas.sum())
    root, along = np.sqrt(random.random(count)), random.random(count)
    weights = np.stack([1 - root, root * (1 - along), root * along], axis=1)
    on = mq.deviation(np.einsum("ni,nij->nj", weights, corners[chosen]), shape)
    return on.nearest + on.normals * random.normal(0.0, noise, (count, 1))


def moved(points, placement):
    matrix = np.array(placement.toMatrix().A).reshape(4, 4)
    return points @ matrix[:3, :3].T + matrix[:3, 3]


class AgainstOpenCascade(unittest.TestCase):
    def check(self, shape, count):
        """Distances and signs of points around a solid, and near its surface."""
        random = np.random.default_rng(2)
        box = shape.BoundBox
        low, high = np.array([box.XMin, box.YMin, box.ZMin]), np.array([box.XMax, box.YMax, box.ZMax])
        size = (high - low).max()
        vertices = mq.triangulate(shape, chord_height_relative=0.01).vertices
        near = vertices[random.integers(0, len(vertices), count // 2)] + random.normal(0.0, 0.02 * size, (count // 2, 3))
        points = np.concatenate([random.uniform(low - 0.3 * size, high + 0.3 * size, (count - count // 2, 3)), near])
        found = mq.deviation(points, shape)
        faces = Part.makeCompound(shape.Faces)
        expected = np.array([Part.Vertex(*point).distToShape(faces)[0] for point in points.tolist()])
        np.testing.assert_allclose(np.abs(found.values), expected, rtol=0.0, atol=1e-7)
        inside = np.array([shape.isInside(V(*point), 1e-9, True) for point in points.tolist()])
        decided = expected > 1e-7
        np.testing.assert_array_equal((found.values < 0.0)[decided], inside[decided])
        self.assertEqual(found.exact, 1.0)
        # The nearest point is on the face that is named.
        for i in range(0, count, count // 20):
            face = shape.Faces[found.faces[i]]
            self.assertLess(Part.Vertex(*found.nearest[i].tolist()).distToShape(face)[0], 1e-6)

    def test_ten_thousand_points_of_elementary_surfaces(self):
        for name, shape in helpers.simple_parts().items():
            with self.subTest(part=name):
                self.check(shape, 1250)

    def test_splines(self):
        self.check(spline_block(), 300)

    def test_points_beside_a_curved_border_are_off_the_face(self):
        """Beside the arc of a hole, where the reference's chords reach into it."""
        part = Part.makeBox(60, 40, 20).cut(Part.makeCylinder(10, 30, V(30, 20, 8)))
        turn = np.linspace(0, 2 * np.pi, 501)
        for inside in (1e-3, 5e-3, 2e-2):
            points = np.stack([30 + (10 - inside) * np.cos(turn), 20 + (10 - inside) * np.sin(turn), np.full(501, 20.0)], axis=1)
            np.testing.assert_allclose(mq.deviation(points, part).values, inside, atol=1e-9)

    def around_narrow(self, shape, width):
        """Points on and beside the faces of this width, and around all vertices."""
        random = np.random.default_rng(3)
        narrow = [face for face in shape.Faces if 2.0 * face.Area < 1.01 * width * face.Length]
        self.assertTrue(narrow)
        points = []
        for face in narrow:
            (low_u, high_u, low_v, high_v) = face.ParameterRange
            places = [(u, v) for u, v in random.uniform((low_u, low_v), (high_u, high_v), (200, 2)).tolist() if face.isPartOfDomain(u, v)]
            points += [face.valueAt(u, v) + height * face.normalAt(u, v) for u, v in places[:30] for height in (0.0, 0.2 * width, -0.2 * width)]
        points += [vertex.Point + V(*random.normal(0.0, size, 3)) for vertex in shape.Vertexes for size in (width, 1e-3, 0.1) for _ in range(5)]
        return np.array([tuple(point) for point in points])

    def test_a_step_that_is_lower_than_the_mesh_tells(self):
        """By formula: the distance from its rectangles."""
        for low in (2e-4, 2e-5):
            corners = [V(0, 0, 0), V(20, 0, 0), V(20, 0, 10 - low), V(10, 0, 10 - low), V(10, 0, 10), V(0, 0, 10)]
            shape = Part.Face(Part.makePolygon([*corners, corners[0]])).extrude(V(0, 20, 0))
            points = self.around_narrow(shape, low)
            rectangles = np.array([((0, 0, 0), (20, 20, 0)), ((0, 0, 0), (0, 20, 10)), ((20, 0, 0), (20, 20, 10 - low)),
                                   ((0, 0, 10), (10, 20, 10)), ((10, 0, 10 - low), (20, 20, 10 - low)), ((10, 0, 10 - low), (10, 20, 10)),
                                   *(((0, y, 0), (10, y, 10)) for y in (0, 20)), *(((10, y, 0), (20, y, 10 - low)) for y in (0, 20))], dtype=float)
            beyond = np.maximum(np.maximum(rectangles[:, 0] - points[:, None], points[:, None] - rectangles[:, 1]), 0.0)
            expected = np.linalg.norm(beyond, axis=2).min(axis=1)
            inside = ((points > 0) & (points < (20, 20, 10)) & ((points[:, :1] < 10) | (points[:, 2:] < 10 - low))).all(axis=1)
            found = mq.deviation(points, shape)
            np.testing.assert_allclose(found.values, np.where(inside, -expected, expected), rtol=0.0, atol=1e-12)
            step = next(i for i, face in enumerate(shape.Faces) if 2.0 * face.Area < 1.01 * low * face.Length)
            on_step = (np.abs(points[:, 0] - 10.0) < 1e-12) & (points[:, 2] > 10 - low) & (points[:, 2] < 10)
            self.assertGreater(on_step.sum(), 20)
            self.assertEqual(set(found.faces[on_step].tolist()), {step})

    def test_other_faces_that_are_narrower_than_the_mesh_tells(self):
        """A chamfer, and a strip that ends in a point, by OpenCASCADE, which is not that exact beside narrower ones."""
        chamfer = [V(0, 0, 0), V(20, 0, 0), V(20, 0, 10 - 2e-4), V(20 - 2e-4, 0, 10), V(0, 0, 10)]
        wedge = Part.Face(Part.makePolygon([V(0, 0, 10), V(20, 0, 10), V(20, 0.01, 10), V(0, 0, 10)])).extrude(V(0, 0, -3))
        for name, shape, width in (
                ("chamfer", Part.Face(Part.makePolygon([*chamfer, chamfer[0]])).extrude(V(0, 20, 0)), 2.83e-4),
                ("strip", Part.makeBox(20, 20, 10).cut(wedge), 0.01)):
            with self.subTest(part=name):
                points = self.around_narrow(shape, width)
                found, faces = mq.deviation(points, shape), Part.makeCompound(shape.Faces)
                expected = np.array([Part.Vertex(*point).distToShape(faces)[0] for point in points.tolist()])
                np.testing.assert_allclose(np.abs(found.values), expected, rtol=0.0, atol=1e-6)
                inside = np.array([shape.isInside(V(*point), 1e-10, True) for point in points.tolist()])
                decided = expected > 1e-6
                np.testing.assert_array_equal((found.values < 0.0)[decided], inside[decided])

    def test_a_mesh_is_measured_by_its_vertices(self):
        shape = Part.makeSphere(5)
        other = Part.makeSphere(5.5)
        mesh = mq.triangulate(other, chord_height=0.01)
        found = mq.deviation(mesh.to_mesh(), shape)
        np.testing.assert_allclose(found.values, 0.5, atol=1e-6)
        self.assertEqual(len(found.triangles), len(mesh.triangles))

    def test_a_mesh_as_the_reference(self):
        box = Part.makeBox(10, 10, 10)
        mesh = mq.triangulate(box)
        points = [(5, 5, 12), (5, 5, 9), (12, 13, 5)]
        for reference in (mesh, mesh.to_mesh(), (mesh.vertices, mesh.triangles)):
            found = mq.deviation(points, reference)
            np.testing.assert_allclose(found.values, [2, -1, np.hypot(2, 3)], atol=1e-9)


class Alignment(unittest.TestCase):
    def test_known_motions_are_found_to_what_the_scatter_allows(self):
        shape, noise = bracket(), 0.02
        points = scan_of(shape, 40000, noise)
        for axis, angle, shift in ((V(1, 2, 3), 25, V(10, -4, 7)), (V(-1, 0, 1), 160, V(300, 0, 50))):
            away = FreeCAD.Placement(shift, FreeCAD.Rotation(axis, angle))
            found = mq.deviation(moved(points, away), shape, align=True)
            fit = found.alignment
            error = (found.points - points).mean(axis=0)
            self.assertLess(fit.position_error, 6.0 * noise / np.sqrt(len(points)))
            self.assertLess(np.linalg.norm(error), 4.0 * fit.position_error)
            self.assertAlmostEqual(fit.rms, noise, delta=0.05 * noise)
            both = found.placement.multiply(away)
            turn = np.degrees(both.Rotation.Angle)  # 0 to 360 degrees: a small turn the other way is just below 360
            self.assertLess(min(turn, 360.0 - turn), 4.0 * fit.angle_error)
            # A map without noise of what is left: the scatter alone.
            self.assertAlmostEqual(found.rms, noise, delta=0.05 * noise)

    def test_without_noise_it_is_exact(self):
        shape = bracket()
        points = scan_of(shape, 5000, 0.0)
        away = FreeCAD.Placement(V(1, 2, 0.5), FreeCAD.Rotation(V(0, 1, 1), 3))
        found = mq.deviation(moved(points, away), shape, align="near")
        self.assertLess(np.abs(found.points - points).max(), 1e-9)
        self.assertLess(found.max_deviation, 1e-9)

    def test_outliers_are_measured_and_do_not_pull(self):
        shape = bracket()
        points = scan_of(shape, 20000, 0.01)
        points[::20] += (0.0, 0.0, 15.0)
        away = FreeCAD.Placement(V(5, 2, 1), FreeCAD.Rotation(V(0, 0, 1), 10))
        found = mq.deviation(moved(points, away), shape, align=True)
        self.assertLess(np.linalg.norm((found.points - points).mean(axis=0)), 0.002)
        self.assertLess(found.alignment.used, 0.96 * len(points))
        self.assertGreater(found.max_deviation, 1.0)

    def test_pairs_and_three_two_one(self):
        shape = Part.makeBox(30, 20, 10)
        on = np.array([(3, 3, 0), (27, 3, 0), (15, 17, 0), (5, 0, 5), (25, 0, 5), (0, 10, 5)], dtype=float)
        away = FreeCAD.Placement(V(7, 8, 9), FreeCAD.Rotation(V(1, 1, 0), 70))
        picked = moved(on, away)
        beside = on + np.array([(0.4, -0.3, 0.2), (-0.2, 0.4, 0.1), (0.1, 0.2, -0.3), (0.3, 0.1, 0.2), (0, -0.2, 0.4), (0.2, 0.1, 0.3)])
        found = mq.deviation(picked, shape, align="3-2-1", pairs=list(zip(picked, beside)))
        self.assertLess(np.abs(found.points - on).max(), 1e-6)
        self.assertLess(found.max_deviation, 1e-9)
        points = scan_of(shape, 2000, 0.0)
        found = mq.deviation(moved(points, away), shape, align="pairs", pairs=list(zip(picked, beside)))
        self.assertLess(np.abs(found.points - points).max(), 1e-6)

    def test_a_free_turn_is_left_and_said(self):
        shape = Part.makeCylinder(5, 20)
        found = mq.deviation(scan_of(shape, 5000, 0.001) + (0.2, 0.0, 0.1), shape, align="near")
        self.assertEqual(found.alignment.undetermined, 1)
        self.assertTrue(any("no distance" in note for note in found.notes), found.notes)

    def test_what_does_not_fit_is_refused_by_name(self):
        torus = scan_of(Part.makeTorus(10, 3), 3000, 0.0)
        with self.assertRaisesRegex(mq.InvalidInput, "the array cannot be aligned with the shape: after .* steps .* mm off.*unit"):
            mq.deviation(torus, Part.makeBox(20, 20, 6), align=True)


class Given(unittest.TestCase):
    def test_wrong_values_are_refused(self):
        box = Part.makeBox(1, 1, 1)
        for arguments, words in (
                (([(0, 0)], box), "array .N, 3. of points"),
                ((np.zeros((0, 3)), box), "the array has no points"),
                (([(0, 0, float("nan"))], box), "no numbers"),
                ((box, box), "not Solid: take a shape as the reference")):
            with self.assertRaisesRegex(mq.InvalidInput, words):
                mq.deviation(*arguments)
        for more, words in (({"align": "any", "pairs": [((0, 0, 0), (0, 0, 0))]}, "pairs have no effect"),
                            ({"align": "3-2-1"}, "needs 6 pairs"), ({"align": "other"}, "align"),
                            ({"tolerance": -1.0}, "tolerance"), ({"scale": 0.0}, "scale = 0.0 is not allowed")):
            with self.assertRaisesRegex(mq.InvalidInput, words):
                mq.deviation([(0, 0, 0)], box, **more)
        with self.assertRaises(mq.Cancelled):
            mq.deviation([(0, 0, 0)], box, progress=lambda *_: False)

    def test_objects_stand_where_the_document_has_them(self):
        import Mesh  # noqa: F401
        import Points

        doc = FreeCAD.newDocument()
        self.addCleanup(lambda: FreeCAD.closeDocument(doc.Name))
        part = doc.addObject("Part::Box", "Box")
        part.Placement = FreeCAD.Placement(V(100, 0, 0), FreeCAD.Rotation())
        mesh = doc.addObject("Mesh::Feature", "Scan")
        mesh.Mesh = mq.triangulate(Part.makeBox(10, 10, 10)).to_mesh()
        mesh.Placement = FreeCAD.Placement(V(100, 0, 0.25), FreeCAD.Rotation())
        cloud = doc.addObject("Points::Feature", "Cloud")
        cloud.Points = Points.Points([V(5, 5, 11), V(5, 5, 8)])
        cloud.Placement = FreeCAD.Placement(V(100, 0, 0), FreeCAD.Rotation())
        doc.recompute()
        found = mq.deviation(mesh, part)
        self.assertAlmostEqual(found.highest, 0.25, places=6)
        np.testing.assert_allclose(mq.deviation(cloud, part).values, [1.0, -2.0], atol=1e-6)
        np.testing.assert_allclose(mq.deviation(cloud.Points, part).values, [1.0, -2.0], atol=1e-6)

    def test_inches(self):
        found = mq.deviation([(0.5, 0.5, 1.0)], Part.makeBox(25.4, 25.4, 12.7), scale=25.4)
        self.assertAlmostEqual(found.values[0], 12.7)


class Tables(unittest.TestCase):
    def setUp(self):
        self.shape = Part.makeBox(30, 20, 10)
        grid = np.array([(x, y) for x in range(1, 30) for y in range(1, 20)], dtype=float)
        self.points = np.concatenate([np.column_stack([grid, np.full(len(grid), 10.1)]), np.column_stack([grid, np.full(len(grid), -0.02)])])
        self.points[3, 2] += 0.5
        self.found = mq.deviation(self.points, self.shape, tolerance=0.15)

    def test_bands_faces_and_places(self):
        found, count = self.found, len(self.points)
        self.assertAlmostEqual(found.within(), 1.0 - 1.0 / count)
        self.assertAlmostEqual(found.within(0.05), 0.5)
        top = next(face for face in found.by_face if face.high > 0.3)
        self.assertEqual((top.points, len(found.by_face)), (count // 2, 2))
        self.assertAlmostEqual(top.low, 0.1, places=9)
        (place,) = found.worst_places()
        self.assertEqual((place.index, place.face), (3, top.face))
        self.assertAlmostEqual(place.value, 0.6, places=9)
        counts, edges = found.histogram(10)
        self.assertEqual((counts.sum(), len(edges)), (count, 11))
        text = str(found)
        for words in ("1,102 points", "0.02 to 0.6 mm", "0.15 mm: 99.91 %", top.face):
            self.assertIn(words, text)
        json.dumps(found.to_dict())

    def test_csv_has_a_line_a_point(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "deviation.csv")
            self.found.write_csv(path)
            with open(path, encoding="ascii") as stream:
                lines = stream.read().splitlines()
        self.assertEqual(lines[0], "point,x,y,z,deviation,face")
        self.assertEqual(len(lines), 1 + len(self.points))
        number, x, y, z, value, face = lines[4].split(",")
        self.assertEqual((number, float(x), float(y), float(z)), ("3", *self.points[3]))
        self.assertAlmostEqual(float(value), 0.6, places=8)


class CommandLine(unittest.TestCase):
    def run_command(self, *arguments):
        return subprocess.run([COMMAND, "deviation", *arguments], capture_output=True, text=True, check=False, stdin=subprocess.DEVNULL)

    def test_a_text_of_points_in_inches(self):
        with tempfile.TemporaryDirectory() as folder:
            part, scan, table = (os.path.join(folder, name) for name in ("part.brep", "scan.xyz", "out.csv"))
            Part.makeBox(25.4, 25.4, 25.4).exportBrep(part)
            with open(scan, "w", encoding="ascii") as stream:
                stream.write("x y z\n0.5 0.5 1.01 7\n0.5, 0.5, 0.9, 7\n")
            done = self.run_command(scan, "--reference", part, "--mesh-scale", "25.4", "--tolerance", "1", "--json", "--csv", table)
            self.assertEqual(done.returncode, 0, done.stderr)
            report = json.loads(done.stdout)
            self.assertEqual((report["points"], report["verdict"]), (2, "not met"))
            self.assertAlmostEqual(report["lowest"], -2.54, places=6)
            self.assertAlmostEqual(report["highest"], 0.254, places=6)
            with open(table, encoding="ascii") as stream:
                self.assertEqual(len(stream.read().splitlines()), 3)
            strict = self.run_command(scan, "--reference", part, "--mesh-scale", "25.4", "--tolerance", "1", "--strict")
            self.assertEqual(strict.returncode, 3, strict.stderr)
            self.assertIn("50 % of the points", strict.stderr)

    def test_wrong_input_has_status_two(self):
        with tempfile.TemporaryDirectory() as folder:
            part, empty = os.path.join(folder, "part.brep"), os.path.join(folder, "empty.xyz")
            Part.makeBox(1, 1, 1).exportBrep(part)
            with open(empty, "w", encoding="ascii") as stream:
                stream.write("no numbers\n")
            done = self.run_command(empty, "--reference", part)
            self.assertEqual(done.returncode, 2)
            self.assertIn("it holds no points", done.stderr)
            self.assertEqual(self.run_command(empty, "--reference", os.path.join(folder, "none.step")).returncode, 2)
