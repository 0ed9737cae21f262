#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The die at a chord height of 1e-4 L by Algorithm E: figure 12 of Aftosmis 1999.

    /usr/bin/python3 benchmarks/papers aftosmis-chord
"""

import sys
from pathlib import Path

import inside_freecad

ANGLE = 25.0
CHORD = 1e-4  # of the largest dimension L
CORNER = (26.0, 26.0, 33.0)  # mm, on the rounded inner corner that goes down to the deeper floor
AROUND = 26.0  # mm
RULES = ("circumcentre", "off-centre")


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--out-dir", default=str(inside_freecad.ROOT / "docs" / "pictures"), help="folder for the picture")
    return result


def places(mesh, curved):
    """The triangles on planar faces as a set of their corners' coordinates, whatever their order."""
    points = mesh.vertices + mesh.origin
    return {frozenset(map(tuple, points[triangle].tolist()))
            for triangle, face in zip(mesh.triangles, mesh.triangle_face) if int(face) not in curved}


def compare(shape, rule, before, after):
    """One row: both meshes, and which triangles on planar faces stayed."""
    curved = {i for i, face in enumerate(shape.Faces) if face.Surface.TypeId != "Part::GeomPlane"}
    planar = places(before, curved)
    largest = max(shape.BoundBox.XLength, shape.BoundBox.YLength, shape.BoundBox.ZLength)
    report = after.report
    on_curved = sum(int(face) in curved for face in after.triangle_face)
    return {"rule": rule, "without": before.report.triangles, "deviation_without": before.report.max_chord_height / largest,
            "with": report.triangles, "deviation": report.max_chord_height / largest, "on_curved": on_curved,
            "planar_before": len(planar), "planar_kept": len(planar & places(after, curved)),
            "smallest_angle": report.min_angle, "exempt": len(report.exempt)}


def draw(before, after, path):
    import numpy as np
    import small_pictures

    figure, panels = small_pictures.mosaic([["25 degrees", "25 degrees and 1e-4 L"]], (10.0, 4.6))
    for (title, axes), mesh in zip(panels.items(), (before, after)):
        middles = (mesh.vertices + mesh.origin)[mesh.triangles].mean(axis=1)
        near = np.flatnonzero(np.linalg.norm(middles - CORNER, axis=1) < AROUND)
        small_pictures.show(axes, mesh, f"{title}: {mesh.report.triangles:,} triangles", (440, 360), (50.0, 35.0), near)
    small_pictures.save(figure, path)


def work(arguments):
    sys.path.append(str(inside_freecad.ROOT / "tools"))
    import parts

    import MeshQuality as mq

    shape = parts.ALL["die"]()
    rows = []
    print(f"{'rule':<13} {'without':>8} {'deviation/L':>12} {'with':>8} {'deviation/L':>12} {'on curved faces':>16} "
          f"{'planar kept':>14} {'smallest angle':>15}")
    for rule in RULES:
        before = mq.triangulate(shape, min_angle=ANGLE, chord_height="none", insertion=rule)
        after = mq.triangulate(shape, min_angle=ANGLE, chord_height_relative=CHORD, insertion=rule)
        row = compare(shape, rule, before, after)
        rows.append(row)
        print(f"{rule:<13} {row['without']:8,} {row['deviation_without']:12.2e} {row['with']:8,} {row['deviation']:12.2e} "
              f"{row['on_curved']:16,} {row['planar_kept']:5,} of {row['planar_before']:5,} {row['smallest_angle']:15.2f}",
              flush=True)
        if rule == "circumcentre":
            draw(before, after, Path(arguments.out_dir) / "aftosmis_chord.png")
    return {"rows": rows}


inside_freecad.start(__file__, parser(), work)
