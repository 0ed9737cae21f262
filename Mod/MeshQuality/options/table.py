# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of every operation: one table, from which the properties of document objects, the
task panels, the command line and the documentation are made. Imports nothing of FreeCAD.
"""

import functools
import json
import math
import numbers
from dataclasses import dataclass, field, replace

from .. import element_names, phrases
from ..errors import InvalidInput
from ..phrases import Text
from . import named_values

METHODS = ("refine", "star", "sprinkle")
CONNECTIVITIES = ("pseudo-delaunay", "parametric")
INSERTIONS = ("off-centre", "circumcentre")
KEPT_EDGES = ("all", "feature")
EVALUATIONS = ("fast", "native")
OVERLAPS = ("refuse", "allow")
OPERATIONS = ("union", "intersection", "difference", "symmetric_difference")
BOOLEAN_METHODS = ("default", "exact", "uniform")

# The bound on the distance is given by one of two options.
DISTANCE = ("chord_height", "chord_height_relative")
MUST_BE_GIVEN = "must be given"  # the text for a required option that is unset
NO_BOUND = "none"  # the value of chord_height for no bound
RELATIVE, ABSOLUTE, UNBOUNDED = "Relative", "Absolute", "None"
BOUNDS = (RELATIVE, ABSOLUTE, UNBOUNDED)  # values of the property DistanceBound


@dataclass(frozen=True)
class Option:
    """One option. `low` itself is not allowed where `above` is set; None stands for `unset`.

    In panels it is called `title`, and its choices as `choice_titles` says; `rare` ones are folded away there. `only_with` is
    (name of another option, values of that one with which this one has an effect); empty: always. `alias` is the name that it
    had in older versions, `choice_aliases` are those of its choices, {older: present}: scripts, command lines and documents may
    go on using them. `suggested` is what a panel begins with: (fraction of the size of the part, mm at most).
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
    only_with: tuple = ()
    alias: str = ""
    choice_aliases: dict = field(default_factory=dict, hash=False)
    suggested: tuple = ()

    @property
    def is_sizes(self):
        """Whether it is a dict of lengths by sub-elements, such as {"Face3": 0.5}."""
        return self.kind is dict

    @property
    def is_faces(self):
        """Whether it is a list of names of faces, such as ["Face3", "Face7"]."""
        return self.kind is list

    @property
    def is_fields(self):
        """Whether it is a list of names of document objects, or of paths of files, that give sizes by place."""
        return self.kind is tuple

    @property
    def is_required(self):
        """Whether there is no operation without it."""
        return self.unset == MUST_BE_GIVEN

    @property
    def is_distance(self):
        """Whether it is one of the two that give the bound on the distance."""
        return self.name in DISTANCE

    @property
    def can_be_unbounded(self):
        """Whether its value may be NO_BOUND."""
        return self.name == DISTANCE[0]

    @property
    def is_of_one_part(self):
        """Whether its value makes sense for the part that it was given for only: a length, or names of
        sub-elements.
        """
        return self.unit == "mm" or self.is_sizes or self.is_faces or self.is_fields

    @property
    def property_name(self):
        """The name of its property on document objects: min_angle -> MinAngle."""
        return _property_name(self.name)

    @property
    def alias_property_name(self):
        """The name of the property in documents of older versions."""
        return _property_name(self.alias)

    @property
    def property_choices(self):
        """The values that the property accepts, with older names of choices."""
        return [*self.choices, *self.choice_aliases]

    @property
    def property_type(self):
        """The type of its property on document objects."""
        if self.choices:
            return "App::PropertyEnumeration"
        if self.unit:
            length = "App::PropertyDistance" if self.low is None else "App::PropertyLength"  # which is never below 0
            return {"degrees": "App::PropertyAngle", "mm": length}[self.unit]
        return {
            bool: "App::PropertyBool", int: "App::PropertyInteger", float: "App::PropertyFloat",
            dict: "App::PropertyString", list: "App::PropertyStringList", tuple: "App::PropertyLinkListGlobal",
        }[self.kind]

    @property
    def property_help(self):
        """The description of the property."""
        told = self.default is not None or self.is_distance or self.is_sizes or self.is_faces or self.is_fields or self.is_required
        return self.help if told else f"{self.help}; 0: {self.unset}"

    @property
    def flag(self):
        """Its name on the command line: min_angle -> --min-angle."""
        return _flag(self.name)

    @property
    def alias_flag(self):
        """The name of its alias on the command line."""
        return _flag(self.alias)

    @property
    def range_text(self):
        """The allowed values, in words."""
        if self.choices:
            return Text(phrases.ONE_OF, list=", ".join(self.choices))
        if self.kind is bool:
            return "True or False"
        if self.is_sizes:
            return Text(phrases.LOCAL_SIZES)
        if self.is_faces:
            return Text(phrases.FACE_NAMES)
        if self.is_fields:
            return Text(phrases.FIELD_NAMES)
        is_length = self.unit == "mm"
        unit = "" if is_length or not self.unit else f" {self.unit}"
        end = f", or {NO_BOUND!r}" if self.can_be_unbounded else ""
        bounds = [(words, bound) for words, bound in (("greater than" if self.above else "at least", self.low),
                                                      ("at most", self.high)) if bound is not None]
        if not bounds:
            return Text(phrases.ANY_LENGTH)
        names = [f"{'length' if is_length else 'number'}{'' if i == 0 else i + 1}" for i in range(len(bounds))]
        phrase = " and ".join(f"{words} {{{name}}}" for (words, _), name in zip(bounds, names)) + unit + end
        return Text(phrase, **{name: f"{bound:.10g}{' mm' if is_length else ''}"
                               for (_, bound), name in zip(bounds, names)})

    def checked(self, value):
        """The value as a plain int, float, bool, str, dict or None.

        Raises InvalidInput naming the option, the value and the range.
        """
        if value is None and (self.default is None or self.is_distance):
            return None
        if self.can_be_unbounded and _says_unbounded(value):
            return NO_BOUND
        if self.is_sizes:
            return named_values.checked_sizes(value, self)
        if self.is_faces:
            return named_values.checked_faces(value, self)
        if self.is_fields:
            return named_values.checked_fields(value, self)
        if self.choices:
            good = isinstance(value, str) and value in self.property_choices
            value = self.choice_aliases.get(value, value) if good else value
        elif self.kind is bool:
            good = isinstance(value, bool)
        else:
            value = _plain_number(value, self)
            good = self._in_range(value)
        if not good:
            raise self._not_allowed(value)
        return value

    def _not_allowed(self, value):
        """The error of a value out of range."""
        if self.unit == "mm" and isinstance(value, (int, float)):
            said = Text(phrases.LENGTH_NOT_ALLOWED, option=self.name, length=f"{value!r} mm", range=self.range_text)
        else:
            said = Text(phrases.NOT_ALLOWED, option=self.name, value=repr(value), range=self.range_text)
        return InvalidInput(said)

    def _in_range(self, value):
        if isinstance(value, float) and not math.isfinite(value):
            return False
        if self.low is not None and (value <= self.low if self.above else value < self.low):
            return False
        return self.high is None or value <= self.high


