# SPDX-License-Identifier: LGPL-2.1-or-later
"""One bound on the distance, which cannot contradict itself, with one default everywhere."""

import hashlib
import json
import math
import os
import subprocess
import unittest
from unittest import mock

import FreeCAD
import helpers
import Part
from test_cli import run

import MeshQuality as mq
from MeshQuality import options
from MeshQuality.core.sources import convert
from MeshQuality.features import mesh_object, properties

DIAMETER, HEIGHT = 10.0, 30.0
DEFAULT = 0.003 * HEIGHT


def pin():
    return Part.makeCylinder(DIAMETER / 2, HEIGHT)


class Calls(unittest.TestCase):
    def test_the_default_is_relative(self):
        report = mq.triangulate(pin()).report
        self.assertAlmostEqual(report.chord_height_asked, DEFAULT)
        self.assertLessEqual(report.max_chord_height, DEFAULT)
        said = mq.triangulate(pin(), chord_height_relative=0.003).report
        self.assertEqual(report.triangles, said.triangles)
        values = options.check(options.CURVE, {})
        self.assertEqual((values["chord_height"], values["chord_height_relative"]), (None, 0.01))

    def test_there_may_be_none(self):
        for nothing in ("none", math.inf):
            report = mq.triangulate(pin(), chord_height=nothing).report
            self.assertEqual(report.chord_height_asked, 0.0)
            self.assertGreater(report.max_chord_height, DEFAULT)
            self.assertIn("no bound was requested", str(report))
        self.assertGreater(len(mq.curve(pin(), chord_height="none").elements), 0)

    def test_both_at_once_are_refused(self):
        for chord in (0.1, "none"):
            for call in (mq.triangulate, mq.curve):
                with self.assertRaisesRegex(mq.InvalidInput, "exclude each other"):
                    call(pin(), chord_height=chord, chord_height_relative=0.1)
        for wrong in ("None", "unbounded", "0.1", -math.inf, math.nan):
            with self.assertRaisesRegex(mq.InvalidInput, "chord_height = .*or 'none'"):
                mq.triangulate(pin(), chord_height=wrong)

    def test_reports_say_which_distance_it_is(self):
        mesh = mq.triangulate(pin(), chord_height=0.1)
        self.assertEqual(mesh.report.max_chord_height_to, "own face")
        self.assertIn("of a triangle from its own CAD face; requested at most 0.1 mm", str(mesh.report))
        measured = mq.quality(mesh.to_mesh(), pin())
        self.assertEqual(measured.max_chord_height_to, "nearest face")
        self.assertIn("largest distance from the nearest CAD face", str(measured))
        self.assertNotIn("requested", str(measured).split("nearest")[1])


