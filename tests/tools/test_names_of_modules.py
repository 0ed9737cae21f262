# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names that tests and benchmarks take from each other's modules are there: window tests are too slow to find out by running them."""

import ast
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def top_names(tree):
    """Names that a module defines: functions, classes, assignments and imports, also those within `if` and `try`."""
    found = set()
    for node in ast.walk(tree):
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            found.add(node.name)
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            found.add(node.id)
        elif isinstance(node, (ast.Import, ast.ImportFrom)):
            found.update((alias.asname or alias.name).split(".")[0] for alias in node.names)
    return found


def missing_names(folder):
    """['file:line: module.name', ...] of names that the modules of a folder and those in it take from each other and that are not there."""
    trees = {path.stem: ast.parse(path.read_text(encoding="utf-8")) for path in sorted(folder.rglob("*.py"))}
    names = {stem: top_names(tree) | {"__file__", "__name__", "__doc__"} for stem, tree in trees.items()}
    faults = []
    for stem, tree in trees.items():
        used = {alias.asname or alias.name: alias.name for node in ast.walk(tree) if isinstance(node, ast.Import)
                for alias in node.names if alias.name in trees}
        for node in ast.walk(tree):
            if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id in used \
                    and node.attr not in names[used[node.value.id]]:
                faults.append(f"{stem}.py:{node.lineno}: {node.value.id}.{node.attr}")
            elif isinstance(node, ast.ImportFrom) and node.module in trees:
                faults += [f"{stem}.py:{node.lineno}: {node.module}.{alias.name}" for alias in node.names
                           if alias.name not in names[node.module]]
    return faults


class NamesOfModules(unittest.TestCase):
    """Of the tree, and of a folder with one fault of each kind."""

    def test_are_there(self):
        for folder in ("tests/gui", "tests/freecad", "tests/tools", "benchmarks"):
            with self.subTest(folder=folder):
                self.assertEqual(missing_names(ROOT / folder), [])

    def test_faults_are_found(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "units.py").write_text("INCHES = 1\ndef use(): pass\n", encoding="utf-8")
            (Path(folder) / "window.py").write_text(
                "import units\nfrom units import INCHES, FEET\nunits.use()\nunits.gone()\n", encoding="utf-8")
            self.assertEqual(sorted(missing_names(Path(folder))), ["window.py:2: units.FEET", "window.py:4: units.gone"])


if __name__ == "__main__":
    unittest.main()
