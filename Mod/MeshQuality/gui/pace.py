# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long work has taken, and how long it still takes where its own progress tells that."""

import bisect
import time

import FreeCAD

translate = FreeCAD.Qt.translate

_SHORT = 3.0  # s: of shorter work nothing is told
_BETWEEN = 0.2  # s between two fractions that are kept
_FIRST = 0.03  # share of the work before which it tells nothing
_AGREE = 2.0  # most by which the time left by all of the work and by its second half differ
_FINE, _COARSE = 5, 15  # s: times left are multiples of these, below and above a minute


class Pace:
    """The times at which shares of work were done.

    Stages of work take longer or shorter than their shares. So the time left is told only where the pace since the beginning and that in the later
    half of the time say nearly the same; it is the longer of the two. Where a stage stands still, the time that has passed is all that is told.
    """

    def __init__(self, now=time.monotonic):
        self._now = now
        self._began, self._times, self._fractions = None, [], []

    def note(self, fraction):
        """This share of the work is done now; less than before: another part of it has begun."""
        now = self._now()
        if self._began is None:
            self._began = now
        if not self._times or fraction < self._fractions[-1]:
            self._times, self._fractions = [now], [fraction]
        elif now - self._times[-1] >= _BETWEEN:
            self._times.append(now)
            self._fractions.append(fraction)

    @property
    def passed(self):
        """s since it began."""
        return 0.0 if self._began is None else self._now() - self._began

    @property
    def left(self):
        """s until it is done; None where that is not known."""
        if len(self._times) < 3 or self._fractions[-1] - self._fractions[0] < _FIRST:
            return None
        now, done = self._now(), self._fractions[-1]
        middle = min(bisect.bisect_left(self._times, (self._times[0] + now) / 2.0), len(self._times) - 2)
        since = [(done - self._fractions[i]) / (now - self._times[i]) for i in (0, middle)]  # shares a second
        if min(since) <= 0.0 or max(since) > _AGREE * min(since):
            return None
        return (1.0 - done) / min(since)

    @property
    def text(self):
        """Both, in the user's language; empty while the work is short."""
        if self.passed < _SHORT:
            return ""
        passed, left = spoken(int(self.passed)), self.left
        if left is None:
            return translate("MeshQuality", "{0} passed").format(passed)
        step = _FINE if left < 60 else _COARSE
        return translate("MeshQuality", "{0} passed, about {1} left").format(passed, spoken(step * max(1, round(left / step))))


def spoken(seconds):
    """Seconds, such as "45 s", "2 min 15 s" or "1 h 5 min"."""
    minutes, rest = divmod(seconds, 60)
    if minutes >= 60:
        return f"{minutes // 60} h {minutes % 60} min"
    return f"{minutes} min {rest} s" if minutes and rest else f"{minutes} min" if minutes else f"{rest} s"
