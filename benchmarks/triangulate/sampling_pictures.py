#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the pictures of docs/method/sampling.md.

    /usr/bin/python3 benchmarks/triangulate/sampling_pictures.py [--out-dir docs/pictures]
"""

import sys
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad

ROOT = Path(__file__).resolve().parents[2]


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--out-dir", default=str(ROOT / "docs" / "pictures"), help="folder for the pictures")
    return result


def panel(axes, title, mesh):
    """Triangles from the back to the front, coloured by their smallest angle as in the demo."""
    import numpy as np
    import render
    from matplotlib.collections import PolyCollection

    points = mesh.vertices @ render.camera().T
    corners = points[mesh.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    light = np.abs(normals[:, 2]) / np.maximum(np.linalg.norm(normals, axis=1), 1e-300)
    colours = render.colours(render.smallest_angles(mesh.vertices, mesh.triangles))
    order = np.argsort(corners[:, :, 2].mean(axis=1))
    if mesh.report.closed:  # what faces away is hidden
        order = order[normals[order, 2] > 0.0]
    shaded = colours * (0.45 + 0.55 * light[:, None])
    axes.add_collection(PolyCollection(corners[order][:, :, :2], facecolors=shaded[order],
                                       edgecolors=render.LINE, linewidths=0.25))
    axes.set_aspect("equal")
    axes.autoscale()
    report = mesh.report
    axes.set_title(f"{title}\n{report.triangles:,} triangles, smallest angle "
                   f"{report.min_angle:.1f}, mean {report.mean_min_angle:.1f} degrees", fontsize=9)
    axes.set_axis_off()


def save(panels, columns, path):
    """panels: (title, mesh)."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    rows = -(-len(panels) // columns)
    figure = Figure(figsize=(5.4 * columns, 4.5 * rows), dpi=90, layout="tight")
    FigureCanvasAgg(figure)
    for axes, (title, mesh) in zip(figure.subplots(rows, columns).flat, panels):
        panel(axes, title, mesh)
    figure.savefig(path)
    print(f"written: {path}", flush=True)


def work(arguments):
    sys.path.append(str(ROOT / "tools"))
    import parts

    import MeshQuality as mq

    folder = Path(arguments.out_dir)
    save([(f"{name}, raw {method}",
           mq.triangulate(parts.ALL[name](), method=method, polish=False,
                          chord_height_relative=0.008))
          for name, method in (("bearing", "star"), ("helix", "sprinkle"), ("crank", "star"),
                               ("support", "star"))], 2, folder / "sampling_parts.png")
    save([(f"{method}, speed of the parameters 1 : {warp * warp:.0f}",
           mq.triangulate(parts.warped_face(warp, warp), method=method, polish=False,
                          chord_height=0.04))
          for method in ("star", "sprinkle") for warp in (1.0, 30.0)],
         2, folder / "sampling_parameters.png")
    return {}


inside_freecad.start(__file__, parser(), work)
