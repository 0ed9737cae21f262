# SPDX-License-Identifier: LGPL-2.1-or-later
"""One part of a batch: what runs on a worker. Imports neither FreeCAD nor Dask."""

import hashlib
import os
import socket

from ..cli import DONE, USAGE
from . import freecads

# The state of a part that nobody could begin or end; a later run does it without being asked.
LOST = "lost"


def digest_of(path):
    """SHA-256 of a file, as text."""
    digest = hashlib.sha256()
    with open(path, "rb") as stream:
        while block := stream.read(2**20):
            digest.update(block)
    return digest.hexdigest()


def run(task, batch):
    """The entry of the part for parts.jsonl; `task` is of Plan.task, `batch` the name of the run.

    A part counts as failed only if it failed in a FreeCAD that had done nothing before.
    """
    entry = {name: task[name] for name in ("part", "key", "size", "mtime_ns", "output")}
    entry["host"] = socket.gethostname()
    try:
        entry["digest"] = digest_of(task["path"])
        if task["output_path"]:
            os.makedirs(os.path.dirname(task["output_path"]), exist_ok=True)
    except OSError as error:
        return {**entry, "digest": None, "state": "input", "error": str(error), "attempts": 0}
    pool = freecads.pool(batch)
    found, used = _attempt(task, pool, fresh=False)
    if found["state"] in ("crash", "memory", "failed") and used and not pool.closed:
        found, _ = _attempt(task, pool, fresh=True)
        found["attempts"] = 2
    if found["state"] != "done":
        entry["output"] = None
    return {**entry, **found}


def _attempt(task, pool, fresh):
    """(what came of the part, whether its FreeCAD had done others before)."""
    job = {"command": task["command"], "options": task["options"], "suffix": task["suffix"],
           "deviation": task["deviation"],
           "inputs": [task["path"]], "input": task["path"], "output": task["output_path"],
           "seconds": task["seconds"]}
    used = False
    try:
        freecad = pool.take(task["bytes"], fresh)
        used = freecad.jobs > 0
        good = False
        try:
            result = freecad.run(job)
            good = result["status"] in (DONE, USAGE)
        finally:
            pool.give_back(freecad, good)
            if not good:
                _remove_unfinished(task, freecad.pid)
    except freecads.NotStarted as error:
        return {"state": LOST, "error": str(error), "attempts": 0}, False
    except freecads.Died as end:
        return {"state": end.state, "error": str(end), "attempts": 1}, used
    return {"attempts": 1, **_outcome(result, task)}, used


def _remove_unfinished(task, pid):
    """Removes the mesh that a FreeCAD was writing when it was ended; see cli_worker.written."""
    if task["output_path"]:
        folder, name = os.path.split(task["output_path"])
        path = os.path.join(folder, f".{name}.{pid}.part{task['suffix']}")
        if os.path.exists(path):
            os.remove(path)


def _outcome(result, task):
    found = {"seconds": round(result["seconds"], 4), "peak_mib": result["peak"] // 2**20}
    if result["status"] == DONE:
        return {"state": "done", **found, "report": result["report"]}
    state = "input" if result["status"] == USAGE else "failed"
    full = "MemoryError" in result["text"] or result["peak"] > 0.9 * task["bytes"]
    if state == "failed" and full:
        state = "memory"
    return {"state": state, **found, "error": result["text"]}
