#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hollows with plane openings, and offsets, that took tens of seconds: time, triangles, volume beside a known one.

    freecadcmd -P Mod benchmarks/surfaces/hollow_cliffs.py </dev/null
    MESHQUALITY_DATA=DIR freecadcmd -P Mod benchmarks/surfaces/hollow_cliffs.py </dev/null    public parts of DIR/cad, too

CPU seconds of all threads. The known volume is that of OpenCASCADE's solids, cut; of the rounded box it is integrated. Of a
public part the largest plane faces are open, one and two of them, with a wall of a twentieth of its smallest side.
"""

import math
import os
import resource
import time
from pathlib import Path

import numpy as np
import Part
from FreeCAD import Vector

import MeshQuality as mq

# Files of the folder cad; nobody has tuned anything for them.
SUFFIXES = (".step", ".stp", ".brep")
MOST_PARTS, MOST_FACES, MOST_SECONDS = 10, 60, 20


def names_of(shape, test):
    return [f"Face{i + 1}" for i, face in enumerate(shape.Faces) if isinstance(face.Surface, Part.Plane) and test(face)]


def rounded_box():
    """40 x 30 x 20, all edges round by 3, open at the top; a wall of 1."""
    box = Part.makeBox(40, 30, 20)
    shape = box.makeFillet(3, box.Edges)
    inner = Part.makeBox(38, 28, 18, Vector(1, 1, 1))
    inner = inner.makeFillet(2, inner.Edges)
    # Above the inner box the hollow ends at a distance of 1 from the rim of the opening.
    depth = (np.arange(20000) + 0.5) / 20000
    away = np.sqrt(1.0 - depth**2)
    above = np.mean((34 - 2 * away) * (24 - 2 * away))
    return shape, names_of(shape, lambda face: face.CenterOfMass.z > 19.9), shape.Volume - inner.Volume - above


def round_as_the_wall(every, ratio):
    """40 x 30 x 20, open at the top, its edges round by the wall of 2 times a ratio: all of them, or those upright."""
    box = Part.makeBox(40, 30, 20)
    edges = [edge for edge in box.Edges if every or abs(edge.tangentAt(0).z) > 0.9]
    shape = box.makeFillet(2.0 * ratio, edges)
    return shape, names_of(shape, lambda face: face.CenterOfMass.z > 19.9)


def tube():
    shape = Part.makeBox(40, 30, 20)
    hollow = shape.cut(Part.makeBox(38, 28, 20, Vector(1, 1, 0)))
    return shape, names_of(shape, lambda face: abs(face.CenterOfMass.z - 10) > 9.9), hollow.Volume


def drilled(length, width, bores):
    """A plate 10 thick with bores of radius 4, open at the top; a wall of 1."""
    shape, hollow = Part.makeBox(length, width, 10), Part.makeBox(length - 2, width - 2, 9, Vector(1, 1, 1))
    for x, y in bores:
        shape = shape.cut(Part.makeCylinder(4, 10, Vector(x, y, 0)))
        hollow = hollow.cut(Part.makeCylinder(5, 10, Vector(x, y, 0)))
    return shape, names_of(shape, lambda face: face.CenterOfMass.z > 9.9), shape.cut(hollow).Volume


def smallest_angle(result):
    """Degrees."""
    points = np.asarray(result.vertices)[np.asarray(result.triangles)]
    least = 180.0
    for k in range(3):
        one, two = points[:, (k + 1) % 3] - points[:, k], points[:, (k + 2) % 3] - points[:, k]
        angles = np.degrees(np.arctan2(np.linalg.norm(np.cross(one, two), axis=1), (one * two).sum(axis=1)))
        least = min(least, angles.min())
    return least


def measured(name, make, volume=None):
    began = time.process_time()
    try:
        result = make()
    except mq.Error as error:
        print(f"{name:<44} {time.process_time() - began:8.2f} s  {str(error)[:90]}", flush=True)
        return
    seconds = time.process_time() - began
    known = "" if volume is None else f"{100 * (result.report.volume / volume - 1):+7.3f} % of volume"
    contour = "contour" if "dividing cells" in result.report.seconds else ""
    print(f"{name:<44} {seconds:8.2f} s {len(result.triangles):8d} triangles, {smallest_angle(result):.4f} degrees, bound "
          f"{result.report.error_bound / result.report.tolerance_asked:.2f} {known} {contour}", flush=True)


def in_a_child(name, make):
    """Measured in a process of its own, which ends when it takes too long."""
    child = os.fork()
    if child == 0:
        resource.setrlimit(resource.RLIMIT_CPU, (MOST_SECONDS + int(time.process_time()), -1))
        measured(name, make)
        os._exit(0)
    if os.waitpid(child, 0)[1] != 0:
        print(f"{name:<44} more than {MOST_SECONDS} s, or ended by a signal", flush=True)


def known_shapes():
    cases = {"rounded box, one face open": rounded_box(), "box, two faces open": tube(),
             "plate with 6 bores, one opening": drilled(60, 40, [(12 + 18 * i, 10 + 20 * j) for i in range(3) for j in range(2)]),
             "box with a bore, one opening": drilled(30, 20, [(15, 10)])}
    for name, (shape, openings, volume) in cases.items():
        measured(name, lambda shape=shape, openings=openings: mq.hollow(shape, 1.0, openings), volume)
    for every in (False, True):
        for ratio in (0.95, 1.0, 1.05):
            shape, openings = round_as_the_wall(every, ratio)
            name = f"{'all' if every else 'upright'} edges round by {ratio} of the wall"
            measured(name, lambda shape=shape, openings=openings: mq.hollow(shape, 2.0, openings))
    for distance in (10, 50):
        exact = 1 + 6 * distance + 3 * math.pi * distance**2 + 4 / 3 * math.pi * distance**3
        measured(f"box of 1 mm by {distance} mm", lambda distance=distance: mq.offset(Part.makeBox(1, 1, 1), distance), exact)


def public_parts(folder):
    done = 0
    for path in sorted(folder.iterdir()):
        if done == MOST_PARTS:
            return
        if path.suffix.lower() not in SUFFIXES:
            continue
        shape = Part.read(str(path))
        planes = [(face.Area, f"Face{i + 1}") for i, face in enumerate(shape.Faces) if isinstance(face.Surface, Part.Plane)]
        if len(shape.Solids) != 1 or len(planes) < 2 or len(shape.Faces) > MOST_FACES:
            continue
        box = shape.BoundBox
        wall = 0.05 * min(box.XLength, box.YLength, box.ZLength)
        largest = [name for _, name in sorted(planes)[::-1]]
        for count in (1, 2):
            in_a_child(f"{path.name[:34]}, {count} open", lambda count=count: mq.hollow(shape, wall, largest[:count]))
        done += 1


if "MESHQUALITY_DATA" in os.environ:  # first: a process that has run threads is not to be forked
    public_parts(Path(os.environ["MESHQUALITY_DATA"]) / "cad")
known_shapes()
