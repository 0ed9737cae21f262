// SPDX-License-Identifier: LGPL-2.1-or-later
#include "boolean/error_measure.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <utility>

#include "base/parallel.h"
#include "boolean/distance_to_solid.h"
#include "mesh/intersection/nearest_tree.h"
#include "mesh/intersection/triangle_distance.h"

namespace mq::boolean {

namespace {

using mesh::Triangle;
using Corners = std::array<Vec3, 3>;

/// Samples on large triangles, all together, about.
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
        largest.add(DistanceToSolid(c.solid, p).bound(std::max(c.enough, largest.get())));
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
