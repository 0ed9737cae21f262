// SPDX-License-Identifier: LGPL-2.1-or-later
#include "given/matching/edge_paths.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/disjoint_sets.h"
#include "geometry/closed_edge.h"
#include "given/matching/artefact_vertices.h"
#include "mesh/intersection/nearest_tree.h"

namespace mq::given {

namespace {

using geometry::Answer;
using geometry::Query;

/// Number of points of a rim near which its mesh vertices are searched.
constexpr int kRimPoints = 8;

/// Largest distance of a mesh vertex from the CAD, as a fraction of the shortest mesh edge at the vertex.
constexpr double kMostOfMeshEdge = 0.25;

class Finder {
  public:
    Finder(geometry::Session& session, const SurfaceGraph& graph)
        : session_(session), topology_(session.topology()), graph_(graph) {}

    EdgePaths run() {
        artefacts_ = artefact_vertices(session_);
        find_candidates();
        find_rims();
        result_.of_node.assign(topology_.nodes.size(), -1);
        result_.polylines.resize(topology_.edges.size());
        for (const Body& body : bodies()) {
            session_.check();
            follow(body);
        }
        return std::move(result_);
    }

  private:
    /// A vertex of the mesh near a CAD edge.
    struct Near {
        int vertex;
        double t;
        double distance;
    };

    /// The connected entities of the model: bodies may touch, and then have vertices and edges of their own in the same
    /// place.
    struct Body {
        std::vector<int> nodes;
        std::vector<int> edges;
    };

    /// The mesh vertices at the place of a CAD vertex, by connected mesh: at most one of each.
    using Candidates = std::map<std::size_t, int>;

    /// The vertices that may lie on a rim, each with a parameter near it; by connected mesh.
    using Rim = std::map<std::size_t, std::map<int, double>>;

    std::vector<Body> bodies() const {
        DisjointSets<std::size_t> joined(topology_.nodes.size());
        std::vector<std::size_t> node_of_face(topology_.faces.size(), topology_.nodes.size());
        for (const geometry::Edge& edge : topology_.edges) {
            for (const int node : edge.nodes) {
                for (const int use : edge.uses) {
                    const auto face = static_cast<std::size_t>(topology_.uses[static_cast<std::size_t>(use)].face);
                    if (node >= 0 && node_of_face[face] == topology_.nodes.size()) {
                        node_of_face[face] = static_cast<std::size_t>(node);
                    } else if (node >= 0) {
                        joined.unite(node_of_face[face], static_cast<std::size_t>(node));
                    }
                }
            }
        }
        std::size_t count = 0;
        const std::vector<std::size_t> number = joined.number(count);
        std::vector<Body> result(count);
        for (std::size_t n = 0; n < number.size(); ++n) {
            result[number[n]].nodes.push_back(static_cast<int>(n));
        }
        for (std::size_t e = 0; e < topology_.edges.size(); ++e) {
            const int node = std::max(topology_.edges[e].nodes[0], topology_.edges[e].nodes[1]);
            if (node >= 0) {
                result[number[static_cast<std::size_t>(node)]].edges.push_back(static_cast<int>(e));
            }
        }
        return result;
    }

    /// Shapes may contain edges of no face, such as annotations: no mesh follows these.
    std::vector<char> used_nodes() const {
        std::vector<char> used(topology_.nodes.size(), 0);
        for (const geometry::Edge& edge : topology_.edges) {
            for (const int node : edge.nodes) {
                if (node >= 0 && !edge.uses.empty()) {
                    used[static_cast<std::size_t>(node)] = 1;
                }
            }
        }
        return used;
    }

    void find_candidates() {
        std::vector<mesh::Triangle> triangles;
        DisjointSets<std::size_t> joined(graph_.points.size());
        for (const auto& t : graph_.triangles) {
            triangles.push_back({t[0], t[1], t[2]});
            joined.unite(static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]));
            joined.unite(static_cast<std::size_t>(t[1]), static_cast<std::size_t>(t[2]));
        }
        std::size_t count = 0;
        part_of_ = joined.number(count);
        triangles_ = std::move(triangles);
        tree_.emplace(graph_.points, triangles_);
        const double rounding = kNear[0] * topology_.box.largest_side();
        const std::vector<char> used = used_nodes();
        for (std::size_t n = 0; n < topology_.nodes.size(); ++n) {
            candidates_.emplace_back();
            if (!used[n]) {
                continue;
            }
            const geometry::Node& node = topology_.nodes[n];
            const double least = nearest_vertex(node.point);
            // If the mesh has a vertex exactly at an artefact vertex, it is used; otherwise none is searched nearby.
            if (!artefacts_[n] || least <= rounding + node.tolerance) {
                for_vertices_near(node.point, least + rounding,
                                  [&](int v) { add_candidate(node, v, least + rounding); });
            }
        }
    }

