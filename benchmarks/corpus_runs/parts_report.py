# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run over many parts says, counted as the public tables of mesh generators count.

A figure is the judge's where the part was judged, else that of MeshQuality's own report.
"""

import re
from collections import Counter, defaultdict
from statistics import median

# The judge takes the largest side of another box than MeshQuality does.
DISTANCE_SLACK = 1.05
ANGLE_SLACK = 1e-6
MANY_TIMES = 20
FREE_FORM = {"BSplineSurface", "BezierSurface", "SurfaceOfExtrusion", "SurfaceOfRevolution",
             "OffsetSurface", "other"}
CLASSES = ("analytic solid", "free-form solid", "assembly", "loose faces", "not read")


def class_of(result):
    """The class of a part by its B-rep."""
    if not result.get("faces"):
        return "not read"
    if bodies(result) > 1:
        return "assembly"
    if not result["closed_shells"]:
        return "loose faces"
    return "free-form solid" if FREE_FORM & set(result["surfaces"]) else "analytic solid"


def judged(result):
    """The judge's figures, or nothing."""
    judge = result.get("judge") or {}
    return {} if "error" in judge else judge


def angle(result, bound):
    """kept, forced (by the part itself), claimed (the judge does not agree that it is), missed."""
    least = judged(result).get("min_angle", result["min_angle"])
    if least >= bound - ANGLE_SLACK:
        return "kept"
    claimed = result["exempt_forced"] == result["exempt"] and \
        result["min_angle_unexempted"] >= bound - ANGLE_SLACK
    if not judged(result):
        return "forced" if claimed else "missed"
    if judged(result)["min_angle_unexcused"] >= bound - ANGLE_SLACK:
        return "forced"
    return "claimed" if claimed else "missed"


def judge_is_far(judge, relative):
    """Whether the judge says that the mesh is farther from the part than requested."""
    return judge.get("chord_max_L", 0.0) > relative * DISTANCE_SLACK


def far_distances(result, options):
    """Which of the two distances is larger than requested, in words."""
    relative, judge = options.get("chord_height_relative"), judged(result)
    if not relative:
        return []
    if not judge:
        kept = result["max_chord_height"] <= result["chord_height_asked"] * DISTANCE_SLACK
        return [] if kept else ["mesh far from the part"]
    most = relative * DISTANCE_SLACK
    if judge_is_far(judge, relative):
        near = judge.get("farthest_place_mm")
        kept = near is not None and max(near, result["max_chord_height"]) <= \
            result["chord_height_asked"] * DISTANCE_SLACK
        if not kept:
            return ["mesh far from the part"]
    return ["part far from the mesh"] if judge["reverse_max_L"] > most else []


def bodies(result):
    """Solids, and shells that belong to none."""
    return result["solids"] + result["free_shells"]


def crossings(result):
    """Pairs of triangles of one body that cross."""
    own = max(result.get("self_intersections") or 0, 0)
    single = bodies(result) <= 1
    return max(own, (judged(result).get("self_intersections") or 0) if single else 0)


def ratio(result):
    """Triangles for each one that BRepMesh makes at the same distance; None: not known."""
    peer = (result.get("brepmesh") or {}).get("triangles")
    return result["triangles"] / peer if peer else None


def symptoms(result, options):
    """What is wrong with a part, each in the few words that parts of the same fault share."""
    if result["state"] != "ok":
        if result["state"] != "error":
            return [result["state"]]
        return ["error: " + re.sub(r"\d+(\.\d+)?", "#", result["error"])[:80]]
    found = []
    if result["closed_shells"] and not result["closed"]:
        found.append("not watertight")
    if not result["manifold"] and bodies(result) <= 1:
        found.append("not manifold")
    if not result["oriented"]:
        found.append("not oriented")
    of_angle = angle(result, options["min_angle"])
    if of_angle in ("missed", "claimed"):
        found.append(f"angle {of_angle}")
    found += far_distances(result, options)
    if crossings(result):
        found.append("crossings")
    if (ratio(result) or 0) > MANY_TIMES:
        found.append(f"more than {MANY_TIMES} times the triangles of BRepMesh")
    if result.get("complete") is False:
        found.append("incomplete")
    if "error" in (result.get("judge") or {}):
        found.append("not judged")
    return found


