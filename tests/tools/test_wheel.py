# SPDX-License-Identifier: LGPL-2.1-or-later
"""What tools/wheel puts beside the binary, that equal content gives equal bytes, and the tree for FreeCAD's index of addons."""

import base64
import csv
import email
import hashlib
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
import zipfile
from importlib.machinery import SourceFileLoader
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[2]
SPACE = "{https://wiki.freecad.org/Package_Metadata}"
sys.path.insert(0, str(ROOT / "tools"))

import own_opencascade  # noqa: E402
import python_headers  # noqa: E402
import wheel_file  # noqa: E402

wheel = SourceFileLoader("wheel", str(ROOT / "tools" / "wheel")).load_module()
PARTS = [wheel_file.Part("kernel", "7.6.3", "LGPL-2.1-only WITH OCCT-exception-1.0", "pkg:deb/debian/kernel@7.6.3", "STATIC_LINK",
                         {"kernel.txt": "terms of the kernel"}),
         wheel_file.Part("headers", "3.4", "MPL-2.0", "pkg:deb/debian/headers@3.4", "CONTAINS", {"headers.txt": "terms of the headers"})]
VERSION = ElementTree.parse(ROOT / "package.xml").findtext(f"{SPACE}version")
INFO = f"meshquality_core-{VERSION}.dist-info"


