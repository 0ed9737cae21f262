# SPDX-License-Identifier: LGPL-2.1-or-later
"""What pages of reports are made of: texts, tables and a style. Imports nothing of FreeCAD."""

import html


class Markup(str):
    """Text that is HTML already."""


def text_of(value):
    """A value as HTML."""
    return html.escape(str(value))


def table_of(head, rows):
    """A table; cells are texts, or Markup."""
    lines = ["<table><tr>" + "".join(f"<th>{text_of(cell)}</th>" for cell in head) + "</tr>"]
    for row in rows:
        cells = (cell if isinstance(cell, Markup) else text_of(cell) for cell in row)
        lines.append("<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>")
    return "\n".join(lines) + "</table>"


STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; margin: 2em auto; max-width: 80em; padding: 0 1em;
       color: #222; background: #fff; }
h1 { font-size: 1.5em; } h2 { font-size: 1.2em; margin-top: 2em; } h3 { font-size: 1em; }
table { border-collapse: collapse; } td, th { text-align: left; padding: .15em 1em .15em 0;
       border-bottom: 1px solid #ddd; vertical-align: top; overflow-wrap: anywhere; }
.charts { display: grid; grid-template-columns: repeat(auto-fill, minmax(24em, 1fr)); gap: 1.5em; }
.chart { width: 100%; overflow: visible; } .chart rect { fill: #3b6ea5; } .chart line { stroke: #555; }
.chart .mark { stroke: #b3261e; stroke-dasharray: 4 3; }
.chart text { font-size: 11px; fill: #444; text-anchor: middle; }
.chart .y { text-anchor: end; } .chart .title { font-size: 12px; font-weight: 600; }
"""
