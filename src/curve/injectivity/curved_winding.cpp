// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/injectivity/curved_winding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "elements/bezier/bernstein.h"
#include "mesh/intersection/triangle_distance.h"

namespace mq::curve {

using elements::Lattice;

namespace {

constexpr double kPi = 3.14159265358979323846;

std::array<Vec3, 3> corners_of(const Lattice& lattice, const std::vector<Vec3>& control) {
    return {control[static_cast<std::size_t>(lattice.corner(0))], control[static_cast<std::size_t>(lattice.corner(1))],
            control[static_cast<std::size_t>(lattice.corner(2))]};
}

/// The largest distance between points of equal parameters of a patch and of the flat triangle of its corners.
double bend_of(const Lattice& lattice, const std::vector<Vec3>& control) {
    const std::array<Vec3, 3> corners = corners_of(lattice, control);
    double bend = 0.0;
    for (int i = 0; i < lattice.size(); ++i) {
        const elements::Barycentric at = lattice.node(i);
        const Vec3 flat = at[0] * corners[0] + at[1] * corners[1] + at[2] * corners[2];
        bend = std::max(bend, (control[static_cast<std::size_t>(i)] - flat).norm());
    }
    return bend;
}

/// The signed solid angle of a triangle; nothing if the point is so near to the triangle that the sign is not certain.
std::optional<double> solid_angle(const std::array<Vec3, 3>& corners, const Vec3& point) {
    constexpr double kNothing = 1e-12;
    const Vec3 a = (corners[0] - point).normalized();
    const Vec3 b = (corners[1] - point).normalized();
    const Vec3 c = (corners[2] - point).normalized();
    const double volume = a.dot(b.cross(c));
    const double rest = 1.0 + a.dot(b) + b.dot(c) + c.dot(a);
    if (rest <= kNothing && std::abs(volume) <= kNothing) {
        return std::nullopt;
    }
    return 2.0 * std::atan2(volume, rest);
}

/// The two corners with the longest straight edge between them.
std::pair<int, int> longest_edge_of(const std::array<Vec3, 3>& corners) {
    std::pair<int, int> longest{0, 1};
    double length = (corners[1] - corners[0]).squaredNorm();
    for (const std::pair<int, int>& edge : {std::pair{1, 2}, std::pair{0, 2}}) {
        const double other =
            (corners[static_cast<std::size_t>(edge.second)] - corners[static_cast<std::size_t>(edge.first)])
                .squaredNorm();
        if (other > length) {
            longest = edge;
            length = other;
        }
    }
    return longest;
}

/// The solid angle of a cone over the triangle between a halved edge and the middle of its curve. The tip of the cone
/// depends on the edge alone, so that the neighbour gets the opposite angle. The tip is outside of the plane of the
/// triangle, as points between an edge and its curve often lie in that plane.
std::optional<double> angle_of_gap(const Vec3& from, const Vec3& to, const Vec3& middle, const Vec3& point) {
    constexpr double kOut = 0.1;  // fraction of the height, so that the tip is as near to the edge as the middle is
    const Vec3 tip =
        (from + to + middle) / 3.0 + kOut * (middle - 0.5 * (from + to)).norm() * Vec3(0.61, 0.37, 0.7).normalized();
    double sum = 0.0;
    for (const std::array<Vec3, 3>& side :
         {std::array<Vec3, 3>{from, to, tip}, {to, middle, tip}, {middle, from, tip}}) {
        const std::optional<double> angle = solid_angle(side, point);
        if (!angle) {
            return std::nullopt;
        }
        sum += *angle;
    }
    return sum;
}

}  // namespace

std::optional<int> curved_winding(const Lattice& lattice, const std::vector<std::vector<Vec3>>& patches,
                                  const Vec3& point, double margin) {
    // Most pieces that are examined: enough for a point at a distance of a thousandth of the size from patches that
    // bend by all of it.
    constexpr int kMostPieces = 20'000;
    // Largest difference by rounding between the sum of angles and a whole number of turns.
    constexpr double kTurnRounding = 1e-6;
    std::vector<std::vector<Vec3>> waiting = patches;
    double sum = 0.0;
    for (int looked_at = 0; !waiting.empty(); ++looked_at) {
        const std::vector<Vec3> control = std::move(waiting.back());
        waiting.pop_back();
        const std::array<Vec3, 3> corners = corners_of(lattice, control);
        const Vec3 nearest = mesh::nearest_on_triangle(point, corners[0], corners[1], corners[2]);
        std::optional<double> angle;
        if ((nearest - point).norm() > bend_of(lattice, control) + margin) {
            angle = solid_angle(corners, point);
        } else if (looked_at < kMostPieces) {
            const auto [a, b] = longest_edge_of(corners);
            auto [first, second] = elements::halve(lattice, control, a, b);
            const Vec3& middle = first[static_cast<std::size_t>(lattice.corner(b))];
            const bool forward = b - a == 1;
            angle = angle_of_gap(corners[static_cast<std::size_t>(forward ? a : b)],
                                 corners[static_cast<std::size_t>(forward ? b : a)], middle, point);
            waiting.push_back(std::move(second));
            waiting.push_back(std::move(first));
        }
        if (!angle) {
            return std::nullopt;
        }
        sum += *angle / (4.0 * kPi);
    }
    const double turns = std::round(sum);
    return std::abs(sum - turns) < kTurnRounding ? std::optional<int>(static_cast<int>(turns)) : std::nullopt;
}

}  // namespace mq::curve
