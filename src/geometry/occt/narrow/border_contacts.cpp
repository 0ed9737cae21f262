// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/narrow/border_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "base/message.h"
#include "geometry/detail.h"
#include "geometry/occt/narrow/edge_joining.h"

namespace mq::geometry {

namespace {

class BorderContacts : EdgeJoining {
  public:
    using EdgeJoining::EdgeJoining;

    void run(const Progress* progress) {
        for (int face = 0; face < static_cast<int>(topology_.faces.size()); ++face) {
            check_cancelled(progress);
            std::vector<Contact> contacts = contacts_of(face);
            std::stable_sort(contacts.begin(), contacts.end(),
                             [](const Contact& a, const Contact& b) { return a.gap < b.gap; });
            for (const Contact& contact : contacts) {
                apply(face, contact);
            }
        }
        rename_nodes();
    }

  private:
    /// Fraction of the detail. Narrow corners are cut off where they are a detail wide, where a contact has opened
    /// then.
    static constexpr double kContact = 0.5;
    /// Fraction of the detail where the walls beside do not open, so that both corners have to stay.
    static constexpr double kContactOfWalls = 0.125;

    /// The nearest points of two edges, in a zone where they are nearer than the detail.
    struct Contact {
        std::array<int, 2> edges;
        std::array<Answer, 2> at;
        double gap;  // mm
    };

    static Contact turned(const Contact& contact) {
        return {{contact.edges[1], contact.edges[0]}, {contact.at[1], contact.at[0]}, contact.gap};
    }

    /// A range of an edge, with the box of its curve as far as its ends and its middle tell.
    struct Piece {
        int edge;
        double from;
        double to;
        Box box;
        double sagitta;  // mm: of the middle
    };

    Piece piece(int e, double from, double to) const {
        const Vec3 start = curve(e).point(from).point;
        const Vec3 middle = curve(e).point(0.5 * (from + to)).point;
        const Vec3 end = curve(e).point(to).point;
        Piece result{e, from, to, {}, (middle - 0.5 * (start + end)).norm()};
        for (const Vec3& point : {start, middle, end}) {
            result.box.add(point);
        }
        const Vec3 margin = Vec3::Constant(result.sagitta + 0.5 * topology_.detail);
        result.box.low -= margin;
        result.box.high += margin;
        return result;
    }

    /// The edges of the border of a face, each in equal ranges of its parameter.
    std::vector<Piece> pieces_of(int face) const {
        constexpr int kPieces = 16;
        std::vector<int> edges;
        for (const Loop& loop : topology_.faces[static_cast<std::size_t>(face)].loops) {
            for (const int use : loop.uses) {
                const int e = edge_of(use);
                if (!edge(e).degenerate && !is_short(e) && std::find(edges.begin(), edges.end(), e) == edges.end()) {
                    edges.push_back(e);
                }
            }
        }
        std::vector<Piece> pieces;
        for (const int e : edges) {
            for (int i = 0; i < kPieces; ++i) {
                pieces.push_back(piece(e, parameter(e, double(i) / kPieces), parameter(e, double(i + 1) / kPieces)));
            }
        }
        return pieces;
    }

    std::vector<Contact> contacts_of(int face) const {
        std::vector<Piece> pieces = pieces_of(face);
        std::sort(pieces.begin(), pieces.end(),
                  [](const Piece& a, const Piece& b) { return a.box.low[0] < b.box.low[0]; });
        std::vector<Contact> contacts;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            for (std::size_t k = i + 1; k < pieces.size() && pieces[k].box.low[0] <= pieces[i].box.high[0]; ++k) {
                if (pieces[i].edge != pieces[k].edge) {
                    search(face, pieces[i], pieces[k], contacts);
                }
            }
        }
        return contacts;
    }

    /// Halves two ranges until they are straight, where their boxes meet, and adds the contact that they are near.
    void search(int face, const Piece& a, const Piece& b, std::vector<Contact>& contacts) const {
        if (!a.box.meets(b.box)) {
            return;
        }
        const double straight = 0.25 * topology_.detail;
        if (a.sagitta <= straight && b.sagitta <= straight) {
            const std::optional<Contact> contact = contact_near(a, b);
            if (contact && is_new(face, *contact, contacts) && opens(face, *contact) && opens(face, turned(*contact))) {
                contacts.push_back(*contact);
            }
            return;
        }
        const Piece& curved = a.sagitta > b.sagitta ? a : b;
        const Piece& other = a.sagitta > b.sagitta ? b : a;
        const double middle = 0.5 * (curved.from + curved.to);
        search(face, piece(curved.edge, curved.from, middle), other, contacts);
        search(face, piece(curved.edge, middle, curved.to), other, contacts);
    }

