// SPDX-License-Identifier: LGPL-2.1-or-later
#include "improve/improve.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "improve/improver.h"
#include "improve/tuning.h"
#include "mesh/edge_table.h"
#include "mesh/intersection/aabb_tree.h"
#include "mesh/intersection/nearest_tree.h"
#include "mesh/quality/surface_verification.h"
#include "mesh/quality/triangle_quality.h"
#include "option_ranges.h"

namespace mq::improve {

namespace {

mesh::TriangleMesh checked(const mesh::TriangleMesh& given) {
    mesh::require_valid(given);
    mesh::TriangleMesh mesh;
    mesh.origin = given.origin;
    for (const Vec3& p : given.vertices) {
        mesh.vertices.push_back(in_single(p));
    }
    for (std::size_t t = 0; t < given.triangles.size(); ++t) {
        if (mesh::is_collapsed(given.triangles[t])) {
            throw InvalidInput(phrases::kVertexTwice, {{"count", t}});
        }
    }
    mesh.triangles = given.triangles;
    return mesh;
}

/// The state that must not become worse: faults by kind, the smallest angle, and the distance from the given surface.
class Condition {
  public:
    /// @param mesh  must outlive this object
    Condition(const mesh::TriangleMesh& mesh, Progress& progress)
        : count_(verified(mesh, progress).count), least_(least_angle(mesh)), surface_(mesh.vertices, mesh.triangles) {}

    /// The triangles of an improved mesh that are worse than in the given one: those at faults of a kind of which it
    /// has more, those with smaller angles, and those with a corner, a middle of a side or a centre farther than the
    /// tolerance (mm) from the given mesh. Halves of triangles have other such points than the triangles that were
    /// tested when they were made.
    std::vector<std::int32_t> worse_in(const mesh::TriangleMesh& mesh, double tolerance, Progress& progress) const {
        const mesh::Verification after = verified(mesh, progress);
        std::vector<std::int32_t> found;
        for (const mesh::Fault& fault : after.faults) {
            const auto kind = static_cast<std::size_t>(fault.kind);
            // Open and non-manifold edges belong to the connections, which are kept; halves of such an edge are no
            // further faults.
            if (fault.kind == mesh::FaultKind::OpenEdge || fault.kind == mesh::FaultKind::NonmanifoldEdge ||
                after.count[kind] <= count_[kind]) {
                continue;
            }
            std::copy_if(fault.triangles.begin(), fault.triangles.end(), std::back_inserter(found),
                         [](std::int32_t t) { return t >= 0; });
        }
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            if (angle(mesh, mesh.triangles[t]) < least_ || !is_within(mesh, mesh.triangles[t], tolerance)) {
                found.push_back(static_cast<std::int32_t>(t));
            }
        }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

  private:
    static mesh::Verification verified(const mesh::TriangleMesh& mesh, Progress& progress) {
        constexpr std::size_t kMostFaults = 1000000;  // faults of one kind that are counted at most
        return mesh::verify(mesh.vertices, mesh.triangles, nullptr, kMostFaults, &progress);
    }
    static double angle(const mesh::TriangleMesh& mesh, const mesh::Triangle& t) {
        const auto corner = [&](std::size_t k) { return mesh.vertices[static_cast<std::size_t>(t[k])]; };
        return mesh::min_angle_of({corner(0), corner(1), corner(2)});
    }
    bool is_within(const mesh::TriangleMesh& mesh, const mesh::Triangle& t, double tolerance) const {
        const auto corner = [&](std::size_t k) { return mesh.vertices[static_cast<std::size_t>(t[k % 3])]; };
        std::int32_t guess = surface_.any_within((corner(0) + corner(1) + corner(2)) / 3.0, tolerance, 0);
        for (std::size_t k = 0; k < 3 && guess >= 0; ++k) {
            guess = surface_.any_within(0.5 * (corner(k) + corner(k + 1)), tolerance, guess);
        }
        return guess >= 0;
    }
    static double least_angle(const mesh::TriangleMesh& mesh) {
        double least = 180.0;
        for (const mesh::Triangle& t : mesh.triangles) {
            least = std::min(least, angle(mesh, t));
        }
        return least;
    }

    std::array<std::size_t, mesh::kFaultKinds> count_;
    double least_;
    mesh::NearestTree surface_;
};

Result result_of(Improver& improver, const mesh::TriangleMesh& start) {
    Result result = std::move(improver.counts);
    result.mesh = improver.mesh().result();
    result.mesh.origin = start.origin;
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

}  // namespace

void ImproveOptions::validate() const {
    ranges::improve::kMinAngle.require(min_angle);
    ranges::improve::kTolerance.require(tolerance);
    ranges::improve::kFeatureAngle.require(feature_angle);
}

Result improve(const mesh::TriangleMesh& given, const ImproveOptions& options, Progress* progress) {
    options.validate();
    const mesh::TriangleMesh start = checked(given);
    if (start.triangles.empty()) {
        throw InvalidInput(phrases::kMeshEmpty);
    }
    Progress unwatched;
    Progress& watched = progress != nullptr ? *progress : unwatched;
    StageTimes seconds;
    StageTimer clock(seconds);
    watched.stage("improving", 0.0, 1.0);
    // Vertices are rounded to single precision after they were tested.
    double rounding = 0.0;
    for (const Vec3& p : start.vertices) {
        rounding = std::max(rounding, std::numeric_limits<float>::epsilon() * p.cwiseAbs().maxCoeff());
    }
    const Condition before(start, watched);
    std::vector<Vec3> points;
    std::vector<mesh::Triangle> frozen;
    for (int round = 0;; ++round) {
        if (round == ImproveTuning::kRepeats) {
            points = start.vertices;
            frozen = start.triangles;
        }
        const mesh::AabbTree tree(points, frozen);
        Improver improver(start, options, watched, frozen.empty() ? nullptr : &tree);
        improver.run();
        Result result = result_of(improver, start);
        result.kept = frozen.size();
        const std::vector<std::int32_t> worse = before.worse_in(result.mesh, improver.tolerance() + rounding, watched);
        if (worse.empty() || round == ImproveTuning::kRepeats) {
            clock.end("improving");
            result.seconds = std::move(seconds);
            return result;
        }
        for (const std::int32_t t : worse) {
            const auto first = static_cast<std::int32_t>(points.size());
            for (const std::int32_t v : result.mesh.triangles[static_cast<std::size_t>(t)]) {
                points.push_back(result.mesh.vertices[static_cast<std::size_t>(v)]);
            }
            frozen.push_back({first, first + 1, first + 2});
        }
    }
}

}  // namespace mq::improve
