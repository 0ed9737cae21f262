#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure 1 of Dey, O'Bara, Shephard: the order of the geometry decides whether the same mesh is valid.

    /usr/bin/python3 benchmarks/papers dey-order [--out-dir docs/pictures] [--solids tee elbow]

The figure's mesh is two triangles on a plane face whose lower edge is a spline. It is curved at each order as it is, and then
repaired. Below, each thin solid of curve_models.py has one coarse surface mesh (chord height 0.05 of the size), which is curved,
filled with tetrahedra and repaired at each order; invalid: right after curving, and in the end. Qualities are lower bounds of
min J / max J; deviation: of the lower edge from the spline, the largest at 200 points.
"""

from pathlib import Path

import inside_freecad
import numpy as np
import small_pictures

ORDERS = (1, 2, 3, 4, 5)
EDGE = ((0.0, 0.0), (0.55, 0.6), (1.9, 0.55), (3.0, 0.25), (4.0, 0.0))  # points of the lower edge
OUTLINE = ((4.0, 2.9), (0.0, 2.9))
TRIANGLES = ((0, 1, 2), (0, 2, 3))
CHORD_HEIGHT, MIN_ANGLE = 0.05, 15.0
SOLIDS = ("thinplate", "thinshell", "tee", "elbow", "thintube")
VOLUME_ORDERS = ORDERS[:4]
POINTS = 200  # of an edge


def parser():
    result = inside_freecad.command_line(__doc__)
    result.add_argument("--out-dir", default=str(inside_freecad.ROOT / "docs" / "pictures"), help="folder for the picture")
    result.add_argument("--solids", nargs="*", default=SOLIDS, choices=SOLIDS)
    return result


def figure_face():
    import Part
    from FreeCAD import Vector

    lower = Part.BSplineCurve()
    lower.interpolate([Vector(x, y, 0) for x, y in EDGE])
    corners = [Vector(*EDGE[-1], 0), *(Vector(x, y, 0) for x, y in OUTLINE), Vector(*EDGE[0], 0)]
    return Part.Face(Part.Wire([lower.toShape()] + [Part.LineSegment(a, b).toShape() for a, b in zip(corners, corners[1:])]))


def curve_options(order, repair):
    from MeshQuality.compat import extension

    options = extension().CurveOptions()
    options.order, options.repair = order, repair
    return options


def figure_mesh(face, order, repair):
    """The two triangles, curved."""
    from MeshQuality.compat import extension

    nodes = np.array([(*p, 0.0) for p in (EDGE[0], EDGE[-1], *OUTLINE)])
    none = np.empty((0, 4), dtype=np.int32)
    return extension().curve_given(nodes, np.array(TRIANGLES, dtype=np.int32), none, np.empty(0, dtype=np.int32), face,
                                   curve_options(order, repair), False)


def side(nodes, order):
    """Points of a mesh edge with nodes at even parameters, its ends first and then those inside."""
    ordered = np.concatenate([nodes[:1], nodes[2:], nodes[1:2]])
    places = np.linspace(0.0, 1.0, order + 1)
    monomials = np.linspace(0.0, 1.0, POINTS)[:, None] ** np.arange(order + 1)
    return monomials @ np.linalg.solve(places[:, None] ** np.arange(order + 1), ordered)


def outline(mesh, triangle):
    """Points around a triangle: Gmsh's order has the corners first and then the nodes of each side."""
    inner = mesh.order - 1
    sides = []
    for k in range(3):
        own = triangle[3 + k * inner:3 + (k + 1) * inner]
        sides.append(side(mesh.nodes[[triangle[k], triangle[(k + 1) % 3], *own]], mesh.order))
    return np.concatenate(sides)


