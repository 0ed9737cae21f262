// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/contoured/side_proof.h"

#include <gtest/gtest.h>

#include <random>

#include "boolean/closed_solids.h"

namespace mq::offset {
namespace {

TEST(SideProof, WhatItProvesHolds) {
    const mesh::TriangleMesh ball = boolean::solids::sphere(Vec3(0, 0, 0), 5.0, 16);
    const OffsetSurface surface{ball.vertices, ball.triangles, std::vector<std::int32_t>(ball.triangles.size(), 0),
                                true};
    const DistanceLevelSet level_set(surface, 1.0, 1e-6);
    constexpr double kSlack = 0.05;
    const SideProof proof(level_set, kSlack);
    std::mt19937 random(3);
    const auto number = [&] { return random() / 4294967296.0; };
    int proven = 0;
    int missed = 0;
    for (int round = 0; round < 400; ++round) {
        const Vec3 near =
            6.0 * Vec3(number() - 0.5, number() - 0.5, number() - 0.5).normalized() * (0.95 + 0.1 * number());
        Tetrahedron cell;
        for (Vec3& corner : cell) {
            corner = near + 0.5 * Vec3(number() - 0.5, number() - 0.5, number() - 0.5);
        }
        double lowest = 1e9;
        double highest = -1e9;
        for (int k = 0; k < 60; ++k) {
            double weights[4] = {number(), number(), number(), number()};
            const double sum = weights[0] + weights[1] + weights[2] + weights[3];
            Vec3 p = Vec3::Zero();
            for (int i = 0; i < 4; ++i) {
                p += weights[i] / sum * cell[static_cast<std::size_t>(i)];
            }
            lowest = std::min(lowest, level_set.at(p, -1).value);
            highest = std::max(highest, level_set.at(p, -1).value);
        }
        if (proof.proves(cell, false, -1)) {
            EXPECT_LE(highest, kSlack);
            ++proven;
        } else {
            missed += highest < -kSlack ? 1 : 0;
        }
        if (proof.proves(cell, true, -1)) {
            EXPECT_GE(lowest, -kSlack);
            ++proven;
        } else {
            missed += lowest > kSlack ? 1 : 0;
        }
    }
    EXPECT_GT(proven, 200);
    EXPECT_LT(missed, 10);
}

TEST(SideProof, AThinSheetInACellIsFound) {
    // All corners are farther than 1 from the sheet, which goes through the cell.
    const OffsetSurface sheet{{Vec3(-0.01, -0.01, 0), Vec3(0.01, -0.01, 0), Vec3(0, 0.01, 0)}, {{0, 1, 2}}, {0}, false};
    const DistanceLevelSet level_set(sheet, 1.0, 1e-6);
    const SideProof proof(level_set, 0.1);
    const Tetrahedron cell{Vec3(-3, -3, -3), Vec3(3, 3, -3), Vec3(3, -3, 3), Vec3(-3, 3, 3)};
    EXPECT_FALSE(proof.proves(cell, true, -1));
}

}  // namespace
}  // namespace mq::offset
