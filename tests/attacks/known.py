# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an earlier round of attacks found slow or wrong in single calls; tests/freecad/test_attacks.py and
test_attacks_batch.py have the rest of it.
"""

import gzip
import os

import FreeCAD
import numpy as np
import Part
from attack import Attack, check, survive, with_patience

import MeshQuality as mq

V = FreeCAD.Vector
_DATA = os.environ.get("MESHQUALITY_DATA", "")
_EDGES_OF_CIRCLE, _LIMIT = 10**4, 10**5


def _pipe():
    return Part.makeCylinder(0.01, 1).cut(Part.makeCylinder(0.009, 1))


def _squeezed():
    cut = Part.makeCylinder(5, 10).cut(Part.makeSphere(6, V(0, 0, 10)))
    matrix = FreeCAD.Matrix()
    matrix.scale(100, 0.01, -1)
    return cut.transformGeometry(matrix)


def _wild():
    """A face of 14 by 14 poles whose heights differ by more than its width."""
    dice = np.random.default_rng(3)
    surface = Part.BSplineSurface()
    surface.interpolate([[V(i, j, dice.uniform(-40, 40)) for j in range(14)] for i in range(14)])
    return surface.toShape()


def _of_ply(path):
    """(vertices, triangles) of a packed binary PLY file of single-precision coordinates."""
    with gzip.open(path, "rb") as stream:
        head, _, data = stream.read().partition(b"end_header\n")
    vertices, triangles = (int(line.split()[2]) for line in head.splitlines() if line.startswith(b"element"))
    found = np.frombuffer(data, "<f4", 3 * vertices).reshape(-1, 3)
    rows = np.frombuffer(data, [("count", "u1"), ("corners", "<i4", 3)], triangles, found.nbytes)
    return found, rows["corners"]


def _boxes(count):
    return Part.makeCompound([Part.makeBox(1, 1, 1, V(2 * i, 0, 0)) for i in range(count)])


def _thin(*size):
    """Volume that single precision cannot hold is told of."""
    def attack():
        part = Part.makeBox(*size)
        report = survive(lambda: mq.triangulate(part, max_triangles=2000)).report
        lost = abs(report.volume - part.Volume) > 0.1 * part.Volume
        check(not lost or "volume" in " ".join(report.notes), "volume is lost without a word")

    return attack


def _turned_pair(seed, operation):
    """Two boxes with a bore, one turned at random: no edge of more than two triangles without a word."""
    def attack():
        dice = np.random.default_rng(seed)
        bored = Part.makeBox(10, 10, 10).cut(Part.makeCylinder(3, 10, V(5, 5, 0)))
        other = bored.copy()
        other.rotate(V(5, 5, 5), V(*dice.normal(size=3)), dice.uniform(0, 360))
        meshes = [mq.triangulate(shape, chord_height=0.1) for shape in (bored, other)]
        result = with_patience(lambda progress: mq.boolean(*meshes, operation, progress=progress))
        check(result is None or result.report.manifold or result.report.faults_left,
              "faults_left is 0 without a manifold")

    return attack


def _quickly(function):
    return lambda: with_patience(function)


CALLS = {
    "a sphere of 10^4 edges a circle, 10^5 triangles":
        lambda p: mq.triangulate(Part.makeSphere(1), edges_per_circle=_EDGES_OF_CIRCLE, max_triangles=_LIMIT,
                                 progress=p),
    "an edge of 3e-5 beside long ones":
        lambda p: mq.triangulate(Part.makeBox(1, 1, 1), local_sizes={"Edge1": 3e-5}, max_triangles=30000, progress=p),
    "an edge of 1e-4 beside long ones":
        lambda p: mq.triangulate(Part.makeBox(1, 1, 1), local_sizes={"Edge1": 1e-4}, max_triangles=10**4, progress=p),
    "edges of 1e-4": lambda p: mq.triangulate(Part.makeBox(1, 1, 1), max_edge=1e-4, max_triangles=_LIMIT, progress=p),
    "edges of 1e-5": lambda p: mq.triangulate(Part.makeBox(1, 1, 1), max_edge=1e-5, max_triangles=_LIMIT, progress=p),
    "edges of 1e-300": lambda p: mq.triangulate(Part.makeBox(1, 1, 1), max_edge=1e-300, progress=p),
    "a pipe of 0.01 mm, order 4, filled": lambda p: mq.curve(_pipe(), order=4, volume=True, progress=p),
    "a cut squeezed by 0.01": lambda p: mq.triangulate(_squeezed(), progress=p),
    "3,000 boxes": lambda p: mq.triangulate(_boxes(3000), progress=p),
    "a wild face at a chord of 0.5": lambda p: mq.triangulate(_wild(), chord_height=0.5, progress=p),
    "uniform at 4096, two cubes": lambda p: mq.boolean(Part.makeBox(1, 1, 1), Part.makeBox(1, 1, 1, V(0.5, 0.5, 0.5)),
                                                       "union", method="uniform", resolution=4096, progress=p),
    "uniform at 4096": lambda p: mq.boolean(Part.makeBox(1, 1, 1), Part.makeSphere(1), "union", method="uniform",
                                            resolution=4096, progress=p),
    "a tessellation of 1e-300": lambda p: mq.curve(Part.makeSphere(1)).tessellate(1e-300, p),
}
# Parts from files: the call, the file.
OF_FILES = {
    "a nut at 33 degrees": ("mal_ecrou.brep", lambda s,
                            p: mq.triangulate(s, min_angle=33.0, chord_height_relative=0.003, progress=p)),
    "terrain": ("terrain.brep", lambda s, p: mq.triangulate(s, chord_height_relative=1e-4, progress=p)),
    "quality of a wing": ("wing_fuselage.step", lambda s,
                          p: mq.quality(mq.triangulate(s, chord_height_relative=0.01), s, p)),
    "a block that is open": ("cube_filet.stp", lambda s, p: mq.boolean([s], operation="union", progress=p)),
}
# Two meshes of one part, of 12,000 and 20,000 triangles, that lie in each other's surface nearly everywhere.
TWINS = [os.path.join(_DATA, "boolean", f"twin_{which}.ply.gz") for which in "ab"]


def _twins(operation):
    return with_patience(lambda p: mq.boolean(*map(_of_ply, TWINS), operation, progress=p))


def rows():
    found = [Attack(name, _quickly(call)) for name, call in CALLS.items()]
    found += [Attack(f"a box of {size}", _thin(*size)) for size in ((1000, 1000, 1e-6), (1e4, 1e-3, 1e-3))]
    found += [Attack(f"turned pair {seed}, {operation}", _turned_pair(seed, operation))
              for seed in (45, 55, 74, 87) for operation in ("union", "difference")]
    if _DATA and all(map(os.path.exists, TWINS)):
        found += [Attack(f"twins, {operation}", lambda o=operation: _twins(o)) for operation in ("union", "difference")]
    for name, (file, call) in OF_FILES.items():
        path = os.path.join(_DATA, "cad", file)
        if _DATA and os.path.exists(path):
            found.append(Attack(name, lambda path=path, call=call: with_patience(lambda p: call(Part.read(path), p))))
    return found
