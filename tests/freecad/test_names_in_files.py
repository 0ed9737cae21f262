# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patches by random names in every format and order: refused by name, or written so that the names are read back."""

import json
import os
import random
import re
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
import zipfile

import FreeCAD
import Part
import test_exchange
import test_patches

import MeshQuality as mq
from MeshQuality import formats

PIECES = ("inlet", "Inlet", "INLET", "a b", "\u5165\u53e3", "\u00e9t\u00e9", '"', "'", "<", ">&amp;", "]]>", "1", "-", "$", "#",
          "%", "\\", "/", ";", ",", "{", "*", "\U0001f600", "Face1", "Solid1", "x" * 30, "y" * 200)

READ_BY_GMSH = """
import json, sys
import gmsh
gmsh.initialize()
gmsh.option.setNumber("General.Verbosity", 0)
found = {}
for path in sys.argv[1:]:
    gmsh.open(path)
    counts = found[path] = {}
    for dimension, tag in gmsh.model.getPhysicalGroups(2):
        entities = gmsh.model.getEntitiesForPhysicalGroup(dimension, tag)
        counts[gmsh.model.getPhysicalName(dimension, tag)] = sum(
            len(block) for entity in entities for block in gmsh.model.mesh.getElements(2, entity)[1])
    gmsh.clear()
print(json.dumps(found))
"""


def name_of(chance):
    return "".join(chance.choice(PIECES) for _ in range(chance.choice((1, 1, 2, 3)))).strip()


def patches_for(chance, faces):
    """Some faces by random names, and a patch without any."""
    names = list({name_of(chance): None for _ in range(chance.randint(1, 4))})
    patches = {name: [] for name in names}
    for face in range(1, faces + 1):
        patches[chance.choice(names)].append(f"Face{face}")
    return patches


def meshes():
    corner = Part.Face(Part.makePolygon([FreeCAD.Vector(*p) for p in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 0))]))
    box = Part.makeBox(1, 2, 3)
    yield 1, mq.triangulate(corner)
    yield 6, mq.triangulate(box)
    for order in (1, 2, 3, 4):
        yield 6, mq.curve(box, order=order)
        yield 6, mq.curve(box, order=order, volume=True)


class NamesInFiles(unittest.TestCase):
    def test_they_are_refused_or_read_back(self):
        chance, written = random.Random(7), {}
        with tempfile.TemporaryDirectory() as folder:
            for number, (faces, mesh) in enumerate(meshes()):
                for trial in range(6):
                    patches = patches_for(chance, faces)
                    for suffix in formats.SUFFIXES:
                        path = os.path.join(folder, f"{number}_{trial}{suffix}")
                        if self.is_written(mesh, path, patches):
                            written[path] = self.counts(mesh, patches)
                            self.check_text(path, patches)
            self.assertGreater(len(written), 300)
            self.check_by_gmsh({path: counts for path, counts in written.items() if ".msh" in path})

    def is_written(self, mesh, path, patches):
        """Whether it was; otherwise the error names a patch, or says that the elements are not for this format."""
        suffix = os.path.splitext(path)[1]
        if suffix == ".cgns" and not test_patches.has_cgns() or suffix == ".exo" and not test_patches.has_netcdf():
            return False
        try:
            mesh.write(path, patches=patches)
        except mq.InvalidInput as error:
            self.assertTrue(any(repr(name) in str(error) for name in patches) or "elements of order" in str(error), error)
        except mq.IoError as error:
            self.assertIn("curved elements are written into", str(error))
        if not os.path.exists(path):
            return False
        self.assertGreater(os.path.getsize(path), 0)
        return True

    @staticmethod
    def counts(mesh, patches):
        """{patch: triangles}, of those that have some."""
        faces = mesh.triangle_face.tolist()
        found = {name: sum(faces.count(int(face[4:]) - 1) for face in chosen) for name, chosen in patches.items()}
        return {name: count for name, count in found.items() if count}

    def check_text(self, path, patches):
        suffix = os.path.splitext(path)[1]
        if suffix == ".3mf":
            with zipfile.ZipFile(path) as container:
                model = ElementTree.fromstring(container.read("3D/3dmodel.model"))
            self.assertEqual([base.get("name") for base in model.iter() if base.tag.endswith("}base")], list(patches))
        elif suffix in (".amf", ".vtu"):
            ElementTree.parse(path)
        elif suffix in (".su2", ".obj", ".fms"):
            pattern = {".su2": r"^MARKER_TAG= (.*)$", ".obj": r"^g (.*)$", ".fms": r"^(.*) wall$"}[suffix]
            with open(path, encoding="utf-8") as stream:
                self.assertEqual(re.findall(pattern, stream.read(), re.MULTILINE), list(patches))

    @unittest.skipUnless(test_exchange.has("gmsh"), "Gmsh's Python module is not installed")
    def check_by_gmsh(self, expected):
        done = subprocess.run(["/usr/bin/python3", "-c", READ_BY_GMSH, *expected], capture_output=True, text=True,
                              timeout=300, check=True)
        found = json.loads(done.stdout.splitlines()[-1])
        for path, counts in expected.items():
            with self.subTest(path):
                self.assertEqual({name: count for name, count in found[path].items() if count}, counts)
