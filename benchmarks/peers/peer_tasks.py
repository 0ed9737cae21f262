# SPDX-License-Identifier: LGPL-2.1-or-later
"""What peers.py has everybody do: cases, who takes part with which settings, and the columns of the tables."""

import json
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

import peer_figures

CGAL_EDGES = 15.0  # its edges, for each of the distance of its facets
LEVEL = 1e-3  # of the largest dimension: the distance to keep
OPERATIONS = ("union", "intersection", "difference")
SURFACE_PARTS = ("netgen_screw.step", "gmsh_t20_data.step", "Pump_TopCover.brep", "part.step", "linkrods.step",
                 "nist_ctc_01_asme1_rd.stp", "bottle.brep", "CrankArm.brep")
BOOLEAN_PAIRS = (("needles84_a", "needles84_b"), ("torusA", "torusRot"), ("bunny70k", "dragon58k"), ("twin_a", "twin_b"))
GIVEN_PARTS = ("netgen_screw.step", "gmsh_t20_data.step", "linkrods.step", "part.step")  # to simplify and to fill
SOLIDS = ("elbow", "screw", "drilled", "linkrods", "filletbox", "t20")  # to curve, of curve_models
WRAPPED = ("as1-oc-214.stp", "3DBenchy.obj", "dm1-id-214.stp", "occBSplCone.brep", "decimated-knight.off", "chair_model.obj", "dlr_f6.brep",
           "plane_holes.obj")
OFFSETS = (0.02, -0.02)  # of the largest dimension
GAP, WRAP_TOLERANCE = 0.03, 0.01  # of the largest dimension
GIVEN_FINER = 0.3  # of the target: the distance of meshes to simplify from their part


@dataclass(frozen=True)
class Column:
    """A heading, the key of a row's figure, how it is written, and whether more (1) or less (-1) of it is better."""

    heading: str
    key: str
    written: str = ""
    better: int = 0


@dataclass(frozen=True)
class Task:
    """One table. `settings` has the grids, coarse to fine, of those who are not asked for a distance; multiples of
    the target where `relative` names them. `said` explains the settings and the columns, `about` how often they were taken
    where that is not by medians. `cgal` is the source of CGAL's program, less its suffix, and the words that it gets;
    `outside` says that other programs may take part.
    """

    meshers: tuple
    columns: tuple
    cases: Callable
    figures: Callable
    said: str
    settings: dict = None
    relative: tuple = ()
    searched: Callable = None
    clean: Callable = None
    cgal: tuple = None
    outside: bool = False
    about: str = ""
    suffix: str = ".off"


def grid(first, ratio=math.sqrt(2.0), count=14):
    return [first * ratio**k for k in range(count)]


def made_parts():
    """(name, shape) of parts that FreeCAD makes."""
    import Part
    from FreeCAD import Vector

    plate = Part.makeBox(80, 50, 8)
    for x in range(10, 80, 15):
        for y in range(10, 50, 15):
            plate = plate.cut(Part.makeCylinder(3, 20, Vector(x, y, -1)))
    flange = Part.makeCylinder(30, 8).fuse(Part.makeCylinder(12, 30)).cut(Part.makeCylinder(8, 60, Vector(0, 0, -1)))
    for k in range(6):
        turn = math.radians(60 * k)
        flange = flange.cut(Part.makeCylinder(2.5, 20, Vector(22 * math.cos(turn), 22 * math.sin(turn), -1)))
    rounded = Part.makeBox(30, 20, 10)
    return [("plate with 15 holes", plate), ("flange", flange), ("rounded box", rounded.makeFillet(3.0, rounded.Edges)),
            ("ball", Part.makeSphere(10))]


def by_turns(first, second):
    """Both lists in one, so that a few have some of both."""
    both = [item for pair in zip(first, second) for item in pair]
    return both + first[len(second):] + second[len(first):]


def parts(arguments, names, folder):
    """(name, shape, BREP file, largest dimension) of parts from files and of parts that are made."""
    import numpy as np
    import Part

    paths = [Path(arguments.data) / "cad" / name for name in names]
    for path in (path for path in paths if not path.exists()):
        print(f"{path.name} is skipped: it is not there", flush=True)
    read = [(path.stem, Part.read(str(path))) for path in paths if path.exists()]
    for name, shape in by_turns(read, made_parts())[:arguments.most or None]:
        brep = folder / f"{name.replace(' ', '_')}.brep"
        shape.exportBrep(str(brep))
        fine = np.array(shape.copy().tessellate(1e-3 * shape.BoundBox.DiagonalLength)[0])
        yield name, shape, str(brep), float(np.ptp(fine, axis=0).max())  # the boxes of splines are too large


