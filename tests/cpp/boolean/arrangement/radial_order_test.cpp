// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/arrangement/radial_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace mq::boolean {
namespace {

TEST(RadialOrder, IsCounterClockwiseFromTheFirstFace) {
    // Apexes around the z axis, at random distances and heights.
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> real(0.5, 2.0);
    constexpr int kFaces = 24;
    Soup soup;
    soup.vertices = {{0, 0, 0}, {0, 0, 1}};
    std::vector<RadialFace> faces;
    for (int i = 0; i < kFaces; ++i) {
        const double angle = 2.0 * M_PI * (i + 0.25) / kFaces;
        soup.vertices.push_back(real(random) * Vec3(std::cos(angle), std::sin(angle), real(random)));
        const bool up = i % 2 == 0;
        soup.triangles.push_back(up ? Triangle{0, 1, i + 2} : Triangle{1, 0, i + 2});
        faces.push_back({i, i + 2, up, i});
    }
    const PointTable points(soup);
    for (int turn = 0; turn < 20; ++turn) {
        std::shuffle(faces.begin(), faces.end(), random);
        const std::int32_t first = faces.front().face;
        sort_radially(points, 0, 1, faces);
        for (int i = 0; i < kFaces; ++i) {
            EXPECT_EQ(faces[static_cast<std::size_t>(i)].face, (first + i) % kFaces);
            EXPECT_EQ(faces[static_cast<std::size_t>(i)].runs_up, faces[static_cast<std::size_t>(i)].face % 2 == 0);
        }
    }
}

TEST(RadialOrder, TellsAHalfPlaneFromTheOppositeOne) {
    // The last apex deviates from the plane of the first two by the least number there is.
    Soup soup;
    soup.vertices = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 0, 5}, {-1, std::nextafter(0.0, 1.0), 0}};
    const PointTable points(soup);
    soup.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
    std::vector<RadialFace> faces{{0, 2, true, 0}, {1, 3, true, 1}, {2, 4, true, 2}};
    sort_radially(points, 0, 1, faces);
    EXPECT_EQ(faces[0].face, 0);
    EXPECT_EQ(faces[1].face, 2) << "less than half a turn from the first";
    EXPECT_EQ(faces[2].face, 1) << "half a turn";
}

}  // namespace
}  // namespace mq::boolean
