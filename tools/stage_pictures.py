# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws the meshes of a folder: a PNG beside each PLY file.   tools/stage_pictures.py FOLDER"""

import sys
from pathlib import Path

import numpy as np
import render
from matplotlib.image import imsave

_FACE = np.dtype([("count", "u1"), ("corners", "<i4", 3)])


def read_ply(path):
    """(vertices, triangles) of a PLY file as MeshQuality writes it."""
    header, _, data = path.read_bytes().partition(b"end_header\n")
    counts = {words[1]: int(words[2]) for words in map(bytes.split, header.splitlines()) if words[0] == b"element"}
    real = "<f8" if b"property double x" in header else "<f4"
    vertices = np.frombuffer(data, real, 3 * counts[b"vertex"]).reshape(-1, 3)
    triangles = np.frombuffer(data, _FACE, counts[b"face"], vertices.nbytes)["corners"]
    return vertices, triangles


def draw(path):
    """Draws a PLY file; a line of its figures."""
    vertices, triangles = read_ply(path)
    image = render.render(vertices, triangles, np.zeros(len(triangles), dtype=int))
    imsave(path.with_suffix(".png"), np.clip(image, 0.0, 1.0))
    worst = render.smallest_angles(vertices, triangles).min()
    return f"{path.with_suffix('.png').name}: {len(triangles)} triangles, smallest angle {worst:.2f} degrees"


if __name__ == "__main__":
    for mesh in sorted(Path(sys.argv[1]).glob("*.ply")):
        print(draw(mesh))