    /// The least distance of a point from the vertices of the triangle nearest to it.
    double nearest_vertex(const Vec3& point) const {
        double least = std::numeric_limits<double>::infinity();
        for (const int v : triangles_[static_cast<std::size_t>(tree_->nearest(point).triangle)]) {
            least = std::min(least, (at(v) - point).norm());
        }
        return least;
    }

    template <typename Visit>
    void for_vertices_near(const Vec3& point, double distance, Visit visit) const {
        Box box;
        box.add(point - Vec3::Constant(distance));
        box.add(point + Vec3::Constant(distance));
        tree_->for_each_in_box(box, [&](std::int32_t t) {
            for (const int v : triangles_[static_cast<std::size_t>(t)]) {
                if ((at(v) - point).norm() <= distance) {
                    visit(v);
                }
            }
        });
    }

    /// Finds mesh vertices near points of closed edges at whose CAD vertex the mesh needs no vertex and has none.
    void find_rims() {
        rims_.resize(topology_.edges.size());
        const double rounding = kNear[0] * topology_.box.largest_side();
        for (std::size_t e = 0; e < topology_.edges.size(); ++e) {
            const geometry::Edge& edge = topology_.edges[e];
            const auto node = static_cast<std::size_t>(std::max(edge.nodes[0], 0));
            if (!geometry::is_closed(edge) || edge.uses.empty() || is_seam(topology_, edge) || !artefacts_[node] ||
                !candidates_[node].empty()) {
                continue;
            }
            geometry::Engine::Batch batch;
            for (int k = 0; k < kRimPoints; ++k) {
                const double t = edge.t0 + (edge.t1 - edge.t0) * k / kRimPoints;
                batch.push_back(Query::edge_point(static_cast<int>(e), t));
            }
            for (const Answer& answer : session_.ask(std::move(batch))) {
                if (answer.found()) {
                    for_vertices_near(answer.point, nearest_vertex(answer.point) + rounding, [&](int v) {
                        rims_[e][part_of_[static_cast<std::size_t>(v)]].emplace(v, answer.t);
                    });
                }
            }
        }
    }

    void add_candidate(const geometry::Node& node, int v, double near) {
        const auto distance = [&](int vertex) { return (at(vertex) - node.point).norm(); };
        if (distance(v) <= near && distance(v) <= reach(v) + node.tolerance) {
            int& known = candidates_.back().emplace(part_of_[static_cast<std::size_t>(v)], v).first->second;
            known = distance(v) < distance(known) ? v : known;
        }
    }

    /// Follows a body on the connected mesh that has most of the body's vertices and rims and, among equal ones, most
    /// of its edges. A mesh is used for a second body only if there is no other one.
    void follow(const Body& body) {
        std::map<std::size_t, std::size_t> met;
        std::size_t most = 0;
        for (const int n : body.nodes) {
            for (const auto& [part, v] : candidates_[static_cast<std::size_t>(n)]) {
                most = std::max(most, ++met[part]);
            }
        }
        for (const int e : body.edges) {
            for (const auto& [part, vertices] : rims_[static_cast<std::size_t>(e)]) {
                most = std::max(most, ++met[part]);
            }
        }
        EdgePaths best;
        std::pair<std::size_t, bool> best_score{0, false};
        std::size_t best_part = 0;
        for (const auto& [part, count] : met) {
            if (count < most) {
                continue;
            }
            EdgePaths edges = follow_on(body, part);
            const auto followed = static_cast<std::size_t>(
                std::count_if(edges.polylines.begin(), edges.polylines.end(),
                              [](const EdgePath& polyline) { return !polyline.vertices.empty(); }));
            const std::pair<std::size_t, bool> score{followed, taken_.count(part) == 0};
            if (best.of_node.empty() || score > best_score) {
                best = std::move(edges);
                best_score = score;
                best_part = part;
            }
        }
        if (best.of_node.empty()) {
            return;
        }
        taken_.insert(best_part);
        for (std::size_t i = 0; i < body.nodes.size(); ++i) {
            result_.of_node[static_cast<std::size_t>(body.nodes[i])] = best.of_node[i];
        }
        for (std::size_t i = 0; i < body.edges.size(); ++i) {
            result_.polylines[static_cast<std::size_t>(body.edges[i])] = std::move(best.polylines[i]);
        }
    }