def surface_cases(arguments, folder):
    """With the part as STEP for outside programs, and finely triangulated by BRepMesh for CGAL."""
    for name, shape, brep, size in parts(arguments, SURFACE_PARTS, folder):
        step, fine = (str(Path(brep).with_suffix(suffix)) for suffix in (".step", ".fine.off"))
        if arguments.program:
            shape.exportStep(step)
        by_mesher("surface", "BRepMesh", brep, 0.1 * LEVEL * size, fine)
        yield {"name": name, "input": brep, "step": step, "fine": fine, "target": LEVEL * size}


def by_mesher(made, mesher, source, setting, out):
    """A mesh that one of FreeCAD's meshers makes for others to work on; in a process of its own."""
    from child import in_child
    import own_runs

    return in_child(lambda: own_runs.run({"task": made, "mesher": mesher, "input": source, "setting": setting, "out": str(out)}))


def simplify_cases(arguments, folder):
    """Closed meshes of parts by MeshQuality, three times as close to the part as the simplified ones may be to them."""
    for name, _shape, brep, size in parts(arguments, GIVEN_PARTS, folder):
        off = Path(brep).with_suffix(".given.off")
        by_mesher("surface", "MeshQuality", brep, GIVEN_FINER * LEVEL * size, off)
        yield {"name": name, "input": str(off), "shape": brep, "target": LEVEL * size}


def fill_cases(arguments, folder):
    """Closed surfaces of solids by MeshQuality at 25 degrees, the same for all."""
    for name, shape, brep, size in parts(arguments, GIVEN_PARTS, folder):
        off = Path(brep).with_suffix(".given.off")
        if len(shape.Solids) == 1 and "failed" not in by_mesher("surface", "MeshQuality", brep, LEVEL * size, off):
            yield {"name": name, "input": str(off), "target": None}


def offset_cases(arguments, folder):
    """Each solid twice, outward and inward: a closed mesh by MeshQuality, five times as close to it as the offset may be."""
    for name, shape, brep, size in parts(arguments, GIVEN_PARTS, folder):
        off = Path(brep).with_suffix(".given.off")
        if len(shape.Solids) != 1 or "failed" in by_mesher("surface", "MeshQuality", brep, 0.2 * LEVEL * size, off):
            continue
        for part in OFFSETS:
            yield {"name": f"{name}, {100 * part:+g} %", "input": str(off), "shape": brep, "target": LEVEL * size, "distance": part * size}


def wrap_cases(arguments, folder):
    """Assemblies and dirty meshes, the same triangles for all."""
    import wrap_assemblies
    from boolean_peers import write_off
    from peer_runs import DIGITS

    box = dummy(folder)
    paths = [Path(arguments.data) / ("cad" if Path(name).suffix in wrap_assemblies.CAD else "mesh") / name for name in WRAPPED]
    for path in [path for path in paths if path.exists()][:arguments.most or None]:
        _, triangles = wrap_assemblies.read(path, folder, WRAP_TOLERANCE)
        size, off = wrap_assemblies.size_of(triangles), folder / f"{path.stem}.off"
        write_off(off, *triangles, DIGITS)
        yield {"name": path.name, "input": str(off), "shape": box, "target": WRAP_TOLERANCE * size, "gap": GAP * size}


def curving_cases(arguments, folder):
    """Solids, and as many tetrahedra as MeshQuality makes of each."""
    import curve_models
    import numpy as np
    from child import in_child
    import own_runs

    found = [(name, curve_models.load(name, Path(arguments.data))) for name in SOLIDS]
    for name, shape in [(name, shape) for name, shape in found if shape][:arguments.most or None]:
        brep, made = str(folder / f"{name}.brep"), folder / f"{name}.npz"
        shape.exportBrep(brep)
        case = {"name": name, "shape": brep, "target": shape.BoundBox.DiagonalLength, "wanted": None, "curved_judge": arguments.curved_judge}
        in_child(lambda job={**case, "task": "curving", "mesher": "MeshQuality", "out": str(made)}: own_runs.run(job))
        if made.exists():
            with np.load(made) as arrays:
                case["wanted"] = len(arrays["tetrahedra"])
        yield case


