#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Booleans of many pairs of meshes that nobody has tidied: what is unsound, refused, slow or lost.

    /usr/bin/python3 benchmarks/boolean/boolean_pairs.py [--peer PROGRAM] [--pairs 200] [--share measure]
    /usr/bin/python3 benchmarks/boolean/boolean_pairs.py --only near-12 [--keep FOLDER]

The pairs are those of pair_meshes.py. Each of the four operations runs in a child process of its own, with a limit of
its processor time; a hang is one that takes ten times that on the clock. A result is sound if an exact verification
finds it closed, manifold and oriented, without contacts, and if its report agrees; --judge PROGRAM has a program that
knows nothing of MeshQuality look at those that are not (`PROGRAM check FILE.off`).

With --peer PROGRAM (see boolean_peers.py) another system does the same work right after. Ratios are MeshQuality's CPU
seconds as multiples of the peer's, where both have a result; a peer says milliseconds, so none counts as less than one.

Volumes: A + B is (A U B) + (A n B), and A - B is A - (A n B), within 1e-6 of A + B, where both operands are sound;
operands that are inside out count as turned. The last column counts symmetric differences that are not
(A U B) - (A n B): their two halves meet along all intersection curves, and are led apart there.

Each operation is one line of JSON in the file --lines. For the share for measuring, sums are printed only.
"""

import itertools
import json
import multiprocessing
import os
import re
import statistics
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import boolean_peers
import inside_freecad
from child import outcome_in_child

PEERS_HAVE = ("union", "intersection", "difference")
OPERATIONS = (*PEERS_HAVE, "symmetric_difference")
CLASSES = "random,near,offset,files"
SYMMETRIC = "symmetric difference"
GIBIBYTES = 8
VOLUMES_AGREE = 1e-6
PEER_RESOLUTION = 1e-3  # seconds
SLOW = 3.0
HEAD = f"{'class':<8} {'pairs':>5} {'results':>7} {'sound':>6} {'unsound':>7} {'errors':>6} {'limit':>5} {'hang':>5} " \
       f"{'crash':>5} {'ratios':>6} {'median':>7} {'worst':>8} {'above 3':>7} {'volumes':>7} {'missed':>6} {'sym.':>4}"


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--data", default=str(inside_freecad.data_folder()), help="folder with mesh/ and boolean/")
    result.add_argument("--classes", default=CLASSES, help=f"default: {CLASSES}")
    result.add_argument("--share", default="develop", choices=("develop", "measure"), help="even or odd pairs")
    result.add_argument("--first", type=int, default=0, help="pairs of the share to pass over")
    result.add_argument("--pairs", type=int, default=40, help="pairs to run")
    result.add_argument("--seed", type=int, default=1, help="of all random numbers")
    result.add_argument("--only", metavar="PAIR", action="append", help="this pair, such as near-12")
    result.add_argument("--operation", choices=OPERATIONS, action="append", help="this operation only")
    result.add_argument("--tolerance", type=float, help="mm, as for mq.boolean")
    result.add_argument("--limit", type=int, default=60, help="CPU seconds of an operation")
    result.add_argument("--jobs", type=int, default=1, help="pairs at a time")
    result.add_argument("--peer", action="append", metavar="PROGRAM", default=[], help="another system's Booleans")
    result.add_argument("--judge", metavar="PROGRAM", help="looks at results that are not sound")
    result.add_argument("--keep", metavar="FOLDER", help="keeps operands and results as OFF files")
    result.add_argument("--lines", default=str(inside_freecad.ROOT / "out" / "boolean_pairs.jsonl"), help="JSON lines")
    return result


def inspected(mesh):
    """Number of triangles, volume, and faults of an operand by an exact verification."""
    from MeshQuality.compat import extension
    from MeshQuality.core.sources.convert import surface_of_arrays
    from pair_meshes import volume

    found = extension().verify(surface_of_arrays(extension(), *mesh, measured=False))
    return {"triangles": len(mesh[1]), "volume": volume(*mesh), "faults": present(found)}


def present(counts):
    return {kind: count for kind, count in counts.items() if count}


def warm_up():
    """Runs a small Boolean. In a child it copies the pages that it shares with its parent, which takes 0.03 s that are
    not of the next Boolean.
    """
    import MeshQuality as mq
    from made_meshes import sphere

    mq.boolean(sphere(2), sphere(2, centre=(0.5, 0.4, 0.3)), "union")


def boolean_row(a, b, operation, path, arguments):
    """What mq.boolean does, verified exactly; the result is written where it is to be kept or is not sound."""
    import MeshQuality as mq
    from MeshQuality.compat import extension
    from pair_meshes import volume

    warm_up()
    wall, cpu = time.perf_counter(), time.process_time()
    try:
        result = mq.boolean(a, b, operation, tolerance=arguments.tolerance)
    except mq.Error as error:
        return {"outcome": "error", "cpu_seconds": time.process_time() - cpu,
                "message": f"{type(error).__name__}: {error}"}
    row = {"cpu_seconds": time.process_time() - cpu, "wall_seconds": time.perf_counter() - wall}
    report = result.report
    for field in ("triangles", "error_bound", "tolerance_asked", "crossing_pairs", "faults_left", "repaired", "notes",
                  "seconds"):
        row[field] = getattr(report, field)
    row["faults"] = present(extension().verify(result._surface))
    row["volume"] = volume(result.vertices, result.triangles)
    says_sound = report.closed and report.oriented and report.manifold and not report.faults_left
    sound = not row["faults"] and (says_sound or not len(result.triangles))
    row["outcome"] = "sound" if sound else "unsound"
    if arguments.keep or not sound:
        boolean_peers.write_off(path, result.vertices, result.triangles)
    return row


def peer_row(peer, operation, operands):
    from pair_meshes import volume

    seconds, result = peer.run(operation, operands)
    if seconds is None:
        return {"peer": peer.name, "failed": result}
    return {"peer": peer.name, "cpu_seconds": seconds, "triangles": len(result[1]), "volume": volume(*result)}


def ratio_to(row, peer):
    """Our seconds as a multiple of the peer's; None where either has no sound result."""
    if row["outcome"] != "sound" or "failed" in peer:
        return None
    return row["cpu_seconds"] / max(peer["cpu_seconds"], PEER_RESOLUTION)