def _property_name(name):
    return "".join(word.capitalize() for word in name.split("_"))


def _flag(name):
    return "--" + name.replace("_", "-")


def _says_unbounded(value):
    return value == NO_BOUND if isinstance(value, str) \
        else isinstance(value, numbers.Real) and value == math.inf


def _plain_number(value, option):
    """Takes numbers of Python and NumPy, and quantities; of an int option no fractions."""
    if type(value).__name__ == "Quantity" and hasattr(value, "Unit"):
        expected = {"degrees": "Angle", "mm": "Length"}.get(option.unit)
        if value.Unit.Type not in (expected, ""):
            raise InvalidInput(Text(phrases.NOT_ALLOWED, option=option.name, value=str(value), range=option.range_text))
        value = value.Value
    wanted = numbers.Integral if option.kind is int else numbers.Real
    try:
        if isinstance(value, wanted) and not isinstance(value, bool):
            return option.kind(value)
    except OverflowError:  # a whole number beyond the largest float
        return math.inf
    except (TypeError, ValueError):  # the type calls itself a number
        pass
    raise InvalidInput(Text(phrases.NOT_A_WHOLE_NUMBER if option.kind is int else phrases.NOT_A_NUMBER,
                            option=option.name, value=repr(value), range=option.range_text))


def _size_field(group):
    return Option("size_field", tuple, None, group=group, title="Size field", unset="none",
                  help="Lengths of edges by place: Size regions of the document, or files of points with columns x, y, z, size or of "
                       "meshes with an array of sizes; the least of all holds")


