#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures 1 to 8 of Ruiz et al.: samples of edges and faces, Star step by step, samples joined in (u, v) and in space.

    /usr/bin/python3 benchmarks/papers ruiz-figures [--out-dir docs/pictures]

Figures 3 to 5 need every proposed vertex, also those that are rejected. They are made by the steps of the paper's section 2.4 word
for word, in Python and asking FreeCAD's faces. Their number of vertices stands beside that of the core's Star, which asks in
batches. The face is a wavy Bezier face of 10 by 10 mm, tests/parts/sampled.py.

Figures 1 and 2 are the border of that face with parameters that run 900 times as fast at one end as at the other: the core's samples,
and points at even parameters. Figure 6 has the samples of Sprinkle and of Star, figure 7 a triangle whose circumscribing ball is
empty and one whose ball is not.

Figure 8 is the face with those parameters. Its samples are joined three times: by
the Delaunay triangulation of their (u, v), which is the paper's figure 8a; by the core's parametric way, which flips the edges of
that triangulation as they lie in space; and by fronts in space, figure 8b. Empty: triangles
with no vertex within the ball around their circumcentre.
"""

import sys
from collections import deque
from pathlib import Path

import inside_freecad
import numpy as np
import small_pictures

CHORD_HEIGHT = 0.04  # mm
LARGEST = 1.0  # mm, r(K) of flat places: a tenth of the size
CLOSEST = 0.7  # of r(K): nearer proposals are too close (step 2.3)
WARP = 30.0
GROWN = 25  # hexagons in the picture of the growing region


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--out-dir", default=str(inside_freecad.ROOT / "docs" / "pictures"), help="folder for the pictures")
    return result


def spacing(face, u, v):
    """r(K) in mm for the chord height, as in the core: by the larger principal curvature."""
    height = 0.75 * CHORD_HEIGHT
    curvature = max(1e-12, *map(abs, face.curvatureAt(u, v)))
    return min(2.0 * np.sqrt(2.0 * height / curvature - height**2), LARGEST)


class Star:
    """Section 2.4 of the paper on one face whose border is sampled (step 0)."""

    def __init__(self, face, border):
        self.face, self.samples = face, [np.array(p) for p in border]
        self.hexagons = []  # (centre, corners, which became vertices)
        queue = deque(range(len(border)))
        while queue:
            self.expand(queue)

    def expand(self, queue):
        import FreeCAD

        centre = self.samples[queue.popleft()]
        u, v = self.face.Surface.parameter(FreeCAD.Vector(*centre))
        x, normal = (np.array(vector) for vector in (self.face.tangentAt(u, v)[0], self.face.normalAt(u, v)))
        y, radius = np.cross(normal, x), spacing(self.face, u, v)
        corners, taken = [], []
        for angle in np.arange(6) * np.pi / 3.0:
            corner = centre + radius * (np.cos(angle) * x + np.sin(angle) * y)
            found = self.projected(corner)
            new = found is not None and self.has_room(*found)
            corners.append(corner)
            taken.append(new)
            if new:
                queue.append(len(self.samples))
                self.samples.append(found[0])
        self.hexagons.append((centre, np.array(corners), np.array(taken)))

    def projected(self, corner):
        """Its place on the face and r(K) there; None outside (step 2.4)."""
        import FreeCAD

        point = FreeCAD.Vector(*corner)
        u, v = self.face.Surface.parameter(point)
        if not self.face.isPartOfDomain(u, v):
            return None
        place = self.face.valueAt(u, v)
        # What lies beyond the border is projected onto it.
        shift = (point - place).sub(self.face.normalAt(u, v) * (point - place).dot(self.face.normalAt(u, v)))
        return None if shift.Length > 1e-3 * CHORD_HEIGHT else (np.array(place), spacing(self.face, u, v))

    def has_room(self, place, radius):
        """Step 2.3."""
        return np.linalg.norm(np.array(self.samples) - place, axis=1).min() >= CLOSEST * radius


def border_of(mesh):
    return mesh.vertices[mesh.vertex_entity[:, 0] < 2]


def draw_star(star, mesh, path):
    """Figures 3a, 3b, 4 and 5 from above."""
    figure, axes = small_pictures.panels(2, 2, 4.4, 4.4)
    border = border_of(mesh)
    first = max(star.hexagons, key=lambda hexagon: hexagon[2].sum())
    for axis, title, hexagons in (
            (axes[0], "Figure 3a: a hexagon in the tangent plane", [first]),
            (axes[1], f"Figure 3b: the region after {GROWN} hexagons", star.hexagons[:GROWN]),
            (axes[2], "Figure 4: accepted (full) and rejected (crosses)", star.hexagons)):
        axis.set_title(title, fontsize=10)
        axis.plot(*border.T[:2], "s", color="black", markersize=3)
        for centre, corners, taken in hexagons:
            if len(hexagons) <= GROWN:
                axis.fill(*corners.T[:2], facecolor="#cfe3f5", edgecolor="#5588bb", linewidth=0.6, alpha=0.6)
            axis.plot(*centre[:2], ".", color="black", markersize=5)
            axis.plot(*corners[taken].T[:2], "o", color="#1c6fb5", markersize=3.5)
            axis.plot(*corners[~taken].T[:2], "x", color="#c22", markersize=3, alpha=0.6)
    axes[3].set_title("Figure 5: small where the curvature is high", fontsize=10)
    heights = curvature_at(star.face, mesh)
    drawn = axes[3].tripcolor(*mesh.vertices.T[:2], mesh.triangles, facecolors=heights, edgecolors="#334", linewidth=0.4,
                              cmap="YlOrRd", alpha=0.9)
    figure.colorbar(drawn, ax=axes[3], shrink=0.6, label="larger principal curvature, 1/mm")
    for axis in axes:
        axis.set_aspect("equal")
    centre = first[0]
    axes[0].set(xlim=(centre[0] - 1.6, centre[0] + 2.4), ylim=(centre[1] - 2.0, centre[1] + 2.0))
    small_pictures.save(figure, path)


def curvature_at(face, mesh):
    """The larger principal curvature at the centre of each triangle, 1/mm."""
    import FreeCAD

    centres = mesh.vertices[mesh.triangles].mean(axis=1)
    places = (face.Surface.parameter(FreeCAD.Vector(*centre)) for centre in centres)
    return np.array([max(map(abs, face.curvatureAt(*place))) for place in places])


def delaunay_in_parameters(face, mesh):
    """Triangles (T, 3) between the mesh's vertices."""
    import FreeCAD
    from scipy.spatial import Delaunay

    places = np.array([face.Surface.parameter(FreeCAD.Vector(*point)) for point in mesh.vertices])
    low, high = places.min(axis=0), places.max(axis=0)
    places = np.where(places - low < 1e-6 * (high - low), low, np.where(high - places < 1e-6 * (high - low), high, places))
    return Delaunay(places).simplices


