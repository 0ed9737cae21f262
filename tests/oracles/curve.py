# SPDX-License-Identifier: LGPL-2.1-or-later
"""curve: the elements of the written file, read and evaluated by Gmsh; distances, volumes, bodies."""

import os
import tempfile

import bodies
import gmsh
import measures
import MeshQuality as mq
import numpy as np
import solids
from judge import Judge, dice_of
from MeshQuality.core.certify import verdict

KINDS = [*solids.SOLIDS, *bodies.BODIES]
SAMPLES = 60


def check(shape, seed):
    dice, numbers = dice_of("curve", seed)
    order, volume = dice.choice([2, 2, 3]), dice.random() < 0.6
    values = {"chord_height_relative": dice.choice([0.01, 0.03]), "imprint": len(shape.Solids) > 1}
    curved = mq.curve(shape, order=order, volume=volume, **values)
    judge = Judge(verdict.of_curved(curved, verdict.must_be_closed(shape), values, shape=shape))
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "curved.msh")
        curved.write(path)
        elements = read(path)
    _jacobians(judge, curved, elements, 3 if volume else 2)
    _volume(judge, curved, shape, elements, volume)
    _distances(judge, curved, shape, elements[2], numbers)
    if len(shape.Solids) > 1:
        _bodies(judge, curved, shape)
    return judge.verdict()


