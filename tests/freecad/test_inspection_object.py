# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Inspection": each check, limits, recompute, undo, save and reload, errors."""

import FreeCAD
import helpers
import Mesh
import Part

import MeshQuality as mq
from MeshQuality import options


class InspectionTest(helpers.DocumentTest):
    def part(self, shape, name="Part"):
        obj = self.document.addObject("Part::Feature", name)
        obj.Shape = shape
        self.document.recompute()
        return obj

    def stepped(self, thin=1.0):
        """A plate that is 3 mm thick, and thinner at one end."""
        return Part.makeBox(30, 20, 3).cut(Part.makeBox(10, 20, 3 - thin, FreeCAD.Vector(20, 0, thin)))

    def faces_at(self, shape, test):
        return {f"Face{i + 1}" for i, face in enumerate(shape.Faces) if test(face.CenterOfMass)}


class Thickness(InspectionTest):
    def test_the_thinnest_wall_and_its_place(self):
        source = self.part(self.stepped())
        obj = mq.add_inspection(source)
        self.assertEqual((obj.Check, obj.Source, obj.Label), ("thickness", source, "Part inspection"))
        self.assertAlmostEqual(obj.Minimum.Value, 1.0, delta=0.02)
        place, = obj.Places
        self.assertGreater(place.x, 19.0)
        expected = self.faces_at(source.Shape, lambda c: c.x > 19.9 and abs(c.z - 1.0) < 1e-6) \
            | self.faces_at(source.Shape, lambda c: c.z < 1e-6)
        self.assertEqual(set(obj.Faces), expected)
        self.assertEqual((obj.Certificate, obj.Status, obj.Count), ("met", "up to date", 0))  # there is no limit
        self.assertEqual(obj.getEditorMode("Minimum"), ["ReadOnly"])
        self.assertEqual(obj.getEditorMode("VoidVolume"), ["Hidden"])
        self.assertTrue(obj.Mesh.isSolid())
        self.assertEqual(obj.Triangles, obj.Mesh.CountFacets)

    def test_a_wall_below_the_limit_is_too_thin_until_it_is_thicker(self):
        source = self.part(self.stepped())
        obj = mq.add_inspection(source, min_thickness=1.5)
        self.assertEqual(obj.MinThickness.Value, 1.5)
        self.assertRegex(obj.Certificate, r"not met: smallest thickness (1|0\.99\d*|1\.0\d*) mm \(requested 1\.5 mm\)")
        self.assertEqual((obj.Count, set(obj.CertificateFaces)), (2, set(obj.Faces)))  # two sides
        self.assertEqual(len(obj.CertificatePlace), 3)
        source.Shape = self.stepped(thin=2.0)
        self.document.recompute()
        self.assertAlmostEqual(obj.Minimum.Value, 2.0, delta=0.04)
        self.assertEqual((obj.Certificate, obj.Count), ("met", 0))
        mq.update(obj, min_thickness=2.5)
        self.assertTrue(obj.Certificate.startswith("not met"))
        self.assertEqual(self.document.UndoNames[0], "Update Part inspection")

    def test_a_curved_wall_as_thick_as_its_limit_is_neither_met_nor_missed(self):
        source = self.part(Part.makeCylinder(20, 10).cut(Part.makeCylinder(16, 10)))
        obj = mq.add_inspection(source, min_thickness=4.0)
        self.assertRegex(obj.Certificate, r"not decided: smallest thickness between 3\.\d+ mm and 4\.\d+ mm \(requested 4 mm\)")
        self.assertEqual(len(obj.CertificatePlace), 3)
        mq.update(obj, min_thickness=4.2)
        self.assertTrue(obj.Certificate.startswith("not met"))
        mq.update(obj, min_thickness=3.8)
        self.assertEqual(obj.Certificate, "met")

    def test_gaps(self):
        source = self.part(Part.makeBox(30, 20, 10).cut(Part.makeBox(2, 20, 8, FreeCAD.Vector(14, 0, 2))))
        obj = mq.add_inspection(source, gap=True, min_thickness=2.5)
        self.assertAlmostEqual(obj.Minimum.Value, 2.0, delta=0.04)
        self.assertTrue(obj.Certificate.startswith("not met: smallest gap"))

    def test_of_a_mesh(self):
        source = self.document.addObject("Mesh::Feature", "Block")
        source.Mesh = Mesh.createBox(30.0, 20.0, 2.0)
        self.document.recompute()
        obj = mq.add_inspection(source, measure="rays")
        self.assertAlmostEqual(obj.Minimum.Value, 2.0, delta=0.01)
        self.assertEqual(list(obj.Faces), [])

    def test_nothing_is_done_when_nothing_changed(self):
        source = self.part(self.stepped())
        obj = mq.add_inspection(source)
        obj.Notes = ["kept while the mesh is"]
        source.touch()
        self.document.recompute()
        self.assertEqual(obj.Notes, ["kept while the mesh is"])


