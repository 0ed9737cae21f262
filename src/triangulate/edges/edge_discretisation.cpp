// SPDX-License-Identifier: LGPL-2.1-or-later
#include "triangulate/edges/edge_discretisation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "base/angle.h"
#include "base/disjoint_sets.h"
#include "triangulate/edges/short_edges.h"
#include "triangulate/edges/tuning.h"
#include "triangulate/edges/unresolved_ends.h"

namespace mq::triangulate {

namespace {

struct Interval {
    int edge;
    double from;
    double to;
    int depth;
};

// Whether the angle between two vectors exceeds EdgeTuning::kMaxTurn; most angles are far below it.
bool exceeds_turn(const Vec3& a, const Vec3& b) {
    constexpr double kClear = 0.5;                       // Fraction of the limit: below it, rounding cannot matter.
    const double slope = kClear * EdgeTuning::kMaxTurn;  // this angle is smaller than its tangent
    const double along = a.dot(b);
    if (along > 0.0 && a.cross(b).squaredNorm() < slope * slope * along * along) {
        return false;
    }
    return angle_between(a, b) > EdgeTuning::kMaxTurn;
}

// Whether the tangent turns by more than EdgeTuning::kMaxTurn between the five equidistant samples of an interval.
bool turns_too_much(const geometry::Answer* samples) {
    for (int i = 0; i < 5; ++i) {
        for (int j = i + 1; j < 5; ++j) {
            if (samples[i].normal.squaredNorm() > 0.0 && samples[j].normal.squaredNorm() > 0.0 &&
                exceeds_turn(samples[i].normal, samples[j].normal)) {
                return true;
            }
        }
    }
    return false;
}

double length_of(const std::vector<Vec3>& points) {
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        length += (points[i] - points[i - 1]).norm();
    }
    return length;
}

}  // namespace

EdgeDiscretisation::EdgeDiscretisation(geometry::Session& session, const SinglePrecisionGrid& grid,
                                       const std::set<int>& kept)
    : grid_(grid) {
    const geometry::Topology& topology = session.topology();
    chains_.resize(topology.edges.size());
    points_.resize(topology.edges.size());
    sample(session);
    contract_short_edges(topology);
    collapse_small_faces(session);
    std::vector<double> lengths;
    for (std::size_t e = 0; e < chains_.size(); ++e) {
        lengths.push_back(chains_[e].collapsed ? 0.0 : length_of(points_[e]));
    }
    contracted_ = contractible_edges(topology, points_, lengths, kept);
    for (const int e : contracted_) {
        collapse(e, topology.edges[e]);
        lengths[static_cast<std::size_t>(e)] = 0.0;
    }
    place_nodes(topology);
    balls_.resize(chains_.size());
    unresolved_ = unresolved_ends(session, grid, lengths);
    for (int e = 0; e < static_cast<int>(chains_.size()); ++e) {
        suppress_near_nodes(topology, e, 1.0, points_[e]);
    }
    place_points(topology);
    points_.clear();
}

