#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Starts FreeCAD on a virtual screen, as it is after its installation, and has window.py look at the workbench.
set -euo pipefail
rm -f window.txt
# The start page's browser does not start as root otherwise.
export QTWEBENGINE_DISABLE_SANDBOX=1
timeout 120 xvfb-run -a -s '-screen 0 1400x900x24' freecad tests/package/window.py
grep -qx good window.txt || { cat window.txt >&2 && exit 1; }
