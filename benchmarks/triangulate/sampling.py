#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sampling methods against `refine`: parts, equal chord heights, parameters, growth.

    /usr/bin/python3 benchmarks/triangulate/sampling.py [--most 1000000]

parts       tests/parts in the manner of Ruiz et al.: polished and raw meshes.
chords      every method at the chord height that the raw star mesh has, so that the measured chord
            heights are equal.
parameters  one surface in other parameters: the speed along a parameter line varies by the factor
            squared.
connectivity  the samples joined by fronts and in the parameters, regular and warped ones.
growth      processor time (the median of three runs) and peak memory against the number of
            vertices, on a torus.
Seconds are those of the processor.
"""

import math
import sys
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad

PARTS = ("bearing", "helix", "crank", "support")
METHODS = ("refine", "star", "sprinkle")
SAMPLING = METHODS[1:]
WARPS = ((1.0, 1.0), (8.0, 1.0), (1.0, 0.1), (20.0, 20.0), (0.02, 30.0), (30.0, 30.0))
REPEATS = 3


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--most", type=float, default=1e5, help="vertices of the last growth step")
    result.add_argument("--only", choices=("parts", "chords", "parameters", "connectivity",
                                           "growth"))
    return result


def mesh(shape, **options):
    """One row of a table."""
    import MeshQuality as mq

    reset_peak_memory()
    before, start = peak_memory(), time.process_time()
    report = mq.triangulate(shape, **options).report
    seconds = time.process_time() - start
    return {
        "method": options.get("method", "refine"), "polish": options.get("polish", True),
        "triangles": report.triangles, "vertices": report.vertices, "seconds": round(seconds, 3),
        "megabytes": round(peak_memory() - before, 1), "queries": report.queries,
        "good": report.closed and report.oriented and report.manifold, "euler": report.euler,
        "min_angle": report.min_angle, "mean_min_angle": report.mean_min_angle,
        "below_30": sum(report.angle_histogram[:30]) / report.triangles,
        "chord_height": report.max_chord_height, "exempt": len(report.exempt),
        "fallback": report.fallback, "histogram": list(report.angle_histogram),
        "area": report.area,
    }


def reset_peak_memory():
    with open("/proc/self/clear_refs", "w", encoding="ascii") as stream:
        stream.write("5")


def peak_memory():
    """The largest resident memory since the last reset, MB."""
    with open("/proc/self/status", encoding="ascii") as stream:
        return next(int(line.split()[1]) for line in stream if line.startswith("VmHWM")) / 1024


def show(name, row):
    print(f"{name:<22} {row['method']:<9} {'polished' if row['polish'] else 'raw':<9} "
          f"{row['triangles']:9,} {row['min_angle']:6.1f} {row['mean_min_angle']:6.1f} "
          f"{100 * row['below_30']:6.1f} {row['chord_height']:10.5f} {row['seconds']:8.2f} "
          f"{row['megabytes']:8.0f} {len(row['fallback']):4}{'' if row['good'] else ' OPEN'}",
          flush=True)


def head(title):
    print(f"\n{title:<32} {'':9} {'triangles':>9} {'min':>6} {'mean':>6} {'<30 %':>6} "
          f"{'chord mm':>10} {'seconds':>8} {'MB':>8} {'fell':>4}")


def compare_parts():
    import parts

    head("parts, chord height 0.001 L")
    rows = {}
    for name in PARTS:
        shape = parts.ALL[name]()
        rows[name] = [mesh(shape, method="refine", chord_height_relative=0.001)]
        rows[name] += [mesh(shape, method=method, polish=polish, chord_height_relative=0.001)
                       for method in SAMPLING for polish in (True, False)]
        for row in rows[name]:
            show(name, row)
    return rows


def compare_chords():
    """Raw samples have a chord height of their own; the others are asked for that one."""
    import parts

    head("equal chord heights")
    rows = {}
    for name in PARTS:
        shape = parts.ALL[name]()
        raw = mesh(shape, method="star", polish=False, chord_height_relative=0.001)
        rows[name] = [raw] + [mesh(shape, method=method, chord_height=raw["chord_height"])
                              for method in METHODS]
        for row in rows[name]:
            show(name, row)
    return rows


def compare_parameters():
    import parts

    head("parameters of one surface")
    rows = {}
    for in_u, in_v in WARPS:
        shape = parts.warped_face(in_u, in_v)
        rows[f"{in_u} {in_v}"] = [mesh(shape, method=method, polish=polish, chord_height=0.001)
                                  for method in SAMPLING for polish in (False, True)]
        for row in rows[f"{in_u} {in_v}"]:
            show(f"{in_u:g} x {in_v:g}", row)
    return rows


def compare_connectivity():
    import parts

    head("connectivity")
    rows = {}
    for warp in (WARPS[0], WARPS[-1]):
        shape = parts.warped_face(*warp)
        for joined in ("pseudo-delaunay", "parametric"):
            name = f"{warp[0]:g} x {warp[1]:g} {joined[:10]}"
            rows[name] = [mesh(shape, method="star", polish=polish, chord_height=0.01,
                               connectivity=joined) for polish in (False, True)]
            for row in rows[name]:
                show(name, row)
    return rows


def grow(most):
    import Part

    print(f"\n{'growth, torus, raw':<20} {'vertices':>10} {'cpu s':>8} {'us/vertex':>10} {'MB':>8} "
          f"{'kB/vertex':>10} {'fell':>4}")
    torus = Part.makeTorus(10.0, 3.0)
    reset_peak_memory()
    before = peak_memory()
    rows = []
    count = 1e3
    while count <= most:
        spacing = math.sqrt(torus.Area / (0.9 * count))
        for method in SAMPLING:
            rows.append(growth_step(torus, before, method=method, polish=False, max_edge=spacing,
                                    max_triangles=10_000_000))
        count *= 10
    return rows


def growth_step(shape, before, **options):
    """A row of the table; memory counts from `before`, as what is freed need not be given back."""
    runs = sorted((mesh(shape, **options) for _ in range(REPEATS)), key=lambda run: run["seconds"])
    row = runs[REPEATS // 2]
    row["megabytes"] = round(peak_memory() - before, 1)
    count = row["vertices"]
    print(f"{row['method']:<20} {count:10,} {row['seconds']:8.3f} "
          f"{1e6 * row['seconds'] / count:10.1f} {row['megabytes']:8.0f} "
          f"{1024 * row['megabytes'] / count:10.2f} {len(row['fallback']):4}", flush=True)
    return row


def work(arguments):
    """All tables on stdout."""
    tables = {"parts": compare_parts, "chords": compare_chords, "parameters": compare_parameters,
              "connectivity": compare_connectivity, "growth": lambda: grow(arguments.most)}
    return {name: table() for name, table in tables.items() if arguments.only in (None, name)}


inside_freecad.start(__file__, parser(), work)
