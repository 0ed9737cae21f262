# SPDX-License-Identifier: LGPL-2.1-or-later
"""bin/meshquality wrap from outside: status, stdout, stderr, files."""

import json
import os

import helpers
import Mesh
import Part
from FreeCAD import Vector
from test_cli import run

import MeshQuality as mq
from MeshQuality import options

GAP, TOLERANCE = ("--gap", 2), ("--tolerance", 0.8)
INSIDE = "10, 10, 10"


class WrapCommand(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        self.a, self.b, self.output = (os.path.join(self.folder, name) for name in ("a.stl", "b.step", "out.ply"))
        Mesh.createBox(10, 10, 10).write(self.a)
        Part.makeBox(10, 10, 10, Vector(5.4, -5, -5)).exportStep(self.b)

    def room(self, radius):
        """A file with a room that has a round opening."""
        path = os.path.join(self.folder, "room.brep")
        room = Part.makeBox(20, 20, 20).cut(Part.makeBox(16, 16, 16, Vector(2, 2, 2)))
        room.cut(Part.makeCylinder(radius, 10, Vector(10, 10, 15))).exportBrep(path)
        return path

    def test_several_inputs_and_json(self):
        status, out, err = run("wrap", self.a, self.b, *GAP, *TOLERANCE, "-o", self.output, "--json")
        self.assertEqual(status, 0, err)
        report = json.loads(out)
        self.assertAlmostEqual(report["volume"], 2040, delta=10.0)  # with the crack
        self.assertTrue(report["closed"] and report["oriented"] and report["manifold"])
        self.assertEqual((report["verdict"], report["findings"], report["notes"]), ("met", [], []))
        self.assertEqual(report["tolerance_asked"], 0.8)
        self.assertLessEqual(report["error_bound"], 0.8)
        self.assertEqual(Mesh.Mesh(self.output).CountFacets, report["triangles"])
        self.assertIn("simplifying", report["seconds"])
        mesh = mq.wrap([Mesh.Mesh(self.a), Part.read(self.b)], GAP[1], TOLERANCE[1])
        self.assertGreater(report["gap_triangles"], 0)
        for name in ("gap_triangles", "gap_area", "distance_to_input", "distance_from_input"):
            self.assertAlmostEqual(report[name], getattr(mesh, name), places=6)
        self.assertEqual(report["leaks"], [])

    def test_one_input_and_text_for_people(self):
        status, out, err = run("wrap", self.b, *GAP, *TOLERANCE)
        self.assertEqual(status, 0, err)
        self.assertTrue(out.startswith("triangles"), out)
        self.assertIn("mm; requested at most", out)
        self.assertIn(", 0 of them close gaps", err[-1])
        status, _, err = run("wrap", self.a, self.b, *GAP, *TOLERANCE)
        self.assertEqual(status, 0, err)
        self.assertRegex(err[-1], r"[1-9]\d* of them close gaps")

    def test_patches_are_in_the_file(self):
        output = os.path.join(self.folder, "out.obj")
        status, _, err = run("wrap", self.b, *GAP, *TOLERANCE, "-o", output)
        self.assertEqual(status, 0, err)
        with open(output, encoding="utf-8") as stream:
            names = {line.split()[1] for line in stream if line.startswith(("g ", "o "))}
        self.assertTrue({f"Face{i}" for i in range(1, 7)} <= names, names)

    def test_a_place_that_is_not_dry_is_said_and_strict_ends_with_3(self):
        room = self.room(3.0)
        arguments = ("wrap", room, *GAP, *TOLERANCE, "--dry", INSIDE, "-o", self.output, "--json")
        status, out, err = run(*arguments)
        self.assertEqual(status, 0, err)
        report = json.loads(out)
        finding, = report["findings"]
        self.assertRegex(finding["text"], r"^\(10, 10, 10\) is not dry: a ball \d.*mm wide comes in at \(.*\); close that opening")
        self.assertEqual(report["verdict"], "not met")
        leak, = report["leaks"]
        self.assertEqual(leak["dry"], [10, 10, 10])
        self.assertTrue(2 < leak["width"] < 2 * 3.0 + 0.8, leak["width"])
        self.assertAlmostEqual(leak["narrowest"][0], 10, delta=2.0)
        self.assertEqual({len(place) for place in leak["path"]}, {3})
        status, out, err = run(*arguments, "--strict")
        self.assertEqual(status, 3)
        self.assertEqual(json.loads(out)["findings"], [finding])
        self.assertIn("is not dry", err[-1])
        self.assertEqual(Mesh.Mesh(self.output).CountFacets, report["triangles"])

    def test_dry_places_stay_dry_behind_a_narrow_opening(self):
        room = self.room(0.6)
        status, out, err = run("wrap", room, *GAP, *TOLERANCE, "--dry", f"{INSIDE}; 5, 5, 5", "--strict", "--json")
        self.assertEqual(status, 0, err)
        self.assertAlmostEqual(json.loads(out)["volume"], 8000, delta=50.0)

    def test_an_object_of_a_document(self):
        part = self.document.addObject("App::Part", "Assembly")
        for x in (0.0, 10.4):
            box = self.box(Length=10, Width=10, Height=10)
            box.Placement.Base.x = x
            part.addObject(box)
        self.box("Other")
        self.document.recompute()
        path = os.path.join(self.folder, "both.FCStd")
        self.document.saveAs(path)
        status, out, err = run("wrap", path, "--object", "Assembly", *GAP, *TOLERANCE, "--json")
        self.assertEqual(status, 0, err)
        self.assertAlmostEqual(json.loads(out)["volume"], 2040, delta=10.0)

    def test_bad_input_ends_with_2_and_says_why(self):
        for arguments, word in (
                ((self.a,), "gap"),
                ((self.a, "--gap", "0"), "gap"),
                ((self.a, "--gap", "-1"), "gap"),
                ((self.a, "--gap", "wide"), "wide"),
                ((self.a, *GAP, "--tolerance", "1.2"), "half of the gap"),
                ((self.a, *GAP, "--dry", "here"), "'here' is no list of places such as '0, 0, 300; 10, 0, 20'"),
                ((self.a, *GAP, "--dry", "1, 2"), "'1, 2' is no list of places"),
                ((self.a, *GAP, "--dry", "1, 2, 3; 4"), "no list of places"),
                ((self.a, *GAP, "--dry", ""), "'' is no list of places"),
                ((self.a, *GAP, "--dry", "1, 2, nan"), "dry"),
                ((self.a, self.folder + "/none.stl", *GAP), "none.stl"),
                ((self.a, *GAP, "-o", "/nowhere/x.ply"), "/nowhere"),
                ((self.a, *GAP, "-o", self.folder + "/x.step"), "x.step")):
            with self.subTest(arguments):
                status, out, err = run("wrap", *arguments)
                self.assertEqual((status, out), (2, ""))
                self.assertIn(word, err[-1])

    def test_every_option_is_there_and_the_command_is_listed(self):
        status, out, _ = run("wrap", "--help")
        self.assertEqual(status, 0)
        for option in options.wrap.WRAP:
            self.assertIn(option.flag, out)
        for text in ("INPUT ...", "--dry", "--strict", "--object"):
            self.assertIn(text, out)
        self.assertRegex(run("--help")[1], r"\n +wrap +close the outer surface")
