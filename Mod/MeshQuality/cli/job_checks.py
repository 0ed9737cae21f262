# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks of arguments: what can be seen of a job without starting FreeCAD. Each raises Error."""

import json
import os

from .. import files, formats, options
from ..errors import Error
from .parser import CAD_SUFFIXES, ELEMENT_SUFFIXES, FOLDERS, INPUTS, MESH_SUFFIXES, OUTPUTS, TABLES, WITH_PATCHES

STANDARD = "-"


def job_of(arguments):
    """What FreeCAD is to do; raises Error for what can be seen without starting it.

    A dict of the arguments: files by absolute path, of standard input and output by "-" yet;
    "options" has those of the operation, checked.
    """
    job = vars(arguments).copy()
    command = job["command"]
    for name in ("input", "shape", "mesh", "reference", "save", "csv", "page", "output"):
        if job.get(name):
            job[name] = _absolute(job[name])
    job["inputs"] = [_absolute(path) for path in job.get("inputs") or [job["input"]]]
    for path in job["inputs"]:
        require_input(path, INPUTS[command], job["input_format"])
    require_input(job.get("shape"), CAD_SUFFIXES, job["input_format"])
    require_input(job.get("mesh"), ELEMENT_SUFFIXES, job["input_format"])
    require_input(job.get("reference"), CAD_SUFFIXES + MESH_SUFFIXES, job["input_format"])
    if (job.get("far_field") or "").lower().endswith(CAD_SUFFIXES):
        job["far_field"] = _absolute(job["far_field"])
        require_input(job["far_field"], CAD_SUFFIXES)
    if (job["inputs"] + [job.get("shape"), job.get("mesh"), job.get("reference")]).count(STANDARD) > 1:
        raise Error("standard input, -, can be read once only: name a file for the others")
    if len(job["inputs"]) == 1 and command == "boolean":
        raise Error("a Boolean needs two inputs or more")
    if "mesh_scale" in job:
        _check_mesh_scale(job)
    if job.get("save"):
        _require_savable(job)
    for flag, path in (("--csv", job.get("csv")), ("--report", job.get("page"))):
        if path:
            _require_folder(flag, path)
    if job.get("page") and not job["page"].lower().endswith((".html", ".htm", ".pdf")):
        raise Error(f"'{job['page']}' has no known extension: a report is .html or .pdf")
    if command == "verify" and job["input"] == STANDARD and not job["mesh"]:
        raise Error("a certificate from standard input is in no folder: name the mesh with --mesh")
    job["options"] = take_options(job, TABLES[command])
    job["suffix"] = suffix_of_output(job)
    if command in WITH_PATCHES:
        job["writing"] = take_writing(job, job["suffix"])
    for flag, value in (("--time-limit", job["time_limit"]), ("--memory-limit", job["memory_limit"])):
        if value is not None and not 0 < value < float("inf"):
            raise Error(f"{flag} {value:g} is not allowed: it must be greater than 0")
    if job.get("output") == STANDARD and job["json"]:
        raise Error("--json and the mesh cannot both go to standard output: name a file with -o")
    return job


def _check_mesh_scale(job):
    if not 0.0 < job["mesh_scale"] < float("inf"):
        raise Error(f"--mesh-scale {job['mesh_scale']:g} is not allowed: it must be greater than 0")
    if job["mesh_scale"] != 1.0 and job["command"] == "curve" and not job["mesh"]:
        raise Error("--mesh-scale is for a mesh that is given: name it with --mesh; --scale is for the file that is written")


def _require_savable(job):
    """Raises Error where the certificate of the job's mesh cannot be saved to its path."""
    path = job["save"]
    if STANDARD in (path, job["input"], job.get("shape")):
        raise Error("--save is for a certificate in a file, of a mesh and a shape in files: it names them with their SHA-256")
    if os.path.splitext(path)[1].lower() != ".json":
        raise Error(f"'{path}' has no known extension: a certificate is .json")
    if os.path.isdir(path) or not os.path.isdir(os.path.dirname(path)):
        raise Error(f"'{path}' cannot be written: give the name of a file in a folder that is there")


def _require_folder(flag, path):
    """Raises Error where a table or a page cannot be written there."""
    if path == STANDARD or os.path.isdir(path) or not os.path.isdir(os.path.dirname(path)):
        raise Error(f"{flag} {path} cannot be written: give the name of a file in a folder that is there")


def _absolute(path):
    return path if path == STANDARD else os.path.abspath(path)


def take_options(job, table):
    """The options of a table, checked, as a dict; they are taken out of the job."""
    return options.check(table, {option.name: job.pop(option.name) for option in table})


def require_input(path, suffixes, input_format=None):
    """Raises Error where a file is not there or has no extension that says what it is."""
    if path == STANDARD:
        if input_format is None:
            raise Error("--input-format must say what standard input is: one of "
                        + " ".join(suffix[1:] for suffix in suffixes))
        require_format("--input-format", input_format, suffixes)
    elif path:
        _require_file(path)
        _require_suffix(path, suffixes)


