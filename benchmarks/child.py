# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs that benchmarks start, with limits, and what became of them."""

import json
import os
import resource
import signal
import subprocess
import time
import traceback


class Limits:
    """Time and memory of a child process."""

    def __init__(self, seconds, gibibytes):
        self.seconds, self.bytes = seconds, int(gibibytes * 2**30)

    def run(self, command, environment=None):
        """Status and output of the command; the status is None when its time was up."""
        process = subprocess.Popen(
            command, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True, errors="replace", start_new_session=True,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (self.bytes, self.bytes)),
        )
        try:
            output, _ = process.communicate(timeout=self.seconds)
            return process.returncode, output
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            output, _ = process.communicate()
            return None, output


def in_child(work, seconds=None):
    """What `work` returns, by way of JSON, done by a copy of this process; None where that fails, crashes or
    takes more seconds of the processor.
    """
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            if seconds is not None:
                most = int(time.process_time() + seconds) + 1
                resource.setrlimit(resource.RLIMIT_CPU, (most, most))
            os.write(writing, json.dumps(work()).encode())
        except Exception:  # the parent's work must not be done here as well
            traceback.print_exc()
        finally:
            os._exit(0)
    os.close(writing)
    with os.fdopen(reading, encoding="utf-8") as stream:
        answer = stream.read()
    os.waitpid(child, 0)
    return json.loads(answer) if answer else None


def crash_cause(status, output):
    """The signal that ended the process; FreeCAD catches some itself and says so before it exits."""
    if status < 0:
        return signal.Signals(-status).name
    lines = output.strip().splitlines() or ["no output"]
    said = [line for line in lines if "signal" in line or "terminate" in line]
    return f"status {status}, {(said or lines[-1:])[0].strip()[:160]}"
