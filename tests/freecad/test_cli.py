# SPDX-License-Identifier: LGPL-2.1-or-later
"""bin/meshquality from outside: status, stdout, stderr, files."""

import json
import os
import subprocess
import time
import unittest
import zipfile

import FreeCAD
import helpers

import Mesh
import Part

import MeshQuality as mq
from MeshQuality import options
from MeshQuality.cli import parser

COMMAND = os.path.join(helpers.ROOT, "bin", "meshquality")


def run(*arguments):
    """(exit status, stdout, lines of stderr)."""
    environment = {name: value for name, value in os.environ.items() if name != "MESHQUALITY_JOB"}
    done = subprocess.run([COMMAND, *map(str, arguments)], stdin=subprocess.DEVNULL, text=True,
                          capture_output=True, timeout=300, env=environment)
    return done.returncode, done.stdout, done.stderr.splitlines()


def workers_of(pid):
    """Process ids of FreeCADs that do a job and whose parent is `pid`."""
    found = []
    for entry in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{entry}/stat", encoding="utf-8", errors="replace") as stream:
                parent = stream.read().rpartition(")")[2].split()[1]
            with open(f"/proc/{entry}/cmdline", "rb") as stream:
                works = b"cli/job.py" in stream.read()
        except OSError:
            continue
        if parent == str(pid) and works:
            found.append(entry)
    return found


# Python tries the temporary folder by a file: Ctrl-C comes just before it is removed.
INTERRUPTED = """
import os, signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)  # shells have commands in the background ignore it
remove = os.unlink
def interrupted(path):
    os.unlink = remove
    signal.raise_signal(signal.SIGINT)  # to this thread, at once
    remove(path)
os.unlink = interrupted
from MeshQuality.cli import main
print(main.main(["triangulate", "nothing.step", "-o", "nothing.ply"]))
"""


class TemporaryFolder(helpers.DocumentTest):
    def test_an_interruption_leaves_no_trial_file(self):
        environment = {**os.environ, "TMPDIR": self.folder, "PYTHONPATH": os.path.join(helpers.ROOT, "Mod")}
        done = subprocess.run(["/usr/bin/python3", "-c", INTERRUPTED], stdin=subprocess.DEVNULL, text=True,
                              capture_output=True, timeout=60, env=environment, check=False)
        self.assertIn("interrupted", done.stderr)
        self.assertEqual(os.listdir(self.folder), [])


