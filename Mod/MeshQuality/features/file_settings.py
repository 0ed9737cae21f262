# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user prefers for File > Export and Import; the page of preferences and freecadcmd have the same parameters."""

import FreeCAD

from .. import formats, options

PATH = "User parameter:BaseApp/Preferences/Mod/MeshQuality"
UNITS = (("mm", 1.0), ("m", 0.001), ("in", 1 / 25.4))  # of the numbers in files, with the factor from mm
_HIGHEST_ORDER = 4  # of tetrahedra


def stored():
    """FreeCAD's group of our parameters."""
    return FreeCAD.ParamGet(PATH)


def scale():
    """The factor from mm to the numbers in files."""
    return _chosen(UNITS, "ExportUnit", 0)[1]


def fills_solids():
    """Whether files for solvers get tetrahedra of shapes with solids, not triangles alone."""
    return stored().GetInt("ExportElements", 0) == 0


def surface_values():
    """The options of triangulate."""
    return _values(options.TRIANGULATE, options.TRIANGULATE_PRESETS)


def element_values(suffix, has_solids):
    """The options of curve for a file of this format."""
    volume = has_solids and fills_solids()
    order = min(max(stored().GetInt("ExportOrder", 2), 1), formats.FORMATS[suffix].curved, _HIGHEST_ORDER)
    values = _values(options.CURVE, options.CURVE_PRESETS)
    return {**values, "order": order, "volume": volume, "imprint": True}


def _values(table, presets):
    values = options.defaults(table)
    length = stored().GetFloat("ExportChordHeight", 0.0)
    given = {"chord_height": length} if length > 0.0 else _chosen(presets, "ExportFineness", 1).values
    given = {name: value for name, value in given.items() if name in options.DISTANCE}
    return options.check(table, {**options.merged(values, given), "min_angle": stored().GetFloat("MinAngle", values["min_angle"])})


def _chosen(rows, entry, usual):
    index = stored().GetInt(entry, usual)
    return rows[index if 0 <= index < len(rows) else usual]
