# SPDX-License-Identifier: LGPL-2.1-or-later
"""The work that goes on without a panel, in FreeCAD's status bar: what is done, how far it is, and a
button that cancels it.
"""

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from . import jobs
from .translation import translated

translate = FreeCAD.Qt.translate

_WIDE = 140  # pixels of the progress bar
_SHORT = 400  # ms: work that ends sooner is not shown

_indicator = None


def tell(job, cancel=None):
    """Has the status bar tell of a job until it has ended, and how it ended.

    cancel  cancel(), called where the user wants it to end; else the job is cancelled
    """
    indicator().add(job, cancel or job.cancel)


def indicator():
    """The Indicator of FreeCAD's window."""
    global _indicator
    if _indicator is None:
        _indicator = Indicator(FreeCADGui.getMainWindow().statusBar())
    return _indicator


class Indicator(QtGui.QWidget):
    """What the status bar shows of the first of its jobs; hidden without one."""

    def __init__(self, status_bar):
        super().__init__(status_bar)
        self._status_bar = status_bar
        self._jobs = []  # (job, what cancels it), in the order in which they run
        self.text, self.bar = QtGui.QLabel(), QtGui.QProgressBar()
        self.button = QtGui.QPushButton()
        self.bar.setRange(0, 1000)
        self.bar.setMaximumWidth(_WIDE)
        self.bar.setFormat("%p %")
        self.button.clicked.connect(self._cancel)
        layout = QtGui.QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        for widget in (self.text, self.bar, self.button):
            layout.addWidget(widget)
        self._timer = QtCore.QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(_SHORT)
        self._timer.timeout.connect(self.show)
        status_bar.addPermanentWidget(self)
        self.hide()

    def add(self, job, cancel):
        """Shows one more job."""
        if not self._jobs:
            self._timer.start()
        self._jobs.append((job, cancel))
        job.changed.connect(self._show)
        job.ended.connect(lambda: self._end(job))
        job.returned.connect(lambda: self._end(job, has_ended()))
        self._show()

    def _end(self, job, more=""):
        if not job.over:
            self._show()
            return
        self._jobs = [(other, cancel) for other, cancel in self._jobs if other is not job]
        why = translated(job.error) if job.state == jobs.FAILED else jobs.state_text(job.state)
        self._status_bar.showMessage("; ".join(filter(None, (f"{job.title}: {why}", more))))
        self._show()

    def _show(self):
        if not self._jobs:
            self._timer.stop()
            self.hide()
            return
        job = self._jobs[0][0]
        more = f" (+{len(self._jobs) - 1})" if len(self._jobs) > 1 else ""
        self.text.setText(f"{job.title}{more}: {_doing(job)}")
        for widget in (self.bar, self.button):
            widget.setVisible(job.active)
        self.bar.setValue(int(1000 * job.fraction))
        self.button.setText(translate("MeshQuality", "Cancel"))
        self.button.setToolTip(translate("MeshQuality", "Cancel “{}”; nothing is changed").format(job.title))

    def _cancel(self):
        if self._jobs:
            self._jobs[0][1]()


def has_ended():
    """The message once a cancelled job is over."""
    return translate("MeshQuality", "what could not be interrupted has ended")


def _doing(job):
    return job.doing if job.active else f"{jobs.state_text(job.state)}; {job.doing}"
