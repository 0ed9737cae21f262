// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/error_measure.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/parallel.h"
#include "boolean/distance_to_solid.h"
#include "mesh/intersection/nearest_tree.h"
#include "mesh/intersection/triangle_contact.h"
#include "mesh/intersection/triangle_distance.h"

namespace mq::boolean {

namespace {

using mesh::Triangle;
using Corners = std::array<Vec3, 3>;

/// Approximate number of samples on all large triangles together.
constexpr double kLargeSamples = 100'000.0;
/// Triangles whose samples are measured between two looks at a cancellation.
constexpr std::size_t kBlock = 64;

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

/// A triangle of the result or of an operand, or a piece of one.
struct Piece {
    Corners corners;
    std::int32_t triangle = -1;  ///< the triangle before moves, in one list of all operands; -1: not known

    double longest_side() const {
        return std::max(
            {(corners[1] - corners[0]).norm(), (corners[2] - corners[1]).norm(), (corners[0] - corners[2]).norm()});
    }
    Vec3 centre() const { return (corners[0] + corners[1] + corners[2]) / 3.0; }
    Vec3 normal() const { return (corners[1] - corners[0]).cross(corners[2] - corners[0]); }
    /// The two halves of the piece, divided at the middle of its longest side.
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
        return {{{{a, middle, c}, triangle}, {{middle, b, c}, triangle}}};
    }
};

/// Calls visit(piece) for the pieces of a triangle, which is halved until no side is longer than the length; settled
/// pieces are skipped.
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

/// The spacing of samples on these triangles: `finest`, doubled until at most kLargeSamples are needed.
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

/// Calls work(i, block) for the numbers below `count`, in blocks for several threads.
template <typename Work>
void in_blocks(std::size_t count, const Progress& progress, const Work& work) {
    parallel_for(static_cast<int>((count + kBlock - 1) / kBlock), [&](int block) {
        progress.check();
        const std::size_t first = kBlock * static_cast<std::size_t>(block);
        for (std::size_t i = first; i < std::min(first + kBlock, count); ++i) {
            work(i, static_cast<std::size_t>(block));
        }
    });
}

/// Pieces of triangles that are not settled, with sides up to a length or of known distances.
struct Unsettled {
    std::vector<Piece> unknown;
    std::vector<std::size_t> triangle;  ///< that each of these is a piece of
    std::vector<Piece> known;

