# SPDX-License-Identifier: LGPL-2.1-or-later
"""One word for one thing, wherever a user reads it; see docs/use/words.md."""

import re

import helpers
import Part

import MeshQuality as mq
from MeshQuality import inspection_options, offset_options, options, wrap_options
from MeshQuality.core import verdict


class MaxDeviation(helpers.DocumentTest):
    def test_every_bound_on_a_distance_has_one_title(self):
        tables = (options.TRIANGULATE, options.CURVE, options.BOOLEAN, options.IMPROVE, offset_options.OFFSET, offset_options.HOLLOW,
                  wrap_options.WRAP, inspection_options.THICKNESS, inspection_options.CLEARANCE, inspection_options.DRAFT)
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
        measured = re.fullmatch(r"(0\.00\d+) mm \(requested 0\.003 mm\)", mesh.Deviation)
        self.assertAlmostEqual(float(measured[1]), mesh.MaxChordHeight.Value, 6)
        mq.update(mesh, chord_height_relative=0.003)
        self.assertTrue(mesh.Deviation.endswith("(requested 0.03 mm = 0.003 of the size)"), mesh.Deviation)
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        union = mq.add_boolean(box, mesh, tolerance=0.05)
        self.assertRegex(union.Deviation, r"^[\d.e-]+ mm \(requested 0\.05 mm\)$")
