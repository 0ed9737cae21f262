# SPDX-License-Identifier: LGPL-2.1-or-later
"""parts.jsonl: a line of JSON a part, and which parts need not be done again."""

import json
import os
import socket
import sys
from concurrent.futures import ThreadPoolExecutor

from ..errors import Error
from ..files import UNFINISHED_OF_BATCH, open_regular
from . import report
from .atomic_file import replacing
from .part import AGAIN, digest_of

NAME = "parts.jsonl"
_TYPES = {"part": str, "key": str, "size": int, "mtime_ns": int, "state": str,
          "output": (str, type(None)), "digest": (str, type(None))}


class Ledger:
    """The lines of one batch. Only one process writes them: it holds a lock on the folder."""

    def __init__(self, plan):
        self.path = plan.out / NAME
        self._plan = plan
        self._stream = None
        plan.out.mkdir(parents=True, exist_ok=True)
        self._lock = _locked(plan.out / ".lock")

    def keep(self, parts, retry=False, check_content=False, chosen=None):
        """Throws away the lines of what must be done, keeps the others; returns the Parts to do.

        A line is kept where the options, the version and the content of the file are those of the
        line, and the mesh of the part is there as it was written: by its size, with `check_content` by its content. `retry`: lines of failures are not. Lines of parts
        that are not `chosen`, by name, stay as they are. Also removes files of interrupted writers
        and, with a message, damaged lines.
        """
        known = {part.name: part for part in parts}
        kept, doubtful = {}, {}
        for entry in self.entries(_say_damaged):
            if chosen and not chosen(entry["part"]):
                kept[entry["part"]] = entry
                continue
            kept.pop(entry["part"], None)  # the last line of a part counts
            doubtful.pop(entry["part"], None)
            part = known.get(entry["part"])
            if part and self._stands(entry, part, retry, check_content):
                same = (entry["size"], entry["mtime_ns"]) == (part.size, part.mtime_ns)
                (kept if same and not check_content else doubtful)[part.name] = entry
        with ThreadPoolExecutor(8) as pool:
            digests = pool.map(self._digest_of, doubtful)
            for entry, digest in zip(doubtful.values(), digests):
                if digest == entry["digest"]:
                    kept[entry["part"]] = {**entry, "mtime_ns": known[entry["part"]].mtime_ns}
        self._replace(kept.values())
        self._sweep()
        return [part for part in parts if part.name not in kept]

    def _stands(self, entry, part, retry, check_content):
        """Whether the entry is good for the part, if its content is still the same."""
        if entry["key"] != self._plan.key or entry["state"] in AGAIN or entry["size"] != part.size:
            return False
        if entry["state"] != "done":
            return not retry
        # A line may be edited, or copied from another folder.
        return entry["output"] == self._plan.output_of(part.name) and (
            entry["output"] is None or self._is_as_written(entry, check_content))

    def _is_as_written(self, entry, check_content):
        path = self._plan.out / entry["output"]
        try:
            return path.is_file() and path.stat().st_size == entry.get("output_size") and (
                not check_content or digest_of(path) == entry.get("output_digest"))
        except OSError:
            return False

    def entries(self, damaged=None):
        """The entries of the file one after the other; damaged(path, line number) hears of bad lines.

        A last line cut short is left out without a word: so ends a batch that was interrupted.
        """
        if not self.path.exists():
            return
        with open_regular(self.path) as stream:
            for i, line in enumerate(stream):
                if line.endswith(b"\n"):
                    entry = self._entry_of(line)
                    if entry:
                        yield entry
                    elif damaged:
                        damaged(self.path, i + 1)

    def _entry_of(self, line):
        """The entry of a line, None where it is damaged."""
        try:
            entry = json.loads(line)
        except (ValueError, RecursionError):
            return None
        good = isinstance(entry, dict) \
            and all(isinstance(entry.get(name, 0.5), kind) for name, kind in _TYPES.items()) \
            and report.can_show(entry, self._plan.command)
        return entry if good else None

    def sorted_entries(self):
        """The entries in the order of their parts' names, without all of them in memory."""
        places, offset = [], 0
        if not self.path.exists():
            return
        with open_regular(self.path) as stream:
            for line in stream:
                entry = self._entry_of(line) if line.endswith(b"\n") else None
                if entry:
                    places.append((entry["part"], offset))
                offset += len(line)
            for _, place in sorted(places):
                stream.seek(place)
                yield json.loads(stream.readline())

    def _replace(self, entries):
        self._close_stream()
        with replacing(self.path, encoding="utf-8") as stream:
            stream.writelines(json.dumps(entry) + "\n" for entry in entries)

    def _sweep(self):
        """Removes the files that a batch began and could not complete: they have names of their own."""
        for path, _, names in os.walk(self._plan.out):
            for name in names:
                if name.startswith(UNFINISHED_OF_BATCH):
                    os.unlink(os.path.join(path, name))

    def _digest_of(self, name):
        """The digest of a file; empty where that cannot be read, so that the part is tried again."""
        try:
            return digest_of(self._plan.folder / name, self._plan.seconds)
        except OSError:
            return ""

    def add(self, entry):
        """Adds the line of a part that was done; it stays if this process ends right afterwards."""
        if self._stream is None:
            self._stream = open(self.path, "a", encoding="utf-8")  # noqa: SIM115 - until close
        self._stream.write(json.dumps(entry) + "\n")
        self._stream.flush()

    def close(self):
        """Releases the lock of the folder."""
        self._close_stream()
        self._lock.close()

    def _close_stream(self):
        if self._stream is not None:
            self._stream.close()
            self._stream = None


def _say_damaged(path, number):
    print(f"meshquality: {path}: line {number} is damaged and was left out; its part is done again",
          file=sys.stderr)


def _locked(path):
    """The open file of a lock that ends with this process; raises Error where another has it."""
    # No link is followed: what it leads to is not the batch's to write.
    flags = os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
    stream = os.fdopen(os.open(path, flags, 0o666), "r+b", buffering=0)
    try:
        import fcntl
    except ImportError:  # Windows has no fcntl
        return stream
    try:
        fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        owner = stream.read(400).decode(errors="replace").strip()
        stream.close()
        raise Error(f"another batch is at work in '{path.parent}'{f' ({owner})' if owner else ''}: wait for "
                    "it, or name another folder with -o") from error
    stream.truncate(0)
    stream.write(f"process {os.getpid()} on {socket.gethostname()}\n".encode())
    return stream
