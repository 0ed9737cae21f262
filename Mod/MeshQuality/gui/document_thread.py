# SPDX-License-Identifier: LGPL-2.1-or-later
"""Calls from other threads of what changes documents: on the window's thread, which waits for nothing meanwhile."""

import threading

from PySide import QtCore

from ..errors import Cancelled

_POLL = 0.1  # seconds between two looks at whether the work was cancelled


class DocumentThread(QtCore.QObject):
    """Made on the window's thread; `call` is for another one.

    obstacle  obstacle() -> what documents are in the middle of, see panel_operation; the call waits for that
    """

    _asked = QtCore.Signal(object)

    def __init__(self, obstacle):
        super().__init__()
        self._obstacle = obstacle
        self._asked.connect(self._run, QtCore.Qt.QueuedConnection)

    def call(self, function, progress):
        """What the function returns, called on the window's thread; what it raises comes out. Raises Cancelled when progress says so
        before it was begun.
        """
        asked = _Call(function)
        self._asked.emit(asked)
        while not asked.done.wait(_POLL):
            if progress(0.5, "waiting for the window") is False and asked.give_up():
                raise Cancelled("cancelled")
        if asked.error is not None:
            raise asked.error
        return asked.result

    def _run(self, asked):
        if self._obstacle():
            QtCore.QTimer.singleShot(int(1000 * _POLL), lambda: self._run(asked))
        else:
            asked.run()


class _Call:
    """One call, which is run or given up, once."""

    def __init__(self, function):
        self._function, self._lock, self._begun = function, threading.Lock(), False
        self.done, self.result, self.error = threading.Event(), None, None

    def give_up(self):
        """Whether it is not run any more."""
        with self._lock:
            given_up, self._begun = not self._begun, True
        return given_up

    def run(self):
        """Runs the function unless the call was given up."""
        if not self.give_up():
            return
        try:
            self.result = self._function()
        except Exception as error:  # noqa: BLE001 - raised where it was asked for
            self.error = error
        self.done.set()
