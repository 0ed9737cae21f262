# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes from elsewhere: files of our own writers and of Gmsh, FEM meshes of FreeCAD, and files that are damaged."""

import base64
import ctypes.util
import importlib.util
import json
import os
import random
import subprocess
import sys
import time
import unittest
import zlib
from functools import lru_cache

import FreeCAD
import helpers
import numpy as np
import Part
from test_curved_files import PYTHON, has

import MeshQuality as mq
from MeshQuality.core.elements import kinds

NEEDED = {"exo": importlib.util.find_spec("netCDF4") is not None, "cgns": ctypes.util.find_library("cgns") is not None}
PATCHES = {"inlet": ["Face1", "Face2"]}

# Meshes of every kind of element by Gmsh, each in several formats; prints how many elements of each type it has.
MADE_BY_GMSH = """
import json, sys
import gmsh
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.option.setNumber("Mesh.MeshSizeMax", 5)
folder, counts = sys.argv[1], {}
for name in ("tet", "hex", "pri", "pyr"):
    for order, incomplete in ((1, 0), (2, 0), (2, 1), (3, 0)):
        gmsh.clear()
        occ = gmsh.model.occ
        rectangle = occ.addRectangle(0, 0, 0, 10, 10)
        made = occ.extrude([(2, rectangle)], 0, 0, 6, [] if name == "tet" else [2], recombine=name != "tet")
        if name == "pyr":
            occ.synchronize()
            occ.extrude([made[0]], 0, 0, 8)
        occ.synchronize()
        if name in ("hex", "pyr"):
            gmsh.model.mesh.setTransfiniteSurface(rectangle)
            gmsh.model.mesh.setRecombine(2, rectangle)
        for dimension in (2, 3):
            tags = [tag for _, tag in gmsh.model.getEntities(dimension)]
            gmsh.model.addPhysicalGroup(dimension, tags, 1)
            gmsh.model.setPhysicalName(dimension, 1, "faces" if dimension == 2 else "body")
        gmsh.model.mesh.generate(3)
        gmsh.option.setNumber("Mesh.SecondOrderIncomplete", incomplete)
        gmsh.model.mesh.setOrder(order)
        key = f"{name}{order}{incomplete}"
        counts[key] = {int(kind): len(numbers) for d in (2, 3)
                       for kind, numbers in zip(*gmsh.model.mesh.getElements(d)[:2])}
        others = [] if order == 3 or (order, incomplete) == (2, 0) and name != "tet" else ["inp", "unv", "bdf", "vtk"]
        if order == 1:
            others.append("su2")
        for version, binary, ending in [(v, b, "msh") for v in (2.2, 4.1) for b in (0, 1)] + [(4.1, 0, e) for e in others]:
            if name == "pyr" and (ending in ("inp", "unv") or ending == "vtk" and order == 2):
                continue  # Gmsh leaves pyramids out of the first two, and writes too many nodes into the last
            gmsh.option.setNumber("Mesh.MshFileVersion", version)
            gmsh.option.setNumber("Mesh.Binary", binary)
            gmsh.write(f"{folder}/{key}_{version}_{binary}.{ending}")
print(json.dumps(counts))
"""


@lru_cache(1)
def part():
    return Part.makeBox(10, 20, 30).cut(Part.makeCylinder(3, 40, FreeCAD.Vector(5, 10, -5)))


@lru_cache(None)
def curved(order, volume):
    return mq.curve(part(), order=order, volume=volume, chord_height_relative=0.1, min_angle=10)


def block_of(mesh, kind):
    return next((block for block in mesh.blocks if block.kind == kind), None)


