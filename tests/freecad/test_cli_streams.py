# SPDX-License-Identifier: LGPL-2.1-or-later
"""bin/meshquality: standard input and output, formats, progress, and that the API is all there."""

import inspect
import json
import os
import pty
import re
import subprocess
import threading
import time
import unittest

import helpers
import Mesh
import Part
from test_cli import COMMAND, run

import MeshQuality as mq
from MeshQuality.cli import parser


def pipe(data, *arguments):
    """(exit status, stdout, lines of stderr) with bytes on standard input."""
    done = subprocess.run([COMMAND, *map(str, arguments)], input=data, capture_output=True,
                          timeout=300)
    return done.returncode, done.stdout, done.stderr.decode().splitlines()


def at_terminal(*arguments):
    """(exit status, stdout, what stderr shows where it is a terminal)."""
    controller, terminal = pty.openpty()
    shown = bytearray()

    def collect():
        while True:
            try:
                data = os.read(controller, 65536)
            except OSError:  # how Linux says that the terminal was closed
                return
            if not data:
                return
            shown.extend(data)

    reader = threading.Thread(target=collect)
    reader.start()
    done = subprocess.run([COMMAND, *map(str, arguments)], stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=terminal, timeout=300)
    os.close(terminal)
    reader.join()
    os.close(controller)
    return done.returncode, done.stdout, shown.decode()


