// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/occt/checks/valid_face.h"

#include <BRepCheck_Wire.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "geometry/occt/checks/boundary_piece.h"
#include "geometry/occt/checks/checked_use.h"

namespace mq::geometry {

namespace {

// Pieces of a wire that are looked at: bounds the time.
constexpr std::size_t kMostPieces = 4096;

/// Whether an edge ends where it starts.
bool is_turn(const CheckedUse& use) {
    return use.vertices[0].IsSame(use.vertices[1]);
}

/// A wire of a face as a closed chain of edges.
class CheckedWire {
  public:
    CheckedWire(const TopoDS_Wire& wire, const CheckedSurface& on) : wire_(wire), on_(on) {}

    /// Whether the wire is closed and does not meet itself, by a proof, or by a search for crossings where the rest is
    /// proved.
    bool is_proved_valid() {
        return read() && (is_chain() || put_in_order()) && goes_one_way() && set_pieces() &&
               (is_simple() || has_no_crossing());
    }
    /// The area inside in (u, v), negative around a hole, and the largest error of it.
    std::pair<double, double> area() const;
    /// 1 for a point inside, -1 for a point outside, 0 if that is not certain.
    int side_of(const Vec2& point) const;
    const Vec2& start() const { return pieces_.front().start(); }
    bool is_apart_from(const CheckedWire& other) const;

  private:
    /// The place where two edges meet.
    struct Joint {
        std::size_t piece;  ///< the first piece after it
        double room;        ///< distance from it in (u, v) up to which both edges stay within the vertex's tolerance
        double gap;         ///< between both curves in (u, v)
    };

    /// A side of the polygon through the ends of all pieces: a chord, or a gap.
    struct Side {
        Vec2 from;
        Vec2 to;
        double beside;  ///< largest distance of the boundary from it
    };

    bool read();
    bool may_use_twice(const CheckedUse& use) const;
    bool is_chain() const;
    bool put_in_order();
    bool goes_one_way() const;
    bool set_pieces();
    void set_sides();
    void add_joint(const CheckedUse& before, const CheckedUse& after);
    bool has_small_gaps() const;
    bool is_simple() const;
    bool has_no_crossing() const;
    bool others_are_apart() const;
    bool leaves(std::size_t before, std::size_t after, double gap, double room) const;

