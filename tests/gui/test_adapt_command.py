# SPDX-License-Identifier: LGPL-2.1-or-later
"""Adapt mesh: from an analysis over the panel with its plot to meshes of less error, step by step, undone, cancelled."""

import os
import shutil
import sys
import time
import unittest

import FreeCADGui
import gui_helpers
import helpers
import numpy as np

import MeshQuality as mq
from MeshQuality.features import adapted_mesh
from MeshQuality.gui import commands
from MeshQuality.gui.panels import convergence_plot

sys.path.append(os.path.join(helpers.ROOT, "benchmarks", "solvers"))
import cantilever  # noqa: E402


@unittest.skipUnless(shutil.which("ccx"), "CalculiX (ccx) is not installed")
class AdaptCommand(gui_helpers.PanelTest):
    def setUp(self):
        super().setUp()
        part = self.document.addObject("Part::Feature", "Bracket")
        part.Shape = cantilever.bracket()
        self.document.recompute()
        self.analysis = cantilever.add_analysis(part, "force")
        self.obj = mq.add_fem_mesh(part, analysis=self.analysis, max_edge=12.0)
        self.document.UndoMode = 1
        self.document.clearUndos()

    def panel(self, command, *objects):
        self.select(*objects)
        self.assertTrue(command().IsActive())
        panel = command.PANEL(command().selected()[0])
        FreeCADGui.Control.showDialog(panel)
        gui_helpers.wait()
        return panel

    def until(self, condition):
        """As in the base class; the work, much of it Python, has the interpreter for most of the time."""
        end = time.monotonic() + gui_helpers.LIMIT
        while not condition() and time.monotonic() < end:
            gui_helpers.wait(0.02)
            time.sleep(0.1)
        self.assertTrue(condition())

    def test_from_an_analysis_to_a_mesh_of_less_error(self):
        first = self.obj.FemMesh.VolumeCount
        panel = self.panel(commands.Adapt, self.analysis)
        self.assertFalse(panel.plot.isVisible())
        panel.options.set_values({"target_error": 0.005, "max_unknowns": 15_000, "steps": 2})
        ticks = []
        panel.table.model().rowsInserted.connect(lambda *_: ticks.append(panel.table.rowCount()))
        panel.accept()
        self.until(lambda: panel.job is None)
        self.assertIn("Solve the analysis once more", panel.said)
        steps = adapted_mesh.steps_in(self.analysis)
        self.assertEqual([step[0] for step in steps], [1, 2])
        self.assertLess(steps[-1][3], 0.8 * steps[0][3])
        self.assertEqual(panel.table.rowCount(), 2)
        self.assertGreater(len(ticks), 1)  # it was seen step by step
        self.assertEqual(self.obj.FemMesh.VolumeCount, steps[-1][2])
        self.assertEqual((self.obj.Certificate, len(self.obj.SizeField)), ("met", 1))
        self.narrow(panel, "panel_adapt")
        places = [panel.plot.place(step[1], step[3]) for step in steps]
        self.assertTrue(all(0 < place.x() < panel.plot.width() and 0 < place.y() < panel.plot.height() for place in places))
        self.assertTrue(places[0].x() < places[-1].x() and places[0].y() < places[-1].y())
        panel.reject()
        for rows in (1, 0):  # each step is one of undo
            self.document.undo()
            self.assertEqual(len(adapted_mesh.steps_in(self.analysis)), rows)
            self.assertEqual(self.obj.SizeField, [])  # the first step has the sizes of the mesh that was there
        self.assertEqual(self.document.UndoCount, 0)
        self.assertIsNone(adapted_mesh.table_of(self.analysis))
        self.obj.touch()  # FreeCAD's undo does not always bring back a FemMesh
        self.document.recompute()
        self.assertEqual(self.obj.FemMesh.VolumeCount, first)

    def test_cancel_keeps_the_last_good_step(self):
        panel = self.panel(commands.Adapt, self.obj)
        panel.options.set_values({"target_error": 0.0001, "max_unknowns": 60_000, "steps": 8})
        panel.accept()
        self.until(lambda: len(adapted_mesh.steps_in(self.analysis)) >= 2)
        panel.reject()
        self.until(lambda: panel.job is None)
        self.assertIn("last good step stays", panel.said)
        steps = adapted_mesh.steps_in(self.analysis)
        self.assertEqual(self.obj.FemMesh.VolumeCount, steps[-1][2])
        panel.reject()
        again = self.panel(commands.Adapt, self.analysis)
        self.assertEqual(again.table.rowCount(), len(steps))  # the document has the table
        again.reject()

    def test_what_is_wrong_is_said(self):
        solver = next(member for member in self.analysis.Group if member.isDerivedFrom("Fem::FemSolverObjectPython"))
        self.document.removeObject(solver.Name)
        panel = self.panel(commands.Adapt, self.analysis)
        panel.accept()
        self.until(lambda: panel.job is None)
        self.assertIn("has no solver", panel.said)
        panel.reject()


class Plot(unittest.TestCase):
    def test_ticks_are_round_and_within(self):
        self.assertEqual(convergence_plot.ticks(2.9, 4.1), [1000, 2000, 5000, 10000])
        np.testing.assert_allclose(convergence_plot.ticks(-3.1, 0.1), [0.001, 0.01, 0.1, 1.0])
