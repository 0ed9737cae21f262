# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a report says of a mesh or of what was measured: values with their pictures, numbers, faces and places."""

import hashlib
from dataclasses import dataclass, field

import numpy as np

from ... import report_phrases as words
from ...compat import extension
from ...errors import InvalidInput
from ..elements import boundary, kinds
from ..inspect.deviation import DeviationMap, drawn
from ..inspect.draft import DraftMap
from ..inspect.thickness import ThicknessMap
from ..measures import table_of_elements
from ..meshes.element_mesh import ElementMesh
from ..meshes.surface_mesh import SurfaceMesh, surface_of
from ..operands.operands import is_arrays
from ..sources import convert

MOST_PLACES = 12
_POOR_DRAFT = 5.0  # degrees: what is blue in pictures of drafts


@dataclass(frozen=True)
class View:
    """Values that are shown in colour and as a histogram.

    title, unit  of them
    values       float64 (E,), by element
    bad, good    the values that are red and blue; -bad == good: red beyond, green at 0, blue below
    limit        the value that was requested, or None
    """

    title: str
    unit: str
    values: np.ndarray
    bad: float
    good: float
    limit: object = None

    @property
    def is_signed(self):
        """Whether values are bad on both sides of 0."""
        return self.bad == -self.good

    def badness(self, values):
        """Numbers that grow the worse the values are."""
        return np.abs(values) if self.is_signed else values if self.bad > self.good else -values

    def goodness(self, values):
        """float64 from 0, bad, to 1, good; not a number where there is no value."""
        values = np.where(np.isposinf(values) & (self.bad < self.good), np.nan, values)
        if self.is_signed:
            return np.interp(values, (-self.bad, 0.0, self.bad), (1.0, 0.6, 0.0)) + 0.0 * values
        return np.clip((values - self.bad) / (self.good - self.bad), 0.0, 1.0)


@dataclass(frozen=True)
class Place:
    """A place that is worth a picture.

    text       what is to be said of it
    point      float64 (3,), mm
    triangles  int (n,), of those that are drawn: they are lit
    """

    text: object
    point: np.ndarray
    triangles: np.ndarray


@dataclass
class Content:
    """What a page says.

    name      of the mesh
    verdict   one of the words MET ..., and the sentences of what is not met
    asked, measured  [(words, value as text), ...]
    corners   float64 (T, 3, 3), mm, of the triangles that are drawn
    element   int (T,), the element of each
    face      int (E,), the CAD face of each element, -1 where there is none
    views     [View, ...]
    places    [Place, ...], and how many there are in all
    whole     the text of the whole report
    digest    SHA-256
    """

    name: str
    corners: np.ndarray
    element: np.ndarray
    face: np.ndarray
    views: list
    digest: str
    measured: list
    whole: str = ""
    verdict: str = words.NO_LIMITS
    findings: list = field(default_factory=list)
    asked: list = field(default_factory=list)
    places: list = field(default_factory=list)
    all_places: int = 0

    def add_exempt(self, reasons):
        """Takes {triangle: why it is below the requested angle} as places."""
        self.places = [Place(text, self.corners[at].mean(axis=0), np.array([at])) for at, text in _first_of_each(reasons.items())]
        self.all_places = len(reasons)


def content_of(source, name, shape=None, progress=None):
    """The Content of what functions of this package return, of a Mesh.Mesh, of arrays (V, F), or of an ElementMesh.

    shape  a taken Part.Shape: the deviation of triangles from it is shown, too
    """
    if isinstance(source, DeviationMap):
        return _of_deviation(source, name)
    if isinstance(source, (ThicknessMap, DraftMap)):
        return _of_map(source, name)
    if isinstance(source, SurfaceMesh) or convert.is_mesh(source) or is_arrays(source):
        mesh = source if isinstance(source, SurfaceMesh) else SurfaceMesh(surface_of(source))
        return _of_triangles(mesh, name, shape, progress)
    if hasattr(source, "elements") or isinstance(source, ElementMesh) or hasattr(source, "blocks"):
        return _of_elements(source, name)
    raise InvalidInput(f"a mesh, or what thickness, draft or deviation return, is needed for a report, not {type(source).__name__}")


