// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/injectivity/patch_pair.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <utility>

#include "curve/injectivity/hulls_apart.h"
#include "curve/injectivity/patch_pieces.h"
#include "curve/injectivity/straight_piercing.h"

namespace mq::curve {

using elements::Lattice;

namespace {

/// The corners of a piece that lie on a shared edge.
struct OnEdge {
    int count = 0;
    std::array<int, 2> corner{};
    std::array<double, 2> at{};  ///< ascending, from 0 to 1 along the edge

    double length() const { return count == 2 ? at[1] - at[0] : 0.0; }
};

/// @param from, to  the corners of the patch at the ends of the edge
OnEdge on_edge(const PatchPiece& piece, int from, int to) {
    OnEdge found;
    const auto opposite = static_cast<std::size_t>(3 - from - to);
    for (int k = 0; k < 3; ++k) {
        const elements::Barycentric& place = piece.part[static_cast<std::size_t>(k)];
        if (place[opposite] == 0.0 && found.count < 2) {
            found.corner[static_cast<std::size_t>(found.count)] = k;
            found.at[static_cast<std::size_t>(found.count++)] = place[static_cast<std::size_t>(to)];
        }
    }
    if (found.count == 2 && found.at[0] > found.at[1]) {
        std::swap(found.at[0], found.at[1]);
        std::swap(found.corner[0], found.corner[1]);
    }
    return found;
}

/// The vertices and edges in which two pieces meet because their patches share them.
struct Meeting {
    std::vector<std::array<int, 2>> corners;  ///< pairs: a corner of each piece
    int edges = 0;
    /// If a piece has a whole shared edge of which the other piece has a fraction only, that edge is halved first. 0 or
    /// 1: the first or the second piece is halved; -1: neither.
    int halve_first = -1;
    std::array<int, 2> halve_edge{};

    void add(int a, int b) {
        const std::array<int, 2> pair{a, b};
        if (std::find(corners.begin(), corners.end(), pair) == corners.end()) {
            corners.push_back(pair);
        }
    }
    void add(const OnEdge& a, const OnEdge& b) {
        const double low = std::max(a.at[0], b.at[0]);
        const double high =
            std::min(a.at[static_cast<std::size_t>(a.count - 1)], b.at[static_cast<std::size_t>(b.count - 1)]);
        if (low > high) {
            return;
        }
        if (a.count == 2 && b.count == 2 && a.at == b.at) {
            ++edges;
        } else if (low < high || !ends_at(a, low) || !ends_at(b, low)) {
            halve_first = a.length() >= b.length() ? 0 : 1;
            halve_edge = halve_first == 0 ? a.corner : b.corner;
            return;
        }
        for (std::size_t i = 0; i < static_cast<std::size_t>(a.count); ++i) {
            for (std::size_t j = 0; j < static_cast<std::size_t>(b.count); ++j) {
                if (a.at[i] == b.at[j]) {
                    add(a.corner[i], b.corner[j]);
                }
            }
        }
    }

  private:
    static bool ends_at(const OnEdge& piece, double at) {
        return piece.at[0] == at || (piece.count == 2 && piece.at[1] == at);
    }
};

/// The corner of a piece that is the given corner of its patch; -1: it has none.
int corner_at(const PatchPiece& piece, int patch_corner) {
    for (int k = 0; k < 3; ++k) {
        if (piece.part[static_cast<std::size_t>(k)][static_cast<std::size_t>(patch_corner)] == 1.0) {
            return k;
        }
    }
    return -1;
}

Meeting meeting_of(const PatchPiece& a, const PatchPiece& b, const SharedEntities& shared) {
    Meeting meeting;
    for (const auto& [in_a, in_b] : shared.corners) {
        const int corner_a = corner_at(a, in_a);
        const int corner_b = corner_at(b, in_b);
        if (corner_a >= 0 && corner_b >= 0) {
            meeting.add(corner_a, corner_b);
        }
    }
    for (const auto& [from, to] : shared.edges) {
        const std::array<int, 2>& first = shared.corners[static_cast<std::size_t>(from)];
        const std::array<int, 2>& last = shared.corners[static_cast<std::size_t>(to)];
        const OnEdge edge_a = on_edge(a, first[0], last[0]);
        const OnEdge edge_b = on_edge(b, first[1], last[1]);
        if (edge_a.count > 0 && edge_b.count > 0) {
            meeting.add(edge_a, edge_b);
        }
    }
    return meeting;
}

class PairSearch {
  public:
    PairSearch(const Lattice& lattice, const std::vector<Vec3>& a, const std::vector<Vec3>& b,
               const SharedEntities& shared, const PatchLimits& limits)
        : lattice_(lattice), a_(lattice, a), b_(lattice, b), shared_(shared), limits_(limits) {}

