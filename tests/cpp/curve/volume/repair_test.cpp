// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/repair.h"

#include <gtest/gtest.h>

#include "curve/volume/filled_solid.h"

namespace mq::curve {
namespace {

TEST(RepairTetrahedralMesh, ThinWallsBecomeValid) {
    for (const double thickness : {0.1, 0.04}) {
        for (int order = 2; order <= 4; ++order) {
            const CurvedMesh mesh = curved(thin_wall(thickness, 0.5 * M_PI), of_order(order, true));
            EXPECT_EQ(invalid_tetrahedra(mesh), 0u) << thickness << " " << order << "\n" << to_text(mesh.report);
            EXPECT_EQ(mesh.report.invalid, 0u);
            EXPECT_GT(mesh.report.min_distortion, 0.1);
            const double inner = 1.0 - thickness;
            EXPECT_NEAR(mesh.report.volume, 0.25 * M_PI * (1.0 - inner * inner), 1e-3);
            expect_conforming(mesh);
        }
    }
}

TEST(RepairTetrahedralMesh, ThereIsSomethingToRepair) {
    EXPECT_GT(curved(thin_wall(0.04, 0.5 * M_PI), of_order(2, true)).report.invalid_before, 0u);
}

}  // namespace
}  // namespace mq::curve
