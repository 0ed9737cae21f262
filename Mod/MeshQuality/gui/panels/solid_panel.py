# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of To Solid: what of a mesh becomes exact, what stays facets and why, before the solid is added."""

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from ...errors import Error
from ...features import mesh_solid
from .. import jobs, selection
from ..panel_operation import name_of
from ..translation import translated
from .task_form import Message
from .writing_panel import WritingPanel

translate = FreeCAD.Qt.translate


class SolidPanel(WritingPanel):
    """Makes the solid in the background, tells of it, and adds it with OK.

    source  a document object with a closed mesh, or a link to one, see frames
    """

    COMMAND, TITLE = "MeshQuality_ToSolid", "To solid"

    def __init__(self, source):
        self.found = None  # (whether facets were allowed, the MeshSolid)
        self._accepted = False
        super().__init__(source)
        QtCore.QTimer.singleShot(0, self._start)

    def add_fields(self, layout):
        of, self.made = QtGui.QLabel(translate("MeshQuality", "Mesh: {0}").format(self.label)), Message()
        of.setWordWrap(True)
        self.facets = QtGui.QCheckBox(translate("MeshQuality", "Facets where surfaces are not known"))
        self.facets.setToolTip(translate("MeshQuality", "A single face that is not known turns all faces into planar facets; off: the mesh is refused then"))
        self.facets.setChecked(True)
        layout.addWidget(of)
        self.add_work(layout)
        layout.addWidget(self.made)
        layout.addWidget(self.facets)
        self.facets.toggled.connect(self._start)

    def _enable(self, enabled):
        self.bar.setVisible(not enabled)
        self.facets.setVisible(enabled)  # dark style sheets have the text of what is disabled as light as FreeCAD's panels

    @staticmethod
    def said_of_cancelling():
        return translate("MeshQuality", "Cancelled; nothing was changed.")

    def accept(self):
        """OK: adds the solid; waits for it first."""
        self._accepted = True
        if self.job is None:
            self._add() if self.found is not None else self._start()
        return False

    def prepare(self):
        self.found, facets = None, self.facets.isChecked()
        self.made.say("")
        make = mesh_solid.maker_of(self.source, facets)
        return make, lambda solid: self._take(facets, solid)

    def _take(self, facets, solid):
        self.found = facets, solid
        self.made.say("\n".join(map(translated, mesh_solid.sentences_of(solid))))

    def _ended(self):
        job, self.job = self.job, None
        self._enable(True)
        if job.state == jobs.FAILED:
            self._fail(job.error)
        elif job.state != jobs.DONE:
            self.say(self.said_of_cancelling())
        elif self._accepted:
            self._add()
            return
        self._accepted = False

    def _fail(self, error):
        text = translated(error)
        self.say(text[:1].upper() + text[1:], error=True)

    def _add(self):
        facets, solid = self.found
        forget = mesh_solid.remember(self.source, facets, solid)
        FreeCADGui.doCommand("import MeshQuality as mq")
        try:
            FreeCADGui.doCommand(f"mq.add_solid({name_of(self.source)}{'' if facets else ', facets=False'})")
        except Error as error:
            self._fail(error)
            return
        finally:
            forget()
        self._close()
        selection.follow([self.source], [self.obj.Document.ActiveObject])
