// SPDX-License-Identifier: LGPL-2.1-or-later
#include "inspection/deviation.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <optional>

#include "base/error.h"
#include "base/parallel.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "inspection/cad_distance.h"
#include "mesh/morton_sort.h"

namespace mq::inspection {

namespace {

/// Points that a thread takes at a time.
constexpr std::size_t kChunk = 256;
/// Triangles of the reference whose centroids stand for it where its principal axes are sought.
constexpr std::size_t kSurfacePoints = 20000;

/// The order in which neighbours follow each other: along a Morton curve.
std::vector<std::uint32_t> order_of(const std::vector<Vec3>& points) {
    Box box;
    for (const Vec3& p : points) {
        box.add(p);
    }
    const double scale = (mesh::kMortonCells - 1) / std::max(box.largest_side(), 1e-300);
    LargeVector<mesh::MortonKey> keys;
    keys.reserve(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Vec3 cell = scale * (points[k] - box.low);
        keys.push_back({mesh::morton_code({cell.x(), cell.y(), cell.z()}), static_cast<std::uint32_t>(k)});
    }
    mesh::sort_by_code(keys);
    std::vector<std::uint32_t> order;
    order.reserve(points.size());
    for (const mesh::MortonKey& key : keys) {
        order.push_back(key.item);
    }
    return order;
}

std::vector<Vec3> ordered(const std::vector<Vec3>& points, const std::vector<std::uint32_t>& order) {
    std::vector<Vec3> result;
    result.reserve(points.size());
    for (const std::uint32_t k : order) {
        result.push_back(points[k]);
    }
    return result;
}

std::vector<SignedDistance> distances_from(const MeshDistance& mesh, const std::vector<Vec3>& points,
                                           const Progress& progress) {
    std::vector<SignedDistance> found(points.size());
    parallel_for(static_cast<int>((points.size() + kChunk - 1) / kChunk), [&](int chunk) {
        progress.check();
        const std::size_t begin = kChunk * static_cast<std::size_t>(chunk);
        std::int32_t guess = -1;
        for (std::size_t k = begin; k < std::min(begin + kChunk, points.size()); ++k) {
            found[k] = mesh.at(points[k], guess);
            guess = found[k].triangle;
        }
    });
    return found;
}

std::vector<SignedDistance> distances_from(const CadDistance& cad, geometry::Session& session,
                                           const std::vector<Vec3>& points, std::size_t& by_mesh) {
    std::vector<SignedDistance> found(points.size());
    std::atomic<std::size_t> sum{0};
    session.for_chunks(points.size(), [&](geometry::Answerer& answerer, std::size_t from, std::size_t to) {
        std::int32_t guess = -1;
        std::size_t own = 0;
        for (std::size_t k = from; k < to; ++k) {
            found[k] = cad.at(answerer, points[k], guess, own);
            guess = found[k].triangle;
        }
        sum += own;
    });
    by_mesh = sum;
    return found;
}

/// Points spread over the surface: each triangle's centroid as often as its share of the area says.
std::vector<Vec3> surface_points(const mesh::TriangleMesh& mesh) {
    const auto corner = [&](const mesh::Triangle& t, int i) -> const Vec3& { return mesh.vertices[t[i]]; };
    const auto area = [&](const mesh::Triangle& t) {
        return (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)).norm();
    };
    double whole = 0.0;
    for (const mesh::Triangle& t : mesh.triangles) {
        whole += area(t);
    }
    std::vector<Vec3> points;
    double sum = 0.0;
    for (const mesh::Triangle& t : mesh.triangles) {
        const double last = sum + area(t);
        const auto number = [&](double part) {
            return static_cast<std::int64_t>(part / whole * static_cast<double>(kSurfacePoints));
        };
        // On lines between the corner and the opposite side, so that a large triangle has more than one place.
        const std::int64_t count = number(last) - number(sum);
        for (std::int64_t k = 0; k < count; ++k) {
            const double a = std::sqrt((static_cast<double>(k) + 0.5) / static_cast<double>(count));
            const double b = static_cast<double>(k) * 0.6180339887498949;
            const double along = b - std::floor(b);
            points.push_back((1.0 - a) * corner(t, 0) + a * (1.0 - along) * corner(t, 1) + a * along * corner(t, 2));
        }
        sum = last;
    }
    return points;
}

}  // namespace

Deviation measure_deviation(const std::vector<Vec3>& points, const mesh::TriangleMesh& reference,
                            geometry::Session* session, double deviation, const DeviationOptions& options,
                            Progress& progress) {
    if (reference.triangles.empty() || points.empty()) {
        throw InvalidInput(phrases::kNoDistance);
    }
    const MeshDistance mesh(reference);
    std::optional<CadDistance> cad;
    if (session != nullptr) {
        progress.stage("preparing the reference", 0.0, 0.1);
        cad.emplace(*session, mesh, deviation);
    }
    Deviation result;
    const std::vector<std::uint32_t> order = order_of(points);
    const std::vector<Vec3> sorted = ordered(points, order);
    const auto by_mesh = [&](const std::vector<Vec3>& at) { return distances_from(mesh, at, progress); };
    const auto exact = [&](const std::vector<Vec3>& at) {
        return cad ? distances_from(*cad, *session, at, result.by_mesh) : by_mesh(at);
    };
    if (options.align != Align::None) {
        progress.stage("aligning", 0.1, 0.6);
        const AlignmentTarget target{by_mesh, exact, surface_points(reference), mesh.tree().box().largest_side()};
        const std::vector<Vec3> fitted =
            options.fit_points.empty() ? sorted : ordered(options.fit_points, order_of(options.fit_points));
        result.alignment = align(fitted, target, options.align, options.pairs, progress);
        if (!result.alignment.converged) {
            return result;
        }
    }
    progress.stage("measuring distances", options.align != Align::None ? 0.6 : 0.1, 1.0);
    std::vector<Vec3> there;
    there.reserve(sorted.size());
    for (const Vec3& p : sorted) {
        there.push_back(options.align == Align::None ? p : result.alignment.motion.of_point(p));
    }
    const std::vector<SignedDistance> found = exact(there);
    result.distances.resize(points.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        result.distances[order[k]] = found[k];
    }
    return result;
}

}  // namespace mq::inspection
