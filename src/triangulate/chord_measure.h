// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/key_set.h"
#include "triangulate/deviation.h"
#include "triangulate/workspace.h"

namespace mq::triangulate {

/// A point of the mesh and its distance from the part, mm. In the mesh's frame.
struct Distance {
    double distance = 0.0;
    Vec3 point = Vec3::Zero();
    /// The largest distance at points where more than the part itself is the reason: CAD edges can lie off their faces.
    double avoidable = 0.0;
    bool recalled = false;  ///< measured before, and kept in single precision, without the point
};

/// Measures how far pieces of the mesh are from the part: segments from their curves, inner edges and triangles from
/// their surfaces.
///
/// Every segment and edge is measured at its middle, and where else the largest distance is expected, if that is near
/// `tolerance` (mm): at the peak of the cubic with the surface's slopes at the ends of an edge, and at that of a cubic
/// over a triangle; and once more beside the farthest of these. So that no wave of the part lies between these places,
/// the way back is measured, too: from points in every span of its curves and surfaces (way_back).
///
/// What was measured is kept by edge, so nothing is asked twice.
class ChordMeasure {
  public:
    explicit ChordMeasure(Workspace& work) : work_(work) {}

    std::vector<Distance> of_segments(const std::vector<int>& segments, double tolerance);
    std::vector<Distance> of_edges(const std::vector<int>& half_edges, double tolerance);
    /// What the surface has over the middle of an edge.
    struct Foot {
        std::size_t index;  ///< among the edges
        geometry::Answer nearest;
    };
    /// Of the edges of the last `of_edges` whose middles were asked for and are farther than the tolerance; ascending.
    const std::vector<Foot>& feet_of_far_middles() const { return feet_; }
    /// Their sides must have been measured.
    std::vector<Distance> of_triangles(const std::vector<int>& triangles, double tolerance);

    /// Of an edge, or of a segment by its first half-edge, as last measured, mm; 0 when it was not.
    double distance_known(int half_edge) const { return static_cast<double>(known(half_edge).distance); }
    /// All that was measured of an edge, to be given to an edge between the same points of another mesh.
    struct Measured {
        float tolerance = -1.0F;  ///< that it was measured for; below 0: it was not
        float distance = 0.0F;
        float avoidable = 0.0F;
        float height = 0.0F;                    ///< over the middle, with the sign of the side; not of segments
        std::array<double, 3> offset{0, 0, 0};  ///< of the middle of a segment from its curve
    };
    Measured measured(int half_edge) const;
    void take(int half_edge, const Measured& measured);

    /// To measure an edge anew, or a segment by any of its half-edges.
    void forget(int half_edge);

  private:
    struct Known {
        float tolerance = -1.0F;  // that it was measured for; below 0: it was not
        float distance = 0.0F;
        float avoidable = 0.0F;
        float height = 0.0F;  // over the middle, with the sign of the side; not of segments
    };
    const Known& known(int half_edge) const;
    bool settled(int half_edge, double tolerance) const;
    bool recall(int half_edge, Distance& result) const;
    void keep(int half_edge, double tolerance, const Distance& distance);
    void keep_height(int half_edge, const Vec3& middle, const geometry::Answer& foot);
    int half_edge_of(int segment) const { return work_.mesh.segment(segment).uses.front().half_edge; }
    std::uint64_t ends_key(int half_edge) const;
    double height(int half_edge) const;
    TriangleHeights heights(int first_half_edge) const;
    void see_way_back(int triangle, double tolerance, Distance& result);
    void measure_sites(const std::vector<int>& half_edges);
    double offset(int half_edge) const { return site_offsets_[work_.mesh.site_of(half_edge)]; }

    Workspace& work_;
    std::vector<double> site_offsets_;  // of vertices on CAD edges from the surface, mm, by site; below 0: not known
    std::vector<Known> known_;          // by the number of the edge; of a segment the one of its first half-edge
    std::vector<Foot> feet_;
    using Offset = std::array<double, 3>;
    KeyMap<Offset> offsets_;  // of the middles of segments from their curves, by their vertices
};

}  // namespace mq::triangulate
