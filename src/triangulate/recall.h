// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <vector>

#include "geometry/initial_triangulation.h"
#include "triangulate/memory.h"
#include "triangulate/workspace.h"

namespace mq::triangulate {

/// What the faces of a part are remembered by: their fingerprints, and the local sizes asked for on and around them.
std::vector<geometry::Fingerprint> keys_of_faces(geometry::Session& session, const Options& options);

/// Brings remembered faces into the mesh of a part: those whose geometry is the same, over the samples that their edges
/// had. Every vertex is compared with the surface as it is now.
class Recall {
  public:
    /// `keys` of all faces of the session's part.
    Recall(geometry::Session& session, const SingleGrid& grid, const Memory& memory,
           const std::vector<geometry::Fingerprint>& keys);

    /// The remembered faces over the chains of all edges; the others are to be triangulated yet.
    geometry::InitialTriangulation begin();
    /// Once all faces are triangulated and assembled: marks the triangles of remembered ones as settled, and hands over
    /// what was measured of them for the same `chord`.
    void settle(const geometry::EdgeChains& chains, Workspace& work, ChordMeasure& measure, double chord);
    /// How many of the settled faces have all their triangles still.
    std::size_t kept(const mesh::SurfaceMesh& mesh) const;

  private:
    using Corners = std::array<int, 3>;

    bool same_borders(const geometry::EdgeChains& chains, int face) const;
    void claim_edges(const geometry::EdgeChains& chains);
    void forget_where_edges_differ(const geometry::EdgeChains& chains);
    void forget_where_points_differ();
    geometry::FaceTriangulation restored(const geometry::EdgeChains& chains, int face) const;
    static std::vector<Corners> corners(const mesh::SurfaceMesh& mesh, const std::vector<int>& triangles);

    geometry::Session& session_;
    const SingleGrid& grid_;
    const Memory& memory_;
    std::vector<const RememberedFace*> faces_;            // of each face; null: none
    std::vector<const std::vector<double>*> parameters_;  // of each edge; null: as the edge is sampled afresh
    std::vector<std::vector<Corners>> settled_;           // by face, in order
};

}  // namespace mq::triangulate
