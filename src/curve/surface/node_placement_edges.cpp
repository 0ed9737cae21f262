// SPDX-License-Identifier: LGPL-2.1-or-later
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/error.h"
#include "core_phrases.h"  // made of Mod/MeshQuality/phrases.py
#include "curve/surface/node_placement.h"
#include "curve/surface/tuning.h"

namespace mq::curve {

using elements::Lattice;

namespace {

using geometry::Answer;
using geometry::Query;

/// A difference of arc lengths that is rounding, as a fraction of the length.
constexpr double kSameLength = 1e-9;

/// Sum of squared steps, 1 when all are equal and on a line: grows with length and with unevenness.
double unevenness(const Vec3& from, const std::vector<Vec3>& inner, const Vec3& to) {
    double sum = 0.0;
    Vec3 last = from;
    for (const Vec3& p : inner) {
        sum += (p - last).squaredNorm();
        last = p;
    }
    sum += (to - last).squaredNorm();
    return sum * static_cast<double>(inner.size() + 1) / (to - from).squaredNorm();
}

}  // namespace

void Placement::Gaps::close(std::vector<Vec3>& inner_nodes) const {
    for (std::size_t i = 0; i < inner_nodes.size(); ++i) {
        inner_nodes[i] =
            closed(inner_nodes[i], static_cast<double>(i + 1) / static_cast<double>(inner_nodes.size() + 1));
    }
}

/// One batch for all edges: each query by itself would cost a change of thread.
std::vector<Placement::Gaps> Placement::gaps(const std::vector<Ends>& edges) {
    const auto off = [&](int v) { return surface_.off_cad.count(v) > 0; };
    std::vector<Query> batch;
    for (const Ends& ends : edges) {
        if (off(ends.a)) {
            batch.push_back(ends.at_a);
        }
        if (off(ends.b)) {
            batch.push_back(ends.at_b);
        }
    }
    const auto answers = batch.empty() ? std::vector<Answer>() : session_.ask(std::move(batch));
    std::size_t next = 0;
    const auto gap_at = [&](int v) -> Vec3 {
        const Answer answer = off(v) ? answers[next++] : Answer();
        return answer.found() ? Vec3(point(v) - answer.point) : Vec3::Zero();
    };
    std::vector<Gaps> result;
    for (const Ends& ends : edges) {
        Gaps found;
        found.at_a = gap_at(ends.a);
        found.at_b = gap_at(ends.b);
        found.none = std::max(found.at_a.norm(), found.at_b.norm()) <=
                     SurfaceTuning::kGapShare * (point(ends.b) - point(ends.a)).norm();
        result.push_back(found);
    }
    return result;
}

bool Placement::may_be_off_cad(int vertex) const {
    const geometry::Topology& topology = session_.topology();
    const mesh::VertexEntity& entity = surface_.shapes.vertices[static_cast<std::size_t>(vertex)].entity;
    const auto index = static_cast<std::size_t>(entity[1]);
    const double tolerance = entity[0] == 0   ? topology.nodes[index].tolerance
                             : entity[0] == 1 ? topology.edges[index].tolerance
                                              : 0.0;
    for (const int t : surface_.triangles_of_vertex(vertex)) {
        for (const int other : surface_.triangles[static_cast<std::size_t>(t)].corners) {
            if (other != vertex && tolerance > SurfaceTuning::kGapShare * (point(other) - point(vertex)).norm()) {
                return true;
            }
        }
    }
    return false;
}

double Placement::distance_off_cad(int vertex) {
    double most = 0.0;
    const auto ask = [&](const Query& query) {
        const Answer answer = session_.ask(query);
        most = std::max(most, answer.found() ? (point(vertex) - answer.point).norm() : 0.0);
    };
    for (const int t : surface_.triangles_of_vertex(vertex)) {
        const SurfaceTriangle& triangle = surface_.triangles[static_cast<std::size_t>(t)];
        const Vec2& uv = *surface_.uv_of(vertex, triangle.face);
        ask(Query::face_point(triangle.face, uv.x(), uv.y()));
        for (const int other : triangle.corners) {
            const Segment* segment = other != vertex ? surface_.segment(vertex, other) : nullptr;
            if (segment != nullptr) {
                ask(Query::edge_point(segment->edge, surface_.t_of(vertex, other)));
            }
        }
    }
    return most;
}

void Placement::set_edge_nodes(int a, int b, const std::vector<Vec3>& nodes) {
    std::vector<Vec3> all{surface_.shapes.vertices[static_cast<std::size_t>(a)].point};
    all.insert(all.end(), nodes.begin(), nodes.end());
    all.push_back(surface_.shapes.vertices[static_cast<std::size_t>(b)].point);
    const std::vector<Vec3> control = elements::nodes_to_bezier(Lattice::of(1, surface_.shapes.order()), all);
    surface_.shapes.set_edge(a, b, {control.begin() + 1, control.end() - 1});
}

std::vector<Placement::Gaps> Placement::segment_gaps(const std::vector<EdgeTask>& tasks) {
    std::vector<Ends> ends;
    for (const EdgeTask& task : tasks) {
        const Segment& s = *surface_.segment(task.a, task.b);
        ends.push_back({task.a, task.b, Query::edge_point(s.edge, s.t_low), Query::edge_point(s.edge, s.t_high)});
    }
    return gaps(ends);
}

/// Parameters of the nodes of mesh edges on CAD edges at even arc lengths, by Newton's method. A step that leaves the
/// parameters between which the node must lie, as where the speed of the curve jumps, goes to the middle of these.
std::vector<Answer> Placement::at_even_lengths(const std::vector<EdgeTask>& tasks, std::vector<Query>& points) {
    const auto per = static_cast<std::size_t>(surface_.shapes.order() - 1);
    const auto segment = [&](std::size_t i) { return *surface_.segment(tasks[i / per].a, tasks[i / per].b); };
    std::vector<std::pair<double, double>> between;  // bracket of each node's parameter
    for (std::size_t i = 0; i < points.size(); ++i) {
        between.emplace_back(segment(i).t_low, segment(i).t_high);
    }
    auto at = session_.ask(points);
    std::vector<std::size_t> open(points.size());
    std::iota(open.begin(), open.end(), std::size_t{0});
    // Halving may take many steps before Newton's method can take over; each leaves half of the parameters.
    for (int left = SurfaceTuning::kArcRounds; left > 0 && !open.empty(); --left) {
        std::vector<Query> lengths;
        for (const std::size_t i : open) {
            const Segment s = segment(i);
            lengths.push_back(Query::edge_length(s.edge, s.t_low, points[i].t));
            lengths.push_back(Query::edge_length(s.edge, points[i].t, s.t_high));
        }
        const auto length = session_.ask(std::move(lengths));
        std::vector<std::size_t> moving;
        std::vector<Query> moved;
        for (std::size_t k = 0; k < open.size(); ++k) {
            const std::size_t i = open[k];
            const Segment s = segment(i);
            const double whole = length[2 * k].distance + length[2 * k + 1].distance;
            const double wanted = whole * static_cast<double>(i % per + 1) / static_cast<double>(per + 1);
            const double more = wanted - length[2 * k].distance;
            const double speed = at[i].normal.norm();
            const double sense = s.t_high > s.t_low ? 1.0 : -1.0;
            auto& [low, high] = between[i];
            (more > 0.0 ? low : high) = points[i].t;
            double t = points[i].t + (speed > 0.0 ? sense * more / speed : 0.0);
            const double whole_range = std::abs(s.t_high - s.t_low);
            const bool there_already = std::abs(more) <= kSameLength * whole;
            if (!there_already && !((t - low) * sense > 0.0 && (high - t) * sense > 0.0)) {
                t = 0.5 * (low + high);
                left = SurfaceTuning::kArcRounds + 1;
            }
            if (!there_already && std::abs(t - points[i].t) >= 1e-9 * whole_range) {
                moving.push_back(i);
            }
            points[i].t = t;
            moved.push_back(points[i]);
        }
        const auto there = session_.ask(std::move(moved));
        for (std::size_t k = 0; k < open.size(); ++k) {
            at[open[k]] = there[k];
        }
        open = std::move(moving);
    }
    return at;
}

void Placement::place_segments(const std::vector<EdgeTask>& tasks) {
    const int q = surface_.shapes.order();
    std::vector<Query> points;
    for (const EdgeTask& task : tasks) {
        const Segment& s = *surface_.segment(task.a, task.b);
        for (int k = 1; k < q; ++k) {
            points.push_back(Query::edge_point(s.edge, s.t_low + (s.t_high - s.t_low) * k / q));  // equation (5)
        }
    }
    const auto at = at_even_lengths(tasks, points);
    const std::vector<Gaps> open = segment_gaps(tasks);
    std::vector<Vec3> nodes;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t which = i / static_cast<std::size_t>(q - 1);
        if (!at[i].found()) {
            throw GeometryError(phrases::kNoPointAt, {{"name", session_.topology().name_of({1, points[i].index})},
                                                      {"number", in_digits(points[i].t, 6)}});
        }
        nodes.push_back(at[i].point);
        if (nodes.size() == static_cast<std::size_t>(q - 1)) {
            open[which].close(nodes);
            set_edge_nodes(tasks[which].a, tasks[which].b, nodes);
            nodes.clear();
        }
    }
}

