# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opening and closing a panel changes nothing, in any unit system; what fields show and take."""

from unittest import mock

import FreeCAD
import FreeCADGui
import gui_helpers
from PySide import QtCore, QtGui

import MeshQuality as mq
from MeshQuality.gui import commands, quantities

METRES, IMPERIAL, BUILDING, FEET = 1, 2, 5, 7


class FormTest(gui_helpers.PanelTest):
    def setUp(self):
        super().setUp()
        self.addCleanup(gui_helpers.use_units, gui_helpers.MM)

    def length_box(self, panel):
        """The field of the absolute distance, shown."""
        field = panel.options._fields["chord_height"]
        field.choice.setCurrentIndex(field.choice.findText("Absolute"))
        return field.length


class Unchanged(FormTest):
    VALUES = {"min_angle": 21.23456789, "chord_height": 0.1234567891, "max_edge": 1.1234567,
              "min_edge": 0.05, "growth_rate": 1.23456789, "local_sizes": {"Face3": 0.7654321987}}

    def test_ok_without_an_edit_leaves_every_option_as_it_was(self):
        obj = mq.add_quality_mesh(self.box(), **self.VALUES)
        held = {name: getattr(obj, name) for name in (
            "MinAngle", "ChordHeight", "MaxEdge", "MinEdge", "Growth", "LocalSizes", "DistanceBound")}
        for schema in (gui_helpers.MM, METRES, IMPERIAL, gui_helpers.INCHES, BUILDING, FEET):
            with self.subTest(schema=schema):
                gui_helpers.use_units(schema)
                steps = self.document.UndoCount
                panel = self.edit(obj)
                for button in panel.options.folds.values():
                    button.setChecked(False)
                gui_helpers.wait()
                gui_helpers.unfold(panel)  # fields write their text anew when they appear
                for box in panel.form.findChildren(QtGui.QAbstractSpinBox):
                    box.setFocus()
                gui_helpers.wait()
                self.assertEqual(panel.options.values()["chord_height"], 0.1234567891)
                self.finish(panel)
                self.assertEqual(panel.said, "")
                self.assertEqual({name: getattr(obj, name) for name in held}, held)
                self.assertEqual(self.document.UndoCount, steps)

    def test_a_relative_bound_and_none_at_all(self):
        for values in ({"chord_height_relative": 0.00123456789}, {"chord_height": "none"}):
            obj = mq.add_quality_mesh(self.box(), **values)
            held = obj.DistanceBound, obj.ChordHeight.Value, obj.ChordHeightRelative
            self.finish(self.edit(obj))
            self.assertEqual((obj.DistanceBound, obj.ChordHeight.Value, obj.ChordHeightRelative), held)

    def test_an_edit_of_one_field_leaves_the_others(self):
        obj = mq.add_quality_mesh(self.box(), **self.VALUES)
        gui_helpers.use_units(gui_helpers.INCHES)
        panel = self.edit(obj)
        gui_helpers.typed(panel.options.field("max_edge"), "1/8 in")
        self.finish(panel)
        self.assertEqual(obj.MaxEdge.Value, 3.175)
        self.assertEqual(obj.MinEdge.Value, 0.05)
        self.assertEqual(obj.ChordHeight.Value, 0.1234567891)


