# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of Repair Mesh: what is wrong with a mesh, and where, beside what computes the repaired one."""

import FreeCAD
import FreeCADGui
import numpy as np

from ...compat import extension
from ...core.certify.faults import find_faults
from ...core.sources import convert
from ..view.quality_scene import QualityScene
from .faults_box import AROUND, FaultsBox
from .mesh_panel import MeshPanel

translate = FreeCAD.Qt.translate


class RepairPanel(MeshPanel):
    """A MeshPanel that lists the faults of its source's mesh, lights them up and moves the camera there."""

    def _lay_out(self):
        super()._lay_out()
        self.faults, self.scene, self._corners = FaultsBox(), None, None
        self.form.layout().insertWidget(1, self.faults)
        source, = self.operations[0].sources
        if source is None:
            self.faults.hide()
            return
        mesh = convert.MeshCopy(source)
        self.faults.picked.connect(self._light_up)
        self.faults.begin(lambda progress: self._find(mesh, progress))

    def _find(self, mesh, progress):
        vertices, triangles = mesh.arrays
        self._corners = vertices[triangles].astype(np.float32)
        return find_faults(convert.surface_of_arrays(extension(), vertices, triangles, measured=False), progress)

    def _light_up(self, chosen, place):
        if self.scene is None:
            self.scene = QualityScene(FreeCADGui.getDocument(self.operations[0].document).activeView())
        self.scene.light_up(self._corners[chosen])
        if len(place):
            self.scene.fly_to(self._corners[place], AROUND, within=self._corners)

    def _end_scene(self):
        self.faults.end()
        if self.scene is not None:
            self.scene.close()
            self.scene = None

    def _close(self):
        self._end_scene()
        super()._close()

    def _document_gone(self):
        self.faults.end()
        super()._document_gone()
