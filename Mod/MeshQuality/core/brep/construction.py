# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a mesh was made of shapes, and from that the CAD faces on which its triangles can lie."""

from dataclasses import dataclass

from .offset_faces import offset_faces


@dataclass(frozen=True)
class Construction:
    """What a mesh was made of.

    sources    a Part.Shape, a SurfaceMesh, the Construction of a mesh, or None where it is another mesh, each
    distance   mm, signed: the faces are offset by it; 0: none is
    openings   indices of faces that are not offset; None: the mesh is no hollow, and has no faces of the sources themselves
               besides those that are offset
    own        mm: the distance of the mesh from the exact surface, where its report does not say it
    """

    sources: tuple
    distance: float = 0.0
    openings: tuple | None = None
    own: float = 0.0

    def faces(self):
        """[Part.Face, ...]: the mesh lies on these, up to its tolerance; None where a source is no CAD or an offset has no known faces."""
        found = []
        for source in self.sources:
            faces = _faces_of(source)
            if faces is None or self.distance and not hasattr(source, "Faces"):
                return None
            if not self.distance or self.openings is not None:
                found += faces
            if self.distance:
                found += offset_faces(source, self.distance, self.openings or ())
        return found

    def tolerance(self):
        """mm: `own`, and the distance of meshes among the sources from the surfaces that faces() gives."""
        meshes = [source for source in self.sources if source is not None and not hasattr(source, "Faces")]
        return self.own + sum(source.tolerance() if isinstance(source, Construction) else tolerance_of(source) for source in meshes)


def tolerance_of(mesh):
    """mm: no point of a SurfaceMesh is farther than this from the exact surface, by its report and those of its sources; a report has
    less than 0 where that was not measured.
    """
    own = getattr(mesh.report, "error_bound", None)
    own = mesh.report.max_chord_height if own is None else own
    return max(own, 0.0) + (0.0 if mesh._construction is None else mesh._construction.tolerance())


def _faces_of(source):
    if hasattr(source, "Faces"):
        return source.Faces
    construction = source if isinstance(source, Construction) else getattr(source, "_construction", None)
    return None if construction is None else construction.faces()
