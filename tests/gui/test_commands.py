# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the workbench, from selection over the panel to the result."""

from unittest import mock

import FreeCAD
import FreeCADGui
import gui_helpers
import Mesh
from PySide import QtCore, QtGui

import MeshQuality as mq
from MeshQuality.gui import commands, jobs
from MeshQuality.gui.panels import quality_panel
from MeshQuality.gui.panels.case_panel import CasePanel
from MeshQuality.gui.panels.export_panel import ExportPanel
from MeshQuality.gui.panels.patches_panel import PatchesPanel
from MeshQuality.gui.panels.quality_panel import QualityPanel

ALL = (commands.Triangulate, commands.Curve, commands.Boolean)


class Commands(gui_helpers.PanelTest):
    def test_each_makes_an_object_and_undoes_it_in_one_step(self):
        sources = self.two_boxes()
        for command in ALL:
            with self.subTest(command.NAME):
                panel = self.panel(command, *(sources if command is commands.Boolean
                                              else sources[:1]))
                self.finish(panel)
                self.assertEqual(panel.said, "")
                self.assertFalse(FreeCADGui.Control.activeDialog())
                obj = self.document.Objects[-1]
                self.assertGreater(obj.Mesh.CountFacets, 0)
                self.assertTrue(obj.Fingerprint)
                self.assertEqual(self.document.UndoNames[0], command.TEXT)
                self.document.undo()
                self.assertEqual(self.document.Objects, list(sources))

    def test_options_of_the_panel_reach_the_object(self):
        box = self.box()
        panel = self.panel(commands.Triangulate, box)
        panel.options.set_values({"min_angle": 30.0, "max_edge": 2.5, "method": "star"})
        self.finish(panel)
        obj = self.document.Objects[-1]
        self.assertEqual((obj.MinAngle.Value, obj.MaxEdge.Value, obj.Method), (30.0, 2.5, "star"))
        self.assertGreaterEqual(obj.MeasuredMinAngle.Value, 30.0 - 1e-6)

    def test_several_selected_objects_get_a_mesh_each(self):
        sources = self.two_boxes()
        self.finish(self.panel(commands.Triangulate, *sources))
        self.assertEqual([obj.Source for obj in self.document.Objects[2:]], list(sources))

    def test_planes_and_axes_of_a_container_are_for_none(self):
        part = self.document.addObject("App::Part", "Assembly")
        self.document.recompute()
        self.select(part.Origin)
        for command in (commands.Triangulate, commands.Curve, commands.Inspect, commands.Hollow):
            self.assertFalse(command().IsActive(), command.NAME)

    def test_what_is_no_mesh_is_for_none(self):
        sheet = self.document.addObject("Spreadsheet::Sheet", "Sheet")
        link = self.document.addObject("App::Link", "Broken")
        for obj in (sheet, link):
            self.select(obj)
            for command in (commands.Analyse, commands.Improve, commands.Export, commands.Update):
                self.assertFalse(command().IsActive(), (obj.Name, command.NAME))
        with self.assertRaisesRegex(mq.InvalidInput, "'Sheet' is no mesh of MeshQuality"):
            mq.update(sheet)

    def test_operands_have_the_letters_of_messages(self):
        first, second = self.two_boxes()
        panel = self.panel(commands.Boolean, first, second)
        texts = [label.text() for label in panel.form.findChildren(QtGui.QLabel)]
        self.assertIn(f"Operands: A = {first.Label}, B = {second.Label}", texts)
        panel.reject()

    def test_operands_can_be_swapped_before_and_after(self):
        first, second = self.two_boxes()
        second.Length = 5  # half of it is in the first one at most
        self.document.recompute()
        panel = self.panel(commands.Boolean, first, second)
        panel.options.set_values({"operation": "difference"})
        panel.swap.click()
        self.finish(panel)
        obj = self.document.Objects[-1]
        self.assertEqual((obj.Sources, obj.Label), ([second, first], f"{second.Label} difference"))
        volume = obj.Volume.Value
        panel = self.edit(obj)
        panel.swap.click()
        texts = [label.text() for label in panel.form.findChildren(QtGui.QLabel)]
        self.assertIn(f"Operands: A = {first.Label}, B = {second.Label}", texts)
        self.narrow(panel, "panel_swap")
        self.finish(panel)
        self.assertEqual(panel.said, "")
        self.assertEqual((obj.Sources, obj.Label, obj.Status), ([first, second], f"{first.Label} difference", "up to date"))
        self.assertNotAlmostEqual(obj.Volume.Value, volume)
        self.assertAlmostEqual(obj.Volume.Value, first.Shape.cut(second.Shape).Volume, delta=0.01)
        self.document.undo()
        self.assertEqual((obj.Sources, obj.Volume.Value), ([second, first], volume))
        self.finish(self.panel(commands.Triangulate, first))  # one source has no order
        panel = self.panel(commands.Wrap, first, second)
        self.assertFalse(panel.swap.isVisible())
        panel.reject()

    def test_lengths_have_room_in_a_narrow_panel(self):
        source = self.document.addObject("Mesh::Feature", "Scan")
        source.Mesh = Mesh.createSphere(5.0, 20)
        panel = self.panel(commands.Improve, source)
        self.narrow(panel, "panel_improve_narrow")
        for name in ("min_angle", "tolerance", "feature_angle"):
            box = panel.options.field(name)
            text = box.lineEdit().text() if hasattr(box, "lineEdit") else box.text()
            self.assertGreater(box.width(), box.fontMetrics().boundingRect(text).width() + 25, name)
        panel.reject()

    def test_the_estimate_is_the_number_of_triangles(self):
        panel = self.panel(commands.Triangulate, self.box())
        self.until(lambda: "triangles" in panel.estimate.text()
                   and "Counting" not in panel.estimate.text())
        shown = int(panel.estimate.text().split()[0].replace(",", ""))
        self.finish(panel)
        self.assertEqual(self.document.Objects[-1].Triangles, shown)

    def test_a_value_out_of_range_is_said_in_the_panel(self):
        box = self.box()
        panel = self.panel(commands.Triangulate, box)
        panel.options.set_values({"min_angle": 50.0})
        panel.accept()
        self.assertIn("Smallest angle", panel.said)
        self.assertEqual(self.document.Objects, [box])
        self.assertTrue(panel.reject())

    def test_a_failure_leaves_nothing_behind_and_is_said_in_the_panel(self):
        source = self.document.addObject("Part::Feature", "Empty")
        for command in (commands.Triangulate, commands.Curve):
            with self.subTest(command.NAME):
                panel = self.panel(command, source)
                self.finish(panel)
                self.assertIn("Empty", panel.said)
                self.assertEqual(self.document.Objects, [source])
                self.assertFalse(self.document.HasPendingTransaction)
                panel.reject()

    def test_cancel_ends_the_work_and_changes_nothing(self):
        box = self.box()
        panel = self.panel(commands.Triangulate, box)
        panel.options.set_values({"max_edge": 0.01})
        panel.accept()
        self.until(lambda: panel.jobs[0].state == jobs.RUNNING)
        self.assertFalse(panel.reject())
        self.until(lambda: not panel.jobs)
        self.assertIn("Cancelled", panel.said)
        self.assertEqual(self.document.Objects, [box])
        self.assertTrue(panel.options.isEnabled())
        self.assertTrue(panel.reject())

    def test_return_in_a_field_takes_the_value_and_begins_nothing(self):
        panel = self.panel(commands.Triangulate, self.box())
        box = panel.options.field("max_edge")
        box.setFocus()
        box.lineEdit().setText("3 mm")
        QtGui.QApplication.sendEvent(box, QtGui.QKeyEvent(QtCore.QEvent.KeyPress, QtCore.Qt.Key_Return, QtCore.Qt.NoModifier))
        self.assertEqual((box.value(), panel.jobs), (3.0, []))
        with_control = QtGui.QKeyEvent(QtCore.QEvent.KeyPress, QtCore.Qt.Key_Return, QtCore.Qt.ControlModifier)
        panel.form.keyPressEvent(with_control)
        self.assertFalse(with_control.isAccepted())  # so that the task view takes it as OK
        panel.reject()

    def test_return_in_any_field_of_any_panel_is_no_ok(self):
        box = self.box()
        mesh = mq.add_quality_mesh(box)
        for make in (PatchesPanel, ExportPanel, CasePanel, QualityPanel):
            panel = make(mesh)
            FreeCADGui.Control.showDialog(panel)
            gui_helpers.wait()
            if make is PatchesPanel:
                FreeCADGui.Selection.addSelection(box, "Face1")
                panel.new.click()  # the name of the patch is in edit
                gui_helpers.wait()
            fields = [field for kind in (QtGui.QLineEdit, QtGui.QAbstractSpinBox, QtGui.QComboBox, QtGui.QAbstractItemView)
                      for field in panel.form.findChildren(kind)]
            self.assertGreater(len(fields), 1)
            with mock.patch.object(type(panel), "accept", create=True) as accepted:
                for field in fields:
                    key = QtGui.QKeyEvent(QtCore.QEvent.KeyPress, QtCore.Qt.Key_Return, QtCore.Qt.NoModifier)
                    QtGui.QApplication.sendEvent(field, key)
                gui_helpers.wait()
                with self.subTest(make.__name__):
                    self.assertEqual(accepted.call_count, 0)
                    self.assertTrue(FreeCADGui.Control.activeDialog())
            if make is PatchesPanel:
                self.assertEqual(list(panel.patches()), ["patch_1"])
            panel.reject()
            gui_helpers.wait()

    def test_ok_selects_what_was_made(self):
        first, second = self.two_boxes()
        self.finish(self.panel(commands.Triangulate, first, second))
        made = self.document.Objects[2:]
        self.assertEqual(FreeCADGui.Selection.getSelection(), made)
        self.assertEqual(commands.Improve().selected(), made)
        panel = self.panel(commands.Triangulate, first)
        self.select(second)  # while the panel is open
        self.finish(panel)
        self.assertEqual(FreeCADGui.Selection.getSelection(), [second])
        panel = self.edit(made[0])
        panel.options.set_values({"max_edge": 3.0})
        self.finish(panel)
        self.assertEqual(FreeCADGui.Selection.getSelection(), [second])

    def test_a_hidden_source_stands_for_its_mesh(self):
        """The next command takes the mesh that is seen in its place."""
        box = self.box()
        self.finish(self.panel(commands.Triangulate, box))
        mesh = self.document.Objects[-1]
        self.select(box)
        for command in (commands.Analyse, commands.Thickness, commands.Export, commands.Patches, commands.FlowCase):
            self.assertEqual(command().selected(), [mesh], command.NAME)
        box.ViewObject.Visibility = True
        self.assertFalse(commands.Analyse().IsActive())

    def test_cancel_is_called_close_once_apply_has_changed_something(self):
        panel = self.panel(commands.Triangulate, self.box())
        button, = (button for button in FreeCADGui.getMainWindow().findChildren(QtGui.QPushButton)
                   if button.text().replace("&", "") == "Cancel" and button.isVisible())
        panel.apply()
        self.assertEqual(button.text().replace("&", ""), "Cancel")
        self.until(lambda: not panel.jobs)
        self.assertEqual(button.text(), "Close")
        gui_helpers.screen().save(f"{gui_helpers.PICTURES}/panel_close.png")
        panel.options.set_values({"max_edge": 0.01})
        panel.apply()
        self.assertEqual(button.text(), "Cancel")
        panel.reject()
        self.until(lambda: not panel.jobs)
        panel.reject()

    def test_a_document_closed_meanwhile_ends_its_job(self):
        other = FreeCAD.newDocument("Other")
        source = other.addObject("Part::Box", "Box")
        other.recompute()
        panel = self.panel(commands.Triangulate, source)
        panel.options.set_values({"max_edge": 0.01})
        panel.accept()
        job = panel.jobs[0]
        self.until(lambda: job.state == jobs.RUNNING)
        FreeCAD.closeDocument("Other")
        self.until(lambda: not job.active)
        self.assertEqual(job.state, jobs.CANCELLED)

    def test_a_source_deleted_before_ok_is_said_in_the_panel(self):
        box = self.box()
        panel = self.panel(commands.Triangulate, box)
        self.document.removeObject(box.Name)
        panel.options.set_values({"max_edge": 2.0})
        panel.accept()
        self.assertIn("The source was deleted. Close this panel.", panel.said)
        self.assertFalse(panel.jobs)
        self.assertTrue(panel.reject())

    def test_a_document_closed_before_ok_closes_the_panel(self):
        for edited in (False, True):
            other = FreeCAD.newDocument("Other")
            source = other.addObject("Part::Box", "Box")
            other.recompute()
            if edited:
                panel = commands.panel_of(mq.add_quality_mesh(source))
                FreeCADGui.Control.showDialog(panel)
            else:
                panel = self.panel(commands.Triangulate, source)
            self.assertTrue(FreeCADGui.Control.activeDialog())
            FreeCAD.closeDocument("Other")
            self.until(lambda: not FreeCADGui.Control.activeDialog())

    def test_the_document_of_a_panel_that_is_gone_closes_no_other(self):
        other = FreeCAD.newDocument("Other")
        source = other.addObject("Part::Box", "Box")
        other.recompute()
        self.panel(commands.Triangulate, source)
        FreeCADGui.Control.closeDialog()
        FreeCAD.setActiveDocument(self.document.Name)
        self.names.append(other.Name)
        panel = self.panel(commands.Triangulate, self.box())
        FreeCAD.closeDocument("Other")
        gui_helpers.wait(0.2)
        self.assertTrue(FreeCADGui.Control.activeDialog())
        self.assertTrue(panel.form.isVisible())

    def test_every_command_has_its_icon_and_its_own_shortcut(self):
        names = [name for name in FreeCADGui.listCommands()
                 if name.startswith("MeshQuality_") and name not in (commands.FirstSteps.NAME, commands.Examples.NAME)]
        self.assertGreaterEqual(len(names), 6)
        shortcuts = set()
        for name in names:
            self.assertFalse(FreeCADGui.getIcon(name).isNull(), name)
            command = FreeCADGui.Command.get(name)
            self.assertTrue(command.getInfo()["toolTip"])
            shortcuts.add(command.getInfo()["shortcut"])
        self.assertEqual(len(shortcuts), len(names))

    def test_the_context_menu_has_what_fits_the_selection(self):
        workbench = FreeCADGui.getWorkbench("MeshQualityWorkbench")
        box = self.box()
        curved = mq.add_curved_mesh(box)
        both = {"Offset", "Hollow", "CamMesh", "Wrap", "Inspect"}
        in_place = {"Analyse", "Patches", "Export", "SaveReport", "FlowCase", "CfdSurface"}  # of the mesh that is seen in place of the box
        for chosen, expected in (((box,), {"Triangulate", "Quick", "Curve", "FemMesh", "FlowMesh", *both, *in_place}), ((), set()),
                                 ((box, curved), {"Triangulate", "Curve", "FemMesh", "FlowMesh", "Boolean", "Improve", "Simplify", "Deviation", "Update", *both}),
                                 ((curved,), {"Improve", "Simplify", "Update", *in_place, *both})):
            self.select(*chosen)
            added = []
            with mock.patch.object(workbench, "appendContextMenu", create=True,
                                   side_effect=lambda menu, names, keep=added: keep.extend(names)):
                workbench.ContextMenu("View")
            self.assertEqual({name.split("_")[1] for name in added}, expected)

    def test_one_click_gives_a_mesh_and_its_quality_in_colour(self):
        box = self.box()
        self.select(box)
        FreeCADGui.runCommand(commands.Quick.NAME)
        self.until(lambda: quality_panel.shown() is not None)
        panel = quality_panel.shown()
        self.addCleanup(lambda: panel.ended or panel.reject())
        self.until(lambda: panel.values is not None)
        obj = self.document.Objects[-1]
        self.assertEqual((panel.obj, obj.Source, obj.Certificate), (obj, box, "met"))
        self.assertEqual(self.document.UndoNames[0], commands.Triangulate.TEXT)
        self.assertEqual(panel.scene.scene.triangles, obj.Mesh.CountFacets)
        panel.reject()
        self.assertIsNone(quality_panel.shown())
        self.assertTrue(obj.ViewObject.Visibility)

    def test_one_click_that_fails_says_why_in_the_panel(self):
        self.select(self.document.addObject("Part::Feature", "Empty"))
        FreeCADGui.runCommand(commands.Quick.NAME)
        gui_helpers.wait(0.3)
        self.assertIsNone(quality_panel.shown())
        self.assertTrue(FreeCADGui.Control.activeDialog())
        self.assertEqual(len(self.document.Objects), 1)

    def test_update_computes_all_selected_meshes_anew(self):
        box = self.box()
        made = [mq.add_quality_mesh(box), mq.add_curved_mesh(box)]
        for obj in made:
            obj.Recompute = "Manual"
        box.Height = 20
        self.document.recompute()
        self.select(*made)
        FreeCADGui.runCommand("MeshQuality_Update")
        self.until(lambda: not len(jobs.queue()))
        for obj in made:
            self.assertAlmostEqual(obj.Mesh.BoundBox.ZLength, 20)
            self.assertEqual(obj.Status, "up to date")

    def test_every_panel_is_usable_at_260_pixels(self):
        sources = self.two_boxes()
        for command in ALL:
            with self.subTest(command.NAME):
                panel = self.panel(command, *sources)
                self.narrow(panel, f"panel_{command.__name__}")
                gui_helpers.unfold(panel)
                self.narrow(panel, f"panel_{command.__name__}_all")
                panel.reject()


class Queue(gui_helpers.GuiTest):
    def test_jobs_run_one_after_the_other_and_what_fails_is_kept(self):
        seen = []
        queue = jobs.Queue()

        def work(name):
            def compute(progress):
                if name == "b":
                    raise RuntimeError("no luck")
                return name
            return compute

        made = [queue.add(jobs.Job(name, work(name), seen.append, quiet=True)) for name in "abc"]
        self.until(lambda: not any(job.active for job in made))
        self.assertEqual(seen, ["a", "c"])
        self.assertEqual([job.state for job in made], [jobs.DONE, jobs.FAILED, jobs.DONE])
        self.assertEqual(str(made[1].error), "no luck")

    def test_a_waiting_job_can_be_cancelled(self):
        queue = jobs.Queue()
        job = jobs.Job("never", lambda progress: self.fail("it ran"), lambda result: None)
        queue.add(job)
        job.cancel()
        gui_helpers.wait(0.2)
        self.assertEqual(job.state, jobs.CANCELLED)
        self.assertEqual(len(queue), 0)
