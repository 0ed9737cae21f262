# SPDX-License-Identifier: LGPL-2.1-or-later
"""Deviations of scans whose truth is known, of parts from files and of parts made at random.

    freecadcmd -P <root>/Mod benchmarks/surfaces/deviation_scans.py </dev/null
MESHQUALITY_SEED is that of all random numbers, MESHQUALITY_POINTS the number of points of a scan, 1,000,000 by default,
MESHQUALITY_CHECKED that of the points which OpenCASCADE measures, too.

Points of the surfaces, by OpenCASCADE, are moved along its normals by a known offset and a normal deviate, the noise, and then away by a
random motion. Printed are, in parts of the noise: by how much the mean deviation misses the offset, of points that are not near edges; by how
much the points miss their places after alignment (root mean square), beside the least that the noise allows, by Cramér and Rao from the
normals; processor seconds of both. Then, of points near the surface and around the part, the largest difference of the distances from those
of OpenCASCADE, and how many signs differ from its classifier.
"""

import os
import sys
import time
from pathlib import Path

import FreeCAD
import numpy as np
import Part

import MeshQuality as mq

sys.path.append(str(Path(__file__).resolve().parents[1] / "harness"))
from inside_freecad import data_folder  # noqa: E402

SEED, COUNT = int(os.environ.get("MESHQUALITY_SEED", "1")), int(os.environ.get("MESHQUALITY_POINTS", "1000000"))
FILES = ("component8.step", "linkrods.step")
NOISE, OFFSET = 2e-4, 1e-3  # of the diagonal
CHECKED = int(os.environ.get("MESHQUALITY_CHECKED", "2000"))  # points that OpenCASCADE measures, too
EACH = 20  # points of a scan at the same place, each with its own noise: OpenCASCADE finds places slowly
ON_BORDER = 1e-6  # mm: nearer points have no sign


def parts(random):
    """(name, solid): three made of random boxes, cylinders and spheres, and those of files that are there."""
    for number in range(3):
        made = Part.makeBox(*random.uniform(20, 60, 3).tolist())
        while made.BoundBox.DiagonalLength and len(made.Faces) < 16:
            place, size = FreeCAD.Vector(*(random.uniform(0, 40, 3).tolist())), float(random.uniform(3, 12))
            axis = FreeCAD.Vector(*random.normal(size=3).tolist())
            tool = Part.makeSphere(size, place) if random.random() < 0.4 else Part.makeCylinder(0.6 * size, 4 * size, place, axis)
            tried = made.cut(tool) if random.random() < 0.5 else made.fuse(tool)
            if tried.isValid() and len(tried.Solids) == 1:
                made = tried.Solids[0]
        yield f"random {number + 1}", made
    for path in (data_folder() / "cad" / name for name in FILES):
        if path.exists():
            yield path.stem, Part.read(str(path)).Solids[0]


def on_surface(shape, count, random):
    """(points, normals) of a solid, spread evenly, by OpenCASCADE's surfaces."""
    points, normals, area = [], [], shape.Area
    for face in shape.Faces:
        corners, triangles = face.tessellate(2e-3 * shape.BoundBox.DiagonalLength)
        corners = np.array([tuple(corner) for corner in corners])[np.array(triangles)]
        areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
        some = round(count * face.Area / area)
        weights = random.dirichlet((1.0, 1.0, 1.0), some)
        rough = np.einsum("ni,nij->nj", weights, corners[random.choice(len(areas), some, p=areas / areas.sum())])
        surface, sign = face.Surface, -1.0 if face.Orientation == "Reversed" else 1.0
        for place in map(FreeCAD.Vector, rough.tolist()):
            u, v = surface.parameter(place)
            points.append(tuple(surface.value(u, v)))
            normals.append(tuple(surface.normal(u, v) * sign))
    return np.array(points), np.array(normals)


def away_from_edges(shape, points, distance):
    """bool (N,): where the faces around decide nothing, however a point is moved by that distance."""
    edges = [edge for edge in shape.Edges if not edge.Degenerated]
    ends = np.array([tuple(edge.valueAt(along)) for edge in edges
                     for along in np.linspace(edge.FirstParameter, edge.LastParameter, max(2, int(edge.Length / distance) + 1)).tolist()])
    return np.array([((ends - point)**2).sum(axis=1).min() > (2.0 * distance)**2 for point in points])


