#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Boundary layers of prisms, hexahedra and pyramids, curved by `mq.curve(part, mesh=...)`.

    /usr/bin/python3 benchmarks/curve/curved_layers.py [--orders 2 3 4]

Models and meshes are those of tests/freecad/layered_meshes.py: layers are thin beside what their walls bend. A row tells
how many elements are not proven valid where the surface alone is curved, and how many of the result, by its report and
counted again by `certify`; the smallest bound of min J / max J; the largest distance from the CAD; the error of the volume; vertices that
moved; CPU s. The second table has layers of ever smaller thickness around a sphere of radius 5.
"""

import sys
import time
from pathlib import Path

sys.path += map(str, Path(__file__).resolve().parents[1].iterdir())
import inside_freecad


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--orders", type=int, nargs="+", default=[2, 3, 4])
    return result


HEAD = f"{'mesh':30} {'order':>5} {'elements':>8} {'surface alone':>13} {'invalid':>7} {'certify':>7} {'min J/max J':>11} " \
       f"{'deviation':>9} {'volume':>8} {'moved':>5} {'CPU s':>6}"


def row(name, shape, given, order):
    import MeshQuality as mq

    started = time.process_time()
    mesh = mq.curve(shape, mesh=given, order=order)
    seconds, report = time.process_time() - started, mesh.report
    found = {"mesh": name, "order": order, "elements": report.elements, "surface_alone": report.invalid_before,
             "invalid": report.invalid, "certified_invalid": mq.certify(mesh).invalid, "distortion": report.min_distortion,
             "deviation": report.max_deviation, "volume_error": report.volume_error, "moved": len(mesh.moved_nodes),
             "cpu_seconds": round(seconds, 2)}
    print(f"{name:30} {order:5} {report.elements:8,} {report.invalid_before:13,} {report.invalid:7,} "
          f"{found['certified_invalid']:7,} {report.min_distortion:11.3f} {report.max_deviation:9.2g} {report.volume_error:8.1g} "
          f"{found['moved']:5} {seconds:6.2f}", flush=True)
    return found


def work(arguments):
    sys.path.insert(0, str(inside_freecad.ROOT / "tests" / "freecad"))
    import layered_meshes

    print(HEAD)
    rows = [row(name, shape, given, order) for name, (shape, given) in layered_meshes.volumes().items()
            for order in arguments.orders]
    print("\n" + HEAD)
    rows += [row(f"sphere, layers of {thickness:g} mm", *layered_meshes.around_sphere(thickness, 0.06), order)
             for thickness in (0.5, 0.05, 0.005) for order in arguments.orders[:2]]
    return {"rows": rows}


inside_freecad.start(__file__, parser(), work)
