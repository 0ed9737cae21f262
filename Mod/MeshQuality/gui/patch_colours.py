# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patches in colour: on the mesh that has them, and on the faces of its sources while they are chosen."""

import re

import numpy as np

from ..core.patches.patches import colour_of, patches_of
from ..core.sources import frames
from ..errors import InvalidInput
from ..features import mesh_object
from ..features.patches import patches_of_object

_FACE = re.compile(r"Face([1-9]\d*)")


def division_of(obj):
    """The division into patches of an object; None where it has none, or none that its sources still have."""
    if not isinstance(getattr(obj, "Proxy", None), mesh_object.PatchedMesh) or obj.Proxy.lacks_source(obj):
        return None
    try:
        return obj.Proxy.faces(obj).division(*patches_of_object(obj))
    except InvalidInput:
        return None  # the command Patches says what is wrong


def show_on_mesh(obj):
    """Colours the segments of a mesh object by its patches; returns whether there are any. Faces that are in no patch keep
    the colour of the mesh.
    """
    count = obj.Mesh.countSegments()
    division = division_of(obj) if count and (obj.Patches or obj.PatchRest) else None
    faces = mesh_object.faces_of_runs(obj.FaceRuns, obj.Mesh.CountFacets) if division is not None else np.zeros(0, int)
    faces = np.unique(faces)  # a segment each, in this order
    if len(faces) != count or not count:
        return False
    found, plain = patches_of(division, faces, count), obj.ViewObject.ShapeColor[:3]
    named = set(range(len(division.names))) | ({found.names.index(division.rest)} if division.rest in found.names else set())
    colours = {patch: tuple(part / 255 for part in colour_of(found, patch)) for patch in named}
    obj.ViewObject.highlightSegments([colours.get(patch, plain) for patch in found.of_triangle.tolist()])
    return True


class SourceColours:
    """Colours faces of the sources of a mesh, until `end`.

    members  of core.source_faces
    """

    def __init__(self, members):
        self._members, self._before = members, {}

    def show(self, patches):
        """Colours the faces of {name of a face: (red, green, blue) from 0 to 255}, and no others."""
        self.end()
        for name, colour in patches.items():
            for member in self._members:
                found = _view_of_face(member, name)
                if found is not None:
                    self._colour(*found, colour)

    def _colour(self, view, index, colour):
        count = view.Object.Shape.countElement("Face")
        if index >= count:
            return
        before = self._before.setdefault(view, view.DiffuseColor)
        colours = list(view.DiffuseColor) if len(view.DiffuseColor) == count else [before[0]] * count
        colours[index] = (*(part / 255 for part in colour), *before[0][3:])
        view.DiffuseColor = colours

    def end(self):
        """The sources have their own colours again."""
        for view, colours in self._before.items():
            if view.Object is not None:
                view.DiffuseColor = colours
        self._before = {}


def _view_of_face(member, name):
    """(view, index of the face) by which a face of a member is drawn; None where it is none of it, or drawn otherwise, as
    through a link.
    """
    if member.count is None or not name.startswith(member.prefix):
        return None
    path, _, element = name[len(member.prefix):].rpartition(".")
    leaf, face = frames.leaf_of(member.source), _FACE.fullmatch(element)
    if path:
        leaf = leaf.getSubObject(f"{path}.", retType=1)
    view = None if leaf is None else leaf.ViewObject
    fits = face and hasattr(view, "DiffuseColor") and "Shape" in leaf.PropertiesList
    return (view, int(face[1]) - 1) if fits else None
