# SPDX-License-Identifier: LGPL-2.1-or-later
"""File > Export and Import: what FreeCAD calls for them, with files read and written by programs that share no code with ours."""

import importlib.util
import math
import os
import re
import shutil
import subprocess
import unittest
import zipfile
from unittest import mock
from xml.etree import ElementTree

import FreeCAD
import helpers
import Mesh
import numpy as np
import Part
import test_high_order_files

import MeshQuality as mq
from MeshQuality import exchange, formats
from MeshQuality.features import export_bodies, file_settings


def has(module):
    """Whether FreeCAD's Python finds a module."""
    return importlib.util.find_spec(module) is not None


meshio = importlib.import_module("meshio") if has("meshio") else None
# Formats that need a library which is not there are left out.
WITHOUT = {suffix for suffix, there in ((".exo", has("netCDF4")), (".cgns", test_high_order_files.has_cgns())) if not there}
SPACE = {"m": "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"}
# Gmsh's own mesh of a box of hexahedra with 27 nodes, and of prisms, with physical groups.
BY_GMSH = """
import sys, gmsh
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
square = gmsh.model.occ.addRectangle(0, 0, 0, 10, 20)
gmsh.model.occ.extrude([(2, square)], 0, 0, 30, numElements=[3], recombine=True)
gmsh.model.occ.synchronize()
if sys.argv[2] == "hexahedron":
    gmsh.model.mesh.setRecombine(2, square)
    for line in gmsh.model.getBoundary([(2, square)], oriented=False):
        gmsh.model.mesh.setTransfiniteCurve(line[1], 3)
    gmsh.model.mesh.setTransfiniteSurface(square)
gmsh.model.setPhysicalName(3, gmsh.model.addPhysicalGroup(3, [1]), "block")
gmsh.model.setPhysicalName(2, gmsh.model.addPhysicalGroup(2, [square]), "bottom")
gmsh.option.setNumber("Mesh.MeshSizeMin", 8)
gmsh.option.setNumber("Mesh.SecondOrderIncomplete", int(sys.argv[4]))
gmsh.model.mesh.generate(3)
gmsh.model.mesh.setOrder(int(sys.argv[3]))
gmsh.write(sys.argv[1])
"""


def by_type(kind, suffix):
    """The module of ours that FreeCAD knows for files with this ending."""
    found = (FreeCAD.getExportType if kind == "export" else FreeCAD.getImportType)(suffix.lstrip("."))
    return importlib.import_module(next(name for name in found if name.startswith("MeshQuality")))


