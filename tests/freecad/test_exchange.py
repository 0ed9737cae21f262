# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files with patches, read back by other programs: numbers of nodes and elements, names of patches and how many triangles
each has come back equal.
"""

import os
import re
import shutil
import subprocess
import unittest
import zipfile
from xml.etree import ElementTree

import FreeCAD
import numpy as np
import Part
import test_curved_files
import test_patches
from test_curved_files import has

import MeshQuality as mq
from MeshQuality import formats

PATCHES = {"inlet": ["Face1", "Face2"], "outlet": {"faces": ["Face3"], "colour": "#ff0000"}}

READ_BY_MESHIO = """
import json, sys, warnings
import meshio
warnings.simplefilter("ignore")
path, form = sys.argv[1:]
mesh = meshio.read(path, file_format=form)
cells = {}
for block in mesh.cells:
    cells[block.type] = cells.get(block.type, 0) + len(block.data)
print(json.dumps({
    "points": len(mesh.points), "cells": cells, "blocks": [len(block.data) for block in mesh.cells],
    "size": float(abs(mesh.points).max()),
    "sets": {name: sum(len(part) for part in parts) for name, parts in mesh.cell_sets.items()},
    "nodes": {name: len(nodes) for name, nodes in mesh.point_sets.items()},
    "data": {name: [int(x) for part in parts for x in part] for name, parts in mesh.cell_data.items()
             if parts[0].ndim == 1 and parts[0].dtype.kind == "i"}}))
"""

READ_BY_GMSH = """
import json, sys
import gmsh
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.open(sys.argv[1])
groups, elements = {}, {}
for dimension, tag in gmsh.model.getPhysicalGroups():
    parts = gmsh.model.getEntitiesForPhysicalGroup(dimension, tag)
    groups[gmsh.model.getPhysicalName(dimension, tag)] = sum(
        len(found) for part in parts for found in gmsh.model.mesh.getElements(dimension, part)[1])
for dimension in (2, 3):
    elements[dimension] = sum(len(found) for found in gmsh.model.mesh.getElements(dimension)[1])
print(json.dumps({"nodes": len(gmsh.model.mesh.getNodes()[0]), "groups": groups, "elements": elements}))
"""

READ_BY_VTK = """
import json, sys
from vtkmodules.vtkIOExodus import vtkExodusIIReader as Reader
reader = Reader()
reader.SetFileName(sys.argv[1])
reader.UpdateInformation()
found = {}
for kind, name in ((Reader.ELEM_BLOCK, "blocks"), (Reader.SIDE_SET, "sides")):
    found[name] = {reader.GetObjectName(kind, i): reader.GetNumberOfEntriesInObject(kind, i)
                   for i in range(reader.GetNumberOfObjects(kind))}
    reader.SetAllArrayStatus(kind, 1)
reader.Update()
print(json.dumps(found))
"""

READ_BY_HDF5 = """
import json, sys
import h5py
zone = h5py.File(sys.argv[1])["Base/Zone1"]
sections = {name: [int(x) for x in node["ElementRange/ data"][()]] for name, node in zone.items()
            if "ElementRange" in node}
families = {name: bytes(node["FamilyName/ data"][()]).decode() for name, node in zone["ZoneBC"].items() if name[0] != " "}
print(json.dumps({"sections": {name: last - first + 1 for name, (first, last) in sections.items()},
                  "families": families, "points": len(zone["GridCoordinates/CoordinateX/ data"])}))
"""


def part():
    """A box with a round boss: eight faces, plane and curved."""
    return Part.makeBox(10, 20, 30).fuse(Part.makeCylinder(4, 10, FreeCAD.Vector(5, 10, 25)))


def run(*command):
    """What a program prints; OpenFOAM's are told where Debian has their files."""
    environment = {**os.environ, "WM_PROJECT_DIR": os.environ.get("WM_PROJECT_DIR", "/usr/share/openfoam")}
    done = subprocess.run(command, capture_output=True, text=True, timeout=300, check=False, env=environment)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


