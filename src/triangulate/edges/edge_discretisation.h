// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <set>
#include <utility>
#include <vector>

#include "base/single_precision_grid.h"
#include "geometry/session.h"

namespace mq::triangulate {

/// A vertex of the initial triangulation, in the local frame of the grid, mm.
struct ChainVertex {
    Vec3 point = Vec3::Zero();
    geometry::Entity entity;
};

/// The polygon that represents a CAD edge in every face that uses it.
struct EdgePolyline {
    bool collapsed = false;     ///< a degenerate edge, or one too short for the grid: it is a single vertex
    std::vector<double> t;      ///< ascending; at least two
    std::vector<int> vertices;  ///< one for each parameter; for a collapsed edge the same vertex twice
};

/// All edges of a shape, each discretised once, so that faces share vertices.
class EdgeDiscretisation {
  public:
    /// Samples every edge so that its tangent turns by at most 30 degrees from vertex to vertex. No vertex is placed
    /// where the edge is still within the tolerance of the node at its end: modellers leave end artefacts there, and
    /// curves on faces that cross those of other edges.
    /// Edges shorter than the detail of the topology are contracted to a vertex where that is safe
    /// (contractible_edges), other than those that are `kept`.
    EdgeDiscretisation(geometry::Session& session, const SinglePrecisionGrid& grid, const std::set<int>& kept = {});

    const std::vector<ChainVertex>& vertices() const { return vertices_; }
    const EdgePolyline& chain(int edge) const { return chains_[edge]; }
    /// Returns the vertex of a CAD node; nodes joined by collapsed edges share one.
    int vertex_of_node(int node) const { return node_vertex_[node]; }
    /// Whether the face is so small that all its edges are collapsed and there is nothing to mesh.
    bool is_a_point(int face) const { return small_faces_.count(face) > 0; }

    /// The edges that were contracted because they are shorter than the detail of the topology.
    const std::vector<int>& contracted() const { return contracted_; }

    using PieceRef = std::pair<int, int>;  ///< edge, index of the piece from t[i] to t[i + 1]
    /// Halves the marked pieces by arc length, except those that the grid cannot halve. @return the edges that
    /// changed.
    std::set<int> halve(geometry::Session& session, const std::set<PieceRef>& marks);
    /// Removes vertices of the edges within `tolerances` times the tolerance of the node at either end, and suppresses
    /// later ones there. @return the edges that changed.
    std::set<int> suppress_near_nodes(const geometry::Topology& topology, const std::set<int>& edges,
                                      double tolerances);
    /// Radius around an end of the edge, mm, within which it has no vertices: see unresolved_ends.
    double unresolved(int edge, int end) const {
        return unresolved_[static_cast<std::size_t>(edge)][static_cast<std::size_t>(end)];
    }
    /// Replaces the inner vertices of an edge, with the ascending parameters `inner`. A collapsed edge does not
    /// change; points that single precision cannot separate from the one before are omitted.
    void resample(geometry::Session& session, int edge, const std::vector<double>& inner);

  private:
    void place_nodes(const geometry::Topology& topology);
    void place_points(const geometry::Topology& topology);
    void sample(geometry::Session& session);
    void contract_short_edges(const geometry::Topology& topology);
    void collapse_small_faces(geometry::Session& session);
    void collapse(int edge, const geometry::Edge& data);
    bool suppress_near_nodes(const geometry::Topology& topology, int edge, double tolerances,
                             std::vector<Vec3>& points);
    bool at_node(int edge, int end, const Vec3& point) const;

    const SinglePrecisionGrid& grid_;
    std::vector<ChainVertex> vertices_;
    std::vector<EdgePolyline> chains_;
    std::vector<int> node_vertex_;
    std::set<int> small_faces_;
    std::vector<int> contracted_;
    std::vector<std::vector<Vec3>> points_;  // by edge, only while edges are sampled
    /// A ball around an end of an edge: points inside it are not distinguished from the node.
    struct Ball {
        Vec3 centre = Vec3::Zero();  // in the shape's frame
        double radius = 0.0;
    };
    std::vector<std::array<Ball, 2>> balls_;         // by edge
    std::vector<std::array<double, 2>> unresolved_;  // by edge and end: see unresolved_ends
};

}  // namespace mq::triangulate
