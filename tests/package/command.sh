#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Meshes a part that FreeCAD itself installs, by the command alone.   tests/package/command.sh PROGRAM...
# tools/package-test runs it where the addon is installed.
set -euo pipefail
program=("$@")
part=/usr/share/freecad/Mod/Idf/Idflibs/SOT428_DPAK.stp
cp "$part" part.stp

# expect FILE EXPRESSION: what the JSON report of a run must fulfil.
expect() {
    python3 -c 'import json, sys; r = json.load(open(sys.argv[1])); ok = eval(sys.argv[2]); sys.exit(not ok)' "$@" ||
        { echo "not so: $2" >&2 && cat "$1" >&2 && exit 1; }
}

"${program[@]}" triangulate part.stp -o part.ply --min-angle 25 --json >mesh.json
expect mesh.json 'r["closed"] and r["oriented"] and r["min_angle_unexempted"] >= 25'
"${program[@]}" quality part.ply --shape part.stp --json >measured.json
expect measured.json 'r["closed"] and r["max_chord_height"] < 0.1'
"${program[@]}" curve part.stp -o part.msh --order 2 --volume --json >curved.json
expect curved.json 'r["invalid"] == 0 and r["elements"] > 0'
