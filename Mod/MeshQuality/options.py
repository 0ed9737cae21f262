# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of every operation: one table, from which the properties of document objects, the
task panels, the command line and the documentation are made. Imports nothing of FreeCAD.
"""

import math
import numbers
import re
from dataclasses import dataclass

from .errors import InvalidInput

METHODS = ("refine", "star", "sprinkle")
CONNECTIVITIES = ("pseudo-delaunay", "parametric")
INSERTIONS = ("off-centre", "paper")
KEPT_EDGES = ("all", "feature")
OPERATIONS = ("union", "intersection", "difference", "symmetric_difference")
BOOLEAN_METHODS = ("default", "uniform")


@dataclass(frozen=True)
class Option:
    """One option. `low` itself is not allowed where `above` is set; None stands for `unset`.

    In panels it is called `title`, and its choices as `choice_titles` says; `rare` ones are folded
    away there.
    """

    name: str
    kind: type
    default: object
    help: str
    unit: str = ""
    low: float = None
    high: float = None
    above: bool = True
    choices: tuple = ()
    group: str = "Mesh"
    unset: str = "any"
    title: str = ""
    choice_titles: tuple = ()
    rare: bool = False

    @property
    def is_sizes(self):
        """Whether it is a dict of lengths by sub-elements, such as {"Face3": 0.5}."""
        return self.kind is dict

    @property
    def property_name(self):
        """The name of its property on document objects: min_angle -> MinAngle."""
        return "".join(word.capitalize() for word in self.name.split("_"))

    @property
    def property_type(self):
        """The type of its property on document objects."""
        if self.choices:
            return "App::PropertyEnumeration"
        if self.unit:
            return {"degrees": "App::PropertyAngle", "mm": "App::PropertyLength"}[self.unit]
        return {
            bool: "App::PropertyBool", int: "App::PropertyInteger", float: "App::PropertyFloat",
            dict: "App::PropertyString",
        }[self.kind]

    @property
    def property_help(self):
        """What the property says of itself."""
        return self.help if self.default is not None else f"{self.help}; 0: {self.unset}"

    @property
    def flag(self):
        """Its name on the command line: min_angle -> --min-angle."""
        return "--" + self.name.replace("_", "-")

    @property
    def range_text(self):
        """What values are allowed, in words."""
        if self.choices:
            return "one of " + ", ".join(self.choices)
        if self.kind is bool:
            return "True or False"
        if self.is_sizes:
            return "lengths in mm greater than 0 by sub-elements, such as Face3=0.5, Edge7=0.2"
        unit = f" {self.unit}" if self.unit else ""
        parts = []
        if self.low is not None:
            parts.append(f"{'greater than' if self.above else 'at least'} {self.low:g}")
        if self.high is not None:
            parts.append(f"at most {self.high:g}")
        return " and ".join(parts) + unit

    def checked(self, value):
        """The value as a plain int, float, bool, str, dict or None.

        Raises InvalidInput naming the option, the value and the range.
        """
        if value is None and self.default is None:
            return None
        if self.is_sizes:
            return _checked_sizes(value, self)
        if self.choices:
            good = isinstance(value, str) and value in self.choices
        elif self.kind is bool:
            good = isinstance(value, bool)
        else:
            value = _plain_number(value, self)
            good = self._in_range(value)
        if not good:
            raise InvalidInput(f"{self.name} = {value!r} is not allowed: it must be "
                               f"{self.range_text}")
        return value

    def _in_range(self, value):
        if not math.isfinite(value):
            return False
        if self.low is not None and (value <= self.low if self.above else value < self.low):
            return False
        return self.high is None or value <= self.high


def _plain_number(value, option):
    """Takes numbers of Python and NumPy, and quantities; of an int option no fractions."""
    if type(value).__name__ == "Quantity" and hasattr(value, "Unit"):
        expected = {"degrees": "Angle", "mm": "Length"}.get(option.unit)
        if value.Unit.Type not in (expected, ""):
            raise InvalidInput(f"{option.name} = {value} is not allowed: it must be "
                               f"{option.range_text}")
        value = value.Value
    wanted = numbers.Integral if option.kind is int else numbers.Real
    if isinstance(value, bool) or not isinstance(value, wanted):
        what = "a whole number" if option.kind is int else "a number"
        raise InvalidInput(f"{option.name} = {value!r} is not allowed: it must be {what}, "
                           f"{option.range_text}")
    return option.kind(value)


def _checked_sizes(value, option):
    """{sub-element: mm} of such a dict, or of its text."""
    sizes = sizes_of_text(value) if isinstance(value, str) else value
    try:
        found = {str(name): float(getattr(length, "Value", length))
                 for name, length in dict(sizes).items()}
    except (TypeError, ValueError):
        found = None
    if found is None or not all(_SUB_ELEMENT.fullmatch(name) and math.isfinite(length) and length > 0
                                for name, length in found.items()):
        raise InvalidInput(f"{option.name} = {value!r} is not allowed: it must be "
                           f"{option.range_text}")
    return found or None


_SUB_ELEMENT = re.compile(r"(Vertex|Edge|Face)([1-9]\d*)")
_SIZE = re.compile(r"(\w+)\s*=\s*([^\s=]+)\s*(?:mm)?")


def sizes_of_text(text):
    """A list of pairs of "Face3=0.5 mm, Edge7=0.2": what it says, not whether that makes sense."""
    parts = [part for part in re.split("[,;]", text) if part.strip()]
    pairs = [_SIZE.fullmatch(part.strip()) for part in parts]
    return [pair.groups() if pair else (part, None) for pair, part in zip(pairs, parts)]


def text_of_sizes(sizes):
    """The text of {"Face3": 0.5}."""
    return ", ".join(f"{name}={length:g}" for name, length in (sizes or {}).items())


def entities_of(sizes):
    """[(dimension, index, mm), ...] of {"Face3": 0.5}."""
    found = [(_SUB_ELEMENT.fullmatch(name), length) for name, length in (sizes or {}).items()]
    return [(("Vertex", "Edge", "Face").index(match[1]), int(match[2]) - 1, length)
            for match, length in found]


TRIANGULATE = (
    Option("min_angle", float, 25.0, unit="degrees", low=0.0, high=34.0, title="Smallest angle",
           help="No triangle gets a smaller angle than this, unless the part has a sharper corner; beyond "
                "about 30 many more triangles are needed"),
    Option("chord_height", float, None, unit="mm", low=0.0, group="Accuracy",
           title="Distance to the shape",
           help="Largest distance between the mesh and the shape"),
    Option("chord_height_relative", float, None, low=0.0, high=1.0, group="Accuracy",
           title="Or as a part of the size",
           help="The same as a part of the shape's largest dimension: 0.001 is a thousandth"),
    Option("max_edge", float, None, unit="mm", low=0.0, group="Size", title="Longest edge",
           help="Longest edge of a triangle"),
    Option("local_sizes", dict, None, group="Size", title="Shorter edges on", unset="nowhere",
           help="Longest edge on single faces, edges or around vertices: Face3=0.5, Edge7=0.2"),
    Option("min_edge", float, None, unit="mm", low=0.0, group="Size", title="Shortest edge",
           rare=True, help="No edge is split into shorter ones than this"),
    Option("edges_per_circle", float, None, low=3.0, above=False, group="Size",
           title="Edges on a full circle", rare=True,
           help="Bent edges and faces get at least so many edges for each full turn: 12 to 36 is usual"),
    Option("growth", float, None, low=1.0, group="Size", title="Growth of edges", rare=True,
           help="How many times longer than their neighbours edges become on the way from fine places to "
                "coarse ones: 1.2 is slow, 2 is fast"),
    Option("method", str, "refine", choices=METHODS, title="Method", rare=True,
           choice_titles=("refine where needed", "sample in hexagons", "sample at random"),
           help="refine inserts points until every angle and distance fits; star (hexagons) and "
                "sprinkle (random points) first lay points on the faces, denser where they bend"),
    Option("insertion", str, "off-centre", choices=INSERTIONS, title="New points",
           rare=True, choice_titles=("few triangles", "as Aftosmis 1999"),
           help="Where a triangle with a small angle gets its new point: off-centre needs fewer "
                "triangles, paper is the rule of Aftosmis 1999"),
    Option("keep_edges", str, "all", choices=KEPT_EDGES, title="Edges of the shape", rare=True,
           choice_titles=("keep all", "keep sharp ones"),
           help="Which edges of the shape the mesh follows: all, or feature: not those that the "
                "surface crosses smoothly, which triangles then may span"),
    Option("feature_angle", float, 10.0, unit="degrees", low=0.0, high=40.0,
           title="Edges are smooth below", rare=True,
           help="With keep_edges = feature: edges are smooth where the surface turns by less than this"),
    Option("max_triangles", int, None, low=1, above=False, group="Size", title="Most triangles",
           rare=True, unset="5 million", help="Work ends, incomplete, at this number"),
    Option("allow_missing_faces", bool, False, title="Leave out faces that fail", rare=True,
           help="Mesh the rest of a part whose faces fail, and name those in the report"),
    Option("connectivity", str, "pseudo-delaunay", choices=CONNECTIVITIES, group="Sampling",
           title="Samples are joined", rare=True,
           choice_titles=("in space", "in face parameters"),
           help="How samples are joined: pseudo-delaunay in space, parametric in (u, v)"),
    Option("polish", bool, True, group="Sampling", title="Refine after sampling", rare=True,
           help="Refine after sampling, so that the bounds on angle and distance hold"),
    Option("seed", int, 0, low=0, high=2**31 - 1, above=False, group="Sampling",
           title="Random seed", rare=True,
           help="Of the random points of sprinkle; the same seed gives the same mesh"),
)


CURVE = (
    Option("order", int, 2, low=1, high=5, above=False, title="Order of the elements",
           help="1: straight sides; 2: quadratic elements, which most FEM programs want; at most 5, "
                "with tetrahedra 4"),
    Option("volume", bool, False, title="Fill solids with tetrahedra",
           help="Fill the solids with tetrahedra"),
    Option("straighten", bool, False, title="Straighten faulty elements",
           help="Make those elements straight that fold over and cannot be repaired"),
    Option("min_angle", float, 20.0, unit="degrees", low=0.0, high=34.0, group="Before curving",
           title="Smallest angle",
           help="Smallest angle of the triangles before they are curved"),
    Option("chord_height", float, None, unit="mm", low=0.0, group="Before curving",
           unset="not given", title="Distance to the shape",
           help="Largest distance between the mesh and the shape before it is curved"),
    Option("chord_height_relative", float, None, low=0.0, high=1.0, group="Before curving",
           unset="not given", title="Or as a part of the size",
           help="The same as a part of the shape's largest dimension; 0.01 unless one is given"),
    Option("max_edge", float, None, unit="mm", low=0.0, group="Before curving", title="Longest edge",
           help="Longest edge of the mesh before it is curved"),
)


# Of the document object, beside those of CURVE.
CURVED_DISPLAY = (
    Option("deviation", float, None, unit="mm", low=0.0, group="Display",
           unset="size / 1000", title="Display accuracy",
           help="Largest distance between the triangles shown and the curved elements"),
)


BOOLEAN = (
    Option("operation", str, "union", choices=OPERATIONS, group="Boolean", title="Operation",
           choice_titles=("join", "keep the common part", "cut off", "keep what is in one only"),
           help="What is done with the operands, one after the other from the first on"),
    Option("resolution", int, 512, low=8, high=65536, above=False, group="Boolean",
           title="Resolution",
           help="Into how many parts the longest side is cut: more parts follow the operands more "
                "closely and take longer. Gives the tolerance where that is 0"),
    Option("tolerance", float, None, unit="mm", low=0.0, group="Boolean", title="Tolerance",
           unset="by resolution",
           help="Largest distance of the result from the exact one"),
    Option("method", str, "default", choices=BOOLEAN_METHODS, group="Boolean", title="Method",
           rare=True, choice_titles=("exact intersection", "sampling (Wang 2010)"),
           help="Algorithm: default divides triangles along the exact intersection; uniform is the "
                "sampling scheme of Wang 2010, for two operands"),
)


IMPROVE = (
    Option("min_angle", float, 25.0, unit="degrees", low=0.0, high=34.0, title="Smallest angle",
           help="Smallest angle that every triangle is to reach"),
    Option("tolerance", float, None, unit="mm", low=0.0, group="Accuracy", title="Tolerance",
           unset="size / 1000", help="Largest distance between the mesh and its better version"),
    Option("feature_angle", float, 35.0, unit="degrees", low=0.0, high=180.0, group="Accuracy",
           title="Edges are sharp from",
           help="Edges where the surface turns by more than this stay where they are"),
)


@dataclass(frozen=True)
class Preset:
    """Values that go together; `title` is a word for the box at the top of a panel."""

    title: str
    values: dict


def _fineness(title, relative, **values):
    return Preset(title, {"chord_height": None, "chord_height_relative": relative,
                          "max_edge": None, **values})


# From coarse to fine, by the distance to the shape as a part of its largest dimension.
TRIANGULATE_PRESETS = (
    _fineness("Coarse", 0.01), _fineness("Medium", 0.003), _fineness("Fine", 0.001),
    _fineness("Very fine", 0.0003),
)
CURVE_PRESETS = (
    _fineness("Coarse", 0.03, order=2), _fineness("Medium", 0.01, order=2),
    _fineness("Fine", 0.005, order=3), _fineness("Very fine", 0.001, order=3),
)
FIRST_PRESET = "Medium"  # where nothing was chosen yet


def check(table, values):
    """All options of `table` as {name: plain value}, those not in `values` with their default.

    Raises InvalidInput naming the option, its value and its range.
    """
    known = {option.name: option for option in table}
    for name in values:
        if name not in known:
            raise InvalidInput(f"{name} is not an option: there are {', '.join(known)}")
    checked = {name: option.checked(values.get(name, option.default))
               for name, option in known.items()}
    _check_sizes(checked)
    return checked


def _check_sizes(values):
    chord, relative = values.get("chord_height"), values.get("chord_height_relative")
    if chord is not None and relative is not None:
        raise InvalidInput(f"chord_height = {chord:g} mm and chord_height_relative = {relative:g} "
                           "exclude each other: give one of them")
    low, high = values.get("min_edge"), values.get("max_edge")
    if low is not None and high is not None and low > high:
        raise InvalidInput(f"min_edge = {low:g} mm is longer than max_edge = {high:g} mm")


def to_property(option, value):
    """The value that stands for `value` in a document object's property: 0 for no bound."""
    if option.is_sizes:
        return text_of_sizes(value)
    return 0 if value is None else value


def hand_over(values, core_options):
    """Sets {option: value} on an object of the core, which has 0 for no bound."""
    for name, value in values.items():
        setattr(core_options, name, 0 if value is None else value)


def from_property(option, value):
    """The option's value that a property holds; the inverse of to_property."""
    if option.is_sizes:
        return option.checked(value)
    value = getattr(value, "Value", value)
    return None if option.default is None and value == 0 else value
