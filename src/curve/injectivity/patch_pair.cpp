// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curve/injectivity/patch_pair.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <optional>
#include <utility>

#include "curve/injectivity/patch_pieces.h"
#include "curve/injectivity/separation.h"
#include "curve/injectivity/straight_piercing.h"

namespace mq::curve {

namespace {

/// The pieces' corners on a shared edge.
struct OnEdge {
    int count = 0;
    std::array<int, 2> corner{};
    std::array<double, 2> at{};  ///< ascending, from 0 to 1 along the edge

    double length() const { return count == 2 ? at[1] - at[0] : 0.0; }
};

/// @param from, to  the corners of the patch between which the edge is
OnEdge on_edge(const PatchPiece& piece, int from, int to) {
    OnEdge found;
    const auto opposite = static_cast<std::size_t>(3 - from - to);
    for (int k = 0; k < 3; ++k) {
        const Barycentric& place = piece.part[static_cast<std::size_t>(k)];
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

/// The way in which two pieces meet by what their patches share.
struct Meeting {
    std::vector<std::array<int, 2>> corners;  ///< a corner of each piece
    int edges = 0;
    /// A piece shares an edge of which the other has a part only: that edge is to be halved first. 0 or 1: the first or
    /// the second piece; -1: there is none.
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

/// The corner of a piece that is one of its patch; -1: none.
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
        for (int looked_at = 0; !waiting_.empty(); ++looked_at) {
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
            if (const std::optional<Vec3> point = crossing(a, b)) {
                return {PatchContact::Crossing, *point};
            }
            if (looked_at >= kMostPiecePairs || overlap_in_plane(a, b) || overlap_in_plane(b, a)) {
                return {PatchContact::NotProven, a.corners[0]};
            }
            if (std::max(a.size, b.size) < limits_.least_size) {
                verdict = {PatchContact::NotProven, a.corners[0]};
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

    /// The vectors from the vertex to all points of a patch are sums of those to its control points with positive
    /// weights: a plane through the vertex separates the patches where one separates these.
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

    /// Each point of a patch is one of the edge plus a sum v of transversals; the difference of two points of the edge
    /// is a sum e of its tangents, or the opposite of one. At a common point v_a - v_b - e = 0, or v_a - v_b + e = 0:
    /// impossible where all these vectors are on one side of a plane, unless v_a and v_b are zero.
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

    /// Whether both pieces are in one plane and a corner of the first is inside the second: no halving tells them
    /// apart.
    bool overlap_in_plane(const PatchPiece& first, const PatchPiece& second) const {
        // Distance from the plane, relative to the smallest pieces: hulls farther apart were told before.
        constexpr double kInPlane = 1e-3;
        const std::array<Vec3, 3>& to = second.corners;
        const Vec3 normal = (to[1] - to[0]).cross(to[2] - to[0]).normalized();
        const auto in_plane = [&](const Vec3& p) {
            return std::abs(normal.dot(p - to[0])) <= kInPlane * limits_.least_size;
        };
        const auto inside = [&](const Vec3& p) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3 along = to[(k + 1) % 3] - to[k];
                const double depth = along.cross(p - to[k]).dot(normal) / along.norm();
                if (!(depth > second.bend + limits_.rounding)) {
                    return false;
                }
            }
            return true;
        };
        return std::any_of(first.corners.begin(), first.corners.end(), inside) &&
               std::all_of(first.control.begin(), first.control.end(), in_plane) &&
               std::all_of(second.control.begin(), second.control.end(), in_plane);
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
    /// In the order of their making, so that large pieces, which show most crossings, come first.
    std::deque<std::pair<std::int32_t, std::int32_t>> waiting_;
};

/// The difference of two points of a patch is, but for its sign, a sum of the transversals towards one corner: it is
/// not zero where for each corner these are on one side of a plane.
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
    const auto [a, b] = longest_edge(piece.part, 2);
    const std::int32_t first = pieces.halve(0, a, b);
    for (const std::int32_t half : {first, first + 1}) {
        PatchPiece part = pieces[half];
        part.part = half == first ? halve(piece.part, a, b).first : halve(piece.part, a, b).second;
        const PatchVerdict verdict = contact_with_itself(part, lattice, limits, depth - 1);
        if (verdict.contact != PatchContact::None) {
            return verdict;
        }
    }
    // The middle of the edge is corner b of the first half and corner a of the second; the third corner is common.
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
    // Halvings one in another: the smallest pieces have a sixteenth of the length.
    constexpr int kDeepest = 8;
    return contact_with_itself(PatchPiece(lattice, control, kWholeSimplex), lattice, limits, kDeepest);
}

}  // namespace mq::curve
