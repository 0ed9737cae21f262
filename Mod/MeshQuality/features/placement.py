# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a mesh object stands: on what it was made of, whatever containers the two lie in.

Its triangles are computed where the document has the source at that time. From then on they go with
the container of the first source: when a container is moved, or the source or the mesh is put into
another one, the object's Placement is set anew, and the triangles stay as they were certified.
"""

import FreeCAD

from .. import phrases
from ..compat import attribute_of, property_of
from ..core.sources import frames
from ..errors import Error, InvalidInput
from .gui_hooks import window

# Name, type, what it says.
FRAME = ("SourceFrame", "App::PropertyPlacement",
         "Where the container of the first source stood when the mesh was computed")
ORIGIN = ("MeshOrigin", "App::PropertyVector",
          "Where the origin of the triangles' coordinates stood in the document then")
ARRANGEMENT = ("SourceArrangement", "App::PropertyString",
               "How the containers of the other sources stood to that of the first one then")

_LISTS = ("Group", "ElementList")  # lists of the members of groups, containers and link groups
_OF_CONTAINERS = ("Placement", "LinkPlacement", "Scale", *_LISTS)


def record(obj, frame, arrangement):
    """Notes where the mesh was computed that the object has just got.

    frame        the frame of its first source then, see frames.frame_of
    arrangement  of all sources then, see frames.arrangement_of
    """
    obj.SourceFrame, obj.SourceArrangement = frame, arrangement
    obj.MeshOrigin = attribute_of(attribute_of(property_of(obj, obj.Proxy.MESH), "Placement"), "Base")


def follow(obj):
    """Puts the object where its source stands, once a container was moved, or got or lost an object;
    where the sources stand to each other in another way, the next recompute makes its mesh anew.
    """
    try:
        move_to_source(obj)
        if frames.arrangement_of(_sources(obj)) != obj.SourceArrangement:
            obj.touch()
    except Error:
        obj.touch()  # its recompute will say what is wrong


def require_outside(obj):
    """Raises InvalidInput where the object lies in something that it is made of: each would wait for the other."""
    holder = _source_around(obj)
    if holder is not None:
        raise InvalidInput(phrases.Text(phrases.IN_ITS_SOURCE, name=f"'{holder.Label}'"))


def _source_around(obj):
    """A group or container around the object that it is made of; None where there is none."""
    around = _all_holders(obj)
    seen, pending = set(), [frames.object_of(source) for source in _sources(obj)] if around else []
    while pending:
        found = pending.pop()
        if found in around:
            return found  # not asked for its OutList: FreeCAD would go on with that after _take_out
        if found not in seen:
            seen.add(found)
            pending += found.OutList
    return None


def _holders(obj):
    """The groups, containers and link groups that list an object."""
    return [user for user in obj.InList
            if any(obj in (getattr(user, name, None) or ()) for name in _LISTS)]


def _all_holders(obj):
    """The groups around an object, and the groups around these."""
    found, pending = set(), [obj]
    while pending:
        holders = set(_holders(pending.pop())) - found
        found |= holders
        pending += holders
    return found


def _take_out(obj, changed):
    """Puts a mesh that came to lie in something that it is made of beside that, and says so, once a container has
    changed.
    """
    if changed not in _all_holders(obj):
        return
    source = _source_around(obj)
    if source is None:
        return
    said = window().translated(phrases.Text(phrases.TAKEN_OUT, name=f"'{source.Label}'"))
    FreeCAD.Console.PrintError(f"{obj.Label}: {said}\n")
    for holder in _holders(obj):
        if hasattr(holder, "removeObject"):
            holder.removeObject(obj)
        else:
            holder.ElementList = [element for element in holder.ElementList if element != obj]


def move_to_source(obj):
    """Puts the object where its first source stands now; returns whether it has moved in the document."""
    if obj.Proxy.LEAVES_CONTAINERS:
        own = FreeCAD.Placement()
    else:
        wanted = _wanted(obj)
        if wanted is None:
            return False
        own = wanted if obj.Proxy.PLACED_IN_DOCUMENT else frames.relative(wanted, frames.frame_of(obj))
    if frames.same(own, property_of(obj, "Placement")):
        return False
    obj.Placement = own
    return True


def _wanted(obj):
    """The placement in the document; None without a source."""
    sources = _sources(obj)
    if not sources:
        return None
    before, now = property_of(obj, "SourceFrame"), frames.frame_of(sources[0])
    origin = frames.translation(property_of(obj, "MeshOrigin"))
    return frames.relative_motion(before, now).multiply(origin)


def _sources(obj):
    return [source for source in obj.Proxy.sources(obj) if source is not None]


class _Observer:
    """Has meshes follow when a container is moved, goes, or gets or loses an object."""

    def slotChangedObject(self, obj, name):
        """Called by FreeCAD."""
        document = obj.Document
        if name in _OF_CONTAINERS and _is_container(obj) and not (document.Restoring or document.Transacting):
            if name in _LISTS:
                for mesh in _meshes(document):
                    _take_out(mesh, obj)
            _follow_all(document)

    def slotDeletedObject(self, obj):
        """Called by FreeCAD while the deleted object still has its content."""
        if _is_container(obj):
            for mesh in _meshes(obj.Document):
                if any(obj in frames.containers_of(frames.object_of(source)) for source in (mesh, *_sources(mesh))):
                    mesh.touch()

    def slotUndoDocument(self, document):
        """Called by FreeCAD."""
        _follow_all(document)

    slotRedoDocument = slotAbortTransaction = slotUndoDocument


def _follow_all(document):
    for mesh in _meshes(document):
        follow(mesh)


def _is_container(obj):
    return obj.hasExtension("App::GroupExtension") or hasattr(obj, "ElementList")


def _meshes(document):
    """The mesh objects of a document that have been computed and have all properties needed here; a property
    that a script removed comes back when they are computed again.
    """
    return [obj for obj in document.Objects if hasattr(getattr(obj, "Proxy", None), "LINKS")
            and {FRAME[0], ORIGIN[0], ARRANGEMENT[0], *obj.Proxy.LINKS} <= set(obj.PropertiesList)
            and getattr(obj, "Fingerprint", "")]


FreeCAD.addDocumentObserver(_Observer())
