# SPDX-License-Identifier: LGPL-2.1-or-later
"""The addon of FreeCAD's index in an empty user folder: without its binary, and with that of a Python package."""

import glob
import json
import os
import re
import shutil
import subprocess
import sys

import helpers
import Mesh

import MeshQuality as mq
from MeshQuality import compat

FREECADCMD = shutil.which("freecadcmd")
SCRIPT = """
import importlib, json, sys
loaded = [name for name in ("numpy", "Part", "MeshQuality.phrases", "MeshQuality._core") if name in sys.modules]
import FreeCAD, Part
import MeshQuality as mq
from MeshQuality import compat

said = dict(loaded=loaded, types=[FreeCAD.getExportType("stl"), FreeCAD.getImportType("msh")])
box = FreeCAD.newDocument().addObject("Part::Box", "Box")
box.Document.recompute()
try:
    importlib.import_module(said["types"][0][-1]).export([box], {exported!r})
except mq.MissingBinary as error:
    said["export"] = str(error)
said.update(home=compat.HOME, why=compat.why_no_extension(), version=mq.__version__)
if not said["why"]:
    mesh = mq.triangulate(Part.makeBox(1, 2, 3))
    said.update(triangles=len(mesh.triangles), binary=compat.extension().__file__, name=type(mesh.report).__module__)
    try:
        mq.triangulate(Part.Shape())
    except mq.InvalidInput as error:
        said["error"] = str(error)
with open({result!r}, "w") as stream:
    json.dump(said, stream)
sys.exit(0)
"""


class Addon(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        self.place = os.path.join(self.folder, "user", "Mod", "MeshQuality")
        self.packages = os.path.join(self.folder, "user", "AdditionalPythonPackages")  # FreeCAD 1.0 takes no PYTHONPATH
        os.makedirs(os.path.dirname(self.place))
        subprocess.run([sys.executable if "python" in os.path.basename(sys.executable) else "/usr/bin/python3",
                        os.path.join(helpers.ROOT, "tools", "addon_tree"), self.place], check=True)

    def core_package(self, version, folder=None):
        """The binaries of this tree, in the form of the Python package meshquality-core."""
        package = os.path.join(folder or self.packages, "meshquality_core")
        os.makedirs(package)
        with open(os.path.join(package, "__init__.py"), "w", encoding="utf-8") as stream:
            stream.write(f"__version__ = {version!r}\n")
        for binary in glob.glob(os.path.join(os.path.dirname(compat.extension().__file__), "*.so")):
            os.symlink(binary, os.path.join(package, os.path.basename(binary)))
        return package

    def said(self):
        """What FreeCAD says that knows the user folder and the folder of Python packages alone."""
        script, result = (os.path.join(self.folder, name) for name in ("script.py", "result.json"))
        with open(script, "w", encoding="utf-8") as stream:
            stream.write(SCRIPT.format(result=result, exported=os.path.join(self.folder, "box.stl")))
        environment = {**os.environ, "FREECAD_USER_HOME": os.path.join(self.folder, "user")}
        subprocess.run([FREECADCMD, script], check=True, stdin=subprocess.DEVNULL, capture_output=True, env=environment, timeout=120)
        with open(result, encoding="utf-8") as stream:
            return json.load(stream)

    def test_without_the_binary_it_says_what_to_install(self):
        said = self.said()
        self.assertIn("it is not there", said["export"])
        self.assertFalse(os.path.exists(os.path.join(self.folder, "box.stl")))
        self.assertEqual(said["home"], os.path.join(self.place, "freecad", "MeshQuality"))
        self.assertIn("it is not there", said["why"])
        self.assertIn(f"meshquality_core-{mq.__version__}-cp{sys.version_info[0]}{sys.version_info[1]}-*.whl", said["why"])

    def test_where_it_says_that_a_wheel_is_to_be_unpacked_it_is_found(self):
        package = self.core_package(mq.__version__, re.search(r"into the folder (\S+),", self.said()["why"])[1])
        said = self.said()
        self.assertEqual((said["why"], os.path.dirname(said["binary"])), ("", package))

    def test_freecad_starts_with_the_types_of_files_alone(self):
        self.core_package(mq.__version__)
        said = self.said()
        self.assertEqual([types[-1] for types in said["types"]], ["MeshQuality.exchange"] * 2)
        self.assertEqual(said["types"][0][0], "Mesh")
        self.assertEqual(said["loaded"], [])
        self.assertTrue(Mesh.Mesh(os.path.join(self.folder, "box.stl")).isSolid())

    def test_freecadcmd_converts_a_document(self):
        self.core_package(mq.__version__)
        self.box()
        document, written = (os.path.join(self.folder, name) for name in ("box.FCStd", "box.msh"))
        self.document.saveAs(document)
        environment = {**os.environ, "FREECAD_USER_HOME": os.path.join(self.folder, "user")}
        subprocess.run([FREECADCMD, document, "--output", written], check=True, stdin=subprocess.DEVNULL, capture_output=True,
                       env=environment, timeout=120)
        self.assertEqual(mq.read_mesh(written).blocks[0][:2], ("tetrahedron", 2))

    def test_the_python_package_is_the_same_module(self):
        package = self.core_package(mq.__version__)
        said = self.said()
        self.assertEqual((said["why"], os.path.dirname(said["binary"])), ("", package))
        self.assertEqual(said["name"], type(mq.triangulate(self.box().Shape).report).__module__)
        self.assertGreaterEqual(said["triangles"], 12)
        self.assertIn("null", said["error"])

    def test_a_python_package_of_another_version_is_refused(self):
        self.core_package("0.0.1")
        self.assertIn(f"meshquality-core is of version 0.0.1, not {mq.__version__}", self.said()["why"])
