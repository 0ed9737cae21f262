# SPDX-License-Identifier: LGPL-2.1-or-later
"""What panels begin with: presets, and the values that were used last."""

import json

import gui_helpers

import MeshQuality as mq
from MeshQuality import options
from MeshQuality.gui import commands, preferences


class Presets(gui_helpers.PanelTest):
    def choose(self, panel, title):
        """Chooses in the box as a user does."""
        index = panel.presets.box.findText(title)
        self.assertGreaterEqual(index, 0)
        panel.presets.box.setCurrentIndex(index)
        panel.presets.box.activated[int].emit(index)

    def triangles_of(self, title):
        source = self.document.addObject("Part::Sphere", "Sphere")
        self.document.recompute()
        panel = self.panel(commands.Triangulate, source)
        self.choose(panel, title)
        self.finish(panel)
        return self.document.Objects[-1]

    def test_a_new_panel_begins_with_medium(self):
        panel = self.panel(commands.Triangulate, self.box())
        self.assertEqual(panel.presets.box.currentText(), "Medium")
        self.assertEqual(panel.options.values()["chord_height_relative"], 0.003)
        self.assertIn("30 µm", panel.presets.promise.text().replace(",", "."))

    def test_each_is_finer_than_the_one_before(self):
        for command, source in ((commands.Triangulate, self.box()), (commands.Curve, self.box())):
            panel = self.panel(command, source)
            titles = [panel.presets.box.itemText(i) for i in range(panel.presets.box.count())]
            self.assertEqual(titles, ["Coarse", "Medium", "Fine", "Very fine", "Custom"])
            heights = []
            for title in titles[:-1]:
                self.choose(panel, title)
                self.assertEqual(panel.presets.box.currentText(), title)
                heights.append(panel.options.values()["chord_height_relative"])
                options.check(command.KIND.OPTIONS, panel.options.values())
            self.assertEqual(heights, sorted(heights, reverse=True))
            panel.reject()

    def test_the_mesh_keeps_what_a_preset_promises(self):
        coarse, fine = self.triangles_of("Coarse"), self.triangles_of("Fine")
        self.assertGreater(fine.Triangles, 2 * coarse.Triangles)
        self.assertLessEqual(coarse.MaxChordHeight.Value, 0.01 * 10)
        self.assertLessEqual(fine.MaxChordHeight.Value, 0.001 * 10)

    def test_changed_fields_are_custom_and_back_again(self):
        panel = self.panel(commands.Triangulate, self.box())
        panel.options.set_values({"max_edge": 1.0})
        self.assertEqual(panel.presets.box.currentText(), "Custom")
        panel.options.set_values({"max_edge": None, "chord_height_relative": 0.001})
        self.assertEqual(panel.presets.box.currentText(), "Fine")
        panel.options.set_values({"chord_height": "none"})
        self.assertIn("not bounded", panel.presets.promise.text())
        panel.options.set_values({"chord_height": 0.25})
        self.assertIn("0.25 mm", panel.presets.promise.text().replace(",", "."))

    def test_booleans_have_none(self):
        panel = self.panel(commands.Boolean, *self.two_boxes())
        kept = panel.estimate.text()
        self.assertRegex(kept, r"^Keeps within \d.* [mµ]m of the exact result\.$")
        panel.options.set_values({"tolerance": 0.5})
        self.assertIn("0.5", panel.estimate.text())
        panel.options.set_values({"tolerance": None})
        self.assertEqual(panel.estimate.text(), kept)
        self.assertTrue(panel.presets.isHidden())

    def test_rare_options_are_folded_away_unless_they_are_used(self):
        panel = self.panel(commands.Triangulate, self.box())
        self.assertFalse(panel.options.field("seed").isVisible())
        gui_helpers.unfold(panel)
        gui_helpers.wait()
        self.assertTrue(panel.options.field("seed").isVisible())
        panel.reject()
        panel = self.panel(commands.Triangulate, self.box("Other"))
        panel.options.set_values({"method": "star"})
        gui_helpers.wait()
        self.assertTrue(panel.options.field("method").isVisible())
        self.assertFalse(panel.options.field("seed").isVisible())


class Remembered(gui_helpers.PanelTest):
    def use(self, **values):
        panel = self.panel(commands.Triangulate, self.box())
        panel.options.set_values(values)
        panel.accept()
        self.until(lambda: not panel.jobs)

    def first(self):
        panel = self.panel(commands.Triangulate, self.box("Another"))
        values = panel.options.values()
        panel.reject()
        return values

    def test_the_next_panel_begins_with_the_values_used_last(self):
        self.use(min_angle=30.0, chord_height_relative=0.02, method="star")
        values = self.first()
        self.assertEqual((values["min_angle"], values["chord_height_relative"], values["method"]),
                         (30.0, 0.02, "star"))

    def test_lengths_and_names_of_faces_stay_with_their_part(self):
        self.use(min_angle=30.0, max_edge=3.0, min_edge=0.01, chord_height=0.5,
                 local_sizes="Face6=0.173")
        values = self.first()
        self.assertEqual(values["min_angle"], 30.0)
        self.assertEqual([values[name] for name in ("max_edge", "min_edge", "chord_height",
                                                    "local_sizes")], [None] * 4)
        self.assertEqual(values["chord_height_relative"], 0.003)

    def test_what_an_older_version_kept_of_them_is_not_used(self):
        preferences.stored().SetString("LastTriangulate", json.dumps(
            {"min_angle": 31.0, "max_edge": 0.5, "chord_height": 0.1, "chord_height_relative": None,
             "local_sizes": {"Face6": 0.1}}))
        values = self.first()
        self.assertEqual((values["min_angle"], values["max_edge"], values["local_sizes"],
                          values["chord_height_relative"]), (31.0, None, None, 0.003))

    def test_no_limit_is_a_choice_that_is_kept(self):
        self.use(chord_height="none")
        self.assertEqual(self.first()["chord_height"], "none")
        self.use(chord_height_relative=0.02)
        self.assertEqual(self.first()["chord_height_relative"], 0.02)

    def test_tolerances_of_booleans_are_lengths(self):
        panel = self.panel(commands.Boolean, *self.two_boxes())
        panel.options.set_values({"tolerance": 0.25, "operation": "difference"})
        self.finish(panel)
        panel = self.panel(commands.Boolean, *self.two_boxes())
        self.assertEqual(panel.options.values()["operation"], "difference")
        self.assertIsNone(panel.options.values()["tolerance"])
        panel.reject()

    def test_an_object_that_is_edited_shows_its_own(self):
        source = self.box()
        obj = mq.add_quality_mesh(source, max_edge=2.0, local_sizes={"Face1": 0.5})
        panel = commands.panel_of(obj)
        self.assertEqual(panel.options.values()["max_edge"], 2.0)
        self.assertEqual(panel.options.values()["local_sizes"], {"Face1": 0.5})

    def test_not_where_the_user_does_not_want_it(self):
        preferences.stored().SetBool("RememberValues", False)
        self.use(min_angle=30.0)
        self.assertEqual(self.first()["min_angle"], 25.0)

    def test_the_preferred_angle(self):
        preferences.stored().SetFloat("MinAngle", 28.0)
        self.assertEqual(self.first()["min_angle"], 28.0)

    def test_values_that_are_not_allowed_any_more_are_left_out(self):
        for text in ('{"min_angle": 90}', '{"gone": 1}', "no JSON"):
            preferences.stored().SetString("LastTriangulate", text)
            self.assertEqual(self.first()["min_angle"], 25.0)
