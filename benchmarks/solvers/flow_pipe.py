# SPDX-License-Identifier: LGPL-2.1-or-later
"""A laminar flow in a straight pipe by OpenFOAM's simpleFoam on meshes of volume_mesh, against Hagen and Poiseuille.

    freecadcmd -P <root>/Mod benchmarks/solvers/flow_pipe.py </dev/null
Needs simpleFoam (Debian: openfoam). EDGES="2.5 1.7 1.2": mm, of the meshes; SCHEME=linear: of gradients and of the convected velocity, in place of
pointLinear; GROWTH=0.8: growth_inside, in place of 0.3. A line each.

Pipe of radius 5 mm and length 40 mm, Reynolds number 100. The parabola of the developed flow enters. The pressure falls by 8 nu Q / (pi R^4)
for each length for a flux Q; that is measured by a line through the cells of the second half, where the flow has become what the scheme makes
of it. The section of the mesh is a polygon inside of the circle: with its area in place of pi R^2 the pressure falls by 8 pi nu Q / A^2.
"""

import math
import os
import sys
from pathlib import Path

import numpy as np
import Part

import MeshQuality as mq

sys.path.append(str(Path(__file__).resolve().parent))
import laminar

RADIUS, LENGTH = 5.0, 40.0  # mm
MEAN = 0.1  # m/s
GROWTH = float(os.environ.get("GROWTH", 0.3))
HALF = (0.5, 0.9)  # of the length, where the gradient of the pressure is measured


def parabola(squared):
    """m/s, for the square of the distance from the axis in mm^2."""
    return np.maximum(2.0 * MEAN * (1.0 - squared / RADIUS**2), 0.0)


def measured(mesh):
    """{what: value} of a run to its end."""
    at_inlet = laminar.centres_of_inlet(mesh)
    velocity = np.zeros_like(at_inlet)
    velocity[:, 2] = parabola((at_inlet[:, :2] ** 2).sum(axis=1))
    run, centres = laminar.solved(mesh, velocity), laminar.centres_of_cells(mesh)
    off = run["velocity"][:, 2] - parabola((centres[:, :2] ** 2).sum(axis=1))
    along = centres[:, 2] / LENGTH
    there = (along > HALF[0]) & (along < HALF[1])
    fall = -np.polyfit(centres[there, 2], run["pressure"][there], 1)[0]  # m^2/s^2 for each mm
    exact, of_polygon = (8.0 * math.pi * laminar.VISCOSITY * run["flux"] / area**2 * 1e9 for area in (math.pi * RADIUS**2, section(mesh)))
    return {**run, "pressure": fall / exact - 1.0, "of_polygon": fall / of_polygon - 1.0, "velocity": math.sqrt((off**2).mean()) / MEAN}


def section(mesh):
    """mm^2, of the inlet."""
    area = 0.0
    for rows, faces in ((mesh.boundary_triangles, mesh.triangle_face), (mesh.boundary_quadrilaterals, mesh.quadrilateral_face)):
        x, y = mesh.nodes[rows[faces == 2]][:, :, :2].transpose(2, 0, 1)
        area += np.abs((x * np.roll(y, -1, axis=1) - y * np.roll(x, -1, axis=1)).sum(axis=1)).sum() / 2.0
    return area


def main():
    region = Part.makeCylinder(RADIUS, LENGTH)
    for edge in map(float, os.environ.get("EDGES", "2.5 1.7 1.2").split()):
        mesh = mq.volume_mesh(region, layers=4, first_height=0.1 * edge, growth_rate=1.2, walls=["Face1"], max_edge=edge,
                              chord_height=edge**2 / 100.0, growth_inside=GROWTH, patches={"inlet": ["Face3"], "outlet": ["Face2"]}, patch_rest="pipe")
        found = measured(mesh)
        print(f"{edge:g} mm: {sum(mesh.report.elements.values()):,} cells, {found['steps']} steps{'' if found['converged'] else ', not converged'}, "
              f"{found['seconds']:.0f} s, residuals of the velocity {found['residuals'][0]:.1e}, of the pressure {found['residuals'][1]:.1e}; "
              f"pressure gradient {found['pressure']:+.2%}, of the polygon {found['of_polygon']:+.2%}, mass balance {found['mass']:.1e}, velocity off by {found['velocity']:.2%} (rms)", flush=True)


main()