/// The nodes of a mesh edge inside a face while they are placed.
struct Placement::InnerEdge {
    EdgeTask task;
    Vec2 from;  ///< (u, v) at a
    Vec2 to;
    /// Whether to project the points of the straight edge; otherwise points between the (u, v) are taken.
    bool project = true;
    std::vector<double> s;  ///< parameters of the nodes along the edge, 0 to 1
    std::vector<Vec3> nodes;
    Gaps gaps{};
};

Query Placement::node_query(const InnerEdge& edge, double s, bool project) const {
    const Vec3& a = surface_.shapes.vertices[static_cast<std::size_t>(edge.task.a)].point;
    const Vec3& b = surface_.shapes.vertices[static_cast<std::size_t>(edge.task.b)].point;
    const Vec2 uv = edge.from + s * (edge.to - edge.from);
    return project ? Query::face_nearest(edge.task.face, a + s * (b - a), uv.x(), uv.y())
                   : Query::face_point(edge.task.face, uv.x(), uv.y());
}

Placement::Ends Placement::ends_of(const InnerEdge& edge, bool project) const {
    return {edge.task.a, edge.task.b, node_query(edge, 0.0, project), node_query(edge, 1.0, project)};
}

void Placement::place_inner_edges(const std::vector<EdgeTask>& tasks) {
    const int q = surface_.shapes.order();
    std::vector<InnerEdge> edges;
    std::vector<Query> batch;
    std::vector<Ends> ends;
    for (const EdgeTask& task : tasks) {
        InnerEdge edge{task, *surface_.uv_of(task.a, task.face), Vec2::Zero(), true, {}, {}};
        edge.to = unwrapped(task.b, task.face, edge.from);
        resolve_free(task.a, task.face, edge.to, edge.from);
        resolve_free(task.b, task.face, edge.from, edge.to);
        for (int k = 1; k < q; ++k) {
            edge.s.push_back(static_cast<double>(k) / q);
            batch.push_back(node_query(edge, edge.s.back(), true));
            batch.push_back(node_query(edge, edge.s.back(), false));
        }
        ends.push_back(ends_of(edge, true));
        ends.push_back(ends_of(edge, false));
        edges.push_back(std::move(edge));
    }
    const auto answers = session_.ask(std::move(batch));
    const std::vector<Gaps> open = gaps(ends);
    std::size_t next = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        InnerEdge& edge = edges[i];
        std::array<std::vector<Vec3>, 2> ways;
        std::array<bool, 2> found{true, true};
        for (int k = 1; k < q; ++k) {
            for (std::size_t way = 0; way < 2; ++way, ++next) {
                ways[way].push_back(answers[next].point);
                found[way] = found[way] && answers[next].found();
            }
        }
        const Vec3& a = point(edge.task.a);
        const Vec3& b = point(edge.task.b);
        for (std::size_t way = 0; way < 2; ++way) {
            open[2 * i + way].close(ways[way]);
        }
        if (!found[0] && !found[1]) {
            throw GeometryError(phrases::kNoPointsForEdge,
                                {{"name", session_.topology().name_of({2, edge.task.face})}});
        }
        edge.project = found[0] && (!found[1] || unevenness(a, ways[0], b) <= unevenness(a, ways[1], b) * (1.0 + 1e-6));
        const std::size_t chosen = edge.project ? 0 : 1;
        edge.nodes = ways[chosen];
        edge.gaps = open[2 * i + chosen];
    }
    for (int round = 0; round < SurfaceTuning::kEvenRounds && q > 2; ++round) {
        space_evenly(edges);
    }
    for (const InnerEdge& edge : edges) {
        set_edge_nodes(edge.task.a, edge.task.b, edge.nodes);
    }
}

