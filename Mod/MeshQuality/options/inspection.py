# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of the inspection of solids, a table as those of table.py. Imports nothing of FreeCAD."""

from dataclasses import replace

from .table import Option

THICKNESS_MEASURES = ("spheres", "rays")

THICKNESS = (
    Option("measure", str, "spheres", choices=THICKNESS_MEASURES, group="Thickness", title="Measure",
           choice_titles=("Inscribed spheres", "Rays"),
           help="spheres: diameter of the largest ball in the solid that touches the surface there; rays: along the "
                "inward normal to the other side"),
    Option("gap", bool, False, group="Thickness", title="Gaps",
           help="Measure the gaps and slots outside of each solid, in place of its walls"),
    Option("min_thickness", float, None, unit="mm", low=0.0, group="Thickness", title="Smallest thickness",
           unset="no limit", help="Walls thinner than this are reported"),
    Option("tolerance", float, None, unit="mm", low=0.0, group="Accuracy", title="Max. deviation",
           unset="by the thinnest wall", help="Largest distance of the mesh that is measured from a shape"),
    Option("spacing", float, None, unit="mm", low=0.0, group="Accuracy", title="Spacing", unset="size / 50",
           help="Largest distance between neighbouring points that are measured"),
    Option("corner_angle", float, 45.0, unit="degrees", low=0.0, high=89.0, group="Accuracy", title="Corner angle",
           help="Surfaces inclined to each other by more than this are a corner, not the sides of a wall"),
)

CLEARANCE = (
    Option("min_clearance", float, None, unit="mm", low=0.0, group="Clearance", title="Smallest clearance",
           unset="no limit", help="Pairs of bodies nearer to each other than this are reported"),
    Option("within", float, None, unit="mm", low=0.0, group="Clearance", title="Largest distance",
           unset="no limit", help="Pairs of bodies farther from each other than this are left out"),
    Option("tolerance", float, None, unit="mm", low=0.0, group="Accuracy", title="Max. deviation",
           unset="size / 1000", help="Largest distance of the mesh that is measured from a shape"),
)

_TOLERANCE = CLEARANCE[-1]
DRAFT = (
    Option("min_draft", float, 1.0, unit="degrees", low=0.0, high=89.0, group="Draft", title="Smallest draft",
           help="Draft that walls should have"),
    _TOLERANCE,
)
VOIDS = (_TOLERANCE,)

ALIGNMENTS = ("none", "near", "any")
DEVIATION = (
    Option("tolerance", float, None, unit="mm", low=0.0, group="Deviation", title="Tolerance", unset="no limit",
           help="Points farther from the reference than this, outside or inside, are reported"),
    Option("align", str, "none", choices=ALIGNMENTS, group="Deviation", title="Alignment",
           choice_titles=("None", "Best fit from here", "Best fit from any pose"),
           help="none: points are measured where they are; near: they are fitted to the reference from there; any: from any pose, by "
                "principal axes first"),
)

# Of document objects, which hold one of these checks.
CHECKS = ("thickness", "clearance", "draft", "voids")
PULL_DIRECTIONS = ("x", "-x", "y", "-y", "z", "-z")


def _only_with(check, options):
    return tuple(replace(option, only_with=("check", (check,))) for option in options)


INSPECTION_OBJECT = (
    Option("check", str, "thickness", choices=CHECKS, group="Inspection", title="Check",
           choice_titles=("Wall thickness", "Clearance", "Draft, undercuts", "Closed voids"),
           help="What is measured: the thickness of walls, the distances between the solids of a shape, the draft against the "
                "pull direction of a mould, or cavities from which nothing comes out"),
    *_only_with("thickness", THICKNESS[:3]),
    *_only_with("clearance", CLEARANCE[:1]),
    *_only_with("draft", (
        Option("pull_direction", str, "z", choices=PULL_DIRECTIONS, group="Draft", title="Pull direction",
               choice_titles=PULL_DIRECTIONS, help="One half of the mould opens along it, the other one against it"),
        DRAFT[0])),
    replace(_TOLERANCE, unset="automatic"),
    *_only_with("thickness", THICKNESS[4:]),
)
