# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verdict's and OpenFOAM's measures in the quality view, and the table that it saves."""

import csv
import importlib.util
import os
import unittest
from unittest import mock

import given_meshes
import gui_helpers
import numpy as np
import Part
from PySide import QtGui

import MeshQuality as mq
from MeshQuality.gui import element_measures, quality_data
from MeshQuality.gui.panels import quality_panel

HAS_FEM = importlib.util.find_spec("Fem") is not None


class ElementMeasures(gui_helpers.PanelTest):
    def open(self, obj):
        panel = quality_panel.open_panel(obj)
        self.addCleanup(lambda: panel.ended or panel.reject())
        self.until(lambda: panel.values is not None)
        return panel

    def choose(self, panel, measure):
        panel.measures.setCurrentIndex(panel.data.measures.index(measure))
        self.until(lambda: panel.measure is measure)

    def table_saved(self, panel, path):
        with mock.patch.object(QtGui.QFileDialog, "getSaveFileName", return_value=(path, "")):
            panel.saving.values.click()
        self.until(lambda: not panel.saving.job.active)
        gui_helpers.wait()
        return panel.warning.text()

    def test_triangles(self):
        source = self.document.addObject("Part::Feature", "Part")
        source.Shape = Part.makeCylinder(5, 20)
        obj = mq.add_quality_mesh(source, chord_height=0.05)
        table, panel = mq.measures(obj), self.open(obj)
        for name in ("aspect_ratio", "scaled_jacobian", "equiangle_skew", "max_angle"):
            self.choose(panel, element_measures.MEASURES[name])
            np.testing.assert_allclose(panel.values, table[name], rtol=1e-9)
            self.assertEqual(panel.histogram.counts.sum(), len(table))
            self.assertEqual(panel._worst[0], table.worst(name)[0])
        self.choose(panel, quality_data.DISTANCE)
        path = os.path.join(self.folder, "values")
        self.assertEqual(self.table_saved(panel, path), "Saved: values.csv")
        with open(path + ".csv", encoding="ascii") as stream:
            rows = list(csv.DictReader(stream))
        self.assertEqual([float(row["max_angle"]) for row in rows], table["max_angle"].tolist())
        self.assertAlmostEqual(max(float(row["max_deviation"]) for row in rows), panel.values.max(), places=9)
        self.assertEqual({row["face"] for row in rows}, {"Face1", "Face2", "Face3"})
        self.narrow(panel, "panel_element_measures")

    def test_a_table_that_cannot_be_written(self):
        source = self.document.addObject("Part::Feature", "Part")
        source.Shape = Part.makeBox(1, 2, 3)
        panel = self.open(mq.add_quality_mesh(source))
        told = self.table_saved(panel, os.path.join(self.folder, "nowhere", "values.csv"))
        self.assertIn("nowhere", told)

    @unittest.skipUnless(HAS_FEM, "this FreeCAD has no FEM workbench")
    def test_volumes(self):
        given = self.document.addObject("Fem::FemMeshObject", "Given")
        given.FemMesh = given_meshes.straight_mesh(Part.makeBox(20, 10, 10), 5.0)
        self.document.recompute()
        table, panel = mq.measures(given), self.open(given)
        names = [name for name in table.names if name in element_measures.MEASURES]
        self.assertIn("non_orthogonality", names)
        for name in names:
            self.choose(panel, element_measures.MEASURES[name])
            np.testing.assert_allclose(panel.values, table[name], rtol=1e-9)
        path = os.path.join(self.folder, "values.csv")
        self.table_saved(panel, path)
        with open(path, encoding="ascii") as stream:
            numbers = [int(row["element"]) for row in csv.DictReader(stream)]
        self.assertEqual(numbers, sorted(given.FemMesh.Volumes))
        self.picture("fem_non_orthogonality")
