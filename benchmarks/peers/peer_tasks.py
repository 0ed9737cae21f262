# SPDX-License-Identifier: LGPL-2.1-or-later
"""What peers.py has everybody do: cases, who takes part with which settings, and the columns of the tables."""

import json
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

import peer_figures

LEVEL = 1e-3  # of the largest dimension: the distance to keep
OPERATIONS = ("union", "intersection", "difference")
SURFACE_PARTS = ("netgen_screw.step", "gmsh_t20_data.step", "Pump_TopCover.brep", "part.step", "linkrods.step",
                 "nist_ctc_01_asme1_rd.stp", "bottle.brep", "CrankArm.brep")
BOOLEAN_PAIRS = (("needles84_a", "needles84_b"), ("torusA", "torusRot"), ("bunny70k", "dragon58k"), ("twin_a", "twin_b"))
GIVEN_PARTS = ("netgen_screw.step", "gmsh_t20_data.step", "linkrods.step", "part.step")  # to simplify and to fill
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
    the target where `relative` names them. `said` explains the settings and the columns.
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
    for name, _shape, brep, size in parts(arguments, SURFACE_PARTS, folder):
        yield {"name": name, "input": brep, "target": LEVEL * size}


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


def boolean_cases(arguments, folder):
    """Pairs of polyhedra that FreeCAD makes, with OpenCASCADE's volumes, and of meshes from files."""
    import mesh_files
    import Part
    from boolean_peers import write_off
    from peer_runs import DIGITS

    box = folder / "box.brep"
    Part.makeBox(1, 1, 1).exportBrep(str(box))
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
        yield {"name": name, "input": files, "shape": str(box), "target": None, "volumes": volumes,
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


TIMES = (Column("CPU s", "seconds", ".3f", -1), Column("wall s", "wall", ".3f"), Column("spread", "spread", ".0%"))

TASKS = {
    "surface": Task(
        meshers=("MeshQuality", "Gmsh 5", "Gmsh 6", "Netgen", "BRepMesh"),
        columns=(Column("triangles", "triangles", "d"), Column("distance / target", "distance", ".2f"),
                 Column("triangles x distance", "product", ".0f", -1), Column("smallest angle", "angle", ".1f", 1),
                 Column("forced left out", "forced", ".1f", 1), Column("below 25 degrees, %", "below", ".1f", -1),
                 Column("closed", "closed"), Column("crossings", "crossings", "d", -1), *TIMES,
                 Column("triangles a CPU s", "rate", ",.0f", 1)),
        cases=surface_cases, figures=peer_figures.surface,
        searched=lambda case, off, judge: peer_figures.surface(case, off, judge, crossings=False),
        clean=lambda row: row["closed"] and not row["crossings"] and row["distance"] <= 1.02,
        settings={"Gmsh 5": grid(10.0), "Gmsh 6": grid(10.0), "Netgen": grid(1.0), "BRepMesh": [2.0, 1.4, 1.0, 0.7, 0.5, 0.35, 0.25, 0.18]},
        relative=("BRepMesh",),
        said="The target is a thousandth of the largest dimension; MeshQuality is asked for it and for 25 degrees. The others get the "
             "coarsest setting of a grid in steps of 1.4 whose measured distance is within it. That is for Gmsh (algorithms 5 and 6) the "
             "elements on a turn of the curvature, for Netgen its safety of curvature, and for BRepMesh its deflection, with the angular "
             "limit opened."),
    "boolean": Task(
        meshers=("MeshQuality", "Manifold", "MeshLib", "PyMeshLab", "CGAL"),
        columns=(Column("sound", "sound", "d", 1), Column("closed", "closed", "d"), Column("triangles", "triangles", "d"),
                 Column("volume off", "off", ".0e"), *TIMES),
        cases=boolean_cases, figures=boolean_figures, clean=lambda row: row["sound"] == len(OPERATIONS),
        said="Union, intersection and difference of each pair, three results a row; sound ones are closed and nothing of them crosses. "
             "Volumes are beside CGAL's, whose points are exact and rounded at the end, or OpenCASCADE's of the solids where CGAL is not "
             "there, in parts of the volume of the operands. PyMeshLab is libigl's exact Boolean."),
    "simplify": Task(
        meshers=("MeshQuality", "PyMeshLab", "MeshLib", "Manifold", "Mmg"),
        columns=(Column("triangles", "triangles", "d", -1), Column("distance / target", "distance", ".2f"), Column("smallest angle", "angle", ".1f"),
                 Column("closed", "closed"), Column("crossings", "crossings", "d", -1), *TIMES),
        cases=simplify_cases, figures=peer_figures.simplified,
        searched=lambda case, off, judge: peer_figures.simplified(case, off, judge, sound=False),
        clean=lambda row: row["closed"] and not row["crossings"] and row["distance"] <= 1.02,
        settings={"PyMeshLab": grid(0.01, count=13), "MeshLib": [2.0**(1 - k / 2) for k in range(10)],
                  "Manifold": [2.0**(1 - k / 2) for k in range(10)], "Mmg": [2.0**(1 - k / 2) for k in range(10)]},
        relative=("MeshLib", "Manifold", "Mmg"),
        said="The target is a thousandth of the largest dimension; given meshes are MeshQuality's, three times as close to the part. "
             "MeshQuality proves the distance, for all points of both surfaces. The others get the coarsest setting of a grid in steps of "
             "1.4 (triangles left, or their own tolerance) with which 20,000 points a side, measured by VTK, keep it."),
    "fill": Task(
        meshers=("MeshQuality", "Gmsh", "Gmsh HXT", "Netgen", "TetGen", "fTetWild"),
        columns=(Column("tetrahedra", "tetrahedra", "d"), Column("smallest dihedral", "dihedral", ".1f", 1),
                 Column("dihedral that 5 % are below", "twentieth", ".1f", 1), Column("border kept", "conforms"), *TIMES,
                 Column("tetrahedra a CPU s", "rate", ",.0f", 1)),
        cases=fill_cases, figures=peer_figures.filling, clean=lambda row: row["conforms"], suffix=".npz",
        said="The same closed surfaces for all, by MeshQuality at a thousandth of the largest dimension and 25 degrees. Gmsh optimises by "
             "its own and Netgen's steps, TetGen keeps the border and aims at a radius of 1.2 edges and at 10 degrees. Angles are in degrees."),
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
