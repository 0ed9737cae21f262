# SPDX-License-Identifier: LGPL-2.1-or-later
"""A report as one page of HTML that needs no other file."""

import datetime
import html

import numpy as np

from ... import charts
from ... import report_phrases as words
from ...compat import versions
from ...html_page import STYLE, Markup, table_of
from ...phrases import Text
from ...version import __version__
from .. import colour_scale
from . import picture
from .content import MOST_PLACES, area_by_element

_BIG, _SMALL = (720, 480), (320, 240)
_MOST_FACES = 100
_AROUND, _LEAST_AROUND = 25.0, 0.08  # width of the picture of a place in sizes of its triangles, and least, of the part
_STOPS = 13
_COLOURS = {words.MET: "#3a7d44", words.NOT_MET: "#b3261e", words.NOT_DECIDED: "#d98e04", words.NO_LIMITS: "#555"}


def page_of(content, say=str):
    """The page as text; say(phrase) is a text of the table of phrases in the user's language."""
    def written(text):
        return html.escape(str(say(_phrase(text))))

    title = written(Text(words.TITLE, name=content.name))
    parts = ["<!DOCTYPE html>", '<html><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">',
             f"<title>{title}</title><style>{STYLE}{_STYLE}</style></head><body>", f"<h1>{title}</h1>",
             f'<p class="verdict" style="background:{_COLOURS[content.verdict]}">{written(content.verdict)}</p>',
             "".join(f"<p>{written(text)}</p>" for text in content.findings),
             f"<h2>{written(words.SEEN)}</h2>", _pictures(content, written),
             '<div class="charts">', _rows(words.REQUESTED, content.asked, written), _rows(words.MEASURED, content.measured, written),
             "</div>", f"<h2>{written(words.DISTRIBUTION)}</h2>", _histograms(content, say), _faces(content, written),
             _places(content, written), _origin(content, written),
             f"<details><summary>{written(words.WHOLE)}</summary><pre>{html.escape(content.whole)}</pre></details></body></html>\n"]
    return "\n".join(filter(None, parts))


def _phrase(text):
    """A text of the table of phrases as a Text, by which `say` knows it."""
    return Text(text) if text in words.TEXTS and not isinstance(text, Text) else text


def _colours(content, view):
    return colour_scale.colours_of(view.goodness(view.values)[content.element])


def _pictures(content, written):
    drawn = []
    for number, view in enumerate(content.views):
        colours = _colours(content, view)
        directions = [picture.AXONOMETRIC, -picture.AXONOMETRIC] if number == 0 else [picture.AXONOMETRIC]
        for direction in directions:
            source = picture.as_source(picture.png(content.corners, colours, _BIG, direction))
            drawn.append(f'<figure><img alt="{written(view.title)}" src="{source}"><figcaption>{written(view.title)}{_legend(view)}'
                         f"{_grey(view, written)}</figcaption></figure>")
    return f'<div class="pictures">{"".join(drawn)}</div>'


def _number(value, unit):
    return f"{value:.4g}{unit if unit == '°' else f' {unit}' if unit else ''}"


def _legend(view):
    ends = (-view.bad, view.bad) if view.is_signed else (view.bad, view.good)
    values = np.linspace(*ends, _STOPS)
    stops = ", ".join("rgb(%d, %d, %d)" % tuple(np.rint(255 * rgb).astype(int)) for rgb in colour_scale.colours_of(view.goodness(values)))
    middle = f"<span>{_number(0.5 * (ends[0] + ends[1]), view.unit)}</span>"
    return (f'<div class="scale" style="background:linear-gradient(to right, {stops})"></div><div class="ends"><span>'
            f"{_number(ends[0], view.unit)}</span>{middle}<span>{_number(ends[1], view.unit)}</span></div>")


def _grey(view, written):
    return f"<div>{written(words.GREY)}</div>" if np.isnan(view.goodness(view.values)).any() else ""


def _rows(title, rows, written):
    if not rows:
        return f"<div><h2>{written(title)}</h2><p>{written(words.NONE)}</p></div>"
    cells = [[Markup(written(name)), Markup(written(value))] for name, value in rows]
    return f"<div><h2>{written(title)}</h2>{table_of(['', ''], cells)}</div>"