class OtherChecks(InspectionTest):
    def test_clearance_of_the_solids_of_a_container(self):
        assembly = self.document.addObject("App::Part", "Assembly")
        for name, x in (("Left", 0.0), ("Right", 10.5)):
            box = self.box(name, Length=10, Width=10, Height=10)
            box.Placement.Base.x = x
            assembly.addObject(box)
        self.document.recompute()
        obj = mq.add_inspection(assembly, check="clearance", min_clearance=1.0)
        self.assertAlmostEqual(obj.Minimum.Value, 0.5, places=6)
        self.assertEqual(sorted(round(place.x, 4) for place in obj.Places), [10.0, 10.5])
        self.assertTrue(obj.Certificate.startswith("not met: smallest gap 0.5 mm (requested 1 mm)"))
        self.assertEqual((obj.Count, obj.Mesh.CountFacets), (1, 0))
        self.document.getObject("Right").Placement.Base.x = 12.0
        self.document.recompute()
        self.assertAlmostEqual(obj.Minimum.Value, 2.0, places=6)
        self.assertEqual((obj.Certificate, obj.Count), ("met", 0))

    def test_draft_against_each_direction(self):
        source = self.part(Part.makeBox(10, 10, 10))
        obj = mq.add_inspection(source, check="draft", min_draft=2.0)
        self.assertAlmostEqual(obj.LowDraftArea.Value, 400.0, delta=1e-3)  # the four sides
        self.assertEqual(obj.UndercutArea.Value, 0.0)
        self.assertEqual(set(obj.Faces), self.faces_at(source.Shape, lambda c: 1.0 < c.z < 9.0))
        self.assertTrue(obj.Certificate.startswith("not met: less draft than 2° on 4 faces"))
        mq.update(obj, pull_direction="-x")
        self.assertEqual(set(obj.Faces), self.faces_at(source.Shape, lambda c: 1.0 < c.x < 9.0))

    def test_undercuts(self):
        source = self.part(Part.makeBox(10, 10, 10).cut(Part.makeBox(6, 10, 2, FreeCAD.Vector(4, 0, 4))))
        obj = mq.add_inspection(source, check="draft")
        self.assertAlmostEqual(obj.UndercutArea.Value, 2 * 60.0 + 20.0, delta=1.0)  # its end, too
        self.assertIn("undercuts", obj.Certificate)
        mq.update(obj, pull_direction="y")
        self.assertEqual(obj.UndercutArea.Value, 0.0)

    def test_voids(self):
        source = self.part(Part.makeBox(10, 10, 10).cut(Part.makeSphere(2, FreeCAD.Vector(5, 5, 5))))
        obj = mq.add_inspection(source, check="voids")
        self.assertAlmostEqual(obj.VoidVolume.Value, 4 / 3 * 3.14159 * 8, delta=0.3)
        self.assertEqual((obj.Count, obj.Certificate), (1, "not met: 1 closed void."))
        self.assertLess((obj.Places[0] - FreeCAD.Vector(5, 5, 5)).Length, 0.05)
        source.Shape = Part.makeBox(10, 10, 10)
        self.document.recompute()
        self.assertEqual((obj.Count, obj.VoidVolume.Value, list(obj.Places), obj.Certificate), (0, 0.0, [], "met"))

    def test_a_change_of_the_check(self):
        obj = mq.add_inspection(self.part(self.stepped()), min_thickness=2.0)
        self.assertTrue(obj.Certificate.startswith("not met"))
        mq.update(obj, check="voids")
        self.assertEqual((obj.Certificate, obj.Minimum.Value, list(obj.Places)), ("met", 0.0, []))
        self.assertEqual((obj.getEditorMode("Minimum"), obj.getEditorMode("VoidVolume")), (["Hidden"], ["ReadOnly"]))
        mq.update(obj, check="thickness")
        self.assertAlmostEqual(obj.Minimum.Value, 1.0, delta=0.02)


class Kept(InspectionTest):
    def test_every_option_is_a_property(self):
        obj = mq.add_inspection(self.part(self.stepped()))
        for option in options.inspection.INSPECTION_OBJECT:
            self.assertEqual(obj.getTypeIdOfProperty(option.property_name), option.property_type)
            self.assertTrue(obj.getDocumentationOfProperty(option.property_name))

    def test_it_comes_back(self):
        source = self.part(self.stepped())
        name = mq.add_inspection(source, min_thickness=1.5).Name
        held = mq.add_inspection(source, check="voids").Name
        self.reopen()
        obj, other = self.document.getObject(name), self.document.getObject(held)
        self.assertEqual(type(obj.Proxy).__module__, "MeshQuality.features.inspection")
        self.assertEqual((obj.Check, other.Check), ("thickness", "voids"))
        self.assertAlmostEqual(obj.Minimum.Value, 1.0, delta=0.02)
        obj.Notes = ["kept while the mesh is"]
        self.document.getObject("Part").touch()
        self.document.recompute()
        self.assertEqual(obj.Notes, ["kept while the mesh is"])
        self.document.getObject("Part").Shape = self.stepped(thin=2.0)
        self.document.recompute()
        self.assertAlmostEqual(obj.Minimum.Value, 2.0, delta=0.04)

    def test_one_undo_step(self):
        source = self.part(self.stepped())
        name = mq.add_inspection(source).Name
        self.assertEqual(self.document.UndoNames[0], "Inspection")
        self.document.undo()
        self.assertIsNone(self.document.getObject(name))

    def test_refusals_leave_nothing_behind(self):
        sheet = self.part(Part.makePlane(5, 5), "Sheet")
        solid = self.part(self.stepped(), "Solid")
        before = len(self.document.Objects)
        for source, values, message in (
                (sheet, {}, "open surface"), (solid, {"check": "weight"}, "check = 'weight'"),
                (solid, {"check": "clearance"}, "one body|two|second"), (solid, {"pull_direction": "up"}, "pull_direction"),
                (solid, {"thick": 1.0}, "thick")):
            with self.subTest(values=values), self.assertRaisesRegex(mq.InvalidInput, message):
                mq.add_inspection(source, **values)
        with self.assertRaisesRegex(mq.InvalidInput, "document object"):
            mq.add_inspection(Part.makeBox(1, 1, 1))
        self.assertEqual(len(self.document.Objects), before)
