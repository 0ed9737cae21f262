# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patches of document objects: named groups of the faces of their sources, kept beside the mesh and written with it."""

import json
import re

from .. import phrases
from ..compat import property_of
from ..core.sources import convert, frames
from ..errors import InvalidInput
from . import face_matching
from .properties import add_hidden, add_property

PATCHES, REST, CHANGED = "Patches", "PatchRest", "PatchesChanged"
_FACES = ("PatchFaces", "App::PropertyString",
          "What the faces of the sources were like when the patches were last right: their kinds, areas and centres")
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
    """The lines of the property for patches as patches= takes them."""
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


def give_patches(obj, faces, patches, patch_rest):
    """Sets the properties, of an object whose sources have these faces; raises InvalidInput where they are not possible, and
    then changes nothing.
    """
    faces.division(patches, patch_rest)
    lines = lines_of_patches(patches or {})
    held = patches_of_lines(lines)
    for name, read in zip(patches or {}, held):
        if name != read:
            raise InvalidInput(phrases.Text(phrases.PATCH_LIKE_COLOUR, value=repr(name)))
    for said in held.values():
        said["faces"] = [faces.kept_name(face) for face in said["faces"]]
    obj.Patches, obj.PatchRest, obj.PatchesChanged = lines_of_patches(held), patch_rest or "", []
    obj.PatchFaces = _saved(_described(faces)) if lines else ""


def follow_sources(obj, faces):
    """Finds the faces of the patches again in sources that have changed; returns sentences about those that it does not
    find.
    """
    if not obj.Patches:
        return []
    try:
        patches, before = patches_of_lines(obj.Patches), _read(obj.PatchFaces)
    except (InvalidInput, ValueError) as error:  # edited by hand
        lost = [phrases.Text(phrases.PATCHES_NOT_FOLLOWED, text=phrases.text_of(error))]
        obj.PatchesChanged = lost
        return lost
    now, lost = _described(faces), []
    for prefix in before:
        old, new = before[prefix], now.get(prefix, [])
        places = face_matching.followed(old, new)
        if places is not None:
            for name, said in patches.items():
                said["faces"] = [_followed(face, prefix, name, places, lost) for face in said["faces"]]
            obj.Patches = lines_of_patches(patches)
    obj.PatchesChanged = [*obj.PatchesChanged, *lost]  # listed until they are chosen anew
    obj.PatchFaces = _saved(now)
    return lost


def _described(faces):
    """{prefix of a source: what its faces are like}, but for meshes."""
    return {member.prefix: face_matching.described(convert.own_shape_of(member.source))
            for member in faces.members if member.count is not None}


def _saved(described):
    return json.dumps(described.get("", described))


def _read(text):
    found = json.loads(text or "{}")
    return found if isinstance(found, dict) else {"": found}


def _followed(face, prefix, patch, places, lost):
    """The present name of a face of a source; what is below a container keeps its own."""
    found = _FACE.fullmatch(face[len(prefix):]) if face.startswith(prefix) else None
    if not found:
        return face
    index = places.get(int(found[1]) - 1)
    if index is None:
        lost.append(phrases.Text(phrases.PATCH_LOST, face=face, name=repr(patch)))
        return face
    return f"{prefix}Face{index + 1}"
