# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user prefers, as FreeCAD keeps it, and the values that a panel begins with."""

import json
import os

import FreeCAD

from .. import options
from ..errors import InvalidInput
from ..features.file_settings import stored
from .quantities import Unit


def first_values(kind):
    """{option: value} that a panel for a new object of this kind begins with: those that were used
    last, else the defaults.
    """
    last = _last(kind) if stored().GetBool("RememberValues", True) else {}
    return options.merged(defaults(kind), last)


def defaults(kind):
    """{option: value} of a panel of this kind where nothing was chosen yet."""
    values = options.defaults(kind.OPTIONS)
    if "min_angle" in values:
        values["min_angle"] = stored().GetFloat("MinAngle", values["min_angle"])
    for preset in kind.PRESETS:
        if preset.title == options.FIRST_PRESET:
            values.update(preset.values)
    return values


def suggested(kind, size):
    """{option: length in mm} with which a panel of this kind begins for a part of this size, two digits in the user's unit; {} for
    size 0, unknown.
    """
    lengths = {option.name: min(option.suggested[0] * size, option.suggested[1])
               for option in kind.OPTIONS if option.suggested and size > 0.0}
    return {name: Unit.of(length).rounded(length, 2) for name, length in lengths.items()}


def remember(kind, values):
    """Keeps the values for the next panel of this kind."""
    if stored().GetBool("RememberValues", True):
        stored().SetString(_entry(kind), json.dumps(_of_any_part(kind, values)))


def _of_any_part(kind, values):
    """Those values that make sense for other parts, too: no lengths and no names of sub-elements."""
    left_out = {option.name for option in kind.OPTIONS
                if option.is_of_one_part and values.get(option.name) != options.NO_BOUND}
    return {name: value for name, value in values.items() if name not in left_out and value is not None}


def is_open(name):
    """Whether the user has left open what can be folded away in a panel."""
    return stored().GetGroup("Open").GetBool(name)


def keep_open(name, opened):
    """Keeps for the next panel whether that is open."""
    stored().GetGroup("Open").SetBool(name, opened)


def manual_above():
    """Number of triangles above which a new mesh does not follow its source by itself."""
    return stored().GetInt("ManualAbove", 200_000)


def in_background():
    """Whether meshes that follow their source are computed in the background."""
    return stored().GetBool("Background", True)


def limit_threads():
    """Gives the core the number of threads that the user prefers, unless the environment names one. The core reads it when it
    works for the first time.
    """
    threads = stored().GetInt("Threads", 0)
    if threads > 0:
        os.environ.setdefault("MESHQUALITY_THREADS", str(threads))


def _last(kind):
    """Values that were used last; {} when there are none, or of another version's options."""
    text = stored().GetString(_entry(kind), "")
    try:
        values = options.renamed(kind.OPTIONS, json.loads(text)) if text else {}
        checked = options.check(kind.OPTIONS, _of_any_part(kind, values))
        return {name: checked[name] for name in _of_any_part(kind, values)}
    except (ValueError, AttributeError, InvalidInput):
        FreeCAD.Console.PrintLog(f"MeshQuality: last values of {kind.COMMAND} are not used: {text}\n")
        return {}


def _entry(kind):
    return "Last" + kind.COMMAND.split("_")[1]
