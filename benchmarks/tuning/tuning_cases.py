# SPDX-License-Identifier: LGPL-2.1-or-later
"""What benchmarks/tuning/tuning.py runs to measure the constants of a folder: name -> a function that returns figures.

Parts of others are triangulated; Booleans take pairs of pair_meshes.py, curving the models of curve_models.py, and
improving some of the meshes.
"""

import hashlib
import itertools
import sys
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad
from parts_report import angle, far_distances

BOUND = 25.0  # degrees
DISTANCE = 0.002  # fraction of the largest side
PAIR_CLASSES = ("random", "near", "offset", "files")


def cases(stage, arguments):
    """The cases of a folder of src by name."""
    if stage.startswith("curve/"):
        return curves(volume=stage == "curve/volume")
    return {"boolean": booleans, "improve": improvements}.get(stage.split("/")[0], triangulations)(arguments)


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


def joined(a, b, operation):
    """Figures of a Boolean; an error is one of them."""
    import MeshQuality as mq

    from MeshQuality.compat import extension

    try:
        mesh = mq.boolean(a, b, operation)
    except mq.Error as error:
        return {"triangles": 0, "errors": 1, "faults": 0, "message": str(error)}
    return {"triangles": mesh.report.triangles, "errors": 0, "error_bound": mesh.report.error_bound,
            "faults": sum(extension().verify(mesh._surface).values()), "digest": digest(mesh.vertices, mesh.triangles)}


def curves(volume):
    """The models of the curving benchmark, as surfaces of the second and the third order or as volumes of the second."""
    import curve_models

    data = inside_freecad.data_folder()
    return {f"{name} {order}":
            lambda name=name, order=order: curved(curve_models.load(name, data), order, volume)
            for name in curve_models.MODELS for order in ((2,) if volume else (2, 3))}


def curved(shape, order, volume):
    """Figures of a curved mesh; an error is one of them."""
    import MeshQuality as mq

    try:
        mesh = mq.curve(shape, order=order, volume=volume)
    except mq.Error as error:
        return {"triangles": 0, "errors": 1, "invalid": 0, "message": str(error)}
    return {"triangles": len(mesh.triangles), "errors": 0, "invalid": mesh.report.invalid,
            "digest": digest(mesh.nodes, mesh.triangles)}


def improvements(_arguments):
    """The meshes that same_bytes.py improves, too."""
    import mesh_files

    folder = inside_freecad.data_folder() / "mesh"
    return {name: lambda path=folder / name: improved(path) for name in mesh_files.IMPROVED}


def improved(path):
    """Figures of an improved mesh."""
    import Mesh

    import MeshQuality as mq

    mesh = mq.improve(Mesh.Mesh(str(path)))
    return {"triangles": mesh.report.triangles, "below": len(mesh.report.exempt),
            "digest": digest(mesh.vertices, mesh.triangles)}