class Texts(FormTest):
    def test_no_unit_system_hides_a_small_value(self):
        for schema in (gui_helpers.MM, METRES, IMPERIAL, gui_helpers.INCHES, BUILDING, FEET):
            gui_helpers.use_units(schema)
            for value in (0.05, 0.1234567, 1e-4, 3.0, 25.4, 1000.0):
                text = quantities.text_of(value)
                self.assertAlmostEqual(quantities.value_of(text) / value, 1.0, 5, (schema, text))
        gui_helpers.use_units(gui_helpers.INCHES)
        self.assertEqual(quantities.text_of(0.05), "0.0019685 in")
        self.assertEqual(quantities.text_of(25.4), "1.00 in")
        gui_helpers.use_units(BUILDING)
        self.assertEqual(quantities.text_of(3.175), '1/8"')

    def test_the_promise_says_how_far_in_every_unit_system(self):
        for schema, words in ((gui_helpers.MM, "30 µm"), (gui_helpers.INCHES, "0.00118 in"), (BUILDING, "0.00118 in")):
            gui_helpers.use_units(schema)
            panel = self.panel(commands.Triangulate, self.box())
            self.assertIn(f"Keeps within {words} of", panel.presets.promise.text())
            panel.reject()

    def test_what_a_field_takes(self):
        box = self.length_box(self.panel(commands.Triangulate, self.box()))
        for text, value in (("0.05", 0.05), ("1/8 in", 3.175), ("=2*0.1 mm", 0.2), ("3 um", 0.003),
                            ("0.12345678 mm", 0.12345678)):
            gui_helpers.typed(box, text)
            self.assertAlmostEqual(box.value(), value, 12, text)
        for text in ("kg", "abc"):
            gui_helpers.typed(box, text)
            self.assertAlmostEqual(box.value(), 0.12345678, 12, text)
        gui_helpers.use_units(gui_helpers.INCHES)
        gui_helpers.typed(box, "0.5")
        self.assertAlmostEqual(box.value(), 12.7)

    def test_german_numbers(self):
        before = QtCore.QLocale()
        QtCore.QLocale.setDefault(QtCore.QLocale("de_DE"))
        self.addCleanup(QtCore.QLocale.setDefault, before)
        self.assertAlmostEqual(quantities.value_of("0,05 mm"), 0.05)
        self.assertAlmostEqual(quantities.value_of("0.05 mm"), 0.05)
        self.assertAlmostEqual(quantities.value_of("1.234,5 mm"), 1234.5)
        self.assertEqual(quantities.text_of(0.1234), "0,1234 mm")

    def test_steps(self):
        box = self.length_box(self.panel(commands.Triangulate, self.box()))
        box.setValue(0.1)
        box.stepBy(1)
        self.assertAlmostEqual(box.value(), 0.2)
        box.stepBy(-1)
        box.stepBy(-1)
        self.assertAlmostEqual(box.value(), 0.09)

    def test_titles_say_what_zero_stands_for(self):
        panel = self.panel(commands.Triangulate, self.box())
        texts = [label.text() for label in panel.form.findChildren(QtGui.QLabel)]
        self.assertIn("Longest edge (0: unlimited)", texts)
        self.assertIn("Max. deviation", texts)


class Distance(FormTest):
    def test_one_row_with_one_field(self):
        panel = self.panel(commands.Triangulate, self.box())
        field = panel.options._fields["chord_height"]
        self.assertIs(panel.options._fields["chord_height_relative"], field)
        self.assertEqual([field.choice.itemText(i) for i in range(3)],
                         ["Relative", "Absolute", "No limit"])
        shown = []
        for title in ("Relative", "Absolute", "No limit"):
            field.choice.setCurrentIndex(field.choice.findText(title))
            gui_helpers.wait()
            shown.append((field.fraction.isVisible(), field.length.isVisible()))
        self.assertEqual(shown, [(True, False), (False, True), (False, False)])
        self.assertIn("not bounded", panel.presets.promise.text())

    def test_another_choice_begins_with_what_means_the_same(self):
        panel = self.panel(commands.Triangulate, self.box(Length=10, Width=20, Height=50))
        box = self.length_box(panel)
        self.assertAlmostEqual(box.value(), 0.15)
        self.assertIn("0.15 mm", panel.presets.promise.text())
        box.setValue(0.5)
        field = panel.options._fields["chord_height"]
        field.choice.setCurrentIndex(0)
        self.assertEqual(panel.options.values()["chord_height_relative"], 0.01)
        self.assertIsNone(panel.options.values()["chord_height"])

    def test_the_fields_show_what_is_set(self):
        panel = self.panel(commands.Triangulate, self.box())
        field = panel.options._fields["chord_height"]
        for values, box, text in (({"chord_height": 0.125}, field.length, "0.125 mm"),
                                  ({"chord_height_relative": 0.02}, field.fraction, "0.02"),
                                  ({"chord_height": 0.1234}, field.length, "0.1234 mm")):
            panel.options.set_values(values)
            gui_helpers.wait()
            self.assertTrue(box.isVisible())
            self.assertEqual(box.text().replace(",", "."), text)
            line = box.findChild(QtGui.QLineEdit)
            self.assertLess(line.fontMetrics().boundingRect(text).width(), line.width())

    def test_typing_a_length_beside_a_preset_is_no_error(self):
        panel = self.panel(commands.Triangulate, self.box())
        gui_helpers.typed(self.length_box(panel), "0.1 mm")
        self.assertEqual(panel.presets.box.currentText(), "Custom")
        self.finish(panel)
        self.assertEqual(panel.said, "")
        obj = self.document.Objects[-1]
        self.assertEqual((obj.DistanceBound, obj.ChordHeight.Value), ("Absolute", 0.1))

    def test_the_recorded_lines_replay_every_change_of_it(self):
        changes = ({"chord_height": 0.5}, {"chord_height": "none"}, {"chord_height_relative": 0.02},
                   {"chord_height": "none"}, {"chord_height": 0.2}, {"chord_height_relative": 0.003})
        sphere = self.document.addObject("Part::Sphere", "Sphere")
        self.document.recompute()
        lines, real = [], FreeCADGui.doCommand
        panel = self.panel(commands.Triangulate, sphere)
        states = []
        with mock.patch.object(FreeCADGui, "doCommand", lambda line: (lines.append(line), real(line))):
            for change in changes:
                panel.options.set_values(change)
                self.apply(panel)
                states.append(self.state(self.document.Objects[-1]))
        panel.reject()
        self.assertEqual(len(set(states[:4])), 3)
        self.assertNotIn("None", "".join(lines))
        obj = self.document.Objects[-1]
        self.document.removeObject(obj.Name)
        replayed = []
        for line in lines:
            exec(line, names := {"App": FreeCAD, "mq": mq})  # noqa: S102 - what a macro does
            if names and "mq." in line:
                replayed.append(self.state(self.document.Objects[-1]))
        self.assertEqual(replayed, states)

    def state(self, obj):
        return obj.DistanceBound, obj.ChordHeight.Value, obj.ChordHeightRelative, obj.Triangles


