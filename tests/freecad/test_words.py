# SPDX-License-Identifier: LGPL-2.1-or-later
"""One word for one thing, wherever a user reads it; see docs/use/words.md."""

import re

import FreeCAD
import helpers
import Mesh
import Part

import MeshQuality as mq
from MeshQuality import options, phrases
from MeshQuality.core.certify import verdict
from MeshQuality.features import mesh_object


class MaxDeviation(helpers.DocumentTest):
    def test_every_bound_on_a_distance_has_one_title(self):
        tables = (options.TRIANGULATE, options.CURVE, options.BOOLEAN, options.IMPROVE, options.offset.OFFSET, options.offset.HOLLOW,
                  options.wrap.WRAP, options.inspection.THICKNESS, options.inspection.CLEARANCE, options.inspection.DRAFT)
        titles = {option.title for table in tables for option in table if option.name in ("chord_height", "tolerance")}
        self.assertEqual(titles, {"Max. deviation"})

    def test_the_line_of_a_boolean_says_it(self):
        result = mq.boolean(Part.makeBox(10, 10, 10), Part.makeSphere(6), "union", tolerance=0.1)
        line = verdict.line("Union", result.report, verdict.of_boolean(result))
        self.assertRegex(line, r"max\. deviation [\d.]+ mm; all requested limits are met")
        self.assertNotIn("error bound", line + str(result.report))

    def test_a_property_shows_what_the_editor_rounds_to_nothing(self):
        sphere = self.document.addObject("Part::Sphere", "Sphere")
        self.document.recompute()
        mesh = mq.add_quality_mesh(sphere, chord_height=0.003, min_angle=1)
        measured = re.fullmatch(r"(0\.00\d+) mm \(requested 0\.003 mm\)", mesh.DeviationInFull)
        self.assertAlmostEqual(float(measured[1]), mesh.MaxChordHeight.Value, 6)
        mq.update(mesh, chord_height_relative=0.003)
        self.assertTrue(mesh.DeviationInFull.endswith("(requested 0.03 mm = 0.003 of the size)"), mesh.DeviationInFull)
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        union = mq.add_boolean(box, mesh, tolerance=0.05)
        self.assertRegex(union.DeviationInFull, r"^[\d.e-]+ mm \(requested 0\.05 mm\)$")


class Told(helpers.DocumentTest):
    def test_bodies_that_overlap_get_a_hint(self):
        both = Part.makeCompound([Part.makeBox(10, 10, 10), Part.makeBox(10, 10, 10, FreeCAD.Vector(5, 5, 5))])
        for shape, hinted in ((both, True), (Part.makeBox(1, 1, 1), False)):
            mesh = mq.triangulate(shape, overlap="allow")
            line = verdict.line("Both", mesh.report, verdict.of_triangulation(mesh, True, {"overlap": "allow"}))
            self.assertEqual("Join bodies that touch (More options), Mesh Boolean or Wrap." in line, hinted, line)

    def test_many_exempt_triangles_do_not_fill_the_editor(self):
        sheet = Mesh.Mesh([[(x, 0, 0), (x + 1, 0, 0), (x + 0.5, 0.05, 0)] for x in range(0, 200, 2)])
        source = self.document.addObject("Mesh::Feature", "Slivers")
        source.Mesh = sheet
        improved = mq.add_improved_mesh(source)
        self.assertEqual((improved.ExemptCount, len(improved.Exempt)), (100, 100))
        self.assertIn("Hidden", improved.getEditorMode("Exempt"))
        self.reopen()
        self.assertIn("Hidden", self.document.getObject(improved_name(self.document)).getEditorMode("Exempt"))
        part = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        self.assertNotIn("Hidden", mq.add_quality_mesh(part).getEditorMode("Exempt"))

    def test_a_copy_without_its_source_says_so(self):
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        mesh = mq.add_quality_mesh(box)
        other = FreeCAD.newDocument("Other")
        self.names.append(other.Name)
        copy = other.copyObject(mesh, False)
        other.recompute()
        self.assertIsNone(copy.Source)
        self.assertEqual(copy.Status, mesh_object.SOURCE_DELETED)


class Errors(helpers.DocumentTest):
    """What a user of the window reads names objects, not the words of scripts."""

    def objects(self):
        made = {name: self.document.addObject(kind, name) for name, kind in (
            ("Nothing", "Part::Feature"), ("Wire", "Part::Feature"), ("Empty", "Mesh::Feature"), ("Sheet", "Mesh::Feature"))}
        made["Wire"].Shape = Part.makePolygon([(0, 0, 0), (1, 0, 0), (1, 1, 0)])
        made["Sheet"].Mesh = Mesh.createPlane(5, 5)
        return made

    def test_errors_name_the_object_and_without_words_of_scripts(self):
        box, objects = self.box(), self.objects()
        for name, obj in objects.items():
            for call in (lambda o=obj: mq.add_boolean([box, o], operation="union", method="exact"), lambda o=obj: mq.add_offset(o, 1.0),
                         lambda o=obj: mq.add_boolean([o, box], operation="union"), lambda o=obj: mq.add_hollow(o, 1.0)):
                with self.subTest(name), self.assertRaises(mq.Error) as caught:
                    call()
                said = str(caught.exception)
                self.assertNotRegex(said, r"Mesh\.Mesh|SurfaceMesh|\(V, F\)|operand [A-Z]\b|\([A-Z] is ", said)
                self.assertTrue(said.startswith(f"'{name}' "), said)

    def test_two_of_one_label_are_told_apart(self):
        settings = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Document")
        settings.SetBool("DuplicateLabels", True)
        self.addCleanup(settings.RemBool, "DuplicateLabels")
        first, second = self.document.addObject("Mesh::Feature", "First"), self.box()
        first.Mesh, first.Label, second.Label = Mesh.createPlane(5, 5), "Same", "Same"
        with self.assertRaisesRegex(mq.Error, r"^'Same' \(operand A\) is an open"):
            mq.add_boolean([first, second], operation="union", method="exact")

    def test_the_error_keeps_its_phrase_for_other_languages(self):
        self.document.addObject("Mesh::Feature", "Flat").Mesh = Mesh.Mesh([[(0, 0, 0), (1, 0, 0), (2, 0, 0)]])
        with self.assertRaises(mq.Error) as caught:
            mq.add_boolean([self.box(), self.document.getObject("Flat")], operation="union")
        self.assertEqual(phrases.text_of(caught.exception).phrase, phrases.CORE_ERRORS["no_enclosed_volume"])
        self.assertTrue(str(caught.exception).startswith("'Flat' "), caught.exception)


def improved_name(document):
    return next(obj.Name for obj in document.Objects if "ExemptCount" in obj.PropertiesList)
