# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of volume meshes with layers, in tables as those of table.py. Imports nothing of FreeCAD."""

from dataclasses import replace

from .table import MUST_BE_GIVEN, TRIANGULATE, TRIANGULATE_PRESETS, Option

# Of the surface that is filled: as triangulate has them.
SURFACE = tuple(option for option in TRIANGULATE if option.name in ("min_angle", "chord_height", "chord_height_relative", "max_edge",
                                                                    "local_sizes"))
_LAYERS = (
    Option("layers", int, None, low=1, high=100, above=False, group="Layers", title="Layers", unset=MUST_BE_GIVEN,
           help="Number of layers of prisms on the walls"),
    Option("first_height", float, None, unit="mm", low=0.0, group="Layers", title="First height", unset=MUST_BE_GIVEN,
           suggested=(0.002, 0.1), help="Height of the layer on the wall"),
    Option("growth_rate", float, 1.2, low=1.0, high=4.0, above=False, group="Layers", title="Growth of layers",
           help="How many times as high each layer is as the one before it"),
)
_INSIDE = Option("growth_inside", float, 0.3, low=0.02, high=2.0, above=False, group="Size", title="Growth inside",
                 help="By how much longer edges of tetrahedra get for each length of distance from the walls: 0.1 is slow, 0.8 is fast")
_ORDER = Option("order", int, 1, low=1, high=4, above=False, title="Element order", group="Layers",
                help="1: straight sides; from 2 on layers follow the CAD")
_FAR_EDGE = Option("far_edge", float, None, unit="mm", low=0.0, group="Far field", title="Edges far away",
                   unset="by distance", help="Longest edges of triangles on the far field; unless given, a fifth of its distance")

VOLUME = (*_LAYERS, _ORDER, _FAR_EDGE, *SURFACE, _INSIDE)

NONE, FAR_FIELDS, HALVES = "none", ("box", "sphere"), ("x>", "x<", "y>", "y<", "z>", "z<")
_AROUND = ("far_field", FAR_FIELDS)

# Of document objects, where each number is a property.
FLOW = (
    *_LAYERS,
    replace(_ORDER, high=2),  # FreeCAD's FEM meshes have no higher one
    Option("walls", list, None, group="Layers", title="Walls", unset="all faces",
           help="Faces of the part that get layers; none named: all. Layers end in the faces beside them, which must be planes"),
    Option("far_field", str, NONE, choices=(NONE, *FAR_FIELDS), group="Far field", title="Flow",
           choice_titles=("in the part", "around, box", "around, sphere"),
           help="Where the fluid is: the part itself, or the space around it in a box or a sphere"),
    Option("far_distance", float, 5.0, low=0.5, high=1000.0, above=False, group="Far field", title="Distance in sizes", only_with=_AROUND,
           help="How many times the largest dimension of the part the far field is away from it"),
    Option("symmetry", str, NONE, choices=(NONE, *HALVES), group="Far field", title="Symmetry", only_with=_AROUND,
           choice_titles=("none", "x above", "x below", "y above", "y below", "z above", "z below"),
           help="The half-space of the fluid, whose plane is one of symmetry"),
    Option("symmetry_at", float, 0.0, unit="mm", group="Far field", title="Plane at", only_with=("symmetry", HALVES),
           help="Coordinate of the plane of symmetry"),
    _FAR_EDGE,
    *SURFACE,
    _INSIDE,
)
FLOW_PRESETS = tuple(replace(preset, values={**preset.values, "layers": layers})
                     for preset, layers in zip(TRIANGULATE_PRESETS, (3, 5, 8, 12)))