class Triangulate(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        self.shape = Part.makeCylinder(5, 10)
        self.step = os.path.join(self.folder, "part.step")
        self.shape.exportStep(self.step)

    def test_json_is_one_object_with_the_report(self):
        output = os.path.join(self.folder, "part.ply")
        status, out, err = run("triangulate", self.step, "-o", output, "--json",
                               "--min-angle", 20, "--chord-height-relative", 0.01)
        self.assertEqual(status, 0, err)
        report = json.loads(out)
        expected = mq.triangulate(Part.read(self.step), min_angle=20, chord_height_relative=0.01)
        for name in ("triangles", "vertices", "closed", "oriented", "manifold", "min_angle",
                     "max_angle", "max_chord_height", "angle_histogram", "queries"):
            self.assertEqual(report[name], getattr(expected.report, name), name)
        self.assertGreater(report["cpu_seconds"], 0.0)
        self.assertIsInstance(report["seconds"], dict)
        self.assertEqual(Mesh.Mesh(output).CountFacets, report["triangles"])

    def test_text_for_people(self):
        status, out, err = run("triangulate", self.step)
        self.assertEqual(status, 0, err)
        self.assertTrue(out.startswith("triangles"), out)
        self.assertIn("triangles", err[-1])

    def test_terminals_without_a_sign_for_degrees(self):
        done = subprocess.run(
            [COMMAND, "triangulate", self.step], stdin=subprocess.DEVNULL, capture_output=True, timeout=300,
            env={**os.environ, "PYTHONIOENCODING": "ascii", "PYTHONUTF8": "0"}, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(rb"requested 25.000\xb0", done.stdout)

    def test_every_kind_of_cad_file(self):
        self.shape.exportBrep(os.path.join(self.folder, "part.brep"))
        self.shape.exportIges(os.path.join(self.folder, "part.iges"))
        self.document.addObject("Part::Box", "Box")
        self.document.addObject("Part::Cylinder", "Cylinder").Label = "my cylinder"
        self.document.recompute()
        self.document.saveAs(os.path.join(self.folder, "part.FCStd"))
        for name, faces in (("part.brep", 3), ("part.iges", 3), ("part.FCStd", 9)):
            path = os.path.join(self.folder, name)
            output = os.path.join(self.folder, "part.msh")
            status, _, err = run("triangulate", path, "-o", output)
            self.assertEqual(status, 0, err)
            with open(output, encoding="ascii") as stream:
                self.assertIn(f"$PhysicalNames\n{faces}\n", stream.read())
        status, out, err = run("triangulate", path, "--object", "my cylinder", "--json")
        self.assertEqual((status, json.loads(out)["components"]), (0, 1), err)

    def test_of_a_document_its_final_shapes_are_meshed(self):
        """Not the operands of a Boolean; and a mesh that refers to a shape does not hide it."""
        box = self.box()
        tool = self.document.addObject("Part::Cylinder", "Tool")
        cut = self.document.addObject("Part::Cut", "Cut")
        cut.Base, cut.Tool = box, tool
        alone = self.document.addObject("Part::Sphere", "Sphere")
        alone.Placement.Base.x = 100
        self.document.recompute()
        mq.add_quality_mesh(cut)
        mq.add_quality_mesh(alone)
        path = os.path.join(self.folder, "part.FCStd")
        self.document.saveAs(path)
        status, out, err = run("triangulate", path, "--json")
        self.assertEqual(status, 0, err)
        report = json.loads(out)
        self.assertEqual(report["components"], 2)
        low, high = report["box"]
        self.assertAlmostEqual(high[0] - low[0], 105.0, places=3)

    def test_a_limit_is_said_in_the_last_line(self):
        status, out, err = run("triangulate", self.step, "--max-triangles", 5, "--json")
        self.assertEqual(status, 0, err)
        self.assertFalse(json.loads(out)["complete"])
        self.assertIn("incomplete", err[-1])
        self.assertIn("more triangles are below 25°", err[-1])

    def test_insertion(self):
        counts = []
        for rule in ("off-centre", "circumcentre"):
            status, out, err = run("triangulate", self.step, "--json", "--insertion", rule,
                                   "--min-angle", 30)
            self.assertEqual(status, 0, err)
            counts.append(json.loads(out)["queries"])
        self.assertNotEqual(*counts)

    def test_bad_input_ends_with_2_and_says_why(self):
        junk = os.path.join(self.folder, "junk.step")
        with open(junk, "w", encoding="ascii") as stream:
            stream.write("no STEP file\n")
        wire = os.path.join(self.folder, "wire.brep")
        Part.makeLine((0, 0, 0), (1, 0, 0)).exportBrep(wire)
        for arguments, word in (
                ((), "COMMAND"),
                (("triangulate",), "INPUT"),
                (("triangulate", self.step, "--min-angle", "foo"), "--min-angle"),
                (("triangulate", self.step, "--min-angle", "50"), "34 degrees"),
                (("triangulate", self.step, "--min-angle", "nan"), "nan"),
                (("triangulate", self.step, "--insertion", "foo"), "off-centre, circumcentre"),
                (("triangulate", self.step, "--chord-height", "1e-12"), "single precision"),
                (("triangulate", os.path.join(self.folder, "none.step")), "none.step"),
                (("triangulate", self.folder + "/part.xyz"), "part.xyz"),
                (("triangulate", junk), "junk.step"),
                (("triangulate", wire), "no faces"),
                (("triangulate", self.step, "-o", "/nowhere/x.ply"), "/nowhere"),
                (("triangulate", self.step, "-o", self.folder + "/x.step"), "x.step"),
                (("quality", self.step), "part.step")):
            with self.subTest(arguments):
                status, out, err = run(*arguments)
                self.assertEqual((status, out), (2, ""))
                self.assertIn(word, err[-1])

    def test_a_negative_number_may_have_an_exponent(self):
        for text in ("-1e9", "-1.5E-3", "-.5", "-2"):
            self.assertEqual(parser.parse(["offset", "part.stl", "--distance", text, "-o", "out.stl"]).distance, float(text))

    def test_a_working_folder_that_is_gone(self):
        gone = os.path.join(self.folder, "gone")
        os.mkdir(gone)
        found = subprocess.run(["/bin/sh", "-c", 'cd "$1" && rmdir "$1" && exec /usr/bin/python3 "$2" quality part.stl', "sh", gone, COMMAND],
                               capture_output=True, text=True, check=False)
        self.assertEqual(found.returncode, 2)
        self.assertIn("the working folder is gone: change into one that is there", found.stderr)

    def test_a_torn_document_is_told_in_one_line(self):
        path = os.path.join(self.folder, "torn.FCStd")
        with zipfile.ZipFile(path, "w") as container:
            container.writestr("Document.xml", '<?xml version="1.0"?>\n<Document SchemaVersion="4">\n<Properties Count="1">\n')
        status, _, err = run("triangulate", path, "-o", os.path.join(self.folder, "out.stl"))
        self.assertEqual(status, 2)
        self.assertNotIn("\\n", err[-1])

    def test_failure_with_json_is_an_object_too(self):
        status, out, err = run("triangulate", self.step, "--json", "--min-angle", "50")
        self.assertEqual(status, 2)
        self.assertIn(json.loads(out)["error"], err[-1])

    def test_told_to_end_it_takes_freecad_with_it(self):
        slow = subprocess.Popen(
            [COMMAND, "triangulate", self.step, "--chord-height", "1e-5",
             "--max-triangles", "100000000"],
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        limit = time.monotonic() + 60
        while not workers_of(slow.pid) and time.monotonic() < limit:
            time.sleep(0.05)
        workers = workers_of(slow.pid)
        self.assertEqual(len(workers), 1)
        slow.terminate()
        _, err = slow.communicate(timeout=60)  # by itself it would not end
        self.assertEqual(slow.returncode, 1)
        self.assertIn("interrupted", err.splitlines()[-1])
        self.assertFalse(os.path.exists(f"/proc/{workers[0]}"))


class Strict(helpers.DocumentTest):
    """What is not met ends with 3 where that is asked for, and is in the JSON in any case."""

    def setUp(self):
        super().setUp()
        corners = [FreeCAD.Vector(*p) for p in ((0, 0, 0), (10, 0, 0), (10, 0.8, 0), (0, 0, 0))]
        wedge = Part.Face(Part.makePolygon(corners)).extrude(FreeCAD.Vector(0, 0, 3))
        self.good, self.bad = (os.path.join(self.folder, name) for name in ("good.brep", "bad.brep"))
        Part.makeBox(10, 10, 10).exportBrep(self.good)
        wedge.exportBrep(self.bad)
        self.ball = os.path.join(self.folder, "ball.stl")
        Mesh.createSphere(5.0, 20).write(self.ball)

    def verdict(self, *arguments):
        """(status without --strict, status with it, report)."""
        plain, out, err = run(*arguments, "--json")
        self.assertEqual(plain, 0, err)
        strict, again, err = run(*arguments, "--json", "--strict")
        report = json.loads(again)
        self.assertEqual(report["verdict"], json.loads(out)["verdict"], err)
        self.assertEqual(strict, 0 if report["verdict"] == "met" else 3, err)
        self.assertEqual(bool(report["findings"]), report["verdict"] == "not met")
        met = "no limits were requested" if arguments[0] == "quality" else "all requested limits are met"
        self.assertIn(report["verdict"] if strict else met, err[-1])
        return report

    def test_triangulate(self):
        self.assertEqual(self.verdict("triangulate", self.good)["verdict"], "met")
        output = os.path.join(self.folder, "bad.ply")
        report = self.verdict("triangulate", self.bad, "-o", output)
        self.assertEqual(report["verdict"], "not met")
        self.assertEqual(Mesh.Mesh(output).CountFacets, report["triangles"])
        finding, = report["findings"]
        self.assertRegex(finding["text"], r"^Smallest angle 4\.57° \(requested 25°\), triangle \d+ on Face\d\. ")
        self.assertTrue(finding["forced"])
        self.assertTrue(finding["faces"])
        self.assertEqual([len(corner) for corner in finding["place"]], [3, 3, 3])

    def test_the_same_as_the_object_of_a_document_says(self):
        obj = self.document.addObject("Part::Feature", "Wedge")
        obj.Shape = Part.read(self.bad)
        self.document.recompute()
        mesh = mq.add_quality_mesh(obj)
        finding, = self.verdict("triangulate", self.bad)["findings"]
        self.assertEqual(mesh.Certificate[len("not met: s"):], finding["text"][1:])

    def test_the_other_commands(self):
        report = self.verdict("curve", self.bad)
        finding, = report["findings"]
        self.assertRegex(finding["text"], r"^Before curving: smallest angle 4\.57° \(requested 20°\), triangle ")
        self.assertEqual(report["straight"]["min_angle_asked"], 20.0)
        self.assertEqual(self.verdict("curve", self.good)["verdict"], "met")
        needle = os.path.join(self.folder, "needle.brep")
        Part.makeBox(10, 0.01, 3).exportBrep(needle)
        self.assertEqual(self.verdict("improve", self.ball, "--min-angle", 34, "--tolerance", 1e-4)["verdict"],
                         "not met")
        self.assertEqual(self.verdict("boolean", self.ball, self.good)["verdict"], "met")
        self.assertEqual(self.verdict("quality", self.ball)["verdict"], "met")

    def test_quality_of_an_open_mesh(self):
        mesh = Mesh.createBox(1, 2, 3)
        mesh.removeFacets([0])
        path = os.path.join(self.folder, "open.stl")
        mesh.write(path)
        report = self.verdict("quality", path)
        self.assertEqual([finding["text"] for finding in report["findings"]], ["Not watertight: 3 open edges."])
        sheet = os.path.join(self.folder, "sheet.brep")
        Part.makePlane(1, 1).exportBrep(sheet)
        self.assertEqual(self.verdict("quality", path, "--shape", sheet)["verdict"], "met")

    def test_bad_usage_and_failure_stay(self):
        self.assertEqual(run("triangulate", self.good, "--strict", "--min-angle", 50)[0], 2)
        self.assertEqual(run("curve", self.good, "--strict", "--volume", "--order", 5)[0], 2)


class Quality(helpers.DocumentTest):
    def test_a_mesh_with_a_hole(self):
        mesh = Mesh.createBox(1, 2, 3)
        mesh.removeFacets([0])
        path = os.path.join(self.folder, "open.stl")
        mesh.write(path)
        status, out, err = run("quality", path, "--json")
        report = json.loads(out)
        self.assertEqual(status, 0, err)
        self.assertFalse(report["closed"])
        self.assertEqual(report["border_edges"], 3)
        self.assertEqual(report["triangles"], 11)


    def test_nothing_was_requested(self):
        """So that nothing requested can be met."""
        path, shape = (os.path.join(self.folder, name) for name in ("box.stl", "box.brep"))
        Mesh.createBox(10, 10, 10).write(path)
        Part.makeBox(10, 10, 10, FreeCAD.Vector(-5, -5, -5)).exportBrep(shape)
        for arguments in ((path,), (path, "--shape", shape)):
            status, out, err = run("quality", *arguments, "--json")
            self.assertEqual((status, json.loads(out)["verdict"]), (0, "met"))
            self.assertIn("; no limits were requested, and no faults were found", err[-1])
            self.assertNotIn("met", err[-1])

    def test_a_mesh_that_is_inside_out(self):
        mesh = Mesh.createBox(1, 2, 3)
        mesh.flipNormals()
        path = os.path.join(self.folder, "inward.stl")
        mesh.write(path)
        status, out, err = run("quality", path, "--json", "--strict")
        report = json.loads(out)
        self.assertAlmostEqual(report["volume"], -6.0, places=5)
        self.assertEqual((status, report["verdict"]), (3, "not met"))
        self.assertEqual([finding["text"] for finding in report["findings"]],
                         ["The surface is inside out: its triangles face inwards."])
        self.assertIn("the surface is inside out", err[-1])


class NoBound(helpers.DocumentTest):
    """The word for no bound on the distance is the same everywhere."""

    def test_other_words_are_refused(self):
        path = os.path.join(self.folder, "box.brep")
        Part.makeBox(1, 1, 1).exportBrep(path)
        box = mq.add_quality_mesh(self.box())
        parts = os.path.join(self.folder, "parts")
        os.mkdir(parts)
        Part.makeBox(1, 1, 1).exportBrep(os.path.join(parts, "box.brep"))
        for word in ("None", "NONE", " none", "no"):
            with self.subTest(word):
                for arguments in (("triangulate", path), ("batch", parts, "-o", os.path.join(self.folder, "out"))):
                    status, _, err = run(*arguments, f"--chord-height={word}")
                    self.assertEqual(status, 2, err)
                    self.assertIn(f"'{word}' is neither a length in mm nor none", err[-1])
                for call in (lambda: mq.triangulate(Part.makeBox(1, 1, 1), chord_height=word),
                             lambda: mq.add_quality_mesh(box.Source, chord_height=word),
                             lambda: mq.update(box, chord_height=word)):
                    with self.assertRaisesRegex(mq.InvalidInput, "chord_height"):
                        call()
        self.assertEqual(run("triangulate", path, "--chord-height", "none")[0], 0)
        mq.update(box, chord_height="none")
        self.assertEqual(box.DistanceBound, "None")


class LocalSizes(helpers.DocumentTest):
    """By the names of objects, as in Python."""

    def setUp(self):
        super().setUp()
        self.part = self.document.addObject("App::Part", "Part")
        self.part.Placement.Base = FreeCAD.Vector(0, 50, 0)
        self.first, self.second = self.box("Box"), self.box("Other")
        self.second.Placement.Base = FreeCAD.Vector(30, 0, 0)
        self.part.addObject(self.first)
        self.part.addObject(self.second)
        self.document.recompute()
        self.path = os.path.join(self.folder, "parts.FCStd")
        self.document.saveAs(self.path)

    def counts(self, *arguments):
        """How many triangles the file gets."""
        status, out, err = run("triangulate", self.path, "--json", *arguments)
        self.assertEqual(status, 0, err)
        return json.loads(out)["triangles"]

    def test_of_a_container_as_in_python(self):
        for name in ("Other.Face3", "Part.Other.Face3", "Other.Edge1"):
            wanted = len(mq.triangulate(self.part, local_sizes={name.removeprefix("Part."): 1.0}).triangles)
            self.assertGreater(wanted, len(mq.triangulate(self.part).triangles))
            for more in ((), ("--object", "Part")):
                self.assertEqual(self.counts("--local-sizes", f"{name}=1.0", *more), wanted, (name, more))

    def test_of_several_objects_of_a_file(self):
        third = self.box("Third")
        third.Placement.Base = FreeCAD.Vector(0, -50, 0)
        self.document.recompute()
        self.document.save()
        plain = self.counts()
        found = {name: self.counts("--local-sizes", f"{name}=1.0")
                 for name in ("Third.Face1", "Part.Box.Face1", "Face1", "Face13")}
        self.assertTrue(all(count > plain for count in found.values()), found)
        status, _, err = run("triangulate", self.path, "--local-sizes", "Box.Face1=1")
        self.assertEqual(status, 2)
        self.assertIn("no 'Box' among the objects that are meshed: begin with one of Part, Third", err[-1])
        status, _, err = run("triangulate", self.path, "--local-sizes", "Third.Face7=1")
        self.assertEqual(status, 2)
        self.assertIn("local_sizes names Third.Face7, but 'Third' has no Face7", err[-1])

    def test_of_a_file_without_names(self):
        path = os.path.join(self.folder, "box.brep")
        Part.makeBox(1, 1, 1).exportBrep(path)
        status, _, err = run("triangulate", path, "--local-sizes", "Box.Edge1=1")
        self.assertEqual(status, 2)
        self.assertIn(f"local_sizes names Box.Edge1, but '{path}' has no objects with names", err[-1])
        self.assertTrue(err[-1].endswith("such as Edge1"))


class Scales(helpers.DocumentTest):
    def test_what_single_precision_does_not_hold_is_refused(self):
        mesh = mq.triangulate(Part.makeBox(10, 10, 10))
        path = os.path.join(self.folder, "box.stl")
        for scale, words in ((1e38, "give a smaller scale"), (1e-38, "give a larger scale")):
            with self.assertRaisesRegex(mq.InvalidInput, words):
                mesh.write(path, scale=scale)
            self.assertFalse(os.path.exists(path))
        mesh.write(path, scale=1e30)


class Help(unittest.TestCase):
    def test_every_option_is_there(self):
        status, out, _ = run("triangulate", "--help")
        self.assertEqual(status, 0)
        for option in options.TRIANGULATE:
            self.assertIn(option.flag, out)
        self.assertEqual(run("--help")[0], 0)
