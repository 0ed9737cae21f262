# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panel of objects that are computed: options, progress in the background, and errors."""

from functools import partial

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from ... import phrases
from ...compat import flags
from ...core.operands.operands import letters
from ...core.sources import frames
from ...errors import Error
from .. import background, background_recompute, jobs, panel_operation, preferences, selection
from ..certificate_box import CertificateBox
from ..quantities import count_text, length_text
from ..translation import translated
from ..view import badge
from .option_form import OptionForm
from .preset_box import PresetBox
from .task_form import ClosesWithDocument, Form, Message, Scrolled, bring_into_sight, is_in_task_view, narrow_buttons

_PAUSE = 400  # ms without a change before a trial begins

translate = FreeCAD.Qt.translate


class MeshPanel:
    """A panel for FreeCADGui.Control.showDialog. Apply computes in the background, OK closes the
    panel besides when that has succeeded.

    operations  one for each object, all with the same table
    editing     whether the panel was opened by a double click on its object
    afterwards  afterwards(obj), called with the first object once OK has closed the panel; or None
    While jobs run Cancel ends them; else it closes the panel. Changes by Apply stay. The panel
    can be closed while they run, too: then the status bar shows them.
    """

    def __init__(self, operations, editing=False, afterwards=None):
        self.operations = operations
        self.jobs = []
        self.said = ""  # the message, which ends with the panel
        self._editing, self._afterwards = editing, afterwards
        self._closing = False  # whether the panel closes once its jobs are done
        self._cancel, self._applied = None, False  # the button; whether work has changed the document
        self._trial = None  # the Job
        self._trials = []  # a Trial for each operation, once they have been computed
        self._left = False  # whether the jobs go on without the panel
        self._finishing = None  # the cancelled job that the message is about
        self._size = max(made.size() for made in operations)
        self._kept_length = operations[0].kind.kept_length(operations[0].sources)
        self.form = Form()
        self.form.setWindowTitle(title_of(operations[0].kind.COMMAND, operations[0].title))
        self.form.setWindowIcon(QtGui.QIcon(badge.path_of(operations[0].kind.COMMAND)))
        self._document_watch = ClosesWithDocument(operations[0].document, self.form, self._document_gone)
        useful = preferences.suggested(operations[0].kind, self._size)
        self.options = OptionForm(operations[0].kind.OPTIONS,
                                  [source for made in operations for source in made.sources],
                                  {**preferences.defaults(operations[0].kind), **useful}, operations[0].kind.COMMAND)
        self.options.set_values(
            operations[0].values() or {**preferences.first_values(operations[0].kind), **useful, **operations[0].chosen})
        self._show_bound()
        self.presets = PresetBox(operations[0].kind.PRESETS)
        self._lay_out()
        self.presets.chosen.connect(self.options.set_values)
        self._timer = QtCore.QTimer(self.form)
        self._timer.setSingleShot(True)
        self._timer.setInterval(_PAUSE)
        self._timer.timeout.connect(self._start_trial)
        self.options.changed.connect(self._options_changed)
        self._options_changed()

    def _lay_out(self):
        of = QtGui.QLabel(_sources_text(self.operations))
        of.setVisible(bool(of.text()))
        self.swap = QtGui.QPushButton(translate("MeshQuality", "Swap A and B"))
        self.swap.setToolTip(translate("MeshQuality", "A difference is the first operand without the second one"))
        self.swap.setVisible(_has_order(self.operations))
        self.swap.clicked.connect(lambda: self._swap(of))
        self.estimate, self.message, self.bar = QtGui.QLabel(), Message(), QtGui.QProgressBar()
        self.doing = QtGui.QLabel()
        self.estimate.setVisible(self.operations[0].trial is not None)
        self.certificate = CertificateBox()
        self.button = QtGui.QPushButton(translate("MeshQuality", "Apply"))
        self.button.setToolTip(translate("MeshQuality", "Computes the mesh and leaves the panel open"))
        self.button.clicked.connect(self.apply)
        self.leave = QtGui.QPushButton(translate("MeshQuality", "Continue in background"))
        self.leave.setToolTip(translate("MeshQuality", "Closes the panel; the status bar shows the progress "
                                                       "and can cancel the work"))
        # Once the click is over: the panel goes, and the button with it.
        self.leave.clicked.connect(lambda: QtCore.QTimer.singleShot(0, self.continue_in_background))
        self.leave.hide()
        layout = QtGui.QVBoxLayout(self.form)
        layout.setContentsMargins(0, 0, 0, 0)
        for label in (of, self.estimate, self.doing):
            label.setWordWrap(True)
        self.fields = QtGui.QWidget()
        fields = QtGui.QVBoxLayout(self.fields)
        fields.setContentsMargins(0, 0, 0, 0)
        for widget in (self.presets, self.options):
            fields.addWidget(widget)
        self.lowest = Scrolled(self.fields)  # kept: else PySide may end what Python says of it
        # What tells of the work comes first, where it is seen however long the options are.
        for widget in (of, self.swap, self.message, self.estimate, self.doing, self.bar, self.button, self.leave, self.certificate,
                       self.lowest):
            layout.addWidget(widget)
        layout.addStretch()
        self.bar.setRange(0, 1000)
        self.bar.setFormat("%p %")
        self._show_work(False)
        self.certificate.show(self._edited())

    def _swap(self, of):
        """The operands in the other order."""
        self.operations[0].sources.reverse()
        of.setText(_sources_text(self.operations))
        self._options_changed()

    def _show_bound(self):
        """Expressions may come and go, and change their values, while the panel is open."""
        self.options.bind(self.operations[0].expressions(), self.operations[0].values())

    def _shows(self):
        """Whether the panel still tells of its jobs."""
        return not self._left and is_in_task_view(self.form)

    def _edited(self):
        """The object that the panel edits; None when it adds, or edits several."""
        return self.operations[0].obj if len(self.operations) == 1 else None

    def getStandardButtons(self):
        # A third one would not fit into the width that FreeCAD's task view has at first.
        return flags(QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Cancel)

    def modifyStandardButtons(self, box):
        """Called by FreeCAD with its buttons."""
        narrow_buttons(box)
        self._cancel = box.button(QtGui.QDialogButtonBox.Cancel)

    def _name_cancel(self):
        """Cancel ends running work; once Apply has done something, which stays, there is nothing more to cancel."""
        if self._cancel is not None:
            self._cancel.setText(translate("MeshQuality", "Close") if self._applied and not self.jobs
                                 else translate("MeshQuality", "Cancel"))

    def apply(self):
        """Begins the work; the panel stays open, and edits what was made."""
        self._closing = False
        self._start()

    def accept(self):
        """OK: begins the work; the panel closes when it has succeeded."""
        self._closing = True
        self._start()
        return False

    def reject(self):
        """Cancel: ends the running work, or closes the panel."""
        if self.jobs:
            for job in list(self.jobs):
                job.cancel()
            return False
        self._close()
        return True

    def continue_in_background(self):
        """Closes the panel while its jobs go on, told of in the status bar. Each lands as one step of
        undo; one that fails says so in the report view.
        """
        self._left = True
        for job in self.jobs:
            background.tell(job)
        self._close()

    def _document_gone(self):
        """The document is closed: its jobs end by themselves."""
        self._left, self._editing = True, False
        self._end_trial()
        FreeCADGui.Control.closeDialog()

    def _close(self):
        self._document_watch.end()
        self._end_trial()
        if self._edited() is not None:
            self.certificate.end()
        if self._editing:
            self._editing = False
            if self.operations[0].document in FreeCAD.listDocuments():
                FreeCADGui.getDocument(self.operations[0].document).resetEdit()
        FreeCADGui.Control.closeDialog()

    def _start(self):
        if self.jobs:
            return
        self._end_trial()
        if not self._trials:
            self.estimate.setText("")
        self._show_bound()
        try:
            values = panel_operation.check(self.operations, self.options.values())
            works = [made.work(values) for made in self.operations]
        except (Error, ImportError) as error:
            self._say(translated(error), error=True)
            return
        self._say("")
        preferences.remember(self.operations[0].kind, values)
        trials = self._trials or [None] * len(works)
        self.jobs = [self._job(made, work, trial) for made, work, trial in zip(self.operations, works, trials)
                     if not made.is_done(work)]
        self._trials = []
        self._enable(not self.jobs)
        self.bar.setValue(0)
        self._show_work(bool(self.jobs))
        bring_into_sight(self.bar)
        for job in list(self.jobs):
            jobs.queue().add(job)
        self._close_if_done()

    def _job(self, made, work, trial):
        watch, edited = panel_operation.Watch(made.sources), made.obj
        if edited is not None:
            background_recompute.stop(edited)
        compute = work.result if trial is None else partial(trial.result_of, work)
        job = jobs.Job(title_of(made.kind.COMMAND, made.title), compute,
                       lambda result: made.land(work, result, watch), lambda: made.possible(edited),
                       obstacle=lambda: made.obstacle_beside_tasks() if self._left else made.obstacle(),
                       taking=jobs.ADDING)
        job.changed.connect(lambda: self._show_progress(job))
        job.ended.connect(lambda: self._ended(job, watch))
        job.returned.connect(lambda: self._returned(job))
        return job

    def _show_progress(self, job):
        if self._shows() and self.jobs[:1] == [job]:
            self.bar.setValue(int(1000 * job.fraction))
            self.doing.setText(job.doing)

    def _ended(self, job, watch):
        watch.end()
        self.jobs.remove(job)
        if not job.over and not self._left:
            background.tell(job)
        if not self._shows():
            return
        if job.state == jobs.CANCELLED:
            self._say_cancelled(job, "" if job.over else job.doing)
        elif job.state == jobs.FAILED:
            self._say(translated(job.error), error=True)
        else:
            self._applied = True
        if self.jobs:
            return
        self._show_work(False)
        self._enable(True)
        self.certificate.show(self._edited())
        self._close_if_done()

    def _returned(self, job):
        if self._shows() and job is self._finishing:
            self._say_cancelled(job, background.has_ended())

    def _say_cancelled(self, job, rest):
        self._say("\n".join(filter(None, (translate("MeshQuality", "Cancelled; nothing was changed."), rest))))
        self._finishing = job

    def _show_work(self, shown):
        self.doing.setVisible(shown)
        self.bar.setVisible(shown)

    def _enable(self, enabled):
        for widget in (self.presets, self.options, self.swap):
            widget.setEnabled(enabled)
        self.button.setVisible(enabled)
        self.leave.setVisible(not enabled)
        self._name_cancel()

    def _close_if_done(self):
        if self._closing and not self.jobs and not self.said:
            is_new = not self._editing
            self._close()
            obj = self.operations[0].obj
            if is_new:
                selection.follow([source for made in self.operations for source in made.sources],
                                 [made.obj for made in self.operations if made.obj is not None])
            if self._afterwards is not None and obj is not None:
                # FreeCAD takes the panel away when control returns to the event loop.
                QtCore.QTimer.singleShot(0, lambda: self._afterwards(obj))

    def _say(self, text, error=False, scroll=True):
        self.said, self._finishing = text, None
        self.message.say(text, error, scroll)

    def _options_changed(self):
        edited = self._edited()
        deleted = edited is not None and edited.Proxy.lacks_source(edited)
        self._say(translated(phrases.Text(phrases.SOURCE_GONE)) if deleted else "", error=deleted)
        self._end_trial()
        self._trials = []
        self.presets.show(self.options.values(), self._size)
        if self.operations[0].trial is not None and not deleted:
            self._counting()
            self._timer.start()
        if self._kept_length is not None:
            kept = length_text(self._kept_length(self.options.values()))
            self.estimate.setText(translate("MeshQuality", "Keeps within {} of the exact result.").format(kept))
            self.estimate.show()

    def _counting(self):
        self.estimate.setText(self.operations[0].trial.func.begun())

    def _start_trial(self):
        try:
            values = panel_operation.check(self.operations, self.options.values())
            trials = [made.trial(values, made.obj) for made in self.operations]
        except Error as error:
            self.estimate.setText("")
            self._say(translated(error), error=True, scroll=False)
            return
        if len(jobs.queue()):
            self.estimate.setText(translate("MeshQuality", "The triangles are counted when other work has finished."))
        self._trial = jobs.queue().add(jobs.Job(
            translate("MeshQuality", "Counting triangles"), lambda progress: [trial.compute(progress) for trial in trials],
            lambda _: self._show_estimate(trials), quiet=True, prepare=self._counting))
        job = self._trial
        job.ended.connect(lambda: job is self._trial and job.state == jobs.FAILED and self.estimate.setText(translated(job.error)))

    def _show_estimate(self, trials):
        self._trials = trials
        self.estimate.setText(trials[0].words(trials).format(count_text(sum(trial.count for trial in trials))))

    def _end_trial(self):
        self._timer.stop()
        if self._trial is not None and self._trial.active:
            self._trial.cancel()
        self._trial = None


def _has_order(operations):
    """Whether there are two operands whose order counts."""
    return "operation" in {option.name for option in operations[0].kind.OPTIONS} and len(operations[0].sources) == 2


def _sources_text(operations):
    """Names the sources; several operands by their letters, too, as messages do."""
    labels = [frames.leaf_of(source).Label for made in operations for source in made.sources if source is not None]
    if "Sources" in operations[0].kind.LINKS and len(labels) > 1:
        operands = (f"{letter} = {label}" for letter, label in zip(letters(len(labels)), labels))
        return translate("MeshQuality", "Operands: {}").format(", ".join(operands))
    return translate("MeshQuality", "Source: {}").format(", ".join(labels)) if labels else ""


def title_of(command, text):
    """The text of a command as a title, in the user's language."""
    return translate(command, f"{text}...").rstrip(".")
