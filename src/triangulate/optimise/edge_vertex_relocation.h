// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "base/key_set.h"
#include "triangulate/measure/distance_probes.h"
#include "triangulate/operators/edit_transaction.h"
#include "triangulate/work_mesh/size_bounds.h"
#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// Moves vertices along their CAD edges to improve the angles on all faces that share the edge. Between pieces of very
/// different lengths few positions are good, and the one that halving gave a vertex can be the worst.
class EdgeVertexRelocation {
  public:
    /// A new one is needed after segments were split or joined elsewhere.
    EdgeVertexRelocation(Workspace& work, const Sizing& sizing);

    /// Moves one of the triangle's vertices, if the smallest angle around it becomes at least `enough(before)`
    /// (radians) and lengths and distances from the CAD model stay within their bounds. The change is recorded in
    /// `undo`.
    /// @return the triangles that have changed; none if there is no such position.
    std::vector<int> improve(int triangle, double bound, const std::function<double(double)>& enough,
                             EditTransaction& undo);

  private:
    /// A vertex on a CAD edge and the triangles around it.
    struct EdgeVertexStar {
        int near = -1;                         ///< the segment that ends at the vertex
        int far = -1;                          ///< the segment that starts at the vertex
        std::vector<std::vector<int>> spokes;  ///< by use: the half-edges that leave the vertex on that face
        /// Parallel to `spokes`: the half-edge of the triangle at a small input angle below the bound, or -1.
        std::vector<std::vector<int>> corners;
    };
    /// The smallest angles around a vertex, radians.
    struct Angles {
        double beside = M_PI;      ///< triangles that do not fill small input angles
        double in_corners = M_PI;  ///< other triangles, except the input angle itself
    };
    struct Place {
        double t = 0.0;
        Vec3 point = Vec3::Zero();
        double angle = 0.0;
    };

    std::optional<EdgeVertexStar> bead_at(int vertex, double bound) const;
    static std::vector<int> triangles_around(const EdgeVertexStar& bead);
    std::optional<Angles> angles_with(const EdgeVertexStar& bead, const Vec3& point, const Angles& at_least) const;
    std::vector<std::optional<Vec3>> points_at(const EdgeVertexStar& bead, const std::vector<double>& parameters) const;
    std::optional<Place> best_place(const EdgeVertexStar& bead, const std::vector<double>& parameters,
                                    Angles at_least) const;
    std::vector<Place> places_for(const EdgeVertexStar& bead, const Angles& at_least) const;
    bool lengths_allowed(const EdgeVertexStar& bead, const Vec3& point) const;
    double distance_from_curve(const EdgeVertexStar& bead, const PointOfEdge& middle) const;
    double distance_from_surfaces(const EdgeVertexStar& bead, const std::vector<ClassifiedMesh::VertexUse>& sites,
                                  double where_none) const;
    bool within_tolerance(const EdgeVertexStar& bead, const Place& place,
                          const std::vector<ClassifiedMesh::VertexUse>& sites) const;
    bool aligned(const EdgeVertexStar& bead, const std::vector<ClassifiedMesh::VertexUse>& sites) const;
    bool put(const EdgeVertexStar& bead, const Place& place, double bound, EditTransaction& undo);

    Workspace& work_;
    const Sizing& sizing_;
    KeySet tried_;                                 // neighbourhoods of vertices that were tried, by key
    std::vector<std::array<int, 2>> segments_at_;  // see segments_at_vertices
};

}  // namespace mq::triangulate
