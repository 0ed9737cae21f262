// SPDX-License-Identifier: LGPL-2.1-or-later
#include "improve/improve.h"

#include <utility>

#include "base/error.h"
#include "improve/improver.h"
#include "mesh/edge_table.h"

namespace mq::improve {

namespace {

void require(bool holds, const char* option, double value, const char* range) {
    if (!holds) {
        throw InvalidInput(std::string(option) + " = " + std::to_string(value) + " is not allowed: it must be " +
                           range);
    }
}

mesh::TriangleMesh checked(const mesh::TriangleMesh& given) {
    mesh::require_valid(given);
    mesh::TriangleMesh mesh;
    mesh.origin = given.origin;
    for (const Vec3& p : given.vertices) {
        mesh.vertices.push_back(in_single(p));
    }
    for (std::size_t t = 0; t < given.triangles.size(); ++t) {
        if (mesh::is_collapsed(given.triangles[t])) {
            throw InvalidInput("triangle " + std::to_string(t) +
                               " names a vertex twice: remove degenerate triangles first");
        }
    }
    mesh.triangles = given.triangles;
    return mesh;
}

}  // namespace

void ImproveOptions::validate() const {
    require(min_angle > 0.0 && min_angle <= 34.0, "min_angle", min_angle, "greater than 0 and at most 34 degrees");
    require(tolerance >= 0.0, "tolerance", tolerance, "0 mm or more");
    require(feature_angle > 0.0 && feature_angle <= 180.0, "feature_angle", feature_angle,
            "greater than 0 and at most 180 degrees");
}

Result improve(const mesh::TriangleMesh& given, const ImproveOptions& options, Progress* progress) {
    options.validate();
    const mesh::TriangleMesh start = checked(given);
    if (start.triangles.empty()) {
        throw InvalidInput("the mesh has no triangles");
    }
    Progress unwatched;
    Progress& watched = progress != nullptr ? *progress : unwatched;
    StageTimes seconds;
    StageClock clock(seconds);
    watched.stage("improving", 0.0, 1.0);
    Improver improver(start, options, watched);
    improver.run();
    clock.end("improving");
    Result result = std::move(improver.counts);
    result.mesh = improver.mesh().result();
    result.mesh.origin = start.origin;
    result.seconds = std::move(seconds);
    // Removed triangles are left out of the result.
    std::vector<std::int32_t> index(static_cast<std::size_t>(improver.mesh().triangle_count()), 0);
    std::int32_t next = 0;
    for (int t = 0; t < improver.mesh().triangle_count(); ++t) {
        index[static_cast<std::size_t>(t)] = improver.mesh().gone(t) ? -1 : next++;
    }
    for (const auto& [t, cause] : improver.left()) {
        result.exempt.emplace_back(index[static_cast<std::size_t>(t)], mesh::ExemptReason{cause});
    }
    return result;
}

}  // namespace mq::improve
