# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of phrases has all that the core says where panels show it, and takes it apart rightly."""

import copy
import dataclasses
import json
import pickle
import re
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "Mod"))

from MeshQuality import errors, options, phrases  # noqa: E402


# Errors of C++ and Python that are said in English: of our own code, and of a build that does not load.
PLAIN_ERRORS = {"std::logic_error", "py::import_error"}
MARKED = phrases.Wording(lambda text: f"<{text}>")  # a translation that can be told from the text
INCHES = phrases.Wording(number=lambda text: text.translate({ord("."): ",", ord(","): "."}),
                         lengths=lambda texts: [f"{float(text.split()[0]) / 25.4:.3g} in" for text in texts])


def refused(**values):
    """What the error says of options that are not possible."""
    try:
        options.check(options.TRIANGULATE, values)
    except errors.InvalidInput as error:
        return error.args[0]
    raise AssertionError(values)


class Phrases(unittest.TestCase):
    def test_every_stage_of_the_core_has_words(self):
        stages = set()
        for path in (ROOT / "src").rglob("*.[ch]*"):
            stages |= set(re.findall(r'(?:stage|start)\("([^"]+)"', path.read_text(encoding="utf-8")))
        self.assertGreater(len(stages), 20)
        self.assertEqual(sorted(stages - set(phrases.STAGES)), [])

    def test_everything_that_the_core_waits_for_has_words(self):
        waits = set()
        for path in (ROOT / "src").rglob("*.[ch]*"):
            waits |= set(re.findall(r'OpenCascadeWait wait\(&?progress, "([^"]+)"', path.read_text(encoding="utf-8")))
        self.assertEqual(sorted(waits - set(phrases.STAGES)), [])
        for what in (*waits, phrases.Text(phrases.CHECKING, name="Face7")):
            stage = phrases.Text(phrases.WAITS_FOR_KERNEL, stage=what)
            self.assertTrue(phrases.is_wait(stage))
            self.assertEqual(phrases.stage(stage, MARKED).count("<"), 2, stage)
            self.assertEqual(phrases.rest(stage, MARKED).count("<"), 2, stage)

    def test_the_core_fills_every_phrase_that_is_compiled_into_it(self):
        """Wherever it uses one, it names its places: from_data fails without one of them."""
        code = [path.read_text(encoding="utf-8") for path in (ROOT / "src").rglob("*.[ch]*")]
        for name, texts in phrases.CORE.items():
            constant = "phrases::k" + "".join(word.capitalize() for word in name.split("_"))
            users = [text for text in code if re.search(rf"{constant}\b", text)]
            self.assertTrue(users, name)
            pair = not isinstance(texts, str)  # whose {count} the function `counted` fills
            for place in set(re.findall(r"{(\w+)}", "".join(phrases.flat([texts])))) - ({"count"} if pair else set()):
                self.assertEqual([text[:200] for text in users if f'"{place}"' not in text], [], name)

    def test_what_the_core_says_is_in_the_table(self):
        """Errors and notes are phrases, as the compiler requires; here are the ways around it."""
        said = []
        for path in (ROOT / "src").rglob("*.[ch]*"):
            said += re.findall(r'(?:Phrase|Message::value)\s*[({]\s*"([^"]*)|throw ((?:std|py)::\w+)\([^;]*"', path.read_text(encoding="utf-8"))
        self.assertEqual({error for _, error in said if error}, PLAIN_ERRORS)
        self.assertEqual({text for text, _ in said if text} - set(phrases.STAGES), set())

    def test_every_length_of_the_table_is_one(self):
        for phrase in phrases.texts():
            self.assertNotRegex(phrase, r"} mm|{unit}")

    def test_errors_say_lengths_in_the_units_of_the_wording(self):
        wording = dataclasses.replace(INCHES, title={"chord_height": "Max. deviation", "max_edge": "Longest edge"}.get)
        for text, shown in (
                (refused(min_edge=5.08, max_edge=2.54),
                 "The shortest edge of 0.2 in is longer than the longest edge of 0.1 in"),
                (refused(chord_height=-2.54),
                 "Max. deviation: -0.1 in is not possible, it must be greater than 0 in, or without a limit"),
                (phrases.Text(phrases.CORE_ERRORS["short_edges"], option="max_edge", length="2.54e-05 mm",
                              length2="2.54 mm"),
                 "Longest edge is 1e-06 in: single precision holds edges of this shape from 0.1 in on; choose a "
                 "larger value"),
                ("Face3 leaves a gap of 2.54 mm at Edge4, 5.08 mm long", "Face3 leaves a gap of 0.1 in at Edge4, "
                                                                          "0.2 in long")):
            self.assertEqual(phrases.translated(text, wording), shown)

    def test_sentences_begin_with_a_capital(self):
        def german(phrase):
            return {"not watertight: {count} open edges.": "nicht wasserdicht: {count} offene Kanten."}.get(
                phrase, phrase)

        wording = phrases.Wording(german)
        text = phrases.Text(phrases.NOT_CLOSED[1], count="3")
        self.assertEqual(phrases.translated(phrases.upper_first(text), wording), "Nicht wasserdicht: 3 offene Kanten.")
        self.assertEqual(phrases.translated(text, wording), "nicht wasserdicht: 3 offene Kanten.")

    def test_what_the_shape_itself_rules_out_is_said(self):
        corner = phrases.Text(phrases.EXEMPT["narrow_corner"], number="3.10", edge="Edge3", edge2="Edge5",
                              vertex="Vertex2")
        self.assertEqual(phrases.exempt_sentence(corner, True), f"Target angle not reachable: {corner}.")
        other = phrases.Text(phrases.EXEMPT["resolution"])
        self.assertEqual(phrases.exempt_sentence(other, False),
                         "Points cannot be placed any closer in single precision.")
        self.assertEqual(phrases.translated(phrases.exempt_sentence(other, False), MARKED),
                         "<points cannot be placed any closer in single precision>.")

    def test_what_a_text_is_made_of_is_kept(self):
        corner = phrases.Text(phrases.EXEMPT["apex"], vertex=phrases.Text(phrases.CREASE_END, name="Face7"))
        text = phrases.joined(phrases.upper_first(phrases.Text(phrases.MORE_BELOW[1], count="3", number="25")),
                              phrases.exempt_sentence(corner, True),
                              phrases.Text(phrases.MISSING[1], count="2", list=["Face1", "Face{2}"]))
        self.assertEqual(text, "3 more triangles are below 25°. Target angle not reachable: the surface comes to a "
                               "point with too little angle around it at the end of a crease on Face7. 2 faces could "
                               "not be meshed and were left out: Face1, Face{2}.")
        said = phrases.translated(text, MARKED)
        self.assertEqual(said.count("<"), 5, said)
        for copied in (copy.deepcopy(text), pickle.loads(pickle.dumps(text)),
                       phrases.stored(str(text), json.dumps(phrases.to_data(text)))):
            self.assertEqual(copied, text)
            self.assertEqual(phrases.translated(copied, MARKED), said)
        self.assertEqual(phrases.lower_first(phrases.exempt_sentence(corner, True)),
                         f"target angle not reachable: {corner}.")

    def test_what_was_stored_is_trusted_only_with_its_text(self):
        text = phrases.Text(phrases.LIMIT)
        data = json.dumps(phrases.to_data(text))
        self.assertIsInstance(phrases.stored(str(text), data), phrases.Text)
        for changed in ("", "[]", "3", "{", '{"phrase": 3, "places": {}}', '{"phrase": "{a}", "places": {}}', data[1:]):
            self.assertIs(type(phrases.stored(str(text), changed)), str)
        self.assertEqual(phrases.stored("met", data), "met")

    def test_lists_of_elements(self):
        listed = phrases.Text(phrases.AND_MORE, count="2", list=[
            phrases.Text(phrases.ON_FACE, phrase=phrases.Text(phrases.TRIANGLE, count="0"), face="Face1"),
            phrases.Text(phrases.TETRAHEDRON, count="2", solid="Solid1")])
        found = phrases.translated(phrases.Text(phrases.FOLDED[1], count="4", count2="90", list=listed), MARKED)
        self.assertEqual(found.count("<"), 5)

    def test_errors_of_options_name_their_field(self):
        for values in ({"min_angle": 40.0}, {"chord_height": -1.0}, {"max_triangles": 0.5},
                       {"chord_height": 1.0, "chord_height_relative": 0.1},
                       {"min_edge": 2.0, "max_edge": 1.0}, {"local_sizes": "Face3"}):
            said = refused(**values)
            found = phrases.translated(said, phrases.Wording(title=lambda name: "Field"))
            self.assertNotEqual(found, said)
            self.assertNotRegex(found, "min_|max_|chord_|local_")

    def test_every_range_of_the_options_is_one_of_the_table(self):
        modules = options, options.fem, options.inspection, options.offset, options.wrap
        ranges = {option.range_text for module in modules for table in vars(module).values()
                  if isinstance(table, tuple) for option in table if isinstance(option, options.Option)}
        filled = {text.phrase for text in ranges if isinstance(text, phrases.Text)}
        self.assertEqual(sorted(filled - set(phrases.RANGES)), [])

    def test_what_is_not_known_stays(self):
        self.assertEqual(phrases.translated("Face3: no such thing", MARKED), "Face3: no such thing")
        self.assertEqual(phrases.stage("unheard of", MARKED), "unheard of")


if __name__ == "__main__":
    unittest.main()
