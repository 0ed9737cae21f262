# SPDX-License-Identifier: LGPL-2.1-or-later
"""Deviation: from scan and part over the panel to the coloured view with its legend and worst places, also in German."""

import FreeCAD
import FreeCADGui
import gui_helpers
import numpy as np
import Part

import MeshQuality as mq
from MeshQuality.gui import commands, quality_data
from MeshQuality.gui.panels import quality_panel


class Deviation(gui_helpers.PanelTest):
    def setUp(self):
        super().setUp()
        self.part = self.document.addObject("Part::Box", "Box")
        self.part.Length, self.part.Width, self.part.Height = 30, 20, 10
        scan = mq.triangulate(Part.makeBox(30, 20, 10), max_edge=1.5)
        vertices = np.array(scan.vertices)
        # A bump on the top, and a dent on a side.
        vertices[:, 2] += 0.4 * np.exp(-((vertices[:, 0] - 20) ** 2 + (vertices[:, 1] - 10) ** 2) / 9) * (vertices[:, 2] > 9.9)
        vertices[:, 1] += 0.3 * np.exp(-((vertices[:, 0] - 8) ** 2 + (vertices[:, 2] - 5) ** 2) / 4) * (vertices[:, 1] < 0.1)
        self.scan = self.document.addObject("Mesh::Feature", "Scan")
        self.scan.Mesh = mq.SurfaceMesh(mq.quality.__globals__["extension"]().surface_from_arrays(vertices, scan.triangles)).to_mesh()
        self.document.recompute()

    def test_the_command_takes_a_scan_and_a_part_in_any_order(self):
        for chosen in ((self.part, self.scan), (self.scan, self.part)):
            self.select(*chosen)
            self.assertTrue(commands.Deviation().IsActive())
            self.assertEqual(commands.Deviation().selected(), [self.scan, self.part])
        self.select(self.part)
        self.assertFalse(commands.Deviation().IsActive())
        self.assertNotIn("MeshQuality_Deviation", commands.fitting())

    def test_the_panel_leads_to_the_coloured_view(self):
        self.select(self.scan, self.part)
        command = commands.Deviation()
        panel = command.panel(command.operations(command.selected()))
        FreeCADGui.Control.showDialog(panel)
        panel.options.set_values({"tolerance": 0.2})
        self.narrow(panel, "panel_deviation")
        panel.accept()
        self.until(lambda: quality_panel.shown() is not None and quality_panel.shown().values is not None)
        obj, view = self.document.Objects[-1], quality_panel.shown()
        self.addCleanup(lambda: view.ended or view.reject())
        self.assertEqual(self.document.UndoNames[0], commands.Deviation.TEXT)
        self.assertTrue(obj.Certificate.startswith("not met: max. deviation 0."), obj.Certificate)
        self.assertIs(view.measure, quality_data.DEVIATION)
        # The scale ends at the tolerance on both sides; the worst place is the bump, outside.
        self.assertEqual((view.scale.low, view.scale.high), (-0.2, 0.2))
        worst = float(view.values[view._worst[0]])
        self.assertAlmostEqual(worst, obj.MaxDeviation.Value, places=6)
        self.assertGreater(worst, 0.3)
        self.assertIn("mm", view.worst.item(0).text())
        self.assertLess(min(row.worst for row in view._faces), -0.2)
        self.assertEqual(view._faces[0].worst, worst)
        view.edges.setChecked(False)
        image = self.picture("deviation")
        red = (image[..., 0] > 150) & (image[..., 1] < 90) & (image[..., 2] < 90)
        self.assertGreater(np.count_nonzero(red), 200)

    def test_its_mesh_has_the_colours_and_follows_the_tolerance(self):
        obj = mq.add_deviation(self.scan, self.part, tolerance=0.2)
        self.assertEqual((obj.ViewObject.DisplayMode, len(obj.FaceColors)), ("Shaded", obj.Mesh.CountFacets))
        red = sum(colour[0] > 0.8 and colour[1] < 0.2 for colour in obj.FaceColors)
        mq.update(obj, tolerance=1.0)
        self.assertLess(sum(colour[0] > 0.8 and colour[1] < 0.2 for colour in obj.FaceColors), red)
        panel = self.edit(obj)
        self.assertEqual(panel.options.values()["tolerance"], 1.0)
        panel.reject()

    def test_points_are_seen(self):
        import Points

        cloud = self.document.addObject("Points::Feature", "Cloud")
        random = np.random.default_rng(1)
        places = random.uniform((0, 0, 10), (30, 20, 10.3), (4000, 3))
        cloud.Points = Points.Points([FreeCAD.Vector(*place) for place in places.tolist()])
        obj = mq.add_deviation(cloud, self.part, tolerance=0.15)
        self.assertEqual(obj.Mesh.CountFacets, 4000)
        image = self.picture("deviation_points")
        strong = image[(image.max(axis=2) - image.min(axis=2)) > 60]
        self.assertGreater(len(strong), 1000)
