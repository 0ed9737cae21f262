# SPDX-License-Identifier: LGPL-2.1-or-later
"""File > Export in a FreeCAD of its own that never sees the workbench: the dialog, the file, the certificate in the Report view."""

import json
import os
import subprocess
import tempfile
import unittest
import zipfile
from pathlib import Path
from xml.etree import ElementTree

import FreeCADGui
import gui_helpers
import run
from PySide import QtCore, QtGui

import MeshQuality as mq
from MeshQuality import exchange
from MeshQuality.features import file_settings

LIMIT = 120  # seconds
SPACE = {"m": "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"}
SCRIPT = """
import json, os, sys
import FreeCAD, FreeCADGui
from PySide import QtCore, QtGui

said = {{}}

def answer(filter_name, path):
    dialog = QtGui.QApplication.activeModalWidget()
    if not isinstance(dialog, QtGui.QFileDialog):
        QtCore.QTimer.singleShot(100, lambda: answer(filter_name, path))
        return
    said.setdefault("filters", dialog.nameFilters())
    dialog.selectNameFilter(filter_name)
    dialog.findChild(QtGui.QLineEdit, "fileNameEdit").setText(path)
    QtCore.QTimer.singleShot(300, acknowledge)
    dialog.accept()

def acknowledge():
    box = QtGui.QApplication.activeModalWidget()
    if isinstance(box, QtGui.QMessageBox):
        said["box"] = box.text() + box.informativeText()
        box.accept()

def export(filter_name, path, *objects):
    FreeCADGui.Selection.clearSelection()
    for obj in objects:
        FreeCADGui.Selection.addSelection(obj)
    QtCore.QTimer.singleShot(300, lambda: answer(filter_name, path))
    FreeCADGui.runCommand("Std_Export")
    for _ in range(20):  # the view takes its lines as events
        QtGui.QApplication.processEvents()

def take(path):
    dialog = QtGui.QApplication.activeModalWidget()
    if not isinstance(dialog, QtGui.QFileDialog):
        QtCore.QTimer.singleShot(100, lambda: take(path))
        return
    said["readers"] = dialog.nameFilters()
    dialog.selectNameFilter(dialog.nameFilters()[0])  # all of them, so that FreeCAD asks
    dialog.findChild(QtGui.QLineEdit, "fileNameEdit").setText(path)
    QtCore.QTimer.singleShot(300, choose)
    dialog.accept()

def choose():
    dialog = QtGui.QApplication.activeModalWidget()
    buttons = dialog.findChildren(QtGui.QRadioButton) if dialog else []
    if not buttons:
        QtCore.QTimer.singleShot(100, choose)
        return
    said["choice"] = [button.text() for button in buttons]
    next(button for button in buttons if "with groups" in button.text()).click()
    dialog.accept()

def main():
    window = FreeCADGui.getMainWindow()
    document = FreeCAD.newDocument("Menu")
    part = document.addObject("App::Part", "Housing")
    box, cylinder = document.addObject("Part::Box", "Lid"), document.addObject("Part::Cylinder", "Pin")
    cylinder.Placement.Base.x = 30
    part.addObjects([box, cylinder])
    document.recompute()
    box.ViewObject.ShapeColor, cylinder.ViewObject.ShapeColor = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)
    broken = document.addObject("Part::Feature", "Pair")
    import Part
    broken.Shape = Part.makeCompound([Part.makeBox(10, 10, 10), Part.makeBox(10, 10, 10, FreeCAD.Vector(5, 5, 5))])
    line = document.addObject("Part::Line", "Axis")
    document.recompute()
    report = window.findChild(QtGui.QTextEdit, "Report view")
    said["before"] = [name for name in ("MeshQuality.gui.commands", "numpy", "MeshQuality._core") if name in sys.modules]
    export("Quality mesh (*.3mf)", {folder!r} + "/part.3mf", part)
    said["report"] = report.toPlainText()
    export("Quality mesh (*.stl)", {folder!r} + "/pair.stl", broken)
    export("Quality mesh, Abaqus and CalculiX (*.inp)", {folder!r} + "/part.inp", part)
    export("Quality mesh (*.obj)", {folder!r} + "/line.obj", line)
    said["later"] = report.toPlainText()
    said["written"] = {{}}
    for name in said["filters"]:
        if name.startswith("Quality mesh"):
            path = {folder!r} + "/each" + name.split("*")[1].split()[0].rstrip(")")
            export(name, path, part)
            said["written"][name] = os.path.getsize(path) if os.path.exists(path) else 0
    QtCore.QTimer.singleShot(300, lambda: take({folder!r} + "/part.inp"))
    FreeCADGui.runCommand("Std_Import")
    said["imported"] = [(obj.TypeId, [obj.FemMesh.getGroupName(group) for group in obj.FemMesh.Groups]) for obj in document.Objects
                        if hasattr(obj, "FemMesh")]
    said["workbench"] = "MeshQuality.gui.commands" in sys.modules
    said["active"] = FreeCADGui.activeWorkbench().name()
    with open({result!r}, "w") as stream:
        json.dump(said, stream)
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)
    window.close()

QtCore.QTimer.singleShot(500, main)
"""


