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
// A vertex on an edge looks less exactly the way of the triangle nearest to it.
constexpr double kSameWay = 0.3;

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

/// The operands' surfaces at their vertices.
class Surfaces {
  public:
    explicit Surfaces(const Soup& soup)
        : operand_(soup.vertices.size(), -1),
          normal_(soup.vertices.size(), Vec3::Zero()),
          steepest_(soup.vertices.size(), 1.0),
          triangles_(static_cast<std::size_t>(soup.operands)) {
        for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
            const std::int32_t own = soup.source[t].operand;
            triangles_[static_cast<std::size_t>(own)].push_back(static_cast<std::int32_t>(t));
            const Vec3 n = area_normal(soup, static_cast<std::int32_t>(t)).normalized();
            const Triangle& c = soup.triangles[t];
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3& p = soup.vertices[static_cast<std::size_t>(c[k])];
                const Vec3 u = soup.vertices[static_cast<std::size_t>(c[(k + 1) % 3])] - p;
                const Vec3 v = soup.vertices[static_cast<std::size_t>(c[(k + 2) % 3])] - p;
                operand_[static_cast<std::size_t>(c[k])] = own;
                normal_[static_cast<std::size_t>(c[k])] += std::atan2(u.cross(v).norm(), u.dot(v)) * n;
            }
        }
        for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
            const Vec3 n = area_normal(soup, static_cast<std::int32_t>(t)).normalized();
            for (const std::int32_t v : soup.triangles[t]) {
                const auto i = static_cast<std::size_t>(v);
                steepest_[i] = std::min(steepest_[i], n.dot(normal_[i].normalized()));
            }
        }
    }

    std::int32_t operand(std::size_t v) const { return operand_[v]; }
    const std::vector<std::int32_t>& triangles(std::int32_t operand) const {
        return triangles_[static_cast<std::size_t>(operand)];
    }
    /// The way by which a vertex goes outward when all triangles around it go outward by 1, or nearly so at spikes.
    Vec3 offset(std::size_t v) const {
        constexpr double kSteep = 0.2;
        return normal_[v].normalized() / std::max(steepest_[v], kSteep);
    }

  private:
    std::vector<std::int32_t> operand_;
    std::vector<Vec3> normal_;      ///< weighted by angles
    std::vector<double> steepest_;  ///< cosine between it and the triangle's normal that is farthest from it
    std::vector<std::vector<std::int32_t>> triangles_;
};

/// The distance from the earlier operand that most vertices of later ones where they run along it stay below; 0 when
/// they do not run along it within `farthest`.
double usual_distance(const Soup& soup, const mesh::TriangleTree& tree, const Surfaces& surfaces, std::int32_t earlier,
                      const std::vector<mesh::ContactPair>& crossing, double farthest) {
    constexpr std::size_t kSamples = 2000;
    constexpr double kMost = 0.98;
    std::vector<std::int32_t> vertices;
    for (const mesh::ContactPair& pair : crossing) {
        if (parallel_operands(soup, pair)) {
            for (const std::int32_t t : {pair.a, pair.b}) {
                const Triangle& c = soup.triangles[static_cast<std::size_t>(t)];
                if (surfaces.operand(static_cast<std::size_t>(c[0])) > earlier) {
                    vertices.insert(vertices.end(), c.begin(), c.end());
                }
            }
        }
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const std::size_t stride = std::max<std::size_t>(1, vertices.size() / kSamples);
    std::vector<double> distances;
    std::size_t asked = 0;
    for (std::size_t i = 0; i < vertices.size(); i += stride, ++asked) {
        const mesh::Nearest near = tree.nearest(soup.vertices[static_cast<std::size_t>(vertices[i])], farthest);
        if (near.triangle >= 0) {
            distances.push_back(near.distance);
        }
    }
    if (2 * distances.size() <= asked) {
        return 0.0;
    }
    const auto most =
        distances.begin() + static_cast<std::ptrdiff_t>(kMost * static_cast<double>(distances.size() - 1));
    std::nth_element(distances.begin(), most, distances.end());
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

bool run_along(const Soup& soup, const std::vector<mesh::ContactPair>& crossing, bool few) {
    const std::ptrdiff_t least = few ? 2 : 64;
    constexpr double kPartOfTriangles = 0.05;
    const auto many = static_cast<std::ptrdiff_t>(kPartOfTriangles * static_cast<double>(soup.triangles.size()));
    const auto parallel = std::count_if(crossing.begin(), crossing.end(), [&](const mesh::ContactPair& pair) {
        return pair.contact == mesh::Contact::Crossing && parallel_operands(soup, pair);
    });
    return parallel > std::max(many, least);
}

NearCoincidence separate(Soup& soup, Operation operation, double tolerance,
                         const std::vector<mesh::ContactPair>& crossing, const Progress& progress) {
    NearCoincidence result;
    const Surfaces surfaces(soup);
    soup.moved.assign(soup.vertices.size(), 0);
    Pace pace(progress);
    for (std::int32_t earlier = 0; earlier + 1 < soup.operands; ++earlier) {
        const int way = way_of(operation, earlier);
        const mesh::TriangleTree tree(soup.vertices, soup.triangles, surfaces.triangles(earlier));
        // Far enough that surfaces which bend between their vertices stay apart.
        constexpr double kStep = 3.0;
        const double step = kStep * usual_distance(soup, tree, surfaces, earlier, crossing, tolerance / (2.0 * kStep));
        if (way == 0 || step == 0.0) {
            continue;
        }
        std::vector<std::pair<std::size_t, Vec3>> moves;  // made when all are known: normals are those of the input
        for (std::size_t v = 0; v < soup.vertices.size(); ++v) {
            pace.step();
            if (surfaces.operand(v) <= earlier || soup.moved[v] != 0) {
                continue;
            }
            const mesh::Nearest near = tree.nearest(soup.vertices[v], step);
            const Vec3 offset = surfaces.offset(v);
            if (near.triangle < 0 || step * offset.norm() > tolerance) {
                continue;
            }
            const double along = area_normal(soup, near.triangle).normalized().dot(offset.normalized());
            if (std::abs(along) > kSameWay) {
                const double inward = along > 0.0 ? way : -way;
                moves.emplace_back(v, to_single(soup.vertices[v] - inward * step * offset));
            }
        }
        for (const auto& [v, target] : moves) {
            result.largest = std::max(result.largest, (target - soup.vertices[v]).norm());
            soup.vertices[v] = target;
            soup.moved[v] = 1;
        }
        result.moved += moves.size();
    }
    return result;
}

}  // namespace mq::boolean
