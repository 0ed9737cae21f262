# SPDX-License-Identifier: LGPL-2.1-or-later
"""What came of the layers of a volume mesh."""

import math
from dataclasses import dataclass, replace

import numpy as np

from ... import flow_phrases, phrases
from ..measures import table_of_elements
from .first_height import FirstHeight

_LOW = 0.1  # of the edges on the walls: last layers that are lower are told of
_NAMED = 8  # elements that a note names
_MOST_LAYERS = 100  # as the option has it
_FULL = 0.95  # share of the height that was asked for from which on it counts as reached


@dataclass(frozen=True)
class WallCoverage:
    """The layers on one wall face.

    face              "Face3"; "zMin" of a far field's
    area              mm^2, of its triangles
    covered           share of the area with prisms in all layers; on the rest they run out, or there are none
    full_height       share of the area with layers at least 0.95 times as high as asked for
    least_height, mean_height
                      mm, of the first layer where there are layers; None where there are none
    """

    face: str
    area: float
    covered: float
    full_height: float
    least_height: float
    mean_height: float


@dataclass(frozen=True)
class VolumeReport:
    """What was asked for, and what came of it.

    layers, first_height, growth_rate
                         as given; heights: mm, of each layer as asked for
    elements             {kind: count}, of volumes; nodes: how many
    walls                [WallCoverage, ...], one for each wall face
    covered              share of the area of all walls with all layers
    full_height          likewise, at least 0.95 times as high as asked for
    volume               mm^3
    min_scaled_jacobian  of prisms and tetrahedra, as Verdict defines it
    max_non_orthogonality, max_skewness
                         of faces, degrees and a ratio, as OpenFOAM measures them
    chord_height         mm, largest distance of the surface from the shape
    order                of the elements. Of a higher order than 1 scaled Jacobian, non-orthogonality and skewness are those of the corners
    min_distortion       the smallest proven bound of min J / max |J|
    straightened         names of elements that bend less than the shape, or not at all, as they would not be valid otherwise
    notes                sentences that a user should know
    """

    layers: int
    first_height: float
    growth_rate: float
    heights: tuple
    elements: dict
    nodes: int
    walls: tuple
    covered: float
    full_height: float
    volume: float
    min_scaled_jacobian: float
    max_non_orthogonality: float
    max_skewness: float
    chord_height: float
    min_distortion: float
    notes: tuple
    order: int = 1
    straightened: tuple = ()

    def to_dict(self):
        """All of it, for JSON."""
        return {**vars(self), "heights": list(self.heights), "walls": [dict(vars(wall)) for wall in self.walls],
                "notes": list(self.notes), "straightened": list(self.straightened)}

    def of_order(self, mesh, curved, least):
        """The report of a VolumeMesh with the Curved elements on the same corners; least is their min_distortion."""
        bent = len(curved.straightened)
        notes = [f"{bent:,} of {sum(self.elements.values()):,} elements bend less than the shape, or not at all, to be valid: "
                 f"{phrases.Text('{list}', list=phrases.first_of(curved.straightened, _NAMED))}"] if bent else []
        return replace(self, order=mesh.order, nodes=len(mesh.nodes), volume=curved.volume, chord_height=curved.deviation,
                       min_distortion=least, straightened=curved.straightened, notes=(*notes, *self.notes))

    def figures(self):
        """Texts of what a line about the mesh tells."""
        yield phrases.counted(flow_phrases.CELLS, sum(self.elements.values()))
        yield phrases.Text(flow_phrases.COVERED, number=percent(self.covered), number2=percent(self.full_height))
        yield phrases.Text(flow_phrases.NON_ORTHOGONAL, number=f"{self.max_non_orthogonality:.3g}")

    def __str__(self):
        counts = ", ".join(f"{count:,} {kind}{'s' if kind != 'tetrahedron' else ''}" for kind, count in self.elements.items())
        counts = counts.replace("tetrahedron", "tetrahedra")
        of_order = f" of order {self.order}" if self.order > 1 else ""
        lines = [f"elements     {counts}{of_order}, {self.nodes:,} nodes, all proven valid",
                 f"layers       {self.layers}, the first {self.first_height:g} mm high, each {self.growth_rate:g} times as high as the "
                 f"one before: {sum(self.heights):.4g} mm together",
                 f"coverage     {self.covered:.2%} of the walls, {self.full_height:.2%} with the height asked for"]
        lines += [f"  {wall.face:<10} {wall.covered:.2%}, {wall.full_height:.2%} with the height asked for" + (
            f"; first layer {wall.least_height:.4g} mm at least, {wall.mean_height:.4g} mm on average" if wall.covered else "")
            for wall in self.walls]
        lines += [f"quality      least scaled Jacobian {self.min_scaled_jacobian:.4g}, non-orthogonality up to "
                  f"{self.max_non_orthogonality:.4g}°, skewness up to {self.max_skewness:.4g}",
                  f"accuracy     the surface deviates by at most {self.chord_height:.3g} mm from the shape"]
        return "\n".join([*lines, *(f"note         {note}" for note in self.notes)]) + "\n"


