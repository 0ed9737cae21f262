# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layers of volume_mesh in random regions of flows: coverage, validity, and what OpenFOAM's checkMesh says.

    SEED=1 COUNT=14 freecadcmd -P <root>/Mod benchmarks/solvers/flow_layers.py </dev/null
Needs checkMesh (Debian: openfoam). OPENINGS=1: up to three plane faces of each region have no layers. HARD=1: 13 regions in which layers
have to end, instead of random ones. ORDER=2: curved elements, of which checkMesh is not asked.

Seven kinds of regions in turn: ducts with ribs, junctions of pipes, banks of cylinders, bent ducts, chambers with pipes, diffusers, oblique
prisms. A line each, and a sum at the end: how many checkMesh accepts, and how many with -allGeometry.
"""

import math
import os
import random
import sys
import time
from pathlib import Path

import Part
from FreeCAD import Vector

import MeshQuality as mq

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
from check_mesh import checked


def ribs(draw):
    shape = Part.makeBox(30, 8, 6)
    for i in range(draw.randint(1, 4)):
        shape = shape.cut(Part.makeBox(draw.uniform(0.5, 2), 8, draw.uniform(1, 3), Vector(4 + 6 * i, 0, 0)))
    return shape


def junction(draw):
    angle = draw.uniform(-0.7, 0.7)
    branch = Part.makeCylinder(draw.uniform(1, 2.6), 14, Vector(), Vector(math.cos(angle), 0, math.sin(angle)))
    return Part.makeCylinder(3, 24, Vector(0, 0, -12)).fuse(branch)


def bank(draw):
    shape = Part.makeBox(20, 10, 4)
    for i in range(3):
        shape = shape.cut(Part.makeCylinder(draw.uniform(0.4, 1.5), 4, Vector(4 + 5 * i, draw.uniform(2.5, 7.5), 0)))
    return shape


def bent(draw):
    return Part.makeBox(12, 6, 6).fuse(Part.makeBox(6, 6, 14, Vector(draw.uniform(2, 6), 0, 0)))


def chamber(draw):
    pipe = Part.makeCylinder(draw.uniform(0.8, 2), 12, Vector(), Vector(1, draw.uniform(-0.3, 0.3), 0))
    return Part.makeSphere(5).fuse(Part.makeCylinder(2, 12)).fuse(pipe)


def diffuser(draw):
    return Part.makeCone(draw.uniform(1, 2), draw.uniform(3, 5), 10).fuse(Part.makeCylinder(1, 6, Vector(0, 0, -5)))


def oblique(draw):
    count = draw.randint(4, 8)
    corners = [Vector(8 * draw.uniform(0.5, 1) * math.cos(2 * math.pi * i / count),
                      8 * draw.uniform(0.5, 1) * math.sin(2 * math.pi * i / count), 0) for i in range(count)]
    return Part.Face(Part.makePolygon([*corners, corners[0]])).extrude(Vector(draw.uniform(-2, 2), 0, 5))


KINDS = (ribs, junction, bank, bent, chamber, diffuser, oblique)


def regions(seed, count, openings):
    """(kind, solid, options) of each."""
    draw = random.Random(seed)
    for i in range(count):
        kind = KINDS[i % len(KINDS)]
        shape = kind(draw).removeSplitter().Solids[0]
        given = {"layers": draw.randint(2, 7), "first_height": draw.choice([0.01, 0.03, 0.06]), "growth_rate": draw.uniform(1.1, 1.5),
                 "max_edge": draw.choice([1.0, 1.5, 2.5])}
        if openings:
            plane = [j for j, face in enumerate(shape.Faces) if isinstance(face.Surface, Part.Plane)]
            left_out = draw.sample(plane, min(len(plane), draw.randint(1, 3)))
            given["walls"] = [f"Face{j + 1}" for j in range(len(shape.Faces)) if j not in left_out]
        yield kind.__name__, shape, given


def wedge(angle):
    turned = Vector(10 * math.cos(math.radians(angle)), 10 * math.sin(math.radians(angle)), 0)
    return Part.Face(Part.makePolygon([Vector(), Vector(10, 0, 0), turned, Vector()])).extrude(Vector(0, 0, 5))


def hard_regions():
    """(name, solid, options) of regions in which layers have to end: acute edges and apexes, narrow gaps, walls that go on in openings."""
    bank_of_one = Part.makeBox(12, 8, 4).cut(Part.makeCylinder(2, 4, Vector(6, 4, 0)))
    slot = Part.makeBox(20, 8, 6).cut(Part.makeBox(6, 8, 5.8, Vector(7, 0, 0)))
    touching = Part.makeBox(12, 8, 4).cut(Part.makeCylinder(2, 4, Vector(6, 2.02, 0)))
    nose = Part.makeCone(0, 3, 12)
    lens = Part.makeSphere(8, Vector(0, 0, -6)).common(Part.makeSphere(8, Vector(0, 0, 6)))
    step = Part.makeBox(10, 10, 5).fuse(Part.makeBox(10, 10, 5, Vector(10, 0, 0))).Solids[0]  # two coplanar faces on each side
    ring = Part.makeCone(2, 4, 10).fuse(Part.makeCylinder(1, 6, Vector(0, 0, -5)))
    crossing = Part.makeCylinder(3, 24, Vector(0, 0, -12)).fuse(Part.makeCylinder(2.95, 14, Vector(), Vector(1, 0, 0.4)))
    star = Part.Face(Part.makePolygon([Vector((6 if i % 2 else 2) * math.cos(math.pi * i / 5), (6 if i % 2 else 2) * math.sin(math.pi * i / 5), 0)
                                       for i in [*range(10), 0]])).extrude(Vector(0, 0, 6))
    usual = {"layers": 4, "first_height": 0.05, "growth_rate": 1.3, "max_edge": 1.5}
    for name, shape, more in (
            ("wedge of 20 degrees", wedge(20), {}), ("its two sides alone", wedge(20), {"walls": ["Face1", "Face3"]}),
            ("wedge of 35 degrees", wedge(35), {}), ("wedge of 10 degrees, many layers", wedge(10), {"layers": 8, "first_height": 0.01}),
            ("narrow slot", slot, {}), ("cylinder that almost touches", touching, {}), ("cylinder in a channel", bank_of_one, {"first_height": 0.01}),
            ("cone", nose, {}), ("lens", lens, {}), ("wall that goes on in an opening", step, {"walls": ["Face1", "Face2"]}),
            ("diffuser, its cone alone", ring, {"walls": ["Face1"]}), ("junction of almost equal pipes", crossing, {}),
            ("star", star, {"max_edge": 1.0})):
        yield name, shape.removeSplitter().Solids[0] if name[0] != "w" else shape, {**usual, **more}


def main():
    count = accepted = strictly = 0
    drawn = hard_regions() if "HARD" in os.environ else regions(int(os.environ.get("SEED", 1)), int(os.environ.get("COUNT", 14)),
                                                                "OPENINGS" in os.environ)
    for kind, shape, given in drawn:
        start, count = time.time(), count + 1
        try:
            mesh = mq.volume_mesh(shape, **given, order=int(os.environ.get("ORDER", 1)))
        except mq.Error as error:
            print(f"{kind}: {error}; {given}", flush=True)
            continue
        seconds, certificate, report = time.time() - start, mq.certify(mesh), mesh.report
        if mesh.order > 1:
            print(f"{kind}: {seconds:.1f} s, {sum(report.elements.values()):,} elements, {certificate.invalid} invalid, {len(report.straightened)} "
                  f"straightened, volume off by {report.volume / shape.Volume - 1:.1e}, bound {report.min_distortion:.2f}", flush=True)
            continue
        faults = checked(mesh)
        more = checked(mesh, "-allGeometry")
        accepted, strictly = accepted + (not faults), strictly + (not more)
        print(f"{kind}: {seconds:.1f} s, {sum(report.elements.values()):,} elements, {certificate.invalid} invalid, covered "
              f"{report.covered:.3f}, full height {report.full_height:.3f}, non-orthogonality {report.max_non_orthogonality:.0f}°, "
              f"skewness {report.max_skewness:.1f}, {faults or 'Mesh OK'}; all geometry: {more or 'Mesh OK'}", flush=True)
    print(f"{accepted} of {count} accepted by checkMesh, {strictly} with -allGeometry", flush=True)


main()