class Exchange(test_curved_files.FileTest):
    @classmethod
    def setUpClass(cls):
        cls.flat = mq.triangulate(part(), patches=PATCHES, patch_rest="walls")
        cls.curved = {(order, volume): mq.curve(part(), order=order, volume=volume, patches=PATCHES, patch_rest="walls")
                      for order in (1, 2) for volume in (False, True)}

    @staticmethod
    def counts(mesh):
        """{patch: triangles}"""
        return {name: int((mesh.triangle_patch == i).sum()) for i, name in enumerate(mesh.patches)}

    @staticmethod
    def node_counts(mesh):
        """{patch: nodes}"""
        return {name: len(np.unique(mesh.triangles[mesh.triangle_patch == i])) for i, name in enumerate(mesh.patches)}

    def put(self, mesh, name, **how):
        path = os.path.join(self.folder, name)
        mesh.write(path, **how)
        return path

    def by_meshio(self, mesh, name, form=None, **how):
        path = self.put(mesh, name, **how)
        return self.read(READ_BY_MESHIO, [path, form or {"nas": "nastran", "inp": "abaqus", "msh2": "gmsh"}.get(
            name.rpartition(".")[2], name.rpartition(".")[2])])

    def numbers(self, mesh, found, first=1):
        """Checks by triangle the number of its patch."""
        self.assertEqual(found[:len(mesh.triangles)], (mesh.triangle_patch + first).tolist())


@unittest.skipUnless(has("meshio"), "meshio (python3-meshio) is not installed")
class ByMeshio(Exchange):
    def test_flat_triangles(self):
        mesh, total = self.flat, len(self.flat.triangles)
        counts = list(self.counts(mesh).values())
        for name, form in (("a.obj", "obj"), ("a.stl", "stl"), ("a.off", "off"), ("a.vtu", "vtu")):
            found = self.by_meshio(mesh, name, form, ascii=name == "a.stl", scale=0.5)
            self.assertEqual((found["points"], found["cells"]), (len(mesh.vertices), {"triangle": total}), name)
            self.assertEqual(found["size"], 17.5)
            if name == "a.obj":
                self.assertEqual(found["blocks"], counts)
            if name == "a.vtu":
                self.numbers(mesh, found["data"]["patch"], first=0)

    def test_nastran(self):
        self.numbers(self.flat, self.by_meshio(self.flat, "a.nas")["data"]["nastran:ref"])
        for (order, volume), mesh in self.curved.items():
            found = self.by_meshio(mesh, "a.nas")
            cells = {"triangle" if order == 1 else "triangle6": len(mesh.triangles)}
            if volume:
                cells["tetra" if order == 1 else "tetra10"] = len(mesh.tetrahedra)
            self.assertEqual((found["points"], found["cells"]), (len(mesh.nodes), cells))
            self.numbers(mesh, found["data"]["nastran:ref"])

    def test_abaqus(self):
        found = self.by_meshio(self.flat, "a.inp")
        self.assertEqual((found["sets"], found["nodes"]), (self.counts(self.flat), self.node_counts(self.flat)))
        for order in (1, 2):
            mesh = self.curved[order, True]
            found = self.by_meshio(mesh, "a.inp")
            self.assertEqual(found["cells"], {"tetra" if order == 1 else "tetra10": len(mesh.tetrahedra)})
            self.assertEqual(found["nodes"], self.node_counts(mesh))
            behind = mesh._curved.tetrahedra_behind()
            expected = {name: len(np.unique(behind[mesh.triangle_patch == i])) for i, name in enumerate(mesh.patches)}
            self.assertEqual({name: found["sets"][name] for name in expected}, expected)

    def test_exodus(self):
        if not test_patches.has_netcdf():
            self.skipTest("netCDF for Python (python3-netcdf4) is not installed")
        for mesh in (self.flat, *self.curved.values()):
            found = self.by_meshio(mesh, "a.exo", "exodus")
            solids = getattr(mesh, "tetrahedra", ())
            self.assertEqual(found["blocks"], [len(solids)] if len(solids) else list(self.counts(mesh).values()))

    def test_su2(self):
        mesh = self.curved[1, True]
        found = self.by_meshio(mesh, "a.su2")
        self.assertEqual((found["points"], found["cells"]),
                         (len(mesh.nodes), {"tetra": len(mesh.tetrahedra), "triangle": len(mesh.triangles)}))
        tags = np.array(found["data"]["su2:tag"][len(mesh.tetrahedra):])
        self.assertEqual([int((tags == i + 1).sum()) for i in range(len(mesh.patches))], list(self.counts(mesh).values()))
        with open(os.path.join(self.folder, "a.su2"), encoding="utf-8") as stream:
            self.assertEqual(re.findall(r"MARKER_TAG= (\w+)", stream.read()), list(mesh.patches))

    def test_gmsh(self):
        for name in ("a.msh", "a.msh2"):
            found = self.by_meshio(self.flat, name, "gmsh")["data"]["gmsh:physical"]
            self.assertEqual([found.count(i + 1) for i in range(len(self.flat.patches))], list(self.counts(self.flat).values()))


