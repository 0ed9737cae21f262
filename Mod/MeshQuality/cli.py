# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line, seen from outside FreeCAD: checks of arguments and the start of FreeCAD.

Imports nothing of FreeCAD. The job travels in a file, because FreeCAD's own option parser takes
what is on its command line, and the result comes back in one, because FreeCAD prints to stdout.
"""

import json
import os
import select
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

from . import files, limits, options
from .cli_parser import (
    CAD_SUFFIXES,
    FEM_SUFFIXES,
    FLAT_SUFFIXES,
    INPUTS,
    OUTPUTS,
    TABLES,
    parse,
)
from .errors import Error

DONE, FAILED, USAGE, MISSED = 0, 1, 2, 3
STANDARD = "-"


def job_of(arguments):
    """What FreeCAD is to do; raises Error for what can be seen without starting it.

    A dict of the arguments: files by absolute path, of standard input and output by "-" yet;
    "options" has those of the operation, checked.
    """
    job = vars(arguments).copy()
    command = job["command"]
    for name in ("input", "shape", "output"):
        if job.get(name):
            job[name] = _absolute(job[name])
    job["inputs"] = [_absolute(path) for path in job.get("inputs") or [job["input"]]]
    for path in job["inputs"]:
        require_input(path, INPUTS[command], job["input_format"])
    require_input(job.get("shape"), CAD_SUFFIXES, job["input_format"])
    if (job["inputs"] + [job.get("shape")]).count(STANDARD) > 1:
        raise Error("standard input, -, can be read once only: name a file for the others")
    if len(job["inputs"]) == 1 and command == "boolean":
        raise Error("a Boolean needs two inputs or more")
    job["options"] = take_options(job, TABLES[command])
    job["suffix"] = suffix_of_output(job)
    for flag, value in (("--time-limit", job["time_limit"]), ("--memory-limit", job["memory_limit"])):
        if value is not None and not 0 < value < float("inf"):
            raise Error(f"{flag} {value:g} is not allowed: it must be greater than 0")
    if job.get("output") == STANDARD and job["json"]:
        raise Error("--json and the mesh cannot both go to standard output: name a file with -o")
    return job


def _absolute(path):
    return path if path == STANDARD else os.path.abspath(path)


def take_options(job, table):
    """The options of a table, checked, as a dict; they are taken out of the job."""
    return options.check(table, {option.name: job.pop(option.name) for option in table})


def require_input(path, suffixes, input_format=None):
    """Raises Error where a file is not there or has no extension that says what it is."""
    if path == STANDARD:
        if input_format is None:
            raise Error("--input-format must say what standard input is: one of "
                        + " ".join(suffix[1:] for suffix in suffixes))
        require_format("--input-format", input_format, suffixes)
    elif path:
        _require_file(path)
        _require_suffix(path, suffixes)


def _require_file(path):
    try:
        kind = files.kind_of(os.stat(path).st_mode)
    except (OSError, ValueError):
        raise Error(f"there is no file '{path}'") from None
    if kind:
        raise Error(f"'{path}' is {kind}, not a file")


def require_format(flag, name, suffixes):
    """The extension of a format; raises Error for one that is not known here."""
    if "." + name.lower() not in suffixes:
        raise Error(f"{flag} {name} is not known here: it must be one of "
                    + " ".join(suffix[1:] for suffix in suffixes))
    return "." + name.lower()


def _require_suffix(path, suffixes):
    suffix = os.path.splitext(path)[1].lower()
    if suffix not in suffixes:
        raise Error(f"'{path}' has no known extension: it must be one of {' '.join(suffixes)}")
    return suffix


def suffix_of_output(job):
    """The extension that says how the mesh is written, None without output; raises Error."""
    path, name, known = job.get("output"), job.get("format"), OUTPUTS[job["command"]]
    if not path:
        if name:
            raise Error(f"--format {name} needs a file to write to: give one with -o")
        if job.get("deviation"):
            raise Error("--deviation is for flat triangles in a file: give one with -o")
        return None
    if name:
        suffix = require_format("--format", name, known)
    elif path == STANDARD:
        raise Error("--format must say how the mesh goes to standard output: one of "
                    + " ".join(suffix[1:] for suffix in known))
    else:
        suffix = _require_suffix(path, known)
    if path != STANDARD and os.path.isdir(path):
        raise Error(f"'{path}' is a folder: give the name of a file with -o")
    if path != STANDARD and not os.path.isdir(os.path.dirname(path)):
        raise Error(f"there is no folder '{os.path.dirname(path)}' to write to")
    if job["command"] == "curve":
        require_curved_output(job, suffix)
    return suffix


def require_curved_output(job, suffix):
    """Raises Error where a curved mesh cannot be written so."""
    order = job["options"]["order"]
    if suffix in FEM_SUFFIXES and order > 2:
        raise Error(f"{suffix} files hold elements of order 1 and 2, not {order}: use .msh or .vtu")
    if job.get("deviation") is not None:
        job["deviation"] = options.check(options.CURVED_DISPLAY,
                                         {"deviation": job["deviation"]})["deviation"]
        if suffix not in FLAT_SUFFIXES:
            raise Error(f"--deviation is for flat triangles, not for {suffix} files")


def freecad():
    """FreeCAD's console program; MESHQUALITY_FREECADCMD overrides. Raises OSError."""
    for name in ("TMPDIR", "TEMP", "TMP"):  # FreeCAD ends at its start where it cannot use it
        folder = os.environ.get(name)
        if folder and not (os.path.isdir(folder) and os.access(folder, os.W_OK | os.X_OK)):
            raise OSError(f"{name} names '{folder}', which is no folder that can be written to: FreeCAD needs "
                          "one for temporary files")
    chosen = os.environ.get("MESHQUALITY_FREECADCMD")
    for name in [chosen] if chosen else ["freecadcmd", "FreeCADCmd", "freecad.cmd"]:
        path = shutil.which(name)
        if path:
            return path
    raise OSError("FreeCAD's console program freecadcmd is not found: put it on PATH, or name "
                  "it in MESHQUALITY_FREECADCMD")