    PatchVerdict run() {
        waiting_.emplace_back(0, 0);
        PatchVerdict verdict;
        for (; !waiting_.empty(); ++verdict.looked_at) {
            const auto [i, j] = waiting_.front();
            waiting_.pop_front();
            const PatchPiece& a = a_[i];
            const PatchPiece& b = b_[j];
            const Meeting meeting = meeting_of(a, b, shared_);
            if (meeting.halve_first >= 0) {
                halve(i, j, meeting.halve_first, &meeting.halve_edge);
                continue;
            }
            if (meet_only_there(a, b, meeting)) {
                continue;
            }
            if (shared_.may_touch && touch(a, b)) {
                verdict.contact = std::max(verdict.contact, PatchContact::Touching);
                continue;
            }
            if (const std::optional<Vec3> point = crossing(a, b)) {
                return {PatchContact::Crossing, *point, verdict.looked_at};
            }
            if (verdict.looked_at >= limits_.most_pairs || overlap_in_plane(a, b)) {
                return {PatchContact::NotProven, a.corners[0], verdict.looked_at};
            }
            if (std::max(a.size, b.size) < limits_.least_size) {
                verdict.contact = PatchContact::NotProven;
                verdict.point = a.corners[0];
            } else {
                halve(i, j, a.size >= b.size ? 0 : 1, nullptr);
            }
        }
        return verdict;
    }

  private:
    void halve(std::int32_t i, std::int32_t j, int side, const std::array<int, 2>* edge) {
        PatchPieces& pieces = side == 0 ? a_ : b_;
        const std::int32_t piece = side == 0 ? i : j;
        const std::int32_t first = edge != nullptr ? pieces.halve(piece, (*edge)[0], (*edge)[1]) : pieces.halve(piece);
        for (const std::int32_t half : {first, first + 1}) {
            waiting_.emplace_back(side == 0 ? half : i, side == 0 ? j : half);
        }
    }

    bool meet_only_there(const PatchPiece& a, const PatchPiece& b, const Meeting& meeting) const {
        const std::size_t corners = meeting.corners.size();
        if (corners == 0) {
            return boxes_apart(a.box, b.box) || hulls_apart(a.control, b.control, limits_.rounding);
        }
        if (corners == 1 && meeting.edges == 0) {
            return meet_in_vertex(a, b, meeting.corners[0]);
        }
        return corners == 2 && meeting.edges == 1 && meet_in_edge(a, b, meeting);
    }

    bool boxes_apart(const Box& a, const Box& b) const {
        return ((a.low - b.high).array() > limits_.rounding).any() ||
               ((b.low - a.high).array() > limits_.rounding).any();
    }

    /// Vectors from the vertex to points of a patch are sums of the vectors to its control points with positive
    /// weights: a plane through the vertex that separates the control points separates the patches.
    bool meet_in_vertex(const PatchPiece& a, const PatchPiece& b, const std::array<int, 2>& corners) const {
        std::vector<Vec3> vectors;
        const auto add = [&](const PatchPiece& piece, int corner, double sign) {
            const int at = lattice_.corner(corner);
            for (int i = 0; i < lattice_.size(); ++i) {
                if (i != at) {
                    vectors.push_back(sign * (piece.control[static_cast<std::size_t>(i)] -
                                              piece.corners[static_cast<std::size_t>(corner)]));
                }
            }
        };
        add(a, corners[0], 1.0);
        add(b, corners[1], -1.0);
        return in_open_half_space(vectors, limits_.rounding);
    }

