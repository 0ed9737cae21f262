# SPDX-License-Identifier: LGPL-2.1-or-later
"""Containers: what is hidden there is no part of their mesh, which says so; what lies in plain groups is there once."""

import json
import os

import FreeCAD
import numpy as np
import Part
import test_cli
import test_placement

import MeshQuality as mq
from MeshQuality.core.sources import convert
from MeshQuality.core.sources import hidden_parts


class LeftOut(test_placement.PlacementTest):
    def setUp(self):
        super().setUp()
        self.box = self.add("Part::Box", "Box")
        self.ball = self.add("Part::Sphere", "Ball")
        self.ball.Placement.Base = FreeCAD.Vector(50, 0, 0)
        self.container = self.part("Assembly", FreeCAD.Placement(), self.box, self.ball)
        self.document.recompute()

    def assert_left_out(self, labels, source=None, **options):
        """What is named is what the shape lacks."""
        source = source or self.container
        self.assertEqual(hidden_parts.left_out_of(source, **options), labels)
        return source

    def test_nothing_hidden(self):
        self.assert_left_out([])
        self.assertEqual(list(mq.add_quality_mesh(self.container).Notes), [])
        self.assertEqual(hidden_parts.left_out_of(Part.makeBox(1, 1, 1)), [])
        self.assertEqual(hidden_parts.left_out_of(self.box), [])

    def test_the_object_names_it(self):
        self.ball.Visibility = False
        self.assert_left_out(["Ball"])
        for add in (mq.add_quality_mesh, mq.add_curved_mesh):
            obj = add(self.container)
            self.assertAlmostEqual(obj.Mesh.Volume, 1000.0, delta=1e-3)
            self.assertEqual(list(obj.Notes), ["1 hidden object of 'Assembly' is no part of it: Ball."])
            self.assertEqual(obj.Certificate, "met")
        self.ball.Visibility = True
        self.document.recompute()
        mq.update(obj)
        self.assertEqual(list(obj.Notes), [])

    def test_what_something_visible_is_made_of_is_not_missing(self):
        cut = self.add("Part::Cut", "Cut", Base=self.box, Tool=self.ball)
        self.container.addObject(cut)
        self.document.recompute()
        self.box.Visibility = self.ball.Visibility = False
        self.assert_left_out([])

    def test_its_mesh_stands_for_it_in_booleans_only(self):
        mesh = mq.add_quality_mesh(self.ball)
        self.container.addObject(mesh)
        self.ball.Visibility = False  # as the window does
        self.assert_left_out(["Ball"])
        self.assert_left_out([], with_meshes=True)
        mesh.Visibility = False
        self.assert_left_out(["Ball", mesh.Label], with_meshes=True)
        tool = self.add("Part::Box", "Tool")
        self.document.recompute()
        joined = mq.add_boolean(self.container, tool)
        self.assertIn("2 hidden objects of 'Assembly' are no part of it: Ball, Ball quality mesh.", joined.Notes)

    def test_groups_links_and_containers_within(self):
        inner = self.part("Inner", FreeCAD.Placement(), self.add("Part::Cone", "Cone"))
        group = self.add("App::DocumentObjectGroup", "Group")
        group.addObject(self.add("Part::Torus", "Torus"))
        self.container.addObjects([inner, group])
        link = self.add("App::Link", "Link", LinkedObject=self.container)
        self.document.recompute()
        self.assert_left_out([])
        everything = [obj for obj in self.document.Objects if obj.Name in ("Box", "Ball", "Cone", "Torus")]
        for hidden in (inner, group, self.ball):
            hidden.Visibility = False
            self.document.recompute()
            for source in (self.container, link):
                left = hidden_parts.left_out_of(source)
                volume = sum(obj.Shape.Volume for obj in everything if obj.Label not in left)
                self.assertAlmostEqual(convert.shape_of(source).Volume, volume, places=6, msg=f"{hidden.Label}: {left}")
        self.assertIn("Ball", hidden_parts.left_out_of(link))

    def test_sketches_and_the_features_of_a_body_are_no_parts(self):
        body = self.add("PartDesign::Body", "Body")
        feature = body.newObject("PartDesign::AdditiveBox", "Feature")
        sketch = self.add("Sketcher::SketchObject", "Sketch")
        self.container.addObjects([body, sketch])
        self.document.recompute()
        sketch.Visibility = False
        feature.Visibility = False
        self.assert_left_out([])
        body.Visibility = False
        self.assert_left_out(["Body"])


class InPython(test_placement.PlacementTest):
    def test_what_is_hidden_is_noted(self):
        part = self.document.addObject("App::Part", "Whole")
        for name, place in (("Seen", 0), ("Unseen", 20)):
            box = self.document.addObject("Part::Box", name)
            box.Placement.Base.x = place
            part.addObject(box)
        self.document.recompute()
        self.document.Unseen.Visibility = False
        for mesh in (mq.triangulate(part), mq.curve(part), mq.wrap(part, gap=2)):
            self.assertEqual([note for note in mesh.report.notes if "Unseen" in note], hidden_parts.sentences_of(part))

    def test_groups_of_analyses_name_what_is_not_found(self):
        """As those of CfdOF do: a mesh with a group for its refinements."""
        box = self.document.addObject("Part::Box", "Box")
        analysis = self.document.addObject("App::DocumentObjectGroupPython", "CfdAnalysis")
        mesh = self.document.addObject("Fem::FemMeshObjectPython", "CfdMesh")
        mesh.addExtension("App::GroupExtensionPython")
        mesh.addObject(self.document.addObject("App::FeaturePython", "MeshRefinement"))
        analysis.addObject(mesh)
        self.document.recompute()
        self.assertEqual((hidden_parts.left_out_of(analysis), convert.meshes_in(analysis)), ([], []))
        self.assertEqual(len(mq.triangulate(box).triangles), 12)


