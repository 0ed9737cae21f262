# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands for meshes nested in an assembly: parts in parts and links to them, each moved and turned."""

import os
import shutil
import sys
import unittest

import FreeCAD
import FreeCADGui
import gui_helpers
import helpers
import Mesh
import numpy as np
import Part
import test_section

import MeshQuality as mq
from MeshQuality.features import adapted_mesh
from MeshQuality.compat import fem_in_document
from MeshQuality.gui import commands
from MeshQuality.gui.panels import quality_panel
from MeshQuality.gui.panels.solid_panel import SolidPanel

sys.path.append(os.path.join(helpers.ROOT, "benchmarks", "solvers"))
import cantilever  # noqa: E402

SIZES = (10.0, 20.0, 30.0)  # mm: of the box in the assembly


def placement(base, axis, angle):
    return FreeCAD.Placement(FreeCAD.Vector(*base), FreeCAD.Rotation(FreeCAD.Vector(*axis), angle))


class Nested(gui_helpers.PanelTest):
    """Outer > Inner > a box and what is made of it, all moved and turned, and a link to Outer elsewhere."""

    def setUp(self):
        super().setUp()
        self.source = self.document.addObject("Part::Box", "Block")
        self.source.Length, self.source.Width, self.source.Height = SIZES
        self.source.Placement = placement((1, 2, 3), (0, 0, 1), 25)
        self.inner, self.outer = (self.document.addObject("App::Part", name) for name in ("Inner", "Outer"))
        self.inner.addObject(self.source)
        self.outer.addObject(self.inner)
        self.inner.Placement = placement((40, 5, 0), (1, 1, 0), 40)
        self.outer.Placement = placement((0, 100, 30), (0, 1, 0), -60)
        self.link = self.document.addObject("App::Link", "Link")
        self.link.LinkedObject = self.outer
        self.link.LinkTransform = False
        self.link.Placement = placement((300, 0, 0), (1, 0, 1), 110)
        self.document.recompute()
        within = self.inner.Placement.multiply(self.source.Placement)
        self.places = {"part": self.outer.Placement.multiply(within), "link": self.link.Placement.multiply(within)}

    def put_in(self, obj):
        """Moves what was made of the box beside it."""
        self.inner.addObject(obj)
        self.document.recompute()
        return obj

    def pick(self, command, obj, way):
        """Selects as a click in the 3D view does; the sources of the command."""
        FreeCADGui.Selection.clearSelection()
        root = {"part": self.outer, "link": self.link}[way]
        FreeCADGui.Selection.addSelection(self.document.Name, root.Name, f"Inner.{obj.Name}.")
        self.assertTrue(command().IsActive(), (command.__name__, way))
        return command().selected()

    def in_box(self, points, way):
        """float64 (n, 3): points as the box has them before it is moved."""
        back = self.places[way].inverse()
        return np.array([tuple(back.multVec(FreeCAD.Vector(*map(float, point)))) for point in points])

    def assert_is_box(self, points, way, sizes=SIZES):
        """The points span the box where it stands in the document."""
        found = self.in_box(points, way)
        np.testing.assert_allclose([found.min(axis=0), found.max(axis=0)], [np.zeros(3), sizes], atol=2e-4)

    def opened(self, source, measure=None):
        panel = quality_panel.open_panel(source, measure)
        self.addCleanup(lambda: panel.ended or panel.reject())
        self.until(lambda: panel.values is not None)
        return panel

    def done(self, command, *sources):
        """The object that a command adds for sources."""
        panel = command().panel(command().operations(list(sources)))
        FreeCADGui.Control.showDialog(panel)
        gui_helpers.wait()
        panel.accept()
        self.until(lambda: not panel.jobs)
        self.assertEqual(panel.said, "")
        self.until(lambda: FreeCADGui.Control.activeDialog() is False or quality_panel.shown() is not None)
        return panel.operations[0].obj


class Views(Nested):
    def test_section(self):
        for volume in (False, True):
            made = mq.add_curved_mesh(self.source, order=2, volume=True) if volume else mq.add_quality_mesh(self.source)
            self.put_in(made)
            for way in self.places:
                with self.subTest(volume=volume, way=way):
                    panel = self.opened(self.pick(commands.Analyse, made, way)[0])
                    self.assert_is_box(panel.data.corners.reshape(-1, 3), way)
                    self.view.viewFront()
                    self.view.fitAll()
                    panel.section.on.setChecked(True)
                    gui_helpers.wait(0.3)
                    corners = test_section.cap(panel)
                    plane = panel.section.plane
                    self.assertLess(np.abs(plane.heights(corners.reshape(-1, 3))).max(), 1e-3)
                    solid = Part.makeBox(*SIZES)
                    solid.Placement = self.places[way]
                    axis = FreeCAD.Vector(*map(float, plane.normal))
                    wires = solid.slice(axis, float(axis * FreeCAD.Vector(*map(float, plane.point))))
                    self.assertAlmostEqual(test_section.area_of(corners), Part.Face(wires).Area, delta=0.05)
                    self.saved(f"nested_section_{way}_{volume}")
                    panel.reject()

    def test_thickness(self):
        net = self.put_in(mq.add_quality_mesh(self.source))
        for way in self.places:
            with self.subTest(way=way):
                source, = self.pick(commands.Thickness, net, way)
                commands.Thickness().Activated()
                panel = quality_panel.shown()
                self.addCleanup(lambda shown=panel: shown.ended or shown.reject())
                self.until(lambda shown=panel: shown.values is not None)
                self.assert_is_box(panel.data.corners.reshape(-1, 3), way)
                self.assertAlmostEqual(panel.values[np.isfinite(panel.values)].max(), min(SIZES), delta=1e-5)
                self.picture(f"nested_thickness_{way}")
                panel.reject()


