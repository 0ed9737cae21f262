# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs that benchmarks start, with limits, and what became of them."""

import os
import resource
import signal
import subprocess


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


def crash_cause(status, output):
    """The signal that ended the process; FreeCAD catches some itself and says so before it exits."""
    if status < 0:
        return signal.Signals(-status).name
    lines = output.strip().splitlines() or ["no output"]
    said = [line for line in lines if "signal" in line or "terminate" in line]
    return f"status {status}, {(said or lines[-1:])[0].strip()[:160]}"