@unittest.skipUnless(has("gmsh"), "Gmsh's Python module is not installed")
class ByGmsh(Exchange):
    def test_physical_groups(self):
        for name in ("a.msh", "a.msh2"):
            for mesh in (self.flat, *self.curved.values()):
                found = self.read(READ_BY_GMSH, [self.put(mesh, name)])
                self.assertEqual({patch: found["groups"][patch] for patch in mesh.patches}, self.counts(mesh))
                self.assertEqual(found["nodes"], len(mesh.vertices if mesh is self.flat else mesh.nodes))

    def test_numbers_of_elements(self):
        for name in ("a.nas", "a.unv"):
            for mesh in (self.flat, *self.curved.values()):
                found = self.read(READ_BY_GMSH, [self.put(mesh, name)])
                self.assertEqual(found["elements"], {"2": len(mesh.triangles), "3": len(getattr(mesh, "tetrahedra", ()))})


@unittest.skipUnless(shutil.which("surfaceCheck"), "OpenFOAM (openfoam) is not installed")
class ByOpenFoam(Exchange):
    def test_surfaces_are_closed_and_have_the_patches(self):
        for name in ("a.stl", "a.obj"):
            said = run("surfaceCheck", self.put(self.flat, name, ascii=name == "a.stl", scale=0.001))
            regions = re.search(r"Region\s+Size\n-+\s+-+\n((?:\w+\s+\d+\n)+)", said)[1]
            self.assertEqual({line.split()[0]: int(line.split()[1]) for line in regions.splitlines()}, self.counts(self.flat))
            self.assertIn("Surface is closed", said)
            self.assertIn("Surface has no illegal triangles", said)

    def test_feature_edges(self):
        path = self.put(self.flat, "a.eMesh")
        said = run("surfaceFeatureConvert", path, os.path.join(self.folder, "a.obj"))
        with open(path, encoding="utf-8") as stream:
            points, edges = (int(n) for n in re.findall(r"^(\d+)$", stream.read(), re.MULTILINE))
        self.assertIn(f"points      : {points}\nedges       : {edges}\n", said)
        self.assertGreater(edges, 20)


