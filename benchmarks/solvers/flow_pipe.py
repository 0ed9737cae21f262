# SPDX-License-Identifier: LGPL-2.1-or-later
"""A laminar flow in a straight pipe by OpenFOAM's simpleFoam on meshes of volume_mesh, against Hagen and Poiseuille.

    freecadcmd -P <root>/Mod benchmarks/solvers/flow_pipe.py </dev/null
Needs simpleFoam (Debian: openfoam). EDGES="2.5 1.7 1.2": mm, of the meshes. A line each.

Pipe of radius 5 mm and length 40 mm, Reynolds number 100. The parabola of the developed flow enters, so that the flow is developed
all along, and the pressure falls by 8 nu L Q / (pi R^4) for a flux Q.
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
                          "functions {\n" + PROBE.format(name="p", patch="inlet", operation="areaAverage", field="p")
                          + PROBE.format(name="phi", patch="inlet", operation="sum", field="phi")
                          + PROBE.format(name="phi", patch="outlet", operation="sum", field="phi") + "}\n",
    "system/fvSchemes": HEAD.format("dictionary", "fvSchemes") + "ddtSchemes { default steadyState; }\ngradSchemes { default Gauss linear; }\n"
                        "divSchemes { default none; div(phi,U) bounded Gauss linear; "
                        "div((nuEff*dev2(T(grad(U))))) Gauss linear; }\nlaplacianSchemes { default Gauss linear corrected; }\n"
                        "interpolationSchemes { default linear; }\nsnGradSchemes { default corrected; }\n",
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
        inlet, outlet, pressure = (last_of(folder, name) for name in ("phi_inlet", "phi_outlet", "p_inlet"))
        with open(os.path.join(folder, str(steps), "U"), encoding="utf-8") as stream:
            inner = stream.read().split("boundaryField")[0]
        velocity = np.array(re.findall(r"^\(([^ ()]+) ([^ ()]+) ([^ ()]+)\)$", inner, re.M), dtype=float)
    centres = np.concatenate([mesh.nodes[rows].mean(axis=1) for _, rows in mesh.solid_blocks])
    off = velocity[:, 2] - parabola((centres[:, :2] ** 2).sum(axis=1))
    exact = 8.0 * VISCOSITY * LENGTH * -inlet / (math.pi * RADIUS**4) * 1e9
    return {"converged": "converged" in text, "steps": steps, "seconds": seconds, "residuals": residuals, "pressure": pressure / exact - 1.0,
            "mass": abs(inlet + outlet) / abs(inlet), "velocity": math.sqrt((off**2).mean()) / MEAN}


def main():
    region = Part.makeCylinder(RADIUS, LENGTH)
    for edge in map(float, os.environ.get("EDGES", "2.5 1.7 1.2").split()):
        mesh = mq.volume_mesh(region, layers=4, first_height=0.1 * edge, growth_rate=1.2, walls=["Face1"], max_edge=edge,
                              chord_height=edge**2 / 100.0, patches={"inlet": ["Face3"], "outlet": ["Face2"]}, patch_rest="pipe")
        found = solved(mesh)
        print(f"{edge:g} mm: {sum(mesh.report.elements.values()):,} cells, {found['steps']} steps{'' if found['converged'] else ', not converged'}, "
              f"{found['seconds']:.0f} s, residuals of the velocity {found['residuals'][0]:.1e}, of the pressure {found['residuals'][1]:.1e}; "
              f"pressure drop {found['pressure']:+.2%}, mass balance {found['mass']:.1e}, velocity off by {found['velocity']:.2%} (rms)", flush=True)


main()
