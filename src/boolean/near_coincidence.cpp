// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/near_coincidence.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "boolean/vertex_offset.h"
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

std::int32_t operand_of(const Soup& soup, std::int32_t t) {
    return soup.source[static_cast<std::size_t>(t)].operand;
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

/// The distance from the earlier operand that most vertices of later ones where they run along it stay below; 0 when
/// they do not run along it within `farthest`.
double usual_distance(const Soup& soup, const mesh::TriangleTree& tree, const VertexOffsets& offsets,
                      std::int32_t earlier, const std::vector<mesh::ContactPair>& crossing, double farthest) {
    constexpr std::size_t kSamples = 2000;
    constexpr double kMost = 0.98;
    std::vector<std::int32_t> vertices;
    for (const mesh::ContactPair& pair : crossing) {
        if (parallel_operands(soup, pair)) {
            for (const std::int32_t t : {pair.a, pair.b}) {
                const Triangle& c = soup.triangles[static_cast<std::size_t>(t)];
                if (offsets.operand(static_cast<std::size_t>(c[0])) > earlier) {
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

std::vector<std::vector<std::int32_t>> triangles_by_operand(const Soup& soup) {
    std::vector<std::vector<std::int32_t>> result(static_cast<std::size_t>(soup.operands));
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        result[static_cast<std::size_t>(soup.source[t].operand)].push_back(static_cast<std::int32_t>(t));
    }
    return result;
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

/// The planes that a vertex shall leave, each to one side.
struct PlanesToLeave {
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    Vec3 sum = Vec3::Zero();
};

/// The shortest way that leads out of all planes by 1 in the sense of least squares; directions that hardly count are
/// left out.
Vec3 way(const PlanesToLeave& planes) {
    constexpr double kHardly = 0.01;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(planes.squares);
    Vec3 result = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
        if (axes.eigenvalues()[i] > kHardly * axes.eigenvalues()[2]) {
            result += axes.eigenvectors().col(i).dot(planes.sum) / axes.eigenvalues()[i] * axes.eigenvectors().col(i);
        }
    }
    return result;
}

/// The later one of two triangles leaves the plane of the earlier one.
/// @param planes_of  of a vertex, or nullptr if it stays
template <typename PlanesOf>
void leave_plane(const Soup& soup, Operation operation, std::array<std::int32_t, 2> pair, PlanesOf&& planes_of) {
    constexpr double kParallelPlanes = 0.5;
    if (operand_of(soup, pair[0]) > operand_of(soup, pair[1])) {
        std::swap(pair[0], pair[1]);
    }
    const int inward = way_of(operation, operand_of(soup, pair[0]));
    const Vec3 n = area_normal(soup, pair[0]).normalized();
    if (inward == 0 || std::abs(n.dot(area_normal(soup, pair[1]).normalized())) < kParallelPlanes) {
        return;
    }
    for (const std::int32_t v : soup.triangles[static_cast<std::size_t>(pair[1])]) {
        if (PlanesToLeave* planes = planes_of(v)) {
            planes->squares += n * n.transpose();
            planes->sum -= inward * n;
        }
    }
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
    const VertexOffsets offsets(soup);
    const auto triangles = triangles_by_operand(soup);
    soup.moved.assign(soup.vertices.size(), 0);
    Pace pace(progress);
    for (std::int32_t earlier = 0; earlier + 1 < soup.operands; ++earlier) {
        const int way = way_of(operation, earlier);
        const mesh::TriangleTree tree(soup.vertices, soup.triangles, triangles[static_cast<std::size_t>(earlier)]);
        // Far enough that surfaces which bend between their vertices stay apart.
        constexpr double kStep = 3.0;
        const double step = kStep * usual_distance(soup, tree, offsets, earlier, crossing, tolerance / (2.0 * kStep));
        if (way == 0 || step == 0.0) {
            continue;
        }
        std::vector<std::pair<std::size_t, Vec3>> moves;  // made when all are known: normals are those of the input
        for (std::size_t v = 0; v < soup.vertices.size(); ++v) {
            pace.step();
            if (offsets.operand(v) <= earlier || soup.moved[v] != 0) {
                continue;
            }
            const mesh::Nearest near = tree.nearest(soup.vertices[v], step);
            const Vec3 offset = offsets.at(v);
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

NearCoincidence separate_flush(Soup& soup, Operation operation, const mesh::FlushPairs& flush, double clearance) {
    std::map<std::int32_t, PlanesToLeave> vertices;
    for (const auto& pair : flush.over) {
        leave_plane(soup, operation, pair, [&](std::int32_t v) { return &vertices[v]; });
    }
    // What moves anyway leaves the planes beside it too, or it would slide along them.
    for (const auto& pair : flush.beside) {
        leave_plane(soup, operation, pair, [&](std::int32_t v) {
            const auto known = vertices.find(v);
            return known != vertices.end() ? &known->second : nullptr;
        });
    }
    NearCoincidence result;
    soup.moved.resize(soup.vertices.size(), 0);
    for (const auto& [v, planes] : vertices) {
        Vec3& p = soup.vertices[static_cast<std::size_t>(v)];
        const Vec3 target = to_single(p + clearance * way(planes));
        result.largest = std::max(result.largest, (target - p).norm());
        p = target;
        soup.moved[static_cast<std::size_t>(v)] = 1;
    }
    result.moved = vertices.size();
    return result;
}

}  // namespace mq::boolean
