#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Algorithm M on parts like those of Aftosmis 1999, section 4: triangles, and how far the angle goes.

    /usr/bin/python3 benchmarks/papers aftosmis-parts

The paper's own CAD files are not public. tests/parts models parts after its figures, with other
sizes and features, so the paper's numbers of triangles are there for the order of magnitude only.

The angle goes up in steps of one degree. An angle is reached when the mesh is complete and every
exempted triangle is explained by the part: by a corner that is narrower than the angle, by the
edges at such a corner, or by the apex of a slender cone.
"""

import time

import inside_freecad

PAPER = {"die": 2606, "wing_main": 20846, "flap": 15334}
PAPER_ANGLE = 25
INSERTIONS = ("off-centre", "circumcentre")


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--from", dest="low", type=int, default=25, metavar="DEGREES")
    result.add_argument("--to", dest="high", type=int, default=34, metavar="DEGREES")
    result.add_argument("--max-triangles", type=int, default=1_000_000, help="the budget")
    return result


# Causes of exemptions that are angles of the part.
EXPLAINED = ("narrow_corner", "narrow_cluster", "apex")


def mesh(shape, angle, insertion, budget):
    """One row of the result."""
    import MeshQuality as mq

    start = time.perf_counter()
    report = mq.triangulate(shape, min_angle=angle, chord_height="none", insertion=insertion,
                            max_triangles=budget).report
    unexplained = [str(why) for _, why in report.exempt_reasons if why.cause not in EXPLAINED]
    return {
        "min_angle_asked": angle, "insertion": insertion, "triangles": report.triangles,
        "seconds": round(time.perf_counter() - start, 4), "complete": report.complete,
        "good": report.closed and report.oriented and report.manifold,
        "euler": report.euler, "min_angle": report.min_angle,
        "min_angle_unexempted": report.min_angle_unexempted,
        "mean_min_angle": report.mean_min_angle, "max_angle": report.max_angle,
        "exempt": len(report.exempt), "unexplained": len(unexplained),
        "causes": report.exempt_causes, "first_unexplained": unexplained[:5],
        "reached": report.complete and not unexplained,
    }


def reached(rows, insertion):
    """The largest angle up to which all angles are reached, or None."""
    best = None
    for row in rows:
        if row["insertion"] == insertion:
            if not row["reached"]:
                break
            best = row["min_angle_asked"]
    return best


def show(name, rows):
    for row in rows:
        causes = [f"{count} {cause.partition(' on ')[0]:.40}" for cause, count in row["causes"]]
        print(f"{name:<10} {row['insertion']:<10} {row['min_angle_asked']:5} "
              f"{row['triangles']:9,} {row['min_angle_unexempted']:8.3f} {row['exempt']:6} "
              f"{row['unexplained']:11} {row['seconds']:8.3f}  {'; '.join(causes[:2])}"
              f"{'' if row['complete'] else ' INCOMPLETE'}{'' if row['good'] else ' FAULTY'}",
              flush=True)


def summary(rows_of):
    """The paper's table 1 with ours beside it, as text."""
    lines = [f"\n{'':10} {'faces':>5} {'the paper':>10} {'off-centre':>11} {'paper rule':>11}   "
             "largest angle reached (off-centre, paper rule)"]
    for name, part in rows_of.items():
        at = {row["insertion"]: row for row in part["rows"]
              if row["min_angle_asked"] == PAPER_ANGLE}
        ours = [f"{at[i]['triangles']:11,}" if i in at else " " * 11 for i in INSERTIONS]
        lines.append(f"{name:<10} {part['faces']:5} {PAPER[name]:10,} {ours[0]} {ours[1]}   "
                     f"{part['reached']['off-centre']}, {part['reached']['circumcentre']} degrees")
    lines.append(f"Triangles at {PAPER_ANGLE} degrees, no chord height. The parts are modelled "
                 "after the paper's figures, they are not its parts.")
    return "\n".join(lines)


def work(arguments):
    """All rows, and the summary on stdout."""
    import parts

    print(f"\n{'part':<10} {'insertion':<10} {'asked':>5} {'triangles':>9} {'kept':>8} "
          f"{'exempt':>6} {'unexplained':>11} {'seconds':>8}")
    results = {}
    for name in PAPER:
        shape = parts.ALL[name]()
        mesh(shape, arguments.low, "circumcentre", arguments.max_triangles)  # warms up
        rows = [mesh(shape, angle, insertion, arguments.max_triangles)
                for insertion in INSERTIONS
                for angle in range(arguments.low, arguments.high + 1)]
        show(name, rows)
        results[name] = {"faces": len(shape.Faces), "paper_triangles": PAPER[name], "rows": rows,
                         "reached": {i: reached(rows, i) for i in INSERTIONS}}
    print(summary(results))
    return {"parts": results}


inside_freecad.start(__file__, parser(), work)
