# SPDX-License-Identifier: LGPL-2.1-or-later
"""The recipes for the console in the guides do what they say."""

import os
import re
import tempfile
import unittest

import FreeCAD
import helpers
import Mesh
import Part
import test_patches

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
        self.assertEqual(kinds, ["QualityMesh", "CurvedMeshObject", "MeshBoolean", "HollowObject"])

    def test_measuring(self):
        self.follow("docs/use/measures.md")
        self.assertEqual(os.listdir("."), ["measures.csv"])

    def test_sections(self):
        self.follow("docs/use/section.md")
        self.assertEqual(sorted(os.listdir(".")), ["cut.csv", "half.vtu"])
        self.assertAlmostEqual(self.names["cut"].area, 24 * 3.14159, delta=1.5)

    def test_improving(self):
        self.follow("docs/use/improve.md")
        self.assertGreaterEqual(self.names["better"].report.min_angle, 25)

    def test_machining(self):
        self.follow("docs/use/cam.md")
        self.assertGreater(self.names["mesh"].nearest, 0.0)

    def test_flows(self):
        self.follow("docs/use/flow.md")
        self.assertEqual(sorted(os.listdir(".")), ["case", "pipe.msh", "pipe.vtu", "pipe_case"])
        self.assertEqual((self.names["obj"].Certificate, self.names["obj"].Walls), ("met", ["Face1"]))

    def test_reporting(self):
        self.follow("docs/use/report.md")
        self.assertEqual(sorted(os.listdir(".")), ["body.html", "mesh.html", "walls.html"])

    def test_simplifying(self):
        self.follow("docs/use/simplify.md")
        self.assertLess(self.names["small"].report.triangles, self.names["mesh"].CountFacets)

    def test_solids_of_meshes(self):
        self.follow("docs/use/to-solid.md")
        self.assertEqual((self.names["solid"].faces, self.names["solid"].facets), (11, 0))
        self.assertEqual(os.listdir("."), ["hollow.step"])

    def test_following(self):
        self.follow("docs/use/follow.md")

    def test_adapting(self):
        self.follow("docs/use/adapt.md")
        self.assertEqual(self.names["result"].stopped, "target")

    def test_sizes(self):
        self.follow("docs/use/sizes.md")

    def test_quality_meshes(self):
        self.follow("docs/use/quality-mesh.md")

    def test_booleans(self):
        self.follow("docs/use/boolean.md")

    def test_curved_meshes(self):
        self.follow("docs/use/curved-mesh.md")

    def test_analysing(self):
        self.follow("docs/use/analyse-quality.md")
        self.assertTrue(self.names["report"].closed)

    def test_to_print(self):
        self.follow("docs/use/print.md")
        self.assertEqual(os.listdir("."), ["print.stl"])

    def test_thickness(self):
        self.names["assembly"] = assembly = self.document.addObject("App::Part", "Assembly")
        for x in (0.0, 10.1):
            box = self.box()
            box.Placement.Base.x = x
            assembly.addObject(box)
        self.document.recompute()
        self.follow("docs/use/thickness.md")
        self.assertEqual(os.listdir("."), ["walls.csv"])
        checks = {obj.Check: obj for obj in self.document.Objects if hasattr(obj, "Check")}
        self.assertEqual(sorted(checks), ["clearance", "draft", "thickness", "voids"])
        self.assertAlmostEqual(checks["clearance"].Minimum.Value, 0.1, places=6)
        self.assertEqual(self.names["obj"].MinThickness.Value, 0.8)
        self.assertLess(self.names["found"].minimum, 10.0)

    def test_offset(self):
        self.names["shape"] = Part.makeBox(20, 20, 10)
        self.follow("docs/use/offset.md")
        self.assertEqual(os.listdir("."), ["cup.stl"])
        self.assertGreater(self.names["larger"].report.volume, 4000.0)
        for name, volume in (("core", 18 * 18 * 8), ("shell", 4000 - 16 * 16 * 6), ("cup", 4000 - 17.6 * 18.8 * 7.6)):
            self.assertAlmostEqual(self.names[name].report.volume / volume, 1.0, delta=0.05, msg=name)
            self.assertTrue(self.names[name].report.closed)

    @unittest.skipUnless(test_patches.has_cgns(), "the CGNS library is not installed")
    def test_wrap(self):
        tub = Part.makeBox(20, 16, 9).cut(Part.makeBox(16, 12, 9, FreeCAD.Vector(2, 2, 2)))
        self.names["objects"] = [tub, Part.makeBox(20, 16, 2, FreeCAD.Vector(0, 0, 9.5))]
        for name, shape in zip(("Tub", "Lid"), self.names["objects"]):
            self.document.addObject("Part::Feature", name).Shape = shape
        self.document.Scan.Placement.Base = FreeCAD.Vector(50, 0, 0)
        self.document.recompute()
        self.names["tunnel"] = Part.makeBox(60, 60, 60, FreeCAD.Vector(-20, -20, -20))
        self.follow("docs/use/wrap.md")
        self.assertEqual(sorted(os.listdir(".")), ["case", "flow.cgns", "flow.stl", "outside.stl"])
        self.assertEqual(self.names["obj"].Certificate, "met")
        with open("flow.cgns", "rb") as stream:
            written = stream.read()
        for name in (b"lid", b"seat", b"cracks", b"walls"):
            self.assertIn(name, written)
        outside = self.names["outside"]
        self.assertTrue(outside.report.closed and outside.gap_area > 0.0)
        self.assertAlmostEqual(outside.report.volume, 20 * 16 * 11.5, delta=30.0)
        self.assertAlmostEqual(self.names["around"].report.volume, 60**3 - outside.report.volume, delta=1.0)
        self.assertEqual(len(self.names["gaps"]), outside.gap_triangles)
        with open("flow.stl", encoding="ascii") as stream:
            solids = [line.split()[1] for line in stream if line.startswith("solid")]
        self.assertEqual(solids, ["lid", "walls"])
        with open("outside.stl", encoding="ascii") as stream:
            solids = [line.split()[1] for line in stream if line.startswith("solid")]
        self.assertIn("gaps", solids)
        self.assertIn("Object2_Face6", solids)

    def test_clearance(self):
        self.names["assembly"] = Part.makeCompound([Part.makeBox(4, 4, 4, FreeCAD.Vector(4.1 * i, 0, 0)) for i in range(2)])
        self.follow("docs/use/clearance.md")
        self.assertEqual(len(self.names["found"].too_near), 1)

    def test_draft(self):
        self.names["shape"] = Part.makeBox(9, 9, 9).cut(Part.makeCylinder(2, 20, FreeCAD.Vector(4, 0, 4), FreeCAD.Vector(0, 1, 0)))
        self.follow("docs/use/draft.md")
        self.assertGreater(len(self.names["stuck"]), 0)
        self.assertGreater(len(self.names["steep"]), 0)

    def test_for_fem(self):
        self.follow("docs/use/fem.md")
        self.assertGreater(self.names["fem"].VolumeCount, 0)

    def test_for_cfd(self):
        self.follow("docs/use/cfd.md")
        self.assertEqual(sorted(os.listdir(".")), ["case", "surface.vtu"])
        self.assertGreater(len(self.names["wall"]), 0)
        self.assertEqual(self.names["surface"].Patches, ["Face1: inlet", "Face2: outlet", "Face3: walls"])

    def test_files(self):
        self.follow("docs/use/files.md")
        self.assertEqual(sorted(os.listdir(".")), ["duct.fms", "duct.inp", "duct.stl"])
        self.assertEqual(list(self.names["whole"].Patches), ["Body: Face1, Face2, Face3"])

    def test_meshes_from_elsewhere(self):
        self.follow("docs/use/meshes-from-elsewhere.md")
        self.assertEqual((self.names["mesh"].blocks[0].kind, self.names["mesh"].faults), ("tetrahedron", ()))
        self.assertEqual([rows.shape[1] for rows in self.names["faces"]], [6])

    def test_deviation(self):
        part = self.names["part"] = self.document.addObject("Part::Box", "Block")
        part.Length, part.Width, part.Height = 10, 8, 6
        self.document.recompute()
        measured = mq.triangulate(part, max_edge=1.0)
        scan = self.names["scan"] = self.document.getObject("Scan")
        scan.Mesh = Mesh.Mesh([tuple(corner + 0.3) for triangle in measured.triangles for corner in measured.vertices[triangle]])
        self.follow("docs/use/deviation.md")
        self.assertLess(abs(self.names["found"].max_deviation), 1e-4)
        self.assertEqual(os.listdir("."), ["deviation.csv"])
        self.assertEqual(self.names["obj"].Certificate, "met")

    def test_export(self):
        document = FreeCAD.newDocument("Printer")
        for name in ("Assembly", "Body"):
            document.addObject("Part::Box", name)
        document.recompute()
        document.saveAs(os.path.join(os.getcwd(), "printer.FCStd"))
        FreeCAD.closeDocument(document.Name)
        settings = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/MeshQuality")
        self.addCleanup(settings.RemInt, "ExportFineness")
        self.follow("docs/use/export.md")
        self.addCleanup(FreeCAD.closeDocument, self.names["document"].Name)
        self.assertEqual(sorted(os.listdir(".")), ["bracket.inp", "printer.3mf", "printer.FCStd"])

    def test_to_repair(self):
        self.follow("docs/use/repair.md")
        self.assertGreaterEqual(self.names["better"].report.min_angle, 25)
        self.assertEqual(os.listdir("."), ["repaired.stl"])

    def test_every_guide_with_recipes_is_followed(self):
        folder = os.path.join(helpers.ROOT, "docs", "use")
        with_recipes = {f"docs/use/{name}" for name in os.listdir(folder) if recipes(f"docs/use/{name}")}
        with open(__file__, encoding="utf-8") as stream:
            followed = set(re.findall(r'self\.follow\("(docs/.*?)"\)', stream.read()))
        self.assertEqual(with_recipes - followed, {"docs/use/mesh-objects.md"})  # which test_mesh_objects follows
