# SPDX-License-Identifier: LGPL-2.1-or-later
"""Elements of any kind in files: read back node by node, by Gmsh, VTK and FreeCAD, and by what HOPR's and Nek5000's formats
say.
"""

import importlib.util
import json
import os
import subprocess
import unittest

import helpers
import numpy as np
import Part
from test_curved_files import PYTHON, has

import MeshQuality as mq
from MeshQuality import formats
from MeshQuality.core.elements import kinds
from MeshQuality.core.elements.assembly import assembled
from MeshQuality.core.elements.parts import Parts, Section
from MeshQuality.core.formats.hopr_order import of_gmsh
from MeshQuality.core.meshes.element_mesh import ElementMesh

HAS_H5PY = importlib.util.find_spec("h5py") is not None
NOT_READ = (".re2", ".mesh")
SERENDIPITY = {"quadrilateral": 8, "pyramid": 13, "prism": 15, "hexahedron": 20}
VOLUMES = ("tetrahedron", "pyramid", "prism", "hexahedron")
READ_BY_GMSH = """
import json, sys
import gmsh
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.open(sys.argv[1])
kinds, _, nodes = gmsh.model.mesh.getElements()
groups = {gmsh.model.getPhysicalName(d, tag): sum(len(numbers) for entity in gmsh.model.getEntitiesForPhysicalGroup(d, tag)
          for numbers in gmsh.model.mesh.getElements(d, entity)[1]) for d, tag in gmsh.model.getPhysicalGroups()}
least = []
for kind in kinds:
    if gmsh.model.mesh.getElementProperties(kind)[1] == 3:
        points, _ = gmsh.model.mesh.getIntegrationPoints(kind, "Gauss3")
        least.append(min(gmsh.model.mesh.getJacobians(kind, points)[1]))
print(json.dumps([dict(zip(map(int, kinds), map(len, nodes))), groups, min(least)]))
"""
READ_BY_VTK = """
import json, sys
import vtk
reader = vtk.vtkXMLUnstructuredGridReader()
reader.SetFileName(sys.argv[1])
reader.Update()
grid = reader.GetOutput()
sizes = vtk.vtkCellSizeFilter()
sizes.SetInputData(grid)
sizes.Update()
found = sizes.GetOutput().GetCellData()
group = grid.GetCellData().GetArray("group")
print(json.dumps([[grid.GetCellType(i) for i in range(grid.GetNumberOfCells())],
                  [found.GetArray("Volume").GetValue(i) for i in range(grid.GetNumberOfCells())],
                  [group.GetValue(i) for i in range(grid.GetNumberOfCells())]]))
"""


def mesh_of(points, sections, groups):
    """An ElementMesh of [(kind, nodes), ...], elements numbered from 1."""
    parts, first = Parts(np.array(points, dtype=float), []), 1
    for kind, nodes in sections:
        nodes = np.atleast_2d(nodes)
        parts.sections.append(Section(kind, nodes, np.arange(first, first + len(nodes))))
        first += len(nodes)
    for name, numbers in groups.items():
        parts.add_to_group(name, numbers)
    return ElementMesh(assembled(parts))


def sheared(places):
    """Places of a reference element in a frame of their own, so that no two of its edges are alike."""
    return places @ np.array([(3.0, 0.2, 0.1), (0.4, 2.0, 0.3), (0.1, 0.5, 4.0)]) + (0.1, 0.2, 0.3)


def single(kind, count):
    """One element with its first face, the rest of its faces as another group."""
    sections, faces = [(kind, np.arange(count))], []
    for flat, local in kinds.faces_of(kind, count) if kinds.DIMENSION[kind] == 3 else ():
        sections.append((flat, local))
        faces.append(len(sections))
    groups = {"body": [1], **({"inlet": faces[:1], "walls": faces[1:]} if faces else {})}
    return mesh_of(sheared(kinds.places(kind, count)), sections, groups)


def all_elements():
    """(kind, count) of all there are."""
    for kind in kinds.CORNERS:
        yield from ((kind, kinds.count_of(kind, order)) for order in range(1, 6))
        if kind in SERENDIPITY:
            yield kind, SERENDIPITY[kind]


