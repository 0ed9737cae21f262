#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes by OpenCASCADE's evaluation and projection alone, beside ours: Aftosmis 1999, sections 1.2 and 5.1.

    /usr/bin/python3 benchmarks/papers aftosmis-native [--public | --model FILE ...]

The same parts with both: how many of our vertices are vertices of the other mesh, to the last bit, what both meshes keep, and
the time of the processor, the lower of two runs in turn.
"""

from pathlib import Path

import inside_freecad

ANGLE = 25.0
CHORD = 1e-3  # of the largest dimension
PUBLIC = ("netgen_screw.step", "gmsh_t20_data.step", "tie_rod.step", "ball_reactor.brep", "wing_fuselage.step",
          "F-16_OpenVSP3.5.0.stp", "mesh_T106_V3.step", "onera_m6.igs", "Torus_1.brep", "ring_nurbs.brep",
          "occBSplSph2.brep", "CrankArm.brep")  # of the folder cad in $MESHQUALITY_DATA


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--public", action="store_true", help="public parts instead of tests/parts")
    result.add_argument("--model", action="append", help="CAD file instead of tests/parts; may be given more than once")
    return result


def shapes(models):
    """(name, shape) one after the other."""
    import Part
    import parts

    for path in models:
        shape = Part.Shape()
        shape.read(path)
        yield Path(path).stem, shape
    if not models:
        yield from ((name, make()) for name, make in parts.ALL.items())


def surface_of(shape, evaluation):
    import MeshQuality as mq

    return mq.triangulate(shape, min_angle=ANGLE, chord_height_relative=CHORD, evaluation=evaluation)


def compare(name, shape):
    runs = {"fast": [], "native": []}
    for _ in range(2):
        for evaluation, found in runs.items():
            found.append(surface_of(shape, evaluation))
    meshes = [found[0] for found in runs.values()]
    ours, others = ({point.tobytes() for point in mesh.vertices} for mesh in meshes)
    largest = max(shape.BoundBox.XLength, shape.BoundBox.YLength, shape.BoundBox.ZLength)
    return {"part": name, "triangles": [mesh.report.triangles for mesh in meshes],
            "shared": len(ours & others) / len(ours),
            "angles": [mesh.report.min_angle_unexempted for mesh in meshes],
            "exempt": [len(mesh.report.exempt) for mesh in meshes],
            "deviations": [mesh.report.max_chord_height / largest for mesh in meshes],
            "seconds": [min(run.report.cpu_seconds for run in found) for found in runs.values()]}


def work(arguments):
    print(f"{'part':<20} {'triangles: ours':>16} {'native':>8} {'shared vertices':>16} {'smallest angles':>17} {'exempt':>9} "
          f"{'deviations/L':>21} {'CPU s':>15} {'ratio':>6}")
    rows = []
    public = [str(inside_freecad.data_folder() / "cad" / name) for name in PUBLIC] if arguments.public else []
    for name, shape in shapes(public + (arguments.model or [])):
        row = compare(name, shape)
        rows.append(row)
        fast, native = row["seconds"]
        print(f"{name:<20.20} {row['triangles'][0]:16,} {row['triangles'][1]:8,} {row['shared']:16.1%} "
              f"{row['angles'][0]:8.3f} {row['angles'][1]:8.3f} {row['exempt'][0]:4} {row['exempt'][1]:4} "
              f"{row['deviations'][0]:10.3e} {row['deviations'][1]:10.3e} {fast:7.3f} {native:7.3f} {native / fast:6.1f}",
              flush=True)
    return {"rows": rows}


inside_freecad.start(__file__, parser(), work)