def freecad_command(script):
    """The command that runs a script of this package in FreeCAD."""
    package = os.path.dirname(os.path.abspath(__file__))
    return [freecad(), "-P", os.path.dirname(package), os.path.join(package, script)]


def _use_stand_ins(job, folder, deadline):
    """Puts files in the place of standard input, and of files with names that FreeCAD cannot take.

    Returns {path of the file: what to call it}.
    """
    names = {}
    for given in {*job["inputs"], job.get("shape")} - {None}:
        suffix = "." + job["input_format"] if given == STANDARD else os.path.splitext(given)[1]
        path = os.path.join(folder, f"input{len(names)}{suffix.lower()}")
        if given == STANDARD:
            _copy_standard_input(path, deadline)
            names[path] = "standard input"
        elif not files.is_utf8(given):
            os.symlink(given, path)
            names[path] = f"'{given}'"
        else:
            continue
        job["inputs"] = [path if name == given else name for name in job["inputs"]]
        for name in ("input", "shape"):
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
    environment = {**os.environ, "MESHQUALITY_JOB": job_path, "MESHQUALITY_TERMINAL": str(int(_at_terminal()))}
    with limits.ownership() as (ends, owner):
        process = subprocess.Popen(
            freecad_command("cli_worker.py"), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE, pass_fds=ends, env={**environment, **owner})
        code, words = _wait_for(process, deadline)
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


def _at_terminal():
    return sys.stderr is not None and sys.stderr.isatty()


def _wait_for(process, deadline):
    """(exit code, last words) of the process, which does not outlive this one when that is told to end.

    What it writes to stderr is handed on. Raises TimeoutError after the deadline.
    """
    words = bytearray()

    def hand_on():
        while block := os.read(process.stderr.fileno(), 65536):
            words.extend(block)
            del words[:-20000]
            if sys.stderr is not None:
                sys.stderr.write(block.decode(errors="replace"))
                sys.stderr.flush()

    reader = threading.Thread(target=hand_on, daemon=True)
    with ended_by_sigterm():
        reader.start()
        try:
            code = process.wait(None if deadline is None else max(0.0, deadline - time.monotonic()))
        except subprocess.TimeoutExpired as error:
            raise TimeoutError("FreeCAD did not end in time") from error
        finally:
            if process.poll() is None:
                process.kill()
                process.wait()
            reader.join(5)  # what the process started may hold its stderr
    return code, words.decode(errors="replace")


