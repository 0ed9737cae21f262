# SPDX-License-Identifier: LGPL-2.1-or-later
"""The recipes for the console in the guides do what they say."""

import os
import re
import tempfile

import FreeCAD
import helpers
import Mesh
import Part

import MeshQuality as mq

_BLOCK = re.compile(r"^```python\n(.*?)^```", re.MULTILINE | re.DOTALL)


def recipes(guide):
    """The blocks of Python of a guide."""
    with open(os.path.join(helpers.ROOT, guide), encoding="utf-8") as stream:
        return _BLOCK.findall(stream.read())


class Recipes(helpers.DocumentTest):
    def setUp(self):
        super().setUp()
        body = self.document.addObject("Part::Cylinder", "Body")
        body.Radius, body.Height = 10, 30
        for name in ("Scan", "Imported"):
            scan = self.document.addObject("Mesh::Feature", name)
            scan.Mesh = Mesh.createSphere(9.0, 40)
        self.box()
        self.document.recompute()
        FreeCAD.setActiveDocument(self.document.Name)
        self.names = {
            "mq": mq, "App": FreeCAD, "FreeCAD": FreeCAD, "Part": Part,
            "shape": Part.makeCylinder(10, 30).cut(Part.makeSphere(8)),
            "mesh": Mesh.createSphere(5.0, 30), "scan": Mesh.createSphere(9.0, 40),
            **{name: Mesh.createBox(2 + i, 3, 4) for i, name in enumerate("abcd")},
        }
        before, scratch = os.getcwd(), tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        os.chdir(scratch.name)
        self.addCleanup(os.chdir, before)

    def follow(self, guide):
        found = recipes(guide)
        self.assertTrue(found)
        for text in found:
            exec(compile(text, guide, "exec"), self.names)

    def test_readme(self):
        names = self.names = {"App": FreeCAD}  # nothing else is there for who follows it
        self.follow("README.md")
        self.addCleanup(FreeCAD.closeDocument, names["document"].Name)
        self.assertGreaterEqual(names["better"].report.min_angle, 25)
        self.assertTrue(names["part"].report.closed and names["part"].report.faults_left == 0)
        self.assertEqual(names["curved"].report.invalid, 0)
        self.assertEqual(sorted(os.listdir(".")), ["part.msh", "part.ply"])
        kinds = [type(obj.Proxy).__name__ for obj in names["document"].Objects if hasattr(obj, "Proxy")]
        self.assertEqual(kinds, ["QualityMesh", "CurvedMeshObject", "MeshBoolean"])

    def test_improving(self):
        self.follow("docs/improve.md")
        self.assertGreaterEqual(self.names["better"].report.min_angle, 25)

    def test_sampling(self):
        self.follow("docs/sampling.md")

    def test_booleans(self):
        self.follow("docs/booleans.md")

    def test_curved_meshes(self):
        self.follow("docs/curved-meshes.md")
