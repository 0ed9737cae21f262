# SPDX-License-Identifier: LGPL-2.1-or-later
"""set_patches and export_mesh: after edits of the document, patches are where their faces are; by the written file."""

import os
import tempfile

import FreeCAD
import measures
import MeshQuality as mq
import numpy as np
import Part
import solids
from judge import Judge, dice_of

KINDS = [kind for kind in solids.SOLIDS if kind not in ("sphere", "torus", "far", "huge", "micro")]
SAMPLES = 15


def check(shape, seed):
    dice, _ = dice_of("patches", seed)
    judge, size = Judge(), measures.size(shape)
    document = FreeCAD.newDocument("Patches")
    source = document.addObject("Part::Feature", "Source")
    source.Shape = shape
    document.recompute()
    chord_height = 0.01 * size
    obj = mq.add_quality_mesh(source, chord_height=chord_height)
    chosen = sorted(dice.sample(range(len(shape.Faces)), dice.randint(1, max(1, len(shape.Faces) // 2))))
    mq.set_patches(obj, {"chosen": [f"Face{k + 1}" for k in chosen]}, patch_rest="rest")
    patch = Part.makeCompound([shape.Faces[k] for k in chosen])
    rest = Part.makeCompound([face for k, face in enumerate(shape.Faces) if k not in chosen])
    _compare(judge, obj, patch, rest, chord_height, "before an edit")
    for name in dice.sample(sorted(EDITS), 2):
        edited = EDITS[name](source.Shape, dice)
        if not edited or not edited.isValid():
            continue
        source.Shape = edited
        document.recompute()
        if not obj.PatchesChanged:  # what it could not find again it says there
            _compare(judge, obj, patch, rest, chord_height, name)
    FreeCAD.closeDocument(document.Name)
    return judge.verdict()


def _reordered(shape, dice):
    """The same solid with its faces in another order."""
    solid = Part.makeSolid(Part.makeShell(dice.sample(shape.Faces, len(shape.Faces))))
    return solid if solid.isClosed() and solid.Volume > 0 else None


def _bored(shape, dice):
    """A small bore in a plane face: others stay, the face is smaller."""
    planes = [face for face in shape.Faces if type(face.Surface).__name__ == "Plane"]
    if not planes:
        return None
    face = dice.choice(planes)
    radius = 0.05 * face.Area ** 0.5
    bore = Part.makeCylinder(radius, 4 * radius, face.CenterOfMass - face.normalAt(0, 0) * 2 * radius, face.normalAt(0, 0))
    cut = shape.cut(bore)
    return cut.Solids[0] if len(cut.Solids) == 1 else None


def _saved(shape, dice):
    """Through a file in FreeCAD's text."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "shape.brep")
        shape.exportBrep(path)
        copy = Part.Shape()
        copy.importBrep(path)
    return copy


EDITS = {"another order of faces": _reordered, "a bore": _bored, "written and read": _saved}


def _compare(judge, obj, patch, rest, chord_height, when):
    """Triangles of the patch lie on its faces, the others on those of the rest or on new ones."""
    found = written(obj)
    judge.claim("chosen" in found, f"{when}: the patch is not in the file")
    for name, own, other in (("chosen", patch, rest), ("rest", rest, patch)):
        middles = np.array(found.get(name, [])).reshape(-1, 3, 3).mean(axis=1)[:: max(1, len(found.get(name, [])) // SAMPLES)]
        for place in middles:
            away, beside = (measures.distances([place], one)[0] if one.Faces else np.inf for one in (own, other))
            judge.claim(not (beside < 0.1 * away and away > 2 * chord_height),
                        f"{when}: a triangle of '{name}' at {place.tolist()} is {away:.4g} mm from the faces of its patch")


def written(obj):
    """{name of a patch: [three corners, ...]} of the ASCII STL file."""
    found, name = {}, None
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "mesh.stl")
        mq.export_mesh(obj, path, ascii=True)
        with open(path, encoding="ascii") as stream:
            for line in stream:
                words = line.split()
                if words[:1] == ["solid"]:
                    name = words[1]
                elif words[:1] == ["vertex"]:
                    found.setdefault(name, []).append([float(word) for word in words[1:]])
    return {name: np.array(points).reshape(-1, 3, 3).tolist() for name, points in found.items()}
