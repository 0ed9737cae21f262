// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "base/key_set.h"
#include "triangulate/distance_probes.h"
#include "triangulate/region_undo.h"
#include "triangulate/sizing.h"
#include "triangulate/workspace.h"

namespace mq::triangulate {

/// Moves vertices along their CAD edges, for the angles around them on all faces that share the edge. Vertices between
/// pieces of very different lengths have little room: there the place that halving gave a vertex can be the worst.
class Slider {
  public:
    /// To be made anew after segments were split or joined.
    Slider(Workspace& work, const Sizing& sizing);

    /// Moves one of the triangle's vertices, if the smallest angle around it becomes at least `enough(before)`
    /// (radians) and lengths and distances from the part stay within their bounds. What is to be undone by and by is
    /// told to `undo`.
    /// @return the triangles that have changed; none when there is no such place.
    std::vector<int> improve(int triangle, double bound, const std::function<double(double)>& enough, UndoStack& undo);

    /// The smallest angle, radians, around a vertex on a CAD edge after it has moved by a part of the way to the next
    /// one (below 0: the one before); no value where it cannot.
    std::optional<double> angle_after(int vertex, double step, double bound) const;
    /// Moves it there, whatever its angles. @return as `improve`
    std::vector<int> move(int vertex, double step, double bound, UndoStack& undo);

    /// After a segment was split into itself and `far`.
    void was_split(int segment, int far);

  private:
    /// A vertex on a CAD edge and all around it.
    struct Bead {
        int near = -1;                         ///< the segment that ends in it
        int far = -1;                          ///< the segment that starts there
        std::vector<std::vector<int>> spokes;  ///< by use: half-edges that leave it on that face
        /// Beside `spokes`: of its triangle, the half-edge at a corner of the part that is narrower than the bound, or
        /// -1
        std::vector<std::vector<int>> corners;
    };
    /// The smallest angles around a vertex, radians.
    struct Angles {
        double beside = M_PI;      ///< of triangles that are not at narrow corners of the part
        double in_corners = M_PI;  ///< of the others, but for the one at the corner
    };
    struct Place {
        double t = 0.0;
        Vec3 point = Vec3::Zero();
        double angle = 0.0;
    };

    std::optional<Bead> bead_at(int vertex, double bound) const;
    static std::vector<int> triangles_around(const Bead& bead);
    Angles angles_with(const Bead& bead, const Vec3& point) const;
    std::vector<Place> places_for(const Bead& bead, const std::vector<double>& parameters,
                                  const Angles& at_least) const;
    std::vector<Place> places_for(const Bead& bead, const Angles& at_least) const;
    bool lengths_allowed(const Bead& bead, const Vec3& point) const;
    double distance_from_curve(const Bead& bead, const PointOfEdge& middle) const;
    double distance_from_surfaces(const Bead& bead, const std::vector<mesh::SurfaceMesh::Site>& sites,
                                  double where_none) const;
    bool near_part(const Bead& bead, const Place& place, const std::vector<mesh::SurfaceMesh::Site>& sites) const;
    bool aligned(const Bead& bead, const std::vector<mesh::SurfaceMesh::Site>& sites) const;
    std::optional<Place> place_at(const Bead& bead, double step) const;
    bool put(const Bead& bead, const Place& place, double bound, UndoStack& undo);

    Workspace& work_;
    const Sizing& sizing_;
    KeySet tried_;                                 // what is around a vertex, by key
    std::vector<std::array<int, 2>> segments_at_;  // see segments_at_vertices
};

}  // namespace mq::triangulate
