# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folder constant/polyMesh of OpenFOAM, as text."""

import os
import re

import numpy as np

from ... import phrases
from ...errors import InvalidInput, IoError
from ...phrases import Text
from ..elements.neighbours import rings_of
from ..meshes import openfoam_case, writing

_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_.+\-]*")


def write_case(mesh, folder, scale, types):
    """Writes a VolumeMesh as a case of OpenFOAM: constant/polyMesh, and the dictionaries in system without which its programs do
    not start. See VolumeMesh.write.
    """
    names = mesh.patch_names
    wrong = next((name for name in names if not _NAME.fullmatch(name)), None)
    if wrong is not None:
        raise InvalidInput(Text(phrases.FOAM_PATCH, name=repr(wrong)))
    faces, owner, neighbour, patch = faces_of(mesh)
    inner = len(neighbour)
    texts = {
        "points": ("vectorField", _list_of("(%r %r %r)", mesh.nodes * scale)),
        "faces": ("faceList", _faces(faces)),
        "owner": ("labelList", _list_of("%d", owner[:, None])),
        "neighbour": ("labelList", _list_of("%d", neighbour[:, None])),
        "boundary": ("polyBoundaryMesh", _boundary(names, types, patch, inner)),
    }
    places = {os.path.join("constant", "polyMesh", name): _header(kind, name) + text for name, (kind, text) in texts.items()}
    places.update({os.path.join(*path.split("/")): text for path, text in openfoam_case.solver_texts().items()})
    for path, text in places.items():
        path = os.path.join(folder, path)
        try:
            os.makedirs(os.path.dirname(path), exist_ok=True)
        except OSError as error:
            raise IoError(f"{os.path.dirname(path)} cannot be made: {error.strerror}") from error
        writing.atomically(path, "", lambda ready, text=text: openfoam_case.save(ready, text))


def faces_of(mesh):
    """(rings int (F, 4), -1 after the third corner of triangles; owner (F,); neighbour (inner faces,); patch (F - inner,)):
    faces in upper-triangular order, inner ones first, then patch by patch; normals lead out of the owner.
    """
    rings, owner = rings_of(mesh.solid_blocks)
    keys = np.sort(rings, axis=1)
    order = np.lexsort((owner, *keys.T))
    same = (keys[order[1:]] == keys[order[:-1]]).all(axis=1)
    first, second = order[:-1][same], order[1:][same]  # the owner is the one with the lower number
    upper = np.lexsort((owner[second], owner[first]))
    first, second = first[upper], second[upper]
    outer = np.ones(len(rings), dtype=bool)
    outer[first] = outer[second] = False
    outer = np.flatnonzero(outer)
    patch = mesh.patch_of_faces(rings[outer])
    by_patch = np.lexsort((owner[outer], patch))
    outer, patch = outer[by_patch], patch[by_patch]
    return np.concatenate([rings[first], rings[outer]]), np.concatenate([owner[first], owner[outer]]), owner[second], patch


def _header(kind, name):
    return (f"FoamFile\n{{\n    version 2.0;\n    format ascii;\n    class {kind};\n    location \"constant/polyMesh\";\n"
            f"    object {name};\n}}\n")


def _list_of(form, rows):
    return f"{len(rows)}\n(\n" + "".join(form % tuple(row) + "\n" for row in rows.tolist()) + ")\n"


def _faces(rings):
    lines = [f"3({a} {b} {c})\n" if d < 0 else f"4({a} {b} {c} {d})\n" for a, b, c, d in rings.tolist()]
    return f"{len(lines)}\n(\n" + "".join(lines) + ")\n"


def _boundary(names, types, patch, inner):
    counts = np.bincount(patch, minlength=len(names))
    starts = inner + np.concatenate([[0], np.cumsum(counts)[:-1]])
    lines = [f"    {name}\n    {{\n        type {types[name]};\n        nFaces {count};\n        startFace {start};\n    }}\n"
             for name, count, start in zip(names, counts.tolist(), starts.tolist())]
    return f"{len(names)}\n(\n" + "".join(lines) + ")\n"
