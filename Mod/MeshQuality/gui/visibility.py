# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the 3D view shows once a mesh is there: the mesh with its edges in place of its sources."""

import FreeCAD

from ..compat import PlainState
from ..core.sources import frames
from ..features import cured_mesh, mesh_object
from ..features.mesh_shape import MeshShape
from .view import badge

_FACES, _EDGES = "Shaded", "Flat Lines"
MOST_WITH_EDGES = 10_000  # triangles: on a screen the edges of more lie so close that they blacken the surface


class FacesView(PlainState):
    """Proxy of the view of a CFD surface: its icon in the tree."""

    COMMAND = "MeshQuality_CfdSurface"

    def getIcon(self):
        """Called by FreeCAD."""
        return badge.path_of(self.COMMAND)


class SolidView(FacesView):
    """Likewise of the solid of a mesh."""

    COMMAND = "MeshQuality_ToSolid"


def show_in_place_of_sources(obj):
    """Hides all that a mesh object that was added would be drawn through (_others_there), and draws its edges. Undo and redo of the step in which the object is added bring them back and hide them again.
    """
    view = obj.ViewObject
    if obj.Proxy.size(obj) == 0:
        return  # nothing would be seen
    # Curved meshes have a display mode of their own, with the edges of the elements.
    if view.DisplayMode == _FACES and obj.Mesh.CountFacets <= MOST_WITH_EDGES and not view.Coloring:
        view.DisplayMode = _EDGES
    _hide(_others_there(obj))


def _hide(objects):
    """Hides those objects that nothing else shows elsewhere."""
    for obj in objects:
        if not _counts_for_others(obj):
            obj.ViewObject.Visibility = False


def follow_count(view, before, count):
    """Draws the edges of a mesh that has become so coarse that they are told apart, and none of one that has become finer.

    before  number of triangles that it had; 0: there was no mesh
    """
    if count > MOST_WITH_EDGES >= before > 0 and view.DisplayMode == _EDGES:
        view.DisplayMode = _FACES
    elif 0 < count <= MOST_WITH_EDGES < before and view.DisplayMode == _FACES and not view.Coloring:
        view.DisplayMode = _EDGES


def show_faces(obj, colours):
    """Gives the faces of an object with a Source and a shape their colours: red, green, blue from 0 to 255; a new one is
    seen in place of its source.
    """
    _give_view(obj, FacesView)
    obj.ViewObject.DiffuseColor = [tuple(part / 255 for part in colour) for colour in colours]


def show_solid(obj):
    """Has an object with a Source and a shape seen, a new one in place of its source."""
    _give_view(obj, SolidView)


def _give_view(obj, kind):
    """FreeCAD shows no shape of a Python object without a proxy of its view."""
    view = obj.ViewObject
    if not isinstance(view.Proxy, FacesView):
        is_new = view.Proxy is None
        view.Proxy = kind()
        if is_new:
            _hide(_others_there(obj))


def _others_there(obj):
    """What a mesh, or a shape of one, is made of in turn, and the other meshes and shapes that are made of nothing but those."""
    known = _with_sources(obj)[1:]
    found = [source for source in known if isinstance(source, FreeCAD.DocumentObject)]
    for made in obj.Document.Objects:
        if made not in (obj, *known) and isinstance(getattr(made, "Proxy", None), (mesh_object.MeshObject, MeshShape)) \
                and all(source in known for source in _sources(made)):
            known.append(made)
            found.append(made)
    return found


def _counts_for_others(source):
    """Whether a container around the object is used by something: what is hidden in it would be lost there."""
    around = frames.containers_of(source)
    return any(user not in around and not user.isDerivedFrom("App::Origin")
               for container in around for user in container.InList)


def sources_of(obj):
    """The document objects that a mesh is made of, as far as they are seen in one place only; none of
    an imported mesh.
    """
    return [source for source in _sources(obj) if isinstance(source, FreeCAD.DocumentObject)]


class Hidden:
    """Hides all that is seen where a mesh is, until `end`."""

    def __init__(self, mesh):
        self._objects = [obj for obj in all_shown_at(mesh) if _is_visible(obj)]
        for obj in self._objects:
            _set_visible(obj, False)

    def end(self):
        """Objects that still exist are shown again."""
        for obj in self._objects:
            if obj in obj.Document.Objects:
                _set_visible(obj, True)


def _group_around(obj):
    """The group of links that draws an object by itself, whatever the object's own view says; None without one."""
    return next((group for group in obj.InList
                 if group.isDerivedFrom("App::LinkGroup") and obj in (getattr(group, "ElementList", None) or ())), None)


def _is_visible(obj):
    group = _group_around(obj)
    return obj.ViewObject.Visibility if group is None else group.isElementVisible(obj.Name) == 1


def _set_visible(obj, visible):
    group = _group_around(obj)
    if group is None:
        obj.ViewObject.Visibility = visible
    else:
        group.setElementVisible(obj.Name, visible)


def all_shown_at(mesh):
    """All that is seen where a mesh is: itself, its sources, those that these are made of in turn, other meshes that are
    made of any of these, and the links through which they are seen there; each once. Of a link to a mesh: what is linked
    stands elsewhere.
    """
    if frames.linked_of(mesh)[0] != mesh:
        return [_seen(mesh)]
    own = _with_sources(mesh)
    others = [made for made in frames.object_of(mesh).Document.Objects
              if made not in own and any(source in own for source in _with_sources(made)[1:])]
    return list(dict.fromkeys(_seen(shown) for shown in (*own, *others)))


def _with_sources(mesh):
    """A mesh, its sources, and those that these are made of in turn, each once."""
    found = [mesh]
    for made in found:
        found += [source for source in dict.fromkeys(_sources(made)) if source is not None and source not in found]
    return found


def _sources(obj):
    proxy = getattr(obj, "Proxy", None)
    if isinstance(proxy, mesh_object.MeshObject):
        return proxy.sources(obj)
    if isinstance(proxy, MeshShape):
        return [proxy.source(obj)]
    part = cured_mesh.part_of(obj) if cured_mesh.has_fem_mesh(obj) else None
    return [] if part is None else [part]


def _seen(source):
    """The object by which a source is seen in its place: what is below a link is seen elsewhere, too."""
    path = frames.path_of(source)
    if not path.endswith("."):
        return frames.object_of(source)
    along = frames.object_of(source).getSubObjectList(path)
    return next((obj for obj in along if obj.isDerivedFrom("App::Link")), along[-1])
