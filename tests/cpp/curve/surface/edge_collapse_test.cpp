// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeCylinder.hxx>

#include "curve/surface/editor.h"
#include "curve/surface/invalid_triangles.h"
#include "curve/volume/filled_solid.h"

namespace mq::curve {
namespace {

constexpr SurfaceEditor::Rule kRefine = SurfaceEditor::Rule::Refine;

class SurfaceEdgeCollapse : public testing::Test {
  protected:
    /// The first edge, from a vertex of the first dimension to one of the second, that satisfies the condition.
    template <typename Condition>
    std::array<int, 2> first_edge(int from, int to, Condition condition) const {
        for (const SurfaceTriangle& t : surface_.triangles) {
            for (std::size_t k = 0; k < 3 && t.alive; ++k) {
                for (const auto& [a, b] : {std::pair(t.corners[k], t.corners[(k + 1) % 3]),
                                           std::pair(t.corners[(k + 1) % 3], t.corners[k])}) {
                    if (dimension(a) == from && dimension(b) == to && condition(a, b)) {
                        return {a, b};
                    }
                }
            }
        }
        return {-1, -1};
    }
    int dimension(int v) const { return surface_.shapes.vertices[static_cast<std::size_t>(v)].entity[0]; }
    std::size_t alive() const {
        return static_cast<std::size_t>(std::count_if(surface_.triangles.begin(), surface_.triangles.end(),
                                                      [](const SurfaceTriangle& t) { return t.alive; }));
    }
    void expect_closed() const {
        for (const SurfaceTriangle& t : surface_.triangles) {
            for (std::size_t k = 0; k < 3 && t.alive; ++k) {
                EXPECT_EQ(surface_.triangles_of_edge(t.corners[k], t.corners[(k + 1) % 3]).size(), 2u);
            }
        }
    }

    Filled filled_{geometry::make_shape_model(BRepPrimAPI_MakeCylinder(1.0, 2.0).Shape()), 2};
    SurfaceEditor& editor_ = filled_.surface_editor;
    CurvedSurface& surface_ = filled_.surface;
};

TEST_F(SurfaceEdgeCollapse, UndoesASplitOfAnEdgeInsideAFace) {
    const auto [a, b] = first_edge(1, 1, [&](int i, int j) { return surface_.segment(i, j) == nullptr; });
    ASSERT_GE(a, 0);
    const std::size_t before = alive();
    const int middle = split_surface_edge(editor_, a, b, kRefine);
    ASSERT_GE(middle, 0);
    ASSERT_EQ(alive(), before + 2);
    EXPECT_TRUE(collapse_surface_edge(editor_, middle, b, kRefine));
    EXPECT_EQ(alive(), before);
    EXPECT_TRUE(surface_.has_edge(a, b));
    expect_closed();
    EXPECT_TRUE(invalid_triangles(surface_).empty());
}

TEST_F(SurfaceEdgeCollapse, AlongACadEdgeKeepsItsParameters) {
    const auto [a, b] = first_edge(1, 1, [&](int i, int j) { return surface_.segment(i, j) != nullptr; });
    ASSERT_GE(a, 0);
    const int edge = surface_.segment(a, b)->edge;
    const double t_a = surface_.t_of(a, b);
    const double t_b = surface_.t_of(b, a);
    const int middle = split_surface_edge(editor_, a, b, kRefine);
    ASSERT_GE(middle, 0);
    ASSERT_EQ(surface_.segment(a, b), nullptr);
    EXPECT_TRUE(collapse_surface_edge(editor_, middle, b, kRefine));
    ASSERT_NE(surface_.segment(a, b), nullptr);
    EXPECT_EQ(surface_.segment(a, b)->edge, edge);
    EXPECT_EQ(surface_.t_of(a, b), t_a);
    EXPECT_EQ(surface_.t_of(b, a), t_b);
    expect_closed();
}

TEST_F(SurfaceEdgeCollapse, KeepsVerticesOfTheCadAndItsEdges) {
    const auto any = [](int, int) { return true; };
    const auto corner = first_edge(0, 1, any);
    ASSERT_GE(corner[0], 0);
    const std::size_t before = alive();
    EXPECT_FALSE(collapse_surface_edge(editor_, corner[0], corner[1], SurfaceEditor::Rule::Try));
    const auto across = first_edge(1, 1, [&](int i, int j) { return surface_.segment(i, j) == nullptr; });
    ASSERT_GE(across[0], 0);
    EXPECT_FALSE(collapse_surface_edge(editor_, across[0], across[1], SurfaceEditor::Rule::Try));
    EXPECT_EQ(alive(), before);
}

}  // namespace
}  // namespace mq::curve