def weights(kind, at):
    """What the corners of an element give to places of the reference element, of straight ones."""
    x, y, z = at.T
    if kind in ("triangle", "tetrahedron", "line"):
        return np.stack([1 - x - y - z, x, y, z][:kinds.CORNERS[kind]], axis=1)
    if kind == "prism":
        flat = np.stack([1 - x - y, x, y], axis=1)
        return np.concatenate([flat * (1 - z)[:, None], flat * z[:, None]], axis=1)
    if kind == "pyramid":
        below = np.where(z < 1, 1 - z, 1)
        x, y = (x - z / 2) / below, (y - z / 2) / below
    square = np.stack([(1 - x) * (1 - y), x * (1 - y), x * y, (1 - x) * y], axis=1)
    if kind == "quadrilateral":
        return square
    low = square * (1 - z)[:, None]
    return np.concatenate([low, z[:, None] if kind == "pyramid" else square * z[:, None]], axis=1)


def flux(corners, about):
    """Six times the volume below each polygon, seen from points."""
    first, *others = [corners[:, i] - about for i in range(corners.shape[1])]
    return sum(np.einsum("ij,ij->i", first, np.cross(a, b)) for a, b in zip(others, others[1:]))


def flat_corners(faces):
    return faces[:, :3 if faces.shape[1] in (3, 6, 10, 15, 21) else 4]


class ReadingTest(helpers.DocumentTest):
    def read(self, name, **options):
        return mq.read_mesh(os.path.join(self.folder, name), **options)

    def assert_fault(self, name, data, words, error=mq.Error):
        path = os.path.join(self.folder, name)
        with open(path, "wb") as file:
            file.write(data if isinstance(data, bytes) else data.encode())
        with self.assertRaises(error) as caught:
            mq.read_mesh(path)
        self.assertIn(name, str(caught.exception))
        self.assertRegex(str(caught.exception), words)

    def assert_sound(self, mesh, volume=None, straight=True):
        """Positive elements, nodes where Gmsh's order has them, a boundary that encloses the elements."""
        total = 0.0
        for block in mesh.blocks:
            places, points = kinds.places(block.kind, block.nodes.shape[1]), mesh.nodes[block.nodes]
            corners = points[:, :kinds.CORNERS[block.kind]]
            if straight:
                off = np.abs(points - np.einsum("pc,ecd->epd", weights(block.kind, places), corners))
                self.assertLess(off.max(), 1e-4, (block.kind, block.order))
            if kinds.DIMENSION[block.kind] == 3:
                below = np.stack([flux(corners[:, list(face)], corners.mean(axis=1)) for face in kinds.FACES[block.kind]])
                self.assertGreater(below.min(), 0.0, block.kind)
                total += below.sum() / 6
        around = sum(flux(mesh.nodes[flat_corners(faces)], np.zeros(3)).sum() for faces in mesh.boundary()) / 6
        self.assertAlmostEqual(around / (total or around), 1.0, places=9)
        if volume:
            self.assertAlmostEqual(total / volume, 1.0, places=6)


