# SPDX-License-Identifier: LGPL-2.1-or-later
"""Temporary folders that go with the process that made them; where it was killed, with the next one.

Beside each folder lies a record, a file that its process keeps locked as long as it lives: what belongs to a
record that nobody locks was left by a process that is gone. Nothing without a record is ever removed.
Imports nothing of FreeCAD.
"""

import contextlib
import json
import os
import re
import shutil
import stat
import tempfile
import uuid

from . import files

try:
    import fcntl
except ImportError:  # not on Windows: folders of killed processes stay there
    fcntl = None

_START, _RECORD = "meshquality-", ".owner"
_MOST = 2**16  # bytes of a record, which holds one path
_NAME = re.compile(_START + r"[0-9a-f]{16}" + re.escape(_RECORD))


class Folder:
    """A new temporary folder, for a `with` statement.

    path    the folder
    """

    def __init__(self):
        self._record = None
        while self._record is None:
            self.path = os.path.join(tempfile.gettempdir(), _START + uuid.uuid4().hex[:16])
            self._record = _new_record(self.path + _RECORD)
        os.mkdir(self.path, 0o700)

    def note_unfinished(self, path):
        """Has a file elsewhere, named by files.unfinished, go with the folder."""
        os.write(self._record, json.dumps({"unfinished": path}).encode())

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.remove()

    def remove(self):
        """Removes the folder, and what was noted as unfinished."""
        _remove(self.path, self._record)


def remove_left():
    """Removes the temporary folders of processes that are gone, and what they had not finished."""
    for entry in os.scandir(tempfile.gettempdir()) if fcntl is not None else ():
        if not _NAME.fullmatch(entry.name) or not _is_own(entry.path, stat.S_ISREG):
            continue
        record = _left_record(entry.path)
        if record is not None:
            _remove(entry.path[:-len(_RECORD)], record)


def _new_record(path):
    """The record made and locked, open; None where there is one, or another process has taken it for left."""
    try:
        record = os.open(path, os.O_RDWR | os.O_CREAT | os.O_EXCL, 0o600)
    except FileExistsError:
        return None
    # Where the file system knows no locks, nobody can take it for left either.
    with contextlib.suppress(OSError):
        return record if _is_locked(record, path) else None
    return record


def _left_record(path):
    """The record of a process that is gone opened and locked; None where it is not, or cannot be told."""
    with contextlib.suppress(OSError):
        record = os.open(path, os.O_RDWR | os.O_NOFOLLOW)
        try:
            if _is_locked(record, path):
                return record
        except OSError:
            os.close(record)
    return None


def _is_locked(record, path):
    """Locks the open record and returns True; closes it where another process has it, or has removed it meanwhile."""
    try:
        if fcntl is not None:
            fcntl.flock(record, fcntl.LOCK_EX | fcntl.LOCK_NB)
        if os.path.samestat(os.fstat(record), os.stat(path)):
            return True
    except (BlockingIOError, FileNotFoundError):
        pass
    os.close(record)
    return False


def _remove(path, record):
    """Removes a folder with its locked record, which goes last, and the file that this names."""
    os.lseek(record, 0, os.SEEK_SET)
    with contextlib.suppress(ValueError):  # none was noted, or its process was killed before the file was made
        unfinished = json.loads(os.read(record, _MOST))["unfinished"]
        if os.path.basename(unfinished).startswith(files.UNFINISHED) and _is_own(unfinished, stat.S_ISREG):
            files.remove_if_there(unfinished)
    if _is_own(path, stat.S_ISDIR):
        shutil.rmtree(path, ignore_errors=True)
    os.close(record)
    files.remove_if_there(path + _RECORD)


def _is_own(path, kind):
    """Whether this user's file or folder of this kind is there; no link to one."""
    try:
        found = os.lstat(path)
    except OSError:
        return False
    return kind(found.st_mode) and (not hasattr(os, "getuid") or found.st_uid == os.getuid())
