#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Claims (i) to (iii) of Ruiz et al. against umbrellas, and against triangulating first and improving then.

    /usr/bin/python3 benchmarks/papers ruiz-attene

Umbrellas are made as the paper describes them (umbrellas.py), with Star's samples of the border and its spacing. The paper has no
rule for fronts that meet, and Attene's own is not built. The other way: OpenCASCADE's incremental mesher triangulates each face in
its parameters, with the linear deflection at which about as many triangles come out as Star makes (angular deflection 0.5);
mq.improve then swaps edges, moves, inserts and removes vertices, with Star's chord height as tolerance. It sees no CAD. For claim
(iii) the fan of triangles that a regular polygon of n sides spreads is measured at the place of highest curvature, its sides about
r(K) long, as that claim describes it.

Meshes of Star and Sprinkle are raw. Where fronts meet: triangles whose centre is about as far from a second part of the face's
border, more than 60 degrees apart as seen from there, as from the nearest one (within half a mean edge). Curved: the tenth with the
highest curvature at the centre. A mesh has its holes where its Euler characteristic is the face's. Area: of all triangles, against
the face's. Tripled: edges with more than two triangles. Deviation: largest of the centres from the face. Seconds are those of the
processor.
"""

import sys
import time

import inside_freecad
import numpy as np

CHORD_HEIGHT = 0.002  # of the largest dimension
ALIKE, TRIES = 0.05, 12
BORDER_POINTS = 2000
FANS = ((6, 1.0), (12, 2.0), (24, 4.0))  # corners, radius in r(K): sides of about r(K)


def parser():
    return inside_freecad.command_line(__doc__)


def faces():
    """{what it is: (a shape of one face, its Euler characteristic)}."""
    import Part
    import parts
    from FreeCAD import Vector

    plate = max((f for f in parts.support().Faces if len(f.Wires) > 1), key=lambda f: len(f.Wires))
    ball = Part.makeSphere(10.0)
    for direction in (Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)):
        ball = ball.cut(Part.makeCylinder(4.0, 30.0, direction * -15, direction))
    profile = Part.BSplineCurve()
    profile.interpolate([Vector(x, 0, z) for x, z in ((4, 0), (8, 4), (3, 9), (5, 14))])
    vase = profile.toShape().revolve(Vector(), Vector(0, 0, 1), 270)
    vase = vase.cut(Part.makeCylinder(1.5, 20.0, Vector(0, 0, 4), Vector(-1, 1, 0)))
    return {"wavy face": (parts.warped_face(1.0, 1.0).Faces[0], 1),
            "plate, 15 holes": (plate, -14),
            "ball, 6 holes": (max(ball.Faces, key=lambda f: f.Area), -4),
            "vase, 1 hole": (max(vase.Faces, key=lambda f: f.Area), 0)}


def size_of(face):
    box = face.BoundBox
    return max(box.XLength, box.YLength, box.ZLength)


def sampled(face, method):
    import MeshQuality as mq

    mesh = mq.triangulate(face, method=method, refine_samples=False, chord_height_relative=CHORD_HEIGHT)
    return mesh.vertices + mesh.origin, mesh.triangles


def first_triangulated(face, deflection):
    import MeshPart
    from MeshQuality.core.sources import convert

    return convert.arrays_of_mesh(MeshPart.meshFromShape(Shape=face, LinearDeflection=deflection, AngularDeflection=0.5))


def improved(mesh, tolerance):
    import MeshQuality as mq

    better = mq.improve((np.ascontiguousarray(mesh[0]), np.ascontiguousarray(mesh[1])), tolerance=tolerance)
    return better.vertices + better.origin, better.triangles


def triangulated_and_improved(face, wanted):
    """The first mesh and the improved one, which has about the wanted number of triangles."""
    tolerance = CHORD_HEIGHT * size_of(face)
    deflection, best = tolerance, None
    for _ in range(TRIES):
        start = time.process_time()
        first = first_triangulated(face, deflection)
        middle = time.process_time()
        better = improved(first, tolerance)
        seconds = (middle - start, time.process_time() - start)
        off = len(better[1]) / wanted
        if best is None or abs(np.log(off)) < abs(np.log(best[2])):
            best = first, better, off, seconds
        if abs(off - 1.0) < ALIKE:
            break
        deflection *= off**0.8
    return best[0], best[1], best[3]


class Judge:
    """Measures meshes of one face."""

    def __init__(self, face, euler):
        self.face, self.euler = face, euler
        lengths = [edge.Length for edge in face.Edges]
        self.border = np.array([point for edge, length in zip(face.Edges, lengths)
                                for point in edge.discretize(2 + int(BORDER_POINTS * length / sum(lengths)))])

    def curvature(self, point):
        """The larger principal one beneath a point, 1/mm, and how far the point is from the surface, mm."""
        import FreeCAD

        place = FreeCAD.Vector(*point)
        u, v = self.face.Surface.parameter(place)
        return max(map(abs, self.face.curvatureAt(u, v))), place.distanceToPoint(self.face.valueAt(u, v))

    def where_fronts_meet(self, centres, near):
        there = np.zeros(len(centres), dtype=bool)
        for k, centre in enumerate(centres):
            to = self.border - centre
            lengths = np.linalg.norm(to, axis=1)
            first = lengths.argmin()
            level = lengths < lengths[first] + near
            cosines = to[level] @ to[first] / (lengths[level] * lengths[first])
            there[k] = cosines.min() < 0.5
        return there

    def row(self, name, mesh, seconds):
        import render

        vertices, triangles = mesh
        corners = vertices[triangles]
        centres = corners.mean(axis=1)
        angles = render.smallest_angles(vertices, triangles)
        sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
        curvatures, distances = np.array([self.curvature(centre) for centre in centres]).T
        curved = curvatures >= np.quantile(curvatures, 0.9)
        edges, uses = np.unique(np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1),
                                axis=0, return_counts=True)
        areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
        found = {"way": name, "triangles": len(triangles), "seconds": seconds, "deviation": float(distances.max()),
                 "area": float(areas.sum() / self.face.Area), "tripled": int((uses > 2).sum()),
                 "holes": int(len(np.unique(triangles)) - len(edges) + len(triangles)) == self.euler}
        meet = self.where_fronts_meet(centres, sides.mean() / 2)
        for where, chosen in (("all", np.ones(len(angles), bool)), ("meet", meet),
                              ("curved", curved if np.ptp(curvatures) > 1e-6 else np.zeros(len(angles), bool))):
            chosen = angles[chosen]
            found[where] = [float(chosen.mean()), float((chosen < 30.0).mean())] if len(chosen) else None
        found["min_angle"] = float(angles.min())
        return found

    def fan(self, centre, count, factor):
        """The smallest angle of triangles between a place on the face and a polygon of the tangent plane, projected."""
        import FreeCAD
        import render

        place = FreeCAD.Vector(*centre)
        u, v = self.face.Surface.parameter(place)
        x, normal = (np.array(a) for a in (self.face.tangentAt(u, v)[0], self.face.normalAt(u, v)))
        y = np.cross(normal, x)
        height = 0.75 * CHORD_HEIGHT * size_of(self.face)
        radius = factor * 2.0 * np.sqrt(2.0 * height / max(map(abs, self.face.curvatureAt(u, v))) - height**2)
        turns = 2.0 * np.pi * np.arange(count) / count
        polygon = [np.array(place) + radius * (np.cos(t) * x + np.sin(t) * y) for t in turns]
        corners = [self.face.Surface.value(*self.face.Surface.parameter(FreeCAD.Vector(*p))) for p in polygon]
        triangles = [(0, 1 + k, 1 + (k + 1) % count) for k in range(count)]
        return float(render.smallest_angles(np.array([place, *corners]), np.array(triangles)).min())


def text(found):
    def pair(values):
        return f"{values[0]:5.1f} {100 * values[1]:5.1f}" if values else "    -     -"

    return f"{found['way']:<22} {found['triangles']:7,} {found['min_angle']:8.1f} {pair(found['all'])}  {pair(found['meet'])}  " \
           f"{pair(found['curved'])}  {'yes' if found['holes'] else 'NO':<5} {100 * found['area']:6.1f} {found['tripled']:7} {found['deviation']:9.4f} {found['seconds']:6.2f}"


def umbrellas_of(judge):
    """The mesh (V, F) of umbrellas from the place that is farthest from the border, as large as Star's triangles there."""
    import MeshQuality as mq
    import umbrellas

    star = mq.triangulate(judge.face, method="star", refine_samples=False, chord_height_relative=CHORD_HEIGHT)
    vertices, triangles = star.vertices + star.origin, star.triangles
    sums, counts = np.zeros(len(vertices)), np.zeros(len(vertices))
    for k in range(3):
        lengths = np.linalg.norm(vertices[triangles[:, k]] - vertices[triangles[:, (k + 1) % 3]], axis=1)
        for ends in (triangles[:, k], triangles[:, (k + 1) % 3]):
            np.add.at(sums, ends, lengths)
            np.add.at(counts, ends, 1.0)
    spacing = sums / np.maximum(counts, 1.0)
    centres = vertices[triangles].mean(axis=1)
    start = centres[np.argmax([np.linalg.norm(judge.border - centre, axis=1).min() for centre in centres])]
    return umbrellas.Umbrellas(judge.face, vertices[star.vertex_entity[:, 0] < 2], start,
                               lambda point: spacing[np.linalg.norm(vertices - point, axis=1).argmin()]).mesh()


