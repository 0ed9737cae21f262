# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the oracles inside FreeCAD; the last line is 'N passed, N failed'.

    freecadcmd -P <root>/Mod tests/oracles/run.py </dev/null

Environment
    MESHQUALITY_ORACLES        inputs for each function; 20 unless given
    MESHQUALITY_ORACLES_OF     names of functions, all unless given: "boolean curve"
    MESHQUALITY_ORACLES_KINDS  kinds of inputs, "," between them; all of each function unless given
    MESHQUALITY_ORACLES_FIRST  the first seed; 0 unless given
    MESHQUALITY_ORACLES_LIMIT  seconds of processor for each input; 5 unless given
    MESHQUALITY_ORACLES_AT_ONCE  inputs at a time; as many as there are cores unless given

Each input runs in a process of its own. Outcomes: right; said (a limit is missed, and the result says so); refused (an error
of MeshQuality); late (not done within its seconds); no input (no valid solid of this seed). Wrong ones, and what
ends FreeCAD, are printed as a script of three lines. Only what was compared counts as passed; a function of which
nothing was compared fails.
"""

import collections
import importlib
import json
import os
import resource
import select
import signal
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(HERE))
FUNCTIONS = ("triangulate", "curve", "boolean", "offset", "hollow", "wrap", "improve", "quality", "thickness",
             "clearance", "draft", "voids", "certify", "files", "patches", "objects")
PATIENCE = 6  # times the limit, on a machine that others use, too: one that waits for itself is late by then
COMPARED = ("right", "said")
FAILED = ("wrong", "ended")
_SCRIPT = """    import sys; sys.path.insert(0, "tests/oracles"); import solids, {function}
    shape = solids.make({kind!r}, {seed})
    print({function}.check(shape, {seed}))"""


def outcome(function, kind, seed):
    """(outcome, sentence) of one input, in this process."""
    import judge  # noqa: PLC0415  on the path only now
    import MeshQuality as mq  # noqa: PLC0415
    import solids  # noqa: PLC0415

    try:
        return importlib.import_module(function).check(solids.make(kind, seed), seed), ""
    except judge.WrongError as error:
        return "wrong", str(error)
    except solids.NoSolidError as error:
        return "no input", str(error)
    except mq.Error as error:
        return "refused", f"{type(error).__name__}: {error}"
    except Exception as error:
        frame = error.__traceback__
        while frame.tb_next:
            frame = frame.tb_next
        where = f"{Path(frame.tb_frame.f_code.co_filename).name}:{frame.tb_lineno}"
        return "wrong", f"{type(error).__name__} at {where}: {error}"


class Child:
    """One input in a process of its own."""

    def __init__(self, case, limit):
        self.case, self.start, self.text = case, time.monotonic(), b""
        self.until = self.start + PATIENCE * limit
        self.pipe, writing = os.pipe()
        sys.stdout.flush()
        self.number = os.fork()
        if self.number == 0:
            try:  # whatever happens, this process does not go on as the runner
                os.close(self.pipe)
                quiet = os.open(os.devnull, os.O_RDWR)
                for stream in (0, 1, 2):
                    os.dup2(quiet, stream)
                resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))
                os.write(writing, json.dumps(outcome(*case)).encode())
            finally:
                os._exit(0)
        os.close(writing)

    def read(self):
        """Whether it has ended."""
        block = os.read(self.pipe, 65536)
        self.text += block
        return not block

    def result(self, late):
        """(outcome, sentence), once it has ended or is late."""
        if late:
            os.kill(self.number, signal.SIGKILL)
        os.close(self.pipe)
        status = os.waitstatus_to_exitcode(os.waitpid(self.number, 0)[1])
        late = late or status in (-signal.SIGXCPU, -signal.SIGKILL)
        if self.text and not late:
            return tuple(json.loads(self.text))
        return ("late", "") if late else ("ended", f"FreeCAD ended with {status}")


def results(cases, limit, at_once):
    """(case, outcome, sentence, seconds) of each, so many at a time."""
    waiting, running = collections.deque(cases), []
    while waiting or running:
        while waiting and len(running) < at_once:
            running.append(Child(waiting.popleft(), limit))
        ready = select.select([child.pipe for child in running], [], [], 0.2)[0]
        for child in list(running):
            ended = child.pipe in ready and child.read()
            if ended or time.monotonic() > child.until:
                running.remove(child)
                yield child.case, *child.result(not ended), time.monotonic() - child.start


def processor_seconds():
    """Of all inputs until now."""
    spent = resource.getrusage(resource.RUSAGE_CHILDREN)
    return spent.ru_utime + spent.ru_stime


def cases_of(function, count, first, chosen):
    kinds = [kind for kind in importlib.import_module(function).KINDS if not chosen or kind in chosen]
    step = max(1, len(kinds) // count) if kinds else 1  # few inputs still are of all sorts
    return [(function, kinds[(seed * step) % len(kinds)], seed) for seed in range(first, first + count) if kinds]


def main():
    environment = os.environ.get
    count, first = int(environment("MESHQUALITY_ORACLES", "20")), int(environment("MESHQUALITY_ORACLES_FIRST", "0"))
    chosen = [kind for kind in environment("MESHQUALITY_ORACLES_KINDS", "").split(",") if kind]
    limit = int(environment("MESHQUALITY_ORACLES_LIMIT", "5"))
    at_once = int(environment("MESHQUALITY_ORACLES_AT_ONCE", str(os.cpu_count() or 1)))
    os.environ["MESHQUALITY_THREADS"] = "1"  # as many inputs at a time as there are cores
    from MeshQuality.compat import extension  # noqa: PLC0415

    extension()  # loaded once, before the processes part
    passed = failed = 0
    for function in environment("MESHQUALITY_ORACLES_OF", "").split() or FUNCTIONS:
        begin, used, counts = time.monotonic(), processor_seconds(), collections.Counter()
        for (_, kind, seed), found, sentence, seconds in results(cases_of(function, count, first, chosen), limit, at_once):
            counts[found] += 1
            if found not in COMPARED:
                print(f"{function} {kind!r} {seed}: {found} after {seconds:.1f} s: {sentence}", flush=True)
            if found in FAILED:
                print(_SCRIPT.format(function=function, kind=kind, seed=seed), flush=True)
        good, bad = sum(counts[one] for one in COMPARED), sum(counts[one] for one in FAILED)
        passed, failed = passed + good, failed + (bad or int(not good))
        text = ", ".join(f"{number} {name}" for name, number in counts.most_common())
        print(f"{function}: {text}; {time.monotonic() - begin:.0f} s, {processor_seconds() - used:.0f} s of processor", flush=True)
    print(f"{passed} passed, {failed} failed", flush=True)
    return 1 if failed else 0


if "FreeCAD" in sys.modules:
    sys.exit(main())
