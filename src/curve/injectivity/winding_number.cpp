// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/injectivity/winding_number.h"

#include <array>
#include <cmath>
#include <utility>

#include "curve/bezier/bernstein.h"
#include "mesh/intersection/aabb_tree.h"

namespace mq::curve {

namespace {

constexpr double kPi = 3.14159265358979323846;

std::array<Vec3, 3> corners_of(const Lattice& lattice, const std::vector<Vec3>& control) {
    return {control[static_cast<std::size_t>(lattice.corner(0))], control[static_cast<std::size_t>(lattice.corner(1))],
            control[static_cast<std::size_t>(lattice.corner(2))]};
}

/// The largest distance between points of equal parameters of a patch and of its flat triangle.
double bend_of(const Lattice& lattice, const std::vector<Vec3>& control) {
    const std::array<Vec3, 3> corners = corners_of(lattice, control);
    double bend = 0.0;
    for (int i = 0; i < lattice.size(); ++i) {
        const Barycentric at = lattice.node(i);
        const Vec3 flat = at[0] * corners[0] + at[1] * corners[1] + at[2] * corners[2];
        bend = std::max(bend, (control[static_cast<std::size_t>(i)] - flat).norm());
    }
    return bend;
}

double solid_angle(const std::array<Vec3, 3>& corners, const Vec3& point) {
    const Vec3 a = (corners[0] - point).normalized();
    const Vec3 b = (corners[1] - point).normalized();
    const Vec3 c = (corners[2] - point).normalized();
    return 2.0 * std::atan2(a.dot(b.cross(c)), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
}

/// Four pieces that have halves of each edge.
std::vector<std::vector<Vec3>> divided(const Lattice& lattice, const std::vector<std::vector<Vec3>>& patches) {
    std::vector<std::vector<Vec3>> pieces;
    const auto add_halves = [&](const std::vector<Vec3>& control, int a, int b) {
        auto [first, second] = halve(lattice, control, a, b);
        pieces.push_back(std::move(first));
        pieces.push_back(std::move(second));
    };
    for (const std::vector<Vec3>& control : patches) {
        const auto [first, second] = halve(lattice, control, 0, 1);
        add_halves(first, 0, 2);
        add_halves(second, 1, 2);
    }
    return pieces;
}

}  // namespace

std::optional<int> winding_number(const Lattice& lattice, const std::vector<std::vector<Vec3>>& patches,
                                  const Vec3& point, double margin) {
    // Divisions of all patches: the smallest pieces have a sixteenth of the length, and bend 256 times less.
    constexpr int kMostDivisions = 4;
    // How far the sum may be from a whole number of turns by rounding.
    constexpr double kRounding = 1e-6;
    std::vector<std::vector<Vec3>> pieces = patches;
    for (int round = 0; round <= kMostDivisions; ++round) {
        double sum = 0.0;
        bool clear = true;
        for (std::size_t i = 0; i < pieces.size() && clear; ++i) {
            const std::array<Vec3, 3> corners = corners_of(lattice, pieces[i]);
            const Vec3 nearest = mesh::nearest_on_triangle(point, corners[0], corners[1], corners[2]);
            clear = (nearest - point).norm() > bend_of(lattice, pieces[i]) + margin;
            sum += clear ? solid_angle(corners, point) / (4.0 * kPi) : 0.0;
        }
        if (clear) {
            const double turns = std::round(sum);
            return std::abs(sum - turns) < kRounding ? std::optional<int>(static_cast<int>(turns)) : std::nullopt;
        }
        pieces = divided(lattice, pieces);
    }
    return std::nullopt;
}

}  // namespace mq::curve
