# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that the window asks for and writes in the background: tables and reports."""

import os

import FreeCAD
import FreeCADGui
from PySide import QtGui

from ..core.reporting.page import page_of
from ..core.reporting.report import PDF, SUFFIX, SUFFIXES, write_page
from ..core.sources import frames
from ..errors import Error
from ..features import report
from . import jobs
from .translation import translated

translate = FreeCAD.Qt.translate


def asked_path(title, name, suffixes, kinds):
    """The path that the user gives, with one of the extensions, by default that of the chosen kind, else the first; empty: none."""
    path, kind = QtGui.QFileDialog.getSaveFileName(FreeCADGui.getMainWindow(), title, name + suffixes[0], kinds)
    if not path or path.lower().endswith(suffixes):
        return path
    return path + next((suffix for suffix in suffixes if f"*{suffix})" in kind), suffixes[0])


def start(title, path, work, say):
    """Adds work(progress), which writes the file; say(text, is_error) is told what became of it. Returns the Job."""
    job = jobs.Job(title, work, lambda _: say(translate("MeshQuality", "Saved: {0}").format(os.path.basename(path)), False))
    job.ended.connect(lambda: job.error and say(translated(job.error), True))
    return jobs.queue().add(job)


def save_report(source, say):
    """Asks for a file and writes the report of a document object, or a link to one, into it; returns the Job, None without one."""
    title, label = translate("MeshQuality", "Save report"), frames.leaf_of(source).Label
    path = asked_path(title, label, SUFFIXES, f"HTML (*{SUFFIX});;PDF (*{PDF})")
    if not path:
        return None
    try:
        content = report.taken(source)
    except Error as error:
        say(translated(error), True)
        return None
    return start(title, path, lambda progress: write_page(path, page_of(content(progress), translated)), say)
