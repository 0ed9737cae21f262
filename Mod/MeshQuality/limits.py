# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a process that works for another one does at its start: it ends with its owner, and within limits.

Imports nothing of FreeCAD.
"""

import contextlib
import ctypes
import os
import select
import signal
import sys
import threading

OWNER = "MESHQUALITY_OWNER"
_PR_SET_PDEATHSIG = 1


def end_with_owner():
    """Has the system end this process when the one that started it ends, by whatever cause.

    On Linux by a signal of the kernel, which also ends code that never returns to Python. Everywhere by
    the pipe whose reading end OWNER names: nobody writes to it, and it ends with its owner.
    """
    if sys.platform.startswith("linux"):
        ctypes.CDLL(None, use_errno=True).prctl(_PR_SET_PDEATHSIG, int(signal.SIGKILL), 0, 0, 0)
    end = os.environ.pop(OWNER, None)
    if end is None:
        return
    end = int(end)
    os.set_inheritable(end, False)
    # The owner may have ended before the signal was asked for.
    if select.select([end], [], [], 0)[0]:
        os._exit(1)
    threading.Thread(target=_end_after, args=(end,), daemon=True).start()


def _end_after(pipe):
    os.read(pipe, 1)
    os._exit(1)


@contextlib.contextmanager
def ownership():
    """(file descriptors to pass on, environment) for a process that is to end with this one."""
    if os.name != "posix":  # descriptors cannot be passed on there
        yield (), {}
        return
    reading, writing = os.pipe()
    try:
        yield (reading,), {OWNER: str(reading)}
    finally:
        os.close(reading)
        os.close(writing)


def limit_memory(bytes_allowed):
    """Limits the data of this process to a number of bytes; on Linux only."""
    if sys.platform.startswith("linux"):
        import resource

        resource.setrlimit(resource.RLIMIT_DATA, (bytes_allowed, bytes_allowed))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def end_itself_after(seconds):
    """Should nobody else do it, even in the middle of a call that never returns; 0: not at all."""
    if hasattr(signal, "alarm"):
        signal.alarm(min(seconds, 2**31 - 1))


def ran_out_of_memory(words):
    """Whether the last words of a process say that it had not enough memory."""
    return any(word in words for word in ("bad_alloc", "MemoryError", "Standard_OutOfMemory"))


def how_it_ended(code, words):
    """The exit code of a FreeCAD that left no result as part of a sentence, with its last words."""
    how = f"by signal {signal.Signals(-code).name}" if code < 0 else f"with status {code}"
    # FreeCAD catches some signals itself and says so above a list of calls.
    lines = words.strip().splitlines()
    said = [line for line in lines if "signal" in line or "terminate" in line] or lines[-1:]
    return f"FreeCAD ended {how}" + (f": {said[0].strip()[:200]}" if said else "")
