# SPDX-License-Identifier: LGPL-2.1-or-later
"""package.xml, which FreeCAD's addon manager reads: what it names exists, and nothing in it is made up."""

import re
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SPACE = "{https://wiki.freecad.org/Package_Metadata}"
# Domains that are reserved for examples (RFC 2606): an address there leads nowhere.
RESERVED = re.compile(r"\bexample\.(?:com|net|org)\b|\.(?:example|invalid|test)\b")
PLACES = ("package.xml", "packaging/CMakeLists.txt", "packaging/conda/recipe.yaml")


class Package(unittest.TestCase):
    def setUp(self):
        self.tree = ElementTree.parse(ROOT / "package.xml")

    def test_no_address_is_made_up(self):
        for place in PLACES:
            found = RESERVED.search((ROOT / place).read_text(encoding="utf-8"))
            self.assertIsNone(found, f"{place}: {found and found[0]}")

    def test_its_files_exist(self):
        named = [*self.tree.iter(f"{SPACE}icon"), *self.tree.iter(f"{SPACE}subdirectory")]
        for path in (*(element.text for element in named),
                     *(element.get("file") for element in self.tree.iter(f"{SPACE}license"))):
            self.assertTrue((ROOT / path).exists(), path)

    def test_needs_what_it_imports(self):
        needed = {element.text for element in self.tree.iter(f"{SPACE}depend")}
        imported = set()
        for path in (ROOT / "Mod" / "MeshQuality").rglob("*.py"):
            imported |= set(re.findall(r"^\s*(?:import|from) (\w+)", path.read_text(encoding="utf-8"), re.MULTILINE))
        for module in ("Part", "Mesh", "numpy"):
            self.assertIn(module, imported)
            self.assertIn(module.lower(), needed)

    def test_urls_can_be_opened(self):
        for element in self.tree.iter(f"{SPACE}url"):
            self.assertRegex(element.text, r"^https://[\w.-]+/\S+$")


if __name__ == "__main__":
    unittest.main()
