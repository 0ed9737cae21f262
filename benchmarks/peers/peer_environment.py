# SPDX-License-Identifier: LGPL-2.1-or-later
"""The rivals of peers.py: packages in a scratch environment of Python, kept from run to run, and CGAL from its headers."""

import json
import re
import subprocess
from pathlib import Path

from inside_freecad import system_environment

# The newest of November 2026. The first name is that of the module.
PACKAGES = (("numpy", "numpy", "2.4.6"), ("gmsh", "gmsh", "4.15.2"), ("netgen", "netgen-mesher", "6.2.2608"),
            ("manifold3d", "manifold3d", "3.5.4"), ("meshlib", "meshlib", "3.1.4.297"),
            ("pymeshlab", "pymeshlab", "2025.7.post1"), ("tetgen", "tetgen", "0.8.4"), ("mmgpy", "mmgpy", "0.17.1"),
            ("pyvista", "pyvista", "0.49.1"),  # pytetwild imports it
            ("pytetwild", "pytetwild", "0.4.2"), ("delmesher", "delmesher", "1.0.1"),
            ("trueform", "trueform", "0.10.7"))  # not free for commercial use: here for comparison only
NAMES = {"Manifold": "manifold3d", "fTetWild": "pytetwild", "Mmg": "mmgpy", "CGAL": "CGAL"}  # of rivals whose module is called otherwise
SECONDS = 900.0  # on the clock, of an installation or a compilation


class Environment:
    """A folder with a Python that has the rivals: `versions` of those that are there, `missing` with reasons."""

    def __init__(self, folder, python, packages=PACKAGES):
        self.folder = Path(folder)
        self.python = self.folder / "venv" / "bin" / "python"
        self.versions, self.missing, self.programs = {}, {}, {}
        if not self.python.exists():
            self.folder.mkdir(parents=True, exist_ok=True)
            _said([python, "-m", "venv", str(self.folder / "venv")])
        for module, package, version in packages:
            self._install(module, package, version)

    def _install(self, module, package, version):
        """Tried once a version: what came of it is kept in the folder."""
        record = self.folder / f"{package}.json"
        if not record.exists() or json.loads(record.read_text(encoding="utf-8"))["version"] != version:
            print(f"installing {package} {version}", flush=True)
            reason = _said([str(self.python), "-m", "pip", "install", "--quiet", f"{package}=={version}"])
            reason = reason or _said([str(self.python), "-c", f"import {module}"])
            record.write_text(json.dumps({"version": version, "reason": reason and without_places(reason)}), encoding="utf-8")
        found = json.loads(record.read_text(encoding="utf-8"))
        kept, value = (self.missing, found["reason"]) if found["reason"] else (self.versions, version)
        kept[module] = value

    def compile(self, source, *libraries):
        """Adds the program of a C++ source that needs CGAL, or the reason why there is none."""
        program = self.folder / source.stem
        if not program.exists() or program.stat().st_mtime < source.stat().st_mtime:
            print(f"compiling {source.name}", flush=True)
            reason = _said(["c++", "-std=c++17", "-O3", "-DNDEBUG", "-DCGAL_NDEBUG", str(source), "-o", str(program), *libraries])
            if reason:
                self.missing["CGAL"] = without_places(reason)
                return
        self.programs[source.stem] = program
        self.versions["CGAL"] = subprocess.run([str(program)], capture_output=True, text=True, check=False).stdout.strip()


def package_of(mesher):
    """The module of a rival, as `versions` and `missing` name it; None of who is not of this environment."""
    module = NAMES.get(mesher, mesher.partition(" ")[0].lower())
    return module if module in (*NAMES.values(), *(name for name, _, _ in PACKAGES)) else None


def _said(command):
    """The last line that a command which failed said; None where it did not fail."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, env=system_environment(),
                              stdin=subprocess.DEVNULL, check=False)
    except (OSError, subprocess.TimeoutExpired) as error:
        return str(error)
    errors = [line for line in done.stderr.splitlines() if "error" in line.lower()] or [f"ended with {done.returncode}"]
    return errors[0] if done.returncode else None


def without_places(reason):
    """A message without the folders and addresses of the machine, short."""
    return re.sub(r"\S*/\S+", "...", reason).strip()[:120]
