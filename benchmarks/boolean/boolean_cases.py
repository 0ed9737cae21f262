#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Booleans of large meshes, of bodies in contact, and of dirty meshes: time, and what came of it.

    /usr/bin/python3 benchmarks/boolean/boolean_cases.py [--only 'T*'] [-n 3] [--method uniform]

The meshes are those of $MESHQUALITY_DATA/boolean (default: ../shared/data/boolean beside the
repository), binary PLY files packed with gzip. Seconds are the processor's (user and system, all
threads) of mq.boolean from NumPy arrays to the measured result, the best of n runs; they count
neither the start of FreeCAD nor the reading of files. The result is then verified exactly: edges,
fans, degenerate triangles, coincident vertices, and pairs of triangles that cross or touch.

With --peer PROGRAM (see boolean_peers.py) another system does the same work in turn with
MeshQuality. Its line shows its seconds, MeshQuality's seconds as a part of them, its triangles and
faults, and the largest distance of either surface's corners and centres from the other surface.
"""

import fnmatch
import sys
import tempfile
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import boolean_peers
import inside_freecad
from boolean_models import CASES, read

HEAD = f"{'case':<26} {'CPU s':>7} {'wall s':>7} {'aim':>5} {'triangles':>10} {'new':>7} " \
       f"{'edges':>5} {'degen.':>6} {'cross':>6} {'volume':>14} {'bound':>8}  faults"


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--data", default=str(inside_freecad.data_folder()),
                        help="folder with boolean/")
    result.add_argument("--only", action="append", metavar="PATTERN", help="names of cases")
    result.add_argument("-n", type=int, default=3, dest="runs", help="runs of each case")
    result.add_argument("--method", default="default", help="as for mq.boolean")
    result.add_argument("--resolution", type=int, default=512, help="as for mq.boolean")
    result.add_argument("--tolerance", type=float, help="mm, as for mq.boolean")
    result.add_argument("--peer", action="append", metavar="PROGRAM", default=[],
                        help="a program that runs another system's Booleans")
    return result


class Best:
    """The run that took least of the processor."""

    def __init__(self):
        self.cpu, self.wall, self.result = None, None, None

    def take(self, cpu, wall, result):
        if self.cpu is None or cpu < self.cpu:
            self.cpu, self.wall, self.result = cpu, wall, result


def run_ours(best, call):
    wall, cpu = time.perf_counter(), time.process_time()
    result = call()
    best.take(time.process_time() - cpu, time.perf_counter() - wall, result)


def run_peer(best, peer, operation, operands):
    seconds, result = peer.run(operation, operands)
    if seconds is None:
        best.result = best.result or result
    else:
        best.take(seconds, None, result)


def measure(name, arguments, meshes, peers):
    """One row of the result: figures, and the faults as sentences."""
    import MeshQuality as mq

    operation, a, b, volume, near, seconds, triangles = CASES[name]
    row = {"case": name, "operation": operation, "operands": [a, b], "aim_seconds": seconds}
    ours, theirs = Best(), [Best() for _ in peers]
    try:
        for _ in range(arguments.runs):
            run_ours(ours, lambda: mq.boolean(
                meshes[a], meshes[b], operation, resolution=arguments.resolution,
                tolerance=arguments.tolerance, method=arguments.method))
            for best, peer in zip(theirs, peers):
                run_peer(best, peer, operation, [peer.operand(n, meshes[n]) for n in (a, b)])
    except mq.Error as error:
        return {**row, "faults": [f"{type(error).__name__}: {error}"]}
    row["cpu_seconds"], row["wall_seconds"] = ours.cpu, ours.wall
    describe(row, ours.result)
    if volume is not None and abs(row["volume"] - volume) > near * volume:
        row["faults"].append(f"volume is not {volume:.10g} within {near:g}")
    if triangles is not None and row["triangles"] > triangles:
        row["faults"].append(f"more than {triangles} triangles")
    row["peers"] = [beside(ours, best, peer) for best, peer in zip(theirs, peers)]
    return row


def describe(row, result):
    from MeshQuality.compat import extension

    for field in ("triangles", "retained", "reconstructed", "closed", "oriented", "manifold",
                  "components", "volume", "error_bound", "faults_left", "repaired", "notes",
                  "seconds"):
        row[field] = getattr(result.report, field)
    row["verified"] = extension().verify(result._surface)
    row["faults"] = [f"{count} x {kind}" for kind, count in row["verified"].items() if count]


def beside(ours, best, peer):
    """A peer's figures, and the distance of the two results."""
    from MeshQuality.compat import extension
    from MeshQuality.core.sources.convert import surface_of_arrays

    if best.cpu is None:
        return {"peer": peer.name, "failed": best.result}
    theirs = surface_of_arrays(extension(), *best.result, measured=False)
    verified = extension().verify(theirs)
    row = {"peer": peer.name, "cpu_seconds": best.cpu, "triangles": len(best.result[1]),
           "verified": verified, "part": ours.cpu / best.cpu if best.cpu else None}
    if len(best.result[1]) and len(ours.result.triangles):
        row["distance"] = [extension().surface_distance(ours.result._surface, theirs)[1],
                           extension().surface_distance(theirs, ours.result._surface)[1]]
    return row


