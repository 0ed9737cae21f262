# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a mesh object stands: on what it was made of, whatever containers the two lie in.

Its triangles are computed where the document has the source at that time. From then on they go with
the container of the first source: when a container is moved, or the source or the mesh is put into
another one, the object's Placement is set anew, and the triangles stay as they were certified.
"""

import FreeCAD

from .. import frames
from ..compat import attribute_of, property_of

# Name, type, what it says.
FRAME = ("SourceFrame", "App::PropertyPlacement",
         "Where the container of the first source stood when the mesh was computed")
ORIGIN = ("MeshOrigin", "App::PropertyVector",
          "Where the origin of the triangles' coordinates stood in the document then")

_OF_CONTAINERS = ("Placement", "LinkPlacement", "Group", "ElementList", "Scale")
_observer = None


def record(obj, frame):
    """Notes where the mesh was computed that the object has just got.

    frame  the frame of its first source then, see frames.frame_of
    """
    obj.SourceFrame = frame
    obj.MeshOrigin = attribute_of(property_of(obj, "Mesh"), "Placement").Base
    _observe()


def settle(obj):
    """Puts the object where its first source stands now; returns whether it has moved in the document."""
    wanted = _wanted(obj)
    if wanted is None:
        return False
    own = frames.relative(wanted, frames.frame_of(obj))
    if frames.same(own, property_of(obj, "Placement")):
        return False
    obj.Placement = own
    return True


def _wanted(obj):
    """The placement in the document; None without a source."""
    sources = [source for source in obj.Proxy.sources(obj) if source is not None]
    if not sources or "SourceFrame" not in obj.PropertiesList:
        return None
    before, now = property_of(obj, "SourceFrame"), frames.frame_of(sources[0])
    origin = frames.translation(property_of(obj, "MeshOrigin"))
    return frames.relative_motion(before, now).multiply(origin)


def _observe():
    """Has meshes follow the containers of all documents from now on."""
    global _observer
    if _observer is None:
        _observer = _Observer()
        FreeCAD.addDocumentObserver(_observer)


class _Observer:
    """Has meshes follow when a container is moved, or gets or loses an object."""

    def slotChangedObject(self, obj, name):
        """Called by FreeCAD."""
        if name not in _OF_CONTAINERS or obj.Document.Restoring or obj.Document.Transacting:
            return
        if name == "Placement" and not (obj.hasExtension("App::GeoFeatureGroupExtension")
                                        or getattr(obj, "ElementList", None)):
            return
        for mesh in list(obj.Document.Objects):
            if hasattr(getattr(mesh, "Proxy", None), "follow_containers"):
                mesh.Proxy.follow_containers(mesh, obj)
