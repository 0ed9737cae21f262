#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curved volume meshes of 19 solids, and what Gmsh makes of the same ones in the same run.

    /usr/bin/python3 benchmarks/curve/curve_peers.py [--order 2] [--only 't*'] [--judge PROGRAM]

Seconds are the processor's, user and system, with the processes that were started. Ours are those
of mq.curve, from the shape to the measured mesh; of them `fill` goes to the tetrahedral mesher.
Gmsh's are of curving and its optimisation (elastic analogy, then high order), and in brackets of
its straight mesh, the coarsest that it makes or, with --alike, one of about as many tetrahedra as
ours; it is run with the Python given by --python, and left out where that has no module gmsh. rms: that of the deviation of the boundary from the CAD, as a part of what plain
curving leaves. Solids are those of curve_models.py; $MESHQUALITY_DATA holds the parts from files
(default: ../shared/data beside the repository), what is missing is skipped.

Ours are judged by our own certified test. With --judge, a program that reads a mesh and the CAD and
prints JSON, both are judged by that, and Gmsh's columns are filled.
"""

import fnmatch
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad

GMSH = Path(__file__).resolve().parent / "curve_gmsh.py"
LARGE = "CrankArm"


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--order", type=int, default=2, choices=(2, 3, 4))
    result.add_argument("--only", default="*", help="names, with wildcards")
    result.add_argument("--data", default=str(inside_freecad.data_folder()))
    result.add_argument("--python", default="/usr/bin/python3", help="that has the module gmsh")
    result.add_argument("--alike", action="store_true",
                        help="give Gmsh about as many tetrahedra as ours")
    result.add_argument("--judge", help="program that judges a mesh: MESH CAD --json")
    result.add_argument("--limit", type=float, default=150.0, help="CPU seconds for Gmsh a model")
    return result


def options(order, volume, repair):
    from MeshQuality.compat import extension

    result = extension().CurveOptions()
    result.order, result.volume, result.repair = order, volume, repair
    return result


def plain_deviation(shape, order):
    """The rms deviation of the same straight mesh, curved without repairs."""
    from MeshQuality.compat import extension

    straight = extension().TriangulateOptions()
    straight.min_angle, straight.chord_height_relative = 20.0, 0.01
    return extension().curve(shape, options(order, False, False), straight).report.rms_deviation


def ours(shape, order, folder):
    import MeshQuality as mq

    mesh = mq.curve(shape, order=order, volume=True)
    report = mesh.report
    mesh.write(folder / "ours.msh")
    return {
        "seconds": report.cpu_seconds, "elements": report.elements, "invalid": report.invalid,
        "folded": sum(name.startswith("triangle") for name in report.invalid_elements),
        "moved": report.moved_vertices, "distortion": report.min_distortion,
        "rms": report.rms_deviation / plain_deviation(shape, order), "stages": report.seconds,
    }


def gmsh(arguments, folder, count):
    done = subprocess.run([arguments.python, str(GMSH), str(folder / "model.brep"), str(folder),
                           str(arguments.order), str(arguments.limit),
                           str(count if arguments.alike else 0)],
                          capture_output=True, text=True, env=inside_freecad.system_environment())
    lines = done.stdout.strip().splitlines()
    if done.returncode != 0 or not lines:
        return {"failed": (done.stderr.strip().splitlines() or ["it crashed"])[-1]}
    found = json.loads(lines[-1])
    if found["repaired"] is None:
        return {"failed": f"did not end within {arguments.limit:.0f} s", **found}
    row = {"seconds": found["repaired"]["seconds"], "straight": found["straight"],
           "said": found["repaired"]["said"], "version": found["version"]}
    if arguments.judge:
        plain = judge(arguments.judge, folder, "plain") if found["plain"] else None
        row.update(judged(judge(arguments.judge, folder, "repaired")))
        row["rms"] = row["rms"] / plain["dev_rms"] if plain else None
        row["moved"] = moved(folder)
    return row


def judge(program, folder, name):
    done = subprocess.run([program, str(folder / f"{name}.msh"), str(folder / "model.brep"),
                           "--json"], capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def judged(found):
    return {"elements": found["tets"], "invalid": found["tet_invalid"],
            "folded": found["tri_folded_vs_cad"], "distortion": found["min_J_over_maxJ"],
            "rms": found["dev_rms"]}


def moved(folder):
    """Corner vertices that the optimiser left elsewhere than plain curving has them."""
    before, after = (corners(folder / f"{name}.msh") for name in ("plain", "repaired"))
    near = 1e-9 * max(map(abs, (x for point in before.values() for x in point)))
    return sum(max(abs(x - y) for x, y in zip(before[tag], point)) > near
               for tag, point in after.items() if tag in before)


def corners(path):
    """Nodes of a Gmsh 4.1 text file that are corners of tetrahedra, by tag."""
    lines = iter(path.read_text(encoding="utf-8").splitlines())
    nodes, used = {}, set()
    for line in lines:
        if line == "$Nodes":
            for _ in range(int(next(lines).split()[0])):
                count = int(next(lines).split()[3])
                tags = [int(next(lines)) for _ in range(count)]
                nodes.update((tag, [float(x) for x in next(lines).split()]) for tag in tags)
        elif line == "$Elements":
            for _ in range(int(next(lines).split()[0])):
                dimension, _, _, count = map(int, next(lines).split())
                for _ in range(count):
                    element = next(lines).split()
                    used.update(map(int, element[1:5]) if dimension == 3 else ())
    return {tag: nodes[tag] for tag in used}


def measure(name, shape, arguments, with_gmsh):
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        shape.exportBrep(str(folder / "model.brep"))
        row = {"model": name, "ours": ours(shape, arguments.order, folder)}
        if arguments.judge:
            found = judged(judge(arguments.judge, folder, "ours"))
            row["ours"].update({k: v for k, v in found.items() if k != "rms"})
        if with_gmsh:
            row["gmsh"] = gmsh(arguments, folder, row["ours"]["elements"])
    return row


def figures(row):
    def one(key, pattern):
        return format(row[key], pattern) if row.get(key) is not None else "-"

    return f"{one('elements', '6d'):>6} {one('invalid', 'd'):>4} {one('folded', 'd'):>4} " \
           f"{one('moved', 'd'):>5} {one('distortion', '.3f'):>6} {one('rms', '.3f'):>6}"


def line(row):
    text = f"{row['model']:<10} {row['ours']['seconds']:6.2f} {figures(row['ours'])}"
    if "gmsh" not in row:
        return text
    if "failed" in row["gmsh"]:
        return f"{text} | {row['gmsh']['failed']}"
    return f"{text} | {row['gmsh']['seconds']:6.2f} ({row['gmsh']['straight']:5.2f}) " \
           f"{figures(row['gmsh'])}"


def sums(rows):
    """Of the models that both finished."""
    both = [row for row in rows if "seconds" in row.get("gmsh", {})]
    result = {}
    for name, chosen in (("all", both), ("without " + LARGE,
                                         [r for r in both if r["model"] != LARGE])):
        own = sum(row["ours"]["seconds"] for row in chosen)
        other = sum(row["gmsh"]["seconds"] for row in chosen)
        straight = sum(row["gmsh"]["straight"] for row in chosen)
        if own > 0:
            result[name] = {"models": len(chosen), "ours": own, "gmsh": other,
                            "straight": straight, "times": other / own}
            print(f"{name}: {len(chosen)} models, ours {own:.2f} s, Gmsh {other:.2f} s "
                  f"({straight:.2f} s for its straight meshes): {other / own:.2f} times ours")
    return result


def work(arguments):
    import curve_models

    with_gmsh = inside_freecad.has_module(arguments.python, "gmsh")
    if not with_gmsh:
        print(f"Gmsh is skipped: {arguments.python} has no module gmsh (package python3-gmsh)")
    heading = "  tets  inv fold moved  minI    rms"
    print(f"{'order ' + str(arguments.order):<10}    CPU {heading}"
          f"{' |    CPU (mesh)   ' + heading if with_gmsh else ''}")
    rows, skipped = [], []
    start = time.monotonic()
    for name in fnmatch.filter(curve_models.MODELS, arguments.only):
        shape = curve_models.load(name, Path(arguments.data))
        if shape is None:
            print(f"{name:<10} skipped: its file is not in {arguments.data}/cad")
            skipped.append(name)
            continue
        rows.append(measure(name, shape, arguments, with_gmsh))
        print(line(rows[-1]), flush=True)
    own = sum(row["ours"]["seconds"] for row in rows if row["model"] != LARGE)
    print(f"ours without {LARGE}: {own:.2f} s")
    return {"order": arguments.order, "rows": rows, "skipped": skipped, "sums": sums(rows),
            "wall_seconds": time.monotonic() - start}


inside_freecad.start(__file__, parser(), work)
