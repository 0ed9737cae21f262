#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Assemblies meshed with and without `imprint`: what contacts cost, and whether the meshes stay good.

    python3 benchmarks/corpus_runs/parts_sources.py bring CLONES PARTS
    /usr/bin/python3 benchmarks/triangulate/contacts.py PARTS --share measure

Takes the files of one share of benchmarks/corpus_runs/parts_sources.tsv with 2 to --solids solids. Each part is meshed twice in a process
of its own, at 25 degrees and 0.002 of its size.
"""

import csv
import sys
from collections import Counter
from pathlib import Path
from statistics import median

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad

READ = {".step", ".stp", ".brep", ".brp", ".iges", ".igs"}


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("parts", help="folder of parts_sources.py bring")
    result.add_argument("--share", choices=("develop", "measure"), default="develop")
    result.add_argument("--solids", type=int, default=60, help="at most")
    result.add_argument("--bytes", type=int, default=3_000_000, help="of a file, at most")
    result.add_argument("--seconds", type=int, default=60, help="of the processor for a part")
    return result


def files_of(share, folder):
    """The files of the share that are there, in the order of their digests."""
    with open(Path(__file__).with_name("parts_sources.tsv"), encoding="utf-8") as stream:
        digests = {row["digest"] for row in csv.DictReader(stream, delimiter="\t") if row["share"] == share}
    return sorted(path for path in folder.iterdir() if path.stem in digests and path.suffix.lower() in READ)


def summary(mesh):
    report = mesh.report
    forced = sum(reason.forced for _, reason in report.exempt_reasons)
    return {"triangles": report.triangles, "closed": report.closed, "manifold": report.manifold,
            "crossings": report.self_intersections, "overlaps": report.overlaps, "forced": forced,
            "missed": len(report.exempt) - forced, "cpu_seconds": report.cpu_seconds,
            "far": report.max_chord_height > report.chord_height_asked,
            "contacts": len(report.contacts), "area": sum(area for *_, area in report.contacts),
            "left": sum("are not joined where they touch" in str(note) for note in report.notes)}


def both(path, solids):
    """The summaries of one part; nothing where it has another number of solids."""
    import MeshQuality as mq
    import Part

    shape = Part.read(str(path))
    if not 2 <= len(shape.Solids) <= solids:
        return []
    found = [len(shape.Solids)]
    for imprint in (False, True):
        try:
            found.append(summary(mq.triangulate(shape, chord_height_relative=0.002, imprint=imprint)))
        except mq.Error as error:
            found.append({"error": str(error)})
    return found


def work(arguments):
    from child import outcome_in_child

    rows, ends = {}, Counter()
    for path in files_of(arguments.share, Path(arguments.parts)):
        if path.stat().st_size > arguments.bytes:
            continue
        found, why = outcome_in_child(lambda path=path: both(path, arguments.solids), arguments.seconds)
        if found is None:
            ends[why] += 1
            print(path.stem[:8], why, flush=True)
        elif found:
            rows[path.stem] = found
            print(path.stem[:8], *found, flush=True)
    report(rows, ends)
    return {"rows": rows, "ends": ends}


def report(rows, ends):
    """Prints the table."""
    met = [(alone, joined) for _, alone, joined in rows.values() if "error" not in alone and "error" not in joined]
    touching = [pair for pair in met if pair[1]["contacts"]]
    print(f"\n{len(rows)} assemblies; ended otherwise (of all files): {dict(ends)}")
    print(f"{sum('error' in alone for _, alone, _ in rows.values())} errors without imprint, "
          f"{sum('error' in joined for *_, joined in rows.values())} with it")
    print(f"{len(touching)} with contacts, {sum(joined['contacts'] for _, joined in touching)} pairs of solids; in "
          f"{sum(joined['left'] for _, joined in met)} assemblies some solids are left as they are")
    for title, good in (("closed", lambda r: r["closed"]), ("manifold", lambda r: r["manifold"]),
                        ("free of crossings", lambda r: not r["crossings"]), ("distance kept", lambda r: not r["far"]),
                        ("angle kept or forced", lambda r: not r["missed"])):
        print(f"{title:22} {sum(good(alone) for alone, _ in touching):4} without, "
              f"{sum(good(joined) for _, joined in touching):4} with imprint")
    for title, name in (("triangles", "triangles"), ("CPU time", "cpu_seconds")):
        ratios = [joined[name] / alone[name] for alone, joined in touching]
        print(f"{title:22} {median(ratios):.2f} times as much with imprint, at most {max(ratios):.1f} (of those with contacts)"
              if ratios else f"{title}: -")


inside_freecad.start(__file__, parser(), work)
