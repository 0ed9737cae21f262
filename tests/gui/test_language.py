# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench in German: menus, panels, and that numbers and values do not depend on it."""

import re

import FreeCAD
import FreeCADGui
import gui_helpers
import Mesh
import Part
from PySide import QtCore, QtGui

import MeshQuality as mq
from MeshQuality import phrases
from MeshQuality.gui import commands, translation
from MeshQuality.gui.panels import quality_panel
from MeshQuality.phrases import Text

# Words of English sentences that are no German ones.
ENGLISH = re.compile(r"\b(the|of|and|is|are|be|with|that|to|than|from|each|triangles?|mesh|shape|angles?|"
                     r"edges?|elements|between|below|above|more|corner|longest|smallest|which|keeps?)\b",
                     re.IGNORECASE)


def shown_texts(widget):
    """All that a widget shows, tooltips too."""
    found = []
    for part in [widget, *widget.findChildren(QtGui.QWidget)]:
        for name in ("text", "title", "windowTitle", "toolTip", "placeholderText", "specialValueText",
                     "format"):
            if callable(getattr(part, name, None)):
                found.append(getattr(part, name)())
        if isinstance(part, QtGui.QComboBox):
            found += [part.itemText(i) for i in range(part.count())]
        if isinstance(part, QtGui.QTabWidget):
            found += [part.tabText(i) for i in range(part.count())]
        if isinstance(part, QtGui.QListWidget):
            for i in range(part.count()):
                found += [part.item(i).text(), part.item(i).toolTip()]
        if isinstance(part, QtGui.QTableWidget):
            found += [part.horizontalHeaderItem(i).text() for i in range(part.columnCount())]
    return [text for text in found if text]


def menu_texts():
    """All texts of the main window's menus."""
    found, pending = [], list(FreeCADGui.getMainWindow().menuBar().actions())
    while pending:
        action = pending.pop()
        found.append(action.text().replace("&", ""))
        if action.menu():
            pending += action.menu().actions()
    return found