class OurFiles(ReadingTest):
    def test_every_format_and_order(self):
        for order in range(1, 6):
            for volume in (False, True):
                if order < 5 or not volume:
                    self.read_back(curved(order, volume), order, volume)

    def read_back(self, mesh, order, volume):
        for ending in ("msh", "msh2", "vtu", "su2", "cgns", "inp", "unv", "nas", "bdf", "exo"):
            highest = {"msh": 5, "msh2": 5, "vtu": 5, "su2": 1}.get(ending, 2)
            if order > highest or not NEEDED.get(ending, True):
                continue
            with self.subTest(ending, order=order, volume=volume):
                mesh.write(os.path.join(self.folder, f"part.{ending}"), patches=PATCHES, patch_rest="wall")
                found = self.read(f"part.{ending}")
                np.testing.assert_allclose(found.nodes, mesh.nodes, atol=1e-12)
                self.assertEqual(found.faults, ())
                kind = "tetrahedron" if volume else "triangle"
                self.assertTrue(np.array_equal(block_of(found, kind).nodes, mesh.tetrahedra if volume else mesh.triangles)
                                or ending in ("cgns", "inp", "nas", "bdf", "exo", "unv", "su2"))
                self.assertEqual(self.rows(block_of(found, kind).nodes), self.rows(mesh.elements))
                self.assert_sound(found, straight=order == 1)
                if ending != "vtu":
                    self.groups_are_back(found, mesh)

    def groups_are_back(self, found, mesh):
        triangles = block_of(found, "triangle").nodes
        self.assertEqual(len(triangles), len(mesh.triangles))
        inlet = np.isin(mesh.triangle_face, (0, 1))
        for name, chosen in (("inlet", inlet), ("wall", ~inlet)):
            ((block, rows),) = found.group_members[name]
            self.assertEqual(found.blocks[block].kind, "triangle")
            self.assertEqual(self.rows(triangles[rows]), self.rows(mesh.triangles[chosen]))
            self.assertTrue((found.blocks[block].group[rows] == found.groups.index(name)).all())

    @staticmethod
    def rows(nodes):
        """Elements as sets, in any sequence: by their corners and the nodes behind these."""
        return sorted(tuple(sorted(row)) for row in nodes.tolist())

    def test_flat_triangles(self):
        mesh = mq.triangulate(part(), chord_height=0.1)
        for ending in ("msh", "msh2", "vtu", "su2", "cgns", "inp", "unv", "nas", "exo"):
            if NEEDED.get(ending, True):
                with self.subTest(ending):
                    mesh.write(os.path.join(self.folder, f"flat.{ending}"), patches=PATCHES, patch_rest="wall", scale=0.001)
                    found = self.read(f"flat.{ending}", scale=1000.0)
                    np.testing.assert_allclose(found.nodes, mesh.vertices, atol=1e-5)
                    self.assertEqual(self.rows(block_of(found, "triangle").nodes), self.rows(mesh.triangles))
                    self.assert_sound(found)

    def test_cad_entities_of_gmsh_files(self):
        mesh = curved(2, True)
        mesh.write(os.path.join(self.folder, "part.msh"))
        found = self.read("part.msh")
        for kind, nodes, entity in (("triangle", mesh.triangles, mesh.triangle_face), ("line", mesh.edges, mesh.edge_entity)):
            block = block_of(found, kind)
            for i in range(entity.max() + 1):
                self.assertEqual(self.rows(block.nodes[block.geometry == i]), self.rows(nodes[entity == i]))


class InFreeCAD(ReadingTest):
    def test_our_meshes(self):
        for order in (1, 2, 3, 4):
            found = mq.ElementMesh.of(curved(order, True))
            self.assertTrue(np.array_equal(found.blocks[0].nodes, curved(order, True).tetrahedra))
            self.assert_sound(found, straight=order == 1)
            self.assertIn("Solid1", found.groups)
        mesh = mq.triangulate(part())
        found = mq.ElementMesh.of(mesh)
        self.assertTrue(np.array_equal(found.blocks[0].geometry, mesh.triangle_face))
        self.assertRegex(repr(found), r"^<ElementMesh: [\d,]+ triangles of order 1, [\d,]+ nodes, 7 groups>$")
        self.assertIs(mq.ElementMesh.of(found), found)

    def test_fem_meshes_stand_where_their_objects_do(self):
        for order in (1, 2):
            shown = self.document.addObject("Part::Feature", "Shown")
            shown.Shape = part()
            fem = mq.add_fem_mesh(shown, order=order, chord_height_relative=0.1, min_angle=10)
            self.document.recompute()
            here = mq.ElementMesh.of(fem)
            self.assertEqual(here.faults, ())
            self.assert_sound(here, straight=order == 1)
            self.assertIn("Face1", here.groups)
            plain = self.document.addObject("Fem::FemMeshObject", "Plain")
            plain.FemMesh = fem.FemMesh
            plain.Placement = FreeCAD.Placement(FreeCAD.Vector(100, 0, 0), FreeCAD.Rotation(FreeCAD.Vector(1, 0, 0), 90))
            holder = self.document.addObject("App::Part", "Holder")
            holder.Placement = FreeCAD.Placement(FreeCAD.Vector(0, 0, 1000), FreeCAD.Rotation())
            holder.addObject(plain)
            self.document.recompute()
            x, y, z = here.nodes.T
            np.testing.assert_allclose(mq.ElementMesh.of(plain).nodes, np.stack([x + 100, -z, y + 1000], axis=1), atol=1e-9)

    def test_what_has_no_elements(self):
        plain = self.document.addObject("Part::Box", "Plain")
        for source, words in ((plain, "'Plain' has no FEM mesh"), (7, "not int"), ("part.msh", "mq.read_mesh")):
            with self.assertRaisesRegex(mq.InvalidInput, words):
                mq.ElementMesh.of(source)


