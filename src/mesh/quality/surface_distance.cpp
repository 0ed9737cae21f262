// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/quality/surface_distance.h"

#include <algorithm>
#include <array>
#include <vector>

#include "base/error.h"
#include "base/parallel.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "mesh/intersection/nearest_tree.h"

namespace mq::mesh {

namespace {

constexpr std::size_t kBlock = 4096;  // triangles in one parallel task

/// The result of one task; `mean` is the sum until all tasks are joined.
struct Part {
    SurfaceDistance distance;
    double area = 0.0;

    void add(const TriangleMesh& from, const Triangle& t, const NearestTree& to) {
        const Vec3& a = from.vertices[static_cast<std::size_t>(t[0])];
        const Vec3& b = from.vertices[static_cast<std::size_t>(t[1])];
        const Vec3& c = from.vertices[static_cast<std::size_t>(t[2])];
        const double weight = (b - a).cross(c - a).norm();
        for (const Vec3& p : std::array<Vec3, 4>{a, b, c, Vec3((a + b + c) / 3.0)}) {
            const double d = to.nearest(p).distance;
            distance.mean += 0.25 * weight * d;
            if (d > distance.largest) {
                distance.largest = d;
                distance.where = p;
            }
        }
        area += weight;
    }
};

}  // namespace

SurfaceDistance surface_distance(const TriangleMesh& from, const TriangleMesh& to, const Progress& progress) {
    if (from.triangles.empty() != to.triangles.empty()) {
        throw InvalidInput(phrases::kNoDistance);
    }
    const NearestTree tree(to.vertices, to.triangles);
    std::vector<Part> parts((from.triangles.size() + kBlock - 1) / kBlock);
    parallel_for(static_cast<int>(parts.size()), [&](int k) {
        progress.check();
        const std::size_t first = static_cast<std::size_t>(k) * kBlock;
        const std::size_t last = std::min(first + kBlock, from.triangles.size());
        for (std::size_t t = first; t < last; ++t) {
            parts[static_cast<std::size_t>(k)].add(from, from.triangles[t], tree);
        }
    });
    Part sum;
    for (const Part& part : parts) {
        sum.area += part.area;
        sum.distance.mean += part.distance.mean;
        if (part.distance.largest > sum.distance.largest) {
            sum.distance.largest = part.distance.largest;
            sum.distance.where = part.distance.where;
        }
    }
    sum.distance.mean /= sum.area > 0.0 ? sum.area : 1.0;
    return sum.distance;
}

}  // namespace mq::mesh