def _distance(relative, group, which):
    """The two options of the bound on the distance, by default relative to the size of the part."""
    return (
        Option("chord_height", float, None, unit="mm", low=0.0, group=group, title="Max. deviation",
               help=f"Max. deviation: largest distance between the {which} and the shape, as a length"),
        Option("chord_height_relative", float, relative, low=0.0, high=1.0, group=group,
               title="Relative deviation",
               help="Max. deviation from the shape, as a fraction of its largest dimension"),
    )


def _imprint(group):
    return Option("imprint", bool, False, title="Join bodies that touch", rare=True, group=group,
                  help="Give solids that share an area the same triangles on both sides, as analyses of "
                       "assemblies need; the report names the pairs")


def _overlap(group):
    return Option("overlap", str, "refuse", choices=OVERLAPS, title="Bodies that overlap", rare=True, group=group,
                  choice_titles=("are not met", "are allowed"),
                  help="Whether bodies of a shape that overlap, lie in one another or cross are a fault of the mesh, or allowed; "
                       "the report names them")


_SAMPLED = ("method", ("star", "sprinkle"))

TRIANGULATE = (
    Option("min_angle", float, 25.0, unit="degrees", low=0.0, high=34.0, title="Smallest angle",
           help="No triangle gets a smaller angle, except where the shape has a sharper corner; above "
                "30 degrees many more triangles are needed"),
    *_distance(0.003, "Accuracy", "mesh"),
    Option("max_edge", float, None, unit="mm", low=0.0, group="Size", title="Longest edge",
           unset="unlimited", help="Longest edge of a triangle"),
    Option("local_sizes", dict, None, group="Size", title="Local sizes", unset="nowhere",
           help="Longest edge on single faces, along edges or around vertices: Face3=0.5 mm, Edge7=0.2 mm; "
                "in containers and links with the path to the object: Box.Face3=0.5 mm"),
    _size_field("Size"),
    Option("min_edge", float, None, unit="mm", low=0.0, group="Size", title="Shortest edge",
           unset="unlimited", rare=True, help="No edge is split into shorter ones than this"),
    # Single precision does not tell more edges a circle from the circle: they are within 5e-8 of its radius.
    Option("edges_per_circle", float, None, low=3.0, high=10000.0, above=False, group="Size",
           title="Edges per full circle", rare=True, unset="no minimum",
           help="Smallest number of edges along each full turn of a curved edge or face: 12 to 36 is usual"),
    Option("growth_rate", float, None, low=1.0, group="Size", title="Growth rate", rare=True,
           alias="growth", unset="unlimited",
           help="Growth rate of edge length from fine to coarse regions: 1.2 is slow, 2 is fast"),
    Option("method", str, "refine", choices=METHODS, title="Method", group="Method", rare=True,
           choice_titles=("refine where needed", "sample in hexagons", "sample at random"),
           help="refine inserts points until every angle and distance fits; star (hexagons) and "
                "sprinkle (random points) first sample the faces, denser where they bend"),
    Option("insertion", str, "off-centre", choices=INSERTIONS, title="Point insertion",
           group="Method", rare=True, choice_titles=("off-centre", "circumcentre"),
           choice_aliases={"paper": "circumcentre"},
           help="Where a triangle with a small angle gets its new point: off-centre needs fewer "
                "triangles, circumcentre is the rule of Aftosmis 1999"),
    Option("order", str, "rounds", choices=("rounds", "worst first"), title="Order of insertion", group="Method", rare=True,
           only_with=("insertion", ("circumcentre",)),
           choice_titles=("rounds", "worst first"),
           help="Triangles with small angles get their points in rounds, which several threads share, or, with "
                "circumcentre, one after the other, the worst first, as in Aftosmis 1999"),
    Option("keep_edges", str, "all", choices=KEPT_EDGES, title="CAD edges to keep", group="Edges and corners", rare=True,
           choice_titles=("all", "only sharp ones"),
           help="CAD edges to keep: all, or only sharp ones (feature); triangles may then cross smooth "
                "edges"),
    Option("feature_angle", float, 10.0, unit="degrees", low=0.0, high=40.0,
           title="Feature angle", group="Edges and corners", rare=True, only_with=("keep_edges", ("feature",)),
           help="With keep_edges = feature: edges are smooth where the surface turns by less than this"),
    Option("corners", str, "auto", choices=("auto", "keep", "cut"), title="Narrow corners", group="Edges and corners", rare=True,
           choice_titles=("cut off where needed", "keep", "cut off"),
           help="Corners of faces below the smallest angle: keep them, each with one triangle of that angle; cut them off "
                "by a twentieth of the distance, where the faces beside them allow it; or do so (auto) where further "
                "triangles would be below the smallest angle"),
    Option("max_triangles", int, None, low=1, high=2**31 - 1, above=False, group="Size", title="Triangle limit",
           rare=True, unset="5 million", help="Stop at this number; the mesh is then incomplete"),
    Option("metric", str, "none", choices=("none", "curvature"), title="Stretched triangles", group="Method", rare=True, choice_titles=("no", "by curvature"),
           help="Triangles that are stretched along the direction in which the surface bends least, so that fewer keep the distance; the "
                "largest angle is bounded by 150 degrees then, instead of the smallest one"),
    Option("max_stretching", float, 5.0, low=1.0, high=100.0, above=False, title="Largest stretching", group="Method", rare=True, only_with=("metric", ("curvature",)),
           help="Longest length that a metric may want at a place, divided by the shortest"),
    Option("allow_missing_faces", bool, False, title="Skip faces that fail", group="Bodies and faces", rare=True,
           help="Mesh the other faces where some fail; the report names those that were skipped"),
    Option("sew", bool, True, title="Join loose faces", group="Bodies and faces", rare=True,
           help="Join faces that belong to no shell, as those of most IGES files, where their borders lie "
                "together; the report says how far apart they were"),
    _imprint("Bodies and faces"),
    _overlap("Bodies and faces"),
    Option("evaluation", str, "fast", choices=EVALUATIONS, title="Evaluation", group="Method", rare=True,
           choice_titles=("fast", "by OpenCASCADE alone"),
           help="How curves and surfaces are evaluated: fast by formulas and polynomial pieces, native by "
                "OpenCASCADE alone, which takes longer"),
    Option("connectivity", str, "pseudo-delaunay", choices=CONNECTIVITIES, group="Sampling",
           title="Connect samples", rare=True, only_with=_SAMPLED,
           choice_titles=("in space", "in face parameters"),
           help="How samples are connected: pseudo-delaunay in space, parametric in (u, v)"),
    Option("refine_samples", bool, True, group="Sampling", title="Refine after sampling", rare=True,
           only_with=_SAMPLED, alias="polish",
           help="Refine after sampling, so that the bounds on angle and distance hold"),
    Option("seed", int, 0, low=0, high=2**31 - 1, above=False, group="Sampling",
           title="Random seed", rare=True, only_with=("method", ("sprinkle",)),
           help="Random seed for the sprinkle method; the same seed gives the same mesh"),
)