    /// Each point of a patch is a point of the edge plus a sum v of transversals. The difference of two points of the
    /// edge is a sum e of its tangents, or the opposite of such a sum. At a common point v_a - v_b - e = 0, or v_a -
    /// v_b + e = 0. If all these vectors are on one side of a plane, this is impossible unless v_a and v_b are zero.
    bool meet_in_edge(const PatchPiece& a, const PatchPiece& b, const Meeting& meeting) const {
        const std::array<int, 2>& from = meeting.corners[0];
        const std::array<int, 2>& to = meeting.corners[1];
        std::vector<Vec3> vectors;
        add_transversals(lattice_, a.control, 3 - from[0] - to[0], 1.0, vectors);
        add_transversals(lattice_, b.control, 3 - from[1] - to[1], -1.0, vectors);
        const std::size_t across = vectors.size();
        for (const double sign : {1.0, -1.0}) {
            vectors.resize(across);
            add_tangents(lattice_, a.control, from[0], to[0], sign, vectors);
            if (!in_open_half_space(vectors, limits_.rounding)) {
                return false;
            }
        }
        return true;
    }

    /// Whether the pieces lie on the two sides of a plane, which both may touch; coplanar faces have opposite normals
    /// then. The planes that are tried are those that separate flat triangles.
    bool touch(const PatchPiece& a, const PatchPiece& b) const {
        const double slack = limits_.touching;
        const auto on_both_sides = [&](const Vec3& direction) {
            const double length = direction.norm();
            if (!(length > 0.0)) {
                return false;
            }
            const auto [low_a, high_a] = range(a, direction / length);
            const auto [low_b, high_b] = range(b, direction / length);
            const bool in_one_plane = std::max(high_a, high_b) - std::min(low_a, low_b) <= 2.0 * slack;
            return !in_one_plane && (low_a >= high_b - slack || low_b >= high_a - slack);
        };
        const Vec3 normal_a = (a.corners[1] - a.corners[0]).cross(a.corners[2] - a.corners[0]);
        const Vec3 normal_b = (b.corners[1] - b.corners[0]).cross(b.corners[2] - b.corners[0]);
        if (on_both_sides(normal_a) || on_both_sides(normal_b)) {
            return true;
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 edge_a = a.corners[(k + 1) % 3] - a.corners[k];
            const Vec3 edge_b = b.corners[(k + 1) % 3] - b.corners[k];
            if (on_both_sides(normal_a.cross(edge_a)) || on_both_sides(normal_b.cross(edge_b))) {
                return true;
            }
            for (std::size_t m = 0; m < 3; ++m) {
                if (on_both_sides(edge_a.cross(b.corners[(m + 1) % 3] - b.corners[m]))) {
                    return true;
                }
            }
        }
        const auto in_plane = [&](const PatchPiece& piece) {
            const auto [low, high] = range(piece, normal_a.normalized());
            return std::max(high - normal_a.normalized().dot(a.corners[0]),
                            normal_a.normalized().dot(a.corners[0]) - low) <= slack;
        };
        return normal_a.dot(normal_b) < 0.0 && in_plane(a) && in_plane(b);
    }

    static std::pair<double, double> range(const PatchPiece& piece, const Vec3& direction) {
        std::pair<double, double> found{std::numeric_limits<double>::infinity(),
                                        -std::numeric_limits<double>::infinity()};
        for (const Vec3& p : piece.control) {
            found.first = std::min(found.first, direction.dot(p));
            found.second = std::max(found.second, direction.dot(p));
        }
        return found;
    }

    /// Whether both pieces are in one plane and overlap there: halving does not separate them.
    bool overlap_in_plane(const PatchPiece& a, const PatchPiece& b) const {
        // Tolerance relative to the pieces: small ones differ in slopes, not only in heights.
        constexpr double kFlat = 1e-3;
        const double slack = std::min(limits_.touching, kFlat * std::min(a.size, b.size));
        const PatchPiece& wide = a.size >= b.size ? a : b;
        const Vec3 normal = (wide.corners[1] - wide.corners[0]).cross(wide.corners[2] - wide.corners[0]).normalized();
        const auto in_plane = [&](const Vec3& p) { return std::abs(normal.dot(p - wide.corners[0])) <= slack; };
        const double depth = a.bend + b.bend + 2.0 * limits_.rounding;
        return std::all_of(a.control.begin(), a.control.end(), in_plane) &&
               std::all_of(b.control.begin(), b.control.end(), in_plane) &&
               overlap(a.corners, b.corners, normal, depth) && overlap(b.corners, a.corners, normal, depth);
    }

