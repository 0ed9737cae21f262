// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/simplices/degree_raising.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <algorithm>

#include "curve/measuring.h"
#include "curve/volume/filled_solid.h"

namespace mq::given {

using curve::Filled;
using elements::Barycentric;

namespace {

template <std::size_t N>
Vec3 point_of(const elements::CurvedShapes& shapes, const std::array<int, N>& corners, const Barycentric& at) {
    std::vector<Vec3> control;
    if constexpr (N == 3) {
        shapes.triangle(corners, control);
    } else {
        shapes.tetrahedron(corners, control);
    }
    const std::vector<double> weights =
        elements::bernstein_values(elements::Lattice::of(static_cast<int>(N) - 1, shapes.order()), at);
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < control.size(); ++i) {
        sum += weights[i] * control[i];
    }
    return sum;
}

TEST(DegreeRaising, KeepsEveryPoint) {
    const auto model = geometry::make_shape_model(BRepPrimAPI_MakeTorus(1.0, 0.4).Shape());
    for (int order = 1; order <= 3; ++order) {
        const Filled solid(model, order);
        const curve::CurvedSurface high = with_degree_raised(solid.surface, solid.volume.tetrahedra);
        ASSERT_EQ(high.shapes.order(), order + 1);
        for (const curve::SurfaceTriangle& t : solid.surface.triangles) {
            for (const Barycentric& at : {Barycentric{0.2, 0.3, 0.5, 0.0}, Barycentric{0.0, 0.6, 0.4, 0.0}}) {
                EXPECT_LT((point_of(high.shapes, t.corners, at) - point_of(solid.surface.shapes, t.corners, at)).norm(),
                          1e-12);
            }
        }
        for (const int t : solid.volume.live_tetrahedra()) {
            const auto& corners = solid.volume.tetrahedra[static_cast<std::size_t>(t)].corners;
            const Barycentric at{0.1, 0.2, 0.3, 0.4};
            EXPECT_LT((point_of(high.shapes, corners, at) - point_of(solid.surface.shapes, corners, at)).norm(), 1e-12)
                << order;
        }
    }
}

std::ptrdiff_t invalid_of(const Filled& solid) {
    const auto bad = [](const auto& element) { return element.alive && !(element.quality > 0.0); };
    return std::count_if(solid.surface.triangles.begin(), solid.surface.triangles.end(), bad) +
           std::count_if(solid.volume.tetrahedra.begin(), solid.volume.tetrahedra.end(), bad);
}

double deviation_of(Filled& solid) {
    const std::vector<double> all = solid.surface_editor.placement.deviations(curve::live_triangles(solid.surface));
    return *std::max_element(all.begin(), all.end());
}

/// Straight tetrahedra, and their shapes written with one degree more.
void raise(Filled& solid) {
    solid.volume.measure(solid.volume.live_tetrahedra());
    ASSERT_EQ(invalid_of(solid), 0);
    solid.surface = with_degree_raised(solid.surface, solid.volume.tetrahedra);
}

TEST(DegreeRaising, WhatIsValidIsPlacedOnTheCad) {
    const auto model = geometry::make_shape_model(BRepPrimAPI_MakeSphere(2.0).Shape());
    Filled low(model, 1);
    const double straight = deviation_of(low);
    raise(low);
    EXPECT_EQ(place_where_valid(low.surface_editor, &low.volume, low.progress), 0u);
    EXPECT_EQ(invalid_of(low), 0);
    EXPECT_LT(deviation_of(low), 0.2 * straight);
}

TEST(DegreeRaising, ElementsThatWouldFoldKeepTheirShapes) {
    Filled wall(curve::thin_wall(0.04, 2.0), 1);
    raise(wall);
    std::vector<int> all = curve::live_triangles(wall.surface);
    const std::size_t kept = place_where_valid(wall.surface_editor, &wall.volume, wall.progress);
    EXPECT_GT(kept, 0u);
    EXPECT_LT(kept, all.size());
    EXPECT_EQ(invalid_of(wall), 0);
    wall.surface_editor.placement.measure(all);
    wall.volume.measure(wall.volume.live_tetrahedra());
    EXPECT_EQ(invalid_of(wall), 0);  // what it says of them is what they are
}

}  // namespace
}  // namespace mq::given
