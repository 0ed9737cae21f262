# SPDX-License-Identifier: LGPL-2.1-or-later
"""The signals that end the command line: Ctrl-C, SIGTERM and SIGHUP."""

import contextlib
import signal


class EndedBySignals:
    """Has the first of Ctrl-C, SIGTERM and SIGHUP raise KeyboardInterrupt, and keeps the others from what is done then.

    Signals that are ignored, as by nohup, stay so. For the main thread.

    last    nothing but the end of the process follows, which signals then no longer change
    """

    told = False

    def __init__(self, last=False):
        self._last = last

    def __enter__(self):
        numbers = [getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)]
        EndedBySignals.told = False
        self._before = {number: signal.signal(number, self._end) for number in numbers
                        if signal.getsignal(number) != signal.SIG_IGN}

    def _end(self, *_):
        if not EndedBySignals.told:
            EndedBySignals.told = True
            raise KeyboardInterrupt

    def __exit__(self, *_):
        for number, handler in self._before.items():
            signal.signal(number, signal.SIG_IGN if self._last else handler)


@contextlib.contextmanager
def signals_held():
    """None of the signals comes in the `with` block, on systems that can hold them back."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGTERM, signal.SIGHUP})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
