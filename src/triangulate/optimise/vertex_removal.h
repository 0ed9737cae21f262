// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "triangulate/measure/chord_error.h"
#include "triangulate/operators/removal_cavity.h"
#include "triangulate/work_mesh/size_bounds.h"

namespace mq::triangulate {

/// Removes vertices where all bounds hold without them: inside faces, and on CAD edges for all their faces at once.
/// Refinement leaves many: halving makes edges up to twice as fine as the bounds require, and the fine triangles
/// around a small detail may no longer be needed.
///
/// Only vertices that refinement inserted are removed: those of the initial triangulation represent the shape of
/// edges. Without a tolerance, the distance from the CAD model does not become larger than that of the present mesh
/// around the vertex.
class VertexRemoval {
  public:
    /// Vertices with an index below `first_vertex` are kept.
    VertexRemoval(Workspace& work, const ChordErrorCache& measure, double min_angle_degrees, const Sizing& sizing,
                  int first_vertex);

    /// @return whether any vertex was removed. Leaves no unused triangle indices.
    bool run();

  private:
    struct RemovalPlan {
        int vertex = -1;
        std::vector<RemovalCavity>
            cavities;  // a single one; for a vertex on a CAD edge one for each use of its segments
        std::vector<Fan> fans;
        std::vector<std::uint32_t> stamps;  // versions of the cavities' triangles, in their order
        int near = -1;                      // the segments that end and start at the vertex; -1: it is inside a face
        int far = -1;
    };

    void find_places();
    std::vector<int> in_order() const;
    bool on_edge(int vertex) const { return work_.mesh.vertex(vertex).entity[0] == 1; }
    bool is_candidate(int vertex) const;
    bool can_be_joined(int near, int far) const;
    std::optional<RemovalPlan> plan_for(int vertex) const;
    double least_angle(const RemovalCavity& cavity) const;
    bool add_fan(int half_edge, RemovalPlan& plan) const;
    bool lengths_allowed(int half_edge, const RemovalCavity& cavity, const Fan& fan) const;
    bool heights_expected(const RemovalCavity& cavity, const Fan& fan) const;
    std::vector<std::optional<RemovalPlan>> plans_for(const int* first, const int* last) const;
    bool remove_some(std::vector<int>& candidates);
    static void choose(RemovalPlan plan, LargeVector<char>& taken, std::vector<RemovalPlan>& chosen,
                       std::vector<int>& later);
    double backward_to_new(const RemovalPlan& plan) const;
    std::optional<double> distance_kept(geometry::Answerer& answerer, const RemovalPlan& plan) const;
    void compute_samples(const RemovalPlan& plan);
    std::vector<char> within_tolerance(const std::vector<RemovalPlan>& plans);
    void add_new(const RemovalPlan& plan, geometry::Engine::Batch& batch) const;
    void add_old(const RemovalPlan& plan, geometry::Engine::Batch& batch) const;
    bool is_valid(const RemovalPlan& plan) const;
    void apply(const RemovalPlan& plan, std::vector<int>& around);

    Workspace& work_;
    const ChordErrorCache& measure_;
    double bound_;  // radians
    double least_angle_;
    const Sizing& sizing_;
    int first_vertex_;
    // Largest number of spokes inside a face: a fan from a corner of a regular cavity with more corners misses
    // least_angle_.
    int most_spokes_;
    std::vector<int> half_edge_of_;  // by vertex: a half-edge that leaves it; -1: none, or the vertex was removed
    std::vector<std::array<int, 2>> segments_at_;  // by vertex on a CAD edge: the segments that end and start there
};

}  // namespace mq::triangulate
