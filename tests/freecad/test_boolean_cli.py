# SPDX-License-Identifier: LGPL-2.1-or-later
"""bin/meshquality boolean from outside: status, stdout, stderr, files."""

import json
import os

import FreeCAD
import helpers
import Mesh
import numpy as np
import Part
from test_cli import run

from MeshQuality import options


class BooleanCommand(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        self.a, self.b, self.c = (os.path.join(self.folder, name)
                                  for name in ("a.stl", "b.ply", "c.step"))
        for path, corner in ((self.a, 0.0), (self.b, 0.5)):
            mesh = Mesh.createBox(1, 1, 1)
            mesh.translate(corner, corner, corner)
            mesh.write(path)
        Part.makeBox(1, 1, 1).exportStep(self.c)
        self.output = os.path.join(self.folder, "out.ply")

    def test_json_is_one_object_with_the_report(self):
        status, out, err = run("boolean", self.a, self.b, "-o", self.output, "--operation",
                               "difference", "--json", "--tolerance", 0.01)
        self.assertEqual(status, 0, err)
        report = json.loads(out)
        self.assertAlmostEqual(report["volume"], 0.875, places=4)
        self.assertTrue(report["closed"] and report["oriented"] and report["manifold"])
        self.assertEqual(report["retained"] + report["reconstructed"], report["triangles"])
        self.assertEqual((report["repaired"], report["faults_left"]), ([], 0))
        self.assertLessEqual(report["error_bound"], 0.01)
        self.assertGreater(report["cpu_seconds"], 0.0)
        self.assertIn("dividing", report["seconds"])
        self.assertEqual(Mesh.Mesh(self.output).CountFacets, report["triangles"])

    def test_a_result_that_is_not_sound_has_a_status_of_its_own(self):
        # Cubes that touch in edges and corners, twice: one result of them has pinched vertices today.
        for seed in (21, 55):
            dice = np.random.default_rng(seed)
            turn, base = FreeCAD.Rotation(*dice.uniform(0, 360, 3)), FreeCAD.Vector(*dice.uniform(0, 1, 3))
            paths = []
            for name, placement in (("first", FreeCAD.Placement()), ("second", FreeCAD.Placement(base, turn))):
                board = Mesh.Mesh()
                for place in np.argwhere(np.indices((3, 3, 3)).sum(axis=0) % 2 == 0):
                    cube = Mesh.createBox(1, 1, 1)
                    cube.translate(*place.tolist())
                    board.addMesh(cube)
                board.transform(placement.toMatrix())
                paths.append(os.path.join(self.folder, f"{name}.ply"))
                board.write(paths[-1])
            status, out, err = run("boolean", *paths, "-o", self.output, "--json", "--tolerance", 1e-4)
            report = json.loads(out)
            sound = report["closed"] and report["manifold"] and report["oriented"]
            self.assertEqual((status, report["faults_left"] == 0), (0 if sound else 3, sound), err)

    def test_many_operands_and_a_cad_file(self):
        status, out, err = run("boolean", self.a, self.b, self.c, "-o", self.output, "--json")
        self.assertEqual(status, 0, err)
        # Cubes of side 1 around 0, 0.5 and 0.5: the second and the third are the same.
        self.assertAlmostEqual(json.loads(out)["volume"], 1.875, places=3)

    def test_uniform_and_text_for_people(self):
        status, out, err = run("boolean", self.a, self.b, "--method", "uniform",
                               "--resolution", 33)
        self.assertEqual(status, 0, err)
        self.assertTrue(out.startswith("triangles"), out)
        self.assertIn("mm; requested at most", out)
        self.assertIn("unchanged from the operands", err[-1])

    def test_bad_input_ends_with_2_and_says_why(self):
        sheet = os.path.join(self.folder, "sheet.stl")
        Mesh.createPlane(5, 5).write(sheet)
        for arguments, word in (
                ((self.a,), "two inputs"),
                ((self.a, sheet), "operand B"),
                ((self.a, self.folder + "/none.stl"), "none.stl"),
                ((self.a, self.b, "--operation", "cut"), "difference"),
                ((self.a, self.b, "--tolerance", "0"), "tolerance"),
                ((self.a, self.b, "--resolution", "3"), "resolution"),
                ((self.a, self.b, "--method", "sampled"), "method"),
                ((self.a, self.b, "-o", "/nowhere/x.ply"), "/nowhere"),
                ((self.a, self.b, "-o", self.folder + "/x.iges"), "x.iges")):
            with self.subTest(arguments):
                status, out, err = run("boolean", *arguments)
                self.assertEqual((status, out), (2, ""))
                self.assertIn(word, err[-1])
        status, out, err = run("boolean", self.a, sheet, "--json")
        self.assertEqual(status, 2)
        self.assertIn(json.loads(out)["error"], err[-1])

    def test_every_option_is_there(self):
        status, out, _ = run("boolean", "--help")
        self.assertEqual(status, 0)
        for option in options.BOOLEAN:
            self.assertIn(option.flag, out)
