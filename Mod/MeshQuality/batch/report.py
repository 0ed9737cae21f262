# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html: what came of a batch, for people; one file that needs no other."""

import html
import os
import re
from collections import Counter, defaultdict
from dataclasses import dataclass

from ..version import __version__
from . import charts

NAME = "report.html"
WORST = 10

_STATES = {
    "done": "meshed", "input": "input that cannot be worked on", "failed": "failed",
    "crash": "crashed", "timeout": "over the time limit", "memory": "over the memory limit",
    "lost": "workers lost",
}


@dataclass(frozen=True)
class Figure:
    """A figure of parts: how it is got from an entry, drawn, and which end of it is bad."""

    title: str
    value: object
    log: bool = False
    limits: tuple = None
    worst: str = "high"


def _of(name):
    return lambda entry: entry["report"].get(name)


def _relative(name):
    """A length by the longest side of the part's box."""
    def value(entry):
        box, length = entry["report"].get("box"), entry["report"].get(name)
        if box is None or length is None:
            return None
        side = max(high - low for low, high in zip(*box))
        return length / side if side > 0 else None

    return value


_COMMON = (
    Figure("seconds", lambda entry: entry["seconds"], log=True),
    Figure("memory, MiB", lambda entry: entry["peak_mib"] or None),
)
_FLAT = (
    Figure("smallest angle, degrees", _of("min_angle"), limits=(0.0, 60.0), worst="low"),
    Figure("smallest angle without exempted triangles, degrees", _of("min_angle_unexempted"),
           limits=(0.0, 60.0), worst="low"),
    Figure("exempted triangles", _of("exempt_count"), log=True),
    Figure("distance to the shape by its size", _relative("max_chord_height"), log=True),
    Figure("triangles", _of("triangles"), log=True),
    *_COMMON,
)
_CURVED = (
    Figure("invalid elements", _of("invalid"), log=True),
    Figure("smallest scaled Jacobian", _of("min_scaled_jacobian"), limits=(0.0, 1.0), worst="low"),
    Figure("largest deviation, mm", _of("max_deviation"), log=True),
    Figure("elements", _of("elements"), log=True),
    *_COMMON,
)


def figures_of(command):
    return _CURVED if command == "curve" else _FLAT


class Findings:
    """What the report shows, gathered from the entries one after the other."""

    def __init__(self, command):
        self.figures = figures_of(command)
        self.states = Counter()
        self.causes = defaultdict(list)
        self.values = [[] for _ in self.figures]
        self.faulty = []
        self.seconds = 0.0

    def add(self, entry):
        self.states[entry["state"]] += 1
        self.seconds += entry.get("seconds", 0.0)
        if entry["state"] != "done":
            self.causes[(entry["state"], kind_of(entry["error"]))].append(
                (entry["part"], entry["error"]))
            return
        for figure, values in zip(self.figures, self.values):
            value = figure.value(entry)
            if value is not None:
                values.append((value, entry["part"], entry["output"]))
        report = entry["report"]
        wrong = [name for name in ("closed", "oriented", "manifold") if report.get(name) is False]
        if wrong:
            self.faulty.append((entry["part"], "not " + ", not ".join(wrong)))


def kind_of(error):
    """The error without what differs from part to part: numbers, and names in quotes."""
    return re.sub(r"\d+(\.\d+)?(e-?\d+)?", "#", re.sub(r"'[^']*'", "'...'", error))


def write(plan, ledger):
    """Writes the report."""
    findings = Findings(plan.command)
    for entry in ledger.entries():
        findings.add(entry)
    path = plan.out / NAME
    ready = path.with_name(f".{NAME}.part")
    ready.write_text(page(plan, findings), encoding="utf-8", errors="replace")
    os.replace(ready, path)


def page(plan, findings):
    """The report as HTML text."""
    total = sum(findings.states.values())
    title = f"{plan.command} of {plan.folder.name}: {findings.states['done']} of {total} parts"
    options = ", ".join(f"{name} = {value}" for name, value in plan.options.items()
                        if value is not None)
    return "\n".join([
        "<!DOCTYPE html>", '<html lang="en"><head><meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width">',
        f"<title>{_text(title)}</title><style>{_STYLE}</style></head><body>",
        f"<h1>{_text(title)}</h1>",
        f"<p>MeshQuality {__version__}. {_text(options)}. {findings.seconds:.0f} s of work in all."
        "</p>",
        _states(findings.states, total), _charts(plan, findings), _causes(findings.causes),
        _worst(findings), _faulty(findings.faulty), "</body></html>\n"])