    TopoDS_Wire wire_;
    const CheckedSurface& on_;
    std::vector<CheckedUse> uses_;
    std::vector<BoundaryPiece> pieces_;
    std::vector<Side> sides_;
    std::vector<Joint> joints_;
    double margin_ = 0.0;  ///< distance in (u, v) from which places count as apart
};

bool CheckedWire::read() {
    if (wire_.Orientation() != TopAbs_FORWARD && wire_.Orientation() != TopAbs_REVERSED) {
        return false;
    }
    for (TopoDS_Iterator it(wire_); it.More(); it.Next()) {
        const TopAbs_Orientation way = it.Value().Orientation();
        uses_.emplace_back();
        if (uses_.size() > kMostPieces || (way != TopAbs_FORWARD && way != TopAbs_REVERSED) ||
            !uses_.back().read(TopoDS::Edge(it.Value()), on_)) {
            return false;
        }
    }
    if (wire_.Orientation() == TopAbs_REVERSED) {
        std::reverse(uses_.begin(), uses_.end());
    }
    return !uses_.empty() &&
           std::all_of(uses_.begin(), uses_.end(), [&](const CheckedUse& use) { return may_use_twice(use); });
}

/// Whether an edge is met in both directions on a seam, and once elsewhere, and no other one turns at its vertex.
bool CheckedWire::may_use_twice(const CheckedUse& use) const {
    int against = 0;
    for (const CheckedUse& other : uses_) {
        if (&other == &use) {
            continue;
        }
        if (other.edge.IsSame(use.edge)) {
            if (other.edge.Orientation() == use.edge.Orientation()) {
                return false;
            }
            ++against;
        } else if (is_turn(use) && is_turn(other) && other.vertices[0].IsSame(use.vertices[0])) {
            return false;
        }
    }
    return against == (use.twice ? 1 : 0);
}

/// Whether each edge starts where the one before it ends, in the order of the wire.
bool CheckedWire::is_chain() const {
    for (std::size_t i = 0; i < uses_.size(); ++i) {
        if (!uses_[i].vertices[1].IsSame(uses_[(i + 1) % uses_.size()].vertices[0])) {
            return false;
        }
    }
    return true;
}

/// Puts the edges in order by vertices, and by places in (u, v) where several edges start at one.
bool CheckedWire::put_in_order() {
    for (auto use = uses_.begin(); use + 1 < uses_.end(); ++use) {
        const auto distance = [&](const CheckedUse& other) {
            return other.vertices[0].IsSame(use->vertices[1]) ? other.uv[0].Distance(use->uv[1])
                                                              : std::numeric_limits<double>::infinity();
        };
        std::iter_swap(use + 1, std::min_element(use + 1, uses_.end(), [&](const CheckedUse& a, const CheckedUse& b) {
                           return distance(a) < distance(b);
                       }));
    }
    return is_chain();
}

/// Whether OpenCASCADE, which follows a wire by vertices and by places in (u, v), can only follow it in this order.
bool CheckedWire::goes_one_way() const {
    // Ends in (u, v) closer than this fraction of OpenCASCADE's limit count as one place.
    constexpr double kSmall = 0.5;
    double largest = 0.0;
    for (const CheckedUse& use : uses_) {
        largest = std::max(largest, BRep_Tool::Tolerance(use.vertices[0]));
    }
    for (std::size_t i = 0; i < uses_.size(); ++i) {
        const CheckedUse& use = uses_[i];
        const CheckedUse& next = uses_[(i + 1) % uses_.size()];
        const double tolerance = BRep_Tool::Tolerance(use.vertices[1]);
        const double du = std::abs(use.uv[1].X() - next.uv[0].X());
        const double dv = std::abs(use.uv[1].Y() - next.uv[0].Y());
        const auto starts_here = [&](const CheckedUse& other) { return other.vertices[0].IsSame(use.vertices[1]); };
        const bool choice = std::count_if(uses_.begin(), uses_.end(), starts_here) > 1;
        if (!on_.is_one_place(use.uv[1], next.uv[0], tolerance) ||
            (choice &&
             (du > kSmall * on_.adaptor.UResolution(tolerance) || dv > kSmall * on_.adaptor.VResolution(tolerance)))) {
            return false;
        }
        for (const CheckedUse& other : uses_) {
            if (choice && &other != &next && starts_here(other) && !other.edge.IsSame(use.edge) &&
                on_.is_one_place(other.uv[0], use.uv[1], largest / kSmall)) {
                return false;
            }
        }
    }
    return true;
}

bool CheckedWire::set_pieces() {
    // Margin as a fraction of the size of the wire in (u, v).
    constexpr double kMargin = 1e-7;
    // Least margin: BRepCheck_Wire.cxx intersects curves in (u, v) with 1e-10 on each.
    constexpr double kLeastMargin = 2e-10;
    for (std::size_t i = 0; i < uses_.size(); ++i) {
        const CheckedUse& use = uses_[i];
        add_joint(uses_[(i + uses_.size() - 1) % uses_.size()], use);
        const std::vector<BoundaryPiece> some =
            BoundaryPiece::of(use.curve, use.first, use.last, use.edge.Orientation() == TopAbs_FORWARD);
        if (some.empty() || pieces_.size() + some.size() > kMostPieces) {
            return false;
        }
        pieces_.insert(pieces_.end(), some.begin(), some.end());
    }
    Vec2 low = pieces_.front().low();
    Vec2 high = pieces_.front().high();
    for (const BoundaryPiece& piece : pieces_) {
        low = low.cwiseMin(piece.low());
        high = high.cwiseMax(piece.high());
    }
    margin_ = std::max(kMargin * (high - low).norm(), kLeastMargin);
    set_sides();
    return pieces_.size() >= 3 && has_small_gaps();
}

void CheckedWire::set_sides() {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const BoundaryPiece& piece = pieces_[i];
        const Vec2& next = pieces_[(i + 1) % pieces_.size()].start();
        sides_.push_back({piece.start(), piece.end(), piece.height()});
        if (piece.end() != next) {
            sides_.push_back({piece.end(), next, (next - piece.end()).norm()});
        }
    }
}

/// Whether edges with a gap between them, which a tolerance may allow, still run around the same area.
bool CheckedWire::has_small_gaps() const {
    constexpr double kSmall = 1e-3;  // Fraction of the size of the pieces at the gap.
    return std::all_of(joints_.begin(), joints_.end(), [&](const Joint& joint) {
        const BoundaryPiece& after = pieces_[joint.piece];
        const BoundaryPiece& before = pieces_[(joint.piece + pieces_.size() - 1) % pieces_.size()];
        return joint.gap <=
               kSmall * std::min((after.high() - after.low()).norm(), (before.high() - before.low()).norm());
    });
}

void CheckedWire::add_joint(const CheckedUse& before, const CheckedUse& after) {
    constexpr double kNear = 1.1;  // As in BRepCheck_Wire.cxx: tolerances of a vertex within which edges may cross.
    gp_Pnt point;
    gp_Vec su;
    gp_Vec sv;
    on_.adaptor.D1(after.uv[0].X(), after.uv[0].Y(), point, su, sv);
    const double left =
        kNear * BRep_Tool::Tolerance(after.vertices[0]) - std::max(before.distances[1], after.distances[0]);
    joints_.push_back(
        {pieces_.size(), left / std::max(su.Magnitude() + sv.Magnitude(), 1e-300), before.uv[1].Distance(after.uv[0])});
}

/// Whether neighbours meet only where one continues the other, and all other pieces are apart.
bool CheckedWire::is_simple() const {
    const std::size_t n = pieces_.size();
    std::size_t joint = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const bool inner = joint >= joints_.size() || joints_[joint].piece != i;
        if (!leaves((i + n - 1) % n, i, inner ? 0.0 : joints_[joint].gap, inner ? 0.0 : joints_[joint].room)) {
            return false;
        }
        joint += inner ? 0 : 1;
    }
    return others_are_apart();
}

