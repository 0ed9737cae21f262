# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes with straight meshes of prisms, hexahedra and pyramids, whose layers are thin. Runs inside FreeCAD."""

import functools
import math

import numpy as np
import Part
from FreeCAD import Vector

import MeshQuality as mq
from MeshQuality.core.elements import kinds
from MeshQuality.core.elements.assembly import Content, ElementBlock
from MeshQuality.core.meshes.element_mesh import ElementMesh


def mesh_of(nodes, *blocks):
    """An ElementMesh of (kind, rows)."""
    made = []
    for kind, rows in blocks:
        rows = np.array(rows, dtype=np.int32)
        none = np.full(len(rows), -1, dtype=np.int32)
        made.append(ElementBlock(kind, kinds.order_of(kind, rows.shape[1]), rows, none, none.copy()))
    return ElementMesh(Content(np.array(nodes, dtype=float), tuple(made), {}, ()))


def shares(layers, growth):
    """From 0 at the wall to 1: layers that grow by a factor."""
    steps = growth ** np.arange(layers)
    return np.concatenate([[0.0], np.cumsum(steps) / steps.sum()])


def stacks(wall, top, triangles, fractions):
    """(nodes, prisms) between two copies of triangles, of which the wall is below."""
    nodes = np.concatenate([wall + (top - wall) * s for s in fractions])
    prisms = [np.column_stack([triangles + k * len(wall), triangles + (k + 1) * len(wall)])
              for k in range(len(fractions) - 1)]
    return nodes, np.concatenate(prisms)


def shell(thickness=5.0, chord=0.05, layers=5, growth=4.0):
    """Prisms from one sphere to another, thinnest on the inner one, whose wall they are pressed by."""
    inner, outer = 5.0, 5.0 + thickness
    surface = mq.curve(Part.makeSphere(inner), order=1, chord_height_relative=chord)
    wall = surface.nodes
    nodes, prisms = stacks(wall, wall * (outer / inner), surface.triangles, shares(layers, growth))
    return Part.makeSphere(outer).cut(Part.makeSphere(inner)), mesh_of(nodes, ("prism", prisms))


def around_sphere(thickness=0.05, chord=0.05, layers=3, growth=2.0):
    """A box around a sphere: prisms on the sphere, tetrahedra beyond."""
    box = Part.makeBox(30, 30, 30, Vector(-15, -15, -15))
    far = mq.curve(box.cut(Part.makeSphere(5 + thickness)), order=1, volume=True, chord_height_relative=chord / 3)
    ball = far.triangles[np.linalg.norm(far.nodes[far.triangles].mean(axis=1), axis=1) < 7]
    on, triangles = np.unique(ball, return_inverse=True)
    triangles = triangles.reshape(-1, 3)[:, ::-1]  # outward of the box is into the sphere
    top = far.nodes[on]
    made, prisms = stacks(top * 5 / (5 + thickness), top, triangles, shares(layers, growth))
    below = len(on) * layers  # those on the top are nodes of tetrahedra
    number = np.concatenate([len(far.nodes) + np.arange(below), on])
    nodes = np.concatenate([far.nodes, made[:below]])
    return box.cut(Part.makeSphere(5)), mesh_of(nodes, ("tetrahedron", far.tetrahedra), ("prism", number[prisms]))


def grid(points):
    """Hexahedra on an array of points (I, J, K, 3)."""
    i, j, k = (n - 1 for n in points.shape[:3])
    index = np.arange(points[..., 0].size).reshape(points.shape[:3])

    def at(a, b, c):
        return index[a:a + i, b:b + j, c:c + k].ravel()

    order = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
    return points.reshape(-1, 3), np.column_stack([at(*corner) for corner in order])


def joined(nodes, elements):
    """The same with nodes at one place as one."""
    _, first, number = np.unique(np.round(nodes, 7), axis=0, return_index=True, return_inverse=True)
    return nodes[first], number.ravel()[elements]