def draw(face, meshes, path):
    figure, axes = small_pictures.panels(1, len(meshes), 2.6, 2.6)
    exact = np.array(face.Edges[0].discretize(200))
    for axis, mesh in zip(axes, meshes):
        for triangle, quality in zip(mesh.triangles, mesh.triangle_quality):
            axis.fill(*outline(mesh, triangle)[:, :2].T, facecolor="#bcd7ee" if quality > 0.0 else "#d8403a", edgecolor="#1c6fb5",
                      alpha=0.6)
        axis.plot(*exact[:, :2].T, "--", color="#222222", linewidth=1.0)
        axis.set_aspect("equal")
        axis.set_title(f"order {mesh.order}: {min(mesh.triangle_quality):.2f}", fontsize=9)
    small_pictures.save(figure, path)


def deviation(face, mesh):
    """Of the lower edges of the mesh from the spline, mm."""
    import Part
    from FreeCAD import Vector

    lower = [edge for edge, entity in zip(mesh.edges, mesh.edge_entity) if face.Edges[entity].isSame(face.Edges[0])]
    return max(face.Edges[0].distToShape(Part.Vertex(Vector(*point)))[0]
               for edge in lower for point in side(mesh.nodes[edge], mesh.order))


def measured(face, mesh):
    quality = mesh.triangle_quality
    return {"triangles": len(quality), "invalid": int((~(quality > 0)).sum()), "quality": float(quality.min()),
            "deviation": deviation(face, mesh), "repairs": {what: count for what, count in mesh.report.repairs.items() if count}}


def figure(path):
    face = figure_face()
    plain = [figure_mesh(face, order, False) for order in ORDERS]
    draw(face, plain, path)
    rows = []
    print(f"{'order':>5} {'triangles':>9} {'invalid':>7} {'min J / max J':>13} {'deviation':>9}   {'repaired: triangles':>19} "
          f"{'invalid':>7} {'min J / max J':>13} {'deviation':>9}  repairs")
    for order, mesh in zip(ORDERS, plain):
        one, two = measured(face, mesh), measured(face, figure_mesh(face, order, True))
        rows.append({"order": order, "plain": one, "repaired": two})
        print(f"{order:5} {one['triangles']:9} {one['invalid']:7} {one['quality']:13.2f} {one['deviation']:9.4f}   "
              f"{two['triangles']:19} {two['invalid']:7} {two['quality']:13.2f} {two['deviation']:9.4f}  {two['repairs']}")
    return rows


def from_shape(shape, order):
    """Likewise where curving may make other straight meshes; all options are the same."""
    import MeshQuality as mq

    report = mq.curve(shape, order=order, volume=True, min_angle=MIN_ANGLE, chord_height_relative=CHORD_HEIGHT).report
    print(f"{'':<10} with other straight meshes, order {order}: {report.elements}, {report.invalid_before} -> {report.invalid}; "
          f"{'; '.join(report.notes)}")
    return [report.elements, report.invalid_before, report.invalid]


def solids(names):
    """Tetrahedra, and the invalid ones before and after repairs, of one surface mesh at each order."""
    import curve_models
    import MeshQuality as mq

    rows = {}
    print(f"\n{'solid':<10} {'triangles':>9}" + "".join(f"{f'order {order}: tets, invalid':>26}" for order in VOLUME_ORDERS))
    for name in names:
        shape = curve_models.load(name, Path())
        straight = mq.triangulate(shape, min_angle=MIN_ANGLE, chord_height_relative=CHORD_HEIGHT)
        rows[name] = {"triangles": len(straight.triangles)}
        print(f"{name:<10} {len(straight.triangles):9}", end="")
        for order in VOLUME_ORDERS:
            report = mq.curve(straight, shape=shape, order=order, volume=True).report
            rows[name][order] = [report.elements, report.invalid_before, report.invalid]
            print(f"{report.elements:14}, {report.invalid_before:3} -> {report.invalid:2}", end="", flush=True)
        print()
        for order in VOLUME_ORDERS:
            if rows[name][order][2]:
                rows[name][f"shape {order}"] = from_shape(shape, order)
    return rows


def work(arguments):
    return {"figure": figure(Path(arguments.out_dir) / "dey_order.png"), "solids": solids(arguments.solids)}


inside_freecad.start(__file__, parser(), work)
