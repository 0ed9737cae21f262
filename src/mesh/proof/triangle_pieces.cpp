// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/proof/triangle_pieces.h"

#include <algorithm>
#include <cmath>

namespace mq::mesh {

Vec3 Piece::centre() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < count; ++k) {
        sum += corners[k];
    }
    return sum / static_cast<double>(count);
}

double Piece::farthest_from(const Vec3& p) const {
    double most = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
        most = std::max(most, (corners[k] - p).squaredNorm());
    }
    return std::sqrt(most);
}

double Piece::farthest_from(const Corners& t) const {
    double most = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
        most = std::max(most, (nearest_on_triangle(corners[k], t[0], t[1], t[2]) - corners[k]).squaredNorm());
    }
    return std::sqrt(most);
}

std::array<Plane, 3> upright(const Corners& t) {
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
    return {Plane{t[0], (t[1] - t[0]).cross(normal)}, Plane{t[1], (t[2] - t[1]).cross(normal)},
            Plane{t[2], (t[0] - t[2]).cross(normal)}};
}

std::array<Piece, 2> cut(const Piece& piece, const Plane& plane) {
    constexpr double kNext = 1e-6;  // a multiple of the size of the piece
    const auto after = [&](std::size_t k) { return k + 1 < piece.count ? k + 1 : 0; };
    std::array<double, Piece::kMostCorners> height{};
    double size = 0.0;
    for (std::size_t k = 0; k < piece.count; ++k) {
        size = std::max(size, (piece.corners[k] - piece.corners[0]).squaredNorm());
    }
    const double next = kNext * std::sqrt(size) * plane.normal.norm();
    bool has_front = false;
    std::size_t crossed = 0;
    for (std::size_t k = 0; k < piece.count; ++k) {
        height[k] = plane.height(piece.corners[k]);
        height[k] = std::abs(height[k]) <= next ? 0.0 : height[k];
        has_front = has_front || height[k] > 0.0;
    }
    for (std::size_t k = 0; k < piece.count; ++k) {
        crossed += height[k] < 0.0 && height[after(k)] >= 0.0 ? 1 : 0;
    }
    std::array<Piece, 2> parts;
    if (crossed != 1 || !has_front) {
        parts[has_front ? 1 : 0] = piece;
        return parts;
    }
    parts[0].halvings = parts[1].halvings = piece.halvings;
    for (std::size_t k = 0; k < piece.count; ++k) {
        if (height[k] <= 0.0) {
            parts[0].add(piece.corners[k]);
        }
        if (height[k] >= 0.0) {
            parts[1].add(piece.corners[k]);
        }
        if (height[k] * height[after(k)] < 0.0) {
            const double share = height[k] / (height[k] - height[after(k)]);
            const Vec3 between = piece.corners[k] + share * (piece.corners[after(k)] - piece.corners[k]);
            parts[0].add(between);
            parts[1].add(between);
        }
    }
    return parts;
}

std::array<Piece, 2> halves(const Piece& piece) {
    std::array<Piece, 2> parts;
    if (piece.has_many()) {
        const std::size_t half = piece.count / 2;
        for (std::size_t k = 0; k <= piece.count; ++k) {
            if (k <= half) {
                parts[0].add(piece.corners[k]);
            }
            if (k >= half) {
                parts[1].add(piece.corners[k % piece.count]);
            }
        }
    } else {
        std::size_t longest = 0;
        double most = -1.0;
        for (std::size_t k = 0; k < piece.count; ++k) {
            const double length = (piece.corners[(k + 1) % piece.count] - piece.corners[k]).squaredNorm();
            if (length > most) {
                most = length;
                longest = k;
            }
        }
        const Vec3& from = piece.corners[longest];
        const Vec3& to = piece.corners[(longest + 1) % piece.count];
        parts = cut(piece, {0.5 * (from + to), to - from});
    }
    parts[0].halvings = parts[1].halvings = piece.halvings + 1;
    return parts;
}

}  // namespace mq::mesh
