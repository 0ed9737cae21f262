#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Digests of everything MeshQuality makes of the benchmarks' cases, to hold a change against.

    /usr/bin/python3 benchmarks/same_bytes.py --out before.json
    (change the program without changing what it does, and build)
    /usr/bin/python3 benchmarks/same_bytes.py --out after.json --against before.json

Cases are the CAD files of $MESHQUALITY_DATA/cad by refinement, star and sprinkle, the solids of the
curving benchmark as surfaces and volumes, the meshes of $MESHQUALITY_DATA/boolean by their
operations, meshes to improve, and offsets, hollows and wraps of every fifth CAD file. A digest covers the arrays and the report but for its times.
Every case runs in a process of its own. Such as take longer than --seconds of the processor are
given as unfinished, and not compared where either run did not finish them. The status is 1 where
digests differ.
"""

import fnmatch
import hashlib
import json
import os
import select
import sys
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parent.iterdir())
import inside_freecad
import mesh_files

CAD_SUFFIXES = {".step", ".stp", ".iges", ".igs", ".brep", ".brp"}
# What a report says of time, of work done and of the way to the shape is no result: faces that are meshed side by side share
# the counts. The reasons are digested as texts.
NO_RESULT = {"seconds", "cpu_seconds", "queries", "predicates", "exact_predicates", "exempt_reasons", "bridge"}
UNFINISHED = "unfinished"


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--data", default=str(inside_freecad.data_folder()), help="folder with cad/, boolean/ and mesh/")
    result.add_argument("--only", action="append", metavar="PATTERN", help="names of cases")
    result.add_argument("--seconds", type=int, default=60, help="of the processor, at most for each case")
    result.add_argument("--jobs", type=int, default=2, help="cases at the same time")
    result.add_argument("--against", metavar="FILE", help="an earlier result to compare with")
    return result


def cases(data):
    """Name -> a function that returns what is digested."""
    import boolean_models
    import curve_models

    found = {}
    files = sorted(path for path in (data / "cad").glob("*") if path.suffix.lower() in CAD_SUFFIXES)
    for path in files:
        found[f"refine {path.name}"] = lambda path=path: triangulated(path, chord_height_relative=0.002)
        found[f"bound 30, smooth edges removed {path.name}"] = lambda path=path: triangulated(
            path, min_angle=30, keep_edges="feature")
    for path in files[::4]:
        for method in ("star", "sprinkle"):
            found[f"{method} {path.name}"] = lambda path=path, method=method: triangulated(path, method=method)
    for name in curve_models.MODELS:
        for volume in (False, True):
            found[f"curve {'volume' if volume else 'surface'} {name}"] = \
                lambda name=name, volume=volume: curved(name, data, volume)
    for name, (operation, a, b, *_) in boolean_models.CASES.items():
        for method in ("default", "uniform"):
            found[f"boolean {method} {name}"] = lambda operation=operation, names=(a, b), method=method: joined(
                data, operation, names, method)
    for name in mesh_files.IMPROVED:
        found[f"improve {name}"] = lambda name=name: improved(data / "mesh" / name)
    for path in files[::5]:
        for verb, share in (("offset", 0.02), ("offset", -0.02), ("hollow", 0.03)):
            found[f"{verb} {share} {path.name}"] = \
                lambda path=path, verb=verb, share=share: moved(path, verb, share)
        found[f"wrap {path.name}"] = lambda path=path: wrapped(path)
    return found


def shape_of_file(path):
    import Part

    shape = Part.Shape()
    shape.read(str(path))
    return shape


def triangulated(path, **options):
    import MeshQuality as mq

    mesh = mq.triangulate(shape_of_file(path), **options)
    return [mesh.vertices, mesh.triangles, mesh.triangle_face, mesh.report]


def curved(name, data, volume):
    import curve_models

    import MeshQuality as mq

    mesh = mq.curve(curve_models.load(name, data), volume=volume)
    arrays = [mesh.nodes, mesh.triangles, mesh.triangle_face]
    return [*arrays, mesh.tetrahedra, mesh.report] if volume else [*arrays, mesh.report]


def joined(data, operation, names, method):
    import boolean_models

    import MeshQuality as mq

    operands = [boolean_models.read(data / "boolean" / f"{name}.ply.gz") for name in names]
    mesh = mq.boolean(*operands, operation, method=method, **({"resolution": 128} if method == "uniform" else {}))
    return [mesh.vertices, mesh.triangles, mesh.report]


def moved(path, verb, share):
    """The offset or the hollow of a shape by a share of its size."""
    import MeshQuality as mq

    shape = shape_of_file(path)
    mesh = getattr(mq, verb)(shape, share * shape.BoundBox.DiagonalLength)
    return [mesh.vertices, mesh.triangles, mesh.triangle_face, mesh.triangle_source, mesh.report]


def wrapped(path):
    import MeshQuality as mq

    shape = shape_of_file(path)
    mesh = mq.wrap([shape], 0.05 * shape.BoundBox.DiagonalLength)
    return [mesh.vertices, mesh.triangles, mesh.triangle_face, mesh.report]


def improved(path):
    import Mesh

    import MeshQuality as mq

    mesh = mq.improve(Mesh.Mesh(str(path)))
    return [mesh.vertices, mesh.triangles, mesh.report]


def digest(parts):
    """SHA-256 of arrays and reports."""
    result = hashlib.sha256()
    for part in parts:
        if hasattr(part, "tobytes"):
            result.update(f"{part.dtype} {part.shape}".encode() + part.tobytes())
        else:
            values = {name: getattr(part, name) for name in dir(part)
                      if not name.startswith("_") and name not in NO_RESULT}
            plain = {name: value for name, value in values.items() if not callable(value)}
            result.update(json.dumps(plain, sort_keys=True, default=repr).encode())
    return result.hexdigest()


def started(work, seconds):
    """(process, stream) of a copy of this process that writes the digest of one case, or why there is none."""
    import resource

    reading, writing = os.pipe()
    process = os.fork()
    if process:
        os.close(writing)
        return process, reading
    try:
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
        os.write(writing, _answer(work).encode())
    finally:
        os._exit(0)


def _answer(work):
    import MeshQuality as mq

    try:
        return digest(work())
    except (mq.Error, OSError) as error:  # a message of ours is an output, too
        return f"{type(error).__name__}: {error}"
    except Exception as error:
        return f"failed: {type(error).__name__}: {error}"


def run(found, seconds, jobs):
    """Name -> digest of all cases."""
    waiting, running, results = list(found), {}, {}
    while waiting or running:
        while waiting and len(running) < jobs:
            name = waiting.pop(0)
            process, stream = started(found[name], seconds)
            running[stream] = (name, process)
        for stream in select.select(list(running), [], [])[0]:
            name, process = running.pop(stream)
            with os.fdopen(stream, encoding="utf-8") as answer:
                results[name] = answer.read() or UNFINISHED
            os.waitpid(process, 0)
            print(f"{len(results):5} {name:<60} {results[name][:60]}", flush=True)
    return {name: results[name] for name in found}


def differences(now, before):
    """The names whose digests differ, and how many were compared."""
    both = [name for name in now if UNFINISHED not in (now[name], before.get(name, UNFINISHED))]
    return [name for name in both if now[name] != before[name]], len(both)


def work(arguments):
    sys.stdout.reconfigure(line_buffering=True)
    found = cases(Path(arguments.data))
    if arguments.only:
        found = {name: case for name, case in found.items()
                 if any(fnmatch.fnmatch(name, pattern) for pattern in arguments.only)}
    results = run(found, arguments.seconds, arguments.jobs)
    print(f"{len(results)} cases, {sum(value == UNFINISHED for value in results.values())} unfinished")
    if not arguments.against:
        return {"digests": results}
    before = json.loads(Path(arguments.against).read_text(encoding="utf-8"))["digests"]
    differing, compared = differences(results, before)
    print(f"{compared} compared, {len(differing)} differ", *differing, sep="\n    ")
    return {"digests": results, "compared": compared, "differing": differing, "status": int(bool(differing))}


inside_freecad.start(__file__, parser(), work)
