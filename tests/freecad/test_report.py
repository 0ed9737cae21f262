# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports: what pages hold, that they need no other file, pictures, the command line, and batches."""

import base64
import hashlib
import html.parser
import json
import os
import re
import shutil
import struct
import unittest
import zlib
from unittest import mock

import helpers
import Mesh
import numpy as np
import Part
import test_cli

import MeshQuality as mq
from MeshQuality.core.reporting import picture, printing


class Page(html.parser.HTMLParser):
    """Counts the tags of a page, gathers its text and the sources of its images."""

    def __init__(self, path):
        super().__init__()
        self.open, self.texts, self.images, self.links = [], [], [], []
        with open(path, encoding="utf-8") as stream:
            self.source = stream.read()
        self.feed(self.source)
        self.text = " ".join(" ".join(self.texts).split())

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag == "img":
            self.images.append(attributes["src"])
        if tag == "a":
            self.links.append(attributes["href"])
        if tag not in ("img", "meta", "br", "line", "rect"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        if tag not in ("line", "rect"):
            assert self.open.pop() == tag, tag

    def handle_data(self, data):
        self.texts.append(data)


def pixels_of(png):
    """uint8 (height, width, 3) of the PNG that the product writes."""
    width, height = struct.unpack(">II", png[16:24])
    data, at = b"", 8
    while at < len(png):
        size, kind = struct.unpack(">I4s", png[at:at + 8])
        body = png[at + 8:at + 8 + size]
        assert struct.unpack(">I", png[at + 8 + size:at + 12 + size])[0] == zlib.crc32(kind + body)
        data += body if kind == b"IDAT" else b""
        at += 12 + size
    rows = np.frombuffer(zlib.decompress(data), dtype=np.uint8).reshape(height, 1 + 3 * width)
    return rows[:, 1:].reshape(height, width, 3)


class Pictures(unittest.TestCase):
    def square(self, z, size=10.0):
        a, b, c, d = ((x * size, y * size, z) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)))
        return [[a, b, c], [a, c, d]]

    def test_the_nearer_one_hides_the_other(self):
        corners = np.array(self.square(0.0) + self.square(1.0, 5.0))
        colours = np.array([(1, 0, 0)] * 2 + [(0, 0, 1)] * 2, dtype=float)
        for direction, middle in (((0, 0, 1), 2), ((0, 0, -1), 0)):
            pixels = pixels_of(picture.png(corners, colours, (200, 100), direction, edges=False))
            self.assertEqual(pixels.shape, (100, 200, 3))
            self.assertEqual(pixels[50, 100].argmax(), middle)
            self.assertEqual(pixels[50, 5].tolist(), [255, 255, 255])
            self.assertEqual(pixels[10, 100].argmax(), 0)

    def test_areas_are_those_of_the_projection(self):
        """A square of 20 in a window of 40: a quarter of the shorter side squared, to the pixels at its border."""
        corners, colours = np.array(self.square(0.0)), np.zeros((2, 3))
        pixels = pixels_of(picture.png(corners, colours, (200, 100), (0, 0, 1), (np.zeros(3), 40.0), edges=False))
        self.assertEqual(int((pixels.sum(axis=2) == 0).sum()), 50 * 50)

    def test_triangles_of_all_sizes_leave_no_gap(self):
        """A square of 90,000 small triangles is seen as that of two."""
        n = 213
        grid = np.stack(np.meshgrid(np.linspace(-10, 10, n), np.linspace(-10, 10, n)), axis=-1)
        grid = np.concatenate([grid, np.zeros((n, n, 1))], axis=2)
        a, b, c, d = grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]
        fine = np.concatenate([np.stack(three, axis=2).reshape(-1, 3, 3) for three in ((a, b, c), (a, c, d))])
        shown = [pixels_of(picture.png(corners, np.tile((0.2, 0.4, 0.9), (len(corners), 1)), (300, 300), (1, 1, 2), edges=False))
                 for corners in (fine, np.array(self.square(0.0)))]
        np.testing.assert_array_equal(*shown)

    def test_lit_triangles_and_edges(self):
        corners, colours = np.array(self.square(0.0)), np.ones((2, 3))
        pixels = pixels_of(picture.png(corners, colours, (200, 200), (0, 0, 1), lit=np.array([True, False])))
        magenta = (pixels[..., 1] < 60) & (pixels[..., 0] > 200)
        self.assertTrue(0.3 < magenta.mean() < 0.5)
        dark = pixels.sum(axis=2) < 450
        self.assertTrue(0.005 < dark.mean() < 0.1)


