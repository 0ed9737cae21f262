# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layers of prisms on walls: as high as asked where that is valid, lower where it is not, and left off where they would be lower
than LEAST of that, or have faces that checkMesh would find too skew. There they run out within one triangle, all together: prisms
of which an edge has no height, which are pyramids, or two, tetrahedra. So all elements conform, and no side of a layer is left to
be filled.
"""

from dataclasses import dataclass

import numpy as np

from ...compat import extension
from ..elements.alike import shares, unique_pairs
from ..elements.neighbours import skew_faces

LEAST = 0.2  # share of the heights that were asked for below which there are no layers
_OF_GAP = 0.4  # most of a gap that layers on one side of it take
_SLOPE = 0.5  # most by which the heights of two vertices differ, for each mm of the edge between them
_LOWER = 0.75  # factor by which heights are lowered where elements are invalid
_SHORT = 4.0  # mm by which a vertex moves for each mm of height: columns are longer only at knife edges, where faces are too skew else
_MOST_SKEW = 3.9  # skewness of faces between elements; checkMesh accepts 4
_ROUNDS = 60
_LEAST_SHRINK = 0.05  # share of its area that a triangle keeps, at least, where layers end


@dataclass(frozen=True)
class Layers:
    """Elements on the walls, and the closed surface that they leave to be filled.

    points      float64 (N, 3), mm: the vertices of the surface first, then those of the layers
    prisms, pyramids, tetrahedra
                int (E, 6 | 5 | 4), in Gmsh's order
    level       int (P,), the layer of each prism, from 0 at the wall
    inner       int (T', 3), rows of points: the surface that is left, outward
    boundary    [(int (F, 3 | 4), int (F,))]: faces of the whole mesh, outward, with the CAD face of each
    covered     bool (T,): triangles of the wall that have prisms
    share       float64 (V,): of the heights that were asked for, how much each vertex got; 0 where there is no layer
    """

    points: np.ndarray
    prisms: np.ndarray
    pyramids: np.ndarray
    tetrahedra: np.ndarray
    level: np.ndarray
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
        return unique_pairs(np.sort(np.concatenate([self.triangles[:, [i, (i + 1) % 3]] for i in range(3)]), axis=1))[0]


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
    on_walls = np.zeros(len(share), dtype=bool)
    on_walls[walls] = True
    alive = on_walls & (marching.visible > 0.02)
    reach = np.linalg.norm(marching.direction, axis=1)
    length = np.minimum(reach, _SHORT)  # of the columns, for each mm of height
    growing = reach > _SHORT
    valid = None
    for _ in range(_ROUNDS):
        check()
        alive &= share >= LEAST
        covered = surface.is_wall & alive[surface.triangles].all(axis=1)
        alive = np.zeros(len(share), dtype=bool)
        alive[surface.triangles[covered]] = True
        share[on_walls & ~alive] = 0.0
        share = _sloped(share, edges, lengths, total)
        moved = marching.displacements(total * share * length / np.where(reach > 0.0, reach, 1.0), edges, lengths, on_walls & ~alive, check)
        check()
        made = _assembled(surface, alive, moved, np.cumsum(heights) / total, share)
        bad = _bad_vertices(surface, made, check)
        if not bad.any():
            valid = made
            skew = _skew_vertices(surface, made, check) & alive
            if not skew.any():
                break
            if (skew & growing).any():
                length, growing = np.where(skew & growing, reach, length), growing & ~skew
            else:
                share[skew] = 0.0
            continue
        near = bad if (bad & alive).any() else _on_same_faces(surface, bad) & alive  # as far as the nearest wall
        long = near & (length > _SHORT)
        length[long] = np.maximum(_LOWER * length[long], _SHORT)
        share[near & ~long] *= _LOWER
    return valid


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


def _assembled(surface, alive, moved, fractions, share):
    """The Layers for displacements of the vertices, of which those that are alive have a point at each level."""
    count, levels = len(surface.points), len(fractions)
    base, columns = surface.points.copy(), np.flatnonzero(alive)
    off = _off_walls(surface)
    base[off] += moved[off]
    points = np.concatenate([base, *(surface.points[columns] + moved[columns] * part for part in fractions)])
    point_at = np.tile(np.arange(count)[:, None], (1, levels + 1))  # by vertex and level
    point_at[columns, 1:] = count + np.arange(len(columns))[:, None] + len(columns) * np.arange(levels)[None, :]
    inward = surface.triangles[surface.is_wall][:, [0, 2, 1]]
    corners = alive[inward].sum(axis=1)
    first = np.where(corners == 1, np.argmax(alive[inward], axis=1), np.argmin(alive[inward], axis=1))  # unlike the other two
    turned = np.take_along_axis(inward, (first[:, None] + np.arange(3)) % 3, axis=1)
    prisms, pyramids, tetrahedra = [], [], []
    for k in range(levels):
        low, high = point_at[:, k], point_at[:, k + 1]
        a, b, c = turned[corners == 3].T
        prisms.append(np.column_stack([low[a], low[b], low[c], high[a], high[b], high[c]]))
        a, b, c = turned[corners == 2].T
        pyramids.append(np.column_stack([low[b], high[b], high[c], low[c], low[a]]))
        a, b, c = turned[corners == 1].T
        tetrahedra.append(np.column_stack([low[a], low[b], low[c], high[a]]))
    covered = surface.is_wall & alive[surface.triangles].all(axis=1)
    top = point_at[:, -1]
    others = ~surface.is_wall
    boundary = [(surface.triangles[surface.is_wall], surface.face[surface.is_wall]), (top[surface.triangles[others]], surface.face[others]),
                *_rims(surface, alive, point_at)]
    return Layers(points, np.concatenate(prisms), np.concatenate(pyramids), np.concatenate(tetrahedra),
                  np.repeat(np.arange(levels), covered.sum()), top[surface.triangles], boundary, covered, np.where(alive, share, 0.0))


def _rims(surface, alive, point_at):
    """[(faces, CAD faces)]: what sides of layers cover of faces without layers, outward as those faces are."""
    count = len(surface.triangles)
    directed = np.concatenate([surface.triangles[:, [i, (i + 1) % 3]] for i in range(3)])
    order = np.lexsort(np.sort(directed, axis=1).T)
    one, other = np.concatenate([order[0::2], order[1::2]]), np.concatenate([order[1::2], order[0::2]])  # two triangles an edge
    at_rim = surface.is_wall[one % count] & ~surface.is_wall[other % count]
    (a, b), faces = directed[other[at_rim]].T, surface.face[other[at_rim] % count]
    found = []
    for k in range(point_at.shape[1] - 1):
        low, high = point_at[:, k], point_at[:, k + 1]
        both, first, second = alive[a] & alive[b], alive[a] & ~alive[b], ~alive[a] & alive[b]
        found += [(np.column_stack([low[a], low[b], high[b], high[a]])[both], faces[both]),
                  (np.column_stack([low[a], low[b], high[a]])[first], faces[first]),
                  (np.column_stack([low[a], low[b], high[b]])[second], faces[second])]
    return found


def proven_bounds(points, kind, elements, order=1, check=lambda: None):
    """float64 (E,): lower bounds of min J / max |J|; 0 of elements that are not proven valid."""
    found = np.zeros(len(elements))
    for share in shares(len(elements)):
        check()
        low, _, verdict = extension().check_elements(kind, order, points, elements[share].astype(np.int32))
        found[share] = np.where(np.asarray(verdict) == 0, np.maximum(low, 0.0), 0.0)
    return found


def _unproven(points, kind, elements, check):
    """Indices of elements that are not proven valid."""
    return np.flatnonzero(~(proven_bounds(points, kind, elements, check=check) > 0.0))


def _bad_vertices(surface, made, check):
    """bool (V,): vertices of the surface at which something is wrong: elements, triangles that turn over or nearly vanish, or the
    surface that is left crosses itself.
    """
    found = []
    for kind, elements in (("prism", made.prisms), ("pyramid", made.pyramids), ("tetrahedron", made.tetrahedra)):
        found.append(elements[_unproven(made.points, kind, elements, check)].ravel())
    before, after = _area_vectors(surface.points, surface.triangles), _area_vectors(made.points, made.inner)
    kept = np.einsum("ti,ti->t", before, after) / np.einsum("ti,ti->t", before, before)
    found.append(surface.triangles[kept < _LEAST_SHRINK].ravel())
    if not any(len(part) for part in found):
        crossing, not_proven, *_ = extension().surface_crossings(made.points, [("triangle", 1, made.inner.astype(np.int32))],
                                                               lambda *_: check())
        pairs = np.array([*crossing, *not_proven], dtype=np.int64).reshape(-1)
        found.append(made.inner[pairs].ravel())
    return _vertices_of(surface, made, np.concatenate(found))


def _skew_vertices(surface, made, check):
    """bool (V,): vertices of the surface with faces above them that are skewer than _MOST_SKEW. Lower layers would be skewer still."""
    blocks = [("prism", made.prisms), ("pyramid", made.pyramids), ("tetrahedron", made.tetrahedra)]
    return _vertices_of(surface, made, skew_faces(made.points, [block for block in blocks if len(block[1])], _MOST_SKEW, check))


def _vertices_of(surface, made, points):
    """bool (V,): the vertices of the surface that points of Layers belong to, or stand above."""
    count, columns = len(surface.points), np.flatnonzero(made.share)
    vertex_of = np.concatenate([np.arange(count), np.tile(columns, (len(made.points) - count) // max(len(columns), 1))])
    found = np.zeros(count, dtype=bool)
    found[vertex_of[points.astype(np.int64)]] = True
    return found


def _off_walls(surface):
    off = np.ones(len(surface.points), dtype=bool)
    off[surface.triangles[surface.is_wall]] = False
    return off


def _area_vectors(points, triangles):
    a, b, c = points[triangles].transpose(1, 0, 2)
    return np.cross(b - a, c - a)