def _histograms(content, say):
    drawn = []
    for view in content.views:
        values = view.values[np.isfinite(view.values)]
        ends = sorted((-view.bad, view.bad) if view.is_signed else (view.bad, view.good))
        unit = f" [{view.unit}]" if view.unit else ""
        drawn.append(charts.histogram(values.tolist(), f"{say(_phrase(view.title))}{unit}", limits=ends, mark=view.limit))
    return f'<div class="charts">{"".join(drawn)}</div>'


def _faces(content, written):
    """A table of the CAD faces, those with the worst values of the first view first."""
    known = np.unique(content.face[content.face >= 0])
    if not len(known):
        return ""
    areas, rows = area_by_element(content), []
    for face in known.tolist():
        chosen = content.face == face
        cells = [f"Face{face + 1}", f"{np.count_nonzero(chosen):,}", f"{areas[chosen].sum():.6g} mm²"]
        worst = np.inf
        for view in content.views:
            values = view.values[chosen]
            values = values[np.isfinite(values)]
            if not len(values):
                cells += ["", ""]
                continue
            bad = values[view.badness(values).argmax()]
            worst = min(worst, float(view.goodness(np.array([bad]))[0])) if view is content.views[0] else worst
            cells += [_number(bad, view.unit), _number(values.mean(), view.unit)]
        rows.append((worst, cells))
    rows.sort(key=lambda row: row[0])
    head = [written(words.FACE), written(words.COUNT), written(words.AREA)]
    for view in content.views:
        head += [f"{written(view.title)}: {written(word)}" for word in (words.WORST, words.MEAN)]
    more = f"<p>{written(Text(words.SHOWN, count=str(_MOST_FACES), count2=str(len(rows))))}</p>" if len(rows) > _MOST_FACES else ""
    return f"<h2>{written(words.BY_FACE)}</h2>" + table_of([Markup(cell) for cell in head], [cells for _, cells in rows[:_MOST_FACES]]) + more


def _places(content, written):
    if not content.places:
        return ""
    size = float(np.linalg.norm(np.ptp(content.corners.reshape(-1, 3), axis=0)))
    colours, drawn = _colours(content, content.views[0]), []
    for place in content.places[:MOST_PLACES]:
        lit = np.zeros(len(content.corners), dtype=bool)
        lit[place.triangles] = True
        own = content.corners[lit]
        direction = np.cross(own[:, 1] - own[:, 0], own[:, 2] - own[:, 0]).sum(axis=0)
        if np.linalg.norm(direction) < 1e-12 * size * size:
            direction = picture.AXONOMETRIC
        extent = float(np.linalg.norm(np.ptp(own.reshape(-1, 3), axis=0)))
        width = min(max(_AROUND * extent if len(own) == 1 else 2.0 * extent, _LEAST_AROUND * size), 1.2 * size)
        source = picture.as_source(picture.png(content.corners, colours, _SMALL, direction, (place.point, width), lit=lit))
        at = ", ".join(f"{x:.5g}" for x in place.point)
        drawn.append(f'<figure><img alt="" src="{source}"><figcaption>{written(place.text)}<br>({at}) mm</figcaption></figure>')
    shown = written(Text(words.SHOWN, count=str(len(drawn)), count2=str(content.all_places)))
    return f'<h2>{written(words.PLACES)}</h2><p>{shown}</p><div class="pictures small">{"".join(drawn)}</div>'


def _origin(content, written):
    now = datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M UTC")
    rows = [["MeshQuality", __version__], ["", versions()], [Markup(written(words.WRITTEN)), now],
            [Markup(written(words.DIGEST)), content.digest]]
    return f"<h2>{written(words.ORIGIN)}</h2>{table_of(['', ''], rows)}"


_STYLE = """
.verdict { color: #fff; padding: .4em .8em; font-weight: 600; border-radius: 4px; }
.pictures { display: flex; flex-wrap: wrap; gap: 1em; }
figure { margin: 0; border: 1px solid #ddd; padding: .5em; max-width: 720px; flex: 1 1 24em; }
.small figure { max-width: 320px; flex: 1 1 16em; }
figure img { width: 100%; display: block; } figcaption { font-size: .9em; overflow-wrap: anywhere; }
.scale { height: .9em; margin-top: .3em; } .ends { display: flex; justify-content: space-between; }
pre { overflow-x: auto; font-size: .85em; } summary { margin-top: 2em; cursor: pointer; }
@media print { figure { break-inside: avoid; } details { display: none; } .verdict, .scale { print-color-adjust: exact; } }
"""
