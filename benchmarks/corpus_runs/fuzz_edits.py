# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random parts that are edited at random and meshed again with a cache: every mesh must keep what a
mesh from nothing keeps, states met again must get their mesh again, and faces must be reused.

    MESHQUALITY_SEEDS=0:100 freecadcmd -P <root>/Mod benchmarks/corpus_runs/fuzz_edits.py </dev/null

Prints a line for each part, and what is worse than from nothing in any of its meshes.
"""

import os
import random
import sys
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())

EDITS = 5
MOST = 60_000  # triangles; parts that need more are left out


def edited(dice, shape, made):
    """The shape after one more random edit, and what was done."""
    import Part  # noqa: PLC0415  only FreeCAD has it
    from FreeCAD import Placement, Rotation, Vector  # noqa: PLC0415

    def near(solid):
        """One valid solid that is about as large."""
        return len(solid.Solids) == 1 and solid.isValid() and solid.Volume > 0.3 * shape.Volume

    box, size = shape.BoundBox, shape.BoundBox.DiagonalLength
    kind = dice.choice(("cut", "cut", "cut", "boss", "fillet", "chamfer", "move", "back"))
    if kind == "back":
        return dice.choice(made), kind
    if kind == "move":
        moved = shape.copy()
        moved.Placement = Placement(
            Vector(*(dice.uniform(-size, size) for _ in range(3))),
            Rotation(Vector(*(dice.gauss(0, 1) for _ in range(3))), dice.uniform(0, 360))
            if dice.random() < 0.6 else Rotation()).multiply(moved.Placement)
        return moved, kind
    if kind in ("fillet", "chamfer"):
        edge = dice.choice([edge for edge in shape.Edges if not edge.Degenerated])
        width = dice.uniform(0.01, 0.05) * size
        other = (shape.makeFillet(width, [edge]) if kind == "fillet"
                 else shape.makeChamfer(width, [edge]))
        return (other if near(other) else shape), kind
    at = Vector(*(dice.uniform(low, high) for low, high in
                  ((box.XMin, box.XMax), (box.YMin, box.YMax), (box.ZMin, box.ZMax))))
    radius = dice.uniform(0.005, 0.08) * size
    tool = Part.makeSphere(radius, at) if dice.random() < 0.3 else Part.makeCylinder(
        radius, 2 * size, at - Vector(0, 0, size), Vector(0, 0, 1))
    other = shape.cut(tool) if kind == "cut" else shape.fuse(Part.makeSphere(radius, at))
    other = other.Solids[0] if len(other.Solids) == 1 else other
    return (other if near(other) else shape), kind


def random_options(dice, size):
    """Of every kind that reuse has to do with."""
    found = {"min_angle": dice.choice((25.0, 25.0, 30.0))}
    choices = {
        "chord_height": size * 10 ** dice.uniform(-3.0, -2.0),
        "chord_height_relative": 10 ** dice.uniform(-3.0, -2.0),
        "max_edge": size * dice.uniform(0.05, 0.3),
        "edges_per_circle": dice.choice((12.0, 24.0)),
        "growth_rate": dice.uniform(1.2, 2.0),
        "insertion": "circumcentre",
    }
    for name, odds in (("chord_height", 0.6), ("max_edge", 0.3), ("edges_per_circle", 0.15),
                       ("growth_rate", 0.15), ("insertion", 0.1)):
        if dice.random() < odds:
            found[name] = choices[name]
    if "chord_height" not in found and dice.random() < 0.5:
        found["chord_height_relative"] = choices["chord_height_relative"]
    elif "chord_height" not in found:
        found["chord_height"] = "none"
    return found


def faults(again, nothing, before, options):
    """What the mesh made with the cache misses and neither the mesh from nothing nor the mesh before the
    edit does.
    """
    a, n = again.report, nothing.report
    found = [name for name in ("closed", "oriented", "manifold", "complete")
             if getattr(n, name) and not getattr(a, name)]
    if a.min_angle_unexempted < options["min_angle"]:
        found.append(f"angle {a.min_angle_unexempted:.4f}")
    if len(a.exempt) > max(len(n.exempt), len(before.report.exempt)):
        found.append(f"{len(a.exempt)} exempt instead of {len(n.exempt)}")
    if a.self_intersections > max(n.self_intersections, before.report.self_intersections):
        found.append(f"{a.self_intersections} crossings")
    asked = a.chord_height_asked
    worst = max(asked, n.max_chord_height, before.report.max_chord_height)
    if asked > 0 and a.max_chord_height > worst:
        found.append(f"distance {a.max_chord_height:.6g} of {asked:.6g}")
    if a.triangles > 1.5 * n.triangles + 50:
        found.append(f"{a.triangles} triangles instead of {n.triangles}")
    return found


def arrays(mesh):
    return mesh.vertices.tobytes(), mesh.triangles.tobytes(), mesh.triangle_face.tobytes()


def campaign(seed):
    """One part: a line of figures, and what is wrong."""
    import fuzz_shapes  # noqa: PLC0415  needs FreeCAD

    import MeshQuality as mq  # noqa: PLC0415
    from MeshQuality.core.sources import convert  # noqa: PLC0415

    dice = random.Random(f"{seed}:edits")
    shape, _ = fuzz_shapes.random_part(seed)
    size = shape.BoundBox.DiagonalLength
    options = random_options(dice, size)
    cache, made, wrong, reused, faces, cpu = mq.MeshCache(), [shape], [], 0, 0, [0.0, 0.0]
    seen, before, what = {}, None, "part"
    for number in range(EDITS + 1):
        try:
            nothing = mq.triangulate(shape, **options, max_triangles=MOST)
        except mq.Error as error:
            return f"{seed}: left out, {str(error)[:60]}", wrong
        if not nothing.report.complete:
            return f"{seed}: left out, too many triangles", wrong
        again = mq.triangulate(shape, **options, max_triangles=MOST, cache=cache)
        wrong += [f"{seed} edit {number} {what}: {text}" for text in faults(again, nothing, before or nothing, options)]
        before = again
        if number == 0 and arrays(again) != arrays(nothing):
            wrong.append(f"{seed}: the first mesh is not that from nothing")
        key = convert.shape_text(shape)  # modelling may change the tolerances of a shape
        if key in seen and seen[key] != arrays(again):
            wrong.append(f"{seed} edit {number}: not the mesh that it was")
        seen[key] = arrays(again)
        if number > 0:
            reused += again.report.reused_faces
            faces += len(shape.Faces)
            cpu[0] += nothing.report.cpu_seconds
            cpu[1] += again.report.cpu_seconds
        try:
            shape, what = edited(dice, shape, made)
        except Exception as error:  # noqa: BLE001  modelling fails in many ways
            what = f"failed {type(error).__name__}"
        made.append(shape)
    return (f"{seed}: {reused} of {faces} faces reused, {nothing.report.triangles} triangles, "
            f"CPU s {cpu[0]:.2f} from nothing, {cpu[1]:.2f} again"), wrong


def main():
    first, last = (int(n) for n in os.environ.get("MESHQUALITY_SEEDS", "0:20").split(":"))
    bad = 0
    for seed in range(first, last):
        begun = time.time()
        line, wrong = campaign(seed)
        print(f"{line} ({time.time() - begun:.1f} s)", *wrong, sep="\n    ", flush=True)
        bad += bool(wrong)
    print(f"{bad} of {last - first} parts with faults", flush=True)


main()
