// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/report/exemption.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "base/angle.h"
#include "triangulate/work_mesh/corner_classification.h"
#include "triangulate/work_mesh/edges_angle.h"

namespace mq::triangulate {

namespace {

using mesh::ExemptReason;

mesh::NamedEntity entity_of(const Workspace& work, geometry::Entity entity) {
    const geometry::Entity whole = work.session.topology().of_shape(entity);
    return {entity.dimension, {whole.dimension, whole.index}};
}

mesh::NamedEntity entity_at(const Workspace& work, int vertex) {
    const mesh::VertexEntity& e = work.mesh.vertex(vertex).entity;
    return entity_of(work, {e[0], e[1]});
}

ExemptReason between_segments(const Workspace& work, int a, int b, int vertex, double angle) {
    const auto edge_of = [&](int segment) { return entity_of(work, {1, work.mesh.segment(segment).edge}); };
    return {Cause::NarrowCorner, angle / kDegree, {edge_of(a), edge_of(b)}, entity_at(work, vertex)};
}

// A corner that the shape does not have.
ExemptReason joined_corner(const Workspace& work, const geometry::Joined& joined, ExemptReason reason) {
    reason.cause = joined.by_shape ? Cause::ToleranceCorner : Cause::IdentifiedCorner;
    reason.joined = {entity_of(work, joined.entities[0]), entity_of(work, joined.entities[1])};
    reason.apart = joined.distance;
    return reason;
}

ExemptReason narrow_corner(const Workspace& work, JoinedCorners& joined, int triangle, double bound) {
    const SmallestAngle smallest = smallest_angle(work.mesh, triangle);
    const int vertex = work.mesh.vertex_of(smallest.half_edge);
    const int a = work.mesh.segment_of(smallest.half_edge);
    const int b = work.mesh.segment_of(ClassifiedMesh::prev(smallest.half_edge));
    const auto spanned = work.spanning.find(triangle);
    const auto found = joined.at(
        vertex, spanned != work.spanning.end() ? spanned->second.faces : std::vector<int>{work.mesh.face_of(triangle)});
    if (found && found->own > std::max(bound, kNarrowed * smallest.angle)) {
        return joined_corner(work, found->joined, between_segments(work, a, b, vertex, smallest.angle));
    }
    const auto enclosed = angle_between_edges(work, a, b, vertex);
    return between_segments(work, a, b, vertex, enclosed ? enclosed->angle : smallest.angle);
}

// The corner of the mesh at a vertex, if it is below `angle`, and no corner of the shape there is; radians.
std::optional<ExemptReason> joined_corner_at(const Workspace& work, JoinedCorners& joined, int vertex, double angle) {
    const auto found = joined.at(vertex);
    const JoinedCorners::Meeting* const meeting = found && found->own >= angle ? joined.narrowest(vertex) : nullptr;
    if (meeting == nullptr || meeting->angle >= angle) {
        return std::nullopt;
    }
    const auto [a, b] = meeting->segments;
    return joined_corner(work, found->joined, between_segments(work, a, b, vertex, meeting->angle));
}

// Whether the triangle fills a corner that the edges themselves enclose, not only their chords. Local improvement can
// make such triangles.
bool fills_corner(const Workspace& work, int triangle) {
    const SmallestAngle smallest = smallest_angle(work.mesh, triangle);
    const int vertex = work.mesh.vertex_of(smallest.half_edge);
    const int a = work.mesh.segment_of(smallest.half_edge);
    const int b = work.mesh.segment_of(ClassifiedMesh::prev(smallest.half_edge));
    if (a < 0 || b < 0 || work.mesh.vertex(vertex).entity[0] != 0) {
        return false;
    }
    const auto enclosed = angle_between_edges(work, a, b, vertex);
    return enclosed && enclosed->least() < kNarrowed * smallest.angle;
}

// Whether three triangles around the vertex cannot all reach the bound, since the total angle is too small.
bool too_little_around(const ClassifiedMesh& mesh, int half_edge, double bound) {
    const auto fan = apex_fan(mesh, half_edge);
    return fan && fan->closed && fan->sum < 3.0 * bound;
}

ExemptReason at_vertex(const Workspace& work, Cause cause, int vertex, double angle = -1.0) {
    return {cause, angle, {}, entity_at(work, vertex)};
}

ExemptReason reason_of(const Workspace& work, const CornersOfReport& corners, int triangle, const Exemption& exemption,
                       double bound) {
    if (exemption.cause == Cause::Budget) {
        return {Cause::Budget};  // takes precedence over all other causes, since the triangle was not tried
    }
    // The present shape of a triangle explains it, independent of what prevented the improvement of earlier ones.
    if (fills_corner(work, triangle)) {
        return narrow_corner(work, corners.joined, triangle, bound);
    }
    const int corner = smallest_angle(work.mesh, triangle).half_edge;
    if (too_little_around(work.mesh, corner, bound)) {
        return at_vertex(work, Cause::Apex, work.mesh.vertex_of(corner));
    }
    if (exemption.cause == Cause::NarrowCorner) {
        return narrow_corner(work, corners.joined, triangle, bound);
    }
    if (exemption.cause == Cause::Apex) {
        return at_vertex(work, Cause::Apex, exemption.vertex);
    }
    ExemptReason reason{exemption.cause};
    if (exemption.cause == Cause::NarrowCluster) {
        const auto infeasible = corners.infeasible.at(exemption.vertex);
        const double least = infeasible ? bound : kNarrowCorner;  // splitting ends at corners below this angle
        if (const auto joined = joined_corner_at(work, corners.joined, exemption.vertex, least)) {
            return *joined;
        }
        if (infeasible) {
            return at_vertex(work, Cause::InfeasibleCorner, exemption.vertex, *infeasible / kDegree);
        }
        reason.vertex = entity_at(work, exemption.vertex);
    }
    const bool somewhere = exemption.cause == Cause::NoSurfacePoint || exemption.cause == Cause::NoImprovingChange;
    if (exemption.edge >= 0 && !somewhere) {
        reason.edges[0] = entity_of(work, {1, exemption.edge});
    }
    return reason;
}

}  // namespace

ExemptReason explain(const Workspace& work, const CornersOfReport& corners, int triangle, const Exemption& exemption,
                     double bound) {
    ExemptReason reason = reason_of(work, corners, triangle, exemption, bound);
    reason.face = entity_of(work, {2, work.mesh.face_of(triangle)});
    return reason;
}

}  // namespace mq::triangulate