void EdgeDiscretisation::sample(geometry::Session& session) {
    const geometry::Topology& topology = session.topology();
    std::vector<Interval> open;
    std::vector<std::vector<std::pair<double, Vec3>>> found(topology.edges.size());
    for (int e = 0; e < static_cast<int>(topology.edges.size()); ++e) {
        const geometry::Edge& edge = topology.edges[e];
        if (edge.degenerate) {
            continue;
        }
        const int pieces = edge.nodes[0] == edge.nodes[1] ? 4 : 1;
        for (int i = 0; i < pieces; ++i) {
            const double step = (edge.t1 - edge.t0) / pieces;
            open.push_back({e, edge.t0 + i * step, i + 1 == pieces ? edge.t1 : edge.t0 + (i + 1) * step, 0});
        }
    }
    while (!open.empty()) {
        geometry::Engine::Batch batch;
        batch.reserve(5 * open.size());
        for (const Interval& piece : open) {
            for (int i = 0; i < 5; ++i) {
                const double t = i == 4 ? piece.to : piece.from + 0.25 * i * (piece.to - piece.from);
                batch.push_back(geometry::Query::edge_point(piece.edge, t));
            }
        }
        const geometry::Engine::Answers answers = session.ask(std::move(batch));
        std::vector<Interval> next;
        for (std::size_t i = 0; i < open.size(); ++i) {
            const Interval& piece = open[i];
            const geometry::Answer* samples = &answers[5 * i];
            const double chord =
                (samples[4].point - samples[0].point).norm() + (samples[2].point - samples[0].point).norm();
            if (piece.depth < EdgeTuning::kMaxDepth && chord > grid_.shortest_side() && turns_too_much(samples)) {
                const double middle = 0.5 * (piece.from + piece.to);
                next.push_back({piece.edge, piece.from, middle, piece.depth + 1});
                next.push_back({piece.edge, middle, piece.to, piece.depth + 1});
            } else {
                found[piece.edge].emplace_back(piece.from, samples[0].point);
                found[piece.edge].emplace_back(piece.to, samples[4].point);
            }
        }
        open = std::move(next);
    }
    for (std::size_t e = 0; e < found.size(); ++e) {
        std::sort(found[e].begin(), found[e].end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        for (const auto& [t, point] : found[e]) {
            if (chains_[e].t.empty() || t > chains_[e].t.back()) {
                chains_[e].t.push_back(t);
                points_[e].push_back(point);
            }
        }
    }
}

void EdgeDiscretisation::contract_short_edges(const geometry::Topology& topology) {
    for (std::size_t e = 0; e < chains_.size(); ++e) {
        const geometry::Edge& edge = topology.edges[e];
        const double length = length_of(points_[e]);
        double limit = grid_.shortest_side();
        if (edge.nodes[0] >= 0 && edge.nodes[1] >= 0 && edge.nodes[0] != edge.nodes[1]) {
            // Modellers treat nodes as one point if balls around them with the smaller of both tolerances meet.
            limit = std::max(limit, 2.0 * std::min(topology.nodes[edge.nodes[0]].tolerance,
                                                   topology.nodes[edge.nodes[1]].tolerance));
        }
        const auto in_node = [&](const Vec3& p) {
            const geometry::Node& node = topology.nodes[edge.nodes[0]];
            return (p - node.point).norm() <= node.tolerance;
        };
        const bool closed = edge.nodes[0] >= 0 && edge.nodes[0] == edge.nodes[1];
        if (edge.degenerate || length < limit ||
            (closed && std::all_of(points_[e].begin(), points_[e].end(), in_node))) {
            collapse(static_cast<int>(e), edge);
        }
    }
}

void EdgeDiscretisation::collapse_small_faces(geometry::Session& session) {
    const geometry::Topology& topology = session.topology();
    for (int f = 0; f < static_cast<int>(topology.faces.size()); ++f) {
        const geometry::Face& face = topology.faces[f];
        if (face.no_area) {
            continue;
        }
        const std::set<int> edges = topology.edges_of(f);
        const double border = std::accumulate(edges.begin(), edges.end(), 0.0,
                                              [&](double sum, int e) { return sum + length_of(points_[e]); });
        const auto sampled = std::find_if(edges.begin(), edges.end(), [&](int e) { return !points_[e].empty(); });
        if (sampled == edges.end() || border >= EdgeTuning::kShortBorder * grid_.shortest_side()) {
            continue;
        }
        // A short border alone is not enough: it may be the hole of a sphere.
        const geometry::Answer middle = session.ask(
            geometry::Query::face_point(f, 0.5 * (face.low[0] + face.high[0]), 0.5 * (face.low[1] + face.high[1])));
        if (middle.found() && (middle.point - points_[*sampled].front()).norm() <= border) {
            std::for_each(edges.begin(), edges.end(), [&](int e) { collapse(e, topology.edges[e]); });
            small_faces_.insert(f);
        }
    }
}

void EdgeDiscretisation::collapse(int edge, const geometry::Edge& data) {
    chains_[edge].collapsed = true;
    chains_[edge].t = {data.t0, data.t1};
}

bool EdgeDiscretisation::at_node(int edge, int end, const Vec3& point) const {
    const Ball& ball = balls_[edge][end];
    return (point - ball.centre).norm() < ball.radius;
}

// @param points  the points of the chain, in the shape's frame; those of suppressed vertices are erased
bool EdgeDiscretisation::suppress_near_nodes(const geometry::Topology& topology, int edge, double tolerances,
                                             std::vector<Vec3>& points) {
    EdgePolyline& chain = chains_[edge];
    const double most = EdgeTuning::kMostOfEdge * length_of(points);
    bool changed = false;
    for (int end = 0; end < 2 && !chain.collapsed; ++end) {
        if (const int n = topology.edges[edge].nodes[end]; n >= 0) {
            Ball& ball = balls_[edge][end];
            const Vec3& centre =
                topology.nodes[static_cast<std::size_t>(vertices_[node_vertex_[n]].entity.index)].point;
            const double gap = (centre - (end == 0 ? points.front() : points.back())).norm();
            const double radius =
                std::max({tolerances * topology.nodes[n].tolerance, grid_.shortest_side(), EdgeTuning::kGaps * gap});
            ball = {centre, std::max({ball.radius, std::min(radius, most), unresolved(edge, end)})};
        }
        while (points.size() > 2 && at_node(edge, end, end == 0 ? points[1] : points[points.size() - 2])) {
            const auto beside = end == 0 ? 1 : static_cast<std::ptrdiff_t>(points.size()) - 2;
            points.erase(points.begin() + beside);
            chain.t.erase(chain.t.begin() + beside);
            if (!chain.vertices.empty()) {
                chain.vertices.erase(chain.vertices.begin() + beside);
            }
            changed = true;
        }
    }
    return changed;
}

std::set<int> EdgeDiscretisation::suppress_near_nodes(const geometry::Topology& topology, const std::set<int>& edges,
                                                      double tolerances) {
    std::set<int> changed;
    for (const int e : edges) {
        std::vector<Vec3> points;
        for (const int v : chains_[e].vertices) {
            points.push_back(grid_.to_shape(vertices_[v].point));
        }
        if (suppress_near_nodes(topology, e, tolerances, points)) {
            changed.insert(e);
        }
    }
    return changed;
}

void EdgeDiscretisation::place_nodes(const geometry::Topology& topology) {
    DisjointSets<int> places(topology.nodes.size());
    for (std::size_t e = 0; e < chains_.size(); ++e) {
        const auto& nodes = topology.edges[e].nodes;
        if (chains_[e].collapsed && nodes[0] >= 0 && nodes[1] >= 0) {
            places.unite(nodes[0], nodes[1]);
        }
    }
    node_vertex_.assign(topology.nodes.size(), -1);
    for (int n = 0; n < static_cast<int>(topology.nodes.size()); ++n) {
        const int root = places.find(n);
        if (root == n) {
            node_vertex_[n] = static_cast<int>(vertices_.size());
            vertices_.push_back({grid_.snap(topology.nodes[n].point), {0, n}});
        } else {
            node_vertex_[n] = node_vertex_[root];
        }
    }
}

void EdgeDiscretisation::place_points(const geometry::Topology& topology) {
    for (int e = 0; e < static_cast<int>(chains_.size()); ++e) {
        EdgePolyline& chain = chains_[e];
        const auto& nodes = topology.edges[e].nodes;
        for (std::size_t i = 0; i < chain.t.size(); ++i) {
            const int end = i == 0 ? nodes[0] : i + 1 == chain.t.size() ? nodes[1] : -1;
            if (end >= 0) {
                chain.vertices.push_back(node_vertex_[end]);
            } else {
                chain.vertices.push_back(static_cast<int>(vertices_.size()));
                vertices_.push_back({grid_.snap(points_[e][i]), {1, e}});
            }
        }
    }
}

std::set<int> EdgeDiscretisation::halve(geometry::Session& session, const std::set<PieceRef>& marks) {
    const std::vector<PieceRef> order(marks.rbegin(),
                                      marks.rend());  // in descending order, so that earlier indices remain valid
    geometry::Engine::Batch batch;
    for (const auto& [e, i] : order) {
        batch.push_back(geometry::Query::edge_middle(e, chains_[e].t[i], chains_[e].t[i + 1]));
    }
    const geometry::Engine::Answers answers = session.ask(std::move(batch));
    std::set<int> changed;
    for (std::size_t k = 0; k < order.size(); ++k) {
        const auto [e, i] = order[k];
        EdgePolyline& chain = chains_[e];
        const Vec3 point = grid_.snap(answers[k].point);
        const double reach = grid_.shortest_side();
        const bool first = i == 0;
        const bool last = i + 2 == static_cast<int>(chain.t.size());
        if ((first && at_node(e, 0, answers[k].point)) || (last && at_node(e, 1, answers[k].point))) {
            continue;
        }
        if (!answers[k].found() || chain.collapsed || answers[k].t <= chain.t[i] || answers[k].t >= chain.t[i + 1] ||
            (point - vertices_[chain.vertices[i]].point).norm() < reach ||
            (point - vertices_[chain.vertices[i + 1]].point).norm() < reach) {
            continue;
        }
        chain.t.insert(chain.t.begin() + i + 1, answers[k].t);
        chain.vertices.insert(chain.vertices.begin() + i + 1, static_cast<int>(vertices_.size()));
        vertices_.push_back({point, {1, e}});
        changed.insert(e);
    }
    return changed;
}

void EdgeDiscretisation::resample(geometry::Session& session, int edge, const std::vector<double>& inner) {
    EdgePolyline& chain = chains_[edge];
    if (chain.collapsed) {
        return;
    }
    geometry::Engine::Batch batch;
    for (const double t : inner) {
        batch.push_back(geometry::Query::edge_point(edge, t));
    }
    const geometry::Engine::Answers answers = session.ask(std::move(batch));
    const double reach = grid_.shortest_side();
    EdgePolyline fresh;
    fresh.t.push_back(chain.t.front());
    fresh.vertices.push_back(chain.vertices.front());
    const Vec3 end = vertices_[chain.vertices.back()].point;
    for (std::size_t i = 0; i < inner.size(); ++i) {
        const Vec3 point = grid_.snap(answers[i].point);
        if (answers[i].found() && inner[i] > fresh.t.back() && inner[i] < chain.t.back() &&
            (point - vertices_[fresh.vertices.back()].point).norm() > reach && (point - end).norm() > reach) {
            fresh.t.push_back(inner[i]);
            fresh.vertices.push_back(static_cast<int>(vertices_.size()));
            vertices_.push_back({point, {1, edge}});
        }
    }
    fresh.t.push_back(chain.t.back());
    fresh.vertices.push_back(chain.vertices.back());
    chain = std::move(fresh);
}

}  // namespace mq::triangulate