def _digest(*arrays):
    found = hashlib.sha256()
    for array in arrays:
        found.update(np.ascontiguousarray(array))
    return found.hexdigest()


def _corners(mesh):
    return (mesh.vertices + mesh.origin)[mesh.triangles]


def _faces(mesh):
    return np.array(mesh.triangle_face) if len(mesh.triangle_face) else np.full(len(mesh.triangles), -1)


def _length(value):
    return f"{value:.6g} mm"


def _measured(mesh):
    """[(words, text), ...] of a SurfaceMesh."""
    report = mesh.report
    yes = {True: words.YES, False: words.NO}
    rows = [(words.TRIANGLES, f"{report.triangles:,}"), (words.VERTICES, f"{report.vertices:,}"),
            (words.CLOSED, yes[report.closed]), (words.MANIFOLD, yes[report.manifold]),
            (words.MIN_ANGLE, f"{report.min_angle:.5g}°"), (words.MAX_ANGLE, f"{report.max_angle:.5g}°")]
    if report.self_intersections >= 0:
        rows.append((words.CROSSINGS, f"{report.self_intersections:,}"))
    distance = getattr(report, "max_chord_height", 0.0) or 0.0
    if distance > 0.0:
        rows.append((words.DEVIATION, _length(distance)))
    proven = getattr(mesh, "deviation", None) or getattr(report, "error_bound", None)
    if isinstance(proven, float):
        rows.append((words.PROVEN, _length(proven)))
    low, high = (np.asarray(corner) for corner in report.box)
    size = " x ".join(f"{side:.6g}" for side in high - low) + " mm"
    return [*rows, (words.AREA, f"{report.area:.7g} mm²"), (words.VOLUME, f"{report.volume:.7g} mm³"), (words.SIZE, size)]


def _asked(mesh):
    report = mesh.report
    rows = [(words.MIN_ANGLE, f"{report.min_angle_asked:g}°")] if getattr(report, "min_angle_asked", 0.0) else []
    for name in ("chord_height_asked", "tolerance_asked"):
        if getattr(report, name, 0.0):
            rows.append((words.DEVIATION, _length(getattr(report, name))))
    return rows


def _of_triangles(mesh, name, shape, progress):
    if not len(mesh.triangles):
        raise InvalidInput("the mesh has no triangles: there is nothing to report")
    asked, report = _asked(mesh), mesh.report
    views = [View(words.MIN_ANGLE, "°", extension().triangle_shapes(mesh._surface)[0], 0.0, 60.0,
                  getattr(report, "min_angle_asked", 0.0) or None)]
    if shape is not None:
        values = extension().triangle_deviations(mesh._surface, shape, progress)
        limit = getattr(report, "chord_height_asked", 0.0) or None
        views.append(View(words.DEVIATION, "mm", values, limit or float(values.max()) or 1.0, 0.0, limit))
    corners = _corners(mesh)
    reasons = {triangle: reason.message for triangle, reason in getattr(report, "exempt_reasons", ())}
    content = Content(name, corners, np.arange(len(corners)), _faces(mesh), views, _digest(mesh.vertices, mesh.triangles),
                      _measured(mesh), str(report), asked=asked)
    content.add_exempt(reasons)
    return content


def _first_of_each(reasons):
    """(triangle, reason): the first of each reason, then the others, MOST_PLACES at most."""
    seen, first, more = set(), [], []
    for triangle, reason in reasons:
        (more if str(reason) in seen else first).append((triangle, reason))
        seen.add(str(reason))
    return [*first, *more][:MOST_PLACES]


