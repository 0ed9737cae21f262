// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <vector>

#include "triangulate/chord_measure.h"
#include "triangulate/sizing.h"
#include "triangulate/star_polygon.h"

namespace mq::triangulate {

/// Takes vertices out where all bounds hold without them: inside faces, and on CAD edges for all their faces at once.
/// Refinement leaves many: halving makes edges up to twice as fine as asked for, and what grew around a small detail
/// need not stay once the detail is there.
///
/// Only vertices that refinement put in: those of the initial triangulation hold the edges' shape. Without a tolerance
/// no place gets farther from the part than the mesh around the vertex was.
class Coarsener {
  public:
    /// Vertices below `first_vertex` stay.
    Coarsener(Workspace& work, const ChordMeasure& measure, double min_angle_degrees, const Sizing& sizing,
              int first_vertex);

    /// @return whether anything was taken out. Leaves no triangle that is gone.
    bool run();

  private:
    struct Plan {
        int vertex = -1;
        std::vector<StarPolygon> polygons;  // one; for a vertex on a CAD edge one for each use of its segments
        std::vector<PolygonFan> fans;
        std::vector<std::uint32_t> stamps;  // of the polygons' triangles, in their order
        int near = -1;                      // segments that end and start at the vertex
        int far = -1;
    };

    void find_places();
    bool on_edge(int vertex) const { return work_.mesh.vertex(vertex).entity[0] == 1; }
    bool worth_trying(int vertex) const;
    bool can_be_joined(int near, int far) const;
    std::optional<Plan> plan_for(int vertex) const;
    double least_angle(const StarPolygon& polygon) const;
    bool add_fan(int half_edge, Plan& plan) const;
    bool lengths_allowed(int half_edge, const StarPolygon& polygon, const PolygonFan& fan) const;
    bool heights_expected(const StarPolygon& polygon, const PolygonFan& fan) const;
    std::vector<Plan> plans(std::vector<int>& candidates);
    double way_back_to_new(const Plan& plan) const;
    std::vector<char> near_part(const std::vector<Plan>& plans);
    void add_new(const Plan& plan, geometry::Engine::Batch& batch) const;
    void add_old(const Plan& plan, geometry::Engine::Batch& batch) const;
    bool still_good(const Plan& plan) const;
    void carry_out(const Plan& plan, std::vector<int>& around);

    Workspace& work_;
    const ChordMeasure& measure_;
    double bound_;  // radians
    double least_angle_;
    const Sizing& sizing_;
    int first_vertex_;
    int most_spokes_;                // inside a face: the corners of a fan's polygon on a circle are so many at most
    std::vector<int> half_edge_of_;  // that leaves the vertex; -1: none, or the vertex is gone
    std::vector<std::array<int, 2>> segments_at_;  // of a vertex on a CAD edge: that end there, and that start there
};

}  // namespace mq::triangulate
