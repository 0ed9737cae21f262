// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <array>
#include <set>
#include <utility>
#include <vector>

#include "base/single_grid.h"
#include "geometry/session.h"

namespace mq::geometry {

/// A vertex of the initial triangulation, in the local frame of the grid.
struct ChainVertex {
    Vec3 point = Vec3::Zero();
    Entity entity;
};

/// The polygon that stands for a CAD edge in every face that uses it.
struct EdgeChain {
    bool collapsed = false;     ///< a degenerate edge, or one too short for the grid: all of it is one vertex
    std::vector<double> t;      ///< ascending; at least two
    std::vector<int> vertices;  ///< one a parameter; of a collapsed edge: the same vertex twice
};

/// All edges of a part, each discretised once, so that faces meet vertex by vertex.
class EdgeChains {
  public:
    /// Samples every edge so that its direction turns by 30 degrees at most from vertex to vertex. No vertex is put
    /// where the edge is still within the tolerance of the node at its end: modelers leave hooks there, and curves on
    /// faces that cross those of other edges.
    EdgeChains(Session& session, const SingleGrid& grid);

    const std::vector<ChainVertex>& vertices() const { return vertices_; }
    const EdgeChain& chain(int edge) const { return chains_[edge]; }
    /// The vertex of a CAD node; nodes joined by collapsed edges share one.
    int vertex_of_node(int node) const { return node_vertex_[node]; }
    /// The face is so small that all its edges are collapsed: nothing of it is left to be meshed.
    bool is_a_point(int face) const { return small_faces_.count(face) > 0; }

    using Mark = std::pair<int, int>;  ///< edge, index of the piece from t[i] to t[i + 1]
    /// Halves the marked pieces by arc length. Pieces that the grid cannot halve stay; @return the edges that changed.
    std::set<int> halve(Session& session, const std::set<Mark>& marks);
    /// Takes out the vertices of edges that are within so many tolerances of the node at either end, and lets none be
    /// put there any more. @return the edges that changed.
    std::set<int> leave_nodes_alone(const Topology& topology, const std::set<int>& edges, double tolerances);
    /// Gives an edge other inner vertices, at the ascending parameters `inner`. Those of a collapsed edge stay; points
    /// that single precision does not hold apart from the one before are left out.
    void resample(Session& session, int edge, const std::vector<double>& inner);

  private:
    void place_nodes(const Topology& topology);
    void sample(Session& session);
    void collapse_short_edges(const Topology& topology);
    void collapse_small_faces(Session& session);
    void collapse(int edge, const Edge& data);
    bool leave_nodes_alone(const Topology& topology, int edge, double tolerances, std::vector<Vec3>& points);
    bool at_node(int edge, int end, const Vec3& point) const;

    const SingleGrid& grid_;
    std::vector<ChainVertex> vertices_;
    std::vector<EdgeChain> chains_;
    std::vector<int> node_vertex_;
    std::set<int> small_faces_;
    std::vector<std::vector<Vec3>> points_;  // per edge, while sampling
    /// Around an end of an edge: what lies in it is as good as the node.
    struct Ball {
        Vec3 centre = Vec3::Zero();  // in the part's frame
        double radius = 0.0;
    };
    std::vector<std::array<Ball, 2>> balls_;  // per edge
};

}  // namespace mq::geometry
