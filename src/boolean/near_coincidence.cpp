// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/near_coincidence.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/triangle_tree.h"

namespace mq::boolean {

namespace {

// Triangles whose normals enclose less than 18 degrees, or more than 162.
constexpr double kParallel = 0.95;

Vec3 area_normal(const Soup& soup, std::int32_t t) {
    const Triangle& c = soup.triangles[static_cast<std::size_t>(t)];
    const Vec3& a = soup.vertices[static_cast<std::size_t>(c[0])];
    return (soup.vertices[static_cast<std::size_t>(c[1])] - a).cross(soup.vertices[static_cast<std::size_t>(c[2])] - a);
}

bool parallel_operands(const Soup& soup, const mesh::ContactPair& pair) {
    if (soup.source[static_cast<std::size_t>(pair.a)].operand ==
        soup.source[static_cast<std::size_t>(pair.b)].operand) {
        return false;
    }
    const Vec3 m = area_normal(soup, pair.a);
    const Vec3 n = area_normal(soup, pair.b);
    return std::abs(m.dot(n)) > kParallel * m.norm() * n.norm();
}

/// How far the vertices of one lie from the other's plane at most.
double depth(const Soup& soup, const mesh::ContactPair& pair) {
    double result = 0.0;
    for (const auto& [own, other] : {std::pair(pair.a, pair.b), std::pair(pair.b, pair.a)}) {
        const Vec3 n = area_normal(soup, other).normalized();
        const Vec3& o = soup.vertices[static_cast<std::size_t>(soup.triangles[static_cast<std::size_t>(other)][0])];
        for (const std::int32_t v : soup.triangles[static_cast<std::size_t>(own)]) {
            result = std::max(result, std::abs(n.dot(soup.vertices[static_cast<std::size_t>(v)] - o)));
        }
    }
    return result;
}

/// The depth that nearly all crossings stay below; 0 when there are none.
double usual_depth(const Soup& soup, const std::vector<mesh::ContactPair>& crossing) {
    std::vector<double> depths;
    for (const mesh::ContactPair& pair : crossing) {
        if (parallel_operands(soup, pair)) {
            depths.push_back(depth(soup, pair));
        }
    }
    if (depths.empty()) {
        return 0.0;
    }
    const auto most = depths.begin() + static_cast<std::ptrdiff_t>(0.98 * static_cast<double>(depths.size() - 1));
    std::nth_element(depths.begin(), most, depths.end());
    return *most;
}

/// +1: the later operand's surface goes into the material of the earlier one; -1: out of it; 0: it stays.
int way_of(Operation operation, std::int32_t earlier) {
    switch (operation) {
        case Operation::Union:
            return 1;
        case Operation::Intersection:
            return -1;
        case Operation::Difference:
            // All but the first are joined, and then taken away.
            return earlier == 0 ? -1 : 1;
        case Operation::SymmetricDifference:
            break;
    }
    return 0;
}

}  // namespace

bool run_along(const Soup& soup, const std::vector<mesh::ContactPair>& crossing) {
    constexpr double kPartOfTriangles = 0.05;
    const auto many = static_cast<std::ptrdiff_t>(kPartOfTriangles * static_cast<double>(soup.triangles.size()));
    const auto parallel = std::count_if(crossing.begin(), crossing.end(), [&](const mesh::ContactPair& pair) {
        return pair.contact == mesh::Contact::Crossing && parallel_operands(soup, pair);
    });
    return parallel > std::max<std::ptrdiff_t>(many, 64);
}

NearCoincidence separate(Soup& soup, Operation operation, double tolerance,
                         const std::vector<mesh::ContactPair>& crossing, const Progress& progress) {
    NearCoincidence result;
    // Far enough that surfaces which bend between the vertices stay apart.
    const double step = 2.0 * usual_depth(soup, crossing);
    if (step <= 0.0 || 2.0 * step > tolerance) {
        return result;
    }
    std::vector<std::int32_t> operand(soup.vertices.size(), -1);
    std::vector<Vec3> normal(soup.vertices.size(), Vec3::Zero());
    std::vector<std::vector<std::int32_t>> triangles(static_cast<std::size_t>(soup.operands));
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        const std::int32_t own = soup.source[t].operand;
        triangles[static_cast<std::size_t>(own)].push_back(static_cast<std::int32_t>(t));
        for (const std::int32_t v : soup.triangles[t]) {
            operand[static_cast<std::size_t>(v)] = own;
            normal[static_cast<std::size_t>(v)] += area_normal(soup, static_cast<std::int32_t>(t));
        }
    }
    soup.moved.assign(soup.vertices.size(), 0);
    Pace pace(progress);
    for (std::int32_t earlier = 0; earlier + 1 < soup.operands; ++earlier) {
        const mesh::TriangleTree tree(soup.vertices, soup.triangles, triangles[static_cast<std::size_t>(earlier)]);
        for (std::size_t v = 0; v < soup.vertices.size(); ++v) {
            pace.step();
            if (operand[v] <= earlier || soup.moved[v] != 0) {
                continue;
            }
            const mesh::Nearest near = tree.nearest(soup.vertices[v], step);
            if (near.triangle < 0) {
                continue;
            }
            const Vec3 n = area_normal(soup, near.triangle).normalized();
            const double along = n.dot(normal[v].normalized());
            const int way = way_of(operation, earlier);
            if (way == 0 || std::abs(along) < kParallel) {
                continue;
            }
            const Vec3 target = (near.point - way * step * n).cast<float>().cast<double>();
            result.largest = std::max(result.largest, (target - soup.vertices[v]).norm());
            soup.vertices[v] = target;
            soup.moved[v] = 1;
            ++result.moved;
        }
    }
    return result;
}

}  // namespace mq::boolean