    /// Whether the two triangles overlap by at least `depth`: the second one reaches farther than that behind each edge
    /// of the first.
    static bool overlap(const std::array<Vec3, 3>& first, const std::array<Vec3, 3>& second, const Vec3& normal,
                        double depth) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 across = normal.cross(first[(k + 1) % 3] - first[k]);
            const double inward = across.dot(first[(k + 2) % 3] - first[k]) >= 0.0 ? 1.0 : -1.0;
            double deepest = -std::numeric_limits<double>::infinity();
            for (const Vec3& p : second) {
                deepest = std::max(deepest, inward * across.dot(p - first[k]));
            }
            if (!(deepest > depth * across.norm())) {
                return false;
            }
        }
        return true;
    }

    std::optional<Vec3> crossing(const PatchPiece& a, const PatchPiece& b) const {
        for (const auto& [arcs, disc] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
            if (arcs->bend + disc->bend > std::min(arcs->size, disc->size)) {
                continue;
            }
            for (std::size_t k = 0; k < 3; ++k) {
                const std::optional<Vec3> point =
                    certain_piercing(arcs->corners[k], arcs->corners[(k + 1) % 3], arcs->bend + limits_.rounding,
                                     disc->corners, disc->bend + limits_.rounding);
                if (point) {
                    return point;
                }
            }
        }
        return std::nullopt;
    }

    const Lattice& lattice_;
    PatchPieces a_;
    PatchPieces b_;
    const SharedEntities& shared_;
    PatchLimits limits_;
    /// In the order of their creation, so that large pieces, which show most crossings, come first.
    std::deque<std::pair<std::int32_t, std::int32_t>> waiting_;
};

/// The difference of two points of a patch is, up to its sign, a sum of the transversals towards one corner. It is not
/// zero if for each corner the transversals are on one side of a plane.
bool is_monotone(const Lattice& lattice, const std::vector<Vec3>& control, double rounding) {
    std::vector<Vec3> vectors;
    for (int corner = 0; corner < 3; ++corner) {
        vectors.clear();
        add_transversals(lattice, control, corner, 1.0, vectors);
        if (!in_open_half_space(vectors, rounding)) {
            return false;
        }
    }
    return true;
}

PatchVerdict contact_with_itself(const PatchPiece& piece, const Lattice& lattice, const PatchLimits& limits,
                                 int depth) {
    if (is_monotone(lattice, piece.control, limits.rounding)) {
        return {};
    }
    if (depth == 0) {
        return {PatchContact::NotProven, piece.corners[0]};
    }
    PatchPieces pieces(lattice, piece.control);
    const auto [a, b] = elements::longest_edge(piece.part, 2);
    const std::int32_t first = pieces.halve(0, a, b);
    for (const std::int32_t half : {first, first + 1}) {
        PatchPiece part = pieces[half];
        part.part = half == first ? elements::halve(piece.part, a, b).first : elements::halve(piece.part, a, b).second;
        const PatchVerdict verdict = contact_with_itself(part, lattice, limits, depth - 1);
        if (verdict.contact != PatchContact::None) {
            return verdict;
        }
    }
    // The middle of the edge is corner b of the first half and corner a of the second one; the third corner is common
    // to both.
    const int third = 3 - a - b;
    return contact_of_patches(lattice, pieces[first].control, pieces[first + 1].control,
                              {{{b, a}, {third, third}}, {{0, 1}}}, limits);
}

}  // namespace

PatchVerdict contact_of_patches(const Lattice& lattice, const std::vector<Vec3>& a, const std::vector<Vec3>& b,
                                const SharedEntities& shared, const PatchLimits& limits) {
    return PairSearch(lattice, a, b, shared, limits).run();
}

PatchVerdict contact_with_itself(const Lattice& lattice, const std::vector<Vec3>& control, const PatchLimits& limits) {
    // Deepest nesting of halvings: the smallest pieces have a sixteenth of the patch's length.
    constexpr int kDeepest = 8;
    return contact_with_itself(PatchPiece(lattice, control, elements::kWholeSimplex), lattice, limits, kDeepest);
}

}  // namespace mq::curve
