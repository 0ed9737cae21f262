# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whatever the window says of lengths is in the user's units; documents stay in mm."""

import re

import FreeCADGui
import gui_helpers
import Part
from PySide import QtCore, QtGui

import MeshQuality as mq
from MeshQuality.features import hollow
from MeshQuality.gui import commands, preferences, quantities
from MeshQuality.gui.panels import quality_panel
from MeshQuality.gui.translation import translated, translated_certificate

# Samples alone, without anything that keeps the distance.
ROUGH = {"method": "star", "refine_samples": False, "chord_height": 0.01}


class UnitsTest(gui_helpers.PanelTest):
    def setUp(self):
        super().setUp()
        self.addCleanup(gui_helpers.use_units, gui_helpers.MM)
        gui_helpers.use_units(gui_helpers.INCHES)

    def use_german_numbers(self):
        before = QtCore.QLocale()
        QtCore.QLocale.setDefault(QtCore.QLocale("de_DE"))
        self.addCleanup(QtCore.QLocale.setDefault, before)

    def cylinder(self):
        source = self.document.addObject("Part::Feature", "Cylinder")
        source.Shape = Part.makeCylinder(5, 10)
        self.document.recompute()
        return source

    def certificate(self, obj):
        """What the panel of an object says of its certificate."""
        panel = commands.panel_of(obj)
        FreeCADGui.Control.showDialog(panel)
        gui_helpers.wait()
        return panel, panel.certificate.text.text()


class Said(UnitsTest):
    def test_the_volume_that_a_hollow_saves(self):
        obj = mq.add_hollow(self.cylinder(), 1.0)
        inches = obj.HollowVolume.Value / 25.4**3
        self.assertRegex(translated(obj.Proxy.told(obj)), rf"it saves {inches:.3g}\d? in³, 51\.2 % of the volume")
        self.assertIn(" mm³, ", obj.Proxy.told(obj))

    def test_the_certificate(self):
        obj = mq.add_quality_mesh(self.cylinder(), **ROUGH)
        self.assertIn("max. deviation 0.0171 mm (requested 0.01 mm), triangle", obj.Certificate)
        panel, said = self.certificate(obj)
        self.assertIn("max. deviation 0.000673 in (requested 0.000394 in), triangle", said)
        self.assertNotIn("mm", said)
        self.narrow(panel, "panel_missed_in_inches")

    def test_the_certificate_with_german_numbers(self):
        self.use_german_numbers()
        obj = mq.add_quality_mesh(self.cylinder(), **ROUGH)
        self.assertIn("max. deviation 0,000673 in (requested 0,000394 in), triangle", self.certificate(obj)[1])

    def test_the_certificate_in_german(self):
        obj = mq.add_quality_mesh(self.cylinder(), **ROUGH)
        FreeCADGui.setLocale("German")
        self.addCleanup(FreeCADGui.setLocale, "English")
        gui_helpers.wait(0.2)
        self.assertRegex(self.certificate(obj)[1], r"max\. Abweichung 0[.,]000673 in \(verlangt 0[.,]000394 in\)")

    def test_the_line_of_the_report_view(self):
        view = FreeCADGui.getMainWindow().findChild(QtGui.QTextEdit, "Report view")
        view.clear()
        mq.add_quality_mesh(self.cylinder(), **ROUGH)
        gui_helpers.wait(0.2)
        line, = [line for line in view.toPlainText().splitlines() if "triangles, " in line]
        self.assertIn("max. deviation 0.000673 in; target not met: max. deviation 0.000673 in (requested "
                      "0.000394 in), ", line)

    def test_errors_in_the_panel_and_the_report_view(self):
        view = FreeCADGui.getMainWindow().findChild(QtGui.QTextEdit, "Report view")
        view.clear()
        expected = "The shortest edge of 0.2 in is longer than the longest edge of 0.1 in"
        panel = self.panel(commands.Triangulate, self.box())
        panel.options.set_values({"min_edge": 5.08, "max_edge": 2.54})
        panel.apply()
        self.assertEqual(panel.said, expected)
        panel.reject()
        obj = mq.add_quality_mesh(self.box())
        obj.MaxEdge, obj.MinEdge = 2.54, 5.08
        self.document.recompute()
        gui_helpers.wait(0.2)
        self.assertEqual(obj.Status, "failed: min_edge = 5.08 mm is longer than max_edge = 2.54 mm")
        self.assertIn(f"{obj.Label}: {expected}", view.toPlainText())
        self.assertIn(f"The last update failed: {expected}", self.certificate(obj)[1])

    def test_first_lengths_have_two_digits_in_the_unit_of_the_user(self):
        self.assertEqual(preferences.suggested(hollow.HollowObject, 1000.0), {"thickness": 2.0066})
        gui_helpers.use_units(gui_helpers.MM)
        self.assertEqual(preferences.suggested(hollow.HollowObject, 1000.0), {"thickness": 2.0})
        self.assertEqual(preferences.suggested(hollow.HollowObject, 0.0), {})

    def test_a_value_out_of_range(self):
        for value, said in ((0.0, "0 in"), (-2.54, "-0.1 in"), (float("inf"), "inf in")):
            with self.assertRaises(mq.InvalidInput) as raised:
                mq.triangulate(Part.makeBox(1, 1, 1), max_edge=value)
            self.assertEqual(str(raised.exception), f"max_edge = {value} mm is not allowed: it must be greater than 0 mm")
            self.assertEqual(translated(raised.exception),
                             f"Longest edge: {said} is not possible, it must be greater than 0 in")

    def test_errors_of_the_core(self):
        view = FreeCADGui.getMainWindow().findChild(QtGui.QTextEdit, "Report view")
        view.clear()
        panel = self.panel(commands.Triangulate, self.box())
        panel.options.set_values({"chord_height": 1e-9, "chord_height_relative": None})
        self.apply(panel)
        gui_helpers.wait(0.2)
        said = re.fullmatch(r"A max\. deviation of (\S+) in is below the single precision of meshes in FreeCAD, here "
                            r"(\S+) in\. Choose a larger value", panel.said)
        self.assertIsNotNone(said, panel.said)
        self.assertLess(float(said[1]), float(said[2]))
        self.assertIn(panel.said, view.toPlainText())
        panel.reject()


