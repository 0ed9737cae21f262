#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Star and Sprinkle on solids like those of Ruiz et al., figure 9: what they ask of a mesher, counts and angles.

    /usr/bin/python3 benchmarks/papers ruiz-solids

The paper's own CAD files are not public, and it gives no counts and no angles. The solids of tests/parts/sampled.py have what its
section 3 asks for: several shells, faces with holes, curvature that varies within a face, and faces of very different areas.
Meshes are raw: the samples as joined, without swaps and refinement. Seconds are those of the processor.
"""

import time

import inside_freecad

SOLIDS = ("bearing", "helix", "crank", "support")
METHODS = ("star", "sprinkle")


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--chord-height-relative", type=float, default=0.001, help="of the largest dimension")
    return result


def features(shape):
    """What section 3 of the paper asks of its test solids."""
    areas = [face.Area for face in shape.Faces]
    return {"shells": len(shape.Shells), "faces": len(areas),
            "faces_with_holes": sum(len(face.Wires) > 1 for face in shape.Faces),
            "area_ratio": max(areas) / min(areas)}


def mesh(shape, method, chord_height):
    import MeshQuality as mq

    start = time.process_time()
    report = mq.triangulate(shape, method=method, refine_samples=False, chord_height_relative=chord_height).report
    return {
        "seconds": time.process_time() - start, "triangles": report.triangles, "min_angle": report.min_angle,
        "mean_min_angle": report.mean_min_angle, "below_30": sum(report.angle_histogram[:30]) / report.triangles,
        "good": report.closed and report.oriented and report.manifold, "fallback": len(report.fallback),
    }


def work(arguments):
    import parts

    found = {}
    print(f"{'solid':<8} {'shells':>6} {'faces':>5} {'with holes':>10} {'areas 1 :':>9}   {'method':<8} {'triangles':>9} "
          f"{'smallest':>8} {'mean':>5} {'<30 %':>5} {'CPU s':>6} {'in (u, v)':>9}")
    for name in SOLIDS:
        shape = parts.ALL[name]()
        has = features(shape)
        rows = found[name] = {"solid": has}
        for method in METHODS:
            row = rows[method] = mesh(shape, method, arguments.chord_height_relative)
            print(f"{name:<8} {has['shells']:6} {has['faces']:5} {has['faces_with_holes']:10} {has['area_ratio']:9,.0f}   "
                  f"{method:<8} {row['triangles']:9,} {row['min_angle']:8.1f} {row['mean_min_angle']:5.1f} "
                  f"{100 * row['below_30']:5.1f} {row['seconds']:6.2f} {row['fallback']:9}"
                  f"{'' if row['good'] else ' OPEN'}", flush=True)
    print("in (u, v): faces whose fronts did not close, which are triangulated in the parameters instead.")
    return {"solids": found}


inside_freecad.start(__file__, parser(), work)
