# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page that peers.py writes: a table a task between marks, and before it where a rival is ahead."""

import statistics
import textwrap
from pathlib import Path

OURS = "MeshQuality"
AHEAD = 0.02  # by no less than this fraction


def cell(value, written):
    if value is None:
        return "-"
    if isinstance(value, bool):
        return "yes" if value else "no"
    return format(value, written)


def table(columns, rows, reasons=True):
    """The Markdown lines of rows, in the order of cases; a row without figures says why."""
    heads = ["part", "by", *(column.heading for column in columns)] + ["what went wrong"] * reasons
    lines = [f"| {' | '.join(heads)} |", f"|---|---|{'---:|' * len(columns)}{'---|' * reasons}"]
    for before, row in zip([None, *rows], rows):
        name = "" if before and before["case"] == row["case"] else row["case"]
        cells = [name, row["mesher"], *(cell(row.get(c.key), c.written) for c in columns)] + [row.get("failed", "")] * reasons
        lines.append(f"| {' | '.join(cells)} |")
    return lines


def figures(columns, rows):
    """A few columns of the rows of the first case, for the front page."""
    chosen = [column for column in columns if column.key in ("triangles", "distance", "forced", "rate")]
    return "\n".join(table(chosen, [row for row in rows if row["case"] == rows[0]["case"]], reasons=False))


def ahead(columns, rows, clean):
    """Bullets: each rival and figure with which it is better than ours on some part, and how often cleanly."""
    ours = {row["case"]: row for row in rows if row["mesher"] == OURS}
    found = []
    for mesher in dict.fromkeys(row["mesher"] for row in rows if row["mesher"] != OURS):
        for column in (column for column in columns if column.better):
            both = [(row, ours[row["case"]]) for row in rows if row["mesher"] == mesher and row["case"] in ours
                    and None not in (row.get(column.key), ours[row["case"]].get(column.key))]
            better = [(row, own) for row, own in both if is_better(row[column.key], own[column.key], column.better)]
            if better:
                found.append(f"- {mesher}: {column.heading}, on {len(better)} of {len(both)}{times(better, column)}{faulty(better, clean)}.")
    return found


def is_better(theirs, own, better):
    return better * (theirs - own) > AHEAD * max(abs(theirs), abs(own))


def times(better, column):
    """How many times better in the median, where no figure is 0."""
    pairs = [(row[column.key], own[column.key]) for row, own in better]
    if any(min(pair) <= 0 for pair in pairs):
        return ""
    found = statistics.median((theirs / own) ** column.better for theirs, own in pairs)
    return f", {found:.{0 if found >= 10 else 2}f} times in the median"


def faulty(better, clean):
    count = sum(not clean(row) for row, _ in better)
    return f", {count} of them with faults" if count else ""


def section(task, rows, versions, missing, command, judged):
    """The text of a task's table, without columns in which nobody has a figure."""
    columns = [column for column in task.columns if any(row.get(column.key) is not None for row in rows)]
    bullets = ahead(columns, rows, task.clean)
    first = ["Ahead of MeshQuality:", "", *bullets] if bullets else ["No rival is ahead in any figure of this table."]
    named = [f"{name} {version}" for name, version in versions.items()]
    judge = "" if judged else " No judge was given: what only it finds is not measured."
    lines = [f"    {command}", "", *first, "", *textwrap.wrap(task.said, 140), ""]
    lines += [*textwrap.wrap(f"{task.about or how_often(rows)}{judge}", 140), ""]
    lines += [*table(columns, rows), "", f"Versions: {', '.join(named)}."]
    lines += [f"Left out: {name} ({reason})." for name, reason in missing.items()]
    return "\n".join(lines)


def how_often(rows):
    """What the seconds of rows are medians of."""
    runs = sorted({row["runs"] for row in rows if row.get("runs")})
    cases = len({row["case"] for row in rows})
    parts = f"{cases} {'part' if cases == 1 else 'parts'}"
    if runs in ([], [1]):
        return f"{parts}; one run of each, of one call."
    return f"{parts}; medians of {' or '.join(map(str, runs))} runs in turn, of one call each; the spread is that of CPU s, largest to smallest."


def marks(name):
    return f"<!-- {name}: written by benchmarks/peers/peers.py -->\n", f"\n<!-- end of {name} -->"


def put(page, name, text):
    """Writes a task's text between its marks on the page; raises ValueError where they are not."""
    page, (first, last) = Path(page), marks(name)
    before = page.read_text(encoding="utf-8")
    if first not in before or last not in before:
        raise ValueError(f"{page.name} has no marks of {name}: {first.strip()} and {last.strip()}")
    head, rest = before.split(first, 1)
    page.write_text(f"{head}{first}{text}{last}{rest.split(last, 1)[1]}", encoding="utf-8")
