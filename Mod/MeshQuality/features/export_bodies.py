# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of a document goes into a file: the visible bodies of the objects that FreeCAD names, by label and with colours."""

from typing import NamedTuple

import FreeCAD

from .. import phrases
from ..core.sources import convert, frames
from ..errors import InvalidInput
from ..phrases import Text
from .cured_mesh import has_fem_mesh
from .gui_hooks import window


class Body(NamedTuple):
    """A source, as in frames, with a shape or a mesh of its own; `colours` are red, green, blue from 0 to 255, one or one for
    each face, and none where there is no window.
    """

    source: object
    label: str
    colours: tuple


class Item(NamedTuple):
    """One of the objects that were named, and the bodies in it."""

    source: object
    label: str
    bodies: tuple


def items_of(objects):
    """The Items of document objects, without those that another one of them holds or is made of.

    Raises InvalidInput where none has faces or triangles.
    """
    objects = list(dict.fromkeys(objects))
    if not objects:
        raise InvalidInput(phrases.NOTHING_TO_EXPORT)
    used = {part for obj in objects for part in obj.OutListRecursive}
    items, empty, seen = [], [], set()
    for obj in objects:
        if any(container in objects for container in frames.containers_of(obj)) or obj in used and not obj.Visibility:
            continue
        bodies = tuple(_colourful(source) for source in _once(_bodies_in(obj), seen))
        (items if bodies else empty).append(Item(obj, _label_of(obj), bodies))
    if not items:
        convert.own_shape_of(objects[0])  # says what is missing
        raise InvalidInput(phrases.NOTHING_TO_EXPORT)
    if empty:
        text = window().translated(Text(phrases.LEFT_OUT_WITHOUT_FACES, list=[item.label for item in empty]))
        FreeCAD.Console.PrintLog(f"{text}\n")
    return items


def _once(sources, seen):
    """Those that do not stand where the same one was met before."""
    for source in sources:
        linked, matrix = frames.linked_of(source)
        key = linked, (frames.frame_of(source).toMatrix() * matrix).A
        if key not in seen:
            seen.add(key)
            yield source


def _bodies_in(source):
    """The sources of all that is visible in a source and has faces or triangles of its own; the source itself where it has."""
    leaf = frames.leaf_of(source)
    linked = leaf.getLinkedObject(True)
    if has_fem_mesh(linked) or convert.is_mesh(source) and linked.Mesh.CountFacets:
        yield source
    elif "Shape" in linked.PropertiesList and not getattr(leaf, "ElementCount", 0):
        if not linked.isDerivedFrom("Fem::FemMeshObject") and convert.has_faces(source):
            yield source
    elif not linked.isDerivedFrom("App::Origin"):
        for name, part in frames.held_by(source):
            if convert.is_visible(leaf, name):
                yield from _bodies_in(part)


def _label_of(source):
    """The label of an object in the tree; of the tip of a body that of the body."""
    leaf = frames.leaf_of(source)
    body = next(iter(frames.containers_of(leaf)), None)
    return body.Label if getattr(body, "Tip", None) == leaf else leaf.Label


def _colourful(source):
    leaf_view, view = (getattr(obj, "ViewObject", None) for obj in (frames.leaf_of(source), frames.linked_of(source)[0]))
    by_face = getattr(view, "DiffuseColor", None) or ()
    one = getattr(view, "ShapeColor", None)
    if getattr(leaf_view, "OverrideMaterial", False):  # of a link
        by_face, one = (), leaf_view.ShapeMaterial.DiffuseColor
    colours = by_face if len(set(by_face)) > 1 else (one,) if one else ()
    return Body(source, _label_of(source), tuple(tuple(round(255 * part) for part in colour[:3]) for colour in colours))