class Reports(helpers.DocumentTest):
    def page(self, source, **values):
        path = os.path.join(self.folder, "report.html")
        mq.write_report(source, path, **values)
        page = Page(path)
        self.assertEqual(page.open, [])
        # Nothing of it is elsewhere.
        self.assertEqual(re.findall(r'(?:src|href)="(?!data:)', page.source), [])
        self.assertNotIn("http", page.source)
        for image in page.images:
            pixels = pixels_of(base64.b64decode(image.removeprefix("data:image/png;base64,")))
            self.assertTrue(0.0001 < (pixels.sum(axis=2) < 700).mean() < 1.0)
        return page

    def test_a_quality_mesh_with_its_shape(self):
        shape = Part.makeCylinder(5, 20)
        mesh = mq.triangulate(shape, chord_height=0.05, min_angle=28)
        page = self.page(mesh, shape=shape)
        self.assertIn("All requested limits are met", page.text)
        for said in (f"{mesh.report.triangles:,}", f"{mesh.report.min_angle:.5g}°", "28°", "0.05 mm", "Face1", "Face3", mq.__version__):
            self.assertIn(said, page.text)
        digest = hashlib.sha256(np.ascontiguousarray(mesh.vertices).tobytes() + np.ascontiguousarray(mesh.triangles).tobytes())
        self.assertIn(digest.hexdigest(), page.text)
        self.assertEqual(len(page.images), 3)

    def test_exempt_places_have_pictures_and_reasons(self):
        wedge = Part.makePolygon([(0, 0, 0), (20, 0, 0), (20, 2, 0), (0, 0, 0)])
        mesh = mq.triangulate(Part.Face(wedge).extrude(helpers.FreeCAD.Vector(0, 0, 5)), min_angle=30)
        self.assertTrue(mesh.report.exempt)
        page = self.page(mesh)
        self.assertIn("Target not met", page.text)
        self.assertIn("Places", page.text)
        self.assertGreaterEqual(len(page.images), 3)
        self.assertIn(str(dict(mesh.report.exempt_reasons)[mesh.report.exempt[0][0]].message)[:20], page.text)

    def test_inspections(self):
        shape = Part.makeBox(20, 20, 5).cut(Part.makeBox(10, 10, 3, helpers.FreeCAD.Vector(9, 9, -1)))
        for found, said in ((mq.thickness(shape, min_thickness=2.0, tolerance=0.1), "Target not met"), (mq.thickness(shape, tolerance=0.1), "No limits were requested"),
                            (mq.draft(shape), "Draft"),
                            (mq.deviation(mq.triangulate(Part.makeSphere(5), chord_height=0.3), Part.makeSphere(5), tolerance=0.01), "mm"),
                            (mq.deviation(np.random.default_rng(1).normal(size=(100, 3)), Part.makeSphere(1)), "Deviation from the part")):
            self.assertIn(said, self.page(found).text)

    def test_volumes(self):
        mesh = mq.curve(Part.makeBox(2, 3, 4), order=2, volume=True)
        page = self.page(mesh)
        self.assertIn(f"{len(mesh.tetrahedra):,} tetrahedra", page.text)

    def test_objects_of_the_document(self):
        source = self.document.addObject("Part::Feature", "Bracket & <co>")
        source.Shape = Part.makeCylinder(5, 20)
        self.document.recompute()
        mesh = mq.add_quality_mesh(source, min_angle=27)
        thinner = self.document.addObject("Part::Cylinder", "Thinner")
        thinner.Radius, thinner.Height = 4.9, 20
        self.document.recompute()
        plain = self.document.addObject("Mesh::Feature", "Plain")
        plain.Mesh = Mesh.createSphere(5.0, 20)
        objects = {mesh: ("27°", "All requested limits are met"), plain: ("No limits were requested",),
                   mq.add_simplified_mesh(mesh): ("triangles are left",), mq.add_curved_mesh(source, volume=True): ("tetrahedra",),
                   mq.add_deviation(mesh, thinner, tolerance=0.01): ("Target not met", "Deviation from the part"),
                   mq.add_inspection(source, min_thickness=1.0): ("All requested limits are met", "Wall thickness")}
        for obj, said in objects.items():
            page = self.page(obj)
            self.assertIn(obj.Label, page.text)
            for words in said:
                self.assertIn(words, page.text)
        self.assertNotIn("<co>", page.source)

    def test_what_has_no_report(self):
        path = os.path.join(self.folder, "report.html")
        for wrong in (self.box(), 3, np.zeros((2, 3)), (np.zeros((0, 3)), np.zeros((0, 3), dtype=np.int32))):
            with self.assertRaises(mq.InvalidInput):
                mq.write_report(wrong, path)
        mesh = mq.triangulate(Part.makeBox(1, 2, 3))
        with self.assertRaisesRegex(mq.InvalidInput, "a report is .html"):
            mq.write_report(mesh, os.path.join(self.folder, "report.txt"))
        with self.assertRaisesRegex(mq.IoError, "nowhere"):
            mq.write_report(mesh, os.path.join(self.folder, "nowhere", "report.html"))
        self.assertFalse(os.path.exists(path))