class Written(helpers.DocumentTest):
    def written(self, mesh, ending, **options):
        path = os.path.join(self.folder, f"mesh{ending}")
        mesh.write(path, **options)
        return path

    def test_each_kind_and_order_comes_back_node_by_node(self):
        tried = dict.fromkeys(formats.ELEMENTS_WRITTEN, 0)
        for kind, count in all_elements():
            mesh = single(kind, count)
            for ending in mesh.suffixes:
                if ending in NOT_READ or ending == ".h5" and not HAS_H5PY:
                    continue
                tried[ending] += 1
                with self.subTest(kind=kind, count=count, ending=ending):
                    found = mq.read_mesh(self.written(mesh, ending))
                    block = found.blocks[0]
                    full = kinds.count_of(kind, block.order) if ending == ".h5" else count
                    self.assertEqual((block.kind, block.nodes.shape), (kind, (1, full)))
                    expected = sheared(kinds.places(kind, full))
                    self.assertLess(np.abs(found.nodes[block.nodes[0]] - expected).max(), 1e-9)
                    self.assertEqual(found.faults, ())
        self.assertEqual({ending: count for ending, count in tried.items() if ending not in NOT_READ},
                         {".msh": 39, ".vtu": 35, ".inp": 13, ".unv": 12, ".nas": 13, ".bdf": 13, ".su2": 7, ".cgns": 24,
                          ".h5": 23 if HAS_H5PY else 0})

    def test_groups_come_back(self):
        for kind in VOLUMES:
            mesh = single(kind, kinds.CORNERS[kind])
            count = len(kinds.FACES[kind])
            for ending in mesh.suffixes:
                if ending in NOT_READ or ending == ".h5" and not HAS_H5PY:
                    continue
                found = mq.read_mesh(self.written(mesh, ending))
                sizes = {name: sum(len(rows) for i, rows in parts if kinds.DIMENSION[found.blocks[i].kind] == 2)
                         for name, parts in found.group_members.items()}
                names = ("group 1", "group 2") if ending == ".vtu" else ("inlet", "walls")
                with self.subTest(kind=kind, ending=ending):
                    self.assertEqual([sizes[name] for name in names], [1, count - 1])

    def test_elements_in_several_groups(self):
        points = np.concatenate([kinds.places("tetrahedron", 4), kinds.places("tetrahedron", 4) + 5])
        mesh = mesh_of(points, [("tetrahedron", np.arange(8).reshape(2, 4))], {"both": [1, 2], "second": [2], "first": [1]})
        for ending in (".msh", ".inp", ".unv"):
            found = mq.read_mesh(self.written(mesh, ending))
            self.assertEqual({name: [rows.tolist() for _, rows in parts] for name, parts in found.group_members.items()},
                             {"both": [[0, 1]], "second": [[1]], "first": [[0]]}, ending)

    def test_numbers_that_calculix_reads(self):
        """It takes 20 characters, of which -1.7367714493258766e-16 has more."""
        points = kinds.places("tetrahedron", 4) + (-1.7367714493258766e-16, 1e-300 / 3, -1 / 3e7)
        mesh = mesh_of(points, [("tetrahedron", np.arange(4))], {})
        ours = mq.curve(Part.makeCylinder(5, 10), order=2, volume=True)
        for written in (mesh, ours):
            with open(self.written(written, ".inp"), encoding="utf-8") as file:
                rows = file.read().split("*NODE\n")[1].split("*")[0].splitlines()
            self.assertLessEqual(max(len(word.strip()) for row in rows for word in row.split(",")), 20)
            found = np.array([row.split(",")[1:] for row in rows], dtype=float)
            np.testing.assert_allclose(found, written.nodes, rtol=1e-12, atol=0)

    def test_scale_and_format(self):
        mesh = single("prism", 6)
        path = os.path.join(self.folder, "mesh.txt")
        mesh.write(path, scale=0.001, format="unv")
        os.rename(path, path := f"{path}.unv")
        np.testing.assert_allclose(mq.read_mesh(path, scale=1000).nodes, mesh.nodes, atol=1e-12)

    def test_what_a_format_does_not_hold_is_said_and_the_file_stays(self):
        mesh = single("pyramid", 14)
        path = self.written(single("pyramid", 5), ".inp")
        with open(path, "rb") as file:
            before = file.read()
        for ending, words in ((".inp", r"hold no pyramids of order 2 with 14 nodes: choose one of .*\.msh"),
                              (".re2", "hold no pyramids"), (".su2", "hold no pyramids")):
            with self.assertRaisesRegex(mq.InvalidInput, words):
                self.written(mesh, ending)
        with open(path, "rb") as file:
            self.assertEqual(file.read(), before)
        self.assertEqual(os.listdir(self.folder), ["mesh.inp"])
        with self.assertRaisesRegex(mq.IoError, r"name that ends in one of \.msh"):
            self.written(mesh, ".stl")
        with self.assertRaisesRegex(mq.InvalidInput, "'stl' is not known"):
            self.written(mesh, ".msh", format="stl")
        named = mesh_of(kinds.places("tetrahedron", 4), [("tetrahedron", np.arange(4))], {"a b": [1]})
        with self.assertRaisesRegex(mq.InvalidInput, "'a b'.*call it 'a_b'"):
            self.written(named, ".inp")

    @unittest.skipUnless(has("gmsh"), "Gmsh's Python module is not installed")
    def test_gmsh_reads_them(self):
        for kind, count in (("hexahedron", 20), ("hexahedron", 27), ("prism", 18), ("prism", 15), ("tetrahedron", 35)):
            mesh = single(kind, count)
            done = subprocess.run([PYTHON, "-c", READ_BY_GMSH, self.written(mesh, ".msh")], capture_output=True, text=True, timeout=120,
                                  check=True)
            found, groups, least = json.loads(done.stdout.splitlines()[-1])
            self.assertEqual(sum(found.values()), sum(block.nodes.size for block in mesh.blocks))
            self.assertEqual(groups, {"body": 1, "inlet": 1, "walls": len(kinds.FACES[kind]) - 1})
            self.assertGreater(least, 0.0)

    @unittest.skipUnless(has("vtk"), "VTK's Python module is not installed")
    def test_vtk_reads_them(self):
        exact = float(np.linalg.det(sheared(np.eye(3)) - sheared(np.zeros((1, 3)))))
        for kind, count, number, share in (("hexahedron", 8, 12, 1), ("hexahedron", 20, 25, 1), ("prism", 15, 26, 1 / 2),
                                           ("tetrahedron", 10, 24, 1 / 6), ("prism", 6, 13, 1 / 2), ("pyramid", 5, 14, 1 / 3)):
            done = subprocess.run([PYTHON, "-c", READ_BY_VTK, self.written(single(kind, count), ".vtu")], capture_output=True,
                                  text=True, timeout=120, check=True)
            types, volumes, groups = json.loads(done.stdout.splitlines()[-1])
            self.assertEqual(types[0], number)
            self.assertAlmostEqual(abs(volumes[0]) / exact, share, places=9)
            self.assertEqual(sorted(groups), sorted([0, 1, *[2] * (len(kinds.FACES[kind]) - 1)]))

    def test_freecad_reads_them(self):
        try:
            import Fem
        except ImportError:
            self.skipTest("this FreeCAD has no FEM workbench")
        for kind, count in (("hexahedron", 20), ("prism", 15), ("tetrahedron", 10), ("hexahedron", 8)):
            for ending in (".unv", ".inp"):
                mesh = Fem.read(self.written(single(kind, count), ending))
                self.assertEqual(mesh.VolumeCount, 1, (kind, ending))
                found = ElementMesh.of(mesh)
                expected = sheared(kinds.places(kind, count))
                np.testing.assert_allclose(found.nodes[found.blocks[0].nodes[0]].mean(axis=0), expected.mean(axis=0), atol=1e-9)
                self.assertEqual(mq.certify(found).invalid, 0, (kind, ending))


