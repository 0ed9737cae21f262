# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that are read and replaced with care: no devices in the place of files, nothing half written.

Imports nothing of FreeCAD.
"""

import contextlib
import errno
import os
import shutil
import stat
import uuid

from .errors import IoError

# Names of files yet to be renamed begin so; those of a batch are removed by the next one.
UNFINISHED = ".meshquality-"
UNFINISHED_OF_BATCH = UNFINISHED + "batch-"
_FULL = (errno.ENOSPC, getattr(errno, "EDQUOT", errno.ENOSPC))
_KINDS = ((stat.S_ISDIR, "a folder"), (stat.S_ISFIFO, "a pipe"), (stat.S_ISSOCK, "a socket"),
          (stat.S_ISCHR, "a device"), (stat.S_ISBLK, "a device"))


class DiskFull(IoError):  # noqa: N818 - told apart by batch only
    """There was no room for a file."""


def is_full(error):
    """Whether the OSError says that there is no room."""
    return error.errno in _FULL


def kind_of(mode):
    """What a file of this mode is in words; None for a regular one."""
    return next((name for test, name in _KINDS if test(mode)), None)


def unfinished(path, suffix, start=UNFINISHED):
    """The path of a file beside `path` that is to get its name once it is complete."""
    return os.path.join(os.path.dirname(path), f"{start}{uuid.uuid4().hex[:16]}.part{suffix}")


def open_regular(path):
    """The regular file opened for reading in binary; raises OSError naming another kind."""
    # Looked at before it is opened: to open a device may do something.
    _require_regular(path, os.stat(path).st_mode)
    stream = os.fdopen(os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0)
                               | getattr(os, "O_BINARY", 0)), "rb")
    try:
        _require_regular(path, os.fstat(stream.fileno()).st_mode)
    except OSError:
        stream.close()
        raise
    return stream


def _require_regular(path, mode):
    kind = kind_of(mode)
    if kind:
        raise OSError(f"'{path}' is {kind}, not a file")


def freecad_takes(path):
    """Whether FreeCAD can be given the path: it takes UTF-8 only, and reads a backslash as a slash, so as another
    file.
    """
    if os.sep == "/" and "\\" in path:
        return False
    try:
        path.encode()
    except UnicodeEncodeError:
        return False
    return True


def put_in_place(ready, path):
    """Gives the complete file `ready` the name `path`; a file there keeps mode, owner and hard links.

    `path` may be a pipe or a device, too: then it gets the content.
    """
    try:
        old = os.stat(path)
    except FileNotFoundError:
        _move(ready, path)
        return
    if not stat.S_ISREG(old.st_mode):
        fill(ready, path)
        return
    mine = os.stat(ready)
    if old.st_nlink > 1 or (old.st_uid, old.st_gid) != (mine.st_uid, mine.st_gid):
        if os.access(path, os.W_OK):
            fill(ready, path)
            return
    with contextlib.suppress(PermissionError):
        os.chmod(ready, stat.S_IMODE(old.st_mode))
    _move(ready, path)


def _move(ready, path):
    try:
        os.replace(ready, path)
    except OSError as error:
        if error.errno != errno.EXDEV:
            raise
        near = unfinished(path, "")
        try:
            shutil.copy(ready, near)
            os.replace(near, path)
        finally:
            remove_if_there(near)
        os.remove(ready)


def fill(ready, path):
    """Puts the content of `ready`, which is removed, into what is there: a file, a pipe or a device. For a file room is made
    before anything of it is lost.
    """
    if not stat.S_ISREG(os.stat(path).st_mode):
        with open(ready, "rb") as source, open(path, "wb", buffering=0) as target:
            shutil.copyfileobj(source, target)
        os.remove(ready)
        return
    with open(ready, "rb") as source, open(path, "r+b") as target:
        size, before = os.fstat(source.fileno()).st_size, os.fstat(target.fileno()).st_size
        if hasattr(os, "posix_fallocate") and size > 0:
            try:
                os.posix_fallocate(target.fileno(), 0, size)
            except OSError:
                os.ftruncate(target.fileno(), before)
                raise
        shutil.copyfileobj(source, target)
        target.truncate(size)
    os.remove(ready)


def remove_if_there(path):
    """Removes a file of ours, unless it or its folder has gone."""
    with contextlib.suppress(FileNotFoundError, NotADirectoryError):
        os.remove(path)


def require_room(path, size):
    """Raises OSError where there is no room for a new file `path` of `size` bytes."""
    try:
        with open(path, "xb") as stream:
            if hasattr(os, "posix_fallocate"):
                os.posix_fallocate(stream.fileno(), 0, size)
    finally:
        remove_if_there(path)


def disk_is_full(path):
    """Whether there is no room for some more bytes in the folder of the path."""
    probe = unfinished(path, "")
    try:
        with open(probe, "wb", buffering=0) as stream:
            stream.write(bytes(65536))
            os.fsync(stream.fileno())
    except OSError as error:
        return is_full(error)
    finally:
        remove_if_there(probe)
    return False
