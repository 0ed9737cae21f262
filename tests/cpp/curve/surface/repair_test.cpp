// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/surface/repair.h"

#include <cmath>

#include "curve/placed_surface.h"
#include "curve/surface/coarse_cylinder.h"

namespace mq::curve {
namespace {

/// The edge inside a face with its middle moved aside until a triangle at it folds.
struct Folded {
    int triangle = -1;
    std::array<int, 3> corners{};
};

Folded fold_an_edge(PlacedCurvedSurface& placed, const char* type) {
    Folded folded;
    folded.triangle = placed.find(type, false, folded.corners);
    const auto& [a, b, c] = folded.corners;
    SurfaceEditor& editor = placed.editor;
    const Vec3 inwards = editor.point(c) - 0.5 * (editor.point(a) + editor.point(b));
    EXPECT_TRUE(editor.placement.bulge_on_face(a, b, editor.triangle(folded.triangle).face, 0.5 * inwards));
    editor.placement.place(placed.surface.triangles_of_edge(a, b));
    EXPECT_GT(placed.invalid(), 0);
    return folded;
}

void expect_nodes_on_cylinder(const PlacedCurvedSurface& placed, int a, int b) {
    const elements::CurvedShapes& shapes = placed.surface.shapes;
    std::vector<Vec3> control = shapes.edge_inner(a, b);
    control.insert(control.begin(), placed.editor.point(a));
    control.push_back(placed.editor.point(b));
    for (const Vec3& node : elements::bezier_to_nodes(elements::Lattice::of(1, shapes.order()), control)) {
        EXPECT_NEAR(node.head<2>().norm(), 1.0, 1e-9);
    }
}

/// Bends edge (a, b) of a triangle on the cylinder towards its third vertex until the triangle is just invalid.
Folded bend_an_edge(PlacedCurvedSurface& placed) {
    Folded folded;
    folded.triangle = placed.find("cylinder", false, folded.corners);
    const auto& [a, b, c] = folded.corners;
    SurfaceEditor& editor = placed.editor;
    const Vec3 along = (editor.point(b) - editor.point(a)).normalized();
    Vec3 inwards = editor.point(c) - editor.point(a);
    inwards -= along * along.dot(inwards);
    for (int step = 0; step < 50 && placed.invalid() == 0; ++step) {
        editor.placement.bulge_on_face(a, b, editor.triangle(folded.triangle).face, 0.02 * inwards);
        editor.placement.place(placed.surface.triangles_of_edge(a, b));
    }
    EXPECT_EQ(placed.invalid(), 1);
    return folded;
}

TEST(SurfaceOperations, AnEdgeOnACurvedFaceGivesWay) {
    for (int order = 2; order <= 5; ++order) {
        PlacedCurvedSurface placed(cylinder(), order, 0.6);
        const Folded folded = bend_an_edge(placed);
        const auto& [a, b, c] = folded.corners;
        const bool at_a = curve_face_edge(placed.editor, a, c, b);
        const bool at_b = curve_face_edge(placed.editor, b, c, a);
        EXPECT_TRUE(at_a || at_b) << order;
        EXPECT_EQ(placed.invalid(), 0) << order;
        expect_nodes_on_cylinder(placed, a, c);
        expect_nodes_on_cylinder(placed, b, c);
    }
}

TEST(SurfaceOperations, NoEdgeComesToLieInsideTwoFaces) {
    PlacedCurvedSurface placed(cylinder(), 3, 0.6);
    std::array<int, 3> side{};
    std::array<int, 3> cap{};
    placed.find("cylinder", false, side);
    const int on_cap = placed.find("plane", false, cap);
    const int face = placed.editor.triangle(on_cap).face;
    const std::vector<SurfaceEditor::Corners> added{{{side[1], side[0], cap[2]}, face}};
    EXPECT_FALSE(placed.editor.replace({on_cap}, added, SurfaceEditor::Rule::Try));
    EXPECT_TRUE(placed.editor.triangle(on_cap).alive);
    EXPECT_EQ(placed.surface.triangles_of_edge(side[0], side[1]).size(), 2u);
    placed.expect_closed();
}

TEST(SurfaceOperations, CavitiesAreFilledAnew) {
    for (const char* type : {"cylinder", "plane"}) {
        for (int order = 2; order <= 4; ++order) {
            PlacedCurvedSurface placed(cylinder(), order, 0.6);
            const std::size_t before = live_triangles(placed.surface).size();
            const Folded folded = fold_an_edge(placed, type);
            EXPECT_TRUE(retriangulate_cavity(placed.editor, folded.triangle)) << type << order;
            EXPECT_EQ(placed.invalid(), 0) << type << order;
            EXPECT_LE(live_triangles(placed.surface).size(), before);
            placed.expect_closed();
        }
    }
}

/// A vertex on a circle of the cylinder, or inside it by the fraction `inside` of the circle's distance from the mesh
/// edge (a, b), that counts as one of the plane face inside.
int put_vertex_at_border(PlacedCurvedSurface& placed, int triangle, const std::array<int, 3>& corners, double inside) {
    CurvedSurface& surface = placed.surface;
    const auto& [a, b, c] = corners;
    const Segment& segment = *surface.segment(a, b);
    const int face = placed.editor.triangle(triangle).face;
    const auto on =
        placed.session.ask(geometry::Query::edge_point(segment.edge, 0.5 * (segment.t_low + segment.t_high)));
    const Vec3 middle = 0.5 * (placed.editor.point(a) + placed.editor.point(b));
    const auto at =
        placed.session.ask(geometry::Query::face_nearest_global(face, on.point + inside * (middle - on.point)));
    const int p = surface.add_vertex({at.point, {2, face}});
    surface.uv[CurvedSurface::key(p, face)] = Vec2(at.u, at.v);
    surface.remove_triangle(triangle);
    placed.editor.placement.place({surface.add_triangle({a, b, p}, face), surface.add_triangle({b, c, p}, face),
                                   surface.add_triangle({c, a, p}, face)});
    return p;
}

TEST(SurfaceOperations, VerticesOnTheBorderAreSnappedToIt) {
    for (const double inside : {0.0, 0.03}) {
        for (int order = 2; order <= 4; ++order) {
            PlacedCurvedSurface placed(cylinder(), order, 0.6);
            std::array<int, 3> corners{};
            const int triangle = placed.find("plane", true, corners);
            const int p = put_vertex_at_border(placed, triangle, corners, inside);
            EXPECT_EQ(placed.invalid(), 1) << order;
            const int flat = placed.surface.triangles_of_vertex(p).front();
            EXPECT_EQ(snap_to_boundary(placed.editor, flat, SurfaceEditor::Rule::Refine), 1) << order;
            EXPECT_EQ(placed.invalid(), 0) << order;
            EXPECT_EQ(placed.surface.shapes.vertices[static_cast<std::size_t>(p)].entity[0], 1);
            EXPECT_NE(placed.surface.segment(corners[0], p), nullptr);
            EXPECT_FALSE(placed.surface.has_edge(corners[0], corners[1]));
            placed.expect_closed();
        }
    }
}

TEST(SurfaceOperations, VerticesAwayFromTheBorderStayOnTheirFace) {
    PlacedCurvedSurface placed(cylinder(), 3, 0.6);
    std::array<int, 3> corners{};
    const int triangle = placed.find("plane", true, corners);
    const int p = put_vertex_at_border(placed, triangle, corners, 0.3);
    EXPECT_EQ(snap_to_boundary(placed.editor, placed.surface.triangles_of_vertex(p).front(), SurfaceEditor::Rule::Try),
              0);
}

TEST(SurfaceOperations, WhatLiesBehindACoarseBorderIsRepaired) {
    for (const double inside : {0.0, 0.03, 0.1, 0.3, 0.7}) {
        for (int order = 2; order <= 4; ++order) {
            PlacedCurvedSurface placed(cylinder(), order, 0.6);
            std::array<int, 3> corners{};
            const int triangle = placed.find("plane", true, corners);
            put_vertex_at_border(placed, triangle, corners, inside);
            EXPECT_GT(placed.invalid(), 0) << inside << " " << order;
            const Progress progress;
            EXPECT_EQ(repair_surface(placed.editor, progress).invalid_after, 0) << inside << " " << order;
            EXPECT_EQ(placed.invalid(), 0) << inside << " " << order;
            placed.expect_closed();
        }
    }
}

TEST(SurfaceOperations, NothingIsChangedThatIsWell) {
    PlacedCurvedSurface placed(cylinder(), 3, 0.6);
    std::array<int, 3> corners{};
    const int triangle = placed.find("cylinder", false, corners);
    EXPECT_EQ(snap_to_boundary(placed.editor, triangle, SurfaceEditor::Rule::Refine), 0);
    EXPECT_FALSE(curve_face_edge(placed.editor, corners[0], corners[1], corners[2]));
    EXPECT_EQ(placed.invalid(), 0);
    placed.expect_closed();
}

}  // namespace
}  // namespace mq::curve
