# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the pictures of docs/pictures/ that show FreeCAD:   python3 tests/gui/run.py doc_pictures"""

import os
import sys
import tempfile

import FreeCAD
import FreeCADGui
import given_meshes
import gui_helpers
import helpers
import numpy as np
import Part
from PySide import QtCore, QtGui

import MeshQuality as mq
from MeshQuality import exchange
from MeshQuality.compat import extension
from MeshQuality.core.sources import convert
from MeshQuality.gui import commands, curved_view, element_measures, quality_data
from MeshQuality.gui.panels import quality_panel
from MeshQuality.gui.panels.flow_panel import FlowPanel
from MeshQuality.gui.panels.mesh_panel import MeshPanel
from MeshQuality.gui.panels.patches_panel import PatchesPanel
from MeshQuality.gui.panels.solid_panel import SolidPanel

sys.path.append(os.path.join(helpers.ROOT, "benchmarks", "solvers"))
import cantilever  # noqa: E402

DOCS = os.path.join(helpers.ROOT, "docs", "pictures")


class Pictures(gui_helpers.GuiTest):
    def test_curved_elements(self):
        source = self.document.addObject("Part::Feature", "Elbow")
        source.Shape = Part.makeTorus(20, 8, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), -180, 180,
                                      110).cut(Part.makeTorus(20, 5))
        self.document.recompute()
        source.ViewObject.Visibility = False
        obj = mq.add_curved_mesh(source, order=3, volume=True, chord_height_relative=0.03)
        self.assertEqual(obj.Invalid, 0)
        self.picture("curved_elements", DOCS)
        obj.ViewObject.ColorBy = curved_view.JACOBIAN
        self.picture("curved_jacobian", DOCS)

    def test_fem_mesh(self):
        source = self.document.addObject("Part::Feature", "Shaft")
        source.Shape = cantilever.bracket()
        self.document.recompute()
        analysis = cantilever.add_analysis(source, "force")
        mq.add_fem_mesh(source, analysis=analysis, max_edge=6.0)
        self.picture("fem_mesh", DOCS)

    def test_size_regions(self):
        """Sizes drawn as points beside the panel, before meshing."""
        block = self.document.addObject("Part::Feature", "Block")
        block.Shape = Part.makeBox(40, 30, 10).cut(Part.makeCylinder(6, 10, FreeCAD.Vector(20, 15, 0)))
        ball = self.document.addObject("Part::Sphere", "Ball")
        ball.Radius, ball.Placement.Base = 8, FreeCAD.Vector(40, 0, 10)
        self.document.recompute()
        ball.ViewObject.Transparency = 80
        regions = [mq.add_size_region(ball, 0.8),
                   mq.add_size_region((block, "Edge15"), 0.6, kind="near", distance=8, far_size=4)]
        panel = MeshPanel(commands.Triangulate().operations([block]))
        FreeCADGui.Control.showDialog(panel)
        self.addCleanup(FreeCADGui.Control.closeDialog)
        panel.options.set_values({"size_field": [region.Name for region in regions]})
        panel.options.field("size_field").draw.click()
        self.picture("size_regions", DOCS)
        self.until(lambda: "triangles" in panel.estimate.text() and "Counting" not in panel.estimate.text())
        self.picture_of_panel(panel, "panel_size_regions")

    def test_given_fem_mesh(self):
        """Folded elements of a mesh that was given: the panel beside the view."""
        source = self.document.addObject("Part::Feature", "Shaft")
        source.Shape = cantilever.bracket()
        given = self.document.addObject("Fem::FemMeshObject", "Given")
        given.FemMesh = given_meshes.straight_mesh(source.Shape, 8.0, (5, 40))
        self.document.recompute()
        source.ViewObject.Visibility = False
        panel = quality_panel.open_panel(given)
        self.until(lambda: panel.values is not None)
        self.view.viewAxonometric()
        panel.worst.setCurrentRow(0)
        self.until(lambda: not panel.scene.flight.active)
        gui_helpers.wait(0.3)
        self.saved("given_fem_mesh", DOCS)
        panel.reject()

    def test_cam_mesh(self):
        """The panel beside the mesh."""
        source = self.document.addObject("Part::Feature", "Part")
        box = Part.makeBox(60, 40, 20)
        source.Shape = box.makeFillet(5, box.Edges)
        obj = mq.add_cam_mesh(source, tolerance=0.1)
        obj.ViewObject.DisplayMode = "Flat Lines"
        FreeCADGui.Selection.clearSelection()
        panel = MeshPanel([commands.CamMesh().editing(obj)], editing=True)
        FreeCADGui.Control.showDialog(panel)
        self.picture("cam_mesh", DOCS)
        self.as_at_first()
        view = QtGui.QImage(os.path.join(DOCS, "cam_mesh.png"))
        gui_helpers.wait(0.5)
        panel.form.setFixedWidth(260)
        gui_helpers.wait(0.3)
        form = panel.form.grab().toImage()
        both = QtGui.QImage(form.width() + view.width(), max(form.height(), view.height()), QtGui.QImage.Format_RGB32)
        both.fill(QtCore.Qt.white)
        painter = QtGui.QPainter(both)
        painter.drawImage(0, 0, form)
        painter.drawImage(form.width(), 0, view)
        painter.end()
        both.save(os.path.join(DOCS, "cam_mesh.png"))
        panel.reject()

    def test_simplify(self):
        """Two meshes side by side, with their edges."""
        source = self.bracket()
        given = mq.add_quality_mesh(source, max_edge=4.0)
        simple = mq.add_simplified_mesh(given, tolerance=0.1)
        self.document.recompute()
        copy = self.document.addObject("Mesh::Feature", "Given")
        copy.Mesh = given.Mesh.copy()
        copy.Placement.Base = FreeCAD.Vector(0, 60, 0)
        for obj in (copy, simple):
            obj.ViewObject.DisplayMode = "Flat Lines"
        self.picture("simplify", DOCS)

    def test_measures(self):
        source = self.document.addObject("Part::Feature", "Shaft")
        source.Shape = cantilever.bracket()
        self.document.recompute()
        obj = mq.add_fem_mesh(source, max_edge=4.0)
        panel = quality_panel.open_panel(obj)
        self.until(lambda: panel.values is not None)
        measure = element_measures.MEASURES["non_orthogonality"]
        panel.measures.setCurrentIndex(panel.data.measures.index(measure))
        self.until(lambda: panel.measure is measure)
        self.picture("measures", DOCS)
        self.picture_of_panel(panel, "panel_measures")
        panel.reject()

    def bracket(self):
        """A part with a fillet, holes and a knife edge."""
        plate = Part.makeBox(60, 40, 8).fuse(Part.makeBox(8, 40, 40))
        for y in (10, 30):
            plate = plate.cut(Part.makeCylinder(5, 20, FreeCAD.Vector(40, y, -5)))
        wedge = Part.Face(Part.makePolygon([FreeCAD.Vector(*p) for p in (
            (8, 0, 8), (40, 0, 8), (8, 0, 12), (8, 0, 8))])).extrude(FreeCAD.Vector(0, 40, 0))
        source = self.document.addObject("Part::Feature", "Bracket")
        source.Shape = plate.fuse(wedge).removeSplitter()
        self.document.recompute()
        return source

    def picture_of_panel(self, panel, name):
        """The panel as wide as FreeCAD's side bar is at first, in a window in which all of it is seen."""
        self.as_at_first()
        window = FreeCADGui.getMainWindow()
        self.addCleanup(window.resize, window.size())
        window.resize(1400, 1100)
        gui_helpers.wait(1.0)
        form = panel.form
        form.setFixedWidth(260)
        gui_helpers.wait(0.3)
        height = panel.lowest.geometry().bottom() + 1 if hasattr(panel, "lowest") else form.height()
        form.grab(QtCore.QRect(0, 0, form.width(), height)).save(os.path.join(DOCS, f"{name}.png"))

    def test_sections(self):
        """A FEM mesh cut open, and in whole elements, beside the panel."""
        source = self.document.addObject("Part::Feature", "Shaft")
        source.Shape = cantilever.bracket()
        self.document.recompute()
        panel = quality_panel.open_panel(mq.add_fem_mesh(source, max_edge=6.0))
        self.addCleanup(lambda: panel.ended or panel.reject())
        self.until(lambda: panel.values is not None)
        panel.measures.setCurrentIndex(panel.data.measures.index(quality_data.DISTORTION))
        self.until(lambda: panel.measure is quality_data.DISTORTION)
        panel.range.high.setText("3")
        panel.range.high.editingFinished.emit()
        self.view.viewAxonometric()
        panel.section.on.setChecked(True)
        panel.section.direction.setCurrentIndex(1)
        self.picture("section", DOCS)
        panel.section.whole.setChecked(True)
        self.picture("section_whole", DOCS)
        panel.form.setFixedWidth(260)
        gui_helpers.wait(0.3)
        panel.section.grab().save(os.path.join(DOCS, "panel_section.png"))

    def test_flow_mesh(self):
        """A bend of a pipe, its layers in whole elements behind a cut."""
        circle = Part.makeCircle(3, FreeCAD.Vector(12, 0, 0), FreeCAD.Vector(0, 1, 0))
        source = self.document.addObject("Part::Feature", "Bend")
        source.Shape = Part.Face(Part.Wire(circle)).revolve(FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 90)
        self.document.recompute()
        obj = mq.add_flow_mesh(source, 5, 0.1, growth_rate=1.3, max_edge=1.5, walls=["Face1"])
        self.assertEqual(obj.Covered, 1.0)
        panel = quality_panel.open_panel(obj)
        self.addCleanup(lambda: panel.ended or panel.reject())
        self.until(lambda: panel.values is not None)
        panel.measures.setCurrentIndex(next(i for i, each in enumerate(panel.data.measures) if each.title.startswith("Scaled Jacobian")))
        gui_helpers.wait(0.5)
        self.until(lambda: panel.values is not None)
        panel.section.on.setChecked(True)
        panel.section.direction.setCurrentIndex(2)
        panel.section.whole.setChecked(True)
        self.picture("flow_mesh", DOCS)

    def test_to_solid(self):
        """The mesh of a hollow, and its solid with exact faces beside it."""
        source = self.document.addObject("Part::Feature", "Part")
        source.Shape = Part.makeBox(40, 30, 20).cut(Part.makeCylinder(8, 40, FreeCAD.Vector(20, -5, 10), FreeCAD.Vector(0, 1, 0)))
        self.document.recompute()
        hollow = mq.add_hollow(source, 2.0, ["Face6"], tolerance=0.2)
        hollow.ViewObject.DisplayMode = "Flat Lines"
        panel = SolidPanel(hollow)
        FreeCADGui.Control.showDialog(panel)
        self.until(lambda: panel.found is not None and panel.job is None)
        panel.form.setFixedWidth(260)
        gui_helpers.wait(0.3)
        panel.form.grab(QtCore.QRect(0, 0, 260, panel.facets.geometry().bottom() + 8)).save(os.path.join(DOCS, "panel_to_solid.png"))
        panel.reject()
        solid = mq.add_solid(hollow)
        hollow.ViewObject.Visibility = True
        solid.ViewObject.Visibility = False
        beside = self.document.addObject("Part::Feature", "Beside")
        beside.Shape = solid.Shape.translated(FreeCAD.Vector(55, 0, 0))
        self.picture("to_solid", DOCS)

    def test_panel_of_a_flow_mesh(self):
        """A pipe whose wall was picked, and its cells counted; and the patches of its ends."""
        source = self.document.addObject("Part::Cylinder", "Pipe")
        source.Radius, source.Height = 5, 20
        self.document.recompute()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(source, "Face1")
        command = commands.FlowMesh()
        panel = FlowPanel(command.operations(command.selected()))
        FreeCADGui.Control.showDialog(panel)
        panel.options.set_values({"max_edge": 2.5, "first_height": 0.1, "layers": 3, "walls": ["Face1"]})
        self.until(lambda: "cells" in panel.estimate.text() and "Counting" not in panel.estimate.text())
        self.picture_of_panel(panel, "panel_flow_mesh")
        panel.reject()
        patches = PatchesPanel(mq.add_flow_mesh(source, 3, 0.1, max_edge=2.5, walls=["Face1"]))
        FreeCADGui.Control.showDialog(patches)
        self.addCleanup(FreeCADGui.Control.closeDialog)
        for row, (name, face) in enumerate((("inlet", "Face3"), ("outlet", "Face2"))):
            FreeCADGui.Selection.clearSelection()
            FreeCADGui.Selection.addSelection(source, face)
            patches.new.click()
            patches.table.item(row, 0).setText(name)
        patches.rest.setText("pipe")
        self.assertEqual(patches.patches(), {"inlet": {"faces": ["Face3"]}, "outlet": {"faces": ["Face2"]}})
        self.picture_of_panel(patches, "panel_patches")

    def test_panel_of_quality_mesh(self):
        source = self.bracket()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(source)
        panel = MeshPanel(commands.Triangulate().operations([source]))
        FreeCADGui.Control.showDialog(panel)
        self.until(lambda: "triangles" in panel.estimate.text()
                   and "Counting" not in panel.estimate.text())
        self.picture_of_panel(panel, "panel_quality_mesh")
        panel.reject()

    def test_quality_view(self):
        obj = mq.add_quality_mesh(self.bracket(), min_angle=25, chord_height=0.05)
        panel = quality_panel.open_panel(obj)
        self.until(lambda: panel.values is not None)
        self.picture("quality_colours", DOCS)
        self.picture_of_panel(panel, "panel_quality")
        panel.histogram.pick(int((panel.histogram.counts > 0).argmax()))
        self.picture("quality_lit", DOCS)
        panel.reject()

    def test_export_by_the_menu(self):
        """FreeCAD's dialog for the second file, over the Report view with the certificate of the first."""
        window = FreeCADGui.getMainWindow()
        FreeCADGui.activateWorkbench("PartWorkbench")
        self.addCleanup(window.resize, window.size())
        window.resize(1000, 700)
        report = window.findChild(QtGui.QDockWidget, "Report view")
        console = window.findChild(QtGui.QDockWidget, "Python console")
        self.addCleanup(console.setVisible, console.isVisible())
        console.setVisible(False)
        report.setVisible(True)
        report.raise_()
        source = self.bracket()
        self.view.viewAxonometric()
        self.view.fitAll()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(source)
        window.findChild(QtGui.QTextEdit, "Report view").clear()
        with tempfile.TemporaryDirectory() as folder:
            folder = os.path.join(folder, "Meshes")
            os.mkdir(folder)
            exchange.export([source], os.path.join(folder, "Bracket.stl"))
            window.resizeDocks([report], [120], QtCore.Qt.Vertical)
            gui_helpers.wait(1.0)

            def photograph():
                dialog = QtGui.QApplication.activeModalWidget()
                dialog.selectNameFilter("Quality mesh (*.3mf)")
                dialog.findChild(QtGui.QLineEdit, "fileNameEdit").setText("Bracket")
                dialog.setDirectory(folder)
                dialog.setSidebarUrls([])
                dialog.resize(560, 230)
                dialog.move(window.x() + 400, window.y() + 300)
                QtCore.QTimer.singleShot(1000, take)

            def take():
                gui_helpers.screen().copy(window.geometry()).save(os.path.join(DOCS, "export_menu.png"))
                QtGui.QApplication.activeModalWidget().reject()

            QtCore.QTimer.singleShot(1500, photograph)
            FreeCADGui.runCommand("Std_Export")

    def test_panels_in_german(self):
        FreeCADGui.setLocale("German")
        self.addCleanup(FreeCADGui.setLocale, "English")
        gui_helpers.wait(0.2)
        source = self.bracket()
        source.Label = "Winkel"
        panel = MeshPanel(commands.Triangulate().operations([source]))
        FreeCADGui.Control.showDialog(panel)
        self.until(lambda: "..." not in panel.estimate.text())
        self.picture_of_panel(panel, "panel_quality_mesh_de")
        panel.reject()

    def test_curved_quality(self):
        source = self.bracket()
        obj = mq.add_curved_mesh(source, order=2, volume=True)
        panel = quality_panel.open_panel(obj)
        self.until(lambda: panel.values is not None)
        panel.measures.setCurrentIndex(panel.data.measures.index(quality_data.DISTORTION))
        self.until(lambda: panel.measure is quality_data.DISTORTION)
        self.picture("quality_distortion", DOCS)
        self.picture_of_panel(panel, "panel_distortion")
        panel.reject()

    def test_certificate_and_marks(self):
        bracket, blade = self.bracket(), self.document.addObject("Part::Feature", "Blade")
        blade.Shape = Part.Face(Part.makePolygon([FreeCAD.Vector(*p) for p in (
            (0, 0, 0), (40, 0, 0), (40, 3, 0), (0, 0, 0))])).extrude(FreeCAD.Vector(0, 0, 30))
        self.document.recompute()
        good, missed = (mq.add_quality_mesh(source, chord_height_relative=0.003)
                        for source in (bracket, blade))
        waiting = mq.add_curved_mesh(bracket)
        waiting.Recompute = "Manual"
        bracket.Placement.Base = FreeCAD.Vector(0, 0, 1)
        self.document.recompute()
        self.assertEqual(good.Certificate, "met")
        self.assertTrue(missed.Certificate.startswith("not met"))
        for obj in (good, missed, waiting):
            obj.ViewObject.Visibility = True
        self.as_at_first()
        tree = next(tree for tree in FreeCADGui.getMainWindow().findChildren(QtGui.QTreeWidget)
                    if tree.isVisible() and tree.topLevelItemCount())
        tree.grab(QtCore.QRect(0, 0, 264, 155)).save(os.path.join(DOCS, "tree_badges.png"))
        panel = commands.panel_of(missed)
        FreeCADGui.Control.showDialog(panel)
        self.picture_of_panel(panel, "panel_missed")
        panel.reject()

    def lever(self):
        """A solid lever with two bores, all of its edges rounded."""
        def at(x):
            return FreeCAD.Vector(x, 0, 0)

        web = Part.Face(Part.makePolygon([FreeCAD.Vector(*p) for p in (
            (0, -16, 2), (60, -9, 2), (60, 9, 2), (0, 16, 2), (0, -16, 2))])).extrude(FreeCAD.Vector(0, 0, 14))
        whole = web.makeFillet(1.5, web.Edges)
        for x, radius, height in ((0, 20, 24), (60, 13, 18)):
            disc = Part.makeCylinder(radius, height, at(x))
            whole = whole.fuse(disc.makeFillet(1.5, [edge for edge in disc.Edges if edge.isClosed() and len(edge.Vertexes) == 1]))
        for x, radius in ((0, 9), (60, 5)):
            whole = whole.cut(Part.makeCylinder(radius, 40, at(x) + FreeCAD.Vector(0, 0, -5)))
        source = self.document.addObject("Part::Feature", "Lever")
        source.Shape = whole
        self.document.recompute()
        return source

    def cut_open(self, mesh, colour, of_cut, forward=0.0):
        """Adds what is behind the plane through the middle of a mesh in one colour, and the section in another, as many mm
        in front of it.
        """
        front = Part.makeBox(200, 100, 100, FreeCAD.Vector(-100, -100, -50))
        half = mq.boolean(mesh, front, "difference", tolerance=0.02)
        points = np.asarray(half.vertices) + half.origin
        on_plane = (abs(points[half.triangles][:, :, 1]) < 1e-3).all(axis=1)
        for name, chosen, shown in (("Behind", ~on_plane, colour), ("Section", on_plane, of_cut)):
            self.coloured(name, half, chosen, shown).Placement.Base.y -= forward

    def coloured(self, name, mesh, chosen, colour):
        """Adds some triangles of a mesh in one colour."""
        obj = self.document.addObject("Mesh::Feature", name)
        obj.Mesh = convert.mesh_of_surface(extension().surface_from_arrays(
            np.asarray(mesh.vertices) + mesh.origin, mesh.triangles[chosen], np.zeros(0, np.int32), False))
        obj.ViewObject.ShapeColor = colour
        obj.ViewObject.Lighting = "Two side"
        return obj

    def seen_from(self, name, *eye):
        """A picture seen from a direction, z upward."""
        eye = FreeCAD.Vector(*eye)
        right = FreeCAD.Vector(0, 0, 1).cross(eye)
        self.view.setCameraOrientation(FreeCAD.Rotation(right, eye.cross(right), eye, "ZXY"))
        self.view.fitAll()
        gui_helpers.wait(0.3)
        self.saved(name, DOCS)

    def test_hollow_in_section(self):
        source = self.lever()
        mesh = mq.hollow(source, 3.0, tolerance=0.15)
        self.assertTrue(mesh.report.closed)
        source.ViewObject.Visibility = False
        self.cut_open(mesh, (0.72, 0.78, 0.85), (0.95, 0.55, 0.2))
        self.seen_from("print_hollow", 0.35, -1, 0.6)

    def test_offset_in_section(self):
        source = self.lever()
        source.ViewObject.Visibility = False
        self.cut_open(mq.offset(source, 4.0, tolerance=0.15), (0.72, 0.78, 0.85), (0.55, 0.75, 0.95))
        self.cut_open(mq.triangulate(source, chord_height=0.02), (0.72, 0.78, 0.85), (0.95, 0.55, 0.2), 0.1)
        self.seen_from("print_offset", 0.35, -1, 0.6)

    def test_thickness_in_colours(self):
        """A cover with bosses and a groove that leaves little of its wall."""
        cover = Part.makeBox(60, 40, 18)
        cover = cover.makeFillet(6, [edge for edge in cover.Edges if abs(edge.tangentAt(edge.FirstParameter).z) > 0.9])
        cover = cover.cut(Part.makeBox(54, 34, 15, FreeCAD.Vector(3, 3, 3)))
        for x, y in ((7, 7), (53, 7), (7, 33), (53, 33)):
            boss = Part.makeCylinder(5, 18, FreeCAD.Vector(x, y, 0))
            cover = cover.fuse(boss).cut(Part.makeCylinder(2, 14, FreeCAD.Vector(x, y, 4)))
        cover = cover.cut(Part.makeCylinder(5.2, 26, FreeCAD.Vector(17, 43.8, 9), FreeCAD.Vector(1, 0, 0))).removeSplitter()
        source = self.document.addObject("Part::Feature", "Cover")
        source.Shape = cover
        self.document.recompute()
        source.ViewObject.Visibility = False
        obj = mq.add_quality_mesh(source, max_edge=1.2)
        panel = quality_panel.open_panel(obj, quality_data.THICKNESS)
        self.until(lambda: panel.values is not None)
        panel.edges.setChecked(False)
        self.seen_from("print_thickness", 0.45, 1, 0.9)
        self.picture_of_panel(panel, "panel_thickness")
        panel.reject()

    def test_panel_of_an_inspection(self):
        source = self.document.addObject("Part::Feature", "Plate")
        source.Shape = Part.makeBox(30, 20, 3).cut(Part.makeBox(10, 20, 2, FreeCAD.Vector(20, 0, 1)))
        self.document.recompute()
        panel = commands.panel_of(mq.add_inspection(source, min_thickness=1.2))
        FreeCADGui.Control.showDialog(panel)
        self.picture_of_panel(panel, "panel_inspection")
        panel.reject()

    def test_deviation_of_a_scan(self):
        part = self.bracket()
        exact = mq.triangulate(part, max_edge=1.0)
        x, y, z = np.array(exact.vertices).T
        off = 0.12 * np.sin(x / 11) * np.cos(y / 9) + 0.3 * np.exp(-((x - x.mean()) ** 2 + (y - y.min()) ** 2 + (z - z.mean()) ** 2) / 60)
        scan = self.document.addObject("Mesh::Feature", "Scan")
        scan.Mesh = mq.SurfaceMesh(extension().surface_from_arrays(exact.vertices + off[:, None] * (0.5, -1.0, 0.7), exact.triangles)).to_mesh()
        panel = quality_panel.open_panel(mq.add_deviation(scan, part, tolerance=0.2))
        self.until(lambda: panel.values is not None)
        panel.edges.setChecked(False)
        self.seen_from("deviation", -0.8, -1, 0.9)
        self.picture_of_panel(panel, "panel_deviation")
        panel.reject()

    def housing(self):
        """An assembly: a tub with a hole, a lid on a crack, and a motor that does not touch the tub."""
        tub = Part.makeBox(60, 40, 24).cut(Part.makeBox(54, 34, 24, FreeCAD.Vector(3, 3, 3)))
        parts = (("Tub", tub.cut(Part.makeCylinder(4, 10, FreeCAD.Vector(30, -2, 13), FreeCAD.Vector(0, 1, 0))), (0.72, 0.78, 0.85)),
                 ("Lid", Part.makeBox(60, 40, 3, FreeCAD.Vector(0, 0, 24.8)), (0.62, 0.74, 0.62)),
                 ("Motor", Part.makeCylinder(10, 14, FreeCAD.Vector(60.9, 20, 12), FreeCAD.Vector(1, 0, 0)), (0.8, 0.74, 0.6)))
        found = []
        for name, shape, colour in parts:
            obj = self.document.addObject("Part::Feature", name)
            obj.Shape, obj.ViewObject.ShapeColor = shape, colour
            found.append(obj)
        self.document.recompute()
        return found

    def test_wrap_of_an_assembly(self):
        """As it is, where it leaks, and its wrap with what closes gaps in another colour."""
        parts = self.housing()
        self.seen_from("wrap_assembly", 0.45, -1, 0.6)
        leaking = mq.wrap(parts, 3.0, 1.0, dry=[(30, 20, 13)])
        leak, = leaking.leaks
        dry = mq.wrap(parts, 10.0, 1.0, dry=[leak.dry])
        self.assertEqual(dry.leaks, [])
        for obj in parts:
            obj.ViewObject.Visibility = False
        gaps = dry.triangle_patch == dry.patches.index("gaps")
        shown = [self.coloured("Wrap", dry, ~gaps, (0.72, 0.78, 0.85)), self.coloured("Gaps", dry, gaps, (0.95, 0.55, 0.2))]
        self.seen_from("wrap_closed", 0.45, -1, 0.6)
        for obj in shown:
            obj.ViewObject.Visibility = False
        below = Part.makeBox(200, 200, 100, FreeCAD.Vector(-50, -100, leak.narrowest[2] - 100))
        for obj in parts:
            half = self.document.addObject("Part::Feature", "Half")
            half.Shape, half.ViewObject.ShapeColor = obj.Shape.common(below), obj.ViewObject.ShapeColor
        line = self.document.addObject("Part::Feature", "Path")
        line.Shape = Part.makePolygon([FreeCAD.Vector(*place) for place in leak.path])
        line.ViewObject.LineColor, line.ViewObject.LineWidth = (0.85, 0.1, 0.1), 6
        for place, radius in ((leak.dry, 1.5), (leak.narrowest, 0.5 * leak.width)):
            ball = self.document.addObject("Part::Feature", "Ball")
            ball.Shape, ball.ViewObject.ShapeColor = Part.makeSphere(radius, FreeCAD.Vector(*place)), (0.95, 0.55, 0.2)
        self.seen_from("wrap_leak", 0.2, -1, 1.6)

    def test_panel_of_a_wrap(self):
        panel = MeshPanel(commands.Wrap().operations(self.housing()))
        FreeCADGui.Control.showDialog(panel)
        panel.options.set_values({"gap": 3.0})
        self.picture_of_panel(panel, "panel_wrap")
        panel.reject()
