# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes one random part inside freecadcmd, meshes it and checks what the mesher promises.

The job comes as JSON in the environment variable MESHQUALITY_JOB: seed, skip (steps of the part to
leave out), plain (options to leave out), creased (as in random_part), result (file to write) and
brep (file for the part, or null). `faults` of the result holds a sentence for every promise that is not kept.
"""

import json
import os
import random
import re
import sys
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import brep_numbers
import fuzz_shapes
import numpy as np
from child import in_child

JOB = json.loads(os.environ["MESHQUALITY_JOB"])
DISTANCE_SLACK = 1e-6
LARGEST = 1e9  # mm; what modelling makes beyond it is not meant
CROSSING = "self-intersections"
RUN_AWAY = 500  # triangles given up for want of room: no part needs so many
CROWDED = ("crowded", "fold", "face_floor_raised")  # causes of exemptions for want of room
FINE = 1e-4  # of the size: chord height of the triangles that a volume is compared with
MEASURED = 5.0  # seconds for measuring distances a second time, which is slow on splines


def random_options(seed, size):
    dice = random.Random(f"{seed}:options")
    found = {
        "min_angle": dice.choice((25.0, 30.0, round(dice.uniform(20, 33), 2))),
        "chord_height": size * 10 ** dice.uniform(-3.3, -1.5),
        "max_edge": size * 10 ** dice.uniform(-1.5, -0.3),
        "min_edge": size * 10 ** dice.uniform(-4, -2.5),
        "method": dice.choice(("refine",) * 8 + ("star", "sprinkle")),
    }
    odds = {"chord_height": 0.7, "max_edge": 0.3, "min_edge": 0.15}
    return {name: value for name, value in found.items()
            if dice.random() < odds.get(name, 1.0) and name not in JOB["plain"]}


def corner_angles(mesh):
    """The smallest angle of every triangle in degrees."""
    points = mesh.vertices[mesh.triangles]
    cosines = []
    for corner in range(3):
        a = points[:, (corner + 1) % 3] - points[:, corner]
        b = points[:, (corner + 2) % 3] - points[:, corner]
        lengths = np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1)
        cosines.append(np.einsum("ij,ij->i", a, b) / np.maximum(lengths, 1e-300))
    return np.degrees(np.arccos(np.clip(np.max(cosines, axis=0), -1.0, 1.0)))


def topology_faults(mesh, shape):
    report, faults = mesh.report, []
    edges = mesh.triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2).astype(np.int64)
    directed = edges[:, 0] * len(mesh.vertices) + edges[:, 1]
    against = edges[:, 1] * len(mesh.vertices) + edges[:, 0]
    if len(np.unique(directed)) != len(directed):
        faults.append("an edge is run twice in one direction")
    if len(np.setdiff1d(against, directed)):
        faults.append("not closed")
    faults += [f"the report says not {name}" for name in ("closed", "oriented", "manifold")
               if not getattr(report, name)]
    if report.euler != brep_numbers.euler(shape):
        faults.append(f"Euler number {report.euler} instead of {brep_numbers.euler(shape)}")
    lost = sorted(set(range(len(shape.Faces))) - set(np.unique(mesh.triangle_face).tolist()))
    named = " ".join(report.notes)
    faults += [f"Face{face + 1} is lost" for face in lost
               if not re.search(rf"\bFace{face + 1}\b", named)]
    if report.self_intersections != 0:
        faults.append(f"{report.self_intersections} {CROSSING}")
    return faults


def angle_faults(mesh, asked):
    report, faults = mesh.report, []
    exempt = dict(report.exempt_reasons)
    below = np.flatnonzero(corner_angles(mesh) < asked - 1e-9)
    if report.min_angle_unexempted < asked:
        faults.append(f"angle {report.min_angle_unexempted:.3f} not exempted")
    if [t for t in below.tolist() if t not in exempt]:
        faults.append("a triangle below the bound is not in the list")
    crowded = sum(why.cause in CROWDED for why in exempt.values())
    if crowded > RUN_AWAY:
        faults.append(f"run-away: {crowded} triangles without room")
    if not all(why.entities for why in exempt.values()):
        faults.append("a reason names no entity")
    return faults


def measured_apart(mesh, shape):
    """The distance that does not come from the mesher, or -1 where that takes too long."""
    import MeshQuality as mq

    end = time.monotonic() + MEASURED
    try:
        return mq.quality(mesh, shape, lambda *_: time.monotonic() < end).max_chord_height
    except mq.Cancelled:
        return -1.0


def distance_faults(mesh, shape, options):
    report, faults = mesh.report, []
    asked = options["chord_height"]
    if asked != "none" and "min_edge" not in options:
        for who, far in (("report", report.max_chord_height),
                         ("quality", measured_apart(mesh, shape))):
            if far > asked * (1 + DISTANCE_SLACK):
                faults.append(f"{who}: distance {far / asked:.3g} of the chord height")
    # Two-sided: the volume between surface and mesh.
    room = 1.05 * shape.Area * max(report.max_chord_height, 0.0) + 1e-5 * shape.Volume
    if abs(report.volume - shape.Volume) > room:
        # The volume of the shape is integrated, and wrong for some splines. OpenCASCADE's mesher and its check
        # abort on some shapes, which is no fault of the mesh.
        by_triangles = in_child(lambda: tessellated(shape))
        if by_triangles is None or abs(report.volume - by_triangles) > room:
            faults.append(f"volume off by {report.volume / shape.Volume - 1:.2g}")
    return faults


def tessellated(shape):
    """The volume by FreeCAD's own triangles."""
    import Mesh

    return Mesh.Mesh(shape.tessellate(FINE * shape.BoundBox.DiagonalLength)).Volume


