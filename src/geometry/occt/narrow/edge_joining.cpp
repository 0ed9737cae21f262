// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/narrow/edge_joining.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Builder.hxx>
#include <Precision.hxx>
#include <algorithm>
#include <numeric>
#include <utility>

#include "base/angle.h"
#include "geometry/detail.h"
#include "geometry/occt/evaluation/conversion.h"

namespace mq::geometry {

std::optional<double> EdgeJoining::dihedral_angle(int use, int other) const {
    const int a = topology_.uses[static_cast<std::size_t>(use)].edge;
    const int b = topology_.uses[static_cast<std::size_t>(other)].edge;
    const double t = parameter(a, 0.5);
    const Answer there = nearest_on(b, curve(a).point(t).point, 0.0);
    const std::optional<Vec3> first = conormal(use, t);
    const std::optional<Vec3> second = there.found() ? conormal(other, there.t) : std::optional<Vec3>();
    return first && second ? std::optional<double>(angle_between(*first, *second)) : std::nullopt;
}

std::optional<Vec3> EdgeJoining::conormal(int use, double t) const {
    const EdgeUse& data = topology_.uses[static_cast<std::size_t>(use)];
    const PCurve& on_face = live_.uses[static_cast<std::size_t>(use)];
    const int e = data.edge;
    if (on_face.curve.IsNull()) {
        return std::nullopt;
    }
    const double share = (t - edge(e).t0) / (edge(e).t1 - edge(e).t0);
    const gp_Pnt2d uv = on_face.curve->Value(on_face.first + share * (on_face.last - on_face.first));
    gp_Pnt point;
    gp_Vec along_u;
    gp_Vec along_v;
    BRepAdaptor_Surface(live_.faces[static_cast<std::size_t>(data.face)], Standard_False)
        .D1(uv.X(), uv.Y(), point, along_u, along_v);
    // Fraction of the edge's range over which its direction is measured.
    constexpr double kStep = 1e-3;
    const EdgeEvaluator& along = curve(e);
    const Vec3 tangent = along.point(parameter(e, std::min(share + kStep, 1.0))).point -
                         along.point(parameter(e, std::max(share - kStep, 0.0))).point;
    const Vec3 normal = to_vec(along_u.Crossed(along_v));
    const Vec3 into = normal.cross(data.forward ? tangent : Vec3(-tangent));
    return into.squaredNorm() > 0.0 ? std::optional<Vec3>(into) : std::nullopt;
}

void EdgeJoining::unite(int a, int b) {
    if (a < 0 || b < 0 || same_node(a, b)) {
        return;
    }
    const Node& first = topology_.nodes[static_cast<std::size_t>(a)];
    const Node& second = topology_.nodes[static_cast<std::size_t>(b)];
    const double distance = (first.point - second.point).norm();
    topology_.joined.push_back(
        {{Entity{0, a}, Entity{0, b}}, distance, distance <= first.tolerance + second.tolerance});
    nodes_.unite(a, b);
}

int EdgeJoining::use_on(int e, int face) const {
    const std::vector<int>& uses = edge(e).uses;
    return *std::find_if(uses.begin(), uses.end(), [&](int use) { return use_of(use).face == face; });
}

void EdgeJoining::drop(Loop& loop, int use) {
    std::vector<int>& uses = edge(edge_of(use)).uses;
    uses.erase(std::remove(uses.begin(), uses.end(), use), uses.end());
    loop.uses.erase(std::remove(loop.uses.begin(), loop.uses.end(), use), loop.uses.end());
}

bool EdgeJoining::parts_two_faces(int use) const {
    return is_side(edge_of(use)) && use_of(opposite_use(use)).face != use_of(use).face;
}

double EdgeJoining::tolerance(int e) const {
    return 2.0 * std::max(topology_.edges[static_cast<std::size_t>(e)].tolerance, Precision::Confusion());
}

bool EdgeJoining::is_short(int e) const {
    if (edge(e).degenerate || !(topology_.detail > 0.0) || edge(e).nodes[0] < 0 || edge(e).nodes[1] < 0) {
        return false;
    }
    const auto node = [&](int i) { return topology_.nodes[static_cast<std::size_t>(edge(e).nodes[i])].point; };
    const double least = std::max(topology_.detail, tolerance(e));
    if ((node(0) - node(1)).norm() > least) {
        return false;
    }
    return curve(e).length(edge(e).t0, edge(e).t1).distance < least &&
           std::all_of(edge(e).uses.begin(), edge(e).uses.end(),
                       [&](int use) { return !live_.uses[static_cast<std::size_t>(use)].curve.IsNull(); });
}

bool EdgeJoining::leaves_corner(int use) const {
    const int face = topology_.uses[static_cast<std::size_t>(use)].face;
    for (const Loop& loop : topology_.faces[static_cast<std::size_t>(face)].loops) {
        const auto at = std::find(loop.uses.begin(), loop.uses.end(), use);
        if (at == loop.uses.end()) {
            continue;
        }
        const auto n = loop.uses.size();
        const auto i = static_cast<std::size_t>(at - loop.uses.begin());
        const int before = loop.uses[(i + n - 1) % n];
        const int after = loop.uses[(i + 1) % n];
        if (n < 3 || before == after) {
            return false;
        }
        const Vec3 corner = curve(topology_.uses[static_cast<std::size_t>(use)].edge)
                                .point(parameter(topology_.uses[static_cast<std::size_t>(use)].edge, 0.5))
                                .point;
        return angle_between(point_along(before, false) - corner, point_along(after, true) - corner) >=
               DetailCorners::kLeastAngle;
    }
    return false;
}

Vec3 EdgeJoining::point_along(int use, bool from_start) const {
    const EdgeUse& data = topology_.uses[static_cast<std::size_t>(use)];
    const bool ascending = data.forward == from_start;
    const double from = ascending ? edge(data.edge).t0 : edge(data.edge).t1;
    const double to = ascending ? edge(data.edge).t1 : edge(data.edge).t0;
    const EdgeEvaluator& along = curve(data.edge);
    const Answer there = along.at_distance(from, to, DetailCorners::kReach * topology_.detail);
    return there.found() ? there.point : along.point(to).point;
}

bool EdgeJoining::others_open(int use, int other) const {
    const std::optional<double> angle = dihedral_angle(opposite_use(use), opposite_use(other));
    return angle && *angle >= DetailCorners::kLeastAngle;
}

double EdgeJoining::angle_of_others(int use, double t, int other, double other_t) const {
    const std::optional<Vec3> first = conormal(opposite_use(use), t);
    const std::optional<Vec3> second = conormal(opposite_use(other), other_t);
    return first && second ? angle_between(*first, *second) : 0.0;
}

Answer EdgeJoining::point_at(int use, bool from_end, double distance) const {
    const Edge& whole = edge(edge_of(use));
    const bool descending = use_of(use).forward == from_end;
    return curve(edge_of(use))
        .at_distance(descending ? whole.t1 : whole.t0, descending ? whole.t0 : whole.t1, distance);
}

int EdgeJoining::opposite_use(int use) const {
    const std::vector<int>& uses = edge(topology_.uses[static_cast<std::size_t>(use)].edge).uses;
    return uses[0] == use ? uses[1] : uses[0];
}

bool EdgeJoining::is_side(int e) const {
    return !edge(e).degenerate && edge(e).uses.size() == 2 && edge(e).nodes[0] >= 0 && edge(e).nodes[1] >= 0 &&
           edge(e).nodes[0] != edge(e).nodes[1];
}

Answer EdgeJoining::nearest_on(int e, const Vec3& point, double within, std::array<double, 2> range) const {
    const auto [low, high] = range[0] < range[1] ? range : std::array<double, 2>{edge(e).t0, edge(e).t1};
    const Answer beside_middle = curve(e).nearest(point, 0.5 * (low + high), low, high);
    return beside_middle.found() && beside_middle.distance <= within ? beside_middle
                                                                     : curve(e).nearest_of_all(point, low, high);
}

std::optional<EdgeJoining::Alignment> EdgeJoining::alignment(int a, int b, double within) const {
    const EdgeEvaluator& first = curve(a);
    double before = 0.0;
    double after = 0.0;
    double largest = 0.0;
    for (int i = 0; i <= kSamples; ++i) {
        const double share = double(i) / kSamples;
        const Answer there = first.point(parameter(a, share));
        const Answer here = nearest_on(b, there.point, within);
        if (!there.found() || !here.found() || here.distance > within) {
            return std::nullopt;
        }
        before = i == 1 ? here.t : before;
        after = i == kSamples - 1 ? here.t : after;
        largest = std::max(largest, here.distance);
    }
    return Alignment{after > before, largest};
}

bool EdgeJoining::join(int a, int b, double within) {
    const double own = tolerance(a) + tolerance(b);
    within = std::max(within, own);
    const std::optional<Alignment> along = alignment(a, b, within);
    if (!along || !alignment(b, a, within)) {
        return false;
    }
    topology_.joined.push_back({{Entity{1, a}, Entity{1, b}}, along->distance, along->distance <= own});
    unite(edge(a).nodes[0], edge(b).nodes[along->same_way ? 0 : 1]);
    unite(edge(a).nodes[1], edge(b).nodes[along->same_way ? 1 : 0]);
    for (const int u : edge(b).uses) {
        EdgeUse& use = topology_.uses[static_cast<std::size_t>(u)];
        PCurve& on_face = live_.uses[static_cast<std::size_t>(u)];
        use.edge = a;
        on_face.of_neighbour = true;
        if (!along->same_way) {
            use.forward = !use.forward;
            std::swap(on_face.first, on_face.last);
        }
        edge(a).uses.push_back(u);
    }
    edge(a).tolerance = std::max({edge(a).tolerance, edge(b).tolerance, along->distance});
    edge(b).uses.clear();
    return true;
}

int EdgeJoining::add_node(const Vec3& point, double tolerance, Entity owner) {
    const int node = static_cast<int>(topology_.nodes.size());
    topology_.nodes.push_back({point, tolerance});
    topology_.parts_of[0].push_back(topology_.of_shape(owner));
    TopoDS_Vertex vertex;
    BRep_Builder().MakeVertex(vertex, to_pnt(point), tolerance);
    live_.nodes.push_back(vertex);
    nodes_.add();
    if (!topology_.joined_nodes.empty()) {
        topology_.joined_nodes.push_back(node);
    }
    return node;
}

int EdgeJoining::divide(int e, double t, int node) {
    const int second = static_cast<int>(topology_.edges.size());
    topology_.parts_of[1].push_back(topology_.of_shape({1, e}));
    live_.edges.push_back(live_.edges[static_cast<std::size_t>(e)]);
    Edge tail = edge(e);
    tail.t0 = t;
    tail.nodes[0] = node;
    tail.uses.clear();
    const double share = (t - edge(e).t0) / (edge(e).t1 - edge(e).t0);
    edge(e).t1 = t;
    edge(e).nodes[1] = node;
    topology_.edges.push_back(tail);
    for (const int use : edge(e).uses) {
        divide_use(use, second, share);
    }
    return second;
}

int EdgeJoining::piece_at(int face, int e, double t) const {
    for (const Loop& loop : topology_.faces[static_cast<std::size_t>(face)].loops) {
        for (const int use : loop.uses) {
            const Edge& piece = edge(edge_of(use));
            if (topology_.of_shape({1, edge_of(use)}) == topology_.of_shape({1, e}) && t > piece.t0 && t < piece.t1) {
                return edge_of(use);
            }
        }
    }
    return e;
}

// The use keeps the first piece of its edge, up to this share of its range; the second piece gets a use of its own.
void EdgeJoining::divide_use(int use, int second, double share) {
    const int added = static_cast<int>(topology_.uses.size());
    EdgeUse data = topology_.uses[static_cast<std::size_t>(use)];
    data.edge = second;
    topology_.uses.push_back(data);
    edge(second).uses.push_back(added);
    PCurve& first_part = live_.uses[static_cast<std::size_t>(use)];
    PCurve second_part = first_part;
    first_part.last = second_part.first = first_part.first + share * (first_part.last - first_part.first);
    live_.uses.push_back(second_part);
    for (Loop& loop : topology_.faces[static_cast<std::size_t>(data.face)].loops) {
        const auto at = std::find(loop.uses.begin(), loop.uses.end(), use);
        if (at != loop.uses.end()) {
            loop.uses.insert(data.forward ? at + 1 : at, added);
        }
    }
}

void EdgeJoining::rename_nodes() {
    for (Edge& edge : topology_.edges) {
        for (int& node : edge.nodes) {
            node = node < 0 ? node : nodes_.find(node);
        }
    }
    if (topology_.joined_nodes.empty()) {
        topology_.joined_nodes.resize(topology_.nodes.size());
        std::iota(topology_.joined_nodes.begin(), topology_.joined_nodes.end(), 0);
    }
    for (int& node : topology_.joined_nodes) {
        node = nodes_.find(node);
    }
}

}  // namespace mq::geometry