def table_line(row):
    if "triangles" not in row:
        return f"{row['case']:<26} {'; '.join(row['faults'])}"
    found = row["verified"]
    contacts = found["crossing pair of triangles"] + found["touching pair of triangles"]
    edges = found["open edge"] + found["non-manifold edge"] + found["pinched vertex"]
    aim = f"{row['aim_seconds']:.1f}" if row["aim_seconds"] else ""
    return f"{row['case']:<26} {row['cpu_seconds']:7.3f} {row['wall_seconds']:7.3f} {aim:>5} " \
           f"{row['triangles']:10} {row['reconstructed']:7} {edges:5} " \
           f"{found['degenerate triangle']:6} {contacts:6} {row['volume']:14.10g} " \
           f"{row['error_bound']:8.1e}  {'; '.join(row['faults'])}"


def peer_line(row):
    if "failed" in row:
        return f"    {row['peer']:<22} {row['failed']}"
    faults = "; ".join(f"{count} x {kind}" for kind, count in row["verified"].items() if count)
    part = f"x {row['part']:.2f}" if row["part"] else ""
    there, back = row.get("distance", (0.0, 0.0))
    return f"    {row['peer']:<22} {row['cpu_seconds']:7.3f} {part:>13} {row['triangles']:10}" \
           f"  distance {there:.1e} {back:.1e}  {faults}"


def work(arguments):
    """Runs the cases with the peers' files in a scratch folder."""
    with tempfile.TemporaryDirectory() as folder:
        return run_cases(arguments, [boolean_peers.Peer(p, folder) for p in arguments.peer])


def run_cases(arguments, peers):
    """Runs the cases whose meshes are there, and says which are not."""
    patterns = arguments.only or ["*"]
    folder, meshes, rows, skipped = Path(arguments.data) / "boolean", {}, [], []
    print(HEAD)
    for name, (_, a, b, *_) in CASES.items():
        if not any(fnmatch.fnmatch(name, pattern) for pattern in patterns):
            continue
        missing = [n for n in (a, b) if not (folder / f"{n}.ply.gz").exists()]
        if missing:
            print(f"{name:<26} skipped: there is no {', '.join(missing)} in {folder}")
            skipped.append(name)
            continue
        for n in (a, b):
            if n not in meshes:
                meshes[n] = read(folder / f"{n}.ply.gz")
        rows.append(measure(name, arguments, meshes, peers))
        print(*[table_line(rows[-1]), *map(peer_line, rows[-1].get("peers", []))], sep="\n",
              flush=True)
    faulty = sum(bool(row["faults"]) for row in rows)
    print(f"{len(rows)} cases, {faulty} with faults, {len(skipped)} skipped")
    return {"method": arguments.method, "resolution": arguments.resolution,
            "tolerance": arguments.tolerance, "runs": arguments.runs, "cases": rows,
            "skipped": skipped}


inside_freecad.start(__file__, parser(), work)