def number_faults(mesh):
    faults = []
    if (mesh.vertices.astype(np.float32) != mesh.vertices).any():
        faults.append("a vertex is not single precision")
    if len(np.unique(mesh.triangles)) != len(mesh.vertices):
        faults.append("a vertex without triangles")
    if not mesh.report.complete:
        faults.append("incomplete")
    return faults


def same(a, b):
    return a.vertices.tobytes() == b.vertices.tobytes() \
        and a.triangles.tobytes() == b.triangles.tobytes() \
        and a.triangle_face.tobytes() == b.triangle_face.tobytes()


def crosses_itself(shape):
    try:
        shape.check(True)
    except ValueError as error:
        return str(error)[:200] if "SelfIntersect" in str(error) else ""
    return ""


def check(shape, options):
    import MeshQuality as mq

    options = {"chord_height": "none", **options}
    mesh = mq.triangulate(shape, **options)
    faults = topology_faults(mesh, shape) + angle_faults(mesh, options["min_angle"]) \
        + distance_faults(mesh, shape, options) + number_faults(mesh)
    if JOB["seed"] % 4 == 0 and not same(mesh, mq.triangulate(shape, **options)):
        faults.append("not the same bytes twice")
    return {"faults": faults, "triangles": len(mesh.triangles), "notes": list(mesh.report.notes),
            "cpu_seconds": mesh.report.cpu_seconds, "exempt": len(mesh.report.exempt),
            "causes": mesh.report.exempt_causes[:5]}


def work():
    import MeshQuality as mq

    shape, steps = fuzz_shapes.random_part(JOB["seed"], JOB["skip"], creased=JOB["creased"])
    if shape is None or not shape.isValid() or shape.BoundBox.DiagonalLength > LARGEST:
        return {"state": "no part", "faults": []}
    if JOB["brep"]:
        shape.exportBrep(JOB["brep"])
    options = random_options(JOB["seed"], shape.BoundBox.DiagonalLength)
    if "min_angle" not in options:
        options["min_angle"] = 25.0
    result = {"state": "ok", "steps": steps, "options": options, "faces": len(shape.Faces)}
    # Kept before the work, so that a crash still tells which part it was.
    Path(JOB["result"]).write_text(json.dumps({**result, "state": "crash"}), encoding="utf-8")
    try:
        result.update(check(shape, options))
    except mq.Error as error:
        result["faults"] = [f"{type(error).__name__}: {error}"]
    if result["faults"]:
        result["crossing"] = in_child(lambda: crosses_itself(shape)) or ""
        if result["crossing"]:  # then its mesh has to cross itself too
            result["faults"] = [fault for fault in result["faults"] if CROSSING not in fault]
    return result


def main():
    result = work()
    Path(JOB["result"]).write_text(json.dumps(result, default=float), encoding="utf-8")


main()
sys.exit(0)
