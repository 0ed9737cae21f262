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
import re
import subprocess
import tempfile
import time

import numpy as np
import Part

import MeshQuality as mq
from MeshQuality.core.volumes import polymesh

RADIUS, LENGTH = 5.0, 40.0  # mm
MEAN, VISCOSITY = 0.1, 1e-5  # m/s, m^2/s
STEPS = 1000
SCHEME, GROWTH = os.environ.get("SCHEME", "pointLinear"), float(os.environ.get("GROWTH", 0.3))
HALF = (0.5, 0.9)  # of the length, where the gradient of the pressure is measured
ENVIRONMENT = {**os.environ, "WM_PROJECT_DIR": os.environ.get("WM_PROJECT_DIR", "/usr/share/openfoam")}
HEAD = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"
PROBE = ("    {name}_{patch} {{ type surfaceFieldValue; libs (fieldFunctionObjects); regionType patch; name {patch}; operation {operation}; "
         "fields ({field}); writeFields no; log no; writeControl timeStep; writeInterval 1; }}\n")
TEXTS = {
    "constant/transportProperties": HEAD.format("dictionary", "transportProperties") + f"transportModel Newtonian; nu {VISCOSITY};\n",
    "constant/turbulenceProperties": HEAD.format("dictionary", "turbulenceProperties") + "simulationType laminar;\n",
    "0/p": HEAD.format("volScalarField", "p") + "dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;\nboundaryField {\n    inlet { type "
           "zeroGradient; }\n    outlet { type fixedValue; value uniform 0; }\n    pipe { type zeroGradient; }\n}\n",
    "system/controlDict": HEAD.format("dictionary", "controlDict") + f"application simpleFoam; startFrom startTime; startTime 0; stopAt endTime; "
                          f"endTime {STEPS}; deltaT 1; writeControl timeStep; writeInterval {STEPS}; writeFormat ascii; writePrecision 10;\n"
                          "functions {\n" + PROBE.format(name="phi", patch="inlet", operation="sum", field="phi")
                          + PROBE.format(name="phi", patch="outlet", operation="sum", field="phi") + "}\n",
    "system/fvSchemes": HEAD.format("dictionary", "fvSchemes") + f"""ddtSchemes {{ default steadyState; }}
gradSchemes {{ default Gauss {SCHEME}; }}
divSchemes {{ default none; div(phi,U) bounded Gauss {SCHEME}; div((nuEff*dev2(T(grad(U))))) Gauss linear; }}
laplacianSchemes {{ default Gauss linear corrected; }}
interpolationSchemes {{ default linear; }}
snGradSchemes {{ default corrected; }}
""",
    "system/fvSolution": HEAD.format("dictionary", "fvSolution") + "solvers {\n    p { solver GAMG; smoother GaussSeidel; tolerance 1e-12; relTol "
                         "0.05; }\n    U { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-14; relTol 0.1; }\n}\n"
                         "SIMPLE { consistent yes; nNonOrthogonalCorrectors 1; residualControl { p 1e-6; U 1e-7; } }\n"
                         "relaxationFactors { equations { U 0.9; } }\n",
}


def parabola(squared):
    """m/s, for the square of the distance from the axis in mm^2."""
    return np.maximum(2.0 * MEAN * (1.0 - squared / RADIUS**2), 0.0)


def write_velocity(mesh, folder):
    """The file 0/U: at the inlet the parabola, at the centres of its faces."""
    rings, _, neighbour, patch = polymesh.faces_of(mesh)
    rings = rings[len(neighbour):][patch == mesh.patch_names.index("inlet")]
    there = rings >= 0
    centres = np.where(there[:, :, None], mesh.nodes[rings], 0.0).sum(axis=1) / there.sum(axis=1)[:, None]
    values = "\n".join(f"(0 0 {value!r})" for value in parabola((centres[:, :2] ** 2).sum(axis=1)).tolist())
    with open(os.path.join(folder, "0", "U"), "w", encoding="utf-8") as stream:
        stream.write(HEAD.format("volVectorField", "U") + f"dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 {MEAN});\nboundaryField {{\n"
                     f"    inlet {{ type fixedValue; value nonuniform List<vector> {len(rings)} (\n{values}\n); }}\n"
                     "    outlet { type zeroGradient; }\n    pipe { type noSlip; }\n}\n")


def last_of(folder, name):
    """The last value of a probe."""
    with open(os.path.join(folder, "postProcessing", name, "0", "surfaceFieldValue.dat"), encoding="utf-8") as stream:
        return float(stream.read().split()[-1])


def solved(mesh):
    """{what: value} of a run to its end."""
    with tempfile.TemporaryDirectory() as folder:
        mesh.write(folder, format="openfoam", binary=True)
        os.makedirs(os.path.join(folder, "0"))
        for path, text in TEXTS.items():
            with open(os.path.join(folder, path), "w", encoding="utf-8") as stream:
                stream.write(text)
        write_velocity(mesh, folder)
        start = time.time()
        said = subprocess.run(["simpleFoam"], cwd=folder, env=ENVIRONMENT, capture_output=True, text=True, timeout=3000)
        seconds, text = time.time() - start, said.stdout
        if said.returncode:
            raise RuntimeError(text[-2000:] + said.stderr)
        steps = int(re.findall(r"^Time = (\d+)", text, re.M)[-1])
        residuals = [float(re.findall(rf"Solving for {name}, Initial residual = ([\d.e+-]+)", text)[-1]) for name in ("Uz", "p")]
        inlet, outlet = (last_of(folder, name) for name in ("phi_inlet", "phi_outlet"))
        velocity = np.array(re.findall(r"^\(([^ ()]+) ([^ ()]+) ([^ ()]+)\)$", inner_field(folder, steps, "U"), re.M), dtype=float)
        pressures = np.array(re.findall(r"^(-?[\d.][\d.e+-]*)$", inner_field(folder, steps, "p").partition("(")[2], re.M), dtype=float)
    centres = np.concatenate([mesh.nodes[rows].mean(axis=1) for _, rows in mesh.solid_blocks])
    off = velocity[:, 2] - parabola((centres[:, :2] ** 2).sum(axis=1))
    along = centres[:, 2] / LENGTH
    there = (along > HALF[0]) & (along < HALF[1])
    fall = -np.polyfit(centres[there, 2], pressures[there], 1)[0]  # m^2/s^2 for each mm
    exact, of_polygon = (8.0 * math.pi * VISCOSITY * -inlet / area**2 * 1e9 for area in (math.pi * RADIUS**2, section(mesh)))
    return {"converged": "converged" in text, "steps": steps, "seconds": seconds, "residuals": residuals, "pressure": fall / exact - 1.0,
            "of_polygon": fall / of_polygon - 1.0, "mass": abs(inlet + outlet) / abs(inlet), "velocity": math.sqrt((off**2).mean()) / MEAN}


def inner_field(folder, steps, name):
    """The text of the values in cells."""
    with open(os.path.join(folder, str(steps), name), encoding="utf-8") as stream:
        return stream.read().split("boundaryField")[0].partition("nonuniform")[2]


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
        found = solved(mesh)
        print(f"{edge:g} mm: {sum(mesh.report.elements.values()):,} cells, {found['steps']} steps{'' if found['converged'] else ', not converged'}, "
              f"{found['seconds']:.0f} s, residuals of the velocity {found['residuals'][0]:.1e}, of the pressure {found['residuals'][1]:.1e}; "
              f"pressure gradient {found['pressure']:+.2%}, of the polygon {found['of_polygon']:+.2%}, mass balance {found['mass']:.1e}, velocity off by {found['velocity']:.2%} (rms)", flush=True)


main()
