// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/edges/unresolved_ends.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/angle.h"
#include "geometry/detail.h"
#include "triangulate/edges/tuning.h"

namespace mq::triangulate {

namespace {

constexpr int kDeviationSamples = 16;  // Pieces of an edge, at whose ends it is compared with its curves on faces.

// Two edges at a corner of a face: each by its index, its end at the corner, and the length up to which it is examined.
struct FaceCorner {
    std::array<int, 2> edge;
    std::array<int, 2> end;
    std::vector<double> distances{};  // from the node, mm, descending

    int node(const geometry::Topology& topology, int k) const { return topology.edges[edge[k]].nodes[end[k]]; }
    bool at_one_node(const geometry::Topology& topology) const { return node(topology, 0) == node(topology, 1); }
};

// @param lengths  of the edges, mm; 0: the edge is a point, and the edges before and after it meet in it
std::vector<FaceCorner> corners_of_faces(const geometry::Topology& topology, const std::vector<double>& lengths) {
    // Where corners are cut off, edges are a detail apart at the node, and told apart beyond it.
    const std::set<int> cut(topology.cut_corners.begin(), topology.cut_corners.end());
    std::vector<FaceCorner> corners;
    for (const geometry::Face& face : topology.faces) {
        for (const geometry::Loop& loop : face.loops) {
            std::vector<int> uses = loop.uses;
            uses.erase(std::remove_if(uses.begin(), uses.end(),
                                      [&](int use) { return !(lengths[topology.uses[use].edge] > 0.0); }),
                       uses.end());
            for (std::size_t i = 0; i < uses.size(); ++i) {
                const geometry::EdgeUse& a = topology.uses[uses[i]];
                const geometry::EdgeUse& b = topology.uses[uses[(i + 1) % uses.size()]];
                const FaceCorner corner{{a.edge, b.edge}, {a.forward ? 1 : 0, b.forward ? 0 : 1}};
                if (a.edge != b.edge && corner.node(topology, 0) >= 0 && corner.node(topology, 1) >= 0 &&
                    cut.count(corner.node(topology, 0)) == 0) {
                    corners.push_back(corner);
                }
            }
        }
    }
    return corners;
}

// Keeps the corners whose edges leave the node at less than EdgeTuning::kApart.
void keep_narrow(geometry::Session& session, std::vector<FaceCorner>& corners) {
    const geometry::Topology& topology = session.topology();
    geometry::Engine::Batch batch;
    for (const FaceCorner& corner : corners) {
        for (int k = 0; k < 2; ++k) {
            const geometry::Edge& edge = topology.edges[corner.edge[k]];
            batch.push_back(geometry::Query::edge_point(corner.edge[k], corner.end[k] == 0 ? edge.t0 : edge.t1));
        }
    }
    const geometry::Engine::Answers ends = session.ask(std::move(batch));
    const geometry::Answer* at = ends.data();
    const auto wide = [&](const FaceCorner& corner) {
        const Vec3 a = (corner.end[0] == corner.end[1] ? 1.0 : -1.0) * at[0].normal;
        const bool known = at[0].found() && at[1].found();
        const bool apart = known && angle_between(a, at[1].normal) > EdgeTuning::kApart;
        at += 2;
        return apart;
    };
    corners.erase(std::remove_if(corners.begin(), corners.end(), wide), corners.end());
}

// Returns the largest distances of edges from their curves on faces, mm, by edge: the tolerances that modellers give
// are often a hundred times as large. Measured for the edges of the corners only.
std::map<int, double> deviations(geometry::Session& session, const std::vector<FaceCorner>& corners) {
    const geometry::Topology& topology = session.topology();
    std::map<int, double> result;
    for (const FaceCorner& corner : corners) {
        result[corner.edge[0]];
        result[corner.edge[1]];
    }
    geometry::Engine::Batch batch;
    for (const auto& entry : result) {
        const geometry::Edge& edge = topology.edges[entry.first];
        for (int i = 0; i <= kDeviationSamples; ++i) {
            const double t = edge.t0 + (edge.t1 - edge.t0) * i / kDeviationSamples;
            batch.push_back(geometry::Query::edge_point(entry.first, t));
            for (const int use : edge.uses) {
                batch.push_back(geometry::Query::use_on_face(use, t));
            }
        }
    }
    const geometry::Engine::Answers answers = session.ask(std::move(batch));
    const geometry::Answer* at = answers.data();
    for (auto& [e, deviation] : result) {
        for (int i = 0; i <= kDeviationSamples; ++i) {
            const geometry::Answer& on_curve = *at++;
            for (std::size_t k = 0; k < topology.edges[e].uses.size(); ++k, ++at) {
                if (on_curve.found() && at->found()) {
                    deviation = std::max(deviation, (at->point - on_curve.point).norm());
                }
            }
        }
        deviation = std::min(deviation, topology.edges[e].tolerance);
    }
    return result;
}

// Lists the distances from the node at which the edges of each corner are compared, and the questions for their points.
geometry::Engine::Batch places(const geometry::Topology& topology, const std::vector<double>& lengths, double shortest,
                               std::vector<FaceCorner>& corners) {
    geometry::Engine::Batch batch;
    for (FaceCorner& corner : corners) {
        const double reach = EdgeTuning::kMostUnresolved * std::min(lengths[corner.edge[0]], lengths[corner.edge[1]]);
        for (double distance = reach; distance > shortest; distance *= 0.5) {
            corner.distances.push_back(distance);
            for (int k = 0; k < 2; ++k) {
                const geometry::Edge& edge = topology.edges[corner.edge[k]];
                const auto [from, to] = corner.end[k] == 0 ? std::pair{edge.t0, edge.t1} : std::pair{edge.t1, edge.t0};
                batch.push_back(geometry::Query::edge_at_distance(corner.edge[k], from, to, distance));
            }
        }
    }
    return batch;
}

// The nodes where something closer than the detail counts as one.
std::set<int> joined_nodes(const geometry::Topology& topology) {
    std::set<int> nodes;
    for (const geometry::Joined& joined : topology.joined) {
        for (const geometry::Entity& entity : joined.entities) {
            if (!joined.by_shape && entity.dimension == 0) {
                nodes.insert(topology.node_of(entity.index));
            } else if (!joined.by_shape) {
                nodes.insert(topology.edges[entity.index].nodes.begin(), topology.edges[entity.index].nodes.end());
            }
        }
    }
    return nodes;
}

// Sets the radius around nodes that were joined or contracted to the distance at which their edges enclose kLeastAngle,
// if they do: nearer to the node the mesh would have a corner that the shape does not have.
void keep_open(geometry::Session& session, std::vector<FaceCorner> corners, std::vector<std::array<double, 2>>& radii) {
    using geometry::DetailCorners;
    const geometry::Topology& topology = session.topology();
    const std::set<int> joined = joined_nodes(topology);
    const double reach = DetailCorners::kReach * topology.detail;
    const auto elsewhere = [&](const FaceCorner& corner) {
        const bool apart = !corner.at_one_node(topology);  // the edges between are contracted
        const auto closed = [&](int e) { return topology.edges[e].nodes[0] == topology.edges[e].nodes[1]; };
        return (!apart && joined.count(corner.node(topology, 0)) == 0) || closed(corner.edge[0]) ||
               closed(corner.edge[1]);
    };
    corners.erase(std::remove_if(corners.begin(), corners.end(), elsewhere), corners.end());
    geometry::Engine::Batch batch;
    for (const FaceCorner& corner : corners) {
        for (int k = 0; k < 2; ++k) {
            const geometry::Edge& edge = topology.edges[corner.edge[k]];
            const auto [from, to] = corner.end[k] == 0 ? std::pair{edge.t0, edge.t1} : std::pair{edge.t1, edge.t0};
            batch.push_back(geometry::Query::edge_at_distance(corner.edge[k], from, to, reach));
            batch.push_back(geometry::Query::edge_point(corner.edge[k], to));
        }
    }
    const geometry::Engine::Answers answers = session.ask(std::move(batch));
    const geometry::Answer* at = answers.data();
    for (const FaceCorner& corner : corners) {
        std::array<Vec3, 2> ways;
        for (int k = 0; k < 2; ++k, at += 2) {
            ways[k] = (at[0].found() ? at[0] : at[1]).point - topology.nodes[corner.node(topology, k)].point;
        }
        for (int k = 0; k < 2 && angle_between(ways[0], ways[1]) >= DetailCorners::kLeastAngle; ++k) {
            double& known = radii[corner.edge[k]][corner.end[k]];
            known = std::max(known, reach);
        }
    }
}

}  // namespace

std::vector<std::array<double, 2>> unresolved_ends(geometry::Session& session, const SinglePrecisionGrid& grid,
                                                   const std::vector<double>& lengths) {
    const geometry::Topology& topology = session.topology();
    std::vector<FaceCorner> corners = corners_of_faces(topology, lengths);
    keep_narrow(session, corners);
    std::vector<std::array<double, 2>> result(topology.edges.size(), {0.0, 0.0});
    keep_open(session, corners, result);
    corners.erase(std::remove_if(corners.begin(), corners.end(),
                                 [&](const FaceCorner& corner) { return !corner.at_one_node(topology); }),
                  corners.end());
    std::map<int, double> deviation = deviations(session, corners);
    const geometry::Engine::Answers answers = session.ask(places(topology, lengths, grid.shortest_side(), corners));
    const geometry::Answer* at = answers.data();
    for (const FaceCorner& corner : corners) {
        const double apart = deviation[corner.edge[0]] + deviation[corner.edge[1]] + 2.0 * grid.resolution();
        // From the farthest to the nearest: the last distance at which they are apart ends the stretch at the node.
        double radius = 0.0;
        bool together = false;
        for (std::size_t i = 0; i < corner.distances.size(); ++i, at += 2) {
            together = at[0].found() && at[1].found() && (at[0].point - at[1].point).norm() < apart;
            radius = together ? radius : corner.distances[i];
        }
        radius = together ? radius : 0.0;
        for (int k = 0; k < 2 && radius > 0.0; ++k) {
            double& known = result[corner.edge[k]][corner.end[k]];
            known = std::max(known, radius);
        }
    }
    return result;
}

}  // namespace mq::triangulate