def _of_map(found, name):
    """Of a ThicknessMap or a DraftMap."""
    mesh, corners = found.mesh, _corners(found.mesh)
    asked, places, count = [], [], 0
    if isinstance(found, DraftMap):
        views = [View(words.DRAFT, "°", np.abs(found.angles), 0.0, max(_POOR_DRAFT, 2.0 * found.min_draft), found.min_draft or None)]
        asked = [(words.DRAFT, f"{found.min_draft:g}°")]
    else:
        values = np.where(found.is_wall, found.values, np.inf)
        finite = values[np.isfinite(values)]
        views = [View(words.THICKNESS, "mm", values, 0.0, 2.0 * float(np.median(finite)) if len(finite) else 1.0, found.min_thickness)]
        if found.min_thickness is not None:
            thin, asked = found.thin_places(), [(words.THICKNESS, _length(found.min_thickness))]
            count = len(thin)
            places = [Place(f"{place.thickness:.4g} mm" + (f" ({', '.join(place.faces)})" if place.faces else ""), place.point,
                            place.triangles) for place in thin[:MOST_PLACES]]
    return Content(name, corners, np.arange(len(corners)), _faces(mesh), views, _digest(mesh.vertices, mesh.triangles), _measured(mesh),
                   str(found), asked=asked, places=places, all_places=count)


def _of_deviation(found, name):
    vertices, triangles, chosen = drawn(found)
    of_corners = chosen[triangles]
    worst = of_corners[np.arange(len(triangles)), np.abs(found.values[of_corners]).argmax(axis=1)]
    limit = found.tolerance or found.max_deviation or 1.0
    view = View(words.SIGNED, "mm", found.values[worst], limit, -limit)
    corners = vertices[triangles]
    centres = corners.mean(axis=1)
    places = [Place(f"{place.value:+.4g} mm" + (f" ({place.face})" if place.face else ""), place.point,
                    np.array([np.square(centres - place.point).sum(axis=1).argmin()])) for place in found.worst_places(MOST_PLACES)]
    asked = [(words.DEVIATION, _length(found.tolerance))] if found.tolerance is not None else []
    measured = [(words.DEVIATION, _length(found.max_deviation))]
    return Content(name, corners, np.arange(len(corners)), found.faces[worst], [view], _digest(found.points, found.triangles), measured,
                   str(found), asked=asked, places=places, all_places=len(places))


def _of_elements(source, name):
    mesh = ElementMesh.of(source)
    table, drawn_parts, owners, starts = table_of_elements(mesh), [], [], 0
    of_highest = []
    for block in mesh.blocks:
        of_highest.append(starts)
        starts += len(block.nodes) if kinds.DIMENSION[block.kind] == mesh.dimension else 0
    for nodes, block, element in boundary.with_elements(mesh.blocks):
        corners = _corners_of_faces(nodes)
        owner = np.array(of_highest)[block] + element
        for at in range(1, corners.shape[1] - 1):
            drawn_parts.append(mesh.nodes[corners[:, [0, at, at + 1]]])
            owners.append(owner)
    views = [View(words.JACOBIAN, "", table["scaled_jacobian"], 0.0, 1.0)]
    count = len(table)
    report = getattr(source, "report", None)
    measured = [(words.ELEMENTS, ", ".join(f"{number:,} {kinds.PLURALS[kind]}" for kind, number in table.kinds.items())),
                (words.VERTICES, f"{len(mesh.nodes):,}")]
    if hasattr(report, "max_deviation"):
        measured.append((words.DEVIATION, _length(report.max_deviation)))
    return Content(name, np.concatenate(drawn_parts), np.concatenate(owners), np.full(count, -1), views,
                   _digest(mesh.nodes, *(block.nodes for block in mesh.blocks)), measured,
                   "\n".join(filter(None, (str(report) if report is not None else "", str(table)))))


def _corners_of_faces(nodes):
    """The corners of triangles (3, 6, 10, 15, 21 nodes) or quadrilaterals (4, 8, 9, 16, 25, 36)."""
    return nodes[:, :3 if nodes.shape[1] in (3, 6, 10, 15, 21) else 4]


def area_by_element(content):
    """float64 (E,), mm², of what is drawn of each element."""
    corners = content.corners
    areas = 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    return np.bincount(content.element, weights=areas, minlength=len(content.face))

