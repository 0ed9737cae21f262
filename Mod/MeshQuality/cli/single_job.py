# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job of the command line in a FreeCAD of its own, its input and output by files."""

import contextlib
import json
import os
import select
import shutil
import subprocess
import sys
import time

from .. import files, limits, scratch
from .exit_status import DONE, FAILED
from .freecad_process import freecad, freecad_command, wait_for
from .job_checks import STANDARD
from .signals import signals_held


def _use_stand_ins(job, folder, deadline):
    """Puts files in the place of standard input, and of files with names that FreeCAD cannot take.

    Returns {path of the file: what to call it}.
    """
    names = {}
    for given in {*job["inputs"], job.get("shape"), job.get("mesh"), job.get("reference")} - {None}:
        suffix = "." + job["input_format"] if given == STANDARD else os.path.splitext(given)[1]
        path = os.path.join(folder, f"input{len(names)}{suffix.lower()}")
        if given == STANDARD:
            _copy_standard_input(path, deadline)
            names[path] = "standard input"
        elif not files.freecad_takes(given):
            os.symlink(given, path)
            names[path] = f"'{given}'"
        else:
            continue
        job["inputs"] = [path if name == given else name for name in job["inputs"]]
        for name in ("input", "shape", "mesh", "reference"):
            if job.get(name) == given:
                job[name] = path
    return names


def _copy_standard_input(path, deadline):
    """Raises TimeoutError where it does not end in time."""
    if sys.stdin is None:
        raise OSError("standard input is closed")
    with open(path, "wb") as stream:
        while True:
            if deadline is not None and os.name == "posix":
                select.select([sys.stdin], [], [], max(0.0, deadline - time.monotonic()))
            if deadline is not None and time.monotonic() > deadline:
                raise TimeoutError("standard input did not end in time")
            block = sys.stdin.buffer.read1(2**20)
            if not block:
                return
            stream.write(block)


def _run_in_freecad(job, folder, deadline):
    """The result {"status", "text", "report", "met", "sound"} of the job, from a FreeCAD of its own."""
    job_path = os.path.join(folder, "job.json")
    result_path = os.path.join(folder, "result.json")
    with open(job_path, "w", encoding="utf-8") as stream:
        json.dump({**job, "result": result_path}, stream)
    # Files that FreeCAD makes for itself are removed with the folder.
    at_terminal = sys.stderr is not None and sys.stderr.isatty()
    temporary = dict.fromkeys(("TMPDIR", "TEMP", "TMP"), folder)
    environment = {**os.environ, **temporary, "MESHQUALITY_JOB": job_path,
                   "MESHQUALITY_TERMINAL": str(int(at_terminal))}
    with limits.ownership() as (ends, owner):
        process = subprocess.Popen(
            freecad_command(os.path.join("cli", "job.py")), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE, pass_fds=ends, env={**environment, **owner})
        code, words = wait_for(process, deadline)
    try:
        with open(result_path, encoding="utf-8") as stream:
            result = json.load(stream)
    except (OSError, ValueError):
        result = {"status": FAILED, "text": f"{limits.how_it_ended(code, words)}; it left no result"}
        if limits.ran_out_of_memory(words):
            result["limit"] = "memory"
    if result.get("limit") == "memory" and job["memory_limit"]:
        result["text"] = f"it took more memory than --memory-limit allows, {job['memory_limit']:g} GiB"
    return result


@contextlib.contextmanager
def _scratch_folder():
    """A folder for temporary files. No signal comes between the files and their removal."""
    with signals_held():
        made = scratch.Folder()
    try:
        yield made
    finally:
        with signals_held():
            made.remove()


def run(job):
    """The result of the job, its mesh written."""
    deadline = None if job["time_limit"] is None else time.monotonic() + job["time_limit"]
    freecad()  # says at once where there is none
    to_stdout = job.get("output") == STANDARD
    if to_stdout and sys.stdout is None:
        raise OSError("standard output is closed")
    with _scratch_folder() as made:
        folder = job["scratch"] = made.path
        try:
            names = _use_stand_ins(job, folder, deadline)
            if to_stdout:
                job["output"] = os.path.join(folder, "output" + job["suffix"])
                names[job["output"]] = "standard output"
            if job.get("output") and job["suffix"]:
                job["ready"] = files.unfinished(os.path.realpath(job["output"]), job["suffix"])
                made.note_unfinished(job["ready"])
            result = _run_in_freecad(job, folder, deadline)
        except TimeoutError:
            return {"status": FAILED, "text": f"it took longer than --time-limit allows, {job['time_limit']:g} s"}
        for path, name in names.items():
            result["text"] = result["text"].replace(f"'{path}'", name).replace(path, name)
        if to_stdout and result["status"] == DONE:
            with open(job["output"], "rb") as stream:
                shutil.copyfileobj(stream, sys.stdout.buffer)
            sys.stdout.flush()
        return result