class ByOthers(Exchange):
    @unittest.skipUnless(test_patches.has_cgns() and shutil.which("cgnscheck"), "cgnscheck (cgns-convert) is not installed")
    def test_cgnscheck_finds_nothing(self):
        for mesh in (self.flat, *self.curved.values()):
            for scale in (1.0, 0.001, 3.0):
                said = run("cgnscheck", self.put(mesh, "a.cgns", scale=scale))
                self.assertNotRegex(said, "WARNING|ERROR")
                for name in mesh.patches:
                    self.assertIn(f'checking BC "{name}"', said)

    @unittest.skipUnless(test_patches.has_cgns() and shutil.which("cgnscheck"), "cgnscheck (cgns-convert) is not installed")
    def test_cgns_patches_with_the_name_of_the_family_of_the_zone(self):
        named = {"wall": ["Face1"], "Mesh1": ["Face2"], "Mesh2": ["Face3"]}
        said = run("cgnscheck", self.put(mq.triangulate(Part.makeBox(1, 2, 3), patches=named), "a.cgns"))
        self.assertNotRegex(said, "WARNING|ERROR")
        for name in named:
            self.assertIn(f'checking BC "{name}"', said)

    @unittest.skipUnless(test_patches.has_cgns() and has("h5py"), "the CGNS library or h5py is not installed")
    def test_cgns_has_a_section_and_a_family_a_patch(self):
        for mesh in (self.flat, *self.curved.values()):
            found = self.read(READ_BY_HDF5, [self.put(mesh, "a.cgns")])
            solids = {"Solid1": len(mesh.tetrahedra)} if len(getattr(mesh, "tetrahedra", ())) else {}
            self.assertEqual(found["sections"], {**solids, **self.counts(mesh)})
            self.assertEqual(found["families"], {name: name for name in mesh.patches})

    @unittest.skipUnless(test_patches.has_netcdf() and has("vtkmodules.vtkIOExodus"), "netCDF or VTK is not installed")
    def test_vtk_reads_exodus(self):
        for mesh in (self.flat, *self.curved.values()):
            found = self.read(READ_BY_VTK, [self.put(mesh, "a.exo")])
            solid = len(getattr(mesh, "tetrahedra", ()))
            self.assertEqual(found, {"blocks": {"Solid1": solid}, "sides": self.counts(mesh)} if solid
                             else {"blocks": self.counts(mesh), "sides": {}})

    def test_freecad_fem(self):
        import Fem

        for mesh in (self.flat, *self.curved.values()):
            solid = len(getattr(mesh, "tetrahedra", ()))
            found = Fem.read(self.put(mesh, "a.inp"))
            self.assertEqual((found.TriangleCount, found.TetraCount), (0 if solid else len(mesh.triangles), solid))
            found = Fem.read(self.put(mesh, "a.unv"))
            self.assertEqual((found.TriangleCount, found.TetraCount), (len(mesh.triangles), solid))
            groups = {found.getGroupName(group): len(found.getGroupElements(group)) for group in found.Groups}
            expected = {**{f"{name}_Faces": count for name, count in self.counts(mesh).items()},
                        **{f"{name}_Nodes": count for name, count in self.node_counts(mesh).items()}}
            self.assertEqual({name: groups[name] for name in expected}, expected)

    @unittest.skipUnless(shutil.which("prusa-slicer"), "PrusaSlicer (prusa-slicer) is not installed")
    def test_a_slicer_reads_what_is_for_printing(self):
        for name in ("a.3mf", "a.amf"):
            for scale in (1.0, 0.001):
                said = run("prusa-slicer", "--info", self.put(self.flat, name, scale=scale))
                self.assertIn(f"number_of_facets = {len(self.flat.triangles)}\nmanifold = yes\n", said)
                if name == "a.3mf" or scale == 1.0:
                    self.assertIn("size_z = 35.000000", said)

    def test_3mf_has_the_colours_of_the_patches(self):
        namespace = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
        with zipfile.ZipFile(self.put(self.flat, "a.3mf")) as container:
            self.assertIsNone(container.testzip())
            model = ElementTree.fromstring(container.read("3D/3dmodel.model"))
        bases = [base.get("name") for base in model.iter(namespace + "base")]
        numbers = [int(triangle.get("p1")) for triangle in model.iter(namespace + "triangle")]
        self.assertEqual(bases, list(self.flat.patches))
        self.assertEqual(numbers, self.flat.triangle_patch.tolist())
        self.assertEqual([base.get("displaycolor") for base in model.iter(namespace + "base")][1], "#FF0000")

    def test_cart3d_and_cfmesh_by_their_texts(self):
        mesh = self.flat
        with open(self.put(mesh, "a.tri"), encoding="utf-8") as stream:
            lines = stream.read().split("\n")
        self.assertEqual(lines[0], f"{len(mesh.vertices)} {len(mesh.triangles)}")
        start = 1 + len(mesh.vertices)
        triangles = np.array([line.split() for line in lines[start:start + len(mesh.triangles)]], dtype=int)
        np.testing.assert_array_equal(triangles - 1, mesh.triangles)
        self.numbers(mesh, [int(line) for line in lines[start + len(mesh.triangles):-1]])
        with open(self.put(mesh, "a.fms"), encoding="utf-8") as stream:
            text = stream.read()
        self.assertEqual(re.findall(r"^(\w+) wall$", text, re.MULTILINE), list(mesh.patches))
        found = np.array(re.findall(r"^\(\((\d+) (\d+) (\d+)\) (\d+)\)$", text, re.MULTILINE), dtype=int)
        np.testing.assert_array_equal(found, np.column_stack([mesh.triangles, mesh.triangle_patch]))

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX (ccx) is not installed")
    def test_calculix_takes_nodes_and_surfaces_by_the_names_of_patches(self):
        patches, pressure = {"fixed": ["Face5"], "loaded": ["Face6"]}, 2.0
        for order in (1, 2):
            mesh = mq.curve(Part.makeBox(10, 20, 30), order=order, volume=True, patches=patches)
            path = self.put(mesh, "beam.inp")
            with open(path, "a", encoding="ascii") as stream:
                stream.write("*MATERIAL, NAME=M\n*ELASTIC\n210000, 0.3\n*SOLID SECTION, ELSET=Solid1, MATERIAL=M\n*STEP\n"
                             f"*STATIC\n*BOUNDARY\nfixed, 1, 3\n*DSLOAD\nloaded_surface, P, {pressure}\n"
                             "*NODE PRINT, NSET=fixed, TOTALS=ONLY\nRF\n*END STEP\n")
            done = subprocess.run(["ccx", "beam"], cwd=self.folder, capture_output=True, text=True, timeout=300, check=False)
            with open(path[:-4] + ".dat", encoding="ascii") as stream:
                force = [float(word) for word in stream.read().split()[-3:]]
            # What the face at the end carries comes out at the other one.
            np.testing.assert_allclose(force, [0, 0, pressure * 200], atol=1e-3, err_msg=done.stdout[-2000:])


class Table(unittest.TestCase):
    def test_every_format_is_of_the_table_and_has_a_reader_here(self):
        with open(__file__, encoding="utf-8") as stream:
            text = stream.read()
        read = set(re.findall(r'"a(\.\w+)"', text)) | {".inp"}
        known = {".ply": "test_interchange", ".bdf": "is .nas by another name", ".mesh": "test_high_order_files",
                 ".xml": "test_high_order_files"}
        self.assertEqual(sorted(set(formats.SUFFIXES) - read - set(known)), [])
