// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/injectivity/hulls_apart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/tuning.h"

namespace mq::curve {

namespace {

/// At most four points of a convex set whose hull contains the point nearest to the origin.
class NearestSimplex {
  public:
    bool holds(const Vec3& p) const { return std::find(points_.begin(), points_.begin() + size_, p) != end(); }

    /// Adds a point and drops those that are no longer needed. @return the point nearest to the origin
    Vec3 add(const Vec3& p) {
        points_[static_cast<std::size_t>(size_++)] = p;
        best_ = std::numeric_limits<double>::infinity();
        for (unsigned mask = 1; mask < (1U << size_); ++mask) {
            try_face(mask);
        }
        points_ = kept_;
        size_ = kept_size_;
        return nearest_;
    }

  private:
    using Points = std::array<Vec3, 4>;

    Points::const_iterator end() const { return points_.begin() + size_; }

    /// Takes the point nearest to the origin of the plane through some of the points, if it lies between them.
    void try_face(unsigned mask) {
        Points face;
        int count = 0;
        for (int i = 0; i < size_; ++i) {
            if ((mask >> i & 1U) != 0) {
                face[static_cast<std::size_t>(count++)] = points_[static_cast<std::size_t>(i)];
            }
        }
        std::array<double, 3> t{};
        if (!weights(face, count, t)) {
            return;
        }
        double rest = 1.0;
        Vec3 point = face[0];
        for (std::size_t i = 1; i < static_cast<std::size_t>(count); ++i) {
            if (!(t[i - 1] > 0.0)) {
                return;
            }
            rest -= t[i - 1];
            point += t[i - 1] * (face[i] - face[0]);
        }
        if (rest > 0.0 && point.squaredNorm() < best_) {
            best_ = point.squaredNorm();
            nearest_ = point;
            kept_ = face;
            kept_size_ = count;
        }
    }

    /// Computes the weights of all points but the first. False if the points are not independent.
    static bool weights(const Points& face, int count, std::array<double, 3>& t) {
        if (count == 1) {
            return true;
        }
        const Vec3 to = -face[0];
        const Vec3 u = face[1] - face[0];
        if (count == 2) {
            t[0] = to.dot(u) / u.squaredNorm();
            return std::isfinite(t[0]);
        }
        const Vec3 v = face[2] - face[0];
        if (count == 3) {
            const Vec3 n = u.cross(v);
            const double square = n.squaredNorm();
            t[0] = to.cross(v).dot(n) / square;
            t[1] = u.cross(to).dot(n) / square;
            return std::isfinite(t[0]) && std::isfinite(t[1]);
        }
        const Vec3 w = face[3] - face[0];
        const double volume = u.cross(v).dot(w);
        t = {to.cross(v).dot(w) / volume, u.cross(to).dot(w) / volume, u.cross(v).dot(to) / volume};
        return std::isfinite(t[0]) && std::isfinite(t[1]) && std::isfinite(t[2]);
    }

    Points points_;
    Points kept_;
    int size_ = 0;
    int kept_size_ = 0;
    double best_ = 0.0;
    Vec3 nearest_ = Vec3::Zero();
};

/// The point of a convex set that is lowest along a direction, and whether all points are high enough along it.
struct Support {
    Vec3 point;
    bool separated;
};

/// @param support  (direction) -> Support
template <typename Find>
bool separable(Vec3 direction, const Find& support) {
    // Relative gain below which the nearest point counts as found.
    constexpr double kNoGain = 1e-12;
    NearestSimplex simplex;
    for (int round = 0; round < kMostSteps; ++round) {
        const double square = direction.squaredNorm();
        if (!(square > 0.0)) {
            return false;
        }
        const Support found = support(direction);
        if (found.separated) {
            return true;
        }
        const bool converged = round > 0 && square - direction.dot(found.point) <= kNoGain * square;
        if (converged || simplex.holds(found.point)) {
            return false;
        }
        direction = simplex.add(found.point);
    }
    return false;
}

Vec3 middle(const std::vector<Vec3>& points) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p : points) {
        sum += p;
    }
    return sum / static_cast<double>(points.size());
}

}  // namespace

bool hulls_apart(const std::vector<Vec3>& a, const std::vector<Vec3>& b, double margin) {
    return separable(middle(a) - middle(b), [&](const Vec3& direction) {
        const auto lower = [&](const Vec3& p, const Vec3& q) { return direction.dot(p) < direction.dot(q); };
        const Vec3 difference =
            *std::min_element(a.begin(), a.end(), lower) - *std::max_element(b.begin(), b.end(), lower);
        return Support{difference, direction.dot(difference) > margin * direction.norm()};
    });
}

bool in_open_half_space(const std::vector<Vec3>& vectors, double margin) {
    std::vector<Vec3> units(vectors.size());
    std::vector<double> margins(vectors.size());
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        const double length = vectors[i].norm();
        if (!(length > margin)) {
            return false;
        }
        units[i] = vectors[i] / length;
        margins[i] = margin / length;
    }
    return separable(middle(units), [&](const Vec3& direction) {
        const double norm = direction.norm();
        double least = std::numeric_limits<double>::infinity();
        Support found{Vec3::Zero(), true};
        for (std::size_t i = 0; i < units.size(); ++i) {
            const double along = direction.dot(units[i]);
            found.separated = found.separated && along > margins[i] * norm;
            if (along < least) {
                least = along;
                found.point = units[i];
            }
        }
        return found;
    });
}

}  // namespace mq::curve
