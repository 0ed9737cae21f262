# SPDX-License-Identifier: LGPL-2.1-or-later
"""The addon without its extension module: it loads, keeps what documents hold, and says what to do."""

import json
import os
import shutil
import subprocess
import sys

import FreeCAD
import helpers

import MeshQuality as mq
from MeshQuality import compat

FREECADCMD = shutil.which("freecadcmd")
SCRIPT = """
import json, os, sys
import FreeCAD, Part
import MeshQuality as mq
from MeshQuality import compat

def told(function):
    try:
        function()
    except mq.MissingBinary as error:
        return str(error)

said = dict(home=compat.HOME, why=compat.why_no_extension())
said["calls"] = [told(call) for call in (
    lambda: mq.triangulate(Part.makeBox(1, 1, 1)), lambda: mq.curve(Part.makeBox(1, 1, 1)),
    lambda: mq.MeshReport, lambda: mq.quality(None))]
document = FreeCAD.openDocument({document!r})
said["facets"] = [o.Mesh.CountFacets for o in document.Objects if hasattr(o, "Mesh")]
document.Box.Length = 12
document.recompute()
said["status"] = [o.getStatusString() for o in document.Objects if hasattr(o, "Mesh")]
said["facets after"] = [o.Mesh.CountFacets for o in document.Objects if hasattr(o, "Mesh")]
with open({result!r}, "w") as stream:
    json.dump(said, stream)
sys.exit(0)
"""


class WithoutBinary(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        self.addon = os.path.join(self.folder, "addon")
        helpers.copy_without_binary(self.addon)

    def test_python_loads_and_every_call_tells_the_remedy(self):
        box = self.box()
        meshes = [mq.add_quality_mesh(box), mq.add_curved_mesh(box)]
        facets = [mesh.Mesh.CountFacets for mesh in meshes]
        saved, result = (os.path.join(self.folder, name) for name in ("saved.FCStd", "result.json"))
        self.document.saveAs(saved)
        script = os.path.join(self.folder, "without.py")
        with open(script, "w", encoding="utf-8") as stream:
            stream.write(SCRIPT.format(document=saved, result=result))
        subprocess.run([FREECADCMD, "-P", os.path.join(self.addon, "Mod"), script], check=True,
                       stdin=subprocess.DEVNULL, capture_output=True, timeout=120)
        with open(result, encoding="utf-8") as stream:
            said = json.load(stream)
        self.assertEqual(said["home"], self.addon)
        self.assertIn("it is not there", said["why"])
        self.assertIn(f"Python {sys.version_info[0]}.{sys.version_info[1]}", said["why"])
        self.assertIn("meshquality_core-", said["why"])
        self.assertEqual(said["calls"], [said["why"]] * 4)
        self.assertEqual(said["facets"], facets)
        self.assertEqual(said["facets after"], facets)
        for status in said["status"]:
            self.assertIn("meshquality_core-", status)

    def test_the_command_says_so_and_fails(self):
        part = os.path.join(self.folder, "part.step")
        self.box().Shape.exportStep(part)
        program = os.path.join(self.addon, "bin", "meshquality")
        environment = {name: value for name, value in os.environ.items() if name != "MESHQUALITY_JOB"}
        done = subprocess.run(["/usr/bin/python3", program,
                               "triangulate", part], stdin=subprocess.DEVNULL, env=environment,
                              capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 1)
        self.assertIn("meshquality_core-", done.stderr)
        self.assertNotIn("Traceback", done.stderr)

    def test_with_it_nothing_is_missing(self):
        self.assertEqual(compat.why_no_extension(), "")
        self.assertIn(".".join(FreeCAD.Version()[:2]), compat.versions())
