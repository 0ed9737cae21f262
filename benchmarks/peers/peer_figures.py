# SPDX-License-Identifier: LGPL-2.1-or-later
"""What peers.py measures of the meshes that everybody made: by other programs and plain formulas, nothing of MeshQuality."""

import json
import subprocess

import numpy as np

from boolean_peers import read_off
from inside_freecad import system_environment

SAMPLES = "20000"  # of the surface, for the judge
POINTS = 300  # of the mesh, where OpenCASCADE has to do
OFFSET_SAMPLES = 4000  # of a surface, for VTK, which takes each by itself
BELOW = 25.0  # degrees
SECONDS = 600.0  # on the clock, for the judge
CORNERS = ((0, 1, 2), (1, 2, 0), (2, 0, 1))
EDGES = ((0, 1, 2, 3), (0, 2, 1, 3), (0, 3, 1, 2), (1, 2, 0, 3), (1, 3, 0, 2), (2, 3, 0, 1))  # of tetrahedra, and what is opposite


def judged(judge, off, brep, *flags):
    """What the judge says of a mesh and a shape."""
    done = subprocess.run([judge, str(off), str(brep), "--json", *flags], capture_output=True, text=True, timeout=SECONDS,
                          check=True, env=system_environment())
    return json.loads(done.stdout)


def angles(points, triangles):
    """Degrees, the smallest of each triangle."""
    found = np.full(len(triangles), 180.0)
    for i, j, k in CORNERS:
        one, two = (points[triangles[:, other]] - points[triangles[:, i]] for other in (j, k))
        sine, cosine = np.linalg.norm(np.cross(one, two), axis=1), np.einsum("ij,ij->i", one, two)
        found = np.minimum(found, np.degrees(np.arctan2(sine, cosine)))
    return found


def is_closed(triangles):
    """Whether each side of a triangle is one of exactly one other, run the other way."""
    sides = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    keys = [{tuple(row) for row in rows.tolist()} for rows in (sides, sides[:, ::-1])]
    return len(keys[0]) == len(sides) and keys[0] == keys[1]


def volume(points, triangles):
    a, b, c = (points[triangles[:, k]] - points.mean(axis=0) for k in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6.0)


def soundness(off, brep, judge):
    """Triangles, whether the mesh is closed, and the pairs that cross, which only a judge finds."""
    _, triangles = read_off(off)
    if not len(triangles):  # nothing is left, which has no faults
        return {"triangles": 0, "closed": True, "crossings": 0}
    if not judge:
        return {"triangles": len(triangles), "closed": is_closed(triangles), "crossings": None}
    found = judged(judge, off, brep, "--samples", "10")
    return {"triangles": len(triangles), "closed": found["closed"] and found["manifold"] and found["oriented"],
            "crossings": found["self_intersections"]}


def surface(case, off, judge, crossings=True):
    """Of a mesh of a CAD part; `distance` is a multiple of the target."""
    points, triangles = read_off(off)
    smallest = angles(points, triangles)
    row = {"triangles": len(triangles), "angle": float(smallest.min()), "below": 100.0 * float((smallest < BELOW - 1e-3).mean())}
    if judge:
        found = judged(judge, off, case["input"], "--samples", SAMPLES, *([] if crossings else ["--no-si"]))
        row |= {"distance": found["hausdorff_L"] * found["brep_L"] / case["target"], "forced": found["min_angle_unexcused"],
                "watertight": found["closed"], "closed": found["closed"] and found["manifold"] and found["oriented"],
                "crossings": found.get("self_intersections")}
    else:
        row |= {"distance": distance_by_opencascade(points, triangles, case["input"]) / case["target"], "forced": None,
                "watertight": is_closed(triangles), "closed": is_closed(triangles), "crossings": None}
    row["product"] = row["triangles"] * row["distance"]
    return row


def distance_by_opencascade(points, triangles, brep):
    """mm, the largest of some centres of triangles from the faces."""
    import Part

    shape = Part.Shape()
    shape.importBrep(str(brep))
    faces = Part.makeCompound(shape.Faces)
    centres = points[triangles].mean(axis=1)
    chosen = np.random.default_rng(1).permutation(len(centres))[:POINTS]
    return max(Part.Vertex(*centres[k]).distToShape(faces)[0] for k in chosen)


def simplified(case, off, judge, sound=True):
    """Of a simplified mesh: its distance both ways from the given one, by VTK, as a multiple of the target."""
    from metro import diagonal, distances

    given, made = read_off(case["input"]), read_off(off)
    found = distances(made, given, 20000)
    largest = max(found["to"][1], found["back"][1]) / 100.0 * diagonal(given)
    row = {"distance": largest / case["target"], "angle": float(angles(*made).min())}
    return row | (soundness(off, case["shape"], judge) if sound else {})


def improved(case, off, judge, sound=True):
    """As simplified, and how many angles are small."""
    smallest = angles(*read_off(off))
    return simplified(case, off, judge, sound) | {"below": 100.0 * float((smallest < BELOW - 1e-3).mean())}


def offset(case, off, judge, sound=True):
    """Of an offset of a mesh: how far it is from the distance, and points at the distance from it, by VTK, as a multiple of
    the target.
    """
    from metro import even_points
    from offset_parts import locator, points_at_distance

    given, made = read_off(case["input"]), read_off(off)
    if not len(made[1]):
        raise ValueError("nothing is left")
    near_given, _, _ = locator(*given)
    near_made, _, _ = locator(*made)
    rng = np.random.default_rng(7)
    samples = np.concatenate([even_points(made[0][made[1]], OFFSET_SAMPLES, rng), made[0][np.unique(made[1])][:OFFSET_SAMPLES]])
    there = np.abs(near_given(samples) - abs(case["distance"])).max()
    back = near_made(points_at_distance(near_given, given[0][given[1]], case["distance"], case["target"], OFFSET_SAMPLES)).max(initial=0.0)
    row = {"distance": float(max(there, back)) / case["target"]}
    return row | (soundness(off, case["shape"], judge) if sound else {})