def run_pair(name, pairs, arguments, folder):
    """The rows of a pair, an operation each."""
    a, b, what = pairs.make(name)
    found, _ = outcome_in_child(lambda: [inspected(a), inspected(b)], arguments.limit, GIBIBYTES)
    peers = [boolean_peers.Peer(program, folder) for program in arguments.peer]
    paths = [folder / f"{name}_{side}.off" for side in "ab"]
    if peers or arguments.keep:
        for path, mesh in zip(paths, (a, b)):
            boolean_peers.write_off(path, *mesh)
    for operation in arguments.operation or OPERATIONS:
        path = folder / f"{name}_{operation}.off"
        row, cause = outcome_in_child(
            lambda operation=operation, path=path: boolean_row(a, b, operation, path, arguments),
            arguments.limit, GIBIBYTES)
        row = {"pair": name, "what": what, "operation": operation, "operands": found,
               **(row or {"outcome": cause.partition(":")[0], "message": cause})}
        if row["outcome"] == "unsound" and arguments.judge:
            row["judged"] = judged(arguments.judge, path)
        row["peers"] = [peer_row(peer, operation, map(str, paths)) for peer in peers if operation in PEERS_HAVE]
        for peer in row["peers"]:
            peer["ratio"] = ratio_to(row, peer)
        yield row


def judged(program, path):
    try:
        done = subprocess.run([program, "check", str(path)], capture_output=True, text=True, timeout=120)
    except subprocess.TimeoutExpired:
        return "no answer in 120 s"
    return done.stdout.strip() or f"ended with {done.returncode}"


def run_pairs(names, arguments):
    """Runs pairs one after the other; a line each operation."""
    from pair_meshes import Pairs

    warm_up()  # the children find all modules loaded
    pairs = Pairs(arguments.data, arguments.seed)
    for name in names:
        with tempfile.TemporaryDirectory() as scratch:
            folder = Path(arguments.keep or scratch).resolve()
            folder.mkdir(parents=True, exist_ok=True)
            for row in run_pair(name, pairs, arguments, folder):
                with open(arguments.lines, "a", encoding="utf-8") as stream:
                    stream.write(json.dumps(row) + "\n")
                if arguments.share == "develop":
                    print(row_line(row), flush=True)


def row_line(row):
    seconds = f"{row['cpu_seconds']:8.3f}" if "cpu_seconds" in row else f"{'':8}"
    peers = " ".join(f"{p['peer']} {p['failed']}" if "failed" in p else
                     f"{p['peer']} {p['cpu_seconds']:.3f}" + (f" x {p['ratio']:.2f}" if p["ratio"] else "")
                     for p in row["peers"])
    said = row.get("message") or ", ".join(f"{n} x {kind}" for kind, n in row["faults"].items())
    return f"{row['pair']:<11} {row['operation']:<20} {row['outcome']:<10} {seconds} {row.get('triangles', ''):>8} " \
           f"{peers}  {said}  [{row['what']}] {row.get('judged', '')}".rstrip()


def identities(rows):
    """{identity: gap as a fraction of A + B} of the rows of one pair, of those that can be told."""
    operands = rows[0]["operands"]
    if operands is None or any(operand["faults"] for operand in operands):
        return {}
    a, b = (abs(operand["volume"]) for operand in operands)
    found = {row["operation"]: row["volume"] for row in rows if row["outcome"] == "sound"}
    gaps = {}
    if "union" in found and "intersection" in found:
        gaps["union + intersection"] = a + b - found["union"] - found["intersection"]
    if "difference" in found and "intersection" in found:
        gaps["difference"] = found["difference"] - (a - found["intersection"])
    if {"symmetric_difference", "union", "intersection"} <= found.keys():
        gaps[SYMMETRIC] = found["symmetric_difference"] - (found["union"] - found["intersection"])
    return {name: abs(gap) / (a + b) for name, gap in gaps.items()}


