#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of docs/measurements/tuning.md, of what benchmarks/tuning/tuning.py wrote.

    benchmarks/tuning/tuning_table.py out/refine.json [out/optimise.json ...]

Each file is one stage, named as the file is. Constants without any effect are listed below the table.
"""

import json
import sys
from pathlib import Path

FACTORS = ("0.5", "2.0")


def cell(row):
    """One setting in words."""
    if row is None:
        return "not measured"
    if not row["differing"]:
        return "no difference"
    parts = [f"{row['differing']} differ", f"triangles {row['triangles_percent']:+.1f} %"]
    for name, text in (("unforced", "exempt"), ("missed", "missed parts"), ("far", "far parts"),
                       ("crossings", "crossing parts"), ("errors", "errors"), ("faults", "faults"),
                       ("invalid", "invalid elements"), ("below", "angles below"), ("failed", "failures")):
        if row.get(name):
            parts.append(f"{text} {row[name]:+d}")
    return ", ".join(parts)


def table(path):
    """The table of one stage, and the constants without effect."""
    rows = json.loads(path.read_text(encoding="utf-8"))["rows"]
    names = list(dict.fromkeys(key.split("*")[0] for key in rows))
    lines, without = [], []
    for name in names:
        cells = [cell(rows.get(f"{name}*{factor}")) for factor in FACTORS]
        if set(cells) == {"no difference"}:
            without.append(f"`{name}`")
        else:
            lines.append(f"| `{name}` | {cells[0]} | {cells[1]} |")
    head = ["| constant | at half | at double |", "|---|---|---|"] if lines else []
    return [f"### {path.stem}", "", *head, *lines, "", "Without effect: " + ", ".join(without) + "." if without else ""]


for file in sys.argv[1:]:
    print(*table(Path(file)), "", sep="\n")