@unittest.skipUnless(has("gmsh"), "Gmsh's Python module is not installed")
class FilesOfGmsh(ReadingTest):
    def test_every_kind_order_and_format(self):
        done = subprocess.run([PYTHON, "-c", MADE_BY_GMSH, self.folder], capture_output=True, text=True, timeout=300,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        counts = json.loads(done.stdout.splitlines()[-1])
        from MeshQuality.core.formats.gmsh import TYPES

        names = [name for name in sorted(os.listdir(self.folder)) if name.split("_")[0] in counts]
        self.assertGreater(len(names), 80)
        for name in names:
            key = name.split("_")[0]
            with self.subTest(name):
                mesh = self.read(name)
                wanted = {TYPES[int(number)]: count for number, count in counts[key].items()}
                self.assertEqual({(block.kind, block.nodes.shape[1]): len(block.nodes) for block in mesh.blocks
                                  if block.kind != "line"}, wanted)
                self.assert_sound(mesh, 1400.0 if key.startswith("pyr") else 600.0)
                if name.endswith(("msh", "unv")):
                    self.assertEqual(set(mesh.groups), {"faces", "body"})
                    self.assertEqual(sum(len(rows) for _, rows in mesh.group_members["body"]),
                                     sum(len(block.nodes) for block in mesh.blocks if kinds.DIMENSION[block.kind] == 3))


GMSH_HEAD = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"


def gmsh_file(nodes, elements):
    points = "\n".join(f"{i} {x} {y} {z}" for i, (x, y, z) in enumerate(nodes, 1))
    return (f"{GMSH_HEAD}$Nodes\n{len(nodes)}\n{points}\n$EndNodes\n$Elements\n{len(elements)}\n"
            + "\n".join(elements) + "\n$EndElements\n")


CORNERS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]


