# SPDX-License-Identifier: LGPL-2.1-or-later
"""A laminar flow in a bent pipe by OpenFOAM's simpleFoam on meshes of volume_mesh, against White's friction of Dean's flow.

    freecadcmd -P <root>/Mod benchmarks/solvers/flow_bend.py </dev/null
Needs simpleFoam (Debian: openfoam). EDGES="2.5 2": mm, of the meshes. A line each.

A pipe of radius 5 mm, bent by 270 degrees around a circle of 50 mm; Reynolds number 200, Dean number 63. The parabola of a straight pipe enters. The
pressure is measured by a line through the cells between 150 and 250 degrees, and compared with that of a straight pipe of the same length and flux
(Hagen and Poiseuille). By White 1929, from Dean numbers K of 11.6 on, the ratio is 1 / (1 - (1 - (11.6 / K)^0.45)^(1 / 0.45)).
"""

import math
import os
import sys
from pathlib import Path

import numpy as np
import Part
from FreeCAD import Vector

import MeshQuality as mq

sys.path.append(str(Path(__file__).resolve().parent))
import laminar

RADIUS, BEND = 5.0, 50.0  # mm
MEAN = 0.2  # m/s
DEVELOPED = (150.0, 250.0)  # degrees
DEAN = 2e-3 * MEAN * RADIUS / laminar.VISCOSITY * math.sqrt(RADIUS / BEND)
WHITE = 1.0 / (1.0 - (1.0 - (11.6 / DEAN) ** 0.45) ** (1.0 / 0.45))


def area_of(mesh, face):
    """mm^2, of a plane face by its index."""
    area = 0.0
    for rows, faces in ((mesh.boundary_triangles, mesh.triangle_face), (mesh.boundary_quadrilaterals, mesh.quadrilateral_face)):
        corners = mesh.nodes[rows[faces == face]]
        area += np.linalg.norm(np.cross(corners, np.roll(corners, -1, axis=1)).sum(axis=1), axis=1).sum() / 2.0
    return area


def main():
    region = Part.makeTorus(BEND, RADIUS, Vector(), Vector(0, 0, 1), -180, 180, 270)
    at = {name: next(i for i, face in enumerate(region.Faces, 1) if (face.CenterOfMass - place).Length < 1e-3)
          for name, place in (("inlet", Vector(BEND, 0, 0)), ("outlet", Vector(0, -BEND, 0)))}
    wall = next(i for i in range(1, 4) if i not in at.values())
    for edge in map(float, os.environ.get("EDGES", "2.5 2").split()):
        mesh = mq.volume_mesh(region, layers=4, first_height=0.1 * edge, growth_rate=1.2, walls=[f"Face{wall}"], max_edge=edge,
                              chord_height=edge**2 / 100.0, patches={name: [f"Face{i}"] for name, i in at.items()}, patch_rest="pipe")
        x, _, z = laminar.centres_of_inlet(mesh).T
        velocity = np.zeros((len(x), 3))
        velocity[:, 1] = np.maximum(2.0 * MEAN * (1.0 - ((x - BEND) ** 2 + z**2) / RADIUS**2), 0.0)
        run, centres = laminar.solved(mesh, velocity), laminar.centres_of_cells(mesh)
        angle = np.arctan2(centres[:, 1], centres[:, 0]) % (2.0 * math.pi)
        there = (angle > math.radians(DEVELOPED[0])) & (angle < math.radians(DEVELOPED[1]))
        fall = -np.polyfit(angle[there] * BEND, run["pressure"][there], 1)[0]  # m^2/s^2 for each mm of the axis
        straight, of_polygon = (fall / (8.0 * math.pi * laminar.VISCOSITY * run["flux"] / area**2 * 1e9)
                                for area in (math.pi * RADIUS**2, area_of(mesh, at["inlet"] - 1)))
        print(f"{edge:g} mm: {sum(mesh.report.elements.values()):,} cells, covered {mesh.report.covered:.3f}, {run['steps']} steps"
              f"{'' if run['converged'] else ', not converged'}, {run['seconds']:.0f} s, residuals {run['residuals'][0]:.1e}, {run['residuals'][1]:.1e}; "
              f"friction {straight:.3f} of a straight pipe's, {of_polygon:.3f} of the polygon's, White {WHITE:.3f} ({of_polygon / WHITE - 1.0:+.1%}); "
              f"mass balance {run['mass']:.1e}", flush=True)


main()