def balls(vertices, triangles):
    """Circumcentres and radii of triangles in space."""
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    squares = (normal**2).sum(axis=1)[:, None]
    offset = (((c - a)**2).sum(axis=1)[:, None] * np.cross(normal, b - a) + ((b - a)**2).sum(axis=1)[:, None] * np.cross(c - a, normal))
    offset = offset / (2.0 * squares)
    return a + offset, np.linalg.norm(offset, axis=1)


def invaders(vertices, triangles):
    """How many vertices lie in the ball of each triangle."""
    centres, radii = balls(vertices, triangles)
    return np.array([(np.linalg.norm(vertices - centre, axis=1) < radius * (1.0 - 1e-6)).sum() for centre, radius in zip(centres, radii)])


def draw_ball(axis, vertices, triangles, chosen, colour):
    (centre,), (radius,) = balls(vertices, triangles[[chosen]])
    a, b, c = vertices[triangles[chosen]]
    x = (b - a) / np.linalg.norm(b - a)
    y = np.cross(np.cross(b - a, c - a), x)
    y = y / np.linalg.norm(y)
    turns = np.linspace(0.0, 2.0 * np.pi, 60)[:, None]
    axis.plot(*(centre + radius * (np.cos(turns) * x + np.sin(turns) * y))[:, :2].T, color=colour, linewidth=1.2)
    axis.fill(*np.array([a, b, c])[:, :2].T, facecolor=colour, alpha=0.4)
    near = np.linalg.norm(vertices - centre, axis=1) < radius * (1.0 - 1e-6)
    axis.plot(*vertices[near][:, :2].T, "o", color=colour, markersize=4)