def pipe(layers=5, growth=3.0, around=8, bend=False):
    """The wall of a pipe, straight or bent by a quarter: hexahedra, thinnest on the inside."""
    radii = 3 + 2 * shares(layers, growth)
    angles = 2 * math.pi * np.arange(around + 1) / around
    along = np.linspace(0, 1, 4)
    r, a, s = np.meshgrid(radii, angles, along, indexing="ij")
    x, y = r * np.cos(a), r * np.sin(a)
    if bend:
        turn = s * math.pi / 2
        points = np.stack([(12 + x) * np.cos(turn), (12 + x) * np.sin(turn), -y], axis=-1)
        shape = _bend(5).cut(_bend(3))
    else:
        points = np.stack([x, y, 10 * s], axis=-1)
        shape = Part.makeCylinder(5, 10).cut(Part.makeCylinder(3, 10))
    return shape, mesh_of(*_with_kind(*joined(*grid(points))))


def _bend(radius):
    circle = Part.makeCircle(radius, Vector(12, 0, 0), Vector(0, 1, 0))
    return Part.Face(Part.Wire(circle)).revolve(Vector(), Vector(0, 0, 1), 90)


def _with_kind(nodes, hexahedra):
    return nodes, ("hexahedron", hexahedra)


def blade(layers=4, growth=3.0):
    """A blade without twist between two arcs, cut off at both ends: hexahedra, thin at both sides."""
    half, rise, height = 10.0, 2.0, 8.0
    sag = 0.5
    upper = Part.Arc(Vector(-half, sag, 0), Vector(0, sag + rise, 0), Vector(half, sag, 0)).toShape()
    lower = Part.Arc(Vector(half, -sag, 0), Vector(0, -sag + 0.6 * rise, 0), Vector(-half, -sag, 0)).toShape()
    ends = [Part.makeLine(Vector(half, sag, 0), Vector(half, -sag, 0)),
            Part.makeLine(Vector(-half, -sag, 0), Vector(-half, sag, 0))]
    shape = Part.Face(Part.Wire([upper, ends[0], lower, ends[1]])).extrude(Vector(0, 0, height))
    along = np.linspace(-half, half, 5)

    def on(edge):
        places = []
        for x in along:
            plane = Part.Plane(Vector(x, 0, 0), Vector(1, 0, 0))
            first, last = edge.ParameterRange
            found = edge.Curve.intersect(plane)[0] if abs(abs(x) - half) > 1e-9 else None
            point = min((edge.Vertexes), key=lambda v: abs(v.X - x)).Point if found is None else max(
                (Vector(p.X, p.Y, p.Z) for p in found), key=lambda p: -abs(edge.distToShape(Part.Vertex(p))[0]))
            places.append(tuple(point))
        return np.array(places)

    thin = shares(layers, growth) / 2
    fractions = np.concatenate([thin, 1 - thin[-2::-1]])
    up, down = on(upper), on(lower)
    flat = down[:, None] + (up - down)[:, None] * fractions[None, :, None]
    points = np.stack([flat + np.array([0, 0, z]) for z in np.linspace(0, height, 3)], axis=2)
    return shape, mesh_of(*_with_kind(*grid(points)))


def with_pyramids(shape, mesh, chosen):
    """The same with the chosen hexahedra divided into six pyramids each."""
    hexahedra = mesh.blocks[0].nodes
    middles = mesh.nodes[hexahedra[chosen]].mean(axis=1)
    apexes = len(mesh.nodes) + np.arange(len(middles))
    pyramids = [np.column_stack([hexahedra[chosen][:, face[::-1]], apexes]) for face in map(list, kinds.FACES["hexahedron"])]
    rest = np.delete(hexahedra, chosen, axis=0)
    nodes = np.concatenate([mesh.nodes, middles])
    return shape, mesh_of(nodes, ("pyramid", np.concatenate(pyramids)), ("hexahedron", rest))


@functools.lru_cache(maxsize=1)
def volumes():
    """{name: (shape, mesh)}"""
    found = {"shell of prisms": shell(), "prisms around a sphere": around_sphere(), "pipe of hexahedra": pipe(),
             "pipe bend of hexahedra": pipe(bend=True), "blade of hexahedra": blade()}
    shape, mesh = found["pipe of hexahedra"]
    outer = np.flatnonzero(np.hypot(*mesh.nodes[mesh.blocks[0].nodes].mean(axis=1)[:, :2].T) > 3.9)
    found["pipe with pyramids"] = with_pyramids(shape, mesh, outer)
    return found