class Streams(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        self.shape = Part.makeCylinder(5, 10)
        self.brep = os.path.join(self.folder, "part.brep")
        self.shape.exportBrep(self.brep)
        with open(self.brep, "rb") as stream:
            self.data = stream.read()

    def test_from_standard_input_to_standard_output(self):
        status, out, err = pipe(self.data, "triangulate", "-", "--input-format", "brep",
                                "-o", "-", "--format", "ply")
        self.assertEqual(status, 0, err)
        self.assertIn("in standard output", err[-1])
        self.assertTrue(any(line.startswith("closed") for line in err))
        expected = mq.triangulate(Part.read(self.brep))
        path = os.path.join(self.folder, "expected.ply")
        expected.write(path)
        with open(path, "rb") as stream:
            self.assertEqual(out, stream.read())
        # ... and on into the next command.
        status, report, err = pipe(out, "quality", "-", "--input-format", "ply", "--json",
                                   "--shape", self.brep)
        self.assertEqual(status, 0, err)
        self.assertEqual(json.loads(report)["triangles"], len(expected.triangles))

    def test_errors_name_standard_input(self):
        status, out, err = pipe(b"junk", "triangulate", "-", "--input-format", "step")
        self.assertEqual((status, out), (2, b""))
        self.assertIn("cannot read standard input", err[-1])

    def test_format_whatever_the_name(self):
        output = os.path.join(self.folder, "mesh.dat")
        status, _, err = run("triangulate", self.brep, "-o", output, "--format", "STL")
        self.assertEqual(status, 0, err)
        self.assertEqual(sorted(os.listdir(self.folder)), ["mesh.dat", "part.brep"])
        os.rename(output, os.path.join(self.folder, "mesh.stl"))
        mesh = Mesh.Mesh(os.path.join(self.folder, "mesh.stl"))
        self.assertEqual(mesh.CountFacets, len(mq.triangulate(Part.read(self.brep)).triangles))

    def test_curved_elements_as_flat_triangles_and_for_fem(self):
        output = os.path.join(self.folder, "part.stl")
        counts = []
        for deviation in (0.2, 0.02):
            status, _, err = run("curve", self.brep, "-o", output, "--deviation", deviation)
            self.assertEqual(status, 0, err)
            counts.append(Mesh.Mesh(output).CountFacets)
        self.assertGreater(counts[1], counts[0])
        self.assertTrue(Mesh.Mesh(output).isSolid())
        output = os.path.join(self.folder, "part.inp")
        status, out, err = run("curve", self.brep, "-o", output, "--volume", "--json")
        self.assertEqual(status, 0, err)
        with open(output, encoding="ascii") as stream:
            text = stream.read()
        self.assertIn("*ELEMENT, TYPE=C3D10", text)
        elements = text.partition("*ELEMENT")[2].partition("\n")[2].partition("*")[0]
        self.assertEqual(len(re.findall(r"^\d+,", elements, re.MULTILINE)),
                         json.loads(out)["elements"])

    def test_bad_use_of_streams_ends_with_2(self):
        for arguments, word in (
                (("triangulate", "-"), "--input-format"),
                (("triangulate", "-", "--input-format", "xyz"), "step"),
                (("triangulate", self.brep, "-o", "-"), "--format"),
                (("triangulate", self.brep, "-o", "-", "--format", "xyz"), "ply"),
                (("triangulate", self.brep, "--format", "ply"), "-o"),
                (("triangulate", self.brep, "--min-an", "20"), "--min-an"),
                (("boolean", "-", "-", "--input-format", "stl"), "once"),
                (("curve", self.brep, "-o", "x.msh", "--deviation", "1"), "flat"),
                (("curve", self.brep, "--deviation", "1"), "-o"),
                (("curve", self.brep, "-o", "x.stl", "--deviation", "-1"), "deviation"),
                (("curve", self.brep, "-o", "x.inp", "--order", "3"), "order 1 and 2")):
            with self.subTest(arguments):
                status, out, err = run(*arguments)
                self.assertEqual((status, out), (2, ""))
                self.assertIn(word, err[-1])
        status, out, err = run("triangulate", self.brep, "-o", "-", "--format", "ply", "--json")
        self.assertEqual(status, 2)
        self.assertIn("--json", json.loads(out)["error"])

    def test_a_file_that_is_there_is_replaced_in_whole_or_not_at_all(self):
        output = os.path.join(self.folder, "kept.ply")
        with open(output, "w", encoding="ascii") as stream:
            stream.write("old")
        status, _, _ = run("triangulate", self.brep, "-o", output, "--chord-height", "1e-12")
        self.assertEqual(status, 2)
        with open(output, encoding="ascii") as stream:
            self.assertEqual(stream.read(), "old")
        link = os.path.join(self.folder, "link.ply")
        os.symlink(output, link)
        status, _, err = run("triangulate", self.brep, "-o", link)
        self.assertEqual(status, 0, err)
        self.assertTrue(os.path.islink(link))
        self.assertGreater(Mesh.Mesh(output).CountFacets, 0)

    def test_progress_at_a_terminal_only(self):
        slow = ("triangulate", self.brep, "--chord-height", "5e-4")
        begun = time.monotonic()
        status, out, shown = at_terminal(*slow)
        seconds = time.monotonic() - begun
        self.assertEqual(status, 0, shown)
        # Which stages it shows depends on how fast they are.
        self.assertRegex(shown, r"\] +\d+ %  [a-z]")
        self.assertNotIn(b" %  ", out)
        *_, line, last = shown.replace("\r\n", "\n").rstrip("\n").split("\n") + [""]
        self.assertEqual(last, "")
        # The line is taken away before the last words.
        self.assertIn("\r\x1b[K", line)
        self.assertTrue(line.rpartition("\x1b[K")[2].startswith("meshquality: "), line)
        self.assertLessEqual(shown.count("\r["), seconds / 0.2 + 2)
        _, _, err = run(*slow)
        self.assertNotIn(" %  ", "".join(err))

    def test_closed_standard_output_is_said(self):
        reader = subprocess.Popen(["true"], stdin=subprocess.PIPE)
        reader.wait()
        done = subprocess.run([COMMAND, "triangulate", self.brep, "-o", "-", "--format", "ply"],
                              stdin=subprocess.DEVNULL, stdout=reader.stdin,
                              stderr=subprocess.PIPE, text=True, timeout=60)
        reader.stdin.close()
        self.assertEqual(done.returncode, 1)
        self.assertIn("standard output was closed", done.stderr.splitlines()[-1])


class Api(unittest.TestCase):
    # What a command line has in another way: the shapes, callbacks, objects of a running FreeCAD.
    CALLED = {"volume": "volume_mesh", "to-solid": "to_solid"}  # functions with another name than the command
    ELSEWHERE = {
        "triangulate": {"shape", "progress", "cache"},
        "curve": {"shape_or_mesh", "shape", "progress"},
        "boolean": {"a", "b", "progress"},
        "improve": {"mesh", "progress"},
        "simplify": {"mesh", "progress"},
        "quality": {"mesh", "progress"},
        "measures": {"mesh"},
        "section": {"mesh", "point"},  # --point 0,0,0
        "to-solid": {"mesh", "facets", "progress"},  # a mesh in a file has facets only
        "certify": {"mesh", "progress"},
        "verify": {"certificate", "progress"},
        "thickness": {"source", "progress"},
        "clearance": {"bodies", "progress"},
        "draft": {"source", "progress"},
        "voids": {"source", "progress"},
        "deviation": {"points", "pairs", "scale", "align", "progress"},  # --mesh-scale, and words for align
        "offset": {"source", "progress"},
        "hollow": {"source", "progress"},
        "wrap": {"objects", "progress"},
        "cam": {"source", "progress"},
        "volume": {"shape", "walls", "progress"},  # --wall
        "adapt": {"problem", "shape", "progress", "order", "size_field", "strains", "values"},  # those of functions, and of the analysis' mesh
    }

    def test_every_option_of_the_api_is_there_under_its_name(self):
        commands = next(action.choices for action in parser.parser()._actions
                        if action.dest == "command")
        self.assertEqual(set(commands), {*self.ELSEWHERE, "batch"})
        for name, elsewhere in self.ELSEWHERE.items():
            flags = commands[name]._option_string_actions
            parameters = inspect.signature(getattr(mq, self.CALLED.get(name, name))).parameters
            for parameter in set(parameters) - elsewhere:
                with self.subTest(f"{name} {parameter}"):
                    action = flags["--" + parameter.replace("_", "-")]
                    default = parameters[parameter].default
                    must_be_given = default is inspect.Parameter.empty or (name, parameter) == ("boolean", "operation")
                    if not must_be_given:
                        self.assertEqual(action.default, default)

    def test_batch_takes_the_options_of_its_command(self):
        for name in parser.BATCHED:
            arguments = parser.parse(["batch", "in", "-o", "out", "--command", name])
            for option in parser.TABLES[name]:
                # What is not given of the bound on the distance is filled in by options.check.
                self.assertEqual(getattr(arguments, option.name),
                                 None if option.is_distance else option.default)

    def test_version(self):
        status, out, _ = run("--version")
        self.assertEqual((status, out), (0, "meshquality 0.1.0\n"))
