# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the extension module computes without FreeCAD, as hashes: tools/windows compares those of two systems.

    python meshes.py FOLDER_OF_MESHQUALITY FOLDER_OF_THE_BINARY FOLDER_OF_PARTS
"""

import glob
import hashlib
import os
import shutil
import sys
import types


class Shape:
    """Stands for FreeCAD's Part.Shape: a shape that is stored as Part.Shape.exportBinary writes it."""

    def __init__(self, source):
        self.path = source.path if isinstance(source, Shape) else source

    def isNull(self):
        return False

    def isEqual(self, other):
        return self.path == other.path

    def exportBinary(self, path):
        shutil.copyfile(self.path, path)


def digest(*arrays):
    return hashlib.sha256(b"".join(array.tobytes() for array in arrays)).hexdigest()[:16]


def main():
    sys.path[:0] = [sys.argv[1]]
    os.environ["MESHQUALITY_BRIDGE"] = "stream"
    part = types.ModuleType("Part")
    part.Shape, part.OCCError = Shape, OSError
    with open(os.path.join(sys.argv[3], "version"), encoding="utf-8") as stream:
        part.OCC_VERSION = stream.read()  # the module for FreeCAD here is refused by another one
    sys.modules["Part"] = part
    import MeshQuality

    MeshQuality.__path__.append(sys.argv[2])
    from MeshQuality import _core

    paths, surfaces = sorted(glob.glob(os.path.join(sys.argv[3], "*.bin"))), []
    for path in paths:
        surfaces.append(_core.triangulate(Shape(path), _core.TriangulateOptions()))
        print(os.path.basename(path), len(surfaces[-1].triangles), digest(surfaces[-1].vertices, surfaces[-1].triangles))
    options = _core.BooleanOptions()
    for operation in ("union", "intersection", "difference"):
        operands = _core.Operands()
        for number, surface in enumerate(surfaces[:2]):
            operands.add(str(number), surface, True, None)
        found = _core.boolean(operands, operation, options, "exact")
        print(operation, len(found.triangles), digest(found.vertices, found.triangles))
    curved_options = _core.CurveOptions()
    curved_options.order = 3
    curved = _core.curve_surface(surfaces[1], Shape(paths[1]), curved_options)
    print("curved", len(curved.nodes), digest(curved.nodes))
    better = _core.improve(surfaces[0], _core.ImproveOptions())
    print("improved", len(better.triangles), digest(better.vertices, better.triangles))


main()
