// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "triangulate/nearest_sheet.h"
#include "triangulate/workspace.h"

namespace mq::triangulate {

/// A point of the part that a change of the mesh must stay near.
struct Passenger {
    Vec3 point = Vec3::Zero();  ///< in the mesh's frame
    int face = -1;
    Vec2 uv = Vec2::Zero();
    double distance = 0.0;  ///< from the mesh as it was before any change, mm
};

/// CAD faces joined across smooth edges to patches, in which triangles may lie on several faces (virtual topology).
///
/// While it lasts every vertex within a patch has one site, that of one of its faces, so that a patch is for the local
/// changes of a mesh what a face is. `settle` gives the vertices of all triangles that lie on one face the sites of
/// that face again.
class Patches {
  public:
    /// Dissolves the segments of the edges marked in `smooth` (see smooth_edges). CAD vertices among these edges where
    /// the surface has no normal, or normals `feature_angle` degrees apart, are locked.
    Patches(mesh::SurfaceMesh& mesh, const std::vector<char>& smooth, double feature_angle);

    /// The vertices on dissolved edges, ascending.
    std::vector<int> vertices_on_edges() const;
    /// A locked vertex must stay.
    bool locked(int vertex) const { return locked_.count(vertex) > 0; }
    void lock(int vertex) { locked_[vertex] = true; }
    /// Whether the triangle was changed since the edges were dissolved.
    bool changed(int triangle) const;

    /// The faces that the triangles may lie on, with guesses for points near `middle`.
    Sheets sheets(const std::vector<int>& triangles, const Vec3& middle) const;
    /// Points of the part under the triangles: those that changed ones took over, and of each other one the feet of its
    /// centroid and of the middles of its sides.
    std::vector<Passenger> passengers(Workspace& work, const std::vector<int>& triangles);
    int face_of_site(int site) const { return face_of_site_[static_cast<std::size_t>(site)]; }

    /// To be told: triangles that took the place of others with their passengers, and triangles that moved.
    void replaced(const std::vector<int>& triangles, const std::vector<Passenger>& passengers);
    void moved(const std::vector<std::pair<int, int>>& pairs);

    /// Puts every changed triangle to the face that most of it lies on, and says which may lie on several.
    std::map<int, Span> settle(Workspace& work);

  private:
    void unify_sites();
    void lock_tips(double feature_angle);
    int site_on(int half_edge, int face, const Vec2& near) const;
    void add_faces(int triangle, std::vector<int>& faces) const;
    void settle_one(Workspace& work, int triangle, std::map<int, Span>& spans);

    mesh::SurfaceMesh& mesh_;
    std::vector<int> face_of_site_;
    std::map<int, std::vector<int>> sites_;  // by vertex on a dissolved edge
    std::map<int, bool> locked_;
    std::vector<std::array<int, 3>> corners_;      // by triangle, as they were
    std::map<int, std::vector<Passenger>> loads_;  // by changed triangle
    std::map<int, std::vector<Passenger>> feet_;   // by unchanged triangle, once somebody asked
};

}  // namespace mq::triangulate
