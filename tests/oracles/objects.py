# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects of the document: after edits of their source, and undo, their meshes are those of the shape, by FreeCAD's Mesh."""

import FreeCAD
import measures
import MeshQuality as mq
import numpy as np
import solids
from judge import Judge, dice_of

KINDS = [kind for kind in solids.SOLIDS if kind not in ("micro", "thread", "pattern")]


class Scene:
    """A document with the shape, and an object that is made of it."""

    def __init__(self, shape, dice):
        self.document, self.size = FreeCAD.newDocument("Objects"), measures.size(shape)
        self.document.UndoMode = 1
        self.source = self.document.addObject("Part::Feature", "Source")
        self.source.Shape = shape
        self.document.recompute()
        self.error = 0.01 * self.size
        self.distance = self.size * dice.choice([0.05, 0.1])

    def quality(self):
        return mq.add_quality_mesh(self.source, chord_height=self.error)

    def curved(self):
        return mq.add_curved_mesh(self.source, chord_height=self.error, deviation=self.error)

    def improved(self):
        return mq.add_improved_mesh(self.quality(), tolerance=self.error)

    def fem(self):
        return mq.add_fem_mesh(self.source, chord_height=self.error)

    def offset(self):
        return mq.add_offset(self.source, self.distance, tolerance=self.error)

    def hollow(self):
        return mq.add_hollow(self.source, self.distance, tolerance=self.error)

    def wrap(self):
        return mq.add_wrap(self.source, 0.1 * self.size, tolerance=2 * self.error)


# By name: how far the box of the mesh is outside of the shape's, in distances, and whether the volume is that of the shape.
MADE = {"quality": (0, True), "curved": (0, True), "improved": (0, True), "fem": (0, True), "offset": (1, False),
        "hollow": (0, False), "wrap": (0, False)}


def check(shape, seed):
    dice, _ = dice_of("objects", seed)
    judge, scene, name = Judge(), Scene(shape, dice), dice.choice(sorted(MADE))
    obj = getattr(scene, name)()
    _compare(judge, scene, obj, name, "made")
    first = measured(obj)
    scene.document.openTransaction("Edit")
    way = dice.choice(["moved", "larger"])
    if way == "moved":
        scene.source.Placement = FreeCAD.Placement(FreeCAD.Vector(scene.size, 0, 0), FreeCAD.Rotation(
            FreeCAD.Vector(dice.uniform(-1, 1), 1, 1), 50)).multiply(scene.source.Placement)
    else:
        scene.source.Shape = solids.scaled(scene.source.Shape, 1.1)
    scene.document.recompute()
    scene.document.commitTransaction()
    _compare(judge, scene, obj, name, way)
    scene.document.undo()
    scene.document.recompute()
    again = measured(obj)
    judge.claim(np.allclose(first[0], again[0], atol=1e-5 * scene.size) and abs(first[1] - again[1]) <= 1e-4 * abs(first[1]),
                f"{name}: undo of '{way}' does not bring the mesh back")
    FreeCAD.closeDocument(scene.document.Name)
    return judge.verdict()


def _compare(judge, scene, obj, name, when):
    shape = scene.source.Shape
    out, same_volume = MADE[name]
    box, volume = measured(obj)
    points, _ = measures.tessellated(shape, scene.error)
    right = np.array([points.min(axis=0), points.max(axis=0)]) + np.array([[-1.0], [1.0]]) * out * scene.distance
    off, allowed = np.abs(box - right).max(), 4 * scene.error + measures.rounding(points)
    judge.claim(off <= allowed, f"{name}, {when}: the box of the mesh is {off:.4g} mm off that of the shape, {allowed:.4g} allowed")
    if same_volume:
        found, error = measures.volume_of(shape)
        allowed = error + 2.2 * scene.error * shape.Area
        judge.claim(abs(volume - found) <= allowed, f"{name}, {when}: volume {volume:.6g} mm3, {found:.6g} is right")
    judge.claim(obj.Status == "up to date", f"{name}, {when}: {obj.Status}")


def measured(obj):
    """(corners of the box, volume) of a document object with a mesh or a FEM mesh."""
    if hasattr(obj, "FemMesh"):
        mesh = obj.FemMesh
        nodes = {tag: tuple(obj.Placement.multVec(point)) for tag, point in mesh.Nodes.items()}
        cells = np.array([[nodes[tag] for tag in mesh.getElementNodes(volume)[:4]] for volume in mesh.Volumes])
        points = np.array([*nodes.values()])
        sides = cells[:, 1:] - cells[:, :1]
        volume = float(np.abs(np.linalg.det(sides)).sum()) / 6.0
    else:
        points, facets = obj.Mesh.Topology
        points = np.array([tuple(point) for point in points])
        volume = measures.volume(points, np.array(facets))
    return np.array([points.min(axis=0), points.max(axis=0)]), volume