    /// @return by the body's own vertices and edges.
    EdgePaths follow_on(const Body& body, std::size_t part) {
        EdgePaths found;
        std::map<int, int> of_node;
        for (const int n : body.nodes) {
            const Candidates& all = candidates_[static_cast<std::size_t>(n)];
            const auto own = all.find(part);
            // A vertex that this mesh does not have may be a vertex of another mesh: bodies may be meshed in pieces.
            const int v = own != all.end() ? own->second : all.empty() ? -1 : all.begin()->second;
            found.of_node.push_back(v);
            of_node.emplace(n, v);
        }
        for (const int e : body.edges) {
            const Rim& rim = rims_[static_cast<std::size_t>(e)];
            const auto own = rim.find(part);
            found.polylines.push_back(own != rim.end() ? cycle_along(e, own->second)
                                      : rim.empty()    ? polyline_of(e, of_node)
                                                       : cycle_along(e, rim.begin()->second));
        }
        return found;
    }

    /// The largest distance from the CAD at which a mesh vertex is searched.
    double reach(int vertex) const {
        return std::min(kNear.back() * topology_.box.largest_side(),
                        kMostOfMeshEdge * graph_.shortest[static_cast<std::size_t>(vertex)]);
    }

    EdgePath polyline_of(int e, const std::map<int, int>& of_node) {
        const geometry::Edge& edge = topology_.edges[static_cast<std::size_t>(e)];
        if (edge.degenerate || edge.uses.empty()) {
            return {};
        }
        const auto end = [&](std::size_t k) { return edge.nodes[k] < 0 ? -1 : of_node.at(edge.nodes[k]); };
        const bool open = edge.nodes[0] >= 0 && edge.nodes[1] >= 0 && edge.nodes[0] != edge.nodes[1];
        if (open && end(0) >= 0 && end(0) == end(1)) {
            return {{end(0)}, 0.0};
        }
        if (end(0) < 0 || end(1) < 0) {
            return {};
        }
        const double size = topology_.box.largest_side();
        for (const double near : kNear) {
            EdgePath polyline =
                longest_path(near_edge(e, {}, {end(0), end(1)}, near * size + edge.tolerance), end(0), end(1));
            if (!polyline.vertices.empty()) {
                return polyline;
            }
        }
        return {};
    }

    /// The mesh edges around a closed edge: among the closed paths along it whose parameters increase except at the
    /// end, the one with the most vertices. It begins at the vertex with the smallest parameter.
    EdgePath cycle_along(int e, const std::map<int, double>& seeds) {
        const geometry::Edge& edge = topology_.edges[static_cast<std::size_t>(e)];
        for (const double near : kNear) {
            const double allowed = near * topology_.box.largest_side() + edge.tolerance;
            const std::vector<Near> around = near_edge(e, seeds, {-1, -1}, allowed);
            EdgePath best;
            // If no path passes through a vertex, the search starts at the next one.
            for (std::size_t start = 0; start < around.size() && best.vertices.size() <= around.size(); ++start) {
                std::vector<Near> inner(around.begin() + static_cast<std::ptrdiff_t>(start) + 1, around.end());
                inner.insert(inner.end(), around.begin(), around.begin() + static_cast<std::ptrdiff_t>(start));
                EdgePath polyline = longest_path(inner, around[start].vertex, around[start].vertex);
                if (polyline.vertices.size() > best.vertices.size()) {
                    best = std::move(polyline);
                    best.distance = std::max(best.distance, around[start].distance);
                }
            }
            if (!best.vertices.empty()) {
                return best;
            }
        }
        return {};
    }

    /// Walks over mesh edges as long as their vertices are near the CAD edge. Each search for a nearest point starts at
    /// the parameter of the previous vertex.
    /// @param seeds  vertices that may be near the edge, with parameters at which searches start
    /// @param ends  vertices to start from, at the ends of the edge, which are not in the result
    std::vector<Near> near_edge(int e, const std::map<int, double>& seeds, const std::array<int, 2>& ends,
                                double allowed) {
        const geometry::Edge& edge = topology_.edges[static_cast<std::size_t>(e)];
        std::map<int, Near> found;
        std::vector<std::pair<int, double>> open(seeds.begin(), seeds.end());
        const auto add_neighbours = [&](int v, double t) {
            for (const int next : graph_.neighbours[static_cast<std::size_t>(v)]) {
                if (next != ends[0] && next != ends[1] && found.count(next) == 0) {
                    open.emplace_back(next, t);
                }
            }
        };
        for (std::size_t k = 0; k < 2 && ends[k] >= 0; ++k) {
            add_neighbours(ends[k], k == 0 ? edge.t0 : edge.t1);
        }
        while (!open.empty()) {
            const std::vector<std::pair<int, double>> asked = std::exchange(open, {});
            geometry::Engine::Batch batch;
            for (const auto& [v, t] : asked) {
                batch.push_back(Query::edge_nearest(e, at(v), t, edge.t0, edge.t1));
            }
            const auto answers = session_.ask(std::move(batch));
            for (std::size_t i = 0; i < answers.size(); ++i) {
                const Answer& answer = answers[i];
                const int v = asked[i].first;
                if (answer.found() && answer.distance <= std::min(allowed, reach(v)) &&
                    found.emplace(v, Near{v, answer.t, answer.distance}).second) {
                    add_neighbours(v, answer.t);
                }
            }
        }
        std::vector<Near> result;
        for (const auto& [v, near] : found) {
            result.push_back(near);
        }
        std::sort(result.begin(), result.end(), [](const Near& a, const Near& b) { return a.t < b.t; });
        return result;
    }

