#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Attacks MeshQuality by all its faces and counts what it survives.

    /usr/bin/python3 tests/attacks/run.py [TABLE ...] [--only TEXT] [--slowest N]

Each table of INSIDE runs in a FreeCAD of its own,
which is started again behind an attack that it did not survive; those of
OUTSIDE attack the command line. The last lines are '312 attacks: 312 survived' and 'N passed, N failed'.
"""

import argparse
import contextlib
import importlib
import json
import os
import select
import signal
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
INSIDE = ("known", "numbers_given", "arrays_given", "meshes_given", "shapes_given", "callbacks", "documents_edited")
OUTSIDE = ("command_line", "folders")
START_SECONDS = 60.0
SLACK = 3.0  # of a machine that others use, too: times the limit of each attack


def freecad_lines(table, first, only, temporary):
    """What inside.py says, line by line as dicts; at last {"ended": how}, unless it came to the end of the table."""
    reading, writing = os.pipe()
    environment = {**os.environ, "ATTACKS_PIPE": str(writing), "ATTACKS_TABLE": table, "ATTACKS_FIRST": str(first),
                   "ATTACKS_ONLY": only, "TMPDIR": temporary}
    program = os.environ.get("MESHQUALITY_FREECADCMD", "freecadcmd")
    log = tempfile.TemporaryFile()
    process = subprocess.Popen([program, "-P", str(ROOT / "Mod"), "-P", str(HERE), str(HERE / "inside.py")],
                               stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT, env=environment,
                               pass_fds=(writing,), start_new_session=True)
    os.close(writing)
    try:
        late = yield from _lines(reading)
        if late:
            yield {"ended": f"hangs: not back after {late:.0f} s"}
        elif process.wait(START_SECONDS):
            log.seek(max(0, log.seek(0, os.SEEK_END) - 3000))
            yield {"ended": f"ended with {process.returncode}:\n{log.read().decode(errors='replace')[-1500:]}"}
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        os.close(reading)
        log.close()


def _lines(reading):
    """The lines as dicts; returns the seconds waited for one that did not come, None at the end."""
    rest, limit = b"", START_SECONDS
    while True:
        if not select.select([reading], [], [], limit)[0]:
            return limit
        block = os.read(reading, 65536)
        if not block:
            return None
        *lines, rest = (rest + block).split(b"\n")
        for line in map(json.loads, lines):
            limit = SLACK * line.get("limit", START_SECONDS / SLACK)
            yield line


class Found(list):
    """[(name, fault or None, seconds)] of the attacks of a table; faults are printed at once."""

    def __init__(self, table):
        super().__init__()
        self.table = table

    def add(self, name, fault, begun):
        """Of an attack that began then."""
        name = f"{self.table}: {name}"
        self.append((name, fault, time.monotonic() - begun))
        if fault is not None:
            print(f"--- {name}\n{fault}", flush=True)


def inside(table, only):
    """What was Found by a table that is run inside FreeCAD."""
    found, first, begun = Found(table), 0, None
    while first is not None:
        with tempfile.TemporaryDirectory() as temporary:
            for line in freecad_lines(table, first, only, temporary):
                if "name" in line:
                    begun = (line["row"], line["name"], time.monotonic())
                elif "fault" in line:
                    found.add(begun[1], line["fault"], begun[2])
                    begun = None
                elif begun is None:
                    found.add("the table itself", line["ended"], time.monotonic())
                    return found
                else:
                    found.add(begun[1], line["ended"], begun[2])
        first, begun = (begun[0] + 1, None) if begun else (None, None)
    return found


def outside(table, only):
    """The same of a table that attacks the command line."""
    found = Found(table)

    def survived(row):
        start, fault = time.monotonic(), None
        try:
            row.call()
        except (AssertionError, OSError, subprocess.SubprocessError, ValueError) as error:
            fault = f"{type(error).__name__}: {error}"
        found.add(row.name, fault, start)

    # They wait for processes half of their time.
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for future in [pool.submit(survived, row) for row in importlib.import_module(table).rows() if only in row.name]:
            future.result()
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tables", nargs="*", metavar="TABLE", help=" ".join(INSIDE + OUTSIDE))
    parser.add_argument("--only", default="", help="attacks whose names have this text in them")
    parser.add_argument("--slowest", type=int, default=0, help="name so many that took longest")
    arguments = parser.parse_args()
    tables = arguments.tables or INSIDE + OUTSIDE
    start = time.monotonic()
    sys.path[:0] = [str(HERE), str(ROOT / "Mod")]
    # Most attacks keep one processor busy.
    with ThreadPoolExecutor(max(2, os.cpu_count() or 1)) as pool:
        # Those outside take longest.
        ordered = sorted(tables, key=lambda table: table in INSIDE)
        done = {table: pool.submit(inside if table in INSIDE else outside, table, arguments.only)
                for table in ordered}
        found = {table: done[table].result() for table in tables}
    everything = [row for rows in found.values() for row in rows]
    failed = [row for row in everything if row[1] is not None]
    for name, _, seconds in sorted(everything, key=lambda row: -row[2])[:arguments.slowest]:
        print(f"{seconds:8.2f} s  {name}")
    for table, rows in found.items():
        print(f"{table:<18} {len(rows):5} attacks, {sum(row[2] for row in rows):6.1f} s")
    print(f"{time.monotonic() - start:.0f} s")
    print(f"{len(everything)} attacks: {len(everything) - len(failed)} survived")
    print(f"{len(everything) - len(failed)} passed, {len(failed) + (not everything)} failed")
    return 1 if failed or not everything else 0


if __name__ == "__main__":
    sys.exit(main())
