# SPDX-License-Identifier: LGPL-2.1-or-later
"""Repair mesh: what is wrong with a mesh, where, and the mesh without it; what other panels say of faults."""

import os

import gui_helpers
import Mesh
import numpy as np

import MeshQuality as mq
from MeshQuality.gui import commands, quality_data
from MeshQuality.gui.panels import quality_panel, repair_panel


class Repair(gui_helpers.PanelTest):
    def dirty(self, hole=3):
        """Two spheres in one mesh that cross; one of them has two flipped triangles, and `hole` triangles are missing."""
        corners = np.array([[tuple(point) for point in facet.Points] for facet in Mesh.createSphere(10, 20).Facets])
        second = corners + (8.1, 0.3, 0.2)
        second[30:32] = second[30:32, ::-1]
        obj = self.document.addObject("Mesh::Feature", "Scan")
        obj.Mesh = Mesh.Mesh(np.concatenate((corners, second[hole:])).reshape(-1, 3).tolist())
        self.view.viewAxonometric()
        self.view.fitAll()
        return obj

    def opened(self, obj):
        self.select(obj)
        command = commands.Repair()
        self.assertTrue(command.IsActive())
        panel = command.panel(command.operations(command.selected()))
        gui_helpers.FreeCADGui.Control.showDialog(panel)
        self.until(lambda: panel.faults.found is not None)
        return panel

    def rows(self, panel):
        return [panel.faults.list.item(row).text() for row in range(panel.faults.list.count())]

    def test_faults_are_listed_shown_and_repaired(self):
        obj = self.dirty()
        panel = self.opened(obj)
        self.assertIsInstance(panel, repair_panel.RepairPanel)
        rows = self.rows(panel)
        self.assertRegex(rows[0], r"^\d+ open edges$")
        self.assertTrue(any("opposite orientation" in row for row in rows))
        self.assertTrue(any("triangles that cross" in row for row in rows))
        width = self.view.getCameraNode().height.getValue()
        panel.faults.list.setCurrentRow(0)
        self.until(lambda: not panel.scene.flight.active)
        self.assertLess(self.view.getCameraNode().height.getValue(), width)
        first = np.array(self.view.getCameraNode().position.getValue().getValue())
        for _ in range(3):  # three edges of the hole are near each other
            panel.faults.next.click()
            self.until(lambda: not panel.scene.flight.active)
        self.assertGreater(np.linalg.norm(self.view.getCameraNode().position.getValue().getValue() - first), 1e-3)
        image = self.saved("repair_faults")
        self.assertGreater(np.count_nonzero((np.abs(image - (255, 32, 255)) < 40).all(axis=2)), 200)
        gui_helpers.screen().save(os.path.join(gui_helpers.PICTURES, "repair_panel.png"))
        self.finish(panel)
        self.assertIsNone(panel.scene)
        made = self.document.Objects[-1]
        self.assertEqual((made.Source, made.Certificate), (obj, "met"))
        self.assertTrue(made.Mesh.isSolid())
        self.assertFalse(made.Mesh.hasSelfIntersections())
        self.assertEqual(self.document.UndoNames[0], commands.Repair.TEXT)
        self.assertIn("hole closed", " ".join(made.Repaired))
        self.document.undo()
        self.assertEqual(self.document.Objects, [obj])

    def test_a_sound_mesh_says_so_and_cancel_changes_nothing(self):
        obj = self.document.addObject("Mesh::Feature", "Ball")
        obj.Mesh = Mesh.createSphere(10, 20)
        panel = self.opened(obj)
        self.assertEqual(panel.faults.text.text(), "The mesh has no faults.")
        self.assertFalse(panel.faults.list.isVisible())
        panel.reject()
        self.assertEqual(self.document.Objects, [obj])

    def test_a_double_click_lists_the_faults_of_the_source(self):
        made = mq.add_repaired_mesh(self.dirty())
        self.assertTrue(made.ViewObject.Proxy.doubleClicked(made.ViewObject))
        gui_helpers.wait()
        self.assertIsInstance(commands.panel_of(made), repair_panel.RepairPanel)

    def test_it_is_for_one_mesh_of_flat_triangles(self):
        box = self.box()
        scan, curved = self.dirty(), mq.add_curved_mesh(box)
        for chosen, active in (((box,), False), ((curved,), False), ((scan,), True), ((scan, curved), False)):
            self.select(*chosen)
            self.assertEqual(commands.Repair().IsActive(), active)

    def quality(self, obj, measure=None):
        panel = quality_panel.open_panel(obj, measure)
        self.addCleanup(lambda: panel.ended or panel.reject())
        self.until(lambda: panel.values is not None or panel._job.error is not None)
        gui_helpers.wait(0.2)
        return panel

    def test_analyse_quality_names_faults_and_shows_them(self):
        obj = self.dirty()
        panel = self.quality(obj)
        self.until(lambda: panel.faults.found is not None)
        self.assertRegex(panel.warning.text(), r"^The mesh has \d+ open edges, .* that cross.*; the command Repair mesh")
        self.assertTrue(panel.warning.isVisible())
        panel.tabs.setCurrentWidget(panel.faults)
        panel.faults.list.setCurrentRow(0)
        self.until(lambda: not panel.scene.flight.active)
        self.assertEqual(np.flatnonzero(panel.lit).tolist(), np.unique(panel.faults.found[0].triangles[:, 0]).tolist())

    def test_wall_thickness_names_faults_and_leaves_the_mesh_in_sight(self):
        obj = self.dirty(hole=0)
        panel = self.quality(obj, quality_data.THICKNESS)
        self.assertRegex(panel.summary.text(), r"^Walls cannot be measured where the mesh has \d+ edges between .* that cross")
        self.assertIn("Repair mesh", panel.summary.text())
        self.assertTrue(obj.ViewObject.Visibility)
        self.assertFalse(panel.histogram.isVisible() or panel.hint.isVisible() or panel.worst.isVisible())
