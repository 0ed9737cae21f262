# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs that benchmarks start, with limits, and what became of them."""

import json
import math
import os
import resource
import signal
import subprocess
import time
import traceback


class Limits:
    """Seconds of the processor and memory of a child process; one that waits is ended after `clock` times the
    seconds.
    """

    def __init__(self, seconds, gibibytes, clock=4.0):
        self.seconds, self.bytes, self.clock = seconds, int(gibibytes * 2**30), clock

    def run(self, command, environment=None):
        """Status and output of the command; the status is None when its time was up."""
        process = subprocess.Popen(
            command, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True, errors="replace", start_new_session=True,
            preexec_fn=self._set,
        )
        try:
            output, _ = process.communicate(timeout=self.clock * self.seconds)
            return None if process.returncode == -signal.SIGXCPU else process.returncode, output
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            output, _ = process.communicate()
            return None, output

    def _set(self):
        seconds = max(1, math.ceil(self.seconds))
        resource.setrlimit(resource.RLIMIT_AS, (self.bytes, self.bytes))
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def in_child(work, seconds=None):
    """What `work` returns, by way of JSON, done by a copy of this process; None where that fails, crashes or
    takes more seconds of the processor.
    """
    return outcome_in_child(work, seconds)[0]


def outcome_in_child(work, seconds=None, gibibytes=None, clock=10.0):
    """As in_child, and why there is no answer: "time limit", "hang", "crash: ..." or "". A hang is a child that takes
    `clock` times the seconds on the clock, asleep or on a busy machine; `gibibytes` bounds its address space.
    """
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            _limit_this_process(seconds, gibibytes, clock)
            os.write(writing, json.dumps(work()).encode())
        except Exception:  # the parent's work must not be done here as well
            traceback.print_exc()
        finally:
            os._exit(0)
    os.close(writing)
    with os.fdopen(reading, encoding="utf-8") as stream:
        answer = stream.read()
    _, ended = os.waitpid(child, 0)
    if answer:
        return json.loads(answer), ""
    status = os.waitstatus_to_exitcode(ended)
    if -status in (signal.SIGXCPU, signal.SIGALRM):
        return None, "time limit" if -status == signal.SIGXCPU else "hang"
    return None, f"crash: {signal.Signals(-status).name if status < 0 else f'status {status}'}"


def _limit_this_process(seconds, gibibytes, clock):
    if seconds is not None:
        most = int(time.process_time() + seconds) + 1
        resource.setrlimit(resource.RLIMIT_CPU, (most, most + 1))
        signal.alarm(int(clock * seconds) + 1)
    if gibibytes is not None:
        most = int(gibibytes * 2**30)
        resource.setrlimit(resource.RLIMIT_AS, (most, most))


def crash_cause(status, output):
    """The signal that ended the process; FreeCAD catches some itself and says so before it exits."""
    if status < 0:
        return signal.Signals(-status).name
    lines = output.strip().splitlines() or ["no output"]
    said = [line for line in lines if "signal" in line or "terminate" in line]
    return f"status {status}, {(said or lines[-1:])[0].strip()[:160]}"