class Faults(ReadingTest):
    def test_what_errors_name(self):
        self.assert_fault("empty.msh", b"", "it is empty", mq.IoError)
        self.assert_fault("other.msh", b"solid cube\n", "MeshFormat", mq.IoError)
        self.assert_fault("old.msh", b"$MeshFormat\n4.0 0 8\n$EndMeshFormat\n", "version 4.*4.1 or 2.2", mq.IoError)
        self.assert_fault("range.msh", gmsh_file(CORNERS, ["7 4 2 0 1 1 2 3 9"]), "tetrahedron 7 has node 9", mq.InvalidInput)
        self.assert_fault("nan.msh", gmsh_file([*CORNERS[:3], (0, "nan", 1)], ["1 4 2 0 1 1 2 3 4"]), "node 4 .* not finite",
                          mq.InvalidInput)
        self.assert_fault("type.msh", gmsh_file(CORNERS, ["1 77 2 0 1 1 2 3 4"]), "type 77", mq.IoError)
        self.assert_fault("none.msh", gmsh_file(CORNERS, []), "no elements", mq.InvalidInput)
        self.assert_fault("huge.msh", f"{GMSH_HEAD}$Nodes\n99999999999\n1 0 0 0\n$EndNodes\n", "too short", mq.IoError)
        self.assert_fault("quadratic.inp", "*NODE\n1,0,0,0\n*ELEMENT,TYPE=C3D27\n1,1\n", "type C3D27", mq.IoError)
        self.assert_fault("some.bdf", "BEGIN BULK\nGRID,1,,0.,0.,0.\nCTETRA,5,1,1,1,1\nENDDATA\n", "CTETRA 5 has 3 nodes",
                          mq.IoError)
        self.assert_fault("moved.nas", "GRID,1,7,0.,0.,0.\n", "coordinate systems", mq.IoError)
        self.assert_fault("cut.unv", "    -1\n  2411\n", "cut off", mq.IoError)
        self.assert_fault("text.exo", b"CDF but no more", "damaged|cannot", mq.IoError)
        self.assert_fault("text.cgns", b"nothing of the kind", "CGNS", mq.IoError)
        self.assert_fault("text.vtk", b"nothing of the kind", "vtk DataFile", mq.IoError)
        four = f"{GMSH_HEAD.replace('2.2', '4.1')}$Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n$EndNodes\n$Elements\n" \
            "1 2 1 2\n3 1 4 1\n1 1 2 3 4\n3 2 4 1\n2 1 2 3 4\n$EndElements\n"
        self.assert_fault("more.msh", four, "\\$Elements has more than it announces", mq.IoError)
        self.assert_fault("more2.msh", gmsh_file(CORNERS, ["1 4 2 0 1 1 2 3 4", "2 4 2 0 1 1 2 3 4"]).replace("$Elements\n2\n", "$Elements\n1\n"),
                          "more than it announces", mq.IoError)
        solid = "*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n*ELEMENT,TYPE=C3D4\n8,1,2,3,4\n"
        self.assert_fault("system.inp", "*SYSTEM\n1,0,0,2,0,0\n" + solid, "coordinate system .*SYSTEM", mq.IoError)
        for keyword in ("*ELSET,ELSET=A\nOTHER\n", "*SURFACE,NAME=A\nOTHER,S1\n"):
            self.assert_fault("set.inp", solid + keyword, "set of elements 'OTHER'", mq.IoError)
        self.assert_fault("many.su2", "NDIME= 3\nNELEM= 1\n10 0 1 2 3 0\nNPOIN= 4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\nNMARK= 1000000000\n",
                          "announces 1,000,000,000 markers and has 0", mq.IoError)
        for name, words in (("nowhere.msh", "no such file"), ("mesh.stl", "ends in one of")):
            with self.assertRaisesRegex(mq.IoError, words):
                self.read(name)
        with self.assertRaisesRegex(mq.InvalidInput, "scale = 0"):
            self.read("type.msh", scale=0)

    def test_lagrange_hexahedra_are_named(self):
        points = " ".join(["0"] * 192)
        text = ('<VTKFile type="UnstructuredGrid"><UnstructuredGrid><Piece NumberOfPoints="64" NumberOfCells="1"><Points>'
                f'<DataArray type="Float64" NumberOfComponents="3" format="ascii">{points}</DataArray></Points><Cells>'
                '<DataArray type="Int32" Name="connectivity" format="ascii">' + " ".join(map(str, range(64)))
                + '</DataArray><DataArray type="Int32" Name="offsets" format="ascii">64</DataArray>'
                '<DataArray type="UInt8" Name="types" format="ascii">72</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>')
        self.assert_fault("lagrange.vtu", text, "hexahedra of VTK Lagrange", mq.IoError)

    def test_a_name_that_ends_datasets_is_not_written(self):
        with self.assertRaisesRegex(mq.InvalidInput, "are not -1; call it '1'"):
            curved(1, True).write(os.path.join(self.folder, "name.unv"), patches={"-1": ["Face1"]})

    def test_a_small_file_that_unpacks_to_gigabytes(self):
        blocks, size = 200, 1 << 24
        packed = zlib.compress(bytes(size), 9)
        head = np.array([blocks, size, 0, *[len(packed)] * blocks], dtype="u8").tobytes()
        text = base64.b64encode(head) + base64.b64encode(packed * blocks)
        path = os.path.join(self.folder, "bomb.vtu")
        with open(path, "wb") as file:
            file.write(b'<VTKFile type="UnstructuredGrid" header_type="UInt64" compressor="vtkZLibDataCompressor"><UnstructuredGrid>'
                       b'<Piece NumberOfPoints="139810133" NumberOfCells="0"><Points><DataArray type="Float64" format="binary">'
                       + text + b'</DataArray></Points><Cells><DataArray type="Int64" Name="connectivity" format="binary">' + text
                       + b"</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>")
        before = time.process_time()
        with self.assertRaisesRegex(mq.IoError, "unpack to more than 64 times its size"):
            mq.read_mesh(path)
        self.assertLess(time.process_time() - before, 3.0)

    def test_odd_meshes_are_taken_with_a_word(self):
        nodes = [*CORNERS, (0, 0, 1), (5, 5, 5)]
        path = os.path.join(self.folder, "odd.msh")
        with open(path, "w", encoding="utf-8") as file:
            file.write(gmsh_file(nodes, ["1 4 2 0 1 1 2 3 4", "2 4 2 0 1 1 2 3 3", "3 4 2 0 1 1 2 3 5"]))
        said = " ".join(mq.read_mesh(path).faults)
        self.assertIn("1 tetrahedron with a corner twice: 2", said)
        self.assertIn("1 node that no element has", said)
        self.assertIn("1 node at the place of another one", said)

    def test_an_element_in_several_groups_is_in_each(self):
        with open(os.path.join(self.folder, "sets.inp"), "w", encoding="utf-8") as file:
            file.write("*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n*ELEMENT,TYPE=C3D4,ELSET=ALL\n8,1,2,3,4\n"
                       "*ELSET,ELSET=Again,GENERATE\n1,9,1\n*SURFACE,NAME=Below\n8,S1\n")
        mesh = self.read("sets.inp")
        self.assertEqual(mesh.groups, ("ALL", "Again", "Below"))
        self.assertEqual(mesh.blocks[0].group.tolist(), [0])
        self.assertEqual([rows.tolist() for _, rows in mesh.group_members["Again"]], [[0]])
        below = mesh.blocks[mesh.group_members["Below"][0][0]]
        self.assertEqual((below.kind, sorted(below.nodes[0].tolist())), ("triangle", [0, 1, 2]))


