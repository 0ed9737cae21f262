# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cases of the Boolean benchmark, and its meshes: binary PLY files packed with gzip."""

import gzip

# Name: operation, operands, volume (None: not known) and how near it must be, CPU seconds and
# triangles to stay within (None: no aim). The volumes of the large pairs are those on which exact
# engines agree.
UNION, DIFFERENCE, INTERSECTION = "union", "difference", "intersection"
TORI, NEFERTITI = 2.466348418, 0.04054367915
CASES = {
    "dragon-bunny": (DIFFERENCE, "dragon277k", "bunny70k", 0.01955343628, 1e-5, 0.5, None),
    "dragon+bunny": (UNION, "dragon277k", "bunny70k", 0.04421231268, 1e-5, None, None),
    "dragon*bunny": (INTERSECTION, "dragon277k", "bunny70k", 0.006006349488, 1e-5, None, None),
    "dragon+nefertiti": (UNION, "dragon277k", "nefertiti400k", 0.0621404976, 1e-5, 1.0, None),
    "armadillo+nefertiti": (UNION, "armadillo871k", "nefertiti400k", None, 1e-5, 2.5, None),
    "fandisk-rocker": (DIFFERENCE, "fandisk", "rocker", None, 1e-5, None, None),
    "sphere-box": (DIFFERENCE, "sphere102k", "box", None, 1e-5, None, None),
    "sphere+sphere": (UNION, "sphere400k", "sphere400k_b", None, 1e-5, 0.8, None),
    "T1 cubes share a face": (UNION, "cubeA", "cubeFace", 2.0, 1e-3, None, None),
    "T2 the same, turned": (UNION, "cubeA_r", "cubeFace_r", 2.0, 1e-3, None, None),
    "T3 coplanar faces overlap": (UNION, "cubeA", "cubeCoplanar", 1.5, 1e-3, None, None),
    "T4 the same, turned": (UNION, "cubeA_r", "cubeCoplanar_r", 1.5, 1e-3, None, None),
    "T5 boss on a face, turned": (UNION, "cubeA_r", "cubeFacePart_r", 1.25, 1e-3, None, None),
    "T6 flush hole": (DIFFERENCE, "cubeA", "cubeThrough", 0.75, 1e-3, None, None),
    "T7 the same, turned": (DIFFERENCE, "cubeA_r", "cubeThrough_r", 0.75, 1e-3, None, None),
    "T8 cubes share an edge": (UNION, "cubeA", "cubeEdge", 2.0, 1e-3, None, None),
    "T9 cubes share a vertex": (UNION, "cubeA", "cubeVertex", 2.0, 1e-3, None, None),
    "T10 tori touch": (UNION, "torusA", "torusTouch", TORI, 1e-3, None, None),
    "T11 tori stacked": (UNION, "torusA", "torusStack", TORI, 1e-3, None, None),
    "T12 tori linked": (UNION, "torusA", "torusLink", None, 1e-5, None, None),
    "T13 torus turned by 0.35": (UNION, "torusA", "torusRot", TORI / 2, 1e-4, 0.5, 300_000),
    "T14 A - A": (DIFFERENCE, "nefertiti100k", "nefertiti100k", 0.0, 0.0, 0.5, 0),
    "T15 A + A": (UNION, "nefertiti100k", "nefertiti100k", NEFERTITI, 1e-9, 0.5, None),
    "T16 A * A": (INTERSECTION, "nefertiti100k", "nefertiti100k", NEFERTITI, 1e-9, 0.5, None),
    "D1 20 holes": (DIFFERENCE, "dragon277k_holes", "bunny70k", 0.01955, 1e-3, 1.0, None),
    "D2 5 large holes": (DIFFERENCE, "dragon277k", "bunny70k_holes", 0.01955, 1e-3, 1.0, None),
    "D3 intersects itself": (DIFFERENCE, "selfint173k", "bunny70k", 0.03512, 1e-3, 1.0, None),
    "D4 holes, self-crossings": (UNION, "ogre124k", "bunny70k", None, 1e-3, 1.0, None),
}


def read(path):
    """(V, F) of a binary little-endian PLY file packed with gzip."""
    import numpy as np  # FreeCAD's Python has it, the one that starts a benchmark need not

    with gzip.open(path) as stream:
        data = stream.read()
    start = data.index(b"end_header\n") + len(b"end_header\n")
    lines = data[:start].decode("ascii").splitlines()
    counts = {line.split()[1]: int(line.split()[2])
              for line in lines if line.startswith("element")}
    vertices = np.frombuffer(data, "<f4", 3 * counts["vertex"], start).reshape(-1, 3)
    faces = np.frombuffer(data, np.dtype([("corners", "u1"), ("vertex", "<i4", 3)]),
                          counts["face"], start + vertices.nbytes)
    return vertices.astype(np.float64), np.ascontiguousarray(faces["vertex"])
