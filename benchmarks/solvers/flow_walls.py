# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flows by OpenFOAM's simpleFoam on meshes of volume_mesh with layers: y+ on a flat plate, and a valve.

    freecadcmd -P <root>/Mod benchmarks/solvers/flow_walls.py </dev/null
Needs simpleFoam (Debian: openfoam). CASES="plate valve": which ones; Y_PLUS="1 40": of the plate. A line each.

Plate: 1 m long, in air at 10 m/s, by k-omega SST. The first layer is as high as first_height says for a y+ at the end of the plate; OpenFOAM's
y+ there, a mean of the faces between 0.8 and 0.95 of the length, is compared with that, and the friction with that of first_height.
Valve: an angle valve with a disc on a stem, 4 mm above its seat, laminar at a Reynolds number of 100 in the pipe. Residuals and the balance of mass count.
"""

import os
import re
import subprocess
import tempfile
import time

import FreeCAD
import numpy as np
import Part

import MeshQuality as mq

ENVIRONMENT = {**os.environ, "WM_PROJECT_DIR": os.environ.get("WM_PROJECT_DIR", "/usr/share/openfoam")}
HEAD = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"
STEPS = 1000
LENGTH, SPEED, AIR = 1000.0, 10.0, 1.516e-5  # mm, m/s, m^2/s
THERE = (0.8, 0.95)  # of the length of the plate, where y+ is measured
KINETIC, OMEGA = 0.015, 100.0  # m^2/s^2 (1 % of the speed), 1/s
BORE, MEAN, VISCOSITY = 10.0, 0.05, 1e-5  # mm, m/s, m^2/s

SCHEMES = HEAD.format("dictionary", "fvSchemes") + """ddtSchemes { default steadyState; }
gradSchemes { default Gauss pointLinear; limited cellLimited Gauss pointLinear 1; grad(U) $limited; grad(k) $limited; grad(omega) $limited; }
divSchemes { default none; div(phi,U) bounded Gauss linearUpwind grad(U); div(phi,k) bounded Gauss upwind; div(phi,omega) bounded Gauss upwind;
    div((nuEff*dev2(T(grad(U))))) Gauss linear; }
laplacianSchemes { default Gauss linear limited corrected 0.5; }
interpolationSchemes { default linear; }
snGradSchemes { default limited corrected 0.5; }
wallDist { method meshWave; }
"""
SOLUTION = HEAD.format("dictionary", "fvSolution") + """solvers {
    p { solver GAMG; smoother GaussSeidel; tolerance 1e-10; relTol 0.05; }
    "(U|k|omega)" { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-12; relTol 0.1; } }
