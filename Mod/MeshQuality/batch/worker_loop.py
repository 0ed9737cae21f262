# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs inside FreeCAD: takes a job a line from stdin, and prints the result of each as a line."""

import ctypes
import json
import os
import sys
import threading
import time

import FreeCAD

from MeshQuality.batch import LONG_LIST, SHOWN_OF_LIST
from MeshQuality.cli import job as cli_job
from MeshQuality.limits import end_itself_after, end_with_owner, limit_memory

_GRACE = 30  # seconds beyond the limit of a job


def forget_peak():
    """Releases memory of earlier jobs, and counts the peak of memory from now on; on Linux only."""
    if not sys.platform.startswith("linux"):
        return
    trim = getattr(ctypes.CDLL(None), "malloc_trim", None)  # the GNU library has it
    if trim:
        trim(0)
    try:
        with open("/proc/self/clear_refs", "w", encoding="ascii") as stream:
            stream.write("5")
    except OSError:
        return


def memory_now():
    """(resident bytes, their peak); (0, 0) where the system does not say."""
    found = {}
    try:
        with open("/proc/self/status", encoding="ascii", errors="replace") as stream:
            for line in stream:
                name, _, value = line.partition(":")
                if name in ("VmRSS", "VmHWM"):
                    found[name] = int(value.split()[0]) * 1024
    except OSError:
        return 0, 0
    return found.get("VmRSS", 0), found.get("VmHWM", 0)


def compact(report):
    """The report without long lists: their first items, and their length as <name>_count."""
    short = {}
    for name, value in report.items():
        if isinstance(value, list) and name != "angle_histogram" and name != "box":
            short[f"{name}_count"] = len(value)
            value = value[:SHOWN_OF_LIST] if len(value) > LONG_LIST else value
        short[name] = value
    return short


def done(job):
    """The result of one job as plain data."""
    forget_peak()
    start = time.monotonic()
    result = cli_job.run(job)
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)
    resident, peak = memory_now()
    result.pop("report_text", None)
    if "report" in result:
        result["report"] = compact(result["report"])
    return {**result, "seconds": time.monotonic() - start, "resident": resident, "peak": peak}


def watch(stream, jobs, given):
    """Takes lines from stdin; its end says that nobody waits any more."""
    for line in stream:
        jobs.append(json.loads(line))
        given.release()
    os._exit(0)


def main():
    end_with_owner()
    limit_memory(int(os.environ["MESHQUALITY_SERVE"]))
    channel = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # nobody reads FreeCAD's output
    jobs, given = [], threading.Semaphore(0)
    stdin = os.fdopen(0, "rb", closefd=False)
    threading.Thread(target=watch, args=(stdin, jobs, given), daemon=True).start()
    channel.write(json.dumps({"meshquality": "ready"}) + "\n")
    channel.flush()
    while True:
        given.acquire()
        job = jobs.pop(0)
        end_itself_after(int(job["seconds"]) + _GRACE)
        result = done(job)
        end_itself_after(0)
        channel.write(json.dumps({"meshquality": "done", **result}) + "\n")
        channel.flush()


if "MESHQUALITY_SERVE" in os.environ:
    main()
