# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles of a face by normal umbrellas, as Ruiz et al. describe the method of Attene et al. in their section 1.

Around a vertex lies a regular hexagon of radius r(K) in the tangent plane; where no triangles are yet, its corners are projected
onto the face along the normal, and each two neighbours make a triangle with the vertex. A corner within half a radius of
a vertex is that vertex; one outside of the face makes no triangles. There is no rule of Attene's own for fronts that meet:
Ruiz et al. give none.
"""

from collections import deque

import numpy as np

CORNERS = 6
MERGED = 0.5  # of r(K)
MOST = 20_000  # vertices


class Umbrellas:
    """Grows from one place of the face among samples of its border; radius(point) in mm."""

    def __init__(self, face, border, start, radius):
        self.face, self.radius = face, radius
        self.vertices, self.triangles, self.at_vertex = list(border), [], [[] for _ in border]
        self.made, self.reached = set(), set()
        self.queue = deque()
        self.add(self.on_face(start))
        while self.queue and len(self.vertices) < MOST:
            self.expand(self.queue.popleft())

    def mesh(self):
        """(V, F)."""
        return np.array(self.vertices), np.array(self.triangles)

    def on_face(self, point):
        """The place beneath a point; None outside of the face."""
        import FreeCAD

        u, v = self.face.Surface.parameter(FreeCAD.Vector(*point))
        if not self.face.isPartOfDomain(u, v):
            return None
        place = np.array(self.face.valueAt(u, v))
        normal = np.array(self.face.normalAt(u, v))
        shift = point - place
        aside = np.linalg.norm(shift - normal * (shift @ normal))
        # What lies beyond the border is projected onto it.
        return None if aside > 1e-3 * self.radius(place) else place

    def add(self, place):
        self.vertices.append(place)
        self.at_vertex.append([])
        return self.reach(len(self.vertices) - 1)

    def reach(self, vertex):
        """Has an umbrella put around it, once."""
        if vertex not in self.reached:
            self.reached.add(vertex)
            self.queue.append(vertex)
        return vertex

    def expand(self, p):
        import FreeCAD

        centre = self.vertices[p]
        u, v = self.face.Surface.parameter(FreeCAD.Vector(*centre))
        x, normal = np.array(self.face.tangentAt(u, v)[0]), np.array(self.face.normalAt(u, v))
        y, radius = np.cross(normal, x), self.radius(centre)

        def angle_of(q):
            offset = self.vertices[q] - centre
            return np.arctan2(offset @ y, offset @ x) % (2.0 * np.pi)

        for from_angle, width, first, last in self.gaps(p, angle_of):
            count = max(1, round(CORNERS * width / (2.0 * np.pi)))
            row = [first]
            for k in range(1, count) if first is not None else range(count):
                angle = from_angle + width * k / count
                row.append(self.corner(p, centre + radius * (np.cos(angle) * x + np.sin(angle) * y), radius))
            row = row[1:] + row[1:2] if first is None else [*row, last]
            for a, b in zip(row, row[1:]):
                self.connect(p, a, b)

    def gaps(self, p, angle_of):
        """(angle, width, first and last neighbour) of each sector without triangles around a vertex, counter-clockwise.

        Without any triangle it is one sector of 2 pi without neighbours.
        """
        spokes = []
        for triangle in self.at_vertex[p]:
            k = triangle.index(p)
            spokes.append((triangle[(k + 1) % 3], triangle[(k + 2) % 3]))
        if not spokes:
            return [(0.0, 2.0 * np.pi, None, None)]
        starts, ends = {a for a, _ in spokes}, {b for _, b in spokes}
        found = []
        for last_covered in ends - starts:
            angle = angle_of(last_covered)
            ahead = [((angle_of(q) - angle) % (2.0 * np.pi), q) for q in starts - ends]
            if ahead:
                width, following = min(ahead)
                found.append((angle, width, last_covered, following))
        return found

    def corner(self, p, point, radius):
        """The vertex at a corner, new or near; None outside of the face."""
        found = self.on_face(point)
        if found is None:
            return None
        distances = np.linalg.norm(np.array(self.vertices) - found, axis=1)
        distances[p] = np.inf
        nearest = int(distances.argmin())
        return self.reach(nearest) if distances[nearest] < MERGED * radius else self.add(found)

    def connect(self, p, a, b):
        if a is None or b is None or len({p, a, b}) < 3 or frozenset((p, a, b)) in self.made:
            return
        self.made.add(frozenset((p, a, b)))
        triangle = (p, a, b)
        self.triangles.append(triangle)
        for vertex in triangle:
            self.at_vertex[vertex].append(triangle)
