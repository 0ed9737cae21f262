# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports as PDF, printed by a browser without a window: FreeCAD has nothing that lays out such a page."""

import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from ...errors import IoError

VARIABLE = "MESHQUALITY_BROWSER"
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "microsoft-edge", "brave-browser", "chrome", "msedge")
_SECONDS = 180.0  # on the clock


def browser():
    """The path of a browser that prints: that named in the environment, else the first on the path; raises IoError."""
    named = os.environ.get(VARIABLE)
    found = shutil.which(named) if named else next(filter(None, map(shutil.which, BROWSERS)), None)
    if found is None:
        where = f"'{named}', named in {VARIABLE}, is not there" if named else "none of Chromium, Chrome, Edge and Brave is on the path"
        raise IoError(f"a report as PDF needs a browser, and {where}: install one, name it in {VARIABLE}, or write .html")
    return found


def print_page(page, path):
    """Writes a page of HTML as PDF. Raises IoError where the browser does not."""
    with tempfile.TemporaryDirectory(prefix="meshquality-report-") as folder:
        source = Path(folder, "report.html")
        source.write_text(page, encoding="utf-8")
        command = [browser(), "--headless", "--disable-gpu", "--no-first-run", "--no-pdf-header-footer", "--print-to-pdf-no-header",
                   f"--user-data-dir={Path(folder, 'profile')}", f"--print-to-pdf={path}"]
        if hasattr(os, "geteuid") and os.geteuid() == 0:
            command.append("--no-sandbox")  # its sandbox does not start as root
        try:
            done = subprocess.run([*command, source.as_uri()], stdin=subprocess.DEVNULL, capture_output=True, timeout=_SECONDS, check=False)
        except (OSError, subprocess.TimeoutExpired) as error:
            raise IoError(f"{command[0]} has not printed the report: {error}") from error
    if not os.path.exists(path) or Path(path).read_bytes()[:5] != b"%PDF-":
        raise IoError(f"{command[0]} has not printed the report, and ended with {done.returncode}")