CURVE = (
    Option("order", int, 2, low=1, high=5, above=False, title="Element order",
           help="1: straight sides; 2: quadratic elements, which most FEM programs want; at most 5, "
                "with tetrahedra 4"),
    Option("volume", bool, False, title="Fill solids with tetrahedra",
           help="Fill the solids with tetrahedra"),
    Option("straighten_invalid", bool, False, title="Straighten invalid elements", alias="straighten", rare=True,
           help="Straighten the elements that stay invalid after all repairs; they deviate more from the shape"),
    Option("min_angle", float, 20.0, unit="degrees", low=0.0, high=34.0, group="Before curving",
           title="Smallest angle",
           help="Smallest angle of the triangles before they are curved"),
    *_distance(0.01, "Before curving", "mesh before it is curved"),
    Option("max_edge", float, None, unit="mm", low=0.0, group="Before curving", title="Longest edge",
           unset="unlimited", help="Longest edge of the mesh before it is curved"),
    _size_field("Before curving"),
    _imprint("Before curving"),
    _overlap("Before curving"),
)


# Options of the document object, beside those of CURVE.
CURVED_DISPLAY = (
    Option("deviation", float, None, unit="mm", low=0.0, group="Display",
           unset="size / 1000", title="Display accuracy", rare=True,
           help="Largest distance between the flat triangles and the curved elements"),
)


# Changes no result, and so is no property of objects.
THREADS = Option("threads", int, 0, low=0, high=1024, above=False, group="Speed", title="Threads",
                 help="Threads that work at a time; 0: one for each core")
