# SPDX-License-Identifier: LGPL-2.1-or-later
"""parts.jsonl: a line of JSON a part, and which parts need not be done again."""

import json
import os
import re
from concurrent.futures import ThreadPoolExecutor

from ..errors import Error
from .part import LOST, digest_of
from .whole_file import replacing

NAME = "parts.jsonl"
# Files yet to be renamed, here and in cli_worker.written. No part is called so: see find_parts.
_UNFINISHED = re.compile(r"\..*\.part(\.\w+)?$")


class Ledger:
    """The lines of one batch. Only one process writes them: it holds a lock on the folder."""

    def __init__(self, plan):
        self.path = plan.out / NAME
        self._plan = plan
        self._stream = None
        plan.out.mkdir(parents=True, exist_ok=True)
        self._lock = _locked(plan.out / ".lock")

    def keep(self, parts, retry=False, check_content=False):
        """Throws away the lines of what must be done, keeps the others; returns the Parts to do.

        A line is kept where the options, the version and the content of the file are those of the
        line, and the mesh that it names is there. `retry`: lines of failures are not. Also takes
        away what interrupted writers left behind.
        """
        known = {part.name: part for part in parts}
        kept, doubtful = {}, {}
        for entry in self.entries():
            part = known.get(entry["part"])
            if part and self._stands(entry, part, retry):
                same = (entry["size"], entry["mtime_ns"]) == (part.size, part.mtime_ns)
                (kept if same and not check_content else doubtful)[part.name] = entry
        with ThreadPoolExecutor(8) as pool:
            digests = pool.map(_digest_of, [self._plan.folder / name for name in doubtful])
            for entry, digest in zip(doubtful.values(), digests):
                if digest == entry["digest"]:
                    kept[entry["part"]] = {**entry, "mtime_ns": known[entry["part"]].mtime_ns}
        self._replace(kept.values())
        self._sweep()
        return [part for part in parts if part.name not in kept]

    def _stands(self, entry, part, retry):
        """Whether the entry is good for the part, if its content is still the same."""
        if entry["key"] != self._plan.key or entry["state"] == LOST or entry["size"] != part.size:
            return False
        if entry["state"] != "done":
            return not retry
        return not entry["output"] or (self._plan.out / entry["output"]).is_file()

    def entries(self):
        """The entries of the file one after the other; a last line cut short is left out."""
        if not self.path.exists():
            return
        with open(self.path, encoding="utf-8") as stream:
            for line in stream:
                if line.endswith("\n"):
                    yield json.loads(line)

    def sorted_entries(self):
        """The entries in the order of their parts' names, without all of them in memory."""
        places, offset = [], 0
        with open(self.path, "rb") as stream:
            for line in stream:
                if line.endswith(b"\n"):
                    places.append((json.loads(line)["part"], offset))
                offset += len(line)
            for _, place in sorted(places):
                stream.seek(place)
                yield json.loads(stream.readline())

    def _replace(self, entries):
        with replacing(self.path, encoding="utf-8") as stream:
            stream.writelines(json.dumps(entry) + "\n" for entry in entries)

    def _sweep(self):
        for path, _, names in os.walk(self._plan.out):
            for name in names:
                if _UNFINISHED.match(name):
                    os.unlink(os.path.join(path, name))

    def add(self, entry):
        """Adds the line of a part that was done; it stays if this process ends right afterwards."""
        if self._stream is None:
            self._stream = open(self.path, "a", encoding="utf-8")  # noqa: SIM115 - until close
        self._stream.write(json.dumps(entry) + "\n")
        self._stream.flush()

    def close(self):
        """Gives the folder free."""
        if self._stream is not None:
            self._stream.close()
            self._stream = None
        self._lock.close()


def _digest_of(path):
    """Of a file that cannot be read one that is no digest, so that the part is tried again."""
    try:
        return digest_of(path)
    except OSError:
        return ""


def _locked(path):
    """The open file of a lock that ends with this process; raises Error where another has it."""
    stream = open(path, "w", encoding="ascii")  # noqa: SIM115 - the lock lives as long as it
    try:
        import fcntl
    except ImportError:  # Windows has no such locks
        return stream
    try:
        fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        stream.close()
        raise Error(f"another batch is at work in '{path.parent}': wait for it, or name another "
                    "folder with -o") from error
    return stream