def _bodies(judge, curved, shape):
    """Those that contain or overlap each other are named; those that are apart do not cross, farther than the lattice is from
    the elements.
    """
    a, b = shape.Solids
    if a.common(b).Volume > 1e-6 * min(a.Volume, b.Volume):
        judge.claim(judge.findings, "two bodies overlap, or one contains the other, and the mesh is called met")
    if curved.report.curved_intersections > 0:
        judge.claim(judge.findings, f"{curved.report.curved_intersections} proven crossings, and the mesh is called met")
    if a.distToShape(b)[0] > 4e-3 * measures.size(shape):
        points, triangles = lattice(curved)
        body = (curved.triangle_face >= len(a.Faces)).repeat(len(triangles) // len(curved.triangles))
        pairs = measures.crossings(points, triangles, body)
        judge.limit(not pairs, f"bodies apart cross: {len(pairs)} pairs of flat parts of curved triangles")


def read(path):
    """{dimension: (points, Jacobian matrices [column, row], determinants, weights)}, each [element, place], by Gmsh."""
    gmsh.initialize()
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(path)
        found = {}
        for dimension in (2, 3):
            parts = []
            for kind in gmsh.model.mesh.getElementTypes(dimension):
                places, weights = gmsh.model.mesh.getIntegrationPoints(kind, "Gauss8")
                corners = [0, 0, 0, 1, 0, 0, 0, 1, 0, *([0, 0, 1] if dimension == 3 else [])]
                places, weights = [*corners, *places], [*[0.0] * (dimension + 1), *weights]
                matrices, dets, points = gmsh.model.mesh.getJacobians(kind, places)
                parts.append((np.reshape(points, (-1, len(weights), 3)), np.reshape(matrices, (-1, len(weights), 3, 3)),
                              np.reshape(dets, (-1, len(weights))), np.array(weights)))
            if parts:
                found[dimension] = parts[0]
        return found
    finally:
        gmsh.finalize()


def _jacobians(judge, curved, elements, dimension):
    judge.claim(dimension in elements and len(elements[dimension][0]) == len(curved.elements),
                "Gmsh reads another number of elements than were made")
    if dimension == 3:
        low = elements[3][2].min(axis=1)
        folded = np.flatnonzero(low <= 0)
        judge.claim(len(folded) <= curved.report.invalid,
                    f"{len(folded)} tetrahedra have a Jacobian <= 0 by Gmsh, {curved.report.invalid} are reported")
    columns = elements[2][1]
    flat = np.linalg.norm(np.cross(columns[:, :, 0], columns[:, :, 1]), axis=2)
    scale = np.median(flat, axis=1)
    judge.claim((flat.min(axis=1) > 1e-6 * scale).all() or curved.report.invalid,
                "a triangle has a place without area by Gmsh, none is reported")


def _volume(judge, curved, shape, elements, volume):
    right, error = measures.volume_of(shape)
    points, matrices, dets, weights = elements[2]
    if abs(curved.report.cad_volume) > 0:
        judge.claim(abs(curved.report.cad_volume - right) <= error + 1e-4 * right,
                    f"cad_volume {curved.report.cad_volume:.6g} mm3, {right:.6g} is right")
    if volume:
        found = float((elements[3][2] * elements[3][3]).sum())
    elif len(curved.triangle_face_behind):
        return  # triangles between two bodies are there once
    else:
        normals = np.cross(matrices[:, :, 0], matrices[:, :, 1])
        found = float(np.einsum("ejk,ejk,j->", points - points[0, 0], normals, weights)) / 3.0
    allowed = error + sum(solid.Area for solid in shape.Solids) * (curved.report.max_deviation * 1.1) + 1e-6 * right
    judge.limit(abs(found - right) <= allowed, f"volume {found:.6g} mm3 by Gmsh, {right:.6g} is right, {allowed:.3g} allowed")
    if curved.report.volume:
        judge.claim(abs(found - curved.report.volume) <= 1e-5 * right,
                    f"volume {found:.7g} mm3 by Gmsh, reported {curved.report.volume:.7g}")


def _distances(judge, curved, shape, surface, numbers):
    points = surface[0].reshape(-1, 3)
    skin, slack = measures.skin(shape), measures.rounding(points) + 1e-7 * measures.size(shape)
    places = points[numbers.choice(len(points), min(SAMPLES, len(points)), replace=False)]
    away = measures.distances(places, skin).max()
    said = curved.report.max_deviation
    judge.claim(away <= 1.05 * said + slack, f"a triangle is {away:.4g} mm from the shape, reported {said:.4g}")
    if not curved.report.straightened and not curved.report.invalid:
        nodes = curved.nodes[np.unique(curved.triangles)]
        places = nodes[numbers.choice(len(nodes), min(SAMPLES, len(nodes)), replace=False)]
        away = measures.distances(places, skin).max()
        judge.claim(away <= max(slack, 1.001 * said), f"a node is {away:.4g} mm from the shape, reported {said:.4g}")
    asked = curved.report.chord_height_asked
    nearest = measures.Nearest(*lattice(curved))
    back, _ = measures.points_on(shape, numbers, SAMPLES)
    away = nearest.distances(back).max(initial=0.0)
    judge.limit(not asked or away <= asked + _FINE * measures.size(shape) + slack,
                f"the shape is {away:.4g} mm from the mesh, {asked:.4g} requested")


_FINE = 1e-3  # of the size: distance of the flat triangles from the curved ones


def lattice(curved):
    """Flat triangles through Lagrange polynomials at the nodes of a lattice, by solving for them at the nodes."""
    order, parts = curved.order, 4
    reference = _reference(order)
    powers = [(i, j) for i in range(order + 1) for j in range(order + 1 - i)]
    lattice = np.array([(i, j) for i in range(parts + 1) for j in range(parts + 1 - i)]) / parts
    shape = np.linalg.solve(_vandermonde(reference, powers).T, _vandermonde(lattice, powers).T).T
    points = np.einsum("pn,tnk->tpk", shape, curved.nodes[curved.triangles])
    number = {tuple(np.rint(place * parts).astype(int)): k for k, place in enumerate(lattice)}
    local = [(number[i, j], number[i + 1, j], number[i, j + 1]) for i in range(parts) for j in range(parts - i)]
    local += [(number[i + 1, j], number[i + 1, j + 1], number[i, j + 1])
              for i in range(parts) for j in range(parts - i - 1)]
    triangles = np.array(local)[None] + (np.arange(len(points)) * len(lattice))[:, None, None]
    return points.reshape(-1, 3), triangles.reshape(-1, 3)


def _reference(order):
    """The nodes of Gmsh's triangle of orders 2 and 3 in (u, v)."""
    if order == 2:
        return np.array([(0, 0), (1, 0), (0, 1), (0.5, 0), (0.5, 0.5), (0, 0.5)])
    third = 1.0 / 3.0
    return np.array([(0, 0), (1, 0), (0, 1), (third, 0), (2 * third, 0), (2 * third, third), (third, 2 * third),
                     (0, 2 * third), (0, third), (third, third)])


def _vandermonde(places, powers):
    return np.array([[u**i * v**j for i, j in powers] for u, v in places])