    /// The nearest points of two edges, of the one in a range and beside it; none if they are not in contact.
    std::optional<Contact> contact_near(const Piece& a, const Piece& b) const {
        constexpr int kGoldenSteps = 40;
        constexpr double kGolden = 0.6180339887498949;
        const auto across = [&](double t) {
            const Answer there = curve(a.edge).point(t);
            return nearest_beside(b.edge, there.point, 0.5 * (b.from + b.to));
        };
        double low = std::max(edge(a.edge).t0, 2.0 * a.from - a.to);
        double high = std::min(edge(a.edge).t1, 2.0 * a.to - a.from);
        for (int i = 0; i < kGoldenSteps; ++i) {
            const double first = high - kGolden * (high - low);
            const double second = low + kGolden * (high - low);
            (across(first).distance < across(second).distance ? high : low) =
                across(first).distance < across(second).distance ? second : first;
        }
        const Answer first = curve(a.edge).point(0.5 * (low + high));
        const Answer second = across(first.t);
        const double gap = (first.point - second.point).norm();
        return gap < kContact * topology_.detail ? std::optional<Contact>({{a.edge, b.edge}, {first, second}, gap})
                                                 : std::nullopt;
    }

    Answer nearest_beside(int e, const Vec3& point, double guess) const {
        return curve(e).nearest(point, guess, edge(e).t0, edge(e).t1);
    }

    /// Whether two edges are a detail apart somewhere between two places of the first one.
    bool apart_between(int e, double from, double to, int other) const {
        constexpr int kPlaces = 8;
        for (int i = 1; i < kPlaces; ++i) {
            const Answer there = curve(e).point(from + (to - from) * i / kPlaces);
            if (nearest_on(other, there.point, topology_.detail).distance > topology_.detail) {
                return true;
            }
        }
        return false;
    }

    /// Whether the edges stay nearer than the detail between a contact and a node that they have in common.
    bool beside_node(int face, const Contact& contact) const {
        const auto [a, b] = contact.edges;
        for (const std::size_t i : {0, 1}) {
            for (const std::size_t k : {0, 1}) {
                if (is_one(face, edge(a).nodes[i], edge(b).nodes[k]) &&
                    !apart_between(a, i == 0 ? edge(a).t0 : edge(a).t1, contact.at[0].t, b)) {
                    return true;
                }
            }
        }
        return false;
    }

