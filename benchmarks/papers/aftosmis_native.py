#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes by OpenCASCADE's evaluation and projection alone, beside ours: Aftosmis 1999, sections 1.2 and 5.1.

    /usr/bin/python3 benchmarks/papers aftosmis-native

The same parts with both: how many of our vertices are vertices of the other mesh, to the last bit, what both meshes keep, and
the time of the processor, the lower of two runs in turn.
"""

import inside_freecad

ANGLE = 25.0
CHORD = 1e-3  # of the largest dimension


def parser():
    return inside_freecad.command_line(__doc__)


def surface_of(shape, evaluation):
    from MeshQuality.compat import extension

    core = extension()
    options = core.TriangulateOptions()
    options.min_angle = ANGLE
    options.chord_height_relative = CHORD
    options.evaluation = evaluation
    return core.triangulate(shape, options)


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


def work(_):
    import parts

    print(f"{'part':<10} {'triangles: ours':>16} {'native':>8} {'shared vertices':>16} {'smallest angles':>17} {'exempt':>9} "
          f"{'deviations/L':>21} {'CPU s':>15} {'ratio':>6}")
    rows = []
    for name, make in parts.ALL.items():
        row = compare(name, make())
        rows.append(row)
        fast, native = row["seconds"]
        print(f"{name:<10} {row['triangles'][0]:16,} {row['triangles'][1]:8,} {row['shared']:16.1%} "
              f"{row['angles'][0]:8.3f} {row['angles'][1]:8.3f} {row['exempt'][0]:4} {row['exempt'][1]:4} "
              f"{row['deviations'][0]:10.3e} {row['deviations'][1]:10.3e} {fast:7.3f} {native:7.3f} {native / fast:6.1f}",
              flush=True)
    return {"rows": rows}


inside_freecad.start(__file__, parser(), work)