def improve_cases(arguments, folder):
    """Meshes of parts by BRepMesh, whose angles are small."""
    for name, _shape, brep, size in parts(arguments, GIVEN_PARTS, folder):
        off = Path(brep).with_suffix(".given.off")
        by_mesher("surface", "BRepMesh", brep, GIVEN_FINER * LEVEL * size, off)
        yield {"name": name, "input": str(off), "shape": brep, "target": LEVEL * size}


def dummy(folder):
    """A shape for the judge of meshes that have none: it judges faults of the mesh alone."""
    import Part

    box = str(folder / "box.brep")
    Part.makeBox(1, 1, 1).exportBrep(box)
    return box


def boolean_cases(arguments, folder):
    """Pairs of polyhedra that FreeCAD makes, with OpenCASCADE's volumes, and of meshes from files."""
    import mesh_files
    import Part
    from boolean_peers import write_off
    from peer_runs import DIGITS

    box = dummy(folder)
    paths = [[Path(arguments.data) / "boolean" / f"{name}.ply.gz" for name in names] for names in BOOLEAN_PAIRS]
    there = [pair for pair in paths if all(path.exists() for path in pair)]
    for made in [*polyhedra(), *there][:arguments.most or None]:
        if made in there:
            name, volumes = " and ".join(path.name.partition(".")[0] for path in made), None
            a, b = map(mesh_files.read, made)
        else:
            name, first, second = made
            volumes = {"union": first.fuse(second).Volume, "intersection": first.common(second).Volume,
                       "difference": first.cut(second).Volume}
            a, b = polyhedron_mesh(first), polyhedron_mesh(second)
        files = [str(folder / f"{name.replace(' ', '_')}_{side}.off") for side in "ab"]
        for path, mesh in zip(files, (a, b)):
            write_off(path, *mesh, DIGITS)
        yield {"name": name, "input": files, "shape": box, "target": None, "volumes": volumes,
               "size": abs(peer_figures.volume(*a)) + abs(peer_figures.volume(*b))}


def polyhedra():
    """(name, shape, shape): faces in common, faces that nearly are, and many small intersections."""
    import Part
    from FreeCAD import Rotation, Vector

    turned = Part.makeBox(10, 10, 10)
    turned.rotate(Vector(5, 5, 5), Vector(1, 2, 3), 1e-4)
    pins = []
    for x in range(8):
        for y in range(8):
            ring = [Vector(5 + 5 * x, 5 + 5 * y, -2) + Rotation(Vector(0, 0, 1), 60 * k + 7).multVec(Vector(1.5, 0, 0)) for k in range(7)]
            ring[6] = ring[0]
            pins.append(Part.Face(Part.makePolygon(ring)).extrude(Vector(0, 0, 8)))
    return [("boxes with faces in common", Part.makeBox(10, 10, 10), Part.makeBox(10, 5, 5, Vector(10, 0, 0)).fuse(
                Part.makeBox(5, 5, 10, Vector(5, 0, 0))).removeSplitter()),
            ("cubes turned by 1e-4 degrees", Part.makeBox(10, 10, 10), turned),
            ("plate and 64 pins", Part.makeBox(45, 45, 4), Part.makeCompound(pins))]


def polyhedron_mesh(shape):
    import numpy as np

    points, triangles = shape.tessellate(1.0)
    return np.array([tuple(point) for point in points]), np.array(triangles)


def boolean_figures(case, off, judge):
    row = peer_figures.soundness(off, case["shape"], judge)
    return row | {"volume": peer_figures.volume(*peer_figures.read_off(off)) if row["triangles"] else 0.0}


def counted(case, made, reference):
    """One row of the three operations: how many are sound, and how far their volumes are off, in parts of A + B.
    `reference` has volumes of the operations by somebody else, where they are known.
    """
    found = [row for row in made.values() if row]
    off = [abs(row["volume"] - reference[key]) / case["size"] for key, row in made.items() if row and reference.get(key) is not None]
    judged = [row for row in found if row["crossings"] is not None]
    return {"sound": sum(row["closed"] and row["crossings"] == 0 for row in judged) if judged or not found else None,
            "closed": sum(row["closed"] for row in found), "triangles": sum(row["triangles"] for row in found),
            "off": max(off, default=None)}


