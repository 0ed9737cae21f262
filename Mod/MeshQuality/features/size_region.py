# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object "Size region": how long edges are to be in a part of space."""

import math

import FreeCAD

from ..compat import PlainState
from ..core.sizes import regions
from ..core.sources import convert
from ..errors import InvalidInput
from .gui_hooks import window
from .properties import add_property
from .transactions import undo_step

INSIDE, NEAR, WAKE = KINDS = "Inside", "Near", "Wake"


class SizeRegion(PlainState):
    """Proxy of an App::FeaturePython: edges of meshes that name it are that long in its region."""

    def __init__(self, obj):
        obj.Proxy = self
        self.add_properties(obj)

    def add_properties(self, obj):
        """Adds those properties that the object has not got yet."""
        if add_property(obj, "App::PropertyEnumeration", "Kind", "Region",
                        "Inside: in the solids; Near: within a distance of the faces, edges and points; Wake: where the solids go if "
                        "they move along a direction"):
            obj.Kind = KINDS
        for kind, name, text in (
                ("App::PropertyLinkSubListGlobal", "Of", "The solids, faces, edges and points"),
                ("App::PropertyLength", "Size", "Length of edges in the region; of Near: at the faces, edges and points"),
                ("App::PropertyLength", "FarSize", "Length of edges at the distance, of Near"),
                ("App::PropertyLength", "Distance", "Where the region ends, of Near"),
                ("App::PropertyVector", "Direction", "Direction of a wake"),
                ("App::PropertyLength", "Length", "Length of a wake")):
            add_property(obj, kind, name, "Region", text)

    def onDocumentRestored(self, obj):
        """An object of an older version gets the properties that were added since."""
        self.add_properties(obj)
        window().attach_view(obj)

    def execute(self, obj):
        """What FreeCAD calls: meshes that name the object are computed again."""

    def size_fields(self, obj):
        """The fields of the region where its shapes are now. Raises InvalidInput naming the object and the property."""
        size = _length(obj, "Size")
        shapes = [shape for source, names in obj.Of for shape in _shapes_of(source, names)]
        if not shapes:
            raise InvalidInput(f"{obj.Label} has no shapes: choose solids, faces, edges or points for its property Of")
        if obj.Kind == NEAR:
            far = obj.FarSize.Value or size
            return [regions.Near(shapes, size, far, _length(obj, "Distance"), obj.Label)]
        if obj.Kind == WAKE:
            length, direction = _length(obj, "Length"), tuple(obj.Direction)
            return [regions.Wake(shape, size, direction, length, obj.Label) for shape in shapes]
        return [regions.Inside(shape, size, obj.Label) for shape in shapes]


def _length(obj, name):
    value = getattr(obj, name).Value
    if not value > 0.0:
        raise InvalidInput(f"{obj.Label} has a {name} of {value:g} mm: set its property {name} to more than 0 mm")
    return value


def _shapes_of(source, names):
    """The shapes of an object's sub-elements, where the document has them; without names its shape."""
    shape = convert.shape_of(source)
    names = [name for name in names if name]
    if not names:
        return [shape]
    found = []
    for name in names:
        try:
            found.append(shape.getElement(name.rpartition(".")[2]))
        except Exception as error:  # of OpenCASCADE or FreeCAD
            raise InvalidInput(f"{source.Label} has no {name}: select it again") from error
    return found


def add_size_region(source, size, kind="inside", distance=None, far_size=None, direction=None, length=None):
    """Adds a Size region to a document: size_field= of meshes takes it, and it follows its shapes; one undo step.

    source     a document object, (object, "Face3"), (object, ["Face3", "Edge7", "Vertex1"]), or a list of these
    size       mm: length of edges in the region; of "near" at the faces, edges and points
    kind       "inside" of the solids; "near" the faces, edges and points; "wake": where the solids go if they move
    distance   mm, of "near": where the region ends
    far_size   mm, of "near": the size there, to which sizes grow linearly; None: `size` all over
    direction  of a wake: a vector; length: how long the wake is, mm

    Returns the object, an App::FeaturePython with the properties Kind, Of, Size, Distance, FarSize, Direction and Length. Raises
    InvalidInput naming what is wrong, and then adds nothing.
    """
    title = {word.lower(): word for word in KINDS}.get(kind)
    if title is None:
        raise InvalidInput(f"kind = {kind!r} is not allowed: it must be one of {', '.join(word.lower() for word in KINDS)}")
    pairs = [_pair(one) for one in (source if isinstance(source, list) else [source])]
    document = pairs[0][0].Document
    values = {"Size": size, "Distance": distance, "FarSize": far_size, "Length": length}
    needed = {"Size", *({"Distance"} if title == NEAR else {"Length"} if title == WAKE else ())}
    for name, value in values.items():
        _require_length(name, value, name in needed)
    if title == WAKE and direction is None:
        raise InvalidInput("a wake needs direction=, a vector")
    with undo_step(document, "Size region"):
        obj = document.addObject("App::FeaturePython", "SizeRegion")
        try:
            SizeRegion(obj)
            obj.Label, obj.Kind, obj.Of = f"Size region of {pairs[0][0].Label}", title, pairs
            for name, value in values.items():
                setattr(obj, name, 0.0 if value is None else value)
            if direction is not None:
                obj.Direction = FreeCAD.Vector(*direction)
            obj.Proxy.size_fields(obj)
            window().attach_view(obj)
            obj.recompute()
            obj.purgeTouched()
        except BaseException:
            document.removeObject(obj.Name)
            raise
    return obj


def _require_length(name, value, needed):
    said = {"Size": "size", "Distance": "distance", "FarSize": "far_size", "Length": "length"}[name]
    if value is None and not needed:
        return
    good = isinstance(getattr(value, "Value", value), (int, float)) and 0 < getattr(value, "Value", value) < math.inf
    if not good:
        raise InvalidInput(f"{said} = {value!r} is not allowed: it must be a length above 0 mm")


def _pair(source):
    obj, names = source if isinstance(source, tuple) else (source, ())
    if not isinstance(obj, FreeCAD.DocumentObject):
        raise InvalidInput(f"a region is made of document objects with shapes, not of {type(obj).__name__}")
    return obj, [names] if isinstance(names, str) else list(names) or [""]