class Texts(UnitsTest):
    def test_a_value_is_told_from_its_limit(self):
        for texts, shown in ((["2.5401 mm", "2.54 mm"], ["0.100004 in", "0.1 in"]),
                             (["2.53999 mm", "2.54 mm"], ["0.0999996 in", "0.1 in"]),
                             (["2.54 mm", "2.54 mm"], ["0.1 in", "0.1 in"]),
                             (["0 mm", "2.54 mm"], ["0 in", "0.1 in"]), (["0 mm"], ["0 in"]), ([], [])):
            self.assertEqual(quantities.lengths_in_units(texts), shown)
        gui_helpers.use_units(gui_helpers.MM)
        for texts, shown in ((["2.5401 mm", "2.54 mm"], ["2.5401 mm", "2.54 mm"]), (["0.0171 mm"], ["17.1 µm"]),
                             (["0.0171 mm", "0.01 mm"], ["17.1 µm", "10 µm"]), (["1234.5 mm"], ["1234.5 mm"]),
                             (["0.05 mm", "20 mm"], ["0.05 mm", "20 mm"])):
            self.assertEqual(quantities.lengths_in_units(texts), shown)
        # FreeCAD 1.0 has no nanometres in this schema.
        self.assertIn(quantities.lengths_in_units(["1.5e-07 mm"]), (["0.15 nm"], ["0.00000015 mm"]))

    def test_a_limit_that_was_given_in_inches_is_that(self):
        for inches in (0.0625, 0.005, 0.1, 0.125, 0.999, 0.0313, 3.5):
            stored = f"longest edge 90 mm (requested {inches * 25.4:.4g} mm), triangle 3."
            self.assertIn(f"(requested {inches:g} in)", translated_certificate(stored))

    def test_order_is_kept_in_every_unit(self):
        for schema in range(8):
            gui_helpers.use_units(schema)
            for limit in (0.00123, 0.2543, 1.0, 25.4, 914.4):
                for more in (1e-6, 1e-4, 0.3):
                    texts = [f"{limit * (1.0 + more):.10g} mm", f"{limit:g} mm"]
                    value, bound = (float(text.split()[0]) for text in quantities.lengths_in_units(texts))
                    self.assertGreater(value, bound, (schema, texts))

    def test_what_no_phrase_fits_has_its_lengths_converted(self):
        self.assertEqual(translated("Face3 ends 2.54 mm from Edge4"), "Face3 ends 0.1 in from Edge4")
        self.assertEqual(translated("Face3 ends there"), "Face3 ends there")