def by_pair(rows):
    return [list(group) for _, group in itertools.groupby(rows, key=lambda row: row["pair"])]


def summary(label, rows):
    """The figures of a line of the table."""
    outcomes = Counter(row["outcome"] for row in rows)
    ratios = [row["peers"][0]["ratio"] for row in rows if row["peers"] and row["peers"][0]["ratio"] is not None]
    gaps = [item for group in by_pair(rows) for item in identities(group).items()]
    missed = Counter(name for name, gap in gaps if gap > VOLUMES_AGREE)
    return {"class": label, "pairs": len(by_pair(rows)), "results": len(rows), "sound": outcomes["sound"],
            "unsound": outcomes["unsound"], "errors": outcomes["error"], "time limit": outcomes["time limit"],
            "hang": outcomes["hang"], "crash": outcomes["crash"], "ratios": len(ratios),
            "median": statistics.median(ratios or [0.0]), "worst": max(ratios, default=0.0),
            "above": sum(ratio > SLOW for ratio in ratios), "volumes": sum(name != SYMMETRIC for name, _ in gaps),
            "missed": missed.total() - missed[SYMMETRIC], "symmetric missed": missed[SYMMETRIC]}


def summary_line(f):
    return f"{f['class']:<8} {f['pairs']:5} {f['results']:7} {f['sound']:6} {f['unsound']:7} {f['errors']:6} " \
           f"{f['time limit']:5} {f['hang']:5} {f['crash']:5} {f['ratios']:6} {f['median']:7.2f} {f['worst']:8.2f} " \
           f"{f['above']:7} {f['volumes']:7} {f['missed']:6} {f['symmetric missed']:4}"


def plain(message):
    """A message without its numbers, so that equal ones count together."""
    return re.sub(r"[-+]?\d[\d.,]*(?:e[-+]?\d+)?", "#", message)


def print_tables(rows, share):
    rows = sorted(rows, key=lambda row: (row["pair"].split("-")[0], int(row["pair"].split("-")[1])))
    table = [summary(kind, [row for row in rows if row["pair"].startswith(f"{kind}-")])
             for kind in CLASSES.split(",")]
    table = [line for line in table if line["pairs"]] + [summary("all", rows)]
    print(HEAD, *map(summary_line, table), sep="\n")
    refused = Counter(peer["failed"] for row in rows for peer in row["peers"] if "failed" in peer)
    messages = Counter(plain(row["message"]) for row in rows if row["outcome"] == "error")
    for title, counts in (("errors", messages), ("peers without a result", refused)):
        print(f"{title}:", *(f"  {count} x {text}" for text, count in counts.most_common()), sep="\n")
    if share == "develop":
        print("worst ratios:", *map(row_line, worst(rows, 15)), sep="\n  ")
        for group in by_pair(rows):
            for name, gap in identities(group).items():
                if gap > VOLUMES_AGREE:
                    print(f"volumes: {group[0]['pair']} {name} {gap:.1e} [{group[0]['what']}]")
    return {"table": table, "errors": messages, "refused": refused}


def worst(rows, count):
    rated = [row for row in rows if row["peers"] and row["peers"][0]["ratio"] is not None]
    return sorted(rated, key=lambda row: -row["peers"][0]["ratio"])[:count]


def chosen(arguments):
    """The names of the pairs to run."""
    from pair_meshes import CLASSES, SHARES, names

    if not arguments.only:
        classes = arguments.classes.split(",")
        return list(itertools.islice(names(classes, arguments.share), arguments.first,
                                     arguments.first + arguments.pairs))
    for name in arguments.only:
        kind, _, number = name.partition("-")
        if kind not in CLASSES or SHARES[int(number) % 2] != arguments.share:
            raise SystemExit(f"{name} is no pair of the share {arguments.share!r}")
    return arguments.only


def work(arguments):
    names, lines = chosen(arguments), Path(arguments.lines)
    lines.parent.mkdir(parents=True, exist_ok=True)
    lines.write_text("", encoding="utf-8")
    context = multiprocessing.get_context("fork")
    workers = [context.Process(target=run_pairs, args=(names[k::arguments.jobs], arguments))
               for k in range(arguments.jobs)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    if any(worker.exitcode for worker in workers):
        raise RuntimeError("a process that ran pairs failed")
    rows = [json.loads(line) for line in lines.read_text(encoding="utf-8").splitlines()]
    results = print_tables(rows, arguments.share)
    print(f"load {os.getloadavg()[0]:.1f}; lines in {lines}")
    return {"arguments": vars(arguments) | {"out": str(arguments.out)}, "load": os.getloadavg(), **results}


inside_freecad.start(__file__, parser(), work)
