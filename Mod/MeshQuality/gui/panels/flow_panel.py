# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of Flow mesh: options, the first height for a y+, and walls by the patches that other meshes of the part have."""

import FreeCAD
from PySide import QtGui

from ... import flow_phrases
from ...core.sources import convert, frames
from ...core.volumes.first_height import FLUIDS, first_height
from ...errors import Error, InvalidInput
from ...features.mesh_object import PatchedMesh
from ...features.patches import patches_of_object
from ...phrases import Text
from ..quantities import QuantityBox, Unit, length_text
from ..translation import translated
from .mesh_panel import MeshPanel

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

_FLUIDS = {"air": QT_TRANSLATE_NOOP("MeshQuality", "air of 20 °C"), "water": QT_TRANSLATE_NOOP("MeshQuality", "water of 20 °C")}


class YPlusBox(QtGui.QGroupBox):
    """Fields for the first height by a y+, folded away until the box is checked.

    take(mm)  called with the height when the user wants it
    length    mm, of the wall along the flow, with which the field begins
    """

    def __init__(self, take, length):
        super().__init__(translate("MeshQuality", "First height for a y+"))
        self._take = take
        self.speed, self.y_plus, self.length, self.fluid = QtGui.QDoubleSpinBox(), QtGui.QDoubleSpinBox(), QuantityBox("mm"), QtGui.QComboBox()
        self.said, self.button, self._fields = QtGui.QLabel(), QtGui.QPushButton(translate("MeshQuality", "Use this height")), QtGui.QWidget()
        self.speed.setRange(0.0, 1e6)
        self.speed.setSuffix(" m/s")
        self.speed.setValue(10.0)
        self.y_plus.setRange(0.01, 1000.0)
        self.y_plus.setValue(30.0)
        self.length.setValue(length)
        for fluid in FLUIDS:
            self.fluid.addItem(translate("MeshQuality", _FLUIDS[fluid]), fluid)
        self.said.setWordWrap(True)
        form = QtGui.QFormLayout(self._fields)
        form.setContentsMargins(0, 0, 0, 0)
        form.setRowWrapPolicy(QtGui.QFormLayout.WrapLongRows)
        for title, hint, widget in (
                (translate("MeshQuality", "Speed"), translate("MeshQuality", "Of the free flow, or the mean one in a duct"), self.speed),
                (translate("MeshQuality", "Length"), translate("MeshQuality", "Of the wall along the flow; of a duct its diameter"), self.length),
                (translate("MeshQuality", "Fluid"), "", self.fluid),
                (translate("MeshQuality", "y+"), translate("MeshQuality", "Of the centre of the first cell: 1 where the solver resolves "
                                                           "the layer at the wall, 30 and more with wall functions"), self.y_plus)):
            label = QtGui.QLabel(title)
            for each in (label, widget):
                each.setToolTip(hint)
            form.addRow(label, widget)
        form.addRow(self.said)
        form.addRow(self.button)
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(4, 9, 4, 4)
        layout.addWidget(self._fields)
        self.setCheckable(True)
        self.setChecked(False)
        self._fields.hide()
        self.toggled.connect(self._fields.setVisible)
        self.button.clicked.connect(lambda: self._take(Unit.of(self.height()).rounded(self.height(), 3)))
        for signal in (self.speed.valueChanged, self.y_plus.valueChanged, self.length.valueChanged, self.fluid.currentIndexChanged):
            signal.connect(self._show)
        self._show()

    def height(self):
        """The FirstHeight; raises InvalidInput."""
        if self.speed.value() <= 0.0 or self.length.value() <= 0.0:
            raise InvalidInput(Text(flow_phrases.NEEDS_NUMBERS))
        return first_height(self.speed.value(), self.length.value(), self.fluid.currentData(), self.y_plus.value())

    def _show(self, *_):
        try:
            found = self.height()
            text = translate("MeshQuality", "{0}, as on a flat plate with a Reynolds number of {1}. Check the y+ that the solver finds.").format(
                length_text(found), f"{found.reynolds:.3g}")
        except Error as error:
            found, text = None, translated(error)
        self.said.setText(text)
        self.button.setEnabled(found is not None)


class FlowPanel(MeshPanel):
    """A MeshPanel that helps with the first height and the walls."""

    def _lay_out(self):
        super()._lay_out()
        self.y_plus = YPlusBox(lambda height: self.options.set_values({"first_height": height}), self._size)
        self.by_patch = QtGui.QComboBox()
        self.by_patch.addItem(translate("MeshQuality", "Add a patch to the walls ..."))
        self.by_patch.setToolTip(translate("MeshQuality", "Patches of this mesh, and of other meshes of the part"))
        for name, faces in _patches_for(self.operations).items():
            self.by_patch.addItem(name, faces)
        self.by_patch.setVisible(self.by_patch.count() > 1)
        self.by_patch.activated.connect(self._add_patch)
        place = self.fields.layout().indexOf(self.options)
        for widget in (self.by_patch, self.y_plus):
            self.fields.layout().insertWidget(place, widget)

    def _add_patch(self, row):
        faces = self.by_patch.itemData(row)
        self.by_patch.setCurrentIndex(0)
        if faces:
            self.options.set_values({"walls": list(dict.fromkeys([*(self.options.values()["walls"] or []), *faces]))})

    def _enable(self, enabled):
        super()._enable(enabled)
        for widget in (self.by_patch, self.y_plus):
            widget.setEnabled(enabled)


def _patches_for(operations):
    """{patch: names of faces} of meshes of the source; {} for several sources."""
    if len(operations) != 1 or operations[0].sources[0] is None:
        return {}
    source, found = operations[0].sources[0], {}
    meshes = [user for user in frames.object_of(source).InList if isinstance(getattr(user, "Proxy", None), PatchedMesh)
              and user.Proxy.sources(user) == [source]]
    for mesh in meshes:
        try:
            patches, rest = patches_of_object(mesh)
        except Error:  # edited by hand
            continue
        for name, said in (patches or {}).items():
            found.setdefault(name, said["faces"])
        if rest:
            named = {face for said in (patches or {}).values() for face in said["faces"]}
            count = convert.own_shape_of(source).countElement("Face")
            found.setdefault(rest, [face for face in (f"Face{i + 1}" for i in range(count)) if face not in named])
    return found
