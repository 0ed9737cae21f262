# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's console program: where it is, and how the command line waits for it."""

import os
import shutil
import subprocess
import sys
import threading
import time

from .signals import EndedBySignals

_LOOK_SECONDS = 0.5  # seconds between looks whether a signal came


def freecad():
    """FreeCAD's console program; MESHQUALITY_FREECADCMD overrides. Raises OSError."""
    for name in ("TMPDIR", "TEMP", "TMP"):  # FreeCAD ends at its start where it cannot use it
        folder = os.environ.get(name)
        if folder and not (os.path.isdir(folder) and os.access(folder, os.W_OK | os.X_OK)):
            raise OSError(f"{name} names '{folder}', which is no folder that can be written to: FreeCAD needs "
                          "one for temporary files")
    chosen = os.environ.get("MESHQUALITY_FREECADCMD")
    for name in [chosen] if chosen else ["freecadcmd", "FreeCADCmd", "freecad.cmd"]:
        path = shutil.which(name)
        if path:
            return path
    raise OSError("FreeCAD's console program freecadcmd is not found: put it on PATH, or name "
                  "it in MESHQUALITY_FREECADCMD")


def freecad_command(script):
    """The command that runs a script of this package in FreeCAD."""
    package = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    return [freecad(), "-P", os.path.dirname(package), os.path.join(package, script)]


def _exit_code(process, deadline):
    """Waits for the process. Raises TimeoutError after the deadline, and KeyboardInterrupt after a signal, even if
    Python lost that exception, as it may in a destructor.
    """
    while True:
        left = _LOOK_SECONDS if deadline is None else deadline - time.monotonic()
        try:
            return process.wait(max(0.0, min(left, _LOOK_SECONDS)))
        except subprocess.TimeoutExpired as error:
            if EndedBySignals.told:
                raise KeyboardInterrupt from None
            if deadline is not None and time.monotonic() >= deadline:
                raise TimeoutError("FreeCAD did not end in time") from error


def wait_for(process, deadline):
    """(exit code, last words) of the process, which does not outlive this one when that is told to end.

    What it writes to stderr is handed on. Raises TimeoutError after the deadline.
    """
    words = bytearray()

    def hand_on():
        while block := os.read(process.stderr.fileno(), 65536):
            words.extend(block)
            del words[:-20000]
            if sys.stderr is not None:
                sys.stderr.write(block.decode(errors="replace"))
                sys.stderr.flush()

    reader = threading.Thread(target=hand_on, daemon=True)
    reader.start()
    try:
        code = _exit_code(process, deadline)
    finally:
        if process.poll() is None:
            process.kill()
            process.wait()
        reader.join(5)  # children of the process may hold its stderr
        if not reader.is_alive():
            process.stderr.close()
    return code, words.decode(errors="replace")
