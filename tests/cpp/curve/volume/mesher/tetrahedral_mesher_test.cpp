// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/volume/mesher/tetrahedral_mesher.h"

#include <gtest/gtest.h>

#include "base/child_process.h"
#include "curve/volume/mesher/netgen_filling.h"
#include "paths.h"

namespace mq::curve {
namespace {

struct Cube {
    std::vector<Vec3> points;
    std::vector<std::array<int, 3>> triangles{{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                              {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    Cube() {
        for (int i = 0; i < 8; ++i) {
            points.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
        }
        set_fill_program(fill_program());
    }
};

TEST(Fill, ACubeIsFilled) {
    const Cube cube;
    const TetrahedralFilling filling = fill(cube.points, cube.triangles, 1.0, Progress());
    double sum = 0.0;
    for (const auto& t : filling.tetrahedra) {
        const auto at = [&](std::size_t k) {
            const auto v = static_cast<std::size_t>(t[k]);
            return v < 8 ? cube.points[v] : filling.inner_points[v - 8];
        };
        const double six = (at(1) - at(0)).cross(at(2) - at(0)).dot(at(3) - at(0));
        EXPECT_GT(six, 0.0);
        sum += six / 6.0;
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_TRUE(filling.own_fault.empty());
}

TEST(Fill, NetgenFillsACubeInAProcessOfItsOwn) {
    const Cube cube;
    EXPECT_FALSE(fill_by_netgen(cube.points, cube.triangles, 1.0, Progress()).tetrahedra.empty());
}

TEST(Fill, AnOpenSurfaceIsRefused) {
    Cube cube;
    cube.triangles.pop_back();
    EXPECT_THROW(fill(cube.points, cube.triangles, 1.0, Progress()), MeshingFailed);
}

TEST(Fill, CanBeCancelled) {
    const Cube cube;
    Progress progress;
    progress.cancel();
    EXPECT_THROW(fill(cube.points, cube.triangles, 1.0, progress), Cancelled);
}

TEST(Fill, AMissingProgramIsNamed) {
    const Cube cube;
    set_fill_program("/nowhere/meshquality_fill");
    try {
        fill_by_netgen(cube.points, cube.triangles, 1.0, Progress());
        FAIL() << "nothing was thrown";
    } catch (const IoError& error) {
        EXPECT_NE(std::string(error.what()).find("/nowhere/meshquality_fill"), std::string::npos);
    }
}

TEST(ChildProcess, BytesGoThrough) {
    std::string input(1 << 20, 'x');
    input[12345] = 0;
    ChildProcess cat("/bin/cat");
    EXPECT_EQ(cat.exchange(input, Progress()), input);
    EXPECT_EQ(cat.end().fault, "");
}

TEST(ChildProcess, AFailureIsToldAndDoesNotHang) {
    ChildProcess program("/bin/false");
    EXPECT_EQ(program.exchange(std::string(1 << 20, 'x'), Progress()), "");
    EXPECT_NE(program.end().fault, "");
}

}  // namespace
}  // namespace mq::curve
