# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where document objects stand: the coordinate systems of their containers.

The placement of an object is relative to the container that it lies in. The frame of an object is
the placement of that coordinate system in the document: those of all containers around it, multiplied
from the outermost to the innermost. Containers are App::Part and PartDesign::Body, link groups and
link arrays; plain groups have no placement.

A source is a document object, or a pair (document object, path) for what only a link leads to:
(link, "Part.Box.") or (part, "Face3"). The frame of a pair is that of its object.
"""

import FreeCAD

from ...compat import property_of
from ...errors import InvalidInput

_SCALED = 1e-9  # of the volume: what rounding changes in a rotation is less


def object_of(source):
    """The document object of a source."""
    return source[0] if _has_path(source) else source


def is_object(source):
    """Whether a source is a document object, or a path below one."""
    return isinstance(object_of(source), FreeCAD.DocumentObject)


def path_of(source):
    """The path below the object of a source; empty without one."""
    if not _has_path(source):
        return ""
    return source[1] if isinstance(source[1], str) else "".join(source[1][:1])


def _has_path(source):
    # A property that links to sub-elements gives a list of their names.
    return isinstance(source, tuple) and len(source) == 2 and (
        isinstance(source[1], str)
        or isinstance(source[1], (list, tuple)) and all(isinstance(name, str) for name in source[1]))


def key_of(source):
    """What tells a document object, or a pair of such a one and a path, from all others: names of document and object."""
    obj = object_of(source)
    return obj.Document.Name, obj.Name, path_of(source)


def source_of(obj, path=""):
    """The source of an object and a path."""
    return (obj, path) if path and obj is not None else obj


def leaf_of(source):
    """The document object that a source means: the one at the end of its path.

    Raises InvalidInput where nothing is there any more.
    """
    obj, path = object_of(source), path_of(source)
    leaf = obj.getSubObject(path, retType=1) if path else obj
    if leaf is None:
        raise InvalidInput(f"'{obj.Label}' has nothing at {path}: choose the source anew")
    return leaf


def held_by(source):
    """[(name, source)] of what a container holds, as it names it. Groups of analyses name things that FreeCAD does not find by these
    names: they hold no shapes of their own, and are left out.
    """
    obj, path = object_of(source), path_of(source)
    names = [name for name in leaf_of(source).getSubObjects() if name.endswith(".")]
    return [(name, (obj, path + name)) for name in names if obj.getSubObject(path + name, retType=1) is not None]


def linked_of(source):
    """(document object, matrix): what a source is in the end, beyond all links, and where that stands in the coordinate
    system of the container of the source's object.
    """
    obj, path = object_of(source), path_of(source)
    found, matrix = leaf_of(source), FreeCAD.Matrix()
    if path:
        _, matrix = obj.getSubObject(path, retType=1, matrix=matrix)
    # A link lends its object, but in the object's place.
    linked, matrix = found.getLinkedObject(True, matrix, not path)
    if linked == obj and "Placement" in obj.PropertiesList:
        matrix = property_of(obj, "Placement").toMatrix()
    return linked, matrix


def path_from_root(source):
    """(object, path): the outermost container of a source and the path from there, as the selection of
    the 3D view names it.
    """
    obj, path = object_of(source), path_of(source)
    for container in containers_of(obj):
        obj, path = container, f"{obj.Name}.{path}"
    return obj, path


def containers_of(obj):
    """The containers around a document object, the innermost first."""
    found = []
    container = _container_of(obj)
    while container is not None and container not in found:
        found.append(container)
        container = _container_of(container)
    return found


def _container_of(obj):
    group = obj.getParentGeoFeatureGroup()
    if group is not None:
        return group
    lists = (other for other in obj.InList if obj in (getattr(other, "ElementList", None) or ()))
    return next(lists, None)


def frame_of(source):
    """The placement of the coordinate system that the source's own placement is relative to; an
    identity outside of containers.

    Raises InvalidInput naming a container that is scaled.
    """
    return _frame_within(object_of(source), containers_of(object_of(source)))


def relative_frames(sources):
    """The frames of sources as they are seen from the container of the first one. Containers around all
    of them leave no trace, not even in the last digit.
    """
    around = [containers_of(object_of(source)) for source in sources]
    shared = [container for container in around[0] if all(container in others for others in around)]
    frames = [_frame_within(object_of(source), [c for c in containers if c not in shared])
              for source, containers in zip(sources, around)]
    return [relative(frame, frames[0]) for frame in frames]


def arrangement_of(sources):
    """How the containers of several sources stand to each other, as text; empty for fewer than two."""
    if len(sources) < 2:
        return ""
    return ";".join(",".join(f"{number:.9g}" for number in frame.toMatrix().A)
                    for frame in relative_frames(sources)[1:])


def _frame_within(obj, containers):
    frame = FreeCAD.Placement()
    for container in containers:
        if getattr(container, "Scale", 1.0) != 1.0:
            raise InvalidInput(f"'{obj.Label}' lies in '{container.Label}', which is scaled: choose "
                               f"'{container.Label}' itself")
        frame = property_of(container, "Placement").multiply(frame)
    return frame


def placement_of(source):
    """Where the source stands in the document, also by links. Raises InvalidInput naming one that is scaled."""
    linked, matrix = linked_of(source)
    if linked == object_of(source):
        own = property_of(linked, "Placement")
    elif abs(matrix.determinant() - 1.0) > _SCALED:
        raise InvalidInput(f"'{leaf_of(source).Label}' is scaled: choose '{linked.Label}' itself, or a link that is not")
    else:
        own = FreeCAD.Placement(matrix)
    frame = frame_of(source)
    return own if is_identity(frame) else frame.multiply(own)


def motion_of(source):
    """The placement that moves what was computed for a mesh object, such as the place of its certificate,
    to where it, or a link to it, stands in the document now; exactly an identity where nothing has moved since.
    """
    held = linked_of(source)[0]
    if "MeshOrigin" not in held.PropertiesList:
        return FreeCAD.Placement()
    return relative_motion(translation(property_of(held, "MeshOrigin")), placement_of(source))


def relative_motion(before, now):
    """The placement that moves what stood at `before` to `now`; exactly an identity where these are the same."""
    return FreeCAD.Placement() if same(before, now) else now.multiply(before.inverse())


def relative(placement, frame):
    """The placement as it is seen from a coordinate system that stands at `frame`; exactly an identity
    where both are the same.
    """
    if same(placement, frame):
        return FreeCAD.Placement()
    return placement if is_identity(frame) else frame.inverse().multiply(placement)


def translation(vector):
    """The placement that moves by a vector."""
    return FreeCAD.Placement(vector, FreeCAD.Rotation())


def is_identity(placement):
    """Whether a placement moves nothing, exactly."""
    return placement.toMatrix() == FreeCAD.Matrix()


def same(a, b):
    """Whether two placements are the same, exactly."""
    return a.toMatrix() == b.toMatrix()


def paths_of_selection(selected):
    """[(source, sub-element), ...] of one Gui.SelectionObject that names its root object, as
    Selection.getSelectionEx("", 0) gives them: what was picked, where it was picked. What a container
    holds is named by itself, what only a link leads to by its path from the root object. The tip of a
    body stands for the body.
    """
    found = []
    for path in selected.SubElementNames or ("",):
        steps, element = split_path(path)
        found.append((_source_at(selected.Object, "".join(f"{step}." for step in steps)), element))
    return found


def split_path(path):
    """(names of the objects on the way, sub-element) of a path "Part.Box.Face1"."""
    *steps, element = path.split(".")
    # FreeCAD 1.0 may put the long name of an element before the short one.
    return [step for step in steps if step and step[0] not in ";?"], element


def _source_at(root, path):
    along = root.getSubObjectList(path) if path else [root]
    leaf = along[-1]
    around = containers_of(leaf)
    if not all(obj in around or _is_plain_group(obj) for obj in along[:-1]):
        return root, path
    body = around[0] if around else None
    return body if getattr(body, "Tip", None) == leaf else leaf


def leaf_paths(obj, path=""):
    """Paths such as "Part.Box." to what has a shape of its own in a container or a link to one; none in what has one
    itself.
    """
    if "Shape" in obj.PropertiesList:
        return
    for name in obj.getSubObjects():
        below = list(leaf_paths(obj.getSubObject(name, retType=1), path + name))
        yield from below or [path + name]


def _is_plain_group(obj):
    return obj.hasExtension("App::GroupExtension") and not obj.hasExtension("App::GeoFeatureGroupExtension")
