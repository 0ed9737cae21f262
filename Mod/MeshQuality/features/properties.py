# SPDX-License-Identifier: LGPL-2.1-or-later
"""Properties of the document objects that hold a mesh: what adds, reads and fills them."""

import json
import re
from contextlib import suppress

from .. import options, phrases
from ..compat import attribute_of, property_of
from . import aliases, distance_bound

# Name, type, what it says: measured on the mesh that an object holds; where its report says it, the name there, see show_report.
TOPOLOGY = (
    ("Triangles", "App::PropertyInteger", "Number of triangles", "triangles"),
    ("Vertices", "App::PropertyInteger", "Number of vertices", "vertices"),
    ("Oriented", "App::PropertyBool", "Neighbouring triangles agree on outside", "oriented"),
)
VOLUME = ("Volume", "App::PropertyVolume", "Enclosed volume", "volume")
BRIDGE = ("Bridge", "App::PropertyString", "How the shape came from FreeCAD: live, in place, or stream, as a copy; empty: there was none",
          "bridge")
NOTES = ("Notes", "App::PropertyStringList", "Other remarks about the computation", "notes")
# Further properties of objects that promise a smallest angle.
ANGLES = (
    ("MeasuredMaxAngle", "App::PropertyAngle", "Largest angle of all triangles", "max_angle"),
    ("ExemptCount", "App::PropertyInteger", "Number of triangles below the requested angle"),
    ("Exempt", "App::PropertyStringList", "Triangles below the requested angle, and why; hidden where there are many"),
)
EXEMPT_REASONS = ("ExemptReasons", "App::PropertyStringList",
                  "For each reason in Exempt what it is made of, and the triangles, by which the window translates it")

FAULTS_LEFT = ("FaultsLeft", "App::PropertyInteger", "Faults that no repair removed", "faults_left")

# For objects that keep a distance; see show_deviation.
DEVIATION = ("DeviationInFull", "App::PropertyString",
             "Max. deviation, measured and requested, with the digits that count: the editor shows 0.003 as 0.00")
_DEVIATIONS = (("MaxChordHeight", "AskedChordHeight"), ("ErrorBound", "AskedTolerance"), ("MaxDeviation", None))

_MOST_LINES = 50  # lines of a list in the property editor


def add_property(obj, kind, name, group, text):
    """Adds a property, unless the object has it; returns whether it was added."""
    if name in obj.PropertiesList:
        return False
    obj.addProperty(kind, name, group, text)
    return True


def add_measured(obj, table):
    """A read-only property for each row of the table, in the group Quality."""
    for name, kind, text, *_ in table:
        add_property(obj, kind, name, "Quality", text)
        obj.setEditorMode(name, 1)
    _fold_long_lists(obj)


def _fold_long_lists(obj):
    """Hides what would fill the property editor; ExemptCount says how much that is."""
    if "Exempt" in obj.PropertiesList:
        obj.setEditorMode("Exempt", 2 if len(obj.Exempt) > _MOST_LINES else 1)


def add_hidden(obj, group, table):
    """A property that the editor does not show for each (name, type, text) of the table."""
    for name, kind, text in table:
        add_property(obj, kind, name, group, text)
        obj.setEditorMode(name, 2)


def show_mesh(obj, mesh):
    """Gives the object its mesh."""
    clear_mesh(obj)
    obj.Mesh = mesh


def clear_mesh(obj):
    """Takes away a mesh with segments. FreeCAD would mark the facets of all segments anew for each
    segment of the mesh that replaces it: of 500,000 triangles on 50 faces that takes seven seconds.
    """
    import Mesh

    if obj.Mesh.countSegments():
        empty = Mesh.Mesh()
        empty.Placement = attribute_of(obj.Mesh, "Placement")
        obj.Mesh = empty


def show_report(obj, table, report, mesh=None):
    """Fills the properties of the table that say what the report does, or else the mesh."""
    for name, _, _, *field in table:
        for field_name in field:
            value = getattr(report if hasattr(report, field_name) else mesh, field_name)
            if isinstance(value, dict):
                value = [f"{what}: {count}" for what, count in value.items() if count]
            setattr(obj, name, value)
    if ANGLES[-1] in table:
        _show_exempt(obj, report)


def show_deviation(obj):
    """Fills DEVIATION, where the object has it, from the lengths beside it."""
    if DEVIATION[0] not in obj.PropertiesList:
        return
    measured, requested = next(names for names in _DEVIATIONS if names[0] in obj.PropertiesList)
    asked = property_of(obj, requested).Value if requested else 0.0
    relative = property_of(obj, "ChordHeightRelative") if requested == "AskedChordHeight" else 0.0
    share = f" = {relative:.4g} of the size" if relative else ""
    obj.DeviationInFull = f"{property_of(obj, measured).Value:.4g} mm" + (f" (requested {asked:.4g} mm{share})" if asked else "")


def _show_exempt(obj, report):
    reasons = [(triangle, reason.message) for triangle, reason in report.exempt_reasons]
    obj.Exempt = [phrases.exempt_triangle(triangle, reason) for triangle, reason in reasons]
    obj.ExemptCount = len(reasons)
    _fold_long_lists(obj)
    triangles = {}
    for triangle, reason in reasons:
        triangles.setdefault(reason, []).append(triangle)
    obj.ExemptReasons = [json.dumps([phrases.to_data(reason), numbers]) for reason, numbers in triangles.items()]


_EXEMPT_LINE = re.compile(r"triangle (\d+): (.+)")  # used where no reasons are stored


def exempt_reasons(obj):
    """{triangle: why it is below the requested angle} of an object; plain texts where an older version stored them."""
    lines = list(getattr(obj, "Exempt", []))
    with suppress(ValueError, KeyError, TypeError, AttributeError, IndexError):
        stored = (json.loads(line) for line in getattr(obj, "ExemptReasons", []))
        reasons = {triangle: reason for data, triangles in stored for reason in [phrases.from_data(data)]
                   for triangle in triangles}
        if [phrases.exempt_triangle(*item) for item in sorted(reasons.items())] == lines:
            return reasons
    return {int(found[1]): found[2] for found in map(_EXEMPT_LINE.fullmatch, lines) if found}


def add_options(obj, table):
    """A property for each option of the table, with its default."""
    for option in table:
        name, value = option.property_name, aliases.first_value(obj, option)
        if add_property(obj, option.property_type, name, option.group, option.property_help):
            if option.choices:
                setattr(obj, name, option.property_choices)
            setattr(obj, name, value)
    aliases.add(obj, table)
    if options.has_distance(table):
        distance_bound.add(obj, table)


def options_of(obj, table):
    """{option: value} of the object's properties."""
    values = {option.name: options.from_property(option, property_of(obj, option.property_name))
              for option in table}
    if options.has_distance(table):
        values.update(options.bound_from_properties(obj.DistanceBound, values))
    return values


def set_options(obj, table, values):
    """Sets the properties of {option: value}, checked before."""
    for option in table:
        value = options.to_property(option, values[option.name])
        if option.is_fields:
            value = [obj.Document.getObject(name) for name in value]
        setattr(obj, option.property_name, value)
    if options.has_distance(table):
        obj.DistanceBound = options.bound_of(values)