class Printed(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        self.mesh, self.path = mq.triangulate(Part.makeBox(1, 2, 3)), os.path.join(self.folder, "report.pdf")

    def with_browser(self, lines):
        """A program in place of a browser."""
        program = os.path.join(self.folder, "browser")
        with open(program, "w", encoding="utf-8") as stream:
            stream.write("#!/bin/sh\nfor last; do case $last in --print-to-pdf=*) out=${last#--print-to-pdf=};; esac; done\n" + lines)
        os.chmod(program, 0o755)
        return mock.patch.dict(os.environ, {printing.VARIABLE: program})

    def test_the_browser_gets_the_page(self):
        with self.with_browser('page=$(echo "$last" | sed s,file://,,)\n(printf %%PDF-; cat "$page") > "$out"\n'):
            mq.write_report(self.mesh, self.path)
        with open(self.path, encoding="utf-8") as stream:
            self.assertRegex(stream.read(), "(?s)^%PDF-<!DOCTYPE html>.*Smallest angle.*</html>")

    def test_what_does_not_print_is_said_and_leaves_no_file(self):
        for lines, said in (("exit 7\n", "has not printed the report, and ended with 7"), ('echo no > "$out"\n', "ended with 0")):
            with self.with_browser(lines), self.assertRaisesRegex(mq.IoError, said):
                mq.write_report(self.mesh, self.path)
        with mock.patch.dict(os.environ, {printing.VARIABLE: "no-such-browser"}), self.assertRaisesRegex(mq.IoError, "install one, name it in"):
            mq.write_report(self.mesh, self.path)
        with mock.patch.object(printing.shutil, "which", lambda name: None), self.assertRaisesRegex(mq.IoError, "none of Chromium"):
            mq.write_report(self.mesh, self.path)
        self.assertEqual([name for name in os.listdir(self.folder) if name.startswith("report")], [])

    @unittest.skipUnless(any(map(shutil.which, printing.BROWSERS)), "no browser is installed")
    def test_a_real_browser(self):
        part = os.path.join(self.folder, "part.brep")
        Part.makeCylinder(5, 20).exportBrep(part)
        status, _, lines = test_cli.run("triangulate", part, "-o", os.path.join(self.folder, "part.stl"), "--report", self.path)
        self.assertEqual(status, 0, lines)
        with open(self.path, "rb") as stream:
            content = stream.read()
        self.assertTrue(content.startswith(b"%PDF-") and b"%%EOF" in content[-20:])
        self.assertGreater(content.count(b"/Subtype /Image"), 2)  # the pictures


class CommandLine(helpers.DocumentTest):
    def test_pages_beside_meshes(self):
        part, mesh = os.path.join(self.folder, "part.brep"), os.path.join(self.folder, "part.stl")
        Part.makeCylinder(5, 20).exportBrep(part)
        first, second = (os.path.join(self.folder, name) for name in ("made.html", "measured.html"))
        status, _, lines = test_cli.run("triangulate", part, "-o", mesh, "--min-angle", 29, "--report", first)
        self.assertEqual(status, 0, lines)
        self.assertIn(f"report in {first}", lines[-1])
        self.assertIn("29°", Page(first).text)
        status, _, lines = test_cli.run("thickness", part, "--min-thickness", 100, "--report", second, "--strict")
        self.assertEqual(status, 3, lines)
        self.assertIn("Target not met", Page(second).text)
        status, _, lines = test_cli.run("triangulate", part, "--report", os.path.join(self.folder, "a.txt"))
        self.assertEqual((status, "a report is .html" in lines[-1]), (2, True))

    def test_a_batch_has_a_page_with_links(self):
        parts, out = os.path.join(self.folder, "parts"), os.path.join(self.folder, "out")
        os.makedirs(os.path.join(parts, "sub"))
        Part.makeBox(1, 2, 3).exportBrep(os.path.join(parts, "box.brep"))
        Part.makeSphere(2).exportBrep(os.path.join(parts, "sub", "ball & co.brep"))
        status, _, lines = test_cli.run("batch", parts, "-o", out, "--reports", "--jobs", 1)
        self.assertEqual(status, 0, lines)
        page = Page(os.path.join(out, "report.html"))
        self.assertIn("reports/sub/ball%20%26%20co.brep.html", page.links)
        for link in ("reports/box.brep.html", "reports/sub/ball & co.brep.html"):
            self.assertIn("All requested limits are met", Page(os.path.join(out, link)).text)
        with open(os.path.join(out, "parts.jsonl"), encoding="utf-8") as stream:
            self.assertEqual({json.loads(line)["page"] for line in stream if '"page"' in line},
                             {"reports/box.brep.html", "reports/sub/ball & co.brep.html"})
