# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user sees on a small screen: messages and progress in sight, meshes in the place of their
sources, work that goes on without its panel.
"""

import importlib.util
import os
from unittest import mock

import FreeCAD
import FreeCADGui
import gui_helpers
import Mesh
import Part
from PySide import QtCore, QtGui

import MeshQuality as mq
from MeshQuality.features import quality_mesh
from MeshQuality.gui import background, commands, jobs, visibility, triangle_estimate
from MeshQuality.gui.panels import export_panel, quality_panel
from MeshQuality.gui.view import badge


def in_sight(widget):
    """Whether all of a widget lies within what its task view shows."""
    areas = [area for area in FreeCADGui.getMainWindow().findChildren(QtGui.QScrollArea)
             if area.isAncestorOf(widget)]
    for area in areas:
        top = widget.mapTo(area.viewport(), QtCore.QPoint(0, 0))
        shown = area.viewport().rect()
        if not shown.contains(top) or not shown.contains(top + QtCore.QPoint(0, widget.height() - 1)):
            return False
    return bool(areas) and widget.isVisible() and widget.height() > 0


class SmallScreen(gui_helpers.PanelTest):
    def setUp(self):
        super().setUp()
        window = FreeCADGui.getMainWindow()
        before = window.size()
        window.resize(1366, 768)
        self.addCleanup(window.resize, before)
        gui_helpers.wait(0.2)

    def shot(self, name):
        """A picture of the screen."""
        gui_helpers.wait(0.2)
        gui_helpers.screen().save(os.path.join(gui_helpers.PICTURES, f"{name}.png"))

    def scrolled_down(self, panel):
        """Opens all options and scrolls to the last one."""
        gui_helpers.unfold(panel)
        gui_helpers.wait(0.2)
        bars = [area.verticalScrollBar() for area in FreeCADGui.getMainWindow().findChildren(QtGui.QScrollArea)
                if area.isAncestorOf(panel.options)]
        self.until(lambda: any(bar.maximum() > 0 for bar in bars))
        for bar in bars:
            bar.setValue(bar.maximum())
        gui_helpers.wait(0.1)

    def test_the_estimate_is_in_sight_at_once(self):
        panel = self.panel(commands.Triangulate, self.box())
        self.until(lambda: "Counting" not in panel.estimate.text())
        self.assertTrue(in_sight(panel.estimate))
        self.assertTrue(in_sight(panel.button))
        self.shot("window_estimate")

    def test_an_error_after_ok_comes_into_sight(self):
        panel = self.panel(commands.Triangulate, self.box())
        panel.options.set_values({"min_angle": 50.0})
        self.scrolled_down(panel)
        panel.accept()
        gui_helpers.wait(0.2)
        self.assertIn("Smallest angle", panel.said)
        self.assertTrue(in_sight(panel.message))
        self.assertEqual(panel.estimate.text(), "")
        self.shot("window_error")

    def test_an_error_of_the_estimate_leaves_the_options_where_they_are(self):
        panel = self.panel(commands.Triangulate, self.box())
        panel.options.set_values({"min_angle": 50.0})
        self.scrolled_down(panel)
        place = panel.lowest.verticalScrollBar().value()
        self.until(lambda: "Smallest angle" in panel.said)
        gui_helpers.wait(0.2)
        self.assertEqual(panel.lowest.verticalScrollBar().value(), place)

    def test_a_failure_comes_into_sight(self):
        source = self.document.addObject("Part::Feature", "Empty")
        panel = self.panel(commands.Triangulate, source)
        self.until(lambda: "Empty" in panel.said)
        self.scrolled_down(panel)
        self.finish(panel)
        gui_helpers.wait(0.2)
        self.assertIn("Empty", panel.said)
        self.assertTrue(in_sight(panel.message))

    def test_progress_comes_into_sight(self):
        for dark in (False, True):
            if dark:
                before = QtGui.QApplication.instance().styleSheet()
                self.addCleanup(QtGui.QApplication.instance().setStyleSheet, before)
                QtGui.QApplication.instance().setStyleSheet(gui_helpers.DARK)
            panel = self.panel(commands.Triangulate, self.box())
            panel.options.set_values({"max_edge": 0.01})
            self.scrolled_down(panel)
            panel.accept()
            self.until(lambda: in_sight(panel.bar) and panel.bar.value() > 0)
            self.assertTrue(in_sight(panel.leave))
            self.assertFalse(panel.button.isVisible())
            self.shot(f"window_progress_{'dark' if dark else 'light'}")
            panel.reject()
            self.until(lambda: not panel.jobs)
            self.assertFalse(panel.leave.isVisible())
            self.assertTrue(in_sight(panel.message))
            panel.reject()

    def test_errors_of_the_export_come_into_sight(self):
        panel = export_panel.ExportPanel(mq.add_curved_mesh(self.box()))
        FreeCADGui.Control.showDialog(panel)
        panel.path.setProperty("fileName", "")
        panel.accept()
        gui_helpers.wait(0.2)
        self.assertIn("Choose a file", panel.said)
        self.assertTrue(in_sight(panel.message))
        self.shot("window_export")

    def test_every_panel_shows_the_icon_of_its_command(self):
        sources = self.two_boxes()
        curved = mq.add_curved_mesh(sources[0])
        for source in sources:
            source.ViewObject.Visibility = True
        for command in (commands.Triangulate, commands.Curve, commands.Boolean):
            panel = self.panel(command, *sources)
            self.check_icon(panel, command.NAME)
            panel.reject()
        self.check_icon(commands.panel_of(curved), commands.Curve.NAME)
        self.check_icon(export_panel.ExportPanel(curved), commands.Export.NAME)
        panel = quality_panel.open_panel(curved)
        self.check_icon(panel, commands.Analyse.NAME)
        panel.reject()

    def check_icon(self, panel, name):
        wanted = QtGui.QIcon(badge.path_of(name)).pixmap(64)
        self.assertEqual(panel.form.windowIcon().pixmap(64).toImage(), wanted.toImage(), name)

    def test_only_what_opens_a_panel_has_an_ellipsis(self):
        for command in commands._COMMANDS:
            text = command().GetResources()["MenuText"]
            self.assertEqual(text.endswith("..."), command.__name__ not in ("Quick", "Update", "CfdSurface"), text)


class InPlaceOfSources(gui_helpers.PanelTest):
    def visible(self, *objects):
        return [obj.ViewObject.Visibility for obj in objects]

    def test_a_mesh_with_edges_takes_the_place_of_its_sources(self):
        first, second = self.two_boxes()
        for command, sources in ((commands.Triangulate, [first]), (commands.Curve, [first]),
                                 (commands.Boolean, [first, second])):
            with self.subTest(command.NAME):
                self.finish(self.panel(command, *sources))
                obj = self.document.Objects[-1]
                name = obj.Name
                self.assertEqual(self.visible(*sources), [False] * len(sources))
                self.assertTrue(obj.ViewObject.Visibility)
                self.assertIn(obj.ViewObject.DisplayMode, ("Flat Lines", "Curved"))
                for _ in range(2):
                    self.document.undo()
                    self.assertEqual(self.visible(first, second), [True, True])
                    self.document.redo()
                    obj = self.document.getObject(name)
                    self.assertEqual(self.visible(*sources), [False] * len(sources))
                    self.assertTrue(obj.ViewObject.Visibility)
                    self.assertIn(obj.ViewObject.DisplayMode, ("Flat Lines", "Curved"))
                self.document.undo()

    def test_a_better_mesh_takes_the_place_of_the_one_before(self):
        source = self.document.addObject("Mesh::Feature", "Imported")
        source.Mesh = Mesh.createCylinder(2.0, 10.0, True, 5.0, 30)
        self.finish(self.panel(commands.Improve, source))
        self.assertEqual(self.visible(source, self.document.Objects[-1]), [False, True])
        self.document.undo()
        self.assertEqual(self.visible(source), [True])

    def test_what_is_in_a_container_is_hidden_and_not_the_container(self):
        box, other = self.two_boxes()
        part = self.document.addObject("App::Part", "Assembly")
        part.addObject(box)
        part.addObject(other)
        self.document.recompute()
        mq.add_quality_mesh(box)
        self.assertEqual(self.visible(part, box, other), [True, False, True])

    def test_a_second_mesh_of_a_part_is_not_drawn_through_the_first(self):
        box, other = self.two_boxes()
        first, apart = mq.add_quality_mesh(box), mq.add_quality_mesh(other)
        second = mq.add_inspection(box)
        self.assertEqual(self.visible(box, first, second, apart), [False, False, True, True])
        self.document.undo()
        self.assertEqual(self.visible(box, first, apart), [False, True, True])
        both = mq.add_boolean(box, other)
        self.assertEqual(self.visible(first, apart, both), [False, False, True])

    def test_edges_are_seen(self):
        obj = mq.add_quality_mesh(self.box(), max_edge=4.0)
        gui_helpers.wait(0.2)
        lines = (self.picture("window_flat_lines") < 60).all(axis=2).mean()
        obj.ViewObject.DisplayMode = "Shaded"
        self.assertGreater(lines, (self.picture("window_shaded") < 60).all(axis=2).mean() + 0.01)

    def test_many_triangles_are_drawn_without_edges(self):
        with mock.patch.object(visibility, "MOST_WITH_EDGES", 11):
            obj = mq.add_quality_mesh(self.box())
        self.assertEqual(obj.ViewObject.DisplayMode, "Shaded")

    def test_edges_go_where_the_mesh_is_small_on_the_screen(self):
        """Of 3,000 triangles on 100 pixels only the faces are seen, and both from near."""
        ball = self.document.addObject("Part::Sphere", "Ball")
        self.document.recompute()
        meshes = [mq.add_quality_mesh(ball, max_edge=0.4), mq.add_curved_mesh(ball, max_edge=0.4)]
        if importlib.util.find_spec("Fem"):
            meshes.append(mq.add_fem_mesh(ball, max_edge=0.8))
        FreeCADGui.Selection.clearSelection()
        for obj in (ball, *meshes):
            obj.ViewObject.Visibility = False
        for obj in meshes:
            with self.subTest(obj.Label):
                obj.ViewObject.Visibility = True
                near = self.black(self.picture(f"window_near_{obj.Name}"))
                camera = self.view.getCameraNode()
                camera.height.setValue(5.0 * camera.height.getValue())
                gui_helpers.wait()
                far = self.black(self.saved(f"window_far_{obj.Name}"))
                self.assertGreater(near, 0.1)
                self.assertLess(far, 0.1)
                obj.ViewObject.Visibility = False

    def black(self, pixels):
        """The share of the mesh that is black."""
        return (pixels < 60).all(axis=2).sum() / (pixels < 240).any(axis=2).sum()

    def test_a_fine_mesh_is_no_black_ball(self):
        ball = self.document.addObject("Part::Sphere", "Ball")
        self.document.recompute()
        obj = mq.add_quality_mesh(ball, max_edge=0.12)
        self.assertGreater(obj.Mesh.CountFacets, 10_000)
        FreeCADGui.Selection.clearSelection()
        for mode in ("Flat Lines", "Shaded"):  # also with edges, which would be too close to each other here
            obj.ViewObject.DisplayMode = mode
            self.assertLess(self.black(self.picture(f"window_fine_ball_{mode.split()[0]}")), 0.1)
        for edge, mode in ((1.0, "Flat Lines"), (0.12, "Shaded")):
            mq.update(obj, max_edge=edge)
            self.assertEqual(obj.ViewObject.DisplayMode, mode)
        obj.ViewObject.DisplayMode = "Wireframe"  # what is chosen stays
        mq.update(obj, max_edge=1.0)
        self.assertEqual(obj.ViewObject.DisplayMode, "Wireframe")

    def test_failure_and_cancel_hide_nothing(self):
        box = self.box()
        panel = self.panel(commands.Triangulate, box)
        panel.options.set_values({"max_edge": 0.01})
        panel.accept()
        self.until(lambda: panel.jobs[0].fraction > 0)
        panel.reject()
        self.until(lambda: not panel.jobs)
        self.assertEqual(self.visible(box), [True])
        with self.assertRaises(mq.Error):
            mq.add_quality_mesh(box, local_sizes={"Face99": 1.0})
        with mock.patch.object(quality_mesh.QualityMesh, "take", side_effect=mq.GeometryError("no luck")), \
                self.assertRaises(mq.GeometryError):
            mq.add_quality_mesh(box)
        self.assertEqual(self.visible(box), [True])
        self.assertEqual(self.document.Objects, [box])

    def test_deleting_the_mesh_shows_its_sources_again(self):
        sources = self.two_boxes()
        both = mq.add_boolean(*sources, "union")
        self.select(both)
        FreeCADGui.runCommand("Std_Delete")
        gui_helpers.wait(0.2)
        self.assertEqual(self.document.Objects, list(sources))
        self.assertEqual(self.visible(*sources), [True, True])
        self.document.undo()
        self.assertEqual(self.visible(*sources), [False, False])

    def test_so_does_a_script_that_deletes_it(self):
        for add in (mq.add_quality_mesh, mq.add_curved_mesh):
            box = self.box()
            obj = add(box)
            self.assertEqual(self.visible(box), [False])
            self.document.openTransaction("Delete")
            self.document.removeObject(obj.Name)
            self.document.commitTransaction()
            self.assertEqual(self.visible(box), [True])
            self.document.undo()
            self.assertEqual(self.visible(box), [False])
            self.document.redo()
            self.assertEqual(self.visible(box), [True])
        sources = self.two_boxes()
        both = mq.add_boolean(*sources, "union")
        self.document.removeObject(both.Name)
        self.assertEqual(self.visible(*sources), [True, True])
        again = mq.add_boolean(*sources, "union")
        self.document.removeObject(sources[0].Name)
        self.document.removeObject(again.Name)
        self.assertEqual(self.visible(sources[1]), [True])

    def test_of_a_document_that_was_opened(self):
        name = mq.add_quality_mesh(self.box()).Name
        self.reopen()
        box = self.document.Box
        self.assertEqual(self.visible(box), [False])
        self.document.removeObject(name)
        self.assertEqual(self.visible(box), [True])

    def test_editing_leaves_it_to_the_user_what_is_seen(self):
        box = self.box()
        obj = mq.add_quality_mesh(box)
        box.ViewObject.Visibility, obj.ViewObject.DisplayMode = True, "Wireframe"
        mq.update(obj, max_edge=2.0)
        self.assertEqual(self.visible(box, obj), [True, True])
        self.assertEqual(obj.ViewObject.DisplayMode, "Wireframe")

    def test_display_comes_back_from_a_file(self):
        box = self.box()
        obj = mq.add_quality_mesh(box)
        names = box.Name, obj.Name
        self.reopen()
        gui_helpers.wait(0.2)
        box, obj = map(self.document.getObject, names)
        self.assertEqual(self.visible(box, obj), [False, True])
        self.assertEqual(obj.ViewObject.DisplayMode, "Flat Lines")

    def test_show_where_leaves_all_as_it_was(self):
        wedge = self.document.addObject("Part::Feature", "Wedge")
        corners = [FreeCAD.Vector(*p) for p in ((0, 0, 0), (10, 0, 0), (10, 0.8, 0), (0, 0, 0))]
        wedge.Shape = Part.Face(Part.makePolygon(corners)).extrude(FreeCAD.Vector(0, 0, 3))
        self.document.recompute()
        obj = mq.add_quality_mesh(wedge)
        self.assertTrue(obj.CertificateFaces)
        self.select(wedge)
        panel = commands.panel_of(obj)
        FreeCADGui.Control.showDialog(panel)
        panel.certificate.button.click()
        self.assertTrue(wedge.ViewObject.Visibility)
        self.assertEqual(len(FreeCADGui.Selection.getSelectionEx()[0].SubElementNames), len(obj.CertificateFaces))
        panel.reject()
        self.assertFalse(wedge.ViewObject.Visibility)
        self.assertEqual(FreeCADGui.Selection.getSelection(), [wedge])
        self.assertFalse(FreeCADGui.Selection.getSelectionEx()[0].SubElementNames)
        self.assertEqual(obj.ViewObject.DisplayMode, "Flat Lines")


class Background(gui_helpers.PanelTest):
    def begin(self, source, command=commands.Triangulate, **values):
        """A panel whose work goes on without it; the job."""
        panel = self.panel(command, source)
        panel.options.set_values(values)
        panel.accept()
        job = panel.jobs[0]
        self.until(lambda: job.state == jobs.RUNNING)
        self.assertTrue(panel.leave.isVisible())
        panel.leave.click()
        self.until(lambda: not FreeCADGui.Control.activeDialog())
        return job

    def test_the_work_goes_on_without_its_panel(self):
        box = self.box()
        job = self.begin(box, max_edge=0.1)
        self.assertTrue(job.active)
        indicator = background.indicator()
        self.until(indicator.isVisible)
        self.assertIn("Quality mesh: ", indicator.text.text())
        gui_helpers.screen().save(os.path.join(gui_helpers.PICTURES, "window_background.png"))
        # Another panel can be used meanwhile.
        other = self.panel(commands.Triangulate, box)
        self.until(lambda: "when other work has finished" in other.estimate.text())
        other.reject()
        self.until(lambda: not job.active)
        self.assertEqual(job.state, jobs.DONE)
        obj = self.document.Objects[-1]
        self.assertEqual((obj.Source, obj.MaxEdge.Value), (box, 0.1))
        self.assertFalse(box.ViewObject.Visibility)
        self.assertFalse(indicator.isVisible())
        self.assertEqual(self.document.UndoNames[0], commands.Triangulate.TEXT)
        self.document.undo()
        self.assertEqual(self.document.Objects, [box])
        self.assertTrue(box.ViewObject.Visibility)

    def test_the_status_bar_can_cancel_it(self):
        box = self.box()
        job = self.begin(box, max_edge=0.01)
        indicator = background.indicator()
        self.until(indicator.isVisible)
        indicator.button.click()
        self.until(lambda: job.over)  # on a busy machine its work ends after the job
        self.assertEqual(job.state, jobs.CANCELLED)
        self.assertEqual(self.document.Objects, [box])
        self.assertFalse(self.document.HasPendingTransaction)
        self.assertFalse(indicator.isVisible())
        self.assertIn("cancelled", FreeCADGui.getMainWindow().statusBar().currentMessage())

    def test_a_failure_is_told_in_the_report_view_and_opens_nothing(self):
        errors, box = [], self.box()
        with mock.patch.object(FreeCAD.Console, "PrintError", errors.append), \
                mock.patch.object(quality_mesh.QualityMesh, "take", side_effect=mq.GeometryError("no luck")):
            job = self.begin(box, max_edge=0.3)
            self.until(lambda: not job.active)
        self.assertEqual(job.state, jobs.FAILED)
        self.assertTrue(any("no luck" in error for error in errors), errors)
        self.assertFalse(FreeCADGui.Control.activeDialog())
        self.assertEqual(self.document.Objects, [box])
        self.assertTrue(box.ViewObject.Visibility)

    def test_it_does_not_land_within_the_step_of_another_task(self):
        box = self.box()
        job = self.begin(box, max_edge=0.3)
        other = self.panel(commands.Curve, box)
        self.document.openTransaction("Another task")
        box.Label = "Renamed"
        self.until(lambda: job.held_up)
        self.assertIn("until the open task is closed", background.indicator().text.text())
        self.assertEqual(self.document.Objects, [box])
        self.document.abortTransaction()
        other.reject()
        self.until(lambda: not job.active)
        self.assertEqual((job.state, box.Label), (jobs.DONE, "Box"))
        self.assertEqual(len(self.document.Objects), 2)

    def test_a_document_closed_meanwhile_ends_it(self):
        other = FreeCAD.newDocument("Other")
        source = other.addObject("Part::Box", "Box")
        other.recompute()
        job = self.begin(source, max_edge=0.01)
        FreeCAD.closeDocument("Other")
        self.until(lambda: job.over)
        self.assertEqual(job.state, jobs.CANCELLED)
        self.assertFalse(background.indicator().isVisible())

    def test_an_object_that_is_edited_gets_its_mesh(self):
        obj = mq.add_quality_mesh(self.box())
        few, panel = obj.Triangles, commands.panel_of(obj)
        FreeCADGui.Control.showDialog(panel)
        panel.options.set_values({"max_edge": 0.3})
        panel.accept()
        job = panel.jobs[0]
        panel.leave.click()
        self.until(lambda: not FreeCADGui.Control.activeDialog() and not job.active)
        self.assertGreater(obj.Triangles, few)
        self.assertEqual(obj.Status, "up to date")


class Estimates(gui_helpers.PanelTest):
    def test_ok_takes_what_the_estimate_has_computed(self):
        box = self.box()
        panel = self.panel(commands.Triangulate, box)
        self.until(lambda: "Counting" not in panel.estimate.text())
        with mock.patch.object(quality_mesh, "triangulate", side_effect=AssertionError("meshed again")):
            self.finish(panel)
        obj = self.document.Objects[-1]
        values = panel.operations[0].values()
        again = mq.triangulate(box, **{name: value for name, value in values.items()}).to_mesh()
        self.assertEqual(obj.Mesh.Topology, again.Topology)
        # What it remembers is what it would remember otherwise.
        box.Height = 11
        self.document.recompute()
        self.assertGreater(obj.ReusedFaces, 0)

    def test_not_where_the_source_has_changed_since(self):
        box = self.box()
        panel = self.panel(commands.Triangulate, box)
        self.until(lambda: "Counting" not in panel.estimate.text())
        box.Height = 20
        self.document.recompute()
        self.finish(panel)
        self.assertAlmostEqual(self.document.Objects[-1].Mesh.BoundBox.ZLength, 20)

    def test_a_round_number_where_there_are_more(self):
        with mock.patch.object(triangle_estimate, "_MOMENT", 0.0), mock.patch.object(triangle_estimate, "_LIMIT", 5000):
            panel = self.panel(commands.Triangulate, self.box())
            panel.options.set_values({"max_edge": 0.1})
            self.until(lambda: "Counting" not in panel.estimate.text())
            self.assertEqual(panel.estimate.text(), "More than 5,000 triangles")
            panel.options.set_values({"max_edge": None})
            self.until(lambda: "More" not in panel.estimate.text() and "Counting" not in panel.estimate.text())
            shown = int(panel.estimate.text().split()[0].replace(",", ""))
            self.finish(panel)
            self.assertEqual(self.document.Objects[-1].Triangles, shown)
