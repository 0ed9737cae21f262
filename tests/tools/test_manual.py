# SPDX-License-Identifier: LGPL-2.1-or-later
"""The manual page says what the command line takes."""

import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT / "Mod"), str(ROOT / "tools")]

import manual  # noqa: E402

from MeshQuality import version  # noqa: E402
from MeshQuality.cli import parser  # noqa: E402


class Manual(unittest.TestCase):
    def test_the_page_is_that_of_the_parser(self):
        self.assertEqual(manual.PAGE.read_text(encoding="utf-8"), manual.page(),
                         "run: python3 tools/manual.py")

    def test_every_option_is_in_it(self):
        said = manual.page().replace("\\-", "-")
        for table in parser.TABLES.values():
            for option in table:
                self.assertIn(option.flag, said)

    def test_it_is_good_roff(self):
        reader = shutil.which("groff") or shutil.which("mandoc")
        if reader is None:
            self.skipTest("neither groff nor mandoc is here to read it")
        command = [reader, "-man", "-Tutf8", "-ww"] if reader.endswith("groff") else [reader, "-Tlint"]
        done = subprocess.run([*command, str(manual.PAGE)], capture_output=True, text=True, timeout=60)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_the_version_is_that_of_the_package(self):
        package = (ROOT / "package.xml").read_text(encoding="utf-8")
        self.assertEqual(re.search(r"<version>(.*?)</version>", package)[1], version.__version__)