def _require_file(path):
    try:
        kind = files.kind_of(os.stat(path).st_mode)
    except (OSError, ValueError):
        raise Error(f"there is no file '{path}'") from None
    if kind:
        raise Error(f"'{path}' is {kind}, not a file")


def require_format(flag, name, suffixes):
    """The extension of a format; raises Error for one that is not known here."""
    suffix = formats.known_suffix("." + name, suffixes)
    if suffix is None:
        raise Error(f"{flag} {name} is not known here: it must be one of "
                    + " ".join(known[1:] for known in suffixes))
    return suffix


def _require_suffix(path, suffixes):
    suffix = formats.known_suffix(os.path.splitext(path)[1], suffixes)
    if suffix is None:
        raise Error(f"'{path}' has no known extension: it must be one of {' '.join(suffixes)}")
    return suffix


def suffix_of_output(job):
    """The extension that says how the mesh is written, "" for a folder, None without output; raises Error."""
    path, name, known = job.get("output"), job.get("format"), OUTPUTS[job["command"]]
    if not path:
        if name:
            raise Error(f"--format {name} needs a file to write to: give one with -o")
        if job.get("deviation"):
            raise Error("--deviation is for flat triangles in a file: give one with -o")
        return None
    if name:
        suffix = require_format("--format", name, known)
    elif job["command"] in FOLDERS and path != STANDARD and not os.path.splitext(path)[1]:
        return _folder(path)
    elif path == STANDARD:
        raise Error("--format must say how the mesh goes to standard output: one of "
                    + " ".join(suffix[1:] for suffix in known))
    else:
        suffix = _require_suffix(path, known)
    if path != STANDARD and os.path.isdir(path):
        raise Error(f"'{path}' is a folder: give the name of a file with -o")
    if path != STANDARD and not os.path.isdir(os.path.dirname(path)):
        raise Error(f"there is no folder '{os.path.dirname(path)}' to write to")
    if job["command"] == "curve":
        require_curved_output(job, suffix)
    return suffix


def _folder(path):
    """The extension of a folder, ""; raises Error where it cannot be one."""
    if os.path.exists(path) and not os.path.isdir(path):
        raise Error(f"'{path}' is a file without extension: name a folder, or a file with one, with -o")
    if not os.path.isdir(os.path.dirname(path)):
        raise Error(f"there is no folder '{os.path.dirname(path)}' to write to")
    return ""


def require_curved_output(job, suffix):
    """Raises Error where a curved mesh cannot be written so."""
    if suffix in formats.CURVED_SUFFIXES:
        formats.check_order(suffix, job["options"]["order"])
    if job.get("deviation") is not None:
        job["deviation"] = options.check(options.CURVED_DISPLAY,
                                         {"deviation": job["deviation"]})["deviation"]
        if suffix not in formats.FLAT_ONLY_SUFFIXES:
            raise Error(f"--deviation is for flat triangles, not for {suffix} files")


def take_writing(job, suffix):
    """What is said of the file, {patches, patch_rest, scale, ascii, interfaces} without what is as always; taken out of
    the job.
    """
    usual = {"patches": None, "patch_rest": None, "scale": 1.0, "ascii": False, "interfaces": False}
    given = {name: job.pop(name, value) for name, value in usual.items()}
    said = {name: value for name, value in given.items() if value != usual[name]}
    if said and suffix is None:
        flag = "--" + next(iter(said)).replace("_", "-")
        raise Error(f"{flag} is for the mesh in a file: give one with -o")
    if not 0.0 < given["scale"] < float("inf"):
        raise Error(f"--scale {given['scale']:g} is not allowed: it must be greater than 0")
    if given["interfaces"] and not job.get("options", {}).get("imprint"):
        raise Error("--interfaces is for solids that share triangles: give --imprint, too")
    if given["ascii"]:
        formats.check_text(suffix)
    if given["patches"] is not None:
        said["patches"] = _read_patches(given["patches"])
    if suffix:
        names = [*said.get("patches", {}), *([given["patch_rest"]] if given["patch_rest"] else [])]
        formats.check_names(suffix, names, ascii=given["ascii"])
    return said


def _read_patches(path):
    _require_file(path)
    try:
        with open(path, encoding="utf-8") as stream:
            found = json.load(stream, object_pairs_hook=_without_repetition)
    except (OSError, ValueError) as error:
        raise Error(f"--patches {path} cannot be read: {error}") from error
    if not isinstance(found, dict):
        raise Error(f'--patches {path} must hold an object such as {{"inlet": ["Face1", "Face4"]}}')
    return found


def _without_repetition(pairs):
    found = dict(pairs)
    if len(found) < len(pairs):
        names = [name for name, _ in pairs]
        twice = next(name for name in names if names.count(name) > 1)
        raise ValueError(f"'{twice}' stands twice in one object: name it once")
    return found
