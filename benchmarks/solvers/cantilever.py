# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cantilevers for FreeCAD's FEM workbench, solved by CalculiX as its window does. Runs inside FreeCAD.

The beam is a bar with rounded edges, clamped at its face x = 0, whose deflection beam theory knows. The bracket is a
shaft that a curved fillet joins to a plate.
"""

import time

import FreeCAD
import Part

LENGTH, WIDTH, HEIGHT, RADIUS = 100.0, 20.0, 10.0, 3.0  # mm
YOUNG = 210000.0  # MPa
# With 0.3 the clamp would stiffen the beam by 1.4 %, which beam theory does not know.
POISSON_RATIO = 0.0
FORCE, PRESSURE = 100.0, 0.1  # N downwards at the free end; MPa on the top
BORED_FORCE = 1000.0  # N
BORED_STRESS = 6.0 * BORED_FORCE * LENGTH / (WIDTH * HEIGHT**2)  # MPa
SHEAR = 10.0 * (1.0 + POISSON_RATIO) / (12.0 + 11.0 * POISSON_RATIO)  # coefficient of Cowper for a rectangle


def beam():
    """The bar along x, its longer edges rounded."""
    box = Part.makeBox(LENGTH, WIDTH, HEIGHT)
    along = [edge for edge in box.Edges if abs(edge.Vertexes[0].X - edge.Vertexes[1].X) > 1.0]
    return box.makeFillet(RADIUS, along)


def bracket():
    """A shaft of 10 mm along x on a plate, with a fillet of 4 mm between the two."""
    x = FreeCAD.Vector(1, 0, 0)
    plate = Part.makeBox(10, 40, 40, FreeCAD.Vector(0, -20, -20))
    whole = plate.fuse(Part.makeCylinder(5, 60, FreeCAD.Vector(10, 0, 0), x))
    root = [edge for edge in whole.Edges if isinstance(edge.Curve, Part.Circle)
            and abs(edge.CenterOfMass.x - 10.0) < 1e-6]
    return whole.makeFillet(4.0, root)


def bored():
    """The sharp bar along x, with a bore of 8 mm at its end: beam theory knows the stress where it is clamped, BORED_STRESS."""
    return Part.makeBox(LENGTH, WIDTH, HEIGHT).cut(Part.makeCylinder(4, HEIGHT, FreeCAD.Vector(90, 10, 0)))


def angle_bracket():
    """Two plates of 6 mm at a right angle, with a fillet of 5 mm in between; the lower one has two bores."""
    whole = Part.makeBox(60, 40, 6).fuse(Part.makeBox(6, 40, 50)).removeSplitter()
    root = [edge for edge in whole.Edges if (edge.CenterOfMass - FreeCAD.Vector(6, 20, 6)).Length < 1e-6]
    whole = whole.makeFillet(5, root)
    for y in (10, 30):
        whole = whole.cut(Part.makeCylinder(3.5, 10, FreeCAD.Vector(45, y, -1)))
    return whole


def deflections():
    """{"force", "pressure": deflection of the beam's free end in mm}, by Timoshenko's theory."""
    section = next(face for face in beam().Faces if abs(face.CenterOfMass.x) < 1e-6)
    stiffness, shear = YOUNG * section.MatrixOfInertia.A22, \
        SHEAR * section.Area * YOUNG / (2.0 * (1.0 + POISSON_RATIO))
    load = PRESSURE * (WIDTH - 2.0 * RADIUS)
    return {"force": FORCE * LENGTH**3 / (3.0 * stiffness) + FORCE * LENGTH / shear,
            "pressure": load * LENGTH**4 / (8.0 * stiffness) + load * LENGTH**2 / (2.0 * shear)}


def face_at(shape, axis, value):
    """The name of the plane face that lies farthest along an axis ("x" or "z"), or least, by the sign of `value`."""
    ends = {f"Face{i + 1}": value * getattr(face.CenterOfMass, axis) for i, face in enumerate(shape.Faces)
            if isinstance(face.Surface, Part.Plane)}
    return max(ends, key=ends.get)


def add_analysis(part, load, clamped=("x", -1)):
    """An analysis of a part that is clamped at its plane face of least x, or at another `face_at`, without a mesh; `load`:
    "force", "pressure" or "weight".
    """
    import ObjectsFem

    document, shape = part.Document, part.Shape
    analysis = ObjectsFem.makeAnalysis(document)
    # The name since FreeCAD 1.0, and the one before.
    make_solver = getattr(ObjectsFem, "makeSolverCalculiXCcxTools", None) or ObjectsFem.makeSolverCalculixCcxTools
    solver = make_solver(document)
    material = ObjectsFem.makeMaterialSolid(document)
    material.Material = {"Name": "Steel", "YoungsModulus": f"{YOUNG} MPa", "PoissonRatio": str(POISSON_RATIO),
                         "Density": "7900 kg/m^3"}
    fixed = ObjectsFem.makeConstraintFixed(document)
    fixed.References = [(part, face_at(shape, *clamped))]
    for obj in (solver, material, fixed, _load(part, load)):
        analysis.addObject(obj)
    return analysis


def set_load(constraint, name, value, unit):
    """A load in a unit: a number until FreeCAD 1.0, a quantity since, whose plain numbers are of FreeCAD's own units."""
    plain = constraint.getTypeIdOfProperty(name) == "App::PropertyFloat"
    setattr(constraint, name, value if plain else FreeCAD.Units.Quantity(f"{value} {unit}"))


def _load(part, load):
    import ObjectsFem

    if load == "weight":
        return ObjectsFem.makeConstraintSelfWeight(part.Document)
    top = face_at(part.Shape, "z", 1)
    if load == "pressure":
        pressure = ObjectsFem.makeConstraintPressure(part.Document)
        pressure.References = [(part, top)]
        set_load(pressure, "Pressure", PRESSURE, "MPa")
        return pressure
    force = ObjectsFem.makeConstraintForce(part.Document)
    force.References = [(part, face_at(part.Shape, "x", 1))]
    set_load(force, "Force", FORCE, "N")
    force.Direction, force.Reversed = (part, [top]), True  # against the normal of the top
    return force


def solve(analysis, folder):
    """The result object of CalculiX, run in this folder. Raises RuntimeError with what is missing or what it said."""
    from femtools import ccxtools

    solver = next(obj for obj in analysis.Group if "Solver" in obj.Name)
    tools = ccxtools.FemToolsCcx(analysis, solver)
    tools.update_objects()
    tools.setup_working_dir(folder)
    missing = tools.check_prerequisites()
    if missing:
        raise RuntimeError(missing)
    tools.write_inp_file()
    if tools.ccx_run() != 0:
        raise RuntimeError(tools.ccx_stdout[-1000:])
    tools.purge_results()
    tools.load_results()
    return next(obj for obj in analysis.Group if obj.isDerivedFrom("Fem::FemResultObject"))


def deflection(result, mesh, face):
    """Mean displacement downwards of the nodes on a face, mm."""
    nodes = set(mesh.getNodesByFace(face))
    moved = [-vector.z for number, vector in zip(result.NodeNumbers, result.DisplacementVectors) if number in nodes]
    return sum(moved) / len(moved)


def largest_stress(name, folder, **values):
    """{"tetrahedra", "expected", "edge", "stress", "solver"} of a FEM mesh of the part with these options; edge in mm, stress
    in MPa.
    """
    import MeshQuality as mq
    from MeshQuality import options
    from MeshQuality.core.fem import fem_size

    make, clamped, end = {"cantilever": (bored, ("x", -1), ("x", 1)),
                          "bracket": (angle_bracket, ("z", -1), ("z", 1)),
                          "shaft": (bracket, ("x", -1), ("x", 1))}[name]
    document = FreeCAD.newDocument()
    try:
        part = document.addObject("Part::Feature", "Part")
        part.Shape = make()
        document.recompute()
        analysis = add_analysis(part, "force", clamped)
        force = next(obj for obj in analysis.Group if obj.isDerivedFrom("Fem::ConstraintForce"))
        set_load(force, "Force", BORED_FORCE, "N")
        force.References = [(part, face_at(part.Shape, *end))]
        along = "x" if name == "bracket" else "z"
        force.Direction = (part, [face_at(part.Shape, along, 1)])
        mesh = mq.add_fem_mesh(part, analysis=analysis, **values).FemMesh
        asked = options.check(options.fem.FEM, values)
        before = time.perf_counter()
        stress = max(solve(analysis, folder).vonMises)
        return {"tetrahedra": mesh.VolumeCount, "expected": fem_size.expected_elements(part.Shape, asked),
                "edge": fem_size.longest_edge(part.Shape, asked)[0], "stress": stress,
                "solver": time.perf_counter() - before}
    finally:
        FreeCAD.closeActiveTransaction()  # opened by what reads the results
        FreeCAD.closeDocument(document.Name)
