#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the tests that need FreeCAD, and the house rules, as many at a time as there are cores.

    /usr/bin/python3 tests/jobs.py [--no-chance] [--logs FOLDER] [STAGE ...]

A stage is a folder of tests (freecad attacks oracles gui tools; all unless given), and a job a part of it that has a
process of its own: a file, a table of attacks, a function of the oracles, some files of the window. Jobs wait in one queue,
the longest first. Each has a home of FreeCAD and a folder for temporary files of its own, and is a failed test when it ends
without a line 'N passed, N failed' or is not done in time. What it prints is shown once it has ended, and kept in
FOLDER/STAGE.log. At last each stage has a line 'stage: N passed, N failed, N s of processor'; the last is 'N passed, N failed'.
"""

import argparse
import os
import re
import runpy
import signal
import subprocess
import sys
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass, field
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
STAGES = ("freecad", "attacks", "oracles", "gui", "tools")
LIMIT = 1800  # seconds for a job, on a machine that does much else
SLOWEST = 12  # jobs that are named at the end
PARTS_OF_THE_WINDOW = 8  # FreeCAD's window takes seconds to open
# Jobs of more than half a minute, the longest first: the others fill what is left beside them.
LONGEST = ("freecad/test_certify", "attacks/meshes_given", "freecad/test_offset", "freecad/test_wrap", "freecad/test_placement",
           "freecad/test_layers", "oracles/certify", "freecad/test_batch", "freecad/test_injectivity", "oracles/wrap",
           "oracles/hollow", "attacks/documents_edited", "attacks/shapes_given", "attacks/callbacks", "freecad/test_given_meshes",
           "freecad/test_cli", "freecad/test_attacks_batch", "freecad/test_cure")


@dataclass
class Job:
    stage: str
    name: str
    command: list
    environment: dict = field(default_factory=dict)
    passed: int = 0
    failed: int = 0
    seconds: float = 0.0
    processor: float = 0.0
    text: str = ""

    def run(self):
        """Fills in what came of it."""
        start = time.monotonic()
        with tempfile.TemporaryDirectory(prefix="mq-", ignore_cleanup_errors=True) as folder, tempfile.TemporaryFile() as log:
            environment = {**os.environ, "TMPDIR": folder, "FREECAD_USER_HOME": folder, **self.environment}
            process = subprocess.Popen(self.command, cwd=ROOT, env=environment, stdin=subprocess.DEVNULL, stdout=log,
                                       stderr=subprocess.STDOUT, start_new_session=True)
            late = threading.Timer(LIMIT, os.killpg, (process.pid, signal.SIGKILL))
            late.start()
            _, status, used = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            late.cancel()
            log.seek(0)
            self.text = log.read().decode(errors="replace")
        self.seconds, self.processor = time.monotonic() - start, used.ru_utime + used.ru_stime
        counts = re.findall(r"^(\d+) passed, (\d+) failed", self.text, re.MULTILINE)
        self.passed, self.failed = map(int, counts[-1]) if counts else (0, 1)
        if not counts or (process.returncode and not self.failed):
            self.failed = max(self.failed, 1)
            self.text += f"\n{self.stage}: {self.name}: ended with {process.returncode} after {self.seconds:.0f} s"
        return self


def freecad(script):
    return ["freecadcmd", "-P", str(ROOT / "Mod"), str(HERE / script)]


def files(folder):
    return sorted(path.stem for path in (HERE / folder).glob("test_*.py"))


def jobs_of(stage, chance):
    """All of a stage."""
    if stage == "freecad":
        return [Job(stage, name, freecad("freecad/run.py"), {"MESHQUALITY_TESTS": name}) for name in files("freecad")]
    if stage == "attacks":
        tables = runpy.run_path(str(HERE / "attacks" / "run.py"))
        names = tables["INSIDE"] + (tables["OUTSIDE"] if chance else ())
        return [Job(stage, name, ["/usr/bin/python3", str(HERE / "attacks" / "run.py"), name]) for name in names]
    if stage == "oracles":
        return [Job(stage, name, freecad("oracles/run.py"), {"MESHQUALITY_ORACLES_OF": name, "MESHQUALITY_ORACLES_AT_ONCE": "1"})
                for name in runpy.run_path(str(HERE / "oracles" / "run.py"))["FUNCTIONS"]]
    if stage == "gui":
        parts = [files("gui")[i::PARTS_OF_THE_WINDOW] for i in range(PARTS_OF_THE_WINDOW)]
        return [Job(stage, " ".join(names), ["/usr/bin/python3", str(HERE / "gui" / "run.py"), *names]) for names in parts]
    return [Job(stage, "rules", ["/usr/bin/python3", str(HERE / "tools" / "run.py")])]


def place(job):
    """In the queue."""
    name = f"{job.stage}/{job.name.split()[0]}"
    return LONGEST.index(name) if name in LONGEST else len(LONGEST)


def finish(jobs, logs):
    """Runs them and shows what they print."""
    for stage in {job.stage for job in jobs}:
        (logs / f"{stage}.log").write_text("", encoding="utf-8")
    with ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        for done in as_completed([pool.submit(job.run) for job in sorted(jobs, key=place)]):
            job = done.result()
            shown = f"--- {job.stage}: {job.name}\n{job.text.rstrip()}\n"
            print(shown, flush=True)
            with open(logs / f"{job.stage}.log", "a", encoding="utf-8") as log:
                log.write(shown)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("stages", nargs="*", metavar="STAGE", help=" ".join(STAGES))
    parser.add_argument("--no-chance", dest="chance", action="store_false", help="without the attacks that chance decides")
    parser.add_argument("--logs", type=Path, default=ROOT / "build" / "test-logs", help="a folder")
    arguments = parser.parse_args()
    stages = arguments.stages or STAGES
    arguments.logs.mkdir(parents=True, exist_ok=True)
    jobs = [job for stage in stages for job in jobs_of(stage, arguments.chance)]
    start = time.monotonic()
    finish(jobs, arguments.logs)
    for job in sorted(jobs, key=lambda job: -job.seconds)[:SLOWEST]:
        print(f"{job.seconds:6.0f} s, {job.processor:6.0f} s of processor: {job.stage}/{job.name}")
    for job in jobs:
        if job.failed:
            print(f"{job.stage}: {job.name}: {job.failed} failed")
    print(f"{len(jobs)} jobs: {time.monotonic() - start:.0f} s")
    for stage in stages:
        own = [job for job in jobs if job.stage == stage]
        print(f"{stage}: {sum(job.passed for job in own)} passed, {sum(job.failed for job in own)} failed, "
              f"{sum(job.processor for job in own):.0f} s of processor")
    failed = sum(job.failed for job in jobs)
    print(f"{sum(job.passed for job in jobs)} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
