# SPDX-License-Identifier: LGPL-2.1-or-later
"""Size fields: what they are made of, that meshes keep them, and what is said where they are wrong."""

import json
import os
import tempfile
import unittest

import FreeCAD
import numpy as np
import Part

import MeshQuality as mq
from MeshQuality.core.sizes import mesh_values

RATIO = 1.3


def ratios(mesh, field):
    """Lengths of the edges of a SurfaceMesh, divided by the field at their middles."""
    points, triangles = mesh.vertices + mesh.origin, mesh.triangles
    ends = points[np.concatenate([triangles[:, [i, (i + 1) % 3]] for i in range(3)])]
    return np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) / field(ends.mean(axis=1))


def graded(points):
    return 0.4 + 0.15 * np.linalg.norm(points - [40, 30, 10], axis=1)


def step(points):
    return np.where(np.linalg.norm(points - [10, 8, 10], axis=1) < 3, 0.3, 4.0)


class Fields(unittest.TestCase):
    """Forms of size_field=, and what triangulate and curve make of them."""

    @classmethod
    def setUpClass(cls):
        block = Part.makeBox(40, 30, 10)
        cls.shape = block.cut(Part.makeCylinder(6, 10, FreeCAD.Vector(20, 15, 0)))

    def assert_kept(self, mesh, field):
        measured = ratios(mesh, field)
        self.assertLessEqual(measured.max(), RATIO)
        self.assertAlmostEqual(mesh.report.size_ratio, measured.max(), places=9)
        self.assertGreaterEqual(mesh.report.min_angle, 25.0)
        self.assertTrue(mesh.report.closed)
        return measured

    def test_function_is_kept_and_measured(self):
        for field in (graded, step, lambda p: np.full(len(p), 1.5), lambda p: 1 + 0.7 * np.sin(p[:, 0]) * np.cos(p[:, 1])):
            mesh = mq.triangulate(self.shape, size_field=field)
            measured = self.assert_kept(mesh, field)
            place = mesh.report.size_ratio_point
            middles = (mesh.vertices[mesh.triangles] + mesh.vertices[np.roll(mesh.triangles, -1, axis=1)]) / 2
            self.assertLess(np.linalg.norm(middles.reshape(-1, 3) - place, axis=1).min(), 1e-9)
            # Beside a jump triangles that touch the fine side are small, too.
            self.assertLess(mesh.report.short_share, 0.35 if field is step else 0.25)
            self.assertGreater(np.median(measured), 0.55)
            self.assertIn("of the size field", str(mesh.report))

    def test_without_field_the_report_says_so(self):
        report = mq.triangulate(self.shape).report
        self.assertEqual((report.size_ratio, report.short_share), (-1.0, 0.0))
        self.assertNotIn("size field", str(report))

    def test_placed_and_far_parts(self):
        for at in ((300, -200, 100), (1e5, 0, 0)):
            shape = self.shape.copy()
            shape.Placement = FreeCAD.Placement(FreeCAD.Vector(*at), FreeCAD.Rotation(FreeCAD.Vector(1, 2, 3), 40))
            corner = np.array(shape.Vertexes[0].Point)
            field = lambda p, corner=corner: 0.5 + 0.2 * np.linalg.norm(p - corner, axis=1)  # noqa: E731
            self.assert_kept(mq.triangulate(shape, size_field=field), field)

    def test_the_least_of_all_bounds_holds(self):
        mesh = mq.triangulate(self.shape, size_field=lambda p: np.full(len(p), 3.0), max_edge=2.0, local_sizes={"Face1": 1.0})
        corners = (mesh.vertices + mesh.origin)[mesh.triangles]
        lengths = np.linalg.norm(corners - np.roll(corners, -1, axis=1), axis=2)
        self.assertLessEqual(lengths.max(), 2.0 + 1e-5)
        self.assertLessEqual(lengths[mesh.triangle_face == 0].max(), 1.0 + 1e-5)
        both = mq.triangulate(self.shape, size_field=[graded, step])
        self.assert_kept(both, lambda p: np.minimum(graded(p), step(p)))

    def test_growth_rate_makes_a_jump_gradual(self):
        sudden = mq.triangulate(self.shape, size_field=step)
        slow = mq.triangulate(self.shape, size_field=step, growth_rate=1.2)
        self.assertGreater(len(slow.triangles), 1.1 * len(sudden.triangles))
        self.assert_kept(slow, step)

    def test_functions_are_called_on_this_thread_in_the_box_in_batches(self):
        import threading
        here, sizes = threading.get_ident(), []

        def field(points):
            self.assertEqual(threading.get_ident(), here)
            self.assertEqual(points.shape[1:], (3,))
            self.assertTrue((points >= -1e-9).all() and (points <= np.array([40, 30, 10]) + 1e-9).all())
            sizes.append(len(points))
            return np.full(len(points), 2.0)

        mq.triangulate(self.shape, size_field=field)
        self.assertGreater(max(sizes), 10_000)

    def test_functions_may_raise_and_cancel(self):
        class Mine(Exception):
            pass

        def fails(_points):
            raise Mine

        with self.assertRaises(Mine):
            mq.triangulate(self.shape, size_field=fails)
        with self.assertRaises(mq.Cancelled):
            mq.triangulate(self.shape, size_field=graded, progress=lambda _f, stage: "size field" not in str(stage))

    def test_points_with_sizes(self):
        points = np.random.RandomState(1).rand(400, 3) * [40, 30, 10]
        sizes = 1 + 0.1 * points[:, 0]
        rows = np.column_stack((points, sizes))
        meshes = [mq.triangulate(self.shape, size_field=form) for form in (rows, (points, sizes), rows.tolist())]
        for mesh in meshes:
            self.assertLessEqual(mesh.report.size_ratio, RATIO)
            self.assertEqual(mesh.triangles.tolist(), meshes[0].triangles.tolist())
        self.assertLess(ratios(meshes[0], lambda p: 1 + 0.1 * p[:, 0]).max(), 1.6)  # interpolated, not exact
        one = mq.triangulate(self.shape, size_field=np.array([[0, 0, 0, 2.0]]))
        self.assert_kept(one, lambda p: np.full(len(p), 2.0))

    def test_files_of_points(self):
        rows = np.column_stack((np.random.RandomState(1).rand(50, 3) * [40, 30, 10], np.linspace(1, 3, 50)))
        wanted = mq.triangulate(self.shape, size_field=rows).triangles.tolist()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "sizes.csv")
            for mark, order in ((",", (0, 1, 2, 3)), (";", (3, 1, 0, 2)), ("\t", (0, 1, 2, 3))):
                names = np.array(["x", "y", "z", "size"])[list(order)]
                with open(path, "w") as file:
                    file.write("# from elsewhere\n" + mark.join(names) + "\n")
                    file.writelines(mark.join(map(repr, row[list(order)].tolist())) + "\n" for row in rows)
                self.assertEqual(mq.triangulate(self.shape, size_field=path).triangles.tolist(), wanted)

    def test_bad_files_of_points(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "sizes.csv")
            for text, said in (("x,y,z\n1,2,3\n", "lacks the column size: its first line names x, y, z"),
                               ("a b\n1 2\n", "lacks the columns x, y, z, size"), ("", "is empty"),
                               ("x,y,z,size\n", "no rows"), ("x,y,z,size\n1,2,3,4\n1,2,three,4\n", "row 3 is '1,2,three,4'"),
                               ("x,y,z,size\n1,2,3,0\n", "a size of 0 mm at \\(1, 2, 3\\)"),
                               ("x,y,z,size\n1,2,3,nan\n", "has a hole"), ("x,y,z,size\n1,inf,3,1\n", "row 1 has the place")):
                with open(path, "w") as file:
                    file.write(text)
                with self.assertRaisesRegex(mq.InvalidInput, said):
                    mq.triangulate(self.shape, size_field=path)
            with self.assertRaisesRegex(mq.IoError, "there is no such file"):
                mq.triangulate(self.shape, size_field=os.path.join(folder, "none.csv"))

    def test_meshes_with_sizes(self):
        solid = mq.curve(self.shape, order=1, volume=True)
        linear = 1.0 + 0.05 * solid.nodes[:, 0]
        field = lambda p: 1.0 + 0.05 * p[:, 0]  # noqa: E731
        self.assertLessEqual(ratios(mq.triangulate(self.shape, size_field=(solid, linear)), field).max(), RATIO)
        by_cell = mq.triangulate(self.shape, size_field=(solid, np.full(len(solid.tetrahedra), 2.0)))
        self.assertLessEqual(ratios(by_cell, lambda p: np.full(len(p), 2.0)).max(), RATIO)
        with self.assertRaisesRegex(mq.InvalidInput, "3 sizes for .* nodes and .* elements"):
            mq.triangulate(self.shape, size_field=(solid, np.ones(3)))
        surface = mq.triangulate(self.shape, max_edge=5)
        sizes = 1.0 + 0.05 * (surface.vertices + surface.origin)[:, 0]
        self.assertLessEqual(ratios(mq.triangulate(self.shape, size_field=(surface, sizes)), field).max(), RATIO)

    def test_files_of_meshes(self):
        field = lambda p: 1.0 + 0.05 * p[:, 0]  # noqa: E731
        solid = mq.curve(Part.makeBox(40, 30, 10), order=1, volume=True)
        corners = solid.nodes[solid.tetrahedra]
        with tempfile.TemporaryDirectory() as folder:
            pos = os.path.join(folder, "sizes.pos")
            with open(pos, "w") as file:
                file.write('View "sizes" {\n')
                for points in corners:
                    places = ",".join(f"{c:.17g}" for c in points.ravel())
                    file.write(f"SS({places}){{{','.join(f'{s:.17g}' for s in field(points))}}};\n")
                file.write("};\n")
            self.assertLessEqual(ratios(mq.triangulate(self.shape, size_field=pos), field).max(), RATIO)
            frd = os.path.join(folder, "sizes.frd")
            with open(frd, "w") as file:
                file.write(f"    2C{len(solid.nodes):30d}{1:38d}\n")
                file.writelines(f" -1{i + 1:10d}{x:12.5E}{y:12.5E}{z:12.5E}\n" for i, (x, y, z) in enumerate(solid.nodes))
                file.write(f" -3\n    3C{len(solid.tetrahedra):30d}{1:38d}\n")
                for i, nodes in enumerate(solid.tetrahedra):
                    file.write(f" -1{i + 1:10d}{3:5d}{0:5d}{1:5d}\n -2" + "".join(f"{n + 1:10d}" for n in nodes) + "\n")
                file.write(" -3\n -4  SIZE        1    1\n -5  SIZE        1    1    0    0\n")
                file.writelines(f" -1{i + 1:10d}{s:12.5E}\n" for i, s in enumerate(field(solid.nodes)))
                file.write(" -3\n 9999\n")
            self.assertLessEqual(ratios(mq.triangulate(self.shape, size_field=frd), field).max(), RATIO)
            with self.assertRaisesRegex(mq.InvalidInput, "has no array T: it has SIZE"):
                mq.triangulate(self.shape, size_field=frd + "#T")
            with open(pos, "w") as file:
                file.write("no view\n")
            with self.assertRaisesRegex(mq.IoError, "no scalar points"):
                mq.triangulate(self.shape, size_field=pos)

    def test_files_that_meshio_reads(self):
        try:
            import meshio
        except ImportError:
            self.skipTest("no meshio")
        field = lambda p: 1.0 + 0.05 * p[:, 0]  # noqa: E731
        solid = mq.curve(Part.makeBox(40, 30, 10), order=1, volume=True)
        with tempfile.TemporaryDirectory() as folder:
            for suffix in ("vtu", "vtk"):
                path = os.path.join(folder, f"sizes.{suffix}")
                meshio.write(path, meshio.Mesh(solid.nodes, [("tetra", solid.tetrahedra)],
                                               point_data={"size": field(solid.nodes), "other": solid.nodes[:, 0]}))
                self.assertLessEqual(ratios(mq.triangulate(self.shape, size_field=path), field).max(), RATIO)
                with self.assertRaisesRegex(mq.InvalidInput, "a size of 0 mm"):
                    mq.triangulate(self.shape, size_field=path + "#other")

    def test_prisms_pyramids_and_hexahedra_are_divided_without_gaps(self):
        for kind, parts in mesh_values._SIMPLICES.items():
            from MeshQuality.core.elements import kinds
            if kinds.DIMENSION[kind] < 3:
                continue
            corners = np.array(kinds._CORNERS[kind], dtype=float)
            volumes = [abs(np.linalg.det(corners[list(part)][1:] - corners[part[0]])) / 6 for part in parts]
            whole = {"tetrahedron": 1 / 6, "pyramid": 4 / 3, "prism": 1.0, "hexahedron": 8.0}[kind]
            size = np.ptp(corners, axis=0).prod()
            wanted = {"tetrahedron": size / 6, "pyramid": size / 3, "prism": size / 2, "hexahedron": size}[kind]
            self.assertGreater(whole, 0)
            self.assertAlmostEqual(sum(volumes), wanted, msg=kind)

    def test_bad_fields_are_named(self):
        for field, said in (
                (lambda p: np.where(p[:, 0] > 39, np.nan, 1.0), "has a hole: no size at \\("),
                (lambda p: np.full(len(p), -1.0), "has a size of -1 mm at"), (lambda p: np.zeros(len(p)), "a size of 0 mm"),
                (lambda p: p, "returned an array of shape \\(\\d+, 3\\) for \\d+ points"), (lambda p: "x", "no array of numbers"),
                (np.zeros((3, 3)), "shape \\(3, 3\\)"), (np.zeros((0, 4)), "n at least 1"),
                ((np.zeros((2, 3)), [1.0]), "2 points, but sizes of shape \\(1,\\)"), ((np.zeros(3), [1.0]), "points have the shape"),
                (5, "size_field = int is not allowed"), (lambda p: np.full(len(p), 1e-9), "asks for about .* triangles")):
            with self.assertRaisesRegex(mq.InvalidInput, said):
                mq.triangulate(self.shape, size_field=field)

    def test_infinite_sizes_are_no_bound(self):
        free = mq.triangulate(self.shape, size_field=lambda p: np.full(len(p), np.inf))
        self.assertEqual(len(free.triangles), len(mq.triangulate(self.shape).triangles))
        self.assertEqual(free.report.size_ratio, 0.0)

    def test_small_features_that_the_samples_miss_are_found_on_the_mesh(self):
        spot = lambda p: np.where(np.abs(p[:, 0] - 7.31) < 0.02, 0.4, 3.0)  # noqa: E731 - thinner than any cell
        report = mq.triangulate(self.shape, size_field=spot).report
        self.assertTrue(report.size_ratio <= RATIO or any("size field" in str(note) for note in report.notes))

    def test_a_reason_is_given_where_sizes_cannot_be_kept(self):
        mesh = mq.triangulate(self.shape, size_field=lambda p: np.full(len(p), 1.0), min_edge=3.0)
        self.assertGreater(mesh.report.size_ratio, RATIO)
        self.assertTrue(any("min_edge" in str(note) for note in mesh.report.notes))

    def test_tetrahedra_keep_it_inside_too(self):
        inner = lambda p: np.where(np.linalg.norm(p - [32, 15, 5], axis=1) < 3, 0.7, 4.0)  # noqa: E731
        for field in (graded, inner):
            mesh = mq.curve(self.shape, order=2, volume=True, size_field=field)
            pairs = np.concatenate([mesh.tetrahedra[:, [i, j]] for i in range(4) for j in range(i)])
            ends = mesh.nodes[pairs]
            measured = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) / field(ends.mean(axis=1))
            self.assertLessEqual(measured.max(), RATIO)
            self.assertAlmostEqual(mesh.report.size_ratio, measured.max(), places=9)
            self.assertEqual(mesh.report.invalid, 0)
            self.assertLess(mesh.report.max_shape_distortion, 4.0)
        with self.assertRaisesRegex(mq.InvalidInput, "not for one that is given"):
            mq.curve(mq.triangulate(self.shape), shape=self.shape, size_field=graded)

    def test_a_field_before_meshing(self):
        field = mq.size_field(self.shape, graded)
        np.testing.assert_allclose(field.sizes, graded(field.points), rtol=0.1)
        self.assertLess(abs(np.log(field.expected_triangles / len(mq.triangulate(self.shape, size_field=graded).triangles))), 0.5)
        again = mq.triangulate(self.shape, size_field=field)
        self.assertLessEqual(ratios(again, graded).max(), RATIO * 1.1)
        self.assertIn("triangles>", repr(field))
        with self.assertRaisesRegex(mq.InvalidInput, "size_field = None"):
            mq.size_field(self.shape, None)

    def test_the_cache_keeps_faces_whose_sizes_are_the_same(self):
        cache = mq.MeshCache()
        first = mq.triangulate(self.shape, size_field=graded, cache=cache)
        self.assertEqual(mq.triangulate(self.shape, size_field=graded, cache=cache).triangles.tolist(), first.triangles.tolist())
        other = mq.triangulate(self.shape, size_field=lambda p: np.where(p[:, 0] < 3, 0.5, graded(p)), cache=cache)
        self.assert_kept(other, lambda p: np.where(p[:, 0] < 3, 0.5, graded(p)))

    def test_equal_bodies_have_sizes_of_their_own(self):
        two = Part.makeCompound([Part.makeBox(10, 10, 10), Part.makeBox(10, 10, 10, FreeCAD.Vector(30, 0, 0))])
        field = lambda p: np.where(p[:, 0] < 20, 1.0, 4.0)  # noqa: E731
        mesh = mq.triangulate(two, size_field=field)
        self.assertLessEqual(ratios(mesh, field).max(), RATIO)
        left = (mesh.vertices[mesh.triangles].mean(axis=1)[:, 0] < 20).mean()
        self.assertGreater(left, 0.85)