class OnTheCommandLine(test_placement.PlacementTest):
    def test_what_is_hidden_is_said(self):
        box, ball = self.add("Part::Box", "Box"), self.add("Part::Sphere", "Ball")
        self.part("Assembly", FreeCAD.Placement(), box, ball)
        ball.Visibility = False
        self.document.recompute()
        path = os.path.join(self.folder, "hidden.FCStd")
        self.document.saveAs(path)
        said = "1 hidden object of 'Assembly' is no part of it: Ball"
        for command, options in (("triangulate", ()), ("curve", ()), ("boolean", (path,))):
            with self.subTest(command):
                suffix = "msh" if command == "curve" else "ply"
                status, out, lines = test_cli.run(command, path, *options, "-o", f"{self.folder}/out.{suffix}", "--json")
                self.assertEqual(status, 0, lines)
                self.assertTrue(lines[-1].endswith(f". {said}"), lines)
                self.assertIn(f"{said}.", json.loads(out)["notes"])


class InPlainGroups(test_placement.PlacementTest):
    """FreeCAD lists what lies in a plain group within a part twice."""

    def setUp(self):
        super().setUp()
        self.box = self.add("Part::Box", "Box")
        self.ball = self.add("Part::Sphere", "Ball")
        self.ball.Placement.Base = FreeCAD.Vector(50, 0, 0)
        inner = self.add("App::DocumentObjectGroup", "InnerGroup")
        inner.addObject(self.ball)
        group = self.add("App::DocumentObjectGroup", "Group")
        group.addObjects([self.box, inner])
        self.container = self.part("Assembly", test_placement.TURNED, group)
        self.link = self.add("App::Link", "Link", LinkedObject=self.container)
        self.link.Placement.Base = FreeCAD.Vector(0, 200, 0)
        self.document.recompute()
        self.volume = self.box.Shape.Volume + self.ball.Shape.Volume

    def test_each_part_is_there_once(self):
        for source in (self.container, self.link, (self.link, "Group.")):
            shape = convert.shape_of(source)
            self.assertEqual(len(shape.Solids), 2)
            self.assertAlmostEqual(shape.Volume, self.volume, places=6)
            listed = Part.getShape(*source) if isinstance(source, tuple) else Part.getShape(source)
            self.assert_same_box(test_placement.box_of(shape), test_placement.box_of(listed), 1e-9)
        obj = mq.add_quality_mesh(self.container, chord_height=0.005)
        self.assertAlmostEqual(obj.Mesh.Volume, self.volume, delta=1e-3 * self.volume)
        self.assertEqual(obj.Mesh.countComponents(), 2)
        tool = self.add("Part::Box", "Tool", FreeCAD.Placement(FreeCAD.Vector(500, 0, 0), FreeCAD.Rotation()))
        self.document.recompute()
        joined = mq.add_boolean(self.container, tool, tolerance=0.01)
        self.assertAlmostEqual(joined.Volume.Value, self.volume + 1000, delta=1e-3 * self.volume)

    def test_a_shape_of_a_script_says_what_it_lists_again(self):
        listed = Part.getShape(self.container)
        notes = [note for note in mq.triangulate(listed).report.notes if "again" in note]
        self.assertEqual(len(notes), len(listed.Solids) - 2)
        self.assertGreater(len(notes), 0)
        for note in notes:
            self.assertRegex(note, r"^Solid\d: is Solid\d again, at the same place$")
        self.assertEqual(mq.triangulate(self.container).report.notes, [])

    def test_local_sizes_are_where_they_were(self):
        mesh = mq.triangulate(self.container, local_sizes={"Group.InnerGroup.Ball.Face1": 0.5})
        far = mesh.vertices[np.unique(mesh.triangles)] - np.array(self.container.Placement.multVec(FreeCAD.Vector(50, 0, 0)))
        on_ball = np.linalg.norm(far, axis=1) < 6.0
        self.assertGreater(on_ball.sum(), 1000)
        self.assertLess((~on_ball).sum(), 100)

    def test_what_is_there_twice_in_two_places_stays(self):
        other = self.add("App::Link", "Copy", LinkedObject=self.box)
        other.Placement.Base = FreeCAD.Vector(0, 0, 30)
        self.container.addObject(other)
        self.document.recompute()
        self.assertEqual(len(convert.shape_of(self.container).Solids), 3)

    def test_without_groups_the_shape_is_that_of_freecad(self):
        plain = self.part("Plain", test_placement.TURNED, self.add("Part::Box", "Another"))
        self.document.recompute()
        self.assertTrue(convert.own_shape_of(plain).isPartner(Part.getShape(plain))
                        or convert.shape_text(convert.own_shape_of(plain)) == convert.shape_text(Part.getShape(plain)))
