# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layers of prisms on walls: as high as asked where that is valid, lower where it is not, and left off where they would be lower
than LEAST of that. Beside places without layers the prisms become pyramids and tetrahedra, so that all elements conform.
"""

from dataclasses import dataclass

import numpy as np

from ...compat import extension

LEAST = 0.2  # share of the heights that were asked for below which there are no layers
_OF_GAP = 0.4  # most of a gap that layers on one side of it take
_SLOPE = 0.5  # most by which the heights of two vertices differ, for each mm of the edge between them
_LOWER = 0.75  # factor by which heights are lowered where elements are invalid
_ROUNDS = 60
_LEAST_SHRINK = 0.05  # share of its area that a triangle keeps, at least, where layers end
_PRISM_ENDS = ((0, 2, 1), (3, 4, 5))
_PRISM_SIDES = ((0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5))  # side i is over edge i of the triangle


@dataclass(frozen=True)
class Layers:
    """Elements on the walls, and the closed surface that they leave to be filled.

    points      float64 (N, 3), mm: the vertices of the surface first, then those of the layers
    prisms, pyramids, tetrahedra
                int (E, 6 | 5 | 4), in Gmsh's order
    level       int (P,), the layer of each prism, from 0 at the wall; wall_of: the triangle of the wall that it is on
    inner       int (T', 3), rows of points: the surface that is left, outward
    boundary    [(int (F, 3 | 4), int (F,))]: faces of the whole mesh, outward, with the CAD face of each
    covered     bool (T,): triangles of the wall that have layers
    share       float64 (V,): of the heights that were asked for, how much each vertex got; 0 where there is no layer
    """

    points: np.ndarray
    prisms: np.ndarray
    pyramids: np.ndarray
    tetrahedra: np.ndarray
    level: np.ndarray
    wall_of: np.ndarray
    inner: np.ndarray
    boundary: list
    covered: np.ndarray
    share: np.ndarray


@dataclass(frozen=True)
class Surface:
    """A closed surface and its walls.

    points float64 (V, 3), mm; triangles int (T, 3), outward; face int (T,), the CAD face; is_wall bool (T,)
    far    (index of the first face of a far field, names of those)
    """

    points: np.ndarray
    triangles: np.ndarray
    face: np.ndarray
    is_wall: np.ndarray
    far: tuple = (0, ())

    def name_of(self, face):
        """What a face is called, by its index."""
        first, names = self.far
        return names[face - first] if names and face >= first else f"Face{face + 1}"

    @property
    def edges(self):
        """int (E, 2), each edge once."""
        return np.unique(np.sort(np.concatenate([self.triangles[:, [i, (i + 1) % 3]] for i in range(3)]), axis=1), axis=0)


def layers_of(surface, marching, heights, gap, check=lambda: None):
    """The Layers of a Surface; None where the rounds of lowering end before all is valid.

    heights  float64 (N,), mm, of the layers from the wall on
    gap      float64 (T,), mm, to what is opposite of each triangle; infinite where that is nothing
    check    called now and then; may raise
    """
    total = heights.sum()
    edges = surface.edges
    lengths = np.linalg.norm(surface.points[edges[:, 0]] - surface.points[edges[:, 1]], axis=1)
    share = np.ones(len(surface.points))
    walls = surface.triangles[surface.is_wall]
    np.minimum.at(share, walls, np.repeat(_OF_GAP * gap[surface.is_wall] / total, 3).reshape(-1, 3))
    blind = marching.visible <= 0.02
    share[blind] = 0.0
    covered = surface.is_wall.copy()
    for _ in range(_ROUNDS):
        check()
        covered &= (share[surface.triangles] >= LEAST).all(axis=1)
        share = np.maximum(share, np.where(blind, 0.0, LEAST))
        share = _sloped(share, edges, lengths, total)
        covered &= (share[surface.triangles] >= LEAST * 0.999).all(axis=1)
        has_layers = np.zeros(len(share), dtype=bool)
        has_layers[surface.triangles[covered]] = True
        fixed = np.zeros(len(share), dtype=bool)
        fixed[surface.triangles[surface.is_wall & ~covered]] = True
        moved = marching.displacements(total * share, edges, lengths, fixed & ~has_layers)
        made = _Assembly(surface, covered, has_layers, moved, np.cumsum(heights) / total).layers(np.where(has_layers, share, 0.0))
        bad = _bad_vertices(surface, made, has_layers, moved)
        if not len(bad):
            return made
        near = np.zeros(len(share), dtype=bool)
        near[bad] = True
        if not (near & has_layers).any():  # as far as the nearest wall
            near = _on_same_faces(surface, near) & has_layers
        share[near] *= _LOWER
    return None


def _on_same_faces(surface, near):
    faces = np.unique(surface.face[near[surface.triangles].any(axis=1)])
    found = np.zeros(len(near), dtype=bool)
    found[surface.triangles[np.isin(surface.face, faces)]] = True
    return found


def _sloped(share, edges, lengths, total):
    """Shares of which those of neighbours do not differ by more than the slope."""
    step = _SLOPE * lengths / total
    for _ in range(len(share)):
        before = share.copy()
        for one, other in ((0, 1), (1, 0)):
            np.minimum.at(share, edges[:, one], np.maximum(before[edges[:, other]], LEAST) + step)
        if np.array_equal(before, share):
            break
    return share


class _Assembly:
    """The elements of layers for chosen displacements of the vertices."""

    def __init__(self, surface, covered, has_layers, moved, fractions):
        self._surface, self._covered, self._fractions = surface, covered, fractions
        count, levels = len(surface.points), len(fractions)
        base = surface.points.copy()
        on_walls = np.zeros(count, dtype=bool)
        on_walls[surface.triangles[surface.is_wall]] = True
        base[~on_walls] += moved[~on_walls]
        columns = np.flatnonzero(has_layers)
        self._points = np.concatenate([base, *(surface.points[columns] + moved[columns] * part for part in fractions)])
        self._level = np.tile(np.arange(count)[:, None], (1, levels + 1))  # by vertex and level its point
        self._level[columns, 1:] = count + np.arange(len(columns))[:, None] + len(columns) * np.arange(levels)[None, :]
        self._has = has_layers

    def layers(self, share):
        surface, levels = self._surface, len(self._fractions)
        chosen = np.flatnonzero(self._covered)
        inward = surface.triangles[chosen][:, [0, 2, 1]]
        prisms = np.concatenate([np.concatenate([self._level[inward, k], self._level[inward, k + 1]], axis=1) for k in range(levels)])
        level, wall_of = np.repeat(np.arange(levels), len(chosen)), np.tile(chosen, levels)
        (bare, bare_faces), (at_rims, rim_faces), (ends, _) = self._edges_of_walls()
        exposed = np.stack([_among(inward[:, [i, (i + 1) % 3]], ends) for i in range(3)], axis=1)
        split = exposed.any(axis=1)
        pyramids, tetrahedra = self._divided(prisms[np.tile(split, levels)], np.tile(exposed[split], (levels, 1)))
        kept = ~np.tile(split, levels)
        top = self._level[:, -1]
        others = np.flatnonzero(~surface.is_wall)
        bare_walls = np.flatnonzero(surface.is_wall & ~self._covered)
        inner = np.concatenate([top[surface.triangles[chosen]], surface.triangles[bare_walls], top[surface.triangles[others]],
                                self._strips(ends[:, ::-1]), self._strips(bare)])
        boundary = [(surface.triangles[surface.is_wall], surface.face[surface.is_wall]),
                    (top[surface.triangles[others]], surface.face[others]), self._bare_rims(bare, bare_faces),
                    (self._quads(at_rims), np.tile(rim_faces, levels))]
        return Layers(self._points, prisms[kept], pyramids, tetrahedra, level[kept], wall_of[kept], inner, boundary,
                      self._covered, share)

    def _edges_of_walls(self):
        """[(directed edges (E, 2), the CAD face on the other side)]: of walls without layers at other faces, of walls with layers at
        other faces, and of walls with layers at walls without; seen from inside, as the prisms have them.
        """
        surface = self._surface
        kind = np.where(self._covered, 2, np.where(surface.is_wall, 1, 0))
        directed = np.concatenate([surface.triangles[:, [i, (i + 1) % 3]] for i in range(3)])
        order = np.lexsort(np.sort(directed, axis=1).T)
        one, other = np.concatenate([order[0::2], order[1::2]]), np.concatenate([order[1::2], order[0::2]])  # two triangles an edge
        count = len(surface.triangles)
        pair = kind[one % count] * 3 + kind[other % count]
        with_layers = self._has[directed[one]].any(axis=1)
        chosen = (pair == 3) & with_layers, pair == 6, pair == 7
        return [(directed[one[these]][:, ::-1], surface.face[other[these] % count]) for these in chosen]

    def _quads(self, edges):
        """Sides (E * levels, 4) over directed edges, layer by layer."""
        return np.concatenate([np.column_stack([self._level[edges[:, 0], k], self._level[edges[:, 1], k],
                                                self._level[edges[:, 1], k + 1], self._level[edges[:, 0], k + 1]])
                               for k in range(len(self._fractions))])

    def _strips(self, edges):
        """The same as triangles; those without area, where an end has no layers, are left out."""
        return _without_repetition(_halves(self._quads(edges)))

    def _bare_rims(self, edges, faces):
        """What layers leave of other faces beside walls without layers: (triangles, CAD faces), outward as those faces are."""
        strips = [self._strips(edge[None, :]) for edge in edges]
        return (np.concatenate([np.zeros((0, 3), dtype=np.int64), *strips]),
                np.repeat(faces, [len(strip) for strip in strips]).astype(np.int64))

    def _divided(self, prisms, exposed):
        """(pyramids, tetrahedra) around the middles of prisms: exposed sides are two triangles each."""
        middles = len(self._points) + np.arange(len(prisms))
        self._points = np.concatenate([self._points, self._points[prisms].mean(axis=1)]) if len(prisms) else self._points
        pyramids, tetrahedra = [np.zeros((0, 5), dtype=np.int64)], [np.zeros((0, 4), dtype=np.int64)]
        for side, corners in enumerate(_PRISM_SIDES):
            quads, out = prisms[:, list(corners)], exposed[:, side]
            pyramids.append(np.column_stack([quads[~out][:, [0, 3, 2, 1]], middles[~out]]))
            halves = _halves(quads[out])
            tetrahedra.append(np.column_stack([halves[:, [0, 2, 1]], np.tile(middles[out], 2)]))
        for end in _PRISM_ENDS:
            tetrahedra.append(np.column_stack([prisms[:, list(end)][:, [0, 2, 1]], middles]))
        return np.concatenate(pyramids), np.concatenate(tetrahedra)


def _halves(quads):
    """Two triangles a quadrilateral, cut at the corner with the least number, so that both sides of it are cut alike."""
    turn = (np.argmin(quads, axis=1)[:, None] + np.arange(4)) % 4
    turned = np.take_along_axis(quads, turn, axis=1)
    return np.concatenate([turned[:, [0, 1, 2]], turned[:, [0, 2, 3]]])


def _without_repetition(triangles):
    a, b, c = triangles.T
    return triangles[(a != b) & (b != c) & (c != a)]


def _among(edges, chosen):
    """bool (E,): which directed edges are among the chosen ones."""
    most = int(max(edges.max(initial=0), chosen.max(initial=0))) + 1
    return np.isin(edges[:, 0] * most + edges[:, 1], chosen[:, 0] * most + chosen[:, 1])


def unproven(points, kind, elements):
    """Indices of elements that are not proven valid."""
    if not len(elements):
        return np.zeros(0, dtype=np.int64)
    low, _, verdict = extension().check_elements(kind, 1, points, elements.astype(np.int32))
    return np.flatnonzero((np.asarray(verdict) != 0) | ~(np.asarray(low) > 0.0))


def _bad_vertices(surface, made, has_layers, moved):
    """Vertices of the surface at which something is wrong: elements, triangles that turn over or nearly vanish, or the surface
    that is left crosses itself.
    """
    found = []
    for kind, elements in (("prism", made.prisms), ("pyramid", made.pyramids), ("tetrahedron", made.tetrahedra)):
        found.append(elements[unproven(made.points, kind, elements)].ravel())
    ends = surface.points + np.where(has_layers[:, None] | _off_walls(surface)[:, None], moved, 0.0)
    before, after = (_area_vectors(points, surface.triangles) for points in (surface.points, ends))
    kept = np.einsum("ti,ti->t", before, after) / np.einsum("ti,ti->t", before, before)
    found.append(surface.triangles[kept < _LEAST_SHRINK].ravel())
    if not any(len(part) for part in found):
        crossing, not_proven, *_ = extension().surface_crossings(made.points, [("triangle", 1, made.inner.astype(np.int32))])
        pairs = np.array([*crossing, *not_proven], dtype=np.int64).reshape(-1)
        found.append(made.inner[pairs].ravel())
    return np.unique(_vertices_of(surface, made, has_layers)[np.concatenate(found).astype(np.int64)])


def _off_walls(surface):
    off = np.ones(len(surface.points), dtype=bool)
    off[surface.triangles[surface.is_wall]] = False
    return off


def _vertices_of(surface, made, has_layers):
    """By point the vertex of the surface that it is of; of middles of prisms the first vertex of a neighbour."""
    count, columns = len(surface.points), np.flatnonzero(has_layers)
    of = np.concatenate([np.arange(count), np.tile(columns, (len(made.points) - count) // max(len(columns), 1) + 1)])[:len(made.points)]
    for elements in (made.tetrahedra, made.pyramids):
        of[elements[:, -1]] = of[elements[:, 0]]
    return of


def _area_vectors(points, triangles):
    a, b, c = points[triangles].transpose(1, 0, 2)
    return np.cross(b - a, c - a)
