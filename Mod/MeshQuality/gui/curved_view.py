# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a curved mesh is drawn: smooth elements with their curved edges, coloured by quality."""

import numpy as np
from pivy import coin

from ..compat import SHAPE_COLOURS, property_of, shape_colour
from ..core.colour_scale import colours_of
from ..core.curving import loader_of
from ..errors import Error
from .mesh_view import MeshView
from .view import edge_detail
from .view.coin_fields import fill, unlit

MODE = "Curved"
PLAIN, JACOBIAN = "Nothing", "Scaled Jacobian"


class Drawing:
    """What a scene needs of a tessellation in the frame of its surface, and of the qualities of the
    curved triangles; any thread may make it.
    """

    def __init__(self, tessellation, quality):
        surface = tessellation.surface()
        self.element, self.quality = np.array(tessellation.element), quality
        self.points = np.asarray(surface.vertices, dtype=np.float32)
        self.normals = np.asarray(tessellation.normals, dtype=np.float32)
        self.faces = _runs(surface.triangles)
        self.face_normals = _runs(tessellation.triangle_normals.reshape(-1, 3))
        self.lines = np.array(tessellation.edge_lines, dtype=np.int32)


class CurvedMeshScene:
    """The scene graph of a curved mesh; `root` is its node. Works without a window."""

    def __init__(self):
        self.root = coin.SoSeparator()
        self._points = coin.SoCoordinate3()
        self._material = coin.SoMaterial()
        self._binding = coin.SoMaterialBinding()
        self._normals = coin.SoNormal()
        self._faces = coin.SoIndexedFaceSet()
        self._line_colour = coin.SoBaseColor()
        self._line_style = coin.SoDrawStyle()
        self._lines = coin.SoIndexedLineSet()
        hints, behind = coin.SoShapeHints(), coin.SoPolygonOffset()
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        normal_binding = coin.SoNormalBinding()
        normal_binding.value = coin.SoNormalBinding.PER_VERTEX_INDEXED
        surface, edges = coin.SoSeparator(), coin.SoSeparator()
        for node in (hints, behind, self._material, self._binding, self._normals, normal_binding,
                     self._faces):
            surface.addChild(node)
        plain = coin.SoMaterialBinding()
        plain.value = coin.SoMaterialBinding.OVERALL
        for node in (self._points, unlit(), plain, self._line_colour, self._line_style, self._lines):
            edges.addChild(node)
        self._detail = edge_detail.thinned(edges, 0)
        for node in (self._points, surface, self._detail):
            self.root.addChild(node)
        self._element = np.zeros(0, dtype=np.int32)

    def show(self, drawing):
        """Takes the geometry of a Drawing."""
        self._element = drawing.element
        fill(self._points.point, drawing.points)
        fill(self._normals.vector, drawing.normals)
        fill(self._faces.coordIndex, drawing.faces)
        fill(self._faces.normalIndex, drawing.face_normals)
        fill(self._lines.coordIndex, drawing.lines)
        edge_detail.set_count(self._detail, np.count_nonzero(drawing.lines == -1))

    def colour(self, quality, transparency=0.0):
        """Colours each curved triangle by its quality."""
        self._binding.value = coin.SoMaterialBinding.PER_FACE
        fill(self._material.diffuseColor,
              np.asarray(colours_of(quality)[self._element], dtype=np.float32))
        self._material.transparency = transparency

    def paint(self, colour, transparency=0.0):
        """One colour (red, green, blue) for all."""
        self._binding.value = coin.SoMaterialBinding.OVERALL
        self._material.diffuseColor = colour
        self._material.transparency = transparency

    def draw_edges(self, colour, width):
        """Colour and width in pixels of the elements' edges."""
        self._line_colour.rgb = colour
        self._line_style.lineWidth = width


def _runs(rows):
    """int32: rows of indices, each followed by -1."""
    return np.column_stack((rows, np.full(len(rows), -1))).ravel().astype(np.int32)


class CurvedMeshView(MeshView):
    """Proxy of the view of a curved mesh. Adds a display mode beside those of every mesh."""

    def __init__(self, view):
        view.addProperty("App::PropertyEnumeration", "ColorBy", "Curved mesh",
                         "What the colours of the elements show")
        view.ColorBy = [PLAIN, JACOBIAN]
        super().__init__(view)
        view.DisplayMode = MODE
        # A document that was saved without a window has the mesh already.
        self.updateData(view.Object, "Mesh")

    def attach(self, view):
        """Called when the view is made, and when it is read from a file."""
        super().attach(view)
        self.scene = CurvedMeshScene()
        self._quality = None
        view.addDisplayMode(self.scene.root, MODE)

    def getDisplayModes(self, view):
        return [MODE]

    def getDefaultDisplayMode(self):
        return MODE

    def setDisplayMode(self, mode):
        return mode

    def updateData(self, obj, name):
        """The object's mesh has changed, or what its icon shows."""
        super().updateData(obj, name)
        if name != "Mesh" or obj.Mesh.CountFacets == 0:
            return
        drawing = getattr(obj.Proxy, "drawing", None)
        if drawing is None:
            try:
                curved = loader_of(obj)()
            except (Error, ImportError):
                # Not all properties are read yet, or there is no core: FreeCAD's own modes remain.
                return
            deviation = property_of(obj, "ShownDeviation").Value
            drawing = Drawing(curved.tessellate(deviation), curved.shown_quality)
        self.scene.show(drawing)
        self._quality = drawing.quality
        self._paint(obj.ViewObject)

    def onChanged(self, view, name):
        """A property of the view has changed."""
        if name in ("ColorBy", *SHAPE_COLOURS, "LineColor", "LineWidth", "Transparency"):
            self._paint(view)

    def _paint(self, view):
        transparency = getattr(view, "Transparency", 0) / 100.0
        if getattr(view, "ColorBy", PLAIN) == JACOBIAN and self._quality is not None:
            self.scene.colour(self._quality, transparency)
        else:
            self.scene.paint(shape_colour(view), transparency)
        self.scene.draw_edges(tuple(getattr(view, "LineColor", (0.0, 0.0, 0.0)))[:3],
                              getattr(view, "LineWidth", 1.0))