def wrapped(case, off, judge):
    """Of a wrap: the per cent of its area that is within the tolerance of the input, and how far the input sticks out of it,
    by VTK, as a multiple of the tolerance.
    """
    from metro import even_points
    from offset_parts import locator
    from wrap_assemblies import distances

    given, made = read_off(case["input"]), read_off(off)
    near_given, _, _ = locator(*given)
    away = near_given(even_points(made[0][made[1]], OFFSET_SAMPLES, np.random.default_rng(7)))
    _, out = distances(given, *made, np.ones(len(made[1]), bool))
    return {"near": 100.0 * float((away <= case["target"]).mean()), "out": float(out) / case["target"]} | soundness(off, case["shape"], judge)


def curved(case, path, _judge):
    """Quadratic tetrahedra, by samples: those whose Jacobian is not positive somewhere, and its ratio of smallest to largest. A
    judge of curved meshes proves the first, and measures distances from the CAD.
    """
    with np.load(path) as arrays:
        points, tetrahedra, triangles = (arrays[name] for name in ("points", "tetrahedra", "triangles"))
    jacobians = sampled_jacobians(points[tetrahedra])
    row = {"tetrahedra": len(tetrahedra), "distance": case["wanted"] / len(tetrahedra) if case["wanted"] else None,
           "invalid": int((jacobians.min(axis=1) <= 0.0).sum()), "distortion": float((jacobians.min(axis=1) / jacobians.max(axis=1)).min())}
    if case["curved_judge"]:
        msh = path.with_suffix(".msh")
        write_msh(msh, points, tetrahedra, triangles)
        found = judged(case["curved_judge"], msh, case["shape"])
        row |= {"invalid": found["tet_invalid"], "folded": found["tri_folded_vs_cad"], "distortion": found["min_J_over_maxJ"],
                "rms": found["dev_rms_rel"] * 1e6, "most": found["dev_max_rel"] * 1e6}
    return row


def sampled_jacobians(corners, steps=5):
    """(T, S) of quadratic tetrahedra (T, 10, 3), whose nodes 4 to 9 lie between corners as Gmsh has them."""
    lattice = [(a, b, c) for a in range(steps + 1) for b in range(steps + 1 - a) for c in range(steps + 1 - a - b)]
    rst = np.array(lattice, float) / steps
    weights = np.column_stack([1.0 - rst.sum(axis=1), rst])  # of the four corners
    gradients = np.vstack([[-1.0, -1.0, -1.0], np.eye(3)])
    shape = [(4.0 * weights[:, k, None] - 1.0) * gradients[k] for k in range(4)]
    shape += [4.0 * (weights[:, i, None] * gradients[j] + weights[:, j, None] * gradients[i])
              for i, j in ((0, 1), (1, 2), (0, 2), (0, 3), (2, 3), (1, 3))]
    return np.linalg.det(np.einsum("nsd,tnx->tsxd", np.array(shape), corners))


def write_msh(path, points, tetrahedra, triangles):
    """A file of Gmsh 2.2 with quadratic elements."""
    with open(path, "w", encoding="ascii") as file:
        file.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{len(points)}\n")
        file.writelines("%d %.17g %.17g %.17g\n" % (k + 1, *point) for k, point in enumerate(points.tolist()))
        file.write(f"$EndNodes\n$Elements\n{len(triangles) + len(tetrahedra)}\n")
        rows = [(9, row) for row in triangles.tolist()] + [(11, row) for row in tetrahedra.tolist()]
        file.writelines(f"{k + 1} {kind} 2 1 1 {' '.join(str(node + 1) for node in row)}\n" for k, (kind, row) in enumerate(rows))
        file.write("$EndElements\n")


def filling(case, path, _judge):
    """Tetrahedra, their smallest dihedral angle, and whether their border is the given surface."""
    with np.load(path) as arrays:
        points, tetrahedra = arrays["points"], arrays["tetrahedra"].astype(np.int64)
    dihedrals = np.full(len(tetrahedra), 180.0)
    for i, j, k, m in EDGES:
        edge = points[tetrahedra[:, j]] - points[tetrahedra[:, i]]
        one, two = (np.cross(edge, points[tetrahedra[:, other]] - points[tetrahedra[:, i]]) for other in (k, m))
        sine, cosine = np.linalg.norm(np.cross(one, two), axis=1), np.einsum("ij,ij->i", one, two)
        dihedrals = np.minimum(dihedrals, np.degrees(np.arctan2(sine, cosine)))
    return {"tetrahedra": len(tetrahedra), "dihedral": float(dihedrals.min()),
            "twentieth": float(np.quantile(dihedrals, 0.05)), "conforms": conforms(read_off(case["input"]), points, tetrahedra)}


def conforms(given, points, tetrahedra):
    """Whether the triangles of one tetrahedron only are those of the surface (V, F), corner for corner."""
    faces = np.sort(np.concatenate([np.delete(tetrahedra, k, axis=1) for k in range(4)]), axis=1)
    kept, count = np.unique(faces, axis=0, return_counts=True)
    border = points[kept[count == 1]]
    return _by_place(border) == _by_place(given[0][given[1]])


def _by_place(triangles):
    return {frozenset(map(bytes, corners)) for corners in np.ascontiguousarray(triangles, float)}
