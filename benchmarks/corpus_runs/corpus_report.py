# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the results of benchmarks/corpus_runs/corpus mean: faults, the table, the summary."""

from collections import Counter

COLUMNS = [
    ("file", 40, "file"), ("valid", 5, "valid"), ("faces", 5, "faces"),
    ("triangles", 9, "triangles"), ("angle", 6, "min_angle"), ("kept", 6, "min_angle_unexempted"),
    ("exempt", 6, "exempt"), ("c/o/m", 5, None), ("chord", 9, "max_chord_height"),
    ("seconds", 7, "seconds"), ("tri/s", 8, None), ("state", 0, None),
]
JUDGED = (
    "min_angle", "min_angle_unexcused", "closed", "manifold", "oriented", "euler", "components",
    "self_intersections", "folds", "flipped_normals", "faces_over_2pct", "chord_max_L",
    "chord_max_at", "reverse_max_L", "hausdorff_L", "brep_vertices_missed", "judge_seconds",
)
TOLERANCE = 1e-6


def expect_closed(result, row):
    """Whether the mesh has to be closed; row: the part's line of index.csv, or nothing."""
    if not row:
        return result.get("closed_shells", False)
    return row.get("open_shells", "0") in ("", "0") and "loose-faces" not in row.get("flags", "")


def faults(result, row, options):
    """Sentences on what is wrong with one part's result; empty when all is well."""
    if result["state"] != "ok":
        refused = result["state"] == "error" and not result.get("valid", True)
        return [] if refused else [result.get("error", result["state"])]
    found = []
    if expect_closed(result, row) and not result["closed"]:
        found.append("not closed")
    if not result["oriented"]:
        found.append("not oriented")
    if not result["manifold"] and "multi-solid" not in (row or {}).get("flags", ""):
        found.append("not manifold")
    if result["valid"] and result["closed"] and result["euler"] != result["brep_euler"]:
        found.append(f"Euler number {result['euler']} instead of {result['brep_euler']}")
    kept = result.get("min_angle_unexempted")
    if kept is not None and kept < options["min_angle"] - TOLERANCE:
        found.append(f"angle {kept:.2f} not exempted")
    if result.get("complete") is False:
        found.append("incomplete")
    return found + _judged_faults(result, row, options)


def _judged_faults(result, row, options):
    judge = result.get("judge")
    if not judge:
        return []
    if "error" in judge:
        return [f"judge: {judge['error']}"]
    found = []
    for name in ("closed", "oriented", "manifold"):
        if judge[name] != result[name]:
            found.append(f"judge: {name} is {judge[name]}, the report says {result[name]}")
    single = "multi-solid" not in (row or {}).get("flags", "")
    if result["valid"] and single and judge["self_intersections"]:
        found.append(f"judge: {judge['self_intersections']} self-intersections")
    if result["valid"] and judge["min_angle_unexcused"] < options["min_angle"] - TOLERANCE:
        found.append(f"judge: angle {judge['min_angle_unexcused']:.2f} not excused")
    if result["valid"] and judge["faces_over_2pct"]:
        found.append(f"judge: {judge['faces_over_2pct']} faces far off")
    relative = options.get("chord_height_relative")
    if relative and judge["chord_max_L"] > relative * 1.05:
        found.append(f"judge: chord height {judge['chord_max_L']:.2e} of L")
    if found and result.get("met"):
        found.append("yet called met")
    return found


def table_head():
    return "  ".join(f"{title:<{width}}" for title, width, _ in COLUMNS)


def table_line(result):
    """One line of the table, its last column the state, the faults and the judge's findings."""
    cells = []
    for title, width, key in COLUMNS:
        if title == "c/o/m":
            text = "".join(_flag(result.get(k)) for k in ("closed", "oriented", "manifold"))
        elif title == "tri/s":
            text = _rate(result)
        elif title == "state":
            text = _state(result)
        else:
            text = _text(result.get(key))
        cells.append(f"{text[:width] if width else text:<{width}}")
    return "  ".join(cells).rstrip()


def _flag(value):
    return {True: "+", False: "-"}.get(value, " ")


def _rate(result):
    seconds, triangles = result.get("seconds"), result.get("triangles")
    return f"{triangles / max(seconds, 1e-6):.0f}" if seconds and triangles else ""


def _text(value):
    if value is None:
        return ""
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def _state(result):
    parts = [result["state"]]
    if result["state"] != "ok":
        parts = [result.get("error", result["state"])]
    elif result["faults"]:
        parts = ["; ".join(result["faults"])]
    if result.get("causes"):
        parts.append(f"[{result['causes'][0][0]}]")
    judge = result.get("judge") or {}
    if "hausdorff_L" in judge:
        parts.append(
            f"judge {judge['min_angle']:.1f}/{judge['min_angle_unexcused']:.1f}"
            f" si {judge['self_intersections']} hausdorff {judge['hausdorff_L']:.1e}"
        )
    return " ".join(parts)


