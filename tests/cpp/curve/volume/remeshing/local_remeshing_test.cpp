// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/remeshing/local_remeshing.h"

#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <algorithm>
#include <optional>
#include <vector>

#include "curve/placed_surface.h"
#include "curve/volume/filled_solid.h"

namespace mq::curve {
namespace {

double straight_volume(const TetrahedralMesh& volume) {
    double sum = 0.0;
    for (const int t : volume.live_tetrahedra()) {
        sum += volume.straight_jacobian(volume.tetrahedra[static_cast<std::size_t>(t)].corners) / 6.0;
    }
    return sum;
}

/// The corners of the live tetrahedra, sorted.
std::vector<std::array<int, 4>> corners_of(const TetrahedralMesh& volume) {
    std::vector<std::array<int, 4>> result;
    for (const int t : volume.live_tetrahedra()) {
        result.push_back(volume.tetrahedra[static_cast<std::size_t>(t)].corners);
        std::sort(result.back().begin(), result.back().end());
    }
    std::sort(result.begin(), result.end());
    return result;
}

TEST(RemeshAndRepair, CavitiesAroundInvalidElementsBecomeValid) {
    Filled filled(thin_wall(0.02, 0.5 * M_PI), 2);
    filled.volume.measure(filled.volume.live_tetrahedra());
    ASSERT_GT(filled.volume.invalid(), 0u);
    const double before = filled.volume_sum();
    std::optional<TetrahedralMesh> volume(std::move(filled.volume));
    LocalRemeshing done;
    remesh_and_repair(volume, filled.surface, RepairScope::Poor, done, filled.progress);
    EXPECT_EQ(volume->invalid(), 0u);
    EXPECT_GE(done.cavities, 1u);
    EXPECT_NEAR(straight_volume(*volume), before, 1e-9);
    EXPECT_EQ(&volume->surface, &filled.surface);
}

TEST(RemeshAndRepair, WhatIsValidStays) {
    Filled filled(geometry::make_shape_model(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Shape()), 2);
    filled.volume.measure(filled.volume.live_tetrahedra());
    ASSERT_EQ(filled.volume.invalid(), 0u);
    const auto before = corners_of(filled.volume);
    std::optional<TetrahedralMesh> volume(std::move(filled.volume));
    LocalRemeshing done;
    remesh_and_repair(volume, filled.surface, RepairScope::Poor, done, filled.progress);
    EXPECT_EQ(done.cavities, 0u);
    EXPECT_EQ(corners_of(*volume), before);
}

TEST(FillAndRepair, WhatStaysInvalidLeavesAMesh) {
    PlacedCurvedSurface placed(geometry::make_shape_model(BRepPrimAPI_MakeBox(1.0, 1.0, 1.0).Shape()), 2, 2.0);
    std::array<int, 3> corners{};
    placed.find("plane", false, corners);
    // The edge is bent through the whole box, so that no tetrahedron at it can be valid.
    placed.surface.shapes.set_edge(corners[0], corners[1], {Vec3(5.0, 5.0, 5.0)});
    Progress progress;
    CurveReport report;
    StageTimer clock(report.seconds);
    const RepairedTetrahedralMesh filled = tetrahedralise_and_repair(placed.session, placed.surface, progress, clock);
    EXPECT_GT(filled.repairs.invalid_after, 0);
    EXPECT_EQ(static_cast<std::size_t>(filled.repairs.invalid_after), filled.volume.invalid());
    EXPECT_NEAR(straight_volume(filled.volume), 1.0, 1e-9);
    for (const int t : filled.volume.live_tetrahedra()) {
        for (const int v : filled.volume.tetrahedra[static_cast<std::size_t>(t)].corners) {
            EXPECT_LT(static_cast<std::size_t>(v), placed.surface.shapes.vertices.size());
        }
    }
}

}  // namespace
}  // namespace mq::curve