def percent(share):
    """As many percent, never 100 where something is missing."""
    return "100" if share >= 1.0 else f"{min(100.0 * share, 99.9):.3g}"


def coverage_of(surface, layers, first_height):
    """(the WallCoverage of each wall face, share of the walls with layers, and with full height)."""
    walls = np.flatnonzero(surface.is_wall)
    areas = _areas(surface.points, surface.triangles)
    share = np.where(layers.covered, layers.share[surface.triangles].min(axis=1), 0.0)
    mean = np.where(layers.covered, layers.share[surface.triangles].mean(axis=1), 0.0)
    found = []
    for face in np.unique(surface.face[walls]).tolist():
        there = walls[surface.face[walls] == face]
        area, on = areas[there].sum(), layers.covered[there]
        heights = first_height * mean[there][on]
        found.append(WallCoverage(
            surface.name_of(face), float(area), float(areas[there][on].sum() / area), float(areas[there][share[there] >= _FULL].sum() / area),
            first_height * float(share[there][on].min()) if on.any() else None,
            float(np.average(heights, weights=areas[there][on])) if on.any() else None))
    whole = areas[walls].sum()
    return tuple(found), float(areas[layers.covered].sum() / whole), float(areas[share >= _FULL].sum() / whole)


def report_of(mesh, surface, layers, values, heights, chord_height, least, gap_of, check):
    """The VolumeReport of a VolumeMesh; values are the checked options, least is its min_distortion, gap_of {wall face: its widest gap, mm}.
    `check` is called now and then, and may raise Cancelled.
    """
    table = table_of_elements(mesh, check)
    walls, covered, full = coverage_of(surface, layers, values["first_height"])
    total, gaps = heights.sum(), {surface.name_of(face): gap for face, gap in gap_of.items()}
    notes = [bare_note(wall, gaps[wall.face], total) for wall in walls if wall.covered < 1.0]
    notes += _step_note(surface, values, heights[-1])
    notes += [str(values["first_height"])] if isinstance(values["first_height"], FirstHeight) else []
    notes += [f"the layers on {wall.face} are lower than asked for on {wall.covered - wall.full_height:.1%} of its area, the first one "
              f"{wall.least_height:.3g} mm at least" for wall in walls if wall.covered - wall.full_height > 0.0005]
    return VolumeReport(values["layers"], float(values["first_height"]), values["growth_rate"], tuple(heights.tolist()), dict(table.kinds),
                        len(mesh.nodes), walls, covered, full, _volume(mesh), table.worst("scaled_jacobian")[1],
                        table.worst("non_orthogonality")[1], table.worst("skewness")[1], chord_height, least, tuple(notes))


def partly(share):
    """A share below 1 in percent with one digit, never 100.0%."""
    return f"{min(share, 0.999):.1%}"


def bare_note(wall, gap, total):
    """Why layers that are `total` mm thick do not cover all of a WallCoverage's face, whose widest gap is `gap` mm."""
    if not wall.covered and gap < total:
        return f"{wall.face} has no layers: the gap there is {gap:.3g} mm at most, and the layers are {total:.3g} mm thick"
    return (f"{wall.face} has layers on {partly(wall.covered)} of its area only: elsewhere they would be lower than a fifth of what was asked "
            "for, or invalid or skew, or not end in the face beside it")


def _step_note(surface, values, last):
    """[a sentence] where the last layer is so low that solvers interpolate poorly between it and the tetrahedra on it."""
    corners = surface.points[surface.triangles[surface.is_wall]]
    edge = float(np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).mean())
    if last >= _LOW * edge:
        return []
    growth, wanted = values["growth_rate"], 2.0 * _LOW * edge
    layers = values["layers"] + math.ceil(math.log(wanted / last) / math.log(growth)) if growth > 1.0 else 0
    remedy = f"{layers} layers would end at {wanted:.2g} mm" if 0 < layers <= _MOST_LAYERS else "give a larger growth_rate, or shorter edges"
    return [f"the last layer is {last:.3g} mm high, and edges are {edge:.3g} mm long, {edge / last:.0f} times as much: elements grow at once there; {remedy}"]


def _areas(points, triangles):
    a, b, c = points[triangles].transpose(1, 0, 2)
    return 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)


def _volume(mesh):
    """mm^3, by the boundary: a quadrilateral counts as the mean of both ways to cut it into triangles."""
    ways = [(mesh.boundary_triangles, 1.0), *((mesh.boundary_quadrilaterals[:, list(way)], 0.5)
                                              for way in ((0, 1, 2), (0, 2, 3), (0, 1, 3), (1, 2, 3)))]
    origin = mesh.nodes.mean(axis=0)
    whole = 0.0
    for triangles, weight in ways:
        a, b, c = (mesh.nodes[triangles] - origin).transpose(1, 0, 2)
        whole += weight * np.einsum("ti,ti->", np.cross(a, b), c) / 6.0
    return float(whole)
