# SPDX-License-Identifier: LGPL-2.1-or-later
"""`meshquality batch`: finds what is to be done, has it done, and writes table and report."""

import importlib.util
import os
import sys
import time
from collections import Counter

from ..cli.exit_status import DONE, FAILED
from ..cli.freecad_process import freecad
from ..phrases import MET, NOT_MET
from . import cluster, report, table
from .ledger import Ledger
from .part import AGAIN
from .plan import find_parts, matches, plan_of

SYSTEM_PYTHON = "/usr/bin/python3"
INTERIM_SECONDS = 60.0  # least time between two looks at finished parts; looks take 2 % of the time
MOST_LOST = 50  # lost parts in a row after which the batch gives up: then no part is the cause


def require_dask():
    """Raises OSError where Dask is missing; starts anew in the system's Python if that has it."""
    if importlib.util.find_spec("distributed"):
        return
    tried = "MESHQUALITY_PYTHON" in os.environ
    if os.path.exists(SYSTEM_PYTHON) and not tried and sys.executable != SYSTEM_PYTHON:
        os.environ["MESHQUALITY_PYTHON"] = SYSTEM_PYTHON
        os.execv(SYSTEM_PYTHON, [SYSTEM_PYTHON, *sys.argv])
    raise OSError("batch needs Dask: install the package python3-distributed (Debian), or "
                  "distributed (conda, pip)")


class ProgressLine:
    """A line at a terminal: how many parts of how many are done, and how long the rest takes."""

    def __init__(self, total):
        self._total, self._start, self._last = total, time.monotonic(), 0.0
        self._done = self._failed = 0
        self._visible = sys.stderr.isatty()

    def add(self, entry):
        """Counts a part that was done."""
        self._done += 1
        self._failed += entry["state"] != "done"
        now = time.monotonic()
        if self._visible and (now - self._last > 0.2 or self._done == self._total):
            self._last = now
            self._show(now - self._start)

    def _show(self, seconds):
        rate = self._done / max(seconds, 1e-6)
        left = (self._total - self._done) / rate
        bar = "#" * int(30 * self._done / self._total)
        failed = f", {self._failed} failed" if self._failed else ""
        print(f"\r[{bar:<30}] {self._done} of {self._total} parts{failed}, {rate:.1f} a second, "
              f"{_duration(left)} left\x1b[K", end="", file=sys.stderr, flush=True)

    def end(self):
        """Removes the line."""
        if self._visible:
            print("\r\x1b[K", end="", file=sys.stderr, flush=True)


def _duration(seconds):
    minutes, seconds = divmod(int(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours} h {minutes} min" if hours else f"{minutes} min {seconds} s" if minutes \
        else f"{seconds} s"


def run(arguments):
    """The result {"status", "text", "report"} of a batch, as the program prints it."""
    require_dask()
    start = time.monotonic()
    plan = plan_of(arguments)
    parts = find_parts(plan, arguments.only)
    ledger = Ledger(plan)
    try:
        chosen = (lambda name: matches(name, arguments.only)) if arguments.only else None
        todo = ledger.keep(parts, arguments.retry, arguments.check_content, chosen)
        # Table and report show the parts that --only left alone, too.
        total = len(parts) + sum(chosen is not None and not chosen(entry["part"])
                                 for entry in ledger.entries())
        if todo:
            _do(arguments, plan, todo, ledger, total)
        states, missed = Counter(), 0
        for entry in ledger.entries():
            if chosen is None or chosen(entry["part"]):
                states[entry["state"]] += 1
                missed += entry.get("report", {}).get("verdict") == NOT_MET
        write_results(plan, ledger, total)
    finally:
        ledger.close()
    failed = len(parts) - states["done"]
    summary = {"parts": len(parts), "worked_on": len(todo), "states": dict(sorted(states.items())),
               "not_met": missed, "verdict": NOT_MET if missed or failed else MET,
               "seconds": round(time.monotonic() - start, 3), "output": str(plan.out)}
    text = f"{failed} of {_parts(len(parts))} failed" if failed else f"{_parts(len(parts))} done"
    if missed:
        text += f"; {missed} of {states['done']} meshes {'does' if missed == 1 else 'do'} not meet a requested limit"
    text += f"; {_parts(len(todo))} processed in {_duration(summary['seconds'])}; see " \
            f"{plan.out / report.NAME}"
    return {"status": FAILED if failed else DONE, "text": text, "report": summary, "met": not missed,
            "report_text": "".join(f"{state:<8} {count:>8}\n"
                                   for state, count in sorted(states.items()))}


def _parts(count):
    return "1 part" if count == 1 else f"{count} parts"


def write_results(plan, ledger, total):
    """Writes table and report; returns the seconds that it took."""
    start = time.monotonic()
    table.write(plan, ledger)
    report.write(plan, ledger, total)
    return time.monotonic() - start


def _do(arguments, plan, todo, ledger, total):
    line, lost, due = ProgressLine(len(todo)), [0], [time.monotonic() + INTERIM_SECONDS]
    if arguments.scheduler is None:
        freecad()  # raises an error at once if there is no FreeCAD

    def finished(entry):
        ledger.add(entry)
        line.add(entry)
        lost[0] = lost[0] + 1 if entry["state"] in AGAIN else 0
        if lost[0] == MOST_LOST:
            raise OSError(f"{MOST_LOST} parts in a row could not be worked on, {entry['part']} "
                          f"because: {entry['error']}")
        if time.monotonic() > due[0]:
            took = write_results(plan, ledger, total)
            due[0] = time.monotonic() + max(INTERIM_SECONDS, 50 * took)

    with cluster.client_of(arguments.scheduler, arguments.jobs, arguments.dashboard) as client:
        try:
            cluster.run(client, plan, todo, finished)
        finally:
            line.end()
