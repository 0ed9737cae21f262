# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a batch is to do: the parts below a folder, the options, and where results go."""

import fnmatch
import hashlib
import json
import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from ..cli.job_checks import require_curved_output, require_format, take_options, take_writing
from ..cli.parser import INPUTS, OUTPUTS, TABLES, WITH_PATCHES
from ..errors import Error
from ..files import kind_of
from ..version import __version__

MESHES, PAGES = "meshes", "reports"
_LONGEST_NAME = 255  # bytes, of most file systems
_DEFAULT_FORMAT = {"triangulate": "ply", "improve": "ply", "curve": "msh"}


class Part(NamedTuple):
    """A file below the folder: its path there with slashes, bytes, and time of change in ns."""

    name: str
    size: int
    mtime_ns: int


@dataclass(frozen=True)
class Plan:
    """The operation on each part. `suffix` is the extension of the meshes, None without any;
    `deviation` is that of flat triangles of curved meshes, `writing` what is said of the files besides.
    """

    folder: Path
    out: Path
    command: str
    options: dict
    suffix: str
    seconds: float
    gibibytes: float
    deviation: float = None
    writing: dict = field(default_factory=dict)
    pages: bool = False

    @property
    def key(self):
        """A digest of all that results depend on beside the part: command, options, format, version."""
        more = [*([self.writing] if self.writing else []), *(["pages"] if self.pages else [])]  # so that results of before have their key still
        said = json.dumps([self.command, self.options, self.suffix, self.deviation, __version__, *more],
                          sort_keys=True)
        return hashlib.sha256(said.encode()).hexdigest()[:16]

    def output_of(self, name):
        """The mesh of a part, relative to `out`; None without one. Names that are too long are cut."""
        return f"{MESHES}/{self._file_of(name, self.suffix)}" if self.suffix else None

    def page_of(self, name):
        """Likewise the page with pictures of a part."""
        return f"{PAGES}/{self._file_of(name, '.html')}" if self.pages else None

    @staticmethod
    def _file_of(name, suffix):
        folder, slash, leaf = name.rpartition("/")
        if len(os.fsencode(leaf + suffix)) > _LONGEST_NAME:
            digest = hashlib.sha256(os.fsencode(leaf)).hexdigest()[:16]
            leaf = os.fsencode(leaf)[:_LONGEST_NAME - 30].decode(errors="ignore") + "~" + digest
        return f"{folder}{slash}{leaf}{suffix}"

    def task(self, part):
        """All that a worker must know to do the part, as plain data."""
        output, page = self.output_of(part.name), self.page_of(part.name)
        return {
            "part": part.name, "path": str(self.folder / part.name), "size": part.size,
            "mtime_ns": part.mtime_ns, "key": self.key, "command": self.command,
            "options": self.options, "suffix": self.suffix, "deviation": self.deviation,
            "writing": self.writing, "output": output,
            "output_path": str(self.out / output) if output else None,
            "page": page, "page_path": str(self.out / page) if page else None,
            "seconds": self.seconds, "bytes": int(self.gibibytes * 2**30),
        }


def plan_of(arguments):
    """The Plan of the command line's arguments; raises Error."""
    command = arguments.batched
    folder, out = Path(arguments.folder).absolute(), Path(arguments.output).absolute()
    if not folder.is_dir():
        raise Error(f"there is no folder '{folder}'")
    # Not resolve(), which raises another error where a link leads to itself.
    whole, meshes = Path(os.path.realpath(folder)), Path(os.path.realpath(out / MESHES))
    if Path(os.path.realpath(out)) == whole or meshes in (whole, *whole.parents):
        raise Error("the results need a folder of their own: name another one with -o")
    if out.exists() and not out.is_dir():
        raise Error(f"'{out}' is a file: the results need a folder")
    for flag, value in (("--time-limit", arguments.time_limit),
                        ("--memory-limit", arguments.memory_limit),
                        ("--jobs", 1 if arguments.jobs is None else arguments.jobs)):
        if not 0 < value < float("inf"):
            raise Error(f"{flag} {value:g} is not allowed: it must be greater than 0")
    job = {"options": take_options(vars(arguments).copy(), TABLES[command]),
           "deviation": getattr(arguments, "deviation", None)}
    name = arguments.format or _DEFAULT_FORMAT.get(command)
    if arguments.format and not OUTPUTS[command]:
        raise Error(f"--format {name} is not for --command {command}, which writes no meshes")
    suffix = require_format("--format", name, OUTPUTS[command]) if name else None
    if command == "curve":
        require_curved_output(job, suffix)
    writing = take_writing(vars(arguments).copy(), suffix) if command in WITH_PATCHES else {}
    return Plan(folder, out, command, job["options"], suffix,
                arguments.time_limit, arguments.memory_limit, job["deviation"], writing, arguments.reports)


def matches(name, patterns):
    """Whether the name of a part is one that --only chose."""
    return not patterns or any(fnmatch.fnmatch(name, pattern) for pattern in patterns)


def find_parts(plan, patterns=None):
    """The Parts below the folder, the largest files first: those that take long must not come last.

    Hidden files and folders are left out, and so is the folder of the results by whatever path it is
    named. Folders named like a part are one where there is no part in them: their line says why it was
    not done. Raises Error where there are none.
    """
    known, found, named = INPUTS[plan.command], [], []
    results = [status for status in map(_status, (plan.out, plan.out / MESHES, plan.out / PAGES)) if status]
    for path, folders, names in os.walk(plan.folder):
        folders[:] = [name for name in folders if not name.startswith(".")
                      and not any(_is_same(os.path.join(path, name), result) for result in results)]
        for name in names + folders:
            if name.startswith(".") or not name.lower().endswith(known):
                continue
            full = os.path.join(path, name)
            relative = os.path.relpath(full, plan.folder).replace(os.sep, "/")
            if matches(relative, patterns):
                (named if name in folders else found).append(_part(relative, full))
    found += [folder for folder in named
              if not any(part.name.startswith(folder.name + "/") for part in found)]
    if not found:
        raise Error(f"there is no file to work on in '{plan.folder}': it must hold "
                    f"{' '.join(known)}" + (" that match --only" if patterns else ""))
    return sorted(found, key=lambda part: (-part.size, part.name))


def _status(path):
    try:
        return os.stat(path)
    except OSError:
        return None


def _is_same(path, status):
    found = _status(path)
    return found is not None and os.path.samestat(found, status)


def _part(name, path):
    status = _status(path)
    # That a link to nowhere, a pipe or a device cannot be read is said later, in its line.
    if status is None or kind_of(status.st_mode):
        return Part(name, 0, 0)
    return Part(name, status.st_size, status.st_mtime_ns)
