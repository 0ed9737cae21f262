# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCADs that do one job after the other, each with a limit of time and of memory.

To start FreeCAD and load the core takes half a second, which is more than most small parts take;
so one does many jobs. It is ended when its time is up, when it crashes, when a job fails in it,
and before it has grown.
"""

import contextlib
import json
import os
import signal
import subprocess
import tempfile
import threading
from concurrent.futures import ThreadPoolExecutor

from ..cli.freecad_process import freecad_command
from ..limits import how_it_ended, ran_out_of_memory

START_SECONDS = 120.0
MOST_JOBS = 1000
_GROWN = 0.25  # share of the memory limit


class Died(Exception):  # noqa: N818 - an event, not a fault of the caller
    """The FreeCAD of a job ended. `state` is crash, timeout or memory; the text says how."""

    def __init__(self, state, text):
        super().__init__(text)
        self.state = state


class NotStarted(Exception):  # noqa: N818
    """No FreeCAD could be started for a job; the job is not the cause."""


# Linux ends the FreeCADs with the thread that started them (see limits), which may be one of Dask's that
# comes and goes: so one thread that stays starts them all.
_starter = ThreadPoolExecutor(1)


def _started(*arguments, **options):
    return _starter.submit(subprocess.Popen, *arguments, **options).result()


class FreeCad:
    """One FreeCAD. `jobs` is how many it has done."""

    def __init__(self, bytes_allowed):
        self.jobs, self.resident = 0, 0
        self._bytes = bytes_allowed
        self._words = tempfile.TemporaryFile()
        environment = {"MESHQUALITY_THREADS": "1", **os.environ,
                       "MESHQUALITY_SERVE": str(bytes_allowed)}
        environment.pop("MESHQUALITY_JOB", None)
        # In a session of its own, so that Ctrl-C reaches the batch only, and so that what it
        # starts can be ended with it.
        self._process = _started(
            freecad_command(os.path.join("batch", "worker_loop.py")), stdin=subprocess.PIPE,
            stdout=subprocess.PIPE, stderr=self._words, env=environment, start_new_session=True)
        self.pid = self._process.pid
        self._answer(START_SECONDS)

    def run(self, job):
        """The result of the job; raises Died."""
        self._words.seek(0)
        self._words.truncate()
        self.jobs += 1
        with contextlib.suppress(BrokenPipeError):  # reading says why
            self._process.stdin.write(json.dumps(job).encode() + b"\n")
            self._process.stdin.flush()
        result = self._answer(job["seconds"])
        self.resident = result["resident"]
        return result

    @property
    def worn(self):
        """Whether the next job should get a new FreeCAD."""
        return self.jobs >= MOST_JOBS or self.resident > _GROWN * self._bytes

    def _answer(self, seconds):
        """The next object that the FreeCAD prints."""
        late = threading.Event()

        def end():
            late.set()
            self.kill()

        timer = threading.Timer(seconds, end)
        timer.start()
        try:
            for line in self._process.stdout:
                # FreeCAD greets before it runs the script.
                if line.startswith(b'{"meshquality"'):
                    return json.loads(line)
        finally:
            timer.cancel()
        code = self._process.wait()
        self.kill()
        if late.is_set():
            raise Died("timeout", f"took more than {seconds:g} s")
        raise self._died(code)

    def _died(self, code):
        self._words.seek(0, os.SEEK_END)
        self._words.seek(max(0, self._words.tell() - 20000))
        words = self._words.read().decode(errors="replace")
        if ran_out_of_memory(words):
            return Died("memory", f"took more than {self._bytes / 2**30:g} GiB of memory")
        return Died("crash", how_it_ended(code, words))

    def kill(self):
        """Ends the FreeCAD and all processes that it started."""
        if hasattr(os, "killpg"):
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.killpg(self.pid, signal.SIGKILL)
        self._process.kill()

    def close(self):
        """Ends the FreeCAD and waits until it is gone."""
        self.kill()
        self._process.wait()
        for stream in (self._process.stdin, self._process.stdout, self._words):
            with contextlib.suppress(OSError):  # nobody reads the rest
                stream.close()


class Pool:
    """The FreeCADs of one batch in this process; as many as there are jobs at the same time."""

    def __init__(self):
        self._lock = threading.Lock()
        self._idle, self._busy, self._closed = [], set(), False

    def take(self, bytes_allowed, fresh=False):
        """An idle FreeCAD, or a new one. Raises NotStarted."""
        with self._lock:
            if self._closed:
                raise NotStarted("the batch was ended")
            if self._idle and not fresh:
                freecad = self._idle.pop()
                self._busy.add(freecad)
                return freecad
        try:
            freecad = FreeCad(bytes_allowed)
        except (Died, OSError) as error:
            raise NotStarted(f"FreeCAD does not start: {error}") from error
        with self._lock:
            self._busy.add(freecad)
        return freecad

    def give_back(self, freecad, good):
        """Keeps the FreeCAD for the next job if its last one succeeded."""
        with self._lock:
            self._busy.discard(freecad)
            keep = good and not freecad.worn and not self._closed
            if keep:
                self._idle.append(freecad)
        if not keep:
            freecad.close()

    @property
    def closed(self):
        return self._closed

    def close(self):
        """Ends all FreeCADs, also those at work."""
        with self._lock:
            self._closed = True
            idle, busy = self._idle, list(self._busy)
            self._idle = []
        for freecad in busy:
            freecad.kill()
        for freecad in idle:
            freecad.close()


_pools, _pools_lock = {}, threading.Lock()


def pool(run):
    """The Pool of the batch of this name."""
    with _pools_lock:
        return _pools.setdefault(run, Pool())


def close_pool(run):
    """Ends the FreeCADs of the batch; called when it is over."""
    pool(run).close()
