# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html: what came of a batch, for people; one file that needs no other."""

import html
import urllib.parse
from array import array
from collections import Counter
from dataclasses import dataclass

from .. import charts, html_page
from ..html_page import Markup, table_of, text_of
from ..phrases import MET, NOT_MET
from ..version import __version__
from . import table
from .atomic_file import replacing

NAME = "report.html"
_OPEN = "not closed"
WORST, SUCH_AS, MOST_ROWS = 10, 5, 100

_STATES = {
    "done": "meshed", "input": "unusable input", "failed": "failed",
    "crash": "crashed", "timeout": "over the time limit", "memory": "over the memory limit",
    "lost": "worker lost", "disk": "disk full", "todo": "not done yet",
}


@dataclass(frozen=True)
class Figure:
    """A figure of parts: how it is got from an entry, how it is drawn, which end of it is bad, and
    which option sets a bound: parts on the good side of that bound are not among the worst.
    """

    title: str
    value: object
    log: bool = False
    limits: tuple = None
    worst: str = "high"
    asked: str = None


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
    Figure("smallest angle, degrees", _of("min_angle"), limits=(0.0, 60.0), worst="low",
           asked="min_angle"),
    Figure("smallest angle without exempt triangles, degrees", _of("min_angle_unexempted"),
           limits=(0.0, 60.0), worst="low", asked="min_angle"),
    Figure("exempt triangles", _of("exempt_count"), log=True),
    Figure("max. deviation relative to size", _relative("max_chord_height"), log=True),
    Figure("triangles", _of("triangles"), log=True),
    *_COMMON,
)
_CURVED = (
    Figure("invalid elements", _of("invalid"), log=True),
    Figure("smallest scaled Jacobian", _of("min_scaled_jacobian"), limits=(0.0, 1.0), worst="low"),
    Figure("max. deviation, mm", _of("max_deviation"), log=True),
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
        self.causes = {}  # (state, kind) -> [number of parts, first error, first parts]
        self.values = [array("d") for _ in self.figures]
        self.worst = [[] for _ in self.figures]
        self.faulty, self.faulty_count = [], 0
        self.missed, self.missed_count, self.met_count = [], 0, 0
        self.seconds = 0.0
        self.pages = []

    def add(self, entry):
        self.states[entry["state"]] += 1
        self.seconds += entry.get("seconds", 0.0)
        if entry["state"] != "done":
            cause = self.causes.setdefault((entry["state"], entry.get("kind", entry["error"])),
                                           [0, entry["error"], []])
            cause[0] += 1
            if cause[0] <= SUCH_AS:
                cause[2].append(entry["part"])
            return
        for i, figure in enumerate(self.figures):
            value = figure.value(entry)
            if value is not None:
                self.values[i].append(value)
                self._keep_worst(i, (-value if figure.worst == "high" else value, entry["part"],
                                     entry["output"]))
        if isinstance(entry.get("page"), str):
            self.pages.append((entry["part"], entry["page"]))
        report = entry["report"]
        self.met_count += report.get("verdict") == MET
        if report.get("verdict") == NOT_MET:
            self.missed_count += 1
            if len(self.missed) < MOST_ROWS:
                text = " ".join(finding["text"] for finding in report["findings"])
                self.missed.append((entry["part"], entry["output"], text))
        wrong = [name for name in ("closed", "oriented", "manifold") if report.get(name) is False]
        if wrong:
            self.faulty_count += 1
            if len(self.faulty) < MOST_ROWS:
                self.faulty.append((entry["part"], "not " + ", not ".join(wrong)))

    def _keep_worst(self, i, row):
        """Keeps the rows with the lowest first values."""
        rows = self.worst[i]
        rows.append(row)
        if len(rows) >= 50 * WORST:
            rows.sort(key=lambda row: row[:2])
            del rows[WORST:]


def can_show(entry, command):
    """Whether the entry has what table and report take from it, each value of its type."""
    if entry["state"] not in _STATES or entry["state"] == "todo":
        return False
    if not isinstance(entry.get("seconds", 0.0), (int, float)):
        return False
    if entry["state"] != "done":
        return isinstance(entry.get("error"), str) and isinstance(entry.get("kind", ""), str)
    report = entry.get("report")
    try:
        values = [figure.value(entry) for figure in figures_of(command)]
        texts = [finding["text"] for finding in report.get("findings", [])]
        table.row_of(entry)
    except (AttributeError, KeyError, TypeError, ValueError, IndexError):
        return False
    return all(value is None or isinstance(value, (int, float)) for value in values) \
        and all(isinstance(text, str) for text in texts)


def write(plan, ledger, total):
    """Writes the report of the parts that are done, of `total` in all."""
    findings = Findings(plan.command)
    for entry in ledger.entries():
        findings.add(entry)
    findings.states["todo"] = total - sum(findings.states.values())
    with replacing(plan.out / NAME, encoding="utf-8", errors="replace") as stream:
        stream.write(page(plan, findings))


def page(plan, findings):
    """The report as HTML text."""
    total = sum(findings.states.values())
    title = f"{plan.command} of {plan.folder.name}: {findings.states['done']} of {total} parts"
    options = ", ".join(f"{name} = {value}" for name, value in plan.options.items()
                        if value is not None)
    return "\n".join([
        "<!DOCTYPE html>", '<html lang="en"><head><meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width">',
        f"<title>{text_of(title)}</title><style>{_STYLE}</style></head><body>",
        f"<h1>{text_of(title)}</h1>",
        f"<p>MeshQuality {__version__}. {text_of(options)}. {findings.seconds:.0f} s of computation in total."
        "</p>",
        _states(findings.states, total), _charts(plan, findings), _causes(findings.causes),
        _missed(findings), _worst(plan, findings), _faulty(findings), _pages(findings), "</body></html>\n"])


def _states(states, total):
    parts = [f'<span class="{state}" style="flex:{states[state]}" title="{_STATES[state]}: '
             f'{states[state]}"></span>' for state in _STATES if states[state]]
    rows = [[_STATES[state], states[state], f"{100 * states[state] / total:.2f} %"]
            for state in _STATES if states[state]]
    return f'<div class="bar">{"".join(parts)}</div>' + table_of(["", "parts", "share"], rows)


def _charts(plan, findings):
    drawn = []
    for figure, values in zip(findings.figures, findings.values):
        drawn.append(charts.histogram(values, figure.title, figure.log, figure.limits,
                                      plan.options.get(figure.asked)))
    return f'<h2>All parts</h2><div class="charts">{"".join(drawn)}</div>'


def _causes(causes):
    if not causes:
        return ""
    rows = [[_STATES[state], count, error, ", ".join(names)]
            for (state, _), (count, error, names)
            in sorted(causes.items(), key=lambda item: (-item[1][0], item[0]))]
    return "<h2>Parts that failed, by cause</h2>" + table_of(
        ["state", "parts", "first error", "examples"], rows[:MOST_ROWS]) + _more(len(rows))


def _more(count):
    return f"<p>... and {count - MOST_ROWS} more: see parts.csv.</p>" if count > MOST_ROWS else ""


def _worst(plan, findings):
    tables = []
    for figure, worst in zip(findings.figures, findings.worst):
        high, asked = figure.worst == "high", plan.options.get(figure.asked)
        worst = [(-value if high else value, part, output)
                 for value, part, output in sorted(worst, key=lambda row: row[:2])[:WORST]]
        rows = [[f"{value:.6g}", _link(part, output)] for value, part, output in worst
                if (value > 0 if high else asked is None or value < asked)]
        if rows:
            tables.append(f"<div><h3>{text_of(figure.title)}, {'highest' if high else 'lowest'}</h3>"
                          + table_of(["", "part"], rows) + "</div>")
    return f'<h2>Worst parts</h2><div class="charts">{"".join(tables)}</div>'


def _missed(findings):
    done = findings.states["done"]
    if not done:
        return ""
    head = f"<h2>Requested limits: met by {findings.met_count} of {done} meshes</h2>"
    if not findings.missed:
        return head
    rows = [[_link(part, output), text] for part, output, text in sorted(findings.missed)]
    return head + table_of(["part", "not met"], rows) + _more(findings.missed_count)


def _faulty(findings):
    if not findings.faulty:
        return ""
    return (f"<h2>Meshes that are not closed, not oriented or not manifold "
            f"({findings.faulty_count})</h2><p>Shells and sets of loose faces that are open have open meshes.</p>"
            + table_of(["part", ""], sorted(findings.faulty, key=lambda row: (row[1] == _OPEN, row)))
            + _more(findings.faulty_count))


def _pages(findings):
    """Links to the pages of all parts."""
    if not findings.pages:
        return ""
    rows = "".join(f"<li>{_link(part, page)}</li>" for part, page in sorted(findings.pages))
    return f'<h2>Reports of parts</h2><ul class="pages">{rows}</ul>'


def _link(part, output):
    if not output:
        return part
    target = urllib.parse.quote(output, errors="surrogateescape")
    return Markup(f'<a href="{html.escape(target)}">{text_of(part)}</a>')


_STYLE = html_page.STYLE + """
.bar { display: flex; height: 1.2em; gap: 2px; margin: 1em 0; } .bar span { min-width: 3px; }
.done { background: #3a7d44; } .input { background: #999; } .failed { background: #d98e04; }
.crash { background: #b3261e; } .timeout { background: #7b4fa3; } .memory { background: #2b6cb0; }
.pages { columns: 24em; } .lost { background: #000; } .disk { background: #666; } .todo { background: #e5e5e5; }
"""
