# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is hidden in a container: FreeCAD leaves it out of the container's shape, and of what is made of that."""

import FreeCAD

from ... import phrases
from . import convert, frames


def left_out_of(source, with_meshes=False):
    """Labels of the objects in a container, or in a link to one, that are left out because they are hidden: those with
    faces, and with triangles where meshes count, too. What something visible there is made of is not left out.
    """
    if not isinstance(frames.object_of(source), FreeCAD.DocumentObject):
        return []
    shown, hidden = {}, {}
    for part, visible in _parts(source, True):
        linked, matrix = frames.linked_of(part)
        if convert.is_mesh(part) and not with_meshes:
            continue
        # What lies in a plain group is listed by the container around that, too.
        (shown if visible else hidden).setdefault((linked, matrix.A), linked)
    left = [obj for place, obj in hidden.items() if place not in shown and _counts(obj)]
    used = {part for obj in shown.values() for part in obj.OutListRecursive} if left else set()
    return list(dict.fromkeys(obj.Label for obj in left if obj not in used))


def sentences_of(source, with_meshes=False):
    """The same as a list of one sentence; empty where nothing is left out."""
    labels = left_out_of(source, with_meshes)
    return [phrases.counted_list(phrases.LEFT_OUT, labels, name=convert.label_of(source))] if labels else []


def noted(mesh, sentences):
    """The mesh, with sentences_of its sources among the notes of its report. They are asked for before the mesh is made:
    meanwhile documents may be closed.
    """
    if sentences:
        mesh.report.notes = [*mesh.report.notes, *sentences]
    return mesh


def _parts(source, visible):
    """(source, whether it is visible) of all that has a shape or a mesh of its own in a container and in what that
    holds.
    """
    leaf = frames.leaf_of(source)
    if _is_whole(source):
        return
    for name, part in frames.held_by(source):
        seen = visible and convert.is_visible(leaf, name)
        if _is_whole(part):
            yield part, seen
        else:
            yield from _parts(part, seen)


def _is_whole(source):
    linked = frames.leaf_of(source).getLinkedObject(True)
    # FEM meshes have a link of the name Shape.
    return convert.is_mesh(source) or "Shape" in linked.PropertiesList and not linked.isDerivedFrom("Fem::FemMeshObject")


def _counts(obj):
    return bool(obj.Mesh.CountFacets if convert.is_mesh(obj) else obj.Shape.Faces)