    /// Whether a contact at the end of an edge goes on along the edge that follows there, and all of that.
    bool goes_on(int face, const Contact& contact) const {
        for (const std::size_t k : {0, 1}) {
            const int node = node_beside(contact.edges[k], contact.at[k].t);
            const int other = contact.edges[1 - k];
            for (const Loop& loop : topology_.faces[static_cast<std::size_t>(face)].loops) {
                for (const int use : loop.uses) {
                    const int next = edge_of(use);
                    const auto& nodes = edge(next).nodes;
                    if (node >= 0 && (nodes[0] == node || nodes[1] == node) && next != contact.edges[k] &&
                        next != other && !apart_between(next, edge(next).t0, edge(next).t1, other)) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    /// Whether a contact is in no zone that has one, nor in that of a common node.
    bool is_new(int face, const Contact& contact, const std::vector<Contact>& contacts) const {
        const auto [a, b] = contact.edges;
        for (const Contact& old : contacts) {
            const bool same = old.edges == contact.edges;
            const bool turned = old.edges[0] == b && old.edges[1] == a;
            if ((same || turned) && !apart_between(a, old.at[same ? 0 : 1].t, contact.at[0].t, b)) {
                return false;
            }
        }
        return !beside_node(face, contact) && !goes_on(face, contact);
    }

    /// Whether two nodes are one, or an edge shorter than the detail joins them.
    bool is_one(int face, int a, int b) const {
        const std::vector<Loop>& loops = topology_.faces[static_cast<std::size_t>(face)].loops;
        const auto joins = [&](int use) {
            const std::array<int, 2>& nodes = edge(edge_of(use)).nodes;
            return (nodes == std::array<int, 2>{a, b} || nodes == std::array<int, 2>{b, a}) && is_short(edge_of(use));
        };
        return a >= 0 && (a == b || std::any_of(loops.begin(), loops.end(), [&](const Loop& loop) {
                              return std::any_of(loop.uses.begin(), loop.uses.end(), joins);
                          }));
    }

    /// Whether the edges open to a detail on both sides of a contact, as far as the first one goes on, with the face
    /// between them, and the walls beside open or the gap is too narrow to be meshed as it is.
    bool opens(int face, const Contact& contact) const {
        const auto [a, b] = contact.edges;
        bool any = false;
        for (const double end : {edge(a).t0, edge(a).t1}) {
            const bool has_side =
                curve(a).length(std::min(contact.at[0].t, end), std::max(contact.at[0].t, end)).distance >
                2.0 * topology_.detail;
            if (!has_side) {
                continue;
            }
            const std::optional<std::array<Answer, 2>> open = opening(contact, end);
            if (!open) {
                return false;
            }
            const Vec3 between = (*open)[1].point - (*open)[0].point;
            const int first = inner_use(face, a, (*open)[0].t, between);
            const int second = inner_use(face, b, (*open)[1].t, -between);
            if (first < 0 || second < 0 ||
                (contact.gap > kContactOfWalls * topology_.detail &&
                 !walls_open(first, second, contact, (*open)[0].t))) {
                return false;
            }
            any = true;
        }
        return any;
    }

    /// The use of an edge on a face, on whose inner side a direction points; -1: on none.
    int inner_use(int face, int e, double t, const Vec3& direction) const {
        const std::vector<int>& uses = edge(e).uses;
        const auto found = std::find_if(uses.begin(), uses.end(), [&](int use) {
            const auto into = use_of(use).face == face ? conormal(use, t) : std::nullopt;
            return into && into->dot(direction) > 0.0;
        });
        return found == uses.end() ? -1 : *found;
    }

    /// Whether the faces on the other sides open half-way from a contact to this parameter of the first edge.
    bool walls_open(int first, int second, const Contact& contact, double t) const {
        const Answer half = curve(contact.edges[0]).point(0.5 * (contact.at[0].t + t));
        const Answer across = nearest_on(contact.edges[1], half.point, topology_.detail);
        return edge(edge_of(first)).uses.size() == 2 && edge(edge_of(second)).uses.size() == 2 && across.found() &&
               angle_of_others(first, half.t, second, across.t) >= DetailCorners::kLeastDihedral;
    }

    /// The first points of two edges, from a contact to an end of the first edge, that are a detail apart.
    std::optional<std::array<Answer, 2>> opening(const Contact& contact, double end) const {
        constexpr double kRatio = 0.7;
        constexpr int kPlaces = 32;
        const auto [a, b] = contact.edges;
        std::optional<std::array<Answer, 2>> open;
        double share = 1.0;
        for (int i = 0; i < kPlaces; ++i, share *= kRatio) {
            const Answer there = curve(a).point(contact.at[0].t + share * (end - contact.at[0].t));
            const Answer across = nearest_on(b, there.point, topology_.detail);
            if (across.found() && across.distance > topology_.detail) {
                open = {{there, across}};
            } else if (open) {
                break;
            }
        }
        return open;
    }

    void apply(int face, const Contact& contact) {
        std::array<int, 2> edges{};
        std::array<int, 2> nodes{};
        std::array<double, 2> t{contact.at[0].t, contact.at[1].t};
        double gap = contact.gap;
        for (std::size_t k = 0; k < 2; ++k) {
            edges[k] = piece_at(face, contact.edges[k], contact.at[k].t);
            nodes[k] = node_beside(edges[k], contact.at[k].t);
        }
        if (same_node(nodes[0], nodes[1]) || beside_node(face, {edges, contact.at, contact.gap})) {
            return;  // a contact before this one has given them the node
        }
        for (std::size_t k = 0; k < 2; ++k) {
            if (nodes[k] >= 0 && nodes[1 - k] < 0) {  // the other edge is divided beside the node
                const Vec3& point = topology_.nodes[static_cast<std::size_t>(nodes[k])].point;
                const Answer beside = nearest_on(edges[1 - k], point, topology_.detail);
                if (!beside.found() || beside.distance > topology_.detail || node_beside(edges[1 - k], beside.t) >= 0) {
                    return;
                }
                t[1 - k] = beside.t;
                gap = beside.distance;
            }
        }
        topology_.faults.push_back(topology_.name_of({2, face}) + ": " + topology_.name_of({1, edges[0]}) + " and " +
                                   topology_.name_of({1, edges[1]}) + " are " + in_digits(contact.gap, 4) +
                                   " mm apart there, and count as touching each other");
        if (nodes[0] >= 0 && nodes[1] >= 0) {
            unite(nodes[0], nodes[1]);
            return;
        }
        const int node = nodes[0] >= 0   ? nodes[0]
                         : nodes[1] >= 0 ? nodes[1]
                                         : add_node(0.5 * (contact.at[0].point + contact.at[1].point),
                                                    0.5 * contact.gap, {1, edges[0]});
        for (std::size_t k = 0; k < 2; ++k) {
            if (nodes[k] < 0) {
                divide(edges[k], t[k], node);
            }
        }
        double& tolerance = topology_.nodes[static_cast<std::size_t>(node)].tolerance;
        tolerance = std::max(tolerance, gap);
    }

    /// The node of an edge that is at most two details from a place on it, along the edge; -1: none is.
    int node_beside(int e, double t) const {
        const auto near = [&](double end) {
            return curve(e).length(std::min(t, end), std::max(t, end)).distance <= 2.0 * topology_.detail;
        };
        return near(edge(e).t0) ? edge(e).nodes[0] : near(edge(e).t1) ? edge(e).nodes[1] : -1;
    }
};

}  // namespace

void join_border_contacts(Topology& topology, ShapeMap& live, const Progress* progress) {
    if (topology.detail > 0.0) {
        BorderContacts(topology, live).run(progress);
    }
}

}  // namespace mq::geometry
