# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a promise is missed: the face of the source that is selected, the mark, the camera's flight."""

import FreeCAD
import FreeCADGui
import gui_helpers
import numpy as np
import Part

import MeshQuality as mq
from MeshQuality.core.sources import convert
from MeshQuality.gui import commands, sub_elements
from MeshQuality.gui.panels import mesh_panel
from MeshQuality.gui.quality_data import QualityData

COARSE = {"method": "star", "refine_samples": False, "chord_height": 0.01}  # misses its distance


class Places(gui_helpers.PanelTest):
    def container(self):
        """A part in a part, moved and turned, beside a box."""
        box = self.box()
        cylinder = self.document.addObject("Part::Cylinder", "Cylinder")
        cylinder.Placement.Base = FreeCAD.Vector(30, 0, 0)
        inner, outer = (self.document.addObject("App::Part", name) for name in ("Inner", "Outer"))
        inner.addObjects([box, cylinder])
        inner.Placement = FreeCAD.Placement(FreeCAD.Vector(1, 2, 3),
                                            FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 30))
        outer.addObjects([inner, self.document.addObject("Part::Box", "Second")])
        self.document.recompute()
        return outer

    def test_sub_elements_of_containers_and_links(self):
        outer = self.container()
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = outer
        link.Placement.Base = FreeCAD.Vector(0, 0, 100)
        array = self.document.addObject("App::Link", "Array")
        array.LinkedObject, array.ElementCount = self.document.getObject("Cylinder"), 2
        self.document.recompute()
        array.getSubObject("1.", retType=1).Placement.Base = FreeCAD.Vector(60, 0, 0)
        self.document.recompute()
        for source in (outer, link, array):
            whole = convert.shape_of(source)
            found = [sub_elements.sub_element(source, f"Face{i + 1}") for i in range(len(whole.Faces))]
            self.assertEqual(len(set(found)), len(whole.Faces), found)
            for face, path in zip(whole.Faces, found):
                there = Part.getShape(source, path, needSubElement=True)
                self.assertLess((there.CenterOfMass - face.CenterOfMass).Length, 1e-6, path)
                self.assertAlmostEqual(there.Area, face.Area)
        self.assertEqual(sub_elements.sub_element(outer, "Face7"), "Inner.Cylinder.Face1")
        self.assertEqual(sub_elements.sub_element(self.document.getObject("Box"), "Face3"), "Face3")

    def test_the_face_in_a_container_is_selected(self):
        outer = self.container()
        panel = commands.panel_of(mq.add_quality_mesh(outer, **COARSE))
        FreeCADGui.Control.showDialog(panel)
        # Of all distances the cylinder's is missed most; its faces come after the box's.
        self.assertIn("on Face7", panel.certificate.text.text())
        panel.certificate.button.click()
        chosen, = FreeCADGui.Selection.getSelectionEx("", 0)
        self.assertEqual((chosen.Object, list(chosen.SubElementNames)),
                         (outer, ["Inner.Cylinder.Face1"]))
        panel.reject()

    def test_the_camera_flies_to_the_missed_distance(self):
        source = self.document.addObject("Part::Cylinder", "Cylinder")
        self.document.recompute()
        obj = mq.add_quality_mesh(source, **COARSE)
        self.view.viewAxonometric()
        self.view.fitAll()
        panel = commands.panel_of(obj)
        FreeCADGui.Control.showDialog(panel)
        graph = self.view.getSceneGraph()
        children = graph.getNumChildren()
        panel.certificate.button.click()
        self.until(lambda: not panel.certificate.flight.active)
        self.assertEqual(graph.getNumChildren(), children + 1)
        centre = np.array([tuple(corner) for corner in obj.CertificatePlace]).mean(axis=0)
        ahead = np.array(self.view.getViewDirection())
        camera = np.array(self.view.getCameraNode().position.getValue().getValue())
        off = (centre - camera) - ((centre - camera) @ ahead) * ahead
        self.assertLess(np.linalg.norm(off), 0.1)
        pixels = self.saved("missed_place")
        self.assertGreater((np.abs(pixels - np.array((255, 32, 255))) < 60).all(axis=2).mean(), 1e-4)
        panel.reject()
        self.assertEqual(graph.getNumChildren(), children)

    def test_a_mesh_without_faces_has_a_place_too(self):
        source = self.document.addObject("Mesh::Feature", "Imported")
        corners = [FreeCAD.Vector(*p) for p in ((0, 0, 0), (10, 0, 0), (10, 0.8, 0), (0, 0, 0))]
        wedge = Part.Face(Part.makePolygon(corners)).extrude(FreeCAD.Vector(0, 0, 3))
        source.Mesh = mq.triangulate(wedge).to_mesh()
        obj = mq.add_improved_mesh(source)
        self.assertTrue(obj.Certificate.startswith("not met"))
        panel = commands.panel_of(obj)
        FreeCADGui.Control.showDialog(panel)
        panel.certificate.button.click()
        self.until(lambda: not panel.certificate.flight.active)
        self.assertEqual(FreeCADGui.Selection.getSelection(), [])
        panel.reject()


