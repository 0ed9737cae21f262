# SPDX-License-Identifier: LGPL-2.1-or-later
"""The progress of a job in a line at a terminal."""

import os
import sys
import time

_STAGE = 39  # characters, in a line of 80


def _is_shown():
    """Whether stderr, which the caller hands on, ends at a terminal."""
    return os.environ.get("MESHQUALITY_TERMINAL") == "1"


def progress_line():
    """A progress callback: a line for people at a terminal, and the end when the caller is gone."""
    visible, parent = _is_shown(), os.getppid()
    last = [0.0]

    def show(fraction, stage):
        if os.getppid() != parent:
            return False
        now = time.monotonic()
        if visible and now - last[0] > 0.2:
            last[0] = now
            done = int(30 * fraction)
            print(f"\r[{'#' * done:<30}] {100 * fraction:3.0f} %  {stage:<{_STAGE}.{_STAGE}}", end="",
                  file=sys.stderr, flush=True)
        return True

    return show


def end_progress_line():
    """Takes the progress line away."""
    if _is_shown():
        print("\r\x1b[K", end="", file=sys.stderr, flush=True)