class FileExport(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        cls.folder, home = Path(holder.name), Path(holder.name, "home")
        home.mkdir()
        run.make_home(home)
        settings = home / "user.cfg"
        settings.write_text(settings.read_text(encoding="utf-8").replace(
            "MeshQualityWorkbench", "PartWorkbench").replace('<FCParamGroup Name="View">', '<FCParamGroup Name="Dialog"><FCBool '
            'Name="DontUseNativeFileDialog" Value="1"/></FCParamGroup><FCParamGroup Name="View">'), encoding="utf-8")
        script, result = cls.folder / "menu.py", cls.folder / "said.json"
        script.write_text(SCRIPT.format(folder=str(cls.folder), result=str(result)), encoding="utf-8")
        done = subprocess.run(["freecad", str(script)], timeout=LIMIT, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              check=False, env={**os.environ, "FREECAD_USER_HOME": str(home)})
        if not result.exists():
            raise AssertionError((done.stdout + done.stderr)[-3000:])
        cls.said = json.loads(result.read_text(encoding="utf-8"))

    def test_nothing_is_loaded_before_and_no_workbench_after(self):
        self.assertEqual(self.said["before"], [])
        self.assertEqual((self.said["workbench"], self.said["active"]), (False, "PartWorkbench"))

    def test_the_dialog_has_the_types_beside_freecads_own(self):
        filters = self.said["filters"]
        for name in ("Quality mesh (*.stl)", "Quality mesh (*.3mf)", "Quality mesh (*.obj)", "Quality mesh (*.ply)",
                     "Quality mesh, Gmsh 4.1 (*.msh)", "STL Mesh (*.stl *.ast)"):
            self.assertIn(name, filters)

    def test_the_certificate_is_in_the_report_view(self):
        for words in (r"Lid: requested: smallest angle 25°, max\. deviation 30(\.0*)? µm; 0 exempt triangles, watertight\n",
                      r"Pin: [\d,]+ triangles, smallest angle 2[5-9]", r"all requested limits are met\.\n", r"Written: .*/part\.3mf\n"):
            self.assertRegex(self.said["report"], words)
        self.assertIn("Pair: 24 triangles", self.said["later"])
        self.assertIn("target not met: 1 pair of bodies overlaps", self.said["later"])

    def test_every_type_writes_a_file(self):
        written = self.said["written"]
        self.assertGreater(len(written), 15)
        self.assertEqual([name for name, size in written.items() if size < 100], [])

    def test_freecad_asks_which_of_two_readers_is_meant(self):
        self.assertEqual(len(self.said["choice"]), 2)
        self.assertIn("FEM mesh with groups (*.cgns", "".join(self.said["readers"]))
        (kind, groups), = self.said["imported"]
        self.assertEqual(kind, "Fem::FemMeshObject")
        self.assertEqual({"Lid", "Pin", "Lid_Face1"} - set(groups), set())

    def test_errors_are_in_a_box_and_in_the_report_view(self):
        for text in (self.said["box"], self.said["later"]):
            self.assertRegex(text, "'Axis' has no faces .*: give a solid, a shell or faces")
        self.assertFalse((self.folder / "line.obj").exists())

    def test_the_files_have_names_and_colours(self):
        with zipfile.ZipFile(self.folder / "part.3mf") as container:
            model = ElementTree.fromstring(container.read("3D/3dmodel.model"))
        self.assertEqual([one.get("name") for one in model.findall(".//m:object", SPACE)], ["Lid", "Pin", "Housing"])
        self.assertEqual([(one.get("name"), one.get("displaycolor")) for one in model.findall(".//m:base", SPACE)],
                         [("Lid", "#FF0000"), ("Pin", "#0000FF")])
        self.assertGreater((self.folder / "pair.stl").stat().st_size, 24 * 50)
        self.assertIn("ELSET=Pin", (self.folder / "part.inp").read_text(encoding="utf-8"))


class Cancel(gui_helpers.GuiTest):
    def test_esc_ends_it_and_leaves_no_file(self):
        self.addCleanup(file_settings.stored().Clear)
        file_settings.stored().SetFloat("ExportChordHeight", 0.0005)
        torus = self.document.addObject("Part::Torus", "Torus")
        self.document.recompute()
        asked = []

        def press():
            for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
                event = QtGui.QKeyEvent(kind, QtCore.Qt.Key_Escape, QtCore.Qt.NoModifier)
                QtGui.QApplication.postEvent(FreeCADGui.getMainWindow(), event)
            QtCore.QTimer.singleShot(100, answer)

        def answer():
            box = QtGui.QApplication.activeModalWidget()
            if box is None:
                QtCore.QTimer.singleShot(100, answer)
                return
            asked.append(box.text())
            box.button(QtGui.QMessageBox.Yes).click()

        QtCore.QTimer.singleShot(0, press)
        with self.assertRaises(mq.Cancelled):
            exchange.export([torus], os.path.join(self.folder, "torus.stl"))
        self.assertEqual(len(asked), 1)
        self.assertEqual(os.listdir(self.folder), [])