/// One step of Newton's method towards nodes at even distances in space. On an arc, nodes projected from even places on
/// the chord deviate several times as much between them.
void Placement::space_evenly(std::vector<InnerEdge>& edges) {
    const int q = surface_.shapes.order();
    std::vector<Query> batch;
    std::vector<std::vector<double>> moved;
    for (const InnerEdge& edge : edges) {
        std::vector<double> s{0.0};
        std::vector<double> length{0.0};
        Vec3 last = surface_.shapes.vertices[static_cast<std::size_t>(edge.task.a)].point;
        const auto go_on = [&](double at, const Vec3& point) {
            s.push_back(at);
            length.push_back(length.back() + (point - last).norm());
            last = point;
        };
        for (std::size_t i = 0; i < edge.nodes.size(); ++i) {
            go_on(edge.s[i], edge.nodes[i]);
        }
        go_on(1.0, surface_.shapes.vertices[static_cast<std::size_t>(edge.task.b)].point);
        std::vector<double>& to = moved.emplace_back();
        for (std::size_t k = 1; k + 1 < s.size(); ++k) {
            const double wanted = length.back() * static_cast<double>(k) / q;
            const double slope = (s[k + 1] - s[k - 1]) / (length[k + 1] - length[k - 1]);
            const double at = s[k] + slope * (wanted - length[k]);
            to.push_back(at > s[k - 1] && at < s[k + 1] ? at : s[k]);
            batch.push_back(node_query(edge, to.back(), edge.project));
        }
    }
    const auto answers = session_.ask(std::move(batch));
    std::size_t next = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        for (std::size_t k = 0; k < edges[i].nodes.size(); ++k, ++next) {
            if (answers[next].found()) {
                edges[i].s[k] = moved[i][k];
                const double along = static_cast<double>(k + 1) / q;
                edges[i].nodes[k] = edges[i].gaps.closed(answers[next].point, along);
            }
        }
    }
}

