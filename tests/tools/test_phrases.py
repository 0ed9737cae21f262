# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of phrases has all that the core says where panels show it, and takes it apart rightly."""

import copy
import json
import pickle
import re
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "Mod"))

from MeshQuality import errors, options, phrases  # noqa: E402

_STRING = re.compile(r'"((?:[^"\\]|\\.)*)"')


MARKED = phrases.Wording(lambda text: f"<{text}>")  # a translation that can be told from the text
INCHES = phrases.Wording(number=lambda text: text.translate({ord("."): ",", ord(","): "."}),
                         lengths=lambda texts: [f"{float(text.split()[0]) / 25.4:.3g} in" for text in texts])


class Phrases(unittest.TestCase):
    def test_every_stage_of_the_core_has_words(self):
        stages = set()
        for path in (ROOT / "src").rglob("*.[ch]*"):
            stages |= set(re.findall(r'stage\("([^"]+)"', path.read_text(encoding="utf-8")))
        operands = (ROOT / "Mod/MeshQuality/core/operands.py").read_text(encoding="utf-8")
        stages |= set(re.findall(r'_stage\("([^"]+)"\)', operands))
        self.assertGreater(len(stages), 20)
        self.assertEqual(sorted(stages - set(phrases.STAGES)), [])

    def test_everything_that_the_core_waits_for_has_words(self):
        waits = set()
        for path in (ROOT / "src").rglob("*.[ch]*"):
            waits |= set(re.findall(r'OpenCascadeWait wait\(&?progress, \(?"([^"]+)"( \+)?', path.read_text(encoding="utf-8")))
        self.assertGreater(len(waits), 5)
        for text, more in waits:
            stage = "waits for OpenCASCADE: " + text + ("Face7" if more else "")
            self.assertEqual(phrases.stage(stage, MARKED).count("<"), 2, stage)
            self.assertEqual(phrases.rest(stage, MARKED).count("<"), 2, stage)

    def test_every_error_of_the_core_is_one_of_its(self):
        said = "".join("".join(_STRING.findall(re.sub(r'"\s*"', "", path.read_text(encoding="utf-8"))))
                       for path in (ROOT / "src").rglob("*.cpp"))
        for error in phrases.CORE_ERRORS:
            for part in re.split(r"{\w+}", error):
                if len(part.split()) > 2:
                    self.assertIn(part, said)

    def test_a_certificate_is_taken_apart(self):
        text = ("smallest angle 4.57° (requested 25°), triangle 7 on Face4. Target angle not reachable: the "
                "shape itself has a corner of 4.57° between Edge3 and Edge5 at Vertex2. 3 more triangles are "
                "below 25°. Max. deviation 0.0171 mm (requested 0.01 mm), triangle 453 on Face1. Not "
                "watertight: 1,203 open edges. The surface intersects itself: 2 pairs of triangles cross. "
                "Face3 and Face14 cross.")
        found = phrases.sentences(text, MARKED)
        self.assertEqual(found.count("<"), 12)
        self.assertEqual(re.sub("[<>]", "", found).lower(), text.lower())
        self.assertEqual(phrases.sentences(text, phrases.Wording()), text)

    def test_lengths_are_in_the_units_of_the_wording_and_numbers_in_its_digits(self):
        for text, shown in (
                ("smallest angle 4.57° (requested 25°), triangle 7 on Face4. Max. deviation 0.0171 mm (requested "
                 "0.01 mm), triangle 453 on Face1. Not watertight: 1,203 open edges.",
                 "smallest angle 4,57° (requested 25°), triangle 7 on Face4. Max. deviation 0.000673 in (requested "
                 "0.000394 in), triangle 453 on Face1. Not watertight: 1.203 open edges."),
                ("Longest edge 2.6 mm (requested 2.54 mm), triangle 3.",
                 "Longest edge 0.102 in (requested 0.1 in), triangle 3."),
                ("Error bound 2.6 mm (requested 2.54 mm).", "Error bound 0.102 in (requested 0.1 in).")):
            self.assertEqual(phrases.sentences(text, INCHES), shown)
            self.assertEqual(phrases.sentences(text, phrases.Wording()), text)

    def test_every_length_of_the_table_is_one(self):
        for phrase in phrases.texts():
            self.assertNotRegex(phrase, r"} mm|{unit}")

    def test_errors_say_lengths_in_the_units_of_the_wording(self):
        for text, shown in (
                ("min_edge = 5.08 mm is longer than max_edge = 2.54 mm",
                 "The shortest edge of 0.2 in is longer than the longest edge of 0.1 in"),
                ("chord_height = -2.54 mm is not allowed: it must be greater than 0 mm, or 'none'",
                 "Max. deviation: -0.1 in is not possible, it must be greater than 0 in, or without a limit"),
                ("max_edge is 2.54e-05 mm: single precision holds edges of this shape from 2.54 mm on; choose a "
                 "larger value",
                 "Longest edge is 1e-06 in: single precision holds edges of this shape from 0.1 in on; choose a "
                 "larger value"),
                ("Face3 leaves a gap of 2.54 mm at Edge4, 5.08 mm long", "Face3 leaves a gap of 0.1 in at Edge4, "
                                                                          "0.2 in long")):
            self.assertEqual(phrases.translated(text, INCHES), shown)

    def test_sentences_begin_with_a_capital(self):
        def german(phrase):
            return {"not watertight: {count} open edges.": "nicht wasserdicht: {count} offene Kanten."}.get(
                phrase, phrase)

        wording = phrases.Wording(german)
        self.assertEqual(phrases.sentences("Not watertight: 3 open edges.", wording),
                         "Nicht wasserdicht: 3 offene Kanten.")
        self.assertEqual(phrases.sentences("not watertight: 3 open edges.", wording),
                         "nicht wasserdicht: 3 offene Kanten.")

    def test_what_the_shape_itself_rules_out_is_said(self):
        corner = phrases.Text(phrases.EXEMPT["narrow_corner"], number="3.10", edge="Edge3", edge2="Edge5",
                              vertex="Vertex2")
        self.assertEqual(phrases.exempt_sentence(corner, True), f"Target angle not reachable: {corner}.")
        other = phrases.Text(phrases.EXEMPT["resolution"])
        self.assertEqual(phrases.exempt_sentence(other, False),
                         "Points cannot be placed any closer in single precision.")
        self.assertEqual(phrases.sentences(phrases.exempt_sentence(other, False), MARKED),
                         "<points cannot be placed any closer in single precision>.")

    def test_what_a_text_is_made_of_is_kept(self):
        corner = phrases.Text(phrases.EXEMPT["apex"], vertex=phrases.Text(phrases.CREASE_END, name="Face7"))
        text = phrases.joined(phrases.upper_first(phrases.Text(phrases.MORE_BELOW[1], count="3", number="25")),
                              phrases.exempt_sentence(corner, True),
                              phrases.Text(phrases.MISSING[1], count="2", list=["Face1", "Face{2}"]))
        self.assertEqual(text, "3 more triangles are below 25°. Target angle not reachable: the surface comes to a "
                               "point with too little angle around it at the end of a crease on Face7. 2 faces could "
                               "not be meshed and were left out: Face1, Face{2}.")
        said = phrases.sentences(text, MARKED)
        self.assertEqual(said.count("<"), 5, said)
        for copied in (copy.deepcopy(text), pickle.loads(pickle.dumps(text)),
                       phrases.stored(str(text), json.dumps(phrases.to_data(text)))):
            self.assertEqual(copied, text)
            self.assertEqual(phrases.sentences(copied, MARKED), said)
        self.assertEqual(phrases.lower_first(phrases.exempt_sentence(corner, True)),
                         f"target angle not reachable: {corner}.")

    def test_what_was_stored_is_trusted_only_with_its_text(self):
        text = phrases.Text(phrases.LIMIT)
        data = json.dumps(phrases.to_data(text))
        self.assertIsInstance(phrases.stored(str(text), data), phrases.Text)
        for changed in ("", "[]", "3", "{", '{"phrase": 3, "places": {}}', '{"phrase": "{a}", "places": {}}', data[1:]):
            self.assertIs(type(phrases.stored(str(text), changed)), str)
        self.assertEqual(phrases.stored("met", data), "met")

    def test_documents_of_older_versions_hold_plain_texts(self):
        for reason in phrases.EXEMPT.values():
            filled = re.sub(r"{(\w+?)\d?}", lambda place: {"number": "4.57", "edge": "Edge3",
                                                           "vertex": "Edge9"}[place[1]], reason)
            for ending in ("", " at Edge12", " at Edge12 on Face3", " on Face3"):
                found = phrases.translated(filled + ending, MARKED)
                self.assertEqual(found.count("<"), 1 + ending.count("E") + ending.count("F"), found)
                line = phrases.exempt_triangle(7, filled + ending)
                self.assertEqual(phrases.read_exempt_triangle(str(line)), (7, filled + ending))
        self.assertIsNone(phrases.read_exempt_triangle("nothing"))

    def test_lists_of_elements(self):
        found = phrases.translated("4 of 90 elements are not proven valid: triangle 0 on Face1, "
                                   "tetrahedron 2 of Solid1 and 2 more.", MARKED)
        self.assertEqual(found.count("<"), 5)

    def test_errors_of_options_name_their_field(self):
        for values in ({"min_angle": 40.0}, {"chord_height": -1.0}, {"max_triangles": 0.5},
                       {"chord_height": 1.0, "chord_height_relative": 0.1},
                       {"min_edge": 2.0, "max_edge": 1.0}, {"local_sizes": "Face3"}):
            with self.assertRaises(errors.InvalidInput) as raised:
                options.check(options.TRIANGULATE, values)
            found = phrases.translated(str(raised.exception), phrases.Wording())
            self.assertNotEqual(found, str(raised.exception))
            self.assertNotRegex(found, "min_|max_|chord_|local_")

    def test_what_is_not_known_stays(self):
        self.assertEqual(phrases.translated("Face3: no such thing", MARKED), "Face3: no such thing")
        self.assertEqual(phrases.stage("unheard of", MARKED), "unheard of")


if __name__ == "__main__":
    unittest.main()
