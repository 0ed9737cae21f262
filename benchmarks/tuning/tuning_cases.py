# SPDX-License-Identifier: LGPL-2.1-or-later
"""What benchmarks/tuning/tuning.py runs to measure the constants of a folder: name -> a function that returns figures.

Parts of others are triangulated; Booleans take pairs of pair_meshes.py and of tests/parts/contact_pairs.py and meshes that
are not closed; curving, filling, offsets and wraps the models of curve_models.py; improving some of the meshes.
"""

import csv
import hashlib
import itertools
import sys
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad
import numpy as np
from parts_report import angle, far_distances

BOUND = 25.0  # degrees
DISTANCE = 0.002  # fraction of the largest side
PAIR_CLASSES = ("random", "near", "offset", "files")
OFFSETS = (0.03, -0.03)  # fractions of the diagonal
GAP = 0.1  # of wraps, a fraction of the diagonal


def cases(stage, arguments):
    """The cases of a folder of src by name."""
    made = {
        "boolean": contacts, "boolean/near_coincidence": contacts, "boolean/input": dirty_operands,
        "boolean/rounding": booleans, "layered_depth": uniform_booleans, "improve": improvements,
        "curve/surface": lambda _: curves((2, 3), volume=False), "curve/volume": lambda _: curves((2,), volume=True),
        "tetrahedralise": lambda _: curves((1, 2), volume=True), "offset": offsets, "contour": offsets_and_wraps,
        "wrap": wraps,
    }
    known = [folder for folder in made if f"{stage}/".startswith(f"{folder}/")]
    return (made[max(known, key=len)] if known else triangulations)(arguments)


def digest(*arrays):
    """Tells whether two meshes are the same."""
    return hashlib.sha256(b"".join(array.tobytes() for array in arrays)).hexdigest()


def triangulations(arguments):
    """Parts of the share to develop on, in the order of their digests."""
    options = {"min_angle": BOUND, "chord_height_relative": DISTANCE, "method": arguments.method}
    if arguments.keep_edges:
        options["keep_edges"] = arguments.keep_edges
    return {name: lambda shape=shape: triangulated(shape, options) for name, shape in read_parts(arguments).items()}


def triangulated(shape, options):
    """What is compared of one mesh."""
    import MeshQuality as mq

    report = mq.triangulate(shape, **options).report
    forced = sum(reason.forced for _, reason in report.exempt_reasons)
    found = {
        "triangles": report.triangles, "vertices": report.vertices,
        "exempt": len(report.exempt), "exempt_forced": forced, "unforced": len(report.exempt) - forced,
        "min_angle": report.min_angle, "min_angle_unexempted": report.min_angle_unexempted,
        "max_chord_height": report.max_chord_height, "chord_height_asked": report.chord_height_asked,
        "self_intersections": max(report.self_intersections, 0),
    }
    found["missed"] = int(angle(found | {"crossings": found["self_intersections"]}, BOUND) == "missed")
    found["far"] = int(bool(far_distances(found, {"chord_height_relative": DISTANCE})))
    found["crossings"] = int(found["self_intersections"] > 0)
    return found


def read_parts(arguments):
    """Shapes by name. Documents, invalid shapes and large files are left out."""
    import Part
    import parts_sources

    if not arguments.parts:
        raise SystemExit("--parts FOLDER is needed for a stage of triangulation")
    shapes, names = {}, set()
    if arguments.names:
        names = set(Path(arguments.names).read_text(encoding="utf-8").split())
    files = sorted(p for p in Path(arguments.parts).iterdir()
                   if parts_sources.share_of(p.stem) == "develop" and p.suffix != ".fcstd")
    for path in files:
        if len(shapes) == arguments.first:
            break
        if path.stat().st_size > arguments.most_bytes or (names and path.stem not in names):
            continue
        shape = Part.Shape()
        try:
            shape.read(str(path))
        except Exception as error:
            print(f"{path.name} is left out: {error}", flush=True)
            continue
        if shape.Faces and shape.isValid():
            shapes[path.stem] = shape
    return shapes


def booleans(arguments):
    """All operations of the first pairs of the share to develop on, and the known hard pairs."""
    import pair_meshes

    pairs = pair_meshes.Pairs(inside_freecad.data_folder(), 1)
    found = {}
    for name in itertools.islice(pair_meshes.names(PAIR_CLASSES, "develop"), arguments.first):
        a, b, _ = pairs.make(name)
        for operation in pair_meshes.OPERATIONS:
            found[f"{name} {operation}"] = lambda a=a, b=b, operation=operation: joined(a, b, operation)
    return found


def contacts(arguments):
    """All operations of solids with common faces, half of them given as meshes."""
    from parts.contact_pairs import KINDS, OPERATIONS

    return {f"{kind}-{seed} {operation}": lambda kind=kind, seed=seed, operation=operation: in_contact(
        kind, seed, operation) for kind, seed, operation in itertools.product(KINDS, range(arguments.first), OPERATIONS)}


