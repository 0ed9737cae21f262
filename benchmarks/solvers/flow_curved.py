# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curved layers of volume_mesh in a pipe bend, orders 1 to 3.

    freecadcmd -P <root>/Mod benchmarks/solvers/flow_curved.py </dev/null
A line each: elements, how many of them bend less than the CAD, the surface's distance from the part, the volume's, and the smallest proven
bound of min J / max |J|. Other regions: flow_layers.py with ORDER=2.
"""

import time

import Part
from FreeCAD import Vector

import MeshQuality as mq


def told(name, shape, **given):
    start = time.process_time()
    mesh = mq.volume_mesh(shape, **given)
    report = mesh.report
    print(f"{name}: {sum(report.elements.values()):,} elements, {len(report.straightened)} straightened, covered {report.covered:.3f}, deviation "
          f"{report.chord_height:.2g} mm, volume off by {report.volume / shape.Volume - 1:.1e}, bound {report.min_distortion:.2f}, "
          f"{time.process_time() - start:.1f} s of processors", flush=True)


def main():
    bend = Part.Face(Part.Wire(Part.makeCircle(3, Vector(12, 0, 0), Vector(0, 1, 0)))).revolve(Vector(), Vector(0, 0, 1), 90)
    for edge in (1.5, 0.8):
        for order in (1, 2, 3):
            told(f"pipe bend, edges up to {edge} mm, order {order}", bend, layers=5, first_height=0.03, growth_rate=1.3, walls=["Face1"],
                 max_edge=edge, order=order)


main()
