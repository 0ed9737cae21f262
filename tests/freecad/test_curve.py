# SPDX-License-Identifier: LGPL-2.1-or-later
"""MeshQuality.curve and the command line's curve, inside FreeCAD."""

import json
import math
import os
import shutil
import subprocess
import unittest

import helpers
import parts

import FreeCAD
import numpy as np
import Part

import MeshQuality as mq

COMMAND = os.path.join(helpers.ROOT, "bin", "meshquality")
PER_TRIANGLE = {1: 3, 2: 6, 3: 10, 4: 15, 5: 21}
PER_TETRAHEDRON = {1: 4, 2: 10, 3: 20, 4: 35}


class Curve(helpers.DocumentTest):
    def test_surfaces_of_every_order(self):
        for order in range(1, 6):
            mesh = mq.curve(Part.makeSphere(5), order=order)
            self.assertEqual(mesh.order, order)
            self.assertEqual(mesh.elements.shape[1], PER_TRIANGLE[order])
            self.assertEqual(mesh.report.invalid, 0)
            np.testing.assert_allclose(np.linalg.norm(mesh.nodes, axis=1), 5.0, atol=1e-9)
            self.assertEqual(set(mesh.triangle_face), {0})

    def test_volumes_of_every_order(self):
        for order in range(1, 5):
            mesh = mq.curve(Part.makeTorus(10, 3), order=order, volume=True)
            self.assertEqual(mesh.elements.shape[1], PER_TETRAHEDRON[order])
            self.assertEqual(mesh.report.invalid, 0, str(mesh.report))
            exact = 2 * math.pi ** 2 * 10 * 9
            self.assertAlmostEqual(mesh.report.volume / exact, 1.0, delta=0.1 if order == 1 else 2e-3)
            self.assertGreater(mesh.report.min_distortion, 0.1)

    def test_every_simple_part_is_valid(self):
        for name, shape in helpers.simple_parts().items():
            report = mq.curve(shape, order=2, volume=True).report
            self.assertEqual(report.invalid, 0, f"{name}: {report}")
            self.assertAlmostEqual(report.volume / shape.Volume, 1.0, delta=5e-3, msg=name)
            self.assertAlmostEqual(report.volume_error, abs(report.volume / shape.Volume - 1), 9)

    def test_slender_cones_are_valid(self):
        """Only three or four triangles have room around the apex. Finer meshes of the whole part had 16,000 tetrahedra, or invalid ones."""
        for radius, height in ((5, 20), (2, 10), (3, 10), (1, 10)):
            mesh = mq.curve(Part.makeCone(radius, 0, height), order=2, volume=True)
            self.assertEqual(mesh.report.invalid, 0, f"{radius} by {height}: {mesh.report}")
            self.assertLess(len(mesh.elements), 8000, f"{radius} by {height}")

    def test_a_vertex_of_a_boolean_far_off_its_edges(self):
        """OpenCASCADE 7.6 joins two vertices 0.43 mm apart, within a tolerance of 0.28 mm."""
        box = Part.makeBox(6.73, 7.142, 6.995, FreeCAD.Vector(2.623, 0.428, -0.239))
        torus = Part.makeTorus(9.234, 2.534, FreeCAD.Vector(2.906, 2.84, -1.959))
        shape = torus.cut(box.makeFillet(0.455, box.Edges))
        tolerance = max(vertex.Tolerance for vertex in shape.Vertexes)
        straight = mq.triangulate(shape, min_angle=20, chord_height_relative=0.02)
        for order in range(2, 6):
            report = mq.curve(straight, order=order, shape=shape).report
            self.assertEqual(report.invalid, 0, str(report))
            self.assertGreater(report.min_distortion, 0.2)
            self.assertLess(report.max_deviation, max(tolerance, 0.05))
            self.assertTrue(math.isfinite(report.max_shape_distortion))
            self.assertEqual(any(" mm from the edges or faces at it" in note for note in report.notes),
                             tolerance > 0.1, report.notes)

    def test_a_face_that_is_no_surface_is_curved_once(self):
        """An edge passes a pole within its tolerance, so that the border of the sphere crosses itself there. Finer
        straight meshes had the same faults: it took more than eight minutes."""
        vector = FreeCAD.Vector
        shape = Part.makeTorus(6.904106579070936, 2.6846184789235075,
                               vector(1.539621748422821, -2.0005066543523506, -1.1986734052493118))
        shape = shape.fuse(Part.makeCone(5.040417438873876, 2.4530821666853564, 5.3380489538378,
                                         vector(2.0633736270267553, -1.3518398557275502, -2.924825234366649)))
        shape = shape.fuse(Part.makeSphere(3.0448445275314255,
                                           vector(-1.8059738289441531, 2.295044007007795, -1.978543863553714)))
        stages = []
        report = mq.curve(shape, order=2, chord_height_relative=0.05,
                          progress=lambda _, stage: stages.append(stage) or True).report
        straight = mq.triangulate(shape, min_angle=20, chord_height_relative=0.05).report
        self.assertEqual(straight.oriented, report.invalid == 0, f"{straight}{report}")
        runs = sum(1 for i, stage in enumerate(stages) if stage == "classifying" and stages[i - 1] != stage)
        self.assertLessEqual(runs, 1 if report.invalid else 4, stages)
        self.assertEqual(any("finer one was not tried" in note for note in report.notes), report.invalid > 0)

    def test_the_volume_of_prisms_on_closed_splines(self):
        """OpenCASCADE's own integration errs by up to a third there."""
        random = np.random.default_rng(5)
        for _ in range(3):
            angles = 2 * math.pi * np.arange(8) / 8
            radii = 10 * random.uniform(0.6, 1.4, 8)
            outline = Part.BSplineCurve()
            outline.interpolate([FreeCAD.Vector(r * math.cos(a), r * math.sin(a), 0) for r, a in zip(radii, angles)], PeriodicFlag=True)
            x, y = np.array([tuple(outline.value(t))[:2] for t in np.linspace(outline.FirstParameter, outline.LastParameter, 20001)]).T
            volume = 2.5 * abs((x[:-1] * y[1:] - x[1:] * y[:-1]).sum())
            report = mq.curve(Part.Face(Part.Wire(outline.toShape())).extrude(FreeCAD.Vector(0, 0, 5)), order=2).report
            self.assertAlmostEqual(report.cad_volume, volume, delta=1e-6 * volume)
            self.assertLess(report.cad_volume_error, 1e-6 * volume)
            self.assertLess(report.volume_error, 1e-3)

    def test_what_has_no_volume_has_no_volume_error(self):
        report = mq.curve(Part.makePlane(10, 10)).report
        self.assertEqual((report.volume, report.cad_volume, report.volume_error), (0.0, 0.0, -1.0))

    def test_distortions_by_element(self):
        mesh = mq.curve(Part.makeTorus(10, 3), order=3, volume=True)
        triangles, tetrahedra = mesh.triangle_distortion, mesh.tetrahedron_distortion
        self.assertEqual((triangles.shape, tetrahedra.shape),
                         ((len(mesh.triangles),), (len(mesh.tetrahedra),)))
        self.assertGreaterEqual(min(triangles.min(), tetrahedra.min()), 1.0)
        self.assertTrue(np.isfinite(tetrahedra).all())
        self.assertIs(mesh.tetrahedron_distortion, tetrahedra)
        self.assertRaises(ValueError, tetrahedra.__setitem__, 0, 1.0)
        self.assertEqual(mesh.report.max_shape_distortion, tetrahedra.max())
        shown = mesh.shown_distortion()
        self.assertTrue(np.isin(shown, tetrahedra).all())
        # Straight elements are as bad as their corners tell, whatever their order.
        flat = mq.curve(Part.makeBox(10, 10, 10), order=2)
        corners = flat.nodes[flat.triangles[:, :3]]
        sides = corners - np.roll(corners, 1, axis=1)
        area = 0.5 * np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1)
        expected = (sides**2).sum(axis=(1, 2)) / (4 * math.sqrt(3) * area)
        np.testing.assert_allclose(flat.triangle_distortion, expected, rtol=1e-9)
        np.testing.assert_array_equal(flat.shown_distortion(), flat.triangle_distortion)
        self.assertEqual(flat.report.max_shape_distortion, flat.triangle_distortion.max())

    def test_edges_lie_on_their_cad_edges(self):
        shape = Part.makeCylinder(5, 10)
        mesh = mq.curve(shape, order=3)
        self.assertEqual(mesh.edges.shape[1], 4)
        on_edges = mesh.nodes[np.unique(mesh.edges)]
        for x, y, z in on_edges[::7]:
            distance = min(edge.distToShape(Part.Vertex(x, y, z))[0] for edge in shape.Edges)
            self.assertLess(distance, 1e-7)

    def test_a_given_surface_mesh(self):
        shape = Part.makeSphere(5)
        straight = mq.triangulate(shape, min_angle=20)
        mesh = mq.curve(straight, order=2, shape=shape)
        self.assertGreaterEqual(len(mesh.triangles), len(straight.triangles))
        with self.assertRaisesRegex(mq.InvalidInput, "shape="):
            mq.curve(straight)

    def test_mesh_for_viewers_is_closed_and_near(self):
        mesh = mq.curve(Part.makeSphere(5), order=3).to_mesh(deviation=0.005)
        self.assertTrue(mesh.isSolid())
        self.assertAlmostEqual(mesh.Volume / (4 / 3 * math.pi * 125), 1.0, delta=4e-3)

    def test_refusals(self):
        sphere = Part.makeSphere(5)
        for bad in ({"order": 0}, {"order": 6}, {"order": 5, "volume": True}, {"order": 2.5},
                    {"chord_height": 1.0, "chord_height_relative": 0.1}, {"progress": 3}):
            with self.assertRaises(mq.InvalidInput, msg=str(bad)):
                mq.curve(sphere, **bad)
        with self.assertRaisesRegex(mq.InvalidInput, "solid"):
            mq.curve(Part.makePlane(10, 10), volume=True)

    def test_cancelling(self):
        for threads in (1, 3):
            with self.assertRaises(mq.Cancelled):
                mq.curve(Part.makeTorus(10, 3), volume=True, progress=lambda fraction, stage: False, threads=threads)

    def test_the_bytes_are_the_same_for_any_number_of_threads(self):
        shell = Part.makeSphere(20).cut(Part.makeSphere(19))
        apart = [shell.copy(), shell.copy(), Part.makeBox(5, 5, 5)]
        for i, solid in enumerate(apart):
            solid.translate(FreeCAD.Vector(50 * i, 0, 0))
        cases = {"several solids": (Part.makeCompound(apart), {"volume": True, "chord_height": 0.4}),
                 "one solid": (helpers.simple_parts()["fused"], {"volume": True, "order": 3}),
                 "surface": (parts.bracket(), {"order": 3, "chord_height_relative": 0.001})}
        for name, (shape, how) in cases.items():
            with self.subTest(name):
                one, *others = (mq.curve(shape, **how, threads=n) for n in (1, 2, 3, 8))
                for several in others:
                    for array in ("nodes", "elements", "edges", "triangle_quality", "tetrahedron_quality"):
                        self.assertEqual(getattr(several, array).tobytes(), getattr(one, array).tobytes(), array)
                    for figure in ("repairs", "notes", "invalid_before", "invalid", "max_deviation", "rms_deviation", "volume",
                                   "max_shape_distortion", "min_distortion", "not_proven_apart"):
                        self.assertEqual(getattr(several.report, figure), getattr(one.report, figure), figure)

    def test_numbers_of_threads_that_are_none_are_refused(self):
        for threads in (-1, 1025, 1.5, True, "all"):
            with self.assertRaisesRegex(mq.InvalidInput, "threads"):
                mq.curve(Part.makeBox(1, 1, 1), threads=threads)

    def test_files(self):
        mesh = mq.curve(Part.makeCylinder(5, 10), order=2, volume=True)
        for name in ("part.msh", "part.vtu"):
            mesh.write(os.path.join(self.folder, name))
        with open(os.path.join(self.folder, "part.msh"), encoding="ascii") as stream:
            text = stream.read()
        self.assertTrue(text.startswith("$MeshFormat\n4.1 0 8\n"))
        for name in ("Face1", "Face3", "Solid1", "Edge2"):
            self.assertIn(f'"{name}"', text)
        with self.assertRaises(mq.IoError):
            mesh.write(os.path.join(self.folder, "part.stl"))

    def test_fem_mesh(self):
        import Fem  # noqa: F401 - FreeCAD's FEM meshes are what is tested

        for order in (1, 2):
            mesh = mq.curve(Part.makeTorus(10, 3), order=order, volume=True)
            fem = mesh.to_fem_mesh()
            self.assertEqual(fem.VolumeCount, len(mesh.tetrahedra))
            used = len(np.unique(mesh.tetrahedra))
            self.assertEqual(fem.NodeCount, used)
        surface = mq.curve(Part.makeSphere(5), order=2)
        self.assertEqual(surface.to_fem_mesh().FaceCount, len(surface.triangles))
        with self.assertRaisesRegex(mq.InvalidInput, "order=2"):
            mq.curve(Part.makeSphere(5), order=3).to_fem_mesh()

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX (ccx) is not installed")
    def test_calculix_reproduces_a_linear_field(self):
        self.expect_linear_field(mq.curve(Part.makeBox(5, 4, 3), order=2, volume=True, max_edge=1.5),
                                 1e-6)
        # CalculiX takes four points an element, exact to degree 2; on curved ones the sum over a
        # node's elements has degree 3 and does not vanish altogether.
        self.expect_linear_field(mq.curve(Part.makeTorus(10, 3), order=2, volume=True), 1e-4)

    def expect_linear_field(self, mesh, accuracy):
        """Solves with a linear displacement of all boundary nodes: the inside must follow."""
        path = os.path.join(self.folder, "patch.inp")
        mesh.to_fem_mesh().writeABAQUS(path, 1, False)
        field = np.array([[1e-3, 2e-4, 0], [0, -5e-4, 1e-4], [3e-4, 0, 7e-4]])
        moved = mesh.nodes @ field.T
        boundary = np.unique(mesh.triangles)
        lines = ["*MATERIAL, NAME=M", "*ELASTIC", "210000, 0.3",
                 "*SOLID SECTION, ELSET=Evolumes, MATERIAL=M", "*STEP", "*STATIC", "*BOUNDARY"]
        lines += [f"{n + 1}, {k + 1}, {k + 1}, {moved[n, k]:.10e}" for n in boundary
                  for k in range(3)]
        lines += ["*NODE PRINT, NSET=Nall", "U", "*END STEP", ""]
        with open(path, "a", encoding="ascii") as stream:
            stream.write("\n".join(lines))
        done = subprocess.run(["ccx", "patch"], cwd=self.folder, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=300, check=False)
        self.assertEqual(done.returncode, 0, done.stdout[-500:])
        rows = []
        with open(os.path.join(self.folder, "patch.dat"), encoding="ascii") as stream:
            for line in stream:
                words = line.split()
                if len(words) == 4 and words[0].isdigit():
                    rows.append([float(word) for word in words])
        solved = np.array(rows)
        self.assertEqual(len(solved), len(mesh.nodes))
        self.assertGreater(len(mesh.nodes), len(boundary), "there are nodes inside to solve for")
        expected = moved[solved[:, 0].astype(int) - 1]
        np.testing.assert_allclose(solved[:, 1:], expected, rtol=0,
                                   atol=accuracy * np.abs(moved).max())

    def test_command_line(self):
        step = os.path.join(self.folder, "part.step")
        output = os.path.join(self.folder, "part.msh")
        Part.makeCylinder(5, 10).exportStep(step)
        done = subprocess.run([COMMAND, "curve", step, "-o", output, "--order", "3", "--volume",
                               "--threads", "2", "--json"], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              timeout=300, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        report = json.loads(done.stdout)
        self.assertEqual(report["invalid"], 0)
        self.assertGreater(report["cpu_seconds"], 0.0)
        self.assertLess(report["volume_error"], 1e-3)
        self.assertEqual(report["straightened"], [])
        self.assertIn("order 3", done.stderr.splitlines()[-1])
        self.assertGreater(os.path.getsize(output), 10000)