    /// The path from `first` to `last` with the most vertices, through vertices of `inner` with increasing parameters.
    EdgePath longest_path(const std::vector<Near>& inner, int first, int last) const {
        // The first vertex has position 0; the last one is handled after all others.
        std::map<int, std::size_t> position;
        for (std::size_t i = 0; i < inner.size(); ++i) {
            position.emplace(inner[i].vertex, i + 1);
        }
        constexpr int kUnreached = -1;
        std::vector<int> length(inner.size() + 2, kUnreached);
        std::vector<std::size_t> before(inner.size() + 2, 0);
        length[0] = 0;
        const auto relax = [&](int vertex, std::size_t here) {
            for (const int other : graph_.neighbours[static_cast<std::size_t>(vertex)]) {
                const auto known = position.find(other);
                const std::size_t from = other == first ? 0 : known == position.end() ? here : known->second;
                if (from < here && length[from] != kUnreached && length[from] + 1 > length[here]) {
                    length[here] = length[from] + 1;
                    before[here] = from;
                }
            }
        };
        for (std::size_t i = 0; i < inner.size(); ++i) {
            relax(inner[i].vertex, i + 1);
        }
        const std::size_t end = inner.size() + 1;
        relax(last, end);
        // A closed edge needs at least three mesh edges.
        if (length[end] == kUnreached || (first == last && length[end] < 3)) {
            return {};
        }
        EdgePath polyline{{last}, 0.0};
        for (std::size_t i = before[end]; i != 0; i = before[i]) {
            polyline.vertices.push_back(inner[i - 1].vertex);
            polyline.distance = std::max(polyline.distance, inner[i - 1].distance);
        }
        polyline.vertices.push_back(first);
        std::reverse(polyline.vertices.begin(), polyline.vertices.end());
        return polyline;
    }

    const Vec3& at(int v) const { return graph_.points[static_cast<std::size_t>(v)]; }

    geometry::Session& session_;
    const geometry::Topology& topology_;
    const SurfaceGraph& graph_;
    std::vector<std::size_t> part_of_;  // by mesh vertex: its connected mesh
    std::vector<mesh::Triangle> triangles_;
    std::optional<mesh::NearestTree> tree_;
    std::vector<char> artefacts_;         // by CAD vertex: whether the mesh needs no vertex there
    std::vector<Candidates> candidates_;  // by CAD vertex
    std::vector<Rim> rims_;               // by CAD edge
    std::set<std::size_t> taken_;         // connected meshes on which bodies were followed
    EdgePaths result_;
};

}  // namespace

SurfaceGraph::SurfaceGraph(const std::vector<Vec3>& given, std::vector<std::array<int, 3>> list)
    : points(given),
      triangles(std::move(list)),
      neighbours(given.size()),
      shortest(given.size(), std::numeric_limits<double>::infinity()) {
    for (const auto& t : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto a = static_cast<std::size_t>(t[k]);
            const auto b = static_cast<std::size_t>(t[(k + 1) % 3]);
            neighbours[a].push_back(static_cast<int>(b));
            neighbours[b].push_back(static_cast<int>(a));
            const double length = (points[a] - points[b]).norm();
            shortest[a] = std::min(shortest[a], length);
            shortest[b] = std::min(shortest[b], length);
        }
    }
    for (auto& list_at : neighbours) {
        std::sort(list_at.begin(), list_at.end());
        list_at.erase(std::unique(list_at.begin(), list_at.end()), list_at.end());
    }
}

EdgePaths find_edge_discretisation(geometry::Session& session, const SurfaceGraph& graph) {
    return Finder(session, graph).run();
}

}  // namespace mq::given
