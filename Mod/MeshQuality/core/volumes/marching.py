# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the vertices of a closed surface go when layers grow on some of its triangles: along marching directions on the walls,
in their own planes on the other faces, and along the surface so that triangles shrink evenly.
"""

from dataclasses import dataclass

import numpy as np

from ..elements.alike import shares

STRETCH = 10.0  # most that a vertex moves for each mm of the layers' height: at sharper edges layers get thinner than that
_HULL_STEPS = 400  # of the search for the marching direction
_SMOOTHING_STEPS = 150
_SMALL_TURN = 0.02  # share of the normals' spread below which the triangles of a vertex count as one plane
_ENDS = 0.17  # sine of 10 degrees: layers end in faces that turn off the wall by this at least, so that they lie in them
_AT_A_TIME = 10_000  # vertices
_SAME_PLANE = 1e-6  # likewise for faces that are planes


@dataclass(frozen=True)
class Marching:
    """How the vertices of a surface march.

    direction  float64 (V, 3), mm for each mm of height: by it all wall triangles of a vertex move by that height at least, or less
               where that needs more than STRETCH; zero off the walls
    visible    float64 (V,), the least cosine between the direction and the normals of the vertex' wall triangles: above 0, the vertex
               sees all of them from inside; infinite off the walls, 0 where a wall goes on in a face without layers, or turns away
               from it, so that no layer ends in that face
    along      float64 (V, 3, 3), projectors onto the ways by which a vertex may also move: along all of its triangles
    """

    direction: np.ndarray
    visible: np.ndarray
    along: np.ndarray

    def displacements(self, heights, edges, lengths, fixed, check=lambda: None):
        """float64 (V, 3), mm: each vertex moves by its height along its direction, and along the surface as its neighbours do.

        heights  float64 (V,), mm
        edges    int (E, 2); lengths: float64 (E,), mm
        fixed    bool (V,): vertices that stay
        check    called now and then; may raise Cancelled
        """
        given = heights[:, None] * self.direction
        given[fixed] = 0.0
        moved = given.copy()
        both = np.concatenate([edges, edges[:, ::-1]])
        weights = np.concatenate([1.0 / lengths, 1.0 / lengths])
        whole = np.bincount(both[:, 0], weights=weights, minlength=len(given))
        along = np.where(fixed[:, None, None], 0.0, self.along)
        for _ in range(_SMOOTHING_STEPS):
            check()
            mean = np.stack([np.bincount(both[:, 0], weights=weights * moved[both[:, 1], k], minlength=len(given))
                             for k in range(3)], axis=1) / whole[:, None]
            moved = given + np.einsum("vij,vj->vi", along, mean)
        return moved


def marching_of(points, triangles, face, is_wall, plane_normal, check=lambda: None):
    """The Marching of a closed surface.

    face          int (T,), the CAD face of each triangle
    is_wall       bool (T,)
    plane_normal  float64 (T, 3): the unit normal of the plane that a triangle without layers lies in; not a number: it lies in
                  none, and its vertices stay
    check         called now and then; may raise Cancelled
    """
    count = len(points)
    a, b, c = points[triangles].transpose(1, 0, 2)
    inward = -np.cross(b - a, c - a)
    inward /= np.linalg.norm(inward, axis=1)[:, None]
    planes = _free_of(count, triangles[~is_wall], plane_normal[~is_wall], _SAME_PLANE, _seams(points, triangles, face, plane_normal),
                      check)
    uses, offsets = _uses_of(count, triangles[is_wall])
    normals = np.repeat(inward[is_wall], 3, axis=0)[uses]
    owner = np.repeat(np.arange(count), np.diff(offsets))
    projected = np.einsum("uij,uj->ui", planes[owner], normals)
    check()
    nearest = _least_of_hulls(projected, offsets, check)
    size = np.linalg.norm(nearest, axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        way = nearest / size[:, None]
        direction = way * np.minimum(1.0 / size, STRETCH)[:, None]
    visible = np.full(count, np.inf)
    np.minimum.at(visible, owner, np.einsum("ui,ui->u", normals, np.nan_to_num(way)[owner]))
    direction[~np.isfinite(direction).all(axis=1)] = 0.0
    visible[_without_end(points, triangles, is_wall, inward)] = 0.0
    check()
    along = planes @ _kernels(_spread([(owner, projected)], count), _SMALL_TURN, check) @ planes
    return Marching(direction, visible, along)


def _without_end(points, triangles, is_wall, inward):
    """bool (V,): ends of edges at which a wall meets a face without layers, but layers on the wall would not lie in that face."""
    directed, one, other = _beside(triangles)
    count = len(triangles)
    at_end = is_wall[one % count] & ~is_wall[other % count]
    one, other = one[at_end], other[at_end]
    start, end, apex = points[directed[other]].transpose(1, 0, 2)
    along = (end - start) / np.linalg.norm(end - start, axis=1)[:, None]
    into = apex - start - np.einsum("ei,ei->e", apex - start, along)[:, None] * along
    into /= np.linalg.norm(into, axis=1)[:, None]
    found = np.zeros(len(points), dtype=bool)
    found[directed[one[np.einsum("ei,ei->e", inward[one % count], into) < _ENDS], :2]] = True
    return found


def _beside(triangles):
    """(edges of all triangles with the corner opposite, int (3T, 3); rows of these, and the rows of the same edges in the triangles beside
    them). Row i is of triangle i % T.
    """
    directed = np.concatenate([triangles[:, [i, (i + 1) % 3, (i + 2) % 3]] for i in range(3)])
    order = np.lexsort(np.sort(directed[:, :2], axis=1).T)
    return directed, np.concatenate([order[0::2], order[1::2]]), np.concatenate([order[1::2], order[0::2]])


def _seams(points, triangles, face, plane_normal):
    """(ends of edges between two faces without layers, int (E, 2); unit vectors across these edges in the first face's plane). Where both lie in
    one plane nothing else keeps their vertices on the edge, as the mesh of a patch needs.
    """
    directed, one, other = _beside(triangles)
    count = len(triangles)
    here, there = one % count, other % count
    known = np.isfinite(plane_normal[here]).all(axis=1) & np.isfinite(plane_normal[there]).all(axis=1) & (face[here] < face[there])
    ends = directed[one[known], :2]
    across = np.cross(points[ends[:, 1]] - points[ends[:, 0]], plane_normal[here[known]])
    return ends, across / np.linalg.norm(across, axis=1)[:, None]


def _uses_of(count, triangles):
    """Rows of corners of triangles, sorted by vertex, and where those of each vertex begin."""
    order = np.argsort(triangles.ravel(), kind="stable")
    return order, np.concatenate([[0], np.cumsum(np.bincount(triangles.ravel(), minlength=count))])


def _free_of(count, triangles, normals, tolerance, seams, check):
    """Projectors (V, 3, 3) onto what all planes and _seams of a vertex have in common; zero where one of its triangles lies in no plane."""
    bent = np.zeros(count, dtype=bool)
    known = np.isfinite(normals).all(axis=1)
    bent[triangles[~known]] = True
    ends, across = seams
    parts = [*((triangles[known, k], normals[known]) for k in range(3)), *((ends[:, k], across) for k in range(2))]
    found = _kernels(_spread(parts, count), tolerance, check)
    found[bent] = 0.0
    return found


def _spread(parts, count):
    """float64 (V, 3, 3): by vertex the sum of the outer products of vectors with themselves; parts are [(vertices, vectors), ...]."""
    owner, vectors = (np.concatenate(side) for side in zip(*parts))
    found = np.empty((count, 3, 3))
    for i in range(3):
        for j in range(3):
            found[:, i, j] = np.bincount(owner, weights=vectors[:, i] * vectors[:, j], minlength=count)
    return found


def _kernels(spread, tolerance, check):
    """Projectors onto the eigenvectors whose eigenvalues are below a share of the sum of all."""
    found = np.empty_like(spread)
    for share in shares(len(spread), _AT_A_TIME):
        check()
        values, vectors = np.linalg.eigh(spread[share])
        small = values <= tolerance * values.sum(axis=1)[:, None]
        found[share] = np.einsum("vik,vk,vjk->vij", vectors, small.astype(float), vectors)
    return found


def _least_of_hulls(normals, offsets, check):
    """By vertex the point of the convex hull of its normals that is nearest to the origin: its direction is the one whose least
    cosine with them is largest (Aubry and Löhner 2008, the most normal normal), by the steps of Gilbert 1966.

    normals  float64 (U, 3), sorted by vertex; offsets: int (V + 1,), where those of each vertex begin
    """
    counts = np.diff(offsets)
    found = np.zeros((len(counts), 3))
    for number in np.unique(counts[counts > 0]).tolist():
        alike = np.flatnonzero(counts == number)
        for share in shares(len(alike), _AT_A_TIME):
            at = alike[share]
            found[at] = _least_of_alike(normals[offsets[at][:, None] + np.arange(number)], check)
    return found


def _least_of_alike(normals, check):
    """The same for float64 (V, n, 3): vertices with as many normals. One that a step leaves where it is has come to its end."""
    found = normals.sum(axis=1) / normals.shape[1]
    moving = np.arange(len(normals))
    for _ in range(_HULL_STEPS):
        if not len(moving):
            break
        check()
        there = found[moving]
        cosines = np.einsum("vni,vi->vn", normals[moving], there)
        step = normals[moving, np.argmin(cosines, axis=1)] - there
        size = np.einsum("vi,vi->v", step, step)
        share = -np.einsum("vi,vi->v", there, step) / np.where(size > 0.0, size, 1.0)
        found[moving] += np.clip(share, 0.0, 1.0)[:, None] * step
        moving = moving[(found[moving] != there).any(axis=1)]
    return found