class File(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.binary = self.folder / "_core.cpython-311-x86_64-linux-gnu.so"
        self.binary.write_bytes(b"\x7fELF of a test")

    def made(self, into=""):
        folder = self.folder / into
        folder.mkdir(exist_ok=True)
        return wheel_file.write(folder, wheel_file.contents(self.binary, (3, 11), "manylinux_2_35_x86_64", PARTS))

    def test_metadata_is_that_of_the_package(self):
        with zipfile.ZipFile(self.made()) as archive:
            said = email.message_from_bytes(archive.read(f"{INFO}/METADATA"))
            names = archive.namelist()
        self.assertEqual((said["Name"], said["Version"], said["Requires-Python"]), ("meshquality-core", VERSION, "==3.11.*"))
        self.assertEqual(said["License-Expression"], "LGPL-2.1-or-later AND LGPL-2.1-only WITH OCCT-exception-1.0 AND MPL-2.0")
        self.assertEqual({name for name in names if "/licenses/" in name},
                         {f"{INFO}/licenses/{name}" for name in said.get_all("License-File")})
        self.assertIsNone(said["Requires-Dist"])

    def test_its_name_and_its_tag_agree(self):
        path = self.made()
        self.assertEqual(path.name, f"meshquality_core-{VERSION}-cp311-cp311-manylinux_2_35_x86_64.whl")
        with zipfile.ZipFile(path) as archive:
            self.assertIn("\nTag: cp311-cp311-manylinux_2_35_x86_64\n", archive.read(f"{INFO}/WHEEL").decode())

    def test_the_record_knows_every_file(self):
        with zipfile.ZipFile(self.made()) as archive:
            rows = {row[0]: row[1:] for row in csv.reader(archive.read(f"{INFO}/RECORD").decode().splitlines())}
            self.assertEqual(set(rows), set(archive.namelist()))
            self.assertEqual(rows.pop(f"{INFO}/RECORD"), ["", ""])
            for name, (digest, size) in rows.items():
                content = archive.read(name)
                expected = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode().rstrip("=")
                self.assertEqual((digest, int(size)), (f"sha256={expected}", len(content)), name)

    def test_lists_what_is_inside(self):
        with zipfile.ZipFile(self.made()) as archive:
            said = json.loads(archive.read(f"{INFO}/sboms/meshquality-core.spdx.json"))
        self.assertEqual({package["name"]: package["licenseDeclared"] for package in said["packages"][1:]},
                         {part.name: part.licence for part in PARTS})
        known = {"SPDXRef-DOCUMENT", *(package["SPDXID"] for package in said["packages"])}
        for relation in said["relationships"]:
            self.assertLessEqual({relation["spdxElementId"], relation["relatedSpdxElement"]}, known)

    def test_equal_content_gives_equal_bytes(self):
        first = self.made("first").read_bytes()
        os.utime(self.binary, (1, 1))
        self.assertEqual(self.made("second").read_bytes(), first)
        with mock.patch.dict(os.environ, {"SOURCE_DATE_EPOCH": "1600000000"}):
            self.assertNotEqual(self.made("third").read_bytes(), first)

    def test_a_licence_in_a_comment_is_found(self):
        source = self.folder / "small.cpp"
        source.write_text("/*\n MIT License\n*/\n\n#include <set> /* sets */\n", encoding="utf-8")
        self.assertEqual(wheel_file.leading_comment(source), "/*\n MIT License\n*/\n")


class Build(unittest.TestCase):
    def test_the_loader_is_shown_the_entry_alone(self):
        script = (ROOT / "src" / "python" / "exports.map").read_text(encoding="utf-8")
        self.assertEqual(re.findall(r"(global|local): (.*);", script), [("global", "PyInit_*"), ("local", "*")])

    def test_what_is_shown_and_needed_is_read(self):
        with tempfile.TemporaryDirectory() as folder:
            source, library = Path(folder, "two.c"), Path(folder, "two.so")
            source.write_text("#include <math.h>\nint PyInit_two(void) { return 0; }\ndouble other(double x) { return pow(x, x); }\n",
                              encoding="utf-8")
            subprocess.run(["cc", "-shared", "-fPIC", "-o", library, source, "-lm"], check=True)
            self.assertEqual(wheel.exported(library), {"PyInit_two", "other"})
            self.assertEqual(wheel.needed(library), {"libm.so.6"})
            subprocess.run(["cc", "-shared", "-fPIC", "-o", library, source, "-lm",
                            f"-Wl,--version-script={ROOT / 'src' / 'python' / 'exports.map'}"], check=True)
            self.assertEqual(wheel.exported(library), {"PyInit_two"})

    def test_a_python_that_is_not_here_is_named_by_its_version(self):
        with mock.patch.object(python_headers, "provide", return_value="headers"):
            version, settings = wheel.of_python("3.14")
        self.assertEqual((version, settings["Python_INCLUDE_DIR"]), ((3, 14), "headers"))
        self.assertRegex(settings["PYTHON_MODULE_EXTENSION"], r"^\.cpython-314-\w+-linux-gnu\.so$")
        version, settings = wheel.of_python(sys.executable)
        self.assertEqual((version, settings), (sys.version_info[:2], {"Python_EXECUTABLE": sys.executable}))

    def test_another_setting_is_another_opencascade(self):
        before = own_opencascade.folder()
        self.assertEqual(own_opencascade.folder(), before)
        self.assertIn("occt-7.6.3-", before.name)
        with mock.patch.dict(own_opencascade.SETTINGS, {"USE_TBB": "ON"}):
            self.assertNotEqual(own_opencascade.folder(), before)

    def test_what_pypi_gives_is_pinned(self):
        text = (ROOT / "packaging" / "requirements.txt").read_text(encoding="utf-8")
        for line in text.splitlines():
            self.assertRegex(line, r"^#|^[\w-]+==[\d.]+ --hash=sha256:[0-9a-f]{64}$")


MADE = sorted((ROOT / "build-wheel").glob("*.whl"))


@unittest.skipUnless(MADE, "no wheel in build-wheel: tools/wheel makes one, the first time in half an hour")
class Made(unittest.TestCase):
    def test_it_shows_its_entry_alone_and_needs_the_system_alone(self):
        for path in MADE:
            with tempfile.TemporaryDirectory() as folder, zipfile.ZipFile(path) as archive:
                binary, = (name for name in archive.namelist() if name.endswith(".so"))
                binary = archive.extract(binary, folder)
                self.assertEqual(wheel.exported(binary), {"PyInit__core"}, path.name)
                self.assertLessEqual(wheel.needed(binary), wheel.SYSTEM_LIBRARIES, path.name)
                self.assertLess(path.stat().st_size, wheel.MOST_BYTES, path.name)


class AddonTree(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.tree = Path(folder.name, "addon")
        subprocess.run([sys.executable, ROOT / "tools" / "addon_tree", cls.tree], check=True)

    def test_metadata_alone_is_at_its_top(self):
        self.assertEqual({path.name for path in self.tree.iterdir()},
                         {"package.xml", "requirements.txt", "LICENSE", "README.md", "CHANGELOG.md", "freecad"})
        self.assertEqual([path.name for path in (self.tree / "freecad").iterdir()], ["MeshQuality"])

    def test_has_no_binary(self):
        kinds = {path.suffix for path in (self.tree / "freecad" / "MeshQuality" / "Mod").rglob("*") if path.is_file()}
        self.assertEqual(kinds, {".py"})

    def test_its_package_names_files_that_exist_and_the_binary(self):
        said = ElementTree.parse(self.tree / "package.xml")
        for path in (*(element.text for element in said.iter(f"{SPACE}icon")),
                     *(element.get("file") for element in said.iter(f"{SPACE}license"))):
            self.assertTrue((self.tree / path).is_file(), path)
        self.assertIn(wheel_file.PACKAGE, [element.text for element in said.iter(f"{SPACE}depend")])
        self.assertEqual((self.tree / "requirements.txt").read_text(encoding="utf-8"), f"{wheel_file.PACKAGE}=={VERSION}\n")

    def test_links_of_its_readme_lead_somewhere(self):
        links = re.findall(r"\]\(([^):#]+)", (self.tree / "README.md").read_text(encoding="utf-8"))
        self.assertTrue(links)
        for link in links:
            self.assertTrue((self.tree / link).exists(), link)

    def test_a_release_gives_the_address(self):
        def addresses(folder):
            return [element.text for element in ElementTree.parse(folder / "package.xml").iter(f"{SPACE}url")]

        released = self.tree.with_name("released")
        subprocess.run([sys.executable, ROOT / "tools" / "addon_tree", released, "https://code.invalid/mesh"], check=True)
        self.assertEqual(addresses(released)[0], "https://code.invalid/mesh")
        self.assertEqual([address.replace("@REPOSITORY@", "https://code.invalid/mesh") for address in addresses(self.tree)],
                         addresses(released))


if __name__ == "__main__":
    unittest.main()
