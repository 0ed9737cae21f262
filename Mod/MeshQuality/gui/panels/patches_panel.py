# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel in which faces of a mesh's sources are put into patches, by selecting them in the 3D view."""

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from ...core.patches.patch_names import suggested_for
from ...core.patches.patches import distinct_colour
from ...core.sources import frames
from ...errors import Error
from ...features.patches import patches_of_lines
from ..panel_operation import is_there, name_of
from ..patch_colours import SourceColours
from ..selection import picked
from ..sub_elements import select_face
from ..translation import translated
from ..view import badge
from .mesh_panel import title_of
from .task_form import ClosesWithDocument, Form, Message, Table, narrow_buttons

translate = FreeCAD.Qt.translate

_NAME, _FACES = 0, 1
_ROWS = 6  # rows in sight without scrolling


class _CellEditor(QtGui.QStyledItemDelegate):
    """Edits a cell within its column: Qt's editor grows with its text, and style sheets, as FreeCAD's dark ones, give fields a
    least width.
    """

    def createEditor(self, parent, option, index):
        """Called by Qt."""
        editor = QtGui.QLineEdit(parent)
        editor.setFrame(False)
        editor.setStyleSheet("min-width: 0px; margin: 0px; padding: 0px")
        return editor


class PatchesPanel:
    """A panel for FreeCADGui.Control.showDialog: OK gives the object its patches as one undo step.

    obj  a document object that set_patches takes
    """

    modifyStandardButtons = staticmethod(narrow_buttons)

    def __init__(self, obj):
        self.obj, self.said = obj, ""
        self.members = obj.Proxy.faces(obj).members
        self._document = obj.Document.Name
        self.form = Form()
        self.form.setWindowTitle(title_of("MeshQuality_Patches", "Patches"))
        self.form.setWindowIcon(QtGui.QIcon(badge.path_of("MeshQuality_Patches")))
        self._document_watch = ClosesWithDocument(self._document, self.form, self._close)
        self.message = Message()
        self.table = Table(0, 2)
        self.table.setHorizontalHeaderLabels([translate("MeshQuality", "Name"), translate("MeshQuality", "Faces")])
        self.table.horizontalHeader().setStretchLastSection(True)
        self.table.setItemDelegate(_CellEditor(self.table))
        self.table.verticalHeader().hide()
        self.table.setSelectionBehavior(QtGui.QAbstractItemView.SelectRows)
        self.table.setMinimumHeight(_ROWS * self.table.verticalHeader().defaultSectionSize())
        self.rest = QtGui.QLineEdit()
        self.rest.setPlaceholderText(translate("MeshQuality", "each by its own name"))
        self._colours = SourceColours(self.members)
        self._lay_out()
        self._show_object()
        self._shown = _show_in_place([frames.object_of(member.source) for member in self.members], obj)
        if not any(chosen.HasSubObjects for chosen in FreeCADGui.Selection.getSelectionEx()):
            FreeCADGui.Selection.clearSelection()  # a click on a face of what is selected as a whole takes what is around it
        self.table.itemChanged.connect(self._show_colours)
        self.table.itemSelectionChanged.connect(self._select_faces)

    def _lay_out(self):
        layout = QtGui.QVBoxLayout(self.form)
        layout.setContentsMargins(0, 0, 0, 0)
        of = QtGui.QLabel(translate("MeshQuality", "Mesh: {}. Select faces in the 3D view, then add them.").format(
            self.obj.Label))
        of.setWordWrap(True)
        for widget in (of, self.message, self.table):
            layout.addWidget(widget)
        self.new = _button(translate("MeshQuality", "New patch"), translate(
            "MeshQuality", "Make a patch of the faces that are selected in the 3D view"), self.add_patch)
        self.more = _button(translate("MeshQuality", "Add faces"), translate(
            "MeshQuality", "Add the faces that are selected in the 3D view to the patch that is marked in the list"),
            self.add_faces)
        self.colour = _button(translate("MeshQuality", "Colour"), translate(
            "MeshQuality", "Choose the colour of the marked patch"), self.choose_colour)
        self.remove = _button(translate("MeshQuality", "Remove"), translate(
            "MeshQuality", "Remove the marked patches from the list"), self.remove_patches)
        for buttons in ((self.new, self.more), (self.colour, self.remove)):
            row = QtGui.QHBoxLayout()
            for button in buttons:
                row.addWidget(button)
            layout.addLayout(row)
        self.names = QtGui.QComboBox()
        self.names.addItem(translate("MeshQuality", "Take patches from ..."), None)
        for title, by in ((translate("MeshQuality", "labels of parts"), "labels"),
                          (translate("MeshQuality", "colours of faces"), "colours"),
                          (translate("MeshQuality", "an analysis (FEM, CfdOF)"), "analysis")):
            self.names.addItem(title, by)
        self.names.activated.connect(self._take_names)
        layout.addWidget(self.names)
        rest = QtGui.QFormLayout()
        rest.addRow(translate("MeshQuality", "All other faces"), self.rest)
        layout.addLayout(rest)
        layout.addStretch()

    def accept(self):
        """OK: gives the object what the list says, then closes."""
        try:
            patches = self.patches()
            FreeCADGui.doCommand("import MeshQuality as mq")
            rest = self.rest.text().strip() or None
            FreeCADGui.doCommand(f"mq.set_patches({name_of(self.obj)}, {patches!r}, patch_rest={rest!r})")
        except Error as error:
            self._say(translated(error), error=True)
            return False
        self._tell(patches, rest)
        self._close()
        return True

    def _tell(self, patches, rest):
        """The report view says what the mesh has now."""
        one, many = translate("MeshQuality", "{0} (1 face)"), translate("MeshQuality", "{0} ({1} faces)")
        words = ", ".join((one if len(said["faces"]) == 1 else many).format(name, len(said["faces"]))
                          for name, said in patches.items())
        told = translate("MeshQuality", "{0}: patches {1}").format(self.obj.Label, words) if patches \
            else translate("MeshQuality", "{0}: no patches").format(self.obj.Label)
        others = translate("MeshQuality", "all other faces: {0}").format(rest) if rest else ""
        FreeCAD.Console.PrintMessage("; ".join(filter(None, (told, others))) + "\n")

    def reject(self):
        """Cancel: closes."""
        self._close()
        return True

    def _close(self):
        self._document_watch.end()
        if self._document in FreeCAD.listDocuments():
            self._colours.end()
        for view, visible in self._shown:
            if is_there(self._document, view.Object):
                view.Visibility = visible
        FreeCADGui.Control.closeDialog()

    def _show_object(self):
        try:
            patches = patches_of_lines(self.obj.Patches)
        except Error as error:  # a line that was edited in the property editor
            patches = {}
            self._say(translated(error), error=True)
        for name, said in patches.items():
            self._append(name, said["faces"], said.get("colour"))
        self.rest.setText(self.obj.PatchRest)
        if self.obj.PatchesChanged:
            self._say("\n".join(self.obj.PatchesChanged))

    def patches(self):
        """The patches of the list as set_patches takes them."""
        lines = []
        for row in range(self.table.rowCount()):
            name, faces = (self.table.item(row, column).text().strip() for column in (_NAME, _FACES))
            colour = self.table.item(row, _NAME).data(QtCore.Qt.UserRole)
            lines.append(f"{name}{f' {colour}' if colour else ''}: {faces}")
        return patches_of_lines(lines)

    def add_patch(self):
        """Makes a patch of what is selected in the 3D view."""
        faces = self._picked()
        if not faces:
            return
        taken = {self.table.item(row, _NAME).text() for row in range(self.table.rowCount())}
        number = next(n for n in range(1, len(taken) + 2) if f"patch_{n}" not in taken)
        self._withdraw(faces)
        self._append(f"patch_{number}", faces)
        self._mark(self.table.rowCount() - 1)
        self.table.editItem(self.table.item(self.table.rowCount() - 1, _NAME))

    def add_faces(self):
        """Adds what is selected in the 3D view to the marked patch."""
        rows = self._marked()
        if len(rows) != 1:
            self._say(translate("MeshQuality", "Mark one patch in the list first."))
            return
        faces = self._picked()
        if faces:
            self._withdraw(faces)
            self._set_faces(rows[0], [*self._faces(rows[0]), *faces])
            self._mark(rows[0])

    def choose_colour(self):
        """Asks for the colour of the marked patches."""
        rows = self._marked()
        if not rows:
            self._say(translate("MeshQuality", "Mark one patch in the list first."))
            return
        colour = QtGui.QColorDialog.getColor(parent=self.form)
        if colour.isValid():
            for row in rows:
                self._set_colour(row, colour.name())

    def remove_patches(self):
        """Takes the marked patches out of the list."""
        for row in sorted(self._marked(), reverse=True):
            self.table.removeRow(row)
        self._show_colours()

    def _take_names(self, index):
        by = self.names.itemData(index)
        self.names.setCurrentIndex(0)
        if by is None:
            return
        self._say("")
        self._colours.end()  # else they would be taken for the faces' own colours
        try:
            found = suggested_for(self.members, by)
        except Error as error:
            self._say(translated(error), error=True)
            self._show_colours()
            return
        self.table.setRowCount(0)
        for name, said in found.items():
            self._append(name, said["faces"], said.get("colour"))

    def _append(self, name, faces, colour=None):
        row, blocked = self.table.rowCount(), self.table.blockSignals(True)
        self.table.insertRow(row)
        self.table.setItem(row, _NAME, QtGui.QTableWidgetItem(name))
        self.table.setItem(row, _FACES, QtGui.QTableWidgetItem())
        self._set_faces(row, faces)
        self._set_colour(row, colour)
        self.table.blockSignals(blocked)
        self._show_colours()

    def _faces(self, row):
        return [face.strip() for face in self.table.item(row, _FACES).text().split(",") if face.strip()]

    def _set_faces(self, row, faces):
        self.table.item(row, _FACES).setText(", ".join(dict.fromkeys(faces)))

    def _set_colour(self, row, colour):
        self.table.item(row, _NAME).setData(QtCore.Qt.UserRole, colour)

    def _show_colours(self, *_):
        """Shows the colour of each patch in the list and on its faces."""
        blocked, faces = self.table.blockSignals(True), {}
        for row in range(self.table.rowCount()):
            own = self.table.item(row, _NAME).data(QtCore.Qt.UserRole)
            colour = QtGui.QColor(own) if own else QtGui.QColor(*distinct_colour(row))
            shown = QtGui.QPixmap(12, 12)
            shown.fill(colour)
            self.table.item(row, _NAME).setIcon(QtGui.QIcon(shown))
            faces.update(dict.fromkeys(self._faces(row), colour.getRgb()[:3]))
        self.table.blockSignals(blocked)
        self._colours.show(faces)

    def _withdraw(self, faces):
        """Takes faces out of the patches in which they are: each belongs to one."""
        for row in range(self.table.rowCount()):
            self._set_faces(row, [face for face in self._faces(row) if face not in faces])

    def _marked(self):
        return sorted({index.row() for index in self.table.selectionModel().selectedRows()})

    def _mark(self, row):
        """Marks a patch without selecting its faces."""
        blocked = self.table.blockSignals(True)
        self.table.selectRow(row)
        self.table.blockSignals(blocked)

    def _select_faces(self):
        """The faces of the marked patches are selected in the 3D view."""
        if not all(is_there(self._document, frames.object_of(member.source)) for member in self.members):
            return
        FreeCADGui.Selection.clearSelection()
        for row in self._marked():
            for face in self._faces(row):
                for member in self.members:
                    _select(member, face)

    def _picked(self):
        """The faces that are selected in the 3D view; without any says what to do."""
        self._say("")
        label = ", ".join(frames.leaf_of(member.source).Label for member in self.members)
        faces, others = [], None
        try:
            for member in self.members:
                own, beside = _picked_of(member)
                faces += own
                others = beside if others is None else [other for other in others if other in beside]
        except Error as error:
            self._say(translated(error), error=True)
            return []
        if others:
            self._say(translate("MeshQuality", "Not added: {0} is not part of {1}.").format(", ".join(others), label))
        elif not faces:
            self._say(translate("MeshQuality", "Select faces of {} in the 3D view first.").format(label))
        return faces

    def _say(self, text, error=False):
        self.said = text
        self.message.say(text, error)


