# SPDX-License-Identifier: LGPL-2.1-or-later
"""Phrases on faults of meshes, a part of the table of phrases. Imports nothing of FreeCAD."""

# The kinds of faults, for one and for many.
FAULTS = {
    "open": ("1 open edge", "{count} open edges"),
    "nonmanifold": ("1 edge with three or more triangles", "{count} edges with three or more triangles"),
    "flipped": ("1 edge between triangles of opposite orientation", "{count} edges between triangles of opposite orientation"),
    "pinched": ("1 vertex at which the surface only touches itself", "{count} vertices at which the surface only touches itself"),
    "degenerate": ("1 triangle without area", "{count} triangles without area"),
    "duplicate": ("1 duplicate triangle", "{count} duplicate triangles"),
    "crossing": ("1 pair of triangles that cross", "{count} pairs of triangles that cross"),
    "touching": ("1 pair of triangles that touch or fold onto each other",
                 "{count} pairs of triangles that touch or fold onto each other"),
}
AT_LEAST = "at least {phrase}"
HAS_FAULTS = "the mesh has {list}; the command Repair mesh mends faults"
REPAIRS = "repairs: {list}"
NO_THICKNESS_OPEN = "the mesh has {count} open edges: only solids have walls; close it first"
NO_THICKNESS_FAULTS = "walls cannot be measured where the mesh has {list}: repair it by the command Repair mesh first"
# What repairs did, for one and for many; count2 are the triangles that close holes.
DONE = tuple((f"1 {one} {done}", f"{{count}} {many} {done}") for one, many, done in (
    ("vertex", "vertices", "welded"), ("degenerate triangle", "degenerate triangles", "removed"),
    ("duplicate triangle", "duplicate triangles", "removed"), ("triangle", "triangles", "turned around"),
    ("edge", "edges", "of more than two triangles parted"), ("vertex", "vertices", "of several sheets parted"),
    ("vertex", "vertices", "joined across cracks"), ("hole", "holes", "closed ({count2} triangles)"),
    ("triangle", "triangles", "of open sheets removed")))
ONE_HOLE = "1 hole closed (1 triangle)"
TEXTS = (*(text for pair in DONE for text in pair), ONE_HOLE, *(text for pair in FAULTS.values() for text in pair), AT_LEAST, HAS_FAULTS, REPAIRS, NO_THICKNESS_OPEN,
         NO_THICKNESS_FAULTS)