class Objects(helpers.DocumentTest):
    """FEM meshes of a document, whoever made them."""

    def test_export_of_a_fem_mesh(self):
        try:
            import Fem
        except ImportError:
            self.skipTest("this FreeCAD has no FEM workbench")
        mesh = Fem.FemMesh()
        for number, place in enumerate(sheared(kinds.places("hexahedron", 8)).tolist(), 1):
            mesh.addNode(*place, number)
        mesh.addVolume([4, 3, 2, 1, 8, 7, 6, 5], 1)
        mesh.addFace([1, 2, 3, 4], 2)
        mesh.addGroupElements(mesh.addGroup("inlet", "Face"), [2])
        given = self.document.addObject("Fem::FemMeshObject", "Given")
        given.FemMesh = mesh
        given.Placement.Base = (100, 0, 0)
        self.document.recompute()
        for ending in (".msh", ".inp", ".unv", ".su2", ".h5" if HAS_H5PY else ".nas"):
            path = os.path.join(self.folder, f"given{ending}")
            mq.export_mesh(given, path, scale=0.001)
            found = mq.read_mesh(path, scale=1000)
            self.assertEqual((found.blocks[0].kind, mq.certify(found).invalid), ("hexahedron", 0), ending)
            self.assertIn("inlet", found.groups)
            np.testing.assert_allclose(found.nodes.mean(axis=0), sheared(kinds.places("hexahedron", 8)).mean(axis=0) + (100, 0, 0),
                                       atol=1e-6)
        for options, words in (({"ascii": True}, "ascii is for STL"), ({"patch_rest": "walls"}, "whose groups are written")):
            with self.assertRaisesRegex(mq.InvalidInput, words):
                mq.export_mesh(given, os.path.join(self.folder, "given.msh"), **options)
        with self.assertRaisesRegex(mq.IoError, "ends in one of"):
            mq.export_mesh(given, os.path.join(self.folder, "given.stl"))


