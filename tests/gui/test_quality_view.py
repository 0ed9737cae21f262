# SPDX-License-Identifier: LGPL-2.1-or-later
"""Analyse Quality: the numbers, the colours, what lights up, and where the camera flies."""

import re
from unittest import mock

import FreeCAD
import FreeCADGui
import gui_helpers
import Mesh
import numpy as np
import Part
from PySide import QtGui

import MeshQuality as mq
from MeshQuality.compat import extension
from MeshQuality.core.sources import convert
from MeshQuality.gui import commands, quality_data
from MeshQuality.gui.panels import quality_panel
from MeshQuality.gui.view import legend, quality_scene

MAGENTA = (255, 32, 255)


def share_of(pixels, colour, width=40):
    """Which part of a picture has nearly this colour."""
    return (np.abs(pixels - np.array(colour)) < width).all(axis=2).mean()


class QualityView(gui_helpers.GuiTest):
    def tearDown(self):
        if FreeCADGui.Control.activeDialog():
            FreeCADGui.Control.closeDialog()
        super().tearDown()

    def meshed(self, shape, **values):
        source = self.document.addObject("Part::Feature", "Part")
        source.Shape = shape
        self.document.recompute()
        return mq.add_quality_mesh(source, **values)

    def open(self, obj):
        panel = quality_panel.open_panel(obj)
        self.addCleanup(lambda: panel.ended or panel.reject())
        self.until(lambda: panel.values is not None)
        return panel

    def choose(self, panel, measure):
        panel.measures.setCurrentIndex(panel.data.measures.index(measure))
        self.until(lambda: panel.measure is measure)

    def test_command_is_for_one_mesh(self):
        obj = self.meshed(Part.makeBox(3, 4, 5))
        FreeCADGui.activateWorkbench("MeshQualityWorkbench")
        for chosen, active in (([obj], True), ([obj.Source], True), ([obj, obj.Source], False)):
            FreeCADGui.Selection.clearSelection()
            for one in chosen:
                FreeCADGui.Selection.addSelection(one)
            self.assertEqual(commands.Analyse().IsActive(), active)
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(obj)
        FreeCADGui.runCommand(commands.Analyse.NAME)
        self.assertTrue(FreeCADGui.Control.activeDialog())

    def test_numbers_are_those_of_the_report(self):
        obj = self.meshed(Part.makeCylinder(5, 20), chord_height=0.05)
        report = mq.quality(obj, obj.Source)
        panel = self.open(obj)
        self.assertAlmostEqual(panel.values.min(), report.min_angle, places=9)
        self.assertAlmostEqual(panel.values.mean(), report.mean_min_angle, places=9)
        self.assertEqual(panel.histogram.counts.sum(), obj.Mesh.CountFacets)
        self.choose(panel, quality_data.ASPECT)
        self.assertAlmostEqual(panel.values.max(), report.max_aspect, places=9)
        self.choose(panel, quality_data.DISTANCE)
        self.assertAlmostEqual(panel.values.max(), report.max_chord_height, places=9)
        self.assertLessEqual(panel.values.max(), 0.05 + 1e-9)

    def test_colours_follow_the_quality(self):
        obj = self.meshed(Part.makeBox(10, 10, 10))
        panel = self.open(obj)
        before = self.picture("quality_angles")
        # All triangles of a cube's sides are half squares: 45 degrees are green.
        self.assertGreater(share_of(before, (40, 130, 90), 90), 0.1)
        self.choose(panel, quality_data.DISTANCE)
        self.assertGreater(share_of(self.picture("quality_distance"), (40, 80, 180), 90), 0.1)

    def test_a_bar_lights_up_its_triangles(self):
        panel = self.open(self.meshed(Part.makeSphere(5), chord_height=0.05))
        self.assertEqual(share_of(self.picture("quality_dark"), MAGENTA), 0.0)
        bar = int(panel.histogram.counts.argmax())
        panel.histogram.pick(bar)
        self.assertIn(f"{panel.histogram.counts[bar]:,} from", panel.hint.text())
        self.assertGreater(share_of(self.picture("quality_lit"), MAGENTA), 0.005)
        panel.histogram.pick(-1)
        self.assertEqual(share_of(self.picture("quality_dark"), MAGENTA), 0.0)

    def test_worst_elements_name_their_face_and_the_reason(self):
        # A wedge of 3 degrees: no mesh can do better in its corner.
        wedge = Part.Face(Part.makePolygon([FreeCAD.Vector(*p) for p in (
            (0, 0, 0), (20, 0, 0), (20, 20 * np.tan(np.radians(3)), 0), (0, 0, 0))]))
        obj = self.meshed(wedge.extrude(FreeCAD.Vector(0, 0, 5)))
        panel = self.open(obj)
        self.assertEqual(panel.worst.count(), min(quality_panel.WORST, obj.Mesh.CountFacets))
        first = panel.worst.item(0).text()
        self.assertRegex(first, r"^3°: element \d+ on Face[45]\n.")
        reason = re.search(r"the shape itself has a corner of 3\.00° between Edge\d+ and Edge\d+ at Vertex\d+",
                           first)
        self.assertIn(reason[0], "\n".join(obj.Exempt))

    def test_the_camera_flies_to_an_element(self):
        panel = self.open(self.meshed(Part.makeSphere(5), chord_height=0.02))
        self.view.viewAxonometric()
        self.view.fitAll()
        panel.worst.setCurrentRow(3)
        self.until(lambda: not panel.scene.flight.active)
        element = panel._worst[3]
        centre = panel.data.corners[element].mean(axis=0)
        ahead = np.array(self.view.getViewDirection())
        camera = np.array(self.view.getCameraNode().position.getValue().getValue())
        self.assertGreater(-ahead @ centre / np.linalg.norm(centre), 0.99)
        off = (centre - camera) - ((centre - camera) @ ahead) * ahead
        self.assertLess(np.linalg.norm(off), 0.2)

    def test_faces_are_listed_and_light_up(self):
        obj = self.meshed(Part.makeCylinder(5, 20), chord_height=0.05)
        panel = self.open(obj)
        self.assertEqual(panel.faces.rowCount(), 3)
        counts = sum(int(panel.faces.item(i, 1).text().replace(",", "")) for i in range(3))
        self.assertEqual(counts, obj.Mesh.CountFacets)
        self.assertEqual({panel.faces.item(i, 0).text() for i in range(3)},
                         {"Face1", "Face2", "Face3"})
        panel.faces.selectRow(0)
        face = int(panel.faces.item(0, 0).text()[4:]) - 1
        self.assertTrue((panel.data.face[panel.lit] == face).all())
        self.assertEqual(panel.lit.sum(), (panel.data.face == face).sum())

    def test_a_mesh_without_cad(self):
        obj = self.document.addObject("Mesh::Feature", "Imported")
        obj.Mesh = Mesh.createSphere(5.0, 20)
        obj.Placement.Base = FreeCAD.Vector(100, 0, 0)
        panel = self.open(obj)
        self.assertNotIn(quality_data.DISTANCE, panel.data.measures)
        self.assertNotIn("Face", panel.worst.item(0).text())
        self.assertGreater(panel.data.corners[..., 0].min(), 94)

    def test_curved_elements(self):
        source = self.document.addObject("Part::Torus", "Torus")
        self.document.recompute()
        obj = mq.add_curved_mesh(source, order=2, volume=True)
        panel = self.open(obj)
        self.assertIs(panel.measure, quality_data.JACOBIAN)
        self.assertEqual(panel.data.elements, len(mq.CurvedMesh.of(obj).triangles))
        self.assertGreater(len(panel.data.corners), panel.data.elements)
        self.assertGreaterEqual(panel.values.min(), obj.MinScaledJacobian)
        curved = mq.CurvedMesh.of(obj)
        self.assertIn(f"{obj.Elements:,} tetrahedra: worst {obj.MinScaledJacobian:.4g}, mean "
                      f"{curved.tetrahedron_quality.mean():.4g}\n", panel.summary.text())
        at_surface = (curved.node_entity[curved.tetrahedra[:, :4]][:, :, 0] < 3).sum(axis=1) >= 3
        self.assertLess(panel.data.shown, obj.Elements)
        self.assertLessEqual(panel.data.shown, at_surface.sum())
        self.assertIn(f"Shown are the {panel.data.shown:,} at the surface: worst {panel.values.min():.4g}",
                      panel.summary.text())
        self.choose(panel, quality_data.DISTORTION)
        found = curved.shown_distortion()
        np.testing.assert_array_equal(panel.values, found)
        self.assertIn(f"{found.max():.4g}: element {found.argmax()} on Face1",
                      panel.worst.item(0).text())
        self.assertIn(f"tetrahedra: worst {obj.MaxShapeDistortion:.4g}", panel.summary.text())
        self.assertIn("A clipping plane shows the surface only", panel.summary.text())
        self.assertIn(f"surface: worst {found.max():.4g}", panel.summary.text())

    def test_means_are_those_of_the_properties(self):
        source = self.document.addObject("Part::Torus", "Torus")
        self.document.recompute()
        obj = mq.add_curved_mesh(source, order=2)
        panel = self.open(obj)
        self.assertEqual(panel.summary.text(), f"{obj.Elements:,} elements: worst {obj.MinScaledJacobian:.4g}, "
                                               f"mean {obj.MeanDistortion:.4g}")

    def test_folded_elements_are_the_worst_of_all(self):
        obj = self.meshed(Part.makeBox(3, 4, 5))
        panel = self.open(obj)
        values = np.full(panel.data.elements, 1.5)
        values[3] = np.inf
        measure = quality_data.DISTORTION
        scale = panel.data.scale(measure, values)
        panel._show(measure, quality_panel._Found(
            values, scale, None, values, np.zeros((len(values), 4)), None, quality_data.Histogram.of(values, scale),
            panel.data.faces(values, measure), measure.order(values)))
        self.assertIn("worst ∞, mean 1.5", panel.summary.text())
        self.assertTrue(panel.worst.item(0).text().startswith("∞: element 3 on Face"))
        self.assertEqual(panel.faces.item(0, 2).text(), "∞")
        self.assertEqual(panel.faces.item(0, 3).text(), "1.5")

    def test_an_empty_mesh_is_refused_with_its_name(self):
        obj = self.document.addObject("Mesh::Feature", "Empty")
        with self.assertRaisesRegex(mq.InvalidInput, "Empty has no triangles"):
            quality_panel.QualityPanel(obj)

    def test_closing_leaves_the_view_as_it_was(self):
        obj = self.meshed(Part.makeBox(3, 4, 5))
        graph = self.view.getSceneGraph()
        children = graph.getNumChildren()
        obj.Source.ViewObject.Visibility = True
        panel = self.open(obj)
        self.assertFalse(obj.ViewObject.Visibility or obj.Source.ViewObject.Visibility)
        self.assertEqual(graph.getNumChildren(), children + 1)
        panel.reject()
        self.assertTrue(obj.ViewObject.Visibility and obj.Source.ViewObject.Visibility)
        self.assertEqual(graph.getNumChildren(), children)
        self.assertFalse(FreeCADGui.Control.activeDialog())

    def test_other_meshes_of_the_part_are_hidden_meanwhile(self):
        obj = self.meshed(Part.makeBox(10, 10, 10))
        sibling = mq.add_curved_mesh(obj.Source)
        made = mq.add_improved_mesh(obj)
        stranger = self.document.addObject("Mesh::Feature", "Stranger")
        stranger.Mesh = Mesh.createSphere(1, 10)
        for shown in (obj, obj.Source, sibling, made):
            shown.ViewObject.Visibility = True
        for one in (obj, sibling, made):
            panel = self.open(one)
            self.assertEqual([o.Label for o in self.document.Objects if o.ViewObject.Visibility], ["Stranger"])
            panel.reject()
            self.assertTrue(all(o.ViewObject.Visibility for o in (obj, obj.Source, sibling, made)))

    def test_sources_in_a_group_of_links_are_hidden_meanwhile(self):
        box = self.document.addObject("Part::Box", "Box")
        self.document.recompute()
        link = self.document.addObject("App::Link", "Link")
        link.LinkedObject = box
        group = self.document.addObject("App::LinkGroup", "Group")
        group.ElementList = [link]
        self.document.recompute()
        self.assertEqual(group.isElementVisible(link.Name), 1)
        panel = self.open(mq.add_quality_mesh((group, "Link.")))
        self.assertEqual(group.isElementVisible(link.Name), 0)
        panel.reject()
        self.assertEqual(group.isElementVisible(link.Name), 1)

    def test_the_camera_never_flies_away_from_the_part(self):
        for perspective in (False, True):
            self.view.setCameraType("Perspective" if perspective else "Orthographic")
            panel = self.open(self.meshed(Part.makeBox(10, 10, 10)))  # triangles as large as the part
            self.view.viewAxonometric()
            self.view.fitAll()
            before = quality_scene._width_of(self.view.getCameraNode())
            panel.worst.setCurrentRow(0)
            self.until(lambda: not panel.scene.flight.active)
            self.assertLessEqual(quality_scene._width_of(self.view.getCameraNode()), 1.01 * max(before, 1.5 * 200 ** 0.5))
            panel.scene.fly_to(panel.data.corners[:1])
            self.view.getCameraNode().scaleHeight(100.0) if not perspective else None
            panel.scene.fly_to(panel.data.corners[:1])
            self.until(lambda: not panel.scene.flight.active)
            self.assertLessEqual(quality_scene._width_of(self.view.getCameraNode()), 1.51 * 300 ** 0.5)
            panel.reject()
        self.view.setCameraType("Orthographic")

    def test_a_mesh_through_a_link(self):
        """Is measured where the link stands, and hides nothing elsewhere."""
        obj = self.meshed(Part.makeSphere(5), chord_height=0.05)
        part = self.document.addObject("App::Part", "Home")
        part.addObject(obj)
        part.Placement.Base = FreeCAD.Vector(0, 0, 40)
        scan = self.document.addObject("Mesh::Feature", "Scan")
        scan.Mesh = obj.Mesh
        curved = mq.add_curved_mesh(obj.Source)
        FreeCADGui.activateWorkbench("MeshQualityWorkbench")
        for linked in (obj, scan, curved):
            link = self.document.addObject("App::Link", "Link")
            link.LinkedObject = linked
            link.Placement = FreeCAD.Placement(FreeCAD.Vector(100, 0, 0), FreeCAD.Rotation(10, 20, 30))
            holder = self.document.addObject("App::Part", "Holder")
            holder.addObject(link)
            holder.Placement.Base.y = 50
            outer = self.document.addObject("App::Link", "Outer")
            outer.LinkedObject = holder
            outer.Placement.Base.x = 300
            self.document.recompute()
            for source, picked, middle in ((link, (link,), (100, 50, 0)), ((outer, "Link."), (outer, f"{link.Name}."),
                                                                           (400, 0, 0))):
                with self.subTest(f"{linked.Name} by {source}"):
                    FreeCADGui.Selection.clearSelection()
                    FreeCADGui.Selection.addSelection(*picked)
                    self.assertTrue(commands.Analyse().IsActive())
                    source, = commands.Analyse().selected()
                    self.assertFalse(commands.Triangulate().IsActive())
                    self.assertEqual(commands.Improve().IsActive(), True)
                    self.assertTrue(commands.Export().IsActive())
                    linked.ViewObject.Visibility = True
                    panel = self.open(source)
                    shown = picked[0]
                    self.assertTrue(linked.ViewObject.Visibility)
                    self.assertFalse(shown.ViewObject.Visibility)
                    points = panel.data.corners.reshape(-1, 3)
                    np.testing.assert_allclose((points.min(axis=0) + points.max(axis=0)) / 2, middle, atol=0.1)
                    self.assertEqual(panel.data.curved, linked is curved)
                    if linked is obj:
                        self.choose(panel, quality_data.DISTANCE)
                        self.assertLess(panel.values.max(), 0.06)
                        self.assertEqual(panel.data.bound, 0.05)
                    panel.reject()
                    self.assertTrue(shown.ViewObject.Visibility)

    def test_all_that_a_mesh_was_made_of_is_hidden_meanwhile(self):
        boxes = [self.box("First"), self.box("Second")]
        boxes[1].Placement.Base = FreeCAD.Vector(4, 4, 4)
        self.document.recompute()
        mesh = mq.add_quality_mesh(boxes[0])
        both = mq.add_boolean(mesh, boxes[1], "union")
        better = mq.add_improved_mesh(both)
        shown, hidden = [boxes[0], boxes[1], both, better], [mesh]
        for obj in shown:
            obj.ViewObject.Visibility = True
        panel = self.open(better)
        self.assertFalse(any(obj.ViewObject.Visibility for obj in shown + hidden))
        panel.reject()
        self.assertTrue(all(obj.ViewObject.Visibility for obj in shown))
        self.assertFalse(any(obj.ViewObject.Visibility for obj in hidden))

    def test_the_hint_follows_the_measure(self):
        panel = self.open(self.meshed(Part.makeSphere(5), chord_height=0.05))
        first = panel.hint.text()
        panel.histogram.pick(int(panel.histogram.counts.argmax()))
        self.assertNotEqual(panel.hint.text(), first)
        self.choose(panel, quality_data.ASPECT)
        self.assertEqual(panel.hint.text(), first)
        self.assertEqual(panel.histogram.chosen, -1)

    def in_units(self, schema):
        before = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units").GetInt("UserSchema", 0)
        FreeCAD.Units.setSchema(schema)
        self.addCleanup(FreeCAD.Units.setSchema, before)

    def test_lengths_are_in_the_users_unit_with_all_their_digits(self):
        obj = self.meshed(Part.makeCylinder(5, 20), chord_height=0.05)
        for schema, unit, factor in ((0, "µm", 1e-3), (3, "in", 25.4), (7, "ft", 304.8), (5, "in", 25.4)):
            with self.subTest(schema):
                self.in_units(schema)
                panel = self.open(obj)
                self.choose(panel, quality_data.DISTANCE)
                worst = f"{panel.values.max() / factor:.4g}"
                self.assertGreater(float(worst), 0.0)
                self.assertIn(f"worst {worst} {unit}", panel.summary.text())
                self.assertTrue(panel.worst.item(0).text().startswith(f"{worst} {unit}: element"))
                self.assertEqual(panel.faces.horizontalHeaderItem(3).text(), f"Mean\n[{unit}]")
                self.assertEqual(panel.faces.item(0, 2).text(), f"{panel.values.max() / factor:.3g}")
                self.assertIn(f"more than the requested {0.05 / factor:.4g} {unit}", panel.meaning.text())
                self.assertIn(unit, panel.histogram.words(0))
                self.picture(f"quality_unit_{schema}")
                panel.reject()

    def test_red_is_beyond_the_bound_of_the_distance_only(self):
        obj = self.meshed(Part.makeCylinder(5, 20), chord_height=0.05)
        self.assertLessEqual(obj.MaxChordHeight.Value, 0.05)
        panel = self.open(obj)
        self.choose(panel, quality_data.DISTANCE)
        self.assertGreater(panel.values.max(), 0.03)
        self.assertGreaterEqual(panel.scale.goodness(panel.values).min(), 0.59)
        self.assertEqual(share_of(self.picture("quality_within")[:, :560], (200, 30, 30), 70), 0.0)
        panel.reject()
        obj.AskedChordHeight = 0.01
        panel = self.open(obj)
        self.choose(panel, quality_data.DISTANCE)
        red = panel.scale.goodness(panel.values) == 0.0
        np.testing.assert_array_equal(red, panel.values > 0.01)
        self.assertTrue(red.any() and not red.all())
        self.assertGreater(share_of(self.picture("quality_beyond")[:, :560], (200, 30, 30), 70), 0.05)

    def test_without_a_bound_the_largest_distance_is_red(self):
        obj = self.meshed(Part.makeCylinder(5, 20), chord_height=0.05)
        obj.AskedChordHeight = 0
        panel = self.open(obj)
        self.choose(panel, quality_data.DISTANCE)
        self.assertIsNone(panel.data.bound)
        self.assertEqual(panel.scale.goodness(panel.values)[panel.values.argmax()], 0.0)

    def legend_of(self, panel, background):
        """The pixels of the legend in a picture with this background."""
        left, low = panel.scene.legend.place_in(gui_helpers.WIDTH, gui_helpers.HEIGHT)
        width, high = panel.scene.legend.size
        rows = self.saved(f"quality_legend_{background}", background=background)
        return rows[gui_helpers.HEIGHT - low - high:gui_helpers.HEIGHT - low, left:left + width]

    def test_the_legend_is_legible_on_any_background(self):
        panel = self.open(self.meshed(Part.makeBox(3, 4, 5)))
        self.view.viewAxonometric()
        self.view.fitAll()
        gui_helpers.wait()
        counts = []
        for background in ("White", "Black"):
            found = self.legend_of(panel, background)
            plate, text = (found.min(axis=2) > 190), (found.max(axis=2) < 90)
            self.assertGreater(plate.mean(), 0.5)
            counts.append(text.sum())
        self.assertGreater(min(counts), 300)
        self.assertLess(max(counts), 1.5 * min(counts))

    def test_colours_are_seen_where_the_mesh_is_small_on_the_screen(self):
        panel = self.open(self.meshed(Part.makeSphere(5), max_edge=0.45))
        self.assertTrue(panel.edges.isChecked())
        self.assertGreater(panel.data.elements, 2500)
        near, camera = self.dark(self.picture("quality_near")), self.view.getCameraNode()
        camera.height.setValue(5.0 * camera.height.getValue())
        gui_helpers.wait()
        self.assertGreater(near, 0.1)
        self.assertLess(self.dark(self.saved("quality_far")), 0.02)

    def dark(self, pixels):
        """The share of the mesh, in the middle of the picture, that is as dark as edges are."""
        middle = pixels[:, 150:550]
        return (middle < 70).all(axis=2).sum() / (middle < 240).any(axis=2).sum()

    def test_a_clipping_plane_cuts_the_model_and_not_the_legend(self):
        panel = self.open(self.meshed(Part.makeBox(3, 4, 5)))
        self.view.viewAxonometric()
        self.view.fitAll()
        gui_helpers.wait()
        whole, model = self.legend_of(panel, "White"), self.saved("quality_unclipped")
        self.view.toggleClippingPlane(1, False, True, FreeCAD.Placement(FreeCAD.Vector(1.5, 2, 2.5), FreeCAD.Rotation()))
        self.addCleanup(lambda: self.view.hasClippingPlane() and self.view.toggleClippingPlane(0))
        clipped = self.legend_of(panel, "White")
        self.assertGreater((np.abs(self.saved("quality_clipped") - model).max(axis=2) > 60).sum(), 5000)
        np.testing.assert_array_equal(clipped, whole)

    def test_the_legend_is_low_in_a_low_view(self):
        panel = self.open(self.meshed(Part.makeBox(3, 4, 5)))
        heights = [len(legend.picture(panel.scale, height)) for height in (900, 600, 250, 100)]
        self.assertEqual(heights[0], heights[1])
        self.assertLess(heights[2], 0.65 * 250)
        self.assertGreater(heights[2], heights[3])

    def test_the_panel_is_legible_in_a_dark_theme(self):
        app = QtGui.QApplication.instance()
        self.addCleanup(app.setStyleSheet, app.styleSheet())
        app.setStyleSheet(gui_helpers.DARK)
        panel = self.open(self.meshed(Part.makeCylinder(5, 20), chord_height=0.05))
        panel.tabs.setCurrentIndex(1)
        gui_helpers.wait(0.3)
        self.screen_with(panel, "quality_dark_theme")
        panel.form.grab().save(f"{gui_helpers.PICTURES}/panel_quality_dark_theme.png")
        axis = gui_helpers.pixels_of(panel.histogram.grab().toImage())[-12:]
        self.assertGreater((axis.min(axis=2) > 150).sum(), 20)

    def area(self, before, after):
        """Where two pictures of the screen differ: left, top, right, bottom."""
        rows, columns = np.nonzero(np.abs(before - after).max(axis=2) > 12)
        self.assertGreater(len(rows), 500)
        return columns.min(), rows.min(), columns.max(), rows.max()

    def test_the_legend_never_lies_under_the_navigation_cube(self):
        parameters = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View")
        since_1_0 = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/NaviCube")
        for group in (parameters, since_1_0):
            self.addCleanup(group.RemInt, "CornerNaviCube")
        self.addCleanup(parameters.RemBool, "ShowNaviCube")
        window = FreeCADGui.getMainWindow()
        self.addCleanup(window.resize, window.size())
        self.addCleanup(window.move, window.pos())
        for size in ((1366, 768), (1366, 660)):
            window.resize(*size)
            for corner in range(4):
                with self.subTest(corner=corner, size=size):
                    for group in (parameters, since_1_0):
                        group.SetInt("CornerNaviCube", corner)
                    gui_helpers.wait(0.2)
                    panel = self.open(self.meshed(Part.makeBox(3, 4, 5)))
                    window.showNormal()
                    window.move(1400 - 1423, 0)  # the right side of the 3D view is on the screen
                    gui_helpers.wait_until_still()  # while the window moves, all of the pictures differ
                    both = self.screen_with(panel, f"quality_cube_{corner}_{size[1]}")
                    panel.scene.legend.show(np.zeros((0, 0, 4), dtype=np.uint8), 0, 0)
                    cube_alone = self.screen_with(panel)
                    parameters.SetBool("ShowNaviCube", False)
                    gui_helpers.wait(0.2)
                    none = self.screen_with(panel)
                    parameters.SetBool("ShowNaviCube", True)
                    panel.reject()
                    legend_at, cube_at = self.area(both, cube_alone), self.area(cube_alone, none)
                    apart = legend_at[0] > cube_at[2] or legend_at[2] < cube_at[0] \
                        or legend_at[1] > cube_at[3] or legend_at[3] < cube_at[1]
                    self.assertTrue(apart, (legend_at, cube_at))

    def screen_with(self, panel, name=None):
        self.view.redraw()
        gui_helpers.wait(0.3)
        image = gui_helpers.screen()
        if name:
            image.save(f"{gui_helpers.PICTURES}/{name}.png")
        return gui_helpers.pixels_of(image)

    def test_no_column_of_the_faces_is_cut_off(self):
        obj = self.meshed(Part.makeCylinder(5, 20), chord_height=0.05)
        self.in_units(3)
        panel = self.open(obj)
        panel.form.setFixedWidth(260)
        panel.tabs.setCurrentIndex(1)
        for measure in panel.data.measures:
            self.choose(panel, measure)
            gui_helpers.wait(0.1)
            table = panel.faces
            panel.form.grab().save(f"{gui_helpers.PICTURES}/panel_faces_{panel.data.measures.index(measure)}.png")
            self.assertLessEqual(table.horizontalHeader().length(), table.viewport().width())
            for column in range(4):
                width = table.columnWidth(column)
                texts = [table.item(row, column).text() for row in range(table.rowCount())]
                for text in texts:
                    self.assertLessEqual(table.fontMetrics().horizontalAdvance(text), width - 4, text)
                for line in table.horizontalHeaderItem(column).text().splitlines():
                    self.assertLessEqual(table.fontMetrics().horizontalAdvance(line), width - 4, line)

    def test_one_list_is_seen_at_a_time(self):
        panel = self.open(self.meshed(Part.makeCylinder(5, 20)))
        for i, seen in ((0, panel.worst), (1, panel.faces)):
            panel.tabs.setCurrentIndex(i)
            for measure in panel.data.measures[:2]:
                self.choose(panel, measure)
                self.assertEqual([page for page in (panel.worst, panel.faces) if page.isVisible()], [seen])

    def test_object_or_document_deleted_meanwhile(self):
        panel = self.open(self.meshed(Part.makeBox(3, 4, 5)))
        self.document.removeObject(panel.obj.Name)
        self.until(lambda: not FreeCADGui.Control.activeDialog())
        self.assertTrue(panel.ended)
        document = FreeCAD.newDocument("Other")
        obj = document.addObject("Mesh::Feature", "Imported")
        obj.Mesh = Mesh.createSphere(5.0, 20)
        gui_helpers.wait()
        panel = self.open(obj)
        FreeCAD.closeDocument("Other")
        self.until(lambda: not FreeCADGui.Control.activeDialog())
        self.assertTrue(panel.ended)

    def test_an_improved_mesh_has_no_shape_to_measure_against(self):
        source = self.document.addObject("Mesh::Feature", "Imported")
        source.Mesh = Mesh.createCylinder(2.0, 10.0, True, 5.0, 30)
        panel = self.open(mq.add_improved_mesh(source))
        self.assertNotIn(quality_data.DISTANCE, panel.data.measures)
        self.assertGreaterEqual(panel.values.min(), 25)

    def big_torus(self):
        """A mesh of a quarter of a million triangles, half of them squeezed."""
        u, v = np.meshgrid(np.linspace(0, 2 * np.pi, 500, endpoint=False),
                           np.linspace(0, 2 * np.pi, 250, endpoint=False) ** 1.5 / (2 * np.pi) ** 0.5,
                           indexing="ij")
        points = np.stack(((20 + 8 * np.cos(v)) * np.cos(u), (20 + 8 * np.cos(v)) * np.sin(u),
                           8 * np.sin(v)), axis=-1).reshape(-1, 3)
        i, k = np.meshgrid(np.arange(500), np.arange(250), indexing="ij")
        a, b, c, d = (((i + m) % 500 * 250 + (k + n) % 250).ravel()
                      for m, n in ((0, 0), (1, 0), (1, 1), (0, 1)))
        triangles = np.concatenate((np.stack((a, b, c), 1), np.stack((a, c, d), 1)))
        obj = self.document.addObject("Mesh::Feature", "Big")
        obj.Mesh = convert.mesh_of_surface(convert.surface_of_arrays(extension(), points, triangles,
                                                                     measured=False))
        return obj

    def test_big_meshes_are_drawn_coarsely_while_the_camera_moves(self):
        with mock.patch.object(quality_scene, "_SLOW", 0.0):
            panel = self.open(self.big_torus())
            self.assertLess(len(panel.data.coarse), 0.5 * panel.data.elements)
            self.view.viewAxonometric()
            self.view.fitAll()
            gui_helpers.wait(0.6)
            drawn = panel.scene.scene._switch.whichChild
            self.assertEqual(drawn.getValue(), 0)
            fine = self.saved("quality_fine")
            self.until(lambda: panel.scene.scene.drawing_seconds > 0.0)
            camera = self.view.getCameraNode()
            camera.position.setValue(camera.position.getValue() * 1.0001)
            self.until(lambda: drawn.getValue() == 1)
            coarse = self.saved("quality_coarse")
            self.until(lambda: drawn.getValue() == 0)
        # From afar they look alike.
        self.assertFalse(panel.edges.isChecked() or panel.data.has_lines)
        panel.edges.setChecked(True)
        self.until(lambda: panel.data.has_lines)
        detail = panel.scene.scene._switch.getChild(0).getChild(2).getPart("contents", False).getChild(0)
        self.until(lambda: detail.getChild(0).getChild(2).coordIndex.getNum() == len(panel.data.lines[1]))
        self.assertGreater(np.abs(fine - coarse).max(), 0)
        self.assertLess(np.abs(fine - coarse).mean(), 2)

    def test_small_meshes_have_no_coarse_triangles(self):
        panel = self.open(self.meshed(Part.makeBox(3, 4, 5)))
        self.assertIsNone(panel.data.coarse)
        panel.scene.scene.moving(True)
        self.assertEqual(panel.scene.scene._switch.whichChild.getValue(), 0)
