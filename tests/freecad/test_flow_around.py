# SPDX-License-Identifier: LGPL-2.1-or-later
"""volume_mesh around a part: the far field, its patches, symmetry, layers on the part; and the first height for a y+."""

import json
import math
import os
import shutil
import subprocess

import helpers
import numpy as np
import Part
from FreeCAD import Vector
from parts import wing
from test_cli import run
from test_measures import ENVIRONMENT

import MeshQuality as mq


class FlowsAround(helpers.DocumentTest):
    def assert_sound(self, mesh, region):
        """All elements are proven and conform, the volume is that of OpenCASCADE's region, and OpenFOAM takes the case."""
        certificate = mq.certify(mesh)
        self.assertEqual((certificate.invalid, certificate.conforming, certificate.oriented), (0, True, True))
        self.assertAlmostEqual(mesh.report.volume / region.Volume, 1.0, delta=1e-5)
        folder = os.path.join(self.folder, "case")
        mesh.write(folder)
        if not shutil.which("checkMesh"):
            self.skipTest("checkMesh is missing: Debian's package openfoam has it")
        said = subprocess.run(["checkMesh"], cwd=folder, env=ENVIRONMENT, capture_output=True, text=True, timeout=300).stdout
        self.assertIn("Mesh OK.", said)

    def areas(self, mesh):
        """mm^2, by patch, of its triangles."""
        a, b, c = mesh.nodes[mesh.boundary_triangles].transpose(1, 0, 2)
        area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
        patch = mesh.patch_of_faces(np.pad(mesh.boundary_triangles, ((0, 0), (0, 1)), constant_values=-1))
        return {name: area[patch == i].sum() for i, name in enumerate(mesh.patch_names)}

    def test_a_box_around_a_box(self):
        part = Part.makeBox(10, 6, 4)
        mesh = mq.volume_mesh(part, layers=3, first_height=0.05, max_edge=3.0, far_field="box:2")
        self.assert_sound(mesh, Part.makeBox(50, 46, 44, Vector(-20, -20, -20)).cut(part))
        self.assertEqual((mesh.report.covered, mesh.report.full_height), (1.0, 1.0))
        areas = self.areas(mesh)
        for name, area in (("xMin", 46 * 44), ("xMax", 46 * 44), ("yMax", 50 * 44), ("zMin", 50 * 46), ("Face1", 6 * 4)):
            self.assertAlmostEqual(areas[name] / area, 1.0, places=6, msg=name)
        self.assertEqual({name for name, kind in mesh.patch_types.items() if kind == "wall"}, {f"Face{i}" for i in range(1, 7)})

    def test_a_plane_of_symmetry_cuts_the_part(self):
        pin = Part.makeCylinder(3, 12)
        mesh = mq.volume_mesh(pin, layers=3, first_height=0.05, far_field="box:3", symmetry="y>0", far_edge=20.0, chord_height=0.1,
                              patches={"inlet": ["xMin"], "outlet": ["xMax"], "top": ["Face2"]}, patch_rest="pin")
        region = Part.makeBox(78, 39, 84, Vector(-39, 0, -36)).cut(pin)
        self.assertEqual(mesh.patch_names, ("inlet", "outlet", "top", "symmetry", "yMax", "zMin", "zMax", "pin"))
        self.assertEqual((mesh.patch_types["symmetry"], mesh.patch_types["pin"], mesh.patch_types["inlet"]), ("symmetry", "wall", "patch"))
        self.assertEqual(mesh.report.covered, 1.0)
        self.assertAlmostEqual(mesh.report.volume / region.Volume, 1.0, delta=1e-4)  # the pin is round
        self.assert_sound(mesh, Part.makeBox(1, 1, mesh.report.volume))

    def test_layers_at_a_sharp_trailing_edge_are_no_skewer_than_checkmesh_accepts(self):
        flap = wing.flap()
        size = flap.BoundBox.XLength
        mesh = mq.volume_mesh(flap, layers=3, first_height=0.0007 * size, growth_rate=1.3, max_edge=size / 25, far_field="box:2")
        self.assert_sound(mesh, Part.makeBox(1, 1, mesh.report.volume))
        self.assertLess(mesh.report.max_skewness, 4.0)  # 6.1 with columns at most 4 times as long as layers are high
        self.assertGreater(mesh.report.covered, 0.97)

    def test_a_sphere_and_a_solid(self):
        part = Part.makeBox(4, 4, 4)
        mesh = mq.volume_mesh(part, layers=2, first_height=0.1, far_field="sphere:1", chord_height=0.2, max_edge=2.0)
        self.assertEqual(mesh.patch_types["farField"], "patch")
        self.assertAlmostEqual(mesh.report.volume / (4 / 3 * math.pi * 6**3 - 64), 1.0, delta=0.05)
        ground = Part.makeBox(24, 24, 14, Vector(-10, -10, 0))  # of which the part stands on the face z = 0
        mesh = mq.volume_mesh(part, layers=2, first_height=0.1, far_field=ground, max_edge=2.0, patches={"ground": ["Far5"]},
                              walls=["ground", "Face1", "Face2", "Face3", "Face4", "Face6"])
        self.assert_sound(mesh, ground.cut(part))
        self.assertEqual(mesh.patch_types["ground"], "wall")
        self.assertIn("Far5", [wall.face for wall in mesh.report.walls])
        self.assertNotIn("Face5", mesh.patch_names)  # it is on the ground

    def test_local_sizes_are_of_the_part(self):
        mesh = mq.volume_mesh(Part.makeBox(10, 6, 4), layers=2, first_height=0.05, max_edge=4.0, far_field="box:1", far_edge=10.0,
                              local_sizes={"Face6": 1.0, "Edge1": 0.5})
        counts = {face: int((mesh.triangle_face == face).sum()) for face in (4, 5)}  # z = 0 and z = 4
        self.assertGreater(counts[5], 3 * counts[4])

    def test_what_is_not_possible_is_named(self):
        box, good = Part.makeBox(10, 10, 10), {"layers": 2, "first_height": 0.1}
        for given, words in (({"far_field": "cube"}, "far_field"), ({"far_field": "box:-1"}, "far_field"), ({"symmetry": "y>0"}, "symmetry"),
                             ({"far_field": "box", "symmetry": "up"}, "symmetry"), ({"far_edge": 3.0}, "far_edge"),
                             ({"far_field": Part.makeBox(5, 5, 5)}, "far field"), ({"far_field": "box", "symmetry": "y<-3"}, "far field"),
                             ({"far_field": Part.makeSphere(50), "symmetry": "y>0"}, "symmetry"),
                             ({"far_field": "box", "patches": {"xMin": ["Face1"]}}, "xMin"),
                             ({"far_field": "box", "patches": {"in": ["Face9"]}}, "Face9"),
                             ({"far_field": "box", "walls": ["Face9"]}, "Face9")):
            with self.assertRaisesRegex(mq.InvalidInput, words):
                mq.volume_mesh(box, **good, **given)

    def test_the_command_line(self):
        part, ground = (os.path.join(self.folder, name) for name in ("block.brep", "ground.brep"))
        Part.makeBox(4, 4, 4).exportBrep(part)
        Part.makeBox(24, 24, 24, Vector(-10, -10, -10)).exportBrep(ground)
        given = ["volume", part, "--layers", "2", "--y-plus", "30", "--speed", "20", "--length", "100", "--json"]
        for more, patch in ((["--far-field", "box:2", "--symmetry", "y>2"], "symmetry"), (["--far-field", ground], "Far1")):
            case = os.path.join(self.folder, patch)
            status, out, said = run(*given, *more, "-o", case)
            self.assertEqual(status, 0, said)
            report = json.loads(out)
            self.assertAlmostEqual(report["first_height"], float(mq.first_height(20.0, 100.0, "air", 30.0)))
            self.assertTrue(any("y+ = 30" in note for note in report["notes"]))
            with open(os.path.join(case, "constant", "polyMesh", "boundary"), encoding="utf-8") as stream:
                self.assertIn(f"    {patch}\n", stream.read())
        for more, words in ((["--first-height", "0.1"], "--first-height"), (["--fluid", "oil"], "oil")):
            status, _, said = run(*given, *more)
            self.assertEqual(status, 2)
            self.assertIn(words, "".join(said))


