// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "base/vec.h"
#include "mesh/triangle_mesh.h"

namespace mq::mesh {

/// Triangles of many kinds: anywhere, on a coarse grid (equal and flat boxes), all the same, single points.
struct Soup {
    enum Kind { kRandom, kGrid, kSame, kPoints, kLine, kFar, kKinds };

    Soup(int kind, int count, std::uint64_t seed) {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> real(-1.0, 1.0);
        std::uniform_int_distribution<int> integer(-4, 4);
        for (int i = 0; i < count; ++i) {
            const Vec3 center(real(random), real(random), real(random));
            const Vec3 cell(integer(random), integer(random), integer(random));
            for (int k = 0; k < 3; ++k) {
                const Vec3 offset(real(random), real(random), real(random));
                vertices.push_back(point(kind, center, cell, offset, k));
            }
            triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        }
    }

    static Vec3 point(int kind, const Vec3& center, const Vec3& cell, const Vec3& offset, int k) {
        switch (kind) {
            case kGrid:
                return cell + Vec3(k == 1, k == 2, 0);
            case kSame:
                return Vec3(0.1 * k, 0.3, 0.7);
            case kPoints:
                return cell;
            case kLine:
                return Vec3(center.x() + 0.01 * offset.x(), 1.0 / 3.0, 0.0);
            case kFar:
                return Vec3(1e7, -3e7, 0.0) + center + 0.1 * offset;
            default:
                return center + 0.2 * offset;
        }
    }

    Box box(std::int32_t i) const {
        Box box;
        for (const std::int32_t v : triangles[i]) {
            box.add(vertices[v]);
        }
        return box;
    }

    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
};

}  // namespace mq::mesh