SIMPLE { consistent yes; nNonOrthogonalCorrectors 1; residualControl { p 1e-5; U 1e-6; "(k|omega)" 1e-5; } }
relaxationFactors { equations { U 0.9; k 0.7; omega 0.7; } }
"""
PROBE = ("    {patch} {{ type surfaceFieldValue; libs (fieldFunctionObjects); regionType patch; name {patch}; operation sum; fields (phi); "
         "writeFields no; log no; writeControl timeStep; writeInterval 1; }}\n")
Y_PLUS = "    yPlus { type yPlus; libs (fieldFunctionObjects); writeControl onEnd; }\n"


def control(functions):
    return HEAD.format("dictionary", "controlDict") + f"application simpleFoam; startFrom startTime; startTime 0; stopAt endTime; endTime {STEPS}; " \
        f"deltaT 1; writeControl timeStep; writeInterval {STEPS}; writeFormat ascii; writePrecision 10;\nfunctions {{\n{functions}}}\n"


def field(name, kind, dimensions, value, patches):
    """The text of a file in 0; patches: {name: what it says}."""
    boundary = "\n".join(f"    {patch} {{ {said} }}" for patch, said in patches.items())
    return HEAD.format(kind, name) + f"dimensions [{dimensions}]; internalField uniform {value};\nboundaryField {{\n{boundary}\n}}\n"


def solved(mesh, texts):
    """({patch: flux}, text, seconds, y+ of the faces of the patch plate or None) of a run to its end."""
    with tempfile.TemporaryDirectory() as folder:
        mesh.write(folder, format="openfoam", binary=True)
        os.makedirs(os.path.join(folder, "0"))
        for path, text in texts.items():
            with open(os.path.join(folder, path), "w", encoding="utf-8") as stream:
                stream.write(text)
        start = time.time()
        said = subprocess.run(["simpleFoam"], cwd=folder, env=ENVIRONMENT, capture_output=True, text=True, timeout=3000)
        if said.returncode:
            raise RuntimeError(said.stdout[-2000:] + said.stderr)
        seconds, steps = time.time() - start, re.findall(r"^Time = (\d+)", said.stdout, re.M)[-1]
        fluxes = {}
        for patch in ("inlet", "outlet"):
            with open(os.path.join(folder, "postProcessing", patch, "0", "surfaceFieldValue.dat"), encoding="utf-8") as stream:
                fluxes[patch] = float(stream.read().split()[-1])
        y_plus, path = None, os.path.join(folder, steps, "yPlus")
        if os.path.exists(path):
            with open(path, encoding="utf-8") as stream:
                part = re.search(r"\n\s*plate\s*\{.*?\(\n(.*?)\n\)", stream.read(), re.S)
            y_plus = np.array(part.group(1).split(), dtype=float)
    return fluxes, said.stdout, seconds, y_plus


def residuals(text):
    names = ("Ux", "p", "k", "omega")
    found = {name: re.findall(rf"Solving for {name}, Initial residual = ([\d.e+-]+)", text) for name in names}
    return ", ".join(f"{name} {float(values[-1]):.1e}" for name, values in found.items() if values)


def faces_of(shape, wanted):
    """The names of the faces for whose centre a condition holds."""
    return [f"Face{i}" for i, face in enumerate(shape.Faces, 1) if wanted(face.CenterOfMass, face)]


def plate(asked):
    """Prints a line."""
    height, thick = 150.0, 20.0
    region = Part.makeBox(LENGTH, height, thick)
    names = {"inlet": faces_of(region, lambda at, _: at.x < 1e-6), "outlet": faces_of(region, lambda at, _: at.x > LENGTH - 1e-6),
             "plate": faces_of(region, lambda at, _: at.y < 1e-6)}
    first = mq.first_height(SPEED, LENGTH, AIR, y_plus=asked)
    growth, total = 1.25, 25.0  # mm, about the boundary layer
    layers = max(3, int(np.ceil(np.log(1.0 + total * (growth - 1.0) / first) / np.log(growth))))
    mesh = mq.volume_mesh(region, layers=layers, first_height=float(first), growth_rate=growth, walls=names["plate"], max_edge=14.0,
                          patches=names, patch_rest="free")
    wall = {1: ("type fixedValue; value uniform 1e-12;", "type nutLowReWallFunction; value uniform 0;")}.get(
        asked < 5, ("type kqRWallFunction; value uniform 0.015;", "type nutkWallFunction; value uniform 0;"))
    free = "type slip;"
    flowing = {"outlet": "type zeroGradient;", "free": free}
    texts = {
        "constant/transportProperties": HEAD.format("dictionary", "transportProperties") + f"transportModel Newtonian; nu {AIR};\n",
        "constant/turbulenceProperties": HEAD.format("dictionary", "turbulenceProperties")
        + "simulationType RAS; RAS { RASModel kOmegaSST; turbulence on; printCoeffs off; }\n",
        "system/controlDict": control(PROBE.format(patch="inlet") + PROBE.format(patch="outlet") + Y_PLUS),
        "system/fvSchemes": SCHEMES, "system/fvSolution": SOLUTION,
        "0/U": field("U", "volVectorField", "0 1 -1 0 0 0 0", f"({SPEED} 0 0)",
                     {"inlet": f"type fixedValue; value uniform ({SPEED} 0 0);", "plate": "type noSlip;", **flowing}),
        "0/p": field("p", "volScalarField", "0 2 -2 0 0 0 0", 0,
                     {"inlet": "type zeroGradient;", "plate": "type zeroGradient;", "outlet": "type fixedValue; value uniform 0;", "free": free}),
        "0/k": field("k", "volScalarField", "0 2 -2 0 0 0 0", KINETIC,
                     {"inlet": f"type fixedValue; value uniform {KINETIC};", "plate": wall[0], **flowing}),
        "0/omega": field("omega", "volScalarField", "0 0 -1 0 0 0 0", OMEGA,
                         {"inlet": f"type fixedValue; value uniform {OMEGA};", "plate": f"type omegaWallFunction; value uniform {OMEGA};", **flowing}),
        "0/nut": field("nut", "volScalarField", "0 2 -1 0 0 0 0", 0,
                       {"inlet": "type calculated; value uniform 0;", "outlet": "type calculated; value uniform 0;", "plate": wall[1],
                        "free": "type calculated; value uniform 0;"}),
    }
    fluxes, text, seconds, y_plus = solved(mesh, texts)
    along = centres_of_patch(mesh, "plate")[:, 0] / LENGTH
    there = y_plus[(along > THERE[0]) & (along < THERE[1])]
    print(f"plate, y+ {asked:g}: {sum(mesh.report.elements.values()):,} cells, {layers} layers from {float(first):.3g} mm, {count(text)}, {seconds:.0f} s, "
          f"residuals {residuals(text)}; y+ {there.mean():.3g} ({there.min():.3g} to {there.max():.3g}), {there.mean() / asked - 1.0:+.0%} of what was "
          f"asked for, mass balance {abs(sum(fluxes.values())) / abs(fluxes['inlet']):.1e}", flush=True)


def centres_of_patch(mesh, name):
    """float64 (F, 3): the middles of its faces, in the order of OpenFOAM's."""
    from MeshQuality.core.volumes import polymesh

    rings, _, neighbour, patch = polymesh.faces_of(mesh)
    rings = rings[len(neighbour):][patch == mesh.patch_names.index(name)]
    there = rings >= 0
    return np.where(there[:, :, None], mesh.nodes[rings], 0.0).sum(axis=1) / there.sum(axis=1)[:, None]