class Effective(FormTest):
    def enabled(self, panel, *names):
        return [panel.options.field(name).isEnabled() for name in names]

    def test_options_without_effect_are_disabled(self):
        panel = self.panel(commands.Triangulate, self.box())
        gui_helpers.unfold(panel)
        names = ("connectivity", "refine_samples", "seed", "feature_angle")
        self.assertEqual(self.enabled(panel, *names), [False] * 4)
        panel.options.field("method").setCurrentIndex(1)
        self.assertEqual(self.enabled(panel, *names), [True, True, False, False])
        panel.options.field("method").setCurrentIndex(2)
        panel.options.field("keep_edges").setCurrentIndex(1)
        self.assertEqual(self.enabled(panel, *names), [True] * 4)
        panel.options.reset.click()
        self.assertEqual(self.enabled(panel, *names), [False] * 4)


class Folds(FormTest):
    """Groups of options that are folded away until the user opens them."""

    def opened(self, panel):
        return {name for name, button in panel.options.folds.items() if button.isChecked()}

    def test_they_stay_as_the_user_left_them(self):
        panel = self.panel(commands.Triangulate, self.box())
        self.assertEqual(self.opened(panel), set())
        self.assertTrue(panel.options.field("max_edge").isVisible())
        for name in ("More options", "More optionsMethod"):
            panel.options.folds[name].click()
        shown = [panel.options.field(name).isVisible() for name in ("method", "keep_edges", "seed")]
        self.assertEqual(shown, [True, False, False])
        panel.reject()
        panel = self.panel(commands.Triangulate, self.document.Objects[0])
        self.assertEqual(self.opened(panel), {"More options", "More optionsMethod"})
        panel.options.folds["More options"].click()
        panel.reject()
        panel = self.panel(commands.Curve, self.document.Objects[0])  # of which nothing was opened
        self.assertEqual(self.opened(panel), set())
        panel.reject()

    def test_what_is_not_a_default_is_shown_once(self):
        obj = mq.add_quality_mesh(self.box(), method="sprinkle", seed=7)
        panel = self.edit(obj)
        self.assertEqual(self.opened(panel), {"More options", "More optionsMethod", "More optionsSampling"})
        panel.reject()
        panel = self.panel(commands.Triangulate, self.document.Objects[0])
        self.assertEqual(self.opened(panel), set())
        panel.reject()

    def test_few_options_are_not_folded_twice(self):
        panel = self.panel(commands.Curve, self.box())
        self.assertEqual(set(panel.options.folds), {"More options"})
        panel.options.more.click()
        self.assertTrue(panel.options.field("imprint").isVisible())
        panel.reject()

    def test_long_panels_begin_short(self):
        """1366x768 has about 570 pixels for a panel, more than which scrolls."""
        for command in (commands.Triangulate, commands.Curve, commands.FemMesh, commands.FlowMesh):
            panel = self.panel(command, self.box(command.__name__))
            panel.form.setFixedWidth(227)
            gui_helpers.wait()
            self.assertLess(panel.fields.sizeHint().height(), 560, command.__name__)
            panel.reject()


class Defaults(FormTest):
    def test_the_button_gives_those_of_a_first_panel(self):
        first = self.panel(commands.Triangulate, self.box())
        values = first.options.values()
        first.options.set_values({"min_angle": 30.0, "max_edge": 3.0, "method": "star",
                                  "chord_height": 0.5, "local_sizes": "Face1=1"})
        self.finish(first)
        panel = self.panel(commands.Triangulate, self.box("Another"))
        self.assertNotEqual(panel.options.values(), values)
        panel.options.reset.click()
        self.assertEqual(panel.options.values(), values)
        self.assertEqual(panel.presets.box.currentText(), "Medium")
        panel.reject()

    def test_booleans_have_it_too(self):
        panel = self.panel(commands.Boolean, *self.two_boxes())
        panel.options.set_values({"resolution": 64, "tolerance": 0.25})
        panel.options.reset.click()
        self.assertEqual(panel.options.values()["resolution"], 512)
        self.assertIsNone(panel.options.values()["tolerance"])
