// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "base/vec.h"

namespace mq {

/// The kinds of point sets on which the predicates are tested.
enum class Points {
    kRandom,      ///< anywhere in a cube
    kSingle,      ///< the same, in single precision
    kGrid,        ///< small integers, scaled: many exact ties
    kShifted,     ///< small integers scaled and far from the origin: differences are rounded
    kCollinear,   ///< on one line, or nearly
    kCoincident,  ///< some of them the same
    kMagnitudes,  ///< coordinates from 1e-12 to 1e12
    /// Corners of regular polygons in space, rotated: isosceles, right angles, cocircular; with errors of single ulps.
    kRegular,
    kReflected,  ///< mirror images of each other: equal angles without equal coordinates; with errors of single ulps
};

/// All kinds, for parametrised tests.
constexpr std::array<Points, 9> kAllPoints{Points::kRandom,     Points::kSingle,    Points::kGrid,
                                           Points::kShifted,    Points::kCollinear, Points::kCoincident,
                                           Points::kMagnitudes, Points::kRegular,   Points::kReflected};

inline std::string name_of(Points kind) {
    static const std::array<const char*, 9> names{"Random",     "Single",     "Grid",    "Shifted",  "Collinear",
                                                  "Coincident", "Magnitudes", "Regular", "Reflected"};
    return names[static_cast<std::size_t>(kind)];
}

/// A reproducible stream of point sets of one kind.
class PointSource {
  public:
    PointSource(Points kind, std::uint64_t seed) : kind_(kind), random_(seed) {}

    std::vector<Vec3> take(int count) {
        std::vector<Vec3> points;
        switch (kind_) {
            case Points::kCollinear:
                points = collinear(count);
                break;
            case Points::kRegular:
                points = regular(count);
                break;
            case Points::kReflected:
                points = reflected(count);
                break;
            default:
                for (int i = 0; i < count; ++i) {
                    points.push_back(single(points));
                }
        }
        return points;
    }

    /// The same kinds in the plane.
    std::vector<Vec2> take_plane(int count) {
        in_plane_ = true;
        std::vector<Vec2> points;
        for (const Vec3& point : take(count)) {
            points.push_back(point.head<2>());
        }
        return points;
    }

    int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
    double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  private:
    Vec3 cube(double size) { return {real(-size, size), real(-size, size), real(-size, size)}; }
    Vec3 grid_point() { return Vec3(integer(-3, 3), integer(-3, 3), integer(-3, 3)); }

    Vec3 single(const std::vector<Vec3>& others) {
        switch (kind_) {
            case Points::kSingle:
                return to_single(cube(10.0));
            case Points::kGrid:
                return grid_point() * 0.1;
            case Points::kShifted:
                return nudge(grid_point() * 0.1 + Vec3(1e3, -7e3, 3e-2));
            case Points::kCoincident:
                return !others.empty() && integer(0, 1) == 0 ? others[integer(0, int(others.size()) - 1)] : cube(1.0);
            case Points::kMagnitudes:
                return cube(1.0).unaryExpr([this](double x) { return x * std::pow(10.0, integer(-12, 12)); });
            default:
                return cube(1.0);
        }
    }

    std::vector<Vec3> collinear(int count) {
        const Vec3 base = integer(0, 1) == 0 ? grid_point() : cube(1.0);
        const Vec3 direction = integer(0, 1) == 0 ? grid_point() : cube(1.0);
        std::vector<Vec3> points;
        for (int i = 0; i < count; ++i) {
            points.push_back(nudge(base + direction * integer(-4, 4)));
        }
        return points;
    }

    std::vector<Vec3> regular(int count) {
        /// Corners of the regular polygons, with a preference for squares.
        static constexpr std::array<int, 6> kCorners{3, 4, 4, 5, 6, 12};
        const int corners = kCorners[integer(0, 5)];
        const bool single_precision = integer(0, 2) == 0;
        const double phase = integer(0, 1) * real(0.0, 6.0);
        const double radius = std::pow(10.0, integer(-2, 3));
        const Vec3 center = integer(0, 1) * cube(radius);
        Vec3 x(1, 0, 0);
        Vec3 y(0, 1, 0);
        if (!in_plane_ && integer(0, 1) == 0) {
            x = cube(1.0).normalized();
            const Vec3 other = cube(1.0);
            y = (other - other.dot(x) * x).normalized();
        }
        std::vector<Vec3> points;
        for (int i = 0; i < count; ++i) {
            const double angle = phase + 2.0 * M_PI * integer(0, corners - 1) / corners;
            const bool middle = integer(0, 9) == 0;
            const Vec3 corner = middle ? center : Vec3(center + radius * (std::cos(angle) * x + std::sin(angle) * y));
            points.push_back(nudge(single_precision ? to_single(corner) : corner));
        }
        return points;
    }

    std::vector<Vec3> reflected(int count) {
        std::vector<Vec3> points;
        const Vec3 first = integer(0, 1) == 0 ? cube(1.0) : to_single(cube(1.0));
        for (int i = 0; i < count; ++i) {
            Vec3 image = first;
            if (integer(0, 3) == 0) {
                std::swap(image.x(), image.y());
            }
            for (int k = 0; k < 3; ++k) {
                image[k] *= integer(0, 1) == 0 ? 1.0 : -1.0;
            }
            points.push_back(nudge(image));
        }
        return points;
    }

    /// Often the point itself, else changed by single units in the last place.
    Vec3 nudge(Vec3 point) {
        if (integer(0, 2) == 0) {
            double& x = point[integer(0, in_plane_ ? 1 : 2)];
            x = std::nextafter(x, integer(0, 1) == 0 ? -1e300 : 1e300);
        }
        // A step from zero would leave the range in which predicates are exact.
        return point.unaryExpr([](double x) { return std::abs(x) < 1e-15 ? 0.0 : x; });
    }

    Points kind_;
    bool in_plane_ = false;
    std::mt19937_64 random_;
};

}  // namespace mq
