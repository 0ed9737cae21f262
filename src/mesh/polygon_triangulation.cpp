// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/polygon_triangulation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/chord_table.h"
#include "base/error.h"
#include "base/predicates.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py

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

/// Appends the best triangulation of a piece of the loop, given by positions in the loop in its direction.
void append_best(const std::vector<Vec3>& loop, const std::vector<std::int32_t>& part, const AvoidTriangle& avoid,
                 std::vector<Triangle>& triangles) {
    const auto to_be_avoided = [&](const Triangle& t, double area, double scale) {
        // Relative height far above rounding, so that exact arithmetic is needed only below it.
        constexpr double kFlat = 1e-10;
        return (area <= kFlat * scale && collinear(loop[t[0]], loop[t[1]], loop[t[2]])) || (avoid && avoid(t));
    };
    ChordTable<Weight> table;
    table.find(part.size(), {}, {std::numeric_limits<std::int32_t>::max(), 0.0},
               [&](std::size_t i, std::size_t k, std::size_t j, const Weight& left, const Weight& right, Weight& best) {
                   const Weight sides = left + right;
                   if (!(sides < best)) {
                       return false;
                   }
                   Weight whole = sides;
                   const Vec3& a = loop[part[i]];
                   const Vec3 u = loop[part[k]] - a;
                   const Vec3 v = loop[part[j]] - a;
                   whole.area += u.cross(v).norm();
                   if (whole < best && to_be_avoided({part[i], part[k], part[j]}, whole.area - sides.area,
                                                     u.squaredNorm() + v.squaredNorm())) {
                       ++whole.avoided;
                   }
                   const bool better = whole < best;
                   best = better ? whole : best;
                   return better;
               });
    table.for_each_triangle([&](std::size_t i, std::size_t k, std::size_t j) {
        triangles.push_back({part[i], part[k], part[j]});
    });
}

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
        throw InvalidInput(phrases::kSmallHole, {{"count", loop.size()}});
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
            append_best(loop, part, avoid, triangles);
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