    void add(const Unsettled& other) {
        unknown.insert(unknown.end(), other.unknown.begin(), other.unknown.end());
        triangle.insert(triangle.end(), other.triangle.begin(), other.triangle.end());
        known.insert(known.end(), other.known.begin(), other.known.end());
    }
    /// The spacing of samples, as if they were taken on all of them.
    double spacing(double finest) const {
        std::vector<Piece> all = unknown;
        all.insert(all.end(), known.begin(), known.end());
        return spacing_on(all, finest);
    }
};

/// In the order of the triangles.
template <typename IsSettled, typename IsKnown>
Unsettled unsettled_pieces(const std::vector<Piece>& triangles, double longest, const Progress& progress,
                           const IsSettled& is_settled, const IsKnown& is_known) {
    std::vector<Unsettled> found((triangles.size() + kBlock - 1) / kBlock);
    in_blocks(triangles.size(), progress, [&](std::size_t t, std::size_t block) {
        const auto is_done = [&](const Piece& piece) {
            const bool settled = is_settled(piece);
            const bool known = !settled && is_known(piece);
            if (known) {
                found[block].known.push_back(piece);
            }
            return settled || known;
        };
        for_each_piece(triangles[t], longest, is_done, [&](const Piece& piece) {
            found[block].unknown.push_back(piece);
            found[block].triangle.push_back(t);
        });
    });
    Unsettled result;
    for (const Unsettled& part : found) {
        result.add(part);
    }
    return result;
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

/// Measures a result.
class Measurement {
  public:
    Measurement(const ExactSolid& solid, const std::vector<EnclosedOperand>& operands, const mesh::TriangleMesh& result,
                const ErrorLimits& limits, const MovedOperands* moved, const Progress& progress)
        : solid_(solid),
          operands_(operands),
          result_(result),
          tree_(result.vertices, result.triangles),
          limits_(limits),
          moved_(moved),
          progress_(progress),
          has_windings_(std::any_of(operands.begin(), operands.end(),
                                    [](const EnclosedOperand& operand) { return operand.winding != nullptr; })) {}

    double to_exact(const std::vector<char>& own, double& spacing) const {
        std::vector<Piece> triangles;
        std::vector<Triangle> corners;
        for (std::size_t t = 0; t < result_.triangles.size(); ++t) {
            if (!is_marked(own, t)) {
                const Triangle& v = result_.triangles[t];
                triangles.push_back({{result_.vertices[v[0]], result_.vertices[v[1]], result_.vertices[v[2]]},
                                     moved_ != nullptr ? moved_->source[t] : -1});
                corners.push_back(v);
            }
        }
        Largest largest;
        const auto is_settled = [&](const Piece& piece) {
            const bool alone = is_alone(piece);
            if (alone) {
                largest.add(distance_to_triangle(piece.corners, solid_.corners(piece.triangle)));
            }
            return alone;
        };
        const auto is_known = [&](const Piece& piece) {
            for (const double distance : {DistanceToSolid::kLeastBound * solid_.beside(), limits_.enough}) {
                if (piece.longest_side() > limits_.finest && is_border_near(piece, distance)) {
                    largest.add(distance);
                    return true;
                }
            }
            return false;
        };
        const Unsettled left = unsettled_pieces(triangles, held(triangles), progress_, is_settled, is_known);
        std::vector<std::int32_t> used;
        for (const std::size_t t : left.triangle) {
            used.insert(used.end(), corners[t].begin(), corners[t].end());
        }
        std::sort(used.begin(), used.end());
        used.erase(std::unique(used.begin(), used.end()), used.end());
        const auto measure = [&](const Vec3& p) {
            largest.add(DistanceToSolid(solid_, p).bound(std::max(limits_.enough, largest.get())));
        };
        in_blocks(used.size(), progress_, [&](std::size_t i, std::size_t /*block*/) {
            measure(result_.vertices[static_cast<std::size_t>(used[i])]);
        });
        spacing = left.spacing(limits_.finest);
        in_blocks(left.unknown.size(), progress_, [&](std::size_t i, std::size_t /*block*/) {
            const auto is_done = [&](const Piece& piece) {
                return is_settled(piece) || (piece.longest_side() > spacing && is_known(piece));
            };
            for_each_piece(left.unknown[i], spacing, is_done, [&](const Piece& piece) { measure(piece.centre()); });
        });
        return largest.get();
    }

    double from_exact(double& spacing) const {
        std::vector<Piece> triangles;
        for (std::size_t k = 0; k < operands_.size(); ++k) {
            for (std::size_t t = 0; t < operands_[k].triangles->size(); ++t) {
                if (!is_marked(operands_[k].retained, t)) {
                    const std::int32_t triangle = solid_.first_triangle(k) + static_cast<std::int32_t>(t);
                    triangles.push_back({solid_.corners(triangle), triangle});
                }
            }
        }
        Largest largest;
        const auto is_settled = [&](const Piece& piece) {
            const bool alone = is_alone(piece);
            if (alone) {
                largest.add(distance_where_alone(piece));
            }
            return alone;
        };
        const auto is_known = [&](const Piece& piece) {
            return piece.longest_side() > limits_.finest && (is_film(piece) || is_near_result(piece, limits_.enough));
        };
        const Unsettled left = unsettled_pieces(triangles, held(triangles), progress_, is_settled, is_known);
        spacing = std::max(spacing, left.spacing(limits_.finest));
        in_blocks(left.unknown.size(), progress_, [&](std::size_t i, std::size_t /*block*/) {
            const auto is_done = [&](const Piece& piece) {
                return is_settled(piece) ||
                       (piece.longest_side() > spacing && (is_film(piece) || is_near_result(piece, largest.get())));
            };
            for_each_piece(left.unknown[i], spacing, is_done, [&](const Piece& piece) { add_points(piece, largest); });
        });
        return largest.get();
    }

  private:
    /// The longest side of the pieces of these triangles that are stored: a multiple of the finest spacing, or larger
    /// if the number of pieces would exceed that of the samples.
    double held(const std::vector<Piece>& triangles) const {
        constexpr double kLarge = 8.0;
        return std::max(kLarge * limits_.finest, spacing_on(triangles, limits_.finest));
    }

    /// Whether no triangle of another operand is within the reach of a piece; never where operands were not moved.
    bool is_alone(const Piece& piece) const {
        if (moved_ == nullptr || piece.triangle < 0) {
            return false;
        }
        Box box;
        for (const Vec3& p : piece.corners) {
            box.add(p);
        }
        const Vec3 around = Vec3::Constant(moved_->reach);
        const std::int32_t operand = solid_.operand_of(piece.triangle);
        bool alone = true;
        solid_.tree().for_each_in_box({box.low - around, box.high + around}, [&](std::int32_t triangle) {
            alone = solid_.operand_of(triangle) == operand;
            return alone;
        });
        return alone;
    }

    /// Whether the solid has the points at a distance on either side of a piece, all or none, along the axis next to
    /// its normal; no value where triangles are there.
    std::optional<std::array<bool, 2>> sides(const Piece& piece, double distance) const {
        if (has_windings_) {
            return std::nullopt;
        }
        int axis = 0;
        piece.normal().cwiseAbs().maxCoeff(&axis);
        bool apart = true;
        for (const double step : {-distance, distance}) {
            Corners moved = piece.corners;
            Box box;
            for (Vec3& p : moved) {
                p[axis] += step;
                box.add(p);
            }
            solid_.tree().for_each_in_box(box, [&](std::int32_t triangle) {
                apart = apart && mesh::certainly_apart(moved, solid_.corners(triangle));
                return apart;
            });
        }
        return apart ? std::optional(solid_.sides(piece.centre(), axis, distance)) : std::nullopt;
    }
    /// Whether it is certain that the border of the solid is within a distance of all points of a piece: it lies
    /// between points of the solid and others.
    bool is_border_near(const Piece& piece, double distance) const {
        const std::optional<std::array<bool, 2>> found = sides(piece, distance);
        return found && (*found)[0] != (*found)[1];
    }
    /// Whether it is certain that a piece of an operand lies in a film, in a gap, or inside of the solid or outside.
    bool is_film(const Piece& piece) const {
        const std::optional<std::array<bool, 2>> found = sides(piece, limits_.thinnest);
        return found && (*found)[0] == (*found)[1];
    }

    /// The largest distance of the points of a piece of an operand from the result, if no other operand is near.
    double distance_where_alone(const Piece& piece) const {
        const Corners& moved = moved_->triangles[static_cast<std::size_t>(piece.triangle)];
        if (moved == solid_.corners(piece.triangle) || !solid_.is_bounded_at(piece.centre(), piece.normal())) {
            return 0.0;
        }
        // If a sheet was moved through another sheet of the same operand, the moved triangle is not in the result.
        const double at_centre = tree_.size() > 0 ? tree_.nearest(piece.centre()).distance : size();
        return std::max(at_centre, distance_to_triangle(piece.corners, moved));
    }

    double size() const {
        const Box box = solid_.tree().box();
        return box.empty() ? 0.0 : (box.high - box.low).norm();
    }

    /// Whether it is certain that all points of a piece are within a distance of the result: its corners are within it
    /// of one triangle.
    bool is_near_result(const Piece& piece, double distance) const {
        const std::int32_t nearest = tree_.size() > 0 ? tree_.nearest(piece.centre()).triangle : -1;
        if (nearest < 0) {
            return false;
        }
        const Triangle& v = result_.triangles[static_cast<std::size_t>(nearest)];
        const Corners corners{result_.vertices[v[0]], result_.vertices[v[1]], result_.vertices[v[2]]};
        return distance_to_triangle(piece.corners, corners) <= distance;
    }

    /// Takes points of a piece that lie on the border of the exact solid, but not at a film or gap, and adds their
    /// distances from the result.
    void add_points(const Piece& piece, Largest& largest) const {
        // Distance of points from the border, as a fraction of the way to the centre: on the border itself other
        // triangles bound the solid, too.
        constexpr double kInside = 0.02;
        const Vec3 centre = piece.centre();
        const Vec3 normal = piece.normal();
        const auto add = [&](const Vec3& p) {
            const double known = std::max(limits_.enough, largest.get());
            if (tree_.nearest(p, known).triangle >= 0 || !solid_.is_bounded_at(p, normal) ||
                !solid_.is_bounded_at(p, normal, limits_.thinnest)) {
                return;
            }
            progress_.check();  // the next test takes many points
            if (solid_.is_thick_at(p, limits_.thinnest)) {
                largest.add(tree_.size() > 0 ? tree_.nearest(p).distance : size());
            }
        };
        add(centre);
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& corner = piece.corners[k];
            const Vec3 middle = 0.5 * (corner + piece.corners[(k + 1) % 3]);
            add(corner + kInside * (centre - corner));
            add(middle + kInside * (centre - middle));
        }
    }

    const ExactSolid& solid_;
    const std::vector<EnclosedOperand>& operands_;
    const mesh::TriangleMesh& result_;
    const mesh::NearestTree tree_;
    const ErrorLimits& limits_;
    const MovedOperands* moved_;
    const Progress& progress_;
    bool has_windings_;  ///< whether operands are open, so that the solid is not bounded by triangles only
};

}  // namespace

MeasuredError measure_error(const std::vector<EnclosedOperand>& operands, const Expression& expression,
                            const mesh::TriangleMesh& result, const std::vector<char>& own, const ErrorLimits& limits,
                            const Progress& progress, const MovedOperands* moved) {
    const ExactSolid solid(operands, expression);
    const Measurement measurement(solid, operands, result, limits, moved, progress);
    MeasuredError error;
    error.to_exact = measurement.to_exact(own, error.spacing);
    error.from_exact = measurement.from_exact(error.spacing);
    return error;
}

}  // namespace mq::boolean
