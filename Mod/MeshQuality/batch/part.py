# SPDX-License-Identifier: LGPL-2.1-or-later
"""One part of a batch: what runs on a worker. Imports neither FreeCAD nor Dask."""

import hashlib
import os
import socket
import time

from ..cli.exit_status import DONE, USAGE
from ..files import UNFINISHED_OF_BATCH, freecad_takes, is_full, open_regular, remove_if_there, unfinished
from ..scratch import Folder
from . import freecad_pool

# The states of a part that no worker could begin or end, and of one without room for its mesh.
LOST, DISK = "lost", "disk"
# A later run does these without being asked: they say nothing of the part.
AGAIN = (LOST, DISK)


def digest_of(path, seconds=float("inf")):
    """SHA-256 of a regular file, as text; raises OSError, TimeoutError where it takes too long."""
    digest, end = hashlib.sha256(), time.monotonic() + seconds
    with open_regular(path) as stream:
        left = os.fstat(stream.fileno()).st_size  # no more: a file may grow without end
        while left > 0 and (block := stream.read(min(2**20, left))):
            digest.update(block)
            left -= len(block)
            if time.monotonic() > end:
                raise TimeoutError(f"took more than {seconds:g} s to read")
    return digest.hexdigest()


def run(task, batch):
    """The entry of the part for parts.jsonl; `task` is of Plan.task, `batch` the name of the run.

    A part counts as failed only if it failed in a FreeCAD that had done nothing before.
    """
    entry = {name: task[name] for name in ("part", "key", "size", "mtime_ns", "output")}
    entry["host"] = socket.gethostname()
    try:
        entry["digest"] = digest_of(task["path"], task["seconds"])
        for path in filter(None, (task["output_path"], task.get("page_path"))):
            os.makedirs(os.path.dirname(path), exist_ok=True)
    except OSError as error:
        state = "timeout" if isinstance(error, TimeoutError) else DISK if is_full(error) else "input"
        return {**entry, "digest": None, "output": None, "state": state, "error": str(error), "attempts": 0}
    pool = freecad_pool.pool(batch)
    found, used = _attempt(task, pool, fresh=False)
    if found["state"] in ("crash", "memory", "failed") and used and not pool.closed:
        found, _ = _attempt(task, pool, fresh=True)
        found["attempts"] = 2
    if found["state"] != "done":
        entry["output"] = None
    elif task.get("page"):
        entry["page"] = task["page"]
    if entry["output"]:
        entry["output_size"] = os.path.getsize(task["output_path"])
        entry["output_digest"] = digest_of(task["output_path"])
    return {**entry, **found}


def _attempt(task, pool, fresh):
    """(result of the part, whether its FreeCAD had done other parts before)."""
    with Folder() as made:
        scratch, path = made.path, task["path"]
        if not freecad_takes(path):
            path = os.path.join(scratch, "part" + os.path.splitext(path)[1].lower())
            os.symlink(task["path"], path)
        found, used = _run(task, path, scratch, pool, fresh)
        if "error" in found:
            found["error"] = found["error"].replace(path, task["path"])
        return found, used


def _run(task, path, scratch, pool, fresh):
    output = task["output_path"]
    ready = unfinished(output, task["suffix"], UNFINISHED_OF_BATCH) if output else None
    job = {"command": task["command"], "options": task["options"], "suffix": task["suffix"],
           "deviation": task["deviation"], "writing": task.get("writing", {}),
           "inputs": [path], "input": path, "output": output, "page": task.get("page_path"),
           "ready": ready, "scratch": scratch, "seconds": task["seconds"]}
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
            if ready:
                remove_if_there(ready)
    except freecad_pool.NotStarted as error:
        return {"state": LOST, "error": str(error), "attempts": 0}, False
    except freecad_pool.Died as end:
        return {"state": end.state, "error": str(end), "attempts": 1}, used
    return {"attempts": 1, **_outcome(result, task)}, used


def _outcome(result, task):
    found = {"seconds": round(result["seconds"], 4), "peak_mib": result["peak"] // 2**20}
    if result["status"] == DONE:
        return {"state": "done", **found, "report": result["report"]}
    state = "input" if result["status"] == USAGE else "failed"
    if state == "failed" and result.get("limit") == DISK:
        state = DISK
    elif state == "failed" and (result.get("limit") == "memory" or result["peak"] > 0.9 * task["bytes"]):
        state = "memory"
    kind = {"kind": result["kind"]} if "kind" in result else {}
    return {"state": state, **found, "error": result["text"], **kind}