TIMES = (Column("CPU s", "seconds", ".3f", -1), Column("wall s", "wall", ".3f"), Column("spread", "spread", ".0%"),
         Column("CPU s, all cores", "seconds_all", ".3f"), Column("wall s, all cores", "wall_all", ".3f"))

TASKS = {
    "surface": Task(
        meshers=("MeshQuality", "Gmsh 5", "Gmsh 6", "Netgen", "BRepMesh", "CGAL"),
        columns=(Column("triangles", "triangles", "d"), Column("distance / target", "distance", ".2f"),
                 Column("triangles x distance", "product", ".0f", -1), Column("smallest angle", "angle", ".1f", 1),
                 Column("smallest angle, forced ones left out", "forced", ".1f", 1), Column("below 25 degrees, %", "below", ".1f", -1),
                 Column("closed", "closed"), Column("crossings", "crossings", "d", -1), *TIMES,
                 Column("triangles a CPU s", "rate", ",.0f", 1)),
        cases=surface_cases, figures=peer_figures.surface,
        searched=lambda case, off, judge: peer_figures.surface(case, off, judge, crossings=False),
        clean=lambda row: row["closed"] and not row["crossings"] and row["distance"] <= 1.02,
        settings={"Gmsh 5": grid(10.0), "Gmsh 6": grid(10.0), "Netgen": grid(1.0)}
        | dict.fromkeys(("BRepMesh", "CGAL"), [2.0, 1.4, 1.0, 0.7, 0.5, 0.35, 0.25, 0.18]),
        relative=("BRepMesh", "CGAL"), outside=True,
        cgal=("cgal_mesh", lambda job: [job["fine"], job["out"], job["setting"], CGAL_EDGES * job["setting"]]),
        said="The target is a thousandth of the largest dimension; MeshQuality is asked for it and for 25 degrees. The others get the "
             "coarsest setting of a grid in steps of 1.4 whose measured distance is within it. That is for Gmsh (algorithms 5 and 6) the "
             "elements on a turn of the curvature, for Netgen its safety of curvature, and for BRepMesh its deflection, with the angular "
             "limit opened. For CGAL it is the facets' distance, with edges of up to 15 times that: Mesh_3 with protected edges and 25 "
             "degrees, of BRepMesh's triangles at a tenth of the target."),
    "public": Task(
        meshers=("MeshQuality", "BRepMesh", "Gmsh"),
        columns=(Column("meshed", "meshed", "d", 1), Column("time-outs", "late", "d", -1), Column("crashes", "crashed", "d", -1),
                 Column("watertight, %", "closed", ".1f", 1), Column("25 degrees kept or forced, %", "angle", ".1f", 1),
                 Column("distance kept, %", "distance", ".1f", 1), Column("without crossings, %", "free", ".1f", 1),
                 Column("all but the angle, % of all", "but_angles", ".1f", 1), Column("all of it, % of all", "good", ".1f", 1),
                 Column("smallest angle, median", "smallest", ".1f", 1), Column("triangles for each of BRepMesh, median", "ratio", ".2f", -1),
                 Column("CPU s, median", "seconds", ".3f", -1), Column("most", "most", ".1f", -1)),
        cases=None, figures=peer_figures.surface, clean=lambda row: True, settings={"Gmsh": [12.0, 24.0, 48.0]}, outside=True,
        about="A run of each, within --limit seconds of the processor.",
        said="CAD files of public repositories that OpenCASCADE's check calls valid, and none of which was chosen for this. The distance "
             "asked for is 0.002 of the largest dimension, and 25 degrees of MeshQuality; a mesh within 1.05 of it keeps it, as the judge "
             "takes the size from another box. Gmsh (algorithm 6) gets 12, 24 and 48 elements on a turn of the curvature until it keeps it. "
             "Watertight: of parts whose faces lie in closed shells; crossings: of parts of one body; angles are forced where a corner of "
             "the part is as narrow, as the judge says."),
    "boolean": Task(
        meshers=("MeshQuality", "Manifold", "MeshLib", "PyMeshLab", "trueform", "CGAL"),
        columns=(Column("sound", "sound", "d", 1), Column("closed", "closed", "d"), Column("triangles", "triangles", "d"),
                 Column("volume off", "off", ".0e"), *TIMES),
        cases=boolean_cases, figures=boolean_figures,
        cgal=("cgal_boolean", lambda job: [job["operation"], *job["input"], job["out"]]), clean=lambda row: row["sound"] == len(OPERATIONS),
        said="Union, intersection and difference of each pair, three results a row; sound ones are closed and nothing of them crosses. "
             "Volumes are beside CGAL's, whose points are exact and rounded at the end, or OpenCASCADE's of the solids where CGAL is not "
             "there, in parts of the volume of the operands. PyMeshLab is libigl's exact Boolean."),
    "simplify": Task(
        meshers=("MeshQuality", "PyMeshLab", "MeshLib", "Manifold", "Mmg", "trueform"),
        columns=(Column("triangles", "triangles", "d", -1), Column("distance / target", "distance", ".2f"), Column("smallest angle", "angle", ".1f"),
                 Column("closed", "closed"), Column("crossings", "crossings", "d", -1), *TIMES),
        cases=simplify_cases, figures=peer_figures.simplified,
        searched=lambda case, off, judge: peer_figures.simplified(case, off, judge, sound=False),
        clean=lambda row: row["closed"] and not row["crossings"] and row["distance"] <= 1.02,
        settings={"PyMeshLab": grid(0.01, count=13), "MeshLib": [2.0**(1 - k / 2) for k in range(10)],
                  "Manifold": [2.0**(1 - k / 2) for k in range(10)], "Mmg": [2.0**(1 - k / 2) for k in range(10)],
                  "trueform": [2.0**(1 - k / 2) for k in range(10)]},
        relative=("MeshLib", "Manifold", "Mmg", "trueform"),
        said="The target is a thousandth of the largest dimension; given meshes are MeshQuality's, three times as close to the part. "
             "MeshQuality proves the distance, for all points of both surfaces. The others get the coarsest setting of a grid in steps of "
             "1.4 (triangles left, or their own tolerance, and trueform its budget of errors) with which 20,000 points a side, measured by VTK, keep it."),
    "fill": Task(
        meshers=("MeshQuality", "Gmsh", "Gmsh HXT", "Netgen", "TetGen", "fTetWild", "delmesher"),
        columns=(Column("tetrahedra", "tetrahedra", "d"), Column("smallest dihedral", "dihedral", ".1f", 1),
                 Column("dihedral that 5 % are below", "twentieth", ".1f", 1), Column("border kept", "conforms"), *TIMES,
                 Column("tetrahedra a CPU s", "rate", ",.0f", 1)),
        cases=fill_cases, figures=peer_figures.filling, clean=lambda row: row["conforms"], suffix=".npz",
        said="The same closed surfaces for all, by MeshQuality at a thousandth of the largest dimension and 25 degrees. Gmsh optimises by "
             "its own and Netgen's steps, TetGen keeps the border and aims at a radius of 1.2 edges and at 10 degrees; delmesher is at its "
             "defaults, which keep the surface and cut its triangles. Angles are in degrees."),
    "offset": Task(
        meshers=("MeshQuality", "MeshLib", "PyMeshLab", "trueform", "Manifold", "CGAL", "OpenCASCADE"),
        columns=(Column("triangles", "triangles", "d"), Column("distance / tolerance", "distance", ".2f"), Column("closed", "closed"),
                 Column("crossings", "crossings", "d", -1), *TIMES),
        cases=offset_cases, figures=peer_figures.offset, searched=lambda case, off, judge: peer_figures.offset(case, off, judge, sound=False),
        clean=lambda row: row["closed"] and not row["crossings"] and row["distance"] <= 1.02,
        settings=dict.fromkeys(("MeshLib", "PyMeshLab", "trueform"), [2.0**(3 - k / 2) for k in range(8)])
        | {"CGAL": [2.0**(4 - k / 2) for k in range(8)]},
        relative=("MeshLib", "PyMeshLab", "trueform", "CGAL"),
        cgal=("alpha_wrap", lambda job: [job["input"], job["out"], job["setting"], job["distance"]]),
        said="By 2 % of the largest dimension outward and inward, with a tolerance of 0.1 %. All get the same closed mesh, by "
             "MeshQuality at 25 degrees and 0.02 %, but for OpenCASCADE, which offsets the shape with rounded joins. MeshQuality "
             "proves the tolerance. The others get the coarsest setting that keeps it: VTK measures 8,000 points of the result from "
             "the given mesh, and points at the distance from the result. MeshLib, PyMeshLab and trueform have voxels from 8 "
             "tolerances on, CGAL's alpha wrap, outward only, alpha from 16 on, in steps of 1.4. Manifold adds a sphere by "
             "Minkowski's sum."),
    "wrap": Task(
        meshers=("MeshQuality", "CGAL", "PyMeshLab", "MeshLib"),
        columns=(Column("triangles", "triangles", "d"), Column("within the tolerance, % of the area", "near", ".1f", 1),
                 Column("sticks out / tolerance", "out", ".2f"), Column("closed", "closed"), Column("crossings", "crossings", "d", -1), *TIMES),
        cases=wrap_cases, figures=peer_figures.wrapped,
        clean=lambda row: row["closed"] and not row["crossings"] and row["out"] <= 1.02,
        cgal=("alpha_wrap", lambda job: [job["input"], job["out"], job["gap"], 0.5 * job["target"]]),
        said="Gaps of 3 % of the largest dimension are to be closed, with a tolerance of 1 %. CGAL's alpha wrap, also the one in PyMeshLab, "
             "has alpha = gap and half of the tolerance as its offset. MeshLib goes outward by half of the gap and back, with voxels of half "
             "of the tolerance. The rest of the area closes gaps, or is off; nothing of the input is to stick out by more than the tolerance."),
    "curving": Task(
        meshers=("MeshQuality", "Gmsh", "Netgen"),
        columns=(Column("tetrahedra", "tetrahedra", "d"), Column("invalid", "invalid", "d", -1), Column("folded triangles", "folded", "d", -1),
                 Column("least J / most J", "distortion", ".3f", 1), Column("distance, rms, 1e-6", "rms", ".2f", -1),
                 Column("largest, 1e-6", "most", ".1f", -1), *TIMES),
        cases=curving_cases, figures=peer_figures.curved,
        searched=lambda case, path, judge: peer_figures.curved({**case, "curved_judge": None}, path, judge),
        clean=lambda row: not row["invalid"] and not row.get("folded"), suffix=".npz",
        settings=dict.fromkeys(("Gmsh", "Netgen"), [0.25 * 2.0 ** (-k / 2) for k in range(10)]), relative=("Gmsh", "Netgen"),
        said="Quadratic tetrahedra. MeshQuality is at its defaults; the others get the longest edges of a grid in steps of 1.4 that make as "
             "many. Gmsh then has the elastic analogy and its optimisation of high order, and Netgen its second order. A judge of curved "
             "meshes proves what is invalid or folded; without one J, the Jacobian within an element, is sampled. The worst element "
             "counts; distances are in parts of the diagonal of the shape."),
    "improve": Task(
        meshers=("MeshQuality", "PyMeshLab", "MeshLib", "Mmg", "trueform", "CGAL"),
        columns=(Column("triangles", "triangles", "d", -1), Column("smallest angle", "angle", ".1f", 1), Column("below 25 degrees, %", "below", ".1f", -1),
                 Column("distance / target", "distance", ".2f"), Column("closed", "closed"), Column("crossings", "crossings", "d", -1), *TIMES),
        cases=improve_cases, figures=peer_figures.improved,
        searched=lambda case, off, judge: peer_figures.improved(case, off, judge, sound=False),
        clean=lambda row: row["closed"] and not row["crossings"] and row["distance"] <= 1.02,
        settings=dict.fromkeys(("PyMeshLab", "MeshLib", "trueform", "CGAL"), [2.0 ** (6 - k / 2) for k in range(10)])
        | {"Mmg": [2.0 ** (1 - k / 2) for k in range(8)]},
        relative=("PyMeshLab", "MeshLib", "Mmg", "trueform", "CGAL"),
        cgal=("cgal_remesh", lambda job: [job["input"], job["out"], job["setting"]]),
        said="Meshes without CAD, made by BRepMesh at 0.3 of the target, a thousandth of the largest dimension, with its angular limit opened. "
             "MeshQuality is asked for 25 degrees and the target. The others get the coarsest setting of a grid in steps of 1.4 with which "
             "20,000 points a side, by VTK, keep it: edges of equal length from 64 targets on, and for Mmg its distance of Hausdorff. Edges "
             "where the surface turns by more than 35 degrees are kept."),
}


class Settings:
    """The settings found in this and former runs."""

    def __init__(self, path, afresh=False):
        self.path = Path(path)
        self.known = json.loads(self.path.read_text(encoding="utf-8")) if self.path.exists() and not afresh else {}

    def of(self, key, search):
        if key not in self.known:
            self.known[key] = search()
            self.path.write_text(json.dumps(self.known, indent=1), encoding="utf-8")
        return self.known[key]
