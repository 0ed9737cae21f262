// SPDX-License-Identifier: LGPL-2.1-or-later
#include "offset/contoured/side_proof.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "offset/contoured/tuning.h"

namespace mq::offset {

bool SideProof::is_within(const Tetrahedron& cell, const Ball& ball, const contour::LevelSample& level) const {
    if (level.value + ball.radius <= slack_) {
        return true;
    }
    const double most = level_set_.distance() + slack_;
    return std::all_of(cell.begin(), cell.end(), [&](const Vec3& corner) {
        return (level_set_.nearest(corner, level.source) - corner).squaredNorm() <= most * most;
    });
}

bool SideProof::is_outside(const Tetrahedron& cell, const Ball& ball, const contour::LevelSample& level) const {
    if (level.value - ball.radius >= -slack_) {
        return true;
    }
    // Distances inside of a solid are negative: no tangent bounds them.
    return level.value + level_set_.distance() > 0.0 && is_farther_from_all(cell, ball, level_set_.distance() - slack_);
}

/// Whether the tangents of the distances from all triangles show that the cell is at least that far from each.
bool SideProof::is_farther_from_all(const Tetrahedron& cell, const Ball& ball, double least) const {
    const double most = least + ball.radius;
    bool holds = true;
    int asked = 0;
    level_set_.tree().for_each_divided(
        [&](std::int32_t node) {
            const Box box = level_set_.tree().node_box(node);
            const Vec3 beside = (box.low - ball.middle).cwiseMax(ball.middle - box.high).cwiseMax(0.0);
            return holds && beside.squaredNorm() < most * most;
        },
        [&](std::int32_t triangle) {
            if (!holds) {
                return;
            }
            const Vec3 away = ball.middle - level_set_.nearest(ball.middle, triangle);
            const double distance = away.norm();
            if (distance >= most) {
                return;
            }
            double lowest = 0.0;
            for (const Vec3& corner : cell) {
                lowest = std::min(lowest, away.dot(corner - ball.middle));
            }
            // Dividing is cheaper than evaluating all triangles that are near to a large cell.
            holds =
                distance > 0.0 && distance + lowest / distance >= least && ++asked <= ContouredOffsetTuning::kMostAsked;
        });
    return holds;
}

bool SideProof::proves(const Tetrahedron& cell, bool outside, std::int32_t guess) const {
    return proves(cell, outside, guess, 0);
}

bool SideProof::proves(const Tetrahedron& cell, bool outside, std::int32_t guess, int divisions) const {
    Ball ball{0.25 * (cell[0] + cell[1] + cell[2] + cell[3]), 0.0};
    for (const Vec3& corner : cell) {
        ball.radius = std::max(ball.radius, (corner - ball.middle).norm());
    }
    const contour::LevelSample level = level_set_.at(ball.middle, guess);
    if (outside ? level.value < -slack_ : level.value > slack_) {
        return false;
    }
    if (outside ? is_outside(cell, ball, level) : is_within(cell, ball, level)) {
        return true;
    }
    if (divisions == ContouredOffsetTuning::kDivisions) {
        return false;
    }
    std::array<std::size_t, 2> longest{0, 1};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = i + 1; j < 4; ++j) {
            if ((cell[i] - cell[j]).squaredNorm() > (cell[longest[0]] - cell[longest[1]]).squaredNorm()) {
                longest = {i, j};
            }
        }
    }
    const Vec3 middle = 0.5 * (cell[longest[0]] + cell[longest[1]]);
    return std::all_of(longest.begin(), longest.end(), [&](std::size_t end) {
        Tetrahedron half = cell;
        half[end] = middle;
        return proves(half, outside, level.source, divisions + 1);
    });
}

}  // namespace mq::offset
