# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the core, the certificates and errors say, in one table, so that panels can say it in the
user's language. Imports nothing of FreeCAD.

Documents, scripts and the command line keep the English text. It is its own key: a phrase of the
table has places for what differs, such as {face}, and fits every text that has something of that
kind in them. In a place that may hold a phrase again, that is translated too.
"""

import re
from functools import lru_cache

from . import options

# Of certificates; features/certificate.py puts sentences together of these.
NOT_CLOSED = "not closed: {count} edges have one triangle only"
NOT_MANIFOLD = ("not manifold: {count} edges of three or more triangles, {count2} pinched vertices, "
                "{count3} triangles without area")
ANGLE = "smallest angle {number} of {number2} degrees at triangle {count}: {phrase}"
MORE_BELOW = "{phrase} ({count} more triangles are below)"
SHAPE_DISTANCE = "distance to the shape {number} of {number2} mm"
RESULT_DISTANCE = "distance from the exact result {number} of {number2} mm"
AT_TRIANGLE = "{phrase} at triangle {count}"
ON_FACE = "{phrase} on {face}"
ONLY_ON_FACE = "on {face}"
NO_REASON = "for no known reason"
LIMIT = "a limit ended the work early"
FAULTS_LEFT = "{count} faults are left that no repair removed"
FOLDED = "{count} of {count2} elements are not proven free of folds: {list}"
AND_MORE = "{list} and {count} more"
CERTIFICATE = (
    NOT_CLOSED, NOT_MANIFOLD, MORE_BELOW, ANGLE, SHAPE_DISTANCE, RESULT_DISTANCE, LIMIT, FAULTS_LEFT,
    FOLDED, AND_MORE, NO_REASON, ONLY_ON_FACE, "triangle {count} on {face}",
    "tetrahedron {count} of {solid}",
)

# Why the mesher could do no better: src/triangulate/explain.cpp, src/improve/improver.cpp.
REASONS = (
    "corner of {number} degrees between {edge} and {edge2} at {vertex}",
    "the surface comes to a point at {vertex} with too little angle around it",
    "edges near the narrow corner at {vertex} would shrink without end",
    "no such angles fit beside edges that part by {number} degrees at {vertex}",
    "a further vertex would lie closer than single precision tells apart",
    "so many triangles there had no room for a further vertex that it is refined no finer",
    "a further vertex would make an edge shorter than min_edge",
    "a further vertex would lie closer to its neighbours than they do to each other",
    "a further vertex would fold the mesh",
    "the engine finds no point of the surface there",
    "no change of the triangles around makes the angle larger "
    "within the bounds",
    "max_triangles is reached",
    "its smallest angle lies between two sharp edges that must stay",
    "no change within the tolerance makes it better",
)

# Errors that a panel can meet.
ERRORS = (
    "{option} = {value} is not allowed: it must be a whole number, {range}",
    "{option} = {value} is not allowed: it must be a number, {range}",
    "{option} = {value} is not allowed: it must be {range}",
    "chord_height = {value} and chord_height_relative = {number} exclude each other: give one of them",
    "min_edge = {number} mm is longer than max_edge = {number2} mm",
    "Source is empty: choose an object with a shape",
    "Source is not a mesh: choose one object with a mesh",
    "Sources has {count} objects: choose two or more with a mesh or a shape",
    "{name} is null: it has no geometry; recompute the document, if it is new",
    "{name} is null: it has no geometry",
    "{name} has no faces (its type is {name2}): give a solid, a shell or faces",
    "{name} has no triangles",
    "local_sizes names {value}, but {name} does not hold that: select it again in the 3D view",
    "what is to be meshed is not in its document any more: close the panel",
)
# Likewise, of the core. What it says of single faults of shapes stays as it is.
CORE_ERRORS = (
    "the shape has no solids to fill: leave volume off to curve its faces",
    "the shape has no faces with an area: give a solid, a shell or faces",
    "no triangulation of {value}. Repair the shape, or allow missing faces to mesh the rest",
    "chord_height is {number} mm: single precision holds this part to {number2} mm only; ask for more "
    "than that",
    "tolerance is {number} mm: single precision holds these operands to {number2} mm only; ask for "
    "more than that",
    "a local size is given for {name}, but the shape has {count} {name2}",
    "order is {count}: it goes from 1 to {count2} for volumes",
    "filling the surface with tetrahedra did not come to an end: its triangles do not fit each other "
    "across thin walls; ask for a smaller chord height or shorter edges",
    "the surface could not be filled with tetrahedra (the mesher says: {value}): it meets itself, or "
    "walls are too thin for its triangles; ask for a smaller chord height",
    "{name} has no triangle with an area that encloses a volume",
)
RANGES = (
    "greater than {number} and at most {number2} {unit}",
    "greater than {number} and at most {number2}",
    "at least {number} and at most {number2}",
    "greater than {number} {unit}, or 'none'",
    "greater than {number} {unit}",
    "greater than {number}",
    "at least {number}",
    "lengths in mm greater than 0 by sub-elements, such as Face3=0.5, Edge7=0.2",
)
UNITS = ("degrees", "mm")

# Between the others and whatever they end with, hence last.
ENDINGS = ("{phrase} at {edge}", ON_FACE, AT_TRIANGLE)

# Stages of the core and of this package by their names there, in words for people.
STAGES = {
    "start": "starting",
    "reading the shape": "reading the shape",
    "reading the operands": "reading the operands",
    "meshing shapes": "meshing the shapes",
    "initial triangulation": "first triangles",
    "sampling": "laying points on the surface",
    "refining angles": "improving the angles",
    "refining to the chord height": "getting nearer to the shape",
    "separating crossings": "separating faces that cross",
    "mending": "mending what is left",
    "taking out vertices": "taking out vertices",
    "releasing smooth edges": "releasing smooth edges",
    "checking": "checking the result",
    "improving": "improving",
    "classifying": "sorting the triangles",
    "curving the surface": "curving the surface",
    "repairing the surface": "repairing the surface",
    "filling": "filling with tetrahedra",
    "repairing the volume": "repairing the tetrahedra",
    "inspecting": "looking at the operands",
    "finding crossings": "finding where they cross",
    "dividing": "dividing triangles",
    "extracting": "putting the result together",
    "fitting to the shapes": "fitting to the shapes",
    "clustering": "grouping the points",
    "Boolean of samples": "combining the points",
    "membership": "finding what is inside",
    "octree": "dividing the space",
    "stitching": "closing gaps",
    "contouring": "making the surface",
    "two-manifold": "separating what only touches",
    "assembly": "putting the result together",
    "measuring the distance": "measuring the distance",
    "measuring the distortion": "measuring the distortion",
    "cutting into triangles": "cutting into triangles",
    "done": "done",
}

# What is said in a panel where the English text is made for scripts.
_SHOWN = {
    "corner of {number} degrees between {edge} and {edge2} at {vertex}":
        "the part itself has a corner of {number} degrees there, between {edge} and {edge2} at {vertex}",
    "{option} = {value} is not allowed: it must be a whole number, {range}":
        "{option}: {value} is not possible, it must be a whole number, {range}",
    "{option} = {value} is not allowed: it must be a number, {range}":
        "{option}: {value} is not possible, it must be a number, {range}",
    "{option} = {value} is not allowed: it must be {range}":
        "{option}: {value} is not possible, it must be {range}",
    "chord_height = {value} and chord_height_relative = {number} exclude each other: give one of them":
        "The max. deviation is given twice, as {value} and as {number} of the size: give one of them",
    "min_edge = {number} mm is longer than max_edge = {number2} mm":
        "The shortest edge of {number} mm is longer than the longest edge of {number2} mm",
    "a further vertex would lie closer than single precision tells apart":
        "a further point would lie too near to be told apart in the numbers that FreeCAD keeps",
    "so many triangles there had no room for a further vertex that it is refined no finer":
        "so many triangles there had no room for a further point that it was not divided any finer",
    "a further vertex would make an edge shorter than min_edge":
        "a further point would make an edge shorter than the shortest that is allowed",
    "a further vertex would lie closer to its neighbours than they do to each other":
        "a further point would not make the triangles around it better",
    "a further vertex would fold the mesh": "a further point would fold the mesh",
    "the engine finds no point of the surface there": "the shape has no usable point there",
    "max_triangles is reached": "the largest number of triangles was reached",
    "not manifold: {count} edges of three or more triangles, {count2} pinched vertices, {count3} "
    "triangles without area":
        "not a clean surface: {count} edges of three or more triangles, {count2} points where it only "
        "touches itself, {count3} triangles without area",
    "the shape has no solids to fill: leave volume off to curve its faces":
        "The shape has no solids to fill with tetrahedra: switch that off to curve its faces",
    "no triangulation of {value}. Repair the shape, or allow missing faces to mesh the rest":
        "Faces cannot be meshed: {value}. Repair the shape with Part - Check geometry, or choose under "
        "More options to leave such faces out",
    "chord_height is {number} mm: single precision holds this part to {number2} mm only; ask for more "
    "than that":
        "A distance to the shape of {number} mm is finer than the numbers of a mesh in FreeCAD, which "
        "hold this part to {number2} mm: ask for more than that",
    "tolerance is {number} mm: single precision holds these operands to {number2} mm only; ask for "
    "more than that":
        "A tolerance of {number} mm is finer than the numbers of a mesh in FreeCAD, which hold these "
        "operands to {number2} mm: ask for more than that",
    "a local size is given for {name}, but the shape has {count} {name2}":
        "Shorter edges are asked for on {name}, but the shape has only {count} of these",
    "order is {count}: it goes from 1 to {count2} for volumes":
        "Elements of order {count} are not possible with tetrahedra: it goes from 1 to {count2}",
    "the surface could not be filled with tetrahedra (the mesher says: {value}): it meets itself, or "
    "walls are too thin for its triangles; ask for a smaller chord height":
        "The surface could not be filled with tetrahedra: it meets itself, or walls are too thin for "
        "its triangles. Ask for a smaller distance to the shape ({value})",
    "filling the surface with tetrahedra did not come to an end: its triangles do not fit each other "
    "across thin walls; ask for a smaller chord height or shorter edges":
        "The surface could not be filled with tetrahedra: its triangles do not fit each other across thin "
        "walls. Ask for a smaller distance to the shape or shorter edges",
}

_NUMBER = r"[-+]?(?:\d[\d.]*(?:e[-+]?\d+)?|inf|nan)"
_KINDS = {
    "count": r"\d+", "number": _NUMBER, "face": r"Face\d+", "edge": r"Edge\d+",
    "vertex": r"(?:Vertex|Edge|Face)\d+", "solid": r"Solid\d+", "option": r"\w+", "value": ".+?",
    "unit": "|".join(UNITS), "name": ".+?", "phrase": ".+", "list": ".+", "range": ".+",
}
_PHRASES = (*CERTIFICATE, *REASONS, *ERRORS, *CORE_ERRORS, *RANGES, *ENDINGS)


def texts():
    """All texts that are to be translated."""
    return sorted({*(_SHOWN.get(phrase, phrase) for phrase in _PHRASES), *STAGES.values(), *UNITS})


def translated(text, translate):
    """The text in the user's language; one that no phrase fits stays as it is.

    translate   translate(text of `texts`) -> text in the user's language
    """
    for phrase in _PHRASES:
        found = _pattern(phrase).fullmatch(text)
        if found:
            places = {name: _place(name, value, translate)
                      for name, value in found.groupdict().items()}
            return translate(_SHOWN.get(phrase, phrase)).format(**places)
    return text


def sentences(text, translate):
    """Of several phrases with "; " between them, each translated."""
    return "; ".join(translated(part, translate) for part in text.split("; "))


def stage(name, translate):
    """Words for a stage."""
    return translate(STAGES[name]) if name in STAGES else name


def _place(name, value, translate):
    kind = name.rstrip("0123456789")
    if kind == "unit":
        return translate(value)
    if kind == "option":
        return translate(_titles().get(value, value))
    if kind == "list":
        return ", ".join(translated(part, translate) for part in value.split(", "))
    return translated(value, translate) if kind in ("phrase", "range") else value


@lru_cache(maxsize=None)
def _pattern(phrase):
    places = re.split(r"{(\w+)}", phrase)
    return re.compile("".join(
        f"(?P<{part}>{_KINDS[part.rstrip('0123456789')]})" if i % 2 else re.escape(part)
        for i, part in enumerate(places)), re.DOTALL)


@lru_cache(maxsize=None)
def _titles():
    tables = (options.TRIANGULATE, options.CURVE, options.CURVED_DISPLAY, options.BOOLEAN,
              options.IMPROVE)
    return {option.name: option.title for table in tables for option in table}
