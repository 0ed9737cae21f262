# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the attacks of one table inside FreeCAD, from a given row on, and says before and after each how it goes.

run.py starts this, watches its lines and the clock, and starts it again behind an attack that it did not survive.
"""

import contextlib
import ctypes
import importlib
import json
import os
import re
import sys
import tempfile
import threading
import traceback

import FreeCAD

LONGEST_FAULT = 1500  # characters
# FreeCAD 1.0 prints a traceback, of Python's own files alone, where it saves a proxy that is no JSON.
NO_JSON = re.compile(r"PropertyPythonObject::toString\(\): failed for .*\nTraceback .*\n(?:  .*\n)*<class 'TypeError'>: .* is not JSON serializable\n")
# FreeCAD 1.1 prints one wherever the execute of an object in Python raises anything. That of our errors is a sentence for the user.
OF_EXECUTE = re.compile(r"Traceback .*\n(?:  .*\n)+<class 'MeshQuality\.\w+'>: .*\n")
EXPECTED = (NO_JSON, OF_EXECUTE)


def children():
    """Ids of the processes that this one has started and that still run."""
    found = []
    with contextlib.suppress(OSError):
        for task in os.listdir("/proc/self/task"):
            with open(f"/proc/self/task/{task}/children", encoding="ascii") as stream:
                found += stream.read().split()
    return found


def left_behind(before):
    """What an attack left in the folder for temporary files, of documents, processes and threads; in words."""
    for name in FreeCAD.listDocuments():
        FreeCAD.closeDocument(name)
    files = sorted(name for name in set(os.listdir(tempfile.gettempdir())) - before if not name.startswith("FreeCAD"))
    threads = [thread.name for thread in threading.enumerate() if not thread.daemon] [1:]
    said = [f"files {files}"] if files else []
    said += [f"processes {children()}"] if children() else []
    said += [f"threads {threads}"] if threads else []
    return ", ".join(said)


class Printed:
    """What this process prints, FreeCAD's console too, in a file that is handed on at the end."""

    def __init__(self):
        self._file = tempfile.TemporaryFile()  # noqa: SIM115 - until the end of the process
        self._shown = os.dup(1)
        for stream in (1, 2):
            os.dup2(self._file.fileno(), stream)

    def since(self):
        """The text since the last call."""
        sys.stdout.flush()
        ctypes.CDLL(None).fflush(None)
        self._file.seek(0)
        text = self._file.read()
        self._file.seek(0)
        self._file.truncate()
        os.write(self._shown, text)
        return text.decode(errors="replace")


def done(attack, printed):
    """What is wrong with what came of the attack; None where it was survived."""
    before = set(os.listdir(tempfile.gettempdir()))
    printed.since()
    try:
        attack.call()
    except BaseException as error:  # noqa: BLE001 - SystemExit and KeyboardInterrupt are faults here, too
        return f"{type(error).__name__}: {error}\n{traceback.format_exc()[-LONGEST_FAULT:]}"
    left = left_behind(before)
    said = printed.since()
    for expected in EXPECTED:
        said = expected.sub("", said)
    if "Traceback" in said:
        return f"a traceback was printed: {said[-LONGEST_FAULT:]}"
    return f"left behind: {left}" if left else None


def main():
    from MeshQuality import limits  # noqa: PLC0415  on the path only inside FreeCAD

    limits.end_with_owner()
    say = os.fdopen(int(os.environ["ATTACKS_PIPE"]), "w", encoding="utf-8")
    rows = importlib.import_module(os.environ["ATTACKS_TABLE"]).rows()
    wanted = os.environ.get("ATTACKS_ONLY", "")
    printed = Printed()
    for i, attack in enumerate(rows):
        if i < int(os.environ["ATTACKS_FIRST"]) or wanted not in attack.name:
            continue
        say.write(json.dumps({"row": i, "name": attack.name, "limit": attack.limit}) + "\n")
        say.flush()
        say.write(json.dumps({"row": i, "fault": done(attack, printed)}) + "\n")
        say.flush()
    sys.stdout.flush()
    os._exit(0)


if "ATTACKS_PIPE" in os.environ:
    main()
