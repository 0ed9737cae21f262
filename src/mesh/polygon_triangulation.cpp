// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/polygon_triangulation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/predicates.h"

namespace mq::mesh {
namespace {

/// The objective of a triangulation: the number of avoided triangles first, then the area.
struct Weight {
    std::int32_t avoided = 0;
    double area = 0.0;  ///< twice the area, mm^2

    friend bool operator<(const Weight& a, const Weight& b) {
        return a.avoided != b.avoided ? a.avoided < b.avoided : a.area < b.area;
    }
    friend Weight operator+(const Weight& a, const Weight& b) { return {a.avoided + b.avoided, a.area + b.area}; }
};

/// The best triangulations of all polygons i..j that a chord i-j cuts off.
class LeastArea {
  public:
    /// @param part positions in the loop, in its direction
    LeastArea(const std::vector<Vec3>& loop, const std::vector<std::int32_t>& part, const AvoidTriangle& avoid)
        : loop_(loop), part_(part), avoid_(avoid), best_(part.size() * part.size()), apex_(best_.size(), -1) {
        const std::size_t count = part.size();
        for (std::size_t length = 2; length < count; ++length) {
            for (std::size_t i = 0; i + length < count; ++i) {
                choose(i, i + length);
            }
        }
    }

    void append_to(std::vector<Triangle>& triangles) const {
        std::vector<std::array<std::size_t, 2>> chords{{0, part_.size() - 1}};
        while (!chords.empty()) {
            const auto [i, j] = chords.back();
            chords.pop_back();
            if (j - i < 2) {
                continue;
            }
            const auto k = static_cast<std::size_t>(apex_[at(i, j)]);
            triangles.push_back({part_[i], part_[k], part_[j]});
            chords.push_back({k, j});
            chords.push_back({i, k});
        }
    }

  private:
    std::size_t at(std::size_t i, std::size_t j) const { return i * part_.size() + j; }

    void choose(std::size_t i, std::size_t j) {
        Weight best{std::numeric_limits<std::int32_t>::max(), 0.0};
        std::int32_t apex = -1;
        for (std::size_t k = i + 1; k < j; ++k) {
            const Weight sides = best_[at(i, k)] + best_[at(k, j)];
            if (!(sides < best)) {
                continue;
            }
            Weight whole = sides;
            const Vec3& a = loop_[part_[i]];
            const Vec3 u = loop_[part_[k]] - a;
            const Vec3 v = loop_[part_[j]] - a;
            whole.area += u.cross(v).norm();
            if (whole < best) {
                whole.avoided += to_be_avoided(i, k, j, whole.area - sides.area, u.squaredNorm() + v.squaredNorm());
            }
            if (whole < best) {
                best = whole;
                apex = static_cast<std::int32_t>(k);
            }
        }
        best_[at(i, j)] = best;
        apex_[at(i, j)] = apex;
    }

    bool to_be_avoided(std::size_t i, std::size_t k, std::size_t j, double area, double scale) const {
        // Relative height far above rounding, so that exact arithmetic is needed only below it.
        constexpr double kFlat = 1e-10;
        if (area <= kFlat * scale && collinear(loop_[part_[i]], loop_[part_[k]], loop_[part_[j]])) {
            return true;
        }
        return avoid_ && avoid_({part_[i], part_[k], part_[j]});
    }

    const std::vector<Vec3>& loop_;
    const std::vector<std::int32_t>& part_;
    const AvoidTriangle& avoid_;
    std::vector<Weight> best_;  ///< best triangulation of the polygon from i to j
    std::vector<std::int32_t> apex_;
};

/// The shortest chord between vertices of the polygon that are at least a quarter of it apart. Very long polygons are
/// sampled.
std::array<std::size_t, 2> dividing_chord(const std::vector<Vec3>& loop, const std::vector<std::int32_t>& part) {
    // Vertices of a sampled polygon: the number of chords is quadratic in them.
    constexpr std::size_t kSamples = 2000;
    const std::size_t count = part.size();
    const std::size_t step = (count + kSamples - 1) / kSamples;
    std::array<std::size_t, 2> chord{0, count / 2};
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count; i += step) {
        for (std::size_t j = i + count / 4; j < count && j - i <= count - count / 4; j += step) {
            const double length = (loop[part[j]] - loop[part[i]]).squaredNorm();
            if (length < shortest) {
                shortest = length;
                chord = {i, j};
            }
        }
    }
    return chord;
}

}  // namespace

std::vector<mesh::Triangle> fill_hole(const std::vector<Vec3>& loop, const AvoidTriangle& avoid,
                                      const Progress* progress) {
    if (loop.size() < 3) {
        throw InvalidInput("a hole has at least three vertices, this one " + std::to_string(loop.size()));
    }
    std::vector<Triangle> triangles;
    triangles.reserve(loop.size() - 2);
    std::vector<std::vector<std::int32_t>> parts(1);
    for (std::size_t i = 0; i < loop.size(); ++i) {
        parts[0].push_back(static_cast<std::int32_t>(i));
    }
    while (!parts.empty()) {
        check_cancelled(progress);
        const std::vector<std::int32_t> part = std::move(parts.back());
        parts.pop_back();
        if (part.size() <= kLongestWholeLoop) {
            LeastArea(loop, part, avoid).append_to(triangles);
            continue;
        }
        const auto [i, j] = dividing_chord(loop, part);
        parts.emplace_back(part.begin() + i, part.begin() + j + 1);
        std::vector<std::int32_t> rest(part.begin() + j, part.end());
        rest.insert(rest.end(), part.begin(), part.begin() + i + 1);
        parts.push_back(std::move(rest));
    }
    return triangles;
}

}  // namespace mq::mesh
