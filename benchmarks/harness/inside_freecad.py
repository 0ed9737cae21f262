# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lets a benchmark be started by any Python: its work is done by a headless FreeCAD.

A benchmark calls `start(__file__, parser, work)`, where the parser is of `command_line`. `work(arguments)` runs inside FreeCAD with
MeshQuality and tests/parts on the path; what it returns goes to --out as JSON, and its "status", if
there is one, becomes the exit status.
"""

import argparse
import json
import os
import platform
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
VARIABLE = "MESHQUALITY_BENCHMARK"
CAD_SUFFIXES = {".step", ".stp", ".iges", ".igs", ".brep", ".brp"}


def data_folder():
    """Where parts and meshes from files are: $MESHQUALITY_DATA, or ../shared/data beside the
    repository."""
    default = ROOT.parent / "shared" / "data"
    return Path(os.environ.get("MESHQUALITY_DATA", default)).resolve()


def system_environment():
    """Variables for other Pythons: without FreeCAD's own folders for modules."""
    return {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "PYTHONHOME", VARIABLE)}


def has_module(python, name):
    """Whether that Python has a module, as the peers of benchmarks need one."""
    return subprocess.run([python, "-c", f"import {name}"], capture_output=True, env=system_environment()).returncode == 0


def command_line(text):
    """A parser of the command line that shows this text as it stands."""
    return argparse.ArgumentParser(description=text,
                                   formatter_class=argparse.RawDescriptionHelpFormatter)


def start(script, parser, work):
    """Parses the command line and goes on in FreeCAD; inside it, does the work and ends."""
    inside = VARIABLE in os.environ
    if not inside:
        name = Path(script).stem
        parser.add_argument("--out", type=Path, default=ROOT / "out" / f"{name}.json",
                            help="JSON file to write")
        arguments = vars(parser.parse_args())
        arguments["out"] = str(arguments["out"].resolve())
        sys.exit(_run(script, arguments))
    status = 1
    try:
        arguments = argparse.Namespace(**json.loads(os.environ[VARIABLE]))
        results = work(arguments)
        _write(Path(arguments.out), {"machine": machine(), **results})
        status = results.get("status", 0)
    except Exception:
        import traceback

        traceback.print_exc()
    # FreeCAD would go on to its prompt.
    sys.exit(status)


def _run(script, arguments):
    program = os.environ.get("MESHQUALITY_FREECADCMD") or shutil.which("freecadcmd") \
        or shutil.which("FreeCADCmd")
    if not program:
        return "freecadcmd is not found: put it on PATH or name it in MESHQUALITY_FREECADCMD"
    environment = {**os.environ, VARIABLE: json.dumps(arguments), "PYTHONPATH": str(ROOT / "tests")}
    folders = (ROOT / "Mod", ROOT / "tests", ROOT / "benchmarks", *filter(Path.is_dir, (ROOT / "benchmarks").iterdir()))
    command = [program, *(word for folder in folders for word in ("-P", str(folder))), str(Path(script).resolve())]
    return subprocess.run(command, stdin=subprocess.DEVNULL, env=environment).returncode


def _write(path, results):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(results, indent=1), encoding="utf-8")
    print(f"written: {path}", flush=True)


def machine():
    """What the figures depend on."""
    import FreeCAD
    import Part

    return {"processor": _processor(), "cores": os.cpu_count(), "system": platform.platform(),
            "freecad": ".".join(FreeCAD.Version()[:3]), "opencascade": Part.OCC_VERSION}


def _processor():
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        return platform.processor()
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor()