def _picked_of(member):
    """(names of the faces of a source that are selected, labels of objects with others); a mesh is selected as a whole."""
    if member.count is None:
        wanted = frames.path_from_root(member.source)
        # A click on a mesh names its "Main", the tree nothing.
        chosen = [(selected.Object, path[:path.rfind(".") + 1]) for selected in FreeCADGui.Selection.getSelectionEx("", 0)
                  for path in selected.SubElementNames or ("",)]
        return [member.prefix[:-1]] if wanted in chosen else [], picked(member.source)[1]
    names, others = picked(member.source)
    return [f"{member.prefix}{name}" for name in names if name.rpartition(".")[2].startswith("Face")], others


def _select(member, face):
    """Selects a face in the 3D view where it is one of this source, by the number that it has there."""
    if member.count is None:
        if face == member.prefix[:-1]:
            FreeCADGui.Selection.addSelection(*frames.path_from_root(member.source))
    elif face.startswith(member.prefix) and face[len(member.prefix):].startswith("Face"):
        select_face(member.source, face[len(member.prefix):])


def _show_in_place(sources, mesh):
    """Shows the sources, whose faces are to be selected, in place of their mesh; returns [(view, visible before), ...]."""
    views = [*(source.ViewObject for source in sources), mesh.ViewObject]
    before = [(view, view.Visibility) for view in views]
    for view in views:
        view.Visibility = view is not views[-1]
    return before


def _button(text, tip, clicked):
    button = QtGui.QPushButton(text)
    button.setToolTip(tip)
    button.clicked.connect(lambda: clicked())
    return button
