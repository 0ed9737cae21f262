# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folder constant/polyMesh of OpenFOAM, as text or binary."""

import os
import re

import numpy as np

from ... import flow_phrases, phrases
from ...errors import InvalidInput, IoError
from ...phrases import Text
from ..elements.neighbours import pairs_of, rings_of
from ..meshes import openfoam_case, writing

_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_.+\-]*")


def write_case(mesh, folder, scale, types, binary):
    """Writes a VolumeMesh as a case of OpenFOAM: constant/polyMesh, and the dictionaries in system without which its programs do
    not start. See VolumeMesh.write.
    """
    if mesh.order > 1:
        raise InvalidInput(Text(flow_phrases.FOAM_ORDER, count=str(mesh.order)))
    names = mesh.patch_names
    wrong = next((name for name in names if not _NAME.fullmatch(name)), None)
    if wrong is not None:
        raise InvalidInput(Text(phrases.FOAM_PATCH, name=repr(wrong)))
    faces, owner, neighbour, patch = faces_of(mesh)
    kind, points, listed = ("faceCompactList", _binary_points, _binary_list) if binary else ("faceList", _points, _list)
    boundary = _boundary(names, types, patch, len(neighbour)).encode()
    files = {"points": ("vectorField", points(mesh.nodes * scale)), "faces": (kind, _binary_faces(faces) if binary else _faces(faces)),
             "owner": ("labelList", listed(owner)), "neighbour": ("labelList", listed(neighbour)), "boundary": ("polyBoundaryMesh", boundary)}
    places = {os.path.join("constant", "polyMesh", name): _header(kind, name, binary and name != "boundary") + content
              for name, (kind, content) in files.items()}
    places.update({os.path.join(*path.split("/")): text.encode() for path, text in openfoam_case.solver_texts(openfoam_case.SKEW_SCHEMES).items()})
    for path, content in places.items():
        path = os.path.join(folder, path)
        try:
            os.makedirs(os.path.dirname(path), exist_ok=True)
        except OSError as error:
            raise IoError(f"{os.path.dirname(path)} cannot be made: {error.strerror}") from error
        writing.atomically(path, "", lambda ready, content=content: _save(ready, content))


def _save(path, content):
    with open(path, "wb") as stream:
        stream.write(content)


def faces_of(mesh):
    """(rings int (F, 4), -1 after the third corner of triangles; owner (F,); neighbour (inner faces,); patch (F - inner,)):
    faces in upper-triangular order, inner ones first, then patch by patch; normals lead out of the owner.
    """
    rings, owner = rings_of(mesh.solid_blocks)
    pairs = np.concatenate([np.column_stack(sides) for sides in pairs_of(mesh.solid_blocks)])
    first, second = np.take_along_axis(pairs, np.argsort(owner[pairs], axis=1, kind="stable"), axis=1).T  # the owner is the one with the lower number
    upper = np.lexsort((owner[second], owner[first]))
    first, second = first[upper], second[upper]
    outer = np.ones(len(rings), dtype=bool)
    outer[first] = outer[second] = False
    outer = np.flatnonzero(outer)
    patch = mesh.patch_of_faces(rings[outer])
    by_patch = np.lexsort((owner[outer], patch))
    outer, patch = outer[by_patch], patch[by_patch]
    return np.concatenate([rings[first], rings[outer]]), np.concatenate([owner[first], owner[outer]]), owner[second], patch


def _header(kind, name, binary):
    form = "    format binary;\n    arch \"LSB;label=32;scalar=64\";\n" if binary else "    format ascii;\n"
    return (f"FoamFile\n{{\n    version 2.0;\n{form}    class {kind};\n    location \"constant/polyMesh\";\n"
            f"    object {name};\n}}\n").encode()


def _lines(lines):
    return f"{len(lines)}\n(\n{''.join(lines)})\n".encode()


def _points(points):
    return _lines(["(%r %r %r)\n" % tuple(row) for row in points.tolist()])


def _list(numbers):
    return _lines(["%d\n" % number for number in numbers.tolist()])


def _faces(rings):
    return _lines([f"3({a} {b} {c})\n" if d < 0 else f"4({a} {b} {c} {d})\n" for a, b, c, d in rings.tolist()])


def _binary(array, count):
    return b"%d\n(%s)\n" % (count, array.tobytes())


def _binary_points(points):
    return _binary(points.astype("<f8"), len(points))


def _binary_list(numbers):
    return _binary(numbers.astype("<i4"), len(numbers))


def _binary_faces(rings):
    """Where the corners of each face begin, and the corners."""
    corners = rings >= 0
    return _binary_list(np.concatenate([[0], np.cumsum(corners.sum(axis=1))])) + _binary_list(rings[corners])


def _boundary(names, types, patch, inner):
    counts = np.bincount(patch, minlength=len(names))
    starts = inner + np.concatenate([[0], np.cumsum(counts)[:-1]])
    lines = [f"    {name}\n    {{\n        type {types[name]};\n        nFaces {count};\n        startFace {start};\n    }}\n"
             for name, count, start in zip(names, counts.tolist(), starts.tolist())]
    return f"{len(names)}\n(\n" + "".join(lines) + ")\n"
