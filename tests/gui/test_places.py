# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a promise is missed: the face of the source that is selected, the mark, the camera's flight."""

import FreeCAD
import FreeCADGui
import gui_helpers
import numpy as np
import Part

import MeshQuality as mq
from MeshQuality import convert
from MeshQuality.gui import commands, places

COARSE = {"method": "star", "polish": False, "chord_height": 0.01}  # misses its distance


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
            found = [places.sub_element(source, f"Face{i + 1}") for i in range(len(whole.Faces))]
            self.assertEqual(len(set(found)), len(whole.Faces), found)
            for face, path in zip(whole.Faces, found):
                there = Part.getShape(source, path, needSubElement=True)
                self.assertLess((there.CenterOfMass - face.CenterOfMass).Length, 1e-6, path)
                self.assertAlmostEqual(there.Area, face.Area)
        self.assertEqual(places.sub_element(outer, "Face7"), "Inner.Cylinder.Face1")
        self.assertEqual(places.sub_element(self.document.getObject("Box"), "Face3"), "Face3")

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
