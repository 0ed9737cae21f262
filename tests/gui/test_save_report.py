# SPDX-License-Identifier: LGPL-2.1-or-later
"""Save report: the command, the button of the quality view, and pages in the language of the window."""

import os
from unittest import mock

import FreeCADGui
import gui_helpers
import Part
from PySide import QtGui

import MeshQuality as mq
from MeshQuality.core.reporting.report import SUFFIXES
from MeshQuality.gui import commands, jobs, saving
from MeshQuality.gui.panels import quality_panel


class ReportTest(gui_helpers.PanelTest):
    def meshed(self):
        source = self.document.addObject("Part::Feature", "Part")
        source.Shape = Part.makeCylinder(5, 20)
        return mq.add_quality_mesh(source, chord_height=0.05)

    def page(self, act):
        path = os.path.join(self.folder, "page.html")
        with mock.patch.object(QtGui.QFileDialog, "getSaveFileName", return_value=(path.removesuffix(".html"), "")):
            act()
        self.until(lambda: not len(jobs.queue()))
        gui_helpers.wait()
        with open(path, encoding="utf-8") as stream:
            return stream.read()


class SaveReport(ReportTest):
    def test_the_command(self):
        obj = self.meshed()
        self.select(obj)
        self.assertTrue(commands.SaveReport().IsActive())
        page = self.page(lambda: FreeCADGui.runCommand(commands.SaveReport.NAME))
        self.assertIn("All requested limits are met", page)
        self.assertIn(obj.Label, page)
        report = FreeCADGui.getMainWindow().findChild(QtGui.QTextEdit, "Report view").toPlainText()
        self.assertIn("Saved: page.html", report)

    def test_the_button_of_the_quality_view(self):
        panel = quality_panel.open_panel(self.meshed())
        self.addCleanup(lambda: panel.ended or panel.reject())
        self.until(lambda: panel.values is not None)
        page = self.page(panel.saving.report.click)
        self.assertIn("data:image/png;base64,", page)
        self.assertEqual(panel.warning.text(), "Saved: page.html")
        self.narrow(panel, "panel_save_report")

    def test_the_chosen_kind_gives_the_extension(self):
        for given, kind, expected in (("page", "PDF (*.pdf)", "page.pdf"), ("page", "HTML (*.html)", "page.html"), ("page.htm", "PDF (*.pdf)", "page.htm")):
            with mock.patch.object(QtGui.QFileDialog, "getSaveFileName", return_value=(given, kind)):
                self.assertEqual(saving.asked_path("", "", SUFFIXES, ""), expected)

    def test_none_without_a_name(self):
        panel = quality_panel.open_panel(self.meshed())
        self.addCleanup(lambda: panel.ended or panel.reject())
        self.until(lambda: panel.values is not None)
        with mock.patch.object(QtGui.QFileDialog, "getSaveFileName", return_value=("", "")):
            panel.saving.report.click()
        self.assertIsNone(panel.saving.job)


class German(ReportTest):
    def setUp(self):
        super().setUp()
        FreeCADGui.setLocale("German")
        self.addCleanup(FreeCADGui.setLocale, "English")
        gui_helpers.wait(0.2)

    def test_the_page_is_german(self):
        obj = self.meshed()
        page = self.page(lambda: (self.select(obj), FreeCADGui.runCommand(commands.SaveReport.NAME)))
        for words in ("Alle geforderten Grenzen sind eingehalten", "Kleinster Winkel", "Nach Fläche", "Gefordert", "Gemessen"):
            self.assertIn(words, page)
