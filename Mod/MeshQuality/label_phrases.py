# SPDX-License-Identifier: LGPL-2.1-or-later
"""What new objects of a document are called, after what they are made of; a part of the table of phrases. Imports nothing of
FreeCAD."""

LABELS = {word: f"{{name}} {word}" for word in (
    "quality mesh", "curved mesh", "FEM mesh", "flow mesh", "cured mesh", "improved", "simplified", "repaired", "inspection", "deviation", "offset", "hollow", "wrap",
    "CFD surface", "CAM mesh", "solid", "union", "intersection", "difference", "symmetric difference", "adaptation")}
TEXTS = tuple(LABELS.values())
