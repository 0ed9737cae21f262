// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/key_set.h"
#include "triangulate/measure/deviation_peaks.h"
#include "triangulate/work_mesh/workspace.h"

namespace mq::triangulate {

/// A point of the mesh, in the mesh's frame, and its distance from the CAD model, mm.
struct Distance {
    double distance = 0.0;
    Vec3 point = Vec3::Zero();
    /// The largest distance at points where the CAD model itself is not the cause: CAD edges can deviate from their
    /// faces.
    double avoidable = 0.0;
    bool recalled = false;  ///< taken from the cache in single precision, without the point
};

/// Measures the distance of pieces of the mesh from the CAD model: segments from their curves, inner edges and
/// triangles from their surfaces.
///
/// Every segment and edge is measured at its middle, and also where the largest distance is expected, if that is near
/// `tolerance` (mm): at the peak of the cubic with the surface's slopes at the ends of an edge, at the peak of a cubic
/// over a triangle, and once more beside the farthest of these. To detect undulations between these sample points, the
/// backward distance is measured too: from sample points in every knot span of curves and surfaces (backward_distance).
///
/// Measurements are stored by edge, so that no query is repeated.
class ChordErrorCache {
  public:
    explicit ChordErrorCache(Workspace& work) : work_(work) {}

    std::vector<Distance> of_segments(const std::vector<int>& segments, double tolerance);
    std::vector<Distance> of_edges(const std::vector<int>& half_edges, double tolerance);
    /// The projection of an edge's middle on its surface.
    struct SurfaceProjection {
        std::size_t index;  ///< index into the edges
        geometry::Answer nearest;
    };
    /// Returns the projections of those edges of the last `of_edges` whose middles were queried and exceed the
    /// tolerance, ascending.
    const std::vector<SurfaceProjection>& projections_of_far_midpoints() const { return projections_; }
    /// Measures triangles, whose sides must have been measured.
    std::vector<Distance> of_triangles(const std::vector<int>& triangles, double tolerance);

    /// Returns the last measured distance of an edge, or of a segment by its first half-edge, mm; 0: not measured.
    double distance_known(int half_edge) const { return static_cast<double>(known(half_edge).distance); }
    /// All measurements of an edge, which can be passed to an edge between the same points in another mesh.
    struct Measured {
        float tolerance = -1.0F;  ///< tolerance it was measured for, mm; below 0: not measured
        float distance = 0.0F;
        float avoidable = 0.0F;
        float height = 0.0F;                    ///< signed height over the middle, mm; not for segments
        std::array<double, 3> offset{0, 0, 0};  ///< offset of a segment's middle from its curve, mm
    };
    Measured measured(int half_edge) const;
    void set_measured(int half_edge, const Measured& measured);
    /// Takes all measurements of the mesh of another cache, whose half-edges are `first`, first + 1, ... here.
    void adopt(const ChordErrorCache& other, int first);

    /// Follows ClassifiedMesh::renumber_edges.
    void renumber(const LargeVector<int>& renewed) { move_to_numbers(renewed, known_); }
    /// Follows ClassifiedMesh::order_in_space.
    void renumber(const NewIndices& renewed);
    /// Discards the measurements of edges by number and those of vertices, and frees their memory.
    void clear() {
        known_ = {};
        site_offsets_ = {};
    }
    /// Discards the measurements of an edge, or of a segment by any of its half-edges.
    void forget(int half_edge);

  private:
    struct Known {
        float tolerance = -1.0F;  // tolerance it was measured for, mm; below 0: not measured
        float distance = 0.0F;
        float avoidable = 0.0F;
        float height = 0.0F;  // signed height over the middle, mm; not for segments
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
    std::optional<geometry::Answer> measure_edge(geometry::Answerer& answerer, int half_edge, double tolerance,
                                                 Distance& result);
    void measure_triangle(geometry::Answerer& answerer, int triangle, double tolerance, Distance& result) const;
    void measure_backward(int triangle, double tolerance, Distance& result);
    void measure_sites(const std::vector<int>& half_edges);
    double offset(int half_edge) const { return site_offsets_[work_.mesh.site_of(half_edge)]; }

    Workspace& work_;
    // By site: distance of vertices on CAD edges from the surface, mm; below 0: not measured.
    LargeVector<double> site_offsets_;
    LargeVector<Known> known_;  // by the number of the edge; for a segment, of its first half-edge
    std::vector<SurfaceProjection> projections_;
    using Offset = std::array<double, 3>;
    KeyMap<Offset> offsets_;  // by their vertices: offsets of the middles of segments from their curves, mm
};

}  // namespace mq::triangulate