def least_error(points, normals):
    """Root mean square of how far points are misplaced by the best possible fit of a rigid motion, in parts of the noise."""
    about = points - points.mean(axis=0)
    size = np.linalg.norm(about, axis=1).mean()
    moved = np.concatenate([normals, np.cross(about / size, normals)], axis=1)
    values, vectors = np.linalg.eigh(moved.T @ moved)
    known = values > 1e-9 * values.max()  # turns about an axis of symmetry are free
    covariance = (vectors[:, known] / values[known]) @ vectors[:, known].T
    turned = np.trace(covariance[3:, 3:]) * (about**2).sum(axis=1).mean() - np.trace(covariance[3:, 3:] @ (about.T @ about)) / len(about)
    return float(np.sqrt(np.trace(covariance[:3, :3]) + turned / size**2))


def against_opencascade(shape, random):
    """(largest difference of distances in mm, number of signs that differ) of points near the surface and around the part."""
    points, normals = on_surface(shape, CHECKED // 2, random)
    size, box = shape.BoundBox.DiagonalLength, shape.BoundBox
    near = points + normals * random.normal(0.0, 0.01 * size, (len(points), 1))
    around = random.uniform((box.XMin, box.YMin, box.ZMin), (box.XMax, box.YMax, box.ZMax), (CHECKED - len(near), 3))
    points, faces = np.concatenate([near, around]), Part.makeCompound(shape.Faces)
    found = mq.deviation(points, shape).values
    distances = np.array([Part.Vertex(*point).distToShape(faces)[0] for point in points.tolist()])
    inside = np.array([shape.isInside(FreeCAD.Vector(*point), 1e-9, True) for point in points.tolist()])
    wrong = ((found < 0.0) != inside) & (distances > ON_BORDER)
    return float(np.abs(np.abs(found) - distances).max()), int(wrong.sum())


def main():
    random = np.random.default_rng(SEED)
    print(f"{'part':<20} {'faces':>5} {'points':>9} {'offset off':>10} {'CPU s':>6} {'misplaced':>9} {'least':>8} {'CPU s':>6} "
          f"{'distance off, mm':>16} {'signs':>6}")
    for name, shape in parts(random):
        points, normals = on_surface(shape, COUNT // EACH, random)
        noise, offset = (part * shape.BoundBox.DiagonalLength for part in (NOISE, OFFSET))
        alone = np.repeat(away_from_edges(shape, points, 5.0 * (noise + offset)), EACH)
        points, normals = (np.repeat(each, EACH, axis=0) for each in (points, normals))
        deviates = random.normal(0.0, noise, (len(points), 1))
        begun = time.process_time()
        found = mq.deviation(points + normals * (offset + deviates), shape)
        measured = time.process_time() - begun
        missed = abs(found.values[alone].mean() - offset) / noise
        scan = points + normals * deviates
        rotation = FreeCAD.Rotation(FreeCAD.Vector(*random.normal(size=3).tolist()), float(random.uniform(0, 180)))
        away = FreeCAD.Placement(FreeCAD.Vector(*(random.uniform(-1, 1, 3) * 1e3 * noise).tolist()), rotation).toMatrix()
        matrix = np.array(away.A).reshape(4, 4)
        begun = time.process_time()
        aligned = mq.deviation(scan @ matrix[:3, :3].T + matrix[:3, 3], shape, align=True)
        used = time.process_time() - begun
        misplaced = np.sqrt(((aligned.points - scan)**2).sum(axis=1).mean()) / noise
        distance, signs = against_opencascade(shape, random)
        print(f"{name:<20} {len(shape.Faces):>5} {len(points):>9,} {missed:>10.2e} {measured:>6.2f} {misplaced:>9.2e} "
              f"{least_error(points, normals):>8.2e} {used:>6.2f} {distance:>16.1e} {signs:>6}", flush=True)


main()
