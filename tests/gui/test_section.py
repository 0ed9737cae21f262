# SPDX-License-Identifier: LGPL-2.1-or-later
"""Analyse Quality: the plane that cuts the mesh open."""

import importlib.util
import unittest

import FreeCAD
import FreeCADGui
import given_meshes
import gui_helpers
import numpy as np
import Part
from PySide import QtCore, QtGui

import MeshQuality as mq
from MeshQuality.gui import quality_data
from MeshQuality.gui.panels import quality_panel

HAS_FEM = importlib.util.find_spec("Fem") is not None


def cap(panel):
    """float64 (T, 3, 3): the triangles of the cut that are drawn."""
    return points_of(panel.scene.scene._cap)


def drawn(panel):
    """float64 (T, 3, 3): the triangles of the mesh that are drawn, before the cut."""
    return points_of(panel.scene.scene._fine)


def points_of(nodes):
    return np.array([tuple(point) for point in nodes._points.vertex.getValues()], dtype=float).reshape(-1, 3, 3)


def area_of(corners):
    return 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum()


class Section(gui_helpers.PanelTest):
    def open(self, obj):
        panel = quality_panel.open_panel(obj)
        self.addCleanup(lambda: panel.ended or panel.reject())
        self.until(lambda: panel.values is not None)
        return panel

    def tube(self):
        source = self.document.addObject("Part::Feature", "Tube")
        source.Shape = Part.makeCylinder(10, 30).cut(Part.makeCylinder(4, 30))
        self.document.recompute()
        return source

    def choose(self, panel, text):
        panel.section.direction.setCurrentIndex(panel.section.direction.findText(text))

    def test_a_surface_is_filled_where_it_is_cut(self):
        obj = mq.add_quality_mesh(self.tube(), chord_height=0.02)
        self.view.viewFront()  # the camera looks along y
        panel = self.open(obj)
        self.assertFalse(panel.section.slider.isVisible())
        self.assertIsNone(panel.section.plane)
        panel.section.on.setChecked(True)
        self.assertEqual((panel.section.direction.currentText(), panel.section.plane.normal.tolist()), ("Y", [0.0, -1.0, 0.0]))
        self.assertAlmostEqual(area_of(cap(panel)), 12 * 30, delta=1.0)
        self.choose(panel, "Z")
        self.assertAlmostEqual(panel.section.offset.value(), 15.0)
        self.assertAlmostEqual(area_of(cap(panel)), np.pi * 84, delta=1.0)
        panel.section.slider.setValue(200)
        self.until(lambda: abs(cap(panel)[..., 2].mean() - 6.0) < 1e-3)
        self.assertAlmostEqual(panel.section.offset.value(), 6.0)
        gui_helpers.typed(panel.section.offset.lineEdit(), "12.5 mm")
        self.assertAlmostEqual(cap(panel)[..., 2].mean(), 12.5, places=4)
        self.assertEqual(panel.section.slider.value(), round(1000 * 12.5 / 30))
        before = panel.section.plane.normal
        panel.section.flip.click()
        np.testing.assert_array_equal(panel.section.plane.normal, -before)
        if panel.section.plane.normal[2] < 0:
            panel.section.flip.click()
        shown = self.picture("section_surface")
        panel.section.on.setChecked(False)
        self.assertEqual(len(cap(panel)), 0)
        self.assertGreater(np.abs(self.picture("section_none") - shown).mean(), 1.0)

    def test_whole_triangles(self):
        panel = self.open(mq.add_quality_mesh(self.tube(), chord_height=0.02))
        panel.section.on.setChecked(True)
        self.choose(panel, "Z")
        panel.section.whole.setChecked(True)
        if panel.section.plane.normal[2] < 0:
            panel.section.flip.click()
        kept = panel.data.corners.mean(axis=1)[:, 2] <= 15.0
        np.testing.assert_array_equal(drawn(panel), panel.data.corners[kept])
        self.assertEqual(len(cap(panel)), 0)
        self.picture("section_whole_triangles")
        panel.measures.setCurrentIndex(1)
        self.until(lambda: panel.measure is panel.data.measures[1])
        self.assertEqual(len(drawn(panel)), kept.sum())
        panel.section.on.setChecked(False)
        self.assertEqual(len(drawn(panel)), len(panel.data.corners))

    def test_a_place_is_picked(self):
        panel = self.open(mq.add_quality_mesh(self.tube(), chord_height=0.02))
        self.view.viewTop()
        self.view.fitAll()
        gui_helpers.wait()
        panel.section.on.setChecked(True)
        self.assertEqual(panel.section.direction.currentText(), "Z")
        self.assertGreater(len(cap(panel)), 0)
        panel.section.pick.setChecked(True)
        self.assertEqual(len(cap(panel)), 0)  # the whole mesh is seen meanwhile
        self.click(*self.pixel_of((7.0, 0.0, 30.0)))
        self.assertFalse(panel.section.pick.isChecked())
        self.assertEqual(panel.section.direction.currentText(), "Picked")
        np.testing.assert_allclose(panel.section.plane.normal, (0, 0, 1), atol=1e-6)
        self.assertAlmostEqual(panel.section.plane.point[2], 30.0, places=4)
        np.testing.assert_allclose(panel.section.plane.point[:2], (7.0, 0.0), atol=0.3)
        gui_helpers.typed(panel.section.offset.lineEdit(), "-10 mm")
        self.assertAlmostEqual(cap(panel)[..., 2].mean(), 20.0, places=3)
        panel.section.pick.setChecked(True)
        panel.reject()
        self.click(*self.pixel_of((7.0, 0.0, 30.0)))  # nothing listens any more

    def test_the_document_is_closed_while_a_place_is_picked(self):
        other = FreeCAD.newDocument("Other")
        gui_helpers.wait()
        source = other.addObject("Part::Feature", "Box")
        source.Shape = Part.makeBox(1, 2, 3)
        other.recompute()
        panel = self.open(mq.add_quality_mesh(source))
        panel.section.on.setChecked(True)
        panel.section.pick.setChecked(True)
        FreeCAD.closeDocument(other.Name)
        gui_helpers.wait(0.3)
        self.assertTrue(panel.ended)
        self.assertFalse(FreeCADGui.Control.activeDialog())
        FreeCAD.setActiveDocument(self.document.Name)

    def pixel_of(self, point):
        """Pixels of the window from the upper left corner of the 3D view."""
        (x, y), (width, height) = self.view.getPointOnScreen(*point), self.view.getSize()
        size = self.view.graphicsView().viewport().size()
        return x * size.width() / width, (height - 1 - y) * size.height() / height

    def click(self, x, y):
        viewport = self.view.graphicsView().viewport()
        for kind, buttons in ((QtCore.QEvent.MouseButtonPress, QtCore.Qt.LeftButton), (QtCore.QEvent.MouseButtonRelease, QtCore.Qt.NoButton)):
            place = QtCore.QPointF(x, y)
            QtGui.QApplication.sendEvent(viewport, QtGui.QMouseEvent(kind, place, place, viewport.mapToGlobal(place.toPoint()),
                                                                     QtCore.Qt.LeftButton, buttons, QtCore.Qt.NoModifier))
        gui_helpers.wait()

    @unittest.skipUnless(HAS_FEM, "this FreeCAD has no FEM workbench")
    def test_volumes(self):
        given = self.document.addObject("Fem::FemMeshObject", "Given")
        given.FemMesh = given_meshes.straight_mesh(Part.makeBox(20, 10, 10), 2.0)
        self.document.recompute()
        panel, found = self.open(given), mq.section(given, (7, 0, 0), "x")
        panel.section.on.setChecked(True)
        self.choose(panel, "X")
        gui_helpers.typed(panel.section.offset.lineEdit(), "7 mm")
        if panel.section.plane.normal[0] < 0:
            panel.section.flip.click()
        self.assertAlmostEqual(area_of(cap(panel)), 100.0, places=3)
        self.assertAlmostEqual(found.area, 100.0, places=6)
        panel.measures.setCurrentIndex(panel.data.measures.index(quality_data.DISTORTION))
        self.until(lambda: panel.measure is quality_data.DISTORTION)
        self.picture("section_volumes")
        inside = int(np.flatnonzero([panel.data.is_inside(i) for i in panel._worst])[0])
        panel.worst.setCurrentRow(inside)
        centre = panel.section.data.centre(panel._worst[inside])
        self.assertAlmostEqual(panel.section.offset.value(), centre[0], places=9)
        panel.section.whole.setChecked(True)
        plane = panel.section.plane
        behind = mq.section(given, plane.point, plane.normal).behind
        seen = np.unique(panel.section.data.whole(plane).element)
        self.assertTrue(np.isin(seen, behind).all())
        boundary = mq.section(given, plane.point, plane.normal).half().boundary()
        self.assertEqual(len(drawn(panel)), 4 * sum(len(faces) for faces in boundary))  # of order 2
        self.picture("section_whole_volumes")
        self.narrow(panel, "panel_section")

    def test_curved_volumes(self):
        source = self.document.addObject("Part::Feature", "Ball")
        source.Shape = Part.makeSphere(10)
        self.document.recompute()
        obj = mq.add_curved_mesh(source, order=3, volume=True, max_edge=5.0)
        panel = self.open(obj)
        self.assertIsNotNone(panel.data.solid)
        panel.section.on.setChecked(True)
        self.choose(panel, "Z")
        self.assertLess(abs(area_of(cap(panel)) - mq.section(obj, (0, 0, 0), "z").area), 1.0)
        self.assertEqual(len(panel.section.data._centres), len(mq.measures(obj)))
        self.picture("section_curved")
        panel.section.whole.setChecked(True)
        self.picture("section_whole_curved")
        self.assertGreater(len(drawn(panel)), 0)
