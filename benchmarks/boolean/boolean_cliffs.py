#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cost of a Boolean where such costs have fallen off: crossing pairs, needles, near copies.

    /usr/bin/python3 benchmarks/boolean/boolean_cliffs.py [--peer PROGRAM] [-n 3] [--picture docs/pictures/boolean_cliffs.png]

Unions of two spheres refined alike; of two cylinders whose sides are needles, turned against each other; and of a ball
and a copy with random displacements. Processor seconds of mq.boolean, the median of n runs, beside those of a peer (see
boolean_peers.py). Every result is verified exactly.
"""

import statistics
import sys
import tempfile
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import boolean_peers
import inside_freecad
import numpy as np
from made_meshes import needle_cylinder, sphere

CASES = ("crossing pairs", "needle angle, degrees", "displacement of the copy, fraction of the size")
HEAD = f"{'case':<46} {'at':>10} {'triangles':>10} {'pairs':>8} {'CPU s':>8} {'peer':>8} {'ratio':>6}  faults"


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--peer", metavar="PROGRAM", help="another system's Booleans")
    result.add_argument("-n", type=int, default=3, dest="runs", help="runs of each case")
    result.add_argument("--picture", metavar="FILE", help="a picture of the three curves")
    return result


def turned(mesh, seed):
    """The mesh turned by a random rotation, of single-precision numbers."""
    frame, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    frame *= np.sign(np.linalg.det(frame))
    return (mesh[0] @ frame.T).astype(np.float32), mesh[1].astype(np.int32)


def centred(mesh):
    return mesh[0] - mesh[0].mean(axis=0), mesh[1]


def pairs_of_operands():
    """(case, place on its axis or None, A, B)."""
    for level in range(3, 9):
        yield CASES[0], None, sphere(level), sphere(level, 0.9, (0.7, 0.1, 0.2))
    for sides in (16, 64, 256, 1024, 4096):
        needle = centred(needle_cylinder(sides))
        angle = np.degrees(np.arctan(2 * np.sin(np.pi / sides) / 2.0))
        yield CASES[1], float(angle), turned(needle, 1), turned(needle, 2)
    ball = sphere(6, 50.0)
    for step in 10.0 ** np.arange(-7, -1.5, 0.5):
        noise = np.random.default_rng(3).uniform(-100 * step, 100 * step, ball[0].shape)
        yield CASES[2], float(step), ball, ((ball[0] + noise).astype(np.float32), ball[1])


def measured(case, at, a, b, runs):
    """The figures of one union."""
    import MeshQuality as mq
    from MeshQuality.compat import extension

    seconds = []
    for _ in range(runs):
        start = time.process_time()
        result = mq.boolean(a, b, "union")
        seconds.append(time.process_time() - start)
    pairs = result.report.crossing_pairs
    return {"case": case, "at": pairs if at is None else at, "triangles": len(a[1]) + len(b[1]), "pairs": pairs,
            "seconds": statistics.median(seconds), "error_bound": result.report.error_bound,
            "faults": sum(extension().verify(result._surface).values())}


def peer_seconds(program, a, b, runs):
    """Seconds of the peer, the median, or None where it has no result."""
    with tempfile.TemporaryDirectory() as folder:
        peer = boolean_peers.Peer(program, folder)
        operands = [peer.operand(name, (np.asarray(mesh[0], float), mesh[1])) for name, mesh in zip("ab", (a, b))]
        seconds = [peer.run("union", operands)[0] for _ in range(runs)]
    return None if None in seconds else statistics.median(seconds)


def show(row):
    other = row.get("peer")
    beside = f"{other:8.3f} {row['seconds'] / max(other, 1e-3):6.2f}" if other is not None else f"{'-':>8} {'':6}"
    print(f"{row['case']:<46} {row['at']:10.3g} {row['triangles']:10} {row['pairs']:8} {row['seconds']:8.3f} {beside}"
          f"  {row['faults']}", flush=True)


def draw(rows, path, peer):
    """The three curves side by side."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, panels = pyplot.subplots(1, len(CASES), figsize=(11, 3.2), sharey=True)
    for panel, case in zip(panels, CASES):
        own = [row for row in rows if row["case"] == case]
        panel.loglog([row["at"] for row in own], [row["seconds"] for row in own], "o-", label="MeshQuality")
        peers = [row for row in own if row.get("peer") is not None]
        if peers:
            panel.loglog([row["at"] for row in peers], [row["peer"] for row in peers], "s--", label=peer)
        panel.set_xlabel(case)
        panel.grid(True, which="major", alpha=0.3)
    panels[0].set_ylabel("seconds of the processor")
    panels[0].legend()
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def work(arguments):
    print(HEAD)
    measured(CASES[0], None, sphere(2), sphere(2, 0.9, (0.7, 0.1, 0.2)), 1)  # modules are loaded by the first one
    rows = []
    for case, at, a, b in pairs_of_operands():
        row = measured(case, at, a, b, arguments.runs)
        if arguments.peer:
            row["peer"] = peer_seconds(arguments.peer, a, b, arguments.runs)
        rows.append(row)
        show(row)
    if arguments.picture:
        draw(rows, Path(arguments.picture), Path(arguments.peer or "").stem.removeprefix("drv_"))
    return {"runs": arguments.runs, "cases": rows, "status": int(any(row["faults"] for row in rows))}


inside_freecad.start(__file__, parser(), work)
