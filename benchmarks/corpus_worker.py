# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes one CAD file inside freecadcmd and writes what came of it as one JSON object.

The job comes as JSON in the environment variable MESHQUALITY_JOB: file, mesh, result, options, and
brep (where to put the shape for a judge, or null).
"""

import json
import os
import re
import sys
import time
from collections import Counter
from pathlib import Path

import brep_numbers
import FreeCAD
import Part

JOB = json.loads(os.environ["MESHQUALITY_JOB"])


def read_shape(path):
    """The shape of a STEP, IGES or BREP file, or the visible shapes of a document."""
    if path.suffix.lower() != ".fcstd":
        shape = Part.Shape()
        shape.read(str(path))
        return shape
    document = FreeCAD.openDocument(str(path), True)
    shown = [o for o in document.Objects if o.Visibility and hasattr(o, "Shape")]
    shapes = [o.Shape for o in shown if not o.Shape.isNull() and o.Shape.Faces]
    return Part.makeCompound(shapes)


def describe(shape):
    """What the B-rep promises: validity, closedness and Euler characteristic of a mesh of it."""
    in_shells = sum(len(shell.Faces) for shell in shape.Shells)
    return {
        "valid": shape.isValid(),
        "faces": len(shape.Faces),
        "solids": len(shape.Solids),
        "closed_shells": all(shell.isClosed() for shell in shape.Shells)
        and in_shells >= len(shape.Faces),
        "brep_euler": brep_numbers.euler(shape),
    }


def causes(exempt):
    """Why triangles are exempted, entity numbers left out, most frequent first."""
    kinds = Counter(re.sub(r"\d+(\.\d+)?", "#", reason) for _, reason in exempt)
    return kinds.most_common(5)


def summarise(mesh, seconds):
    """The report of the mesh as plain numbers."""
    report = mesh.report
    names = (
        "triangles", "vertices", "closed", "oriented", "manifold", "euler", "components",
        "min_angle", "min_angle_unexempted", "mean_min_angle", "max_angle", "max_chord_height",
        "complete", "cpu_seconds", "queries", "predicates", "exact_predicates",
    )
    found = {name: getattr(report, name, None) for name in names}
    found["below_30"] = sum(report.angle_histogram[:30])
    found["seconds"] = seconds
    found["stages"] = dict(report.seconds)
    found["exempt"] = len(report.exempt)
    found["causes"] = causes(report.exempt)
    found["notes"] = list(getattr(report, "notes", []))
    return found


def fallbacks(shape, report):
    """Faces by surface type, how many of them fell back, and why, by face."""
    types = [surface_type(face) for face in shape.Faces]
    fallen = dict(report.fallback)
    return {
        "surfaces": Counter(types),
        "fallen": Counter(types[face] for face in fallen),
        "why": {f"Face{face + 1}": f"{types[face]}: {why}" for face, why in fallen.items()},
    }


def surface_type(face):
    """Plane, Cylinder, BSplineSurface, ..."""
    try:
        return type(face.Surface).__name__
    except TypeError:  # FreeCAD has no class for it
        return "other"


def work():
    import MeshQuality as mq  # noqa: PLC0415  a build that does not load is a result, too

    start = time.monotonic()
    shape = read_shape(Path(JOB["file"]))
    result = {"read_seconds": time.monotonic() - start, **describe(shape)}
    yield result
    start = time.monotonic()
    mesh = mq.triangulate(shape, **JOB["options"])
    result.update(summarise(mesh, time.monotonic() - start))
    result["fallbacks"] = fallbacks(shape, mesh.report)
    mesh.write(JOB["mesh"])
    if JOB["brep"]:
        shape.exportBrep(JOB["brep"])
    result["state"] = "ok"
    yield result


def main():
    result = {}
    try:
        for result in work():
            # Kept from the start, so that a crash still tells which part it was.
            Path(JOB["result"]).write_text(json.dumps(result, default=float))
    except MemoryError:
        result.update(state="error", error="out of memory")
    except Exception as error:
        result.update(state="error", error=f"{type(error).__name__}: {error}")
    Path(JOB["result"]).write_text(json.dumps(result, default=float))


main()
sys.exit(0)
