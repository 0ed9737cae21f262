#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of 25 degrees with histograms of their smallest angles: figures 8 and 11 of Aftosmis 1999.

    /usr/bin/python3 benchmarks/papers aftosmis-meshes
"""

import sys
from pathlib import Path

import inside_freecad

NAMES = ["die", "wing_main", "flap"]
RULES = (("circumcentre", "#c2452d"), ("off-centre", "#3667a6"))
ANGLE = 25.0


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--out-dir", default=str(inside_freecad.ROOT / "docs" / "pictures"), help="folder for the pictures")
    return result


VIEWS = {"die": ((420, 380), (50.0, 35.0)), "wing_main": ((720, 200), (-15.0, 60.0)), "flap": ((720, 160), (-15.0, 60.0))}


def draw_meshes(meshes, path):
    import small_pictures

    figure, panels = small_pictures.mosaic([["die", "wing_main"], ["die", "flap"]], (13.5, 5.2))
    for name, (size, view) in VIEWS.items():
        mesh = meshes[name, "circumcentre"]
        small_pictures.show(panels[name], mesh, f"{name}: {mesh.report.triangles:,} triangles", size, view)
    small_pictures.save(figure, path)


def draw_histograms(meshes, path):
    import numpy as np
    import small_pictures

    figure, panels = small_pictures.mosaic([NAMES], (12.0, 3.0))
    for name, axes in panels.items():
        for rule, colour in RULES:
            counts = np.asarray(meshes[name, rule].report.angle_histogram)
            axes.stairs(100.0 * counts / counts.sum(), np.arange(len(counts) + 1), color=colour, label=rule)
        axes.axvline(ANGLE, color="0.4", linewidth=0.8, linestyle="--")
        axes.set_xlim(15.0, 60.0)
        axes.set_title(name, fontsize=9)
        axes.set_xlabel("smallest angle of a triangle, degrees", fontsize=8)
        axes.set_ylabel("% of the triangles", fontsize=8)
        axes.tick_params(labelsize=7)
        axes.legend(fontsize=8)
    small_pictures.save(figure, path)


def work(arguments):
    sys.path.append(str(inside_freecad.ROOT / "tools"))
    import parts

    import MeshQuality as mq

    meshes, rows = {}, []
    print(f"{'part':<10} {'rule':<13} {'triangles':>9} {'mean of the smallest angles':>28} {'below 30':>9} {'above 45':>9}")
    for name in NAMES:
        shape = parts.ALL[name]()
        for rule, _ in RULES:
            mesh = mq.triangulate(shape, min_angle=ANGLE, chord_height="none", insertion=rule)
            meshes[name, rule] = mesh
            counts = mesh.report.angle_histogram
            row = {"part": name, "rule": rule, "triangles": mesh.report.triangles,
                   "mean_min_angle": mesh.report.mean_min_angle,
                   "below_30": sum(counts[:30]) / sum(counts), "above_45": sum(counts[45:]) / sum(counts)}
            rows.append(row)
            print(f"{name:<10} {rule:<13} {row['triangles']:9,} {row['mean_min_angle']:28.2f} {row['below_30']:9.1%} "
                  f"{row['above_45']:9.1%}", flush=True)
    folder = Path(arguments.out_dir)
    draw_meshes(meshes, folder / "aftosmis_meshes.png")
    draw_histograms(meshes, folder / "aftosmis_histograms.png")
    return {"rows": rows}


inside_freecad.start(__file__, parser(), work)
