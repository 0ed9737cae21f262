# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patches that a document knows already: by the labels of parts, the colours of faces, or what an analysis refers to."""

import re

import FreeCAD

from ... import phrases
from ...errors import InvalidInput
from ..sources import convert, frames

KINDS = ("labels", "colours", "analysis")


def suggested_patches(source, by, analysis=None):
    """Patches of a source as the document has them, for patches= and set_patches.

    source    document object with a shape: feature, body, link or container
    by        "labels": one for each part of a container; "colours": one for each colour of faces, in the window;
              "analysis": one for each constraint of an analysis (FEM or CfdOF) that refers to faces of the source
    analysis  an analysis of the document; None: all that it has

    Returns {name: {"faces": [...]}}, with colours by "colours". Raises InvalidInput where there are none.
    """
    if by not in KINDS:
        raise InvalidInput(f"by = {by!r} is not possible: give one of {', '.join(map(repr, KINDS))}")
    if not isinstance(frames.object_of(source), FreeCAD.DocumentObject):
        raise InvalidInput(f"a document object with a shape is needed, not {type(source).__name__}")
    found = {"labels": _by_labels, "colours": _by_colours,
             "analysis": lambda given: _by_analysis(given, analysis)}[by](source)
    if not found:
        raise InvalidInput(phrases.Text(phrases.NO_PATCHES[by], name=convert.label_of(source)))
    return found


def suggested_for(members, by):
    """Suggested patches of all sources of a mesh, members of source_faces, by the names of faces in the mesh. By
    labels, each of several sources that is no container is one patch.
    """
    found, refused = {}, InvalidInput(phrases.Text(phrases.NO_PATCHES[by], name=", ".join(
        convert.label_of(member.source) for member in members)))
    for member in members:
        try:
            patches = _of_one_of_several(member) if by == "labels" and member.prefix else suggested_patches(member.source, by)
        except InvalidInput as error:
            refused, patches = error, {}
        for name, said in patches.items():
            _add(found, name, [f"{member.prefix}{face}".rstrip(".") for face in said["faces"]], said.get("colour"))
    if not found:
        raise refused
    return found


def _of_one_of_several(member):
    if member.count is not None and any(frames.leaf_paths(frames.leaf_of(member.source))):
        return suggested_patches(member.source, "labels")
    faces = [""] if member.count is None else [f"Face{k + 1}" for k in range(member.count)]
    return {plain_name(frames.leaf_of(member.source).Label): {"faces": faces}}


def plain_name(label):
    """A label as a name that all formats can hold."""
    name = re.sub(r"\W+", "_", label, flags=re.ASCII).strip("_")
    return name if name[:1].isalpha() else f"patch_{name}".rstrip("_")


def _another(name, taken):
    """The name, with a number if another patch has it: labels may differ only in letters that names of patches cannot have."""
    number = 2
    plain = name
    while name in taken:
        name, number = f"{plain}_{number}", number + 1
    return name


def _add(found, name, faces, colour=None):
    """Adds faces that are in no patch yet."""
    taken = {face for said in found.values() for face in said["faces"]}
    faces = [face for face in dict.fromkeys(faces) if face not in taken]
    if faces:
        said = found.setdefault(name, {"faces": []})
        said["faces"] += faces
        if colour:
            said["colour"] = colour


def _by_labels(source):
    import Part

    found, finder = {}, convert.ElementFinder(convert.own_shape_of(source), "Face")
    obj, start = frames.object_of(source), frames.path_of(source)
    for path in frames.leaf_paths(frames.leaf_of(source)):
        name = _another(plain_name(obj.getSubObject(start + path, retType=1).Label), found)
        faces = map(finder.name_of, Part.getShape(obj, start + path).Faces)
        _add(found, name, [face for face in faces if face])
    return found


def _by_colours(source):
    obj = frames.linked_of(source)[0]
    view = getattr(obj, "ViewObject", None)
    colours = list(getattr(view, "DiffuseColor", ()))
    count = convert.own_shape_of(source).countElement("Face")
    found = {}
    if len(colours) != count or len(set(colours)) < 2:
        return found
    for index, colour in enumerate(colours, 1):
        text = "".join(f"{round(255 * part):02x}" for part in colour[:3])
        _add(found, f"colour_{text}", [f"Face{index}"], f"#{text}")
    return found


def _by_analysis(source, analysis):
    found, document = {}, frames.object_of(source).Document
    if analysis is not None and not hasattr(analysis, "Group"):
        raise InvalidInput(f"{convert.label_of(analysis)} is no analysis: give one of the FEM workbench or of CfdOF")
    groups = [analysis] if analysis is not None else [obj for obj in document.Objects if hasattr(obj, "Group")]
    for group in groups:
        for member in group.Group:
            faces = [face for obj, names in _references(member, document) for name in names
                     for face in [_face_in(source, obj, name)] if face]
            _add(found, _another(plain_name(member.Label), found), faces)
    return found


def _references(member, document):
    """[(object, names of sub-elements), ...] of a FEM constraint or a boundary of CfdOF."""
    for name in ("References", "ShapeRefs"):
        for entry in getattr(member, name, None) or ():
            obj, names = entry[0], entry[1]
            if isinstance(obj, str):  # older versions of CfdOF store a name
                obj = document.getObject(obj)
            if obj is not None:
                yield obj, [names] if isinstance(names, str) else names


def _face_in(source, obj, name):
    """The name of a face of another object in the source; None where the source does not have it."""
    if not name.rpartition(".")[2].startswith("Face"):
        return None
    if obj == frames.object_of(source) and not frames.path_of(source) and "." not in name:
        return name
    import Part

    face = Part.getShape(obj, name, needSubElement=True)
    return None if face.isNull() else convert.name_in(convert.own_shape_of(source), face)
