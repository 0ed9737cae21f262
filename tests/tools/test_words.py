# SPDX-License-Identifier: LGPL-2.1-or-later
"""Comments of the C++ code keep to the vocabulary, and the checker finds each kind of fault on a small tree."""

import tempfile
import unittest
from pathlib import Path

import words

ROOT = Path(__file__).resolve().parents[2]


class Words(unittest.TestCase):
    """The rule on the tree itself."""

    def test_comments_are_sentences(self):
        faults = words.check_comments(ROOT)
        self.assertFalse(faults, "\n" + "\n".join(faults))

    def test_names_are_the_fields(self):
        faults = words.check_names(ROOT)
        self.assertFalse(faults, "\n" + "\n".join(faults))

    def test_python_names_its_quantities(self):
        faults = words.check_python(ROOT)
        self.assertFalse(faults, "\n" + "\n".join(faults))


class Checker(unittest.TestCase):
    """The checker on temporary trees."""

    def faults(self, text, check=words.check_comments):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "src/mesh/x.h")
            path.parent.mkdir(parents=True)
            path.write_text(text, encoding="utf-8")
            return check(Path(folder))

    def test_retired_names(self):
        for text in ("class TriangleTree;\n", "// see LiveShape\nint x;\n"):
            self.assertEqual(len(self.faults(text, words.check_names)), 1, text)
        self.assertEqual(self.faults("class AabbTree;\n", words.check_names), [])

    def test_retired_words_in_python(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "Mod/MeshQuality/core/x.py")
            path.parent.mkdir(parents=True)
            path.write_text('"""Of a mesh with so many triangles, and so on."""\n', encoding="utf-8")
            self.assertEqual(words.check_python(Path(folder)),
                             ['Mod/MeshQuality/core/x.py:1: "so many": name the quantity'])

    def test_comments_that_begin_with_of(self):
        for text in ("/// Of a half-edge, mm.\nint x;\n", "int x;  ///< of each triangle\n", "/* of it */\n",
                     "/// A sum.\n///\n/// Of two numbers.\n", "int x;  // a\nint y;  // of b\n",
                     "int x;  // a\n// Of b\nint y;\n",
                     "int x;  ///< a\n         ///< b\n/// Of c\nint y;\n"):
            found = self.faults(text)
            self.assertEqual(len(found), 1, text)
            self.assertIn("begins with", found[0])

    def test_names_the_line(self):
        self.assertEqual(self.faults("int x;\n\n/// The sum\n/// of two.\nint y;  // of x\n"),
                         ['src/mesh/x.h:5: begins with "of": write a sentence'])

    def test_retired_words(self):
        for phrase in ("so many", "so much", "So far", "by so much", "for ever", "by and by", "within nothing",
                       "what is asked for", "the part", "a part of it", "to part", "faces flush with others"):
            self.assertEqual(len(self.faults(f"int x;  // tries {phrase} today\n")), 1, phrase)

    def test_a_phrase_that_a_line_break_divides(self):
        self.assertEqual(len(self.faults("/// Tries so\n/// many times.\n")), 1)

    def test_what_may_stand(self):
        for text in ("/// The number of sides\n/// of a polygon.\n", 'const char* s = "// of so many";\n',
                     "/// Takes the Part.Shape with `the part` in it.\n", "/// @param flush pairs in one plane\n",
                     "/// Parts are not partial; offset and often are no 'of'.\n", "char c = '\"'; int d = 1'000;\n",
                     'auto s = R"(// of so many)";\n', "int of_shape();  // an entity\n"):
            self.assertEqual(self.faults(text), [], text)


if __name__ == "__main__":
    unittest.main()
