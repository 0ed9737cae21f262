# SPDX-License-Identifier: LGPL-2.1-or-later
"""Python's collection of reference cycles, kept on the GUI's thread while other threads work.

Python collects cycles on whichever thread happens to allocate. Panels, timers and other objects of Qt
stand in cycles, and Qt has them destroyed on the thread that they live in: a timer that ends on another
one stays registered, and the event loop later calls what is no more.
"""

import gc


class Collector:
    """Takes the place of the automatic collection between `begin` and `end`."""

    def __init__(self):
        self._automatic = False

    def begin(self):
        """No thread collects by itself from here on."""
        self._automatic = self._automatic or gc.isenabled()
        gc.disable()

    def end(self):
        """Every thread may collect again, if it could before."""
        if self._automatic:
            gc.enable()
        self._automatic = False

    def collect(self):
        """Collects on this thread what Python would have collected by now."""
        due = [n for n, (count, limit) in enumerate(zip(gc.get_count(), gc.get_threshold())) if 0 < limit < count]
        if due:
            gc.collect(due[-1])