void Placement::set_warped(int a, int b, double by, int degree) {
    const Segment& segment = *surface_.segment(a, b);
    const double t_a = surface_.t_of(a, b);
    const double t_b = surface_.t_of(b, a);
    std::vector<Vec3> nodes;
    for (int k = 1; k < degree; ++k) {
        const double s = static_cast<double>(k) / degree;
        const double t = t_a + (s + 4.0 * by * s * (1.0 - s)) * (t_b - t_a);
        const Answer answer = session_.ask(Query::edge_point(segment.edge, t));
        if (!answer.found()) {
            return;
        }
        nodes.push_back(answer.point);
    }
    gaps({{a, b, Query::edge_point(segment.edge, t_a), Query::edge_point(segment.edge, t_b)}}).front().close(nodes);
    // The polynomial of the lower degree at the nodes of the mesh's order.
    nodes.insert(nodes.begin(), surface_.shapes.vertices[static_cast<std::size_t>(a)].point);
    nodes.push_back(surface_.shapes.vertices[static_cast<std::size_t>(b)].point);
    const Lattice& lower = Lattice::of(1, degree);
    const std::vector<Vec3> control = elements::nodes_to_bezier(lower, nodes);
    const int q = surface_.shapes.order();
    std::vector<Vec3> raised;
    for (int k = 1; k < q; ++k) {
        const double s = static_cast<double>(k) / q;
        raised.push_back(elements::value(lower, control, {1.0 - s, s, 0.0, 0.0}));
    }
    set_edge_nodes(a, b, raised);
}

