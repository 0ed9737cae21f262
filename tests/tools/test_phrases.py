# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of phrases has all that the core says where panels show it, and takes it apart rightly."""

import re
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "Mod"))

from MeshQuality import errors, options, phrases  # noqa: E402

_STRING = re.compile(r'"((?:[^"\\]|\\.)*)"')


def marked(text):
    """A translation that can be told from the text."""
    return f"<{text}>"


def literals(path, begin, end):
    """The strings between two marks of a source file."""
    text = (ROOT / path).read_text(encoding="utf-8")
    return _STRING.findall(text[text.index(begin):text.index(end, text.index(begin))])


class Phrases(unittest.TestCase):
    def test_every_stage_of_the_core_has_words(self):
        stages = set()
        for path in (ROOT / "src").rglob("*.[ch]*"):
            stages |= set(re.findall(r'stage\("([^"]+)"', path.read_text(encoding="utf-8")))
        operands = (ROOT / "Mod/MeshQuality/operands.py").read_text(encoding="utf-8")
        stages |= set(re.findall(r'_stage\("([^"]+)"\)', operands))
        self.assertGreater(len(stages), 20)
        self.assertEqual(sorted(stages - set(phrases.STAGES)), [])

    def test_every_reason_of_the_core_is_a_phrase(self):
        known = " ".join(phrases.REASONS + phrases.ENDINGS)
        parts = literals("src/triangulate/explain.cpp", "std::string degrees(", "}  // namespace mq")
        parts += literals("src/improve/improver.cpp", "Improver::left()", "return result")
        parts = [part.strip() for part in parts
                 if len(part.split()) > 1 and not part.startswith("%")]
        self.assertGreater(len(parts), 9)
        for part in parts:
            self.assertIn(part, known)

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
        found = phrases.sentences(text, marked)
        self.assertEqual(found.count("<"), 12)
        self.assertEqual(re.sub("[<>]", "", found).lower(), text.lower().replace("1,203", "1\u202f203"))
        self.assertEqual(phrases.sentences(text, lambda phrase: phrase), text)

    def test_sentences_begin_with_a_capital(self):
        def german(phrase):
            return {"not watertight: {count} open edges.": "nicht wasserdicht: {count} offene Kanten."}.get(
                phrase, phrase)

        self.assertEqual(phrases.sentences("Not watertight: 3 open edges.", german),
                         "Nicht wasserdicht: 3 offene Kanten.")
        self.assertEqual(phrases.sentences("not watertight: 3 open edges.", german),
                         "nicht wasserdicht: 3 offene Kanten.")

    def test_what_the_shape_itself_rules_out_is_said(self):
        reason = "the shape itself has a corner of 3.10° between Edge3 and Edge5 at Vertex2"
        self.assertTrue(phrases.is_forced(reason + " on Face4"))
        self.assertEqual(phrases.sentence(reason), f"Target angle not reachable: {reason}.")
        other = "points cannot be placed any closer in single precision"
        self.assertFalse(phrases.is_forced(other))
        self.assertEqual(phrases.sentence(other), "Points cannot be placed any closer in single precision.")

    def test_reasons_with_every_ending(self):
        for reason in phrases.REASONS:
            filled = re.sub(r"{(\w+?)\d?}", lambda place: {"number": "4.57", "edge": "Edge3",
                                                           "vertex": "Edge9"}[place[1]], reason)
            for ending in ("", " at Edge12", " at Edge12 on Face3", " on Face3"):
                found = phrases.translated(filled + ending, marked)
                self.assertEqual(found.count("<"), 1 + ending.count("E") + ending.count("F"), found)

    def test_lists_of_elements(self):
        found = phrases.translated("4 of 90 elements are not proven valid: triangle 0 on Face1, "
                                   "tetrahedron 2 of Solid1 and 2 more.", marked)
        self.assertEqual(found.count("<"), 5)

    def test_errors_of_options_name_their_field(self):
        for values in ({"min_angle": 40.0}, {"chord_height": -1.0}, {"max_triangles": 0.5},
                       {"chord_height": 1.0, "chord_height_relative": 0.1},
                       {"min_edge": 2.0, "max_edge": 1.0}, {"local_sizes": "Face3"}):
            with self.assertRaises(errors.InvalidInput) as raised:
                options.check(options.TRIANGULATE, values)
            found = phrases.translated(str(raised.exception), lambda phrase: phrase)
            self.assertNotEqual(found, str(raised.exception))
            self.assertNotRegex(found, "min_|max_|chord_|local_")

    def test_what_is_not_known_stays(self):
        self.assertEqual(phrases.translated("Face3: no such thing", marked), "Face3: no such thing")
        self.assertEqual(phrases.stage("unheard of", marked), "unheard of")


if __name__ == "__main__":
    unittest.main()
