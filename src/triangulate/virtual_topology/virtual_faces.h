// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "triangulate/measure/projection.h"
#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// A sample point of the CAD model whose distance from the mesh changes must limit.
struct CadSample {
    Vec3 point = Vec3::Zero();  ///< in the mesh's frame
    int face = -1;
    Vec2 uv = Vec2::Zero();
    double distance = 0.0;  ///< distance from the mesh before any change, mm
};

/// CAD faces joined across smooth edges to patches, in which triangles may lie on several faces (virtual topology).
///
/// Meanwhile every vertex within a patch has one site, that of one of its faces, so that local operations treat a
/// patch as a face. `settle` afterwards gives the vertices of all triangles that lie on one face the sites of that
/// face again.
class VirtualFaces {
  public:
    /// Dissolves the segments of the edges marked in `smooth` (see smooth_edges). CAD vertices of these edges where
    /// the surface has no normal, or normals more than `feature_angle` degrees apart, are locked.
    VirtualFaces(ClassifiedMesh& mesh, const std::vector<char>& smooth, double feature_angle);

    /// Returns the vertices on dissolved edges, ascending.
    std::vector<int> vertices_on_edges() const;
    /// Whether the vertex must be kept.
    bool locked(int vertex) const { return locked_.count(vertex) > 0; }
    void lock(int vertex) { locked_[vertex] = true; }
    /// Whether the triangle was changed after the edges were dissolved.
    bool changed(int triangle) const;

    /// Returns the faces that the triangles may lie on, with initial guesses for points near `middle`.
    CandidateFaces sheets(const std::vector<int>& triangles, const Vec3& middle) const;
    /// Returns the CAD samples of the triangles: those that changed triangles received, and for each unchanged one the
    /// projections of its centroid and of the middles of its sides.
    std::vector<CadSample> passengers(Workspace& work, const std::vector<int>& triangles);
    int face_of_site(int site) const { return face_of_site_[static_cast<std::size_t>(site)]; }

    /// To be called after triangles were replaced, with the CAD samples of the former ones, and after triangles moved.
    void replaced(const std::vector<int>& triangles, const std::vector<CadSample>& passengers);
    void moved(const std::vector<std::pair<int, int>>& pairs);

    /// Assigns every changed triangle to the face that most of it lies on, and returns those that may lie on several.
    std::map<int, MultiFaceClassification> settle(Workspace& work);

  private:
    void unify_vertex_uses();
    void lock_singular_vertices(double feature_angle);
    int site_on(int half_edge, int face, const Vec2& near) const;
    void add_faces(int triangle, std::vector<int>& faces) const;
    void settle_one(Workspace& work, int triangle, std::map<int, MultiFaceClassification>& spans);

    ClassifiedMesh& mesh_;
    std::vector<int> face_of_site_;
    std::map<int, std::vector<int>> sites_;  // by vertex on a dissolved edge: its sites
    std::map<int, bool> locked_;
    std::vector<std::array<int, 3>> corners_;  // by triangle: the sites of its corners before the edges were dissolved
    std::map<int, std::vector<CadSample>> samples_of_changed_;  // by changed triangle: its CAD samples
    std::map<int, std::vector<CadSample>>
        samples_of_unchanged_;  // by unchanged triangle: its CAD samples, computed on demand
};

}  // namespace mq::triangulate
