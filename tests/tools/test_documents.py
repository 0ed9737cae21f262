# SPDX-License-Identifier: LGPL-2.1-or-later
"""The documents keep their rules, and the check of them finds what breaks these."""

import tempfile
import unittest
from pathlib import Path

import documents


class Documents(unittest.TestCase):
    def test_keep_the_rules(self):
        self.assertEqual(documents.complaints(), [])

    def test_are_of_four_kinds(self):
        for kind in documents.KINDS:
            self.assertTrue(list((documents.ROOT / "docs" / kind).glob("*.md")), kind)


class Check(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name).resolve()
        (self.root / "docs" / "method").mkdir(parents=True)
        (self.root / "src").mkdir()
        self.write("SECURITY.md", "Safe.")
        self.write("docs/picture.svg", "<svg/>")
        self.write("docs/method/page.md", "# A page\n\n![A picture](../picture.svg) of [code](../../src/)\n")
        self.write("README.md", "[A page](docs/method/page.md#a-page)")

    def write(self, name, text):
        (self.root / name).write_text(text, encoding="utf-8")

    def complaints(self):
        return documents.complaints(self.root)

    def test_accepts_what_keeps_the_rules(self):
        self.assertEqual(self.complaints(), [])

    def test_finds_links_that_lead_nowhere(self):
        self.write("SECURITY.md", "[Gone](docs/gone.md), [no heading](README.md#none), [web](https://example.org)")
        self.assertEqual(self.complaints(), ["SECURITY.md: docs/gone.md does not exist",
                                             "SECURITY.md: README.md#none: no such heading"])

    def test_finds_pictures_and_pages_that_nobody_shows(self):
        self.write("docs/other.png", "")
        self.write("docs/other.md", "Alone.")
        self.assertEqual(self.complaints(), ["docs/other.png: no document shows it",
                                             "docs/other.md: no link leads to it"])

    def test_finds_methods_without_figure_or_code(self):
        self.write("docs/method/bare.md", "[Back](page.md)")
        self.write("README.md", "[A page](docs/method/page.md), [bare](docs/method/bare.md)")
        self.assertEqual(self.complaints(), ["docs/method/bare.md has no figure",
                                             "docs/method/bare.md names no folder of code"])

    def test_finds_measurements_without_command_and_pages_of_no_kind(self):
        for folder in ("measurements", "notes"):
            (self.root / "docs" / folder).mkdir()
            self.write(f"docs/{folder}/page.md", "As fast as `tools/`.")
        self.write("README.md", "[A](docs/method/page.md), [b](docs/measurements/page.md), [c](docs/notes/page.md)")
        self.assertEqual(self.complaints(), ["docs/measurements/page.md names no benchmark or tool",
                                             "docs/notes/page.md is of no kind: use, method, measurements, papers"])

    def test_finds_walks_that_lead_nowhere(self):
        self.write("src/mesh.cpp", "int join() { return 0; }")
        self.write("src/mesh.h", "int join();")
        self.write("docs/architecture.md", "## Walks\n1. `src/mesh.cpp`, `Mesh::join`, and `mesh.h`: joined.\n"
                   "2. `src/gone.cpp`, `join`: gone.\n3. `src/mesh.cpp`, `split`, divides.\n\n## Else\n`src/none.cpp`")
        self.write("README.md", "[A](docs/method/page.md), [b](docs/architecture.md)")
        self.assertEqual(self.complaints(), ["docs/architecture.md: src/gone.cpp does not exist",
                                             "docs/architecture.md: src/mesh.cpp has no split"])

    def test_finds_long_paragraphs_and_sentences(self):
        self.write("SECURITY.md", "Start.\n\n" + "One two three. " * 34)
        self.assertEqual(self.complaints(), ["SECURITY.md:3: a paragraph of 102 words"])
        self.write("SECURITY.md", "- " + "word " * 46)
        self.assertEqual(len(self.complaints()), 1)
        self.assertTrue(self.complaints()[0].startswith("SECURITY.md:1: a sentence of 46 words"))

    def test_finds_tests_that_are_not_there(self):
        for folder in ("freecad", "attacks"):
            (self.root / "tests" / folder).mkdir(parents=True)
        self.write("tests/freecad/test_box.py", "class A:\n    def test_one(self): ...\n\n\nclass B:\n"
                                                "    def test_two(self): ...\n")
        self.write("tests/attacks/known.py", 'CALLS = {"a nut": None}')
        self.write("SECURITY.md", "`test_box.A.test_one`, `test_box.B.test_two`, `known: a nut`, `size: 3`")
        self.assertEqual(self.complaints(), [])
        self.write("SECURITY.md", "`test_box.A.test_two`, `test_none.A.test_one`, `known: a bolt`")
        self.assertEqual(self.complaints(), ["SECURITY.md: no test is called test_box.A.test_two",
                                             "SECURITY.md: no test is called test_none.A.test_one",
                                             "SECURITY.md: no attack of known is called a bolt"])

    def test_leaves_tables_and_code_alone(self):
        long = "word " * 200
        self.write("SECURITY.md", f"| {long} |\n\n    {long}\n\n```\n{long}\n```\n")
        self.assertEqual(self.complaints(), [])


if __name__ == "__main__":
    unittest.main()