class CommandLine(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        self.brep = os.path.join(self.folder, "pin.brep")
        pin().exportBrep(self.brep)

    def asked(self, *arguments):
        status, out, err = run("triangulate", self.brep, "--json", *arguments)
        self.assertEqual(status, 0, err)
        report = json.loads(out)
        self.assertEqual(report["max_chord_height_to"], "own face")
        return report["chord_height_asked"]

    def test_the_same_default_and_none(self):
        self.assertAlmostEqual(self.asked(), DEFAULT)
        self.assertEqual(self.asked("--chord-height", "none"), 0.0)
        self.assertEqual(self.asked("--chord-height", 0.25), 0.25)

    def test_what_makes_no_sense_ends_with_2(self):
        for arguments, words in ((("--chord-height", "0.1", "--chord-height-relative", "0.1"), "not allowed"),
                                 (("--chord-height", "some"), "neither a length in mm nor none"),
                                 (("--chord-height", "0"), "greater than 0 mm, or 'none'")):
            status, _, err = run("triangulate", self.brep, *arguments)
            self.assertEqual(status, 2)
            self.assertIn(words, err[-1])

    def test_texts_name_the_distance(self):
        output = os.path.join(self.folder, "pin.stl")
        _, first, _ = run("triangulate", self.brep, "-o", output, "--chord-height", "none")
        _, second, _ = run("quality", output, "--shape", self.brep)
        self.assertIn("own CAD face; no bound was requested", first)
        self.assertIn("nearest CAD face", second)
        for text in (first, second):
            self.assertNotRegex(text, "chord height .* at most")


class Objects(helpers.DocumentTest):
    def pin(self):
        return self.document.addObject("Part::Cylinder", "Pin")

    def made(self, **values):
        source = self.pin()
        source.Radius, source.Height = DIAMETER / 2, HEIGHT
        self.document.recompute()
        return mq.add_quality_mesh(source, **values)

    def check(self, obj, bound, chord, relative):
        self.assertEqual(obj.DistanceBound, bound)
        self.assertAlmostEqual(obj.ChordHeight.Value, chord)
        self.assertAlmostEqual(obj.ChordHeightRelative, relative)
        shown = [name for name in ("ChordHeight", "ChordHeightRelative")
                 if "Hidden" not in obj.getEditorMode(name)]
        self.assertEqual(shown, {"Absolute": ["ChordHeight"], "Relative": ["ChordHeightRelative"],
                                 "None": []}[bound])

    def test_what_is_given_is_chosen(self):
        self.check(self.made(), "Relative", 0, 0.003)
        self.check(self.made(chord_height=0.1), "Absolute", 0.1, 0)
        self.check(self.made(chord_height="none"), "None", 0, 0)
        self.check(mq.add_curved_mesh(self.made().Source), "Relative", 0, 0.01)
        self.assertFalse(hasattr(mq.add_improved_mesh(self.made()), "DistanceBound"))

    def test_update_replaces_the_bound(self):
        obj = self.made()
        for values, found in (({"chord_height": 0.1}, ("Absolute", 0.1, 0)),
                              ({"max_edge": 5.0}, ("Absolute", 0.1, 0)),
                              ({"chord_height_relative": 0.01}, ("Relative", 0, 0.01)),
                              ({"chord_height": None}, ("Relative", 0, 0.01)),
                              ({"chord_height": "none"}, ("None", 0, 0)),
                              ({"chord_height_relative": 0.02}, ("Relative", 0, 0.02))):
            mq.update(obj, **values)
            self.check(obj, *found)
            asked = found[1] or found[2] * HEIGHT
            self.assertAlmostEqual(obj.AskedChordHeight.Value, asked)
        with self.assertRaisesRegex(mq.InvalidInput, "exclude each other"):
            mq.update(obj, chord_height=0.1, chord_height_relative=0.1)
        self.check(obj, "Relative", 0, 0.02)

    def test_properties_choose_the_bound(self):
        obj = self.made()
        obj.ChordHeight = 0.2
        self.check(obj, "Absolute", 0.2, 0)
        obj.ChordHeightRelative = 0.01
        self.check(obj, "Relative", 0, 0.01)
        obj.DistanceBound = "Absolute"
        self.check(obj, "Absolute", 0.3, 0)
        obj.DistanceBound = "Relative"
        self.check(obj, "Relative", 0, 0.01)
        obj.DistanceBound = "None"
        self.check(obj, "None", 0, 0)
        obj.DistanceBound = "Relative"
        self.check(obj, "Relative", 0, 0.003)
        obj.ChordHeightRelative = 0
        self.check(obj, "None", 0, 0)
        obj.ChordHeight = 0.2
        obj.ChordHeight = 0
        self.check(obj, "None", 0, 0)
        self.document.recompute()
        self.assertEqual((obj.Status, obj.AskedChordHeight.Value), (mesh_object.UP_TO_DATE, 0.0))

    def test_undo_and_redo(self):
        obj = self.made()
        self.document.openTransaction("edit")
        obj.ChordHeight = 0.2
        self.document.recompute()
        self.document.commitTransaction()
        self.check(obj, "Absolute", 0.2, 0)
        self.document.undo()
        self.check(obj, "Relative", 0, 0.003)
        self.assertAlmostEqual(obj.AskedChordHeight.Value, DEFAULT)
        self.document.redo()
        self.check(obj, "Absolute", 0.2, 0)
        self.assertAlmostEqual(obj.AskedChordHeight.Value, 0.2)

    def test_saved_and_copied(self):
        for values, found in (({}, ("Relative", 0, 0.003)), ({"chord_height": 0.1}, ("Absolute", 0.1, 0)),
                              ({"chord_height": "none"}, ("None", 0, 0))):
            name = self.made(**values).Name
            self.reopen()
            obj = self.document.getObject(name)
            self.check(obj, *found)
            self.assertEqual(obj.Status, mesh_object.UP_TO_DATE)
            self.assertNotIn("Touched", obj.State)
            self.check(self.document.copyObject(obj), *found)

    def test_documents_of_older_versions(self):
        for values, chord, relative, bound in (
                ({"chord_height": "none"}, 0, 0, "None"), ({"chord_height": 0.1}, 0.1, 0, "Absolute"),
                ({"chord_height_relative": 0.01}, 0, 0.01, "Relative")):
            obj = self.made(**values)
            held = obj.Fingerprint
            obj.removeProperty("DistanceBound")
            obj.ChordHeight, obj.ChordHeightRelative = chord, relative
            obj.Proxy.onDocumentRestored(obj)
            self.check(obj, bound, chord, relative)
            self.assertEqual(properties.options_of(obj, obj.Proxy.OPTIONS),
                             options.check(options.TRIANGULATE, values))
            work = obj.Proxy.work_on([obj.Source], properties.options_of(obj, obj.Proxy.OPTIONS), obj)
            self.assertEqual(work.fingerprint, held)

    def test_older_curved_meshes_keep_their_default(self):
        obj = mq.add_curved_mesh(self.made().Source)
        obj.removeProperty("DistanceBound")
        obj.ChordHeightRelative = 0
        obj.Proxy.onDocumentRestored(obj)
        self.check(obj, "Relative", 0, 0.01)

    def test_fingerprints_are_those_of_older_versions(self):
        shape = pin()
        for given, held in (({"chord_height": "none"}, (None, None)), ({"chord_height": 0.1}, (0.1, None)),
                            ({"chord_height_relative": 0.01}, (None, 0.01))):
            values = options.check(options.TRIANGULATE, given)
            before = {**values, "chord_height": held[0], "chord_height_relative": held[1],
                      "insertion": "off-centre", "growth": values["growth_rate"],
                      "polish": values["refine_samples"]}
            for later in "growth_rate", "refine_samples", "size_field", "metric", "max_stretching":
                del before[later]
            digest = hashlib.sha256(convert.shape_text(shape))
            digest.update(json.dumps(before, sort_keys=True).encode())
            self.assertEqual(mesh_object.fingerprint_of(shape, values), digest.hexdigest())


class Failures(helpers.DocumentTest):
    def test_the_status_says_what_failed_until_it_is_mended(self):
        obj = mq.add_quality_mesh(self.box())
        obj.MinAngle = 50
        self.document.recompute()
        self.assertIn("Invalid", obj.State)
        self.assertTrue(obj.Status.startswith("failed: min_angle = 50"), obj.Status)
        self.assertIn("min_angle = 50", obj.getStatusString())
        obj.MinAngle = 25
        self.document.recompute()
        self.assertEqual(obj.Status, mesh_object.UP_TO_DATE)
        self.assertNotIn("Invalid", obj.State)

    def test_an_error_that_nobody_expected_is_no_success_either(self):
        obj = mq.add_quality_mesh(self.box())
        with mock.patch.object(type(obj.Proxy), "work_on", side_effect=RuntimeError("gone wrong")):
            obj.MaxEdge = 3
            self.document.recompute()
            self.assertEqual(obj.Status, "failed: gone wrong")
            with self.assertRaisesRegex(RuntimeError, "gone wrong"):
                mq.update(obj)
        self.assertIn("Invalid", obj.State)

    def test_no_traceback_is_printed(self):
        script = os.path.join(self.folder, "fail.py")
        with open(script, "w", encoding="utf-8") as stream:
            stream.write("import FreeCAD, MeshQuality as mq\n"
                         "document = FreeCAD.newDocument()\n"
                         "box = document.addObject('Part::Box', 'Box')\n"
                         "document.recompute()\n"
                         "mesh = mq.add_quality_mesh(box)\n"
                         "mesh.MinAngle = 50\n"
                         "document.recompute()\n"
                         "print('Invalid' in mesh.State)\n")
        done = subprocess.run(["freecadcmd", "-P", os.path.join(helpers.ROOT, "Mod"), script],
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=100,
                              check=False)
        said = done.stdout + done.stderr
        self.assertIn("True", said)
        self.assertIn("min_angle = 50.0 is not allowed", said)
        self.assertNotIn("Traceback", said)
        self.assertNotIn(".py", said.replace(script, ""))


class Local(helpers.DocumentTest):
    """Sizes of sub-elements of what a container or a link holds."""

    def setUp(self):
        super().setUp()
        self.part = self.document.addObject("App::Part", "Asm")
        inner = self.document.addObject("App::Part", "Inner")
        self.part.addObject(inner)
        inner.Placement.Base.z = 50
        for i, holder in ((1, self.part), (2, self.part), (3, inner)):
            box = self.document.addObject("Part::Box", f"B{i}")
            box.Placement = FreeCAD.Placement(FreeCAD.Vector(20 * i, 0, 0), FreeCAD.Rotation(10 * i, 0, 0))
            holder.addObject(box)
        self.part.Placement.Base.x = 7
        self.document.recompute()

    def same_face(self, source, name, held):
        index = int(convert.resolve_sizes(source, {name: 1.0}).popitem()[0][4:]) - 1
        found = convert.shape_of(source).Faces[index]
        wanted = Part.getShape(source, held, needSubElement=True)
        self.assertLess((found.CenterOfMass - wanted.CenterOfMass).Length, 1e-9)

    def test_each_face_is_found(self):
        for path in ("B1", "B2", "Inner.B3"):
            for i in range(1, 7):
                self.same_face(self.part, f"{path}.Face{i}", f"{path}.Face{i}")
        self.assertEqual(convert.resolve_sizes(self.part, {"B2.Face6": 0.5, "Face1": 1.0}),
                         {"Face18": 0.5, "Face1": 1.0})
        self.assertEqual(convert.resolve_sizes(self.part, {"B2.Edge1": 0.5, "B2.Vertex1": 0.5}),
                         {"Edge25": 0.5, "Vertex17": 0.5})

    def test_the_smaller_of_two_for_one_face_holds(self):
        self.assertEqual(convert.resolve_sizes(self.part, {"B2.Face6": 0.5, "Face18": 0.2}), {"Face18": 0.2})

    def test_a_link(self):
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = self.part
        link.Placement.Base.y = 100
        self.document.recompute()
        self.same_face(link, "Inner.B3.Face2", "Inner.B3.Face2")

    def test_meshes_are_fine_there_only(self):
        mesh = mq.triangulate(self.part, local_sizes={"B2.Face6": 0.5})
        counts = [int((mesh.triangle_face == face).sum()) for face in range(18)]
        self.assertGreater(counts[17], 500)
        self.assertEqual([face for face, count in enumerate(counts) if count > 500], [17])
        obj = mq.add_quality_mesh(self.part, local_sizes={"B2.Face6": 0.5})
        self.assertEqual((obj.Triangles, obj.LocalSizes), (len(mesh.triangles), "B2.Face6=0.5"))

    def test_what_is_not_there_is_named(self):
        for name in ("B9.Face1", "B2.Face7", "Inner.B2.Face1"):
            with self.assertRaisesRegex(mq.InvalidInput, f"{name}.*'Asm' does not hold"):
                mq.triangulate(self.part, local_sizes={name: 0.5})
        with self.assertRaisesRegex(mq.InvalidInput, "B2.Face1, but the shape does not hold"):
            mq.triangulate(convert.shape_of(self.part), local_sizes={"B2.Face1": 0.5})
        for name in ("B2.", ".Face1", "B2.Solid1", "B 2.Face1"):
            with self.assertRaisesRegex(mq.InvalidInput, "sub-elements"):
                mq.triangulate(self.part, local_sizes={name: 0.5})