class InContainers(gui_helpers.PanelTest):
    """What is picked in the 3D view inside of containers is meshed, joined and shown where it stands."""

    def assembly(self):
        """Two parts with a box each; the boxes overlap in a cube of 5 mm at (105, 5, 5)."""
        for name, base in (("One", (100, 0, 0)), ("Two", (105, 5, 5))):
            part = self.document.addObject("App::Part", name)
            part.addObject(self.document.addObject("Part::Box", "BoxIn" + name))
            part.Placement.Base = FreeCAD.Vector(*base)
        self.document.recompute()

    def picked(self, command, *paths):
        """The panel of a command for what was picked in the 3D view, given as paths "Part.Box.Face1"."""
        FreeCADGui.Selection.clearSelection()
        for path in paths:
            root, below = path.split(".", 1)
            FreeCADGui.Selection.addSelection(self.document.Name, root, below)
        self.assertTrue(command().IsActive())
        panel = mesh_panel.MeshPanel(command().operations(command().selected()))
        FreeCADGui.Control.showDialog(panel)
        gui_helpers.wait()
        return panel

    def world_box(self, obj):
        mesh = obj.Mesh.copy()
        mesh.Placement = obj.getGlobalPlacement()
        box = mesh.BoundBox
        return [round(v, 3) for v in (box.XMin, box.YMin, box.ZMin, box.XMax, box.YMax, box.ZMax)]

    def test_a_picked_face_of_a_nested_box(self):
        self.assembly()
        for command in (commands.Triangulate, commands.Curve):
            panel = self.picked(command, "One.BoxInOne.Face6")
            self.finish(panel)
            obj = panel.operations[0].obj
            self.assertEqual(obj.Source, self.document.getObject("BoxInOne"))
            self.assertEqual(self.world_box(obj), [100, 0, 0, 110, 10, 10])

    def test_nested_operands(self):
        self.assembly()
        panel = self.picked(commands.Boolean, "One.BoxInOne.Face6", "Two.BoxInTwo.Face1")
        panel.options.set_values({"operation": "intersection"})
        self.finish(panel)
        obj = panel.operations[0].obj
        self.assertAlmostEqual(obj.Volume.Value, 125.0, delta=1e-3)
        self.assertEqual(self.world_box(obj), [105, 5, 5, 110, 10, 10])

    def test_what_only_a_link_leads_to(self):
        self.assembly()
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = self.document.getObject("One")
        link.Placement.Base = FreeCAD.Vector(0, 0, 50)
        self.document.recompute()
        panel = self.picked(commands.Triangulate, "Link.BoxInOne.Face6")
        self.finish(panel)
        obj = panel.operations[0].obj
        self.assertEqual((obj.Source, obj.SourcePath), (link, "BoxInOne."))
        self.assertEqual(self.world_box(obj), [0, 0, 50, 10, 10, 60])
        again = commands.panel_of(obj)
        FreeCADGui.Control.showDialog(again)
        again.options.set_values({"max_edge": 3.0})
        self.apply(again)
        self.assertEqual(again.said, "")
        self.assertGreater(obj.Triangles, 100)
        self.assertEqual(self.world_box(obj), [0, 0, 50, 10, 10, 60])
        again.reject()

    def test_the_quality_of_a_nested_mesh_is_drawn_where_it_stands(self):
        self.assembly()
        part, source = self.document.getObject("One"), self.document.getObject("BoxInOne")
        for add in (mq.add_quality_mesh, mq.add_curved_mesh):
            obj = add(source)
            part.addObject(obj)
            self.document.recompute()
            data = QualityData(obj)
            data.prepare()
            points = data.corners.reshape(-1, 3)
            np.testing.assert_allclose(points.min(axis=0), (100, 0, 0), atol=1e-4)
            np.testing.assert_allclose(points.max(axis=0), (110, 10, 10), atol=1e-4)
            np.testing.assert_allclose(data.lines[0].max(axis=0), (110, 10, 10), atol=1e-4)
            if add is mq.add_quality_mesh:
                self.assertLess(data.distances().max(), 1e-4)

    def test_the_missed_place_of_a_moved_mesh(self):
        source = self.document.addObject("Part::Cylinder", "Cylinder")
        part = self.document.addObject("App::Part", "Part")
        part.addObject(source)
        self.document.recompute()
        obj = mq.add_quality_mesh(source, **COARSE)
        part.Placement.Base = FreeCAD.Vector(500, 0, 0)
        self.document.recompute()
        panel = commands.panel_of(obj)
        FreeCADGui.Control.showDialog(panel)
        panel.certificate.button.click()
        self.until(lambda: not panel.certificate.flight.active)
        camera = np.array(self.view.getCameraNode().position.getValue().getValue())
        self.assertGreater(camera[0], 400)
        chosen, = FreeCADGui.Selection.getSelectionEx("", 0)
        self.assertEqual((chosen.Object, chosen.SubElementNames[0].split(".")[0]), (part, "Cylinder"))
        panel.reject()