class Objects(Nested):
    def points_of(self, obj):
        mesh = obj.Mesh.copy()
        mesh.Placement = obj.getGlobalPlacement()
        return np.array([tuple(point.Vector) for point in mesh.Points])

    def test_simplify(self):
        net = self.put_in(mq.add_quality_mesh(self.source, max_edge=3.0))
        for way in self.places:
            with self.subTest(way=way):
                made = self.done(commands.Simplify, *self.pick(commands.Simplify, net, way))
                self.assertEqual(made.Triangles, 12)
                self.assert_is_box(self.points_of(made), way)

    def test_to_solid(self):
        net = self.put_in(mq.add_hollow(self.source, 2.0))
        for way in self.places:
            with self.subTest(way=way):
                panel = SolidPanel(self.pick(commands.ToSolid, net, way)[0])
                FreeCADGui.Control.showDialog(panel)
                self.until(lambda shown=panel: shown.found is not None or shown.said)
                self.until(lambda shown=panel: shown.job is None)
                self.assertEqual(panel.said, "")
                panel.accept()
                solid = self.document.ActiveObject
                self.assertTrue(solid.Shape.isValid())
                self.assertEqual((solid.ExactFaces, solid.FacetCount, list(solid.Notes)), (12, 0, []))
                self.assertAlmostEqual(solid.Shape.Volume, 6000 - 6 * 16 * 26, places=6)
                self.assert_is_box([vertex.Point for vertex in solid.Shape.Vertexes], way)
                self.assertTrue(self.outer.ViewObject.Visibility and self.link.ViewObject.Visibility)
        panel = self.opened(net)
        self.assertFalse(any(obj.ViewObject.Visibility for obj in self.document.Objects if obj.Name.startswith("Solid") and obj.Source == net))
        panel.reject()

    def test_deviation(self):
        scan = self.document.addObject("Mesh::Feature", "Scan")
        box = Mesh.createBox(*SIZES)
        box.translate(SIZES[0] / 2, SIZES[1] / 2, SIZES[2] / 2 + 0.5)
        scan.Mesh = box
        scan.Placement = self.source.Placement
        self.put_in(scan)
        for way in self.places:
            with self.subTest(way=way):
                FreeCADGui.Selection.clearSelection()
                root = {"part": self.outer, "link": self.link}[way]
                for obj in (scan, self.source):
                    FreeCADGui.Selection.addSelection(self.document.Name, root.Name, f"Inner.{obj.Name}.")
                self.assertTrue(commands.Deviation().IsActive())
                made = self.done(commands.Deviation, *commands.Deviation().selected())
                self.until(lambda: quality_panel.shown() is not None and quality_panel.shown().values is not None)
                panel = quality_panel.shown()
                found = self.in_box(panel.data.corners.reshape(-1, 3), way)
                np.testing.assert_allclose([found.min(axis=0), found.max(axis=0)], [(0, 0, 0.5), (10, 20, 30.5)], atol=2e-4)
                self.assertAlmostEqual(made.MaxDeviation.Value, 0.5, delta=1e-5)
                self.picture(f"nested_deviation_{way}")
                panel.reject()


@unittest.skipUnless(shutil.which("ccx"), "CalculiX (ccx) is not installed")
class Fem(Nested):
    def test_adapt_and_section(self):
        errors = []
        for nested in (False, True):
            part = self.document.addObject("Part::Feature", "Bracket")
            part.Shape = cantilever.bracket()
            if nested:
                self.put_in(part)
            self.document.recompute()
            analysis = cantilever.add_analysis(part, "force")
            if nested and not fem_in_document():
                self.put_in(analysis)
            obj = mq.add_fem_mesh(part, analysis=analysis, max_edge=12.0)
            FreeCADGui.Selection.clearSelection()
            FreeCADGui.Selection.addSelection(analysis)
            self.assertTrue(commands.Adapt().IsActive())
            panel = commands.Adapt.PANEL(commands.Adapt().selected()[0])
            FreeCADGui.Control.showDialog(panel)
            panel.options.set_values({"target_error": 0.005, "max_unknowns": 15_000, "steps": 1})
            panel.accept()
            self.until(lambda shown=panel: shown.job is None)
            self.assertIn("Solve the analysis once more", panel.said)
            panel.reject()
            errors.append([step[3] for step in adapted_mesh.steps_in(analysis)])
        np.testing.assert_allclose(errors[1], errors[0], rtol=0.05)
        panel = self.opened(obj)
        self.view.viewFront()
        self.view.fitAll()
        panel.section.on.setChecked(True)
        gui_helpers.wait(0.3)
        solid = cantilever.bracket()
        solid.Placement = self.outer.Placement.multiply(self.inner.Placement)
        axis = FreeCAD.Vector(*map(float, panel.section.plane.normal))
        wires = solid.slice(axis, float(axis * FreeCAD.Vector(*map(float, panel.section.plane.point))))
        self.assertAlmostEqual(test_section.area_of(test_section.cap(panel)) / Part.Face(wires).Area, 1.0, delta=0.05)  # of straight elements
        self.saved("nested_fem_section")
        panel.reject()