@unittest.skipUnless(HAS_H5PY, "h5py is not installed (python3-h5py)")
class Hopr(helpers.DocumentTest):
    """By the numbers of docs/Meshformat of HOPR."""

    def written(self, mesh):
        import h5py

        path = os.path.join(self.folder, "mesh.h5")
        mesh.write(path)
        with h5py.File(path, "r") as file:
            return {**{name: int(file.attrs[name][0]) for name in file.attrs if name != "Version"},
                    **{name: file[name][()] for name in file}}

    def test_two_tetrahedra(self):
        """Corners of the second one are turned, so that the flip is not trivial."""
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)]
        mesh = mesh_of(points, [("tetrahedron", [(0, 1, 2, 3), (3, 1, 2, 4)]), ("triangle", [(0, 2, 1)])],
                       {"inlet": [3], "one": [1], "two": [2]})
        found = self.written(mesh)
        self.assertEqual({name: found[name] for name in ("Ngeo", "nElems", "nSides", "nNodes", "nUniqueSides", "nUniqueNodes", "nBCs")},
                         {"Ngeo": 1, "nElems": 2, "nSides": 8, "nNodes": 8, "nUniqueSides": 7, "nUniqueNodes": 5, "nBCs": 2})
        self.assertEqual(found["ElemInfo"].tolist(), [[104, 1, 0, 4, 0, 4], [104, 2, 4, 8, 4, 8]])
        self.assertEqual([name.decode().rstrip() for name in found["BCNames"]], ["inlet", "others"])
        self.assertEqual(found["BCNames"].dtype, "S255")
        # Side 3 of the first one has its corners 2, 3, 4, nodes 1, 2, 3; side 1 of the second its corners 1, 3, 2, nodes
        # 3, 2, 1, of which the third is the master's first.
        self.assertEqual(found["SideInfo"].tolist(), [
            [3, 1, 0, 0, 1], [3, 2, 0, 0, 2], [3, 3, 2, 13, 0], [3, 4, 0, 0, 2],
            [3, -3, 1, 33, 0], [3, 5, 0, 0, 2], [3, 6, 0, 0, 2], [3, 7, 0, 0, 2]])
        self.assertEqual(found["GlobalNodeIDs"].tolist(), [1, 2, 3, 4, 4, 2, 3, 5])
        np.testing.assert_array_equal(found["NodeCoords"][4], points[3])
        self.assertEqual({row[0]: row[1] for row in found["ElemCounter"].tolist() if row[1]}, {104: 2})
        for name in ("ElemInfo", "SideInfo", "GlobalNodeIDs", "BCType"):
            self.assertEqual(found[name].dtype, np.int32, name)

    def test_order_of_nodes(self):
        """Those of order 2 by the algorithm of the format: i runs first, then j, then k."""
        steps = {"tetrahedron": [(0, 0, 0), (1, 0, 0), (2, 0, 0), (0, 1, 0), (1, 1, 0), (0, 2, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1),
                                 (0, 0, 2)],
                 "prism": [(i, j, k) for k in range(3) for j in range(3) for i in range(3 - j)],
                 "hexahedron": [(i, j, k) for k in range(3) for j in range(3) for i in range(3)]}
        for kind, listed in steps.items():
            places = kinds.places(kind, len(listed))[of_gmsh(kind, 2)]
            np.testing.assert_allclose(places * 2, listed, atol=1e-12)
        # Corners by the format's own table, for order 3.
        n = 3
        self.assertEqual([of_gmsh("pyramid", n)[k - 1] for k in (1, n + 1, (n + 1)**2, n * (n + 1) + 1, (n + 1) * (n + 2) * (2 * n + 3) // 6)],
                         [0, 1, 2, 3, 4])
        self.assertEqual([of_gmsh("tetrahedron", n)[k - 1] for k in (1, n + 1, (n + 1) * (n + 2) // 2, (n + 1) * (n + 2) * (n + 3) // 6)],
                         [0, 1, 2, 3])

    def test_all_kinds_in_one_mesh(self):
        """A prism on a side of a hexahedron, a pyramid on top, a tetrahedron beside that: sides as the format's table has them."""
        points = np.array([(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2), (1, 1, 3),
                           (4, 1, 0), (4, 1, 2)], dtype=float)
        sections = [("hexahedron", [range(8)]), ("prism", [(1, 9, 2, 5, 10, 6)]), ("pyramid", [(4, 5, 6, 7, 8)]),
                    ("tetrahedron", [(5, 10, 6, 8)])]
        mesh = mesh_of(points, [(kind, np.array([list(row) for row in rows])) for kind, rows in sections], {})
        found = self.written(mesh)
        self.assertEqual(sorted(found["ElemInfo"][:, 0].tolist()), [104, 115, 116, 118])
        self.assertEqual((found["nSides"], found["nUniqueSides"], found["nUniqueNodes"], found["nNodes"]), (20, 16, 11, 23))
        self.check(found)
        back = mq.read_mesh(os.path.join(self.folder, "mesh.h5"))
        self.assertEqual((mq.certify(back).invalid, mq.certify(back).conforming, back.groups), (0, True, ("others",)))

    def check(self, found):
        """What all files keep: neighbours name each other, and the nodes of their sides are the same."""
        corners = {4: (0, 2, 1), 5: (0, 3, 2, 1)}
        self.assertEqual(len(corners), 2)
        sides, info = found["SideInfo"], found["ElemInfo"]
        inner = np.flatnonzero(sides[:, 2] > 0)
        for row in inner.tolist():
            other = info[sides[row, 2] - 1, 2] + sides[row, 3] // 10 - 1
            element = int(np.searchsorted(info[:, 3], row, side="right"))
            self.assertEqual((sides[row, 1], sides[other, 2], sides[other, 3] % 10),
                             (-sides[other, 1], element + 1, sides[row, 3] % 10))
            self.assertEqual((sides[row, 4], sides[row, 0] % 10), (0, sides[other, 0] % 10))
        outer = np.flatnonzero(sides[:, 2] == 0)
        self.assertTrue((sides[outer, 4] > 0).all() and (sides[outer, 3] == 0).all() and (sides[outer, 1] > 0).all())

    def test_curved_parts_of_all_orders(self):
        shape = Part.makeCylinder(5, 10)
        for order in range(1, 5):
            mesh = mq.curve(shape, order=order, volume=True, patches={"ends": ["Face2", "Face3"]})
            found = self.written(mesh)
            self.assertEqual((found["Ngeo"], found["nElems"]), (order, len(mesh.tetrahedra)))
            self.assertEqual([name.decode().rstrip() for name in found["BCNames"]], ["ends", "Face1"])
            self.assertEqual(np.bincount(found["SideInfo"][:, 4])[1:].tolist(),
                             [int((mesh.triangle_patch == i).sum()) for i in range(2)])
            self.check(found)
            back = mq.read_mesh(os.path.join(self.folder, "mesh.h5"))
            certificate = mq.certify(back, shape)
            self.assertEqual((certificate.invalid, certificate.conforming, certificate.oriented), (0, True, True))
            self.assertAlmostEqual(certificate.max_deviation, mesh.report.max_deviation, places=6)

    def test_what_it_does_not_hold(self):
        with self.assertRaisesRegex(mq.InvalidInput, "hold volumes"):
            self.written(mq.curve(Part.makeBox(1, 1, 1)))
        points = np.concatenate([kinds.places("tetrahedron", 4), kinds.places("tetrahedron", 10) + 3])
        mixed = mesh_of(points, [("tetrahedron", np.arange(4)), ("tetrahedron", np.arange(4, 14))], {})
        with self.assertRaisesRegex(mq.InvalidInput, "one order, not of 1 and 2"):
            self.written(mixed)


class Nek5000(helpers.DocumentTest):
    """By the numbers of Nek5000's reader_re2.f and genxyz.f."""

    def written(self, mesh):
        path = os.path.join(self.folder, "mesh.re2")
        mesh.write(path)
        with open(path, "rb") as file:
            data = file.read()
        count = int(data[5:14])
        elements = np.frombuffer(data, "<f8", 25 * count, 84).reshape(count, 25)
        records, at = [], 84 + elements.nbytes
        kind = np.dtype([("values", "<f8", 7), ("letters", "S8")])
        for _ in range(2):
            number = int(np.frombuffer(data, "<f8", 1, at)[0])
            records.append(np.frombuffer(data, kind, number, at + 8))
            at += 8 + records[-1].nbytes
        self.assertEqual(at, len(data))
        return data[:84], elements, records

    def test_a_bent_hexahedron(self):
        points = kinds.places("hexahedron", 20) * 2.0
        bent = 8 + [tuple(sorted(edge)) for edge in kinds.EDGES["hexahedron"]].index((2, 6))
        points[bent] += (0.25, 0.0, 0.0)
        flat, local = kinds.faces_of("hexahedron", 20)[5]
        mesh = mesh_of(points, [("hexahedron", np.arange(20)), (flat, local)], {"top": [2]})
        head, elements, (curves, conditions) = self.written(mesh)
        self.assertEqual(head[:27], b"#v002        1  3        1 ")
        self.assertEqual(np.frombuffer(head[80:], "<f4")[0], np.float32(6.54321))
        np.testing.assert_array_equal(elements[0, 1:].reshape(3, 8).T, points[:8])
        # Edge 11 goes from corner 3 to corner 7, as genxyz.f has it: node 18 of 3 x 3 x 3.
        self.assertEqual([(row["values"].tolist(), row["letters"]) for row in curves],
                         [([1.0, 11.0, 2.25, 2.0, 1.0, 0.0, 0.0], b"m       ")])
        self.assertEqual([(row["values"].tolist(), row["letters"]) for row in conditions],
                         [([1.0, 6.0, 0.0, 0.0, 0.0, 0.0, 1.0], b"MSH     ")])

    def test_all_sides_and_edges(self):
        """Sides by their corners in Nek5000's order, from 1; edges likewise."""
        points = kinds.places("hexahedron", 27) * 2.0
        centre = points.mean(axis=0)
        points[8:20] += 0.1 * (points[8:20] - centre)
        sides = ((1, 2, 6, 5), (2, 3, 7, 6), (3, 4, 8, 7), (4, 1, 5, 8), (1, 2, 3, 4), (5, 6, 7, 8))
        edges = ((1, 2), (2, 3), (3, 4), (4, 1), (5, 6), (6, 7), (7, 8), (8, 5), (1, 5), (2, 6), (3, 7), (4, 8))
        faces = kinds.faces_of("hexahedron", 27)
        mesh = mesh_of(points, [("hexahedron", np.arange(27)), *faces], {f"side{i}": [i + 2] for i in range(6)})
        _, _, (curves, conditions) = self.written(mesh)
        self.assertEqual(len(curves), 12)
        for row in curves["values"]:
            a, b = (points[corner - 1] for corner in edges[int(row[1]) - 1])
            np.testing.assert_allclose(row[2:5], (a + b) / 2 + 0.1 * ((a + b) / 2 - centre), atol=1e-12)
        for row in conditions["values"]:
            group = int(row[6]) - 1
            self.assertEqual({corner - 1 for corner in sides[int(row[1]) - 1]}, set(faces[group][1][:4].tolist()))
        self.assertEqual(sorted(conditions["values"][:, 1]), [1, 2, 3, 4, 5, 6])

    def test_other_elements_are_refused(self):
        with self.assertRaisesRegex(mq.InvalidInput, "hold no tetrahedra"):
            self.written(ElementMesh.of(mq.curve(Part.makeBox(1, 1, 1), volume=True)))
