# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of what functions of this package return: its verdict, what was requested, and its file."""

from ... import report_phrases as words
from ..certify import verdict
from ..inspect.deviation import DeviationMap
from ..inspect.draft import DraftMap
from ..inspect.thickness import ThicknessMap
from ..meshes.surface_mesh import SurfaceMesh
from ..meshes.writing import atomically
from ..sources import convert
from .content import content_of
from .printing import print_page

SUFFIX, PDF = ".html", ".pdf"
SUFFIXES = (SUFFIX, ".htm", PDF)


def content_for(source, name, shape=None, progress=None, findings=None):
    """The Content of a result with its verdict.

    shape     Part.Shape or document object: deviations from it are shown, too
    findings  of its certificate; None: those of what the result says was requested of it
    """
    found = content_of(source, name, None if shape is None else convert.taken(convert.shape_of(shape)), progress)
    findings = _findings_of(source) if findings is None else findings
    if findings or found.asked:
        found.verdict = {verdict.MET: words.MET, verdict.NOT_MET: words.NOT_MET}.get(verdict.word(findings), words.NOT_DECIDED)
        found.findings = [finding.text for finding in findings]
    return found


def _findings_of(source):
    if isinstance(source, ThicknessMap):
        return verdict.of_thickness(source)
    if isinstance(source, DraftMap):
        return verdict.of_draft(source)
    if isinstance(source, DeviationMap):
        return verdict.of_deviation(source)
    if isinstance(source, SurfaceMesh):
        is_solid = hasattr(source.report, "error_bound")
        return verdict.of_boolean(source) if is_solid else [*verdict.of_improvement(source, False), *verdict.deviation(source)]
    return verdict.elements(source) if hasattr(source, "tetrahedron_quality") else []


def asked_rows(table, values, titled=lambda option: option.title or option.name):
    """[(what is requested, value as text), ...] of the lengths and angles that are set, and of other options that are not as usual."""
    rows = []
    for option in table:
        value = values.get(option.name)
        unit = {"degrees": "°", "mm": " mm"}.get(option.unit, "")
        if value is None or value == {} or option.name == "threads" or not unit and value == option.default:
            continue
        rows.append((titled(option), f"{value:g}{unit}" if isinstance(value, float) else f"{value}{unit}"))
    return rows


def write_page(path, page):
    """Writes a page, as PDF where the path says so; raises IoError naming the path."""
    def write_into(ready):
        with open(ready, "w", encoding="utf-8") as stream:
            stream.write(page)

    if path.lower().endswith(PDF):
        atomically(path, PDF, lambda ready: print_page(page, ready))
    else:
        atomically(path, SUFFIX, write_into)
