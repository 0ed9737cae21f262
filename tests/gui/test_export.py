# SPDX-License-Identifier: LGPL-2.1-or-later
"""Export of meshes: selection, formats, the file, errors in the panel, cancel, the macro."""

import os
from unittest import mock

import FreeCAD
import FreeCADGui
import gui_helpers
from PySide import QtGui

import MeshQuality as mq
from MeshQuality import formats
from MeshQuality.gui import commands
from MeshQuality.gui.panels import export_panel


class Export(gui_helpers.PanelTest):
    def curved(self):
        obj = mq.add_curved_mesh(self.box(), order=2)
        self.select(obj)
        return obj

    def panel_for(self, obj, name):
        panel = export_panel.ExportPanel(obj)
        FreeCADGui.Control.showDialog(panel)
        panel.path.setProperty("fileName", os.path.join(self.folder, name))
        gui_helpers.wait()
        return panel

    def write(self, panel):
        panel.accept()
        self.until(lambda: panel.job is None)

    def test_it_is_for_one_mesh(self):
        box, command = self.box(), commands.Export()
        curved, plain = mq.add_curved_mesh(box), mq.add_quality_mesh(box)
        curved.ViewObject.Visibility = True  # two are seen in place of the box
        for chosen, active in (((curved,), True), ((plain,), True), ((box,), False), ((), False),
                               ((curved, plain), False)):
            self.select(*chosen)
            self.assertEqual(command.IsActive(), active)
        self.select(curved)
        command.Activated()
        self.assertTrue(FreeCADGui.Control.activeDialog())

    def test_patches_are_spoken_of_where_there_can_be_any(self):
        first, second = self.two_boxes()
        for obj, said in ((mq.add_quality_mesh(first), True), (mq.add_boolean(first, second), False)):
            panel = export_panel.ExportPanel(obj)
            self.assertEqual(any("patch" in label.text().lower() for label in panel.form.findChildren(QtGui.QLabel)), said)

    def test_the_format_of_the_last_file_comes_first(self):
        plain, curved = mq.add_quality_mesh(self.box()), self.curved()
        self.write(self.panel_for(plain, "part.3mf"))
        for obj, suffix in ((plain, ".3mf"), (curved, ".msh")):
            panel = export_panel.ExportPanel(obj)
            self.assertEqual((panel.formats.currentData(), os.path.splitext(panel.path.property("fileName"))[1]), (suffix, suffix))

    def test_the_file_is_that_of_the_api(self):
        obj = self.curved()
        for name in ("part.msh", "part.vtu"):
            panel = self.panel_for(obj, name)
            self.write(panel)
            self.assertEqual(panel.said, "")
            self.assertFalse(FreeCADGui.Control.activeDialog())
            mq.CurvedMesh.of(obj).write(os.path.join(self.folder, "expected_" + name))
            with open(os.path.join(self.folder, name), "rb") as written, \
                    open(os.path.join(self.folder, "expected_" + name), "rb") as expected:
                self.assertEqual(written.read(), expected.read())
        self.assertFalse([name for name in os.listdir(self.folder) if ".part" in name])

    def test_fem_meshes_of_others(self):
        try:
            import Fem
        except ImportError:
            self.skipTest("this FreeCAD has no FEM workbench")
        given = self.document.addObject("Fem::FemMeshObject", "Given")
        given.FemMesh = mq.curve(self.box().Shape, order=2, volume=True).to_fem_mesh(groups=True)
        self.assertIsInstance(given.FemMesh, Fem.FemMesh)
        self.document.recompute()
        self.select(given)
        self.assertTrue(commands.Export().IsActive())
        panel = self.panel_for(given, "given.inp")
        self.assertEqual(panel.formats.currentData(), ".inp")
        self.assertEqual([panel.formats.itemData(i) for i in range(panel.formats.count())], list(formats.ELEMENTS_WRITTEN))
        self.narrow(panel, "panel_export_fem")
        panel.formats.setCurrentIndex(panel.formats.findData(".unv"))
        self.assertTrue(panel.path.property("fileName").endswith("given.unv"))
        self.write(panel)
        self.assertEqual(panel.said, "")
        found = mq.read_mesh(os.path.join(self.folder, "given.unv"))
        self.assertEqual((len(found.blocks[0].nodes), mq.certify(found).invalid), (given.FemMesh.VolumeCount, 0))
        self.assertIn("Face1", found.groups)

    def test_what_is_wrong_with_a_path_is_said_in_the_panel(self):
        obj = self.curved()
        os.mkdir(os.path.join(self.folder, "folder.msh"))
        for name, words in (("part.docx", "ends in one of"), ("none/part.msh", "no folder"),
                            ("folder.msh", "cannot be written")):
            panel = self.panel_for(obj, name)
            self.write(panel)
            self.assertIn(words, panel.said)
            self.assertTrue(FreeCADGui.Control.activeDialog())
            self.assertTrue(panel.path.isEnabled())
            with self.assertRaisesRegex(mq.IoError, words):
                mq.export_curved_mesh(obj, os.path.join(self.folder, name))
            panel.reject()
        self.assertEqual(os.listdir(self.folder), ["folder.msh"])

    def test_a_name_without_an_ending_gets_that_of_the_format(self):
        obj = self.curved()
        for ending in (".msh", ".vtu"):
            panel = self.panel_for(obj, "part")
            panel.formats.setCurrentIndex(panel.formats.findData(ending))
            self.write(panel)
            self.assertEqual(panel.said, "")
            self.assertTrue(os.path.isfile(os.path.join(self.folder, "part" + ending)))
        self.assertEqual(sorted(os.listdir(self.folder)), ["part.msh", "part.vtu"])

    def test_the_format_follows_the_name_and_the_name_the_format(self):
        panel = self.panel_for(self.curved(), "part.vtu")
        self.assertEqual(panel.formats.currentData(), ".vtu")
        panel.formats.setCurrentIndex(panel.formats.findData(".msh"))
        self.assertTrue(panel.path.property("fileName").endswith("part.msh"))

    def test_without_a_name_it_says_what_to_do(self):
        obj = self.curved()
        panel = self.panel_for(obj, "part.msh")
        for path, words in (("", "Choose a file"), (self.folder, "is a folder")):
            panel.path.setProperty("fileName", path)
            self.write(panel)
            self.assertIn(words, panel.said)
            self.assertTrue(FreeCADGui.Control.activeDialog())
        with self.assertRaisesRegex(mq.IoError, "the file has no name"):
            mq.export_curved_mesh(obj, "")

    def test_its_document_closed_closes_it(self):
        other = FreeCAD.newDocument("Other")
        source = other.addObject("Part::Box", "Box")
        other.recompute()
        FreeCADGui.Control.showDialog(export_panel.ExportPanel(mq.add_curved_mesh(source)))
        FreeCAD.closeDocument("Other")
        self.until(lambda: not FreeCADGui.Control.activeDialog())

    def test_cancel_writes_nothing(self):
        obj = self.curved()
        panel = self.panel_for(obj, "part.msh")
        panel.accept()
        self.assertFalse(panel.reject())
        self.until(lambda: panel.job is None)
        self.assertIn("Cancelled", panel.said)
        self.assertEqual(os.listdir(self.folder), [])

    def test_an_existing_file_is_told_of(self):
        obj = self.curved()
        with open(os.path.join(self.folder, "part.msh"), "w", encoding="utf-8"):
            pass
        panel = self.panel_for(obj, "part.msh")
        self.assertIn("will be replaced", panel.said)
        self.write(panel)
        self.assertGreater(os.path.getsize(os.path.join(self.folder, "part.msh")), 100)

    def test_the_recorded_lines_write_the_file(self):
        obj, lines = self.curved(), []
        real = FreeCADGui.doCommand
        panel = self.panel_for(obj, "part.msh")
        with mock.patch.object(FreeCADGui, "doCommand",
                               lambda line: (lines.append(line), real(line))):
            self.write(panel)
        path = os.path.join(self.folder, "part.msh")
        os.remove(path)
        exec("\n".join(lines), {"App": FreeCAD})  # noqa: S102 - what a macro does
        self.assertGreater(os.path.getsize(path), 100)

    def test_the_panel_is_usable_at_260_pixels(self):
        panel = self.panel_for(self.curved(), "part.msh")
        self.narrow(panel, "panel_Export")
