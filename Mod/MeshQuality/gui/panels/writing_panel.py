# SPDX-License-Identifier: LGPL-2.1-or-later
"""The common base of panels that write files in the background."""

import os

import FreeCAD
import FreeCADGui
from PySide import QtGui

from ...core.sources import frames
from ...errors import Error
from .. import background, jobs, preferences
from ..panel_operation import is_there
from ..translation import translated
from ..view import badge
from .mesh_panel import title_of
from .task_form import ClosesWithDocument, Form, Message, is_in_task_view, narrow_buttons

translate = FreeCAD.Qt.translate


class WritingPanel:
    """A panel for FreeCADGui.Control.showDialog: OK writes, then closes unless it STAYS; what goes wrong is said in the panel.

    A subclass has
    COMMAND, TITLE      its command, and the text of that
    add_fields(layout)  lays out its fields, with `add_work` where the progress is to be; sets `fields`, which are
                        not edited meanwhile
    prepare()           (work(progress), land(result)): the first is called on another thread, the second then on
                        this one; raises an error of MeshQuality where that is not possible
    source  what is written: a document object or a link, see frames
    """

    COMMAND = TITLE = ""
    STAYS = False  # whether the panel stays open when the work has succeeded
    DROP = staticmethod(lambda result: None)  # called with a result that nobody takes

    def __init__(self, source):
        self.source, self.obj = source, frames.object_of(source)
        self.document, self.label = self.obj.Document.Name, frames.leaf_of(source).Label
        self.job, self.said, self.fields, self._cancel = None, "", (), None
        self.form = Form()
        self.form.setWindowTitle(title_of(self.COMMAND, self.TITLE))
        self.form.setWindowIcon(QtGui.QIcon(badge.path_of(self.COMMAND)))
        self._document_watch = ClosesWithDocument(self.document, self.form, self._close)
        self.message, self.bar = Message(), QtGui.QProgressBar()
        self.bar.setRange(0, 0)
        self.bar.hide()
        layout = QtGui.QVBoxLayout(self.form)
        layout.setContentsMargins(0, 0, 0, 0)
        self.add_fields(layout)
        layout.addStretch()

    def add_work(self, layout):
        """Lays out what tells of the work."""
        layout.addWidget(self.message)
        layout.addWidget(self.bar)

    def modifyStandardButtons(self, box):
        """Called by FreeCAD with its buttons."""
        narrow_buttons(box)
        self._cancel = box.button(QtGui.QDialogButtonBox.Cancel)

    def accept(self):
        """OK: begins to write."""
        if self.job is None:
            self._start()
        return False

    def reject(self):
        """Cancel: forgets what is being written, or closes the panel."""
        if self.job is not None:
            self.job.cancel()
            return False
        self._close()
        return True

    def say(self, text, error=False):
        """Shows a sentence in the panel."""
        self.said = text
        self.message.say(text, error)

    @staticmethod
    def said_of_cancelling():
        """The message of the panel once the work was cancelled."""
        return translate("MeshQuality", "Cancelled; no file was written.")

    @staticmethod
    def first_folder():
        """Where files were written the last time."""
        return preferences.stored().GetString("ExportFolder", "") or os.path.expanduser("~")

    @staticmethod
    def remember_folder(folder):
        """Keeps the folder with which the next panel begins."""
        preferences.stored().SetString("ExportFolder", folder)

    def _start(self):
        try:
            work, land = self.prepare()
        except (Error, ImportError) as error:
            self.say(translated(error), error=True)
            return
        self._enable(False)
        self.say("")
        self.job = jobs.Job(self.form.windowTitle(), work, land, lambda: is_there(self.document, self.obj),
                            drop=self.DROP)
        self.job.changed.connect(self._tell)
        self.job.ended.connect(self._ended)
        jobs.queue().add(self.job)

    def _tell(self):
        """What is said while the work goes on."""
        if self.job is not None and self.job.time and is_in_task_view(self.form):
            self.say(self.job.time)

    def _ended(self):
        job, self.job = self.job, None
        if not job.over:
            background.tell(job)
        if not is_in_task_view(self.form):
            return
        self._enable(True)
        if job.state == jobs.DONE and not self.STAYS:
            self._close()
        elif job.state == jobs.DONE and self._cancel is not None:
            self._cancel.setText(translate("MeshQuality", "Close"))
        elif job.state == jobs.FAILED:
            self.say(translated(job.error), error=True)
        elif job.state == jobs.CANCELLED:
            self.say(self.said_of_cancelling())

    def _enable(self, enabled):
        self.bar.setVisible(not enabled)
        for widget in self.fields:
            widget.setEnabled(enabled)

    def _close(self):
        self._document_watch.end()
        FreeCADGui.Control.closeDialog()
