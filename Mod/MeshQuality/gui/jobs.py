# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work in the background: one job after the other on a thread, watched from the GUI's thread.

A job computes on the thread and touches neither documents nor widgets there; its result is taken
on the GUI's thread. The core frees Python's lock while it works, so that the window stays alive.
"""

import collections
import os
import sys
import threading
import time

import FreeCAD
from PySide import QtCore

from .. import phrases
from ..errors import Cancelled, Error
from .garbage_collection import Collector
from .pace import Pace
from .translation import translated, translated_rest, translated_stage

translate = FreeCAD.Qt.translate

ADDING = phrases.Text(phrases.ADDING)
WAITING, RUNNING, DONE, FAILED, CANCELLED = "waiting", "running", "done", "failed", "cancelled"
_POLL = 30  # ms between two looks at the thread
_SLICE = 0.03  # s of steps at a look
_NICENESS = 5
_PATIENCE = 0.3  # s that a cancelled job has to end in before its user goes on without it
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
    compute  compute(progress) -> result, called on the thread; progress as for triangulate. A result with steps(), an
             iterator, has that run on the GUI's thread first, bit by bit
    take     take(result), called on the GUI's thread
    wanted   wanted() -> whether the result still has a place to go to, asked on the GUI's thread
    quiet    a failure is not reported
    drop     drop(result), called on the GUI's thread instead of take where the job was cancelled
             after the work had ended
    prepare  prepare(), called on the GUI's thread when the work starts
    obstacle obstacle() -> what the result has to wait for, in the user's language; empty: it can be
             taken now; asked again and again
    taking   the stage that is shown while the result is taken, which the window waits for

    The window stays alive between taking a result and the signal `ended`. A cancelled job ends even
    where its work cannot be interrupted: that goes on until `over`, and the next job waits for it.
    """

    changed = QtCore.Signal()  # state, fraction or stage
    ended = QtCore.Signal()
    returned = QtCore.Signal()  # after `ended`: what could not be interrupted is over

    def __init__(self, title, compute, take, wanted=lambda: True, quiet=False,
                 drop=lambda result: None, prepare=lambda: None, obstacle=lambda: "", taking=""):
        super().__init__()
        self.title, self.compute, self.take, self.wanted = title, compute, take, wanted
        self.quiet, self.drop, self.prepare = quiet, drop, prepare
        self.obstacle, self.taking = obstacle, taking
        self.state, self.fraction, self.stage, self.error = WAITING, 0.0, "", None
        self.held_up = ""  # the reason for which the result has to wait once the work has ended
        self.over = False  # whether the job has ended, and its work, too
        self._result = self._steps = None
        self._disposed = self._taken = False  # whether the result was taken or dropped, and taken
        self._given_up = None  # when it was seen to be cancelled
        self._pace = Pace()
        self._thread = None
        self._cancel = threading.Event()

    @property
    def active(self):
        """Whether the job waits or runs."""
        return self.state in (WAITING, RUNNING)

    @property
    def works(self):
        """Whether its thread still works."""
        return self._thread is not None and self._thread.is_alive()

    @property
    def wait(self):
        """What the job waits for, in the user's language; empty if that has no name."""
        other = queue().running
        if self.state == WAITING and other is not None:
            return translate("MeshQuality", "waits for “{}”: {}").format(other.title, other.doing)
        if self.held_up:
            return self.held_up
        stage = self._stage_now()
        return translated_stage(stage) if phrases.is_wait(stage) else ""

    @property
    def doing(self):
        """What the job does or waits for, and how long, in the user's language."""
        if not self.active and not self.over:
            return translated_rest(self._stage_now())
        what = self.wait or (translated_stage(self.stage) if self.stage else state_text(self.state))
        return "; ".join(filter(None, (what, self.time)))

    @property
    def time(self):
        """How long its thread has worked, and how long that still takes where it is known, in the user's language; empty of short work."""
        return self._pace.text if self.active and self.works else ""

    def _stage_now(self):
        """The stage; what the core waits for is known after it was cancelled, too."""
        core = sys.modules.get("MeshQuality._core")
        what = dict(core.waits()).get(self._thread.name) if core is not None and self.works else None
        return what if what else self.stage

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
        # A daemon: FreeCAD would wait for any other, however long that cannot be interrupted.
        self._thread = threading.Thread(target=self._work, name=self.title, daemon=True)
        self._thread.start()

    def poll(self):
        """Reports how far the work is, takes its result once it has ended, and then ends."""
        if not self.wanted():
            self._cancel.set()
        if self.works:
            self._pace.note(self.fraction)
            if self.active and self._patience_is_over():
                self._end(CANCELLED)
            self.changed.emit()
        elif self.error is None and not self._disposed:
            self._dispose()
        elif not self.active:
            self._return()
        else:
            cancelled = self._cancel.is_set() and not self._taken
            cancelled = cancelled or isinstance(self.error, Cancelled)
            self._end(CANCELLED if cancelled else FAILED if self.error is not None else DONE)

    def _patience_is_over(self):
        if not self._cancel.is_set():
            return False
        if self._given_up is None:
            self._given_up = time.monotonic()
        return time.monotonic() - self._given_up > _PATIENCE

    def _dispose(self):
        """Takes or drops the result, unless that has to wait."""
        if self._cancel.is_set():
            self.drop(self._result)
            self._disposed = True
            return
        self.held_up = self.obstacle()
        if self.held_up or self.stage != self.taking != "":
            if not self.held_up:
                self.stage = self.taking
            self.changed.emit()
            return  # the window shows it before it has to wait
        if self._steps_are_done():
            self._disposed = self._taken = True
            self._take()

    def _steps_are_done(self):
        """Goes on with the steps of the result for a moment; the window does other things before it comes back."""
        if self._steps is None:
            self._steps = getattr(self._result, "steps", tuple)()
        end = time.monotonic() + _SLICE
        try:
            for _ in self._steps:
                if time.monotonic() > end:
                    return False
        except (Error, ImportError, MemoryError, RuntimeError) as error:
            self.error = error
        return self.error is None

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
        self.state, self.over = state, not self.works
        if self.over:
            self._result = self._steps = None
        if state == FAILED and not self.quiet:
            FreeCAD.Console.PrintError(f"{self.title}: {translated(self.error)}\n")
        self.changed.emit()
        self.ended.emit()

    def _return(self):
        self._result, self.over = None, True
        self.changed.emit()
        self.returned.emit()


class Queue(QtCore.QObject):
    """Jobs in the order in which they were added; one runs at a time."""

    def __init__(self):
        super().__init__()
        self._waiting = collections.deque()
        self.running = None
        self._collector = Collector()
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(_POLL)
        self._timer.timeout.connect(self._poll)
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
            if not job.wait:  # the core gives what waits there a time to end in, too
                job.join(_GRACE)

    def _poll(self):
        if self.running is None:
            self._start_next()
        if self.running is None:
            self._timer.stop()
        else:
            self._collector.collect()
            self.running.poll()
            for job in self._waiting:
                job.changed.emit()
            if self.running.over:
                self.running = None
                self._collector.end()

    def _start_next(self):
        while self._waiting:
            job = self._waiting.popleft()
            if job.active:
                self.running = job
                self._collector.begin()
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
