// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "triangulate/incremental/mesh_cache.h"
#include "triangulate/initial/initial_triangulation.h"
#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// Restores cached faces into the mesh of a shape: those with unchanged geometry, over the cached samples of their
/// edges. If the whole shape was moved, they move with it. Every inner vertex is compared with the present surface.
class CacheRestore {
  public:
    /// `faces`: CacheKeys::faces of the session's shape. `chord`: the present chord tolerance in mm; 0: none.
    CacheRestore(geometry::Session& session, const SinglePrecisionGrid& grid, std::shared_ptr<const CachedRun> run,
                 const std::vector<geometry::Fingerprint>& faces, double chord);

    /// Returns the restored faces over the chains of all edges; the other faces remain to be triangulated.
    InitialTriangulation begin();
    /// To be called once all faces are triangulated and assembled. Marks triangles of restored faces as settled if
    /// their angles reach `min_angle` (degrees), or if they were exempt and their neighbourhood is unchanged; passes
    /// the cached measurements on.
    void mark_settled(const EdgeDiscretisation& chains, Workspace& work, ChordErrorCache& measure, double min_angle);

    /// Whether any face was restored from the cache.
    bool began() const;
    /// The cached face with which the mesh of a face began; null: none.
    const CachedFace* beginning(int face) const { return settled_[face].empty() ? nullptr : faces_[face].get(); }
    /// By face: its cached face if the mesh still has exactly its triangles, else null.
    std::vector<std::shared_ptr<const CachedFace>> kept(const ClassifiedMesh& mesh) const;
    /// The least number of vertices along an edge in any run since its geometry is known; 0: the edge is new.
    std::size_t min_sample_count(int edge) const { return fewest_[edge]; }
    /// Whether the cached measurements of the vertices and edges of a face hold unchanged.
    bool exact(int face) const { return exact_[face] != 0; }

  private:
    using Corners = std::array<int, 3>;

    bool fine_enough(const CachedFace& face, double chord) const;
    bool same_borders(const EdgeDiscretisation& chains, int face) const;
    void assign_edge_samples(const EdgeDiscretisation& chains);
    void forget_where_edges_differ(const EdgeDiscretisation& chains);
    void forget_where_points_differ();
    void drop_over_refined();
    bool made_fine_by_changes(int face) const;
    FaceMesh restored(const EdgeDiscretisation& chains, int face);
    void mark_settled_face(int face, const std::vector<int>& triangles, double bound, Workspace& work,
                           ChordErrorCache& measure) const;
    void mark_given_up(const EdgeDiscretisation& chains, const std::vector<std::vector<int>>& triangles,
                       Workspace& work) const;
    static std::vector<Corners> corners(const ClassifiedMesh& mesh, const std::vector<int>& triangles);

    geometry::Session& session_;
    const SinglePrecisionGrid& grid_;
    std::shared_ptr<const CachedRun> run_;
    geometry::RigidMotion motion_;  // moves the cached placement of the shape to the present one
    std::vector<std::shared_ptr<const CachedFace>> faces_;  // by face; null: not restored
    std::vector<const std::vector<double>*> claims_;        // by edge: its cached parameters; null: it is sampled anew
    std::vector<std::size_t> fewest_;                       // by edge: see min_sample_count()
    std::vector<char> exact_;                    // by face: whether all points are bit by bit where they were
    std::vector<std::vector<Corners>> settled_;  // by face, ascending
};

}  // namespace mq::triangulate
