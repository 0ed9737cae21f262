# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task public of peers.py: a folder of parts that nobody chose for it, and of how many everybody makes what was asked for."""

import json
import statistics
from pathlib import Path

import peer_figures
from child import in_child

SUFFIXES = {".step", ".stp", ".brep", ".iges", ".igs"}
SHARES = {"measure": "89abcdef", "develop": "01234567", "both": "0123456789abcdef"}  # by the first digit of a part's digest
LEVEL = 2e-3  # of the largest dimension: the distance to keep
ALLOWED = 1.05  # times that, since the judge measures a part's size otherwise
ANGLE = 25.0  # degrees
READING = 60.0  # CPU seconds


def chosen(arguments):
    """The files of the share, in the order of their digests."""
    paths = sorted(path for path in Path(arguments.parts).iterdir()
                   if path.suffix.lower() in SUFFIXES and path.name[0] in SHARES[arguments.share])
    return paths[:arguments.most or None]


def prepared(path, folder, as_step):
    """A case of a file, as BREP, and STEP where that is asked for; None without faces. Some files crash those who read them."""
    import brep_numbers
    import numpy as np
    import Part

    shape = Part.Shape()
    shape.read(str(path))
    if not shape.Faces:
        return None
    shape = brep_numbers.with_faces(shape)
    brep, step = (Path(folder) / f"part{suffix}" for suffix in (".brep", ".step"))
    shape.exportBrep(str(brep))
    if as_step:
        shape.exportStep(str(step))
    size = float(np.ptp(np.array(shape.copy().tessellate(1e-3 * shape.BoundBox.DiagonalLength)[0]), axis=0).max())
    closed = all(shell.isClosed() for shell in shape.Shells) and sum(len(shell.Faces) for shell in shape.Shells) >= len(shape.Faces)
    return {"name": path.stem, "input": str(brep), "step": str(step), "target": LEVEL * size, "valid": shape.isValid(),
            "closed_shells": closed, "bodies": len(shape.Solids) + len(shape.Shells) - sum(len(solid.Shells) for solid in shape.Solids)}


def result_of(runs, case, mesher):
    """What a mesher makes of a part; with the first of its settings that keeps the distance, or with the last."""
    factor = case["target"] if mesher in runs.task.relative else 1.0
    found = {}
    for setting in (factor * step for step in runs.task.settings.get(mesher, [case["target"] / factor])):
        said = runs.run(runs.job(case, mesher, setting))
        if "failed" in said:
            return {"failed": said["failed"]}
        found = {"seconds": said["seconds"], **(runs.measured(peer_figures.surface, case, runs.out(mesher)) or {"failed": "not measured"})}
        if found.get("distance", 0.0) <= ALLOWED:
            break
    return found


def results(runs, meshers, kept):
    """{(name, mesher): result} of all parts, with `valid`, `closed_shells` and `bodies` of the part. The file `kept` grows by a
    line each, and what is there is not done again.
    """
    kept = Path(kept)
    done = {}
    if kept.exists() and not runs.arguments.afresh:
        lines = [json.loads(line) for line in kept.read_text(encoding="utf-8").splitlines()]
        done = {(line["part"], line["mesher"]): line for line in lines}
    with kept.open("a" if done else "w", encoding="utf-8") as file:
        for k, path in enumerate(paths := chosen(runs.arguments)):
            wanted = [mesher for mesher in meshers if (path.stem, mesher) not in done]
            case = wanted and in_child(lambda path=path: prepared(path, runs.folder, bool(runs.outside)), READING)
            for mesher in wanted if case and case["valid"] else ():
                line = {"part": path.stem, "mesher": mesher, "closed_shells": case["closed_shells"], "bodies": case["bodies"],
                        **result_of(runs, case, mesher)}
                done[path.stem, mesher] = line
                file.write(json.dumps(line) + "\n")
                file.flush()
            print(f"{k + 1} of {len(paths)}", flush=True)
    names = {path.stem for path in paths}
    return {key: line for key, line in done.items() if key[0] in names and key[1] in meshers}


def rows(found, meshers):
    """One row a mesher: counts of the parts that all have done."""
    names = [name for name in dict.fromkeys(name for name, _ in found) if all((name, mesher) in found for mesher in meshers)]
    return [{"case": f"{len(names)} parts", "mesher": mesher,
             **counts([found[name, mesher] for name in names], [found.get((name, "BRepMesh"), {}) for name in names])} for mesher in meshers]


def counts(lines, of_brepmesh):
    """The columns of a row from the results of a mesher, with BRepMesh's of the same parts."""
    made = [line for line in lines if "failed" not in line]
    single, failures = [line for line in made if line["bodies"] == 1], [line["failed"] for line in lines if "failed" in line]
    ratios = [line["triangles"] / other["triangles"] for line, other in zip(lines, of_brepmesh)
              if line.get("triangles") and other.get("triangles")]
    return {"meshed": len(made), "late": sum(text in ("time limit", "hang") for text in failures),
            "crashed": sum(text.startswith("crash") for text in failures),
            "closed": share(is_closed, [line for line in made if line["closed_shells"]]), "angle": share(angle_kept, made),
            "distance": share(distance_kept, made), "free": share(no_crossings, [line for line in single if line["crossings"] is not None]),
            "but_angles": 100.0 * sum(is_good(line, angles=False) for line in made) / max(1, len(lines)),
            "good": 100.0 * sum(map(is_good, made)) / max(1, len(lines)),
            "smallest": median(line["angle"] for line in made), "ratio": median(ratios), "seconds": median(line["seconds"] for line in made),
            "most": max((line["seconds"] for line in made), default=None)}


def median(values):
    """None of nothing."""
    values = list(values)
    return statistics.median(values) if values else None


def share(test, lines):
    """Per cent; None of nothing."""
    return 100.0 * sum(map(test, lines)) / len(lines) if lines else None


def is_closed(line):
    """Without a border; a part of one body also manifold and oriented, as bodies that touch may share edges."""
    return bool(line["closed"] if line["bodies"] == 1 else line["watertight"])


def angle_kept(line):
    """Or forced by the part, as the judge says where there is one."""
    return (line["forced"] if line["forced"] is not None else line["angle"]) >= ANGLE - 1e-3


def distance_kept(line):
    return line["distance"] <= ALLOWED


def no_crossings(line):
    return not line["crossings"]


def is_good(line, angles=True):
    return ((is_closed(line) or not line["closed_shells"]) and (no_crossings(line) or line["bodies"] != 1) and distance_kept(line)
            and (angle_kept(line) or not angles))
