# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of objects that are computed: options, progress in the background, and errors."""

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from .. import options
from ..errors import Error
from ..features import mesh_object
from . import jobs
from .option_form import OptionForm

_TRIAL = 50_000  # triangles of a trial for the estimate
_PAUSE = 400  # ms without a change before a trial begins


class Operation:
    """What a panel does: a command's name for people, its table of options, and its objects.

    title     for windows and undo
    table     of options
    sources   document objects
    work      work(values) -> mesh_object.Work
    call      call(values) -> the line of Python that adds the object, for the macro too
    trial     trial(values, most) -> compute(progress) -> (number of triangles, whether these are
              all), for an estimate with `most` triangles; None: no estimate
    """

    def __init__(self, title, table, sources, work, call, trial=None):
        self.title, self.table, self.sources = title, table, sources
        self.work, self.call, self.trial = work, call, trial


class MeshPanel:
    """A panel for FreeCADGui.Control.showDialog: OK computes in the background, then closes.

    operations  one for each object to be added, all with the same table
    While jobs run Cancel ends them; else it closes the panel.
    """

    def __init__(self, operations, values=None, hidden=()):
        self.operations = operations
        self.jobs = []
        self.said = ""  # the message, which ends with the panel
        self._trial = None
        self.form = QtGui.QWidget()
        self.form.setWindowTitle(operations[0].title)
        layout = QtGui.QVBoxLayout(self.form)
        of = QtGui.QLabel("Of " + ", ".join(source.Label for operation in operations
                                           for source in operation.sources))
        self.options = OptionForm(operations[0].table, hidden)
        self.options.set_values(values or {})
        self.estimate, self.message, self.bar = QtGui.QLabel(), QtGui.QLabel(), QtGui.QProgressBar()
        self.estimate.setVisible(operations[0].trial is not None)
        for label in (of, self.estimate, self.message):
            label.setWordWrap(True)
        for widget in (of, self.options, self.estimate, self.bar, self.message):
            layout.addWidget(widget)
        layout.addStretch()
        self.bar.setRange(0, 1000)
        self.bar.hide()
        self._timer = QtCore.QTimer(self.form)
        self._timer.setSingleShot(True)
        self._timer.setInterval(_PAUSE)
        self._timer.timeout.connect(self._start_trial)
        self.options.changed.connect(self._options_changed)
        self._options_changed()

    def getStandardButtons(self):
        buttons = QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Cancel
        return int(getattr(buttons, "value", buttons))

    def accept(self):
        """OK: begins the work; the panel closes when it has succeeded."""
        self._end_trial()
        if not self.jobs:
            self._start()
        return False

    def reject(self):
        """Cancel: ends the running work, or closes the panel."""
        if self.jobs:
            for job in list(self.jobs):
                job.cancel()
            return False
        self._end_trial()
        FreeCADGui.Control.closeDialog()
        return True

    def _start(self):
        try:
            values = options.check(self.operations[0].table, self.options.values())
            works = [operation.work(values) for operation in self.operations]
        except (Error, ImportError) as error:
            self._say(str(error))
            return
        self.options.setEnabled(False)
        self.bar.setValue(0)
        self.bar.show()
        self._say("")
        self.jobs = [self._job(operation, work, values)
                     for operation, work in zip(self.operations, works)]
        for job in list(self.jobs):
            jobs.queue().add(job)

    def _job(self, operation, work, values):
        document = operation.sources[0].Document.Name
        job = jobs.Job(operation.title, work.compute,
                       lambda result: _add(operation, document, work.fingerprint, values, result),
                       lambda: _present(document, operation.sources))
        job.changed.connect(lambda: self._show_progress(job))
        job.ended.connect(lambda: self._ended(job))
        return job

    def _show_progress(self, job):
        self.bar.setValue(int(1000 * job.fraction))
        self.bar.setFormat(f"{job.stage or job.state}: %p %")

    def _ended(self, job):
        self.jobs.remove(job)
        if job.state == jobs.CANCELLED:
            self._say("Cancelled; nothing was changed.")
        elif job.state == jobs.FAILED:
            self._say(str(job.error))
        if self.jobs:
            return
        self.bar.hide()
        self.options.setEnabled(True)
        if not self.said:
            FreeCADGui.Control.closeDialog()

    def _say(self, text):
        self.said = text
        self.message.setText(text)
        self.message.setVisible(bool(text))

    def _options_changed(self):
        self._say("")
        self._end_trial()
        if self.operations[0].trial is not None:
            self.estimate.setText("Counting triangles ...")
            self._timer.start()

    def _start_trial(self):
        try:
            values = options.check(self.operations[0].table, self.options.values())
            trials = [operation.trial(values, _TRIAL) for operation in self.operations]
        except Error as error:
            self.estimate.setText("")
            self._say(str(error))
            return
        self._trial = jobs.queue().add(jobs.Job(
            "Estimate", lambda progress: [trial(progress) for trial in trials],
            self._show_estimate, quiet=True))

    def _show_estimate(self, found):
        count = sum(triangles for triangles, _ in found)
        more = "" if all(complete for _, complete in found) else "more than "
        self.estimate.setText(f"{more}{count:,} triangles".capitalize())

    def _end_trial(self):
        self._timer.stop()
        if self._trial is not None and self._trial.active:
            self._trial.cancel()
        self._trial = None


def _present(document, sources):
    """Whether the sources still are in the document of this name."""
    if document not in FreeCAD.listDocuments():
        return False
    objects = FreeCAD.getDocument(document).Objects
    return all(source in objects for source in sources)


def _add(operation, document, fingerprint, values, result):
    """Adds the object by a line of Python that the macro records; it finds its result ready."""
    document = FreeCAD.getDocument(document)
    mesh_object.ahead[fingerprint] = result
    document.openTransaction(operation.title)
    try:
        FreeCADGui.doCommand("import MeshQuality as mq")
        FreeCADGui.doCommand(operation.call(values))
    except BaseException:
        document.abortTransaction()
        raise
    finally:
        mesh_object.ahead.pop(fingerprint, None)
    document.commitTransaction()
