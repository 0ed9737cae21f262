# SPDX-License-Identifier: LGPL-2.1-or-later
"""The translations have the texts of the workbench, and all of them."""

import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
FOLDER = ROOT / "Resources" / "translations"


class Translations(unittest.TestCase):
    def test_none_is_unfinished(self):
        files = sorted(FOLDER.glob("*.ts"))
        self.assertTrue(files)
        for path in files:
            text = path.read_text(encoding="utf-8")
            self.assertEqual(text.count('type="unfinished"'), 0, path.name)
            self.assertTrue(path.with_suffix(".qm").exists())

    def test_places_for_values_are_kept(self):
        for path in FOLDER.glob("*.ts"):
            pairs = re.findall(r"<source>(.*?)</source>\s*<translation>(.*?)</translation>",
                               path.read_text(encoding="utf-8"), re.DOTALL)
            self.assertGreater(len(pairs), 100)
            for source, translation in pairs:
                self.assertEqual(source.count("{}"), translation.count("{}"), source)

    @unittest.skipUnless(shutil.which("pylupdate5") and shutil.which("lrelease"),
                         "pylupdate5 or lrelease is not installed")
    def test_they_are_up_to_date(self):
        done = subprocess.run([sys.executable, str(ROOT / "tools" / "translations"), "--check"],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
