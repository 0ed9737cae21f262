# SPDX-License-Identifier: LGPL-2.1-or-later
"""One version everywhere, and the changelog has a part for it or for what is not released yet."""

import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PLACES = {
    "CMakeLists.txt": r"project\(MeshQuality VERSION (\S+)",
    "package.xml": r"<version>(.*)</version>",
    "Mod/MeshQuality/version.py": r'__version__ = "(.*)"',
    "packaging/conda/recipe.yaml": r'version: "(.*)"',
}


class Version(unittest.TestCase):
    def test_is_the_same_everywhere(self):
        found = {}
        for file, pattern in PLACES.items():
            match = re.search(pattern, (ROOT / file).read_text(encoding="utf-8"))
            self.assertTrue(match, file)
            found[file] = match.group(1)
        self.assertEqual(len(set(found.values())), 1, found)
        self.assertRegex(next(iter(found.values())), r"^\d+\.\d+\.\d+$")

    def test_the_changelog_knows_it(self):
        text = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
        version = re.search(PLACES["package.xml"],
                            (ROOT / "package.xml").read_text(encoding="utf-8")).group(1)
        self.assertTrue("## [Unreleased]" in text or f"## [{version}]" in text)
