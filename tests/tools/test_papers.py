# SPDX-License-Identifier: LGPL-2.1-or-later
"""docs/papers.md and benchmarks/papers agree: no figure without its command, no command or file that is gone."""

import importlib.util
import re
import tempfile
import unittest
from pathlib import Path

import documents

ROOT = documents.ROOT
COMMAND = re.compile(r"benchmarks/papers ([a-z0-9-]+)")
FILES = re.compile(r"`((?:src|Mod|tests|benchmarks|docs)/[\w./]+)`")
FIRST_COLUMN = "| in the paper |"  # heads the tables of where to find what


def known():
    spec = importlib.util.spec_from_file_location("papers", ROOT / "benchmarks" / "papers" / "__main__.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.names()


def sections(text):
    """[(heading, text)] of all sections, of whatever level."""
    parts = re.split(r"^(#+ .*)$", text, flags=re.MULTILINE)
    return list(zip(parts[1::2], parts[2::2]))


def complaints(text, names, root=ROOT):
    asked = COMMAND.findall(text)
    found = [f"{name}: no such command" for name in asked if name not in names]
    found += [f"{name}: the page does not show it" for name in names if name not in asked]
    found += [f"{path}: no such file" for path in FILES.findall(text) if not (root / path).exists()]
    for heading, body in sections(text):
        shows = "![" in body or ("\n|" in body and FIRST_COLUMN not in body)
        if shows and not COMMAND.search(body):
            found.append(f"{heading}: a table or figure without its command")
        for row in body.splitlines() if FIRST_COLUMN in body else []:
            if row.startswith("|") and not row.startswith((FIRST_COLUMN, "|-")) and not (
                    FILES.search(row) or "not built" in row):
                found.append(f"{heading}: a row without its file: {row}")
    return found


class Papers(unittest.TestCase):
    def test_page_and_commands_agree(self):
        text = (ROOT / "docs" / "papers.md").read_text(encoding="utf-8")
        self.assertEqual(complaints(text, known()), [])

    def test_every_command_says_how_it_is_called(self):
        for name in known():
            script = ROOT / "benchmarks" / "papers" / f"{name.replace('-', '_')}.py"
            self.assertIn(f"benchmarks/papers {name}", script.read_text(encoding="utf-8"), name)


class Check(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name)
        (self.root / "src").mkdir()
        (self.root / "src" / "a.cpp").write_text("", encoding="utf-8")

    def complaints(self, text):
        return complaints(text, {"die": "The die."}, self.root)

    def test_accepts_what_is_right(self):
        self.assertEqual(self.complaints("## Die\n    python3 benchmarks/papers die\n\n| a |\n|---|\n| 1 |\n\n## Where\n"
                                         "| in the paper | file |\n|---|---|\n| 2 | `src/a.cpp` |\n| 3 | not built |\n"), [])

    def test_finds_what_is_gone(self):
        self.assertEqual(self.complaints("`src/b.cpp` benchmarks/papers wing"),
                         ["wing: no such command", "die: the page does not show it", "src/b.cpp: no such file"])

    def test_finds_figures_without_command(self):
        text = "## Die\n    python3 benchmarks/papers die\n\n## Wing\n![Wing](wing.png)\n"
        self.assertEqual(self.complaints(text), ["## Wing: a table or figure without its command"])

    def test_finds_rows_without_file(self):
        text = "benchmarks/papers die\n## Where\n| in the paper | file |\n|---|---|\n| section 2 | nothing |\n"
        self.assertEqual(self.complaints(text), ["## Where: a row without its file: | section 2 | nothing |"])


if __name__ == "__main__":
    unittest.main()
