# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes one CAD file inside freecadcmd and writes what came of it as one JSON object.

The job comes as JSON in the environment variable MESHQUALITY_JOB: file, mesh, result, options, and
brep (where to put the shape for a judge, or null).
"""

import json
import os
import sys
import time
from collections import Counter
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import brep_numbers
import FreeCAD
import Part
from child import in_child

JOB = json.loads(os.environ["MESHQUALITY_JOB"])
BREPMESH_SECONDS = 60


def read_shape(path):
    """The shape of a STEP, IGES or BREP file, or the shapes that a document shows."""
    if path.suffix.lower() != ".fcstd":
        shape = Part.Shape()
        shape.read(str(path))
        return shape
    document = FreeCAD.openDocument(str(path), True)
    candidates = [o for o in document.Objects if holds_faces(o) and not is_step(o)]
    # Where a document shows nothing, what nothing else is made from is the part.
    shown = [o for o in candidates if o.Visibility] or [
        o for o in candidates if not any(holds_faces(user) for user in o.InList)
    ]
    return Part.makeCompound([placed_shape(o) for o in shown])


def holds_faces(thing):
    """Whether a document object has a shape with faces."""
    shape = getattr(thing, "Shape", None)  # of documents' own properties some are called so
    return isinstance(shape, Part.Shape) and not shape.isNull() and bool(shape.Faces)


def is_step(thing):
    """Whether a document object is a step of a body or of a later step, and so no part itself."""
    return thing.TypeId.startswith("PartDesign::") and any(
        user.TypeId.startswith("PartDesign::") and holds_faces(user) for user in thing.InList
    )


def placed_shape(thing):
    """The shape of a document object where its containers put it."""
    shape = thing.Shape.copy()
    if hasattr(thing, "getGlobalPlacement"):
        shape.Placement = thing.getGlobalPlacement()
    return shape


def describe(shape):
    """What the B-rep promises: validity, closedness and Euler characteristic of a mesh of it."""
    in_shells = sum(len(shell.Faces) for shell in shape.Shells)
    return {
        "valid": shape.isValid(),
        "faces": len(shape.Faces),
        "solids": len(shape.Solids),
        "free_shells": len(shape.Shells) - sum(len(solid.Shells) for solid in shape.Solids),
        "closed_shells": all(shell.isClosed() for shell in shape.Shells)
        and in_shells >= len(shape.Faces),
        "brep_euler": brep_numbers.euler(shape),
        "surfaces": Counter(surface_type(face) for face in shape.Faces),
    }


def summarise(mesh, seconds):
    """The report of the mesh as plain numbers."""
    report = mesh.report
    names = (
        "triangles", "vertices", "closed", "oriented", "manifold", "euler", "components",
        "min_angle", "min_angle_unexempted", "mean_min_angle", "max_angle", "max_chord_height",
        "chord_height_asked", "self_intersections", "overlaps", "complete", "cpu_seconds", "queries", "predicates", "exact_predicates",
    )
    found = {name: getattr(report, name, None) for name in names}
    found["below_30"] = sum(report.angle_histogram[:30])
    found["seconds"] = seconds
    found["stages"] = dict(report.seconds)
    found["exempt"] = len(report.exempt)
    found["exempt_forced"] = sum(reason.forced for _, reason in report.exempt_reasons)
    found["causes"] = report.exempt_causes[:5]
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


def brepmesh(shape, distance):
    """Triangles and processor seconds of OpenCASCADE's mesher for a chord height in mm."""
    start = time.process_time()
    _, triangles = shape.copy().tessellate(distance)
    return {"triangles": len(triangles), "cpu_seconds": time.process_time() - start}


def work():
    import MeshQuality as mq  # noqa: PLC0415  a build that does not load is a result, too
    from MeshQuality.core.certify import verdict  # noqa: PLC0415

    start = time.monotonic()
    shape = read_shape(Path(JOB["file"]))
    result = {"read_seconds": time.monotonic() - start, **describe(shape)}
    if not result["faces"]:
        raise ValueError("no faces")
    yield result
    start = time.monotonic()
    mesh = mq.triangulate(shape, **JOB["options"])
    result.update(summarise(mesh, time.monotonic() - start))
    result["met"] = not verdict.of_triangulation(mesh, verdict.must_be_closed(shape), JOB["options"], shape)
    result["fallbacks"] = fallbacks(shape, mesh.report)
    mesh.write(JOB["mesh"])
    if JOB["brep"]:
        brep_numbers.with_faces(shape).exportBrep(JOB["brep"])
    result["state"] = "ok"
    yield result
    if result["chord_height_asked"] > 0:
        distance = result["chord_height_asked"]
        result["brepmesh"] = in_child(lambda: brepmesh(shape, distance), BREPMESH_SECONDS)
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