def summarise(results):
    """Counts, totals and the failing parts by name."""
    ok = [r for r in results if r["state"] == "ok"]
    seconds = sum(r["seconds"] for r in ok)
    triangles = sum(r["triangles"] for r in ok)
    return {
        "parts": len(results),
        "good": sum(not r["faults"] for r in results),
        "states": dict(sorted(Counter(r["state"] for r in results).items())),
        "refused_invalid": sum(r["state"] == "error" and not r["faults"] for r in results),
        "with_exemptions": sum(bool(r["exempt"]) for r in ok),
        "exempt_triangles": sum(r["exempt"] for r in ok),
        "triangles": triangles,
        "seconds": seconds,
        "triangles_per_second": triangles / seconds if seconds else 0.0,
        "failing": {r["file"]: r["faults"] for r in results if r["faults"]},
    }


def summary_text(summary):
    """The summary for people; the last line counts."""
    lines = [
        "",
        f"states: {', '.join(f'{count} {state}' for state, count in summary['states'].items())}",
        f"{summary['refused_invalid']} invalid shapes refused with a message",
        f"{summary['with_exemptions']} parts with exemptions, "
        f"{summary['exempt_triangles']} triangles exempted",
        f"{summary['triangles']} triangles in {summary['seconds']:.1f} s: "
        f"{summary['triangles_per_second']:.0f} a second",
    ]
    if summary["failing"]:
        lines.append("failing:")
        lines += [f"  {name}: {'; '.join(why)}" for name, why in summary["failing"].items()]
    lines.append(f"{summary['good']} of {summary['parts']} parts good")
    return "\n".join(lines)


def comparison_text(results):
    """Methods side by side; results: those of every method, by method, in the same order of parts.

    Triangles, angles and processor seconds are those of the parts that every method meshed.
    """
    common = [parts for parts in zip(*results.values()) if all(p["state"] == "ok" for p in parts)]
    lines = ["", f"{len(common)} parts that every method meshed:",
             f"{'method':<10}{'good':>10}{'triangles':>11}{'mean':>7}{'least':>7}{'<30 %':>7}"
             f"{'cpu s':>8}{'most':>7}{'faces':>8}{'fell':>6}"]
    for k, (method, parts) in enumerate(results.items()):
        lines.append(_method_line(method, parts, [row[k] for row in common],
                                  [row[max(k - 1, 0)] for row in common]))
    lines += ["mean: of the smallest angles of all triangles; least: median over the parts of the",
              "smallest angle; most: cpu seconds of a part in those of the line above (0.1 s at least)"]
    return "\n".join(lines + _fallback_lines(results))


def _method_line(method, parts, common, above):
    triangles = sum(p["triangles"] for p in common)
    mean = sum(p["mean_min_angle"] * p["triangles"] for p in common) / max(triangles, 1)
    least = sorted(p["min_angle"] for p in common)[len(common) // 2]
    below = 100 * sum(p["below_30"] for p in common) / max(triangles, 1)
    most = max(p["cpu_seconds"] / max(other["cpu_seconds"], 0.1)
               for p, other in zip(common, above))
    good = f"{sum(not p['faults'] for p in parts)} of {len(parts)}"
    counts = [sum(sum(p["fallbacks"][key].values()) for p in parts if "fallbacks" in p)
              for key in ("surfaces", "fallen")]
    return (f"{method:<10}{good:>10}{triangles:>11}{mean:>7.1f}{least:>7.1f}{below:>7.1f}"
            f"{sum(p['cpu_seconds'] for p in common):>8.1f}{most:>7.1f}{counts[0]:>8}{counts[1]:>6}")


def _fallback_lines(results):
    """Faces by surface, how many there are and how many fell back by every method."""
    totals = {}
    for method, parts in results.items():
        for part in parts:
            for key in ("surfaces", "fallen"):
                totals.setdefault((method, key), Counter()).update(
                    part.get("fallbacks", {}).get(key, {}))
    sampling = [method for method in results if totals[method, "fallen"]]
    if not sampling:
        return []
    counts = totals[sampling[0], "surfaces"]
    lines = ["", f"{'surface':<24}{'faces':>8}" + "".join(f"{method:>12}" for method in sampling)]
    for surface, count in counts.most_common():
        fallen = "".join(f"{totals[method, 'fallen'][surface]:>12}" for method in sampling)
        lines.append(f"{surface:<24}{count:>8}{fallen}")
    return lines
