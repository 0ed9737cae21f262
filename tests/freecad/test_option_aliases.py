# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options and choices that were renamed: the older names go on working everywhere."""

import inspect
import json
import os
import tempfile
import unittest
from unittest import mock

import FreeCAD
import Part

import MeshQuality as mq
from MeshQuality import options
from MeshQuality.cli import parser
from MeshQuality.features import aliases, mesh_object, properties

OLDER = {"insertion": "paper", "growth": 1.5, "polish": False}
PRESENT = {"insertion": "circumcentre", "growth_rate": 1.5, "refine_samples": False}


def pin():
    return Part.makeCylinder(5, 10)


class Calls(unittest.TestCase):
    def test_older_keywords_and_choices_mean_the_same(self):
        for older, present in (({"insertion": "paper"}, {"insertion": "circumcentre"}),
                               ({"growth": 1.3}, {"growth_rate": 1.3}),
                               ({"method": "star", "polish": False}, {"method": "star", "refine_samples": False})):
            meshes = [mq.triangulate(pin(), **values) for values in (older, present)]
            self.assertEqual(meshes[0].vertices.tobytes(), meshes[1].vertices.tobytes(), older)
        self.assertEqual(mq.curve(pin(), straighten=True).report.invalid, 0)

    def test_help_has_the_present_names_alone(self):
        names = inspect.signature(mq.triangulate).parameters
        self.assertLessEqual(set(PRESENT), set(names))
        self.assertFalse({"growth", "polish"} & set(names))
        self.assertIn("straighten_invalid", inspect.signature(mq.curve).parameters)

    def test_both_names_at_once_are_refused(self):
        with self.assertRaisesRegex(mq.InvalidInput, "growth is the older name of growth_rate"):
            mq.triangulate(pin(), growth=1.3, growth_rate=1.4)

    def test_messages_name_the_present_choices(self):
        with self.assertRaisesRegex(mq.InvalidInput, "one of off-centre, circumcentre$"):
            mq.triangulate(pin(), insertion="cheap")

    def test_fingerprints_are_those_of_older_versions(self):
        present = options.check(options.TRIANGULATE, PRESENT)
        self.assertEqual(options.check(options.TRIANGULATE, OLDER), present)
        written = json.loads(options.hashed(present))
        self.assertEqual({name: written[name] for name in OLDER}, OLDER)
        self.assertFalse({"growth_rate", "refine_samples"} & set(written))
        self.assertIs(json.loads(options.hashed(options.check(options.CURVE, {})))["straighten"], False)


class CommandLine(unittest.TestCase):
    def test_older_flags(self):
        parsed = parser.parse(["triangulate", "a.step", "--growth", "1.5", "--no-polish"])
        self.assertEqual((parsed.growth_rate, parsed.refine_samples), (1.5, False))
        parsed = parser.parse(["triangulate", "a.step", "--growth-rate", "1.5"])
        self.assertEqual((parsed.growth_rate, parsed.refine_samples), (1.5, True))
        self.assertIs(parser.parse(["curve", "a.step", "--straighten"]).straighten_invalid, True)
        self.assertIs(parser.parse(["curve", "a.step"]).straighten_invalid, False)

    def test_help_shows_the_present_ones_alone(self):
        commands = next(action.choices for action in parser.parser()._actions if action.dest == "command")
        text = commands["triangulate"].format_help()
        self.assertIn("--growth-rate ", text)
        self.assertNotIn("--growth ", text)
        self.assertNotIn("polish", text)


class Documents(unittest.TestCase):
    def setUp(self):
        self.document = FreeCAD.newDocument()
        self.source = self.document.addObject("Part::Feature", "Pin")
        self.source.Shape = pin()

    def tearDown(self):
        FreeCAD.closeDocument(self.document.Name)

    def values(self, obj):
        found = properties.options_of(obj, obj.Proxy.OPTIONS)
        return {name: found[name] for name in PRESENT}

    def test_older_names_when_adding_and_updating(self):
        obj = mq.add_quality_mesh(self.source, **OLDER)
        self.assertEqual(self.values(obj), PRESENT)
        mq.update(obj, growth=1.25, insertion="off-centre")
        mq.update(obj, insertion="paper")
        self.assertEqual(self.values(obj), {**PRESENT, "growth_rate": 1.25})
        self.assertEqual(obj.Status, mesh_object.UP_TO_DATE)

    def test_properties_by_both_names(self):
        obj = mq.add_quality_mesh(self.source)
        obj.Growth, obj.Polish, obj.Insertion = 1.5, False, "paper"
        self.assertEqual((obj.GrowthRate, obj.RefineSamples, obj.Insertion), (1.5, False, "circumcentre"))
        obj.GrowthRate, obj.RefineSamples = 1.25, True
        self.assertEqual((obj.Growth, obj.Polish), (1.25, True))
        self.assertEqual(obj.getEditorMode("Growth"), ["Hidden"])
        self.assertEqual(obj.getEditorMode("GrowthRate"), [])

    def test_undo_brings_both_back(self):
        self.document.UndoMode = 1
        obj = mq.add_quality_mesh(self.source)
        self.document.openTransaction("Grow")
        obj.Growth = 1.5
        self.document.commitTransaction()
        self.document.undo()
        self.assertEqual((obj.Growth, obj.GrowthRate), (0.0, 0.0))

    def test_documents_of_older_versions(self):
        obj = mq.add_quality_mesh(self.source, **OLDER)
        held = obj.Fingerprint
        for name in ("GrowthRate", "RefineSamples"):
            obj.removeProperty(name)
        for name in ("Growth", "Polish"):
            obj.setEditorMode(name, 0)
        with mock.patch.object(aliases, "follow_change"):  # what is read from a file is left as it is
            obj.Insertion = ["off-centre", "paper"]
            obj.Insertion = "paper"
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "older.FCStd")
            self.document.saveAs(path)
            FreeCAD.closeDocument(self.document.Name)
            self.document = FreeCAD.openDocument(path)
        obj = self.document.getObject("QualityMesh")
        self.assertEqual(self.values(obj), PRESENT)
        self.assertEqual((obj.Growth, obj.Polish, obj.getEditorMode("Polish")), (1.5, False, ["Hidden"]))
        self.assertEqual((obj.Status, obj.Fingerprint), (mesh_object.UP_TO_DATE, held))
        self.assertNotIn("Touched", obj.State)
