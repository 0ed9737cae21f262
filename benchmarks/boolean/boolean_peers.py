# SPDX-License-Identifier: LGPL-2.1-or-later
"""Other systems' Booleans, run as programs of their own beside MeshQuality.

A peer is a program `PEER union|intersection|difference A.off B.off OUT.off` that prints a line with
`RESULT status=ok cpu=SECONDS`: the processor's seconds of the operation, conversions included,
files not.
"""

import re
import resource
import signal
import subprocess
from pathlib import Path

LIMIT = 120  # seconds of the processor, and a tenth of those on the clock


def write_off(path, vertices, triangles, digits=9):
    """Writes an OFF file; nine digits bring every single-precision number back, 17 every double."""
    with open(path, "w", encoding="ascii") as stream:
        stream.write(f"OFF\n{len(vertices)} {len(triangles)} 0\n")
        stream.writelines(f"%.{digits}g %.{digits}g %.{digits}g\n" % tuple(v) for v in vertices.tolist())
        stream.writelines("3 %d %d %d\n" % tuple(t) for t in triangles.tolist())


def read_off(path):
    """(V, F) of an OFF file of triangles."""
    import numpy as np

    words = Path(path).read_text(encoding="ascii").split()
    count = int(words[1])
    vertices = np.array(words[4:4 + 3 * count], dtype=float).reshape(-1, 3)
    corners = np.array(words[4 + 3 * count:], dtype=np.int64).reshape(-1, 4)
    return vertices, corners[:, 1:4].astype(np.int32)


class Peer:
    """One program; its files lie in a scratch folder."""

    def __init__(self, program, folder):
        self.program = Path(program).resolve()
        self.name = re.sub(r"^drv_", "", self.program.stem)
        self.folder = Path(folder)

    def operand(self, name, mesh):
        path = self.folder / f"{name}.off"
        if not path.exists():
            write_off(path, *mesh)
        return str(path)

    def run(self, operation, operands):
        """(seconds, (V, F)), or (None, what went wrong)."""
        out = self.folder / f"{self.name}.off"
        out.unlink(missing_ok=True)
        command = [str(self.program), operation, *operands, str(out)]
        try:
            done = subprocess.run(
                command, capture_output=True, text=True, timeout=10 * LIMIT,
                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (LIMIT, LIMIT + 1)))
        except subprocess.TimeoutExpired:
            return None, f"no answer in {10 * LIMIT} s on the clock"
        if done.returncode == -signal.SIGXCPU:
            return None, f"no answer in {LIMIT} s"
        found = re.search(r"RESULT status=(\S+).* cpu=(\S+)", done.stdout)
        if found is None:
            return None, f"ended with {done.returncode}"
        if found[1] != "ok" or not out.exists():
            return None, found[1]
        return float(found[2]), read_off(out)
