# SPDX-License-Identifier: LGPL-2.1-or-later
"""The version that tools/release writes, and the notes of a release."""

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from importlib.machinery import SourceFileLoader
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
release = SourceFileLoader("release", str(ROOT / "tools" / "release")).load_module()


class Version(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        for name in (*release.NAMED, "CHANGELOG.md"):
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / name, self.root / name)
        patch = mock.patch.object(release, "ROOT", self.root)
        patch.start()
        self.addCleanup(patch.stop)

    def test_every_file_names_it(self):
        self.assertTrue(release.set_version("7.8.9", "2031-02-03"))
        for name, pattern in release.NAMED.items():
            self.assertEqual(re.search(pattern, (self.root / name).read_text(encoding="utf-8"))[1], "7.8.9", name)
        self.assertIn("<date>2031-02-03</date>", (self.root / "package.xml").read_text(encoding="utf-8"))

    def test_written_once(self):
        release.set_version("7.8.9", "2031-02-03")
        self.assertFalse(release.set_version("7.8.9", "2031-02-04"))

    def test_what_was_unreleased_becomes_its_section(self):
        before = (self.root / "CHANGELOG.md").read_text(encoding="utf-8")
        release.set_version("7.8.9", "2031-02-03")
        self.assertEqual(release.notes("7.8.9").strip(), before.partition("## [Unreleased]\n")[2].strip())
        release.set_version("7.9.0", "2031-03-03")
        self.assertEqual(release.notes("7.9.0").strip(), "")


class Refusals(unittest.TestCase):
    def refused(self, *arguments):
        ended = subprocess.run([str(ROOT / "tools" / "release"), *arguments], capture_output=True, text=True, check=False)
        self.assertEqual(ended.returncode, 2)
        return ended.stderr

    def test_what_is_no_version(self):
        self.assertIn("three numbers such as 1.2.0", self.refused("next", "--repository", "here"))

    def test_no_address(self):
        self.assertIn("--repository", self.refused("7.8.9"))
