# SPDX-License-Identifier: LGPL-2.1-or-later
"""The quality of a mesh in a 3D view: colours, lit elements, a legend, and the camera's flight."""

import FreeCADGui
import numpy as np
from pivy import coin
from PySide import QtCore

from . import legend
from .legend_node import LegendNode
from .mesh_nodes import LIT, MeshNodes

_STEPS, _TICK = 16, 25  # steps of a flight; ms between them
_SLOW = 0.05  # seconds of drawing from which on moving is drawn coarsely
_STILL = 250  # ms without a move after which all is drawn again
_CLOSED = 1e-6  # share of the squared size: the vector areas of an element's sides add up to zero but for rounding
_NO_LINES = np.zeros((0, 3)), np.zeros(0, dtype=np.int32)
_AROUND = 25.0  # width of the view around a place, in sizes of the place, ...
_FITS = 1.5  # ... and of one in which it is seen whole


class QualityScene:
    """Draws in one 3D view until `close`.

    scene   MeshNodes
    legend  LegendNode
    node    that of both
    """

    def __init__(self, view):
        self.scene, self.legend, self.view = MeshNodes(), LegendNode(), view
        self.node = self.scene.root
        self.node.addChild(self.legend.node)
        self._graph = view.getSceneGraph()
        self._graph.addChild(self.node)
        self.flight = None
        self._corners = self._colours = None
        self._lines = _NO_LINES
        self._opened = False
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.setInterval(_STILL)
        self._timer.timeout.connect(lambda: self.scene.moving(False))
        self._camera, self._pose = view.getCameraNode(), None
        self._sensor = coin.SoNodeSensor(self._moved, None)
        self._sensor.attach(self._camera)

    def close(self):
        """Leaves the view as it was."""
        if self.flight is not None:
            self.flight.stop()
        self._timer.stop()
        self._sensor.detach()
        self._graph.removeChild(self.node)
        self._graph, self.node = None, None

    def show(self, data):
        """Takes the triangles of a QualityData."""
        self._corners = data.corners
        self.scene.show(data.corners)
        if data.coarse is not None:
            self.scene.show_coarse(data.coarse)

    def _moved(self, *_):
        """The camera has changed: if it has moved and drawing takes long, coarse triangles are drawn
        meanwhile. What Coin sets at each drawing, between which distances is drawn, is no move.
        """
        camera = self._camera
        size = camera.height if hasattr(camera, "height") else camera.heightAngle
        pose = (camera.position.getValue().getValue(), camera.orientation.getValue().getValue(),
                size.getValue())
        moved, self._pose = pose != self._pose, pose
        if moved and self.scene.drawing_seconds > _SLOW and not self._opened:  # coarse triangles would be those of the whole
            self.scene.moving(True)
            self._timer.start()

    def draw_edges(self, data, wanted):
        """Draws the edges, or not."""
        self._lines = data.lines if wanted else _NO_LINES
        self.scene.draw_edges(*self._lines)

    def colour(self, colours, coarse, scale):
        """uint8 (T, 4) colours of the triangles, (n, 4) of the coarse ones, and the legend of the
        scale that they show.
        """
        self.close_again()
        self._colours = colours
        self.scene.colour(colours)
        if coarse is not None:
            self.scene.colour_coarse(coarse)
        self.legend.show(legend.picture(scale, self._view_height()), *legend.corner_to_leave())

    def _view_height(self):
        """In pixels that do not depend on the screen's scale."""
        return self.view.getSize()[1] / FreeCADGui.getMainWindow().devicePixelRatioF()

    def light_up(self, corners):
        """Lights up triangles, float32 (n, 3, 3), instead of those before."""
        self.scene.light_up(corners)

    def fly_to(self, corners, around=_AROUND, within=None):
        """As flight_to; without `within` in the mesh that is shown."""
        self.flight = flight_to(self.view, corners, around, self._corners if within is None else within)

    def open_before(self, corners):
        """Lights up triangles inside of the mesh, without the surface on the camera's side of them, which would hide them."""
        ahead = self.ahead().astype(np.float32)
        nearest = (corners.reshape(-1, 3) @ ahead).min()
        behind = (self._corners @ ahead).min(axis=1) >= nearest
        self.scene.show(self._corners[behind])
        self.scene.colour(self._colours[behind])
        self.scene.light_up(corners)  # the lit triangles were removed with the surface
        self._opened = True

    def show_part(self, corners, colours, lines):
        """Draws triangles, with colours and edges or None, in place of the surface, until close_again; nothing is lit up."""
        self.scene.show(corners)
        self.scene.colour(colours)
        self.scene.draw_edges(*(lines or _NO_LINES))
        self._opened = True

    def clip(self, plane, corners, colours, is_lit, lines):
        """Cuts the surface off by a core.inspect.section.Plane until close_again, and draws the cut: triangles, with colours, those that
        are lit, and edges or None.
        """
        self.scene.clip(plane, corners, np.where(is_lit[:, None], np.array(LIT, dtype=np.uint8), colours), lines or _NO_LINES)

    def close_again(self):
        """The whole surface is there."""
        self.scene.clip(None)
        if self._opened:
            self._opened = False
            self.scene.show(self._corners)
            self.scene.colour(self._colours)
            self.scene.draw_edges(*self._lines)


    def ahead(self):
        """float64 (3,): the direction in which the camera looks."""
        return np.array(self._camera.orientation.getValue().multVec(coin.SbVec3f(0, 0, -1)).getValue())

    def hit(self, x, y):
        """The first of the triangles of the mesh, float64 (3, 3), that is seen at a pixel, from the lower left corner of the view, and the
        point there, (3,); None where there is none.
        """
        start, ahead = _ray(self._camera, *self.view.getSize(), x, y)
        a, b, c = np.moveaxis(self._corners.astype(np.float64), 1, 0)
        normals = np.cross(b - a, c - a)
        with np.errstate(divide="ignore", invalid="ignore"):
            along = np.einsum("ij,ij->i", a - start, normals) / (normals @ ahead)
        found = np.flatnonzero(np.isfinite(along) & (along > 0.0))
        points = start + along[found, None] * ahead
        for p, q in ((a, b), (b, c), (c, a)):
            inside = np.einsum("ij,ij->i", np.cross(q[found] - p[found], points - p[found]), normals[found]) >= 0.0
            found, points = found[inside], points[inside]
        if not len(found):
            return None
        first = along[found].argmin()
        return self._corners[found[first]].astype(np.float64), points[first]