class FileMenu(helpers.DocumentTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        exchange.register()  # what FreeCAD itself has done where this is an addon

    def setUp(self):
        super().setUp()
        self.addCleanup(file_settings.stored().Clear)
        file_settings.stored().Clear()
        self.said = []
        console = mock.Mock(PrintMessage=lambda text: self.said.append(("message", text)),
                            PrintWarning=lambda text: self.said.append(("warning", text)))
        patched = mock.patch.object(FreeCAD, "Console", console)
        patched.start()
        self.addCleanup(patched.stop)

    def put(self, objects, name):
        """Exports by the type that FreeCAD knows; returns the path."""
        path = os.path.join(self.folder, name)
        by_type("export", os.path.splitext(name)[1]).export(objects, path)
        self.assertEqual([name for name in os.listdir(self.folder) if ".part" in name], [])
        return path

    def cylinder(self, radius=5.0, at=(0, 0, 0), name="Cylinder"):
        found = self.document.addObject("Part::Cylinder", name)
        found.Radius, found.Height, found.Placement.Base = radius, 10, FreeCAD.Vector(*at)
        self.document.recompute()
        return found

    def assembly(self):
        """A part with a box, a cylinder and a hidden sphere, raised by 100 mm."""
        part = self.document.addObject("App::Part", "Asm")
        part.Label, part.Placement.Base = "Träger <1>", FreeCAD.Vector(0, 0, 100)
        box, cylinder, hidden = self.box(), self.cylinder(at=(30, 0, 0)), self.document.addObject("Part::Sphere", "Sphere")
        box.Label = "Kiste & Deckel"
        part.addObjects([box, cylinder, hidden])
        hidden.Visibility = False
        self.document.recompute()
        return part


class Triangles(FileMenu):
    def test_freecad_has_the_types_with_its_own_before_them(self):
        for suffix in (".stl", ".3mf", ".obj", ".ply", *formats.CURVED_SUFFIXES):
            known = FreeCAD.getExportType(suffix[1:])
            self.assertEqual(known.count("MeshQuality.exchange"), 1, suffix)
            self.assertEqual(known[-1], "MeshQuality.exchange", suffix)
        for suffix in ("msh", "inp", "su2", "cgns", "exo"):
            self.assertEqual(FreeCAD.getImportType(suffix)[-1], "MeshQuality.exchange")
        self.assertEqual(FreeCAD.getImportType("inp")[0], "Fem")

    def test_a_part_is_closed_and_within_the_distance(self):
        part = self.cylinder()
        for suffix in (".stl", ".obj", ".ply", ".3mf"):
            found = self.read(self.put([part], f"a{suffix}"))
            self.assertTrue(found.isSolid(), suffix)
            self.assertFalse(found.hasSelfIntersections())
            self.assertAlmostEqual(found.Volume, part.Shape.Volume, delta=0.02 * part.Shape.Volume)
            centres = [facet.Points for facet in found.Facets][::7]
            for points in centres:
                middle = sum((FreeCAD.Vector(*p) for p in points), FreeCAD.Vector()) / 3
                self.assertLess(Part.Vertex(middle).distToShape(part.Shape)[0], 0.03)

    def read(self, path):
        if not path.endswith(".3mf"):
            return Mesh.Mesh(path)
        (_, points, corners, _), = self.objects(path)[0].values()
        return Mesh.Mesh([[points[i] for i in row] for row in corners])

    def objects(self, path):
        """({number: (name, points, corners, materials)}, {number: (name, [components])}, items, [(name, colour)], unit)."""
        with zipfile.ZipFile(path) as container:
            self.assertIsNone(container.testzip())
            model = ElementTree.fromstring(container.read("3D/3dmodel.model"))
        meshes, held = {}, {}
        for one in model.findall(".//m:object", SPACE):
            parts = [part.get("objectid") for part in one.findall(".//m:component", SPACE)]
            if parts:
                held[one.get("id")] = one.get("name"), parts
                continue
            rows = one.findall(".//m:triangle", SPACE)
            meshes[one.get("id")] = (
                one.get("name"),
                np.array([[float(vertex.get(axis)) for axis in "xyz"] for vertex in one.findall(".//m:vertex", SPACE)]),
                np.array([[int(row.get(f"v{k}")) for k in (1, 2, 3)] for row in rows]),
                [int(row.get("p1", -1)) for row in rows])
        items = [one.get("objectid") for one in model.findall("m:build/m:item", SPACE)]
        bases = [(base.get("name"), base.get("displaycolor")) for base in model.findall(".//m:base", SPACE)]
        return meshes, held, items, bases, model.get("unit")

    def test_the_certificate_says_what_was_requested_and_what_is_met(self):
        self.put([self.cylinder()], "a.stl")
        text = "".join(text for _, text in self.said)
        for words in ("Cylinder: requested: smallest angle 25°, max. deviation 0.03 mm; 0 exempt triangles, watertight\n",
                      "; all requested limits are met.\n", f"Written: {self.folder}/a.stl\n"):
            self.assertIn(words, text)
        self.assertNotIn("warning", dict(self.said))

    def test_what_is_not_met_is_a_warning_and_the_file_is_there(self):
        pair = self.document.addObject("Part::Feature", "Pair")
        pair.Shape = Part.makeCompound([Part.makeBox(10, 10, 10), Part.makeBox(10, 10, 10, FreeCAD.Vector(5, 5, 5))])
        path = self.put([pair], "a.stl")
        (warning,) = [text for kind, text in self.said if kind == "warning"]
        self.assertRegex(warning, r"^Pair: 24 triangles.*target not met: 1 pair of bodies overlaps")
        self.assertEqual(Mesh.Mesh(path).CountFacets, 24)

    def test_exempt_triangles_are_counted(self):
        wedge = self.document.addObject("Part::Feature", "Wedge")
        wedge.Shape = Part.Face(Part.makePolygon([FreeCAD.Vector(*p) for p in ((0, 0, 0), (50, 0, 0), (50, 5, 0), (0, 0, 0))])
                                ).extrude(FreeCAD.Vector(0, 0, 5))
        self.put([wedge], "a.stl")
        self.assertRegex("".join(text for _, text in self.said), r"Wedge: requested: .*; [1-9]\d* exempt triangles, watertight")

    def test_3mf_has_a_part_a_body_by_the_names_of_the_tree(self):
        lone, whole = self.cylinder(at=(0, 50, 0), name="Lone"), self.assembly()
        meshes, held, items, bases, unit = self.objects(self.put([whole, lone], "a.3mf"))
        self.assertEqual(unit, "millimeter")
        self.assertEqual({name: len(parts) for name, parts in held.values()}, {"Träger <1>": 2})
        self.assertEqual([held[one][0] if one in held else meshes[one][0] for one in items], ["Träger <1>", "Lone"])
        self.assertEqual([meshes[one][0] for one in held[items[0]][1]], ["Kiste & Deckel", "Cylinder"])
        self.assertEqual([name for name, _ in bases], ["Kiste & Deckel", "Cylinder", "Lone"])
        self.assertEqual(len({colour for _, colour in bases}), 3)
        for i, (name, points, corners, materials) in enumerate(meshes.values()):
            one = Mesh.Mesh([[points[k] for k in row] for row in corners])
            self.assertTrue(one.isSolid(), name)
            self.assertEqual(set(materials), {i})
        self.assertEqual(meshes[held[items[0]][1][0]][1].min(axis=0).tolist(), [0, 0, 100])
        self.assertRegex("".join(text for kind, text in self.said if kind == "warning"), "1 hidden object .*: Sphere")

    @unittest.skipUnless(shutil.which("prusa-slicer"), "PrusaSlicer (prusa-slicer) is not installed")
    def test_a_slicer_has_each_body_in_its_place(self):
        path = self.put([self.assembly(), self.cylinder(at=(0, 50, 0), name="Lone")], "a.3mf")
        said = subprocess.run(["prusa-slicer", "--info", path], capture_output=True, text=True, timeout=120, check=True).stdout
        self.assertEqual(said.count("manifold = yes"), 3)
        places = {(0, 0, 100), (25, -5, 100), (-5, 45, 0)}
        found = {tuple(round(float(number)) for number in place) for place in re.findall(
            r"min_x = (\S+)\nmin_y = (\S+)\nmin_z = (\S+)\n", said)}
        if len(found) == len(places):
            self.assertEqual(found, places)
            return
        # PrusaSlicer 2.9 tells of each body as if it stood alone; the plate has them in their places, each on the bed.
        plate = os.path.join(self.folder, "plate.stl")
        subprocess.run(["prusa-slicer", "--export-stl", "--dont-arrange", "-o", plate, path], capture_output=True, timeout=120, check=True)
        boxes = [body.BoundBox for body in Mesh.Mesh(plate).getSeparateComponents()]
        self.assertEqual({(round(box.XMin), round(box.YMin)) for box in boxes}, {place[:2] for place in places})

    @unittest.skipUnless(shutil.which("prusa-slicer"), "PrusaSlicer (prusa-slicer) is not installed")
    def test_a_slicer_slices_it_without_a_warning_in_any_unit(self):
        used, store = {}, file_settings.stored()
        for unit, name in ((0, "mm.3mf"), (1, "m.3mf"), (2, "inch.3mf"), (0, "mm.stl"), (0, "mm.obj")):
            self.addCleanup(store.SetInt, "ExportUnit", 0)
            store.SetInt("ExportUnit", unit)
            path = self.put([self.cylinder(name=f"Pin{len(used)}")], name)
            sliced = os.path.join(self.folder, "sliced.gcode")
            said = subprocess.run(["prusa-slicer", "--export-gcode", "--loglevel", "2", "-o", sliced, path], stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, timeout=120, check=True).stdout
            self.assertNotIn("warning", said.lower())
            with open(sliced, encoding="utf-8") as stream:
                used[name] = float(re.search(r"filament used \[mm\] = (\S+)", stream.read())[1])
        self.assertGreater(min(used.values()), 10.0)
        self.assertAlmostEqual(min(used.values()), max(used.values()), delta=1e-3 * max(used.values()))

    def test_3mf_has_the_colours_of_faces(self):
        box, view = self.box(), mock.Mock(spec=["DiffuseColor", "ShapeColor"])
        view.DiffuseColor = [(1.0, 0.0, 0.0, 0.0)] + [(0.0, 0.0, 1.0, 0.0)] * 5
        with mock.patch.object(export_bodies, "getattr", lambda obj, name, default=None: view if name == "ViewObject"
                               else getattr(obj, name, default), create=True):
            (mesh,), _, _, bases, _ = (part.values() if isinstance(part, dict) else part
                                       for part in self.objects(self.put([box], "a.3mf")))
        self.assertEqual(bases, [("Box #ff0000", "#FF0000"), ("Box #0000ff", "#0000FF")])
        _, points, corners, materials = mesh
        red = points[corners[np.array(materials) == 0]]
        self.assertTrue((red[:, :, 0] == red[0, 0, 0]).all())  # Face1 is the one at x = 0
        self.assertEqual((len(red), red[0, 0, 0]), (2, 0.0))

    def test_several_bodies_are_groups_in_other_files(self):
        whole = self.assembly()
        path = self.put([whole], "a.obj")
        with open(path, encoding="utf-8") as stream:
            self.assertEqual([line.split()[1] for line in stream if line.startswith("g ")], ["Kiste_Deckel", "Cylinder"])
        found = Mesh.Mesh(path)
        self.assertEqual(found.countComponents(), 2)
        self.assertAlmostEqual(found.BoundBox.ZMin, 100.0)
        box = self.document.getObject("Box")
        self.assertAlmostEqual(Mesh.Mesh(self.put([whole, box], "b.stl")).Volume, found.Volume, places=2)  # the box is there once

    def test_a_link_stands_where_it_is(self):
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject, link.Placement.Base = self.assembly(), FreeCAD.Vector(0, 200, 0)
        self.document.recompute()
        meshes, held, items, *_ = self.objects(self.put([link], "a.3mf"))
        self.assertEqual([meshes[one][0] for one in held[items[0]][1]], ["Kiste & Deckel", "Cylinder"])
        self.assertEqual(meshes[held[items[0]][1][0]][1].min(axis=0).tolist(), [0, 200, 0])  # a link has its own placement

    def test_arrays_of_links_and_groups(self):
        link, group = self.document.addObject("App::Link", "Row"), self.document.addObject("App::DocumentObjectGroup", "Group")
        link.LinkedObject, link.ElementCount = self.box(), 3
        for i, element in enumerate(link.ElementList):
            element.Placement.Base.y = 20 * i
        group.addObject(self.cylinder(at=(50, 0, 0)))
        self.document.recompute()
        meshes, held, items, bases, _ = self.objects(self.put([link, group], "a.3mf"))
        self.assertEqual([held[one][0] if one in held else meshes[one][0] for one in items], ["Row", "Cylinder"])
        self.assertEqual([meshes[one][1].min(axis=0)[1] for one in held[items[0]][1]], [0, 20, 40])
        self.assertEqual(len(bases), 4)
        self.assertEqual(Mesh.Mesh(self.put([group], "a.stl")).countComponents(), 1)

    def test_the_tip_of_a_body_is_the_body(self):
        body = self.document.addObject("PartDesign::Body", "Body")
        pad = body.newObject("PartDesign::AdditiveBox", "Block")
        body.Label = "Gehäuse"
        self.document.recompute()
        for chosen in ([body], [pad], [body, pad], [*self.document.Objects]):
            meshes, _, items, *_ = self.objects(self.put(chosen, "a.3mf"))
            self.assertEqual([meshes[one][0] for one in items], ["Gehäuse"])

    def test_what_hidden_objects_are_the_source_of_is_there_once(self):
        box, tool = self.box(), self.cylinder()
        cut = self.document.addObject("Part::Cut", "Cut")
        cut.Base, cut.Tool = box, tool
        self.document.recompute()
        box.Visibility = tool.Visibility = False
        found = Mesh.Mesh(self.put(self.document.Objects, "a.stl"))
        self.assertAlmostEqual(found.Volume, cut.Shape.Volume, delta=0.01 * cut.Shape.Volume)

    def test_meshes_are_written_as_they_are(self):
        box = self.box()
        ours, other = mq.add_quality_mesh(box), self.document.addObject("Mesh::Feature", "Other")
        other.Mesh = Mesh.createSphere(5.0, 12)
        for obj in (ours, other):
            for suffix in (".stl", ".3mf"):
                found = self.read(self.put([obj], f"a{suffix}"))
                self.assertEqual(found.CountFacets, obj.Mesh.CountFacets)
                self.assertAlmostEqual(found.Volume, obj.Mesh.Volume, places=4)
        self.assertIn(("message", f"{ours.Label}: met\n"), self.said)
        found = Mesh.Mesh(self.put([other, box], "b.stl"))
        self.assertEqual(found.CountFacets, other.Mesh.CountFacets + 12)

    def test_the_preferences_are_those_of_a_headless_freecad_too(self):
        part, store = self.cylinder(), file_settings.stored()
        counts = []
        for fineness in range(4):
            store.SetInt("ExportFineness", fineness)
            counts.append(Mesh.Mesh(self.put([part], "a.stl")).CountFacets)
        self.assertEqual(counts, sorted(set(counts)))
        store.SetFloat("ExportChordHeight", 0.5)
        self.assertLess(Mesh.Mesh(self.put([part], "a.stl")).CountFacets, counts[0])
        self.assertIn("max. deviation 0.5 mm", "".join(text for _, text in self.said))
        store.SetFloat("MinAngle", 31.0)
        self.assertGreaterEqual(self.smallest(Mesh.Mesh(self.put([part], "a.stl"))), 30.999)
        store.SetInt("ExportUnit", 2)
        self.assertAlmostEqual(Mesh.Mesh(self.put([part], "a.stl")).BoundBox.ZMax, 10 / 25.4, places=6)
        self.assertEqual(self.objects(self.put([part], "a.3mf"))[4], "inch")
        store.SetInt("ExportFineness", 7)  # of another version
        self.put([part], "a.stl")

    @staticmethod
    def smallest(mesh):
        angles = []
        for facet in mesh.Facets:
            a, b, c = (FreeCAD.Vector(*point) for point in facet.Points)
            angles += [math.degrees((q - p).getAngle(r - p)) for p, q, r in ((a, b, c), (b, c, a), (c, a, b))]
        return min(angles)


class Refused(FileMenu):
    def test_errors_name_the_object_and_leave_the_older_file(self):
        path = os.path.join(self.folder, "a.stl")
        with open(path, "w", encoding="utf-8") as stream:
            stream.write("older")
        line, box = self.document.addObject("Part::Line", "Line"), self.box()
        self.document.recompute()
        broken = self.document.addObject("Part::Feature", "Broken")
        broken.Shape = box.Shape
        for objects, name, words in (([line], "a.stl", "Line.*no faces"), ([], "a.stl", "nothing to export"),
                                     ([box], "a.docx", "ends in one of"), ([box], "none/a.stl", "there is no folder")):
            with self.assertRaisesRegex(mq.Error, words):
                exchange.export(objects, os.path.join(self.folder, name))
        with mock.patch("MeshQuality.features.file_export.triangulate", side_effect=mq.GeometryError("Face3 cannot be meshed")), \
                self.assertRaisesRegex(mq.GeometryError, "Face3"):
            exchange.export([broken], path)
        with mock.patch("MeshQuality.core.formats.three_mf.zipfile.ZipFile", side_effect=OSError(28, "No space left")), \
                self.assertRaisesRegex(mq.IoError, "a.3mf.*No space left"):
            exchange.export([box], os.path.join(self.folder, "a.3mf"))
        with open(path, encoding="utf-8") as stream:
            self.assertEqual(stream.read(), "older")
        self.assertEqual(os.listdir(self.folder), ["a.stl"])

    @unittest.skipUnless(has("meshio"), "meshio is not installed")
    def test_a_fem_mesh_goes_alone(self):
        fem, box = self.document.addObject("Fem::FemMeshObject", "Given"), self.box()
        fem.FemMesh = mq.curve(box.Shape, volume=True).to_fem_mesh(groups=True)
        with self.assertRaisesRegex(mq.InvalidInput, "'Given' is a FEM mesh.*select it alone"):
            self.put([fem, box], "a.inp")
        found = meshio.read(self.put([fem], "a.inp"))
        self.assertEqual(len(found.cells_dict["tetra10"]), fem.FemMesh.VolumeCount)


class Solvers(FileMenu):
    def test_every_format_has_the_bodies_by_name(self):
        whole = self.assembly()
        solids = {"Kiste_Deckel": 1000.0, "Cylinder": np.pi * 250}
        faces = [f"Kiste_Deckel_Face{k}" for k in range(1, 7)] + [f"Cylinder_Face{k}" for k in range(1, 4)]
        for suffix in sorted({".inp", ".unv", ".nas", ".bdf", ".exo", ".cgns", ".msh", ".msh2"} - WITHOUT):
            found = mq.read_mesh(self.put([whole], f"a{suffix}"))
            groups = {name: found.group_members[name] for name in found.groups}
            self.assertEqual([name for name in faces if name not in groups], [], suffix)
            for name, volume in solids.items():
                rows = [found.blocks[i].nodes[k][:, :4] for i, k in groups[name]]
                corners = found.nodes[np.concatenate(rows)]
                edges = corners[:, 1:] - corners[:, :1]
                self.assertAlmostEqual(np.linalg.det(edges).sum() / 6, volume, delta=0.06 * volume, msg=suffix)
        with open(self.put([whole], "a.mesh"), encoding="utf-8") as stream:
            self.assertIn("# attribute 2: Cylinder\n", stream.read())
        with open(self.put([whole], "a.xml"), encoding="utf-8") as stream:
            self.assertIn("Kiste_Deckel", stream.read())

    @unittest.skipUnless(has("meshio"), "meshio is not installed")
    def test_other_programs_read_the_groups(self):
        whole = self.assembly()
        by_inp = meshio.read(self.put([whole], "a.inp"))
        self.assertEqual({"Kiste_Deckel", "Cylinder"} - set(by_inp.cell_sets), set())
        self.assertEqual({"Kiste_Deckel_Face1", "Cylinder_Face3"} - set(by_inp.point_sets), set())
        self.assertTrue(all(by_inp.points[by_inp.point_sets["Kiste_Deckel_Face1"], 0] == 0.0))
        self.assertEqual({kind for kind in by_inp.cells_dict}, {"tetra10"})
        by_gmsh = meshio.read(self.put([whole], "a.msh"))
        self.assertEqual({"Kiste_Deckel", "Cylinder", "Cylinder_Face2"} - set(by_gmsh.field_data), set())
        by_su2 = meshio.read(self.put([whole], "a.su2"))
        self.assertEqual(len(by_su2.cells_dict["tetra"]) > 0, True)
        self.assertIn("tetra", by_su2.cells_dict)  # the highest order of the format is 1
        self.assertIn("elements of order 1", "".join(text for _, text in self.said))
        import Fem

        found = Fem.read(self.put([whole], "a.unv"))
        names = [found.getGroupName(group) for group in found.Groups]
        self.assertIn("Cylinder_Face2_Faces", names)

    @unittest.skipUnless(has("meshio"), "meshio is not installed")
    def test_bodies_that_touch_share_their_nodes(self):
        part = self.document.addObject("App::Part", "Asm")
        first, second = self.box(), self.box("Second")
        second.Placement.Base.x = 10
        part.addObjects([first, second])
        self.document.recompute()
        found = meshio.read(self.put([part], "a.inp"))
        self.assertEqual(len(np.unique(found.points, axis=0)), len(found.points))
        self.assertTrue(any("shape distortion" in text and "limits are met" in text for _, text in self.said))

    def test_faces_of_several_bodies_are_told_apart(self):
        first, second = self.box(), self.box("Second")
        second.Placement.Base = FreeCAD.Vector(5, 5, 5)  # they overlap
        self.document.recompute()
        self.put([first, second], "a.inp")
        self.assertIn(("message", "Second: Face7 to Face12 of all that is exported\n"), self.said)
        (warning,) = [text for kind, text in self.said if kind == "warning"]
        self.assertIn("Box, Second:", warning)
        self.assertIn("target not met", warning)

    @unittest.skipUnless(has("meshio"), "meshio is not installed")
    def test_shells_and_triangles(self):
        face = self.document.addObject("Part::Plane", "Plane")
        self.document.recompute()
        self.assertEqual(set(meshio.read(self.put([face], "a.msh")).cells_dict), {"triangle6", "line3"})
        box = self.box()
        file_settings.stored().SetInt("ExportElements", 1)
        self.assertEqual(set(meshio.read(self.put([box], "a.msh")).cells_dict), {"triangle6", "line3"})
        file_settings.stored().SetInt("ExportOrder", 1)
        self.assertEqual(set(meshio.read(self.put([box], "a.inp")).cells_dict), {"triangle"})
        whole = mq.add_quality_mesh(box)
        found = meshio.read(self.put([whole, self.cylinder(at=(30, 0, 0))], "b.msh"))
        self.assertIn("Cylinder_Face1", found.field_data)
        self.assertIn("Box_quality_mesh_Face1", found.field_data)

    @unittest.skipUnless(has("netCDF4"), "netCDF for Python is not installed")
    def test_long_labels_fit_the_format(self):
        first, second = self.box(), self.box("Second", Placement=FreeCAD.Placement(FreeCAD.Vector(0, 0, 40), FreeCAD.Rotation()))
        first.Label, second.Label = "A very long label of a first part of it all", "A very long label of a second part of it all"
        found = mq.read_mesh(self.put([first, second], "a.exo"))
        self.assertEqual(len(found.groups), 14)
        self.assertLessEqual(max(map(len, found.groups)), 32)


class Import(FileMenu):
    def given(self, kind, order, serendipity=0, suffix=".msh"):
        path = os.path.join(self.folder, f"given{suffix}")
        subprocess.run(["/usr/bin/python3", "-c", BY_GMSH, path, kind, str(order), str(serendipity)], check=True, timeout=120,
                       capture_output=True)
        return path

    def take(self, path):
        return by_type("import", os.path.splitext(path)[1]).insert(path, self.document.Name)

    @unittest.skipUnless(has("vtkmodules"), "VTK's Python module is not installed")
    @unittest.skipUnless(has("gmsh"), "Gmsh's Python module is not installed")
    def test_elements_of_others_come_with_their_groups(self):
        for kind, order, nodes in (("hexahedron", 1, 8), ("hexahedron", 2, 20), ("prism", 1, 6), ("prism", 2, 15)):
            mesh = self.take(self.given(kind, order)).FemMesh
            groups = {mesh.getGroupName(group): (mesh.getGroupElementType(group), len(mesh.getGroupElements(group)))
                      for group in mesh.Groups}
            self.assertEqual(groups["block"], ("Volume", mesh.VolumeCount))
            self.assertEqual(groups["bottom"][0], "Face")
            self.assertGreater(mesh.VolumeCount, 0)
            self.assertEqual({len(mesh.getElementNodes(number)) for number in mesh.Volumes}, {nodes})
            self.assertAlmostEqual(self.volume(mesh), 6000.0, places=3)
            bottom = next(group for group in mesh.Groups if mesh.getGroupName(group) == "bottom")
            used = {node for face in mesh.getGroupElements(bottom) for node in mesh.getElementNodes(face)}
            self.assertEqual({mesh.Nodes[node].z for node in used}, {0.0})
            self.assertEqual(set(mesh.Nodes), {node for number in mesh.Volumes for node in mesh.getElementNodes(number)})
            if order == 2:
                self.check_middles(mesh, nodes)

    def volume(self, mesh):
        """The signed volume of straight elements as FreeCAD writes them and VTK divides them."""
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

        path = os.path.join(self.folder, "fem.vtu")
        mesh.write(path)
        reader, triangulate = vtkXMLUnstructuredGridReader(), vtkDataSetTriangleFilter()
        reader.SetFileName(path)
        triangulate.SetInputConnection(reader.GetOutputPort())
        triangulate.TetrahedraOnlyOn()
        triangulate.Update()
        grid = triangulate.GetOutput()
        points = vtk_to_numpy(grid.GetPoints().GetData())
        corners = points[vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)].astype(float)
        return abs(np.linalg.det(corners[:, 1:] - corners[:, :1]).sum()) / 6

    def check_middles(self, mesh, nodes):
        """Middle nodes are between the corners where SMESH has them: below, above, then between."""
        corners = nodes // 5 * 2
        half = corners // 2
        ring = [(k, (k + 1) % half) for k in range(half)]
        edges = [*ring, *((a + half, b + half) for a, b in ring), *((k, k + half) for k in range(half))]
        for number in mesh.Volumes:
            at = [mesh.Nodes[node] for node in mesh.getElementNodes(number)]
            for (a, b), middle in zip(edges, at[corners:]):
                self.assertLess(((at[a] + at[b]) / 2 - middle).Length, 1e-9)

    @unittest.skipUnless(has("vtkmodules"), "VTK's Python module is not installed")
    def test_files_of_each_format(self):
        solid = mq.curve(self.cylinder().Shape, volume=True, patches={"inlet": ["Face2"]}, patch_rest="walls")
        for suffix in sorted({".msh", ".inp", ".su2", ".cgns", ".exo"} - WITHOUT):
            path, written = os.path.join(self.folder, f"a{suffix}"), solid.with_order(1) if suffix == ".su2" else solid
            written.write(path)
            obj = self.take(path)
            self.assertEqual(obj.TypeId, "Fem::FemMeshObject")
            self.assertEqual((obj.Label[:1], obj.FemMesh.VolumeCount), ("a", len(solid.tetrahedra)))
            names = {obj.FemMesh.getGroupName(group) for group in obj.FemMesh.Groups}
            self.assertEqual({"inlet", "walls"} - names, set(), suffix)
            self.assertAlmostEqual(self.volume(obj.FemMesh), 250 * np.pi, delta=50.0)

    @unittest.skipUnless(has("vtkmodules"), "VTK's Python module is not installed")
    @unittest.skipUnless(has("meshio"), "meshio is not installed")
    def test_triangles_alone_and_the_unit(self):
        path = os.path.join(self.folder, "a.su2")
        meshio.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [("tetra", [[0, 1, 2, 3]])]).write(path)
        file_settings.stored().SetInt("ExportUnit", 1)
        self.assertAlmostEqual(self.volume(self.take(path).FemMesh), 1e9 / 6, delta=1.0)
        path = os.path.join(self.folder, "b.msh")
        mesh = mq.triangulate(Part.makeBox(1, 2, 3))
        mesh.write(path)
        self.assertEqual(self.take(path).FemMesh.TriangleCount, len(mesh.triangles))

    @unittest.skipUnless(has("gmsh"), "Gmsh's Python module is not installed")
    def test_a_new_document_and_one_undo_step(self):
        path = self.given("prism", 1)
        found = exchange.open(path)
        self.names.append(found.Name)
        self.assertEqual([obj.TypeId for obj in found.Objects], ["Fem::FemMeshObject"])
        before = self.document.UndoCount
        self.take(path)
        self.assertEqual(self.document.UndoCount, before + 1)
        self.document.undo()
        self.assertEqual(self.document.Objects, [])
        made = exchange.insert(path, "NotThereYet")
        self.names.append(made.Document.Name)

    def test_what_cannot_be_taken_is_said_and_adds_nothing(self):
        path = os.path.join(self.folder, "a.msh")
        mq.curve(Part.makeSphere(5), order=3).write(path)
        with self.assertRaisesRegex(mq.InvalidInput, "elements of order 3"):
            self.take(path)
        with open(path, "r+b") as stream:
            stream.truncate(300)
        with self.assertRaisesRegex(mq.IoError, "a.msh"):
            self.take(path)
        self.assertEqual(self.document.Objects, [])
