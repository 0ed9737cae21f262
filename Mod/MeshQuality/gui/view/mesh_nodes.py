# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh as nodes of a scene: a colour for each triangle, edges, and triangles that are lit up."""

import time

import numpy as np
from pivy import coin

from . import edge_detail
from .coin_fields import fill, separator, unlit

_GREY = (204, 204, 204, 255)  # of triangles before they are coloured
LIT = (255, 32, 255, 255)  # red, green, blue, opacity: a colour that no scale has
_EDGES = (0.15, 0.15, 0.15)  # red, green, blue: dark grey
_OUTLINE = 3.0  # width of outlines, pixels
_DARKEST = 0.65  # fraction of its colour that a triangle keeps when it is turned away from the light
_LIGHT = np.array((0.365, -0.548, 0.753), dtype=np.float32)  # the direction to it: above the usual view from the front right
_FINE, _COARSE = 0, 1  # children of the switch


class MeshNodes:
    """A mesh with one colour for each triangle, its edges and highlighted triangles.

    Coin caches the drawing as a display list, so that turning a million triangles needs the graphics card only. All calls
    belong to the thread of the window.

    root             for the scene
    drawing_seconds  of the last drawing of triangles and edges; 0: they were not drawn. Long without a graphics card
    """

    def __init__(self):
        self.drawing_seconds = self._began = 0.0
        self._fine, self._coarse = ShadedTriangles(), ShadedTriangles()
        self._edge_points, self._edges = coin.SoVertexProperty(), coin.SoIndexedLineSet()
        self._edges.vertexProperty = self._edge_points
        colour = coin.SoBaseColor()
        colour.rgb = _EDGES
        self._detail = edge_detail.thinned(separator(unlit(), colour, self._edges), 0)
        before, after = coin.SoCallback(), coin.SoCallback()
        before.setCallback(self._begin, None)
        after.setCallback(self._end, None)
        fine = separator(before, self._fine.node, self._detail, after)
        fine.renderCaching = coin.SoSeparator.OFF  # the calls that take time must not be left out
        self._switch = coin.SoSwitch()
        self._switch.addChild(fine)
        self._switch.addChild(self._coarse.node)
        self._switch.whichChild = _FINE
        self._clip, self._cap = coin.SoClipPlane(), ShadedTriangles()
        self._cap_points, self._cap_edges = coin.SoVertexProperty(), coin.SoIndexedLineSet()
        self._cap_edges.vertexProperty = self._cap_points
        clipped = coin.SoSeparator()
        for node in (self._clip, self._switch, self._lit()):
            clipped.addChild(node)
        self.root = coin.SoSeparator()
        self.root.addChild(clipped)
        self.root.addChild(separator(self._cap.node, unlit(), colour, self._cap_edges))
        self.clip(None)

    def _lit(self):
        style = coin.SoDrawStyle()
        style.lineWidth = _OUTLINE
        self._lit_points = coin.SoVertexProperty()
        self._lit_points.orderedRGBA = int.from_bytes(LIT, "big")
        self._lit_points.materialBinding = coin.SoVertexProperty.OVERALL
        self._lit_faces, self._outlines = coin.SoFaceSet(), coin.SoLineSet()
        for shape in (self._lit_faces, self._outlines):
            shape.vertexProperty = self._lit_points
        self.light_up(np.zeros((0, 3, 3)))
        return separator(unlit(), style, self._lit_faces, self._outlines)

    @property
    def triangles(self):
        """How many there are."""
        return len(self._fine.shade)

    def _begin(self, _, action):
        if action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
            self._began = time.perf_counter()

    def _end(self, _, action):
        if action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
            self.drawing_seconds = time.perf_counter() - self._began

    def show(self, corners):
        """Takes triangles as float32 (T, 3, 3). They are grey until they are coloured; none is lit up."""
        self._fine.show(corners)
        self.light_up(corners[:0])

    def colour(self, colours):
        """uint8 (T, 4): red, green, blue, opacity of each triangle."""
        self._fine.colour(colours)

    def clip(self, plane, corners=None, colours=None, lines=None):
        """Draws nothing of the mesh where a core.inspect.section.Plane cuts it off, and the cut as triangles, float32 (n, 3, 3), in
        colours, uint8 (n, 4), with lines as of edges; None: all of it and no cut.
        """
        self._clip.on = plane is not None
        if plane is not None:
            self._clip.plane = coin.SbPlane(coin.SbVec3f(*(-plane.normal).tolist()), float(-plane.normal @ plane.point))
        self._cap.show(np.zeros((0, 3, 3), dtype=np.float32) if plane is None else corners)
        if plane is not None:
            self._cap.colour(colours)
        points, runs = lines or (np.zeros((0, 3)), np.zeros(0, dtype=np.int32))
        fill(self._cap_points.vertex, points)
        fill(self._cap_edges.coordIndex, runs)

    def show_coarse(self, corners):
        """float32 (n, 3, 3): what is drawn in place of triangles and edges while the camera moves."""
        self._coarse.show(corners)

    def colour_coarse(self, colours):
        """uint8 (n, 4), likewise."""
        self._coarse.colour(colours)

    def moving(self, moves):
        """Whether the camera moves now."""
        child = _COARSE if moves and len(self._coarse.shade) else _FINE
        if self._switch.whichChild.getValue() != child:
            self._switch.whichChild = child

    def draw_edges(self, points, lines):
        """float32 (P, 3), and int32 runs of point indices, each ended by -1; no runs: no edges."""
        fill(self._edge_points.vertex, points)
        fill(self._edges.coordIndex, lines)
        edge_detail.set_count(self._detail, np.count_nonzero(lines == -1))

    def light_up(self, corners):
        """Highlights triangles, float32 (n, 3, 3), in place of those before: they are drawn over the others with thick
        outlines, so that the smallest one is visible from afar.
        """
        # Outlines are closed by repeating their first corner.
        rounds = np.concatenate((corners, corners[:, :1]), axis=1)
        fill(self._lit_points.vertex, rounds)
        for shape in (self._lit_faces, self._outlines):
            fill(shape.numVertices, np.full(len(corners), 4))


