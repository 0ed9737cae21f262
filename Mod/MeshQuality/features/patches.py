# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patches of document objects: named groups of the faces of their source, kept beside the mesh and written with it."""

import json
import re

from .. import phrases
from ..compat import property_of
from ..core import convert, frames
from ..core.patches import division_for
from ..errors import InvalidInput
from . import face_matching
from .properties import add_hidden, add_property

PATCHES, REST, CHANGED = "Patches", "PatchRest", "PatchesChanged"
_FACES = ("PatchFaces", "App::PropertyString",
          "What the faces of the source were like when the patches were last right: their kinds, areas and centres")
_LINE = re.compile(r"(?P<name>[^:]*?)\s*(?P<colour>#[0-9a-fA-F]{6})?\s*:(?P<faces>[^:]*)")
_FACE = re.compile(r"Face([1-9][0-9]{0,8})")


def add_patch_properties(obj):
    """Adds those that the object has not got yet."""
    add_property(obj, "App::PropertyStringList", PATCHES, "Patches",
                 "Named groups of faces, one a line: \"inlet: Face1, Face4\", or with a colour \"inlet #ff0000: Face1\"")
    add_property(obj, "App::PropertyString", REST, "Patches",
                 "Name of the patch of all other faces; empty: each is one by its own name")
    add_property(obj, "App::PropertyStringList", CHANGED, "Patches",
                 "Faces of patches that an edit of the source may have exchanged; choose them anew")
    obj.setEditorMode(CHANGED, 1)
    add_hidden(obj, "Patches", (_FACES,))


def patches_of_lines(lines):
    """{name: {"faces": [...], "colour": "#ff0000"}} of the property; raises InvalidInput naming the line."""
    found = {}
    for line in lines:
        if not line.strip():
            continue
        parts = _LINE.fullmatch(line.strip())
        if not parts or not parts["name"]:
            raise InvalidInput(phrases.Text(phrases.PATCH_LINE, value=repr(line)))
        if parts["name"] in found:
            raise InvalidInput(phrases.Text(phrases.PATCHES_ALIKE, name=repr(parts["name"])))
        faces = [face.strip() for face in parts["faces"].split(",")]
        found[parts["name"]] = {"faces": [face for face in faces if face]}
        if parts["colour"]:
            found[parts["name"]]["colour"] = parts["colour"]
    return found


def lines_of_patches(patches):
    """The inverse, of what patches= takes."""
    lines = []
    for name, said in patches.items():
        faces, colour = (said["faces"], said.get("colour")) if hasattr(said, "items") else (said, None)
        lines.append(f"{name}{f' {colour}' if colour else ''}: {', '.join(faces)}")
    return lines


def patches_of_object(obj):
    """(patches, patch_rest) of a document object, as write and export_mesh take them; (None, None): it has none."""
    obj = frames.linked_of(obj)[0]
    patches = patches_of_lines(property_of(obj, PATCHES) or []) if PATCHES in obj.PropertiesList else {}
    rest = property_of(obj, REST) or None if REST in obj.PropertiesList else None
    return patches or None, rest


def give_patches(obj, source, patches, patch_rest):
    """Sets the properties; raises InvalidInput where they are not possible, and then changes nothing."""
    division_for(source, patches, patch_rest)
    lines = lines_of_patches(patches or {})
    for name, held in zip(patches or {}, patches_of_lines(lines)):
        if name != held:
            raise InvalidInput(phrases.Text(phrases.PATCH_LIKE_COLOUR, value=repr(name)))
    obj.Patches, obj.PatchRest, obj.PatchesChanged = lines, patch_rest or "", []
    obj.PatchFaces = face_matching.described(convert.own_shape_of(source)) if lines else ""


def follow_source(obj, source):
    """Finds the faces of the patches again in a source that has changed; returns sentences about those that it does not
    find.
    """
    if not obj.Patches:
        return []
    try:
        patches, before = patches_of_lines(obj.Patches), json.loads(obj.PatchFaces or "[]")
    except (InvalidInput, ValueError) as error:  # edited by hand
        lost = [phrases.Text(phrases.PATCHES_NOT_FOLLOWED, text=phrases.text_of(error))]
        obj.PatchesChanged = lost
        return lost
    described = face_matching.described(convert.own_shape_of(source))
    now, lost = json.loads(described), []
    if before and [face[0] for face in before] != [face[0] for face in now]:
        places = face_matching.same_faces(before, now)
        for name, said in patches.items():
            said["faces"] = [_followed(face, name, places, lost) for face in said["faces"]]
        obj.Patches = lines_of_patches(patches)
    obj.PatchesChanged = [*obj.PatchesChanged, *lost]  # until they are chosen anew
    obj.PatchFaces = described
    return lost


def _followed(face, patch, places, lost):
    """The present name of a face; what is below a container keeps its own."""
    found = _FACE.fullmatch(face)
    if not found:
        return face
    index = places.get(int(found[1]) - 1)
    if index is None:
        lost.append(phrases.Text(phrases.PATCH_LOST, face=face, name=repr(patch)))
        return face
    return f"Face{index + 1}"
