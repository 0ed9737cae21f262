# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work in the background: one job after the other on a thread, watched from the GUI's thread.

A job computes on the thread and touches neither documents nor widgets there; its result is taken
on the GUI's thread. The core frees Python's lock while it works, so that the window stays alive.
"""

import collections
import os
import sys
import threading

import FreeCAD
from PySide import QtCore

from ..errors import Cancelled, Error

translate = FreeCAD.Qt.translate

WAITING, RUNNING, DONE, FAILED, CANCELLED = "waiting", "running", "done", "failed", "cancelled"
_POLL = 30  # ms between two looks at the thread
_NICENESS = 5
_GRACE = 5.0  # s that a job has to end in when FreeCAD quits


def state_text(state):
    """A state of a job, in the user's language."""
    return {
        WAITING: translate("MeshQuality", "waiting"), RUNNING: translate("MeshQuality", "running"),
        DONE: translate("MeshQuality", "done"), FAILED: translate("MeshQuality", "failed"),
        CANCELLED: translate("MeshQuality", "cancelled"),
    }[state]


class Job(QtCore.QObject):
    """One piece of work.

    title    what is shown for it
    compute  compute(progress) -> result, called on the thread; progress as for triangulate
    take     take(result), called on the GUI's thread
    wanted   wanted() -> whether the result still has a place to go to, asked on the GUI's thread
    quiet    a failure is not reported
    drop     drop(result), called on the GUI's thread instead of take where the job was cancelled
             after the work had ended
    prepare  prepare(), called on the GUI's thread when the work starts
    ready    ready() -> whether the result can be taken now; asked again and again

    The window stays alive between taking a result and the signal `ended`.
    """

    changed = QtCore.Signal()  # state, fraction or stage
    ended = QtCore.Signal()

    def __init__(self, title, compute, take, wanted=lambda: True, quiet=False,
                 drop=lambda result: None, prepare=lambda: None, ready=lambda: True):
        super().__init__()
        self.title, self.compute, self.take, self.wanted = title, compute, take, wanted
        self.quiet, self.drop, self.prepare, self.ready = quiet, drop, prepare, ready
        self.state, self.fraction, self.stage, self.error = WAITING, 0.0, "", None
        self.held_up = False  # whether the work has ended, and its result cannot be taken yet
        self._result = None
        self._settled = self._taken = False
        self._thread = None
        self._cancel = threading.Event()

    @property
    def active(self):
        """Whether it waits or runs."""
        return self.state in (WAITING, RUNNING)

    def cancel(self):
        """Asks the work to stop; `ended` tells when it has."""
        self._cancel.set()
        if self.state == WAITING:
            self._end(CANCELLED)

    def start(self):
        """Begins the work on its thread."""
        self.state = RUNNING
        try:
            self.prepare()
        except (Error, ImportError) as error:
            self.error = error
            return
        # No daemon: one that still works while Python is taken down would abort FreeCAD.
        self._thread = threading.Thread(target=self._work, name=self.title)
        self._thread.start()

    def look(self):
        """Reports how far the work is, takes its result once it has ended, and then ends."""
        if not self.wanted():
            self._cancel.set()
        if self._thread is not None and self._thread.is_alive():
            self.changed.emit()
        elif self.error is None and not self._settled:
            self._settle()
        else:
            cancelled = self._cancel.is_set() and not self._taken
            cancelled = cancelled or isinstance(self.error, Cancelled)
            self._end(CANCELLED if cancelled else FAILED if self.error is not None else DONE)

    def _settle(self):
        """Takes or drops the result, unless that has to wait."""
        if self._cancel.is_set():
            self.drop(self._result)
            self._settled = True
        elif self.ready():
            self.held_up = False
            self._settled = self._taken = True
            self._take()
        else:
            self.held_up = True
            self.changed.emit()

    def join(self, seconds):
        """Waits for the thread."""
        if self._thread is not None:
            self._thread.join(seconds)

    def _work(self):
        _give_way()
        try:
            self._result = self.compute(self._progress)
        except Exception as error:  # noqa: BLE001 - the thread's last resort; the GUI shows it
            self.error = error

    def _progress(self, fraction, stage):
        self.fraction, self.stage = fraction, stage
        return not self._cancel.is_set()

    def _take(self):
        try:
            self.take(self._result)
        except (Error, ImportError, MemoryError, RuntimeError) as error:
            self.error = error

    def _end(self, state):
        self.state, self._result = state, None
        if state == FAILED and not self.quiet:
            FreeCAD.Console.PrintError(f"{self.title}: {self.error}\n")
        self.changed.emit()
        self.ended.emit()


class Queue(QtCore.QObject):
    """Jobs in the order in which they were added; one runs at a time."""

    def __init__(self):
        super().__init__()
        self._waiting = collections.deque()
        self.running = None
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(_POLL)
        self._timer.timeout.connect(self._look)
        QtCore.QCoreApplication.instance().aboutToQuit.connect(self.close)

    def __len__(self):
        return len(self._waiting) + (self.running is not None)

    def add(self, job):
        """Has a job done, after those that were added before."""
        self._waiting.append(job)
        self._timer.start()
        return job

    def close(self):
        """Ends all jobs; FreeCAD quits."""
        self._timer.stop()
        jobs = [*self._waiting, *([self.running] if self.running else [])]
        self._waiting.clear()
        for job in jobs:
            job.cancel()
        for job in jobs:
            job.join(_GRACE)

    def _look(self):
        if self.running is None:
            self._start_next()
        if self.running is None:
            self._timer.stop()
        else:
            self.running.look()
            if not self.running.active:
                self.running = None

    def _start_next(self):
        while self._waiting:
            job = self._waiting.popleft()
            if job.active:
                self.running = job
                job.start()
                return


def _give_way():
    """Has this thread, and those that it starts, leave the processor to the window when that has
    something to do, where the system knows priorities of threads.
    """
    if sys.platform == "linux":
        os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), _NICENESS)


_queue = None


def queue():
    """The queue of this FreeCAD."""
    global _queue
    if _queue is None:
        _queue = Queue()
    return _queue
