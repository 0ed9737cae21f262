# SPDX-License-Identifier: LGPL-2.1-or-later
"""Histograms as inline SVG, for the report of a batch."""

import html
import math

WIDTH, HEIGHT, LEFT, BOTTOM, TOP = 420, 190, 46, 34, 12
BINS = 30


def edges_of(values, log, limits=None):
    """The edges of equal bins over the values, on a logarithmic axis if asked for."""
    low, high = limits or (min(values), max(values))
    if log:
        low, high = math.floor(math.log10(low)), math.ceil(math.log10(high))
        high = max(high, low + 1)
        return [10 ** (low + (high - low) * i / BINS) for i in range(BINS + 1)]
    if high <= low:
        low, high = low - 0.5, high + 0.5
    return [low + (high - low) * i / BINS for i in range(BINS + 1)]


def counts_of(values, edges):
    """How many values lie in each bin; those beyond the ends count in the outermost bins."""
    counts = [0] * (len(edges) - 1)
    log = edges[0] > 0 and edges[1] / edges[0] > 1.001 and _is_geometric(edges)
    for value in values:
        if log:
            at = math.log(value / edges[0]) / math.log(edges[1] / edges[0])
        else:
            at = (value - edges[0]) / (edges[1] - edges[0])
        counts[min(max(int(at), 0), len(counts) - 1)] += 1
    return counts


def _is_geometric(edges):
    return math.isclose(edges[1] / edges[0], edges[2] / edges[1], rel_tol=1e-6)


def histogram(values, title, log=False, limits=None, mark=None):
    """A histogram as SVG text; `mark` draws a line at a value. On a logarithmic axis values that are
    not positive are left out, and the title says how many.
    """
    drawn = [value for value in values if value > 0] if log else list(values)
    left_out = len(values) - len(drawn)
    if left_out:
        title += f" ({left_out} of 0 left out)"
    if not drawn:
        return ""
    edges = edges_of(drawn, log, limits)
    counts = counts_of(drawn, edges)
    most, span = max(counts), WIDTH - LEFT - 8
    step, floor = span / len(counts), HEIGHT - BOTTOM
    rows = [f'<svg class="chart" viewBox="0 0 {WIDTH} {HEIGHT}" role="img">',
            f"<title>{html.escape(title)}</title>"]
    for i, count in enumerate(counts):
        tall = (floor - TOP) * count / most
        rows.append(f'<rect x="{LEFT + i * step:.1f}" y="{floor - tall:.1f}" width="{step - 1:.1f}" '
                    f'height="{tall:.1f}"><title>{_number(edges[i])} to {_number(edges[i + 1])}: '
                    f"{count}</title></rect>")
    rows += _axes(edges, log, most, floor, span)
    if mark is not None and edges[0] <= mark <= edges[-1]:
        x = LEFT + span * _place(mark, edges, log)
        rows.append(f'<line class="mark" x1="{x:.1f}" y1="{TOP}" x2="{x:.1f}" y2="{floor}"/>')
    rows.append(f'<text class="title" x="{LEFT + span / 2}" y="{HEIGHT - 4}">{html.escape(title)}'
                "</text></svg>")
    return "\n".join(rows)


def _axes(edges, log, most, floor, span):
    rows = [f'<line x1="{LEFT}" y1="{floor}" x2="{LEFT + span}" y2="{floor}"/>',
            f'<text class="y" x="{LEFT - 5}" y="{TOP + 8}">{most}</text>',
            f'<text class="y" x="{LEFT - 5}" y="{floor}">0</text>']
    for value in ticks(edges, log):
        x = LEFT + span * _place(value, edges, log)
        rows.append(f'<line x1="{x:.1f}" y1="{floor}" x2="{x:.1f}" y2="{floor + 4}"/>'
                    f'<text x="{x:.1f}" y="{floor + 15}">{_number(value)}</text>')
    return rows


def _place(value, edges, log):
    if log:
        return math.log(value / edges[0]) / math.log(edges[-1] / edges[0])
    return (value - edges[0]) / (edges[-1] - edges[0])


def ticks(edges, log):
    """Round values for the axis: powers of ten, or some six steps of 1, 2 or 5."""
    low, high = edges[0], edges[-1]
    if log:
        first, last = round(math.log10(low)), round(math.log10(high))
        every = max(1, math.ceil((last - first) / 7))
        return [10.0**i for i in range(first, last + 1, every)]
    rough = (high - low) / 6
    size = 10 ** math.floor(math.log10(rough))
    step = min((size * factor for factor in (1, 2, 5, 10)), key=lambda s: abs(s - rough))
    first = math.ceil(low / step - 1e-9)
    return [i * step for i in range(first, math.floor(high / step + 1e-9) + 1)]


def _number(value):
    return f"{value:.4g}".replace("e+0", "e").replace("e-0", "e-")
