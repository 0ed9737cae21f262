# SPDX-License-Identifier: LGPL-2.1-or-later
"""docs/papers and benchmarks/papers agree: no figure without its command, no command, option or file that is gone."""

import importlib.util
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import documents

ROOT = documents.ROOT
COMMAND = re.compile(r"benchmarks/papers ([a-z0-9-]+)")
OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]*")
FILES = re.compile(r"`((?:src|Mod|tests|benchmarks|docs)/[\w./-]+)`")
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


def script_of(name, root):
    return root / "benchmarks" / "papers" / f"{name.replace('-', '_')}.py"


def unknown_options(body, names, root):
    """Options that a section gives to its commands, or names in its text, and no script of these has."""
    found, scripts = [], []
    for line in body.splitlines():
        command = COMMAND.search(line)
        if command and command[1] in names:
            scripts.append(script_of(command[1], root).read_text(encoding="utf-8"))
            found += [f"{command[1]}: no option {option}" for option in OPTION.findall(line[command.end():])
                      if f'"{option}"' not in scripts[-1]]
        elif scripts:
            found += [f"{option}: no command of its section has it" for span in re.findall(r"`([^`]*)`", line)
                      for option in OPTION.findall(span) if not any(f'"{option}"' in script for script in scripts)]
    return found


def rows_without_file(heading, body):
    """Of a table of where to find what."""
    rows = [row for row in body.splitlines() if row.startswith("|") and not row.startswith((FIRST_COLUMN, "|-"))]
    if not rows:
        return [f"{heading}: the table is empty"]
    return [f"{heading}: a row without its file: {row}" for row in rows if not (FILES.search(row) or "not built" in row)]


def complaints(text, names, root=ROOT):
    asked = COMMAND.findall(text)
    found = [f"{name}: no such command" for name in asked if name not in names]
    found += [f"{name}: the page does not show it" for name in names if name not in asked]
    found += [f"{path}: no such file" for path in FILES.findall(text) if not (root / path).exists()]
    for heading, body in sections(text):
        shows = "![" in body or ("\n|" in body and FIRST_COLUMN not in body)
        if shows and not COMMAND.search(body):
            found.append(f"{heading}: a table or figure without its command")
        found += unknown_options(body, names, root)
        if FIRST_COLUMN in body:
            found += rows_without_file(heading, body)
    return found


class Papers(unittest.TestCase):
    def test_pages_and_commands_agree(self):
        text = "\n".join(page.read_text(encoding="utf-8") for page in sorted((ROOT / "docs" / "papers").glob("*.md")))
        self.assertEqual(complaints(text, known()), [])

    def test_every_command_says_how_it_is_called(self):
        for name in known():
            self.assertIn(f"benchmarks/papers {name}", script_of(name, ROOT).read_text(encoding="utf-8"), name)

    def test_programs_that_are_not_built_are_named_with_how(self):
        command = [sys.executable, str(ROOT / "benchmarks" / "papers"), "dey-operations", "--program", "/nowhere/curve_operations"]
        done = subprocess.run(command, capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (2, "/nowhere/curve_operations is not there: cmake -B build "
                                                             "-DMESHQUALITY_BENCHMARKS=ON && ninja -C build curve_operations\n"))


class Check(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name)
        for name, text in (("src/a.cpp", ""), ("src/old-a.cpp", ""),
                           ("benchmarks/papers/die.py", 'parser.add_argument("--rays")')):
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            (self.root / name).write_text(text, encoding="utf-8")

    def complaints(self, text):
        return complaints(text, {"die": "The die."}, self.root)

    def test_accepts_what_is_right(self):
        self.assertEqual(self.complaints("`tools/build --tests`\n## Die\n    python3 benchmarks/papers die --rays 9\n\n`--rays` chooses.\n"
                                         "| a |\n|---|\n| 1 |\n\n## Where\n| in the paper | file |\n|---|---|\n| 2 | `src/a.cpp` |\n"
                                         "| 3 | `src/old-a.cpp` |\n| 4 | not built |\n"), [])

    def test_finds_what_is_gone(self):
        self.assertEqual(self.complaints("`src/b.cpp` `src/new-b.cpp` benchmarks/papers wing"),
                         ["wing: no such command", "die: the page does not show it", "src/b.cpp: no such file",
                          "src/new-b.cpp: no such file"])

    def test_finds_options_that_are_gone(self):
        text = "## Die\n    python3 benchmarks/papers die --rows a --rays 9\n\nMore with `--rays`, fewer with `die --part 3`.\n"
        self.assertEqual(self.complaints(text), ["die: no option --rows", "--part: no command of its section has it"])

    def test_finds_figures_without_command(self):
        text = "## Die\n    python3 benchmarks/papers die\n\n## Wing\n![Wing](wing.png)\n"
        self.assertEqual(self.complaints(text), ["## Wing: a table or figure without its command"])

    def test_finds_rows_without_file(self):
        text = "benchmarks/papers die\n## Where\n| in the paper | file |\n|---|---|\n| section 2 | nothing |\n"
        self.assertEqual(self.complaints(text), ["## Where: a row without its file: | section 2 | nothing |"])

    def test_finds_empty_tables_of_files(self):
        text = "benchmarks/papers die\n## Where\n| in the paper | file |\n|---|---|\n\nNothing.\n"
        self.assertEqual(self.complaints(text), ["## Where: the table is empty"])


if __name__ == "__main__":
    unittest.main()
