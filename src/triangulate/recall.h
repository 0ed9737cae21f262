// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "geometry/initial_triangulation.h"
#include "triangulate/memory.h"
#include "triangulate/workspace.h"

namespace mq::triangulate {

/// Brings remembered faces into the mesh of a part: those whose geometry is the same, over the samples that their edges
/// had. Where the part stands elsewhere as a whole they go with it. Every vertex is compared with the surface as it is
/// now.
class Recall {
  public:
    /// `faces`: Keys::faces of the session's part. `chord`: mm, as it is asked for now; 0: not.
    Recall(geometry::Session& session, const SingleGrid& grid, std::shared_ptr<const Run> run,
           const std::vector<geometry::Fingerprint>& faces, double chord);

    /// The remembered faces over the chains of all edges; the others are to be triangulated yet.
    geometry::InitialTriangulation begin();
    /// Once all faces are triangulated and assembled: marks the triangles of remembered ones that keep `min_angle`
    /// (degrees) as settled, and hands over what was measured.
    void settle(const geometry::EdgeChains& chains, Workspace& work, ChordMeasure& measure, double min_angle);

    /// What the mesh of a face began with; null: with nothing.
    const RememberedFace* beginning(int face) const { return settled_[face].empty() ? nullptr : faces_[face].get(); }
    /// By face: what was remembered of it, where all its triangles are those still; else null.
    std::vector<std::shared_ptr<const RememberedFace>> kept(const mesh::SurfaceMesh& mesh) const;
    /// Of all vertices along an edge, the least number in any run since it is known; 0: it is not.
    std::size_t fewest(int edge) const { return fewest_[edge]; }
    /// Whether what was measured of the vertices and edges of a face holds as it is.
    bool exact(int face) const { return exact_[face] != 0; }

  private:
    using Corners = std::array<int, 3>;

    bool fine_enough(const RememberedFace& face, double chord) const;
    bool same_borders(const geometry::EdgeChains& chains, int face) const;
    void claim_edges(const geometry::EdgeChains& chains);
    void forget_where_edges_differ(const geometry::EdgeChains& chains);
    void forget_where_points_differ();
    void forget_what_changes_made_fine();
    bool made_fine_by_changes(int face) const;
    geometry::FaceTriangulation restored(const geometry::EdgeChains& chains, int face);
    void settle_face(int face, const std::vector<int>& triangles, double bound, Workspace& work,
                     ChordMeasure& measure) const;
    static std::vector<Corners> corners(const mesh::SurfaceMesh& mesh, const std::vector<int>& triangles);

    geometry::Session& session_;
    const SingleGrid& grid_;
    std::shared_ptr<const Run> run_;
    geometry::Motion motion_;                                   // from where the part stood to where it stands
    std::vector<std::shared_ptr<const RememberedFace>> faces_;  // of each face; null: none
    std::vector<const std::vector<double>*> claims_;            // of each edge; null: it is sampled afresh
    std::vector<std::size_t> fewest_;                           // of each edge
    std::vector<char> exact_;                                   // by face: all points are bit by bit where they were
    std::vector<std::vector<Corners>> settled_;                 // by face, in order
};

}  // namespace mq::triangulate