class German(gui_helpers.PanelTest):
    def setUp(self):
        super().setUp()
        FreeCADGui.setLocale("German")
        self.addCleanup(FreeCADGui.setLocale, "English")
        gui_helpers.wait(0.2)

    def test_menus_are_german_and_english_again(self):
        texts = menu_texts()
        for text in ("Netzqualität", "Qualitätsnetz...", "Gekrümmtes Netz...",
                     "Netz exportieren...", "Netz aktualisieren"):
            self.assertIn(text, texts)
        FreeCADGui.setLocale("English")
        gui_helpers.wait(0.2)
        self.assertIn("Quality mesh...", menu_texts())
        self.assertNotIn("Qualitätsnetz...", menu_texts())

    def test_the_name_of_the_workbench_is_that_of_its_menu(self):
        workbench = FreeCADGui.listWorkbenches()["MeshQualityWorkbench"]
        self.assertEqual((workbench.MenuText, workbench.ToolTip), ("Netzqualität", "Netze von CAD-Formen mit garantierter Qualität"))
        FreeCADGui.setLocale("English")
        self.assertEqual(workbench.MenuText, "Mesh Quality")

    def test_panels_are_german_and_fit(self):
        sources = self.two_boxes()
        expected = {commands.Triangulate: ("Qualitätsnetz", "Kleinster Winkel", "Sehr fein"),
                    commands.Curve: ("Gekrümmtes Netz", "Ordnung der Elemente", "Sehr fein"),
                    commands.Boolean: ("Boolesche Netzoperation", "Auflösung", "Vereinigung")}
        for command, words in expected.items():
            panel = self.panel(command, *sources)
            shown = [panel.form.windowTitle()]
            shown += [label.text() for label in panel.form.findChildren(QtGui.QLabel)]
            for box in panel.form.findChildren(QtGui.QComboBox):
                shown += [box.itemText(i) for i in range(box.count())]
            for word in words:
                self.assertIn(word, shown)
            gui_helpers.unfold(panel)
            self.narrow(panel, f"panel_{command.__name__}_de")
            panel.reject()

    def test_help_names_choices_as_the_boxes_do(self):
        for command in (commands.Triangulate, commands.Curve, commands.FemMesh, commands.Inspect, commands.Offset):
            panel = self.panel(command, self.box())
            for field in dict.fromkeys(panel.options._fields.values()):
                for choice, title in zip(field.option.choices, field.option.choice_titles):
                    if FreeCAD.Qt.translate("MeshQuality", title) != title:
                        self.assertIsNone(re.search(rf"(?<![\w-]){re.escape(choice)}(?![\w-])", field.widget.toolTip()), choice)
            panel.reject()

    def test_values_and_properties_do_not_depend_on_it(self):
        panel = self.panel(commands.Triangulate, self.box())
        panel.options.set_values({"min_angle": 27.5, "max_edge": 2.25, "method": "star"})
        values = panel.options.values()
        self.assertEqual((values["min_angle"], values["max_edge"], values["method"]),
                         (27.5, 2.25, "star"))
        self.finish(panel)
        obj = self.document.Objects[-1]
        self.assertEqual((obj.MaxEdge.Value, obj.Certificate), (2.25, "met"))
        FreeCADGui.setLocale("English")
        mq.update(obj, max_edge=3.5)
        self.assertEqual(obj.MaxEdge.Value, 3.5)

    def no_english(self, widget):
        for text in shown_texts(widget):
            # FreeCAD's own menus of fields, and names of files and options, are none of ours.
            self.assertIsNone(ENGLISH.search(text), text)

    def wedge(self):
        source = self.document.addObject("Part::Feature", "Keil")
        corners = [FreeCAD.Vector(*p) for p in ((0, 0, 0), (10, 0, 0), (10, 0.8, 0), (0, 0, 0))]
        source.Shape = Part.Face(Part.makePolygon(corners)).extrude(FreeCAD.Vector(0, 0, 3))
        self.document.recompute()
        return source

    def test_no_english_is_left_in_panels(self):
        sources = self.two_boxes()
        for i, source in enumerate(sources):
            source.Label = f"Quader {i}"
        net = mq.add_quality_mesh(sources[0])
        net.Label = "Netz"
        for command, chosen in ((commands.Triangulate, sources[:1]), (commands.Curve, sources[:1]),
                                (commands.Boolean, sources), (commands.Improve, [net]), (commands.Simplify, [net])):
            panel = self.panel(command, *chosen)
            gui_helpers.unfold(panel)
            self.until(lambda made=panel: "..." not in made.estimate.text())
            self.no_english(panel.form)
            panel.reject()

    def test_no_english_is_left_in_a_certificate(self):
        obj = mq.add_quality_mesh(self.wedge())
        obj.Label = "Netz"
        panel = commands.panel_of(obj)
        FreeCADGui.Control.showDialog(panel)
        self.assertIn("Ziel nicht erreicht: kleinster Winkel 4.57° (verlangt 25°), Dreieck", panel.certificate.text.text())
        self.no_english(panel.form)
        self.narrow(panel, "panel_missed_de")
        panel.reject()

    def test_no_english_is_left_in_the_quality_panel(self):
        obj = mq.add_quality_mesh(self.wedge())
        obj.Label = "Netz"
        panel = quality_panel.open_panel(obj)
        self.addCleanup(lambda: panel.ended or panel.reject())
        for i in range(panel.measures.count()):
            panel.measures.setCurrentIndex(i)
            self.until(lambda k=i: panel.measure is panel.data.measures[k])
            self.no_english(panel.form)
        panel.measures.setCurrentIndex(0)
        self.until(lambda: panel.measure is panel.data.measures[0])
        self.assertIn("eine Ecke von 4.57° zwischen Edge", panel.worst.item(0).text())
        panel.histogram.pick(int(panel.histogram.counts.argmax()))
        self.no_english(panel.form)
        self.narrow(panel, "panel_quality_de")

    def test_new_objects_have_german_names(self):
        boxes = self.two_boxes()
        for i, box in enumerate(boxes):
            box.Label = f"Quader {i + 3}"
        made = (mq.add_quality_mesh(boxes[0]), mq.add_inspection(boxes[0]), mq.add_offset(boxes[0], 1.0),
                mq.add_wrap(boxes[0], 2.0), mq.add_repaired_mesh(mq.add_quality_mesh(boxes[1])))
        self.assertEqual([obj.Label for obj in made], [
            "Quader 3 Qualitätsnetz", "Quader 3 Prüfung", "Quader 3 Versatz", "Quader 3 Hülle", "Quader 4 Qualitätsnetz repariert"])
        both = mq.add_boolean(*boxes)
        self.assertEqual(both.Label, "Quader 3 Vereinigung")
        mq.update(both, operation="difference")
        self.assertEqual(both.Label, "Quader 3 Differenz")
        both.Label = "Mein Teil"
        mq.update(both, operation="union")
        self.assertEqual(both.Label, "Mein Teil")

    def test_what_repairs_did_is_german(self):
        corners = [tuple(point) for facet in mq.add_quality_mesh(self.box()).Mesh.Facets for point in facet.Points]
        dirty = self.document.addObject("Mesh::Feature", "Netz")
        dirty.Mesh = Mesh.Mesh([*corners[3:], *corners[6:9]])
        obj = mq.add_repaired_mesh(dirty)
        panel = commands.panel_of(obj)
        FreeCADGui.Control.showDialog(panel)
        self.assertRegex(panel.certificate.text.text(), r"^Reparaturen: .*1 doppeltes Dreieck entfernt, 1 Loch geschlossen \(1 Dreieck\)")
        self.no_english(panel.certificate)
        panel.reject()

    def test_errors_and_stages_are_german(self):
        panel = self.panel(commands.Triangulate, self.box())
        panel.options.set_values({"min_edge": 2.0, "max_edge": 1.0})
        panel.apply()
        self.assertEqual(panel.said, "Die kürzeste Kante von 2 mm ist länger als die längste Kante von 1 mm")
        panel.options.set_values({"min_edge": None, "max_edge": 0.05})
        stages = set()
        panel.apply()
        panel.jobs[0].changed.connect(lambda: stages.add(panel.doing.text()))
        self.until(lambda: len(stages) > 1)
        panel.reject()
        self.until(lambda: not panel.jobs)
        self.assertIn("Abgebrochen", panel.said)
        for text in stages:
            self.assertIsNone(ENGLISH.search(text), text)

    def test_waits_are_german(self):
        checking = Text(phrases.WAITS_FOR_KERNEL, stage=Text(phrases.CHECKING, name="Face12"))
        for stage, german in (
                (checking, "wartet auf OpenCASCADE: Face12 wird geprüft"),
                (Text(phrases.WAITS_FOR_KERNEL, stage="reading the shape"), "wartet auf OpenCASCADE: Form wird gelesen"),
                (Text(phrases.WAITS_FOR_ENGINE, name="Mesh of Bracket"),
                 "wartet auf den Formkern, belegt durch: Mesh of Bracket")):
            self.assertEqual(translation.translated_stage(stage), german)
        self.assertEqual(translation.translated_rest(checking),
                         "OpenCASCADE arbeitet noch: Face12 wird geprüft")
        self.assertEqual(translation.translated_rest("mending"),
                         "arbeitet noch: " + translation.translated_stage("mending"))

    def test_errors_of_the_core_are_german(self):
        for command, values, words in (
                (commands.Curve, {"order": 5, "volume": True}, "Tetraeder der Ordnung 5 sind nicht möglich"),
                (commands.Triangulate, {"local_sizes": "Face99=0.5"}, "Für Face99 ist eine lokale Größe"),
                (commands.Triangulate, {"chord_height": 1e-7, "chord_height_relative": None},
                 "Eine max. Abweichung von 0.1 nm")):
            panel = self.panel(command, self.box())
            panel.options.set_values(values)
            self.finish(panel)
            self.assertIn(words, panel.said)
            self.assertIsNone(ENGLISH.search(panel.said), panel.said)
            panel.reject()

    def test_help_of_properties_is_german(self):
        obj = mq.add_quality_mesh(self.box())
        texts = [obj.getDocumentationOfProperty(name) for name in ("MinAngle", "ChordHeight",
                                                                   "Certificate", "Closed")]
        for text in texts:
            german = QtCore.QCoreApplication.translate("App::Property", text)
            self.assertNotEqual(german, text)
            self.assertIsNone(ENGLISH.search(german), german)
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(obj)
        gui_helpers.wait(0.3)
        tips = [tip for tree in FreeCADGui.getMainWindow().findChildren(QtGui.QTreeView)
                for tip in _tips(tree.model())]
        self.assertTrue(any("Das Netz ist wasserdicht" in tip for tip in tips), tips[:20])


def _tips(model, parent=None, deep=0):
    """All tooltips of a model."""
    parent = parent or QtCore.QModelIndex()
    for row in range(model.rowCount(parent) if model and deep < 3 else 0):
        index = model.index(row, 0, parent)
        yield str(index.data(QtCore.Qt.ToolTipRole) or "")
        yield from _tips(model, index, deep + 1)