def compare(judge):
    face, rows = judge.face, []
    sampled(face, "star")  # warms up
    for method in ("star", "sprinkle"):
        start = time.process_time()
        mesh = sampled(face, method)
        rows.append(judge.row(method, mesh, time.process_time() - start))
    start = time.process_time()
    mesh = umbrellas_of(judge)
    rows.append(judge.row("umbrellas, in Python", mesh, time.process_time() - start))
    first, better, seconds = triangulated_and_improved(face, rows[0]["triangles"])
    rows.append(judge.row("triangulated", first, seconds[0]))
    rows.append(judge.row("triangulated, improved", better, seconds[1]))
    return rows


def fans(judge):
    """{corners: smallest angle} at the place of highest curvature among the centres of a mesh, not near the border."""
    face = judge.face
    vertices, triangles = sampled(face, "star")
    centres = vertices[triangles].mean(axis=1)
    inside = np.array([np.linalg.norm(judge.border - centre, axis=1).min() for centre in centres]) > 0.1 * size_of(face)
    centres = centres[inside]
    sharpest = centres[np.argmax([judge.curvature(centre)[0] for centre in centres])]
    return {count: judge.fan(sharpest, count, factor) for count, factor in FANS}


def work(arguments):
    import Part

    sys.path.append(str(inside_freecad.ROOT / "tools"))
    found = {}
    for name, (face, euler) in faces().items():
        judge = Judge(face, euler)
        print(f"\n{name:<22} {'':7} {'':8} {'all':>11}  {'fronts meet':>11}  {'curved':>11}  {'holes':<5} {'area':>6} {'':>7} {'deviation':>9}")
        print(f"{'':<22} {'number':>7} {'smallest':>8} {' mean  <30 %':>11}  {' mean  <30 %':>11}  {' mean  <30 %':>11}  "
              f"{'kept':<5} {'%':>6} {'tripled':>7} {'mm':>9} {'CPU s':>6}")
        found[name] = {"rows": compare(judge)}
        for row in found[name]["rows"]:
            print(text(row), flush=True)
        if not isinstance(face.Surface, Part.Plane):
            angles = found[name]["fans"] = fans(judge)
            print("fans at the highest curvature: " + ", ".join(f"{count} corners {angle:.1f} degrees"
                                                                 for count, angle in angles.items()))
    return {"faces": found}


inside_freecad.start(__file__, parser(), work)
