// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh/vertex_clustering.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/key_set.h"
#include "mesh/triangle_mesh.h"

namespace mq::mesh {

namespace {

constexpr std::uint64_t kBits = 21;  // bits of a cell's number along each axis

Vec3 corner_of(const float* corners, std::size_t k) {
    return {corners[3 * k], corners[3 * k + 1], corners[3 * k + 2]};
}

/// Whether all nine numbers of a triangle are finite; other triangles have no cell.
bool is_finite(const float* corners, std::size_t t) {
    return std::all_of(corners + 9 * t, corners + 9 * (t + 1), [](float x) { return std::isfinite(x); });
}

/// The side of cells at which an even mesh of that area has about `wanted` triangles: two for each cell that the
/// surface crosses.
double cell_side(const float* corners, std::size_t triangles, std::size_t wanted, const Box& box) {
    double area = 0.0;
    for (std::size_t t = 0; t < triangles; ++t) {
        if (!is_finite(corners, t)) {
            continue;
        }
        const Vec3 a = corner_of(corners, 3 * t);
        area += 0.5 * (corner_of(corners, 3 * t + 1) - a).cross(corner_of(corners, 3 * t + 2) - a).norm();
    }
    const double side = std::sqrt(2.0 * area / static_cast<double>(std::max<std::size_t>(wanted, 1)));
    const double finest = box.largest_side() / static_cast<double>((1ULL << kBits) - 2);
    return std::max({side, finest, std::numeric_limits<double>::min()});
}

/// The number of each corner's cluster, in the order of the first corners.
struct Numbering {
    std::vector<std::int32_t> cluster;  ///< -1: its triangle has numbers that are not finite
    std::vector<Vec3> centre;           ///< mean of the corners in each cluster
};

Numbering number(const float* corners, std::size_t count, const Vec3& low, double side, const Progress* progress) {
    Numbering result;
    result.cluster.assign(count, -1);
    std::vector<double> members;
    KeyMap<std::int32_t> numbers;
    CancelPace pace(progress);
    for (std::size_t k = 0; k < count; ++k) {
        pace.step();
        if (!is_finite(corners, k / 3)) {
            continue;
        }
        const Vec3 corner = corner_of(corners, k);
        const Vec3 at = (corner - low) / side;
        std::uint64_t key = 0;
        for (int axis = 0; axis < 3; ++axis) {
            key = key << kBits | static_cast<std::uint64_t>(std::max(at[axis], 0.0));
        }
        const auto [found, added] = numbers.try_emplace(key, static_cast<std::int32_t>(members.size()));
        if (added) {
            members.push_back(0.0);
            result.centre.push_back(Vec3::Zero());
        }
        const auto number = static_cast<std::size_t>(found->second);
        result.cluster[k] = found->second;
        result.centre[number] += corner;
        members[number] += 1.0;
    }
    for (std::size_t i = 0; i < members.size(); ++i) {
        result.centre[i] /= members[i];
    }
    return result;
}

}  // namespace

ClusteredMesh cluster(const float* corners, std::size_t triangles, std::size_t wanted, const Progress* progress) {
    Box box;
    for (std::size_t k = 0; k < 3 * triangles; ++k) {
        if (is_finite(corners, k / 3)) {
            box.add(corner_of(corners, k));
        }
    }
    ClusteredMesh result;
    result.joined.assign(triangles, -1);
    if (triangles == 0) {
        return result;
    }
    const Numbering numbers =
        number(corners, 3 * triangles, box.low, cell_side(corners, triangles, wanted, box), progress);
    using Named = std::array<std::int32_t, 3>;
    std::vector<std::pair<Named, std::uint32_t>> kept;
    for (std::size_t t = 0; t < triangles; ++t) {
        Named c{numbers.cluster[3 * t], numbers.cluster[3 * t + 1], numbers.cluster[3 * t + 2]};
        std::sort(c.begin(), c.end());
        if (c[0] != c[1] && c[1] != c[2]) {
            kept.emplace_back(c, static_cast<std::uint32_t>(t));
        }
    }
    std::sort(kept.begin(), kept.end());
    check_cancelled(progress);
    for (std::size_t i = 0; i < kept.size(); ++i) {
        if (i == 0 || kept[i].first != kept[i - 1].first) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3& at = numbers.centre[static_cast<std::size_t>(numbers.cluster[3 * kept[i].second + k])];
                for (int axis = 0; axis < 3; ++axis) {
                    result.corners.push_back(static_cast<float>(at[axis]));
                }
            }
        }
        result.joined[kept[i].second] = static_cast<std::int32_t>(result.corners.size() / 9) - 1;
    }
    return result;
}

}  // namespace mq::mesh