BOOLEAN = (
    Option("operation", str, "union", choices=OPERATIONS, group="Boolean", title="Operation",
           choice_titles=("Union", "Intersection", "Difference", "Symmetric difference"),
           help="Set operation, applied to the operands in their order; difference: the first one without the "
                "others"),
    Option("resolution", int, 512, low=8, high=65536, above=False, group="Boolean",
           title="Resolution",
           help="Cells along the longest side, or along 8 thicknesses of slender operands; sets the max. deviation if "
                "none is given"),
    Option("tolerance", float, None, unit="mm", low=0.0, group="Boolean", title="Max. deviation",
           unset="by resolution",
           help="Largest distance between the result and the exact Boolean"),
    Option("method", str, "default", choices=BOOLEAN_METHODS, group="Boolean", title="Method",
           rare=True, choice_titles=("exact where possible", "exact intersection", "sampling (Wang 2010)"),
           help="Algorithm: exact divides triangles along the exact intersection; uniform samples along rays (Wang "
                "2010), also operands that are open; default takes uniform where there is no exact result"),
    Option("full", bool, False, group="Boolean", title="Reconstruct everything", rare=True,
           help="Make the whole surface anew from the samples, so that no triangle of the operands stays; only with method "
                "uniform"),
)


IMPROVE = (
    Option("min_angle", float, 25.0, unit="degrees", low=0.0, high=34.0, title="Smallest angle",
           help="Target for the smallest angle of every triangle"),
    Option("tolerance", float, None, unit="mm", low=0.0, group="Accuracy", title="Max. deviation",
           unset="size / 1000", help="Largest distance between the given mesh and the improved one"),
    Option("feature_angle", float, 35.0, unit="degrees", low=0.0, high=180.0, group="Accuracy",
           title="Feature angle",
           help="Edges where the surface turns by more than this are sharp and keep their place"),
)


@dataclass(frozen=True)
class Preset:
    """Values that go together; `title` is a word for the box at the top of a panel."""

    title: str
    values: dict


def _fineness(title, relative, **values):
    return Preset(title, {"chord_height": None, "chord_height_relative": relative,
                          "max_edge": None, **values})


# From coarse to fine, by the distance to the shape as a fraction of its largest dimension. The medium one
# has the table's defaults.
TRIANGULATE_PRESETS = (
    _fineness("Coarse", 0.01), _fineness("Medium", 0.003), _fineness("Fine", 0.001),
    _fineness("Very fine", 0.0003),
)
CURVE_PRESETS = (
    _fineness("Coarse", 0.03, order=2), _fineness("Medium", 0.01, order=2),
    _fineness("Fine", 0.005, order=3), _fineness("Very fine", 0.001, order=3),
)
FIRST_PRESET = "Medium"  # the preset before any choice


def check(table, values):
    """All options of `table` as {name: plain value}, those not in `values` with their default.

    Of the two options that bound the distance one has a value and the other None; where both are None
    or missing the relative one has its default. chord_height is NO_BOUND where there is no bound.

    Raises InvalidInput naming the option, its value and its range.
    """
    known = {option.name: option for option in table}
    values = renamed(table, values)
    for name in values:
        if name not in known:
            raise InvalidInput(f"{name} is not an option: there are {', '.join(known)}")
    given = {option.name: values.get(option.name, None if option.is_distance else option.default)
             for option in table}
    checked = {name: known[name].checked(value) for name, value in given.items()}
    _check_sizes(checked)
    if has_distance(table) and all(checked[name] is None for name in DISTANCE):
        checked[DISTANCE[1]] = known[DISTANCE[1]].default
    return checked


def require_callable(progress):
    """Raises InvalidInput unless the progress is None or can be called."""
    if progress is not None and not callable(progress):
        raise InvalidInput(f"progress = {progress!r} is not callable: give a function of "
                           "(fraction, stage)")


def renamed(table, values, **others):
    """The values with the present names of options in place of their aliases; `others` are {alias: name} of
    arguments that are not in the table.

    Raises InvalidInput where an option is given by both names.
    """
    present = {**{option.alias: option.name for option in table if option.alias}, **others}
    for alias, name in present.items():
        if alias in values and name in values:
            raise InvalidInput(f"{alias} is the older name of {name}: give one of them")
    return {present.get(name, name): value for name, value in values.items()}


