// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "triangulate/fold.h"
#include "triangulate/workspace.h"

namespace mq::triangulate {

/// Where a new site should go, before the engine has put it on the surface.
struct Candidate {
    int triangle = -1;  ///< that owns it
    Vec3 point = Vec3::Zero();
    Vec2 uv = Vec2::Zero();  ///< interpolated: the guess for the engine
    bool uv_is_near = true;  ///< the surface point at `uv` would do as well
    double reach = 0.0;      ///< a foot farther from `point` than this is on another sheet of the surface
};

/// The paper's site (Aftosmis 1999, section 3.3): the circumcentre of a triangle that is not obtuse; otherwise the
/// centroid of the triangle across the edge opposite the obtuse angle. No value when that edge is a segment, which
/// is then `blocking_segment`.
std::optional<Candidate> paper_site(const mesh::SurfaceMesh& mesh, int triangle, int& blocking_segment);
/// The off-centre (Ungor 2004): the point on the perpendicular bisector of the shortest edge from which that edge is
/// seen under `angle` (radians), or the circumcentre when that is nearer. It may fall into another triangle: see
/// `locate`. Unlike the paper's centroid it never lies closer to the shortest edge than good angles allow, so rows of
/// thin triangles along a finely split edge do not split that edge further.
Candidate off_centre_site(const mesh::SurfaceMesh& mesh, int triangle, double angle);
/// The middle of the edge of `h`.
Candidate edge_middle_site(const mesh::SurfaceMesh& mesh, int h);

/// A point of the surface that may become a vertex inside a face.
struct SurfacePoint {
    Vec3 point;
    Vec2 uv;
    Vec3 normal;
};

/// What was found as the nearest to a candidate; no value where that is none, or on another sheet of the surface.
std::optional<SurfacePoint> surface_point(const Workspace& work, const Candidate& candidate,
                                          const geometry::Answer& nearest);
/// Asks for the surface points of many candidates at once; no value where the engine has none near.
std::vector<std::optional<SurfacePoint>> surface_points(Workspace& work, const std::vector<Candidate>& candidates);

/// Where a surface point falls on the mesh.
struct Location {
    int triangle = -1;  ///< that it falls in, or -1
    int segment = -1;   ///< a segment that it lies beyond, or -1
};
/// Walks from `triangle`. Never crosses a segment.
Location locate(const mesh::SurfaceMesh& mesh, int triangle, const SurfacePoint& p);

/// What a new vertex at p would meet: found in the triangles around `triangle` whose circumspheres hold p.
struct Surroundings {
    std::vector<int> encroached;  ///< segments with p in their diametral sphere, among those that p can see
    double nearest = 1e300;       ///< distance to the nearest vertex
    std::vector<int> triangles;   ///< those around `triangle`, with it
};
Surroundings look_around(const mesh::SurfaceMesh& mesh, int triangle, const Vec3& p);

/// Puts a vertex into a triangle, takes in the neighbours that it would fold with otherwise, and restores the maxmin
/// property. Changes nothing, and says why, when it would lie too close to a corner or fold the mesh all the same.
/// Changed triangles are appended to `touched`. New triangles are at least as aligned as `aligned` or the old one.
/// Too close is less than `shortest`, mm, or what the workspace allows.
std::optional<Cause> insert_vertex(Workspace& work, int triangle, const SurfacePoint& p, std::vector<int>& touched,
                                   double aligned = kAligned, std::optional<double> shortest = std::nullopt);

}  // namespace mq::triangulate
