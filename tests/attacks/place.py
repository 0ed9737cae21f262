# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the command line is attacked: folders with parts, what a command may use there, and what it must leave."""

import contextlib
import functools
import hashlib
import os
import shutil
import signal
import struct
import subprocess
import tempfile
import time
import uuid
from pathlib import Path

from attack import check

ROOT = Path(__file__).resolve().parent.parent.parent
COMMAND = str(ROOT / "bin" / "meshquality")
LIMIT = 25.0  # seconds for one command
STATUSES = (0, 1, 2, 3)
GONE = 3.0  # seconds within which what a command started has ended
MIB = 2**20
ENDLESS = ("--chord-height", "5e-6", "--max-triangles", "2000000000")
CUBE = ((0, 2, 1), (0, 3, 2), (4, 5, 6), (4, 6, 7), (0, 1, 5), (0, 5, 4), (1, 2, 6), (1, 6, 5), (2, 3, 7), (2, 7, 6),
        (3, 0, 4), (3, 4, 7))
CORNERS = ((0, 0, 0), (9, 0, 0), (9, 9, 0), (0, 9, 0), (0, 0, 9), (9, 0, 9), (9, 9, 9), (0, 9, 9))


def stl_of_cube():
    data = bytes(80) + struct.pack("<I", len(CUBE))
    for triangle in CUBE:
        data += struct.pack("<12fH", 0, 0, 0, *(x for v in triangle for x in CORNERS[v]), 0)
    return data


@functools.lru_cache(maxsize=1)
def parts():
    """The folder of the parts, made once by FreeCAD."""
    folder = Path(tempfile.mkdtemp(prefix="attacked-parts-"))
    script = folder / "make.py"
    script.write_text("import FreeCAD, Part, os\n"
                      f"os.chdir({str(folder)!r})\n"
                      "Part.makeBox(1, 2, 3).exportBrep('box.brep')\n"
                      "Part.makeBox(1, 2, 3).exportStep('box.step')\n"
                      "Part.makeSphere(5).exportBrep('ball.brep')\n"
                      "document = FreeCAD.newDocument('box')\n"
                      "document.addObject('Part::Box', 'Box')\n"
                      "document.recompute()\n"
                      "document.saveAs('box.FCStd')\n"
                      "os._exit(0)\n", encoding="utf-8")
    subprocess.run([os.environ.get("MESHQUALITY_FREECADCMD", "freecadcmd"), str(script)], stdin=subprocess.DEVNULL,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=60, check=False)
    script.unlink()
    (folder / "cube.stl").write_bytes(stl_of_cube())
    check((folder / "box.FCStd").exists(), "FreeCAD made no parts")
    return folder


def digests(folder):
    """{name: digest} of the regular files of a folder."""
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in Path(folder).iterdir()
            if path.is_file() and not path.is_symlink()}


def processes_with(mark):
    """Ids of processes that have the mark in their environment and have not ended."""
    found = []
    for entry in filter(str.isdigit, os.listdir("/proc")):
        with contextlib.suppress(OSError):
            environment = Path("/proc", entry, "environ").read_bytes()
            if mark.encode() in environment and ") Z" not in Path("/proc", entry, "stat").read_text("utf-8", "replace"):
                found.append(int(entry))
    return found


class Place:
    """A folder with copies of the parts, one for temporary files, and what a command may use and must leave."""

    def __init__(self):
        self.mark = uuid.uuid4().hex

    def __enter__(self):
        self.folder = Path(tempfile.mkdtemp(prefix="attacked-"))
        self.temporary = self.folder / "temporary"
        shutil.copytree(parts(), self.folder / "work")
        self.work = self.folder / "work"
        self.temporary.mkdir()
        self.before = digests(self.work)
        return self

    def __exit__(self, *_):
        for pid in processes_with(self.mark):
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        for path, _, _ in os.walk(self.folder):
            with contextlib.suppress(OSError):
                os.chmod(path, 0o700)
        shutil.rmtree(self.folder, ignore_errors=True)

    def environment(self, changes=()):
        """That of this process with changes; None takes a variable away."""
        # The Python that has Dask: batch would start it itself, and signals would end the command meanwhile.
        path = f"/usr/bin:{os.environ.get('PATH', '')}"
        found = {**os.environ, "PATH": path, "TMPDIR": str(self.temporary), "MESHQUALITY_ATTACK": self.mark,
                 **dict(changes)}
        return {name: value for name, value in found.items() if value is not None}

    def start(self, *arguments, environment=(), **options):
        options = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options}
        return subprocess.Popen([COMMAND, *map(os.fspath, map(str_or_bytes, arguments))], cwd=self.work,
                                env=self.environment(environment), **options)

    def run(self, *arguments, **options):
        """(status, stdout, stderr) of a command that has ended as one should."""
        given = options.pop("given", None)
        process = self.start(*arguments, **options)
        try:
            out, err = process.communicate(given, timeout=LIMIT)
        finally:
            process.kill()
            process.wait()
        return self.ended(process.returncode, (out or b"").decode(errors="replace"),
                          (err or b"").decode(errors="replace"))

    def _temporary_files(self):
        return [name for name in os.listdir(self.temporary) if not name.startswith("FreeCAD")]

    def ended(self, status, out, err, statuses=STATUSES):
        """The same, looked at: status, words, processes, files."""
        check(status in statuses, f"status {status}: {err[-600:]}")
        check("Traceback" not in err and "Traceback" not in out, f"a traceback: {err[-900:]}")
        if err and status in (1, 2) and status in statuses:
            check("meshquality" in err.splitlines()[-1], f"the last line does not say why: {err[-300:]}")
        end = time.monotonic() + GONE
        while processes_with(self.mark) and time.monotonic() < end:
            time.sleep(0.02)
        check(not processes_with(self.mark), "a process is left")
        if any(name.endswith(".owner") for name in self._temporary_files()):
            # What a killed worker had goes with the next command, whatever comes of that.
            self.start("quality", "none.stl").communicate(timeout=LIMIT)
        left = self._temporary_files()
        check(not left, f"left in the folder for temporary files: {left}")
        left = [path.name for path in self.work.rglob(".meshquality*")]
        check(not left, f"left beside the output: {left}")
        after = digests(self.work)
        lost = [name for name,
                digest in self.before.items() if after.get(name) != digest and name not in self.may_change]
        check(not lost, f"inputs lost or changed: {lost}")
        return status, out, err

    may_change = ()


def str_or_bytes(value):
    return value if isinstance(value, bytes) else str(value)


def good_mesh(path, triangles=None):
    """Whether a binary STL file is whole."""
    data = Path(path).read_bytes()
    check(len(data) >= 84, f"{len(data)} bytes are no mesh")
    count, = struct.unpack_from("<I", data, 80)
    check(len(data) == 84 + 50 * count and (triangles is None or count == triangles), f"a torn mesh: {len(data)} bytes")


def wait_until_it_takes_signals(process):
    """Python takes SIGINT itself from its start on: the one to look for is SIGTERM."""
    end = time.monotonic() + LIMIT
    while time.monotonic() < end and process.poll() is None:
        with contextlib.suppress(OSError):
            status = Path("/proc", str(process.pid), "status").read_text(encoding="ascii")
            caught, = [int(line.split()[1], 16) for line in status.splitlines() if line.startswith("SigCgt")]
            if caught >> (signal.SIGTERM - 1) & 1:
                return
        time.sleep(0.005)
    raise AssertionError("the command never takes signals")