def counts(results, options):
    """The rows of the table for some parts: name and value."""
    ok = [r for r in results if r["state"] == "ok"]
    states = Counter(r["state"] for r in results)
    angles = Counter(angle(r, options["min_angle"]) for r in ok)
    closed = [r for r in ok if r["closed_shells"]]
    single = [r for r in ok if bodies(r) <= 1]
    ratios = [ratio(r) for r in ok if ratio(r)]
    peers = [r["brepmesh"]["cpu_seconds"] for r in ok if r.get("brepmesh")]
    seconds = [r["cpu_seconds"] for r in ok]
    return [
        ("parts", len(results)),
        ("meshed", len(ok)),
        ("error", states["error"]),
        ("time-out", states["timeout"]),
        ("crash", states["crash"]),
        ("watertight, of those with closed shells",
         share(sum(r["closed"] for r in closed), len(closed))),
        ("manifold, of those with one body",
         share(sum(r["manifold"] for r in single), len(single))),
        ("angle kept by every triangle", share(angles["kept"], len(ok))),
        ("angle forced by the part", share(angles["forced"], len(ok))),
        ("angle forced by the part, as only the report says", share(angles["claimed"], len(ok))),
        ("angle missed", share(angles["missed"], len(ok))),
        ("distance kept", share(sum(not far_distances(r, options) for r in ok), len(ok))),
        ("without crossings", share(sum(not crossings(r) for r in ok), len(ok))),
        ("with bodies that cross each other",
         share(sum((r["overlaps"] or 0) > 0 for r in ok), len(ok))),
        ("good in every respect",
         share(sum(not symptoms(r, options) for r in results), len(results))),
        ("judged", sum(bool(judged(r)) for r in ok)),
        ("called met", share(sum(bool(r.get("met")) for r in ok), len(ok))),
        ("called met, and refuted", refuted(ok, options)),
        ("triangles", sum(r["triangles"] for r in ok)),
        ("triangles for each of BRepMesh, median", f"{median(ratios):.2f}" if ratios else "-"),
        (f"parts with more than {MANY_TIMES} times its triangles",
         sum(r > MANY_TIMES for r in ratios)),
        ("CPU s of meshing", f"{sum(seconds):.1f}"),
        ("CPU s, median and most",
         f"{median(seconds):.2f}, {max(seconds):.1f}" if seconds else "-"),
        ("CPU s of BRepMesh", f"{sum(peers):.1f}"),
    ]


def refuted(results, options):
    """How many results that are called met are not good, and of what."""
    wrong = [found for r in results if r.get("met") and (found := [s for s in symptoms(r, options) if "times" not in s])]
    causes = Counter(symptom for found in wrong for symptom in found)
    return ", ".join([str(len(wrong)), *(f"{count} {cause}" for cause, count in sorted(causes.items()))])


def share(count, total):
    return f"{count} of {total} ({100 * count / total:.1f} %)" if total else "0 of 0"


def groups(results):
    """Parts whose shape OpenCASCADE calls valid, those it calls invalid, and those not read."""
    read = [r for r in results if r.get("faces")]
    return {
        "valid": [r for r in read if r["valid"]],
        "invalid": [r for r in read if not r["valid"]],
        "not read": [r for r in results if not r.get("faces")],
    }


def text(results, options, name_failing):
    """The table as Markdown; name_failing: the failing parts by symptom, too."""
    by_group = groups(results)
    tables = [counts(by_group[name], options) for name in ("valid", "invalid")]
    unread = Counter(symptoms(r, options)[0] for r in by_group["not read"])
    lines = [
        "",
        f"{len(results)} parts; not read: {len(by_group['not read'])}"
        + "".join(f"; {count} {what}" for what, count in sorted(unread.items())),
        "",
        "| | valid | invalid by OpenCASCADE's check |",
        "|---|---:|---:|",
        *(f"| {name} | {valid} | {invalid} |"
          for (name, valid), (_, invalid) in zip(*tables)),
        "",
        *_class_lines(by_group["valid"], options),
    ]
    return "\n".join(lines + (_failing_lines(by_group, options) if name_failing else []))


def _class_lines(valid, options):
    lines = ["| class | valid parts | good | angle missed |", "|---|---:|---:|---:|"]
    for name in CLASSES[:-1]:
        parts = [r for r in valid if class_of(r) == name]
        good = sum(not symptoms(r, options) for r in parts)
        missed = sum("angle missed" in symptoms(r, options) for r in parts)
        lines.append(f"| {name} | {len(parts)} | {good} | {missed} |")
    return lines


def _failing_lines(by_group, options):
    """The failing parts by symptom; a part stands under each of its symptoms."""
    lines = []
    for group, results in by_group.items():
        parts = defaultdict(list)
        for result in results:
            for symptom in symptoms(result, options):
                parts[symptom].append(result["file"][:8])
        lines += ["", f"failing, {group}:"] if parts else []
        lines += [f"  {symptom} ({len(names)}): {' '.join(sorted(names))}"
                  for symptom, names in sorted(parts.items())]
    return lines