bool Placement::place_by_parameters(int a, int b, int face) {
    InnerEdge edge{{a, b, face}, *surface_.uv_of(a, face), Vec2::Zero(), false, {}, {}, {}};
    edge.to = unwrapped(b, face, edge.from);
    resolve_free(a, face, edge.to, edge.from);
    resolve_free(b, face, edge.from, edge.to);
    std::vector<Query> batch;
    for (int k = 1; k < surface_.shapes.order(); ++k) {
        batch.push_back(node_query(edge, static_cast<double>(k) / surface_.shapes.order(), false));
    }
    for (const Answer& answer : session_.ask(std::move(batch))) {
        if (!answer.found()) {
            return false;
        }
        edge.nodes.push_back(answer.point);
    }
    gaps({ends_of(edge, false)}).front().close(edge.nodes);
    set_edge_nodes(a, b, edge.nodes);
    return true;
}

bool Placement::bulge_on_face(int a, int b, int face, const Vec3& by) {
    const int q = surface_.shapes.order();
    std::vector<Vec3> control = surface_.shapes.edge_inner(a, b);
    control.insert(control.begin(), surface_.shapes.vertices[static_cast<std::size_t>(a)].point);
    control.push_back(surface_.shapes.vertices[static_cast<std::size_t>(b)].point);
    std::vector<Vec3> nodes = elements::bezier_to_nodes(Lattice::of(1, q), control);
    nodes = {nodes.begin() + 1, nodes.end() - 1};
    Vec2 from = *surface_.uv_of(a, face);
    Vec2 to = unwrapped(b, face, from);
    resolve_free(a, face, to, from);
    resolve_free(b, face, from, to);
    std::vector<Query> batch;
    for (int k = 1; k < q; ++k) {
        const double s = static_cast<double>(k) / q;
        Vec3& node = nodes[static_cast<std::size_t>(k - 1)];
        node += 4.0 * s * (1.0 - s) * by;
        const Vec2 uv = from + s * (to - from);
        batch.push_back(Query::face_nearest(face, node, uv.x(), uv.y()));
    }
    if (!planar(face)) {
        const auto answers = session_.ask(std::move(batch));
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            if (!answers[i].found()) {
                return false;
            }
            nodes[i] = answers[i].point;
        }
        gaps({ends_of({{a, b, face}, from, to, true, {}, {}, {}}, true)}).front().close(nodes);
    }
    set_edge_nodes(a, b, nodes);
    return true;
}

elements::CurvedShapes edges_of_second_order(geometry::Session& session, const CurvedSurface& surface) {
    CurvedSurface quadratic = surface;
    quadratic.shapes = elements::CurvedShapes(2);
    quadratic.shapes.vertices = surface.shapes.vertices;
    std::vector<int> live;
    for (std::size_t t = 0; t < quadratic.triangles.size(); ++t) {
        if (quadratic.triangles[t].alive) {
            live.push_back(static_cast<int>(t));
        }
    }
    Placement(session, quadratic).place(live);
    return std::move(quadratic.shapes);
}

}  // namespace mq::curve
