# SPDX-License-Identifier: LGPL-2.1-or-later
"""The version that tools/release writes, and the notes of a release."""

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile
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
        changes = self.root / "CHANGELOG.md"
        before = changes.read_text(encoding="utf-8")
        changes.write_text(before.replace(release.UNRELEASED, f"{release.UNRELEASED}\n- This one.\n\n## [1.2.2] - 2030-01-01\n"), encoding="utf-8")
        release.set_version("7.8.9", "2031-02-03")
        self.assertEqual(release.notes("7.8.9"), "- This one.\n")
        release.set_version("7.9.0", "2031-03-03")
        self.assertEqual(release.notes("7.9.0").strip(), "")


class Made(unittest.TestCase):
    """A release whose binary and Debian package are not built but stood in for."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.package = self.folder / "freecad-meshquality_1.2.3-1_amd64.deb"
        self.package.write_bytes(b"a package")
        patch = mock.patch.object(release, "run", self.run_command)
        patch.start()
        self.addCleanup(patch.stop)

    def run_command(self, name, *arguments):
        if name == "tools/wheel":
            binary = self.folder / f"_core.cpython-{arguments[1]}-x86_64-linux-gnu.so"
            binary.write_bytes(f"a binary for {arguments[1]}".encode())
            release.wheel_file.write(arguments[3], release.wheel_file.contents(binary, (3, int(arguments[1][1:])), "linux_x86_64", []))
        elif name == "tools/addon_tree":
            subprocess.run([ROOT / name, *arguments], check=True)
        else:
            self.assertEqual((name, *arguments), ("bash", "tools/package", "deb"))
            return f"built\n{self.package}\n"
        return ""

    def made(self, name):
        return release.make(self.folder / name, "Unreleased", "https://code.invalid/mesh", ["311", "313"])

    def test_its_files(self):
        sums = self.made("first")
        self.assertEqual({name.split("-")[0] for name in sums}, {"MeshQuality", "meshquality_core", "freecad", "NOTES.md"})
        self.assertEqual(sorted(Path(name).suffix for name in sums), [".deb", ".json", ".json", ".md", ".whl", ".whl", ".zip", ".zip"])
        subprocess.run(["sha256sum", "--check", "--quiet", "SHA256SUMS"], check=True, cwd=self.folder / "first")

    def test_one_zip_has_the_binaries_of_all_wheels_and_their_licences(self):
        self.made("first")
        plain, whole = sorted((self.folder / "first").glob("*.zip"))
        names = [set(zipfile.ZipFile(path).namelist()) for path in (plain, whole)]
        binaries = {f"MeshQuality/meshquality_core/_core.cpython-{python}-x86_64-linux-gnu.so" for python in ("311", "313")}
        self.assertIn("MeshQuality/package.xml", names[0])
        self.assertFalse(names[0] & binaries)
        self.assertLessEqual(binaries | names[0], names[1])
        self.assertEqual({name.partition("/meshquality_core/")[2] for name in names[1] - names[0] - binaries},
                         {"__init__.py", "licenses/LICENSE"})

    def test_the_same_bytes_twice(self):
        self.assertEqual(self.made("first"), self.made("second"))


class Refusals(unittest.TestCase):
    def test_a_command_that_fails_is_shown_with_what_it_printed(self):
        with self.assertRaises(SystemExit) as ended:
            release.run("sh", "-c", "echo why; exit 3")
        self.assertEqual(str(ended.exception), "why\nsh -c echo why; exit 3 ended with 3")

    def refused(self, *arguments):
        ended = subprocess.run([str(ROOT / "tools" / "release"), *arguments], capture_output=True, text=True, check=False)
        self.assertEqual(ended.returncode, 2)
        return ended.stderr

    def test_what_is_no_version(self):
        self.assertIn("three numbers such as 1.2.0", self.refused("next", "--repository", "here"))

    def test_no_address(self):
        self.assertIn("--repository", self.refused("7.8.9"))