class ended_by_sigterm:  # noqa: N801 - used like a function
    """Has SIGTERM raise KeyboardInterrupt, as Ctrl-C does."""

    def __enter__(self):
        def end(*_):
            raise KeyboardInterrupt

        self._before = signal.signal(signal.SIGTERM, end)

    def __exit__(self, *_):
        signal.signal(signal.SIGTERM, self._before)


def _run(job):
    """The result of the job, its mesh written."""
    deadline = None if job["time_limit"] is None else time.monotonic() + job["time_limit"]
    freecad()  # says at once where there is none
    to_stdout = job.get("output") == STANDARD
    if to_stdout and sys.stdout is None:
        raise OSError("standard output is closed")
    with tempfile.TemporaryDirectory(prefix="meshquality-") as folder:
        job["scratch"] = folder
        try:
            names = _use_stand_ins(job, folder, deadline)
            if to_stdout:
                job["output"] = os.path.join(folder, "output" + job["suffix"])
                names[job["output"]] = "standard output"
            if job.get("output"):
                job["ready"] = files.unfinished(os.path.realpath(job["output"]), job["suffix"])
            result = _run_in_freecad(job, folder, deadline)
        except TimeoutError:
            return {"status": FAILED, "text": f"it took longer than --time-limit allows, {job['time_limit']:g} s"}
        finally:
            if job.get("ready"):
                files.remove_if_there(job["ready"])
        for path, name in names.items():
            result["text"] = result["text"].replace(f"'{path}'", name).replace(path, name)
        if to_stdout and result["status"] == DONE:
            with open(job["output"], "rb") as stream:
                shutil.copyfileobj(stream, sys.stdout.buffer)
            sys.stdout.flush()
        return result


def main(arguments=None):
    """Runs the command line; returns the exit status."""
    parsed = parse(arguments)
    if hasattr(sys.stdout, "reconfigure"):
        sys.stdout.reconfigure(errors="backslashreplace")  # as stderr: not every terminal has a sign for degrees
    try:
        if parsed.command == "batch":
            from .batch import command

            result = command.run(parsed)
        else:
            result = _run(job_of(parsed))
    except Error as error:
        result = {"status": USAGE, "text": str(error)}
    except BrokenPipeError:
        _give_up(sys.stdout)
        result = {"status": FAILED, "text": "standard output was closed before all was written"}
    except OSError as error:
        result = {"status": FAILED, "text": str(error)}
    except KeyboardInterrupt:
        remedy = ": run it again to go on" if parsed.command == "batch" else ""
        result = {"status": FAILED, "text": "interrupted" + remedy}
    if not _print(result, parsed):
        return result["status"] or FAILED
    # A Boolean that is no closed manifold is of no use, whether anybody asked for strictness or not.
    missed = result["status"] == DONE and not (result.get("sound", True) and (result["met"] or not parsed.strict))
    return MISSED if missed else result["status"]


def _give_up(stream):
    """Nobody takes what is written there any more; Python must not try once more when it ends."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def _print(result, parsed):
    """Whether all could be printed."""
    good = True
    if parsed.json:
        failure = {} if result["status"] == DONE else {"error": result["text"]}
        good = _put(json.dumps({**result.get("report", {}), **failure}) + "\n", sys.stdout)
    elif "report_text" in result:
        # Standard output may hold the mesh.
        held = getattr(parsed, "output", None) == STANDARD and parsed.command != "batch"
        good = _put(result["report_text"], sys.stderr if held else sys.stdout)
    lost = "" if good else "; the report could not be written to standard output"
    return _put(f"meshquality: {result['text']}{lost}\n", sys.stderr) and good


def _put(text, stream):
    """Whether the stream took the text."""
    if stream is None:  # it was closed before Python started
        return False
    try:
        stream.write(text)
        stream.flush()
    except OSError:
        _give_up(stream)
        return False
    return True
