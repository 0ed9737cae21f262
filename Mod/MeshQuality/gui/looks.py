# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the 3D view shows once a mesh is there: the mesh with its edges in place of its sources."""

import FreeCAD

from ..features import mesh_object

_EDGES = "Flat Lines"
_MOST = 200_000  # triangles: the edges of more cover the surface, and take as long to draw as that


def show_in_place_of_sources(obj):
    """Hides the sources of a mesh object that was added, and draws its edges. Undo and redo of the
    step in which the object is added bring the sources back and hide them again.
    """
    view = obj.ViewObject
    # Curved meshes have a display mode of their own, with the edges of the elements.
    if view.DisplayMode == "Shaded" and obj.Mesh.CountFacets <= _MOST:
        view.DisplayMode = _EDGES
    for source in sources_of(obj):
        source.ViewObject.Visibility = False


def sources_of(obj):
    """The document objects that a mesh is made of; none of an imported one, or of a shape."""
    proxy = getattr(obj, "Proxy", None)
    sources = proxy.sources(obj) if isinstance(proxy, mesh_object.MeshObject) else []
    return [source for source in sources if isinstance(source, FreeCAD.DocumentObject)]


def all_sources_of(obj):
    """The same, and those that these are made of in turn; each once."""
    found, pending = [], [obj]
    while pending:
        new = [source for source in sources_of(pending.pop()) if source not in found]
        found += dict.fromkeys(new)
        pending += new
    return found
