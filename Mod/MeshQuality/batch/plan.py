# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a batch is to do: the parts below a folder, the options, and where results go."""

import fnmatch
import hashlib
import json
import os
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from .. import cli
from ..cli_parser import INPUTS, OUTPUTS, TABLES
from ..errors import Error
from ..version import __version__

MESHES = "meshes"
_DEFAULT_FORMAT = {"triangulate": "ply", "improve": "ply", "curve": "msh"}


class Part(NamedTuple):
    """A file below the folder: its path there with slashes, bytes, and time of change in ns."""

    name: str
    size: int
    mtime_ns: int


@dataclass(frozen=True)
class Plan:
    """What is done to each part. `suffix` is the extension of the meshes, None without any; `deviation`
    is that of flat triangles of curved meshes.
    """

    folder: Path
    out: Path
    command: str
    options: dict
    suffix: str
    seconds: float
    gibibytes: float
    deviation: float = None

    @property
    def key(self):
        """A digest of all that results depend on beside the part: command, options, format, version."""
        said = json.dumps([self.command, self.options, self.suffix, self.deviation, __version__],
                          sort_keys=True)
        return hashlib.sha256(said.encode()).hexdigest()[:16]

    def output_of(self, name):
        """The mesh of a part, relative to `out`; None without one."""
        return f"{MESHES}/{name}{self.suffix}" if self.suffix else None

    def task(self, part):
        """All that a worker must know to do the part, as plain data."""
        output = self.output_of(part.name)
        return {
            "part": part.name, "path": str(self.folder / part.name), "size": part.size,
            "mtime_ns": part.mtime_ns, "key": self.key, "command": self.command,
            "options": self.options, "suffix": self.suffix, "deviation": self.deviation,
            "output": output,
            "output_path": str(self.out / output) if output else None,
            "seconds": self.seconds, "bytes": int(self.gibibytes * 2**30),
        }


def plan_of(arguments):
    """The Plan of the command line's arguments; raises Error."""
    command = arguments.batched
    folder, out = Path(arguments.folder).absolute(), Path(arguments.output).absolute()
    if not folder.is_dir():
        raise Error(f"there is no folder '{folder}'")
    if out.resolve() == folder.resolve():
        raise Error("the results need a folder of their own: name another one with -o")
    if out.exists() and not out.is_dir():
        raise Error(f"'{out}' is a file: the results need a folder")
    for flag, value in (("--time-limit", arguments.time_limit),
                        ("--memory-limit", arguments.memory_limit),
                        ("--jobs", 1 if arguments.jobs is None else arguments.jobs)):
        if not 0 < value < float("inf"):
            raise Error(f"{flag} {value:g} is not allowed: it must be greater than 0")
    job = {"options": cli.take_options(vars(arguments).copy(), TABLES[command]),
           "deviation": getattr(arguments, "deviation", None)}
    name = arguments.format or _DEFAULT_FORMAT.get(command)
    if arguments.format and not OUTPUTS[command]:
        raise Error(f"--format {name} is not for --command {command}, which writes no meshes")
    suffix = cli.require_format("--format", name, OUTPUTS[command]) if name else None
    if command == "curve":
        cli.require_curved_output(job, suffix)
    return Plan(folder, out, command, job["options"], suffix,
                arguments.time_limit, arguments.memory_limit, job["deviation"])


def find_parts(plan, patterns=None):
    """The Parts below the folder, the largest files first: those that take long must not come last.

    Hidden files and folders are left out. Raises Error where there are none.
    """
    known, found = INPUTS[plan.command], []
    for path, folders, names in os.walk(plan.folder):
        folders[:] = [name for name in folders
                      if not name.startswith(".") and Path(path, name) != plan.out]
        for name in names:
            if name.startswith(".") or not name.lower().endswith(known):
                continue
            full = os.path.join(path, name)
            relative = os.path.relpath(full, plan.folder).replace(os.sep, "/")
            if patterns and not any(fnmatch.fnmatch(relative, pattern) for pattern in patterns):
                continue
            found.append(_part(relative, full))
    if not found:
        raise Error(f"there is no file to work on in '{plan.folder}': it must hold "
                    f"{' '.join(known)}" + (" that match --only" if patterns else ""))
    return sorted(found, key=lambda part: (-part.size, part.name))


def _part(name, path):
    try:
        status = os.stat(path)
    except OSError:  # a link to nowhere: that it cannot be read is said of the part later
        return Part(name, 0, 0)
    return Part(name, status.st_size, status.st_mtime_ns)
