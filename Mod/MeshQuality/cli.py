# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line, seen from outside FreeCAD: arguments, help, and the start of FreeCAD.

Imports nothing of FreeCAD. The job travels in a file, because FreeCAD's own option parser takes
what is on its command line, and the result comes back in one, because FreeCAD prints to stdout.
"""

import argparse
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile

from . import options
from .errors import Error

DONE, FAILED, USAGE = 0, 1, 2
CAD_SUFFIXES = (".step", ".stp", ".iges", ".igs", ".brep", ".brp", ".fcstd")
MESH_SUFFIXES = (".stl", ".ply", ".obj", ".off", ".bms", ".ast")
CURVED_SUFFIXES = (".msh", ".vtu")
OUTPUT_SUFFIXES = (".stl", ".ply", ".obj", ".off", ".msh", ".vtu")


def _add_options(parser, table):
    for option in table:
        if option.kind is bool:
            # --no-... exists for what is on unless it is switched off.
            action = argparse.BooleanOptionalAction if option.default else "store_true"
            parser.add_argument(option.flag, action=action, default=option.default,
                                help=option.help)
            continue
        default = "" if option.default is None else f" (default: {option.default})"
        text = f"{option.help}; {option.range_text}{default}"
        kind = str if option.is_sizes else option.kind
        parser.add_argument(option.flag, type=kind, metavar=_metavar(option),
                            default=option.default, help=text.replace("%", "%%"))


def _metavar(option):
    if option.unit:
        return option.unit.upper()
    if option.is_sizes:
        return "SIZES"
    return "NAME" if option.choices else {int: "N", float: "FRACTION"}[option.kind]


def parser():
    """The argument parser of bin/meshquality."""
    top = argparse.ArgumentParser(
        prog="meshquality", description="Quality meshes of CAD parts, by FreeCAD's shapes.",
        epilog="Exit status: 0 done, 1 failed, 2 bad usage or input; stderr's last line says why.")
    commands = top.add_subparsers(dest="command", required=True, metavar="COMMAND")
    common = argparse.ArgumentParser(add_help=False)
    common.add_argument("--json", action="store_true",
                        help="print the report as one JSON object on stdout")
    common.add_argument("--object", metavar="NAME",
                        help="of an FCStd file mesh the object of this name or label only")

    for name, title, text, outputs, table in (
            ("triangulate", "mesh a CAD part",
             "Triangulates a CAD part with a guaranteed smallest angle.",
             OUTPUT_SUFFIXES, options.TRIANGULATE),
            ("curve", "make a mesh of curved elements of a CAD part",
             "Meshes a CAD part with curved triangles or tetrahedra, each proven valid.",
             CURVED_SUFFIXES, options.CURVE)):
        one = commands.add_parser(name, parents=[common], help=title, description=text)
        one.add_argument("input", help="CAD file: " + " ".join(CAD_SUFFIXES))
        one.add_argument("-o", "--output", help="mesh file: " + " ".join(outputs))
        _add_options(one, table)

    one = commands.add_parser(
        "boolean", parents=[common], help="join, intersect or subtract closed meshes and shapes",
        description="A Boolean of two or more meshes or CAD parts; the operation is applied from "
                    "the first on. The result is closed and free of self-intersections.")
    one.add_argument("inputs", nargs="+", metavar="input",
                     help="mesh or CAD file: " + " ".join(MESH_SUFFIXES + CAD_SUFFIXES))
    one.add_argument("-o", "--output", help="mesh file: " + " ".join(OUTPUT_SUFFIXES))
    _add_options(one, options.BOOLEAN)

    one = commands.add_parser(
        "improve", parents=[common], help="give a mesh better triangles",
        description="Improves the triangles of a mesh on its own surface; sharp edges stay.")
    one.add_argument("input", help="mesh file: " + " ".join(MESH_SUFFIXES))
    one.add_argument("-o", "--output", help="mesh file: " + " ".join(OUTPUT_SUFFIXES))
    _add_options(one, options.IMPROVE)

    one = commands.add_parser(
        "quality", parents=[common], help="report on a mesh",
        description="Measures a mesh: topology, angles, and its distance to a shape if given.")
    one.add_argument("input", help="mesh file: " + " ".join(MESH_SUFFIXES))
    one.add_argument("--shape", metavar="CAD", help="CAD file to measure the distance to")
    return top


def _job(arguments):
    """What FreeCAD is to do; raises Error for what can be seen without starting it."""
    job = vars(arguments).copy()
    known = {"quality": MESH_SUFFIXES, "improve": MESH_SUFFIXES,
             "boolean": MESH_SUFFIXES + CAD_SUFFIXES}
    suffixes = known.get(job["command"], CAD_SUFFIXES)
    for name in ("input", "shape", "output"):
        if job.get(name):
            job[name] = os.path.abspath(job[name])
    if "inputs" in job:
        job["inputs"] = [os.path.abspath(path) for path in job["inputs"]]
    for path in job.get("inputs", [job.get("input")]):
        _require_file(path, suffixes)
    _require_file(job.get("shape"), CAD_SUFFIXES)
    if len(job.get("inputs", ())) == 1:
        raise Error("a Boolean needs two inputs or more")
    curved = job["command"] == "curve"
    _require_suffix(job.get("output"), CURVED_SUFFIXES if curved else OUTPUT_SUFFIXES)
    if job.get("output") and not os.path.isdir(os.path.dirname(job["output"])):
        raise Error(f"there is no folder '{os.path.dirname(job['output'])}' to write to")
    table = {"triangulate": options.TRIANGULATE, "curve": options.CURVE,
             "boolean": options.BOOLEAN, "improve": options.IMPROVE}.get(job["command"])
    if table:
        names = [option.name for option in table]
        job["options"] = options.check(table, {n: job.pop(n) for n in names})
    return job


def _require_file(path, suffixes):
    if path and not os.path.isfile(path):
        raise Error(f"there is no file '{path}'")
    _require_suffix(path, suffixes)


def _require_suffix(path, suffixes):
    if path and os.path.splitext(path)[1].lower() not in suffixes:
        raise Error(f"'{path}' has no known extension: it must be one of {' '.join(suffixes)}")


def _freecad():
    """FreeCAD's console program; MESHQUALITY_FREECADCMD overrides."""
    chosen = os.environ.get("MESHQUALITY_FREECADCMD")
    for name in [chosen] if chosen else ["freecadcmd", "FreeCADCmd", "freecad.cmd"]:
        path = shutil.which(name)
        if path:
            return path
    raise OSError("FreeCAD's console program freecadcmd is not found: put it on PATH, or name "
                  "it in MESHQUALITY_FREECADCMD")


