// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/near_coincidence/near_coincidence.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "base/predicates.h"
#include "boolean/near_coincidence/tuning.h"
#include "boolean/near_coincidence/vertex_offset.h"
#include "mesh/intersection/nearest_tree.h"

namespace mq::boolean {

namespace {

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
    return std::abs(m.dot(n)) > NearCoincidenceTuning::kParallelNormals * m.norm() * n.norm();
}

/// By operand, the vertices of later ones where these nearly coincide with it: those of triangles that are nearly
/// parallel to one that they cross.
std::vector<std::vector<std::int32_t>> vertices_of_parallel_pairs(const Soup& soup,
                                                                  const std::vector<mesh::ContactPair>& crossing) {
    std::vector<std::vector<std::int32_t>> result(static_cast<std::size_t>(soup.operands));
    for (const mesh::ContactPair& pair : crossing) {
        if (parallel_operands(soup, pair)) {
            const bool in_order = operand_of(soup, pair.a) < operand_of(soup, pair.b);
            const Triangle& c = soup.triangles[static_cast<std::size_t>(in_order ? pair.b : pair.a)];
            std::vector<std::int32_t>& list =
                result[static_cast<std::size_t>(operand_of(soup, in_order ? pair.a : pair.b))];
            list.insert(list.end(), c.begin(), c.end());
        }
    }
    return result;
}

/// The distance from the earlier operand below which most vertices of later ones stay where they nearly coincide; 0
/// when they do not within `farthest`.
double usual_distance(const Soup& soup, const mesh::NearestTree& tree, std::vector<std::int32_t> vertices,
                      double farthest) {
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const std::size_t stride = std::max<std::size_t>(1, vertices.size() / NearCoincidenceTuning::kDistanceSamples);
    std::vector<double> distances;
    std::size_t asked = 0;
    for (std::size_t i = 0; i < vertices.size(); i += stride, ++asked) {
        const mesh::ClosestPoint near = tree.nearest(soup.vertices[static_cast<std::size_t>(vertices[i])], farthest);
        if (near.triangle >= 0) {
            distances.push_back(near.distance);
        }
    }
    if (2 * distances.size() <= asked) {
        return 0.0;
    }
    const auto most = distances.begin() + static_cast<std::ptrdiff_t>((1.0 - NearCoincidenceTuning::kDistanceOutliers) *
                                                                      static_cast<double>(distances.size() - 1));
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

/// Offset sign: +1 moves the later operand's surface into the material of the earlier one, -1 out of it, 0 leaves it.
int offset_sign(const Expression& expression, std::int32_t earlier, std::int32_t later) {
    switch (expression.pairing(earlier, later)) {
        case Pairing::Union:
        case Pairing::SecondLessFirst:
            return 1;
        case Pairing::Intersection:
        case Pairing::FirstLessSecond:
            return -1;
        case Pairing::None:
            break;
    }
    return 0;
}

/// The planes from which a vertex is offset, each to one side.
struct PlanesToLeave {
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    Vec3 sum = Vec3::Zero();
};

/// The shortest displacement that moves by 1 off all planes, in the sense of least squares; directions with a small
/// eigenvalue are left out.
Vec3 way(const PlanesToLeave& planes) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(planes.squares);
    Vec3 result = Vec3::Zero();
    for (int i = 0; i < 3; ++i) {
        if (axes.eigenvalues()[i] > NearCoincidenceTuning::kLeastEigenvalue * axes.eigenvalues()[2]) {
            result += axes.eigenvectors().col(i).dot(planes.sum) / axes.eigenvalues()[i] * axes.eigenvectors().col(i);
        }
    }
    return result;
}

/// Offsets the later one of two triangles from the plane of the earlier one.
/// @param planes_of  gives the planes for a vertex, or nullptr if it stays
template <typename PlanesOf>
void leave_plane(const Soup& soup, const Expression& expression, std::array<std::int32_t, 2> pair,
                 PlanesOf&& planes_of) {
    if (operand_of(soup, pair[0]) > operand_of(soup, pair[1])) {
        std::swap(pair[0], pair[1]);
    }
    const int inward = offset_sign(expression, operand_of(soup, pair[0]), operand_of(soup, pair[1]));
    const Vec3 n = area_normal(soup, pair[0]).normalized();
    if (inward == 0 ||
        std::abs(n.dot(area_normal(soup, pair[1]).normalized())) < NearCoincidenceTuning::kParallelPlanes) {
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

bool nearly_coincident(const Soup& soup, const std::vector<mesh::ContactPair>& crossing, bool few) {
    const std::ptrdiff_t least = few ? 2 : 64;
    const auto many =
        static_cast<std::ptrdiff_t>(NearCoincidenceTuning::kCrossingShare * static_cast<double>(soup.triangles.size()));
    const auto parallel = std::count_if(crossing.begin(), crossing.end(), [&](const mesh::ContactPair& pair) {
        return pair.contact == mesh::Contact::Crossing && parallel_operands(soup, pair);
    });
    return parallel > std::max(many, least);
}

bool separable(const Soup& soup, double tolerance, const std::vector<mesh::ContactPair>& crossing) {
    const auto triangles = triangles_by_operand(soup);
    const auto vertices = vertices_of_parallel_pairs(soup, crossing);
    for (std::size_t earlier = 0; earlier < vertices.size(); ++earlier) {
        if (!vertices[earlier].empty()) {
            const mesh::NearestTree tree(soup.vertices, soup.triangles, triangles[earlier]);
            if (usual_distance(soup, tree, vertices[earlier], tolerance / (2.0 * NearCoincidenceTuning::kOffsetStep)) >
                0.0) {
                return true;
            }
        }
    }
    return false;
}

NearCoincidence separate(Soup& soup, const Expression& expression, double tolerance,
                         const std::vector<mesh::ContactPair>& crossing, const Progress& progress) {
    NearCoincidence result;
    const VertexOffsets offsets(soup);
    const auto triangles = triangles_by_operand(soup);
    const auto near_pairs = vertices_of_parallel_pairs(soup, crossing);
    soup.moved.assign(soup.vertices.size(), 0);
    CancelPace pace(progress);
    for (std::int32_t earlier = 0; earlier + 1 < soup.operands; ++earlier) {
        const std::vector<std::int32_t>& near_vertices = near_pairs[static_cast<std::size_t>(earlier)];
        if (near_vertices.empty()) {
            continue;
        }
        const mesh::NearestTree tree(soup.vertices, soup.triangles, triangles[static_cast<std::size_t>(earlier)]);
        const double step =
            NearCoincidenceTuning::kOffsetStep *
            usual_distance(soup, tree, near_vertices, tolerance / (2.0 * NearCoincidenceTuning::kOffsetStep));
        if (step == 0.0) {
            continue;
        }
        std::vector<int> ways(static_cast<std::size_t>(soup.operands), 0);  // by later operand
        for (std::int32_t later = earlier + 1; later < soup.operands; ++later) {
            ways[static_cast<std::size_t>(later)] = offset_sign(expression, earlier, later);
        }
        std::vector<std::pair<std::size_t, Vec3>> moves;  // applied when all are known: normals are those of the input
        for (std::size_t v = 0; v < soup.vertices.size(); ++v) {
            pace.step();
            // A vertex that no triangle uses has the operand -1.
            const std::int32_t own = offsets.operand(v);
            const int way = own > earlier ? ways[static_cast<std::size_t>(own)] : 0;
            if (way == 0 || soup.moved[v] != 0) {
                continue;
            }
            const mesh::ClosestPoint near = tree.nearest(soup.vertices[v], step);
            const Vec3 offset = offsets.at(v);
            if (near.triangle < 0 || step * offset.norm() > tolerance) {
                continue;
            }
            const double along = area_normal(soup, near.triangle).normalized().dot(offset.normalized());
            if (std::abs(along) > NearCoincidenceTuning::kSameSideNormals) {
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

NearCoincidence separate_coplanar(Soup& soup, const Expression& expression, const mesh::CoplanarPairs& flush,
                                  double clearance) {
    std::map<std::int32_t, PlanesToLeave> vertices;
    for (const auto& pair : flush.over) {
        leave_plane(soup, expression, pair, [&](std::int32_t v) { return &vertices[v]; });
    }
    // A vertex that moves anyway leaves the planes beside it too, or it would slide along them.
    for (const auto& pair : flush.beside) {
        leave_plane(soup, expression, pair, [&](std::int32_t v) {
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

void undo_degenerate_moves(Soup& soup, const std::vector<Vec3>& before) {
    const auto moved = [&](int v) -> char& { return soup.moved[static_cast<std::size_t>(v)]; };
    const auto at = [&](int v) -> Vec3& { return soup.vertices[static_cast<std::size_t>(v)]; };
    for (bool again = !soup.moved.empty(); again;) {
        again = false;
        for (const Triangle& c : soup.triangles) {
            if (std::any_of(c.begin(), c.end(), moved) && collinear(at(c[0]), at(c[1]), at(c[2]))) {
                for (const int v : c) {
                    at(v) = before[static_cast<std::size_t>(v)];
                    moved(v) = 0;
                }
                again = true;
            }
        }
    }
}

}  // namespace mq::boolean