def valve():
    """Prints a line."""
    up, side = FreeCAD.Vector(0, 0, 1), FreeCAD.Vector(1, 0, 0)
    zero = FreeCAD.Vector()
    region = Part.makeCylinder(BORE, 60.0, FreeCAD.Vector(0, 0, -60), up).fuse(
        [Part.makeCylinder(18.0, 30.0, zero, up), Part.makeCylinder(BORE, 70.0, FreeCAD.Vector(0, 0, 15), side)])
    plug = Part.makeCylinder(13.0, 5.0, FreeCAD.Vector(0, 0, 4), up).fuse(Part.makeCylinder(3.0, 40.0, FreeCAD.Vector(0, 0, 4), up))
    region = region.cut(plug).removeSplitter()
    names = {"inlet": faces_of(region, lambda at, _: at.z < -59.9), "outlet": faces_of(region, lambda at, _: at.x > 69.9)}
    walls = [f"Face{i}" for i in range(1, len(region.Faces) + 1) if f"Face{i}" not in names["inlet"] + names["outlet"]]
    mesh = mq.volume_mesh(region.Solids[0], layers=4, first_height=0.15, growth_rate=1.25, walls=walls, max_edge=4.0, patches=names, patch_rest="wall")
    still = "type zeroGradient;"
    texts = {
        "constant/transportProperties": HEAD.format("dictionary", "transportProperties") + f"transportModel Newtonian; nu {VISCOSITY};\n",
        "constant/turbulenceProperties": HEAD.format("dictionary", "turbulenceProperties") + "simulationType laminar;\n",
        "system/controlDict": control(PROBE.format(patch="inlet") + PROBE.format(patch="outlet")),
        "system/fvSchemes": SCHEMES, "system/fvSolution": SOLUTION,
        "0/U": field("U", "volVectorField", "0 1 -1 0 0 0 0", "(0 0 0)",
                     {"inlet": f"type fixedValue; value uniform (0 0 {MEAN});", "outlet": still, "wall": "type noSlip;"}),
        "0/p": field("p", "volScalarField", "0 2 -2 0 0 0 0", 0, {"inlet": still, "outlet": "type fixedValue; value uniform 0;", "wall": still}),
    }
    fluxes, text, seconds, _ = solved(mesh, texts)
    print(f"valve: {len(region.Faces)} faces, {sum(mesh.report.elements.values()):,} cells, {count(text)}, {seconds:.0f} s, residuals {residuals(text)}, "
          f"mass balance {abs(sum(fluxes.values())) / abs(fluxes['inlet']):.1e}, {mesh.report.covered:.1%} of the walls covered", flush=True)


def count(text):
    steps = re.findall(r"^Time = (\d+)", text, re.M)[-1]
    return f"{steps} steps{'' if 'converged' in text else ', not converged'}"


def main():
    cases = os.environ.get("CASES", "plate valve").split()
    for asked in map(float, os.environ.get("Y_PLUS", "1 40").split()) if "plate" in cases else ():
        plate(asked)
    if "valve" in cases:
        valve()


main()