def draw_samples(warped, sprinkled, star, joined, path):
    """Figures 1 and 2, 6a, 6b and 7 from above; joined: (vertices, triangles) in space and in (u, v)."""
    figure, axes = small_pictures.panels(1, 4, 3.4, 3.8)
    even = np.array([edge.valueAt(edge.FirstParameter + s * (edge.LastParameter - edge.FirstParameter))
                     for edge in warped.Edges for s in np.linspace(0.0, 1.0, 14)])
    axes[0].plot(*even[:, :2].T, "x", color="#c22", markersize=6)
    axes[0].plot(*border_of(star)[:, :2].T, "s", color="black", markersize=3)
    axes[0].set_title("1, 2: iso-metric, and even parameters (crosses)", fontsize=9)
    for axis, mesh, title in ((axes[1], sprinkled, "6a: Sprinkle"), (axes[2], star, "6b: Star")):
        axis.plot(*mesh.vertices[:, :2].T, ".", color="#1c6fb5", markersize=4)
        axis.plot(*border_of(mesh)[:, :2].T, "s", color="black", markersize=3)
        axis.set_title(f"{title}, {len(mesh.vertices)} samples", fontsize=9)
    (vertices, good), (_, bad) = joined
    axes[3].plot(*vertices[:, :2].T, ".", color="#888888", markersize=3)
    middle = np.array([5.0, 5.0])
    inside = invaders(vertices, good) == 0
    draw_ball(axes[3], vertices, good, np.flatnonzero(inside)[np.linalg.norm(
        vertices[good][inside].mean(axis=1)[:, :2] - [7.0, 5.0], axis=1).argmin()], "#1c6fb5")
    invaded = np.flatnonzero((invaders(vertices, bad) > 2) & (balls(vertices, bad)[1] < 2.0))
    draw_ball(axes[3], vertices, bad, invaded[np.linalg.norm(
        vertices[bad[invaded]].mean(axis=1)[:, :2] - middle, axis=1).argmin()], "#c22")
    axes[3].set_title("7: an empty ball, and one that is invaded", fontsize=9)
    for axis in axes:
        axis.set_aspect("equal")
    small_pictures.save(figure, path)


def draw_connectivity(panels, path):
    """panels: (title, vertices, triangles)."""
    import render

    figure, axes = small_pictures.panels(1, len(panels), 4.0, 5.0)
    for axis, (title, vertices, triangles) in zip(axes, panels):
        angles = render.smallest_angles(vertices, triangles)
        axis.tripcolor(*vertices.T[:2], triangles, facecolors=angles, edgecolors="#223", linewidth=0.35, cmap="RdYlBu",
                       vmin=0, vmax=60)
        axis.set_title(f"{title}\nsmallest angle {angles.min():.1f}, mean {angles.mean():.1f} degrees", fontsize=9, pad=12)
        axis.set_aspect("equal")
    small_pictures.save(figure, path)


def row(name, vertices, triangles):
    import render

    angles = render.smallest_angles(vertices, triangles)
    found = {"joined": name, "triangles": len(triangles), "min_angle": float(angles.min()),
             "mean_min_angle": float(angles.mean()), "below_30": float((angles < 30).mean()),
             "empty": float((invaders(vertices, triangles) == 0).mean())}
    print(f"{name:<32} {found['triangles']:9,} {found['min_angle']:8.1f} {found['mean_min_angle']:6.1f} "
          f"{100 * found['below_30']:6.1f} {100 * found['empty']:7.1f}", flush=True)
    return found


def work(arguments):
    sys.path.append(str(inside_freecad.ROOT / "tools"))
    import parts

    import MeshQuality as mq

    folder = Path(arguments.out_dir)
    options = {"method": "star", "refine_samples": False, "chord_height": CHORD_HEIGHT}
    face = parts.warped_face(1.0, 1.0).Faces[0]
    mesh = mq.triangulate(face, **options)
    star = Star(face, border_of(mesh))
    print(f"Star: {len(star.samples)} vertices by the paper's steps, {len(mesh.vertices)} by the core; proposals accepted "
          f"{sum(taken.sum() for _, _, taken in star.hexagons)}, rejected {sum((~taken).sum() for _, _, taken in star.hexagons)}")
    draw_star(star, mesh, folder / "ruiz_star.png")

    warped = parts.warped_face(WARP, WARP).Faces[0]
    space = mq.triangulate(warped, **options)
    flipped = mq.triangulate(warped, connectivity="parametric", **options)
    in_parameters = delaunay_in_parameters(warped, space)
    draw_samples(warped, mq.triangulate(warped, **{**options, "method": "sprinkle"}), space,
                 ((space.vertices, space.triangles), (space.vertices, in_parameters)), folder / "ruiz_samples.png")
    panels = [("8a: Delaunay in (u, v)", space.vertices, in_parameters),
              ("(u, v), then flipped in space", flipped.vertices, flipped.triangles),
              ("8b: pseudo-Delaunay in space", space.vertices, space.triangles)]
    draw_connectivity(panels, folder / "ruiz_connectivity.png")
    print(f"{'samples joined':<32} {'triangles':>9} {'smallest':>8} {'mean':>6} {'<30 %':>6} {'empty %':>7}")
    return {"star": {"paper": len(star.samples), "core": len(mesh.vertices)}, "rows": [row(*panel) for panel in panels]}


inside_freecad.start(__file__, parser(), work)