class FirstHeights(helpers.DocumentTest):
    def test_plates(self):
        turbulent = mq.first_height(10.0, 1000.0, 1.5e-5)
        self.assertAlmostEqual(turbulent.reynolds, 1e4 / 0.015)
        self.assertAlmostEqual(turbulent.skin_friction, 0.027 * (1e4 / 0.015) ** (-1 / 7))
        self.assertAlmostEqual(turbulent, 0.0673, delta=0.0001)  # mm: twice 1.5e-5 / 0.446 m
        laminar = mq.first_height(1.0, 100.0, "water", y_plus=0.5)
        self.assertAlmostEqual(laminar.skin_friction, 0.664 / math.sqrt(0.1 / 1.004e-6))
        self.assertAlmostEqual(laminar / 1000 * laminar.friction_velocity / 1.004e-6, 2 * 0.5)
        self.assertIn("y+ = 0.5", str(laminar))

    def test_what_is_not_possible_is_named(self):
        for given, words in (((0.0, 1.0), "speed"), ((1.0, math.inf), "length"), ((1.0, 1.0, "oil"), "oil"), ((1.0, 1.0, -1.0), "fluid"),
                             ((1.0, 1.0, "air", 0.0), "y_plus")):
            with self.assertRaisesRegex(mq.InvalidInput, words):
                mq.first_height(*given)