def takes_aliases(table, **others):
    """Has a function take options of the table, and the `others` of `renamed`, by their aliases, too."""
    def decorated(function):
        @functools.wraps(function)
        def call(*arguments, **values):
            return function(*arguments, **renamed(table, values, **others))

        return call

    return decorated


def _check_sizes(values):
    chord, relative = (values.get(name) for name in DISTANCE)
    if chord is not None and relative is not None:
        raise InvalidInput(Text(phrases.NO_BOUND_AND_BOUND, number=f"{relative:g}") if chord == NO_BOUND else
                           Text(phrases.TWO_BOUNDS, length=f"{chord:g} mm", number=f"{relative:g}"))
    low, high = values.get("min_edge"), values.get("max_edge")
    if low is not None and high is not None and low > high:
        raise InvalidInput(Text(phrases.MIN_ABOVE_MAX, length=f"{low:g} mm", length2=f"{high:g} mm"))


def has_distance(table):
    """Whether the operation bounds the distance to a shape."""
    return any(option.is_distance for option in table)


def defaults(table):
    """{option: value} of a call that gives none."""
    return {option.name: option.default for option in table}


def merged(values, changes):
    """The checked `values` with those of `changes`, by which a bound on the distance replaces one that
    is given the other way.
    """
    given = [name for name in DISTANCE if changes.get(name) is not None]
    replaced = dict.fromkeys(DISTANCE) if given and DISTANCE[0] in values else {}
    return {**values, **replaced, **changes}


def differing(values, known):
    """The checked `values` that differ from `known`, so that merged(known, differing(values, known)) is `values`."""
    return {name: value for name, value in values.items()
            if value != known[name] and not (name in DISTANCE and value is None)}


def bound_of(values):
    """Which of BOUNDS the checked values have."""
    chord = values[DISTANCE[0]]
    return RELATIVE if chord is None else UNBOUNDED if chord == NO_BOUND else ABSOLUTE


def hashed(values):
    """JSON text of checked values, for fingerprints, as older versions wrote it; options that they did not have only where used."""
    newer = {"size_field": None, **({"metric": "none"} if values.get("metric") == "none" else {}), **({"order": 1} if "layers" in values else {})}
    unused = {name for name, usual in newer.items() if values.get(name, usual) == usual} | ({"max_stretching"} if "metric" in newer else set())
    return json.dumps({name: None if value == NO_BOUND else value for name, value in _by_aliases(values).items() if name not in unused},
                      sort_keys=True)


def to_property(option, value):
    """The value that stands for `value` in a document object's property: 0 for no bound."""
    if option.is_sizes:
        return element_names.text_of_sizes(value)
    return value or [] if option.is_faces or option.is_fields else _number_of(value)


def hand_over(values, core_options):
    """Sets {option: value} on an object of the core, which has 0 for no bound and the older names."""
    for name, value in _by_aliases(values).items():
        setattr(core_options, name, _number_of(value))


_ALIASED = {option.name: option for option in TRIANGULATE + CURVE if option.alias or option.choice_aliases}


def _by_aliases(values):
    """Checked values with the older names of options and choices, where there are any."""
    found = {}
    for name, value in values.items():
        option = _ALIASED.get(name)
        if option is not None:
            name = option.alias or name
            value = {present: older for older, present in option.choice_aliases.items()}.get(value, value)
        found[name] = value
    return found


def _number_of(value):
    return 0 if value is None or value == NO_BOUND else value


def from_property(option, value):
    """The option's value that a property holds; the inverse of to_property, but for the bound on the
    distance, which takes bound_from_properties.
    """
    if option.is_sizes:
        return option.checked(value)
    if option.is_faces:
        return list(value) or None
    if option.is_fields:
        return [obj.Name for obj in value] or None
    value = getattr(value, "Value", value)
    return None if option.default is None and value == 0 else value


def bound_from_properties(bound, values):
    """The two options of the bound on the distance from the values of their properties; `bound`, one
    of BOUNDS, says which has an effect.
    """
    if bound not in BOUNDS:  # a script may give the property other choices
        raise InvalidInput(f"DistanceBound = {bound!r} is not allowed: it must be one of {', '.join(BOUNDS)}")
    chord, relative = (values[name] for name in DISTANCE)
    return {DISTANCE[0]: {ABSOLUTE: chord or 0.0, UNBOUNDED: NO_BOUND, RELATIVE: None}[bound],
            DISTANCE[1]: relative if bound == RELATIVE else None}
