// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/work_mesh/corner_classification.h"

#include <set>

#include "base/angle.h"
#include "triangulate/work_mesh/side_lengths.h"
#include "triangulate/work_mesh/tuning.h"

namespace mq::triangulate {

double angle_at(const ClassifiedMesh& mesh, int h) {
    const Vec3& o = mesh.point_of(h);
    const Vec3 a = mesh.point_of(ClassifiedMesh::next(h)) - o;
    const Vec3 b = mesh.point_of(ClassifiedMesh::prev(h)) - o;
    return angle_between(a, b);
}

SmallestAngle smallest_angle(const ClassifiedMesh& mesh, int triangle) {
    const int corner = ClassifiedMesh::prev(shortest_side(mesh, triangle));
    return {corner, angle_at(mesh, corner)};
}

Vec3 doubled_area(const ClassifiedMesh& mesh, int triangle) {
    const Vec3& p = mesh.point_of(3 * triangle);
    return (mesh.point_of(3 * triangle + 1) - p).cross(mesh.point_of(3 * triangle + 2) - p);
}

double squared_sine_of_smallest_angle(const ClassifiedMesh& mesh, int triangle) {
    const int h = 3 * triangle;
    return squared_sine_of_smallest_angle(doubled_area(mesh, triangle), squared_length(mesh, h),
                                          squared_length(mesh, h + 1), squared_length(mesh, h + 2));
}

int narrow_corner_of(const ClassifiedMesh& mesh, int triangle) {
    constexpr double kLargestBound =
        34.0 * kDegree;  // Radians: the largest angle bound that TriangulateOptions::validate allows.
    for (int h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        if (mesh.segment_of(h) >= 0 && mesh.segment_of(ClassifiedMesh::prev(h)) >= 0 &&
            angle_at(mesh, h) < kLargestBound) {
            return h;
        }
    }
    return -1;
}

std::vector<NarrowCorner> corners_at(const ClassifiedMesh& mesh, int segment, int end) {
    std::vector<NarrowCorner> corners;
    const ClassifiedMesh::Segment& s = mesh.segment(segment);
    if (mesh.vertex(s.vertices[end]).entity[0] != 0) {
        return corners;
    }
    for (const ClassifiedMesh::SegmentUse& use : s.uses) {
        const std::vector<int> star = mesh.star(mesh.leaving(use, s.vertices[end]));
        double sum = 0.0;
        for (const int spoke : star) {
            sum += angle_at(mesh, spoke);
        }
        const int first = mesh.segment_of(star.front());
        const int last = mesh.segment_of(ClassifiedMesh::prev(star.back()));
        const int other = first == segment ? last : first;
        if (other >= 0 && other != segment) {
            corners.push_back({sum, other});
        }
    }
    return corners;
}

NarrowCorner narrowest_corner(const ClassifiedMesh& mesh, int segment, int end) {
    NarrowCorner best;
    for (const NarrowCorner& corner : corners_at(mesh, segment, end)) {
        best = corner.angle < best.angle ? corner : best;
    }
    return best;
}

// An apex has no normal, or several sites: one for each of its images in the parameter domain.
std::optional<ApexFan> apex_fan(const ClassifiedMesh& mesh, int h, std::size_t most) {
    const int site = mesh.site_of(h);
    bool apex = !(mesh.site(site).normal.squaredNorm() > 0.0);
    if (!apex && mesh.vertex(mesh.vertex_of(h)).entity[0] == 2) {
        return std::nullopt;  // inside a face a vertex has one site
    }
    ApexFan fan;
    std::set<int> segments;
    for (const int spoke : mesh.star(h, most)) {
        apex = apex || mesh.site_of(spoke) != site;
        const double angle = angle_at(mesh, spoke);
        fan.sum += angle;
        fan.widest = std::max(fan.widest, angle);
        ++fan.triangles;
        segments.insert({mesh.segment_of(spoke), mesh.segment_of(ClassifiedMesh::prev(spoke))});
    }
    segments.erase(-1);
    fan.closed = segments.size() < 2;
    return apex && fan.triangles > 0 ? std::optional(fan) : std::nullopt;
}

std::optional<ApexFan> cone_fan(const ClassifiedMesh& mesh, int h) {
    if (mesh.site(mesh.site_of(h)).normal.squaredNorm() > 0.0) {
        return std::nullopt;
    }
    const auto fan = apex_fan(mesh, h);
    return fan && fan->closed && fan->sum < WorkMeshTuning::kSlenderCone ? fan : std::nullopt;
}

bool ringed_apex(const ClassifiedMesh& mesh, int h) {
    const auto fan = cone_fan(mesh, h);
    return fan && fan->widest <= WorkMeshTuning::kWidestShare * fan->sum;
}

}  // namespace mq::triangulate
