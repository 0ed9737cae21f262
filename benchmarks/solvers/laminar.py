# SPDX-License-Identifier: LGPL-2.1-or-later
"""Laminar steady flows by OpenFOAM's simpleFoam on meshes of volume_mesh with the patches inlet, outlet and pipe."""

import os
import re
import subprocess
import tempfile
import time

import numpy as np

from MeshQuality.core.volumes import polymesh

VISCOSITY = 1e-5  # m^2/s
STEPS = 1000
SCHEME = os.environ.get("SCHEME", "pointLinear")
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


def centres_of_inlet(mesh):
    """float64 (F, 3), mm: the middles of the faces of the inlet, as polyMesh has them."""
    rings, _, neighbour, patch = polymesh.faces_of(mesh)
    rings = rings[len(neighbour):][patch == mesh.patch_names.index("inlet")]
    there = rings >= 0
    return np.where(there[:, :, None], mesh.nodes[rings], 0.0).sum(axis=1) / there.sum(axis=1)[:, None]


def centres_of_cells(mesh):
    """float64 (E, 3), mm: the means of their corners."""
    return np.concatenate([mesh.nodes[rows].mean(axis=1) for _, rows in mesh.solid_blocks])


def solved(mesh, inlet_velocity):
    """A run to its end: {what: value}, with the velocity, float64 (E, 3), m/s, and the pressure, float64 (E,), m^2/s^2, in the cells.

    inlet_velocity  float64 (F, 3), m/s, in the faces of the inlet
    """
    with tempfile.TemporaryDirectory() as folder:
        mesh.write(folder, format="openfoam", binary=True)
        os.makedirs(os.path.join(folder, "0"))
        for path, text in {**TEXTS, "0/U": velocity_text(inlet_velocity)}.items():
            with open(os.path.join(folder, path), "w", encoding="utf-8") as stream:
                stream.write(text)
        start = time.time()
        said = subprocess.run(["simpleFoam"], cwd=folder, env=ENVIRONMENT, capture_output=True, text=True, timeout=3000)
        seconds, text = time.time() - start, said.stdout
        if said.returncode:
            raise RuntimeError(text[-2000:] + said.stderr)
        steps = int(re.findall(r"^Time = (\d+)", text, re.M)[-1])
        residuals = [float(re.findall(rf"Solving for {name}, Initial residual = ([\d.e+-]+)", text)[-1]) for name in ("U[xyz]", "p")]
        inlet, outlet = (last_of(folder, name) for name in ("phi_inlet", "phi_outlet"))
        velocity = np.array(re.findall(r"^\(([^ ()]+) ([^ ()]+) ([^ ()]+)\)$", inner_field(folder, steps, "U"), re.M), dtype=float)
        pressure = np.array(re.findall(r"^(-?[\d.][\d.e+-]*)$", inner_field(folder, steps, "p").partition("(")[2], re.M), dtype=float)
    return {"converged": "converged" in text, "steps": steps, "seconds": seconds, "residuals": residuals, "flux": -inlet,
            "mass": abs(inlet + outlet) / abs(inlet), "velocity": velocity, "pressure": pressure}


def velocity_text(inlet_velocity):
    """The file 0/U."""
    values = "\n".join(f"({x!r} {y!r} {z!r})" for x, y, z in inlet_velocity.tolist())
    return (HEAD.format("volVectorField", "U") + "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);\nboundaryField {\n"
            f"    inlet {{ type fixedValue; value nonuniform List<vector> {len(inlet_velocity)} (\n{values}\n); }}\n"
            "    outlet { type zeroGradient; }\n    pipe { type noSlip; }\n}\n")


def last_of(folder, name):
    """The last value of a probe."""
    with open(os.path.join(folder, "postProcessing", name, "0", "surfaceFieldValue.dat"), encoding="utf-8") as stream:
        return float(stream.read().split()[-1])


def inner_field(folder, steps, name):
    """The text of the values in cells."""
    with open(os.path.join(folder, str(steps), name), encoding="utf-8") as stream:
        return stream.read().split("boundaryField")[0].partition("nonuniform")[2]