def _run_in_freecad(job):
    """The result {"status", "text", "report"} of the job, from a FreeCAD of its own."""
    package = os.path.dirname(os.path.abspath(__file__))
    with tempfile.TemporaryDirectory(prefix="meshquality-") as folder:
        job_path = os.path.join(folder, "job.json")
        result_path = os.path.join(folder, "result.json")
        with open(job_path, "w", encoding="utf-8") as stream:
            json.dump({**job, "result": result_path}, stream)
        code = _wait_for(subprocess.Popen(
            [_freecad(), "-P", os.path.dirname(package), os.path.join(package, "cli_worker.py")],
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            env={**os.environ, "MESHQUALITY_JOB": job_path}))
        try:
            with open(result_path, encoding="utf-8") as stream:
                return json.load(stream)
        except (OSError, ValueError):
            how = f"was ended by signal {-code}" if code < 0 else f"ended with status {code}"
            return {"status": FAILED, "text": f"FreeCAD {how} and left no result"}


def _wait_for(process):
    """The exit code of the process, which does not outlive this one when that is told to end."""
    def end(*_):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGTERM, end)
    try:
        return process.wait()
    finally:
        if process.poll() is None:
            process.kill()
            process.wait()
        signal.signal(signal.SIGTERM, before)


def main(arguments=None):
    """Runs the command line; returns the exit status."""
    parsed = parser().parse_args(arguments)
    try:
        result = _run_in_freecad(_job(parsed))
    except Error as error:
        result = {"status": USAGE, "text": str(error)}
    except OSError as error:
        result = {"status": FAILED, "text": str(error)}
    except KeyboardInterrupt:
        result = {"status": FAILED, "text": "interrupted"}
    report = result.get("report", {})
    if parsed.json:
        failure = {} if result["status"] == DONE else {"error": result["text"]}
        print(json.dumps({**report, **failure}))
    elif result["status"] == DONE:
        print(result["report_text"], end="")
    print(f"meshquality: {result['text']}", file=sys.stderr)
    return result["status"]
