// SPDX-License-Identifier: LGPL-2.1-or-later
#include "inspection/draft.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "inspection/ray_crossings.h"
#include "mesh/intersection/aabb_tree.h"

namespace mq::inspection {

namespace {

/// Degrees of draft up to which a wall counts as parallel to the pull: either half of the mould may form it.
constexpr double kAlongPull = 0.01;
/// Distance from the surface at which rays start, as a fraction of the largest side of the model.
constexpr double kOffset = 1e-5;
/// Triangles that a thread takes at a time.
constexpr std::size_t kChunk = 256;

}  // namespace

void DraftOptions::validate() const {
    if (!pull.allFinite() || !(pull.norm() > 0.0)) {
        throw InvalidInput(phrases::kNoDirection);
    }
    if (!(offset >= 0.0 && std::isfinite(offset))) {
        throw InvalidInput(
            phrases::kLengthNotAllowed,
            {{"option", "offset"}, {"length", in_mm(offset)}, {"range", Message(phrases::kAtLeast, {{"number", 0}})}});
    }
}

MouldDraft draft(const mesh::TriangleMesh& mesh, const std::vector<Vec3>& normals, const DraftOptions& options,
                 Progress* progress) {
    options.validate();
    const std::size_t count = mesh.triangles.size();
    const mesh::AabbTree tree(mesh.vertices, mesh.triangles);
    const Vec3 pull = options.pull.normalized();
    const double offset = options.offset > 0.0 ? options.offset : kOffset * tree.box().largest_side();
    MouldDraft found;
    found.angle.resize(count);
    found.release.resize(count);
    const auto is_free = [&](const Vec3& from, const Vec3& direction, std::size_t own) {
        return crossings_of(tree, mesh.vertices, mesh.triangles, from, direction, static_cast<std::int32_t>(own))
            .empty();
    };
    const auto measure = [&](std::size_t k) {
        const mesh::Triangle& t = mesh.triangles[k];
        const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        const Vec3 plane = (b - a).cross(c - a).normalized();
        const Vec3& normal = normals.empty() ? plane : normals[k];
        found.angle[k] = 180.0 / M_PI * std::atan2(normal.dot(pull), normal.cross(pull).norm());
        const Vec3 from = (a + b + c) / 3.0 + offset * plane;
        int release = 0;
        if (found.angle[k] >= -kAlongPull && is_free(from, pull, k)) {
            release |= static_cast<int>(Release::Along);
        }
        if (found.angle[k] <= kAlongPull && is_free(from, -pull, k)) {
            release |= static_cast<int>(Release::Against);
        }
        found.release[k] = static_cast<Release>(release);
    };
    const std::size_t chunks = (count + kChunk - 1) / kChunk;
    std::atomic<std::size_t> done{0};
    parallel_for(static_cast<int>(chunks), [&](int chunk) {
        const std::size_t begin = kChunk * static_cast<std::size_t>(chunk);
        for (std::size_t k = begin; k < std::min(begin + kChunk, count); ++k) {
            check_cancelled(progress);
            measure(k);
        }
        if (progress != nullptr) {
            progress->advance(static_cast<double>(++done) / static_cast<double>(chunks));
        }
    });
    return found;
}

}  // namespace mq::inspection