class Regions(unittest.TestCase):
    """Size regions and stored fields of documents."""

    def setUp(self):
        self.document = FreeCAD.newDocument("SizeRegions")
        self.document.UndoMode = 1
        self.addCleanup(lambda: FreeCAD.closeDocument(self.document.Name))
        self.box = self.document.addObject("Part::Box", "Box")
        self.box.Length, self.box.Width, self.box.Height = 40, 30, 10
        self.ball = self.document.addObject("Part::Sphere", "Ball")
        self.ball.Radius = 6
        self.ball.Placement.Base = FreeCAD.Vector(40, 30, 10)
        self.document.recompute()
        self.document.clearUndos()

    def lengths(self, obj):
        points, triangles = obj.Mesh.Topology
        points = np.array([tuple(p) for p in points])
        ends = points[np.concatenate([np.array(triangles)[:, [i, (i + 1) % 3]] for i in range(3)])]
        return ends.mean(axis=1), np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)

    def longest_near(self, obj, place, radius):
        middles, lengths = self.lengths(obj)
        return lengths[np.linalg.norm(middles - place, axis=1) < radius].max(initial=0.0)

    def test_inside_follows_its_solid(self):
        region = mq.add_size_region(self.ball, 0.6)
        mesh = mq.add_quality_mesh(self.box, size_field=region)
        self.assertEqual((mesh.SizeField, mesh.Certificate), ([region], "met"))
        self.assertLess(self.longest_near(mesh, (40, 30, 10), 5.5), 0.6 * RATIO)
        self.assertGreater(self.longest_near(mesh, (0, 0, 0), 5.5), 2.0)
        self.ball.Placement.Base = FreeCAD.Vector(0, 0, 0)
        self.document.recompute()
        self.assertLess(self.longest_near(mesh, (0, 0, 0), 5.5), 0.6 * RATIO)
        self.assertGreater(self.longest_near(mesh, (40, 30, 10), 5.5), 2.0)
        region.Size = 1.2
        self.document.recompute()
        self.assertGreater(self.longest_near(mesh, (0, 0, 0), 5.5), 0.7)

    def test_near_edges_grows_to_the_far_size(self):
        region = mq.add_size_region((self.box, ["Edge1"]), 0.4, kind="near", distance=5, far_size=3)
        mesh = mq.add_quality_mesh(self.box, size_field=[region])
        edge = self.box.Shape.Edge1
        middles, lengths = self.lengths(mesh)
        for middle, length in zip(middles[::7], lengths[::7]):
            away = edge.distToShape(Part.Vertex(*middle))[0]
            if away < 5:
                self.assertLessEqual(length, RATIO * (0.4 + 2.6 * away / 5) * 1.02)

    def test_near_points_and_faces(self):
        mesh = mq.add_quality_mesh(self.box, size_field=[
            mq.add_size_region((self.box, "Vertex8"), 0.5, kind="near", distance=3),
            mq.add_size_region((self.box, "Face1"), 1.0, kind="near", distance=0.5)])
        self.assertLess(self.longest_near(mesh, tuple(self.box.Shape.Vertex8.Point), 2.5), 0.5 * RATIO)
        middles, lengths = self.lengths(mesh)
        self.assertLess(lengths[np.abs(middles[:, 0]) < 0.4].max(), RATIO)

    def test_wake(self):
        self.ball.Placement.Base = FreeCAD.Vector(0, 15, 10)
        region = mq.add_size_region(self.ball, 0.8, kind="wake", direction=(1, 0, 0), length=20)
        mesh = mq.add_quality_mesh(self.box, size_field=region)
        for x in (2, 10, 20):
            self.assertLess(self.longest_near(mesh, (x, 15, 10), 4), 0.8 * RATIO)
        self.assertGreater(self.longest_near(mesh, (36, 15, 10), 4), 1.5)

    def test_regions_in_the_place_of_their_container(self):
        part = self.document.addObject("App::Part", "Part")
        part.addObject(self.ball)
        part.Placement.Base = FreeCAD.Vector(-40, -30, -10)
        self.document.recompute()
        mesh = mq.add_quality_mesh(self.box, size_field=mq.add_size_region(self.ball, 0.6))
        self.assertLess(self.longest_near(mesh, (0, 0, 0), 5.5), 0.6 * RATIO)

    def test_other_forms_are_stored_in_the_document(self):
        points = np.random.RandomState(1).rand(200, 3) * [40, 30, 10]
        for form in (lambda p: 1 + 0.1 * p[:, 0], np.column_stack((points, 1 + 0.1 * points[:, 0])), (points, 1 + 0.1 * points[:, 0])):
            mesh = mq.add_quality_mesh(self.box, size_field=form)
            field, = mesh.SizeField
            self.assertLess(self.longest_near(mesh, (0, 15, 5), 6), 2.2)
            self.assertGreater(self.longest_near(mesh, (40, 15, 5), 6), 2.2)
            with tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "fields.FCStd")
                self.document.saveCopy(path)
                copy = FreeCAD.openDocument(path, True)
                try:
                    again = copy.getObject(mesh.Name)
                    again.touch()
                    copy.recompute()
                    self.assertEqual(again.Status, "up to date")
                    again.MinAngle = 24
                    copy.recompute()
                    self.assertLess(self.longest_near(again, (0, 15, 5), 6), 2.2)
                finally:
                    FreeCAD.closeDocument(copy.Name)
            self.assertTrue(field.From)

    def test_one_undo_step(self):
        before = len(self.document.Objects)
        mq.add_quality_mesh(self.box, size_field=lambda p: 2.0)
        self.assertEqual(len(self.document.Objects), before + 2)
        self.document.undo()
        self.assertEqual(len(self.document.Objects), before)

    def test_nothing_is_added_where_the_field_is_wrong(self):
        before = len(self.document.Objects)
        for form in (lambda p: np.full(len(p), np.nan), np.zeros((2, 4)), 7):
            with self.assertRaises(mq.InvalidInput):
                mq.add_quality_mesh(self.box, size_field=form)
            self.assertEqual(len(self.document.Objects), before)

    def test_update_takes_other_fields(self):
        mesh = mq.add_quality_mesh(self.box)
        plain = mesh.Mesh.CountFacets
        mq.update(mesh, size_field=mq.add_size_region(self.ball, 0.6))
        self.assertGreater(mesh.Mesh.CountFacets, 3 * plain)
        mq.update(mesh, size_field=None)
        self.assertEqual(mesh.Mesh.CountFacets, plain)

    def test_curved_and_fem_meshes(self):
        region = mq.add_size_region(self.ball, 1.0)
        for add in (mq.add_curved_mesh, mq.add_fem_mesh):
            few, many = add(self.box), add(self.box, size_field=region)
            self.assertGreater(many.Elements, few.Elements)
            self.assertEqual(many.Certificate, "met")
        self.ball.Placement.Base = FreeCAD.Vector(200, 0, 0)
        self.document.recompute()
        self.assertEqual(many.Elements, few.Elements)

    def test_wrong_regions_are_named(self):
        before = len(self.document.Objects)
        for call, said in (
                (lambda: mq.add_size_region(self.ball, 0), "size = 0 is not allowed"),
                (lambda: mq.add_size_region(self.ball, 1, kind="around"), "kind = 'around' is not allowed"),
                (lambda: mq.add_size_region(self.ball, 1, kind="near"), "distance = None is not allowed"),
                (lambda: mq.add_size_region((self.ball, "Face7"), 1, kind="near", distance=1), "Ball has no Face7"),
                (lambda: mq.add_size_region((self.box, "Face1"), 1), "has no solid"),
                (lambda: mq.add_size_region(self.ball, 1, kind="wake", length=3), "needs direction="),
                (lambda: mq.add_size_region(self.ball, 1, kind="wake", length=3, direction=(0, 0, 0)), "not all 0"),
                (lambda: mq.add_size_region(3, 1), "made of document objects")):
            with self.assertRaisesRegex(mq.InvalidInput, said):
                call()
            self.assertEqual(len(self.document.Objects), before)
        region = mq.add_size_region(self.ball, 1.0)
        region.Of = []
        with self.assertRaisesRegex(mq.InvalidInput, "has no shapes"):
            mq.triangulate(self.box, size_field=region)
        with self.assertRaisesRegex(mq.InvalidInput, "size_field = Box is not allowed"):
            mq.update(mq.add_quality_mesh(self.box), size_field=["Box"])


class CommandLine(unittest.TestCase):
    """--size-field FILE."""

    def test_options_are_on_the_command_line(self):
        from MeshQuality.cli import parser
        given = parser.parse(["triangulate", "a.step", "--size-field", "sizes.csv"])
        self.assertEqual(given.size_field, "sizes.csv")

    def test_report_has_the_ratio(self):
        from MeshQuality.cli.report_fields import report_fields
        report = mq.triangulate(Part.makeBox(10, 10, 10), size_field=lambda p: np.full(len(p), 1.0)).report
        fields = json.loads(json.dumps(report_fields(report)))
        self.assertLessEqual(fields["size_ratio"], RATIO)
        self.assertEqual(len(fields["size_ratio_point"]), 3)
