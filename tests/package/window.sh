#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Starts FreeCAD on a virtual screen and has window.py look at the installed workbench.
set -euo pipefail
rm -f window.txt
timeout 120 xvfb-run -a -s '-screen 0 1400x900x24' freecad --user-cfg "$PWD/window.cfg" tests/package/window.py
grep -qx good window.txt || { cat window.txt >&2 && exit 1; }
