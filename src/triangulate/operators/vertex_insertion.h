// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "triangulate/work_mesh/surface_alignment.h"
#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// A proposed position of a new site, before it is projected onto the surface.
struct Candidate {
    int triangle = -1;  ///< the triangle that requests it
    Vec3 point = Vec3::Zero();
    Vec2 uv = Vec2::Zero();  ///< interpolated parameters: the initial guess for the projection
    bool uv_is_near = true;  ///< whether the surface point at `uv` is also acceptable
    double reach = 0.0;      ///< mm; a projection farther from `point` lies on another sheet of the surface
};

/// The paper's site (Aftosmis 1999, section 3.3): the circumcentre of a triangle that is not obtuse; otherwise the
/// centroid of the triangle across the edge opposite the obtuse angle. No value when that edge is a segment, which
/// is then `blocking_segment`.
std::optional<Candidate> circumcentre_site(const ClassifiedMesh& mesh, int triangle, int& blocking_segment);
/// The off-centre (Ungor 2004): the point on the perpendicular bisector of the shortest edge from which that edge is
/// seen under `angle` (radians), or the circumcentre if that is nearer. It may fall into another triangle: see
/// `locate`. Unlike the paper's centroid it never lies closer to the shortest edge than good angles allow, so that
/// rows of thin triangles along a finely split edge do not split that edge further.
Candidate off_centre_site(const ClassifiedMesh& mesh, int triangle, double angle);
/// Returns the middle of the edge of `h`.
Candidate edge_middle_site(const ClassifiedMesh& mesh, int h);

/// A point of the surface that may become a vertex inside a face.
struct SurfacePoint {
    Vec3 point;
    Vec2 uv;
    Vec3 normal;
};

/// Converts the projection of a candidate; no value if there is none, or it lies on another sheet of the surface.
std::optional<SurfacePoint> surface_point(const Workspace& work, const Candidate& candidate,
                                          const geometry::Answer& nearest);
/// Projects a candidate; no value where the engine finds no surface point nearby.
std::optional<SurfacePoint> surface_point(geometry::Answerer& answerer, const Workspace& work, const Candidate& c);
/// Projects many candidates at once; no value where the engine finds no surface point nearby.
std::vector<std::optional<SurfacePoint>> surface_points(Workspace& work, const std::vector<Candidate>& candidates);

/// The place of a surface point on the mesh.
struct Location {
    int triangle = -1;  ///< triangle that contains it, or -1
    int segment = -1;   ///< segment beyond which it lies, or -1
};
/// Walks from `triangle` to the point without crossing a segment.
Location locate(const ClassifiedMesh& mesh, int triangle, const SurfacePoint& p);

/// The neighbourhood of a new vertex at p: found in the triangles around `triangle` whose circumspheres contain p.
struct Surroundings {
    std::vector<int> encroached;  ///< segments whose diametral sphere contains p, among those visible from p
    double nearest = 1e300;       ///< distance to the nearest vertex, mm
    std::vector<int> triangles;   ///< the visited triangles, including `triangle`
};
Surroundings surroundings_of(const ClassifiedMesh& mesh, int triangle, const Vec3& p);

/// Inserts a vertex into a triangle, adds the neighbours that it would otherwise fold with, and restores the maxmin
/// property. If the vertex would be too close to a corner or fold the mesh nevertheless, changes nothing and returns
/// the cause. Changed triangles are appended to `touched`. New triangles are at least as aligned as `aligned` or the
/// old triangle. The smallest distance to a corner is `shortest`, mm, or that of the workspace.
std::optional<Cause> insert_vertex(Workspace& work, int triangle, const SurfacePoint& p, std::vector<int>& touched,
                                   double aligned = kAligned, std::optional<double> shortest = std::nullopt);

/// Splits a segment at a point of its curve, and the triangles beside it. `on_faces[k]` is the point on the face of
/// use k.
/// @return the halves of these triangles. The new segment is the mesh's last.
std::vector<int> split_at(Workspace& work, int segment, double t, const Vec3& point, const geometry::Answer* on_faces);

}  // namespace mq::triangulate