class ShadedTriangles:
    """Triangles with one colour each.

    The shading is computed into the colours once, with a fixed light: without lamps and normals the processor of a machine
    without a graphics card draws a million triangles four times as fast. The shading is weak, so that colours stay those of
    the legend.

    node   for the scene
    shade  float32 (T,): the visible fraction of each triangle's colour
    """

    def __init__(self):
        self._points, self._faces = coin.SoVertexProperty(), coin.SoFaceSet()
        self._points.materialBinding = coin.SoVertexProperty.PER_FACE
        self._faces.vertexProperty = self._points
        self.node = separator(unlit(), coin.SoPolygonOffset(), self._faces)  # drawn behind the edges
        self.show(np.zeros((0, 3, 3), dtype=np.float32))

    def show(self, corners):
        """Takes triangles as float32 (T, 3, 3). Grey until they are coloured."""
        a, b, c = np.moveaxis(corners, 1, 0)
        normals = np.cross(b - a, c - a)
        lengths = np.sqrt(np.einsum("ij,ij->i", normals, normals))
        facing = normals @ _LIGHT / np.where(lengths > 0.0, lengths, 1.0)
        self.shade = np.where(lengths > 0.0, _DARKEST + (1.0 - _DARKEST) * 0.5 * (1.0 + facing), 1.0)
        fill(self._points.vertex, corners)
        fill(self._faces.numVertices, np.full(len(corners), 3))
        self.colour(np.tile(np.array(_GREY, dtype=np.uint8), (len(corners), 1)))

    def colour(self, colours):
        """uint8 (T, 4): red, green, blue, opacity. Raises ValueError unless there is one for each triangle."""
        packed = np.empty((len(self.shade), 4), dtype=np.uint8)
        packed[:, :3] = colours[:, :3] * self.shade[:, None] + 0.5
        packed[:, 3] = colours[:, 3]
        fill(self._points.orderedRGBA, packed.view(">u4").reshape(-1))
