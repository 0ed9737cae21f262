# SPDX-License-Identifier: LGPL-2.1-or-later
"""certify and verify: honest certificates hold, and are true; forged ones are refused."""

import json
import os
import tempfile

import curve
import measures
import MeshQuality as mq
import numpy as np
import solids
from judge import Judge, dice_of

KINDS = [*solids.SOLIDS]
SAMPLES = 80


def check(shape, seed):
    dice, numbers = dice_of("certify", seed)
    judge, size = Judge(), measures.size(shape)
    with tempfile.TemporaryDirectory() as folder:
        mesh, cad, saved = (os.path.join(folder, name) for name in ("mesh.msh", "shape.brep", "certificate.json"))
        shape.exportBrep(cad)
        if dice.random() < 0.3:
            made = mq.triangulate(shape, chord_height=0.04 * size)
            made.write(mesh)
        else:
            made = mq.curve(shape, order=dice.choice([1, 2, 2, 3]), volume=dice.random() < 0.4, chord_height_relative=0.05)
            made.write(mesh)
        certificate = mq.certify(mesh, shape)
        judge.claim(certificate.not_on_shape is None, f"an honest mesh is called off its shape: {certificate.not_on_shape}")
        _true(judge, certificate, made, shape, numbers)
        certificate.save(saved, cad=cad)
        _holds(judge, saved)
        for name in dice.sample(sorted(FORGED), 3):
            _refused(judge, name, saved, mesh, cad, dice)
    return judge.verdict()


def _true(judge, certificate, made, shape, numbers):
    """Its distances, by OpenCASCADE and VTK."""
    if certificate.not_on_shape is not None:
        return
    slack = 1e-6 * measures.size(shape)
    if isinstance(made, mq.SurfaceMesh):
        nearest, slack = measures.Nearest(made.vertices + made.origin, made.triangles), slack + measures.rounding(made.vertices)
        places, _ = measures.samples(made.vertices + made.origin, made.triangles, numbers, SAMPLES)
    else:
        if made.order == 1:
            fine = made.nodes, made.triangles
        else:
            fine, slack = curve.lattice(made), slack + 1e-3 * measures.size(shape)
        nearest, places = measures.Nearest(*fine), numbers.permutation(made.nodes[np.unique(made.triangles)])[:SAMPLES]
    away = measures.distances(places, measures.skin(shape)).max()
    judge.claim(away <= certificate.max_deviation * 1.02 + slack,
                f"the mesh is {away:.5g} mm from the shape, certified {certificate.max_deviation:.5g}")
    back, _ = measures.points_on(shape, numbers, SAMPLES)
    away = nearest.distances(back).max(initial=0.0)
    judge.claim(away <= certificate.cad_deviation + certificate.cad_spacing + slack,
                f"the shape is {away:.5g} mm from the mesh, certified {certificate.cad_deviation:.5g}")


def _holds(judge, saved):
    verified = mq.verify(saved)
    judge.claim(verified.holds, f"an honest certificate is refused: {verified.faults[:1]}")


def _refused(judge, name, saved, mesh, cad, dice):
    """A forged copy of the certificate beside the mesh, or of the mesh and the CAD, put back afterwards."""
    kept = {}
    for path in (saved, mesh, cad):
        with open(path, "rb") as stream:
            kept[path] = stream.read()
    content = json.loads(kept[saved])
    if FORGED[name](content, {"mesh": mesh, "cad": cad}, dice):
        with open(saved, "w", encoding="ascii") as stream:
            json.dump(content, stream)
        try:
            judge.claim(not mq.verify(saved).holds, f"a forged certificate is accepted: {name}")
        except mq.Error:
            pass  # refused as damaged
    for path, data in kept.items():
        with open(path, "wb") as stream:
            stream.write(data)


def _number(key, change):
    """Another number for one of the proven claims; False where that would be no lie."""

    def forge(content, paths, dice):
        old = content["proven"].get(key)
        if old is None or abs(change(old) - old) <= 1e-6 * (1 + abs(old)):
            return False
        content["proven"][key] = change(old)
        return True

    return forge


def _left_out(key):
    def forge(content, paths, dice):
        if content["proven"].get(key) is None:
            return False
        content["proven"][key] = None
        return True

    return forge


def _triangle(content, paths, dice):
    """The largest distance of a triangle, and of all, is said to be half."""
    found = content["surface"].get("deviation")
    if not found or max(found) < 1e-4:
        return False
    content["surface"]["deviation"] = [value / 2 for value in found]
    content["proven"]["max_deviation"] /= 2
    return True


def _bounds(content, paths, dice):
    block = content["blocks"][-1]
    if min(block["distortion"], default=1.0) > 0.9:
        return False
    block["distortion"] = [0.95] * len(block["distortion"])
    return True


def _bytes(which):
    """A digit of the file is another one, and nothing is said of it."""

    def forge(content, paths, dice):
        with open(paths[which], "rb") as stream:
            data = bytearray(stream.read())
        places = [k for k in range(len(data) // 3, len(data) // 2) if 0x30 <= data[k] <= 0x39]
        if not places:
            return False
        data[dice.choice(places)] ^= 1
        with open(paths[which], "wb") as stream:
            stream.write(data)
        return True

    return forge


FORGED = {
    "max_deviation halved": _number("max_deviation", lambda x: x / 2 if x > 1e-4 else x),
    "cad_deviation 0": _number("cad_deviation", lambda x: 0.0 if x > 1e-4 else x),
    "cad_deviation halved": _number("cad_deviation", lambda x: x / 2 if x > 1e-4 else x),
    "cad_spacing 0": _number("cad_spacing", lambda x: 0.0 if x > 1e-4 else x),
    "cad_spacing 1e-9": _number("cad_spacing", lambda x: 1e-9 if x > 1e-4 else x),
    "min_distortion 0.99": _number("min_distortion", lambda x: 0.99 if x < 0.9 else x),
    "another number of folded ones": _number("folded_on_cad", lambda x: x + 1),
    "not conforming": _number("conforming", lambda x: not x),
    "max_deviation left out": _left_out("max_deviation"), "cad_deviation left out": _left_out("cad_deviation"),
    "folded_on_cad left out": _left_out("folded_on_cad"),
    "distances of triangles halved": _triangle, "bounds of elements": _bounds,
    "a byte of the mesh": _bytes("mesh"), "a byte of the shape": _bytes("cad")}
