// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "base/vec.h"

namespace mq::tetrahedralise {

/// A closed surface, outward.
struct ClosedSurface {
    std::vector<Vec3> points;
    std::vector<std::array<int, 3>> triangles;

    double volume() const {
        double six = 0.0;
        for (const auto& t : triangles) {
            // Relative to a vertex, for the sake of rounding.
            const Vec3& o = points.front();
            six += (points[t[0]] - o).dot((points[t[1]] - o).cross(points[t[2]] - o));
        }
        return six / 6.0;
    }
    /// The other one as well; a void where it is inverted.
    void add(const ClosedSurface& other) {
        const int first = static_cast<int>(points.size());
        points.insert(points.end(), other.points.begin(), other.points.end());
        for (const auto& t : other.triangles) {
            triangles.push_back({first + t[0], first + t[1], first + t[2]});
        }
    }
    ClosedSurface inverted() const {
        ClosedSurface other = *this;
        for (auto& t : other.triangles) {
            std::swap(t[0], t[1]);
        }
        return other;
    }
};

/// A box from the origin with n squares along each side, two triangles a square.
inline ClosedSurface box(const Vec3& size, int n) {
    ClosedSurface surface;
    std::map<std::array<int, 3>, int> number;
    const auto vertex = [&](std::array<int, 3> at) {
        const auto [found, fresh] = number.emplace(at, static_cast<int>(surface.points.size()));
        if (fresh) {
            surface.points.emplace_back(size.x() * at[0] / n, size.y() * at[1] / n, size.z() * at[2] / n);
        }
        return found->second;
    };
    for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {0, n}) {
            for (int i = 0; i < n; ++i) {
                for (int k = 0; k < n; ++k) {
                    const auto corner = [&](int x, int y) {
                        std::array<int, 3> at{};
                        at[axis] = side;
                        at[(axis + 1) % 3] = i + x;
                        at[(axis + 2) % 3] = k + y;
                        return vertex(at);
                    };
                    std::array<int, 3> first{corner(0, 0), corner(1, 0), corner(1, 1)};
                    std::array<int, 3> second{corner(0, 0), corner(1, 1), corner(0, 1)};
                    if (side == 0) {
                        std::swap(first[0], first[1]);
                        std::swap(second[0], second[1]);
                    }
                    surface.triangles.push_back(first);
                    surface.triangles.push_back(second);
                }
            }
        }
    }
    return surface;
}

/// A torus with n by m squares.
inline ClosedSurface torus(double major, double minor, int n, int m) {
    ClosedSurface surface;
    for (int i = 0; i < n; ++i) {
        for (int k = 0; k < m; ++k) {
            const double u = 2.0 * M_PI * i / n;
            const double v = 2.0 * M_PI * k / m;
            const double r = major + minor * std::cos(v);
            surface.points.emplace_back(r * std::cos(u), r * std::sin(u), minor * std::sin(v));
        }
    }
    const auto at = [&](int i, int k) { return (i % n) * m + k % m; };
    for (int i = 0; i < n; ++i) {
        for (int k = 0; k < m; ++k) {
            surface.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
            surface.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
        }
    }
    return surface;
}

/// A sphere around the origin: a box whose points are moved to it.
inline ClosedSurface sphere(double radius, int n) {
    ClosedSurface surface = box(Vec3(2.0, 2.0, 2.0), n);
    for (Vec3& p : surface.points) {
        p = radius * (p - Vec3(1.0, 1.0, 1.0)).normalized();
    }
    return surface;
}

/// A sphere whose points are moved in and out along their rays at random, which makes it no more than star-shaped.
inline ClosedSurface rough_ball(int n, double roughness, unsigned seed) {
    ClosedSurface surface = sphere(1.0, n);
    std::mt19937 dice(seed);
    std::uniform_real_distribution<double> factor(1.0 - roughness, 1.0);
    for (Vec3& p : surface.points) {
        p *= factor(dice);
    }
    return surface;
}

/// A prism whose upper triangle is turned. With one of the two diagonals of its sides no tetrahedra fill it without a
/// point inside (Schoenhardt 1928).
inline ClosedSurface turned_prism(bool other_diagonal) {
    ClosedSurface surface;
    for (const double z : {0.0, 1.0}) {
        for (int i = 0; i < 3; ++i) {
            const double angle = 2.0 * M_PI * i / 3.0 + z * M_PI / 6.0;
            surface.points.emplace_back(std::cos(angle), std::sin(angle), z);
        }
    }
    surface.triangles = {{0, 2, 1}, {3, 4, 5}};
    for (int i = 0; i < 3; ++i) {
        const int k = (i + 1) % 3;
        if (other_diagonal) {
            surface.triangles.push_back({i, k, 3 + i});
            surface.triangles.push_back({k, 3 + k, 3 + i});
        } else {
            surface.triangles.push_back({i, k, 3 + k});
            surface.triangles.push_back({i, 3 + k, 3 + i});
        }
    }
    return surface;
}

}  // namespace mq::tetrahedralise
