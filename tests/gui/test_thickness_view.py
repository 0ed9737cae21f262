# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command Wall thickness: colours, the thinnest places, the flight there, and what it refuses."""

import FreeCAD
import FreeCADGui
import gui_helpers
import Mesh
import numpy as np
import Part

import MeshQuality as mq
from MeshQuality.core import colour_scale
from MeshQuality.gui import commands, quality_data
from MeshQuality.gui.panels import quality_panel
from MeshQuality.gui.view import legend


class ThicknessView(gui_helpers.PanelTest):
    def opened(self, obj):
        """The panel that the command opens, once it has measured."""
        self.select(obj)
        self.assertTrue(commands.Thickness().IsActive())
        commands.Thickness().Activated()
        panel = quality_panel.shown()
        self.addCleanup(lambda: panel.ended or panel.reject())
        self.until(lambda: panel.values is not None or panel._job.error is not None)
        return panel

    def stepped(self):
        """A quality mesh of a plate that is 3 mm thick, and 1 mm at one end."""
        source = self.document.addObject("Part::Feature", "Step")
        source.Shape = Part.makeBox(30, 10, 3).cut(Part.makeBox(10, 10, 2, FreeCAD.Vector(20, 0, 1)))
        self.document.recompute()
        return mq.add_quality_mesh(source, max_edge=2.0)

    def test_thin_walls_are_red_listed_first_and_flown_to(self):
        mesh = self.stepped()
        panel = self.opened(mesh)
        self.assertIs(panel.measure, quality_data.THICKNESS)
        self.assertEqual(panel.data.measures[panel.measures.currentIndex()], quality_data.THICKNESS)
        values = panel.values
        centres = panel.data.corners.mean(axis=1)
        inner = (centres[:, 1] > 2) & (centres[:, 1] < 8)  # balls near a rim touch that
        thin = inner & (centres[:, 0] > 22) & (centres[:, 0] < 28)
        np.testing.assert_allclose(values[thin & np.isin(centres[:, 2].round(4), (0.0, 1.0))], 1.0, atol=0.02)
        thick = inner & (centres[:, 0] > 4) & (centres[:, 0] < 16)
        np.testing.assert_allclose(values[thick & np.isin(centres[:, 2].round(4), (0.0, 3.0))], 3.0, atol=0.06)
        worst = panel._worst[0]
        self.assertGreater(centres[worst, 0], 19.0)
        self.assertIn("1 mm: element", panel.worst.item(0).text())
        colours = panel._found[panel.measure.title].colours
        self.assertGreater(int(colours[worst, 0]), int(colours[worst, 2]))  # more red than blue
        panel.worst.setCurrentRow(0)
        self.until(lambda: not panel.scene.flight.active)
        self.assertEqual(np.flatnonzero(panel.lit).tolist(), [worst])
        panel.worst.setCurrentRow(-1)
        image = self.picture("thickness")
        red = (image[:, :, 0] - image[:, :, 2]) > 60
        self.assertGreater(np.count_nonzero(red), 1000)
        panel.form.grab().save(f"{gui_helpers.PICTURES}/panel_thickness.png")

    def test_what_has_no_wall_is_grey_with_a_swatch_of_its_own(self):
        mesh = self.stepped()
        panel = self.opened(mesh)
        values = np.where(np.isfinite(panel.values), panel.values, 1.0)
        before = legend.picture(panel.data.scale(quality_data.THICKNESS, values), 600)
        values[:5] = np.inf
        with_some = panel.data.scale(quality_data.THICKNESS, values)
        colours = colour_scale.bytes_of(with_some.goodness(values))
        self.assertEqual({tuple(colour) for colour in colours[:5].tolist()}, {(158, 158, 158, 255)})
        self.assertEqual(np.count_nonzero((colours[5:, :3] == 158).all(axis=1)), 0)
        picture = legend.picture(with_some, 600)
        self.assertGreater(len(picture), len(before))
        self.assertLess(np.count_nonzero((before[:, :, :3] == 158).all(axis=2)), 20)  # of letters
        self.assertGreater(np.count_nonzero((picture[:, :, :3] == 158).all(axis=2)), 100)
        histogram = quality_data.Histogram.of(values, with_some)
        self.assertEqual(histogram.counts.sum(), len(values) - 5)
        self.assertEqual(histogram.bar[:5].tolist(), [-1] * 5)
        self.assertIn("logarithmic", panel.hint.text())
        folded = quality_data.Scale(quality_data.DISTORTION, np.array([1.0, np.inf]))
        self.assertEqual(folded.goodness(np.array([1.0, np.inf])).tolist(), [1.0, 0.0])  # infinite is bad there

    def test_an_open_mesh_is_refused(self):
        source = self.document.addObject("Mesh::Feature", "Sheet")
        source.Mesh = Mesh.createPlane(5, 5)
        panel = self.opened(source)
        gui_helpers.wait(0.2)
        self.assertIn("The mesh has 4 open edges: only solids have walls", panel.summary.text())

    def test_it_is_for_one_flat_mesh(self):
        box = self.box()
        curved, flat = mq.add_curved_mesh(box), mq.add_quality_mesh(box)
        self.select(box)
        self.assertTrue(commands.Thickness().IsActive())  # the mesh that is seen in its place
        curved.ViewObject.Visibility = True  # two are
        for chosen, active in (((box,), False), ((curved,), False), ((flat,), True), ((flat, curved), False)):
            self.select(*chosen)
            self.assertEqual(commands.Thickness().IsActive(), active)

    def test_a_hollow_shows_its_wall(self):
        box = self.box(Length=10, Width=10, Height=10)
        panel = self.opened(mq.add_hollow(box, 1.5, tolerance=0.05))
        self.assertAlmostEqual(float(panel.values[panel._worst[0]]), 1.5, delta=0.06)
        self.assertTrue(FreeCADGui.Control.activeDialog())
