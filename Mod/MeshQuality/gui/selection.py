# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces, edges and vertices that are selected in the 3D view, by their names below an object."""

import re

import FreeCADGui

from .. import element_names
from ..core.sources import convert, frames
from ..errors import InvalidInput

_ELEMENT = re.compile(r"(Face|Edge|Vertex)\d+")


def picked(source):
    """(names, labels): what is selected of the object as "Face6", or "Box.Face6" below a container or
    link; and the labels of objects with selected sub-elements that the object does not hold.
    """
    names, others = [], []
    for selected in FreeCADGui.Selection.getSelectionEx("", 0):
        for path in selected.SubElementNames:
            if not _ELEMENT.fullmatch(path.rpartition(".")[2]):
                continue
            name = _below(source, selected.Object, path)
            if name is None:
                others.append(_owner(selected.Object, path).Label)
            else:
                names.append(name)
    return list(dict.fromkeys(names)), list(dict.fromkeys(others))


def picked_faces(source):
    """The names of those that are faces."""
    return element_names.faces_of(picked(source)[0])


def follow(sources, results):
    """Selects what was made of sources in their place, unless something else has been selected meanwhile."""
    chosen = [source for selected in FreeCADGui.Selection.getSelectionEx("", 0) for source, _ in frames.paths_of_selection(selected)]
    if all(source in sources for source in chosen):
        select(results)


def select(objects):
    """Selects objects, and nothing else."""
    FreeCADGui.Selection.clearSelection()
    for obj in objects:
        FreeCADGui.Selection.addSelection(obj)


def _below(source, root, path):
    """The name of a sub-element below the source; None where the source does not hold it."""
    steps, element = frames.split_path(path)
    for i in range(len(steps) + 1):
        if _is_there(source, root, steps[:i]):
            name = ".".join([*steps[i:], element])
            # A body shows the faces of a feature as its own.
            whole = i < len(steps) and "Shape" in frames.leaf_of(source).PropertiesList
            return _own(source, name) if whole else name
    return None


def _is_there(source, root, steps):
    """Whether the source is what these steps lead to from the root."""
    if frames.path_of(source):
        return (root, "".join(f"{step}." for step in steps)) == frames.path_from_root(source)
    return _at(root, steps) == source


def _own(source, name):
    try:
        return next(iter(convert.resolve_sizes(source, {name: 1.0})))
    except InvalidInput:
        return None


def _owner(root, path):
    """The innermost object on the way to a sub-element."""
    return _at(root, frames.split_path(path)[0]) or root


def _at(root, steps):
    return root.getSubObject(".".join(steps) + ".", retType=1) if steps else root