# Reads files that are damaged in a process with a limit of memory: prints what came that is none of our errors.
READ_DAMAGED = """
import glob, resource, sys
sys.path.insert(0, sys.argv[1])
import MeshQuality as mq
resource.setrlimit(resource.RLIMIT_DATA, (2 << 30, 2 << 30))
for path in sorted(glob.glob(sys.argv[2] + "/damaged_*")):
    print(path, flush=True)
    try:
        mq.read_mesh(path).boundary()
    except mq.Error:
        pass
print("all read")
"""


class Fuzz(ReadingTest):
    def test_damaged_files_raise_errors_of_ours(self):
        """Files cut off and with bytes changed, of each format: no other error, no crash, no endless loop."""
        chance = random.Random(20)
        for ending in ("msh", "msh2", "vtu", "su2", "cgns", "inp", "unv", "nas", "exo"):
            if not NEEDED.get(ending, True):
                continue
            path = os.path.join(self.folder, f"whole.{ending}")
            curved(1, True).write(path, patches=PATCHES, patch_rest="wall")
            with open(path, "rb") as file:
                whole = file.read()
            for i in range(12):
                # The HDF5 library, in which CGNS files are, ends the program on some of those with other bytes: these are cut.
                cut = i % 3 == 0 or ending == "cgns"
                data = bytearray(whole[:chance.randrange(len(whole))] if cut else whole)
                for _ in range(0 if cut else chance.choice((1, 3, 20))):
                    data[chance.randrange(len(data)) if i % 2 else chance.randrange(min(len(data), 800))] = chance.randrange(256)
                with open(os.path.join(self.folder, f"damaged_{i}.{ending}"), "wb") as file:
                    file.write(data)
        code = f"import sys; sys.argv = ['', {os.path.join(helpers.ROOT, 'Mod')!r}, {self.folder!r}]\n{READ_DAMAGED}"
        script = os.path.join(self.folder, "read_damaged.py")
        with open(script, "w", encoding="utf-8") as file:
            file.write(code)
        program = os.path.join(os.path.dirname(os.path.realpath(sys.executable)), "freecadcmd")
        done = subprocess.run([program if os.path.exists(program) else "freecadcmd", script], capture_output=True, text=True,
                              timeout=300, check=False, stdin=subprocess.DEVNULL)
        self.assertIn("all read", done.stdout, done.stdout[-300:] + done.stderr[-600:])
