// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/error_measure.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <utility>

#include "base/parallel.h"
#include "base/predicates.h"
#include "mesh/intersection/nearest_tree.h"
#include "mesh/intersection/triangle_distance.h"

namespace mq::boolean {

namespace {

using mesh::Triangle;
using Corners = std::array<Vec3, 3>;

/// Half the distance between the two points by which a side of a surface is told from the other, by the size: as single
/// precision rounds.
constexpr double kBeside = 1e-7;
/// Samples on large triangles, all together, about.
constexpr double kLargeSamples = 100'000.0;
/// Triangles whose samples are measured between two looks at a cancellation.
constexpr std::size_t kBlock = 64;

/// The side on which an edge passes a line along an axis: positive where it runs counter-clockwise around it, seen
/// against the axis. The line is moved by an infinitesimal vector, the same for all edges, so that it meets none.
int side_of_edge(const Vec3& p, const Vec3& v, const Vec3& w, int axis) {
    const int side = orient2d(p, v, w, axis);
    if (side != 0) {
        return side;
    }
    const int i = (axis + 1) % 3;
    const int j = (axis + 2) % 3;
    if (v[j] != w[j]) {
        return v[j] > w[j] ? 1 : -1;
    }
    return v[i] < w[i] ? 1 : v[i] > w[i] ? -1 : 0;
}

/// Calls visit for the 26 steps to neighbours in a grid, of one length, until it returns false.
template <typename Visit>
void for_each_way(double length, const Visit& visit) {
    for (int k = 0; k < 27; ++k) {
        const Vec3 way(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
        if (k != 13 && !visit(Vec3(length / way.norm() * way))) {
            return;
        }
    }
}

/// The points of space that an expression makes of its operands.
class ExactSolid {
  public:
    ExactSolid(const std::vector<EnclosedOperand>& operands, const Expression& expression)
        : operands_(operands), expression_(expression), triangles_(merge()), tree_(vertices_, triangles_) {
        const Box box = tree_.box();
        beside_ = box.empty() ? 0.0 : kBeside * box.largest_side();
    }

    const mesh::NearestTree& tree() const { return tree_; }
    double beside() const { return beside_; }
    Corners corners(std::int32_t triangle) const {
        const Triangle& t = triangles_[static_cast<std::size_t>(triangle)];
        return {vertices_[static_cast<std::size_t>(t[0])], vertices_[static_cast<std::size_t>(t[1])],
                vertices_[static_cast<std::size_t>(t[2])]};
    }
    std::int32_t first_triangle(std::size_t operand) const { return first_[operand]; }
    std::int32_t operand_of(std::int32_t triangle) const { return operand_[static_cast<std::size_t>(triangle)]; }

    bool contains(const Vec3& p) const {
        const Box box = tree_.box();
        int axis = 0;
        double shortest = std::numeric_limits<double>::infinity();
        for (int k = 0; k < 3; ++k) {
            const double way = std::min(p[k] - box.low[k], box.high[k] - p[k]);
            if (way < 0.0) {
                return false;
            }
            if (way < shortest) {
                shortest = way;
                axis = k;
            }
        }
        return sides(p, axis, 0.0)[0];
    }

    /// Whether the points before and behind p along an axis, at the distance `half`, belong to the solid.
    std::array<bool, 2> sides(const Vec3& p, int axis, double half) const {
        const Box box = tree_.box();
        const double sign = box.high[axis] - p[axis] < p[axis] - box.low[axis] ? 1.0 : -1.0;
        Vec3 along = Vec3::Zero();
        along[axis] = sign;
        std::vector<std::int32_t> beyond(operands_.size(), 0);
        std::vector<std::int32_t> between(operands_.size(), 0);
        tree_.for_each_on_ray(p - 2.0 * half * along, along, [&](std::int32_t triangle) {
            const auto operand = static_cast<std::size_t>(operand_[static_cast<std::size_t>(triangle)]);
            if (operands_[operand].winding != nullptr) {
                return;
            }
            const auto [a, b, c] = corners(triangle);
            const int side = side_of_edge(p, a, b, axis);
            if (side == 0 || side_of_edge(p, b, c, axis) != side || side_of_edge(p, c, a, axis) != side) {
                return;
            }
            const Vec3 normal = (b - a).cross(c - a);
            double at = p[axis];
            if (normal[axis] != 0.0) {
                Vec3 in_plane = a - p;
                in_plane[axis] = 0.0;
                at = a[axis] + in_plane.dot(normal) / normal[axis];
            }
            const auto [low, high] = std::minmax({a[axis], b[axis], c[axis]});
            const double ahead = sign * (std::clamp(at, low, high) - p[axis]);
            const int turns = sign > 0.0 ? side : -side;
            if (ahead > half) {
                beyond[operand] += turns;
            } else if (ahead > -half) {
                between[operand] += turns;
            }
        });
        for (std::size_t k = 0; k < operands_.size(); ++k) {
            between[k] += beyond[k];
            if (operands_[k].winding != nullptr) {
                beyond[k] = guesses_inside(k, p + half * along) ? 1 : 0;
                between[k] = half > 0.0 ? (guesses_inside(k, p - half * along) ? 1 : 0) : beyond[k];
            }
        }
        return {expression_.contains(between.data()), expression_.contains(beyond.data())};
    }

    /// Whether the solid is on one side only of a point of a triangle.
    bool is_bounded_at(const Vec3& p, const Vec3& normal) const { return is_bounded_at(p, normal, beside_); }
    /// The same of points at this distance on both sides.
    bool is_bounded_at(const Vec3& p, const Vec3& normal, double beside) const {
        int axis = 0;
        normal.cwiseAbs().maxCoeff(&axis);
        const auto [before, behind] = sides(p, axis, beside);
        return before != behind;
    }

    /// Whether there is a ball of this diameter near a point of the surface in the solid, and one outside of it: in a
    /// film or a gap that is thinner, or at its rim, there is none. Near are centers up to a diameter away, so that
    /// edges of 60 degrees are not taken for films. Balls are tested by 26 points.
    bool is_thick_at(const Vec3& p, double diameter) const {
        return has_ball(p, true, 0.5 * diameter) && has_ball(p, false, 0.5 * diameter);
    }

    /// The steps by which the winding numbers of open operands would come to 0.5, where they have a gradient, and those
    /// to the sides of the boxes in which these operands lie.
    void add_steps_to_guess(const Vec3& p, std::vector<Vec3>& steps) const {
        for (const EnclosedOperand& operand : operands_) {
            if (operand.winding == nullptr) {
                continue;
            }
            const Vec3 gradient = operand.winding->gradient(p);
            if (gradient.squaredNorm() > 0.0) {
                steps.emplace_back((0.5 - operand.winding->at(p)) / gradient.squaredNorm() * gradient);
            }
            const Box box = operand.winding->tree().box();
            for (int k = 0; k < 3; ++k) {
                steps.emplace_back((box.low[k] - p[k]) * Vec3::Unit(k));
                steps.emplace_back((box.high[k] - p[k]) * Vec3::Unit(k));
            }
        }
    }

  private:
    bool has_ball(const Vec3& p, bool inside, double radius) const {
        bool found = false;
        for (double way = radius; way <= 2.0 * radius && !found; way += radius) {
            for_each_way(way, [&](const Vec3& step) {
                found = contains(p + step) == inside;
                for_each_way(radius, [&](const Vec3& around) {
                    found = found && contains(p + step + around) == inside;
                    return found;
                });
                return !found;
            });
        }
        return found;
    }

    /// Whether a point is in an open operand: in the box of its triangles, where it winds around it.
    bool guesses_inside(std::size_t operand, const Vec3& p) const {
        const mesh::WindingNumber& winding = *operands_[operand].winding;
        return winding.tree().box().contains(p) && winding.at(p) >= 0.5;
    }

    std::vector<Triangle> merge() {
        std::vector<Triangle> all;
        for (std::size_t k = 0; k < operands_.size(); ++k) {
            const auto first = static_cast<std::int32_t>(vertices_.size());
            first_.push_back(static_cast<std::int32_t>(all.size()));
            vertices_.insert(vertices_.end(), operands_[k].vertices->begin(), operands_[k].vertices->end());
            for (const Triangle& t : *operands_[k].triangles) {
                all.push_back({t[0] + first, t[1] + first, t[2] + first});
            }
            operand_.resize(all.size(), static_cast<std::int32_t>(k));
        }
        return all;
    }

    const std::vector<EnclosedOperand>& operands_;
    const Expression& expression_;
    std::vector<Vec3> vertices_;
    std::vector<std::int32_t> operand_;  ///< by triangle
    std::vector<std::int32_t> first_;    ///< triangle of each operand
    std::vector<Triangle> triangles_;
    mesh::NearestTree tree_;
    double beside_ = 0.0;
};

/// The largest of many values, from all threads.
class Largest {
  public:
    double get() const { return value_.load(std::memory_order_relaxed); }
    void add(double value) {
        double before = get();
        while (value > before && !value_.compare_exchange_weak(before, value, std::memory_order_relaxed)) {
        }
    }

  private:
    std::atomic<double> value_{0.0};
};

/// Bounds the distance of one point from the surface of a solid from above.
class DistanceSearch {
  public:
    DistanceSearch(const ExactSolid& solid, const Vec3& p) : solid_(solid), p_(p) {}

    /// @param enough  a bound up to this is not improved
    double bound(double enough) {
        const mesh::ClosestPoint near = solid_.tree().nearest(p_);
        if (near.triangle < 0) {
            return 0.0;  // no operand has a triangle: nothing is to be compared
        }
        const double least = 8.0 * solid_.beside();  // the points looked at are not farther away
        if (near.distance <= 2.0 * solid_.beside() && lies_on()) {
            return least;
        }
        inside_ = solid_.contains(p_);
        const Box box = solid_.tree().box();
        const double whole = (box.high - box.low).norm() + near.distance;
        best_ = whole;
        try_step(near.point - p_);
        std::vector<Vec3> guesses;
        solid_.add_steps_to_guess(p_, guesses);
        for (const Vec3& step : guesses) {
            try_step(step);
        }
        if (best_ > enough && is_any_beyond(enough)) {
            return enough;
        }
        double searched = 0.0;
        for (double reach = kWider * (near.distance + solid_.beside()); best_ > enough && searched < best_;
             reach *= kWider) {
            search(searched, std::min(reach, best_));
            if (best_ > reach) {
                probe(reach);
            }
            searched = reach;
        }
        return best_;
    }

  private:
    /// Factor by which the ball grows in which triangles are sought.
    static constexpr double kWider = 2.0;
    /// By how much steps are longer than the way to a surface, and again where that is not enough, as on curved ones.
    static constexpr std::array<double, 4> kBeyond{1.0, 1.01, 1.1, 1.5};
    /// Steps whose ends are nearer to each other than this, by their length, are taken as one.
    static constexpr double kSame = 0.05;
    /// Steps shorter than this, by the radius of the ball, are not taken in pairs: they were in smaller balls.
    static constexpr double kNear = 0.125;
    /// Steps that are taken singly, looked around at their ends, taken in pairs, and in threes.
    static constexpr std::size_t kMost = 256;
    static constexpr std::size_t kMostAround = 8;
    static constexpr std::size_t kMostInPairs = 16;
    static constexpr std::size_t kMostInThrees = 6;

    /// Whether a triangle at p bounds the solid there, or a little nearer to one of its corners: at an edge, a vertex
    /// or a curve of intersection the solid may be on one side of it on a part only.
    bool lies_on() const {
        const Vec3 around = Vec3::Constant(2.0 * solid_.beside());
        bool found = false;
        solid_.tree().for_each_in_box({p_ - around, p_ + around}, [&](std::int32_t triangle) {
            const Corners corners = solid_.corners(triangle);
            const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
            const Vec3 at = mesh::nearest_on_triangle(p_, corners[0], corners[1], corners[2]);
            if ((at - p_).norm() > 2.0 * solid_.beside()) {
                return true;
            }
            found = solid_.is_bounded_at(at, normal);
            for (std::size_t k = 0; k < 3 && !found; ++k) {
                const Vec3 way = corners[k] - at;
                const double share = std::min(1.0, 4.0 * solid_.beside() / std::max(way.norm(), solid_.beside()));
                found = solid_.is_bounded_at(at + share * way, normal);
            }
            return !found;
        });
        return found;
    }

    /// Whether the point a step away, and a little farther, is on another side than p.
    bool try_step(const Vec3& step) {
        const double length = step.norm();
        if (length == 0.0) {
            return false;
        }
        for (const double factor : kBeyond) {
            const double far = factor * length + 2.0 * solid_.beside();
            if (far >= best_) {
                return false;
            }
            if (solid_.contains(p_ + far / length * step) != inside_) {
                best_ = far;
                return true;
            }
        }
        return false;
    }

    /// The same a little beside the end of a step, to four sides: where the step leads along a face to an edge, the
    /// points beyond its end are on a border of the solid themselves.
    bool try_around(const Vec3& step) {
        const Vec3 ahead = step.normalized();
        const Vec3 across = ahead.unitOrthogonal();
        const Vec3 third = ahead.cross(across);
        const double little = 4.0 * solid_.beside();
        for (const double i : {-little, little}) {
            for (const double j : {-little, little}) {
                const Vec3 there = step + little * ahead + i * across + j * third;
                if (there.norm() < best_ && solid_.contains(p_ + there) != inside_) {
                    best_ = there.norm();
                    return true;
                }
            }
        }
        return false;
    }

    /// Tries what triangles of which the nearest points are in a ball lead to; those nearer than `searched` singly no
    /// more.
    void search(double searched, double reach) {
        const std::vector<Vec3> steps = steps_within(reach);
        std::size_t tried = 0;
        for (const Vec3& step : steps) {
            if (step.norm() < searched) {
                continue;
            }
            if (++tried > kMost || step.norm() >= best_ || try_step(step) ||
                (tried <= kMostAround && try_around(step))) {
                break;
            }
        }
        const std::vector<Vec3> apart = steps_apart(steps, kNear * reach);
        for (std::size_t i = 0; i < apart.size(); ++i) {
            for (std::size_t j = i + 1; j < apart.size(); ++j) {
                try_to_meet({&apart[i], &apart[j]});
                for (std::size_t k = j + 1; k < std::min(apart.size(), kMostInThrees); ++k) {
                    try_to_meet({&apart[i], &apart[j], &apart[k]});
                }
            }
        }
    }

    /// Whether a point on another side than p is found at this distance.
    bool is_any_beyond(double distance) const {
        bool found = false;
        for_each_way(distance, [&](const Vec3& step) {
            found = solid_.contains(p_ + step) != inside_;
            return !found;
        });
        return found;
    }

    /// Tries points all around p: where no plane tells the way, as at edges and vertices.
    void probe(double radius) {
        for_each_way(radius, [&](const Vec3& step) {
            if (solid_.contains(p_ + step) != inside_) {
                shorten(step);
            }
            return true;
        });
    }

    /// Takes a step to the other side, as far as the surface is on its way.
    void shorten(const Vec3& step) {
        constexpr int kHalvings = 7;  // to a hundredth
        double from = 0.0;
        double to = 1.0;
        for (int k = 0; k < kHalvings; ++k) {
            const double middle = 0.5 * (from + to);
            (solid_.contains(p_ + middle * step) == inside_ ? from : to) = middle;
        }
        best_ = std::min(best_, to * step.norm());
    }

    /// The ways to the nearest points of triangles around p, the shortest first.
    std::vector<Vec3> steps_within(double reach) const {
        std::vector<Vec3> all;
        const Vec3 around = Vec3::Constant(reach);
        solid_.tree().for_each_in_box({p_ - around, p_ + around}, [&](std::int32_t triangle) {
            const auto [a, b, c] = solid_.corners(triangle);
            const Vec3 step = mesh::nearest_on_triangle(p_, a, b, c) - p_;
            if (step.norm() <= reach) {
                all.push_back(step);
            }
        });
        std::sort(all.begin(), all.end(),
                  [](const Vec3& a, const Vec3& b) { return a.squaredNorm() < b.squaredNorm(); });
        return all;
    }

    /// The first of some steps, none shorter than `least`, whose ends are not near to each other.
    static std::vector<Vec3> steps_apart(const std::vector<Vec3>& steps, double least) {
        std::vector<Vec3> apart;
        for (const Vec3& step : steps) {
            if (step.norm() < least) {
                continue;
            }
            if (apart.size() == kMostInPairs) {
                break;
            }
            const double near = kSame * step.norm();
            const auto is_near = [&](const Vec3& other) { return (other - step).norm() <= near; };
            if (std::none_of(apart.begin(), apart.end(), is_near)) {
                apart.push_back(step);
            }
        }
        return apart;
    }

    /// The shortest step to the line, or point, in which the planes at the ends of steps meet, where it crosses all.
    template <std::size_t n>
    void try_to_meet(const Vec3* const (&steps)[n]) {
        Eigen::Matrix<double, n, n> products;
        Eigen::Matrix<double, n, 1> lengths;
        for (std::size_t i = 0; i < n; ++i) {
            lengths[i] = steps[i]->norm();
            for (std::size_t j = 0; j < n; ++j) {
                products(i, j) = steps[i]->dot(*steps[j]) / (lengths[i] * steps[j]->norm());
            }
        }
        constexpr double kIndependent = 1e-3;  // determinant: normals about 2 degrees apart
        if (lengths.minCoeff() <= 0.0 || products.determinant() < kIndependent) {
            return;
        }
        const Eigen::Matrix<double, n, 1> shares = products.inverse() * lengths;
        Vec3 step = Vec3::Zero();
        for (std::size_t i = 0; i < n; ++i) {
            step += shares[i] / lengths[i] * *steps[i];
        }
        if (shares.minCoeff() > 0.0) {
            try_step(step);
        }
    }

    const ExactSolid& solid_;
    const Vec3 p_;
    bool inside_ = false;
    double best_ = 0.0;
};

/// A triangle of the result or of an operand, or a piece of one.
struct Piece {
    Corners corners;
    std::int32_t operand = -1;  ///< whose surface it is on; -1: not known

    double longest_side() const {
        return std::max(
            {(corners[1] - corners[0]).norm(), (corners[2] - corners[1]).norm(), (corners[0] - corners[2]).norm()});
    }
    Vec3 centre() const { return (corners[0] + corners[1] + corners[2]) / 3.0; }
    Vec3 normal() const { return (corners[1] - corners[0]).cross(corners[2] - corners[0]); }
    /// Both halves of it, cut across the longest side.
    std::array<Piece, 2> halves() const {
        std::size_t side = 0;
        for (std::size_t k = 1; k < 3; ++k) {
            if ((corners[(k + 1) % 3] - corners[k]).norm() > (corners[(side + 1) % 3] - corners[side]).norm()) {
                side = k;
            }
        }
        const Vec3& a = corners[side];
        const Vec3& b = corners[(side + 1) % 3];
        const Vec3& c = corners[(side + 2) % 3];
        const Vec3 middle = 0.5 * (a + b);
        return {{{{a, middle, c}, operand}, {{middle, b, c}, operand}}};
    }
};

/// visit(piece) for the pieces of a triangle that is halved until no side is longer; not for those that are settled.
template <typename IsSettled, typename Visit>
void for_each_piece(const Piece& triangle, double longest, const IsSettled& is_settled, const Visit& visit) {
    std::vector<Piece> pieces{triangle};
    while (!pieces.empty()) {
        const Piece piece = pieces.back();
        pieces.pop_back();
        if (is_settled(piece)) {
            continue;
        }
        if (piece.longest_side() <= longest) {
            visit(piece);
            continue;
        }
        const auto [one, two] = piece.halves();
        pieces.push_back(one);
        pieces.push_back(two);
    }
}

/// The spacing of samples on these triangles: the finest, or twice, four times ... that where it takes too many.
double spacing_on(const std::vector<Piece>& triangles, double finest) {
    double spacing = finest;
    for (double pieces = 2.0 * kLargeSamples; pieces > kLargeSamples; spacing *= 2.0) {
        pieces = 0.0;
        for (const Piece& t : triangles) {
            const double longest = t.longest_side();
            if (longest > spacing) {  // pieces are half as large as a square of this side, or there is one row of them
                const double area = 0.5 * t.normal().norm();
                pieces += 2.0 * (area / spacing + longest) / spacing;
            }
        }
    }
    return 0.5 * spacing;
}

/// What of triangles has to be sampled: all, or what is near other operands where some were moved.
class Unsettled {
  public:
    Unsettled(const ExactSolid& solid, const MovedOperands* moved) : solid_(solid), moved_(moved) {}

    /// Whether no triangle of another operand is within the reach of a piece.
    bool is_alone(const Piece& piece) const {
        if (moved_ == nullptr || piece.operand < 0) {
            return false;
        }
        Box box;
        for (const Vec3& p : piece.corners) {
            box.add(p);
        }
        const Vec3 around = Vec3::Constant(moved_->reach);
        bool alone = true;
        solid_.tree().for_each_in_box({box.low - around, box.high + around}, [&](std::int32_t triangle) {
            alone = solid_.operand_of(triangle) == piece.operand;
            return alone;
        });
        return alone;
    }

    /// Large pieces with all that is not settled.
    std::vector<Piece> of(const std::vector<Piece>& triangles, double finest) const {
        if (moved_ == nullptr) {
            return triangles;
        }
        constexpr double kLarge = 8.0;  // as a multiple of the finest spacing: few enough to be held in memory
        std::vector<Piece> result;
        for (const Piece& triangle : triangles) {
            for_each_piece(
                triangle, kLarge * finest, [&](const Piece& piece) { return is_alone(piece); },
                [&](const Piece& piece) { result.push_back(piece); });
        }
        return result;
    }

  private:
    const ExactSolid& solid_;
    const MovedOperands* moved_;
};

/// measure(piece) for pieces of all triangles that are not settled.
template <typename IsSettled, typename Measure>
void sample(const std::vector<Piece>& triangles, double spacing, const Progress& progress, const IsSettled& is_settled,
            const Measure& measure) {
    parallel_for(static_cast<int>((triangles.size() + kBlock - 1) / kBlock), [&](int block) {
        progress.check();
        const std::size_t first = kBlock * static_cast<std::size_t>(block);
        for (std::size_t t = first; t < std::min(first + kBlock, triangles.size()); ++t) {
            for_each_piece(triangles[t], spacing, is_settled, measure);
        }
    });
}

bool is_marked(const std::vector<char>& marks, std::size_t index) {
    return !marks.empty() && marks[index] != 0;
}

/// The largest distance of a triangle's points from another triangle: it is that of a corner.
double distance_to_triangle(const Corners& corners, const Corners& other) {
    double largest = 0.0;
    for (const Vec3& p : corners) {
        largest = std::max(largest, (mesh::nearest_on_triangle(p, other[0], other[1], other[2]) - p).norm());
    }
    return largest;
}

/// What a measurement compares, and how finely.
struct Comparison {
    const ExactSolid& solid;
    const std::vector<EnclosedOperand>& operands;
    const mesh::TriangleMesh& result;
    const MovedOperands* moved;
    double finest;
    double enough;
    const Progress& progress;
};

double distance_to_exact(const Comparison& c, const std::vector<char>& own, double& spacing) {
    const Unsettled unsettled(c.solid, c.moved);
    std::vector<Piece> triangles;
    std::vector<char> used(c.result.vertices.size(), 0);
    Largest largest;
    for (std::size_t t = 0; t < c.result.triangles.size(); ++t) {
        if (c.moved == nullptr && is_marked(own, t)) {
            continue;
        }
        const Triangle& v = c.result.triangles[t];
        const std::int32_t source = c.moved != nullptr ? c.moved->source[t] : -1;
        const Corners corners{c.result.vertices[v[0]], c.result.vertices[v[1]], c.result.vertices[v[2]]};
        triangles.push_back({corners, source >= 0 ? c.solid.operand_of(source) : -1});
        if (unsettled.is_alone(triangles.back())) {
            largest.add(distance_to_triangle(corners, c.solid.corners(source)));
            triangles.pop_back();
        } else {
            used[v[0]] = used[v[1]] = used[v[2]] = 1;
        }
    }
    const auto measure = [&](const Vec3& p) {
        largest.add(DistanceSearch(c.solid, p).bound(std::max(c.enough, largest.get())));
    };
    parallel_for(static_cast<int>((used.size() + kBlock - 1) / kBlock), [&](int block) {
        c.progress.check();
        const std::size_t first = kBlock * static_cast<std::size_t>(block);
        for (std::size_t v = first; v < std::min(first + kBlock, used.size()); ++v) {
            if (used[v] != 0) {
                measure(c.result.vertices[v]);
            }
        }
    });
    triangles = unsettled.of(triangles, c.finest);
    spacing = spacing_on(triangles, c.finest);
    sample(
        triangles, spacing, c.progress, [&](const Piece& piece) { return unsettled.is_alone(piece); },
        [&](const Piece& piece) { measure(piece.centre()); });
    return largest.get();
}

/// The distance of a point of the exact surface from the result, and the point.
using FarPoint = std::pair<double, std::array<double, 3>>;

double distance_from_exact(const Comparison& c, double thinnest, double& spacing) {
    const Unsettled unsettled(c.solid, c.moved);
    Largest largest;
    std::vector<Piece> triangles;
    for (std::size_t k = 0; k < c.operands.size(); ++k) {
        for (std::size_t t = 0; t < c.operands[k].triangles->size(); ++t) {
            if (is_marked(c.operands[k].retained, t)) {
                continue;
            }
            const std::int32_t triangle = c.solid.first_triangle(k) + static_cast<std::int32_t>(t);
            triangles.push_back({c.solid.corners(triangle), static_cast<std::int32_t>(k)});
            if (unsettled.is_alone(triangles.back())) {
                const Piece& alone = triangles.back();
                if (c.solid.is_bounded_at(alone.centre(), alone.normal())) {
                    largest.add(
                        distance_to_triangle(alone.corners, c.moved->triangles[static_cast<std::size_t>(triangle)]));
                }
                triangles.pop_back();
            }
        }
    }
    const mesh::NearestTree tree(c.result.vertices, c.result.triangles);
    const Box box = c.solid.tree().box();
    const double none = box.empty() ? 0.0 : (box.high - box.low).norm();  // the result is empty
    triangles = unsettled.of(triangles, c.finest);
    spacing = std::max(spacing, spacing_on(triangles, c.finest));
    std::mutex taking;
    std::vector<FarPoint> far;
    const auto measure = [&](const Vec3& p, const Vec3& normal) {
        const bool near = tree.nearest(p, std::max(c.enough, largest.get())).triangle >= 0;
        if (!near && c.solid.is_bounded_at(p, normal) && c.solid.is_bounded_at(p, normal, thinnest)) {
            const double distance = tree.size() > 0 ? tree.nearest(p).distance : none;
            const std::lock_guard<std::mutex> lock(taking);
            far.push_back({distance, {p.x(), p.y(), p.z()}});
        }
    };
    sample(
        triangles, spacing, c.progress, [&](const Piece& piece) { return unsettled.is_alone(piece); },
        [&](const Piece& piece) {
            // Distance of points from the border, as a fraction of the way to the centre: on the border itself other
            // triangles bound the solid, too.
            constexpr double kInside = 0.02;
            const Vec3 centre = piece.centre();
            measure(centre, piece.normal());
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3& corner = piece.corners[k];
                const Vec3 middle = 0.5 * (corner + piece.corners[(k + 1) % 3]);
                measure(corner + kInside * (centre - corner), piece.normal());
                measure(middle + kInside * (centre - middle), piece.normal());
            }
        });
    std::sort(far.rbegin(), far.rend());
    const auto farthest = std::find_if(far.begin(), far.end(), [&](const FarPoint& point) {
        c.progress.check();
        return c.solid.is_thick_at(Vec3(point.second[0], point.second[1], point.second[2]), thinnest);
    });
    return farthest != far.end() ? std::max(largest.get(), farthest->first) : largest.get();
}

}  // namespace

MeasuredError measure_error(const std::vector<EnclosedOperand>& operands, const Expression& expression,
                            const mesh::TriangleMesh& result, const std::vector<char>& own, double finest,
                            double enough, double thinnest, const Progress& progress, const MovedOperands* moved) {
    const ExactSolid solid(operands, expression);
    const Comparison comparison{solid, operands, result, moved, finest, enough, progress};
    MeasuredError error;
    error.to_exact = distance_to_exact(comparison, own, error.spacing);
    error.from_exact = distance_from_exact(comparison, thinnest, error.spacing);
    return error;
}

}  // namespace mq::boolean