def _ray(camera, width, height, x, y):
    """(float64 (3,), (3,)): where the ray through a pixel begins, and its direction."""
    turn = camera.orientation.getValue()
    right, up, ahead = (np.array(turn.multVec(coin.SbVec3f(*axis)).getValue()) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, -1)))
    place, pixel = np.array(camera.position.getValue().getValue()), 1.0 / min(width, height)  # the shorter side is as long as is said
    across = (x - 0.5 * width) * pixel * right + (y - 0.5 * height) * pixel * up
    if camera.isOfType(coin.SoPerspectiveCamera.getClassTypeId()):
        return place, ahead + 2.0 * np.tan(0.5 * camera.heightAngle.getValue()) * across
    return place + camera.height.getValue() * across, ahead


def flight_to(view, corners, around=_AROUND, within=None):
    """Begins to move a view's camera to look at triangles, (n, 3, 3), from outside; the Flight.

    around  width of the view in sizes of the triangles
    within  (m, 3, 3), all triangles of the mesh, or None: the view gets no wider than the mesh

    It gets no wider than it is, either, but for triangles that would not fit into it.
    """
    points = corners.reshape(-1, 3).astype(float)
    centre = 0.5 * (points.min(axis=0) + points.max(axis=0))
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    camera = view.getCameraNode()
    width = min(around * size, max(_width_of(camera), _FITS * size))
    if within is not None:
        width = min(width, _FITS * float(np.linalg.norm(np.ptp(within.reshape(-1, 3), axis=0))))
    sides = corners.astype(float)
    normal = np.cross(sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0]).sum(axis=0)
    if np.linalg.norm(normal) < _CLOSED * size * size:
        normal = np.zeros(3)
    return Flight(camera, centre, normal, width)


def _width_of(camera):
    """How much of a plane at its focus a camera sees: the shorter side of the view, mm."""
    if camera.isOfType(coin.SoPerspectiveCamera.getClassTypeId()):
        return 2.0 * camera.focalDistance.getValue() * np.tan(0.5 * camera.heightAngle.getValue())
    return camera.height.getValue()


class Flight(QtCore.QObject):
    """Turns and moves a camera step by step to look at a place."""

    def __init__(self, camera, centre, normal, height):
        super().__init__()
        self.camera = camera
        self._perspective = camera.isOfType(coin.SoPerspectiveCamera.getClassTypeId())
        self._from = self._now()
        distance = height
        if self._perspective:
            distance = 0.5 * height / np.tan(0.5 * camera.heightAngle.getValue())
        turn = self._from[1]
        if np.linalg.norm(normal) > 0.0:
            # A camera looks along its -z.
            to = coin.SbVec3f(*(-normal / np.linalg.norm(normal)))
            ahead = turn.multVec(coin.SbVec3f(0, 0, -1))
            turn = turn * coin.SbRotation(ahead, to)
        back = turn.multVec(coin.SbVec3f(0, 0, 1)).getValue()
        self._to = (np.asarray(centre) + distance * np.array(back), turn, height, distance)
        self._step = 0
        self._timer = QtCore.QTimer(self)
        self._timer.setInterval(_TICK)
        self._timer.timeout.connect(self._next)
        self._timer.start()

    @property
    def active(self):
        """Whether it has not arrived."""
        return self._timer.isActive()

    def stop(self):
        """Stays where it is."""
        self._timer.stop()

    def _now(self):
        height = 0.0 if self._perspective else self.camera.height.getValue()
        return (np.array(self.camera.position.getValue().getValue()),
                coin.SbRotation(*self.camera.orientation.getValue().getValue()), height,
                self.camera.focalDistance.getValue())

    def _next(self):
        self._step += 1
        part = self._step / _STEPS
        part = part * part * (3.0 - 2.0 * part)
        start, end = self._from, self._to
        self.camera.position.setValue(*(start[0] + part * (end[0] - start[0])))
        self.camera.orientation.setValue(coin.SbRotation.slerp(start[1], end[1], part))
        self.camera.focalDistance.setValue(start[3] + part * (end[3] - start[3]))
        if not self._perspective:
            # Heights change by factors: each step halves or doubles what is seen alike.
            self.camera.height.setValue(start[2] * (end[2] / start[2]) ** part)
        if self._step >= _STEPS:
            self._timer.stop()
