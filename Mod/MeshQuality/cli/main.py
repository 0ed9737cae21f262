# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program bin/meshquality: does what its arguments ask for, and says what came of it."""

import json
import os
import sys
import tempfile

from .. import scratch
from ..errors import Error
from . import single_job
from .exit_status import DONE, FAILED, MISSED, USAGE
from .job_checks import STANDARD, job_of
from .parser import parse
from .signals import EndedBySignals, signals_held


def main(arguments=None):
    """Runs the command line; returns the exit status."""
    parsed = parse(arguments)
    if hasattr(sys.stdout, "reconfigure"):
        sys.stdout.reconfigure(errors="backslashreplace")  # as Python has it for stderr: not every terminal has a sign for degrees
    with EndedBySignals(last=arguments is None):
        result = _outcome(parsed)
        try:
            printed = _print(result, parsed)
        except KeyboardInterrupt:
            printed = False
    if not printed:
        return result["status"] or FAILED
    # A Boolean that is no closed manifold is of no use, whether anybody asked for strictness or not.
    missed = result["status"] == DONE and not (result.get("sound", True) and (result["met"] or not parsed.strict))
    return MISSED if missed else result["status"]


def _outcome(parsed):
    """The result of the command, also where it was ended or failed."""
    try:
        return _result_of(parsed)
    except Error as error:
        return {"status": USAGE, "text": str(error)}
    except BrokenPipeError:
        _give_up(sys.stdout)
        return {"status": FAILED, "text": "standard output was closed before all was written"}
    except OSError as error:
        return {"status": FAILED, "text": str(error)}
    except KeyboardInterrupt:
        remedy = ": run it again to go on" if parsed.command == "batch" else ""
        return {"status": FAILED, "text": "interrupted" + remedy}


def _result_of(parsed):
    try:
        os.getcwd()
    except FileNotFoundError as error:
        raise Error("the working folder is gone: change into one that is there") from error
    with signals_held():
        tempfile.gettempdir()  # Python tries the folder by a file, which an interruption would leave there
    scratch.remove_left()
    if parsed.command == "batch":
        from ..batch import command  # single jobs start without all that batches need

        return command.run(parsed)
    return single_job.run(job_of(parsed))


def _give_up(stream):
    """Nobody reads the stream any more; Python must not flush it once more when it ends."""
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
    return _put(f"meshquality: {_on_one_line(result['text'])}{lost}\n", sys.stderr) and good


def _on_one_line(text):
    """The text with signs escaped that are not printed, such as the ends of lines and a terminal's commands in names."""
    return "".join(sign if sign.isprintable() else sign.encode("unicode_escape", "surrogatepass").decode()
                   for sign in text)


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