/// Whether pieces that are no neighbours are apart.
bool CheckedWire::others_are_apart() const {
    const std::size_t n = pieces_.size();
    std::vector<std::size_t> from_left(n);
    std::iota(from_left.begin(), from_left.end(), std::size_t{0});
    std::sort(from_left.begin(), from_left.end(),
              [&](std::size_t a, std::size_t b) { return pieces_[a].low().x() < pieces_[b].low().x(); });
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t a = from_left[i];
        const double reach = pieces_[a].high().x() + margin_;
        for (std::size_t k = i + 1; k < n && pieces_[from_left[k]].low().x() <= reach; ++k) {
            const std::size_t b = from_left[k];
            const std::size_t steps = a < b ? b - a : a - b;
            if (steps != 1 && steps != n - 1 && !pieces_[a].is_apart_from(pieces_[b], margin_)) {
                return false;
            }
        }
    }
    return true;
}

/// Whether a line separates a piece from the next one. Pieces with a gap between them may meet within `room` of the
/// gap.
bool CheckedWire::leaves(std::size_t before, std::size_t after, double gap, double room) const {
    // Least cosine of the angle between a piece and the direction in which it is left: the boundary does not turn back.
    constexpr double kLeastCosine = 0.05;
    const Vec2 direction = pieces_[before].end_direction() + pieces_[after].start_direction();
    const double cosine = 0.5 * direction.norm();
    return cosine > kLeastCosine && (gap == 0.0 || gap / cosine <= room) && pieces_[before].ascends(direction) &&
           pieces_[after].ascends(direction);
}

bool CheckedWire::has_no_crossing() const {
    TopoDS_Edge one;
    TopoDS_Edge other;
    return BRepCheck_Wire(wire_).SelfIntersect(on_.face, one, other) == BRepCheck_NoError;
}

std::pair<double, double> CheckedWire::area() const {
    double area = 0.0;
    double beside = 0.0;
    const Vec2& origin = start();
    for (const Side& side : sides_) {
        area += 0.5 * cross(side.from - origin, side.to - origin);
        beside += (side.beside + margin_) * (side.to - side.from).norm();
    }
    return {area, beside};
}

int CheckedWire::side_of(const Vec2& point) const {
    bool inside = false;
    for (const Side& side : sides_) {
        const Vec2& a = side.from;
        const Vec2& b = side.to;
        const double share = std::clamp((point - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
        if (!((a + share * (b - a) - point).norm() > side.beside + margin_)) {
            return 0;
        }
        if ((a.y() > point.y()) != (b.y() > point.y()) &&
            point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
            inside = !inside;
        }
    }
    return inside ? 1 : -1;
}

bool CheckedWire::is_apart_from(const CheckedWire& other) const {
    const double margin = std::max(margin_, other.margin_);
    return std::all_of(pieces_.begin(), pieces_.end(), [&](const BoundaryPiece& own) {
        return std::all_of(other.pieces_.begin(), other.pieces_.end(),
                           [&](const BoundaryPiece& others) { return own.is_apart_from(others, margin); });
    });
}

/// Whether one wire encloses all others, and the others are holes side by side.
bool are_nested(const std::vector<CheckedWire>& wires) {
    const CheckedWire* outer = nullptr;
    for (const CheckedWire& wire : wires) {
        const auto [area, error] = wire.area();
        if (!(std::abs(area) > error) || (area > 0.0 && outer != nullptr)) {
            return false;
        }
        outer = area > 0.0 ? &wire : outer;
    }
    if (outer == nullptr) {
        return false;
    }
    for (const CheckedWire& hole : wires) {
        for (const CheckedWire& other : wires) {
            if (&hole != outer && &hole != &other &&
                (!hole.is_apart_from(other) || other.side_of(hole.start()) != (&other == outer ? 1 : -1))) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace

bool is_proved_valid(const TopoDS_Face& face) {
    const TopoDS_Face forward = TopoDS::Face(face.Oriented(TopAbs_FORWARD));
    const CheckedSurface surface(forward);
    if (surface.surface.IsNull() || face.Infinite()) {
        return false;
    }
    std::vector<CheckedWire> wires;
    for (TopoDS_Iterator it(forward); it.More(); it.Next()) {
        if (it.Value().ShapeType() != TopAbs_WIRE) {
            return false;
        }
        wires.emplace_back(TopoDS::Wire(it.Value()), surface);
        if (!wires.back().is_proved_valid()) {
            return false;
        }
    }
    return !wires.empty() && are_nested(wires);
}

}  // namespace mq::geometry