def in_contact(kind, seed, operation):
    """Figures of one of them."""
    import MeshQuality as mq

    from parts.contact_pairs import contact_pair

    pair = contact_pair(kind, seed)
    operands = [mq.triangulate(shape, chord_height=0.5 * pair.tolerance).to_mesh() if seed % 2 else shape
                for shape in (pair.first, pair.displaced)]
    return joined(*operands, operation, tolerance=pair.tolerance, method="exact")


def dirty_operands(arguments):
    """Boxes with the smallest meshes that are not closed taken out of them."""
    import mesh_files
    import Part
    from FreeCAD import Vector

    data = inside_freecad.data_folder()
    with open(data / "index.csv", encoding="utf-8") as rows:
        names = [row["file"] for row in csv.DictReader(rows) if row["kind"] == "mesh" and "open" in row["flags"]]
    found = {}
    for name in sorted(names, key=lambda name: (data / name).stat().st_size)[:arguments.first]:
        vertices, triangles = mesh_files.read(data / name)
        low, size = vertices.min(axis=0), np.ptp(vertices, axis=0)
        box = Part.makeBox(*(0.6 * size).tolist(), Vector(*low.tolist()))
        for options in ({}, {"method": "uniform", "resolution": 65}):
            found[f"{Path(name).name} {options}"] = lambda given=(vertices, triangles), box=box, options=options: joined(
                box, given, "difference", **options)
    return found


def uniform_booleans(_arguments):
    """Unions of models with themselves, turned, from samples."""
    import FreeCAD

    found = {}
    for name, shape in models().items():
        turned = shape.rotated(FreeCAD.Vector(), FreeCAD.Vector(1, 2, 3), 40)
        for operation in ("union", "difference"):
            found[f"{name} {operation}"] = lambda a=shape, b=turned, operation=operation: joined(
                a, b, operation, method="uniform", resolution=65, full=True)
    return found


def joined(a, b, operation, **options):
    """Figures of a Boolean; an error is one of them."""
    return figures(lambda mq: mq.boolean(a, b, operation, **options))


def figures(work):
    """Figures of the surface that `work` makes of the module; an error is one of them."""
    import MeshQuality as mq

    from MeshQuality.compat import extension

    try:
        mesh = work(mq)
    except mq.Error as error:
        return {"triangles": 0, "errors": 1, "faults": 0, "message": str(error)}
    return {"triangles": mesh.report.triangles, "errors": 0, "error_bound": mesh.report.error_bound,
            "faults": sum(extension().verify(mesh._surface).values()), "digest": digest(mesh.vertices, mesh.triangles)}


def models():
    """Those models of the curving benchmark that are made, by name."""
    import curve_models

    return {name: made() for name, made in curve_models.MODELS.items() if callable(made)}


def offsets(_arguments):
    """Offsets of models both ways, and of some of the meshes to improve."""
    return {f"{name} {share}": lambda solid=solid, share=share: figures(
        lambda mq: mq.offset(solid, share * solid.BoundBox.DiagonalLength))
        for name, solid in {**models(), **meshes()}.items() for share in OFFSETS}


def wraps(_arguments):
    """Wraps of models, and of two boxes with a gap between them."""
    import FreeCAD
    import Part

    boxes = Part.Compound([Part.makeBox(1, 1, 1), Part.makeBox(1, 1, 1, FreeCAD.Vector(1.1, 0.3, 0.2))])
    return {f"wrap {name}": lambda shape=shape: figures(
        lambda mq: mq.wrap([shape], GAP * shape.BoundBox.DiagonalLength))
        for name, shape in {**models(), "gap": boxes}.items()}


def offsets_and_wraps(arguments):
    """Both."""
    return {**offsets(arguments), **wraps(arguments)}


def curves(orders, volume):
    """The models of the curving benchmark as surfaces or volumes of these orders."""
    import curve_models

    data = inside_freecad.data_folder()
    return {f"{name} {order}": lambda name=name, order=order: curved(curve_models.load(name, data), order, volume)
            for name in curve_models.MODELS for order in orders}


def curved(shape, order, volume):
    """Figures of a curved mesh; an error is one of them."""
    import MeshQuality as mq

    try:
        mesh = mq.curve(shape, order=order, volume=volume)
    except mq.Error as error:
        return {"triangles": 0, "errors": 1, "invalid": 0, "message": str(error)}
    cells = [mesh.tetrahedra] if volume else []
    return {"triangles": len(mesh.triangles), "errors": 0, "invalid": mesh.report.invalid,
            "digest": digest(mesh.nodes, mesh.triangles, *cells)}


def meshes():
    """The meshes that same_bytes.py improves, by name."""
    import Mesh
    import mesh_files

    return {name: Mesh.Mesh(str(inside_freecad.data_folder() / "mesh" / name)) for name in mesh_files.IMPROVED}


def improvements(_arguments):
    """Those, improved."""
    return {name: lambda mesh=mesh: improved(mesh) for name, mesh in meshes().items()}


def improved(mesh):
    """Figures of an improved mesh."""
    import MeshQuality as mq

    better = mq.improve(mesh)
    return {"triangles": better.report.triangles, "below": len(better.report.exempt),
            "digest": digest(better.vertices, better.triangles)}
