# SPDX-License-Identifier: LGPL-2.1-or-later
"""Booleans of the examples of wang_models, each in a FreeCAD of its own, and what they took."""

import json
import os
import resource
import sys
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
from child import Limits
from inside_freecad import ROOT

VARIABLE = "MESHQUALITY_WANG_RUN"
# Limits of a run. Most take seconds. At 129 rays the surface of "that - bars" crosses itself at 228,000 pairs of triangles, and 834,000
# triangles are left of them: the step that makes it free of crossings takes over 400 s.
SECONDS, GIBIBYTES = 1800.0, 16.0


def operands(name, folder, with_exact=False):
    """Makes the operands of an example, and the exact result where it is asked for, as files of the folder; returns the
    numbers of triangles.
    """
    return _run({"work": "operands", "name": name, "folder": str(folder), "exact": with_exact})


def boolean(name, folder, rays, method="uniform", full=False, points=0, save=""):
    """One Boolean of operands that were made; the distances from the exact result over so many points, if any. `save` names
    the file of the folder for the triangles of the result that are an operand's own, and for the others.

    Returns {"cpu_seconds", "seconds", "stages", "megabytes", "megabytes_before", "triangles", "retained", "holes", "crossings",
    "faults", "components", "euler", "degenerate", "open", "errors"}; `crossings` are pairs of triangles of the scheme's surface that
    crossed (of the operands' by another method), `open` counts what is not closed, oriented or 2-manifold; megabytes are the most that were
    resident, and what the process with FreeCAD and the operands had before.
    """
    return _run({"work": "boolean", "name": name, "folder": str(folder), "rays": rays, "method": method, "full": full,
                 "points": points, "save": save})


def _run(job):
    command = ["freecadcmd", "-P", str(ROOT / "Mod"), str(Path(__file__).resolve())]
    _, text = Limits(SECONDS, GIBIBYTES).run(command, {**os.environ, VARIABLE: json.dumps(job)})
    lines = [line for line in text.splitlines() if line.startswith('{"')]
    if not lines:
        raise RuntimeError(f"{job}: {text[-600:]}")
    answer = json.loads(lines[-1])
    if "missing" in answer:
        sys.exit(answer["missing"])
    return answer


def load(path):
    """The surfaces (V, F) of a file of the folder."""
    import numpy as np

    with np.load(path) as file:
        return [(file[f"v{k}"], file[f"t{k}"]) for k in range(len(file.files) // 2)]


def _save(path, *meshes):
    import numpy as np

    np.savez(path, **{f"v{k}": mesh[0] for k, mesh in enumerate(meshes)},
             **{f"t{k}": mesh[1] for k, mesh in enumerate(meshes)})


def _make_operands(job):
    import wang_models

    folder, name = Path(job["folder"]), job["name"]
    a, b = wang_models.operands(name)
    _save(folder / f"{name}.npz", a, b)
    if job["exact"]:
        _save(folder / f"{name}.exact.npz", wang_models.exact(a, b, wang_models.BY_NAME[name].operation))
    return {"triangles": [len(a[1]), len(b[1])]}


def _megabytes():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def _boolean(job):
    import metro
    import MeshQuality as mq
    import wang_models

    folder, name = Path(job["folder"]), job["name"]
    meshes = load(folder / f"{name}.npz")
    before, wall = _megabytes(), time.perf_counter()
    result = mq.boolean(meshes, operation=wang_models.BY_NAME[name].operation, method=job["method"],
                        resolution=job["rays"], full=job["full"])
    report = result.report
    row = {"cpu_seconds": report.cpu_seconds, "seconds": time.perf_counter() - wall, "stages": dict(report.seconds),
           "megabytes": _megabytes(), "megabytes_before": before, "triangles": report.triangles,
           "retained": report.retained, "holes": report.holes_filled, "crossings": report.crossing_pairs,
           "faults": report.faults_left, "components": report.components, "euler": report.euler,
           "degenerate": report.degenerate_triangles,
           "open": report.border_edges + report.nonmanifold_edges + report.misoriented_edges + report.pinched_vertices}
    if job["points"]:
        exact = load(folder / f"{name}.exact.npz")[0]
        row["errors"] = metro.distances((result.vertices + result.origin, result.triangles), exact, job["points"])
        row["errors"]["bound"] = 100.0 * report.error_bound / metro.diagonal(exact)
    if job["save"]:
        own, points = result.triangle_source[:, 0] >= 0, result.vertices + result.origin
        _save(folder / job["save"], (points, result.triangles[own]), (points, result.triangles[~own]))
    return row


if VARIABLE in os.environ:
    asked = json.loads(os.environ[VARIABLE])
    del os.environ[VARIABLE]
    # FreeCAD keeps what is raised to itself.
    try:
        told = _make_operands(asked) if asked["work"] == "operands" else _boolean(asked)
    except FileNotFoundError as problem:
        told = {"missing": str(problem)}
    print("\n" + json.dumps(told))
    sys.stdout.flush()
    sys.exit(0)
