# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's progress bar for work on the main thread, which Esc cancels."""

import contextlib

import FreeCAD

_STEPS = 100


@contextlib.contextmanager
def shown(title):
    """Shows the bar; its value is a function that triangulate and curve take as progress."""
    bar, done = FreeCAD.Base.ProgressIndicator(), 0
    bar.start(title, _STEPS)

    def progress(fraction, _stage):
        nonlocal done
        try:
            while done < min(int(_STEPS * fraction), _STEPS - 1):
                done += 1
                bar.next(True)
        except (FreeCAD.Base.FreeCADAbort, RuntimeError):  # FreeCAD 0.20 raises the latter
            return False
        return True

    try:
        yield progress
    finally:
        bar.stop()