def _states(states, total):
    parts = [f'<span class="{state}" style="flex:{states[state]}" title="{_STATES[state]}: '
             f'{states[state]}"></span>' for state in _STATES if states[state]]
    rows = [[_STATES[state], states[state], f"{100 * states[state] / total:.2f} %"]
            for state in _STATES if states[state]]
    return f'<div class="bar">{"".join(parts)}</div>' + _table(["", "parts", "of all"], rows)


def _charts(plan, findings):
    drawn = []
    for figure, values in zip(findings.figures, findings.values):
        mark = plan.options.get("min_angle") if "angle," in figure.title else None
        drawn.append(charts.histogram([value for value, _, _ in values], figure.title, figure.log,
                                      figure.limits, mark))
    return f'<h2>All parts</h2><div class="charts">{"".join(drawn)}</div>'


def _causes(causes):
    if not causes:
        return ""
    rows = []
    for (state, _), parts in sorted(causes.items(), key=lambda item: (-len(item[1]), item[0])):
        names = ", ".join(name for name, _ in sorted(parts)[:5])
        rows.append([_STATES[state], len(parts), min(parts)[1], names])
    return "<h2>Parts that failed, by cause</h2>" + _table(
        ["state", "parts", "the first says", "such as"], rows)


def _worst(findings):
    tables = []
    for figure, values in zip(findings.figures, findings.values):
        worst = sorted(values, key=lambda row: (-row[0] if figure.worst == "high" else row[0], row[1]))
        worst = [row for row in worst[:WORST] if row[0] > 0 or figure.worst == "low"]
        if worst:
            rows = [[f"{value:.6g}", _link(part, output)] for value, part, output in worst]
            end = "highest" if figure.worst == "high" else "lowest"
            tables.append(f"<div><h3>{_text(figure.title)}, {end}</h3>"
                          + _table(["", "part"], rows) + "</div>")
    return f'<h2>Worst parts</h2><div class="charts">{"".join(tables)}</div>'


def _faulty(faulty):
    if not faulty:
        return ""
    more = f"<p>... and {len(faulty) - 100} more: see parts.csv.</p>" if len(faulty) > 100 else ""
    return (f"<h2>Meshes that are not closed, not oriented or not manifold ({len(faulty)})</h2>"
            "<p>Open shells and loose faces have open meshes.</p>"
            + _table(["part", ""], sorted(faulty)[:100]) + more)


class _Markup(str):
    """Text that is HTML already."""


def _link(part, output):
    if not output:
        return part
    target = "/".join(_quoted(name) for name in output.split("/"))
    return _Markup(f'<a href="{html.escape(target)}">{_text(part)}</a>')


def _quoted(name):
    from urllib.parse import quote

    return quote(name, errors="surrogateescape")


def _table(head, rows):
    lines = ["<table><tr>" + "".join(f"<th>{_text(cell)}</th>" for cell in head) + "</tr>"]
    for row in rows:
        cells = (cell if isinstance(cell, _Markup) else _text(cell) for cell in row)
        lines.append("<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>")
    return "\n".join(lines) + "</table>"


def _text(value):
    return html.escape(str(value))


_STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; margin: 2em auto; max-width: 80em; padding: 0 1em;
       color: #222; background: #fff; }
h1 { font-size: 1.5em; } h2 { font-size: 1.2em; margin-top: 2em; } h3 { font-size: 1em; }
table { border-collapse: collapse; } td, th { text-align: left; padding: .15em 1em .15em 0;
       border-bottom: 1px solid #ddd; vertical-align: top; overflow-wrap: anywhere; }
.bar { display: flex; height: 1.2em; gap: 2px; margin: 1em 0; } .bar span { min-width: 3px; }
.done { background: #3a7d44; } .input { background: #999; } .failed { background: #d98e04; }
.crash { background: #b3261e; } .timeout { background: #7b4fa3; } .memory { background: #2b6cb0; }
.lost { background: #000; }
.charts { display: grid; grid-template-columns: repeat(auto-fill, minmax(24em, 1fr)); gap: 1.5em; }
.chart { width: 100%; } .chart rect { fill: #3b6ea5; } .chart line { stroke: #555; }
.chart .mark { stroke: #b3261e; stroke-dasharray: 4 3; }
.chart text { font-size: 11px; fill: #444; text-anchor: middle; }
.chart .y { text-anchor: end; } .chart .title { font-size: 12px; font-weight: 600; }
"""
