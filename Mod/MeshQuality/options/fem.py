# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of FEM meshes, in tables as those of table. Imports nothing of FreeCAD."""

from dataclasses import replace

from .table import CURVE, CURVE_PRESETS, Option

_OF_FEM = {
    "order": {"high": 2, "help": "1: straight sides; 2: quadratic elements, which follow curved faces and bend as "
                                 "they should"},
    "volume": {"default": True, "help": "Fill the solids with tetrahedra; off, and where there is no solid: triangles "
                                        "for shells"},
    "imprint": {"default": True},
    "max_edge": {"unset": "by the walls"},
}
THROUGH = Option("elements_through", int, 2, low=1, high=8, above=False, group="Before curving",
                 title="Elements through walls",
                 help="Where no longest edge is given: elements through a wall of mean thickness, which is twice the volume "
                      "over the area of the surface; at most about 100,000 elements in all")
FEM = tuple(made for option in CURVE for made in (
    replace(option, **_OF_FEM.get(option.name, {})), *([THROUGH] if option.name == "max_edge" else [])))
# For meshes that others made.
CURE = tuple(replace(option, group="Mesh") for option in FEM if option.name in ("order", "straighten_invalid", "imprint"))

FEM_PRESETS = tuple(replace(preset, values={**preset.values, "order": 2, "elements_through": through})
                    for through, preset in enumerate(CURVE_PRESETS, 1))