class LocalSizes(UnitsTest):
    def field(self, sizes):
        panel = self.panel(commands.Triangulate, self.box())
        panel.options.set_values({"local_sizes": sizes})
        return panel.options._fields["local_sizes"]

    def test_are_shown_in_the_users_unit_and_kept_as_they_were(self):
        for sizes in ("Face3=0.1234567891, Edge7=2.54", {"Face3": 0.1234567891, "Edge7": 2.54}):
            field = self.field(sizes)
            self.assertEqual(field.text.text(), "Face3=0.0048605 in, Edge7=0.10 in")
            self.assertEqual(field.value(), sizes)
            field.text.setText(field.text.text() + ", Vertex1=0.5")
            self.assertEqual(field.value(), "Face3=0.1234567891, Edge7=2.54, Vertex1=12.7")
            FreeCADGui.Control.closeDialog()

    def test_any_unit_is_taken(self):
        field = self.field(None)
        for text, sizes in (("Face3=1/8 in; Box.Edge7 = 2 mm", "Face3=3.175, Box.Edge7=2"), ("Face3=1, ", "Face3=25.4"),
                            ("Face3", "Face3"), ("Face3=abc", "Face3=abc"), ("Face3=2 kg", "Face3=2 kg"), ("", None)):
            field.text.setText(text)
            self.assertEqual(field.value(), sizes)
        self.use_german_numbers()
        gui_helpers.use_units(gui_helpers.MM)
        field.text.setText("Face3=0,5, Edge7=1,25 mm")
        self.assertEqual(field.value(), "Face3=0.5, Edge7=1.25")

    def test_what_is_picked_gets_a_size_in_the_users_unit(self):
        box = self.box()
        panel = self.panel(commands.Triangulate, box)
        FreeCADGui.Selection.addSelection(box, "Face3")
        field = panel.options._fields["local_sizes"]
        field.button.click()
        diagonal = box.Shape.BoundBox.DiagonalLength
        self.assertEqual(field.text.text(), f"Face3={quantities.length_text(diagonal / 100)}")
        self.assertRegex(field.text.text(), r"^Face3=0\.\d+ in$")
        self.finish(panel)
        size = float(self.document.Objects[-1].LocalSizes.split("=")[1])
        self.assertAlmostEqual(size / diagonal, 0.01, 4)


class QualityView(UnitsTest):
    def test_numbers_follow_the_locale(self):
        obj = mq.add_quality_mesh(self.cylinder(), chord_height=0.002, chord_height_relative=None)
        self.use_german_numbers()
        panel = quality_panel.open_panel(obj)
        self.until(lambda: panel.scale is not None)
        count = f"{obj.Mesh.CountFacets:,}".replace(",", ".")
        self.assertGreater(obj.Mesh.CountFacets, 1000)
        self.assertTrue(panel.summary.text().startswith(f"{count} triangles: worst "), panel.summary.text())
        self.assertRegex(panel.summary.text(), r"mean \d+,\d+°$")
        self.assertRegex(panel.worst.item(0).text(), r"^\d+(,\d+)?°: element")
        panel.reject()
