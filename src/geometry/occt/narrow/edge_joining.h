// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "base/disjoint_sets.h"
#include "geometry/occt/topology/shape_map.h"

namespace mq::geometry {

/// Makes one edge of two that lie along each other, and one node of several, in the topology of a shape: the shape
/// itself does not change.
class EdgeJoining {
  public:
    struct Alignment {
        bool same_way;    ///< whether t grows the same way on both edges
        double distance;  ///< the largest of the samples of the first from the second, mm
    };

    EdgeJoining(Topology& topology, ShapeMap& live) : topology_(topology), live_(live), nodes_(topology.nodes.size()) {}

    /// Makes all uses of `b` uses of `a`, if they are no farther apart than `within`, or than twice their tolerances.
    /// The tolerance of `a` becomes their distance, if that is larger.
    /// @return whether they are one now
    bool join(int a, int b, double within = 0.0);
    /// The point of an edge, or of a range of it, that is nearest to a point; a nearer one may be left out where one is
    /// found within this distance (mm).
    Answer nearest_on(int e, const Vec3& point, double within, std::array<double, 2> range = {}) const;
    /// How `a` lies along `b`; nothing if a sample of `a` is farther than `within` (mm) from `b`.
    std::optional<Alignment> alignment(int a, int b, double within) const;
    /// Radians: the angle between the faces of two uses in the middle of their edges, which lie along each other; 0:
    /// the faces lie on each other there. Nothing if a use has no curve on its face.
    std::optional<double> dihedral_angle(int use, int other) const;

    /// A new node that belongs to an entity of the shape (Topology::parts_of). @param tolerance  mm
    int add_node(const Vec3& point, double tolerance, Entity owner);
    /// Divides an edge at its parameter `t`, where it gets the node: the edge keeps the first piece.
    /// @return the second piece, a new edge (Topology::parts_of)
    int divide(int e, double t, int node);
    /// The piece of an edge on the border of a face that has the parameter inside: the edge itself if it was not
    /// divided.
    int piece_at(int face, int e, double t) const;
    /// Merges two nodes, if both exist, and records that.
    void unite(int a, int b);
    bool same_node(int a, int b) { return a >= 0 && b >= 0 && nodes_.find(a) == nodes_.find(b); }
    /// Replaces the nodes of the edges by the nodes that they were merged with.
    void rename_nodes();

  protected:
    /// Intervals along an edge, and along each parameter of a face, at whose ends distances are measured.
    static constexpr int kSamples = 8;

    Edge& edge(int e) { return topology_.edges[static_cast<std::size_t>(e)]; }
    const Edge& edge(int e) const { return topology_.edges[static_cast<std::size_t>(e)]; }
    int edge_of(int use) const { return topology_.uses[static_cast<std::size_t>(use)].edge; }
    const EdgeUse& use_of(int use) const { return topology_.uses[static_cast<std::size_t>(use)]; }
    /// The use of an edge on a face.
    int use_on(int e, int face) const;
    /// Takes a use out of a loop, and off its edge.
    void drop(Loop& loop, int use);
    double length(int e) const { return curve(e).length(edge(e).t0, edge(e).t1).distance; }  ///< mm
    /// Whether the edge of a use bounds another face, too.
    bool parts_two_faces(int use) const;
    /// Twice the tolerance of an edge, mm.
    double tolerance(int e) const;
    /// Whether an edge between two nodes is shorter than the detail, and has a curve on all of its faces.
    bool is_short(int e) const;
    /// Whether another face lies on the other side of an edge between two nodes.
    bool is_side(int e) const;
    /// Whether the neighbours of a use on its loop make a corner of DetailCorners::kLeastAngle where its edge is a
    /// point.
    bool leaves_corner(int use) const;
    /// The point of a use's edge at DetailCorners::kReach details from its start or its end, or its other end if it is
    /// shorter.
    Vec3 point_along(int use, bool from_start) const;
    /// The point of the edge of a use at this distance from its end (mm), or from its start.
    Answer point_at(int use, bool from_end, double distance) const;
    /// Whether the faces on the other sides of two uses, whose edges lie along each other, meet at
    /// DetailCorners::kLeastAngle or more, unlike those of a thin plate.
    bool others_open(int use, int other) const;
    /// Radians: the angle between the faces on the other sides of two uses, each at a parameter of its edge; 0 if one
    /// has no curve there.
    double angle_of_others(int use, double t, int other, double other_t) const;
    /// The other use of the edge of one of its two uses.
    int opposite_use(int use) const;
    const EdgeEvaluator& curve(int e) const {
        return live_.curves.of(e, live_.edges[static_cast<std::size_t>(e)], edge(e));
    }
    double parameter(int e, double share) const { return edge(e).t0 + share * (edge(e).t1 - edge(e).t0); }
    /// The direction from the edge of a use, at its parameter t, into the face of the use; none where it has no curve.
    std::optional<Vec3> conormal(int use, double t) const;

    Topology& topology_;
    ShapeMap& live_;

  private:
    void divide_use(int use, int second, double share);

    DisjointSets<int> nodes_;
};

}  // namespace mq::geometry
